"""A building of one height over its footprint."""

from __future__ import annotations

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.objects.kinds.base import ObjectKind
from raybundle.objects.rings import ring_of, ring_triangles
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
        height = numbers[-1]
        if line is None:
            w, d = numbers[:2]
            line = np.array([[-w / 2, -d / 2], [w / 2, -d / 2], [w / 2, d / 2], [-w / 2, d / 2]])
        line = ring_of(line, "building: its footprint")
        n, flat = len(line), ring_triangles(line)
        k = np.arange(n)
        after = (k + 1) % n
        walls = np.concatenate([np.stack([k, after, after + n], axis=1), np.stack([k, after + n, k + n], axis=1)])
        triangles = np.concatenate([flat[:, ::-1], walls, flat + n])
        vertices = np.concatenate([np.column_stack([line, np.full(n, z)]) for z in (0.0, height)])
        w, d = np.ptp(line, axis=0)
        return Surface(
            name="building", vertices=vertices, triangles=triangles, wanted=np.arange(len(triangles)) >= len(flat),
            about=phrase("object_size.building", width_m=w, depth_m=d, height_m=height, corners=n),
        )  # fmt: skip
