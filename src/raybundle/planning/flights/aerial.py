"""What photographs from the air will determine, of a square and of a mission: predicted precision, what stays open.

Observations are exact and sigma0 is 1: the figures are those of the network (`raybundle.planning.predicted`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.block import Block
from raybundle.errors import DatumDefect, NotSolvable
from raybundle.numerics.arrays import Array, Index
from raybundle.objects.surface import farthest_first
from raybundle.planning.flights.aerial_block import Aerial, aerial_block
from raybundle.planning.predicted import Predicted, predicted

UNSOLVED = "everything"
"""What is open where there is no solution at all and nothing is named"""
LOOSE = 100.0
"""Standard deviation [m] of points that hold the block where nothing else does, to show what is open"""
NO_RTK = (5.0, 5.0, 10.0)
"""Standard deviations of positions where photographs state none, as `raybundle orient` takes them [m]"""
RTK_SHARE = 0.1
"""Of those standard deviations: carrier phases give centimetres to decimetres, codes metres; a tenth parts them"""
ENOUGH_GAIN = 0.1
"""Share of a standard deviation that more control must bring to be worth it"""


def is_rtk(sigma: tuple[float, float, float]) -> bool:
    """Whether positions of these standard deviations (east, north, up) [m] are those of carrier phases."""
    return all(own < RTK_SHARE * plain for own, plain in zip(sigma, NO_RTK, strict=True))


@dataclass(frozen=True, slots=True, kw_only=True)
class Precision:
    """Standard deviations of the ground points; NaN where something is not determinable."""

    sigma_m: Array
    """(3,) X, Y, Z, root mean square over the points"""
    plan_worst_m: float
    """Largest of a point in plan: root mean square of X and Y"""
    height_worst_m: float
    std: Mapping[str, float]
    """Standard deviations of what is free of camera and lever arm, in the units of their models"""
    lost: tuple[str, ...]
    """What is not determinable; where that leaves the block without a place, points are held loosely to show it"""
    photographs: int
    points: int

    @property
    def plan_m(self) -> float:
        """In plan, root mean square over the points and X, Y."""
        return float(np.sqrt(np.mean(self.sigma_m[:2] ** 2)))


def precision(plan: Aerial, least_rays: int = 2) -> Precision:
    """What a plan determines; figures over the points of so many rays.

    raises  NotSolvable where photographs see too little in common
    Limits: errors that all positions share, as of a wrong antenna height or geoid, are in no figure.
    """
    block = aerial_block(plan)
    try:
        found = predicted(block)
    except DatumDefect:
        # a lever arm leaves the block without a place: what is open with it is given by holding three points loosely
        far = farthest_first(plan.ground, 3)
        loose = replace(plan, control=far, control_sigma=(LOOSE, LOOSE, LOOSE))
        block = aerial_block(loose)
        found = predicted(block)
    return _precision(found, block, least_rays)


def _precision(found: Predicted, block: Block, least_rays: int) -> Precision:
    lost = tuple(dict.fromkeys(symbol for _, symbol in found.lost))
    variance = np.diagonal(found.points, axis1=1, axis2=2)
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    free = np.isfinite(variance).all(axis=1) & (rays >= least_rays)
    variance = variance[free]
    nothing = float("nan")
    return Precision(
        sigma_m=np.full(3, np.nan) if lost else np.sqrt(variance.mean(axis=0)),
        plan_worst_m=nothing if lost else float(np.sqrt(variance[:, :2].mean(axis=1).max())),
        height_worst_m=nothing if lost else float(np.sqrt(variance[:, 2].max())),
        std={symbol: s for (_, symbol), s in found.std.items()}, lost=lost, photographs=len(block.images),
        points=int(free.sum()),
    )  # fmt: skip


def open_in(plan: Aerial) -> tuple[str, ...]:
    """What a plan leaves open, in a network so weak that there may be no solution."""
    return by_design(plan)[0]


def by_design(plan: Aerial) -> tuple[tuple[str, ...], Mapping[str, float]]:
    """What a plan leaves open, as `open_in`, and the standard deviations of all other parameters."""
    try:
        found = precision(plan)
    except NotSolvable as error:
        return tuple(dict.fromkeys(u.symbol for u in error.undetermined if u.kind == "parameter")) or (UNSOLVED,), {}
    return found.lost, {symbol: s for symbol, s in found.std.items() if symbol not in found.lost}


def mended(before: float, design: float, after: float) -> bool:
    """Whether a change of a plan mends a parameter that hung on the unevenness of the flight.

    before, after  its standard deviations in an uneven flight, as planned (infinite: not determinable) and changed
    design         the same where the changed flight is exactly level at one height

    Either the design alone shows it better than the unevenness did, or more than half of what is known of it comes from
    the change: information is the inverse of variance, which then falls to less than half.
    """
    return design < before or 2 * after**2 < before**2


PLACES = {
    1: ((0, 0),),
    2: ((-1, -1), (1, 1)),
    3: ((-1, -1), (1, -1), (0, 1)),
    4: ((-1, -1), (1, 1), (-1, 1), (1, -1)),
    5: ((0, 0), (-1, -1), (1, 1), (-1, 1), (1, -1)),
    9: ((0, 0), (-1, -1), (1, 1), (-1, 1), (1, -1), (0, -1), (0, 1), (-1, 0), (1, 0)),
    13: ((0, 0), (-1, -1), (1, 1), (-1, 1), (1, -1), (0, -1), (0, 1), (-1, 0), (1, 0),
         (-0.5, -0.5), (0.5, 0.5), (-0.5, 0.5), (0.5, -0.5)),
}  # fmt: skip
"""Number of control points -> where they lie: 0 the middle, 1 four fifths of the way to an edge"""
PLACED = {3: "two_corners", 5: "corners", 9: "edges", 13: "between"}
LAYOUTS = {
    "corners": PLACES[5],
    "one_edge": ((-1, -1), (-0.5, -1), (0, -1), (0.5, -1), (1, -1)),
    "middle": ((0, 0), (-0.2, -0.2), (0.2, 0.2), (-0.2, 0.2), (0.2, -0.2)),
}
"""Of five points"""
NUMBERS, SIGMAS_M = (3, 5, 9, 13), (0.005, 0.01, 0.03)
REACH = 0.4


def control_rows(ground: Array, places: Sequence[Sequence[float]]) -> Index:
    """Rows (k,) of the ground points nearest to places in the box round them, each once."""
    low, high = ground[:, :2].min(axis=0), ground[:, :2].max(axis=0)
    return _at(ground, (low + high) / 2 + np.array(places, float) * REACH * (high - low))


def _at(ground: Array, xy: Array) -> Index:
    rows = [int(np.linalg.norm(ground[:, :2] - at, axis=1).argmin()) for at in xy]
    return np.array(list(dict.fromkeys(rows)), np.int64)


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlRow:
    """What a number of control points of a standard deviation brings."""

    points: int
    sigma_m: float
    """Of each coordinate; NaN without control"""
    where: str
    """Places as in `PLACED` and `LAYOUTS`; empty: there is none"""
    found: Precision


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlTable:
    """Control by number and standard deviation, and by where it lies."""

    rows: tuple[ControlRow, ...]
    """Without any first, then by standard deviation, then by number"""
    layouts: tuple[ControlRow, ...]
    """Five points of 10 mm, differently placed"""

    def enough(self, sigma_m: float) -> ControlRow:
        """The row of this standard deviation from which on more points bring less than a tenth of the worst height."""
        mine = [self.rows[0], *(r for r in self.rows if r.sigma_m == sigma_m)]
        worst = [r.found.height_worst_m for r in mine]
        for k, row in enumerate(mine):
            if np.isfinite(worst[k]) and min(worst[k:]) > (1 - ENOUGH_GAIN) * worst[k]:
                return row
        return mine[-1]


def control_table(plan: Aerial) -> ControlTable:
    """Control points of several numbers and standard deviations in a plan; its own control is left aside.

    raises  NotSolvable as `precision`
    """

    def row(places: Sequence[Sequence[float]], sigma: float, where: str) -> ControlRow:
        rows = control_rows(plan.ground, places) if places else np.zeros(0, np.int64)
        known = replace(plan, control=rows, control_sigma=(sigma, sigma, sigma))
        return ControlRow(points=len(rows), sigma_m=sigma, where=where, found=precision(known))

    rows = [row((), float("nan"), "")]
    rows += [row(PLACES[n], s, PLACED[n]) for s in SIGMAS_M for n in NUMBERS]
    return ControlTable(rows=tuple(rows), layouts=tuple(row(p, 0.01, name) for name, p in LAYOUTS.items()))
