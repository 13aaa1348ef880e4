"""What a corrected RPC states of its own errors: ERR_BIAS and ERR_RAND after its bias was adjusted.

Both are root mean squares in metres along one horizontal axis: ERR_BIAS of the error that all points of the image have
in common, ERR_RAND of that of each single point (STDI-0002, RPC00B; the same words in GDAL's RPC domain).  A viewing
ray is fixed in the image, so that an error of the image is one of the ground at a given height: with G the derivatives
of east, north by x, y at the middle of the scene,

    C_ground = G D C D' G'        ERR_BIAS = sqrt(trace(C_ground) / 2)

where C is the covariance of the adjusted bias, enlarged by the misfit, and D its derivatives at the middle (A0, B0).
ERR_RAND is the scatter of the control points about the corrected RPC, and what A1 ... B2 are uncertain by over the
image; the errors of measuring the points are in it, so that it is an upper limit.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import metres_per_geographic
from raybundle.scenes.bias import BIAS_PARAMETERS, BiasKind, bias_design
from raybundle.scenes.bias_choice import ENOUGH, BiasAdvice, BiasFit
from raybundle.scenes.rpc import Rpc

GAUSS = np.array([[u, v] for u in (-1, 1) for v in (-1, 1)]) / np.sqrt(3)
"""Places over which the mean of a square of linear terms is that of the whole image."""


@dataclass(frozen=True, slots=True, kw_only=True)
class GroundErrors:
    """Errors of an RPC on the ground, at the middle of the scene."""

    err_bias_m: float
    """ERR_BIAS"""
    err_rand_m: float | None
    """ERR_RAND; None where neither the points nor the vendor show it"""
    covariance_m2: Array
    """(2, 2) of east and north of the common error [m^2]"""
    height_share_m: float
    """the part of ERR_BIAS that comes from the stated standard deviations of the heights of the points"""
    per_height: Array
    """(2,) metres east and north by which a ground point moves for each metre that its height is wrong: no error of
    heights is in ERR_BIAS or ERR_RAND but that of the control points"""
    measured_rand: bool
    """whether the points stated ERR_RAND; else it is the vendor's"""

    def of(self, rpc: Rpc) -> Rpc:
        """An RPC that states it."""
        return replace(rpc, err_bias_m=self.err_bias_m, err_rand_m=self.err_rand_m)


def ground_errors(rpc: Rpc, advice: BiasAdvice, fit: BiasFit) -> GroundErrors:
    """The errors of an RPC that was corrected by this fit.

    Without a correction (none) the common error is the shift that was found and left, and its standard deviation.
    Limits: errors that all control points have in common, of their datum or of their geoid.
    """
    G, per_height = _ground_by_image(rpc)
    kept: BiasFit | None = fit
    left = np.zeros(2)
    if fit.kind == "none":
        kept = next((f for f in advice.fits if f.kind == "shift"), None)
        left = np.zeros(2) if kept is None else kept.values
    common = height = np.zeros((2, 2))
    if kept is not None:
        common = common_covariance(kept.kind, kept.misfit**2 * kept.covariance)
        height = common_covariance(kept.kind, kept.misfit**2 * kept.height_covariance)
    C = G @ (common + np.outer(left, left)) @ G.T
    rand, measured = _random(rpc, G, fit)
    return GroundErrors(
        err_bias_m=_per_axis(C), err_rand_m=rand, covariance_m2=C, height_share_m=_per_axis(G @ height @ G.T),
        per_height=per_height, measured_rand=measured,
    )  # fmt: skip


def errors_of_covariance(rpc: Rpc, kind: BiasKind, covariance: Array) -> tuple[float, float]:
    """ERR_BIAS, and what terms that change over the image add to ERR_RAND [m], of a bias with this covariance [px^2].

    For a bias that was adjusted in a block, whose covariance holds everything.
    """
    G, _ = _ground_by_image(rpc)
    common, changing = common_covariance(kind, covariance), _changing(kind, covariance)
    return _per_axis(G @ common @ G.T), _per_axis(G @ changing @ G.T)


def common_covariance(kind: BiasKind, covariance: Array) -> Array:
    """(2, 2) of x, y at the middle of the image [px^2], of a bias with this covariance (k, k)."""
    D = bias_design(kind, np.zeros((1, 2)))[0]
    return D @ covariance @ D.T


def _changing(kind: BiasKind, covariance: Array) -> Array:
    """(2, 2) of x, y [px^2], mean over the image, of the terms that are not the same everywhere."""
    D = bias_design(kind, GAUSS)
    D[:, :, [s[1] == "0" for s in BIAS_PARAMETERS[kind]]] = 0
    return np.einsum("nia,ab,njb->ij", D, covariance, D) / len(D)


def _random(rpc: Rpc, G: Array, fit: BiasFit) -> tuple[float | None, bool]:
    changing = _per_axis(G @ _changing(fit.kind, fit.misfit**2 * fit.covariance) @ G.T)
    if fit.redundancy >= ENOUGH:
        v = fit.residuals
        scatter = _per_axis(G @ (v.T @ v) @ G.T * 2 / fit.redundancy)
        return float(np.hypot(scatter, changing)), True
    if rpc.err_rand_m is None:
        return (changing or None), False
    return float(np.hypot(rpc.err_rand_m, changing)), False


def _ground_by_image(rpc: Rpc) -> tuple[Array, Array]:
    """(2, 2) derivatives of east, north by x, y [m/px], and (2,) by the height along a ray, at the middle."""
    centre = rpc.ground_offset[None]
    by_metres = rpc.project_with_partials(centre)[1][0] / metres_per_geographic(centre)[0]
    G = np.linalg.inv(by_metres[:, :2])
    return G, -G @ by_metres[:, 2]


def _per_axis(covariance: Array) -> float:
    return float(np.sqrt(np.trace(covariance) / 2))
