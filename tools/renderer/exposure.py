"""The light that reaches the pixels of a photograph, integrated over each pixel."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr

from .camera import Photograph
from .height_field import BLOCK

Array = NDArray[np.float64]
Seen = Callable[[Array, Array], NDArray[np.float32]]
"""Light (3, m, n) that comes along rays: origins (m, n, 3), directions (m, n, 3)."""
SAMPLES = 3
"""Rays of a pixel, along x and along y."""
MARGIN = BLOCK // SAMPLES
"""Pixels beyond the format that are looked at too, for the blur."""


def kernel(blur_px: float, samples: int = SAMPLES) -> NDArray[np.float32]:
    """Weights of samples around a pixel's centre: its square, blurred by a Gaussian of standard deviation `blur_px`."""
    reach = min(int(np.ceil((0.5 + 3.5 * blur_px) * samples)), MARGIN * samples - samples)
    at = (np.arange(-reach, reach + 1) + (0 if samples % 2 else 0.5)) / samples
    width = max(blur_px, 1e-9)
    weight = ndtr((at + 0.5) / width) - ndtr((at - 0.5) / width)
    return (weight / weight.sum()).astype(np.float32)


def exposed(photograph: Photograph, seen: Seen, blur_px: float = 0.45, samples: int = SAMPLES) -> NDArray[np.float32]:
    """Linear light (3, height, width) of a photograph, with the fall-off of its lens.

    Rays stand at the centres of samples^2 equal parts of each pixel; `samples` is odd and divides BLOCK.
    """
    camera = photograph.camera
    weights = kernel(blur_px, samples)
    margin = BLOCK // samples
    columns = -(-camera.width_px // margin) * margin + 2 * margin
    rows = -(-camera.height_px // margin) * margin + 2 * margin
    x = (np.arange(columns * samples) + 0.5) / samples - margin
    part = np.empty((3, rows * samples, camera.width_px), dtype=np.float32)
    for first in range(0, rows * samples, BLOCK):
        y = (np.arange(first, first + BLOCK) + 0.5) / samples - margin
        origins, directions = photograph.rays(x[None, :], y[:, None])
        light = seen(origins, directions)
        part[:, first : first + BLOCK] = _filtered(light, weights, samples, margin, camera.width_px)
    light = _filtered(part.swapaxes(1, 2), weights, samples, margin, camera.height_px).swapaxes(1, 2)
    x = np.arange(camera.width_px, dtype=float) + 0.5
    y = np.arange(camera.height_px, dtype=float) + 0.5
    return light * camera.light(x[None, :], y[:, None]).astype(np.float32)


def _filtered(
    light: NDArray[np.float32], weights: NDArray[np.float32], samples: int, margin: int, count: int
) -> NDArray[np.float32]:
    """Samples along the last axis, weighted around the centre of each of `count` pixels."""
    reach = len(weights) // 2
    start = margin * samples + samples // 2 - reach
    out = np.zeros((*light.shape[:-1], count), dtype=np.float32)
    for k, weight in enumerate(weights):
        out += weight * light[..., start + k : start + k + samples * count : samples][..., :count]
    return out
