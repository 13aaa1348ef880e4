"""Which bias an RPC needs, judged on control points: by significance, and by points that were left out.

Points that contradict the others are set aside first and named; what remains has to pass a global test.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.errors import InputError, Message, NotSolvable, Severity, Value, message
from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import metres_per_geographic
from raybundle.scenes.bias import BIAS_PARAMETERS, BiasKind, bias_design
from raybundle.scenes.bias_blunders import SIGNIFICANCE, agreeing, misfit, solve_bias
from raybundle.scenes.rpc import Rpc

LARGEST_MISFIT = 5.0
"""Residuals larger than so many times the stated sigma are no fit: nothing should be built on it."""
FAR = 3.0
"""Ratio of a shift to the stated bias above which the points or the RPC deserve a second look."""
ENOUGH = 4
"""Redundancy from which the scatter of the residuals decides what is significant; below, the stated sigma does."""


@dataclass(frozen=True, slots=True, kw_only=True)
class BiasFit:
    """One bias model on the control points; all in px."""

    kind: BiasKind
    values: Array
    """(k,) to be added to what the RPC projects, in the order of `BIAS_PARAMETERS`."""
    covariance: Array
    """(k, k) from the stated sigma of the points."""
    height_covariance: Array
    """(k, k) the part of it that comes from the stated sigma of their heights."""
    residuals: Array
    """(n, 2) measured - corrected projection."""
    rms: Array
    """(2,) x, y"""
    left_out_rms: Array
    """(2,) of each point by the others; NaN where too few are left."""
    square_sum: float
    """Weighted residuals."""
    redundancy: int

    @property
    def misfit(self) -> float:
        """How many times the stated sigma the residuals are; 1 where the global test at 1 % finds no excess.

        Standard deviations have to be multiplied by it.  1 without redundancy, too: then nothing was tested.
        """
        return misfit(self.square_sum, self.redundancy)

    @property
    def sigma(self) -> Array:
        """(k,) standard deviations [px] of the values, enlarged by the misfit."""
        return self.misfit * np.sqrt(np.diagonal(self.covariance))


@dataclass(frozen=True, slots=True, kw_only=True)
class BiasAdvice:
    """All models that the points allow, and the one to use; from the points that do not contradict the others."""

    fits: tuple[BiasFit, ...]
    advised: BiasFit
    reason: Message
    """Why this one; a detail where points take no part."""
    sigma_px: float
    """Stated, of an image coordinate."""
    prior_ratio: float | None
    """Length of the advised shift in the middle of the RPC over the sigma that the vendor states (ERR_BIAS);
    None without either.  Above FAR the points or the RPC deserve a second look."""
    set_aside: tuple[int, ...]
    """Rows of points that contradict the others and took no part, the worst first."""
    set_aside_px: Array
    """(len(set_aside), 2) measured - corrected projection of these points."""

    @property
    def is_far(self) -> bool:
        """Whether the shift is decidedly larger than what the vendor states."""
        return self.prior_ratio is not None and self.prior_ratio > FAR


def choose_bias(
    rpc: Rpc, geographic: Array, xy_px: Array, *, sigma_px: float, sigma_ground_m: Array | None = None
) -> BiasAdvice:
    """The bias model for control points with longitude, latitude, height (n, 3) measured at (n, 2) [px].

    sigma_px         standard deviation of a measured image coordinate
    sigma_ground_m   (n, 3) of the points, east, north, up [m]; None: free of error
    raises           InputError without a point, or where the points lie outside the RPC's denominators

    The next larger model is taken only if it improves the fit with a significance of 1 % and predicts points that
    were left out better.  Few points can hide a drift; the advice is no proof that there is none.
    """
    geographic, xy_px = np.asarray(geographic, float), np.asarray(xy_px, float)
    if len(xy_px) == 0 or len(xy_px) != len(geographic):
        raise InputError("bias.point_count", ground=len(geographic), image=len(xy_px))
    if not sigma_px > 0:
        raise InputError("image_point.sigma_not_positive_px", sigma_px=sigma_px)
    projected = rpc.project(geographic)
    covariance, heights = point_covariance(rpc, geographic, sigma_px, sigma_ground_m)
    uv = (projected - rpc.image_offset) / rpc.image_scale
    difference = xy_px - projected
    kept = agreeing(uv, difference, covariance)
    fits = tuple(
        f
        for kind in BIAS_PARAMETERS
        if (f := _fit(kind, uv[kept], difference[kept], covariance[kept], heights[kept])) is not None
    )
    advised, reason = _advised(fits, sigma_px)
    if aside := int((~kept).sum()):
        reason = replace(reason, details=(message("bias.points_excluded", n=aside, total=len(kept)),))
    prior, ratio = rpc.bias_sigma_px(), None
    if prior is not None and advised.kind != "none":
        shift = advised.values[[s in {"A0", "B0"} for s in BIAS_PARAMETERS[advised.kind]]]
        ratio = float(np.sqrt(np.mean((shift / prior) ** 2)))
    aside = np.flatnonzero(~kept)
    left = difference[aside] - bias_design(advised.kind, uv[aside]) @ advised.values
    order = np.argsort(-np.hypot(*left.T), kind="stable")
    return BiasAdvice(
        fits=fits,
        advised=advised,
        reason=reason,
        sigma_px=sigma_px,
        prior_ratio=ratio,
        set_aside=tuple(aside[order].tolist()),
        set_aside_px=left[order],
    )


def point_covariance(rpc: Rpc, geographic: Array, sigma_px: float, sigma_ground_m: Array | None) -> tuple[Array, Array]:
    """(n, 2, 2) covariance of points in the image, that of their ground coordinates included, and its part by heights.

    arguments as of `choose_bias`; [px^2]
    """
    covariance = np.broadcast_to(np.eye(2) * sigma_px**2, (len(geographic), 2, 2))
    if sigma_ground_m is None:
        return covariance, np.zeros_like(covariance)
    J = rpc.project_with_partials(geographic)[1] / metres_per_geographic(geographic)[:, None, :]
    variance = np.asarray(sigma_ground_m) ** 2
    heights = np.einsum("ni,nj,n->nij", J[:, :, 2], J[:, :, 2], variance[:, 2])
    return covariance + J @ (variance[:, :, None] * np.eye(3)) @ np.swapaxes(J, 1, 2), heights


def check_fit(advice: BiasAdvice, fit: BiasFit) -> None:
    """Raise NotSolvable where a fit leaves residuals so large that nothing should be built on it."""
    if fit.misfit > LARGEST_MISFIT:
        x, y = fit.rms
        raise NotSolvable(
            "bias.misfit",
            model=fit.kind,
            advised=advice.advised.kind,
            better=fit.kind != advice.advised.kind,
            x_px=x,
            y_px=y,
            misfit=fit.misfit,
            limit=LARGEST_MISFIT,
            sigma_px=advice.sigma_px,
        )


def _fit(kind: BiasKind, uv: Array, difference: Array, covariance: Array, heights: Array) -> BiasFit | None:
    """Weighted least squares; None where the points do not determine the model."""
    solved = solve_bias(kind, uv, difference, covariance)
    if solved is None:
        return None
    values, Q, square_sum = solved
    residuals = difference - bias_design(kind, uv) @ values
    left_out = np.full(difference.shape, np.nan)
    for i in range(len(uv)):
        others = np.arange(len(uv)) != i
        part = solve_bias(kind, uv[others], difference[others], covariance[others])
        if part is not None and others.any():
            left_out[i] = difference[i] - bias_design(kind, uv[i : i + 1])[0] @ part[0]
    return BiasFit(
        kind=kind,
        values=values,
        covariance=Q,
        height_covariance=_part(Q, bias_design(kind, uv), covariance, heights),
        residuals=residuals,
        rms=np.sqrt(np.mean(residuals**2, axis=0)),
        left_out_rms=np.sqrt(np.mean(left_out**2, axis=0)),
        square_sum=square_sum,
        redundancy=2 * len(uv) - len(values),
    )


def _part(Q: Array, design: Array, covariance: Array, part: Array) -> Array:
    """(k, k) what a part (n, 2, 2) of the covariance of the points makes of that of the parameters."""
    K = np.einsum("ab,nib,nij->naj", Q, design, np.linalg.inv(covariance))
    return np.einsum("nai,nij,nbj->ab", K, part, K)


def _advised(fits: tuple[BiasFit, ...], sigma_px: float) -> tuple[BiasFit, Message]:
    from scipy.stats import chi2, f

    chosen, reason = fits[0], _without_bias(fits[0], len(fits), sigma_px)
    for larger in fits[1:]:
        more = len(larger.values) - len(chosen.values)
        gain = chosen.square_sum - larger.square_sum
        if larger.redundancy >= ENOUGH:
            value = gain / more / max(larger.square_sum / larger.redundancy, 1e-300)
            limit, test = float(f.isf(SIGNIFICANCE, more, larger.redundancy)), "F"
        else:
            value, limit, test = gain, float(chi2.isf(SIGNIFICANCE, more)), "chi-square"
        before, after = (float(np.hypot(*fit.left_out_rms)) for fit in (chosen, larger))
        # a shift alone may be taken on a single point, of which none can be left out
        predicts = after < before or (larger.kind == "shift" and not np.isfinite(after))
        if value > limit and predicts:
            chosen = larger
            few = not np.isfinite(after)
            values: dict[str, Value] = {
                "model": larger.kind, "test": test, "value": float(value), "limit": limit, "few": few,
                "left_out_px": 0.0 if few else after, "before_px": before if np.isfinite(before) else 0.0,
            }  # fmt: skip
            reason = Message(code="bias.improvement", severity=Severity.NOTE, values=values)
    return chosen, reason


def _without_bias(none: BiasFit, models: int, sigma_px: float) -> Message:
    """Whether the points agree with the RPC as it is."""
    if none.misfit > 1:
        values: dict[str, Value] = {"larger": models > 1, "misfit": none.misfit, "sigma_px": sigma_px}
        return Message(code="bias.rpc_contradicted", severity=Severity.WARNING, values=values)
    return Message(code="bias.rpc_confirmed", severity=Severity.NOTE, values={"sigma_px": sigma_px})
