"""Products that hold no geometry of a scene, by the marks of their files: maps, and scenes with an orbit elsewhere."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

import numpy as np

from raybundle.errors import InputError, Message, message
from raybundle.io.reading.hdf5 import PACKAGE, SIGNATURE
from raybundle.io.reading.tiff import tiff_tags

MARKS: tuple[tuple[bytes, str, str], ...] = (
    (b"LANDSAT_METADATA_FILE", "scene.is_map", "landsat"),
    (b"L1_METADATA_FILE", "scene.is_map", "landsat"),
    (b"Level-1C_", "scene.is_map", "sentinel2"),
    (b"Level-2A_", "scene.is_map", "sentinel2"),
    (b"Level-1B_User_Product", "scene.product_not_read", "sentinel2"),
    (b"SAOCOM_XMLProduct", "scene.product_not_read", "saocom"),
    (b"<MissionID>KMPS", "scene.product_not_read", "kompsat5"),
    (b"CPHD/1.", "scene.product_not_read", "cphd"),
)
"""In the beginning of a file, code of the message, and the product that it names"""
HDF4 = b"\x0e\x03\x13\x01"
CEOS = b"\xc0\x12\x12"
"""Type codes of the first record of a CEOS file, from byte 6; in leaders of radars a data set summary (10) follows"""
ORTHO = (b"RASTER_ORTHO", b">ORTHO<", b">ORT<")
"""In a DIMAP file of an orthoimage"""
SCALE, TIE_POINTS, MATRIX = 33550, 33922, 34264
"""Tags of GeoTIFF: pixel size, tie points of six numbers, affine transformation"""


def product_of(path: Path, head: bytes) -> Message | None:
    """The message about a file by its beginning; None for other files."""
    for mark, code, what in MARKS:
        if mark in head:
            return message(code, what=what)
    if head.startswith(SIGNATURE) and find_spec(PACKAGE) is None:
        return message("package.h5py_missing")
    if head.startswith(HDF4):
        aster = path.name.upper().startswith("AST_L1A") or b"ASTER" in head
        return message("scene.product_not_read", what="aster" if aster else "hdf")
    if head[5:8] == CEOS and head[725:726] != b"\n":
        return message("scene.product_not_read", what="ceos")
    return None


def raster_without_model(path: Path) -> Message | None:
    """The message about a TIFF without RPC: a map, or an image with points on the ground alone."""
    try:
        _, tags = tiff_tags(path, frozenset({SCALE, TIE_POINTS, MATRIX}))
    except InputError:
        return None
    scale, ties, matrix = (np.array(tags.get(tag, ())) for tag in (SCALE, TIE_POINTS, MATRIX))
    scaled = bool(scale[:2].size) and bool(scale[:2].all()) and bool(np.isfinite([*scale[:2], *ties]).all())
    if scaled or (matrix.any() and np.isfinite(matrix).all()):
        return message("scene.is_map", what="raster")
    points = len(ties) // 6 if np.isfinite(ties).all() else 0
    return message("scene.no_orbit", n=points) if points > 1 else None


def orthoimage(head: bytes) -> Message | None:
    """The message about a DIMAP file without a model, if it belongs to an orthoimage."""
    return message("scene.is_map", what="orthoimage") if any(mark in head for mark in ORTHO) else None
