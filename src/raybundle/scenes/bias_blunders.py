"""Control points of a scene that contradict the others, whichever bias its RPC has."""

from __future__ import annotations

from itertools import combinations
from math import comb

import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.scenes.bias import BIAS_PARAMETERS, BiasKind, bias_design

SIGNIFICANCE = 0.01
"""Of the test of all points together, and of the global test."""
SAMPLES = 600
"""Smallest sets of points that are tried at most."""
MEDIAN = 1.3862943611198906
"""Of chi-square with two degrees of freedom."""


def solve_bias(kind: BiasKind, uv: Array, difference: Array, covariance: Array) -> tuple[Array, Array, float] | None:
    """Values (k,), their covariance (k, k) and the weighted square sum; None where the points do not determine them.

    uv (n, 2) as in `bias_design`;  difference (n, 2) measured - projected [px];  covariance (n, 2, 2) [px^2]
    """
    design = bias_design(kind, uv)
    k = design.shape[2]
    if 2 * len(uv) < k:
        return None
    P = np.linalg.inv(covariance)
    N = np.einsum("nia,nij,njb->ab", design, P, design)
    if k and (np.linalg.matrix_rank(design.reshape(-1, k)) < k or np.linalg.cond(N) > 1e12):
        return None
    values = np.linalg.solve(N, np.einsum("nia,nij,nj->a", design, P, difference)) if k else np.zeros(0)
    v = difference - design @ values
    return values, np.linalg.inv(N) if k else np.zeros((0, 0)), float(np.einsum("ni,nij,nj->", v, P, v))


def misfit(square_sum: float, redundancy: int) -> float:
    """Factor by which the residuals exceed the stated sigma; 1 where the global test at 1 % finds no excess."""
    from scipy.special import gammainccinv

    if redundancy < 1 or square_sum <= 2 * float(gammainccinv(redundancy / 2, SIGNIFICANCE)):
        return 1.0
    return float(np.sqrt(square_sum / redundancy))


def agreeing(uv: Array, difference: Array, covariance: Array) -> Mask:
    """(n,) whether a point agrees with the majority under the bias that suits it best; all where it is unknown.

    A start by least median of squares over small sets of points (Rousseeuw 1984), whose kind of bias is chosen by the
    truncated square sum with a price for each parameter; then each point is tested against the fit of the others, with
    the stated sigma, or with that of the others where these scatter more than stated (Pope 1976).
    Limits: which of two points is wrong, or of two halves that contradict each other.
    """
    n = len(uv)
    everything: Mask = np.ones(n, np.bool_)
    starts = [s for kind in BIAS_PARAMETERS if (s := _start(kind, uv, difference, covariance)) is not None]
    limit = _limit(n, 1.0, None)
    scale = max(1.0, next((s for _, _, s in reversed(starts) if np.isfinite(s)), 1.0))
    best, kind, kept = np.inf, None, everything
    for candidate, d2, _ in starts:
        score = float(np.minimum(d2 / scale**2, limit).sum()) + len(BIAS_PARAMETERS[candidate]) * float(np.log(2 * n))
        if score < best:
            best, kind, kept = score, candidate, d2 / scale**2 <= limit
    if kind is None or 2 * kept.sum() <= n:
        kept = everything
    kept = kept if kind is None else _settled(kind, kept, uv, difference, covariance)
    return kept if 2 * kept.sum() > n else everything


def _start(kind: BiasKind, uv: Array, difference: Array, covariance: Array) -> tuple[BiasKind, Array, float] | None:
    """Squared misfit (n,) of each point under the set with the least median, and the scatter it shows.

    The scatter is NaN where too few points stand beside the set.
    """
    n, least = len(uv), len(BIAS_PARAMETERS[kind]) // 2
    if n < max(3, least + 1):
        return None
    P = np.linalg.inv(covariance)
    design = bias_design(kind, uv)
    best, found = np.inf, None
    for rows in _sets(n, least):
        solved = solve_bias(kind, uv[rows], difference[rows], covariance[rows])
        if solved is None:
            continue
        v = difference - design @ solved[0]
        d2 = np.einsum("ni,nij,nj->n", v, P, v)
        median = float(np.partition(d2, (n + least) // 2)[(n + least) // 2])
        if median < best:
            best, found = median, d2
    if found is None:
        return None
    enough = n >= 2 * least + 1
    scatter = float(np.sqrt(best / MEDIAN)) * (1 + 5 / (n - least)) if enough else float("nan")
    return kind, found, scatter


def _sets(n: int, least: int) -> list[list[int]]:
    if comb(n, least) <= SAMPLES:
        return [list(c) for c in combinations(range(n), least)]
    rng = np.random.default_rng(1)
    return [rng.choice(n, least, replace=False).tolist() for _ in range(SAMPLES)]


def _settled(kind: BiasKind, kept: Mask, uv: Array, difference: Array, covariance: Array) -> Mask:
    """Drop the point that contradicts the others most, or take back the one that agrees best, until neither is left."""
    kept = kept.copy()
    for _ in range(2 * len(uv)):
        ratio = np.array([_contradiction(kind, k, kept, uv, difference, covariance) for k in range(len(uv))])
        if (wrong := kept & (ratio > 1)).any():
            kept[int(np.argmax(np.where(wrong, ratio, -np.inf)))] = False
        elif (right := ~kept & (ratio <= 1)).any():
            kept[int(np.argmin(np.where(right, ratio, np.inf)))] = True
        else:
            break
    return kept


def _contradiction(kind: BiasKind, k: int, kept: Mask, uv: Array, difference: Array, covariance: Array) -> float:
    """Squared misfit of a point against the fit of the others, over its limit; 0 where they cannot show."""
    others = kept.copy()
    others[k] = False
    solved = solve_bias(kind, uv[others], difference[others], covariance[others])
    redundancy = 2 * int(others.sum()) - len(BIAS_PARAMETERS[kind])
    if solved is None or redundancy < 2:
        return 0.0
    values, Q, square_sum = solved
    design = bias_design(kind, uv[k : k + 1])[0]
    v = difference[k] - design @ values
    d2 = float(v @ np.linalg.solve(covariance[k] + design @ Q @ design.T, v))
    factor = misfit(square_sum, redundancy)
    return d2 / _limit(len(uv), factor, redundancy)


def _limit(n: int, factor: float, redundancy: int | None) -> float:
    """Largest squared misfit of two coordinates that chance allows among n points."""
    from scipy.special import fdtri, gammainccinv

    if factor == 1 or redundancy is None:
        return 2 * float(gammainccinv(1.0, SIGNIFICANCE / n))
    return 2 * factor**2 * float(fdtri(2, redundancy, 1 - SIGNIFICANCE / n))
