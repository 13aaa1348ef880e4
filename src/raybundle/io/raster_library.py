"""rasterio, which reads and writes rasters (extra `geo`), with the parts of it that are used here."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any

from raybundle.errors import InputError

SHOWN = 200
"""Characters of what the library reports"""
PARTS = ("crs", "enums", "errors", "rpc", "shutil", "vrt", "warp", "windows")


def found_raster_library() -> Any | None:
    """The module; None where it is not installed."""
    try:
        library: Any = import_module("rasterio")  # an extra
        for part in PARTS:
            import_module(f"rasterio.{part}")
    except ImportError:
        return None
    return library


def raster_library(path: Path | None = None) -> Any:
    """The module; raises InputError where it is not installed."""
    library = found_raster_library()
    if library is None:
        raise InputError("package.rasterio_missing", file=path)
    return library


@contextmanager
def raster_errors(path: Path) -> Generator[None]:
    """Turn what rasterio, GDAL and PROJ raise for a raster into an InputError that names it.

    A coordinate system without an inverse, or with a text that is no UTF-8, passes rasterio as an error of GDAL.
    """
    library = raster_library(path)
    of_gdal = tuple({e for e in vars(import_module("rasterio._err")).values() if _is_error(e)})
    projection: Any = import_module("pyproj.exceptions")
    try:
        yield
    except InputError:
        raise
    except (library.errors.RasterioError, projection.ProjError, UnicodeError, *of_gdal) as error:
        why = (str(error).splitlines() or [type(error).__name__])[0][:SHOWN]
        raise InputError("raster.not_readable", detail=why, file=path) from None


def _is_error(value: object) -> bool:
    return isinstance(value, type) and issubclass(value, Exception) and value.__module__ == "rasterio._err"
