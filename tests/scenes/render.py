"""A made-up terrain with texture, rendered through RPCs into 16-bit images and through cameras into photographs."""

from __future__ import annotations

import functools
from dataclasses import dataclass, replace

import cv2
import numpy as np
from PIL import Image
from scipy.interpolate import CubicSpline

from raybundle.io.scenes.rpc_text import write_rpc_text
from raybundle.numerics.places import Local
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.scenes.rpc import Rpc
from raybundle.scenes.rpc_fit import fit_rpc
from raybundle.scenes.simulate import OrbitPlan, orbit_scene

ORIGIN = (15.0, 48.0, 300.0)
PLACE = Local(origin=ORIGIN)
HEIGHTS = (100.0, 500.0)
"""Range of the RPCs [m]; the terrain stands within 220 to 380 m."""
GRID_PX = 30


@dataclass(frozen=True)
class Terrain:
    """Heights and grey values on a square grid of the local frame, `cell` metres apart."""

    height: np.ndarray
    grey: np.ndarray
    cell: float
    half: float

    @classmethod
    def made(cls, seed=3, half=1150.0, cell=1.0, relief=75.0):
        """Octaves of noise: relief of +-75 m, texture of all sizes above 3 m."""
        n = int(2 * half / cell) + 1
        rng = np.random.default_rng(seed)
        height, grey = np.zeros((n, n), np.float32), np.zeros((n, n), np.float32)
        for size in (900.0, 450.0, 220.0):
            height += octave(rng, n, size / cell) * size
        height *= relief / np.abs(height).max()
        for size, weight in ((400.0, 0.4), (90.0, 0.6), (30.0, 1.0), (12.0, 1.0), (5.0, 0.9)):
            grey += weight * octave(rng, n, size / cell)
        return cls(height, grey / grey.std(), cell, half)

    def at(self, layer, x, y):
        """Values of a layer at local x, y, float32 arrays of one shape."""
        column = ((x + self.half) / self.cell).astype(np.float32)
        row = ((y + self.half) / self.cell).astype(np.float32)
        return cv2.remap(layer, column, row, cv2.INTER_CUBIC, borderMode=cv2.BORDER_REFLECT)

    def points(self, x, y):
        """Points (n, 3) of the surface."""
        x, y = np.asarray(x, float), np.asarray(y, float)
        z = self.at(self.height, x[None].astype(np.float32), y[None].astype(np.float32))[0]
        return np.column_stack([x, y, z.astype(float)])


def octave(rng, n, size):
    """Smooth noise of one size of feature [cells], about -1 to 1."""
    m = int(n / size) + 4
    small = rng.normal(0, 1, (m, m)).astype(np.float32)
    large = cv2.resize(small, (int(m * size) + 1, int(m * size) + 1), interpolation=cv2.INTER_CUBIC)
    shift = int(size)
    return large[shift : shift + n, shift : shift + n]


@functools.cache
def scene_rpc(pitch_deg, size_px=1500, roll_deg=0.5, err_bias_m=8.0) -> Rpc:
    """The RPC of a simulated scene whose middle shows the origin."""
    scene = orbit_scene(
        OrbitPlan(target=ORIGIN, pitch_deg=pitch_deg, roll_deg=roll_deg, width_px=size_px, height_px=size_px)
    )
    return replace(fit_rpc(scene.localise, (size_px, size_px), HEIGHTS).rpc, err_bias_m=err_bias_m, err_rand_m=0.3)


def scene_ground(rpc, size_px, terrain):
    """Local x, y (h, w) of the centre of every pixel, where its ray meets the terrain."""
    steps = np.arange(0, size_px + GRID_PX, GRID_PX)
    nodes = np.stack([a.ravel() for a in np.meshgrid(steps + 0.5, steps + 0.5)], axis=1)
    levels = [PLACE.block_from_geographic(rpc.localise(nodes, h)).reshape(len(steps), len(steps), 3) for h in HEIGHTS]
    spline = CubicSpline(steps, np.eye(len(steps)))(np.arange(size_px))
    low, high = (
        [np.float32(spline @ p[..., k] @ spline.T) for k in range(3)] for p in levels
    )  # fmt: skip
    t = np.full_like(low[0], 0.5)
    for _ in range(8):
        x, y = low[0] + t * (high[0] - low[0]), low[1] + t * (high[1] - low[1])
        t = (terrain.at(terrain.height, x, y) - low[2]) / (high[2] - low[2])
    return x, y


def render_scene(rpc, terrain, size_px=1500, seed=1):
    """A 16-bit image (h, w) of 11-bit grey values with noise."""
    grey = terrain.at(terrain.grey, *scene_ground(rpc, size_px, terrain))
    noise = np.random.default_rng(seed).normal(0, 3.0, grey.shape)
    return np.clip(600 + 160 * grey + noise, 1, 2047).astype(np.uint16)


def write_scene(folder, name, pixels, rpc, *, tag=False, **options):
    """NAME.tif, its RPC in the tag 50844 or in NAME_RPC.TXT."""
    path = folder / f"{name}.tif"
    info = {}
    if tag:
        info = {"tiffinfo": rpc_tag(rpc)}
    else:
        write_rpc_text(rpc, folder / f"{name}_RPC.TXT")
    Image.fromarray(pixels).save(path, **info, **options)
    return path


def rpc_tag(rpc):
    """A directory with the tag 50844."""
    from PIL.TiffImagePlugin import ImageFileDirectory_v2

    x, y = rpc.image_offset - 0.5
    lon, lat, h = rpc.ground_offset
    lon_s, lat_s, h_s = rpc.ground_scale
    scalars = [rpc.err_bias_m or -1, rpc.err_rand_m or -1, y, x, lat, lon, h, *rpc.image_scale[::-1], lat_s, lon_s, h_s]
    directory = ImageFileDirectory_v2()
    directory.tagtype[50844] = 12
    directory[50844] = tuple(float(v) for v in (*scalars, *rpc.coefficients.ravel()))
    return directory


@dataclass(frozen=True)
class View:
    """A pinhole photograph of the terrain."""

    centre: np.ndarray
    rotation: np.ndarray
    size: tuple[int, int] = (900, 700)
    c_px: float = 1000.0

    def pixels(self, terrain, seed):
        """(h, w) uint8."""
        w, h = self.size
        x, y = np.meshgrid(np.arange(w) + 0.5 - w / 2, np.arange(h) + 0.5 - h / 2)
        d = np.stack([x, -y, np.full_like(x, -self.c_px)], axis=-1) @ self.rotation
        ground = np.full((h, w), 0.0)
        for _ in range(15):
            scale = (ground - self.centre[2]) / d[..., 2]
            X, Y = (np.float32(self.centre[k] + scale * d[..., k]) for k in (0, 1))
            ground = terrain.at(terrain.height, X, Y)
        noise = np.random.default_rng(seed).normal(0, 1.0, (h, w))
        return np.clip(120 + 32 * terrain.at(terrain.grey, X, Y) + noise, 0, 255).astype(np.uint8)

    def project(self, xyz):
        """(n, 2) pixel frame."""
        U, V, W = self.rotation @ (xyz - self.centre).T
        return np.stack([self.size[0] / 2 - self.c_px * U / W, self.size[1] / 2 + self.c_px * V / W], axis=1)


def flight(count=6, height=1500.0, base=330.0, side=450.0, seed=4):
    """Photographs in two lines, nearly vertical."""
    rng = np.random.default_rng(seed)
    views = []
    for k in range(count):
        line, place = divmod(k, (count + 1) // 2)
        X = (place - (count // 2 - 1) / 2) * base
        Y = (line - 0.5) * side
        angles = np.radians(np.array([0, 0, 180 * line]) + rng.normal(0, 2.0, 3))
        views.append(View(np.array([X, Y, height + rng.normal(0, 15)]), rotation_from_angles(angles[None])[0]))
    return views


def write_photo(path, pixels):
    """A JPEG whose EXIF tells a focal length of 36 mm for film (1000 px of 1000 px)."""
    image = Image.fromarray(pixels)
    exif = Image.Exif()
    exif[271], exif[272] = "Made", "Up"
    details = exif.get_ifd(0x8769)
    details[0x920A], details[0xA405] = 10.0, 40
    image.save(path, quality=97, exif=exif)
    return path
