"""Critical values, detectability and tests.

Distributions come from scipy.special: scipy.stats takes half a second to load.
"""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array

ALPHA = 0.001
"""Significance level of the smallest detectable blunder (Baarda 1968)."""
POWER = 0.80
CRITICAL_W = 3.2905267314918945
"""Two-sided critical value of a standard normal deviate at ALPHA."""
DELTA0 = 4.132147965064809
"""Shift of the mean of w that is detected at ALPHA with POWER: root of the noncentrality 17.0746 (Baarda 1968)."""


DECISIVE = 2 * float(np.log(100))
"""Difference of two chi-squares from which one hypothesis is a hundred times likelier than the other."""


def noncentrality(alpha: float, power: float) -> tuple[float, float]:
    """Critical value k and shift delta0 of a standard normal deviate tested two-sided at alpha with this power.

    The chance to exceed the limit on the far side is neglected, as in Baarda's tables.
    """
    from scipy.special import ndtri

    k = -float(ndtri(alpha / 2))
    return k, k + float(ndtri(power))


def family_wise_normal(significance: float, count: int) -> float:
    """Critical |w| such that among `count` tests one false alarm has at most this probability (Bonferroni)."""
    from scipy.special import ndtri

    return -float(ndtri(significance / (2 * max(count, 1))))


def family_wise_t(significance: float, count: int, redundancy: float) -> float:
    """The same for |value| / std, sigma0 from an adjustment of that redundancy (Student); below 1: infinite."""
    from scipy.special import stdtrit

    if redundancy < 1:
        return float("inf")
    return -float(stdtrit(redundancy, significance / (2 * max(count, 1))))


def family_wise_tau(significance: float, count: int, redundancy: int) -> float:
    """The same for tau = v / (sigma0 s sqrt r), sigma0 from the same adjustment (Pope 1976)."""
    from scipy.special import stdtrit

    if redundancy < 2:
        return float("nan")
    q = -float(stdtrit(redundancy - 1, significance / (2 * max(count, 1))))
    return float(np.sqrt(redundancy) * q / np.sqrt(redundancy - 1 + q * q))


def global_test(square_sum: float, redundancy: int, significance: float = 0.05) -> tuple[float, float, float]:
    """Lower limit, weighted square sum, upper limit of the two-sided chi-square test of sigma0 = 1."""
    from scipy.special import gammainccinv, gammaincinv

    if redundancy < 1:
        return float("nan"), square_sum, float("nan")
    half = redundancy / 2
    return 2 * float(gammaincinv(half, significance / 2)), square_sum, 2 * float(gammainccinv(half, significance / 2))


def chi_square_tails(value: float, freedom: float) -> tuple[float, float]:
    """Probabilities of a smaller and of a larger chi-square value."""
    from scipy.special import gammainc, gammaincc

    return float(gammainc(freedom / 2, value / 2)), float(gammaincc(freedom / 2, value / 2))


def chi_square_limit(significance: float, freedom: int) -> float:
    """Value that a chi-square exceeds with a probability."""
    from scipy.special import chdtri

    return float(chdtri(freedom, significance))


def detectable_noncentrality(significance: float, freedom: int, power: float) -> float:
    """Noncentrality that a chi-square test at this significance detects with this power (Baarda 1968)."""
    from scipy.special import chndtrinc

    return float(chndtrinc(chi_square_limit(significance, freedom), freedom, 1 - power))


def fisher_tail(value: float, first: int, second: float) -> float:
    """Probability of a larger F value with so many degrees of freedom; the second infinite: chi-square / first."""
    from scipy.special import chdtrc, fdtrc

    return float(chdtrc(first, value * first) if np.isinf(second) else fdtrc(first, second, value))


def joint_test(error: Array, covariance: Array, freedom: float) -> tuple[float, float]:
    """F of an error (n,) under its covariance (n, n), in the directions in which it varies, and its probability.

    freedom  of the variance factor in the covariance; infinite where it is known
    NaN where it varies in none.
    """
    size, way = np.linalg.eigh(covariance)
    good = size > 1e-9 * max(float(size[-1]), 1e-300)
    dof = int(good.sum())
    if not dof:
        return float("nan"), float("nan")
    F = float(np.sum((way[:, good].T @ error) ** 2 / size[good])) / dof
    return F, fisher_tail(F, dof, freedom)


def mahalanobis2(error: Array, covariance: Array) -> Array:
    """E' C^-1 e of errors (n, k) under covariances (k, k) or (n, k, k): chi-square with k degrees of freedom."""
    solved = np.linalg.solve(np.broadcast_to(covariance, (len(error), *covariance.shape[-2:])), error[..., None])
    return np.einsum("ni,ni->n", error, solved[..., 0])


def correlation(cofactor: Array) -> Array:
    """Correlation matrix (k, k) of a cofactor or covariance matrix (k, k)."""
    s = np.sqrt(np.diagonal(cofactor))
    with np.errstate(invalid="ignore", divide="ignore"):
        return cofactor / np.outer(s, s)


def axis_weights(packed: Array) -> Array:
    """Diagonal (n, 2) of the weights P = C^-1 of image points; packed (n, 3): C as xx, yy, xy."""
    return packed[:, [1, 0]] / (packed[:, 0] * packed[:, 1] - packed[:, 2] ** 2)[:, None]


def axis_tests(error: Array, packed: Array) -> Array:
    """(P e) / sqrt(diag P) of errors (n, 2): what each is tested by alone, e / s of uncorrelated ones."""
    P, across = axis_weights(packed), packed[:, 2] / (packed[:, 0] * packed[:, 1] - packed[:, 2] ** 2)
    return (P * error - across[:, None] * error[:, ::-1]) / np.sqrt(P)
