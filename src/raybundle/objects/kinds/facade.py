"""A plane facade, by its width and height or its outline."""

from __future__ import annotations

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.objects.kinds.base import ObjectKind
from raybundle.objects.rings import ring_of, ring_triangles
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
        line = ring_of(line, "facade: its outline")
        triangles = ring_triangles(line)
        vertices = np.column_stack([line[:, 0], np.zeros(len(line)), line[:, 1]])
        w, h = np.ptp(line, axis=0)
        return Surface(
            name="facade",
            vertices=vertices,
            triangles=triangles,
            about=phrase("object_size.flat", width_m=w, height_m=h),
        )
