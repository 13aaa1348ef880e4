"""Cross-validation of a calibration: photographs that took no part, oriented with it, tell how well it carries over."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.assemble import State, System
from raybundle.adjustment.engine import carry_out
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.reliability import image_statistics
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Role, no_attitudes, no_stations
from raybundle.block.select import with_rows
from raybundle.errors import NotSolvable, RaybundleError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent

FOLDS = 5
NEAR = 1e-4
"""Where an adjustment may end: last step in standard deviations."""
LEAST_POINTS = 6
"""Points by which a photograph that was left out is oriented."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CrossValidation:
    """Residuals of photographs that took no part in the calibration they are oriented with."""

    folds: int
    rms_px: float
    """Root mean square image coordinate residual of the photographs left out"""
    fit_px: float
    """The same of the photographs that took part, over all folds"""
    images: Array
    """(n,) rms [px] of each photograph when it was left out; NaN where it could not be oriented"""

    @property
    def ratio(self) -> float:
        """1: the calibration carries over as well as it fits; more: it fits its own photographs only."""
        return self.rms_px / self.fit_px


def cross_validation(result: Adjustment, *, folds: int = FOLDS, progress: Progress = silent) -> CrossValidation | None:
    """Leave photographs out in turn, calibrate with the others, orient those left out by points held; see there.

    None where a fold leaves too little to calibrate with.  Residuals of both kinds are divided by the root of their
    redundancy share, so that the few unknowns of an orientation do not make them look small.
    What it does not tell: errors that all photographs share.
    """
    block = replace(result.adjusted, observations=result.given.observations)
    used = result.image_observations.used
    free = _free(result)
    images = np.flatnonzero(np.bincount(block.observations.image[used], minlength=len(block.images)) > 0)
    folds = min(folds, len(images) // 2)
    if folds < 3:
        return None
    square, count, fit_square, fit_count = 0.0, 0.0, 0.0, 0.0
    each = np.full(len(block.images), np.nan)
    options = replace(
        result.options, reject="none", estimate="given", statistics=False, robust_start=False, tolerance=NEAR
    )
    for k in range(folds):
        progress("cross-validation", k / folds)
        out: Mask = np.zeros(len(block.images), bool)
        out[images[k::folds]] = True
        try:
            part = _kept(block, used & ~out[block.observations.image])
            own = _adjusted(part, options, free)
            left = _left_out(block, part, own, used & out[block.observations.image])
            held = _adjusted(left, replace(options, datum="control"), {c.id: () for c in left.cameras})
        except (RaybundleError, NotSolvable):
            return None
        v = held.residuals_px
        share = held.redundancy / v.size
        square += float((v**2).sum()) / share
        count += v.size
        for i in np.unique(held.image):
            each[i] = np.sqrt(np.mean(v[held.image == i] ** 2) / share)
        fit = own.residuals_px
        fit_square += float((fit**2).sum()) * fit.size / own.redundancy
        fit_count += fit.size
    progress("cross-validation", 1.0)
    return CrossValidation(
        folds=folds, rms_px=float(np.sqrt(square / count)), fit_px=float(np.sqrt(fit_square / fit_count)), images=each
    )


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


def _kept(block: Block, keep: Mask) -> Block:
    rays = np.bincount(block.observations.point[keep], minlength=len(block.points))
    return with_rows(block, keep & (rays[block.observations.point] > 1))


def _adjusted(block: Block, options: AdjustmentOptions, free: dict[str, tuple[str, ...]]) -> _Adjusted:
    work, reasons = carry_out(block, options, free, ("",) * len(block.observations), start="adjusted")
    system, state = work.system, work.solution.state
    whitened, _ = work.normals.residuals(state)
    v = image_statistics(system, whitened, None, 1.0, reasons).residuals_px[system.rows]
    return _Adjusted(
        system=system, state=state, residuals_px=v, image=block.observations.image[system.rows],
        redundancy=system.observations - system.unknowns + work.datum.defect,
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
        if row.image < 0:
            values = {row.model.symbols[k]: float(own.state.interior[r, k]) for k in row.carries}
            cameras[row.camera] = replace(cameras[row.camera], values={**cameras[row.camera].values, **values})
    return replace(
        part,
        cameras=tuple(cameras),
        points=replace(part.points, xyz=xyz, sigma=np.zeros((n, 3)), role=np.full(n, Role.CONTROL, np.int32)),
        distances=replace(
            part.distances, start=part.distances.start[:0], end=part.distances.end[:0],
            length=part.distances.length[:0], sigma=part.distances.sigma[:0],
        ),
        stations=no_stations(),
        attitudes=no_attitudes(),
    )  # fmt: skip
