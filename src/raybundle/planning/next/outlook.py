"""A finished adjustment as it is asked what photographs would add: joint covariances, and the network with them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.adjustment.evaluation.additions import Photographs, Rows, rows_of, with_photographs
from raybundle.adjustment.evaluation.joint_cofactors import Factored, JointCofactors, joint_cofactors
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.interior import image_effects, plausible_std
from raybundle.block import Block
from raybundle.block.points import automatic
from raybundle.block.rejection import Rejections
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.planning.next.visibility import well_spread

MOST_POINTS = 1000
"""Object points whose joint covariance is formed: 72 MB, and some milliseconds for each candidate."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Outlook:
    """A network with the joint covariance of its points and cameras, to which photographs can be added."""

    result: Adjustment
    block: Block
    """with adjusted values and the image observations as they were given"""
    rejected: Rejections
    free: dict[str, tuple[str, ...]]
    """Camera -> parameters that are free; those that goals of calibration free are among them"""
    factored: Factored
    joint: JointCofactors
    variance: float
    wider: Array
    """(t, 3) how much wider standard deviations of points are stated than for white noise"""
    freed: str = ""
    """Camera whose parameters are free that the adjustment held for want of determinability"""
    carried: Mapping[str, float] = field(default_factory=dict[str, float])
    """Its parameters that are observed to keep the network determined -> variance; goals take that away again"""

    @classmethod
    def of(cls, result: Adjustment, points: Index | None = None, freed: str = "") -> Outlook:
        """Of a finished adjustment with statistics; raises InputError for one without.

        points  (t,) positions of the object points that are regarded; None: as many as `points_of` gives
        freed   camera whose parameters that were held for want of determinability are free
        """
        block = replace(result.adjusted, observations=result.given.observations)
        factored, variance = Factored.of(result), result.variance_factor
        points = points_of(result, factored) if points is None else points
        free = {c.id: () for c in result.given.parametrised} | {i.camera: i.free for i in result.interior}
        wider = wider_than_white(result, points)
        rejected, carried = result.image_observations.rejected, dict[str, float]()
        if freed:
            block, free[freed], carried = _freed(result, block, freed)
        if carried:
            factored = Factored.at(block, result.options, free, rejected, like=factored)
        return cls(
            result=result, block=block, rejected=rejected, free=free, factored=factored, freed=freed, carried=carried,
            joint=joint_cofactors(factored, points), variance=variance, wider=wider,
        )  # fmt: skip

    @property
    def used(self) -> Mask:
        """(m,) image observations that take part."""
        return np.array([not r for r in self.rejected], bool)

    def rows(self, more: Photographs) -> Rows:
        """Partial derivatives of photographs that could be taken."""
        return rows_of(self.factored, self.joint, self.block, more)

    def added(self, more: Photographs, names: tuple[str, ...] = ()) -> Outlook:
        """The network with these photographs, factored anew: photographs after these are judged as exactly."""
        block, rejected = with_photographs(self.block, self.rejected, more, names)
        factored = Factored.at(block, self.result.options, self.free, rejected, like=self.factored)
        return replace(
            self, block=block, rejected=rejected, factored=factored,
            joint=joint_cofactors(factored, self.joint.points),
        )  # fmt: skip


def wider_than_white(result: Adjustment, points: Index) -> Array:
    """(t, 3) how much wider standard deviations of points are stated than for white noise."""
    if result.precision is None or result.noise.kind != "fields":
        return np.ones((len(points), 3))
    variance = result.variance_factor
    stated = _diagonals(result.precision.object_points[points])
    white = variance * _diagonals(Factored.of(result).found.points[points])
    with np.errstate(all="ignore"):
        return np.where(white > 0, np.sqrt(stated / white), 1.0)


def points_of(result: Adjustment, factored: Factored, also: tuple[str, ...] = (), most: int = MOST_POINTS) -> Index:
    """At most so many object points, ascending: those named `also`, others that somebody named, tie points to fill up.

    Of more than there is room for those are taken that are spread well over the object.
    """
    block, used = result.given, np.flatnonzero(factored.system.points_used)
    names = np.array(block.points.ids, object)[used]
    rank = np.where(np.isin(names, np.array(also, object)), 0, np.where(automatic(names.tolist()), 2, 1))
    xyz = result.adjusted.points.xyz
    taken = used[:0]
    for k in range(3):
        mine = used[rank == k]
        taken = np.concatenate([taken, mine[well_spread(xyz[mine], max(most - len(taken), 0))]])
    return np.sort(taken)


def _diagonals(blocks: Array) -> Array:
    return np.diagonal(blocks, axis1=1, axis2=2)


def _freed(result: Adjustment, block: Block, camera: str) -> tuple[Block, tuple[str, ...], dict[str, float]]:
    """The block with a camera whose parameters that it does not determine are observed; all that are free; variances.

    With what one knows of such a camera anyway, so that there is a factor; `goals.without_prior` takes it away again.
    Parameters that the adjustment itself kept near what was given (`adjustment.evaluation.held_interiors`) are among
    them.
    """
    owner = next((c for c in block.cameras if c.id == camera), None)
    interior = next((i for i in result.interior if i.camera == camera and i.image is None), None)
    if owner is None or interior is None:
        raise InputError("plan.no_common_interior", camera=camera)
    lost = {s for s, p in interior.parameters.items() if p.status == "not determinable"}
    model, values = owner.sensor, owner.parameters

    def effects() -> Array:
        return image_effects(model, owner, values)

    std = {
        s: plausible_std(owner, values, k, effects)
        for k, s in enumerate(model.symbols)
        if s in lost and s not in owner.sigma
    }
    cameras = tuple(replace(c, sigma={**c.sigma, **std}) if c.id == camera else c for c in block.cameras)
    free = tuple(s for s in model.symbols if s in lost or s in interior.free)
    return replace(block, cameras=cameras), free, {s: v**2 for s, v in std.items()}
