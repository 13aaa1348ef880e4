"""Outlines and axes of objects: pairs of coordinates from CSV, GeoJSON, KML or what OGR reads, in metres."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.io.missions.areas import in_crs, plane_crs, read_shapes
from raybundle.io.reading.dialects import with_points
from raybundle.io.reading.files import read_lines
from raybundle.io.reading.words import number_of, quoted
from raybundle.numerics.arrays import Array

TEXT = (".csv", ".txt")


def read_outline(path: Path, crs: str = "") -> Array:
    """(k, 2) places of the line or area in a file [m].

    CSV has a pair of coordinates a line, with or without a header, with decimal commas too where none separates; other
    files hold one line or area, in degrees or in `crs`, which is brought into a plane system in metres.
    raises  InputError with file and line where that is not so
    """
    if path.suffix.lower() in TEXT:
        return _pairs(path)
    shapes = [s for s in read_shapes(str(path), crs) if s.kind != "place"]
    if len(shapes) != 1:
        raise InputError("outline.not_one", n=len(shapes), file=path)
    return in_crs(shapes[0].xy, shapes[0].crs, plane_crs(shapes[0]))


def _pairs(path: Path) -> Array:
    found = list[tuple[float, float]]()
    for line, text in read_lines(path):
        words = text.replace(";", ",").replace(",", " ").split()
        if len(words) > 2 and len(apart := re.split(r"[;\s]+", text.strip())) == 2:
            words = with_points(apart)  # decimal commas
        if not words:
            continue
        values = [number_of(w) for w in words]
        if len(values) == 2 and values[0] is not None and values[1] is not None:
            found.append((values[0], values[1]))
        elif found or any(v is not None for v in values):
            raise InputError("outline.no_pair", text=quoted(text.strip()), file=path, line=line)
    if not found:
        raise InputError("outline.empty", file=path)
    return np.array(found)
