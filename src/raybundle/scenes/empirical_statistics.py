"""Statistics of empirical models: reliability, significance, correlations, physical units; the choice among them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError, Message, NotSolvable, Severity, as_detail
from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import DELTA0, family_wise_normal
from raybundle.scenes.empirical import EmpiricalFit, fit_empirical

SIGNIFICANT = 1.96
"""Value over standard deviation beyond which a parameter differs from zero (95 %)."""
FALSE_ALARM = 0.01
"""Chance of one false alarm among all w tests of a fit."""
UNCONTROLLED = 1e-6
"""Redundancy number below which an observation is not controlled by others."""
SPATIAL = ("affine", "parallel-perspective", "dlt", "sdlt", "dlt-brown", "affine2")
"""Models of space by their number of parameters, the fewest first."""
PLANE = ("plane-affine", "plane-projective")


@dataclass(frozen=True, slots=True, kw_only=True)
class ParameterStatistics:
    """One parameter of an empirical model, for coordinates counted from the fit's offsets."""

    symbol: str
    value: float
    std: float
    """From the stated sigma of the image points; 0 where the parameter is held."""
    unit: str
    """px, the unit of length of the object points, and 1."""
    t: float | None
    """Value over standard deviation; None where it is held."""
    significant: bool
    """Whether it differs from zero (95 %); asked of additional parameters, others may well be zero."""
    additional: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class EmpiricalStatistics:
    """What a fit shows beside its parameters."""

    parameters: tuple[ParameterStatistics, ...]
    covariance: Array
    """(k, k) of the parameters in those units."""
    correlation: Array
    """(k, k); 0 for held ones."""
    redundancy: Array
    """(n, 2) share of an image coordinate's error that shows in its residual; sums to the redundancy of the fit."""
    w: Array
    """(n, 2) residual over its standard deviation, by the stated sigma; NaN where it is not controlled."""
    mdb_px: Array
    """(n, 2) smallest blunder that the w test finds with 80 %, at 0.1 %."""
    left_out_px: Array
    """(n, 2) model - measured had the coordinate taken no part, v / r, to first order."""
    critical_w: float
    """Largest |w| that chance explains among so many tests (Bonferroni)."""

    @property
    def blunders(self) -> tuple[tuple[int, int], ...]:
        """Point and axis of the image coordinates whose w is beyond the limit, the largest first."""
        size = np.abs(np.nan_to_num(self.w))
        order = np.argsort(-size, axis=None)[: int((size > self.critical_w).sum())]
        rows, axes = np.unravel_index(order, size.shape)
        return tuple(zip(rows.tolist(), axes.tolist(), strict=True))

    def correlated(self, limit: float) -> tuple[tuple[str, str, float], ...]:
        """Pairs of parameters that correlate beyond a limit, the strongest first."""
        i, j = np.triu_indices(len(self.parameters), 1)
        found = [
            (self.parameters[a].symbol, self.parameters[b].symbol, float(self.correlation[a, b]))
            for a, b in zip(i.tolist(), j.tolist(), strict=True)
            if abs(self.correlation[a, b]) > limit
        ]
        return tuple(sorted(found, key=lambda f: -abs(f[2])))


def empirical_statistics(fit: EmpiricalFit, *, length_unit: str = "m") -> EmpiricalStatistics:
    """Statistics of a fitted model; parameters for (object - object_offset) and (image - image_offset) of the fit.

    length_unit  of the object points, for the names of the units
    The standard deviations hold for the stated sigma and an adequate model: where the fit states that the model is not
    adequate they show nothing.  The object points count as free of error.
    """
    n, free = fit.normalisation, fit.free
    powers = np.array(fit.model.powers)
    factor = n.image_scale ** powers[:, 0].astype(float) * n.object_scale ** powers[:, 1].astype(float)
    values, covariance = fit.values * factor, fit.covariance * np.outer(factor, factor)
    std = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    safe = np.where(std > 0, std, 1.0)
    A = fit.project_with_partials(fit.points)[2][:, :, free] / fit.sigma_px
    Q = fit.covariance[np.ix_(free, free)]
    redundancy = np.clip(1 - np.einsum("nak,kl,nal->na", A, Q, A), 0.0, 1.0)
    controlled = redundancy > UNCONTROLLED
    root = np.sqrt(np.where(controlled, redundancy, 1.0))
    v = fit.residuals_px
    return EmpiricalStatistics(
        parameters=tuple(
            ParameterStatistics(
                symbol=s, value=float(values[k]), std=float(std[k]), unit=_unit(fit.model.powers[k], length_unit),
                t=float(values[k] / std[k]) if std[k] > 0 else None,
                significant=bool(std[k] > 0 and abs(values[k]) > SIGNIFICANT * std[k]),
                additional=s in fit.model.additional,
            )
            for k, s in enumerate(fit.model.symbols)
        ),
        covariance=covariance,
        correlation=covariance / np.outer(safe, safe),
        redundancy=redundancy,
        w=np.where(controlled, v / (fit.sigma_px * root), np.nan),
        mdb_px=np.where(controlled, DELTA0 * fit.sigma_px / root, np.nan),
        left_out_px=np.where(controlled, v / np.where(controlled, redundancy, 1.0), np.nan),
        critical_w=family_wise_normal(FALSE_ALARM, redundancy.size),
    )  # fmt: skip


def _unit(powers: tuple[int, int], length: str) -> str:
    """As px/m, px^-2, 1."""
    image, thing = powers
    above = "px" if image == 1 else f"px^{image}" if image else ""
    below = length if thing == -1 else f"{length}^{-thing}" if thing else ""
    if above and below:
        return f"{above}/{below}"
    return above or (f"1/{below}" if below else "1")


@dataclass(frozen=True, slots=True, kw_only=True)
class Candidate:
    """A model that was tried."""

    name: str
    fit: EmpiricalFit | None
    """None where it cannot be fitted."""
    left_out_rms_px: float
    """Of the image coordinates left out one by one; NaN where there is no redundancy."""
    reason: Message
    """What its residuals show, or why it cannot be fitted."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EmpiricalAdvice:
    """Which model is adequate."""

    candidates: tuple[Candidate, ...]
    advised: Candidate | None
    """The adequate one with the fewest parameters; None where none is."""
    reason: Message


def choose_empirical(
    xyz: Array, xy_px: Array, *, sigma_px: float, names: Sequence[str] | None = None
) -> EmpiricalAdvice:
    """Fit the models of space (or of a plane, where the points lie in one) and say which is adequate.

    names    models to try, in this order; None: all that the points allow
    raises   InputError where no model can be fitted
    Adequate is a model whose residuals the stated sigma explains (chi-square, 0.1 %), with redundancy left to show; of
    those the one with the fewest parameters.  It states nothing about ground outside the points.
    """
    found = [_candidate(name, xyz, xy_px, sigma_px) for name in names or SPATIAL]
    if names is None and not any(c.fit is not None for c in found):
        found += [_candidate(name, xyz, xy_px, sigma_px) for name in PLANE]
    fitted = [c for c in found if c.fit is not None]
    if not fitted:
        raise InputError("empirical.none_fitted", details=[c.reason for c in found])
    good = [c for c in fitted if c.fit is not None and c.fit.adequate and c.fit.redundancy > 0]
    if not good:
        least = min(fitted, key=lambda c: c.left_out_rms_px if np.isfinite(c.left_out_rms_px) else np.inf)
        return EmpiricalAdvice(
            candidates=tuple(found), advised=None,
            reason=Message(
                code="empirical.none_adequate", severity=Severity.WARNING,
                values={"model": least.name, "left_out_px": least.left_out_rms_px, "sigma_px": sigma_px},
            ),
        )  # fmt: skip
    best = min(good, key=lambda c: len(c.fit.free) if c.fit is not None else 99)
    assert best.fit is not None
    return EmpiricalAdvice(
        candidates=tuple(found), advised=best,
        reason=Message(
            code="empirical.advised", severity=Severity.NOTE,
            values={"model": best.name, "n": len(best.fit.free), "left_out_px": best.left_out_rms_px},
        ),
    )  # fmt: skip


def _candidate(name: str, xyz: Array, xy_px: Array, sigma_px: float) -> Candidate:
    try:
        fit = fit_empirical(name, xyz, xy_px, sigma_px=sigma_px)
    except (InputError, NotSolvable) as error:
        return Candidate(name=name, fit=None, left_out_rms_px=float("nan"), reason=as_detail(error))
    left_out = empirical_statistics(fit).left_out_px
    known = left_out[np.isfinite(left_out)]
    rms = float(np.sqrt(np.mean(known**2))) if fit.redundancy and len(known) else float("nan")
    return Candidate(name=name, fit=fit, left_out_rms_px=rms, reason=fit.reason)
