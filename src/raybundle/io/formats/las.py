"""LAS and LAZ point clouds by laspy, the extra `[las]`: object points with colour, rays and standard deviations."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from raybundle.errors import InputError
from raybundle.io.formats.base import Draft, Export, Format, register
from raybundle.io.formats.surveyed import Surveyed, surveyed
from raybundle.numerics.arrays import Array

if TYPE_CHECKING:
    from pyproj import CRS

STEP_M = 1e-4
"""LAS holds whole multiples of this."""
STEP_DEG = 1e-9
"""The same of longitude and latitude: 0.1 mm on the ground."""
MOST = 2e9
"""Multiples that fit its whole numbers of 32 bits, counted from the least coordinate."""
SIGMAS = ("sigma_x", "sigma_y", "sigma_z")


def write(export: Export, path: Path) -> Draft:
    """Write LAS 1.4, point format 7; coordinates rounded to 0.1 mm (block in m) or 1e-7 of its extent."""
    try:
        import laspy  # noqa: PLC0415  (an extra)
        from laspy.vlrs.known import WktCoordinateSystemVlr  # noqa: PLC0415
    except ModuleNotFoundError:
        raise InputError("LAS files need laspy; install the extra: pip install 'raybundle[las]'") from None
    view = surveyed(export)
    s = view.scene
    xyz = view.placed(s.xyz)
    remarks = list(s.remarks)
    header: Any = laspy.LasHeader(point_format=7, version="1.4")
    if view.system is not None:
        header.vlrs.append(WktCoordinateSystemVlr(_wkt(view.system)))
        header.global_encoding.wkt = True
        remarks.append(f"coordinates are written in {view.system_name}")
    low = xyz.min(axis=0, initial=0.0) if len(xyz) == 0 else xyz.min(axis=0)
    header.offsets = np.floor(low)
    header.scales = _steps(xyz, header.offsets, degrees=view.degrees)
    for name in SIGMAS:
        header.add_extra_dim(laspy.ExtraBytesParams(name=name, type="float32"))
    cloud: Any = laspy.LasData(header)
    cloud.xyz = xyz
    cloud.red, cloud.green, cloud.blue = (s.colours[:, k].astype(np.uint16) * 257 for k in range(3))
    rays = np.bincount(s.point, minlength=len(xyz))
    cloud.user_data = np.minimum(rays, 255).astype(np.uint8)
    sigma = _sigma_m(export, view) if view.degrees else view.sigma_of(s.points, xyz)
    for k, name in enumerate(SIGMAS):
        cloud[name] = sigma[:, k].astype(np.float32)
    cloud.write(str(path), do_compress=path.suffix.lower() == ".laz")
    return Draft(remarks=tuple(remarks))


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
    """OGC 01-009, as LAS 1.4 wants it; systems that it cannot tell, in its successor ISO 19162."""
    from pyproj.exceptions import CRSError  # noqa: PLC0415

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
        suffix=".las",
        write=write,
        colours=True,
        metric=True,
    )
)
