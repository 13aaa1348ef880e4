"""The empirical models: image points, their derivatives and closed-form starts, in normalised coordinates."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array


@dataclass(frozen=True, slots=True, kw_only=True)
class EmpiricalModel:
    """One of the models; `evaluate` and `start` work on normalised coordinates."""

    name: str
    symbols: tuple[str, ...]
    evaluate: Callable[[Array, Array], tuple[Array, Array, Array]]
    """Image points (n, 2), their derivatives (n, 2, 3) by the object point and (n, 2, k) by the parameters."""
    start: Callable[[Array, Array], Array]
    """Parameters (k,) in closed form from object points (n, 3) and image points (n, 2)."""
    powers: tuple[tuple[int, int], ...]
    """(k,) of the units of length in the image and in object space, in each parameter: (1, -1) is px / length."""
    additional: tuple[str, ...] = ()
    """Parameters that may be left out (held at zero), as those of a lens."""

    @property
    def least_points(self) -> int:
        """Points that determine the parameters."""
        return (len(self.symbols) + 1) // 2


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


_BROWN = ("K1", "K2", "K3", "P1", "P2")


def _principal_point(L: Array) -> tuple[Array, Array]:
    """Of the DLT's interior orientation (2,), and its derivatives (2, 11); far away where the view is parallel."""
    c = L[8:11]
    cc = max(float(c @ c), 1e-300)
    by = np.zeros((2, 11))
    x0 = np.empty(2)
    for axis, a in enumerate((slice(0, 3), slice(4, 7))):
        x0[axis] = L[a] @ c / cc
        by[axis, a] = c / cc
        by[axis, 8:11] = (L[a] - 2 * x0[axis] * c) / cc
    return x0, by


def _brown(d: Array, k: Array) -> tuple[Array, Array, Array]:
    """Corrections (n, 2) at points d (n, 2) from the principal point, derivatives by d (n, 2, 2) and k (n, 2, 5)."""
    u, v = d.T
    r2 = u * u + v * v
    K1, K2, K3, P1, P2 = k
    radial = r2 * (K1 + r2 * (K2 + r2 * K3))
    slope = K1 + r2 * (2 * K2 + 3 * r2 * K3)
    by_k = np.empty((len(d), 2, 5))
    for axis, w in enumerate((u, v)):
        by_k[:, axis, :3] = w[:, None] * r2[:, None] ** np.arange(1, 4)
    by_k[:, 0, 3], by_k[:, 0, 4] = r2 + 2 * u * u, 2 * u * v
    by_k[:, 1, 3], by_k[:, 1, 4] = 2 * u * v, r2 + 2 * v * v
    by_d = np.empty((len(d), 2, 2))
    by_d[:, 0, 0] = radial + 2 * u * u * slope + 6 * P1 * u + 2 * P2 * v
    by_d[:, 1, 1] = radial + 2 * v * v * slope + 6 * P2 * v + 2 * P1 * u
    by_d[:, 0, 1] = by_d[:, 1, 0] = 2 * u * v * slope + 2 * P1 * v + 2 * P2 * u
    return by_k @ k, by_d, by_k


def _inverse2(J: Array) -> Array:
    """Inverses (n, 2, 2) of matrices (n, 2, 2); not finite where there is none."""
    turned = np.stack([J[:, 1, 1], -J[:, 0, 1], -J[:, 1, 0], J[:, 0, 0]], axis=1).reshape(-1, 2, 2)
    return turned / (J[:, 0, 0] * J[:, 1, 1] - J[:, 0, 1] * J[:, 1, 0])[:, None, None]


def _dlt_brown(X: Array, p: Array) -> tuple[Array, Array, Array]:
    """The DLT at the image point with Brown's corrections: m + corrections(m - principal point) = DLT(X)."""
    uv, by_X, by_L = _dlt(X, p[:11])
    x0, x0_by_L = _principal_point(p[:11])
    m = uv.copy()
    with np.errstate(all="ignore"):  # values of a step that went too far are not finite, which the caller sees
        for _ in range(30):
            correction, by_d, _ = _brown(m - x0, p[11:])
            step = (_inverse2(np.eye(2) + by_d) @ (uv - m - correction)[:, :, None])[:, :, 0]
            m = m + step
            if not np.abs(step).max() > 1e-14:
                break
        _, by_d, by_k = _brown(m - x0, p[11:])
        inverse = _inverse2(np.eye(2) + by_d)
    by_values = np.concatenate([by_L + by_d @ x0_by_L, -by_k], axis=2)
    return m, inverse @ by_X, inverse @ by_values


def _dlt_brown_start(X: Array, uv: Array) -> Array:
    """Closed form: the DLT gives the principal point and the denominators, with which all sixteen are linear."""
    plain = np.concatenate([_dlt_start(X, uv), np.zeros(5)])
    rows, p = _dlt_rows(X, uv), plain
    for _ in range(3):
        d = uv - _principal_point(p[:11])[0]
        lens = -_brown(d, np.zeros(5))[2] * (1 + X @ p[8:11])[:, None, None]
        A = np.concatenate([rows, lens], axis=2).reshape(-1, 16)
        if not np.isfinite(A).all():
            return plain
        scale = np.linalg.norm(A, axis=0)
        scale[scale == 0] = 1.0
        p = np.linalg.lstsq(A / scale, uv.reshape(-1), rcond=1e-12)[0] / scale
        if np.abs(p[11:]).max() > 1:  # too little depth or field to show the lens: begin without it
            return plain
    return p


def _numbered(letter: str, count: int) -> tuple[str, ...]:
    return tuple(f"{letter}{k}" for k in range(1, count + 1))


_LINEAR, _PLACE, _DENOMINATOR = (1, -1), (1, 0), (0, -1)
_ROW = (_LINEAR,) * 3 + (_PLACE,)
_SECOND = (*_ROW, *((1, -2),) * 5)
_PROJECTIVE = (*_ROW, *_ROW, *(_DENOMINATOR,) * 3)
_LENS = ((-2, 0), (-4, 0), (-6, 0), (-1, 0), (-1, 0))


def _models() -> dict[str, EmpiricalModel]:
    affine, affine_start = _linear(_affine_terms, 4)
    affine2, affine2_start = _linear(_affine2_terms, 9)
    plane, plane_start = _linear(_plane_affine_terms, 3)
    plane_symbols = _numbered("a", 3) + _numbered("b", 3)
    plane_row = (_LINEAR, _LINEAR, _PLACE)
    models = (
        EmpiricalModel(
            name="affine", symbols=_numbered("a", 4) + _numbered("b", 4), evaluate=affine, start=affine_start,
            powers=_ROW * 2,
        ),
        EmpiricalModel(
            name="affine2", symbols=_numbered("a", 9) + _numbered("b", 9), evaluate=affine2, start=affine2_start,
            powers=_SECOND * 2,
        ),
        EmpiricalModel(
            name="parallel-perspective", symbols=_numbered("L", 11), evaluate=_parallel, start=_parallel_start,
            powers=(*_ROW, *(_DENOMINATOR,) * 3, *_ROW),
        ),
        EmpiricalModel(
            name="dlt", symbols=_numbered("L", 11), evaluate=_dlt, start=_dlt_start, powers=_PROJECTIVE
        ),
        EmpiricalModel(
            name="dlt-brown", symbols=_numbered("L", 11) + _BROWN, evaluate=_dlt_brown, start=_dlt_brown_start,
            powers=(*_PROJECTIVE, *_LENS), additional=_BROWN,
        ),
        EmpiricalModel(
            name="sdlt", symbols=_numbered("L", 12), evaluate=_sdlt, start=_sdlt_start,
            powers=(*_PROJECTIVE, (-1, 0)),
        ),
        EmpiricalModel(
            name="plane-affine", symbols=plane_symbols, evaluate=plane, start=plane_start, powers=plane_row * 2
        ),
        EmpiricalModel(
            name="plane-projective", symbols=_numbered("h", 8), evaluate=_plane_projective,
            start=_plane_projective_start, powers=(*plane_row, *plane_row, *(_DENOMINATOR,) * 2),
        ),
    )  # fmt: skip
    return {m.name: m for m in models}


empirical_models = _models()
