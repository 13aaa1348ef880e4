"""A building of one height over its footprint."""

from __future__ import annotations

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.objects.kinds.base import ObjectKind
from raybundle.objects.kinds.facade import crossing_sides
from raybundle.objects.surface import Surface


class Building(ObjectKind):
    """Walls and a flat roof over a rectangle about the origin, or over the footprint given; its floor at Z = 0."""

    name = "building"
    about = "a building: its walls and a flat roof over a rectangle or a footprint"
    numbers = ("width", "depth", "height")
    line = "the footprint of a building (X, Y)"
    line_for = 2
    side = "round"
    example = (12.0, 8.0, 6.0)

    def made(self, numbers: tuple[float, ...], line: Array | None) -> Surface:
        """A prism; the floor hides and is not measured."""
        from mapbox_earcut import triangulate_float64  # noqa: PLC0415

        height = numbers[-1]
        if line is None:
            w, d = numbers[:2]
            line = np.array([[-w / 2, -d / 2], [w / 2, -d / 2], [w / 2, d / 2], [-w / 2, d / 2]])
        if np.array_equal(line[0], line[-1]):
            line = line[:-1]
        crossing = crossing_sides(line)
        if crossing:
            a, b = crossing
            raise InputError(
                f"building: its footprint crosses itself: the sides from points {a + 1} and {b + 1}; give its corners "
                "in the order in which one walks round it"
            )
        x, y = line.T
        area = float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) / 2
        if len(line) < 3 or abs(area) < 1e-9 * float(np.ptp(line, axis=0).max()) ** 2:
            raise InputError("building: its footprint encloses no area")
        line = line if area > 0 else line[::-1]
        n = len(line)
        flat = triangulate_float64(np.ascontiguousarray(line), np.array([n], np.uint32)).reshape(-1, 3).astype(np.int64)
        p, q, r = (line[flat[:, k]] for k in range(3))
        turned = (q[:, 0] - p[:, 0]) * (r[:, 1] - p[:, 1]) < (q[:, 1] - p[:, 1]) * (r[:, 0] - p[:, 0])
        flat[turned] = flat[turned][:, ::-1]
        k = np.arange(n)
        after = (k + 1) % n
        walls = np.concatenate([np.stack([k, after, after + n], axis=1), np.stack([k, after + n, k + n], axis=1)])
        triangles = np.concatenate([flat[:, ::-1], walls, flat + n])
        vertices = np.concatenate([np.column_stack([line, np.full(n, z)]) for z in (0.0, height)])
        w, d = np.ptp(line, axis=0)
        return Surface(
            name="building", vertices=vertices, triangles=triangles, wanted=np.arange(len(triangles)) >= len(flat),
            about=f"{w:g} x {d:g} x {height:g} m" + (f", {n} corners" if n != 4 else ""),
        )  # fmt: skip
