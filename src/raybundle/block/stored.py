"""Calibrations that are known with their covariance, as observations of all parameters together."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np

from raybundle.block.block import Camera
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.observations.parameter import Calibrated

ROUNDED = 1e-6
"""Of a variance: what six digits of the correlations in a file may lose; a little more uncertainty, never less."""


def observed_jointly(camera: Camera, free: tuple[str, ...], covariance: Array) -> Camera:
    """The camera with its values observed as a calibration gave them, and free to move within its covariance.

    free        symbols that the calibration estimated; the others stay held
    covariance  (u, u) of `free`, positive definite
    Limits: whether zoom, focus or stabilisation have moved since; the residuals of the observations do.
    """
    plain = replace(camera, estimate=free, sigma={}, relations=(), calibrated=None)
    if not free:
        return plain
    size = np.sqrt(np.abs(np.diag(covariance)))
    R, lost = _positive_definite(covariance / np.outer(size, size))
    if R is None:
        raise InputError("camera.covariance_not_positive", camera=camera.id)
    return replace(
        plain,
        calibrated=Calibrated(
            symbols=free,
            values=tuple(float(camera.values[s]) for s in free),
            sigma=tuple((size * np.sqrt(1 + lost)).tolist()),
            correlations=tuple((*row[:k].tolist(), 1.0) for k, row in enumerate(R)),
        ),
    )


def _positive_definite(correlation: Array) -> tuple[Array | None, float]:
    """Correlations, and the share of each variance that was put back as rounding may have taken it; None: neither."""
    for lost in (0.0, ROUNDED):
        widened = (correlation + lost * np.eye(len(correlation))) / (1 + lost)
        try:
            if np.isfinite(np.linalg.inv(np.linalg.cholesky(widened))).all():
                return widened, lost
        except np.linalg.LinAlgError:
            continue
    return None, 0.0


def is_observed_jointly(camera: Camera) -> bool:
    """Whether a calibration with its covariance was given for the camera."""
    return camera.calibrated is not None


def joint_covariance(camera: Camera) -> tuple[tuple[str, ...], Array | None]:
    """Symbols and covariance (u, u) of the calibration by which a camera is observed; (), None where there is none."""
    return ((), None) if camera.calibrated is None else (camera.calibrated.symbols, camera.calibrated.covariance)


def without_relations_of_calibration(camera: Camera) -> Camera:
    """The camera of a file written when the calibrated parameters p were observed as the rows of L^-1 p, C = L L'.

    Each row has one parameter more than the one before; where they do not, they stay observations like others.
    """
    mine = [r for r in camera.relations if r.origin == "calibration"]
    terms = [set[str](), *(set(r.terms) for r in mine)]
    if not mine or not all(a < b and len(b) == len(a) + 1 for a, b in pairwise(terms)):
        return camera
    free = tuple((b - a).pop() for a, b in pairwise(terms))
    inverse = np.linalg.inv(np.array([[r.terms.get(s, 0.0) / r.sigma for s in free] for r in mine]))
    given = inverse @ np.array([r.observed / r.sigma for r in mine])
    values = dict(camera.values) | dict(zip(free, given.tolist(), strict=True))
    known = observed_jointly(replace(camera, values=values), free, inverse @ inverse.T)
    others = tuple(r for r in camera.relations if r.origin != "calibration")
    return replace(camera, calibrated=known.calibrated, relations=others)
