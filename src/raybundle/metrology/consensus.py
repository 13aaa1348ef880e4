"""Points that may have stayed: consensus of small similarity transformations, robust for up to half that moved."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask

DRAWS = 400
"""Triples of points or patches: one of stable ones alone is among them but once in 1e30 where 55 % stayed"""
REFINED = 10
"""Of these the best that are refined"""
ROUNDS = 10
INSIDE = 0.95
"""Share of points that stayed which lie within the limit"""


class Differences(Protocol):
    """Differences d (3 n k) of points = datum B t, with covariance Q."""

    @property
    def d(self) -> Array:
        """(3 n k)."""
        ...

    @property
    def Q(self) -> Array:
        """Their covariance."""
        ...

    @property
    def B(self) -> Array:
        """(3 n k, g) what the datum does to them."""
        ...

    @property
    def points(self) -> int:
        """Number of points."""
        ...

    def rows(self, points: Index) -> Index:
        """(len(points), 3 k) rows of points."""
        ...


def stable_starts(model: Differences, patches: Sequence[Index]) -> list[Mask]:
    """(n,) points that agree with the datum of most: none left out, by single points, by the means around each.

    patches  the smallest patch around each point
    """
    n = model.points
    rows = model.rows(np.arange(n))
    # the datum of Q is of no account: covariances of single points are those in the datum of all
    H = np.linalg.qr(model.B)[0]
    Q = model.Q - H @ (H.T @ model.Q)
    Q = Q - (Q @ H) @ H.T
    d = model.d - H @ (H.T @ model.d)
    starts = [np.ones(n, bool)]
    single = [np.array([k]) for k in range(n)]
    for sets in (single, list(patches)):
        if len(sets) < 4:
            continue
        each = np.array([d[rows[p]].mean(axis=0) for p in sets])
        B = np.array([H[rows[p]].mean(axis=0) for p in sets])
        C = np.array([_mean(Q, rows[p]) for p in sets])
        good = _consensus(each, B, C)
        # a point stayed where most patches that it belongs to did
        votes = np.zeros((n, 2))
        for p, g in zip(sets, good.tolist(), strict=True):
            votes[p, int(g)] += 1
        starts.append(votes[:, 1] >= votes[:, 0])
    return [s for s in starts if s.sum() > 3]


def _mean(Q: Array, rows: Index) -> Array:
    """Covariance (3 k, 3 k) of the mean of points."""
    r = rows.ravel()
    return Q[np.ix_(r, r)].reshape(*rows.shape, *rows.shape).mean(axis=(0, 2))


def _consensus(d: Array, B: Array, C: Array) -> Mask:
    """(h,) differences (h, f) that agree with B t for the t that most agree with; C (h, f, f) their covariances."""
    from scipy.special import chdtri

    h, f = d.shape
    half = np.linalg.inv(np.linalg.cholesky(C + 1e-9 * np.trace(C.mean(axis=0)) * np.eye(f)))
    y, A = np.einsum("hij,hj->hi", half, d), half @ B
    limit = float(chdtri(f, 1 - INSIDE))
    rng = np.random.default_rng(0)
    best = (np.inf, np.zeros(B.shape[2]))
    tried: list[tuple[float, Array]] = []
    for _ in range(DRAWS):
        some = rng.choice(h, 3, replace=False)
        t = np.linalg.lstsq(A[some].reshape(3 * f, -1), y[some].ravel(), rcond=1e-6)[0]
        # three points know the datum worse than all do: the limit is wider for their consensus
        tried.append((float(np.minimum(_square(y, A, t), 4 * limit).sum()), t))
    tried.append((0.0, np.linalg.lstsq(A.reshape(h * f, -1), y.ravel(), rcond=1e-9)[0]))
    for _, start in sorted(tried, key=lambda c: c[0])[: REFINED + 1]:
        t = start
        for _ in range(ROUNDS):
            weight = np.sqrt(np.maximum(1 - _square(y, A, t) / (4 * limit), 0.0))  # Tukey's, at twice the limit
            if (weight > 0).sum() < 3:
                break
            w = weight[:, None]
            t = np.linalg.lstsq((w[:, :, None] * A).reshape(h * f, -1), (w * y).ravel(), rcond=1e-9)[0]
        score = float(np.minimum(_square(y, A, t), limit).sum())
        if score < best[0]:
            best = (score, t)
    return _square(y, A, best[1]) < limit


def _square(y: Array, A: Array, t: Array) -> Array:
    """(h,) squared distances, in standard deviations."""
    return ((y - A @ t) ** 2).sum(axis=1)
