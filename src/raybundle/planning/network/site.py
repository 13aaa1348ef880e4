"""A site: an object, where one may stand, a camera; and what stations there see of the object."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from raybundle.adjustment.system.predict import projected
from raybundle.block import Camera
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.objects.distance import Distances
from raybundle.objects.sight import Sight
from raybundle.objects.surface import Surface, SurfacePoints

MARGIN = 0.02
"""Share of the format along its edges in which nothing is measured"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Access:
    """Where one may stand."""

    low: Array
    high: Array
    """(3,) corners of the box in which stations may be [m]"""
    clearance: float = 0.0
    """Least distance from the surface [m]"""
    forbidden: Array = field(default_factory=lambda: np.zeros((0, 2, 3)))
    """(k, 2, 3) boxes in which no station may be"""
    allowed: Callable[[Array], Mask] | None = None
    """Which (n,) of places (n, 3) are allowed besides; None: all"""

    def __post_init__(self) -> None:
        """Raise InputError where nothing is left."""
        if not (np.isfinite(self.low).all() and np.isfinite(self.high).all()):
            raise InputError("site.limit_not_finite")
        for axis, low, high in zip("XYZ", self.low.tolist(), self.high.tolist(), strict=True):
            if high < low:
                raise InputError("site.empty", axis=axis, low_m=low, high_m=high)


@dataclass(frozen=True, kw_only=True)
class Site:
    """An object with the points by which a network is judged, a camera, and where one may stand."""

    surface: Surface
    points: SurfacePoints
    """What is measured: targets, or what stands for natural points"""
    camera: Camera
    """As it is thought to be; `estimate` names what is free"""
    access: Access
    sigma_px: float
    """Standard deviation of an image coordinate"""
    depth: tuple[float, float] = (0.0, float("inf"))
    """Distances along the axis that are sharp [m]"""
    incidence_deg: float = 70.0
    """Largest angle between a ray and the normal of the surface"""
    found: Callable[[Array], Array] | None = None
    """Of the cosines (n,) of rays to the normal: the share of photographs in which points are found; None: in all"""
    beside: float = 0.001
    """How far other parts of the object must be beside a ray, by its length: nobody stands exactly there"""

    @cached_property
    def sight(self) -> Sight:
        """Rays against the surface."""
        return Sight(self.surface)

    @cached_property
    def free(self) -> tuple[str, ...]:
        """Parameters of the interior orientation that are estimated."""
        e = self.camera.estimate
        return tuple(e) if not isinstance(e, str) else tuple(self.camera.values)

    @cached_property
    def extent(self) -> float:
        """Longest side of the box round the points [m]."""
        return float(np.ptp(self.points.xyz, axis=0).max())

    @cached_property
    def closed(self) -> bool:
        """Whether the surface has an inside."""
        return not self.surface.open_edges

    @cached_property
    def distances(self) -> Distances:
        """Distances from the surface."""
        return Distances(self.surface)

    def may_stand(self, centre: Array) -> Mask:
        """(n,) whether stations may be there."""
        a = self.access
        ok = np.asarray(((centre >= a.low) & (centre <= a.high)).all(axis=1))
        if len(a.forbidden):
            within = (centre[:, None] >= a.forbidden[:, 0]) & (centre[:, None] <= a.forbidden[:, 1])
            ok &= ~np.any(np.asarray(within.all(axis=2)), axis=1)
        if a.allowed is not None and ok.any():
            ok[ok] = a.allowed(centre[ok])
        rows = np.flatnonzero(ok)
        if len(rows) and a.clearance > 0:
            ok[rows] = self.distances.of(centre[rows]) >= a.clearance
        low, high = self.surface.bounds
        rows = np.flatnonzero(ok & np.asarray(((centre > low) & (centre < high)).all(axis=1)))
        if len(rows) and self.closed:
            ok[rows] = ~self.sight.inside(centre[rows])
        return ok

    def faced(self, centre: Array) -> tuple[Index, Index]:
        """Stations (k,) and points (k,) that see each other, whatever way the cameras look.

        centre  (n, 3); the incidence, what stands between, and the distance count
        """
        p = self.points
        to = centre[:, None] - p.xyz[None]
        distance = np.linalg.norm(to, axis=2)
        slant = np.einsum("nti,ti->nt", to, p.normal)
        ok = (slant > np.cos(np.radians(self.incidence_deg)) * distance) & (distance > self.depth[0])
        station, point = np.nonzero(ok)
        clear = self.sight.visible(centre[station], p.xyz[point], p.normal[point], self.beside)
        return station[clear], point[clear]

    def seen(self, centre: Array, rotation: Array) -> tuple[Index, Index, Array, Array]:
        """What stations measure: rows of stations and points, image points (k, 2) [mm], points in the camera (k, 3).

        centre, rotation  (n, 3), (n, 3, 3)
        """
        p, camera = self.points, self.camera
        sight = p.xyz[None] - centre[:, None]
        local = np.einsum("nij,ntj->nti", rotation, sight)
        depth = -local[..., 2]
        distance = np.linalg.norm(sight, axis=2)
        slant = -np.einsum("nti,ti->nt", sight, p.normal)
        ok = (depth > self.depth[0]) & (depth < self.depth[1])
        ok &= slant > np.cos(np.radians(self.incidence_deg)) * distance
        station, point = np.nonzero(ok)
        P = local[station, point].T
        model, values = camera.sensor, camera.parameters
        with np.errstate(all="ignore"):
            image = model.start(P, values)
        near = np.asarray(model.in_front(P)) & (np.abs(image.T) < 0.75 * np.abs(camera.size_mm)).all(axis=1)
        station, point, P, image = station[near], point[near], P[:, near], image[:, near]
        if self._bent:
            image, found = projected(camera, P, values, image)
            station, point, P, image = station[found], point[found], P[:, found], image[:, found]
        inside = (np.abs(image.T) < (0.5 - MARGIN) * camera.size_mm).all(axis=1)
        station, point, P, image = station[inside], point[inside], P[:, inside], image[:, inside]
        clear = self.sight.visible(centre[station], p.xyz[point], p.normal[point], self.beside)
        return station[clear], point[clear], image[:, clear].T, P[:, clear].T

    def share(self, centre: Array, point: Index) -> Array:
        """(k,) share of the photographs in which points are found that are seen from places (k, 3)."""
        if self.found is None:
            return np.ones(len(point))
        to = centre - self.points.xyz[point]
        cosine = np.einsum("ni,ni->n", to, self.points.normal[point]) / np.linalg.norm(to, axis=1)
        return self.found(cosine)

    @cached_property
    def _bent(self) -> bool:
        """Whether images are other than the sensor's first guess, the central projection."""
        model = self.camera.sensor
        far = np.array([[0.1], [0.07], [-1.0]])
        g, _ = model.condition_and_jacobian(*model.start(far, self.camera.parameters), *far, *self.camera.parameters)
        return bool(np.abs(g).max() > 1e-9)
