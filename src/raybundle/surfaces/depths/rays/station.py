"""Rays of a photograph: depths are counted from its projection centre."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from raybundle.block import Camera
from raybundle.numerics.arrays import Array
from raybundle.orientation.rays import camera_rays
from raybundle.platforms.carried import Carried
from raybundle.surfaces.depths.rays.reference import BEYOND, ReferenceRays

WIDEST = np.cos(np.radians(80.0))
"""Beyond this angle off the axis the depth along the axis states little of the distance."""
LEAST_RANGE = 0.05
"""What a range of depths is taken for at least, as a share of the largest parameter."""
AXIS, DISTANCE = "along the optical axis, from the projection centre", "distance from the projection centre"


@dataclass(frozen=True, slots=True, kw_only=True)
class StationRays(ReferenceRays):
    """Object points along the rays of a photograph: X = origin + direction / t.

    t is the inverse depth along the axis [1 / length] where all rays are within 80 degrees of it: a plane is then
    linear in the pixels of a picture without distortion.  Else it is the inverse distance.
    """

    rotation: Array
    """(3, 3) object axes to image axes"""
    centre: Array
    """(3,)"""
    axis: Array | None
    """(3,) in the image frame; None: t is the inverse distance"""

    @classmethod
    def takes(cls, camera: Camera) -> bool:
        """All but scenes."""
        return not camera.is_scene

    @classmethod
    def made(cls, camera: Camera, rotation: Array, centre: Array) -> StationRays:
        """As `ReferenceRays`."""
        free = cls(camera=camera, rotation=rotation, centre=centre, axis=None)
        size = np.array([camera.width_px, camera.height_px])
        side = np.linspace(0, 1, 17)
        everywhere = np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2) * size
        d = free.in_sensor(everywhere)[1]
        axis = free.in_sensor(size[None] / 2.0)[1][0] if isinstance(camera.sensor, Carried) else np.array([0, 0, -1.0])
        return free if (d @ axis).min() < WIDEST else replace(free, axis=axis)

    def moved(self, camera: Camera, rotation: Array, centre: Array) -> StationRays:
        """As `ReferenceRays`."""
        return replace(self, camera=camera, rotation=rotation, centre=centre)

    def in_sensor(self, xy_px: Array) -> tuple[Array, Array]:
        """Origins and directions (n, 3) in the image frame of points (n, 2) [px]."""
        model, values = self.camera.sensor, self.camera.parameters
        if isinstance(model, Carried):
            image = self.camera.image_from_pixel(xy_px).T
            origin = model.point_on_ray(image, values, 0.0)
            d = (model.point_on_ray(image, values, 1.0) - origin).T
        else:
            d = camera_rays(self.camera, xy_px)
            origin = np.zeros((3, len(d)))
        return origin.T, d if self.axis is None else d / (d @ self.axis)[:, None]

    def rays(self, xy_px: Array) -> tuple[Array, Array]:
        """As `ReferenceRays`."""
        origin, direction = self.in_sensor(xy_px)
        return self.centre + origin @ self.rotation, direction @ self.rotation

    def points(self, xy_px: Array, t: Array) -> Array:
        """As `ReferenceRays`."""
        origin, direction = self.rays(xy_px)
        return origin + direction / t[:, None]

    def along(self, t: Array) -> tuple[Array, Array]:
        """As `ReferenceRays`."""
        return 1 / t, -1 / np.square(t)

    def steps(self, xy_px: Array, t: Array, more: Array) -> tuple[Array, Array]:
        """As `ReferenceRays`."""
        origin, direction = self.rays(xy_px)
        xyz = origin + direction / t[:, None]
        return xyz, origin + direction / (t + more)[:, None] - xyz

    def levels(self, xy_px: Array, t: Array) -> Iterator[Array]:
        """As `ReferenceRays`."""
        origin, direction = self.rays(xy_px)
        for one in t:
            yield origin + direction / one

    def by_t(self, xy_px: Array, t: Array) -> Array:
        """As `ReferenceRays`."""
        return -self.rays(xy_px)[1] / t[:, None] ** 2

    def parameter(self, xy_px: Array, xyz: Array) -> Array:
        """As `ReferenceRays`."""
        if not isinstance(self.camera.sensor, Carried):
            # all rays begin in the projection centre: which of them it is does not matter
            away = xyz - self.centre
            return 1 / (np.linalg.norm(away, axis=1) if self.axis is None else away @ (self.axis @ self.rotation))
        origin, direction = self.rays(xy_px)
        return (direction**2).sum(axis=1) / ((xyz - origin) * direction).sum(axis=1)

    def directions(self, xy_px: Array) -> Array:
        """As `ReferenceRays`."""
        return self.rays(xy_px)[1]

    def viewer(self, coordinates: Callable[[Array], Array]) -> Array:
        """As `ReferenceRays`: the projection centre."""
        return coordinates(self.centre[None])[0]

    def lengths(self, t: Array, sigma: Array) -> Array:
        """As `ReferenceRays`: along the axis, or the distance."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return sigma / np.square(t)

    def parameters(self, t: Array, length: Array) -> Array:
        """As `ReferenceRays`."""
        return length * np.square(t)

    def widened(self, low: float, high: float) -> tuple[float, float]:
        """As `ReferenceRays`."""
        more = BEYOND * max(high - low, LEAST_RANGE * high)
        return max(low - more, 0.5 * low), high + more

    @property
    def reported(self) -> str:
        """As `ReferenceRays`."""
        return DISTANCE if self.axis is None else AXIS

    def depths(self, t: Array) -> Array:
        """As `ReferenceRays`."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return 1 / t
