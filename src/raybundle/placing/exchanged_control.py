"""Coordinates that stand at the wrong name or in another unit: two points or photographs exchanged, mm among metres.

Where the photographs alone have the points, and where the file has them, differ by a similarity.  Two exchanged names
are two large errors that vanish together the other way round, which states more than that both points are wrong.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from scipy.special import fdtri

from raybundle.adjustment.records.notice import Notice
from raybundle.block import Block, Role
from raybundle.errors import InputError, Value
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.statistics import fisher_tail
from raybundle.numerics.transform import robust_similarity, similarity
from raybundle.placing.mirrored import without_control
from raybundle.placing.positions import Positions

FEWEST = 5
"""Points: without two of them, three are left, which with four or more coordinates beyond those of a similarity test
each other."""
LEVEL = 1e-3
"""Probability with which right coordinates are taken for others, over all tries together, at most."""
TRIED = 10
"""Points that agree least with the others, of which each two are tried in each other's place."""
ROUGHLY = 0.01
"""Share of the extent up to which points agree, to begin with those that do not."""
LEFT = 3
"""Control points that place a block; with fewer there is no control left to use."""
UNITS = (1000.0, 0.001)
"""Millimetres and metres, either taken for the other."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Misread:
    """Rows that contradict all others as given, and agree with them if read otherwise."""

    rows: tuple[int, ...]
    factor: float
    """By which the coordinates are multiplied then; 1 where two are exchanged"""
    before: float
    """Distance from where all others put them, root mean square"""
    after: float
    """The same, read otherwise"""


def misread(source: Array, target: Array, *, units: bool) -> Misread | None:
    """The two points that are exchanged, or the one in another unit; None where no such reading stands out.

    source, target  (n, 3) in two systems that differ by a similarity
    units           whether a single point in another unit is looked for, too

    With W the square sum of the residuals of the similarity of the points without the k in doubt, of r = 3 (n - k) - 7
    degrees of freedom, and W + D with them, (D / 3 k) / (W / r) is distributed as F(3 k, r) if they are right.  It must
    be beyond the limit as given, for as many tries as there are, and within it as read otherwise, of one reading alone.
    A point that lies anywhere in the plan of the others is within that limit, a radius, by chance with the square of
    its ratio to their extent: that must be improbable, too.
    """
    n = len(source)
    if n < FEWEST:
        return None
    tries = list(_readings(source, target, units=units))
    found = [m for rows, factor, other in tries if (m := _judged(source, target, other, rows, factor, len(tries)))]
    return found[0] if len(found) == 1 else None


def _readings(source: Array, target: Array, *, units: bool) -> Iterator[tuple[tuple[int, ...], float, Array]]:
    middle = np.median(target, axis=0)
    extent = 2 * float(np.median(np.linalg.norm(target - middle, axis=1)))
    try:
        onto, _ = robust_similarity(source, target, ROUGHLY * extent)
    except InputError:
        return
    worst = np.argsort(-np.linalg.norm(onto.points(source) - target, axis=1), kind="stable")[:TRIED].tolist()
    for i, j in combinations(sorted(worst), 2):
        other = target.copy()
        other[[i, j]] = target[[j, i]]
        yield (i, j), 1.0, other
    for k in worst if units else ():
        for factor in UNITS:
            other = target.copy()
            other[k] *= factor
            yield (k,), factor, other


def _judged(
    source: Array, target: Array, other: Array, rows: tuple[int, ...], factor: float, tries: int
) -> Misread | None:
    keep = np.setdiff1d(np.arange(len(source)), rows)
    redundancy, count = 3 * len(keep) - 7, 3 * len(rows)
    try:
        rest = similarity(source[keep], target[keep])
        W = max(float(np.sum(rest.residuals**2)), 1e-300)
        F = [
            (float(np.sum(similarity(source, t).residuals ** 2)) - W) / count / (W / redundancy)
            for t in (target, other)
        ]
    except InputError:  # in a line
        return None
    if fisher_tail(F[0], count, redundancy) >= LEVEL / tries or fisher_tail(max(F[1], 0.0), count, redundancy) < LEVEL:
        return None
    # what is read otherwise must not fit for being anywhere within a wide band
    radius = np.sqrt(count * fdtri(count, redundancy, 1 - LEVEL) * W / redundancy)
    extent = np.sqrt(np.mean(np.sum((target[keep] - target[keep].mean(axis=0)) ** 2, axis=1)))
    if tries * min(radius / extent, 1.0) ** (2 * len(rows)) > LEVEL:
        return None
    put = rest.points(source[list(rows)])
    before, after = (float(np.sqrt(np.mean(np.sum((put - t[list(rows)]) ** 2, axis=1)))) for t in (target, other))
    return Misread(rows=rows, factor=factor, before=before, after=after)


def without_misread_control(block: Block, free: Array, *, units: bool) -> tuple[Block, list[Notice]]:
    """The block in which exchanged control points, or one in another unit, have no coordinates, and the fault.

    free   (p, 3) the points as the photographs alone have them; NaN where they do not
    units  whether coordinates stand as the file has them, in no coordinate system
    """
    points = block.points
    given = np.isin(np.asarray(points.role), (Role.CONTROL, Role.CHECK)) & np.isfinite(points.xyz).all(axis=1)
    rows = np.flatnonzero(given & np.isfinite(free).all(axis=1))
    found = misread(free[rows], points.xyz[rows], units=units)
    if found is None:
        return block, []
    mine = rows[list(found.rows)]
    names = tuple(points.ids[k] for k in mine)
    block = without_control(block, mine)
    few = bool(np.asarray(block.points.is_control).all(axis=1).sum() < LEFT)
    if few:
        block = without_control(block)
    values: dict[str, Value] = {"before_m": found.before, "after_m": found.after, "few": few, "least": LEFT}
    if found.factor == 1:
        return block, [
            Notice(code="control_exchanged", ids=names, values={**values, "first": names[0], "second": names[1]})
        ]
    unit: dict[str, Value] = {"point": names[0], "factor": found.factor, "millimetres": found.factor < 1}
    return block, [Notice(code="control_unit.point", ids=names, values={**values, **unit})]


def without_exchanged_positions(block: Block, positions: Positions) -> tuple[Positions, list[Notice]]:
    """The positions without those of two photographs that are exchanged, and the fault that states it."""
    rows: Index = np.flatnonzero(np.isfinite(positions.xyz).all(axis=1))
    found = misread(block.images.centre[positions.image[rows]], positions.xyz[rows], units=False)
    if found is None:
        return positions, []
    names = tuple(block.images.ids[positions.image[rows[k]]] for k in found.rows)
    keep = np.setdiff1d(np.arange(len(positions)), rows[list(found.rows)])
    values = {"first": names[0], "second": names[1], "before_m": found.before, "after_m": found.after}
    left = replace(
        positions, image=positions.image[keep], xyz=positions.xyz[keep], sigma=positions.sigma[keep],
        flight=positions.flight[keep], assumed=positions.assumed[keep],
    )  # fmt: skip
    return left, [Notice(code="positions_exchanged", ids=names, values=values)]
