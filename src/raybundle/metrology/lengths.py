"""Measured lengths held against known ones: errors, how sure they are, and the table of a length test.

The table has what VDI/VDE 2634 part 1 asks of a length test (errors of lengths against A + K L); what that guideline
asks of the arrangement (seven lines through the volume, five lengths in each) is not looked at here.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field

import numpy as np

from raybundle.errors import InputError
from raybundle.metrology.point_set import PointSet
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.statistics import joint_test

COVERAGE = 2.0
CONTROLLED = 0.01
"""Redundancy number from which on an observation is controlled at all (Förstner 1979)"""
BOUND = 0.1
"""Share of the usual change of lengths by their points below which a combination of them is bound by geometry.

A certificate whose error nobody states is taken as free of error, which it may be called if it is ten times as good as
what it tests; in a combination that points change ten times less than others it is not."""


@dataclass(frozen=True, slots=True, kw_only=True)
class KnownLength:
    """A length between two points, as a certificate states it."""

    start: str
    end: str
    length: float
    """[m]"""
    sigma: float = 0.0
    """[m]"""
    line: int | None = field(default=None, compare=False)
    """of its file"""


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
    """All that took no part together, with their correlations: F of the errors, and its probability"""
    freedom: float
    allowed: Array
    """(k,) largest error that is allowed [m]; NaN where none is stated"""
    served: Mask
    """(k,) lengths that were scale bars as well: they took part, and are no test"""
    significance: float
    """Probability that any is called significant by errors of measurement alone"""
    worst: int
    """The length whose error is the largest part of its standard deviation, among those that took no part"""
    without_worst: tuple[float, float]
    """F of the others and its probability; NaN where there are none"""
    scale: tuple[float, float]
    """By how much the lengths that took no part are measured too long, as a share, and its standard deviation"""

    @property
    def independent(self) -> int:
        """Number of lengths that took no part."""
        return int((~self.served).sum())

    @property
    def controlled(self) -> Mask:
        """(k,) lengths that took no part and whose test can find an error of the measurement.

        Their own certificates have part of the error: of a redundancy below `CONTROLLED` nothing is found.
        """
        return np.asarray(~self.served & (self.sigma**2 >= CONTROLLED * self.error_sigma**2), bool)

    @property
    def compared(self) -> Mask:
        """(k,) the lengths that figures are taken over: those that took no part, all where each was a bar."""
        return ~self.served if self.independent else np.ones(len(self.known), bool)

    @property
    def factor(self) -> float:
        """How many times larger errors are than standard deviations say."""
        return float(np.sqrt(self.whole[0]))

    @property
    def contradicts(self) -> bool:
        """Whether lengths that took no part differ, together or one of them, by more than standard deviations say."""
        return self.independent > 0 and bool(self.whole[1] < self.significance or self.strange.any())

    @property
    def strange(self) -> Mask:
        """(k,) lengths that took no part whose errors are significant."""
        return np.asarray(self.significant & ~self.served, bool)

    @property
    def largest_at(self) -> int:
        """The length with the largest absolute error."""
        return int(np.where(self.compared, np.abs(self.error), -1.0).argmax())

    @property
    def significant(self) -> Mask:
        """(k,) errors that errors of measurement do not explain."""
        return self.p_value < self.limit

    @property
    def largest(self) -> float:
        """Largest absolute error [m]."""
        return float(np.abs(self.error[self.largest_at]))

    @property
    def rms(self) -> float:
        """[m]."""
        return float(np.sqrt(np.mean(self.error[self.compared] ** 2)))

    @property
    def within(self) -> float:
        """Share of the errors that are below two of their standard deviations: 0.95 is to be expected."""
        some = self.compared
        return float(np.mean(np.abs(self.error[some]) <= COVERAGE * self.error_sigma[some]))

    @property
    def kept(self) -> bool | None:
        """Whether every error is within what is allowed; None where nothing is stated."""
        if np.isnan(self.allowed).all():
            return None
        return bool((np.abs(self.error) <= self.allowed).all())


def length_test(
    measured: PointSet, known: Sequence[KnownLength], *, allowed: tuple[float, float] | None = None,
    significance: float = 0.05, bars: Collection[frozenset[str]] = (),
) -> LengthTest:  # fmt: skip
    """Hold lengths between measured points against known ones.

    allowed  A [m] and K: errors up to A + K L are allowed
    bars     pairs of ends between which a distance took part in the adjustment
    raises   InputError for points that were not measured, lengths that are none, a scale that nothing measured
    Known lengths are taken as independent.  Limits: whether points or certificates are wrong where they
    contradict each other.
    """
    if not known:
        raise InputError("length_test.no_length")
    if measured.free_scale:
        raise InputError("length_test.no_scale", name=measured.name)
    place = {name: k for k, name in enumerate(measured.ids)}
    missing = sorted({i for k in known for i in (k.start, k.end) if i not in place})
    if missing:
        raise InputError("measurement.unknown_points", name=measured.name, points=missing)
    a, b = (np.array([place[getattr(k, end)] for k in known]) for end in ("start", "end"))
    way = measured.xyz[b] - measured.xyz[a]
    length = np.linalg.norm(way, axis=1)
    wanted, wanted_sigma = np.array([k.length for k in known]), np.array([k.sigma for k in known])
    if not ((length > 0) & (wanted > 0)).all() or not (wanted_sigma >= 0).all():
        k = known[int(np.argmin((length > 0) & (wanted > 0) & (wanted_sigma >= 0)))]
        raise InputError("length_test.invalid_length", start=k.start, end=k.end, length_m=k.length, sigma_m=k.sigma)
    J = np.zeros((len(known), 3 * len(measured.ids)))
    for j in range(len(known)):
        J[j, 3 * b[j] : 3 * b[j] + 3] += way[j] / length[j]
        J[j, 3 * a[j] : 3 * a[j] + 3] -= way[j] / length[j]
    C = J @ measured.covariance @ J.T
    D = C + np.diag(wanted_sigma**2)
    error, sigma = length - wanted, np.sqrt(np.diagonal(D))
    if not (sigma > 0).all():
        k = known[int(np.argmin(sigma))]
        raise InputError("length_test.no_error", start=k.start, end=k.end)
    A, K = allowed or (float("nan"), float("nan"))
    served = np.array([frozenset((k.start, k.end)) in bars for k in known], bool)
    some = ~served if not served.all() else np.ones(len(known), bool)
    worst = int(np.where(some, np.abs(error) / sigma, -1.0).argmax())
    certified = bool((wanted_sigma > 0).all())

    def ways(which: Mask) -> Array:
        return _ways(J, which, free=certified)

    others = some & (np.arange(len(known)) != worst)
    return LengthTest(
        known=tuple(known), measured=length, sigma=np.sqrt(np.diagonal(C)), error=error, error_sigma=sigma,
        p_value=np.array([_tail(e / s, measured.freedom) for e, s in zip(error, sigma, strict=True)]),
        limit=significance / len(known), whole=_joint(error, D, ways(some), measured.freedom), freedom=measured.freedom,
        allowed=A + K * wanted, served=served, significance=significance, worst=worst,
        without_worst=_joint(error, D, ways(others), measured.freedom),
        scale=_scale(error, length, D, ways(some)),
    )  # fmt: skip


def _ways(J: Array, some: Mask, *, free: bool) -> Array:
    """(k, r) combinations of some lengths that points can change; of others certificates alone decide.

    J     (k, 3 n) partial derivatives of the lengths by the coordinates
    free  whether every certificate states its error: then all of them
    The lengths between points on one bar depend on each other: what is left of them is what certificates contradict
    each other by, their last digits, and no standard deviation of the measurement is tested by that.
    """
    U = np.zeros((len(J), int(some.sum())))
    U[np.flatnonzero(some), np.arange(int(some.sum()))] = 1.0
    if free or not some.any():
        return U
    left, size, _ = np.linalg.svd(J[some], full_matrices=False)
    return U @ left[:, size > BOUND * size[0]]


def _joint(error: Array, D: Array, U: Array, freedom: float) -> tuple[float, float]:
    return joint_test(U.T @ error, U.T @ D @ U, freedom) if U.shape[1] else (float("nan"), float("nan"))


def _scale(error: Array, length: Array, D: Array, U: Array) -> tuple[float, float]:
    """Common share of the errors in the lengths by least squares, and its standard deviation."""
    W = U @ np.linalg.pinv(U.T @ D @ U, rcond=1e-9, hermitian=True) @ U.T
    weight = float(length @ W @ length)
    return float(length @ W @ error) / weight, 1 / float(np.sqrt(weight))


def _tail(ratio: float, freedom: float) -> float:
    from scipy.special import ndtr, stdtr

    return float(2 * (ndtr(-abs(ratio)) if np.isinf(freedom) else stdtr(freedom, -abs(ratio))))
