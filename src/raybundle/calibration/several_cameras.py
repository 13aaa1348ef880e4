"""Photographs of several cameras, or zooms, that were taken for one: found, and named.

They are not given a camera each here: tie points were chosen and weighed with the wrong camera, and all is done again.

Which photographs belong together is read from the interior orientations that single images ask for
(`raybundle.adjustment.evaluation.image_interiors`); an adjustment with a camera for each group confirms that they
differ.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.image_interiors import LEVEL, Groups, groups_of, own_interiors
from raybundle.adjustment.evaluation.joint_interior import JointInterior, joint_interior, smooth_errors
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.adjusted_values import as_start
from raybundle.block import Block, Camera
from raybundle.errors import NotSolvable, Value, message
from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import fisher_tail

MOST_CAMERAS = 8
"""Cameras of a block up to which more are looked for."""
LARGE = 4.0
"""Mean square of the residuals in the directions of smooth fields, in units of white noise, from which on it is looked
at: standard deviations of such sums are then twice those of white noise."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SeveralCameras:
    """Photographs that get a camera of their own."""

    camera_of: dict[str, tuple[str, str]]
    """By photograph: the camera that it had, and the new one"""
    notices: tuple[Notice, ...]

    def applied(self, block: Block) -> Block:
        """The block with these cameras; new ones begin as copies of the old."""
        cameras, of = list(block.cameras), block.images.camera.copy()
        for new in dict.fromkeys(self.camera_of.values()):
            old = next(c for c in cameras if c.id == new[0])
            cameras.append(replace(old, id=new[1]))
        place = {c.id: k for k, c in enumerate(cameras)}
        for k, name in enumerate(block.images.ids):
            if name in self.camera_of:
                of[k] = place[self.camera_of[name][1]]
        return replace(block, cameras=tuple(cameras), images=replace(block.images, camera=of))


def several_cameras(result: Adjustment) -> SeveralCameras | None:
    """Cameras whose photographs fall into groups with interior orientations of their own; None where none does.

    result  under noise of kind fields

    Two tests have to agree: that the images' own values fall into groups more distinctly than values without groups do
    (`own_interiors.groups_of`), and that the groups' interior orientations, adjusted apart, differ significantly by
    the covariance that this adjustment states, smooth errors within the groups included.
    Not decided: whether groups are two cameras, two zooms or two distances of focus; groups below three
    images; cameras of which each took one image.
    """
    if result.noise.kind != "fields" or not result.noise.chi_square > LARGE:
        return None
    camera_of: dict[str, tuple[str, str]] = {}
    notices = list[Notice]()
    tested = set[str]()
    while len(result.given.cameras) < MOST_CAMERAS:
        found = None
        for own in own_interiors(result):
            camera = result.given.cameras[int(result.given.images.camera[own.images[0]])]
            if camera.id in tested or camera.estimate != "auto" or camera.calibrated is not None:
                continue
            groups = groups_of(own)
            found = None if groups is None else _apart(result, camera, groups, sorted(set(own.images.tolist())))
            if found is not None:
                break
            tested.add(camera.id)
        if found is None:
            break
        result, names, notice = found
        for name, new in names.items():
            old = camera_of.get(name, (new[0], ""))[0]
            camera_of[name] = old, new[1]
        notices.append(notice)
    return SeveralCameras(camera_of=camera_of, notices=tuple(notices)) if camera_of else None


def _sigma_px(result: Adjustment) -> float:
    return result.sigma0 * float(np.median(np.sqrt(result.given.observations.cov_px2[:, :2])))


def _apart(
    result: Adjustment, camera: Camera, groups: Groups, images: Sequence[int]
) -> tuple[Adjustment, dict[str, tuple[str, str]], Notice] | None:
    """The adjustment with a camera for each group, who gets which, and a notice; None where it refutes them."""
    ids = [camera.id, *_new_names(result.given.cameras, camera.id, len(groups.images) - 1)]
    largest = max(range(len(groups.images)), key=lambda g: len(groups.images[g]))
    order = [largest, *(g for g in range(len(groups.images)) if g != largest)]
    name = result.given.images.ids
    camera_of = {
        name[i]: (camera.id, new) for new, g in zip(ids[1:], order[1:], strict=True) for i in groups.images[g].tolist()
    }
    apart = SeveralCameras(camera_of=camera_of, notices=())
    start = apart.applied(as_start(result.given, result.adjusted))
    free = {i.camera: i.free for i in result.interior if i.image is None}
    free |= dict.fromkeys(ids, free.get(camera.id, ()))
    options = replace(result.options, reject="none", robust_start=False, tolerance=max(result.options.tolerance, 1e-3))
    try:
        after = adjust_block(
            start, options, free=free, rejected=result.image_observations.rejected, start="adjusted"
        )  # fmt: skip
    except NotSolvable:
        return None
    joint = joint_interior(after, ids, smooth_errors(after))
    differ = [_differ(joint, a, b) for a, b in zip(_sorted(ids, order), _sorted(ids, order)[1:], strict=False)]
    if not joint.names or max(differ, default=1.0) > LEVEL:
        return None
    spread = float(np.ptp(groups.means_px))
    if not spread > _sigma_px(after):
        return None
    return after, camera_of, _notice(after, camera, groups, ids, order, spread, max(differ), len(images))


def _sorted(ids: Sequence[str], order: Sequence[int]) -> list[str]:
    """The cameras in the order of the groups' values."""
    return [ids[order.index(g)] for g in range(len(order))]


def _differ(joint: JointInterior, one: str, other: str) -> float:
    """Probability by chance of a difference as large between the interior orientations of two cameras."""
    symbols = [s for c, s in joint.names if c == one and (other, s) in joint.names]
    if not symbols:
        return 1.0
    a, b = (joint.at([(c, s) for s in symbols]) for c in (one, other))
    D = np.zeros((len(symbols), len(joint.names)))
    D[np.arange(len(symbols)), a], D[np.arange(len(symbols)), b] = 1.0, -1.0
    d, C = D @ joint.values, D @ joint.stated @ D.T
    s: Array = np.sqrt(np.diagonal(C))
    F = float(d / s @ np.linalg.solve(C / np.outer(s, s), d / s)) / len(symbols)
    return fisher_tail(F, len(symbols), joint.residuals)


def _new_names(cameras: Sequence[Camera], name: str, count: int) -> list[str]:
    taken = {c.id for c in cameras}
    free = (f"{name}-{k}" for k in range(2, 2 + len(taken) + count))
    return [n for n in free if n not in taken][:count]


def _notice(
    after: Adjustment, camera: Camera, groups: Groups, ids: Sequence[str], order: Sequence[int], spread: float,
    probability: float, count: int,
) -> Notice:  # fmt: skip
    name = after.given.images.ids
    own = tuple(
        message("several_cameras.own", pattern="|".join(name[i] for i in groups.images[g].tolist())) for g in order[1:]
    )
    values: dict[str, Value] = {
        "camera": camera.id, "photographs": count, "cameras": len(ids), "symbol": groups.symbol, "spread_px": spread,
        "scatter_px": groups.scatter_px, "p": max(probability, groups.probability),
    }  # fmt: skip
    return Notice(code="several_cameras", ids=tuple(ids), values=values, details=own)
