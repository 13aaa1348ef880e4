"""Places at which photographs are counted: one for each square of a grid, in that part of it that an area has."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.missions.polygons import inside, part_in_box
from raybundle.missions.terrain import Ground
from raybundle.numerics.arrays import Array, Index

MOST_PLACES = 20_000
"""Of the ground at which photographs are counted."""
LEAST_PART = 1e-9
"""Of a square: less of the area is rounding"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Places:
    """Squares of a grid over an area, and a place in each."""

    xyz: Array
    """(n, 3) of the ground, in the middle of what the area has of each square [m]"""
    middle: Array
    """(n, 2) of the squares [m]"""
    part: Array
    """(n,) share of each square that the area has, above 0 to 1"""
    step: float
    """side of the squares [m]"""
    outline: Array | None = None
    """(k, 2) to which the squares are cut; None: they are not"""

    def __len__(self) -> int:
        """Number of places."""
        return len(self.xyz)

    def area_m2(self, rows: Index | slice = slice(None)) -> float:
        """What some places stand for [m^2]."""
        return float(self.part[rows].sum()) * self.step**2


def free_places(xyz: Array, step: float) -> Places:
    """Places (n, 3) that no outline bounds, each for a square of the step."""
    return Places(xyz=xyz, middle=xyz[:, :2], part=np.ones(len(xyz)), step=step)


def places(outline: Array, step: float, ground: Ground) -> Places:
    """Places of the ground within an outline; the step is enlarged where they would be too many.

    Squares that the outline cuts count by their part inside, so that the parts together are the area.
    """
    low, size = outline.min(axis=0), np.ptp(outline, axis=0)
    step = max(step, float(np.sqrt(size[0] * size[1] / MOST_PLACES)))
    count = np.maximum(np.ceil(size / step - 1e-9).astype(int), 1)
    cut = np.zeros(count, bool)
    cut[tuple(_crossed((outline - low) / step, count).T)] = True
    i, j = (a.ravel() for a in np.meshgrid(*(np.arange(n) for n in count), indexing="ij"))
    middle = low + step * (np.stack([i, j], axis=1) + 0.5)
    at, part = middle.copy(), inside(outline, middle).astype(float)
    for k in np.flatnonzero(cut[i, j]).tolist():
        area, at[k] = part_in_box(outline, middle[k] - step / 2, middle[k] + step / 2)
        part[k] = area / step**2
    keep = part > LEAST_PART
    xy = at[keep]
    return Places(
        xyz=np.column_stack([xy, ground(xy)]), middle=middle[keep], part=np.minimum(part[keep], 1.0), step=step,
        outline=outline,
    )  # fmt: skip


def _crossed(ring: Array, count: Array) -> Index:
    """Columns and rows (m, 2) of the unit squares through which the edges of a polygon run."""
    found: list[Array] = []
    for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        cuts = [np.array([0.0, 1.0])]
        for u, v in zip(a.tolist(), b.tolist(), strict=True):
            between = np.arange(np.ceil(min(u, v)), np.floor(max(u, v)) + 1)
            cuts.append((between - u) / (v - u) if u != v else np.zeros(0))
        t = np.unique(np.concatenate(cuts))
        middle = (t[:-1] + t[1:]) / 2
        found.append(np.floor(a + middle[:, None] * (b - a)).astype(np.int64))
    return np.clip(np.concatenate(found), 0, count - 1)
