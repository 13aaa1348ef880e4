"""Dots in rows and columns: which is whose neighbour, whatever the view and the lens.

In the affine frame of its own ellipse, in which a dot is a unit circle, the neighbours of a dot stand at right angles
and at the same distance, however the plane is tilted.  A lattice grows from a dot that has four such neighbours; each
step is predicted from the two before it, so that perspective and distortion are followed and gaps are gone round.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array, Index

NEAR = 12
"""Nearest dots among which the neighbours of a dot are sought."""
SQUARE = 0.3
"""Largest departure of a seed's neighbours from right angles and equal lengths, as a share."""
OFF = 0.25
"""Largest distance of a dot from where it is predicted, in units of the spacing there."""
SIZES = 1.7
"""Largest ratio of the areas of neighbouring dots."""
STEPS = ((1, 0), (0, 1), (-1, 0), (0, -1))


@dataclass(frozen=True, slots=True, kw_only=True)
class Lattice:
    """Dots of one lattice."""

    dot: Index
    """(n,) rows of the dots"""
    place: Index
    """(n, 2) column and row, from 0 upwards; as seen from the front, rows run downwards where columns run to the
    right"""

    @property
    def size(self) -> tuple[int, int]:
        """Columns and rows."""
        return int(self.place[:, 0].max()) + 1, int(self.place[:, 1].max()) + 1

    def grid(self) -> Array:
        """(rows, columns) rows of the dots, -1 where none was found."""
        columns, rows = self.size
        g = np.full((rows, columns), -1)
        g[self.place[:, 1], self.place[:, 0]] = self.dot
        return g


def lattices(xy: Array, ellipse: Array, least: int) -> list[Lattice]:
    """Lattices of at least so many dots, the largest first.

    xy       (n, 2) centres
    ellipse  (n, 2, 2) C of the edges
    """
    n = len(xy)
    if n < max(least, 5):
        return []
    frames = np.linalg.inv(np.linalg.cholesky(ellipse))
    area = np.sqrt(np.linalg.det(ellipse))
    seeds = _seeds(xy, frames, area)
    free = np.ones(n, bool)
    found: list[Lattice] = []
    for i, u, v in seeds:
        if not free[i]:
            continue
        labels = _grow(xy, area, i, u, v, free)
        free[list(labels.values())] = False
        if len(labels) >= least:
            place = np.array(list(labels), int).reshape(-1, 2)
            found.append(Lattice(dot=np.array(list(labels.values())), place=place - place.min(axis=0)))
    return sorted(found, key=lambda k: -len(k.dot))


def _seeds(xy: Array, frames: Array, area: Array) -> list[tuple[int, Array, Array]]:
    """Dots with four neighbours, squarest first, with the vectors to the next column and row."""
    scored: list[tuple[float, int, Array, Array]] = []
    for i in range(len(xy)):
        d = xy - xy[i]
        e = d @ frames[i].T
        r = np.hypot(*e.T)
        r[i] = np.inf
        r[(area > SIZES * area[i]) | (area < area[i] / SIZES)] = np.inf
        near = np.argsort(r)[:NEAR]
        near = near[np.isfinite(r[near])]
        if len(near) < 4:
            continue
        score, u, v = _cross(d[near], e[near])
        if score < SQUARE:
            scored.append((score, i, u, v))
    scored.sort(key=lambda s: s[0])
    return [(i, u, v) for _, i, u, v in scored]


def _cross(d: Array, e: Array) -> tuple[float, Array, Array]:
    """How far the nearest dot and those at right angles to it are from a cross, and its two arms in the image."""
    a = e[0]
    wanted = np.stack([a, [-a[1], a[0]], -a, [a[1], -a[0]]])
    off = np.hypot(*(e[:, None] - wanted).transpose(2, 0, 1)) / np.hypot(*a)
    which, score = off.argmin(axis=0), float(off.min(axis=0).max())
    u, v = (d[which[0]] - d[which[2]]) / 2, (d[which[1]] - d[which[3]]) / 2
    # rows run downwards where columns run to the right, as the image's do
    return score, u, (v if u[0] * v[1] - u[1] * v[0] > 0 else -v)


def _grow(xy: Array, area: Array, seed: int, u: Array, v: Array, free: Array) -> dict[tuple[int, int], int]:
    """Dots by column and row."""
    labels: dict[tuple[int, int], int] = {(0, 0): seed}
    owner: dict[int, tuple[int, int]] = {seed: (0, 0)}
    arms: dict[tuple[int, int], Array] = {(0, 0): np.stack([u, v])}
    queue = deque([(0, 0)])
    while queue:
        at = queue.popleft()
        i = labels[at]
        for k, (du, dv) in enumerate(STEPS):
            to = (at[0] + du, at[1] + dv)
            if to in labels:
                continue
            axis, sign = k % 2, 1 if k < 2 else -1
            back = labels.get((at[0] - du, at[1] - dv))
            arm = xy[i] - xy[back] if back is not None else sign * arms[at][axis]
            place = xy[i] + arm
            off = np.hypot(*(xy - place).T)
            j = int(off.argmin())
            if off[j] > OFF * np.hypot(*arm) or not free[j] or j in owner or not 1 / SIZES < area[j] / area[i] < SIZES:
                continue
            labels[to], owner[j] = j, to
            new = arms[at].copy()
            new[axis] = sign * (xy[j] - xy[i])
            arms[to] = new
            queue.append(to)
    return labels
