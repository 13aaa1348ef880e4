"""Rational polynomials made from any model that finds the ground point of an image point at a height.

The coefficients of a ratio of cubics are nearly dependent: fitted without restraint they follow the nodes and may
run away by hundreds of pixels between them.  Here they are drawn towards zero (Tikhonov), as strongly as makes
the misfit at points between the nodes smallest (Tao and Hu 2001 choose by eye what is chosen here by these points),
and the misfit that is reported is that at a third set of points.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError, NotSolvable
from raybundle.numerics.arrays import Array
from raybundle.scenes.bias import BiasKind
from raybundle.scenes.rpc import Rpc, correct_image, fill_terms

Localise = Callable[[Array, Array], Array]
"""Longitude, latitude, height (n, 3) of image points (n, 2) [px] at heights (n,) [m]."""
GRID = (15, 15, 5)
"""Nodes along x, y and height."""
STRENGTHS = (0.0, *(10.0**k for k in range(-14, -5)))
"""Weights of the restraint that are tried; the first is none."""
TOLERATED = 1.05
"""The strongest restraint is taken whose misfit is at most so many times the smallest."""
LEAST_DENOMINATOR = 0.1
"""Of a fitted denominator over the whole range, whose value at the centre is 1."""
CHECK_POINTS = 4000
MISFIT_PX = 20.0
"""Misfit above which an RPC stands for nothing."""
POLAR_DEG = 89.0
"""Latitude from which on a failure is put down to the pole."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RpcFit:
    """An RPC and how well it stands for its model; not how well the model is known."""

    rpc: Rpc
    strength: float
    """Weight of the restraint."""
    rms_px: Array
    """(2,) x, y at `points` points that took no part in the fit."""
    largest_px: Array
    """(2,) largest deviation there, x, y."""
    points: int
    height_range: tuple[float, float]


def fit_rpc(
    localise: Localise, size_px: tuple[int, int], height_range: tuple[float, float], *, seed: int = 1
) -> RpcFit:
    """The RPC that stands for a model within an image and a range of heights.

    size_px       width and height of the image
    height_range  lowest and highest ellipsoidal height [m]; the RPC holds there and little beyond
    raises        InputError for an empty range; NotSolvable where every denominator found has a zero in the range, or
                  where the best misfit is above `MISFIT_PX`, as at a pole
    """
    low, high = height_range
    if not (np.isfinite([low, high]).all() and high - low >= 1):
        raise InputError("rpc.height_range", low_m=low, high_m=high)
    size = np.array(size_px, float)
    nodes = _nodes(size, low, high)
    rng = np.random.default_rng(seed)
    between, apart = (rng.uniform([0, 0, low], [*size, high], (CHECK_POINTS, 3)) for _ in range(2))
    ground, chosen, checked = (_unwrapped(localise(p[:, :2], p[:, 2])) for p in (nodes, between, apart))
    frame = _Frame.of(ground, size)
    found: list[tuple[float, float, Rpc]] = []
    for strength in STRENGTHS:
        rpc = frame.rpc(ground, nodes[:, :2], strength)
        if _denominators_hold(rpc):
            miss = float(np.abs(rpc.project(chosen) - between[:, :2]).max())
            found.append((miss, strength, rpc))
    if not found:
        raise NotSolvable("rpc.no_fit")
    smallest = min(miss for miss, _, _ in found)
    if smallest > MISFIT_PX:
        lat = float(np.abs(ground[:, 1]).max())
        raise NotSolvable(
            "rpc.inaccurate_fit", misfit_px=smallest, limit_px=MISFIT_PX, latitude_deg=lat, polar=lat > POLAR_DEG
        )
    _, strength, rpc = next(f for f in reversed(found) if f[0] <= TOLERATED * smallest)
    deviation = rpc.project(checked) - apart[:, :2]
    return RpcFit(
        rpc=rpc,
        strength=strength,
        rms_px=np.sqrt(np.mean(deviation**2, axis=0)),
        largest_px=np.abs(deviation).max(axis=0),
        points=len(apart),
        height_range=(float(low), float(high)),
    )


def corrected_rpc(
    rpc: Rpc, kind: BiasKind, bias: Array, size_px: tuple[int, int], height_range: tuple[float, float]
) -> tuple[Rpc, RpcFit | None]:
    """The RPC with a bias built in: a shift exactly, in the offsets; drift and affine by a new fit, also returned."""
    if kind == "none":
        return rpc, None
    if kind == "shift":
        return rpc.shifted(np.asarray(bias, float)), None
    fit = fit_rpc(lambda xy, h: rpc.localise(correct_image(rpc, xy, kind, bias), h), size_px, height_range)
    return fit.rpc, fit


def _nodes(size: Array, low: float, high: float) -> Array:
    """Grid points (n, 3) x, y, height; denser to the borders, where polynomials run away (Chebyshev)."""
    axes = [(1 - np.cos(np.linspace(0, np.pi, n))) / 2 for n in GRID]
    unit = np.stack([a.ravel() for a in np.meshgrid(*axes, indexing="ij")], axis=1)
    return unit * [*size, high - low] + [0, 0, low]


def _unwrapped(geographic: Array) -> Array:
    """Longitudes without the step at 180 degrees."""
    result = geographic.copy()
    result[:, 0] -= 360 * np.round((result[:, 0] - result[0, 0]) / 360)
    return result


@dataclass(frozen=True, slots=True, kw_only=True)
class _Frame:
    """Offsets and scales of the RPC that is to be fitted."""

    ground_offset: Array
    ground_scale: Array
    image_offset: Array
    image_scale: Array

    @staticmethod
    def of(ground: Array, size: Array) -> _Frame:
        low, high = ground.min(axis=0), ground.max(axis=0)
        return _Frame(
            ground_offset=_short((low + high) / 2), ground_scale=_short((high - low) / 2), image_offset=size / 2,
            image_scale=size / 2,
        )  # fmt: skip

    def rpc(self, ground: Array, xy: Array, strength: float) -> Rpc:
        """Fitted coefficients, by linear least squares whose weights follow the denominators."""
        normalised = (ground - self.ground_offset) / self.ground_scale
        T = fill_terms(normalised.T, np.empty((20, len(ground)))).T
        uv = (xy - self.image_offset) / self.image_scale
        coefficients = np.concatenate([_ratio(T, uv[:, axis], strength) for axis in (1, 0)])
        return Rpc(
            coefficients=coefficients,
            ground_offset=self.ground_offset,
            ground_scale=self.ground_scale,
            image_offset=self.image_offset,
            image_scale=self.image_scale,
        )


def _short(values: Array) -> Array:
    """Numbers of 12 digits: programs that keep 15 of a file (GDAL) lose nothing of them."""
    return np.array([float(f"{v:.12g}") for v in values])


def _ratio(T: Array, value: Array, strength: float) -> Array:
    """(2, 20) numerator and denominator with T num = value (T den), den[0] = 1, drawn towards zero."""
    design = np.concatenate([T, -value[:, None] * T[:, 1:]], axis=1)
    restraint = np.sqrt(strength * len(T)) * np.eye(39)
    denominator = np.ones(len(T))
    x = np.zeros(39)
    for _ in range(4):
        w = 1 / denominator
        R = triangle(np.column_stack([design, value]) * w[:, None])
        A, b = np.concatenate([R[:, :39], restraint]), np.concatenate([R[:, 39], np.zeros(39)])
        x = np.linalg.lstsq(A, b, rcond=1e-15)[0]
        new = 1 + np.einsum("ij,j->i", T[:, 1:], x[20:])  # no BLAS, which would divide it among threads
        if (new < LEAST_DENOMINATOR).any():
            break  # the caller finds the zero
        denominator = new
    return np.stack([x[:20], np.concatenate([[1.0], x[20:]])])


BLOCK_ROWS = 128
"""Rows of a block in `triangle`.  OpenBLAS divides products with a vector from 9216 elements on: 230 rows of 40."""


def triangle(A: Array) -> Array:
    """R (k, k) of the QR decomposition of a tall matrix (m, k), by blocks of rows and then of their triangles.

    As stable as the decomposition in one piece (Demmel et al. 2012), and without threads that wait for each other.
    """
    k = A.shape[1]
    while len(A) > BLOCK_ROWS:
        blocks = -(-len(A) // BLOCK_ROWS)
        padded = np.zeros((blocks * BLOCK_ROWS, k))
        padded[: len(A)] = A
        A = np.asarray(np.linalg.qr(padded.reshape(blocks, BLOCK_ROWS, k), mode="r")).reshape(-1, k)
    return np.asarray(np.linalg.qr(A, mode="r"))


def _denominators_hold(rpc: Rpc) -> bool:
    """Whether both denominators stay away from zero over the whole range."""
    steps = np.linspace(-1, 1, 21)
    cube = np.stack([a.ravel() for a in np.meshgrid(steps, steps, steps, indexing="ij")])
    values = rpc.coefficients[[1, 3]] @ fill_terms(cube, np.empty((20, cube.shape[1])))
    return bool((values > LEAST_DENOMINATOR).all())
