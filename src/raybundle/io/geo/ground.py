"""Heights of the ground above the ellipsoid, at places of a raster that is read window by window (extra `geo`).

The raster keeps its own grid and its own coordinate system: nothing is brought over before it is interpolated.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from raybundle.errors import InputError, Text, code_of, named
from raybundle.io.geo.coordinate_systems import height_remarks, local_frame, parse_crs
from raybundle.io.geo.rasters import (
    METRES_IN,
    Unit,
    check_heights,
    check_size,
    metres_of_heights,
    no_system,
    scale_and_offset,
)
from raybundle.io.pictures.resampling import sampled
from raybundle.io.raster_library import raster_errors, raster_library
from raybundle.io.reading.files import check_regular
from raybundle.numerics.arrays import Array

if TYPE_CHECKING:
    from pyproj import CRS

ROW = 4096
"""Places that are interpolated side by side."""
Window = Callable[[int, int, int, int], Array]
"""Heights (h, w) as they are of columns x0 to x1 and rows y0 to y1; NaN where there are none."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Ground:
    """A raster of heights on the earth."""

    file: Path
    plan: str
    """its plane or geographic system (WKT)"""
    heights: str
    """the same with its heights, where these count from a geoid"""
    undulation_m: float | None
    """stated height of the geoid above the ellipsoid"""
    metres: float
    """in a unit of the heights"""
    shape: tuple[int, int]
    """rows, columns"""
    transform: tuple[float, float, float, float, float, float]
    """a, b, c, d, e, f of x = a column + b row + c, y = d column + e row + f, from the outer corner"""
    window: Window = field(repr=False)
    remarks: tuple[str, ...] = ()
    """what was assumed"""

    def places(self, geographic: Array) -> Array:
        """Rows and columns (n, 2), from the centre of the first cell, of longitudes and latitudes (n, 3) in WGS 84."""
        frame = local_frame(self.plan, self._middle())
        return self.cells(frame.crs_from_local(frame.local_from_wgs84(geographic))[:, :2])

    def cells(self, xy: Array) -> Array:
        """Rows and columns (n, 2), from the centre of the first cell, of x, y (n, 2) in the raster's system."""
        a, b, c, d, e, f = self.transform
        columns = (xy - [c, f]) @ np.linalg.inv(np.array([[a, b], [d, e]])).T
        return columns[:, ::-1] - 0.5

    def xy(self, cells: Array) -> Array:
        """x, y (n, 2) of rows and columns (n, 2), the inverse of `cells`."""
        a, b, c, d, e, f = self.transform
        return (cells[:, ::-1] + 0.5) @ np.array([[a, b], [d, e]]).T + [c, f]

    def separation(self, cells: Array) -> Array:
        """(n,) what heights of the raster lack of those above the ellipsoid of WGS 84 [m], at cells (n, 2).

        raises  InputError where heights count from a geoid whose grid is not installed
        """
        xyz = np.column_stack([self.xy(cells), np.zeros(len(cells))])
        try:
            frame = local_frame(self.heights, xyz.mean(axis=0), undulation_m=self.undulation_m)
            return frame.wgs84_from_local(frame.local_from_crs(xyz))[:, 2]
        except InputError as error:
            raise error.at(self.file) from None

    def at(self, cells: Array) -> Array:
        """Heights (...) as the raster counts them, in metres, bilinear between the centres of cells (..., 2).

        NaN in holes and beyond the raster; within half a cell of its border the outer cells go on.
        raises  InputError for what are no heights of the ground
        """
        shape = cells.shape[:-1]
        flat = cells.reshape(-1, 2)
        row, column = flat[:, 0], flat[:, 1]
        near = (row >= -0.5) & (row <= self.shape[0] - 0.5) & (column >= -0.5) & (column <= self.shape[1] - 0.5)
        if not near.any():
            return np.full(shape, np.nan)
        low = np.maximum(np.floor(flat[near].min(axis=0)).astype(int) - 1, 0)
        high = np.minimum(np.ceil(flat[near].max(axis=0)).astype(int) + 3, self.shape)
        check_size(self.file, int(np.prod(high - low)))
        values = self.window(int(low[1]), int(low[0]), int(high[1]), int(high[0])) * self.metres
        known = np.isfinite(values)
        if not known.any():
            return np.full(shape, np.nan)
        check_heights(values, self.file)
        wide = min(len(flat), ROW)
        xy = np.full((-(-len(flat) // wide) * wide, 2), np.nan)
        xy[: len(flat), 0], xy[: len(flat), 1] = column - low[1] + 0.5, row - low[0] + 0.5
        xy[: len(flat)][~near] = np.nan
        found, seen = sampled(values, xy.reshape(-1, wide, 2), "bilinear", known)
        return np.where(seen, found, np.nan).ravel()[: len(flat)].reshape(shape)

    def _middle(self) -> tuple[float, float, float]:
        x, y = self.xy(np.array([self.shape], float) / 2)[0].tolist()
        return x, y, 0.0


@contextmanager
def opened_ground(
    given: Any, *, geoid: str | None = None, undulation: float | None = None, unit: Unit = ""
) -> Generator[Ground]:
    """A raster of heights: a file, an opened dataset of rasterio, or a DataArray of rioxarray.

    geoid       vertical system of heights that the raster does not name, as EPSG:5773
    undulation  height of the geoid above the ellipsoid [m], in place of a grid
    raises      InputError for no raster, no coordinate system, or what contradicts that of the raster
    """
    if isinstance(given, str | Path):
        path = Path(given)
        check_regular(path)
        library = raster_library(path)
        with raster_errors(path):
            source = library.open(path)
        with source:
            yield _of_dataset(library, source, path, geoid, undulation, unit)
    elif hasattr(given, "rio"):
        yield _of_array(given, geoid, undulation, unit)
    else:
        path = Path(str(given.name))
        yield _of_dataset(raster_library(path), given, path, geoid, undulation, unit)


def _of_dataset(
    library: Any, source: Any, path: Path, geoid: str | None, undulation: float | None, unit: Unit
) -> Ground:
    def window(x0: int, y0: int, x1: int, y1: int) -> Array:
        try:
            data = source.read(1, window=library.windows.Window(x0, y0, x1 - x0, y1 - y0), masked=True)
        except library.errors.RasterioError as error:
            raise InputError("file.not_readable", detail=str(error).splitlines()[0][:200], file=path) from None
        return np.asarray((data.astype(float) * scale + offset).filled(np.nan))

    scale, offset = scale_and_offset(source, 1)
    if source.crs is None:
        no_system(path)
    own = parse_crs(source.crs.to_wkt())
    feet = own.is_projected and not own.is_compound and abs(own.axis_info[0].unit_conversion_factor - 1) > 1e-9
    if feet and not unit and not source.units[0]:
        raise InputError("raster.height_unit_missing", unit=own.axis_info[0].unit_name, file=path)
    metres, remarks = metres_of_heights(source, own, path, unit, 1)
    return _ground(path, own, tuple(source.transform)[:6], (source.height, source.width), window, metres, remarks,
                   geoid, undulation)  # fmt: skip


def _of_array(array: Any, geoid: str | None, undulation: float | None, unit: Unit) -> Ground:
    path = Path(str(array.encoding.get("source") or "heights"))
    values = array if len(array.shape) == 2 else array[0]
    nothing = array.rio.nodata

    def window(x0: int, y0: int, x1: int, y1: int) -> Array:
        part = np.asarray(values[y0:y1, x0:x1], float)
        return part if nothing is None else np.where(part == nothing, np.nan, part)

    if array.rio.crs is None:
        no_system(path)
    own = parse_crs(array.rio.crs.to_wkt())
    factor = own.sub_crs_list[-1].axis_info[0].unit_conversion_factor if own.is_compound else 1.0
    metres = METRES_IN[unit] if unit else float(factor)
    return _ground(path, own, tuple(array.rio.transform())[:6], (values.shape[0], values.shape[1]), window, metres, [],
                   geoid, undulation)  # fmt: skip


def _ground(
    path: Path, own: CRS, transform: tuple[float, ...], shape: tuple[int, int], window: Window, metres: float,
    remarks: list[str], geoid: str | None, undulation: float | None,
) -> Ground:  # fmt: skip
    if min(shape) < 2:
        raise InputError("height_grid.too_small", rows=shape[0], columns=shape[1], file=path)
    a, b, c, d, e, f = transform
    plan = own.sub_crs_list[0] if own.is_compound else own.to_2d() if len(own.axis_info) == 3 else own
    assert plan is not None
    heights = _with_heights(path, own, plan, geoid, undulation)
    reported = (
        height_remarks(heights, undulation) if undulation is not None or not parse_crs(heights).is_compound else ()
    )
    if len(own.axis_info) == 3 and not own.is_compound:
        reported = ()  # it states that they are ellipsoidal
    if reported or geoid is not None:  # each states it
        remarks = [r for r in remarks if code_of(r) != "raster.unit_assumed"]
    ground = Ground(
        file=path, plan=plan.to_wkt(), heights=heights, undulation_m=undulation, metres=metres, shape=shape,
        transform=(a, b, c, d, e, f), window=window,
        remarks=(*remarks, *(Text.of(named(path.name, r)) for r in reported)),
    )  # fmt: skip
    ground.separation(np.array([shape], float) / 2)  # a geoid that is not there is reported before anything is done
    return ground


def _with_heights(path: Path, own: CRS, plan: CRS, geoid: str | None, undulation: float | None) -> str:
    """WKT of the system with its heights."""
    from pyproj.crs import CompoundCRS, VerticalCRS
    from pyproj.exceptions import CRSError

    if geoid is None:
        if len(own.axis_info) == 3 and not own.is_compound and undulation is not None:
            raise InputError("raster.ellipsoidal_heights", system=own.name, file=path)
        return own.to_wkt() if own.is_compound else plan.to_wkt()
    if undulation is not None:
        raise InputError("raster.geoid_and_undulation")
    try:
        vertical = VerticalCRS.from_user_input(geoid)
    except CRSError:
        raise InputError("raster.geoid_unknown", geoid=geoid[:60]) from None
    if own.is_compound and not own.sub_crs_list[-1].equals(vertical):
        raise InputError("raster.geoid_differs", own=own.sub_crs_list[-1].name, geoid=vertical.name, file=path)
    return CompoundCRS(f"{plan.name} + {vertical.name}", [plan, vertical]).to_wkt()
