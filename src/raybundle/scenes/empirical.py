"""Empirical models: from object coordinates to the image without knowing the sensor.

Each model is x = f(X, Y, Z; parameters), y = g(...), in object coordinates and image points that are centred and
scaled to about -1 to 1, in which its parameters and their covariance are given.

    affine               x = a1 X + a2 Y + a3 Z + a4, y likewise                                      8 parameters
    affine2              affine with the terms XY, XZ, YZ, X^2, Y^2                                   18
    parallel-perspective y (along track) affine, x projective: one linear pushbroom (Gupta, Hartley)  11
    dlt                  both projective with one denominator (Abdel-Aziz and Karara 1971)            11
    dlt-brown            dlt with radial K1-K3 and decentring P1, P2 at the image point                16
    sdlt                 dlt with y / (1 - L12 x) (Wang 1999)                                         12
    plane-affine         from X, Y alone, for rectification of plane objects                          6
    plane-projective     from X, Y alone, a perspective image of a plane                              8

`scenes.empirical_statistics` has redundancy numbers, w tests, correlations and significance, parameters in units of the
image and of object space, and the choice among models.

A narrow field of view makes affine enough (IKONOS); wide scenes and relief do not, which `EmpiricalFit.adequate` and
its reason say.  An adequate fit shows about the points that were used, nothing about ground outside them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError, Message, NoConvergence, RankDefect, Severity, Value
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.least_squares import added, minimum
from raybundle.scenes.empirical_models import EmpiricalModel, empirical_models

__all__ = ["EmpiricalFit", "EmpiricalModel", "Normalisation", "empirical_models", "fit_empirical"]

SIGNIFICANCE = 0.001


@dataclass(frozen=True, slots=True, kw_only=True)
class Normalisation:
    """Centre and scale of object points and image points: normalised = (value - offset) / scale."""

    object_offset: Array
    object_scale: float
    image_offset: Array
    image_scale: float

    @staticmethod
    def of(xyz: Array, xy_px: Array) -> Normalisation:
        """The middle of the points' box, and half its longest side."""
        low, high = xyz.min(axis=0), xyz.max(axis=0)
        left, right = xy_px.min(axis=0), xy_px.max(axis=0)
        return Normalisation(
            object_offset=(low + high) / 2,
            object_scale=float((high - low).max() / 2) or 1.0,
            image_offset=(left + right) / 2,
            image_scale=float((right - left).max() / 2) or 1.0,
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class EmpiricalFit:
    """A model fitted by least squares, with its statistics."""

    model: EmpiricalModel
    normalisation: Normalisation
    values: Array
    """(k,)"""
    covariance: Array
    """(k, k) from the stated sigma of the image points."""
    points: Array
    """(n, 3) to which it was fitted."""
    residuals_px: Array
    """(n, 2) adjusted - measured."""
    sigma_px: float
    redundancy: int
    sigma0: float
    """sqrt(sum (v / sigma)^2 / redundancy); 1 is expected."""
    adequate: bool
    """Whether the residuals are no larger than the stated sigma explains (chi-square, 0.1 %)."""
    reason: Message
    """What the residuals show of the model."""
    without: tuple[str, ...] = ()
    """Parameters that were left out, held at zero."""

    @property
    def free(self) -> Index:
        """Positions of the parameters that were estimated."""
        return np.array([k for k, s in enumerate(self.model.symbols) if s not in self.without], np.int32)

    def project(self, xyz: Array) -> Array:
        """Image points (n, 2) [px] of object points (n, 3)."""
        return self.project_with_partials(xyz)[0]

    def project_with_partials(self, xyz: Array) -> tuple[Array, Array, Array]:
        """Image points (n, 2) [px], derivatives (n, 2, 3) by the point and (n, 2, k) by the parameters."""
        n = self.normalisation
        uv, by_point, by_values = self.model.evaluate((xyz - n.object_offset) / n.object_scale, self.values)
        factor = n.image_scale
        return n.image_offset + factor * uv, by_point * (factor / n.object_scale), by_values * factor


def fit_empirical(
    name: str, xyz: Array, xy_px: Array, *, sigma_px: float, without: tuple[str, ...] = ()
) -> EmpiricalFit:
    """Fit a model to object points (n, 3), in a Cartesian frame, and image points (n, 2) [px].

    sigma_px  standard deviation of an image coordinate; the object points count as free of error
    without   additional parameters that are left out
    raises    InputError for an unknown model or too few points; RankDefect where the points lie so that the
              parameters are not determined (in a plane, for all but plane models); NoConvergence
    """
    model, xyz, xy_px = _named(name), np.asarray(xyz, float), np.asarray(xy_px, float)
    if not sigma_px > 0:
        raise InputError("image_point.sigma_not_positive_px", sigma_px=sigma_px)
    if strange := [s for s in without if s not in model.additional]:
        raise InputError(
            "empirical.no_additional_parameter",
            model=name,
            names=strange,
            known=model.additional,
            n=len(model.additional),
        )
    free = np.array([k for k, s in enumerate(model.symbols) if s not in without], np.int32)
    least = (len(free) + 1) // 2
    if len(xyz) != len(xy_px) or len(xyz) < least:
        raise InputError(
            "empirical.too_few_points", model=name, object=len(xyz), image=len(xy_px), parameters=len(free), least=least
        )
    normalisation = Normalisation.of(xyz, xy_px)
    X = (xyz - normalisation.object_offset) / normalisation.object_scale
    uv = (xy_px - normalisation.image_offset) / normalisation.image_scale
    values, N, v = _least_squares(model, X, uv, free)
    redundancy = 2 * len(X) - len(free)
    residuals = v * normalisation.image_scale
    square_sum = float(np.sum((residuals / sigma_px) ** 2))
    covariance = np.zeros((len(values), len(values)))
    covariance[np.ix_(free, free)] = np.linalg.inv(N) * (sigma_px / normalisation.image_scale) ** 2
    adequate, reason = _adequate(model, residuals, square_sum, redundancy, sigma_px)
    return EmpiricalFit(
        model=model,
        normalisation=normalisation,
        values=values,
        covariance=covariance,
        points=xyz,
        residuals_px=residuals,
        sigma_px=sigma_px,
        redundancy=redundancy,
        sigma0=float(np.sqrt(square_sum / redundancy)) if redundancy else float("nan"),
        adequate=adequate,
        reason=reason,
        without=without,
    )


def _least_squares(model: EmpiricalModel, X: Array, uv: Array, free: Index) -> tuple[Array, Array, Array]:
    """Values, normal matrix and residuals after Gauss-Newton from the closed-form start."""
    k = len(free)
    held = np.ones(len(model.symbols), bool)
    held[free] = False
    start = np.where(held, 0.0, model.start(X, uv))

    def full(part: Array) -> Array:
        values = start.copy()
        values[free] = part
        return values

    def function(part: Array) -> tuple[Array, Array]:
        image, _, by_values = model.evaluate(X, full(part))
        return (image - uv).reshape(-1), by_values[:, :, free].reshape(-1, k)

    found = minimum(function, start[free], added)
    A = found.jacobian
    scale = np.linalg.norm(A, axis=0)
    if not (np.isfinite(A).all() and (scale > 0).all()) or np.linalg.cond(A / scale) > 1e8:
        raise RankDefect("empirical.not_determined", model=model.name, n=k)
    if not found.settled:
        raise NoConvergence("empirical.no_minimum", model=model.name, n=found.steps)
    return full(found.values), A.T @ A, found.residuals.reshape(-1, 2)


def _adequate(
    model: EmpiricalModel, residuals: Array, square_sum: float, redundancy: int, sigma_px: float
) -> tuple[bool, Message]:
    from scipy.stats import chi2

    if redundancy == 0:
        return True, Message(code="empirical.no_redundancy", severity=Severity.WARNING, values={"model": model.name})
    limit = float(chi2.isf(SIGNIFICANCE, redundancy))
    x, y = np.sqrt(np.mean(residuals**2, axis=0))
    ratio = np.sqrt(square_sum / redundancy)
    values: dict[str, Value] = {"model": model.name, "x_px": float(x), "y_px": float(y), "sigma_px": sigma_px}
    if square_sum <= limit:
        return True, Message(code="empirical.adequate", severity=Severity.NOTE, values=values)
    values |= {"ratio": float(ratio), "limit": float(np.sqrt(limit / redundancy))}
    return False, Message(code="empirical.not_adequate", severity=Severity.WARNING, values=values)


def _named(name: str) -> EmpiricalModel:
    if name not in empirical_models:
        raise InputError("empirical.unknown_model", name=repr(name), known=sorted(empirical_models))
    return empirical_models[name]
