"""Frames of object coordinates whose place on the earth is known: local, geocentric, projected.

A satellite scene is reported in longitude, latitude and height; a block stands in one of these frames.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import (
    WGS84,
    Ellipsoid,
    LocalPlace,
    enu_from_geocentric,
    geocentric_from_geographic,
    geographic_from_geocentric,
    geographic_partials,
    metres_per_geographic,
)

STEP_M = 10.0
"""Half the width of the central differences through a map projection: their error is below 1e-10."""


class Place(Protocol):
    """What an observation equation asks of a frame of object coordinates."""

    def geographic_from_block(self, xyz: Array) -> Array:
        """Longitude, latitude [deg], height [m] (n, 3) of object coordinates (n, 3)."""
        ...

    def block_from_geographic(self, geographic: Array) -> Array:
        """Object coordinates (n, 3) of longitude, latitude [deg], height [m] (n, 3)."""
        ...

    def geographic_by_block(self, xyz: Array, geographic: Array) -> Array:
        """(n, 3, 3) derivatives of geographic by object coordinates."""
        ...

    def geocentric_from_block(self, xyz: Array) -> Array:
        """Geocentric coordinates (n, 3)."""
        ...

    def geocentric_by_block(self, xyz: Array) -> Array:
        """(n, 3, 3) derivatives of geocentric by object coordinates."""
        ...


@dataclass(frozen=True, slots=True, kw_only=True)
class Local:
    """East, north, up at one point of the ellipsoid."""

    origin: tuple[float, float, float]
    """Longitude, latitude [deg], height [m]."""
    ellipsoid: Ellipsoid = WGS84
    crs: str = ""
    """The coordinate system in which the block is reported, "EPSG:25832+7837"; empty: none was named."""
    crs_origin: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """The origin in that system: east, north, height."""
    undulation_m: float | None = None
    """Height of the geoid above the ellipsoid there; None: by the geoid's grid."""

    @property
    def place(self) -> LocalPlace:
        """The transformations."""
        return LocalPlace(origin=self.origin, ellipsoid=self.ellipsoid)

    def geographic_from_block(self, xyz: Array) -> Array:
        """As `Place`."""
        return self.place.geographic_from_local(xyz)

    def block_from_geographic(self, geographic: Array) -> Array:
        """As `Place`."""
        return self.place.local_from_geographic(geographic)

    def geographic_by_block(self, xyz: Array, geographic: Array) -> Array:
        """As `Place`."""
        del xyz
        return self.place.geographic_partials(geographic)

    def geocentric_from_block(self, xyz: Array) -> Array:
        """As `Place`."""
        return self.place.geocentric_from_local(xyz)

    def geocentric_by_block(self, xyz: Array) -> Array:
        """As `Place`."""
        return np.broadcast_to(self.place.local_from_geocentric_rotation().T, (len(xyz), 3, 3))


@dataclass(frozen=True, slots=True, kw_only=True)
class Geocentric:
    """X through the zero meridian, Z through the north pole [m]."""

    ellipsoid: Ellipsoid = WGS84

    def geographic_from_block(self, xyz: Array) -> Array:
        """As `Place`."""
        return geographic_from_geocentric(xyz, self.ellipsoid)

    def block_from_geographic(self, geographic: Array) -> Array:
        """As `Place`."""
        return geocentric_from_geographic(geographic, self.ellipsoid)

    def geographic_by_block(self, xyz: Array, geographic: Array) -> Array:
        """As `Place`."""
        del xyz
        return geographic_partials(geographic, self.ellipsoid)

    def geocentric_from_block(self, xyz: Array) -> Array:
        """As `Place`."""
        return xyz

    def geocentric_by_block(self, xyz: Array) -> Array:
        """As `Place`."""
        return np.broadcast_to(np.eye(3), (len(xyz), 3, 3))


@dataclass(frozen=True, slots=True, kw_only=True)
class Projected:
    """Easting, northing of a map projection and height above the ellipsoid or a geoid [m].

    Frames of a bundle are Cartesian; this one is not.  Lines are straight in space only over the extent of a satellite
    scene's own rays, which are evaluated rigorously; photographs do not belong into such a block.
    """

    name: str
    """As the coordinate system is written, "EPSG:32633"."""
    origin: tuple[float, float, float]
    """A point of the block, in this system."""
    to_geographic: Callable[[Array], Array]
    """(n, 3) to longitude, latitude [deg], height above the ellipsoid [m] (n, 3)."""
    from_geographic: Callable[[Array], Array]
    ellipsoid: Ellipsoid = WGS84

    def geographic_from_block(self, xyz: Array) -> Array:
        """As `Place`."""
        return self.to_geographic(xyz)

    def block_from_geographic(self, geographic: Array) -> Array:
        """As `Place`."""
        return self.from_geographic(geographic)

    def geographic_by_block(self, xyz: Array, geographic: Array) -> Array:
        """As `Place`; central differences."""
        del geographic
        steps = STEP_M * np.eye(3)
        columns = [(self.to_geographic(xyz + d) - self.to_geographic(xyz - d)) / (2 * STEP_M) for d in steps]
        return np.stack(columns, axis=2)

    def geocentric_from_block(self, xyz: Array) -> Array:
        """As `Place`."""
        return geocentric_from_geographic(self.to_geographic(xyz), self.ellipsoid)

    def geocentric_by_block(self, xyz: Array) -> Array:
        """As `Place`."""
        geographic = self.to_geographic(xyz)
        metric = metres_per_geographic(geographic, self.ellipsoid)[:, :, None]
        to_geocentric = np.swapaxes(enu_from_geocentric(geographic), 1, 2)
        return to_geocentric @ (metric * self.geographic_by_block(xyz, geographic))
