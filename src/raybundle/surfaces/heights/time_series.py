"""Volumes of several dates above one base, and what changed from date to date, by their joint covariance.

All are sums of heights of all dates with weights.  Errors of orientation that two dates have in common count once; the
base is one, and no change depends on it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.special import ndtr, ndtri

from raybundle.metrology.trends import Series, Trend, trend
from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.heights.cut_and_fill import Signs
from raybundle.surfaces.heights.height_model import HeightModel, SumOfHeights
from raybundle.surfaces.heights.level_of_detection import FOUND
from raybundle.surfaces.heights.resampling import one_measurement
from raybundle.surfaces.heights.volumes import base_of


@dataclass(frozen=True, slots=True, kw_only=True)
class JointHeights:
    """Heights of several dates on one grid."""

    models: tuple[HeightModel, ...]

    @property
    def _spans(self) -> list[slice]:
        """Which of all independent errors those of each date are; dates that name theirs alike have the same."""
        found, known, end = list[slice](), dict[tuple[str, int], slice](), 0
        for m in self.models:
            q = m.moved.shape[3]
            mine = known.get((m.errors, q)) if m.errors else None
            if mine is None:
                mine = slice(end, end + q)
                end += q
                known[m.errors, q] = mine
            found.append(mine)
        return found

    def sum_of(self, weights: Mapping[int, Array]) -> SumOfHeights:
        """The sum of heights times weights (rows, columns) of some dates."""
        spans = self._spans
        moved = np.zeros(max(s.stop for s in spans))
        sums = {k: self.models[k].sum_of(w) for k, w in weights.items()}
        for k, s in sums.items():
            moved[spans[k]] += s.moved
        local = float(np.linalg.norm([s.local for s in sums.values()]))
        return SumOfHeights(value=sum(s.value for s in sums.values()), local=local, moved=moved)

    def covariance(self, weights: Sequence[Mapping[int, Array]]) -> Array:
        """(n, n) covariance of n sums of heights; weights that two have of one date may be one array."""
        moved = np.array([self.sum_of(w).moved for w in weights])
        found = moved @ moved.T
        for date, model in enumerate(self.models):
            arrays = {id(w[date]): w[date] for w in weights if date in w}
            local = {
                frozenset((a, b)): model.sum_of(x if a == b else x + y).local ** 2
                for a, x in arrays.items() for b, y in arrays.items() if a <= b
            }  # fmt: skip
            for i, w in enumerate(weights):
                for j, v in enumerate(weights):
                    if date in w and date in v:
                        a, b = id(w[date]), id(v[date])
                        own = local[frozenset((a,))], local[frozenset((b,))]
                        found[i, j] += own[0] if a == b else (local[frozenset((a, b))] - sum(own)) / 2
        return found


@dataclass(frozen=True, slots=True, kw_only=True)
class Change:
    """What changed in a region between two dates."""

    begin: int
    end: int
    """dates"""
    net: SumOfHeights
    fill: SumOfHeights
    cut: SumOfHeights
    """positive: what is missing"""
    limit: float
    """of values over their standard deviations"""

    @property
    def detectable(self) -> float:
        """The smallest change of the volume that is found with a probability of 80 %."""
        return (self.limit + float(ndtri(FOUND))) * self.net.sigma

    def significant(self, of: SumOfHeights) -> bool:
        """Whether net, fill or cut is more than chance."""
        return bool(abs(of.value) > self.limit * of.sigma)


def probability(of: SumOfHeights) -> float:
    """Of a value as large by chance."""
    return 2 * float(ndtr(-abs(of.value) / of.sigma)) if of.sigma else float(of.value == 0)


@dataclass(frozen=True, slots=True, kw_only=True)
class RegionSeries:
    """The volumes of a region."""

    name: str
    covered: Array
    """(rows, columns) share of each cell"""
    plan_area: float
    volumes: Array
    """(dates,) net, above the base"""
    covariance: Array
    """(dates, dates)"""
    filled: Array
    """(dates,) share of the plan area whose heights were interpolated"""
    changes: tuple[Change, ...]
    """from date to date, and from the first to the last where there are more than two"""

    @property
    def sigma(self) -> Array:
        """(dates,) standard deviations of the volumes."""
        return np.sqrt(np.diag(self.covariance))


@dataclass(frozen=True, slots=True, kw_only=True)
class RegionWeights:
    """A region whose volumes are wanted, of one part or more."""

    name: str
    parts: tuple[tuple[Array, float | tuple[Array, ...]], ...]
    """of each (rows, columns) the share of each cell, and its base: a height, or rings (n, 2) along which heights of
    the first date make a plane"""


def intervals(dates: int) -> list[tuple[int, int]]:
    """From date to date, and from the first to the last."""
    return [*pairwise(range(dates)), *([(0, dates - 1)] if dates > 2 else [])]


def time_series(
    models: Sequence[HeightModel], regions: Sequence[RegionWeights], significance: float,
    below: HeightModel | None = None,
) -> tuple[RegionSeries, ...]:  # fmt: skip
    """Volumes and their changes.

    significance  probability of any net change, cut or fill of any region and interval that is chance (Bonferroni)
    below         heights of a base on the same grid; one of the models, too
    raises        InputError where a cell within has no height
    """
    tests = 3 * len(regions) * len(intervals(len(models)))
    limit = float(-ndtri(significance / 2 / tests))
    own = next((k for k, m in enumerate(models) if m is below), None)
    joint = JointHeights(models=(*models, below) if below is not None and own is None else tuple(models))
    parts = [_Interval.of(joint, a, b) for a, b in intervals(len(models))]
    base = len(joint.models) - 1 if below is not None and own is None else own
    return tuple(_region(joint, r, len(models), parts, (base, limit)) for r in regions)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Interval:
    """Which cells rose between two dates, and which are not of one measurement."""

    begin: int
    end: int
    signs: Signs
    differs: Mask

    @classmethod
    def of(cls, joint: JointHeights, begin: int, end: int) -> _Interval:
        a, b = joint.models[begin], joint.models[end]
        d = np.where(a.known & b.known, b.heights.height.astype(float) - a.heights.height, np.nan)
        sigma = np.hypot(a.local, b.local)
        signs = Signs.of(d, sigma, max(a.length, b.length))
        return cls(begin=begin, end=end, signs=signs, differs=~one_measurement(a, b))


def _region(
    joint: JointHeights, r: RegionWeights, dates: int, parts: Sequence[_Interval], base: tuple[int | None, float]
) -> RegionSeries:
    """Of one region."""
    first, (below, limit) = joint.models[0], base
    covered = np.sum([c for c, _ in r.parts], axis=0)
    w = covered * first.cell**2
    weights, less, bent = [{k: w} for k in range(dates)], np.zeros(w.shape), [0.0]
    ground = np.zeros(w.shape)
    for part, rests_on in r.parts if below is None else []:
        rests = base_of(first, rests_on if isinstance(rests_on, int | float) else list(rests_on))
        ground += rests.plane * part
        less -= rests.spread(part * first.cell**2)
        bent.append(rests.bent(part * first.cell**2))
    if below is not None:
        ground, less = covered * np.nan_to_num(joint.models[below].heights.height), -w
    rim = 0 if below is None else below
    for each in weights:
        each[rim] = each[rim] + less if rim in each else less
    volumes = [
        float((w * np.nan_to_num(m.heights.height.astype(float))).sum() - ground.sum() * first.cell**2)
        for m in joint.models[:dates]
    ]
    covariance = joint.covariance(weights) + float(np.linalg.norm(bent)) ** 2
    filled = [
        0.0 if m.holes is None else float(covered[m.holes.filled].sum() / covered.sum()) for m in joint.models[:dates]
    ]
    return RegionSeries(
        name=r.name, covered=covered, plan_area=float(w.sum()), volumes=np.array(volumes), covariance=covariance,
        filled=np.array(filled), changes=tuple(_change(joint, w, p, limit) for p in parts),
    )  # fmt: skip


def _change(joint: JointHeights, w: Array, part: _Interval, limit: float) -> Change:
    """Of one region and interval."""

    def summed(weights: Array) -> SumOfHeights:
        # what is one measurement in both has not changed
        each = np.where(part.differs, weights, 0.0)
        return joint.sum_of({part.begin: -each, part.end: each})

    net, fill, cut = part.signs.cut_and_fill(w, summed)
    return Change(begin=part.begin, end=part.end, limit=limit, net=net, fill=fill, cut=cut)


def rates(regions: Sequence[RegionSeries], days: Array) -> tuple[Trend | None, ...]:
    """The constant rate of each region by three dates or more, and whether it fits.

    days  (dates,) of the dates; none: they are not known
    """
    if len(days) < 3:
        return tuple(None for _ in regions)
    n = len(days) - 1
    less = np.hstack([-np.ones((n, 1)), np.eye(n)])
    return tuple(
        trend(
            Series(
                name=r.name, area=True, first=0, dates=tuple(range(1, n + 1)), days=days[1:] - days[0],
                displacement=(less @ r.volumes)[:, None], covariance=less @ r.covariance @ less.T,
            ),
            np.inf,
        )
        for r in regions
    )  # fmt: skip
