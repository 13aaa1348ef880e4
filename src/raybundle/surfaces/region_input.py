"""The part of an object that a surface is asked for: read from files, corners or a rectangle."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from raybundle.errors import InputError, as_detail
from raybundle.io.reading.words import number_of
from raybundle.numerics.arrays import Array
from raybundle.surfaces.files.input import areas_in
from raybundle.surfaces.grid import HeightPlane
from raybundle.surfaces.region import SurfaceRegion

NO_NUMBERS = {"nan", "inf", "-inf", "infinity"}


def region_asked(
    plane: HeightPlane, wkt: str, region: Sequence[str], extent: Sequence[float] | None, apart: float
) -> SurfaceRegion:
    """That of files or corners, or of a rectangle.

    wkt     coordinate system of a map; empty: the plane is one of the object
    apart   distance between points
    raises  InputError with what was given, where it is no area, and where it is smaller than that distance
    """
    areas = list[Sequence[Array]]()
    for given in region:
        _check(given)
        try:
            areas += areas_in(wkt, [given], None)
        except InputError as error:
            if error.file is not None:
                raise
            raise InputError("surface.region_invalid", given=given, details=[as_detail(error)]) from None
    found = SurfaceRegion.of(plane, areas_in(wkt, [], extent) if extent is not None else areas)
    left, bottom, right, top = found.extent.tolist()
    if min(right - left, top - bottom) < apart:
        raise InputError("surface.region_too_small", width=right - left, height=top - bottom, apart=apart)
    return found


def _check(given: str) -> None:
    """Raise InputError for a text that names no file and is no list of corners, with what is wrong of it."""
    there = bool(given.strip()) and Path(given).exists()
    if there and not Path(given).is_dir():
        return
    corners = [[number_of(word) for word in part.split()] for part in re.split(r"[;,]", given)]
    whole = all(len(c) == 2 and None not in c for c in corners)
    if there or not (whole and len(corners) > 2):
        words = re.findall(r"[^;,\s]+", given)
        if words and not there and not any(number_of(w) is not None or w.lower() in NO_NUMBERS for w in words):
            return  # a name, of which it is reported that there is no such file
        raise InputError("surface.region_not_readable", given=given, rectangle=whole and len(corners) == 2)
