"""Cross-validation of a calibration: photographs that took no part, oriented with it, show how well it carries over."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.estimation import carry_out
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.reliability import image_statistics
from raybundle.adjustment.system.assemble import State, System
from raybundle.block import Block, Role
from raybundle.block.select import with_rows
from raybundle.errors import NotSolvable, RaybundleError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent

FOLDS = 5
FEWEST = 4
"""Photographs of a camera from which on some can be left out."""
NEAR = 1e-4
"""Where an adjustment may end: last step in standard deviations."""
LEAST_POINTS = 6
"""Points by which a photograph that was left out is oriented."""
ALPHA = 0.001
"""Probability with which a camera that is the same in all photographs is accused, all folds together."""
SLACK = 1.3
"""Factor by which standard deviations are taken too small before that is called a contradiction: variances of groups of
observations are known to some ten per cent, which the test would find in any set with thousands of residuals."""
WORSE = 1.3
"""Factor of residuals of photographs left out, from which on it is explained."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CrossValidation:
    """Photographs of a camera that took no part in the calibration, against what it predicts of them.

    Two figures.  Oriented by the points and the camera held, photographs left out show the errors of both besides
    their own: their residuals are larger the fewer the views, and accuse nobody.  What is tested is whether they are as
    large as predicted, with the joint covariance of points and camera: in a Gauss-Markov model that weighted sum of
    squares is the growth of the minimum when they take part, Omega(all) - Omega(without), with as many degrees of
    freedom as the redundancy grows by; over the variance of the others it has Fisher's distribution (Chow 1960).
    """

    folds: int
    rms_px: float
    """Root mean square image coordinate residual of the photographs left out, points and camera held"""
    fit_px: float
    """The same of the photographs that took part, over all folds"""
    images: Array
    """(n,) rms [px] of each photograph when it was left out; NaN where it could not be oriented"""
    statistic: Array
    """(folds,) mean square of the photographs left out by their predicted covariance, over that of the others"""
    limit: Array
    """(folds,) of the statistic, for ALPHA over all folds, if the camera is the same in all photographs"""

    @property
    def ratio(self) -> float:
        """Residuals of photographs left out, points and camera held, over those of photographs that took part."""
        return self.rms_px / self.fit_px

    @property
    def excess(self) -> float:
        """Standard deviations of the worst fold over those predicted, as far as chance does not explain it."""
        return float(np.sqrt(np.max(self.statistic / self.limit)))

    @property
    def contradicts(self) -> bool:
        """Whether photographs left out are not as predicted: the camera, or the object, was not the same."""
        return self.excess > SLACK

    @property
    def few_views(self) -> bool:
        """Whether photographs left out fit worse, as predicted: too few views, not another camera."""
        return not self.contradicts and self.ratio > WORSE


def cross_validation(
    result: Adjustment, camera: str, *, folds: int = FOLDS, progress: Progress = silent
) -> CrossValidation | None:
    """Leave photographs of a camera out in turn, calibrate with all others, predict those left out; see there.

    None where there are fewer than FEWEST photographs, or a fold leaves too little to calibrate with.  Residuals are
    divided by the root of their redundancy share, so that the few unknowns of an orientation do not make them look
    small.  Limits: errors that all photographs share.
    """
    from scipy.special import fdtri

    block = replace(result.adjusted, observations=result.given.observations)
    k = next(i for i, c in enumerate(block.cameras) if c.id == camera)
    used = result.image_observations.used
    free = _free(result)
    seen = np.bincount(block.observations.image[used], minlength=len(block.images)) > 0
    images = np.flatnonzero(seen & (block.images.camera == k))
    if len(images) < FEWEST:
        return None
    folds = min(folds, len(images))
    options = replace(
        result.options, reject="none", estimate="given", statistics=False, robust_start=False, tolerance=NEAR
    )
    done: list[_Fold] = []
    each = np.full(len(block.images), np.nan)
    try:
        whole = _adjusted(_kept(block, used), options, free)
        for f in range(folds):
            progress("cross-validation", f / folds)
            done.append(_fold(block, whole, used, images[f::folds], options, free, each))
    except (RaybundleError, NotSolvable):
        return None
    progress("cross-validation", 1.0)
    if not all(d.grown > 0 and d.left > 0 for d in done):
        return None
    return CrossValidation(
        folds=folds,
        rms_px=float(np.sqrt(sum(d.out for d in done) / sum(d.out_count for d in done))),
        fit_px=float(np.sqrt(sum(d.fit for d in done) / sum(d.fit_count for d in done))),
        images=each,
        statistic=np.array([d.statistic for d in done]),
        limit=np.array([float(fdtri(d.grown, d.left, 1 - ALPHA / folds)) for d in done]),
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class _Fold:
    """One adjustment without some photographs."""

    statistic: float
    grown: int
    """Degrees of freedom that the photographs left out bring"""
    left: int
    """Degrees of freedom without them"""
    out: float
    """Sum of squares [px^2] of photographs left out, for a redundancy share of one, and its count"""
    out_count: int
    fit: float
    fit_count: int


def _fold(
    block: Block, whole: _Adjusted, used: Mask, left_out: Index, options: AdjustmentOptions,
    free: dict[str, tuple[str, ...]], each: Array,
) -> _Fold:  # fmt: skip
    """Leave these photographs out; their rms is written into `each`."""
    out: Mask = np.zeros(len(block.images), bool)
    out[left_out] = True
    part = _kept(block, used & ~out[block.observations.image])
    own = _adjusted(part, options, free)
    left = _left_out(block, part, own, used & out[block.observations.image])
    held = _adjusted(left, replace(options, datum="control"), {c.id: () for c in left.cameras})
    v, fit = held.residuals_px, own.residuals_px
    share = held.redundancy / v.size
    for i in np.unique(held.image):
        each[i] = np.sqrt(np.mean(v[held.image == i] ** 2) / share)
    grown = whole.redundancy - own.redundancy
    return _Fold(
        statistic=(whole.square - own.square) / max(grown, 1) / (own.square / own.redundancy), grown=grown,
        left=own.redundancy, out=float((v**2).sum()) / share, out_count=v.size,
        fit=float((fit**2).sum()) * fit.size / own.redundancy, fit_count=fit.size,
    )  # fmt: skip


def _free(result: Adjustment) -> dict[str, tuple[str, ...]]:
    free: dict[str, tuple[str, ...]] = {c.id: () for c in result.given.cameras}
    return free | {i.camera: i.free for i in result.interior}


@dataclass(frozen=True, slots=True, kw_only=True)
class _Adjusted:
    """What is needed of an adjustment; all else is left out, since there are many."""

    system: System
    state: State
    residuals_px: Array
    """(m, 2) of the rows that took part"""
    image: Index
    """(m,) of these rows"""
    redundancy: int
    square: float
    """Weighted sum of squares of all observations"""


def _kept(block: Block, keep: Mask) -> Block:
    rays = np.bincount(block.observations.point[keep], minlength=len(block.points))
    return with_rows(block, keep & (rays[block.observations.point] > 1))


def _adjusted(block: Block, options: AdjustmentOptions, free: dict[str, tuple[str, ...]]) -> _Adjusted:
    work, reasons = carry_out(block, options, free, (None,) * len(block.observations), start="adjusted")
    system, state = work.system, work.solution.state
    whitened, _ = work.normals.residuals(state)
    v = image_statistics(system, whitened, None, 1.0, reasons).residuals_px[system.rows]
    return _Adjusted(
        system=system, state=state, residuals_px=v, image=block.observations.image[system.rows],
        redundancy=system.observations - system.unknowns + work.datum.defect, square=2 * work.solution.cost,
    )  # fmt: skip


def _left_out(block: Block, kept: Block, own: _Adjusted, rows: Mask) -> Block:
    """The photographs left out, with the points that the others know held, and their cameras."""
    place = {name: k for k, name in enumerate(kept.points.ids)}
    of: Index = np.array([place.get(name, -1) for name in block.points.ids], np.int32)
    rows = rows & (of[block.observations.point] >= 0)
    count = np.bincount(block.observations.image[rows], minlength=len(block.images))
    rows &= count[block.observations.image] >= LEAST_POINTS
    part = with_rows(block, rows)
    xyz = (own.state.xyz + own.system.shift)[[place[name] for name in part.points.ids]]
    n = len(part.points)
    cameras = [replace(c, estimate=(), sigma={}) for c in kept.cameras]
    for r, row in enumerate(own.system.interior):
        if row.image < 0 <= row.camera:
            values = {row.model.symbols[k]: float(own.state.interior[r, k]) for k in row.carries}
            cameras[row.camera] = replace(cameras[row.camera], values={**cameras[row.camera].values, **values})
    points = replace(part.points, xyz=xyz, sigma=np.zeros((n, 3)), role=np.full(n, Role.CONTROL, np.int32))
    return replace(part, cameras=tuple(cameras), points=points, tables={})
