"""Calibrations that are known with their covariance, as observations of all parameters together."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np

from raybundle.block.block import Camera, Relation
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array

ROUNDED = 1e-6
"""Of a variance: what six digits of the correlations in a file may lose; a little more uncertainty, never less."""


def observed_jointly(camera: Camera, free: tuple[str, ...], covariance: Array) -> Camera:
    """The camera with its values observed as a calibration gave them, and free to move within its covariance.

    free        symbols that the calibration estimated; the others stay held
    covariance  (u, u) of `free`, positive definite
    With C = L L', the rows of L^-1 p are u independent observations with standard deviation 1: relation k is what the
    calibration says of its k-th parameter beside those before.  What it does not tell: whether zoom, focus or
    stabilisation have moved since; the residuals of these observations do.
    """
    if not free:
        return replace(camera, estimate=(), sigma={}, relations=())
    size = np.sqrt(np.abs(np.diag(covariance)))
    root = _inverse_root(covariance / np.outer(size, size)) / size
    if not np.isfinite(root).all():
        raise InputError(f"camera {camera.id}: the covariance of its calibration is not positive definite")
    values = np.array([camera.values[s] for s in free])
    relations = tuple(
        Relation(
            name=f"calibration: {symbol}",
            origin="calibration",
            terms={s: float(f) for s, f in zip(free[: k + 1], root[k], strict=False)},
            sigma=1.0,
            observed=float(root[k] @ values),
        )
        for k, symbol in enumerate(free)
    )
    return replace(camera, estimate=free, sigma={}, relations=relations)


def _inverse_root(correlation: Array) -> Array:
    """L^-1 of a correlation matrix L L'; NaN where it is none, also after what rounding may have taken is put back."""
    for lost in (0.0, ROUNDED):
        try:
            return np.linalg.inv(np.linalg.cholesky(correlation + lost * np.eye(len(correlation))))
        except np.linalg.LinAlgError:
            continue
    return np.full_like(correlation, np.nan)


def is_observed_jointly(camera: Camera) -> bool:
    """Whether a calibration with its covariance was given for the camera."""
    return any(r.origin == "calibration" for r in camera.relations)


def joint_covariance(camera: Camera) -> tuple[tuple[str, ...], Array | None]:
    """Symbols and covariance (u, u) of the calibration by which a camera is observed; (), None where there is none."""
    mine = [r for r in camera.relations if r.origin == "calibration"]
    told = [set[str](), *(set(r.terms) for r in mine)]
    if not mine or not all(a < b and len(b) == len(a) + 1 for a, b in pairwise(told)):
        return (), None
    free = tuple((b - a).pop() for a, b in pairwise(told))
    root = np.array([[r.terms.get(s, 0.0) / r.sigma for s in free] for r in mine])
    inverse = np.linalg.inv(root)
    return free, inverse @ inverse.T
