"""Geographic, geocentric and local Cartesian coordinates on an ellipsoid of revolution, with their derivatives.

geographic   (n, 3)  longitude, latitude [deg], height above the ellipsoid [m]
geocentric   (n, 3)  X through the zero meridian, Z through the north pole [m]
local        (n, 3)  east, north, up [m] at one point of the ellipsoid

Hofmann-Wellenhof, Lichtenegger and Wasle 2008, sections 8.2 and 8.4; Bowring 1976.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array


@dataclass(frozen=True, slots=True)
class Ellipsoid:
    """An ellipsoid of revolution; a sphere where both axes are equal."""

    a: float
    """Semi-major axis, in the plane of the equator [m]."""
    b: float
    """Semi-minor axis, to the poles [m]."""

    def __post_init__(self) -> None:
        """Refuse what is no body."""
        if not (0 < self.b <= self.a < float("inf")):
            raise InputError("ellipsoid.semi_axes", a=self.a, b=self.b)

    @property
    def e2(self) -> float:
        """Squared first eccentricity."""
        return 1 - (self.b / self.a) ** 2


WGS84 = Ellipsoid(6378137.0, 6378137.0 * (1 - 1 / 298.257223563))


def geocentric_from_geographic(geographic: Array, ellipsoid: Ellipsoid = WGS84) -> Array:
    """Geocentric coordinates (n, 3) of geographic ones (n, 3); exact."""
    lon, lat, h = np.radians(geographic[:, 0]), np.radians(geographic[:, 1]), geographic[:, 2]
    e2 = ellipsoid.e2
    N = ellipsoid.a / np.sqrt(1 - e2 * np.sin(lat) ** 2)
    plane = (N + h) * np.cos(lat)
    return np.stack([plane * np.cos(lon), plane * np.sin(lon), (N * (1 - e2) + h) * np.sin(lat)], axis=1)


def geographic_from_geocentric(xyz: Array, ellipsoid: Ellipsoid = WGS84) -> Array:
    """Geographic coordinates (n, 3) of geocentric ones (n, 3).

    Bowring's iteration on the reduced latitude; three steps reach 1e-14 rad from the sea floor to satellites.
    The centre of the body has no latitude.
    """
    a, b, e2 = ellipsoid.a, ellipsoid.b, ellipsoid.e2
    plane, z = np.hypot(xyz[:, 0], xyz[:, 1]), xyz[:, 2]
    reduced = np.arctan2(z * a, plane * b)
    lat = reduced
    for _ in range(3):
        lat = np.arctan2(z + e2 * a * a / b * np.sin(reduced) ** 3, plane - e2 * a * np.cos(reduced) ** 3)
        reduced = np.arctan2(b * np.sin(lat), a * np.cos(lat))
    h = plane * np.cos(lat) + z * np.sin(lat) - a * np.sqrt(1 - e2 * np.sin(lat) ** 2)
    return np.stack([np.degrees(np.arctan2(xyz[:, 1], xyz[:, 0])), np.degrees(lat), h], axis=1)


def enu_from_geocentric(geographic: Array) -> Array:
    """Rotations (n, 3, 3) from geocentric axes to east, north, up at geographic points (n, 3)."""
    lon, lat = np.radians(geographic[:, 0]), np.radians(geographic[:, 1])
    so, co, sa, ca = np.sin(lon), np.cos(lon), np.sin(lat), np.cos(lat)
    rows = [[-so, co, np.zeros_like(so)], [-sa * co, -sa * so, ca], [ca * co, ca * so, sa]]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def metres_per_geographic(geographic: Array, ellipsoid: Ellipsoid = WGS84) -> Array:
    """(n, 3) length of a degree of longitude, of a degree of latitude and of a metre of height [m]."""
    lat, h = np.radians(geographic[:, 1]), geographic[:, 2]
    e2 = ellipsoid.e2
    w2 = 1 - e2 * np.sin(lat) ** 2
    N = ellipsoid.a / np.sqrt(w2)
    M = N * (1 - e2) / w2
    return np.stack([np.radians((N + h) * np.cos(lat)), np.radians(M + h), np.ones_like(h)], axis=1)


def geographic_partials(geographic: Array, ellipsoid: Ellipsoid = WGS84) -> Array:
    """(n, 3, 3) derivatives of geographic [deg, deg, m] by geocentric coordinates [m], at geographic points (n, 3)."""
    return enu_from_geocentric(geographic) / metres_per_geographic(geographic, ellipsoid)[:, :, None]


@dataclass(frozen=True, slots=True, kw_only=True)
class LocalPlace:
    """East, north, up at one point of an ellipsoid: a Cartesian frame, in which heights are those above its plane.

    1 km from the origin the plane stands 8 cm above the ellipsoid, 10 km from it 8 m.
    """

    origin: tuple[float, float, float]
    """Longitude, latitude [deg], height [m]."""
    ellipsoid: Ellipsoid = WGS84

    def local_from_geographic(self, geographic: Array) -> Array:
        """Local coordinates (n, 3) [m]."""
        return self.local_from_geocentric(geocentric_from_geographic(geographic, self.ellipsoid))

    def local_from_geocentric(self, xyz: Array) -> Array:
        """Local coordinates (n, 3) [m]."""
        centre, R = self._place()
        return (xyz - centre) @ R.T

    def geocentric_from_local(self, xyz: Array) -> Array:
        """Geocentric coordinates (n, 3) [m]."""
        centre, R = self._place()
        return xyz @ R + centre

    def geographic_from_local(self, xyz: Array) -> Array:
        """Geographic coordinates (n, 3) [deg, deg, m]."""
        return geographic_from_geocentric(self.geocentric_from_local(xyz), self.ellipsoid)

    def geographic_partials(self, geographic: Array) -> Array:
        """(n, 3, 3) derivatives of geographic by local coordinates, at geographic points (n, 3)."""
        return geographic_partials(geographic, self.ellipsoid) @ self._place()[1].T

    def local_from_geocentric_rotation(self) -> Array:
        """(3, 3) rotation from geocentric axes to east, north, up of this place."""
        return self._place()[1]

    def _place(self) -> tuple[Array, Array]:
        origin = np.array([self.origin], float)
        return geocentric_from_geographic(origin, self.ellipsoid)[0], enu_from_geocentric(origin)[0]
