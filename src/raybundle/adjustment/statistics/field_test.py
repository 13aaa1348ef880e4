"""The test of each image's field alone (Rao 1948): what its residuals show of an interior orientation of its own."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.records.severity import POOR_FIT
from raybundle.adjustment.statistics.fields import COLUMNS, NEGLIGIBLE, TERMS
from raybundle.numerics.arrays import Array

DEGREE = np.repeat([a + b for a, b in TERMS], 2)
"""Of the product of each coefficient, by which it is divided (`fields.field_shapes`)."""


@dataclass(frozen=True, slots=True, kw_only=True)
class OwnField:
    """What the residuals of one image show of a field of its own."""

    image: int
    square: float
    """T = s' M^+ s / s0^2: sum of the squares of its independent scores"""
    directions: int
    """k, their number"""
    rms_px: float
    """of the displacement over the format, by one step from none, in directions that are reported"""


def own_fields(images: Array, M: Array, scores: Array, variance: float) -> list[OwnField]:
    """The score test (Rao 1948) of each image's field alone, all others none.

    images    (f,) whose fields these are
    M         (10 f, 10 f) what is left of their normal matrix; scores (10 f,), see `fields.independent_scores`
    variance  sigma0^2
    """
    found: list[OwnField] = []
    for k, image in enumerate(images.tolist()):
        at = slice(COLUMNS * k, COLUMNS * (k + 1))
        values, vectors = np.linalg.eigh((M[at, at] + M[at, at].T) / 2)
        kept = values > max(NEGLIGIBLE * values[-1], 0.0)
        values, vectors = values[kept], vectors[:, kept]
        y = vectors.T @ scores[at] / np.sqrt(values * variance)
        poor = y**2 > POOR_FIT**2
        b = vectors[:, poor] @ (y[poor] * np.sqrt(variance / values[poor]))
        rms = float(np.sqrt(np.sum((b / DEGREE) ** 2)))
        found.append(OwnField(image=image, square=float(y @ y), directions=len(y), rms_px=rms))
    return found
