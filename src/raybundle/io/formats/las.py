"""LAS and LAZ point clouds by laspy, the extra `[las]`: object points with colour, rays and standard deviations."""

from __future__ import annotations

import struct
import warnings
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.formats.base import Draft, Export, Format, register
from raybundle.io.formats.surveyed import Surveyed, surveyed
from raybundle.io.reading.files import check_regular
from raybundle.io.reading.words import quoted
from raybundle.numerics.arrays import Array, Index

if TYPE_CHECKING:
    from pyproj import CRS

STEP_M = 1e-4
"""LAS holds whole multiples of this."""
STEP_DEG = 1e-9
"""The same of longitude and latitude: 0.1 mm on the ground."""
HEAD_BYTES, RECORD_BYTES = 375, (54, 60)
"""Of the header, and of the heads of its variable length records and the extended ones"""
AT_ONCE = 1_000_000
"""Points that are read together"""
MOST = 2e9
"""Multiples that fit its whole numbers of 32 bits, counted from the least coordinate."""
SIGMAS = ("sigma_x", "sigma_y", "sigma_z")


def las_library() -> Any:
    """The module; raises InputError where it is not installed."""
    try:
        import laspy
    except ModuleNotFoundError:
        raise InputError("package.laspy_missing") from None
    return laspy


def writes_laz() -> bool:
    """Whether a library that compresses is there."""
    return bool(las_library().LazBackend.detect_available())


@dataclass(frozen=True, slots=True, kw_only=True)
class LasPoints:
    """Points of a LAS file; arrays (n, ...)."""

    xyz: Array
    """(n, 3) in the system of the file"""
    colours: Array
    """(n, 3) uint8"""
    rays: Index
    """photographs that see it"""
    extra: Mapping[str, Array]
    """further dimensions by name, each of its own type"""


def write_las(
    path: Path, parts: Iterable[LasPoints], *, offsets: Array, steps: Array, system: CRS | None = None
) -> None:
    """Write LAS 1.4, point format 7, compressed under a name in .laz, of points that come part by part.

    offsets, steps  (3,) coordinates are whole multiples of steps from offsets on
    system          None: none of the earth
    All parts have the same further dimensions, those of the first.
    """
    laspy = las_library()
    from laspy.vlrs.known import WktCoordinateSystemVlr

    header: Any = laspy.LasHeader(point_format=7, version="1.4")
    if system is not None:
        header.vlrs.append(WktCoordinateSystemVlr(_wkt(system)))
        header.global_encoding.wkt = True
    header.offsets, header.scales = offsets, steps
    writer: Any = None
    try:
        for part in parts:
            if writer is None:
                for name, values in part.extra.items():
                    header.add_extra_dim(laspy.ExtraBytesParams(name=name, type=values.dtype.name))
                compress = path.suffix.lower() == ".laz"
                writer = laspy.open(str(path), mode="w", header=header, do_compress=compress)
            if not len(part.xyz):
                continue
            record: Any = laspy.ScaleAwarePointRecord.zeros(len(part.xyz), header=header)
            record.x, record.y, record.z = part.xyz.T
            record.red, record.green, record.blue = (part.colours[:, k].astype(np.uint16) * 257 for k in range(3))
            record.user_data = np.minimum(part.rays, 255).astype(np.uint8)
            for name, values in part.extra.items():
                record[name] = values
            writer.write_points(record)
        if writer is None:
            writer = laspy.open(str(path), mode="w", header=header, do_compress=path.suffix.lower() == ".laz")
    finally:
        if writer is not None:
            writer.close()


def read_las(path: Path) -> Iterator[tuple[Array, str]]:
    """Coordinates (n, 3) of the points of a LAS or LAZ file, some at a time, and its system; empty: it states none.

    raises  InputError for a file that is damaged or none of this kind
    """
    laspy = las_library()
    check_regular(path)
    _check_header(path)
    left, total = 0, 0
    try:
        with laspy.open(str(path)) as file:
            found, left = file.header.parse_crs(), int(file.header.point_count)
            total = left
            for points in file.chunk_iterator(AT_ONCE):
                xyz = np.column_stack([points.x, points.y, points.z]).astype(float)
                left -= len(xyz)
                yield xyz[np.isfinite(xyz).all(axis=1)], "" if found is None else str(found.to_wkt())
    except Exception as error:  # noqa: BLE001  (laspy and its decoders raise what they like on damaged files)
        raise InputError("file.not_readable", detail=quoted(str(error)), file=path) from None
    if left:
        raise InputError("old_heights.cloud_cut_off", missing=left, total=total, file=path)


def _check_header(path: Path) -> None:
    """Refuse more variable records than the file has room for: laspy reads on behind its end for each."""
    size = path.stat().st_size
    with path.open("rb") as file:
        head = file.read(HEAD_BYTES).ljust(HEAD_BYTES, b"\0")
    header, points, records = struct.unpack_from("<HII", head, 94)
    begin, extended = struct.unpack_from("<QI", head, 235) if head[24:26] >= b"\x01\x04" else (size, 0)
    room = min(points, size) - header, size - min(begin, size)
    for n, least, free in zip((records, extended), RECORD_BYTES, room, strict=True):
        if n * least > max(free, 0):
            raise InputError("value.count", n=max(free, 0) // least, needed=n, file=path, column="VLR")


def write(export: Export, path: Path) -> Draft:
    """Write LAS 1.4, point format 7; coordinates rounded to 0.1 mm (block in m) or 1e-7 of its extent."""
    las_library()
    view = surveyed(export)
    s = view.scene
    xyz = view.placed(s.xyz)
    remarks = list(s.remarks)
    if view.system is not None:
        remarks.append(phrase("conversion.system", system=view.system_name))
    offsets = np.floor(xyz.min(axis=0) if len(xyz) else np.zeros(3))
    sigma = _sigma_m(export, view) if view.degrees else view.sigma_of(s.points, xyz)
    points = LasPoints(
        xyz=xyz, colours=s.colours, rays=np.bincount(s.point, minlength=len(xyz)),
        extra={name: sigma[:, k].astype(np.float32) for k, name in enumerate(SIGMAS)},
    )  # fmt: skip
    steps = _steps(xyz, offsets, degrees=view.degrees)
    write_las(path, [points], offsets=offsets, steps=steps, system=view.system)
    return Draft(remarks=tuple(remarks))


def steps_for(low: Array, high: Array, sigma: float, *, degrees: bool) -> tuple[Array, Array]:
    """Offsets (3,) and steps (3,) of coordinates between low and high (3,), which add nothing to a standard deviation.

    sigma  the least one that counts, in the unit of the heights: a step is a power of ten and a tenth of it at most
    """
    offsets = np.floor(low)
    step = 10.0 ** np.floor(np.log10(sigma / 10)) if sigma > 0 and np.isfinite(sigma) else STEP_M
    least = (high - offsets) / MOST
    wanted = [STEP_DEG, STEP_DEG, step] if degrees else [step] * 3
    return offsets, np.maximum(wanted, 10.0 ** np.ceil(np.log10(np.maximum(least, 1e-12))))


def _steps(xyz: Array, offsets: Array, *, degrees: bool) -> Array:
    """(3,) of what the coordinates are multiples; longitude and latitude have steps of their own."""
    if not len(xyz):
        return np.full(3, STEP_M)
    least = (xyz.max(axis=0) - offsets) / MOST
    if not degrees:
        largest = float(np.ptp(xyz, axis=0).max())
        return np.full(3, max(min(STEP_M, largest * 1e-7) or STEP_M, float(least.max())))
    return np.maximum([STEP_DEG, STEP_DEG, STEP_M], least)


def _wkt(system: CRS) -> str:
    """OGC 01-009, as LAS 1.4 wants it; systems that it cannot show, in its successor ISO 19162."""
    from pyproj.exceptions import CRSError

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            text = system.to_wkt("WKT1_GDAL")
    except CRSError:
        text = ""
    return text or system.to_wkt()


def _sigma_m(export: Export, view: Surveyed) -> Array:
    """(p, 3) east, north, up [m], where the coordinates are in degrees."""
    rows = view.scene.points
    return np.full((len(rows), 3), np.nan) if export.sigma is None else export.sigma[rows] * view.metres


register(
    Format(
        name="las",
        title="LAS or LAZ points with colour, rays and sigma (extra [las])",
        kind="file",
        observations=False,
        suffix=".las",
        write=write,
        colours=True,
        metric=True,
    )
)
