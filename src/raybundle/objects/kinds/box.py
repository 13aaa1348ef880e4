"""A box on the ground: a house, a machine, a container."""

from __future__ import annotations

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.objects.kinds.base import ObjectKind
from raybundle.objects.surface import Surface

FACES = np.array(
    [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4], [1, 2, 6], [1, 6, 5], [2, 3, 7], [2, 7, 6],
     [3, 0, 4], [3, 4, 7]]
)  # fmt: skip


class Box(ObjectKind):
    """Its middle above the origin, its bottom at Z = 0; the bottom is not measured."""

    name = "box"
    about = "a box on the ground: its four sides and its top"
    numbers = ("width", "depth", "height")
    side = "round"
    example = (4.0, 3.0, 2.5)

    def made(self, numbers: tuple[float, ...], line: Array | None) -> Surface:
        """Eight corners, twelve triangles."""
        del line
        w, d, h = numbers
        x, y = np.array([-1, 1, 1, -1]) * w / 2, np.array([-1, -1, 1, 1]) * d / 2
        corners = np.concatenate([np.stack([x, y, np.full(4, z)], axis=1) for z in (0.0, h)])
        wanted = np.arange(len(FACES)) >= 2
        return Surface(
            name="box",
            vertices=corners,
            triangles=FACES,
            wanted=wanted,
            about=phrase("object_size.building", width_m=w, depth_m=d, height_m=h, corners=4),
        )
