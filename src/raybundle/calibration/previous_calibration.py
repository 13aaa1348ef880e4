"""What becomes of a calibration that was given, held or with its covariance: whether it still holds.

Observations are weighted by white noise alone.  Where their errors are smooth, photographs have more weight against a
calibration than they deserve; standard deviations that contain such errors (noise of kind fields) show it: a parameter
may come out less precise than it was given.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.special import chdtri, fdtri

from raybundle.adjustment.decision.previous_knowledge import LEVEL
from raybundle.adjustment.engine import adjust_block, free_parameters
from raybundle.adjustment.records.figures import InteriorResult
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import NEARLY, Severity
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.interior import image_shifts
from raybundle.adjustment.system.adjusted_values import as_start
from raybundle.block import Camera
from raybundle.block.stored import joint_covariance
from raybundle.errors import Message, NotSolvable, Value, message, plain
from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import family_wise_normal, fisher_tail

LEAST_SHARE = 1e-6
"""Share of a parameter's variance that the photographs must take for it to be tested: less is rounding."""


def calibration_notices(result: Adjustment) -> tuple[Notice, ...]:
    """What there is to say of cameras that were given with the covariance of their calibration."""
    owners = {c.id: c for c in result.given.cameras}
    found: list[Notice] = []
    for interior in result.interior:
        camera = owners.get(interior.camera)
        symbols, covariance = ((), None) if camera is None else joint_covariance(camera)
        if camera is None or covariance is None or interior.image is not None:
            continue
        found += _contradicted(result, camera, interior)
        found += _outweighed(
            result, camera, interior, dict(zip(symbols, np.sqrt(np.diagonal(covariance)), strict=True))
        )
    return tuple(found)


def _contradicted(result: Adjustment, camera: Camera, interior: InteriorResult) -> list[Notice]:
    """Where the interior orientation lies beyond the calibration: v' C^-1 v, chi-square distributed or smaller.

    Under noise of kind fields it is larger by what fields make of the estimates, and the tests of the parameters, which
    contain that, decide by themselves.
    """
    square, count = 0.0, 0
    for g in result.groups:
        for k, (name, origin) in enumerate(zip(g.ids, g.origin, strict=False)):
            if name == camera.id and origin == "calibration":
                square, count = square + float(g.square[k]), count + 1
    limit = float(chdtri(count, LEVEL)) if count else np.inf
    if not square > limit:
        return []
    beyond, by = _worded(camera, _moved(result, camera, interior), count)
    fields = result.noise.kind == "fields"
    if fields and not beyond:
        return []
    values: dict[str, Value] = {
        "camera": camera.id, "squares": square, "n": count, "limit": limit, "level_percent": 100 * LEVEL,
        "smooth": not fields,
    }  # fmt: skip
    ids = (camera.id, *(m.symbol for m in beyond))
    return [Notice(code="calibration_contradicted", values=values, ids=ids, details=by)]


def held_notices(result: Adjustment, cameras: Sequence[str]) -> tuple[Notice, ...]:
    """Where the photographs contradict a calibration that was given to be held.

    cameras  whose whole interior orientation was given and is held
    The block is adjusted once more with the interior orientation free.  With d the differences of its u determined
    parameters from those held, and C their covariance from f residuals (of fields: directions), d' C^-1 d / u is
    distributed as F(u, f) if the calibration is right.  Beyond its limit it is mentioned where the difference moves
    image points by more than their standard deviation.
    It is a fault where the result suffers: where a projection centre of the camera moves, from the block with the
    calibration held to that with it free, by more than F(3, f) of its covariance in the latter allows, family-wise.
    Below, the photographs by themselves do not place the camera better than the calibration does.
    Limits: which of them is wrong where photographs determine only several parameters together.
    """
    found = [_contradicted_held(result, c) for c in result.given.cameras if c.id in cameras]
    return tuple(n for n in found if n is not None)


def _contradicted_held(result: Adjustment, camera: Camera) -> Notice | None:
    fields = result.noise.kind == "fields"
    free = _freed(result, camera, fields=False)
    if free is None or not _beyond_chance(free):
        return None  # smooth errors make it more probable still
    free = _freed(result, camera, fields=fields, whole=True)
    if free is None or not _beyond_chance(free):
        return None
    if not free.effect_px > free.sigma_px:
        return None
    _, by = _worded(camera, sorted(free.moved, key=lambda m: -abs(m.w)), len(free.moved))
    limit = float(fdtri(len(free.moved), free.residuals, 1 - LEVEL))
    farthest = float(free.centres.max(initial=0.0))
    allowed = float(fdtri(3, free.residuals, 1 - LEVEL / max(len(free.centres), 1)))
    suffers = farthest > allowed
    return Notice(
        code="calibration_contradicted.held" if suffers else "calibration_contradicted.harmless", details=by,
        ids=(camera.id, *(m.symbol for m in free.moved)),
        measured=Severity.FAULT if suffers else Severity.WARNING,
        values={
            "camera": camera.id, "F": free.F, "limit": limit, "n": len(free.moved), "level_percent": 100 * LEVEL,
            "effect_px": free.effect_px, "sigma_px": free.sigma_px, "centres": farthest, "centres_limit": allowed,
        },
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class _Freed:
    """An adjustment with the interior orientation free that was held, against what was held."""

    moved: list[_Moved]
    F: float
    residuals: int
    """degrees of freedom of the variance in it"""
    effect_px: float
    """by which the whole difference moves image points within the format, at most"""
    sigma_px: float
    """standard deviation of an image coordinate"""
    centres: Array
    """(n,) d' C^-1 d / 3 of the camera's projection centres, C as the block with free parameters states it"""


def _beyond_chance(free: _Freed) -> bool:
    return bool(free.moved) and fisher_tail(free.F, len(free.moved), free.residuals) < LEVEL


def _freed(result: Adjustment, camera: Camera, *, fields: bool, whole: bool = False) -> _Freed | None:
    """The same observations with this camera's interior orientation free; None where they do not determine it.

    whole  whether projection centres are compared, too
    """
    released = replace(camera, estimate="auto")
    symbols = free_parameters(released)
    block = as_start(result.given, result.adjusted)
    block = replace(
        block, cameras=tuple(replace(c, estimate=symbols) if c.id == camera.id else c for c in block.cameras)
    )
    options = replace(
        result.options, reject="none", estimate="given", statistics=True, robust_start=False,
        noise="fields" if fields else "white",
    )  # fmt: skip
    try:
        free = adjust_block(
            block, options, rejected=result.image_observations.rejected, start="adjusted",
            extent="report" if fields or whole else "decisions",
        )  # fmt: skip
    except NotSolvable:
        return None
    interior = next((i for i in free.interior if i.camera == camera.id and i.image is None), None)
    if interior is None or free.precision is None or free.redundancy < 1:
        return None
    estimated = [s for s in interior.free if interior.parameters[s].status == "estimated"]
    rows = [interior.free.index(s) for s in estimated]
    C = free.precision.interior[camera.id][np.ix_(rows, rows)]
    d = np.array([interior.parameters[s].value - camera.values[s] for s in estimated])
    if not estimated or not np.isfinite(C).all():
        return None
    model = camera.sensor
    shift = image_shifts(model, camera, camera.parameters)[:, :, [model.symbols.index(s) for s in estimated]] * d
    each = np.nanmax(np.linalg.norm(shift, axis=1), axis=0)
    size = np.sqrt(np.diagonal(C))
    unit = d / size
    used = free.image_observations.used
    given, found = camera.values, interior.parameters
    moved = [
        _Moved(symbol=s, given=given[s], found=found[s].value, std=float(e), effect_px=float(px))
        for s, e, px in zip(estimated, size, each, strict=True)
    ]
    return _Freed(
        moved=moved,
        F=float(unit @ np.linalg.solve(C / np.outer(size, size), unit)) / len(estimated),
        residuals=free.noise.directions if free.noise.kind == "fields" else free.redundancy,
        effect_px=float(np.nanmax(np.linalg.norm(shift.sum(axis=2), axis=1))),
        sigma_px=free.sigma0 * float(np.median(np.sqrt(free.given.observations.cov_px2[used, :2]))),
        centres=_centres(result, free, camera) if whole else np.zeros(0),
    )  # fmt: skip


def _centres(result: Adjustment, free: Adjustment, camera: Camera) -> Array:
    """Squares (n,) d' C^-1 d / 3 of the projection centres of a camera in two adjustments, in one datum."""
    assert free.precision is not None
    of_camera = np.array([c.id == camera.id for c in result.given.cameras])[result.given.images.camera]
    C = free.precision.images[:, :3, :3]
    mine = of_camera & np.isfinite(C).all(axis=(1, 2)) & (np.linalg.det(np.nan_to_num(C)) > 0)
    d = (free.adjusted.images.centre - result.adjusted.images.centre)[mine]
    return np.einsum("ni,ni->n", d, np.linalg.solve(C[mine], d[:, :, None])[:, :, 0]) / 3


def _worded(camera: Camera, moved: list[_Moved], count: int) -> tuple[list[_Moved], tuple[Message, ...]]:
    """The parameters of `count` that moved beyond their limit, and a message each; of the first where none did."""
    critical = family_wise_normal(LEVEL, count)
    beyond = [m for m in moved if abs(m.w) > critical]
    return beyond, tuple(m.message(camera, critical) for m in beyond or moved[:1])


@dataclass(frozen=True, slots=True, kw_only=True)
class _Moved:
    """A parameter as the calibration gave it and as the photographs have it."""

    symbol: str
    given: float
    found: float
    std: float
    """of their difference; of the one found, where what was given is held"""
    effect_px: float | None = None
    """by which the difference moves image points, at most, where what was given is held"""

    @property
    def w(self) -> float:
        """The difference by its standard deviation."""
        return (self.found - self.given) / self.std

    def message(self, camera: Camera, limit: float) -> Message:
        """Both values with as many digits as their difference has, and the unit; limit  of |w|."""
        unit = next(p.unit for p in camera.sensor.parameters if p.symbol == self.symbol)
        digits = 3 + max(0, math.floor(math.log10(max(abs(self.given), self.std) / self.std)))
        values: dict[str, Value] = {
            "symbol": self.symbol, "given": float(f"{self.given:.{digits}g}"),
            "found": float(f"{self.found:.{digits}g}"), "sigma": self.std, "unit": "" if unit == "1" else unit,
            "w": abs(self.w), "limit": limit, "alone": abs(self.w) > limit,
        }  # fmt: skip
        if self.effect_px is None:
            return Message(code="calibration_contradicted.given", values=plain(values))
        return Message(code="calibration_contradicted.moved", values=plain({**values, "effect_px": self.effect_px}))


def _moved(result: Adjustment, camera: Camera, interior: InteriorResult) -> list[_Moved]:
    """The calibrated parameters, the one that moved most of its standard deviations first.

    The residual v of a parameter that was given with the covariance C has the cofactor C - Q, Q that of the estimate
    with all observations; fields add to its variance what they add to that of the estimate, as C has no part in them.
    """
    known = camera.calibrated
    assert known is not None
    symbols, covariance, given = known.symbols, known.covariance, known.values
    found: list[_Moved] = []
    for k, s in enumerate(symbols):
        p = interior.parameters[s]
        if p.std is None:
            continue
        white = p.std if p.std_white is None else p.std_white
        own = float(covariance[k, k]) - (white / result.sigma0) ** 2
        variance = max(own, 0.0) + p.std**2 - white**2
        if own > LEAST_SHARE * covariance[k, k]:
            found.append(_Moved(symbol=s, given=given[k], found=p.value, std=math.sqrt(variance)))
    return sorted(found, key=lambda m: -abs(m.w))


def _wider(result: Adjustment) -> float:
    """Ratio of the standard deviations, afterwards and as given, from which on the calibration was outweighed.

    Afterwards they rest on a mean square of f residuals: of all, sigma0^2, or under noise of kind fields of those in
    the directions that fields move.  Where both are alike in truth, chi-square_f / f keeps its root below the limit
    with 1 - LEVEL.  What is less than NEARLY states nothing for any use.
    """
    f = result.noise.directions if result.noise.kind == "fields" else result.redundancy
    return max(NEARLY, math.sqrt(float(chdtri(f, LEVEL)) / f)) if f > 0 else math.inf


def _outweighed(result: Adjustment, camera: Camera, interior: InteriorResult, given: dict[str, float]) -> list[Notice]:
    """Parameters that the result states less precisely than the calibration did."""
    limit = _wider(result)
    found: list[Message] = []
    for symbol, before in given.items():
        after = interior.parameters[symbol].std if symbol in interior.parameters else None
        if after is not None and after > limit * before:
            found.append(message("calibration_outweighed.parameter", symbol=symbol, before=float(before), after=after))
    if not found:
        return []
    values: dict[str, Value] = {"camera": camera.id, "n": len(found), "limit": limit}
    return [Notice(code="calibration_outweighed", values=values, ids=(camera.id, *given), details=tuple(found))]
