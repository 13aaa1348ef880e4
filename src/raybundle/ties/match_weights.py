"""Variances of tie points measured by least-squares matching, from the residuals of the block they belong to."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.matching.refine import LEVELS
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.ties.block import FEATURE_SIGMA_PX

MOST_FEATURE_PX = 5.0
"""Largest standard deviation that the residuals can give a feature: verification leaves none beyond 6 px."""
CLASSES = 10
"""Of equal number in each level of the pyramid, where that leaves each `FEWEST` points."""
FEWEST = 20
LEAST_FLOOR_PX2 = 0.01**2
CONTROLLED = 0.2
"""Redundancy of a point from which on its residuals show its variance."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Matches:
    """What the variances of measured image points depend on: these can be estimated again from other residuals."""

    images: tuple[str, ...]
    image: Index
    """(m,) in `images`"""
    xy_px: Array
    grey: Array
    """(m, 3) covariances from grey values alone"""
    level: Index
    reference: Mask
    feature: Mask

    FIGURES = ("grey", "level", "reference", "feature")

    def found_in(self, block: Block) -> tuple[Index, Index]:
        """Rows of image points of a block that were measured here, and where each stands here."""
        number = {name: k for k, name in enumerate(block.images.ids)}
        image = np.array([number.get(name, -1) for name in self.images])[self.image]
        o = block.observations
        both = np.vstack([np.column_stack([o.image, o.xy_px]), np.column_stack([image, self.xy_px])])
        key = np.unique(both, axis=0, return_inverse=True)[1].ravel()
        here = np.full(key.max(initial=-1) + 1, -1)
        here[key[len(o) :]] = np.arange(len(self.image))
        at = here[key[: len(o)]]
        rows = np.flatnonzero(at >= 0)
        return rows, at[rows]


@dataclass(frozen=True, slots=True, kw_only=True)
class Weights:
    """Variance of a least-squares match: factor * (covariance from grey values) + floor; of references; of features.

    Grey values alone are true where windows are plane (`with_noisy_gradients`); a window at a coarse level covers more
    of the relief, so that every level has a factor and a floor of its own.
    """

    factors: tuple[float, ...] = (1.0, 1.7, 2.6, 4.0)
    """of the levels, finest first; to begin with what a rendered facade shows, of which the truth is known"""
    floors_px2: tuple[float, ...] = (0.03**2, 0.06**2, 0.12**2, 0.24**2)
    reference_px2: float = 0.1**2
    feature_px2: float = FEATURE_SIGMA_PX**2

    @classmethod
    def of(cls, values: Array) -> Weights:
        """The weights that `array` gave."""
        reference, feature, *levels = values.tolist()
        factors, floors = tuple(levels[:LEVELS]), tuple(levels[LEVELS:])
        return cls(factors=factors, floors_px2=floors, reference_px2=reference, feature_px2=feature)

    def array(self) -> Array:
        """The values, to be stored."""
        return np.array([self.reference_px2, self.feature_px2, *self.factors, *self.floors_px2])

    def covariance(self, grey: Array, level: Index, reference: Mask, feature: Mask | None = None) -> Array:
        """(m, 3) variances and covariances [px^2].

        grey   (m, 3) from grey values alone
        level  (m,) of the pyramid
        """
        of = np.minimum(level, LEVELS - 1)
        cov = np.array(self.factors)[of][:, None] * grey
        cov[:, :2] += np.array(self.floors_px2)[of][:, None]
        cov[reference] = self.reference_px2, self.reference_px2, 0.0
        if feature is not None:
            cov[feature] = self.feature_px2, self.feature_px2, 0.0
        return cov


def estimate_weights(
    result: Adjustment, grey: Array, level: Index, reference: Mask, before: Weights, feature: Mask | None = None,
    known: Mask | None = None,
) -> Weights:  # fmt: skip
    """Variance components by the precision that the grey values promise.

    In classes of equal number, sum v^2 / sum r estimates the variance of an image coordinate (Förstner 1979); what the
    classes of a level have in common gives its factor and its floor (non-negative least squares in relative errors).
    References and features are classes of their own.  A level with too few points keeps its ratios to the finer one.
    Rows that are not `known` (None: all are) have variances of their own, and count for none.
    """
    other = np.zeros(len(reference), bool) if feature is None else feature
    s = result.image_observations
    v2 = (s.residuals_px**2).sum(axis=1)
    r = np.nan_to_num(s.redundancy.sum(axis=1))
    testable = s.used & (r > CONTROLLED)
    if known is not None:
        testable &= known

    def component(mine: Mask, instead: float, least: float, most: float) -> float:
        return float(np.clip(v2[mine].sum() / r[mine].sum(), least, most)) if mine.sum() > FEWEST else instead

    features = component(testable & other, before.feature_px2, 0.02**2, MOST_FEATURE_PX**2)
    mine = testable & ~reference & ~other
    if mine.sum() < FEWEST * CLASSES:
        return replace(before, feature_px2=features)
    factors, floors = _levels(v2[mine], r[mine], (grey[mine, 0] + grey[mine, 1]) / 2, level[mine], before)
    return Weights(
        factors=factors,
        floors_px2=floors,
        reference_px2=component(testable & reference, before.reference_px2, 0.02**2, 1.0),
        feature_px2=features,
    )


def weights_again(result: Adjustment, matches: Sequence[Matches], before: Weights) -> Weights:
    """The weights by the residuals of another adjustment of what was matched."""
    grey, level, reference, feature, known = _figures(result.given, matches)
    return estimate_weights(result, grey, level, reference, before, feature, known)


def weighted(block: Block, matches: Sequence[Matches], weights: Weights) -> Block:
    """The block with variances of its matches by these weights."""
    grey, level, reference, feature, known = _figures(block, matches)
    o = block.observations
    cov = np.where(known[:, None], weights.covariance(grey, level, reference, feature), o.cov_px2)
    return replace(block, observations=replace(o, cov_px2=cov))


def _figures(block: Block, matches: Sequence[Matches]) -> tuple[Array, Index, Mask, Mask, Mask]:
    """`Matches.FIGURES` of the image points of a block, and which of them are matches."""
    m = len(block.observations)
    grey, level = np.zeros((m, 3)), np.zeros(m, np.int64)
    reference, feature, known = (np.zeros(m, bool) for _ in range(3))
    for each in matches:
        rows, at = each.found_in(block)
        grey[rows], level[rows], reference[rows], feature[rows] = (getattr(each, n)[at] for n in Matches.FIGURES)
        known[rows] = True
    return grey, level, reference, feature, known


def _levels(
    v2: Array, r: Array, grey: Array, level: Index, before: Weights
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """A factor and a floor [px^2] for each level."""
    factors, floors = list[float](), list[float]()
    for k in range(LEVELS):
        mine = np.flatnonzero(level == k)
        if len(mine) >= FEWEST * CLASSES / 2:
            order = mine[np.argsort(grey[mine], kind="stable")]
            factor, floor = _line(
                [(v2[p], r[p], grey[p]) for p in np.array_split(order, min(CLASSES, len(mine) // FEWEST))]
            )
        elif k == 0:
            factor, floor = before.factors[0], before.floors_px2[0]
        else:
            factor = factors[-1] * before.factors[k] / max(before.factors[k - 1], 1e-9)
            floor = floors[-1] * before.floors_px2[k] / before.floors_px2[k - 1]
        factors.append(factor)
        floors.append(max(floor, LEAST_FLOOR_PX2))
    return tuple(factors), tuple(floors)


def _line(classes: Sequence[tuple[Array, Array, Array]]) -> tuple[float, float]:
    """Factor and floor through classes of squared residuals, redundancy and variances from grey values."""
    from scipy.optimize import nnls

    grey = np.array([g.mean() for _, _, g in classes])
    variance = np.array([v.sum() / max(r.sum(), 1e-9) for v, r, _ in classes])
    weight = np.sqrt([len(g) for _, _, g in classes]) / np.maximum(variance, 1e-12)  # known to a share of itself
    (factor, floor), _ = nnls(np.stack([grey, np.ones(len(grey))], axis=1) * weight[:, None], variance * weight)
    return float(factor), float(floor)
