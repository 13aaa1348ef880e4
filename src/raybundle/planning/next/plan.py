"""The next photographs of a block in hand: stations within reach, what they would show, and the best of them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.additions import with_photographs
from raybundle.adjustment.evaluation.joint_cofactors import Factored
from raybundle.adjustment.readjust import block_again
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.block.points import automatic
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.planning.next.best import Chosen, next_best
from raybundle.planning.next.goals import For, Goal
from raybundle.planning.next.obstacles import Obstacles
from raybundle.planning.next.outlook import MOST_POINTS, Outlook, points_of, wider_than_white
from raybundle.planning.next.stations import Reach, reachable
from raybundle.planning.next.visibility import FEWEST, GRAZING, PointSight
from raybundle.platforms import Carried

if TYPE_CHECKING:
    from raybundle.objects.surface import Surface

LEVEL = np.radians(45)
"""Steepest view, in the median of the photographs, with which people still speak of left, right and higher; of steeper
ones, and of boards whose Z is their normal, the picture itself states what is right and up."""
WEAKEST = 200
"""Of the points that are regarded, where not all are, those that are least determined; the others are spread evenly"""
LEAST_CONTROL = 3
"""Control points by whose given coordinates the frame is one in which Z is up, whatever carries the datum"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Conditions:
    """Which photographs can be taken, and what they show."""

    camera: str = ""
    """Camera that takes them; empty: that of most photographs"""
    reach: Reach = Reach()  # noqa: RUF009  (frozen)
    depth: tuple[float, float] = (0.0, float("inf"))
    """Distances along the axis that are sharp [length unit of the block]"""
    incidence: float = GRAZING
    """Largest angle of a ray to the normal [rad]"""
    surface: Surface | None = None
    """Of the object, in the frame of the block: what hides what"""


@dataclass(frozen=True, slots=True, kw_only=True)
class NextPlan:
    """Photographs proposed for a block, one after the other."""

    outlook: Outlook
    """The network as it is"""
    goal: Goal
    camera: int
    """Position in `Block.cameras` of the one that takes them"""
    reached: int
    """Stations within reach that were looked at, each way of holding the camera counted"""
    judged: int
    """Of these, those that show enough points"""
    wanted: int
    """Photographs asked for"""
    proposals: tuple[Chosen, ...]
    """As many as lower what is to be lowered"""
    towards: Array
    """(k, 3) what each looks at"""
    names: tuple[str, ...]
    """(k,) of the proposed photographs, that no other has"""
    vertical: Array | None
    """(3,) upwards; None: not known, or of photographs that look down or up"""

    @property
    def result(self) -> Adjustment:
        """The adjustment that was asked."""
        return self.outlook.result

    @property
    def block(self) -> Block:
        """The block with adjusted values."""
        return self.outlook.block

    def extended(self) -> Block:
        """The block of the result, to be adjusted again, with the proposals as further photographs of it."""
        block, rejected = block_again(self.result), self.outlook.rejected
        for name, chosen in zip(self.names, self.proposals, strict=True):
            block, rejected = with_photographs(block, rejected, chosen.photograph, (name,))
        return block

    def adjusted(self) -> Adjustment:
        """A full adjustment with the proposals, whose image points are the promised ones: it fits a little too well.

        Its standard deviations times the ratio of the sigma0 before to its own are what the proposals promise.
        """
        block = self.extended()
        sigma = {c.id: c.sigma for c in self.block.cameras}
        block = replace(block, cameras=tuple(replace(c, sigma=sigma[c.id]) for c in block.cameras))
        rejected = self.outlook.rejected + (None,) * (len(block.observations) - len(self.outlook.rejected))
        options = replace(self.result.options, noise="white", reject="none", estimate="given")
        return adjust_block(block, options, free=self.outlook.free, rejected=rejected, start="adjusted")

    def promised(self, after: Adjustment) -> Array:
        """(p, 3, 3) covariances of all object points with the proposals.

        after  what `adjusted` gave
        """
        assert after.precision is not None
        wide = wider_than_white(self.result, np.arange(len(self.block.points)))
        scale = self.outlook.variance / after.variance_factor
        return scale * after.precision.object_points * wide[:, :, None] * wide[:, None]


def plan_next(
    result: Adjustment, aim: For, photographs: int = 1, conditions: Conditions | None = None,
    points: tuple[str, ...] = (), progress: Progress = silent,
) -> NextPlan:  # fmt: skip
    """The best further photographs of an adjusted block, each after those before it.

    aim     as of `Goal`; points: of kind points, those whose largest standard deviation is to fall
    raises  InputError for results without statistics, cameras that are no frame cameras, where nothing is within reach
            or seen, and for more photographs than there are candidates

    Image points are taken to be as precise as those that the block has of the same points, and sigma0 as it is.  What
    it does not show: whether one can stand there, and whether the points are recognised from there.
    """
    with_ = conditions or Conditions()
    if result.handle.work is None:
        Factored.of(result)  # states what is missing
    used = np.array([not r for r in result.image_observations.rejected], bool)
    k = camera_of(result, used, with_.camera)
    camera = result.given.cameras[k].id
    outlook = _outlook(result, aim, camera, points)
    goal = Goal(kind=aim, points=points, camera=camera)
    block, joint = outlook.block, outlook.joint
    least = outlook.wider.max(axis=1) * np.sqrt(joint.variances()).max(axis=1)
    sight = PointSight.of(block, used, joint.points, k)
    sight = replace(sight, depth=with_.depth, incidence=with_.incidence)
    reach = with_.reach
    if with_.surface is not None:
        hides = Obstacles.of(with_.surface, sight.xyz)
        sight = replace(sight, visible=hides.visible)
        reach = replace(reach, allowed=hides.allowed(reach.clearance or 0.0))
    # who gives heights knows that Z is up, though nothing in the adjustment may show it
    vertical = vertical_of(result) if reach.heights is None else np.array([0.0, 0.0, 1.0])
    found = reachable(block, used, k, least, vertical, reach, joint.points)
    shown = sight.shown(block, k, found.centre, found.rotation, least)
    enough = np.flatnonzero(np.bincount(shown.image, minlength=len(shown)) > 0)
    if not len(enough):
        raise InputError("plan.nothing_seen_again", n=len(found.centre), least=FEWEST)
    if photographs > len(enough):
        raise InputError("plan.too_few_candidates", n=len(enough), wanted=photographs)
    chosen = next_best(outlook, shown.chosen(enough), goal, photographs, progress)
    rows = enough[[c.candidate for c in chosen]]
    return NextPlan(
        outlook=outlook, goal=goal, camera=k, reached=len(found.centre), judged=len(enough), wanted=photographs,
        proposals=chosen, towards=found.towards[rows], names=_names(block, len(chosen)), vertical=vertical,
    )  # fmt: skip


def _outlook(result: Adjustment, aim: For, camera: str, points: tuple[str, ...]) -> Outlook:
    factored = Factored.of(result)
    weak = weakest(result, factored) if aim == "worst" else ()
    regarded = points_of(result, factored, also=points or weak)
    if not len(regarded):
        raise InputError("plan.no_object_points")
    interior = next((i for i in result.interior if i.camera == camera and i.image is None), None)
    # knots of surfaces in corners that no point reaches say nothing, and nobody misses them
    surfaces = any(c.id == camera and c.sensor.local_width for c in result.given.cameras)
    parameters = {} if interior is None or surfaces else interior.parameters
    lost = any(p.status == "not determinable" for p in parameters.values())
    return Outlook.of(result, regarded, freed=camera if aim == "calibration" and lost else "")


def weakest(result: Adjustment, factored: Factored) -> tuple[str, ...]:
    """Names of the least determined points that somebody named, where there are too many to regard all of them."""
    used, ids = np.flatnonzero(factored.system.points_used), result.given.points.ids
    used = used[~automatic([ids[p] for p in used.tolist()])]
    if len(used) <= MOST_POINTS:
        return ()
    largest = np.diagonal(factored.found.points[used], axis1=1, axis2=2).max(axis=1)
    return tuple(ids[p] for p in used[np.argsort(-largest, kind="stable")[:WEAKEST]].tolist())


def camera_of(result: Adjustment, used: Array, wanted: str = "") -> int:
    """Position of the camera that takes the photographs: the one named, or that of most photographs that take part.

    raises  InputError where there is none, or it is no frame camera with one station for each photograph
    """
    block = result.given
    ids = [c.id for c in block.cameras]
    if wanted and wanted not in ids:
        raise InputError("plan.unknown_camera", camera=wanted, known=ids)
    images = np.unique(block.observations.image[used])
    count = np.bincount(block.images.camera[images], minlength=len(ids))
    fit = np.array([is_frame_camera(result, k) for k in range(len(ids))])
    if wanted:
        k = ids.index(wanted)
    elif (count * fit).any():
        k = int((count * fit).argmax())
    else:
        k = int(count.argmax())
    if not fit[k]:
        raise InputError("plan.no_frame_camera", camera=ids[k], model=block.cameras[k].model)
    if not count[k]:
        raise InputError("plan.camera_not_used", camera=ids[k])
    return k


def is_frame_camera(result: Adjustment, k: int) -> bool:
    """Whether a camera's photographs have each a station of their own and share the interior orientation."""
    camera, images = result.given.cameras[k], result.given.images
    if camera.is_scene or camera.own_symbols or isinstance(camera.sensor, Carried):
        return False
    if images.station is None:
        return True
    mine = images.station[images.camera == k]
    return not np.isin(mine, images.station[images.camera != k]).any() and len(np.unique(mine)) == len(mine)


def frame_known(result: Adjustment) -> bool:
    """Whether the axes of the block are not arbitrary: something fixes them, or control gave its coordinates."""
    turned = any(part.startswith("rotation") and part[-1] in "XY" for part in result.datum_defect)
    return not turned or int(result.given.points.is_control.all(axis=1).sum()) >= LEAST_CONTROL


def vertical_of(result: Adjustment) -> Array | None:
    """Z, where people on site go by it: the frame is not arbitrary, and most photographs look ahead."""
    seen = np.unique(result.given.observations.image[result.image_observations.used])
    steep = np.abs(result.adjusted.images.rotation[seen, 2, 2])
    if not frame_known(result) or np.median(steep) > np.sin(LEVEL):
        return None
    return np.array([0.0, 0.0, 1.0])


def _names(block: Block, count: int) -> tuple[str, ...]:
    taken, found, k = set(block.images.ids), list[str](), 1
    while len(found) < count:
        if f"next-{k}" not in taken:
            found.append(f"next-{k}")
        k += 1
    return tuple(found)
