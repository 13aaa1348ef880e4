"""Heights of the ground from rasters, through rasterio (extra `geo`)."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, Literal, NoReturn

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.geo.parsed_systems import parse_crs
from raybundle.io.raster_library import raster_errors, raster_library
from raybundle.io.reading.files import check_regular
from raybundle.io.reading.words import quoted
from raybundle.numerics.arrays import Array
from raybundle.objects.heights import HeightGrid

Unit = Literal["", "m", "ft", "us-ft"]
METRES_IN = {"m": 1.0, "ft": 0.3048, "us-ft": 1200 / 3937}
_UNITS = {
    "": "", "m": "m", "metre": "m", "meter": "m", "metres": "m", "meters": "m", "ft": "ft", "foot": "ft", "feet": "ft",
    "us survey foot": "us-ft", "us-ft": "us-ft", "ussurveyfoot": "us-ft", "ftus": "us-ft",
}  # fmt: skip
MOST_CELLS = 40_000_000
"""That are read at once: 20 km by 20 km of metre cells, 0.3 GB."""
SAMPLED = 1024
"""Rows and columns that show whether heights are rounded"""
LOWEST, HIGHEST = -500.0, 9000.0
"""Heights of the ground of the earth [m], with some room."""


def read_heights(path: Path, crs: str, box: Array, *, unit: Unit = "", band: int = 1) -> HeightGrid:
    """Heights over a box of a plane coordinate system in metres.

    crs   the system in which they are wanted, as EPSG:32632
    box   (2, 2) least and greatest x, y there [m]; what of the raster lies in it is read
    unit  of the heights, where the raster does not say and its coordinates are not in metres either
    A raster in another system, in degrees as well, is brought over by bilinear interpolation onto cells of the same
    size in metres, which is stated in the remarks; its heights stay as they are but for their unit.
    raises  InputError for a missing library, no raster, no coordinate system, no overlap, unknown or odd units
    """
    check_regular(path)
    library = raster_library(path)
    with raster_errors(path), library.open(path) as source:
        return _read(library, source, path, crs, box, unit, band)


def read_all_heights(path: Path, crs: str = "", *, unit: Unit = "", band: int = 1) -> HeightGrid:
    """All heights of a raster, in `crs` or its own plane coordinate system.

    raises  InputError as `read_heights`, and where the raster is in degrees and `crs` does not say in what plane system
            it is wanted
    """
    check_regular(path)
    library = raster_library(path)
    with raster_errors(path), library.open(path) as source:
        if source.crs is None:
            crs = crs or "EPSG:3857"  # never used: what names no system is refused
        wkt = "" if source.crs is None else str(source.crs.to_wkt())
        own = parse_crs(wkt) if wkt else None
        if not crs and own is not None:
            if own.is_geographic:
                raise InputError("raster.degrees", system=own.name, file=path)
            crs = wkt
        left, bottom, right, top = source.bounds
        if own is not None and source.crs != library.crs.CRS.from_wkt(parse_crs(crs).to_wkt()):
            target = library.crs.CRS.from_wkt(parse_crs(crs).to_wkt())
            left, bottom, right, top = library.warp.transform_bounds(source.crs, target, left, bottom, right, top)
        return _read(library, source, path, crs, np.array([[left, bottom], [right, top]]), unit, band)


def whole_units(path: Path, band: int = 1) -> bool:
    """Whether all heights of a raster, some of a large one, are whole numbers of its unit."""
    library = raster_library(path)
    with raster_errors(path), library.open(path) as source:
        shape = tuple(min(n, SAMPLED) for n in source.shape)
        scale, offset = scale_and_offset(source, band)
        found = source.read(band, out_shape=shape, masked=True).compressed() * scale + offset
    known = found[np.isfinite(found)]
    return bool(len(known)) and bool((known == np.round(known)).all())


def scale_and_offset(source: Any, band: int) -> tuple[float, float]:
    """By which stored numbers of a band are heights (GDAL: stored number times scale plus offset)."""
    return float(source.scales[band - 1]), float(source.offsets[band - 1])


def no_system(path: Path) -> NoReturn:
    """Raise InputError of a raster that does not say where it lies."""
    raise InputError("raster.no_system", file=path)


def _read(library: Any, source: Any, path: Path, crs: str, box: Array, unit: Unit, band: int) -> HeightGrid:
    if not 1 <= band <= source.count:
        raise InputError("raster.band_missing", n=source.count, band=band, file=path)
    if source.crs is None:
        no_system(path)
    own = parse_crs(source.crs.to_wkt())
    metres, remarks = metres_of_heights(source, own, path, unit, band)
    target = library.crs.CRS.from_wkt(parse_crs(crs).to_wkt())
    same = source.crs == target and source.transform.b == 0 and source.transform.d == 0
    low, high = np.asarray(box, float)
    bounds = tuple(low) + tuple(high)
    if same:
        heights, transform = _window(library, source, path, bounds, band)
    else:
        heights, transform = _warped(library, source, path, target, bounds, band)
        system = "degrees" if own.is_geographic else own.name
        remarks.append(phrase("raster.transformed", name=path.name, system=system, target=crs, cell_m=abs(transform.a)))
    scale, offset = scale_and_offset(source, band)
    heights = np.where(np.isfinite(heights), (heights * scale + offset) * metres, np.nan)
    check_heights(heights, path)
    return HeightGrid(
        heights=heights, origin=_centre(transform), column=(transform.a, transform.d),
        row=(transform.b, transform.e), crs=crs, remarks=tuple(remarks),
    )  # fmt: skip


def _centre(t: Any) -> tuple[float, float]:
    """x, y of the centre of the first cell."""
    return t.c + (t.a + t.b) / 2, t.f + (t.d + t.e) / 2


def metres_of_heights(source: Any, own: Any, path: Path, unit: Unit, band: int) -> tuple[float, list[str]]:
    """Metres in a unit of the heights, and what is to be stated of it."""
    stated = str(source.units[band - 1] or "").strip().lower()
    if stated not in _UNITS:
        raise InputError("raster.unit_unknown", unit=quoted(stated), file=path)
    found = _UNITS[stated]
    if not found and own.is_compound:
        factor = own.sub_crs_list[-1].axis_info[0].unit_conversion_factor
        found = next((u for u, m in METRES_IN.items() if abs(m - factor) < 1e-9), "")
    if unit and found and unit != found:
        raise InputError("raster.unit_differs", own=found, unit=unit, file=path)
    found = unit or found
    if not found and own.is_projected and abs(own.axis_info[0].unit_conversion_factor - 1) > 1e-9:
        raise InputError("raster.dem_unit_missing", unit=own.axis_info[0].unit_name, file=path)
    if found in {"ft", "us-ft"}:
        return METRES_IN[found], [phrase("raster.feet", name=path.name)]
    return 1.0, [] if found else [phrase("raster.unit_assumed", name=path.name)]


def _window(library: Any, source: Any, path: Path, bounds: tuple[float, ...], band: int) -> tuple[Array, Any]:
    """Heights of the cells in and round a box, as they are."""
    a, b, c, d = bounds
    size = max(abs(source.transform.a), abs(source.transform.e))
    wanted = library.windows.from_bounds(a - 2 * size, b - 2 * size, c + 2 * size, d + 2 * size, source.transform)
    first_col, first_row = max(0, math.floor(wanted.col_off)), max(0, math.floor(wanted.row_off))
    last_col = min(source.width, math.ceil(wanted.col_off + wanted.width))
    last_row = min(source.height, math.ceil(wanted.row_off + wanted.height))
    if last_col - first_col < 2 or last_row - first_row < 2:
        _no_overlap(source, path, bounds)
    check_size(path, (last_row - first_row) * (last_col - first_col))
    t = source.transform
    window = library.windows.Window(first_col, first_row, last_col - first_col, last_row - first_row)
    data = source.read(band, window=window, masked=True).astype(float)
    return np.asarray(data.filled(np.nan)), library.Affine(
        t.a, t.b, t.c + first_col * t.a, t.d, t.e, t.f + first_row * t.e
    )


def _warped(
    library: Any, source: Any, path: Path, target: Any, bounds: tuple[float, ...], band: int
) -> tuple[Array, Any]:
    """Heights interpolated onto cells of the same size along the axes of another system."""
    cell = _cell_m(library, source, path, target, bounds)
    low = np.floor(np.array(bounds[:2]) / cell - 2) * cell
    high = np.ceil(np.array(bounds[2:]) / cell + 2) * cell
    columns, rows = np.rint((high - low) / cell).astype(int).tolist()
    check_size(path, rows * columns)
    transform = library.Affine(cell, 0.0, float(low[0]), 0.0, -cell, float(high[1]))
    heights = np.full((rows, columns), np.nan)
    library.warp.reproject(
        library.band(source, band), heights, dst_transform=transform, dst_crs=target, src_nodata=source.nodata,
        dst_nodata=np.nan, resampling=library.warp.Resampling.bilinear,
    )  # fmt: skip
    if not np.isfinite(heights).any():
        _no_overlap(source, path, bounds)
    return heights, transform


def _cell_m(library: Any, source: Any, path: Path, target: Any, bounds: tuple[float, ...]) -> float:
    """Side of a cell in the target system [m], where the box lies."""
    x, y = (bounds[0] + bounds[2]) / 2, (bounds[1] + bounds[3]) / 2
    u, v = library.warp.transform(target, source.crs, [x], [y])
    t = source.transform
    us = [u[0], u[0] + t.a, u[0] + t.b]
    vs = [v[0], v[0] + t.d, v[0] + t.e]
    xs, ys = library.warp.transform(source.crs, target, us, vs)
    area = (xs[1] - xs[0]) * (ys[2] - ys[0]) - (ys[1] - ys[0]) * (xs[2] - xs[0])
    if not 0 < abs(area) < math.inf:
        _no_overlap(source, path, bounds)
    return abs(area) ** 0.5


def check_size(path: Path, cells: int) -> None:
    """Raise InputError for more cells than are read at once."""
    if cells > MOST_CELLS:
        raise InputError("raster.too_many_cells", n=cells, most=MOST_CELLS, file=path)


def _no_overlap(source: Any, path: Path, bounds: tuple[float, ...]) -> None:
    b = source.bounds
    raise InputError("raster.no_overlap", covered=[b.left, b.bottom, b.right, b.top], wanted=list(bounds), file=path)


def check_heights(heights: Array, path: Path) -> None:
    """Refuse what are no heights of the ground: a mark for holes that is not stated, an image, another unit."""
    good = heights[np.isfinite(heights)]
    if not len(good):
        raise InputError("raster.no_height", file=path)
    low, high = float(good.min()), float(good.max())
    if low < LOWEST or high > HIGHEST:
        odd = low if low < LOWEST else high
        raise InputError("raster.impossible_heights", lowest_m=low, highest_m=high, height_m=odd, file=path)
