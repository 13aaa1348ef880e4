"""Images of a flat specimen with known displacements at every place."""

import numpy as np

from raybundle.matching.spline_pictures import Picture
from raybundle.matching.subsets import SubsetGrid, follow, window_options
from tests.matching.scenes import Texture

WIDTH, HEIGHT = 340, 300
MIDDLE = np.array([WIDTH, HEIGHT]) / 2
TEXTURE = Texture(3, waves=60, shortest=6.0, longest=30.0)


def motion(rotation_deg=0.0, strain=(0.0, 0.0, 0.0), shift=(0.0, 0.0)):
    """F (2, 2) and shift (2,): rotation of a body that is stretched by xx, yy, xy."""
    a = np.radians(rotation_deg)
    R = np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])
    xx, yy, xy = strain
    return R @ np.array([[1 + xx, xy], [xy, 1 + yy]]), np.array(shift)


def moved(xy, F, shift):
    return MIDDLE + shift + (xy - MIDDLE) @ F.T


def image(seed, source=None, *, noise=2.0, level=120.0, contrast=35.0):
    """8 bit with white noise; `source` brings the pixel frame to the texture."""
    x, y = np.meshgrid(np.arange(WIDTH) + 0.5, np.arange(HEIGHT) + 0.5)
    xy = np.stack([x, y], axis=-1)
    grey = level + contrast * TEXTURE.at(xy if source is None else source(xy))
    return np.clip(np.round(grey + np.random.default_rng(seed).normal(0, noise, grey.shape)), 0, 255).astype(np.uint8)


def deformed(seed, F, shift, **light):
    return image(seed, lambda xy: MIDDLE + (xy - MIDDLE - shift) @ np.linalg.inv(F).T, **light)


def found(reference, target, *, step=10, half=10, quadratic=False):
    """The grid and its subsets in the target."""
    grid = SubsetGrid.of(np.ones(reference.shape, bool), step, half)
    window = window_options(half, quadratic=quadratic)
    return grid, follow(Picture.of(reference, 1), Picture.of(target, 2), grid, window)
