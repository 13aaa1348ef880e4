"""A flat sheet that lies: a calibration sheet, a board, a drawing."""

from __future__ import annotations

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.objects.kinds.base import ObjectKind, grid_triangles
from raybundle.objects.surface import Surface


class Sheet(ObjectKind):
    """In the plane Z = 0 about the origin, seen from above; where it hangs, Z points out of the wall."""

    name = "sheet"
    about = "a flat sheet or board, seen from above"
    numbers = ("width", "height")
    side = "above"
    example = (0.42, 0.297)

    def made(self, numbers: tuple[float, ...], line: Array | None) -> Surface:
        """Two triangles."""
        del line
        w, h = numbers
        x, y = np.meshgrid([-w / 2, w / 2], [-h / 2, h / 2])
        return Surface(
            name="sheet", vertices=np.column_stack([x.ravel(), y.ravel(), np.zeros(4)]),
            triangles=grid_triangles(2, 2), about=phrase("object_size.flat", width_m=w, height_m=h),
        )  # fmt: skip
