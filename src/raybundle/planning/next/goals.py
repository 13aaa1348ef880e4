"""What a photograph is to lower, and what that amounts to in a network as it stands or as it would be."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from raybundle.adjustment.evaluation.additions import Columns, Gain
from raybundle.adjustment.evaluation.joint_cofactors import Factored
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.precision import interior_unknowns, node_cofactor
from raybundle.block.points import automatic
from raybundle.calibration.maps import ProjectionShifts, projection_shifts
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.planning.next.outlook import Outlook

For = Literal["worst", "mean", "calibration", "points"]
FEW = 200
"""Points up to which nothing is left out of the largest standard deviation."""
SHARE = 0.99
"""Of more tie points that a program found the largest standard deviation but for one in a hundred: single points far
behind the object are seen by accident, and no photograph is worth taking for them."""
UNFREED = 1e-6
"""Share of what is known of a parameter that the observations must bring to have a standard deviation of their own."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Goal:
    """What a photograph is to lower."""

    kind: For = "worst"
    """worst: the largest standard deviation of a coordinate of an object point; mean: the mean one; points: the largest
    of chosen points; calibration: the largest uncertainty of projection over the format of a camera [px]"""
    points: tuple[str, ...] = ()
    """Of kind points"""
    camera: str = ""
    """Of kind calibration"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Standing:
    """What a goal amounts to, of a network as it stands or as it would be."""

    value: float
    """Standard deviation [length unit of the block; px of a calibration]; infinite where it is not determined"""
    point: int = -1
    """Position of the object point that has it; -1: of none"""
    carried: float = 0.0
    """Of a calibration what it is with what one knows of such a camera beforehand: where several photographs are needed
    to determine it, the first ones lower this"""

    @property
    def rank(self) -> tuple[float, float]:
        """By this the better of two comes first."""
        return self.value, self.carried


@dataclass(frozen=True, slots=True, kw_only=True)
class Measure:
    """How a goal is measured in a network."""

    columns: Columns
    """Joint cofactors that it hangs on"""
    standing: Callable[[Gain | None], Standing]
    """What it amounts to with some photographs, by what they do to these; None: as the network stands"""


def measure_of(outlook: Outlook, goal: Goal) -> Measure:
    """How a goal is measured; raises InputError for points that take no part and cameras that were not estimated."""
    if goal.kind == "calibration":
        return _calibration(outlook, goal.camera)
    at, share = _regarded(outlook, goal)
    points, now = outlook.joint.points[at], outlook.joint.variances()[at]
    factor = outlook.variance * outlook.wider[at] ** 2
    free = now > 0

    def standing(g: Gain | None) -> Standing:
        left = now if g is None else now - g.lost().reshape(-1, 3)
        std = np.sqrt(np.maximum(left * factor, 0.0))
        if goal.kind == "mean":
            return Standing(value=float(std[free].mean()))
        largest = std.max(axis=1)
        k = int(largest.argmax()) if share == 1 else int(np.argsort(largest)[int(share * (len(largest) - 1))])
        return Standing(value=float(largest[k]), point=int(points[k]))

    whole = len(at) == len(outlook.joint.points)
    columns = slice(0, 3 * len(at)) if whole else (3 * at[:, None] + np.arange(3)).ravel()
    return Measure(columns=columns, standing=standing)


def _regarded(outlook: Outlook, goal: Goal) -> tuple[Index, float]:
    """Places among the joint cofactors of the points of a goal, and the quantile that counts as the largest."""
    block, points = outlook.block, outlook.joint.points
    if goal.kind == "points":
        index = {name: k for k, name in enumerate(block.points.ids)}
        named = np.array([index.get(name, -1) for name in goal.points], np.int64)
        at = outlook.joint.place(named)
        missing = [name for name, k in zip(goal.points, at.tolist(), strict=True) if k < 0]
        if missing or not len(at):
            raise InputError("plan.points_not_adjusted", names=missing, n=len(missing))
        return at, 1.0
    natural = automatic([block.points.ids[p] for p in points.tolist()])
    named = ~natural & ~block.points.is_control[points].any(axis=1)
    if named.any() and natural.any() and goal.kind == "worst":  # what somebody named is what is asked for
        return np.flatnonzero(named), 1.0
    natural = natural | block.points.is_control[points].any(axis=1)
    return np.arange(len(points)), SHARE if natural.all() and len(points) > FEW else 1.0


def _calibration(outlook: Outlook, camera: str) -> Measure:
    """Measure of the largest uncertainty of projection of a camera, priors that only carry it taken away."""
    system, result = outlook.factored.system, outlook.result
    row = next((r for r in system.interior if r.image < 0 and r.owner(system.block).id == camera), None)
    if row is None or row.node < 0 or row.camera < 0:
        raise InputError("plan.camera_fixed", camera=camera)
    symbols = tuple(row.model.symbols[k] for k in row.free)
    adjusted = next(c for c in outlook.block.cameras if c.id == camera)
    shifts = projection_shifts(adjusted, symbols, columns=18, rows=12)
    at = outlook.joint.columns[interior_unknowns(system, row)]
    carried = outlook.carried if outlook.freed == camera else {}
    kept, prior = np.array([symbols.index(s) for s in carried], np.int64), np.array([*carried.values()])
    wider = _wider(result, camera, symbols, shifts, outlook)

    now = outlook.joint.matrix[np.ix_(at, at)]

    def standing(g: Gain | None) -> Standing:
        Q = now if g is None else now - g.change()
        known = wider * shifts.uncertainty(outlook.variance * Q).largest
        if not carried:
            return Standing(value=known)
        bare = without_prior(Q, kept, prior)
        value = np.inf if bare is None else wider * shifts.uncertainty(outlook.variance * bare).largest
        return Standing(value=value, carried=known)

    return Measure(columns=at, standing=standing)


def without_prior(Q: Array, at: Index, variance: Array) -> Array | None:
    """Cofactors (u, u) without what is known beforehand of some of the unknowns; None where they rest on it.

    at, variance  (k,) places of these, and their prior variances
    """
    scale = np.sqrt(variance)
    left = np.eye(len(at)) - Q[np.ix_(at, at)] / scale[:, None] / scale
    if np.linalg.eigvalsh(left)[0] < UNFREED:
        return None
    C = Q[:, at] / scale
    return Q + C @ np.linalg.solve(left, C.T)


def _wider(
    result: Adjustment, camera: str, symbols: tuple[str, ...], shifts: ProjectionShifts, outlook: Outlook
) -> float:
    """How much wider a calibration is stated than for white noise; 1 where other parameters are free than stated."""
    interior = next((i for i in result.interior if i.camera == camera and i.image is None), None)
    if result.noise.kind != "fields" or result.precision is None or interior is None or interior.free != symbols:
        return 1.0
    factored = Factored.of(result)
    row = next(r for r in factored.system.interior if r.image < 0 and r.owner(factored.system.block).id == camera)
    white = node_cofactor(factored.normals, factored.found, interior_unknowns(factored.system, row))
    stated = shifts.uncertainty(result.precision.interior[camera]).largest
    return stated / shifts.uncertainty(outlook.variance * white).largest
