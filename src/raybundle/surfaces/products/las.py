"""Product: the cloud as LAZ or LAS in the system of the result, with standard deviations as further dimensions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.errors import phrase
from raybundle.io.folders import new_files
from raybundle.io.formats.las import LasPoints, las_library, steps_for, write_las, writes_laz
from raybundle.io.formats.surveyed import Surveyed, surveyed
from raybundle.numerics.arrays import Array
from raybundle.surfaces.product import Context, Points, Product, Written, register
from raybundle.surfaces.run import Surface
from raybundle.surfaces.state import Cloud

LAZ, LAS = "points.laz", "points.las"
LEAST = 0.01
"""Share of the points whose standard deviations may be smaller than what coordinates are rounded for."""


@dataclass(frozen=True, slots=True, kw_only=True)
class _System:
    """Where points go, and what their errors become."""

    view: Surveyed

    def jacobian(self, xyz: Array) -> Array:
        """(3, 3) of the lengths east, north, up of the system by the block's axes, around a point (3,)."""
        if self.view.frame is None or self.view.degrees:
            return np.eye(3) * self.view.metres if self.view.frame is not None else np.eye(3)
        at = self.view.placed(xyz[None])
        return np.linalg.inv(self.view.frame.jacobian(at)[0]) * self.view.metres

    def points(self, cloud: Cloud) -> LasPoints:
        """As they are written."""
        J = self.jacobian(cloud.xyz.mean(axis=0)) if len(cloud) else np.eye(3)
        scale = abs(float(np.linalg.det(J))) ** (1 / 3)
        sigma = np.sqrt(cloud.sigma.astype(float) ** 2 @ (J**2).T)
        normal = cloud.normal @ np.linalg.inv(J)
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
        extra = {f"sigma_{a}": sigma[:, k].astype(np.float32) for k, a in enumerate("xyz")}
        extra |= {f"Normal{a}": normal[:, k].astype(np.float32) for k, a in enumerate("XYZ")}
        extra |= {
            f"sigma_{a}": (scale * cloud.parts[:, k]).astype(np.float32)
            for k, a in enumerate(("noise", "roughness", "orientation"))
        }
        extra |= {
            "rays": cloud.views, "maps": cloud.confirmed, "incidence": cloud.incidence.astype(np.float32),
            "image": cloud.image.astype(np.int32),
        }  # fmt: skip
        xyz = self.view.placed(cloud.xyz) if len(cloud) else np.zeros((0, 3))
        return LasPoints(xyz=xyz, colours=cloud.colour, rays=cloud.views, extra=extra)


def _write(surface: Surface, out: Path, context: Context) -> Written:
    del surface
    system = _System(view=surveyed(context.export))
    laz = writes_laz()
    path, other = (out / LAZ, out / LAS) if laz else (out / LAS, out / LAZ)
    offsets, steps = _steps(system, context.points)

    def parts() -> Iterator[LasPoints]:
        for cloud in context.points.parts():
            yield system.points(cloud)

    with new_files(path) as (file,):
        write_las(file, parts(), offsets=offsets, steps=steps, system=system.view.system)
    other.unlink(missing_ok=True)
    name = system.view.system_name
    reported = [phrase("product.las", n=len(context.points), system=name or "none", step=float(steps[2]))]
    if not context.unit:
        reported.append(phrase("product.las_without_unit"))
    if not laz:
        reported.append(phrase("product.lazrs_missing"))
    return Written(files=(path,), reported=tuple(reported))


def _steps(system: _System, points: Points) -> tuple[Array, Array]:
    """Offsets and steps for all points."""
    low, high, sigma = np.full(3, np.inf), np.full(3, -np.inf), list[Array]()
    for cloud in points.parts():
        if len(cloud):
            xyz = system.view.placed(cloud.xyz)
            low, high = np.minimum(low, xyz.min(axis=0)), np.maximum(high, xyz.max(axis=0))
            scale = abs(float(np.linalg.det(system.jacobian(cloud.xyz[0])))) ** (1 / 3)
            # what orientation does, all points share: it does not say how finely they are distinguished
            sigma.append(scale * np.hypot(cloud.parts[::7, 0], cloud.parts[::7, 1]))
    if not sigma:
        return np.zeros(3), np.full(3, 1e-4)
    least = float(np.quantile(np.concatenate(sigma), LEAST))
    return steps_for(low, high, least, degrees=system.view.degrees)


def _check() -> None:
    las_library()


PRODUCT = register(Product(name="las", files=(LAZ, LAS), write=_write, of_cloud=True, check=_check))
