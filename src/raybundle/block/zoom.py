"""A zoom lens: interior orientation as a function of the EXIF focal length, with its covariance.

The parameters are series of Legendre polynomials in the focal length, its logarithm or its reciprocal, scaled to
-1 .. 1 over the calibrated range.  Within it they are interpolated; beyond it nothing is stated.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from raybundle.block.block import Camera
from raybundle.errors import InputError, phrase
from raybundle.numerics.arrays import Array

Variable = Literal["f", "log f", "1/f"]
VARIABLES: tuple[Variable, ...] = ("f", "log f", "1/f")
RESOLUTIONS_MM = (1.0, 0.5, 0.1, 0.05)
"""Steps in which EXIF focal lengths are written."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ZoomSetting:
    """One calibration of a zoom lens."""

    focal_mm: float
    """EXIF focal length"""
    camera: Camera
    free: tuple[str, ...]
    """Symbols that were estimated"""
    covariance: Array
    """(u, u) of `free`"""
    focus_m: float | None = None
    """Object distance to which the lens was focused; None: not known"""


@dataclass(frozen=True, slots=True, kw_only=True)
class ZoomPrediction:
    """Interior orientation at a focal length between the calibrated ones."""

    camera: Camera
    free: tuple[str, ...]
    covariance: Array
    """(u, u) of `free`, with the error of the EXIF focal length"""
    remarks: tuple[str, ...]
    """What is not known"""


@dataclass(frozen=True, slots=True, kw_only=True)
class ZoomCalibration:
    """Interior orientation as a function of the EXIF focal length."""

    camera: Camera
    """Format, sensor model and the parameters that do not vary"""
    symbols: tuple[str, ...]
    """Parameters that vary, or could"""
    variables: tuple[Variable, ...]
    """Of what the polynomial of each symbol is"""
    orders: tuple[int, ...]
    coefficients: Array
    """(u,) the symbols' coefficients one after the other, from order 0"""
    covariance: Array
    """(u, u) with the variance factor"""
    range_mm: tuple[float, float]
    """Smallest and largest EXIF focal length that was calibrated"""
    resolution_mm: float
    """Step in which the EXIF focal length is written; 0: without rounding"""
    settings_mm: tuple[float, ...]
    """EXIF focal lengths that were calibrated"""
    square_sum: float
    """Of the residuals of the settings' parameters, by their covariance"""
    redundancy: int
    focus_m: float | None = None
    """Object distance of all calibrations; None: not known or not one"""

    @property
    def variance_factor(self) -> float:
        """How far the settings scatter about the polynomials, in variances; 1 at least is used."""
        return self.square_sum / self.redundancy if self.redundancy > 0 else 1.0

    def predict(self, focal_mm: float, focus_m: float | None = None) -> ZoomPrediction:
        """The camera at an EXIF focal length, with the covariance of its parameters.

        focus_m  object distance of the photograph where the metadata show it
        raises   InputError outside the calibrated range

        The rounding of the focal length counts as an error, uniform over its step.  What the covariance does not show:
        that zoom and focus may have been moved while EXIF stayed the same, and play of the lens.
        """
        low, high = self.range_mm
        slack = self.resolution_mm / 2 + 1e-9 * high
        if not low - slack <= focal_mm <= high + slack:
            raise InputError("zoom.out_of_range", camera=self.camera.id, focal_mm=focal_mm, low_mm=low, high_mm=high)
        values = design(self, focal_mm) @ self.coefficients
        slope = design(self, focal_mm, derivative=True) @ self.coefficients
        F = design(self, focal_mm)
        C = F @ self.covariance @ F.T + rounding_variance(self.resolution_mm) * np.outer(slope, slope)
        camera = replace(
            self.camera,
            values={**self.camera.values, **{s: float(v) for s, v in zip(self.symbols, values, strict=True)}},
        )
        camera, remarks = self._focused(camera, focus_m)
        return ZoomPrediction(camera=camera, free=self.symbols, covariance=(C + C.T) / 2, remarks=remarks)

    def _focused(self, camera: Camera, focus_m: float | None) -> tuple[Camera, tuple[str, ...]]:
        """The camera constant at another focus by the lens equation 1/f = 1/s + 1/c; the rest stays."""
        if self.focus_m is None or focus_m is None:
            of = "calibration" if self.focus_m is None else "photograph"
            return camera, (phrase("zoom.focus_unknown", of=of),)
        if abs(focus_m - self.focus_m) <= 1e-3 * self.focus_m:
            return camera, ()
        c = camera.values["c"]
        moved = refocused(c, self.focus_m, focus_m)
        remark = phrase("zoom.refocused", focus_m=focus_m, calibrated_m=self.focus_m, change_mm=moved - c)
        return replace(camera, values={**camera.values, "c": moved}), (remark,)


def design(zoom: ZoomCalibration, focal_mm: float, *, derivative: bool = False) -> Array:
    """(m, u) d parameters / d coefficients at a focal length, or its derivative by the focal length [1 / mm]."""
    out = np.zeros((len(zoom.symbols), sum(o + 1 for o in zoom.orders)))
    at = 0
    for i, (variable, order) in enumerate(zip(zoom.variables, zoom.orders, strict=True)):
        t, by_f = scaled_variable(focal_mm, zoom.range_mm, variable)
        value, slope = legendre(t, order)
        out[i, at : at + order + 1] = slope * by_f if derivative else value
        at += order + 1
    return out


def scaled_variable(focal_mm: float, range_mm: tuple[float, float], variable: Variable) -> tuple[float, float]:
    """The variable -1 .. 1 of a focal length, and its derivative by the focal length."""
    low, high = range_mm
    if variable == "f":
        return 2 * (focal_mm - low) / (high - low) - 1, 2 / (high - low)
    if variable == "log f":
        span = float(np.log(high / low))
        return 2 * float(np.log(focal_mm / low)) / span - 1, 2 / (focal_mm * span)
    a, b = 1 / high, 1 / low
    return 2 * (1 / focal_mm - a) / (b - a) - 1, -2 / (focal_mm**2 * (b - a))


def legendre(t: float, order: int) -> tuple[Array, Array]:
    """Legendre polynomials (order + 1,) at t and their derivatives."""
    from numpy.polynomial import legendre as series

    value = series.legvander(np.array([t]), order)[0]
    slope = np.array([float(series.legval(t, series.legder(row))) for row in np.eye(order + 1)])
    return value, slope


def rounding_variance(resolution_mm: float) -> float:
    """Variance of an error that is uniform over a step."""
    return resolution_mm**2 / 12


def focal_resolution(focal_mm: Array) -> float:
    """The coarsest usual step of which all focal lengths [mm] are multiples; 0: they are not rounded."""
    f = np.asarray(focal_mm, float)
    return next((r for r in RESOLUTIONS_MM if np.allclose(f / r, np.round(f / r), rtol=0, atol=1e-6)), 0.0)


def refocused(c_mm: float, from_m: float, to_m: float) -> float:
    """Camera constant [mm] at another focus: 1/f = 1/s + 1/c with the same f (Gauss)."""
    return 1 / (1 / c_mm + 1 / (1000 * from_m) - 1 / (1000 * to_m))


def between_focuses(near: ZoomPrediction, far: ZoomPrediction, focus_m: Mapping[str, float]) -> ZoomPrediction:
    """Interior orientation at a focus between two calibrated ones, all other settings the same.

    focus_m  "near", "far" (may be infinite) and "wanted": object distances [m]
    raises   InputError where the calibrations differ in model or free parameters, or the focus lies beyond them

    Distortion, camera constant and principal point are linear in the magnification f / (s - f): dr = a dr_near +
    (1 - a) dr_far, a = (s_far - s)(s_near - f) / ((s_far - s_near)(s - f)) (Magill 1955; Brown 1971; Fraser and
    Shortis 1992).  What it leaves out: the change of distortion within the depth of one photograph.
    """
    if near.free != far.free or near.camera.model != far.camera.model:
        raise InputError("focus.calibrations_differ")
    s1, s2, s = (1000 * focus_m[k] for k in ("near", "far", "wanted"))
    if not s1 < s2 or not s1 * (1 - 1e-9) <= s <= s2 * (1 + 1e-9):
        raise InputError("focus.out_of_range", focus_m=focus_m["wanted"], near_m=focus_m["near"], far_m=focus_m["far"])
    f = 1 / (1 / near.camera.values["c"] + 1 / s1)
    m1, m2, m = (f / (d - f) for d in (s1, s2, s))
    a = (m - m2) / (m1 - m2)
    values = {
        k: a * near.camera.values[k] + (1 - a) * far.camera.values[k] if k in near.free else v
        for k, v in near.camera.values.items()
    }
    return ZoomPrediction(
        camera=replace(near.camera, values=values),
        free=near.free,
        covariance=a**2 * near.covariance + (1 - a) ** 2 * far.covariance,
        remarks=(),
    )
