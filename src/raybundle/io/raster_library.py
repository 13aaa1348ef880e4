"""rasterio, which reads and writes rasters (extra `geo`), with the parts of it that are used here."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from typing import Any

from raybundle.errors import InputError

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
        message = "rasters are read and written by rasterio, which is not installed: pip install 'raybundle[geo]'"
        raise InputError(message, file=path)
    return library
