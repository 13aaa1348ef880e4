"""Pictures in a map: GeoTIFF (OGC 19-008r4) by rasterio, the extra `[geo]`, or a file of the system beside others."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Mask

TILE_PX = 256
"""Side of a tile: a multiple of 16, as TIFF wants it, and what viewers ask for at once."""
OVERVIEW_PX = 512
"""Longer side from which on halved copies are kept in the file, the smallest below it."""


def write_geotiff(
    library: Any, path: Path, colours: Array, seen: Mask, *, left: float, top: float, pixel: float, wkt: str,
    tags: Mapping[str, str] | None = None,
) -> None:  # fmt: skip
    """Write colours (h, w, 3) with an alpha band of what was seen (h, w), tiled, deflated, with overviews.

    left, top  outer corner of the upper left pixel in the system
    tags       further ones: ImageDescription, Artist, Copyright
    raises     InputError where the library cannot write the system
    """
    height, width = seen.shape
    bands = {"count": 4, "dtype": "uint8", "photometric": "RGB", "alpha": "YES", "interleave": "pixel"}
    with new_geotiff(
        library, path, bands, width=width, height=height, left=left, top=top, pixel=pixel, wkt=wkt, tags=tags
    ) as write:
        for row in range(0, height, TILE_PX):  # all bands of a tile at once: each is compressed once
            rows = slice(row, min(row + TILE_PX, height))
            write(0, row, np.dstack([colours[rows], seen[rows].astype(np.uint8) * 255]))


Write = Callable[[int, int, Array], None]
"""Column and row of the first pixel of a part, and its values (h, w, bands)."""


@contextmanager
def new_geotiff(
    library: Any, path: Path, bands: Mapping[str, Any], *, width: int, height: int, left: float, top: float,
    pixel: float, wkt: str, tags: Mapping[str, str] | None = None, names: Sequence[str] = (),
) -> Generator[Write]:  # fmt: skip
    """A GeoTIFF that is written part by part, tiled, deflated; overviews follow when the body ends.

    bands   what rasterio gets of them: count, dtype, nodata
    wkt     empty: a plane that is in no map
    names   of the bands
    raises  InputError where the library cannot write the system or the file
    """
    floats = np.dtype(bands["dtype"]).kind == "f"
    profile = {
        "driver": "GTiff", "width": width, "height": height,
        "transform": library.Affine(pixel, 0.0, left, 0.0, -pixel, top), "compress": "deflate",
        "predictor": 3 if floats else 2, "bigtiff": "IF_SAFER", **bands,
    }  # fmt: skip
    if min(width, height) >= TILE_PX:
        profile |= {"tiled": True, "blockxsize": TILE_PX, "blockysize": TILE_PX}
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of the library, about systems without an EPSG code
            system = library.crs.CRS.from_wkt(wkt) if wkt else None
            with library.open(path, "w", crs=system, **profile) as file:
                if names:
                    file.descriptions = tuple(names)

                def write(column: int, row: int, values: Array) -> None:
                    window = library.windows.Window(column, row, values.shape[1], values.shape[0])
                    file.write(np.moveaxis(values, 2, 0), window=window)

                yield write
                file.update_tags(AREA_OR_POINT="Area", TIFFTAG_SOFTWARE="raybundle", **{
                    f"TIFFTAG_{name.upper()}": words for name, words in (tags or {}).items()
                })  # fmt: skip
            if levels := overview_levels(width, height):
                with library.open(path, "r+") as file:
                    file.build_overviews(levels, library.enums.Resampling.average)
    except (library.errors.RasterioError, library.errors.CRSError) as error:
        raise InputError("geotiff.not_written", detail=str(error).splitlines()[0][:200]) from None


TAGS = {"ImageDescription": 270, "Software": 305, "Artist": 315, "Copyright": 33432}
"""Numbers of TIFF (6.0, sections 8) and of EXIF, which has them of TIFF"""


def tags_of(record: Mapping[str, str]) -> dict[str, str]:
    """What is stated of a delivery in the tags that pictures have for it."""
    about = [record[k] for k in ("state", "title", "object", "place", "reference", "date", "client") if record.get(k)]
    tags = {
        "ImageDescription": "; ".join(dict.fromkeys(about)), "Artist": record.get("operator", ""),
        "Copyright": record.get("rights", ""),
    }  # fmt: skip
    return {name: " ".join(words.split()) for name, words in tags.items() if words}


def overview_levels(width: int, height: int) -> list[int]:
    """Factors of reduced copies: halves, until one is no longer than 512 pixels; none of a small picture."""
    levels: list[int] = []
    factor = 1
    while max(width, height) > OVERVIEW_PX * factor:
        factor *= 2
        levels.append(factor)
    return levels


def system_file(path: Path) -> Path:
    """PICTURE.SUFFIX.aux.xml, where GDAL, QGIS and ArcGIS look for the system of a picture with a world file."""
    return path.with_name(f"{path.name}.aux.xml")


def system_text(wkt: str) -> str:
    """Its contents, as GDAL describes them for persistent auxiliary metadata."""
    return '<PAMDataset>\n  <SRS dataAxisToSRSAxisMapping="1,2">' + escape(wkt, quote=False) + "</SRS>\n</PAMDataset>\n"
