"""Random fields with a given spectrum."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import fft, ndimage


def power_law(
    shape: tuple[int, int], cell: float, longest: float, shortest: float, exponent: float, rng: np.random.Generator
) -> NDArray[np.float32]:
    """A Gaussian field of mean 0 and standard deviation 1 whose amplitudes fall as frequency^-exponent.

    shape               nodes of the grid
    cell                distance of nodes
    longest, shortest   wavelengths between which it has power, in the unit of `cell`
    """
    size = tuple(int(fft.next_fast_len(n, real=True) or n) for n in shape)
    noise = rng.standard_normal(size, dtype=np.float32)
    spectrum = np.asarray(fft.rfft2(noise))
    del noise
    fy = fft.fftfreq(size[0], cell).astype(np.float32)[:, None]
    fx = fft.rfftfreq(size[1], cell).astype(np.float32)[None, :]
    for i in range(0, size[0], 512):  # row by row: a filter of the whole plane would double the memory
        f = np.hypot(fy[i : i + 512], fx)
        f = np.maximum(f, 1e-9, out=f)
        gain = f**-exponent * np.exp(-((shortest * f) ** 4)) * (1 - np.exp(-((longest * f) ** 4)))
        spectrum[i : i + 512] *= gain
    field = np.asarray(fft.irfft2(spectrum, s=size, overwrite_x=True))[: shape[0], : shape[1]]
    field -= field.mean()
    field /= field.std()
    return np.ascontiguousarray(field, dtype=np.float32)


def enlarged(coarse: NDArray[np.float32], factor: int, shape: tuple[int, int]) -> NDArray[np.float32]:
    """A coarse grid of nodes by cubic splines on a grid `factor` times as fine, from the same first node."""
    size = tuple((n - 1) * factor + 1 for n in coarse.shape)
    ratio = [m / n for m, n in zip(size, coarse.shape, strict=True)]
    fine = np.asarray(ndimage.zoom(coarse, ratio, order=3, mode="nearest", output=np.float32), dtype=np.float32)
    if fine.shape != size:
        raise ValueError(f"A grid of {coarse.shape} gives {fine.shape} nodes, not {size}.")
    return fine[: shape[0], : shape[1]]


def coarse_nodes(shape: tuple[int, int], factor: int) -> tuple[int, int]:
    """Nodes of a grid `factor` times as coarse that covers one of `shape`."""
    return (shape[0] - 2) // factor + 2, (shape[1] - 2) // factor + 2
