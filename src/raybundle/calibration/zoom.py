"""Calibrations of a zoom lens at several settings, adjusted together as polynomials of the EXIF focal length.

The settings' parameters are the observations, each with its full covariance from its own calibration: a calibration
leaves nothing else to the zoom, so the result is that of one adjustment of all photographs (adjustment in steps).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Camera
from raybundle.block.zoom import (
    VARIABLES,
    Variable,
    ZoomCalibration,
    ZoomSetting,
    design,
    focal_resolution,
    legendre,
    rounding_variance,
    scaled_variable,
)
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array

FEWEST = 3
"""Settings from which on a zoom lens is interpolated."""
HIGHEST = 4
"""Order of the polynomials."""
SPARE = 2.0
"""Standard deviations that the first term left out may have."""
ROUNDS = 6
"""Of the slopes by which the rounding of focal lengths acts."""


_Term = tuple[Variable, int]
"""Variable and order of the polynomial of one symbol"""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Problem:
    """The settings' parameters, whitened."""

    whitened: Array
    """(n, m) L^-1 values"""
    inverse: Array
    """(n, m, m) L^-1 of the covariances L L'"""
    basis: dict[Variable, tuple[Array, Array]]
    """(n, order + 1) Legendre polynomials of each variable and their derivatives by the focal length"""

    def design(self, terms: Sequence[_Term]) -> Array:
        """(n m, u) whitened."""
        blocks = [self.inverse[:, :, i, None] * self.basis[v][0][:, None, : o + 1] for i, (v, o) in enumerate(terms)]
        return np.concatenate(blocks, axis=2).reshape(self.whitened.size, -1)

    def solve(self, terms: Sequence[_Term], allowance: Array) -> tuple[Array, Array]:
        """Coefficients (u,) and cofactors (u, u), coefficients observed as 0 with standard deviations (u,) or inf."""
        A, y = self.design(terms), self.whitened.ravel()
        A, y = np.concatenate([A, np.diag(1 / allowance)]), np.append(y, np.zeros(len(allowance)))
        scale = 1 / np.linalg.norm(A, axis=0)
        Q, R = np.linalg.qr(A * scale)
        root = np.linalg.inv(R) * scale[:, None]
        return root @ (Q.T @ y), root @ root.T

    def with_allowance(self, terms: Sequence[_Term], settings: int) -> tuple[list[_Term], Array]:
        """One order more for each symbol, and the standard deviation (u,) with which its coefficient is 0.

        A term that is not significant may still be there, as large as SPARE of the standard deviations with which it
        would be estimated; inf for those that are estimated.
        """
        A = self.design(terms)
        U = np.linalg.qr(A / np.linalg.norm(A, axis=0))[0]
        more: list[_Term] = []
        allowance = list[float]()
        for i, (v, o) in enumerate(terms):
            allowance += [np.inf] * (o + 1)
            if o + 1 >= settings:
                more.append((v, o))
                continue
            column = (self.inverse[:, :, i] * self.basis[v][0][:, None, o + 1]).ravel()
            own = float(np.linalg.norm(column - U @ (U.T @ column)))
            more.append((v, o + 1))
            allowance.append(SPARE / max(own, 1e-300))
        return more, np.array(allowance)

    def square_sum(self, terms: Sequence[_Term]) -> float:
        """Of the residuals."""
        A, y = self.design(terms), self.whitened.ravel()
        Q = np.linalg.qr(A / np.linalg.norm(A, axis=0))[0]
        return float(np.sum((y - Q @ (Q.T @ y)) ** 2))

    def slopes(self, terms: Sequence[_Term], a: Array) -> Array:
        """(n, m) derivatives of the parameters by the focal length."""
        ends = np.cumsum([o + 1 for _, o in terms])
        return np.stack(
            [self.basis[v][1][:, : o + 1] @ a[e - o - 1 : e] for (v, o), e in zip(terms, ends, strict=True)], axis=1
        )


def setting_of(result: Adjustment, camera: str, focal_mm: float, focus_m: float | None = None) -> ZoomSetting:
    """The setting that an adjustment has calibrated; raises InputError without estimated parameters or statistics."""
    interior = next((i for i in result.interior if i.camera == camera and i.image is None), None)
    if interior is None or result.precision is None or not interior.free:
        raise InputError("calibration.not_estimated", camera=camera)
    return ZoomSetting(
        focal_mm=focal_mm,
        camera=next(c for c in result.adjusted.cameras if c.id == camera),
        free=interior.free,
        covariance=result.precision.interior[camera],
        focus_m=focus_m,
    )


def calibrate_zoom(
    settings: Sequence[ZoomSetting], *, resolution_mm: float | None = None, significance: float = 0.01
) -> ZoomCalibration:
    """Interior orientation as polynomials of the EXIF focal length, from calibrations at several settings.

    resolution_mm  step in which EXIF writes the focal length; None: read from the values themselves
    significance   family-wise, of the terms: a term stays if the settings contradict its absence
    raises         InputError for fewer than three settings, or settings of different cameras or parameters

    Orders grow by the drop of the square sum (chi-square), each symbol in the focal length, its logarithm or its
    reciprocal, whichever fits better.  The error of rounded focal lengths acts along the slope of all parameters, on
    the settings and on what is predicted.  Where the settings scatter more about the polynomials than their
    covariances allow, all covariances grow by the variance factor.
    """
    settings = sorted(settings, key=lambda s: s.focal_mm)
    _check(settings)
    focal = np.array([s.focal_mm for s in settings])
    resolution = focal_resolution(focal) if resolution_mm is None else resolution_mm
    values = np.array([[s.camera.values[k] for k in settings[0].free] for s in settings])
    slopes = np.gradient(values, focal, axis=0)
    kinds = {p.symbol: p.kind for p in settings[0].camera.sensor.parameters}
    chosen: list[_Term] = [("f", int(kinds[s] == "scale")) for s in settings[0].free]
    terms, a, Q, omega = chosen, np.zeros(0), np.zeros((0, 0)), 0.0
    for _ in range(ROUNDS if resolution > 0 else 1):
        problem = _problem(settings, slopes, resolution)
        chosen = _selected(problem, chosen, min(HIGHEST, len(settings) - 2), significance)
        terms, allowance = problem.with_allowance(chosen, len(settings))
        a, Q = problem.solve(terms, allowance)
        new = problem.slopes(terms, a)
        omega = problem.square_sum(chosen)
        settled = np.allclose(new, slopes, rtol=1e-6, atol=0)
        slopes = new
        if settled:
            break
    focus = {s.focus_m for s in settings}
    zoom = ZoomCalibration(
        camera=_common(settings), symbols=settings[0].free, variables=tuple(v for v, _ in terms),
        orders=tuple(o for _, o in terms), coefficients=a, covariance=Q, range_mm=(float(focal[0]), float(focal[-1])),
        resolution_mm=resolution, settings_mm=tuple(focal.tolist()), square_sum=omega,
        redundancy=values.size - sum(o + 1 for _, o in chosen), focus_m=focus.pop() if len(focus) == 1 else None,
    )  # fmt: skip
    return replace(zoom, covariance=max(1.0, zoom.variance_factor) * Q)


def _problem(settings: Sequence[ZoomSetting], slopes: Array, resolution: float) -> _Problem:
    """The settings whitened, with the rounding of their focal lengths along the slopes (n, m)."""
    free = settings[0].free
    inverse, whitened = list[Array](), list[Array]()
    for s, slope in zip(settings, slopes, strict=True):
        C = s.covariance + rounding_variance(resolution) * np.outer(slope, slope)
        d = np.sqrt(np.diagonal(C))
        inverse.append(np.linalg.inv(np.linalg.cholesky(C / np.outer(d, d))) / d)
        whitened.append(inverse[-1] @ [s.camera.values[k] for k in free])
    ends = (settings[0].focal_mm, settings[-1].focal_mm)
    basis: dict[Variable, tuple[Array, Array]] = {}
    for v in VARIABLES:
        at = [scaled_variable(s.focal_mm, ends, v) for s in settings]
        rows = [(legendre(t, HIGHEST + 1), by_f) for t, by_f in at]
        basis[v] = np.array([r[0] for r, _ in rows]), np.array([r[1] * by_f for r, by_f in rows])
    return _Problem(whitened=np.array(whitened), inverse=np.array(inverse), basis=basis)


def _check(settings: Sequence[ZoomSetting]) -> None:
    if len(settings) < FEWEST:
        raise InputError("zoom.too_few_settings", n=len(settings), least=FEWEST)
    first = settings[0]
    for a, b in pairwise(settings):
        if not b.focal_mm > a.focal_mm:
            raise InputError("zoom.setting_given_twice", focal_mm=a.focal_mm)
    for s in settings[1:]:
        mine, other = first.camera, s.camera
        same = (mine.model, mine.width_px, mine.height_px, mine.pixel_mm) == (
            other.model, other.width_px, other.height_px, other.pixel_mm,
        )  # fmt: skip
        if not same or s.free != first.free:
            raise InputError(
                "zoom.settings_differ", first_mm=first.focal_mm, second_mm=s.focal_mm, first=first.free, second=s.free
            )
        held = [k for k, v in mine.values.items() if k not in first.free and other.values.get(k, v) != v]
        if held:
            raise InputError("zoom.held_values_differ", parameters=held, first_mm=first.focal_mm, second_mm=s.focal_mm)


def _selected(problem: _Problem, terms: Sequence[_Term], highest: int, significance: float) -> list[_Term]:
    """Variables and orders chosen by significance: up by the terms that lower the square sum, then down again."""
    from scipy.stats import chi2

    chosen: list[_Term] = [(v, min(o, highest)) for v, o in terms]
    level = significance / len(chosen)
    omega = problem.square_sum(chosen)
    for _ in range(10 * len(chosen)):
        tried: list[list[_Term]] = [
            [*chosen[:i], (v, o + more), *chosen[i + 1 :]]
            for i, (_, o) in enumerate(chosen)
            for v in VARIABLES
            for more in (0, 1, 2)
            if o + more <= highest and (more, v) != (0, chosen[i][0])
        ]
        sums = [problem.square_sum(t) for t in tried]
        more = [sum(o for _, o in t) - sum(o for _, o in chosen) for t in tried]
        # a step in BIC, which pays for the terms; exchanges of the variable must gain, further terms be significant
        gain = np.array([omega - s - m * np.log(problem.whitened.size) for s, m in zip(sums, more, strict=True)])
        best = int(np.argmax(gain))
        limit = float(chi2.isf(level, more[best])) if more[best] else 1e-9 * omega
        if omega - sums[best] <= limit:
            break
        chosen, omega = tried[best], sums[best]
    for i in np.argsort([-o for _, o in chosen]).tolist():
        while chosen[i][1] > 0:
            fewer: list[_Term] = [(v, o - (k == i)) for k, (v, o) in enumerate(chosen)]
            less = problem.square_sum(fewer)
            if less - omega > chi2.isf(level, 1):
                break
            chosen, omega = fewer, less
    return chosen


def _common(settings: Sequence[ZoomSetting]) -> Camera:
    return replace(settings[len(settings) // 2].camera, estimate=(), sigma={})


def zoom_residuals(zoom: ZoomCalibration, settings: Sequence[ZoomSetting]) -> Array:
    """(n, m) polynomials minus the settings' parameters, for a report."""
    return np.array(
        [design(zoom, s.focal_mm) @ zoom.coefficients - [s.camera.values[k] for k in zoom.symbols] for s in settings]
    )
