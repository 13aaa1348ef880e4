"""Surfaces of objects as triangles, and points spread over them."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask

DENSE = 12
"""Points drawn for each that is wanted: those that are kept are then 0.8 of the best possible distance apart."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Surface:
    """Triangles with outward normals (right-handed round each); lengths in metres."""

    name: str
    vertices: Array
    """(n, 3)"""
    triangles: Index
    """(m, 3) rows of vertices"""
    wanted: Mask | None = None
    """(m,) triangles that are to be measured, the others only hide what is behind them; None: all"""
    about: str = ""
    """What it is, in words"""
    thickness: float = 0.0
    """How far its triangles may lie off the object [m]: what is nearer to a point hides nothing of it"""

    def __post_init__(self) -> None:
        """Raise InputError where numbers are not finite, triangles name no vertices or nothing has an extent."""
        v, t = np.asarray(self.vertices), np.asarray(self.triangles)
        if v.ndim != 2 or v.shape[1:] != (3,) or t.ndim != 2 or t.shape[1:] != (3,) or not len(t):
            raise InputError("mesh.no_triangles", name=self.name)
        if not np.isfinite(v).all():
            bad = int(np.flatnonzero(~np.isfinite(v).all(axis=1))[0])
            raise InputError("mesh.vertex_not_finite", name=self.name, vertex=bad + 1)
        if t.min() < 0 or t.max() >= len(v):
            raise InputError("mesh.unknown_vertex", name=self.name, vertex=int(t.max()) + 1, n=len(v))
        if not self.areas.sum() > 0:
            raise InputError("mesh.no_area", name=self.name)
        if self.wanted is not None and not self.areas[self.wanted].sum() > 0:
            raise InputError("mesh.nothing_to_measure", name=self.name)

    @property
    def crosses(self) -> Array:
        """(m, 3) normals with twice the area as their length [m^2]."""
        a, b, c = (self.vertices[self.triangles[:, k]] for k in range(3))
        return np.cross(b - a, c - a)

    @property
    def areas(self) -> Array:
        """(m,) [m^2]."""
        return np.linalg.norm(self.crosses, axis=1) / 2

    @property
    def normals(self) -> Array:
        """(m, 3) outward unit normals; zero where a triangle has no area."""
        n = self.crosses
        return n / np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-300)

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Least and largest coordinates (3,) of what the triangles use."""
        used = self.vertices[np.unique(self.triangles)]
        return used.min(axis=0), used.max(axis=0)

    @property
    def wanted_area(self) -> float:
        """Area that is to be measured [m^2]."""
        return float(self.areas.sum() if self.wanted is None else self.areas[self.wanted].sum())

    @property
    def extent(self) -> float:
        """Longest side of the box round what is to be measured [m]."""
        low, high = self.wanted_bounds
        return float((high - low).max())

    @property
    def wanted_bounds(self) -> tuple[Array, Array]:
        """Least and largest coordinates (3,) of what is to be measured."""
        rows = self.triangles if self.wanted is None else self.triangles[self.wanted]
        used = self.vertices[np.unique(rows)]
        return used.min(axis=0), used.max(axis=0)

    @property
    def open_edges(self) -> int:
        """Edges that one triangle alone has: 0 where the surface is closed."""
        t = np.sort(np.concatenate([self.triangles[:, [0, 1]], self.triangles[:, [1, 2]], self.triangles[:, [2, 0]]]))
        pairs = np.sort(t.reshape(-1, 2), axis=1)
        _, count = np.unique(pairs, axis=0, return_counts=True)
        return int((count == 1).sum())


@dataclass(frozen=True, slots=True, kw_only=True)
class SurfacePoints:
    """Points on a surface."""

    xyz: Array
    """(n, 3) [m]"""
    normal: Array
    """(n, 3) outward unit normals"""
    triangle: Index = field(default_factory=lambda: np.zeros(0, np.int64))
    """(n,) rows of the surface's triangles"""

    def __len__(self) -> int:
        """How many there are."""
        return len(self.xyz)


def spread(surface: Surface, count: int, seed: int = 1) -> SurfacePoints:
    """So many points on what is to be measured of a surface, far from each other; the same at every call.

    Drawn evenly by area by the low-discrepancy sequence of the golden ratio's kin (Roberts 2018), then each the
    farthest from those before (Gonzalez 1985).
    Limits: whether anything that can be measured is there.
    """
    rows = np.arange(len(surface.triangles)) if surface.wanted is None else np.flatnonzero(surface.wanted)
    area = surface.areas[rows]
    n = max(DENSE * count, 200)
    g = 1.22074408460575947536  # root of x^4 = x + 1
    u = (0.5 + np.arange(1, n + 1)[:, None] / g ** np.arange(1, 4) + 0.1 * (seed - 1)) % 1.0
    which = np.searchsorted(np.cumsum(area) / area.sum(), u[:, 0], side="right").clip(max=len(rows) - 1)
    a, b, c = (surface.vertices[surface.triangles[rows[which], k]] for k in range(3))
    s = np.sqrt(u[:, 1:2])
    xyz = (1 - s) * a + s * (1 - u[:, 2:3]) * b + s * u[:, 2:3] * c
    keep = farthest_first(xyz, count)
    triangle = rows[which[keep]]
    return SurfacePoints(xyz=xyz[keep], normal=surface.normals[triangle], triangle=triangle)


def farthest_first(xyz: Array, count: int) -> Index:
    """Rows of points, each the farthest from those before (Gonzalez 1985), from the outermost on."""
    count = min(count, len(xyz))
    chosen = np.zeros(count, np.int64)
    far = np.linalg.norm(xyz - xyz.mean(axis=0), axis=1)
    for k in range(count):
        chosen[k] = int(far.argmax())
        to_new = np.linalg.norm(xyz - xyz[chosen[k]], axis=1)
        far = to_new if k == 0 else np.minimum(far, to_new)
    return chosen


def tiles(surface: Surface, count: int) -> tuple[Array, SurfacePoints]:
    """What is to be measured of a surface in about so many small triangles: corners (m, 3, 3) and middles.

    The longest sides are halved until none is longer than that of an equilateral triangle of twice the mean area.
    """
    rows = surface.triangles if surface.wanted is None else surface.triangles[surface.wanted]
    corners = surface.vertices[rows].astype(float)
    longest = np.sqrt(2 * surface.wanted_area / count * 4 / np.sqrt(3))
    while True:
        side = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2)
        long = np.flatnonzero(side.max(axis=1) > longest)
        if not len(long) or len(corners) > 4 * count:
            break
        first = side[long].argmax(axis=1)
        k = np.arange(len(long))
        turned = np.stack(
            [corners[long][k, (first + j) % 3] for j in range(3)], axis=1
        )  # its first side is the longest
        middle = (turned[:, 0] + turned[:, 1]) / 2
        one = np.stack([turned[:, 0], middle, turned[:, 2]], axis=1)
        two = np.stack([middle, turned[:, 1], turned[:, 2]], axis=1)
        corners = np.concatenate([np.delete(corners, long, axis=0), one, two])
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(cross, axis=1)
    good = area > 0
    return corners[good], SurfacePoints(xyz=corners[good].mean(axis=1), normal=cross[good] / area[good, None])
