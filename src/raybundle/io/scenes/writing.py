"""RPC into files: text that stands beside an image, or the tag of a GeoTIFF, by the ending of the name."""

from __future__ import annotations

import shutil
import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.io.folders import new_files
from raybundle.io.raster_library import raster_library
from raybundle.io.reading.tiff import is_tiff
from raybundle.io.scenes.base import is_scene
from raybundle.io.scenes.rpc_text import write_geom, write_rpb, write_rpc_text
from raybundle.io.scenes.tags import read_tiff
from raybundle.scenes.rpc import Rpc, rasterio_from_rpc

TEXTS: dict[str, Callable[[Rpc, Path], None]] = {".txt": write_rpc_text, ".rpb": write_rpb, ".geom": write_geom}
RASTERS = (".tif", ".tiff")
"""Endings of pictures that take an RPC in their tag 50844."""
NAMES = "NAME_RPC.TXT, NAME.RPB, NAME.geom, or NAME.tif for the picture with its RPC"


def check_rpc_name(path: Path, picture: Path | None = None) -> None:
    """Raise InputError where the name of a file to write states no format of RPC that can be written.

    picture  raster of the scene, which a GeoTIFF is a copy of; None: there is none
    """
    suffix = path.suffix.lower()
    if suffix in RASTERS:
        if picture is None:
            raise InputError(
                "rpc.geotiff_needs_picture",
                file=path,
            )
        raster_library(path)
        stale = [f for f in files_before_the_tag(path) if f.exists() and is_scene(f)]
        if stale:
            raise InputError(
                "rpc.file_precedes_tag",
                name=stale[0].name,
                file=path,
            )
    elif suffix not in TEXTS:
        raise InputError("rpc.name_ending", ending=path.suffix or "blank", file=path)


def write_rpc(rpc: Rpc, path: Path, picture: Path | None = None) -> None:
    """Write the format of the name: NAME_RPC.TXT, NAME.RPB, NAME.geom, or NAME.tif with the pixels of `picture`.

    raises  InputError where the name states another one, where a GeoTIFF is asked for without a picture or without
            rasterio, or the file cannot be written
    """
    check_rpc_name(path, picture)
    if path.suffix.lower() in RASTERS:
        assert picture is not None
        _write_raster(rpc, path, picture)
    else:
        TEXTS[path.suffix.lower()](rpc, path)


def files_before_the_tag(path: Path) -> tuple[Path, ...]:
    """Files beside a GeoTIFF from which GDAL takes an RPC before it looks at the tag."""
    stem = path.with_suffix("")
    beside = [f"{stem.name}{end}" for end in ("_RPC.TXT", "_rpc.txt", ".RPB", ".rpb")]
    return tuple(path.with_name(name) for name in (f"{path.name}.aux.xml", *beside))


def _write_raster(rpc: Rpc, path: Path, picture: Path) -> None:
    """A copy of a picture as GeoTIFF whose tag 50844 holds this RPC; of a TIFF every other byte of the pixels stays."""
    library = raster_library(path)
    with new_files(path) as (file,), warnings.catch_warnings():
        warnings.simplefilter("ignore", library.errors.NotGeoreferencedWarning)
        try:
            if is_tiff(picture):
                shutil.copyfile(picture, file)
            else:
                library.shutil.copy(str(picture), str(file), driver="GTiff", bigtiff="IF_SAFER", tiled=True)
                beside = file.with_name(f"{file.name}.aux.xml")
                beside.unlink(missing_ok=True)
            with library.open(file, "r+") as raster:
                raster.rpcs = rasterio_from_rpc(rpc)
        except library.errors.RasterioError as error:
            raise InputError("picture.not_geotiff", detail=str(error).splitlines()[0][:200], file=picture) from None
        _check_written(rpc, file, path)


def _check_written(rpc: Rpc, file: Path, path: Path) -> None:
    """Raise InputError where the tag does not hold the RPC to the last bit, whoever wrote it."""
    found = read_tiff(file).rpc
    parts = ("coefficients", "ground_offset", "ground_scale", "image_scale")
    if found is None or not all(np.array_equal(getattr(found, p), getattr(rpc, p)) for p in parts):
        raise InputError("rpc.tag_differs", file=path)
