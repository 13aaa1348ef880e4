"""LAS and LAZ point clouds by laspy, the extra `[las]`: object points with colour, rays and standard deviations."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.io.formats.base import Draft, Export, Format, register, scene

STEP_M = 1e-4
"""LAS holds whole multiples of this."""
SIGMAS = ("sigma_x", "sigma_y", "sigma_z")


def write(export: Export, path: Path) -> Draft:
    """Write LAS 1.4, point format 7; coordinates rounded to 0.1 mm (block in m) or 1e-7 of its extent."""
    try:
        import laspy  # noqa: PLC0415  (an extra)
    except ModuleNotFoundError:
        raise InputError("LAS files need laspy; install the extra: pip install 'raybundle[las]'") from None
    s = scene(export)
    xyz = s.xyz
    metres = 0.001 if export.block.length_unit == "mm" else 1.0
    remarks = list(s.remarks)
    header: Any = laspy.LasHeader(point_format=7, version="1.4")
    if export.frame is not None:
        from raybundle.io.geo.coordinate_systems import parse_crs  # noqa: PLC0415

        xyz = export.frame.crs_from_local(xyz * metres)
        header.add_crs(parse_crs(export.frame.crs))
        remarks.append(f"coordinates are written in {export.frame.crs[:60]}")
    low = xyz.min(axis=0, initial=0.0) if len(xyz) == 0 else xyz.min(axis=0)
    extent = float(np.ptp(xyz, axis=0).max()) if len(xyz) else 0.0
    header.offsets = np.floor(low)
    header.scales = np.full(3, max(min(STEP_M, extent * 1e-7) or STEP_M, extent / 2e9))
    for name in SIGMAS:
        header.add_extra_dim(laspy.ExtraBytesParams(name=name, type="float32"))
    cloud: Any = laspy.LasData(header)
    cloud.xyz = xyz
    cloud.red, cloud.green, cloud.blue = (s.colours[:, k].astype(np.uint16) * 257 for k in range(3))
    rays = np.bincount(s.point, minlength=len(xyz))
    cloud.user_data = np.minimum(rays, 255).astype(np.uint8)
    sigma = np.full((len(xyz), 3), np.nan) if export.sigma is None else export.sigma[s.points]
    for k, name in enumerate(SIGMAS):
        cloud[name] = sigma[:, k].astype(np.float32)
    cloud.write(str(path), do_compress=path.suffix.lower() == ".laz")
    return Draft(remarks=tuple(remarks))


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
