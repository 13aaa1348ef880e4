"""Two measurements that each have a scale, or a frame, of their own: whether the points of both say the same of it.

The seven parameters of the similarity between them are estimated from common points with the joint covariances of both
(least squares, the datum of a free network left open) and tested (Koch 1999, section 4.2).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.metrology.point_set import PointSet, datum_directions
from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import fisher_tail, joint_test
from raybundle.numerics.transform import similarity

FEWEST = 3
"""Points that a similarity needs"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Between:
    """How the frame of another measurement lies in that of a first."""

    factor: float
    """Lengths of the other over those of the first"""
    sigma: float
    """Standard deviation of `factor`, all errors of both contained: bars or control, and photographs"""
    scale: tuple[float, float]
    """F of a factor of 1, and its probability"""
    shift: Array
    """(3,) of the middle of the points [m]"""
    turn: float
    """about it [rad]"""
    frame: tuple[float, float] | None
    """F of no shift, no turn and a factor of 1, and its probability; None where not both have a frame of their own"""


def between(first: PointSet, other: PointSet, points: Sequence[str], *, placed: bool) -> Between:
    """What common points say of the similarity between two measurements.

    points  that stayed where they were
    placed  whether both have a frame of their own, so that shift and turn are tested too; otherwise these are free
    raises  InputError for fewer than three points
    Both have a scale of their own.  Limits: which of both is wrong.
    """
    if len(points) < FEWEST:
        raise InputError("frames.too_few_points", first=first.name, second=other.name, n=len(points), least=FEWEST)
    a, b = first.named(points), other.named(points)
    by = None if placed else similarity(b.xyz, a.xyz)
    here, known = (b, 1.0) if by is None else (b.moved(by), by.scale)
    B = datum_directions(a.xyz, scale=True).reshape(3 * len(points), -1)
    Q = a.covariance + here.covariance
    if not placed:  # shift and turn of a free network are no errors
        free = B[:, :6]
        Q = Q + np.trace(Q) / max(float(np.trace(free @ free.T)), 1e-300) * free @ free.T
    try:
        half = np.linalg.inv(np.linalg.cholesky(Q))
    except np.linalg.LinAlgError:
        raise InputError("frames.covariance_singular", first=first.name, second=other.name) from None
    N = half @ B
    C = np.linalg.inv(N.T @ N)
    t = C @ N.T @ half @ (here.xyz - a.xyz).ravel()
    size = _size(a.xyz)
    factor, sigma = (1 + float(t[6]) / size) / known, float(np.sqrt(C[6, 6])) / size / known
    freedom = first.freedom + other.freedom
    F = ((factor - 1) / sigma) ** 2
    return Between(
        factor=factor, sigma=sigma, scale=(F, fisher_tail(F, 1, freedom)), shift=t[:3],
        turn=float(np.linalg.norm(t[3:6])) / size, frame=joint_test(t, C, freedom) if placed else None,
    )  # fmt: skip


def _size(xyz: Array) -> float:
    """That by which `datum_directions` measures turns and scales."""
    return float(np.sqrt(np.mean(np.sum((xyz - xyz.mean(axis=0)) ** 2, axis=1))))
