"""Closed outlines in a plane: whether they are sound, and the triangles that they enclose."""

from __future__ import annotations

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index


def ring_of(line: Array, what: str) -> Array:
    """An outline (k, 2) without its first corner once more, counterclockwise.

    what    for messages, as "facade: its outline"
    raises  InputError where it crosses itself or encloses no area
    """
    if np.array_equal(line[0], line[-1]):
        line = line[:-1]
    crossing = crossing_sides(line)
    if crossing:
        a, b = crossing
        raise InputError("outline.crosses_itself", name=what, first=a + 1, second=b + 1)
    x, y = line.T
    area = float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) / 2
    if len(line) < 3 or abs(area) < 1e-9 * float(np.ptp(line, axis=0).max()) ** 2:
        raise InputError("outline.no_area", name=what)
    return line if area > 0 else line[::-1]


def ring_triangles(ring: Array) -> Index:
    """(m, 3) triangles of what a sound outline (k, 2) encloses, counterclockwise (Held 2001: ear clipping)."""
    from mapbox_earcut import triangulate_float64

    rows = triangulate_float64(np.ascontiguousarray(ring), np.array([len(ring)], np.uint32)).reshape(-1, 3)
    triangles = rows.astype(np.int64)
    a, b, c = (ring[triangles[:, k]] for k in range(3))
    turned = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) < (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    triangles[turned] = triangles[turned][:, ::-1]
    return triangles


def crossing_sides(outline: Array) -> tuple[int, int] | None:
    """The first two sides of a polygon (k, 2) that cross each other without being neighbours; None: it is simple."""
    n = len(outline)
    a, b = outline, np.roll(outline, -1, axis=0)

    def side(p: Array, q: Array, r: Array) -> Array:
        return np.sign(
            (q[..., 0] - p[..., 0]) * (r[..., 1] - p[..., 1]) - (q[..., 1] - p[..., 1]) * (r[..., 0] - p[..., 0])
        )

    for k in range(n):
        others = np.arange(k + 2, n if k else n - 1)
        if not len(others):
            continue
        c, d = a[others], b[others]
        p, q = a[k][None], b[k][None]
        crossed = (side(p, q, c) * side(p, q, d) < 0) & (side(c, d, p) * side(c, d, q) < 0)
        if crossed.any():
            return k, int(others[crossed][0])
    return None
