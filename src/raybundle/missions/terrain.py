"""Heights of way points over ground: as asked for above it, no steeper than a vehicle climbs, in few straight parts."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.objects.heights import HeightGrid

Ground = Callable[[Array], Array]
"""Heights of the ground (n,) at x, y (n, 2); raises InputError where one is not known."""


def level_ground(height: float) -> Ground:
    """Ground of one height everywhere."""
    return lambda xy: np.full(len(xy), height)


def ground_of(grid: HeightGrid) -> Ground:
    """Ground of a grid of heights; what is asked for beyond it or at a hole is an error with the place."""

    def heights(xy: Array) -> Array:
        found = grid.at(xy)
        bad = np.flatnonzero(np.isnan(found))
        if len(bad):
            x, y = xy[bad[0]]
            place = grid.place(xy[bad])
            beyond = ((place < 0) | (place > np.array(grid.heights.shape) - 1)).any(axis=1)
            if beyond.any():
                low, high = grid.corners.min(axis=0), grid.corners.max(axis=0)
                x, y = xy[bad[int(np.flatnonzero(beyond)[0])]]
                raise InputError(
                    "terrain.flight_beyond", x=x, y=y, low_x=low[0], high_x=high[0], low_y=low[1], high_y=high[1]
                )
            raise InputError("terrain.void_below_flight", x=x, y=y, n=len(bad))
        return found

    return heights


@dataclass(frozen=True, slots=True, kw_only=True)
class Climbing:
    """Limits of a way's heights."""

    up: float
    """steepest climb [m/m]"""
    down: float
    """steepest descent [m/m]"""
    tolerance: float = 1.0
    """by which a height may differ from that asked for [m]"""
    step: float = 5.0
    """between the places at which the ground is looked at [m]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Profile:
    """A way with heights."""

    xyz: Array
    """(n, 3)"""
    part: Array
    """(n,) along the given points: 1.5 is half way from the second to the third"""
    raised: float
    """by which it lies above what was asked for at most, the ground being steeper than the vehicle climbs [m]"""


def profile(xy: Array, above: Array, ground: Ground, limits: Climbing) -> Profile:
    """Heights of a way over the ground.

    xy      (k, 2) its corners, which are kept
    above   (k,) asked for above the ground, linear between
    Where the ground rises or falls more steeply than the vehicle can, the way begins to climb earlier and descends
    later: it is never nearer to the ground than asked for, but for the tolerance.  Then points are left out while the
    straight way between the others stays within the tolerance (Douglas and Peucker 1973).
    """
    s, part = _sampled(xy, limits.step)
    places = np.stack([np.interp(part, np.arange(len(xy)), xy[:, j]) for j in (0, 1)], axis=1)
    wanted = ground(places) + np.interp(part, np.arange(len(xy)), above)
    z = _climbable(s, wanted, limits)
    keep = _corners(s, z, np.isin(part, np.arange(len(xy))), limits.tolerance)
    return Profile(xyz=np.column_stack([places, z])[keep], part=part[keep], raised=float((z - wanted).max(initial=0.0)))


def _sampled(xy: Array, step: float) -> tuple[Array, Array]:
    """Lengths along a way (n,) and places in its points (n,), corners among them."""
    length = np.linalg.norm(np.diff(xy, axis=0), axis=1)
    parts = [k + np.arange(n) / n for k, n in enumerate(np.maximum(1, np.ceil(length / step)).astype(int).tolist())]
    part = np.append(np.concatenate(parts) if parts else np.zeros(0), len(xy) - 1.0)
    return np.interp(part, np.arange(len(xy)), np.append(0.0, np.cumsum(length))), part


def _climbable(s: Array, z: Array, limits: Climbing) -> Array:
    """The lowest heights not below the wanted ones that neither climb nor descend too steeply."""
    result = z.copy()
    ds = np.diff(s)
    for k in range(len(ds)):  # a descent may not be steeper than `down`
        result[k + 1] = max(result[k + 1], result[k] - limits.down * ds[k])
    for k in range(len(ds) - 1, -1, -1):  # nor a climb than `up`
        result[k] = max(result[k], result[k + 1] - limits.up * ds[k])
    return result


def _corners(s: Array, z: Array, fixed: Array, tolerance: float) -> Array:
    """Rows of the points that have to stay."""
    keep = np.flatnonzero(fixed).tolist()
    stack = list(pairwise(keep))
    while stack:
        a, b = stack.pop()
        if b - a < 2:
            continue
        inner = np.arange(a + 1, b)
        length = s[b] - s[a]
        share = (s[inner] - s[a]) / length if length > 0 else np.zeros(len(inner))
        off = np.abs(z[inner] - z[a] - share * (z[b] - z[a]))
        k = int(off.argmax())
        if off[k] > tolerance:
            keep.append(a + 1 + k)
            stack += [(a, a + 1 + k), (a + 1 + k, b)]
    return np.array(sorted(keep))


def below_photographs(xyz: Array, above: float) -> Ground:
    """Ground as planned photographs (n, 3) let expect it: so far below each; the nearest one counts."""
    from scipy.spatial import KDTree

    tree = KDTree(xyz[:, :2])
    return lambda xy: xyz[tree.query(np.nan_to_num(xy))[1], 2] - above
