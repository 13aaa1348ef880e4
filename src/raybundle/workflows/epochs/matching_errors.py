"""Displacements of points by wrong image points: what a movement has to exceed.

Image points have gross errors that the normal distribution does not have.  With few rays a date the residuals do not
show them: along the epipolar line of two rays nothing does.  Two mixtures of normal distributions describe them, both
estimated from the dates one by one, in which nothing moves:

- image points: a share has standard deviations `SCALES` times as large (by the residuals of points with three rays);
- places: errors that the rays of a date share (by differences of places of one date, from half of its rays each, halved
  by the viewing direction).

The probability of a displacement is the mean over which image points may be wrong: each such set has a probability by
the residuals, which no movement changes, and moves and enlarges the place and its covariance.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import combinations, product

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import Block
from raybundle.metrology.congruence_model import POWER
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.statistics import detectable_noncentrality

SCALES = (1.0, 3.0, 9.0)
"""Of the standard deviations of image points"""
OF_PLACES = (1.0, 2.0, 4.0)
"""Of the standard deviations of differences of places"""
MOST_WRONG = 2
"""Image points of a place that may be wrong together"""
RAYS = (3, 8)
"""Image points of places from which shares are estimated: fewer show nothing, more add nothing"""
FEW, BEFORE_IMAGES, BEFORE_PLACES = 30, (0.97, 0.025, 0.005), (0.95, 0.04, 0.01)
"""Places or differences below which shares are filled up with those of photographs of facades"""
ROUNDS = 100
LEAST = 1e-7
"""Probability of a set of wrong image points below which it is left out, and counted as the one that explains most"""
CONDITION = 1e12
TOGETHER = 200_000
"""Pairs of sets that are compared together"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Shares:
    """Of image points and of differences of places, by their scales."""

    images: Array
    places: Array


@dataclass(frozen=True, slots=True, kw_only=True)
class Place:
    """A place under each set of wrong image points."""

    weight: Array
    """(c,) probabilities"""
    shift: Array
    """(c, 3) against the place without wrong ones [length unit of the block]"""
    extra: Array
    """(c, 3, 3) covariance beyond that without wrong ones"""


@dataclass(frozen=True, slots=True, kw_only=True)
class MatchingErrors:
    """The image points of an adjustment, in their standard deviations, linear in the places of their points."""

    rows: dict[int, Index]
    """of each point"""
    y: Array
    """(m, 2) residuals: y = A dX + errors of 1"""
    A: Array
    """(m, 2, 3)"""
    metres: float
    shares: Shares
    variance: float = 1.0
    """by which differences of places between halves of dates exceed their covariances"""
    places: dict[int, Place] = field(init=False, default_factory=dict[int, Place])
    """of points that were asked for"""

    @classmethod
    def of(
        cls, result: Adjustment, shares: Shares | None = None, variance: float = 1.0
    ) -> MatchingErrors | None:  # fmt: skip
        """Of an adjustment; shares: None estimates them.  None where images are scenes of satellites."""
        b, o = result.adjusted, result.adjusted.observations
        if any(c.is_scene for c in b.cameras):
            return None
        placed = np.asarray(np.isfinite(b.points.xyz).all(axis=1), bool)
        there = np.flatnonzero(placed[o.point] & b.images.oriented[o.image])
        y, A = np.zeros((len(o), 2)), np.zeros((len(o), 2, 3))
        v, B = _linear(b, there)
        C = result.variance_factor * o.cov_px2[there][:, [0, 2, 2, 1]].reshape(-1, 2, 2)
        half = np.linalg.inv(np.linalg.cholesky(C))
        y[there], A[there] = -np.einsum("mij,mj->mi", half, v), half @ B
        taken = np.asarray(result.image_observations.used, bool) & np.isin(np.arange(len(o)), there)
        found = cls(
            rows=_by_point(o.point, taken), y=y, A=A, metres=0.001 if b.length_unit == "mm" else 1.0,
            shares=shares or Shares(images=np.array(BEFORE_IMAGES), places=np.array(BEFORE_PLACES)), variance=variance,
        )  # fmt: skip
        if shares is not None:
            return found
        rejected = np.array([r is not None for r in result.image_observations.rejected], bool)
        every = _by_point(o.point, taken | (rejected & np.isin(np.arange(len(o)), there)))
        return found.estimated(every, o.image, b.images.centre)

    def estimated(self, rows: dict[int, Index], image: Index, centre: Array) -> MatchingErrors:
        """With the shares that the dates one by one show.

        rows    of each point, with those that were rejected
        image   (m,) of each row
        centre  (n, 3) of the images
        """
        images = self._of_images(rows)
        places = self._of_places(np.log(np.maximum(images, 1e-300)), image, centre)
        return replace(self, shares=Shares(images=images, places=places))

    def place(self, point: int) -> Place:
        """A point under each set of wrong image points; nothing known of it: one set that changes nothing."""
        if point not in self.places:
            self.places[point] = self._place(point)
        return self.places[point]

    def _place(self, point: int) -> Place:
        rows = self.rows.get(point, np.zeros(0, np.int64))
        if len(rows) < 2:
            return Place(weight=np.ones(1), shift=np.zeros((1, 3)), extra=np.zeros((1, 3, 3)))
        (weight,), (x,), (C,) = self._placed(rows[None], np.log(np.maximum(self.shares.images, 1e-300)))
        keep = weight > LEAST
        keep[0] = True
        return Place(weight=weight[keep], shift=self.metres * (x - x[0])[keep], extra=self.metres**2 * (C - C[0])[keep])

    def probability(self, points: Sequence[int], d: Array, C: Array) -> float:
        """Probability of a larger displacement of the places of later dates against that of the first, by errors alone.

        points  of each date
        d, C    (3 k) displacements [m] and their covariance as if no image point were wrong
        """
        from scipy.special import chdtrc

        C = self.variance * C
        weight, shift, extra = self._together(points, LEAST)
        e = d + shift
        F = np.maximum(np.einsum("si,sij,sj->s", e, np.linalg.pinv(C + extra, rcond=1e-10, hermitian=True), e), 0)
        tails = np.array([chdtrc(len(d), F / s**2) for s in OF_PLACES])
        p = self.shares.places @ tails
        return float(p @ weight) + max(1 - float(weight.sum()), 0.0) * float(p.max())

    def detectable(self, points: Sequence[int], C: Array, alpha: float) -> float:
        """Length of the smallest displacement of the last date that errors alone do not explain, with `POWER` [m]."""
        C = self.variance * C
        weight, _, extra = self._together(points, alpha)
        size = np.sqrt(np.maximum(np.linalg.eigvalsh((C + extra)[:, -3:, -3:])[:, -1], 0))
        found = 0.0
        for share, scale in zip(self.shares.places.tolist(), OF_PLACES, strict=True):
            # what a set of wrong image points explains is to be excluded at what is left of the significance
            p = share * weight
            some = p > alpha
            if some.any():
                found = max(found, scale * float((size[some] * _shifts(alpha / p[some], len(C))).max()))
        return found

    def _together(self, points: Sequence[int], least: float) -> tuple[Array, Array, Array]:
        first, *later = [self.place(p) for p in points]
        k, some = len(later), np.flatnonzero(first.weight > least)
        weight, shift = first.weight[some], np.tile(-first.shift[some], (1, k))
        extra = np.tile(first.extra[some], (1, k, k))
        for j, place in enumerate(later):
            own = slice(3 * j, 3 * j + 3)
            weight = np.outer(weight, place.weight)
            keep = np.nonzero(weight > least)
            weight, shift, extra = weight[keep], shift[keep[0]], extra[keep[0]]
            shift[:, own] += place.shift[keep[1]]
            extra[:, own, own] += place.extra[keep[1]]
        return weight, shift, extra

    def _placed(self, rows: Index, shares: Array) -> tuple[Array, Array, Array]:
        """Of g points with rows (g, m): probabilities (g, c), places (g, c, 3), covariances (g, c, 3, 3) of sets.

        shares  logarithms
        """
        log, x, C = _solved(self.y[rows], self.A[rows])
        w = log + shares[_sets(rows.shape[1])].sum(axis=1)
        w = np.exp(w - w.max(axis=1, keepdims=True))
        return w / w.sum(axis=1, keepdims=True), x, C

    def _of_images(self, rows: dict[int, Index]) -> Array:
        """Shares of image points by expectation and maximisation."""
        parts: list[tuple[Array, Array]] = []
        for m, at in _by_count(rows.values()).items():
            if RAYS[0] <= m <= RAYS[1]:
                log = _solved(self.y[at], self.A[at])[0]
                good = np.isfinite(log).all(axis=1)
                count = np.stack([(_sets(m) == k).sum(axis=1) for k in range(len(SCALES))], axis=1)
                parts.append((np.exp(log - log.max(axis=1, keepdims=True))[good], count))
        return _shares(parts, BEFORE_IMAGES)

    def _of_places(self, log: Array, image: Index, centre: Array) -> Array:
        """Shares of differences of places, of the halves of the rays of a point at a date."""
        found: list[Array] = []
        for count, every in _by_count(self.rows.values()).items():
            if count < 4:
                continue
            c = centre[image[every]] - centre[image[every]].mean(axis=1, keepdims=True)
            way = np.linalg.svd(c, full_matrices=False)[2][:, 0]
            order = np.argsort(np.einsum("gmi,gi->gm", c, way), axis=1, kind="stable")
            rows = np.take_along_axis(every, order, axis=1)
            sets = len(_sets(count // 2)) * len(_sets(count - count // 2))
            for some in np.array_split(rows, len(rows) * sets // TOGETHER + 1):
                halves = [self._placed(r, log) for r in (some[:, : count // 2], some[:, count // 2 :])]
                found.append(_differences(*halves))
        count = np.eye(len(OF_PLACES), dtype=np.int64)
        return _shares([(f, count) for f in found if len(f)], BEFORE_PLACES)


def _differences(first: tuple[Array, Array, Array], second: tuple[Array, Array, Array]) -> Array:
    """Likelihoods (g, scales) of the difference of two places of each point, under each scale; of some points none."""
    (w, x, C), (v, z, D) = first, second
    point, i, j = np.nonzero((w > 1e-6)[:, :, None] & (v > 1e-6)[:, None])
    start = np.searchsorted(point, np.arange(len(w)))
    S = C[point, i] + D[point, j]
    trace = np.trace(S[start], axis1=1, axis2=2)
    S = S / trace[point, None, None]
    with np.errstate(invalid="ignore"):
        good = np.logical_and.reduceat(np.isfinite(S).all(axis=(1, 2)), start)
    good[good] = np.linalg.cond(S[start[good]]) <= CONDITION
    kept = good[point]
    point, i, j, S = point[kept], i[kept], j[kept], S[kept]
    if not len(point):
        return np.zeros((0, len(OF_PLACES)))
    start = np.flatnonzero(np.diff(point, prepend=-1))
    d = z[point, j] - x[point, i]
    F = np.einsum("si,si->s", d, np.linalg.solve(S, d[:, :, None])[:, :, 0]) / trace[point]
    size = -np.linalg.slogdet(S)[1] / 2
    likely = np.array([size - F / s**2 / 2 - 3 * np.log(s) for s in OF_PLACES])
    largest = np.repeat(np.maximum.reduceat(likely.max(axis=0), start), np.diff(start, append=len(point)))
    both = w[point, i] * v[point, j]
    return np.add.reduceat(np.exp(likely - largest) * both, start, axis=1).T


def _linear(block: Block, rows: Index) -> tuple[Array, Array]:
    """Residuals (k, 2) of image points, and their partials (k, 2, 3) by the coordinates of their points [px]."""
    xyz = block.points.xyz[block.observations.point[rows]]
    step = 1e-5 * float(np.median(np.linalg.norm(xyz - np.median(xyz, axis=0), axis=1)))
    v = residuals_px(block, rows, xyz)
    return v, np.stack([(residuals_px(block, rows, xyz + step * u) - v) / step for u in np.eye(3)], axis=2)


def _by_point(point: Index, taken: Array) -> dict[int, Index]:
    rows = np.flatnonzero(taken)
    rows = rows[np.argsort(point[rows], kind="stable")]
    parts = np.split(rows, np.flatnonzero(np.diff(point[rows])) + 1) if len(rows) else []
    return {int(point[r[0]]): r for r in parts}


def _by_count(rows: Iterable[Index]) -> dict[int, Index]:
    """Rows (g, m) of points with m of them, the fewest first."""
    found: dict[int, list[Index]] = {}
    for r in rows:
        found.setdefault(len(r), []).append(r)
    return {m: np.array(found[m]) for m in sorted(found)}


@lru_cache(maxsize=64)
def _sets(rays: int) -> Index:
    """(c, rays) the scale of each image point, at most `MOST_WRONG` of them wrong; the first set has none."""
    found = [np.zeros(rays, np.int64)]
    for count in range(1, min(MOST_WRONG, rays) + 1):
        for which in combinations(range(rays), count):
            for scales in product(range(1, len(SCALES)), repeat=count):
                found.append(np.zeros(rays, np.int64))
                found[-1][list(which)] = scales
    return np.array(found)


def _solved(y: Array, A: Array) -> tuple[Array, Array, Array]:
    """Of g points with m rays under each set: log-likelihood (g, c), places (g, c, 3), covariances (g, c, 3, 3)."""
    w = np.array(SCALES)[_sets(y.shape[1])] ** -2.0
    N = np.einsum("cm,gmjk->gcjk", w, np.einsum("gmij,gmik->gmjk", A, A))
    b = np.einsum("cm,gmj->gcj", w, np.einsum("gmij,gmi->gmj", A, y))
    unit = 1 / np.sqrt(np.maximum(np.einsum("gjj->gj", N[:, 0]), 1e-300))
    N = N * unit[:, None, :, None] * unit[:, None, None, :]
    C = np.linalg.pinv(N, rcond=1 / CONDITION, hermitian=True) * unit[:, None, :, None] * unit[:, None, None, :]
    x = np.einsum("gcjk,gck->gcj", C, b)
    square = np.einsum("cm,gm->gc", w, (y**2).sum(axis=2)) - np.einsum("gcj,gcj->gc", x, b)
    sign, size = np.linalg.slogdet(N)
    return np.where(sign > 0, np.log(w).sum(axis=1) - size / 2, -np.inf) - square / 2, x, C


def _shares(parts: Sequence[tuple[Array, Array]], before: Sequence[float]) -> Array:
    """Shares of scales by likelihoods (g, c) of sets and how often each scale is in a set (c, scales)."""
    start = np.array(before)
    shares, n = start, sum(len(p) for p, _ in parts)
    for _ in range(ROUNDS):
        total = max(FEW - n, 0) * start
        for likely, count in parts:
            of = likely * np.exp(count @ np.log(np.maximum(shares, 1e-12)))
            total = total + (of / np.maximum(of.sum(axis=1, keepdims=True), 1e-300)).sum(axis=0) @ count
        shares = total / total.sum()
    return shares


@lru_cache(maxsize=8)
def _table(dof: int) -> tuple[Array, Array]:
    log = np.linspace(-20, 0, 81)
    return log, np.array([np.sqrt(detectable_noncentrality(min(float(np.exp(x)), 0.7), dof, POWER)) for x in log])


def _shifts(alpha: Array, dof: int) -> Array:
    """Standard deviations that tests at these significances detect with `POWER`."""
    return np.interp(np.log(alpha), *_table(dof))
