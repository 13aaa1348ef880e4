"""A standing cylinder: a tank, a column, a tower."""

from __future__ import annotations

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.objects.kinds.base import ObjectKind, grid_triangles
from raybundle.objects.surface import Surface

SIDES = 72
"""Of the prism that stands for it: it deviates by 0.1 % of the radius."""


class Cylinder(ObjectKind):
    """Its axis above the origin, its bottom at Z = 0; the ends are not measured."""

    name = "cylinder"
    about = "a standing cylinder: its mantle"
    numbers = ("diameter", "height")
    side = "round"
    example = (3.0, 4.0)

    def made(self, numbers: tuple[float, ...], line: Array | None) -> Surface:
        """A prism with its ends."""
        del line
        diameter, h = numbers
        a = 2 * np.pi * np.arange(SIDES) / SIDES
        ring = diameter / 2 * np.stack([np.cos(a), np.sin(a)], axis=1)
        rings = [np.column_stack([ring, np.full(SIDES, z)]) for z in (0.0, h)]
        around = grid_triangles(2, SIDES + 1)  # the last column is the first once more
        around = around // (SIDES + 1) * SIDES + around % (SIDES + 1) % SIDES
        k = np.arange(SIDES)
        after = (k + 1) % SIDES
        bottom = np.stack([np.full(SIDES, 2 * SIDES), after, k], axis=1)
        top = np.stack([np.full(SIDES, 2 * SIDES + 1), SIDES + k, SIDES + after], axis=1)
        triangles = np.concatenate([around, bottom, top])
        return Surface(
            name="cylinder", vertices=np.concatenate([*rings, [[0, 0, 0], [0, 0, h]]]), triangles=triangles,
            wanted=np.arange(len(triangles)) < len(around),
            about=phrase("object_size.cylinder", diameter_m=diameter, height_m=h),
        )  # fmt: skip
