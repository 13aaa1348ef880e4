"""A part on a table with coded targets, and photographs of it: plane faces, painted from far to near."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from threadpoolctl import threadpool_limits

from raybundle.numerics.arrays import Array
from raybundle.planning.rendered.rendering import View, between, exposed, looked_up, noise_of_size, spread

Paint = Callable[[Array, Array], Array]
"""Grey value of a face at places along its two sides [m]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Face:
    """A plane rectangle, seen from the side to which its normal points."""

    corner: Array
    """(3,)"""
    right: Array
    """(3,) unit vector"""
    up: Array
    """(3,) unit vector, square to it"""
    size: tuple[float, float]
    paint: Paint
    fine: int = 1
    """Samples along a pixel"""

    @property
    def normal(self) -> Array:
        """Unit vector (3,)."""
        return np.cross(self.right, self.up)

    @property
    def corners(self) -> Array:
        """Points (4, 3), from the first around."""
        w, h = self.size
        return self.corner + np.array([[0, 0], [w, 0], [w, h], [0, h]]) @ np.stack([self.right, self.up])


def plain(grey: float, rng: np.random.Generator, *, scatter: float = 4.0, texel: float = 0.004) -> Paint:
    """A surface of one grey with stains of a few millimetres."""
    stains = noise_of_size(rng, (400, 400), 3.0)

    def paint(u: Array, v: Array) -> Array:
        return grey + scatter * looked_up(stains, (v / texel) % 398, (u / texel) % 398)

    return paint


def target(ring: Array, radii: tuple[float, float], dot: float, half: float) -> Paint:
    """A white dot on black with a coded ring.

    ring   (n, 2) angles where set sectors begin and end [rad], from the right, counter-clockwise as seen
    radii  inner and outer, in radii of the dot
    dot    its radius, half the half side of the card [m]
    """

    def paint(u: Array, v: Array) -> Array:
        x, y = (u - half) / dot, (v - half) / dot
        r, angle = np.hypot(x, y), np.arctan2(y, x) % (2 * math.pi)
        on = r < 1
        coded = (r > radii[0]) & (r < radii[1])
        for begin, end in ring:
            on = on | (coded & ((angle - begin) % (2 * math.pi) < end - begin))
        return np.where(on, 225.0, 22.0)

    return paint


def block(low: Array, high: Array, paint: Paint) -> list[Face]:
    """Top and sides of a box, edges along the axes."""
    (w, d, h), x, y, z = (high - low).tolist(), *np.eye(3)

    def shaded(share: float) -> Paint:
        return lambda u, v: share * paint(u, v)

    return [
        Face(corner=low + h * z, right=x, up=y, size=(w, d), paint=paint),
        Face(corner=low, right=x, up=z, size=(w, h), paint=shaded(0.72)),
        Face(corner=high - h * z, right=-x, up=z, size=(w, h), paint=shaded(0.58)),
        Face(corner=low + w * x, right=y, up=z, size=(d, h), paint=shaded(0.82)),
        Face(corner=high - h * z - w * x, right=-y, up=z, size=(d, h), paint=shaded(0.64)),
    ]


def card(centre: Array, normal: Array, half: float, paint: Paint) -> Face:
    """A square card with the target's centre in its middle, that faces along `normal` (3,)."""
    level = np.array([0.0, 1.0, 0.0]) if abs(normal[2]) > 0.9 else np.array([0.0, 0.0, 1.0])
    right = np.cross(level, normal)
    right /= np.linalg.norm(right)
    up = np.cross(normal, right)
    return Face(corner=centre - half * (right + up), right=right, up=up, size=(2 * half, 2 * half), paint=paint, fine=6)


def photograph(bodies: Sequence[Sequence[Face]], view: View, rng: np.random.Generator) -> Array:
    """Grey values (h, w, 3) uint8 of bodies; the first is the table, what nothing hides is dark ground.

    The table is painted first, convex bodies that stand apart on it from far to near, the faces of each in their order:
    what lies on a face comes after it.
    """
    rays = view.node_directions()
    seen = np.full((view.camera.height_px, view.camera.width_px), 60.0)

    def away(body: Sequence[Face]) -> float:
        return float(np.linalg.norm(np.mean([f.corners.mean(axis=0) for f in body], axis=0) - view.centre))

    with threadpool_limits(1):  # many small products
        for body in (bodies[0], *sorted(bodies[1:], key=away, reverse=True)):
            for face in body:
                if (view.centre - face.corner) @ face.normal > 0:
                    _painted(seen, face, view, rays)
    tint = np.array([1.0, 0.985, 0.95])
    return exposed((seen[..., None] * tint).astype(np.float32), rng)


def _painted(seen: Array, face: Face, view: View, rays: tuple[Array, Array, Array]) -> None:
    """Paint a face into the picture."""
    columns, rows, nodes = rays
    xy = view.pixels_of(face.corners)
    size = np.array([view.camera.width_px, view.camera.height_px])
    low = np.clip(np.floor(xy.min(axis=0)).astype(int) - 2, 0, size)
    high = np.clip(np.ceil(xy.max(axis=0)).astype(int) + 3, 0, size)
    if (high <= low).any():
        return
    k = face.fine
    across, down = (
        between(n, low[a] + (np.arange((high[a] - low[a]) * k) + 0.5) / k) for a, n in ((0, columns), (1, rows))
    )
    d = spread(nodes, down, across)
    reach = ((face.corner - view.centre) @ face.normal) / (d @ face.normal)
    off = view.centre - face.corner
    u, v = (off @ axis + reach * (d @ axis) for axis in (face.right, face.up))
    # edges that do not fall between samples are covered in part
    inner = [
        np.clip(np.minimum(a, size - a) / np.maximum(np.linalg.norm(np.gradient(a), axis=0), 1e-12) + 0.5, 0, 1)
        for a, size in zip((u, v), face.size, strict=True)
    ]
    on = inner[0] * inner[1]
    grey = on * face.paint(u, v)
    h, w = high[1] - low[1], high[0] - low[0]
    share, value = (a.reshape(h, k, w, k).mean(axis=(1, 3)) for a in (on, grey))
    part = seen[low[1] : high[1], low[0] : high[0]]
    part *= 1 - share
    part += value
