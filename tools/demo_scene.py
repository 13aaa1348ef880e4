"""The object and the network of the demonstration set: a portal as displaced surfaces, and where it is seen from."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from scipy import ndimage

from raybundle.block import Camera
from raybundle.numerics.arrays import Array
from raybundle.sensors import sensor_models

Relief = Callable[[Array, Array], Array]
"""How far a turned body stands out of its profile, by angle and height."""
SEED = 20240
TRUE = {"c": 24.31, "x0": 0.118, "y0": -0.083, "K1": 4.1e-5, "K2": -2.6e-8, "P1": 6.5e-6, "P2": -4.2e-6}
SENSOR_MM = (36.0, 27.0)
BAR = (np.array([-0.62, -0.62, 0.575]), np.array([0.61, -0.66, 0.630]))
"""The ends of the scale bar [m]."""


WALL_M = (6.2, 3.6)
"""What the wall's texture covers: the wall and, beside it, the niche."""


# ---- noise and textures


def noise(shape: tuple[int, int], cell: float, rng: np.random.Generator) -> Array:
    """Smooth noise (h, w) of standard deviation 1 whose features are about `cell` samples wide."""
    rows, columns = (math.ceil(n / cell) + 4 for n in shape)
    size = round(columns * cell), round(rows * cell)
    zoomed = cv2.resize(rng.standard_normal((rows, columns)).astype(np.float32), size, interpolation=cv2.INTER_CUBIC)
    field = zoomed[: shape[0], : shape[1]]
    return (field - field.mean()) / field.std()


def octaves(shape: tuple[int, int], coarsest: float, finest: float, falloff: float, rng: np.random.Generator) -> Array:
    """Noise of many scales, standard deviation 1."""
    total, cell, weight = np.zeros(shape), coarsest, 1.0
    while cell >= finest:
        total += weight * noise(shape, cell, rng)
        cell, weight = cell / 2, weight * falloff
    return total / total.std()


def stone(shape: tuple[int, int], rng: np.random.Generator, tint: tuple[float, float, float]) -> Array:
    """A stone's colours (h, w, 3) uint8: stains, grain, pores and veins at all scales."""
    stains = octaves(shape, 600, 24, 0.8, rng)
    grain = octaves(shape, 16, 1.5, 0.95, rng)
    veins = np.exp(-((octaves(shape, 300, 8, 0.6, rng) / 0.05) ** 2))
    pores = octaves(shape, 12, 3, 0.8, rng) > 2.0
    value = 0.66 + 0.045 * stains + 0.06 * grain - 0.07 * veins - 0.17 * pores
    hue = 0.014 * octaves(shape, 200, 20, 0.7, rng)
    colour = np.stack([value * tint[0] + hue, value * tint[1], value * tint[2] - hue], axis=2)
    return (np.clip(colour, 0.04, 0.97) * 255).astype(np.uint8)


def target_card(code: int, pixels: int = 360) -> Array:
    """A card (n, n, 3): white dot and twelve ring segments on black; the centre is the centre of the card."""
    axis = (np.arange(pixels) + 0.5) / pixels * 2 - 1
    x, y = np.meshgrid(axis, axis)
    r = np.hypot(x, y)
    segment = ((np.arctan2(y, x) / (2 * np.pi) * 12) % 12).astype(int)
    white = (r < 0.28) | ((r > 0.52) & (r < 0.76) & ((code >> segment) & 1 == 1))
    soft = ndimage.gaussian_filter(white.astype(float), 1.0)
    return np.repeat((18 + 215 * soft)[..., None], 3, axis=2).astype(np.uint8)


# ---- shapes: grids of vertices (rows, columns, 3) with texture coordinates (rows, columns, 2)


@dataclass(frozen=True, slots=True, kw_only=True)
class Sheet:
    """A displaced surface with the texture that it shows."""

    name: str
    xyz: Array
    uv: Array
    texture: str


def smooth_step(x: Array, width: float) -> Array:
    """0 below 0, 1 above `width`."""
    t = np.clip(x / width, 0, 1)
    return t * t * (3 - 2 * t)


def band(x: Array, low: float, high: float, edge: float = 0.008) -> Array:
    """1 between `low` and `high`, 0 outside."""
    return smooth_step(x - low, edge) * smooth_step(high - x, edge)


def facade_depth(x: Array, z: Array, rng: np.random.Generator) -> Array:
    """How far the wall stands out [m] at (x, z)."""
    shape = x.shape
    course = np.floor(z / 0.31).astype(int)
    block_width = 0.47
    shifted = x + 0.235 * (course % 2) + 0.05 * np.sin(3.7 * course)
    column = np.floor(shifted / block_width).astype(int)
    own = rng.standard_normal((64, 64, 3))[course % 64, column % 64]
    inside = band(z - 0.31 * course, 0.0, 0.31, 0.012) * band(shifted - block_width * column, 0, block_width, 0.012)
    d = 0.014 * inside + 0.004 * own[..., 0] + 0.02 * own[..., 1] * (z - 0.31 * course - 0.15) * 0.5
    d += 0.0022 * octaves(shape, 40, 2, 0.75, rng) * (1 + 0.6 * (own[..., 2] > 0.3))
    frame = band(np.abs(x), -1, 0.78) * band(z, 0.0, 2.72)
    d = d * (1 - frame) + frame * (0.035 + 0.0012 * octaves(shape, 30, 2, 0.75, rng))
    arch = np.hypot(x, np.maximum(z - 1.95, 0))
    mouldings = 0.03 + 0.02 * band(arch, 0.50, 0.54) - 0.016 * band(arch, 0.57, 0.60)
    d += frame * band(arch, 0.47, 0.66) * (z > 0.9) * mouldings
    angle = np.arctan2(z - 1.95, x)
    beads = np.cos(26 * angle + 1.1 * np.sin(5 * angle)) * (0.6 + 0.4 * np.sin(3.3 * angle + 1))
    d += frame * band(arch, 0.605, 0.65) * (z > 1.95) * 0.014 * beads
    d += band(z, 0, 0.42, 0.01) * 0.07
    d += ornament(x, z, rng)
    d += 0.05 * band(z, 2.70, 2.76) + 0.09 * smooth_step(z - 3.02, 0.05) + 0.10 * smooth_step(z - 3.14, 0.02)
    teeth = np.cos(2 * np.pi * x / 0.11 + 1.3 * np.sin(2.1 * x))
    d += 0.045 * band(z, 3.02, 3.12) * smooth_step(teeth + 0.1, 0.3)
    chips = octaves(shape, 60, 4, 0.85, rng) > 2.1
    d -= 0.012 * ndimage.gaussian_filter(chips.astype(float), 1.5)
    niche = np.sqrt(np.maximum(0.46**2 - arch**2, 0)) * (z > 0.92)
    return np.where(niche > 0, 0.05 - niche + 0.002 * octaves(shape, 30, 2, 0.8, rng), d)


def ornament(x: Array, z: Array, rng: np.random.Generator) -> Array:
    """Carved frieze and rosettes; no two leaves are the same."""
    d = np.zeros(x.shape)
    for centre in np.arange(-2.0, 2.01, 0.235):
        u, v = x - centre - 0.03 * rng.standard_normal(), z - 2.89 - 0.012 * rng.standard_normal()
        r, angle = np.hypot(u, v), np.arctan2(v, u)
        petals = rng.integers(5, 9)
        first, second = rng.uniform(0, 6), rng.uniform(0, 6)
        edge = 0.085 * (0.75 + 0.25 * np.cos(petals * angle + first) + 0.06 * np.cos(3 * angle + second))
        d += 0.034 * np.clip(1 - (r / edge) ** 2, 0, 1) * (0.7 + 0.3 * np.cos(r * 180))
    for sign in (-1, 1):
        u, v = x - sign * 1.62, z - 1.72
        r, angle = np.hypot(u, v), np.arctan2(v, u) + rng.uniform(0, 6)
        d += 0.03 * band(r, 0.30, 0.37) + 0.012 * band(r, 0.32, 0.35)
        lobes = 0.17 * (1 + 0.35 * np.cos((6 if sign > 0 else 7) * angle))
        d += 0.05 * np.clip(1 - (r / lobes) ** 2, 0, 1) ** 0.7
        d += 0.014 * band(r, 0.18, 0.29) * np.cos(11 * angle + 9 * r * sign)
    return d


@dataclass(frozen=True, slots=True)
class Moved:
    """A square of the wall that has moved outwards by `by`; lower left corner, side [m]."""

    x: float
    z: float
    side: float
    by: float

    def out(self, x: Array, z: Array) -> Array:
        """How far the wall at (x, z) has moved; its rim rises within a facet."""
        edge = 0.004
        return (
            self.by
            * band(x, self.x - edge / 2, self.x + self.side + edge / 2, edge)
            * band(z, self.z - edge / 2, self.z + self.side + edge / 2, edge)
        )


def facade(rng: np.random.Generator, cell: float, reliefs: Sequence[Moved] = ()) -> Sheet:
    """The wall."""
    x, z = np.meshgrid(np.arange(-2.3, 2.3001, cell), np.arange(0, 3.6001, cell))
    out = facade_depth(x, z, rng)
    for relief in reliefs:
        out = out + relief.out(x, z)
    xyz = np.stack([x, -out, z], axis=2)
    # the niche shows a part of the texture of its own, unrolled
    u, v, arch = x, z - 1.95, np.hypot(x, np.maximum(z - 1.95, 0))
    unrolled = np.arcsin(np.minimum(arch / 0.46, 1)) * 0.46 / np.maximum(arch, 1e-6)
    niche = (arch < 0.46) & (z > 0.92)
    u = np.where(niche, 5.35 - 2.3 + x * unrolled, u)
    v = np.where(niche & (v > 0), v * unrolled, v) + 1.95
    return Sheet(name="facade", xyz=xyz, uv=np.stack([(u + 2.3) / WALL_M[0], v / WALL_M[1]], axis=2), texture="wall")


def turned(
    name: str, profile: Array, centre: tuple[float, float], relief: Relief, uv0: tuple[float, float], cell: float
) -> Sheet:
    """A turned body: radius by height (n, 2), displaced outward by relief(angle, z, shape)."""
    heights = np.arange(profile[0, 0], profile[-1, 0], cell)
    angles = np.arange(0, 2 * np.pi, cell / 0.12)
    angles = np.append(angles, 2 * np.pi)
    a, z = np.meshgrid(angles, heights)
    r = np.interp(heights, profile[:, 0], profile[:, 1])[:, None] + relief(a, z)
    r[:, -1] = r[:, 0]
    xyz = np.stack([centre[0] + r * np.sin(a), centre[1] - r * np.cos(a), z], axis=2)
    uv = np.stack([uv0[0] + a * 0.14 / 4.1, uv0[1] + (z - heights[0]) / 4.1], axis=2)
    return Sheet(name=name, xyz=xyz, uv=uv, texture="stone")


def column(name: str, x: float, rng: np.random.Generator, uv0: tuple[float, float], cell: float) -> Sheet:
    """A fluted column with base and capital."""
    profile = np.array([
        (0.50, 0.20), (0.56, 0.20), (0.565, 0.17), (0.60, 0.185), (0.64, 0.15), (0.66, 0.140), (1.3, 0.142),
        (2.3, 0.118), (2.32, 0.13), (2.34, 0.118), (2.40, 0.13), (2.52, 0.185), (2.56, 0.19), (2.57, 0.21),
        (2.70, 0.21),
    ])  # fmt: skip
    phase = rng.uniform(0, 6)

    def relief(a: Array, z: Array) -> Array:
        flutes = -0.011 * np.abs(np.cos(9 * a + phase)) * band(z, 0.72, 2.22, 0.05)
        leaves = 0.014 * np.cos(7 * a + phase + 14 * z) * np.sin(40 * z + phase) * band(z, 2.36, 2.54, 0.02)
        wear = 0.0012 * octaves(a.shape, 30, 2, 0.75, rng)
        return flutes + leaves + wear - 0.008 * (octaves(a.shape, 50, 6, 0.8, rng) > 2.2)

    return turned(name, profile, (x, -0.27), relief, uv0, cell)


def figure(rng: np.random.Generator, cell: float) -> Sheet:
    """A draped figure for the niche."""
    profile = np.array([
        (0.93, 0.19), (0.97, 0.19), (0.98, 0.155), (1.02, 0.165), (1.2, 0.14), (1.45, 0.125), (1.62, 0.15),
        (1.74, 0.165), (1.83, 0.14), (1.87, 0.06), (1.90, 0.055), (1.93, 0.08), (1.99, 0.097), (2.06, 0.085),
        (2.10, 0.05), (2.115, 0.004),
    ])  # fmt: skip

    def relief(a: Array, z: Array) -> Array:
        body = band(z, 1.0, 1.8, 0.08)
        folds = 0.016 * np.cos(8 * a + 5 * np.sin(2.2 * z) + 1.5 * np.sin(3 * a)) * body * (1.7 - 0.5 * z)
        sash = 0.02 * np.exp(-(((z - 1.42 - 0.12 * np.sin(a + 0.6)) / 0.035) ** 2))
        arms = 0.045 * np.exp(-(((z - 1.55) / 0.07) ** 2)) * np.exp(-(((np.sin(a / 2 - 0.35)) / 0.3) ** 2))
        face = 0.012 * np.cos(3 * a) * np.sin(55 * z) * band(z, 1.92, 2.06, 0.02)
        hair = 0.006 * np.cos(17 * a + 30 * z) * band(z, 1.98, 2.10, 0.03) * (np.cos(a) < 0.2)
        return folds + sash + arms + face + hair + 0.0012 * octaves(a.shape, 30, 2, 0.75, rng)

    return turned("figure", profile, (0.0, 0.17), relief, (0.50, 0.02), cell)


def slab(
    name: str,
    corner: Array,
    along: Array,
    up: Array,
    rng: np.random.Generator,
    uv0: tuple[float, float],
    cell: float,
    rough: float = 0.0014,
) -> Sheet:
    """A plane face with a worn surface, its outer side where along x up points."""
    width, height = np.linalg.norm(along), np.linalg.norm(up)
    s, t = np.meshgrid(np.linspace(0, 1, max(2, round(width / cell))), np.linspace(0, 1, max(2, round(height / cell))))
    normal = np.cross(along, up) / (width * height)
    edge = np.minimum(np.minimum(s, 1 - s) * width, np.minimum(t, 1 - t) * height)
    d = rough * octaves(s.shape, 40, 2, 0.75, rng) * smooth_step(edge, 0.02) if min(s.shape) > 4 else np.zeros(s.shape)
    xyz = corner + s[..., None] * along + t[..., None] * up + d[..., None] * normal
    uv = np.stack([uv0[0] + s * width / 4.1, uv0[1] + t * height / 4.1], axis=2)
    return Sheet(name=name, xyz=xyz, uv=uv, texture="stone")


def box(
    name: str, low: Array, high: Array, rng: np.random.Generator, uv0: tuple[float, float], cell: float
) -> list[Sheet]:
    """Front, top and sides of a block that stands before the wall."""
    size = high - low
    ex, ey, ez = np.diag(size)
    u, v = uv0
    return [
        slab(f"{name} front", low, ex, ez, rng, (u, v), cell),
        slab(f"{name} top", low + ez, ex, ey, rng, (u, v + size[2] / 4.1), cell),
        slab(f"{name} left", low + ey, -ey, ez, rng, (u + size[0] / 4.1, v), cell),
        slab(f"{name} right", low + ex, ey, ez, rng, (u + (size[0] + size[1]) / 4.1, v), cell),
    ]


@dataclass(frozen=True, slots=True, kw_only=True)
class Target:
    """A card of 90 mm with a point in its centre."""

    id: str
    code: int
    centre: Array
    normal: Array

    def sheet(self) -> Sheet:
        """The card as a surface."""
        right = np.cross([0, 0, 1.0], self.normal)
        right /= np.linalg.norm(right)
        up = np.cross(self.normal, right)
        s, t = np.meshgrid([-0.045, 0.045], [-0.045, 0.045])
        xyz = self.centre + s[..., None] * right + t[..., None] * up
        return Sheet(name=self.id, xyz=xyz, uv=np.stack([s, t], axis=2) / 0.09 + 0.5, texture=self.id)


def targets() -> list[Target]:
    """The two ends of the scale bar and eight targets on the object."""
    places = [
        (-1.95, -0.16, 0.62, 0.1), (1.93, -0.16, 0.60, -0.1), (-1.88, -0.10, 2.52, 0.0), (1.90, -0.10, 2.50, 0.0),
        (-0.66, -0.09, 2.58, 0.0), (0.68, -0.09, 2.56, 0.0), (-0.62, -0.09, 1.15, 0.15), (0.63, -0.09, 1.18, -0.15),
    ]  # fmt: skip
    codes = [0x0B1, 0x0E5, 0x133, 0x15B, 0x1A7, 0x1D9, 0x2B7, 0x36D, 0x05F, 0x197]
    found = []
    for k, (x, y, z, turn) in enumerate(places):
        normal = np.array([math.sin(turn), -math.cos(turn), 0.0])
        found.append(Target(id=f"T{k + 1}", code=codes[k], centre=np.array([x, y, z]), normal=normal))
    for id_, end, code in zip(("A", "B"), BAR, codes[8:], strict=True):
        found.append(Target(id=id_, code=code, centre=end, normal=np.array([0.0, -1.0, 0.12]) / math.hypot(1, 0.12)))
    return found


def sheets(rng: np.random.Generator, cell: float, reliefs: Sequence[Moved] = ()) -> list[Sheet]:
    """The whole object; `cell` [m] is the width of a facet."""
    parts = [facade(rng, cell, reliefs)]
    parts += [column("column 1", -1.08, rng, (0.02, 0.02), cell), column("column 2", 1.08, rng, (0.26, 0.02), cell)]
    parts.append(figure(rng, cell / 1.5))
    for k, x in enumerate((-1.08, 1.08)):
        low, high = np.array([x - 0.23, -0.50, 0.0]), np.array([x + 0.23, -0.02, 0.50])
        parts += box(f"pedestal {k}", low, high, rng, (0.74, 0.02 + 0.13 * k), cell)
    for k in range(3):
        low = np.array([-0.80 + 0.04 * k, -1.15 + 0.27 * k, 0.0])
        high = np.array([0.80 - 0.04 * k, -0.02, 0.14 * (k + 1)])
        parts += box(f"step {k}", low, high, rng, (0.01, 0.62 + 0.12 * k), cell)
    corner, along, away = np.array([-2.6, -2.9, 0.0]), np.array([5.2, 0, 0]), np.array([0, 2.9, 0])
    ground = slab("ground", corner, along, away, rng, (0, 0), 0.012, 0.004)
    parts.append(Sheet(name="ground", xyz=ground.xyz, uv=ground.uv * 4.1 / np.array([5.2, 2.9]), texture="ground"))
    parts += bar_sheets(rng)
    return parts + [t.sheet() for t in targets()]


def bar_sheets(rng: np.random.Generator) -> list[Sheet]:
    """The rod behind the two scale bar targets, and its two feet."""
    a, b = BAR
    along = (b - a) / np.linalg.norm(b - a)
    start, end = a - 0.07 * along, b + 0.07 * along
    down, back = np.array([0, 0, 1.0]), np.array([0, 0.012, 0])
    parts = [slab("rod", start + back - 0.02 * down, end - start, 0.04 * down, rng, (0.05, 0.97), 0.02)]
    for k, share in enumerate((0.2, 0.8)):
        foot = start + share * (end - start) + back + np.array([0, 0.004, 0])
        low = np.array([foot[0] - 0.02, foot[1], 0.28])
        up = np.array([0, 0, foot[2] - low[2]])
        parts.append(slab(f"foot {k}", low, np.array([0.04, 0, 0]), up, rng, (0.9, 0.9), 0.02))
    return parts


# ---- cameras


def network(rng: np.random.Generator) -> list[tuple[str, Array, Array, int]]:
    """Name, projection centre, rotation (object to image axes) and EXIF orientation of each photograph."""
    plan: list[tuple[tuple[float, float, float], tuple[float, float, float], float]] = [
        ((-2.6, -2.75, 1.62), (-0.15, -0.1, 1.55), 0), ((-1.45, -3.35, 1.70), (-0.15, -0.1, 1.60), 0),
        ((0.05, -3.70, 1.66), (0.0, -0.1, 1.62), 0), ((1.40, -3.40, 1.74), (0.1, -0.1, 1.60), 0),
        ((2.65, -2.70, 1.60), (0.15, -0.1, 1.55), 0), ((-0.85, -2.95, 2.65), (-0.1, -0.1, 1.55), 0),
        ((0.95, -2.90, 2.70), (0.1, -0.1, 1.50), 0), ((0.60, -3.10, 0.75), (0.05, -0.1, 1.65), 0),
        ((-0.95, -1.95, 1.50), (-0.25, 0.0, 1.55), 0), ((0.05, -2.15, 1.85), (0.0, 0.0, 1.65), 0),
        ((1.05, -1.90, 1.45), (0.25, 0.0, 1.60), 0), ((-0.35, -2.30, 1.15), (-0.1, 0.0, 1.95), 0),
        ((-0.75, -3.15, 1.55), (-0.2, -0.1, 1.60), 90), ((0.80, -3.05, 1.90), (0.15, -0.1, 1.65), -90),
    ]  # fmt: skip
    images = []
    for k, (place, aim, roll) in enumerate(plan):
        centre = np.array(place) + 0.05 * rng.standard_normal(3)
        view = np.array(aim) + 0.05 * rng.standard_normal(3) - centre
        view /= np.linalg.norm(view)
        right = np.cross(view, [0, 0, 1.0])
        right /= np.linalg.norm(right)
        up = np.cross(right, view)
        angle = math.radians(roll + 2.0 * rng.standard_normal())
        x, y = math.cos(angle) * right + math.sin(angle) * up, -math.sin(angle) * right + math.cos(angle) * up
        images.append((f"portal_{k + 1:02d}", centre, np.stack([x, y, -view]), {0: 1, 90: 8, -90: 6}[roll]))
    return images


def true_camera(width: int, height: int) -> Camera:
    """The camera as it is; the metadata say 24.0 mm."""
    values = {**dict.fromkeys(sensor_models["brown"].symbols, 0.0), **TRUE}
    pixel = SENSOR_MM[0] / width
    return Camera(
        id="virtual-24-24mm", model="brown", width_px=width, height_px=height, pixel_mm=(pixel, pixel), values=values
    )


def directions(camera: Camera, rotation: Array, xy_px: Array) -> Array:
    """Unit directions (n, 3) in object space of points (n, 2) in the pixel frame: Brown's condition read as a ray."""
    v = camera.values
    x, y = (camera.image_from_pixel(xy_px) - [v["x0"], v["y0"]]).T
    r2 = x * x + y * y
    radial = r2 * (v["K1"] + r2 * (v["K2"] + r2 * v["K3"]))
    dx = x * radial + v["P1"] * (r2 + 2 * x * x) + 2 * v["P2"] * x * y
    dy = y * radial + v["P2"] * (r2 + 2 * y * y) + 2 * v["P1"] * x * y
    d = np.stack([x + dx, y + dy, np.full_like(x, -v["c"])], axis=1)
    return (d / np.linalg.norm(d, axis=1, keepdims=True)) @ rotation


def projected(camera: Camera, centre: Array, rotation: Array, xyz: Array) -> tuple[Array, Array]:
    """Pixel frame (n, 2) of object points, NaN where they are not in the picture, and a mask of those that are."""
    local = (xyz - centre) @ rotation.T
    xy = np.full((len(xyz), 2), np.nan)
    values = np.array([camera.values[s] for s in sensor_models["brown"].symbols])
    ahead = (local[:, 2] < -0.1) & (np.abs(local[:, :2]).max(axis=1) < -1.0 * local[:, 2])
    xy[ahead] = camera.pixel_from_image(sensor_models["brown"].project(local[ahead].T, values)[0].T)
    with np.errstate(invalid="ignore"):
        inside = ((xy > 4) & (xy < [camera.width_px - 4, camera.height_px - 4])).all(axis=1)
    return xy, inside
