"""RPC within images: the tag 50844 of GeoTIFF and the extensions RPC00A and RPC00B of NITF; read without GDAL.

Both count from the centre of the first pixel (0, 0).  Only headers are read, never pixels.
"""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np

from raybundle.errors import InputError, message, note
from raybundle.io.reading.tiff import tiff_tags
from raybundle.io.reading.words import no_number, number_of, numbers_of, quoted, whole_of
from raybundle.io.scenes.base import Scene, SceneFormat, check_denominators, register
from raybundle.io.scenes.maxar import RPC00A_IN_B
from raybundle.io.scenes.products import raster_without_model
from raybundle.numerics.arrays import Array
from raybundle.scenes.rpc import Rpc, rpc_of

RPC_TAG, WIDTH_TAG, HEIGHT_TAG = 50844, 256, 257
SUBHEADER_BYTES = 1 << 20
NITF_FIELDS = (7, 7, 6, 5, 8, 9, 5, 6, 5, 8, 9, 5)
"""Characters of ERR_BIAS, ERR_RAND, the five offsets and the five scales, after the digit SUCCESS."""
NITF_LENGTH = 1 + sum(NITF_FIELDS) + 80 * 12


def read_tiff(path: Path) -> Scene:
    """The RPC in the tag of a GeoTIFF or BigTIFF, first image of the file."""
    _, tags = tiff_tags(path, frozenset({RPC_TAG, WIDTH_TAG, HEIGHT_TAG}))
    if RPC_TAG not in tags:
        raise InputError(raster_without_model(path) or message("rpc.no_tag"), file=path)
    values = np.array(tags[RPC_TAG], float)
    if len(values) != 92:
        raise InputError("rpc.tag_count", n=len(values), file=path)
    rpc = _rpc(values[:12], values[12:].reshape(4, 20), path)
    width, height = (int(tags[t][0]) if t in tags else None for t in (WIDTH_TAG, HEIGHT_TAG))
    return Scene(file=path, format="geotiff", rpc=rpc, width_px=width, height_px=height)


def _rpc(scalars: Array, coefficients: Array, path: Path) -> Rpc:
    """From ERR_BIAS, ERR_RAND, then line, sample, latitude, longitude, height: offsets, and scales."""
    if not np.isfinite(scalars).all():
        raise InputError("rpc.not_finite", file=path)
    _, _, line, sample, lat, lon, height, line_s, sample_s, lat_s, lon_s, height_s = scalars
    bias, rand = (float(v) if v > 0 else None for v in scalars[:2])
    rpc = rpc_of(
        coefficients=coefficients,
        ground_offset=np.array([lon, lat, height]),
        ground_scale=np.array([lon_s, lat_s, height_s]),
        image_offset=np.array([sample, line]) + 0.5,
        image_scale=np.array([sample_s, line_s]),
        err_bias_m=bias,
        err_rand_m=rand,
    )
    check_denominators(rpc, path)
    return rpc


def read_nitf(path: Path) -> Scene:
    """The RPC in the first image subheader of a NITF 2.1 file (MIL-STD-2500C)."""
    with path.open("rb") as file:
        head = file.read(380)
        length, images = _digits(path, head, 354, 6, "HL"), _digits(path, head, 360, 3, "NUMI")
        if images == 0:
            raise InputError("nitf.no_image", file=path)
        size = _digits(path, head, 363, 6, "LISH001")
        file.seek(length)
        subheader = file.read(min(size, SUBHEADER_BYTES))
    for name in ("RPC00B", "RPC00A"):
        at = subheader.find(f"{name}{NITF_LENGTH:05d}".encode())
        if at >= 0:
            return _nitf_scene(path, name, subheader, subheader[at + 11 : at + 11 + NITF_LENGTH])
    raise InputError(
        "nitf.no_rpc",
        file=path,
    )


def _nitf_scene(path: Path, name: str, subheader: bytes, data: bytes) -> Scene:
    text = data.decode("latin-1")
    if len(text) < NITF_LENGTH or text[0] != "1":
        raise InputError("nitf.rpc_invalid", name=name, success=quoted(text[:1]), file=path)
    ends = np.cumsum((1, *NITF_FIELDS, *([12] * 80)))
    words = [text[a:b] for a, b in pairwise(ends.tolist())]
    values = numbers_of(w.strip() for w in words)
    if values is None:
        bad = next(w for w in words if number_of(w.strip()) is None)
        raise InputError(no_number(bad), file=path, column=name)
    coefficients, remarks = values[12:].reshape(4, 20), ()
    if name == "RPC00A":
        ordered = np.zeros((4, 20))
        ordered[:, list(RPC00A_IN_B)] = coefficients
        coefficients, remarks = ordered, (note("rpc.terms_reordered"),)
    rows, columns = (_digits(path, subheader, at, 8, key) for at, key in ((333, "NROWS"), (341, "NCOLS")))
    return Scene(
        file=path,
        format="nitf",
        rpc=_rpc(values[:12], coefficients, path),
        width_px=columns,
        height_px=rows,
        remarks=remarks,
    )


def _digits(path: Path, data: bytes, at: int, count: int, key: str) -> int:
    word = data[at : at + count]
    value = whole_of(word.decode("latin-1")) if len(word) == count else None
    if value is None or value < 0:
        raise InputError("nitf.field", name=key, value=quoted(word.decode("latin-1")), n=count, file=path)
    return value


def _is_tiff(path: Path, head: bytes) -> bool:
    del path
    return head[:4] in {b"II*\0", b"MM\0*", b"II+\0", b"MM\0+"}


def _is_nitf(path: Path, head: bytes) -> bool:
    del path
    return head.startswith((b"NITF02.10", b"NSIF01.00"))


register(SceneFormat(name="geotiff", title="GeoTIFF with RPC (tag 50844)", recognises=_is_tiff, read=read_tiff))
register(SceneFormat(name="nitf", title="NITF 2.1 with RPC00B", recognises=_is_nitf, read=read_nitf))
