"""What becomes of a calibration that was given with its covariance: whether it still holds, and what it is left to say.

Observations are weighted by white noise alone.  Where their errors are smooth, photographs have more weight against a
calibration than they deserve; standard deviations that contain such errors (noise of kind fields) show it: a parameter
may come out less precise than it was given.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.special import chdtri

from raybundle.adjustment.known_before import LEVEL
from raybundle.adjustment.result import Adjustment, InteriorResult, Notice
from raybundle.adjustment.severity import NEARLY
from raybundle.block import Camera
from raybundle.block.stored import joint_covariance
from raybundle.numerics.statistics import family_wise_normal

TOLD = 1e-6
"""Share of a parameter's variance that the photographs must take for it to be tested: less is rounding."""


def calibration_notices(result: Adjustment) -> tuple[Notice, ...]:
    """What there is to say of cameras that were given with the covariance of their calibration."""
    cameras = {c.id: c for c in result.given.cameras}
    found: list[Notice] = []
    for interior in result.interior:
        camera = cameras[interior.camera]
        symbols, covariance = joint_covariance(camera)
        if covariance is None or interior.image is not None:
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
                square, count = square + float((g.residual[k] / g.sigma[k]) ** 2), count + 1
    limit = float(chdtri(count, LEVEL)) if count else np.inf
    if not square > limit:
        return []
    moved = _moved(result, camera, interior)
    critical = family_wise_normal(LEVEL, count)
    beyond = [m for m in moved if abs(m.w) > critical]
    fields = result.noise.kind == "fields"
    if fields and not beyond:
        return []
    each = "; ".join(f"{m.words(camera)}, |w| {abs(m.w):.1f}" for m in beyond or moved[:1])
    by = f"{each} (limit {critical:.1f})" if beyond else f"{each} (limit {critical:.1f}: only all together)"
    smooth = "" if fields else ", or the errors of the photographs are smooth, which their weights do not know"
    message = (
        f"camera {camera.id}: the photographs contradict its calibration: {by}; chi-square of all {count} parameters "
        f"{square:.0f}, limit {limit:.1f} at {100 * LEVEL:g} %. Focus, zoom or mounting was another{smooth}. Calibrate "
        "under the conditions of the photographs, or hold the calibration (estimate = [])"
    )
    return [Notice(code="calibration_contradicted", message=message, ids=(camera.id, *(m.symbol for m in beyond)))]


@dataclass(frozen=True, slots=True, kw_only=True)
class _Moved:
    """A parameter as the calibration gave it and as the photographs have it."""

    symbol: str
    given: float
    found: float
    std: float
    """of their difference"""

    @property
    def w(self) -> float:
        """The difference by its standard deviation."""
        return (self.found - self.given) / self.std

    def words(self, camera: Camera) -> str:
        """Both values with as many digits as their difference has, and the unit."""
        unit = next(p.unit for p in camera.sensor.parameters if p.symbol == self.symbol)
        digits = 3 + max(0, math.floor(math.log10(max(abs(self.given), self.std) / self.std)))
        shown = f"{self.symbol} given {self.given:.{digits}g}, found {self.found:.{digits}g}"
        return shown if unit == "1" else f"{shown} {unit}"


def _moved(result: Adjustment, camera: Camera, interior: InteriorResult) -> list[_Moved]:
    """The calibrated parameters, the one that moved most of its standard deviations first.

    The residual v of a parameter that was given with the covariance C has the cofactor C - Q, Q that of the estimate
    with all observations; fields add to its variance what they add to that of the estimate, as C has no part in them.
    """
    symbols, covariance = joint_covariance(camera)
    assert covariance is not None
    relations = {tuple(sorted(r.terms)): r for r in camera.relations if r.origin == "calibration"}
    rows = [relations[tuple(sorted(symbols[: k + 1]))] for k in range(len(symbols))]
    given = np.linalg.solve(
        np.array([[r.terms.get(s, 0.0) for s in symbols] for r in rows]), [r.observed for r in rows]
    )
    found: list[_Moved] = []
    for k, s in enumerate(symbols):
        p = interior.parameters[s]
        if p.std is None:
            continue
        white = p.std if p.std_white is None else p.std_white
        own = float(covariance[k, k]) - (white / result.sigma0) ** 2
        variance = max(own, 0.0) + p.std**2 - white**2
        if own > TOLD * covariance[k, k]:
            found.append(_Moved(symbol=s, given=float(given[k]), found=p.value, std=math.sqrt(variance)))
    return sorted(found, key=lambda m: -abs(m.w))


def _wider(result: Adjustment) -> float:
    """Ratio of the standard deviations, afterwards and as given, from which on the calibration was outweighed.

    Afterwards they rest on a mean square of f residuals: of all, sigma0^2, or under noise of kind fields of those in
    the directions that fields move.  Where both are alike in truth, chi-square_f / f keeps its root below the limit
    with 1 - LEVEL.  What is less than NEARLY says nothing for any use.
    """
    f = result.noise.directions if result.noise.kind == "fields" else result.redundancy
    return max(NEARLY, math.sqrt(float(chdtri(f, LEVEL)) / f)) if f > 0 else math.inf


def _outweighed(result: Adjustment, camera: Camera, interior: InteriorResult, given: dict[str, float]) -> list[Notice]:
    """Parameters that the result states less precisely than the calibration did."""
    limit = _wider(result)
    told: list[str] = []
    for symbol, before in given.items():
        after = interior.parameters[symbol].std if symbol in interior.parameters else None
        if after is not None and after > limit * before:
            told.append(f"{symbol} {before:.2g} before, {after:.2g} now")
    if not told:
        return []
    message = (
        f"camera {camera.id}: the result knows it less precisely than the calibration that was given (standard "
        f"deviations of {'; '.join(told)}; limit {limit:.2g} times): observations are weighted as if their errors were "
        "independent, and draw it from values that are known better. To keep these, hold the calibration "
        "(estimate = [])"
    )
    return [Notice(code="calibration_outweighed", message=message, ids=(camera.id, *given))]
