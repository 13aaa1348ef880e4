"""A wavy ground that cameras of all kinds look down on: rendered exactly, small enough for tests of seconds."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.block import Block, Camera, Images, Observations, Points
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.platforms import sensor_models
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.depths.refine import PixelGrid, Source
from raybundle.surfaces.depths.transfer import transfer
from tests.matching.scenes import Texture

WIDTH, HEIGHT, PIXEL_MM = 160, 120, 0.02
HEIGHT_M, BASE_M, RANGE = 10.0, 2.0, (1 / 12, 1 / 8)
VALUES = {
    "brown": {"c": 5.0, "x0": 0.05, "K1": -2e-3, "P1": 2e-4},
    "fisheye": {"c": 4.0, "y0": -0.03, "K1": -1e-3},
    "panorama": {"c": 5.0},
    "brown_rolling": {"c": 5.0, "K1": -2e-3, "r": 1e-2, "vx": 2.0, "wz": 0.5},
    "brown_mounted": {"c": 5.0},
    "pushbroom": {"c": 5.0, "vy": 2.0},
}
"""By model; of a pushbroom the sources look back and ahead."""


def surface(x, y):
    """Heights [m]."""
    return 0.15 * np.sin(x / 1.5) * np.cos(y / 1.7)


@dataclass
class Scene:
    """Photographs of the ground, the first of which is the reference, with the true depth parameter of its pixels."""

    block: Block
    grey: list
    t: np.ndarray
    slopes: np.ndarray
    rays: ReferenceRays
    sources: list

    def grid(self, stride=1, margin=6):
        return PixelGrid.over(self.grey[0], stride, margin)

    def start(self, grid, noise_px=0.0, seed=3):
        """(3, rows, columns) with the true slopes."""
        t = grid.of(self.t)
        off = noise_px / self.reach() * np.random.default_rng(seed).standard_normal(t.shape)
        return np.stack([t + off, grid.of(self.slopes[0]), grid.of(self.slopes[1])]).astype(np.float32)

    def reach(self):
        """Pixels in the most sensitive source for a unit of t, in the middle."""
        at, t = np.array([[WIDTH / 2, HEIGHT / 2]]), np.array([1 / HEIGHT_M])
        return max(
            np.linalg.norm(s.transfer.at(at, t + 1e-4) - s.transfer.at(at, t - 1e-4)) / 2e-4 for s in self.sources
        )


def blocks(model, places=((0, 0), (-1, 0.1), (1, -0.1), (0.1, 1), (0, -1))):
    """Cameras of a model above the ground; the turn about the vertical differs."""
    values, n = VALUES[model], len(places)
    kind = sensor_models[model]
    camera = Camera(
        id="1", model=model, width_px=WIDTH, height_px=HEIGHT, pixel_mm=(PIXEL_MM, PIXEL_MM),
        values={p.symbol: values.get(p.symbol, p.default) for p in kind.parameters},
    )  # fmt: skip
    centre = np.array([[BASE_M * x, BASE_M * y, HEIGHT_M] for x, y in places])
    turn = np.array([[0.02 * k, -0.015 * k, 0.2 * k] for k in range(n)])
    interior = {}
    if model == "pushbroom":
        turn, centre = turn * [0, 0, 0.1], centre * [0.2, 0, 1]
        interior = {k: {**camera.values, "y0": (0.0, 0.8, -0.8, 1.0, -1.0)[k]} for k in range(n)}
        centre[:, 1] = [-2.0 * interior[k]["y0"] for k in range(n)]
    rotation = rotation_from_angles(turn)
    return Block(
        cameras=(camera,),
        images=Images(
            ids=tuple(str(k) for k in range(n)), camera=np.zeros(n, np.int32), file=("",) * n, centre=centre,
            rotation=rotation, interior=interior,
        ),
        observations=Observations.empty(),
        points=Points.empty(),
    )  # fmt: skip


def ground_of(origin, direction):
    """Factors (n,) of the directions at which rays meet the ground."""
    s = -origin[:, 2] / direction[:, 2]
    for _ in range(30):
        x = origin + s[:, None] * direction
        s = s + (surface(x[:, 0], x[:, 1]) - x[:, 2]) / direction[:, 2]
    return s


def pixels(width=WIDTH, height=HEIGHT):
    x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    return np.stack([x.ravel(), y.ravel()], axis=1)


def scene(model="brown", contrast=20.0, seed=1):
    """Grey values of mean 120, textures of 4 to 20 pixels."""
    block = blocks(model)
    texture = Texture(seed, shortest=4.0, longest=20.0)
    grey = []
    for k in range(len(block.images)):
        origin, direction = ReferenceRays.of(block, k).rays(pixels())
        x = origin + ground_of(origin, direction)[:, None] * direction
        value = 120 + contrast * texture.at(x[:, :2] / (HEIGHT_M / 5.0 * PIXEL_MM))
        grey.append(value.reshape(HEIGHT, WIDTH).astype(np.float32))
    rays = ReferenceRays.of(block, 0)
    origin, direction = rays.rays(pixels())
    t = (1 / ground_of(origin, direction)).reshape(HEIGHT, WIDTH)
    sources = [Source(grey=grey[k], transfer=transfer(block, rays, k, RANGE)) for k in range(1, len(grey))]
    gy, gx = np.gradient(t)
    return Scene(block=block, grey=grey, t=t, slopes=np.stack([gx, gy]), rays=rays, sources=sources)
