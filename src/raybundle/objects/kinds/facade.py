"""A plane facade, by its width and height or its outline."""

from __future__ import annotations

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.objects.kinds.base import ObjectKind
from raybundle.objects.surface import Surface


class Facade(ObjectKind):
    """In the plane Y = 0, seen from Y < 0: X to the right, Z up."""

    name = "facade"
    about = "a plane facade: a rectangle, or an outline in its plane"
    numbers = ("width", "height")
    line = "the outline of a facade in its plane (X to the right, Z up)"
    line_for = 2
    side = "front"
    example = (12.0, 8.0)

    def made(self, numbers: tuple[float, ...], line: Array | None) -> Surface:
        """The outline as triangles."""
        if line is None:
            w, h = numbers
            line = np.array([[-w / 2, 0.0], [w / 2, 0.0], [w / 2, h], [-w / 2, h]])
        if np.array_equal(line[0], line[-1]):
            line = line[:-1]
        crossing = crossing_sides(line)
        if crossing:
            a, b = crossing
            raise InputError(
                f"facade: its outline crosses itself: the sides from points {a + 1} and {b + 1}; give its corners in "
                "the order in which one walks round it"
            )
        x, z = line.T
        area = float(np.sum(x * np.roll(z, -1) - np.roll(x, -1) * z)) / 2
        if len(line) < 3 or abs(area) < 1e-9 * float(np.ptp(line, axis=0).max()) ** 2:
            raise InputError("facade: its outline encloses no area")
        if area < 0:
            line = line[::-1]
        from mapbox_earcut import triangulate_float64  # noqa: PLC0415

        rows = triangulate_float64(np.ascontiguousarray(line), np.array([len(line)], np.uint32)).reshape(-1, 3)
        triangles = rows.astype(np.int64)
        vertices = np.column_stack([line[:, 0], np.zeros(len(line)), line[:, 1]])
        a, b, c = (vertices[triangles[:, k]] for k in range(3))
        back = np.cross(b - a, c - a)[:, 1] > 0
        triangles[back] = triangles[back][:, ::-1]
        w, h = np.ptp(line, axis=0)
        return Surface(name="facade", vertices=vertices, triangles=triangles, about=f"{w:g} x {h:g} m")


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
