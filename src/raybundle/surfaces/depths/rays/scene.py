"""Rays of a satellite scene: they have no common centre, and what is measured along them is the height."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import cast

import numpy as np

from raybundle.block import Camera
from raybundle.numerics.arrays import Array
from raybundle.scenes.sensor import VIEW_M, SceneSensor
from raybundle.surfaces.depths.rays.reference import BEYOND, ReferenceRays

STEP_M = 10.0
"""Half the difference of heights over which a direction is taken: a ray bends by less than 1e-6 rad over it."""
LEAST_RANGE_M = 120.0
"""What a range of heights is taken for at least: houses and trees stand 30 m above ground on which all tie points may
lie."""
HEIGHT = "height above the ellipsoid"


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneRays(ReferenceRays):
    """Object points of a scene's pixels at heights above the ellipsoid: t [m] counts them from below all ground.

    A scene sees the ground by parallel rays, but for some parts in a thousand: a plane is linear in t and the pixels.
    The points are those of the scene's own model, the RPC with its corrections or the orbit with those of its
    trajectory.
    """

    sensor: SceneSensor
    base_m: float
    """height where t is 0"""

    @classmethod
    def takes(cls, camera: Camera) -> bool:
        """Scenes."""
        return isinstance(camera.scene, SceneSensor)

    @classmethod
    def made(cls, camera: Camera, rotation: Array, centre: Array) -> SceneRays:
        """As `ReferenceRays`; a scene stands where its file states."""
        del rotation, centre
        sensor = cast("SceneSensor", camera.scene)
        return cls(camera=camera, sensor=sensor, base_m=sensor.height_m - sensor.depth_m)

    def moved(self, camera: Camera, rotation: Array, centre: Array) -> SceneRays:
        """As `ReferenceRays`."""
        del rotation, centre
        return SceneRays(camera=camera, sensor=self.sensor, base_m=self.base_m)

    def rays(self, xy_px: Array) -> tuple[Array, Array]:
        """As `ReferenceRays`: tangents at the middle of all heights."""
        t = np.full(len(xy_px), self.sensor.depth_m)
        direction = self.by_t(xy_px, t)
        return self.points(xy_px, t) - direction * t[:, None], direction

    def along(self, t: Array) -> tuple[Array, Array]:
        """As `ReferenceRays`."""
        return t, np.ones_like(t)

    def points(self, xy_px: Array, t: Array) -> Array:
        """As `ReferenceRays`."""
        return self.sensor.localise(np.asarray(xy_px, float), self.base_m + t, self.camera.parameters)

    def by_t(self, xy_px: Array, t: Array) -> Array:
        """As `ReferenceRays`."""
        return (self.points(xy_px, t + STEP_M) - self.points(xy_px, t - STEP_M)) / (2 * STEP_M)

    def parameter(self, xy_px: Array, xyz: Array) -> Array:
        """As `ReferenceRays`."""
        del xy_px
        return self.sensor.place.geographic_from_block(xyz)[:, 2] - self.base_m

    def directions(self, xy_px: Array) -> Array:
        """As `ReferenceRays`."""
        return -self.by_t(xy_px, np.full(len(xy_px), self.sensor.depth_m))

    def viewer(self, coordinates: Callable[[Array], Array]) -> Array:
        """As `ReferenceRays`: as far away as a satellite, in the direction that rays have on the ground.

        In coordinates of a map a long ray is bent.
        """
        middle = np.array([[self.camera.width_px / 2, self.camera.height_px / 2]])
        t = np.full(1, self.sensor.depth_m)
        ground, above = (coordinates(self.points(middle, t + up))[0] for up in (0.0, STEP_M))
        return ground + (above - ground) * (VIEW_M / float(np.linalg.norm(above - ground)))

    def lengths(self, t: Array, sigma: Array) -> Array:
        """As `ReferenceRays`: heights."""
        del t
        return sigma

    def parameters(self, t: Array, length: Array) -> Array:
        """As `ReferenceRays`."""
        del t
        return length

    def widened(self, low: float, high: float) -> tuple[float, float]:
        """As `ReferenceRays`."""
        more = BEYOND * max(high - low, LEAST_RANGE_M)
        return max(low - more, 0.5 * low), high + more

    @property
    def reported(self) -> str:
        """As `ReferenceRays`."""
        return HEIGHT

    def depths(self, t: Array) -> Array:
        """As `ReferenceRays`."""
        return self.base_m + t
