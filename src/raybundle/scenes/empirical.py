"""Empirical models: from object coordinates to the image without knowing the sensor.

Each model is x = f(X, Y, Z; parameters), y = g(...), in object coordinates and image points that are centred and
scaled to about -1 to 1, in which its parameters and their covariance are given.

    affine               x = a1 X + a2 Y + a3 Z + a4, y likewise                                      8 parameters
    affine2              affine with the terms XY, XZ, YZ, X^2, Y^2                                   18
    parallel-perspective y (along track) affine, x projective: one linear pushbroom (Gupta, Hartley)  11
    dlt                  both projective with one denominator (Abdel-Aziz and Karara 1971)            11
    sdlt                 dlt with y / (1 - L12 x) (Wang 1999)                                         12
    plane-affine         from X, Y alone, for rectification of plane objects                          6
    plane-projective     from X, Y alone, a perspective image of a plane                              8

A narrow field of view makes affine enough (IKONOS); wide scenes and relief do not, which `EmpiricalFit.adequate` and
its reason say.  An adequate fit tells about the points that were used, nothing about ground outside them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError, NoConvergence, RankDefect
from raybundle.numerics.arrays import Array

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
class EmpiricalModel:
    """One of the models; `evaluate` and `start` work on normalised coordinates."""

    name: str
    symbols: tuple[str, ...]
    evaluate: Callable[[Array, Array], tuple[Array, Array, Array]]
    """Image points (n, 2), their derivatives (n, 2, 3) by the object point and (n, 2, k) by the parameters."""
    start: Callable[[Array, Array], Array]
    """Parameters (k,) in closed form from object points (n, 3) and image points (n, 2)."""

    @property
    def least_points(self) -> int:
        """Points that determine the parameters."""
        return (len(self.symbols) + 1) // 2


@dataclass(frozen=True, slots=True, kw_only=True)
class EmpiricalFit:
    """A model fitted by least squares, with its statistics."""

    model: EmpiricalModel
    normalisation: Normalisation
    values: Array
    """(k,)"""
    covariance: Array
    """(k, k) from the stated sigma of the image points."""
    residuals_px: Array
    """(n, 2) adjusted - measured."""
    sigma_px: float
    redundancy: int
    sigma0: float
    """sqrt(sum (v / sigma)^2 / redundancy); 1 is expected."""
    adequate: bool
    """Whether the residuals are no larger than the stated sigma explains (chi-square, 0.1 %)."""
    reason: str

    @property
    def standard_deviation_px(self) -> Array:
        """(2,) of the residuals in x and y."""
        return self.residuals_px.std(axis=0)

    def project(self, xyz: Array) -> Array:
        """Image points (n, 2) [px] of object points (n, 3)."""
        return self.project_with_partials(xyz)[0]

    def project_with_partials(self, xyz: Array) -> tuple[Array, Array, Array]:
        """Image points (n, 2) [px], derivatives (n, 2, 3) by the point and (n, 2, k) by the parameters."""
        n = self.normalisation
        uv, by_point, by_values = self.model.evaluate((xyz - n.object_offset) / n.object_scale, self.values)
        factor = n.image_scale
        return n.image_offset + factor * uv, by_point * (factor / n.object_scale), by_values * factor


def fit_empirical(name: str, xyz: Array, xy_px: Array, *, sigma_px: float) -> EmpiricalFit:
    """Fit a model to object points (n, 3), in a Cartesian frame, and image points (n, 2) [px].

    sigma_px  standard deviation of an image coordinate; the object points count as free of error
    raises    InputError for an unknown model or too few points; RankDefect where the points lie so that the
              parameters are not determined (in a plane, for all but plane models); NoConvergence
    """
    model, xyz, xy_px = _named(name), np.asarray(xyz, float), np.asarray(xy_px, float)
    if not sigma_px > 0:
        raise InputError(f"sigma of the image points {sigma_px:g} px must be positive")
    if len(xyz) != len(xy_px) or len(xyz) < model.least_points:
        raise InputError(
            f"{name}: {len(xyz)} object and {len(xy_px)} image points; {len(model.symbols)} parameters need at least "
            f"{model.least_points} of both"
        )
    normalisation = Normalisation.of(xyz, xy_px)
    X = (xyz - normalisation.object_offset) / normalisation.object_scale
    uv = (xy_px - normalisation.image_offset) / normalisation.image_scale
    values, N, v = _least_squares(model, X, uv)
    redundancy = 2 * len(X) - len(values)
    residuals = v * normalisation.image_scale
    square_sum = float(np.sum((residuals / sigma_px) ** 2))
    adequate, reason = _adequate(model, residuals, square_sum, redundancy, sigma_px)
    return EmpiricalFit(
        model=model,
        normalisation=normalisation,
        values=values,
        covariance=np.linalg.inv(N) * (sigma_px / normalisation.image_scale) ** 2,
        residuals_px=residuals,
        sigma_px=sigma_px,
        redundancy=redundancy,
        sigma0=float(np.sqrt(square_sum / redundancy)) if redundancy else float("nan"),
        adequate=adequate,
        reason=reason,
    )


def _least_squares(model: EmpiricalModel, X: Array, uv: Array) -> tuple[Array, Array, Array]:
    """Values, normal matrix and residuals after Gauss-Newton from the closed-form start."""
    k = len(model.symbols)
    values = model.start(X, uv)
    last = np.inf
    for _ in range(50):
        image, _, by_values = model.evaluate(X, values)
        A, l = by_values.reshape(-1, k), (uv - image).reshape(-1)
        scale = np.linalg.norm(A, axis=0)
        if not (np.isfinite(A).all() and (scale > 0).all()) or np.linalg.cond(A / scale) > 1e8:
            raise RankDefect(
                f"{model.name}: its {k} parameters are not determined by these points; they lie in a plane or a line, "
                "or are too few; take a model with fewer parameters or points at other heights"
            )
        step = np.linalg.lstsq(A / scale, l, rcond=None)[0] / scale
        values = values + step
        size = float(np.abs(step).max() / max(1.0, float(np.abs(values).max())))
        if size < 1e-12 or (size < 1e-9 and size > 0.3 * last):
            image, _, by_values = model.evaluate(X, values)
            A = by_values.reshape(-1, k)
            return values, A.T @ A, image - uv
        last = size
    raise NoConvergence(
        f"{model.name}: no minimum after 50 iterations (last step {last:.2g}); the points may hold a blunder"
    )


def _adequate(
    model: EmpiricalModel, residuals: Array, square_sum: float, redundancy: int, sigma_px: float
) -> tuple[bool, str]:
    from scipy.stats import chi2  # noqa: PLC0415  (SciPy only where it is asked for)

    if redundancy == 0:
        return True, f"{model.name}: no redundancy; nothing can be said about how well the model fits"
    limit = float(chi2.isf(SIGNIFICANCE, redundancy))
    x, y = np.sqrt(np.mean(residuals**2, axis=0))
    ratio = np.sqrt(square_sum / redundancy)
    if square_sum <= limit:
        return True, f"{model.name}: residuals of {x:.3g}, {y:.3g} px (rms) agree with a sigma of {sigma_px:g} px"
    return False, (
        f"{model.name} is not adequate for this scene: residuals of {x:.3g}, {y:.3g} px (rms) are {ratio:.3g} times "
        f"what a sigma of {sigma_px:g} px explains (limit {np.sqrt(limit / redundancy):.3g}); take the scene's RPC or "
        "rigorous model, or a model with more parameters"
    )


# --- the models ---------------------------------------------------------------------------------------------------


def _linear(
    terms: Callable[[Array], tuple[Array, Array]], count: int
) -> tuple[Callable[..., tuple[Array, Array, Array]], Callable[[Array, Array], Array]]:
    """A model whose x and y are the same terms with coefficients of their own."""

    def evaluate(X: Array, p: Array) -> tuple[Array, Array, Array]:
        T, slope = terms(X)
        a = p.reshape(2, count)
        by_values = np.zeros((len(X), 2, 2 * count))
        by_values[:, 0, :count] = by_values[:, 1, count:] = T
        return T @ a.T, np.einsum("ak,nkj->naj", a, slope), by_values

    def start(X: Array, uv: Array) -> Array:
        return np.linalg.lstsq(terms(X)[0], uv, rcond=None)[0].T.reshape(-1)

    return evaluate, start


def _affine_terms(X: Array) -> tuple[Array, Array]:
    slope = np.zeros((len(X), 4, 3))
    slope[:, :3] = np.eye(3)
    return np.concatenate([X, np.ones((len(X), 1))], axis=1), slope


def _affine2_terms(X: Array) -> tuple[Array, Array]:
    T, slope = _affine_terms(X)
    pairs = ((0, 1), (0, 2), (1, 2), (0, 0), (1, 1))
    more = np.zeros((len(X), len(pairs), 3))
    for k, (i, j) in enumerate(pairs):
        more[:, k, i] += X[:, j]
        more[:, k, j] += X[:, i]
    products = np.stack([X[:, i] * X[:, j] for i, j in pairs], axis=1)
    return np.concatenate([T, products], axis=1), np.concatenate([slope, more], axis=1)


def _plane_affine_terms(X: Array) -> tuple[Array, Array]:
    slope = np.zeros((len(X), 3, 3))
    slope[:, :2, :2] = np.eye(2)
    return np.concatenate([X[:, :2], np.ones((len(X), 1))], axis=1), slope


_IN_DLT = [0, 1, 3, 4, 5, 7, 8, 9]
"""Parameters of the DLT that the image of a plane keeps."""


def _plane_projective(X: Array, p: Array) -> tuple[Array, Array, Array]:
    """The DLT without its terms in Z."""
    L = np.zeros(11)
    L[_IN_DLT] = p
    uv, by_X, by_L = _dlt(X * [1, 1, 0], L)
    return uv, by_X, by_L[:, :, _IN_DLT]


def _plane_projective_start(X: Array, uv: Array) -> Array:
    rows = _dlt_rows(X * [1, 1, 0], uv)[:, :, _IN_DLT]
    return np.linalg.lstsq(rows.reshape(-1, 8), uv.reshape(-1), rcond=None)[0]


def _ratio(X: Array, top: Array, bottom: Array) -> tuple[Array, Array, Array, Array]:
    """Homogeneous points (n, 4), the ratio (n,) top / (1 + bottom), its derivatives (n, 3) and the denominator (n,)."""
    H = np.concatenate([X, np.ones((len(X), 1))], axis=1)
    D = 1 + X @ bottom
    value = (H @ top) / D
    return H, value, (top[:3] - value[:, None] * bottom) / D[:, None], D


def _parallel(X: Array, p: Array) -> tuple[Array, Array, Array]:
    """L1..L4 over 1 + L5..L7 for x, L8..L11 for y."""
    H, x, x_by_X, D = _ratio(X, p[:4], p[4:7])
    by_values = np.zeros((len(X), 2, 11))
    by_values[:, 0, :4] = H / D[:, None]
    by_values[:, 0, 4:7] = -x[:, None] * X / D[:, None]
    by_values[:, 1, 7:] = H
    y_by_X = np.broadcast_to(p[7:10], (len(X), 3))
    return np.stack([x, H @ p[7:]], axis=1), np.stack([x_by_X, y_by_X], axis=1), by_values


def _parallel_start(X: Array, uv: Array) -> Array:
    H = np.concatenate([X, np.ones((len(X), 1))], axis=1)
    y = np.linalg.lstsq(H, uv[:, 1], rcond=None)[0]
    x = np.linalg.lstsq(np.concatenate([H, -uv[:, :1] * X], axis=1), uv[:, 0], rcond=None)[0]
    return np.concatenate([x, y])


def _dlt(X: Array, p: Array) -> tuple[Array, Array, Array]:
    """L1..L4 and L5..L8 over 1 + L9..L11."""
    H, x, x_by_X, D = _ratio(X, p[:4], p[8:11])
    _, y, y_by_X, _ = _ratio(X, p[4:8], p[8:11])
    uv = np.stack([x, y], axis=1)
    by_values = np.zeros((len(X), 2, 11))
    by_values[:, 0, :4] = by_values[:, 1, 4:8] = H / D[:, None]
    by_values[:, :, 8:] = -uv[:, :, None] * (X / D[:, None])[:, None, :]
    return uv, np.stack([x_by_X, y_by_X], axis=1), by_values


def _dlt_rows(X: Array, uv: Array) -> Array:
    H = np.concatenate([X, np.ones((len(X), 1))], axis=1)
    rows = np.zeros((len(X), 2, 11))
    rows[:, 0, :4] = rows[:, 1, 4:8] = H
    rows[:, :, 8:] = -uv[:, :, None] * X[:, None, :]
    return rows


def _dlt_start(X: Array, uv: Array) -> Array:
    return np.linalg.lstsq(_dlt_rows(X, uv).reshape(-1, 11), uv.reshape(-1), rcond=None)[0]


def _sdlt(X: Array, p: Array) -> tuple[Array, Array, Array]:
    """The DLT with y / (1 - L12 x)."""
    uv, by_X, by_L = _dlt(X, p[:11])
    x, y = uv.T
    D = 1 - p[11] * x
    by_values = np.zeros((len(X), 2, 12))
    by_values[:, :, :11] = by_L
    by_values[:, 1, :11] = by_L[:, 1] / D[:, None] + (y * p[11] / D**2)[:, None] * by_L[:, 0]
    by_values[:, 1, 11] = y * x / D**2
    bent = by_X[:, 1] / D[:, None] + (y * p[11] / D**2)[:, None] * by_X[:, 0]
    return np.stack([x, y / D], axis=1), np.stack([by_X[:, 0], bent], axis=1), by_values


def _sdlt_start(X: Array, uv: Array) -> Array:
    rows = np.concatenate([_dlt_rows(X, uv), np.zeros((len(X), 2, 1))], axis=2)
    rows[:, 1, 11] = uv[:, 0] * uv[:, 1]
    return np.linalg.lstsq(rows.reshape(-1, 12), uv.reshape(-1), rcond=None)[0]


def _numbered(letter: str, count: int) -> tuple[str, ...]:
    return tuple(f"{letter}{k}" for k in range(1, count + 1))


def _models() -> dict[str, EmpiricalModel]:
    affine, affine_start = _linear(_affine_terms, 4)
    affine2, affine2_start = _linear(_affine2_terms, 9)
    plane, plane_start = _linear(_plane_affine_terms, 3)
    plane_symbols = _numbered("a", 3) + _numbered("b", 3)
    models = (
        EmpiricalModel(
            name="affine", symbols=_numbered("a", 4) + _numbered("b", 4), evaluate=affine, start=affine_start
        ),
        EmpiricalModel(
            name="affine2", symbols=_numbered("a", 9) + _numbered("b", 9), evaluate=affine2, start=affine2_start
        ),
        EmpiricalModel(
            name="parallel-perspective", symbols=_numbered("L", 11), evaluate=_parallel, start=_parallel_start
        ),
        EmpiricalModel(name="dlt", symbols=_numbered("L", 11), evaluate=_dlt, start=_dlt_start),
        EmpiricalModel(name="sdlt", symbols=_numbered("L", 12), evaluate=_sdlt, start=_sdlt_start),
        EmpiricalModel(name="plane-affine", symbols=plane_symbols, evaluate=plane, start=plane_start),
        EmpiricalModel(
            name="plane-projective",
            symbols=_numbered("h", 8),
            evaluate=_plane_projective,
            start=_plane_projective_start,
        ),
    )
    return {m.name: m for m in models}


empirical_models = _models()


def _named(name: str) -> EmpiricalModel:
    if name not in empirical_models:
        raise InputError(f"unknown empirical model {name!r}; known: {', '.join(empirical_models)}")
    return empirical_models[name]
