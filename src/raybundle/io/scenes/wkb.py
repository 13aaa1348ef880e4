"""Points from well-known binary (OGC 06-103r4), as GDAL hands them out."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array

ISO_Z, EWKB_Z = 1000, 0x80000000


def points_of(shapes: Sequence[Any], path: Path) -> Array:
    """(n, 3) coordinates of points; NaN for a height that a point has not.

    raises  InputError for another geometry, or none
    """
    found = np.full((len(shapes), 3), np.nan)
    for k, data in enumerate(shapes):
        values = _point(b"" if data is None else bytes(data))
        if values is None:
            raise InputError("scene_control.not_points", file=path, column=f"row {k + 1}")
        found[k, : len(values)] = values
    return found


def _point(data: bytes) -> tuple[float, ...] | None:
    try:
        order = "<" if data[0] == 1 else ">"
        (code,) = struct.unpack_from(f"{order}I", data, 1)
        high = bool(code & EWKB_Z) or (code & 0xFFFF) // ISO_Z in {1, 3}
        if (code & 0xFFFF) % ISO_Z != 1:
            return None
        return struct.unpack_from(f"{order}{3 if high else 2}d", data, 5)
    except (IndexError, struct.error):
        return None
