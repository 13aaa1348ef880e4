"""Measured lengths held against known ones: errors, how sure they are, and the table of a length test.

The table has what VDI/VDE 2634 part 1 asks of a length test (errors of lengths against A + K L); what that guideline
asks of the arrangement (seven lines through the volume, five lengths in each) is not looked at here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.metrology.point_set import PointSet
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.statistics import joint_test

COVERAGE = 2.0


@dataclass(frozen=True, slots=True, kw_only=True)
class KnownLength:
    """A length between two points, as a certificate states it."""

    start: str
    end: str
    length: float
    """[m]"""
    sigma: float = 0.0
    """[m]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class LengthTest:
    """Measured lengths against known ones; arrays over the lengths."""

    known: tuple[KnownLength, ...]
    measured: Array
    """(k,) [m]"""
    sigma: Array
    """(k,) standard deviations of the measured lengths [m]"""
    error: Array
    """(k,) measured - known [m]"""
    error_sigma: Array
    """(k,) of the errors, that of the known lengths included [m]"""
    p_value: Array
    """(k,) probability of a larger error by errors of measurement alone, of this length alone"""
    limit: float
    """Probability below which an error is significant: family-wise over the lengths"""
    whole: tuple[float, float]
    """All together, with their correlations: F of the errors, and its probability"""
    freedom: float
    allowed: Array
    """(k,) largest error that is allowed [m]; NaN where none is stated"""

    @property
    def significant(self) -> Mask:
        """(k,) errors that errors of measurement do not explain."""
        return self.p_value < self.limit

    @property
    def largest(self) -> float:
        """Largest absolute error [m]."""
        return float(np.abs(self.error).max())

    @property
    def rms(self) -> float:
        """[m]."""
        return float(np.sqrt(np.mean(self.error**2)))

    @property
    def within(self) -> float:
        """Share of the errors that are below two of their standard deviations: 0.95 is to be expected."""
        return float(np.mean(np.abs(self.error) <= COVERAGE * self.error_sigma))

    @property
    def kept(self) -> bool | None:
        """Whether every error is within what is allowed; None where nothing is stated."""
        if np.isnan(self.allowed).all():
            return None
        return bool((np.abs(self.error) <= self.allowed).all())


def length_test(
    measured: PointSet, known: Sequence[KnownLength], *, allowed: tuple[float, float] | None = None,
    significance: float = 0.05,
) -> LengthTest:  # fmt: skip
    """Hold lengths between measured points against known ones.

    allowed  A [m] and K: errors up to A + K L are allowed
    raises   InputError for points that were not measured, lengths that are none, a scale that nothing measured
    Known lengths are taken as independent.  What it does not tell: lengths that took part in the adjustment as scale
    bars are no test.
    """
    if not known:
        raise InputError("a length test needs a known length")
    if measured.free_scale:
        raise InputError(
            f"{measured.name}: nothing measured the scale, so that lengths are in no unit; give a scale bar"
        )
    place = {name: k for k, name in enumerate(measured.ids)}
    missing = sorted({i for k in known for i in (k.start, k.end) if i not in place})
    if missing:
        raise InputError(f"{measured.name} has no point {', '.join(missing[:10])}")
    a, b = (np.array([place[getattr(k, end)] for k in known]) for end in ("start", "end"))
    way = measured.xyz[b] - measured.xyz[a]
    length = np.linalg.norm(way, axis=1)
    wanted, wanted_sigma = np.array([k.length for k in known]), np.array([k.sigma for k in known])
    if not ((length > 0) & (wanted > 0)).all() or not (wanted_sigma >= 0).all():
        k = known[int(np.argmin((length > 0) & (wanted > 0) & (wanted_sigma >= 0)))]
        raise InputError(f"length {k.start} to {k.end}: {k.length:g} m with a standard deviation of {k.sigma:g} m")
    J = np.zeros((len(known), 3 * len(measured.ids)))
    for j in range(len(known)):
        J[j, 3 * b[j] : 3 * b[j] + 3] += way[j] / length[j]
        J[j, 3 * a[j] : 3 * a[j] + 3] -= way[j] / length[j]
    C = J @ measured.covariance @ J.T
    D = C + np.diag(wanted_sigma**2)
    error, sigma = length - wanted, np.sqrt(np.diagonal(D))
    if not (sigma > 0).all():
        k = known[int(np.argmin(sigma))]
        raise InputError(f"length {k.start} to {k.end} has no error: both ends are held; it is no test")
    A, K = allowed or (float("nan"), float("nan"))
    return LengthTest(
        known=tuple(known), measured=length, sigma=np.sqrt(np.diagonal(C)), error=error, error_sigma=sigma,
        p_value=np.array([_tail(e / s, measured.freedom) for e, s in zip(error, sigma, strict=True)]),
        limit=significance / len(known), whole=joint_test(error, D, measured.freedom), freedom=measured.freedom,
        allowed=A + K * wanted,
    )  # fmt: skip


def _tail(ratio: float, freedom: float) -> float:
    from scipy.special import ndtr, stdtr  # noqa: PLC0415

    return float(2 * (ndtr(-abs(ratio)) if np.isinf(freedom) else stdtr(freedom, -abs(ratio))))
