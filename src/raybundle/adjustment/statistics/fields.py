"""Smooth errors that differ from image to image: fields, and how large they are by the residuals themselves.

Lens stabilisers, focus, shutters and compression displace image points smoothly, and differently in each image; what
is left of a photograph's errors is correlated over hundreds of pixels.  Both make standard deviations from white noise
too small on real photographs, by factors of 1.5 to 14.  The model here: in each image a field of Legendre products of
degree 1 and 2 whose coefficients are random with one standard deviation tau [px]; a scale, which a wandering focus
moves, with one of its own (variance components: Rao and Kleffe 1988); and a floor phi >= 1 by which all noise carries
less information than white noise would (in the sense of quasi-likelihood: McCullagh and Nelder 1989).  The estimates
stay those of least squares; only their covariance and what is stated of it change
(`raybundle.adjustment.statistics.noise`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.adjustment.system.dense import as_many_threads_as_help
from raybundle.block import Camera
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.maths import Scalar
from raybundle.sensors import Parameter, SensorModel

DEGREE = 2
"""Largest degree of a field; what is smoother still, a shift of the whole image, the principal point takes."""
TERMS = tuple((d - i, i) for d in range(1, DEGREE + 1) for i in range(d + 1))
"""Degrees in x and y of each product."""
COLUMNS = 2 * len(TERMS)
"""Coefficients of an image: each product in x and in y."""
NEGLIGIBLE = 1e-7
"""Of the largest eigenvalue, below which a direction of the fields is what orientations and points absorb."""
MOST = 30.0
"""What a direction counts at most, in its own variances (5.5 standard deviations): a blunder is no field."""
FOCUS = np.zeros(COLUMNS)
FOCUS[[2 * TERMS.index((1, 0)), 2 * TERMS.index((0, 1)) + 1]] = 1 / np.sqrt(3)
"""Coefficients of a change of scale that displaces by a pixel at half the longer side of the format."""
GRID = 21
CLOSINGS = 60
"""Grids at most: six close in from everywhere, the others follow a valley."""
PRECISION = 1e-3
"""Of the logarithms of phi and tau^2, and of twice the log-likelihood."""
SIGNIFICANT = 5.41
"""Twice the gain of log-likelihood that one more variance has by chance in one case of a hundred (Self and Liang 1987:
half of chi-square with one degree of freedom, for a variance at its border)."""
TOGETHER = 500
"""Images that are worked on at once: 16 MB of the scores of a sample."""
REACH = 14.0
"""Of the logarithms, from where a search begins."""
FEWEST_DIRECTIONS = 20
"""Directions from which on two numbers can be determined: their standard deviation is then below a third."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Noise:
    """What was assumed of the noise of the image coordinates, and what was found."""

    kind: str
    """white | fields"""
    phi: float = 1.0
    """Floor: variance of smooth sums of the noise, in units of white noise; 1 for white noise"""
    tau_px: float = 0.0
    """Standard deviation of the coefficients of each image's field; about the field's rms per coordinate and term"""
    focus_px: float = 0.0
    """Standard deviation of each image's scale, which a wandering focus makes: displacement at half the longer side"""
    directions: int = 0
    """Independent combinations of the fields that the residuals show"""
    chi_square: float = 1.0
    """Mean square of the residuals in these directions, in units of what white noise would leave there"""
    images: int = 0
    """Images that have a field"""
    sampled: int = 0
    """Images whose residuals phi and tau were taken from"""
    share: float = 0.0
    """Of the variances of the interior orientations (projection centres where none is free) that fields cause: mean"""
    ratio_interior: float = 1.0
    """Standard deviations of interior orientations over those of white noise: median; also of the following; NaN where
    there are none"""
    ratio_images: float = 1.0
    ratio_points: float = 1.0
    reason: str = ""
    """Why white noise was assumed, where fields had been asked for"""


WHITE = Noise(kind="white")


def smooth_px(tau_square: float, focus_square: float) -> float:
    """Standard deviation [px] of an image coordinate by fields and a wandering focus, over a square format."""
    return float(np.sqrt(tau_square * sum(1 / (i + j) ** 2 for i, j in TERMS) + focus_square / 3))


def field_shapes(x: Array, y: Array) -> Array:
    """Values (terms, n) of the products at coordinates over half the longer side of the format.

    Normalised to a mean square of one over the square -1 .. 1; a term of degree d is divided by d, so that fields fall
    off with their degree.
    """
    X, Y = ((np.ones_like(t), t, 1.5 * t * t - 0.5) for t in (x, y))
    return np.stack([X[a] * Y[b] * (np.sqrt((2 * a + 1) * (2 * b + 1)) / (a + b)) for a, b in TERMS])


class WithFields(SensorModel, registered=False):
    """A camera whose image points are displaced by a field, in pixels: the model's parameters, and the coefficients.

    Its partial derivatives are all that is wanted: the coefficients themselves are zero.
    """

    name = "fields"
    columns = COLUMNS
    """Coefficients of an image"""
    explicit = False  # the field is taken at the adjusted image point: at the measured one it would see its noise

    def __init__(self, camera: Camera) -> None:
        """The sensor model of a camera, with its format."""
        self.base = camera.sensor
        self.parameters = self.base.parameters + self._coefficients()
        self._pixel = np.array(camera.pixel_mm)
        self._half = max(camera.width_px, camera.height_px) / 2

    def _coefficients(self) -> tuple[Parameter, ...]:
        return tuple(Parameter(f"f{axis}{a}{b}", "px", f"field in {axis}") for a, b in TERMS for axis in "xy")

    @property
    def condition_and_jacobian(self) -> Callable[..., tuple[Array, Array]]:  # pyright: ignore[reportIncompatibleVariableOverride]
        """G (2, n) and its Jacobian, the fields' columns last."""
        return self._evaluate

    def _evaluate(self, x: Array, y: Array, X: Array, Y: Array, Z: Array, *values: Scalar) -> tuple[Array, Array]:
        g, J = self.base.condition_and_jacobian(x, y, X, Y, Z, *values[: -self.columns])
        # measured = true + field: the condition holds at the measured point less the field
        return g, np.concatenate([J, -np.einsum("ijn,jkn->ikn", J[:, :2], self.displacements(x, y))], axis=1)

    def displacements(self, x: Array, y: Array) -> Array:
        """Displacements (2, 10, n) [mm] by the coefficients [px] of image points [mm]."""
        shapes = field_shapes(x / (self._pixel[0] * self._half), y / (self._pixel[1] * self._half))
        found = np.zeros((2, COLUMNS, shapes.shape[1]))
        found[0, ::2], found[1, 1::2] = self._pixel[0] * shapes, self._pixel[1] * shapes
        return found

    def in_front(self, points: Array, image: Array | None = None, values: Array | None = None) -> Mask:
        """As the camera's own model states."""
        return self.base.in_front(points, image, None if values is None else values[: -self.columns])


OWN = ("c", "x0", "y0", "K1")
"""What an image may have of its own beside the others of its camera, in pixels: c and K1 at half the longer side."""


class WithOwnInterior(WithFields, registered=False):
    """A camera whose images have a field each, and a camera constant, principal point and radial distortion."""

    name = "own interior orientation"
    columns = COLUMNS + len(OWN)

    def _coefficients(self) -> tuple[Parameter, ...]:
        return super()._coefficients() + tuple(Parameter(f"own {s}", "px", f"{s} of one image") for s in OWN)

    def displacements(self, x: Array, y: Array) -> Array:
        """Displacements (2, 14, n) [mm] by the coefficients [px] of image points [mm]."""
        X, Y = x / (self._pixel[0] * self._half), y / (self._pixel[1] * self._half)
        square = X * X + Y * Y
        one, none = np.ones_like(X), np.zeros_like(X)
        shapes = np.stack([np.stack([X, one, none, X * square]), np.stack([Y, none, one, Y * square])])
        return np.concatenate([super().displacements(x, y), self._pixel[:, None, None] * shapes], axis=1)


@dataclass(frozen=True, slots=True, kw_only=True)
class Components:
    """Variance components of the noise."""

    phi: float
    tau_square: float
    """[px^2]"""
    focus_square: float
    """[px^2], at half the longer side of the format"""
    directions: int
    chi_square: float

    @property
    def smooth_px(self) -> float:
        """Standard deviation of an image coordinate by smooth errors of single images."""
        return smooth_px(self.tau_square, self.focus_square)

    def root(self, variance: float) -> Array:
        """A square root (10, 10) of the covariance of an image's coefficients, in units of `variance`."""
        return root_of_fields(self.tau_square, self.focus_square) / np.sqrt(variance)


def root_of_fields(tau_square: float, focus_square: float) -> Array:
    """A square root (10, 10) [px] of the covariance of an image's coefficients."""
    tau, size = np.sqrt(tau_square), float(FOCUS @ FOCUS)
    along = np.sqrt(tau_square + focus_square * size)
    return tau * np.eye(COLUMNS) + (along - tau) * np.outer(FOCUS, FOCUS) / size


@dataclass(frozen=True, slots=True, kw_only=True)
class Scores:
    """Independent scores of the fields: y has the covariance phi + tau^2 diag(weight) + focus^2 B B'."""

    y: Array
    """(k,)"""
    weight: Array
    """(k,) [px^-2]"""
    B: Array
    """(k, n) [px^-1]"""


def independent_scores(M: Array, scores: Array, variance: float, across: Array | None = None) -> Scores:
    """The scores in their eigen-directions, in units of what white noise makes of them.

    M         (k, k) what is left of the fields' normal matrix when all unknowns are eliminated: F' W R F
    scores    (k,) F' W v, of the covariance phi s0^2 M + M cov(fields) M
    variance  sigma0^2
    across    (k, 10 f) where the scores are those of some images: F' W R G, G the columns of all f
    Directions that orientations and points absorb (NEGLIGIBLE) are left out.
    """
    from scipy.linalg import eigh

    with as_many_threads_as_help(len(M)):
        values, vectors = eigh((M + M.T) / 2)
        kept = values > NEGLIGIBLE * max(values[-1], 0.0)
        values, vectors = values[kept], vectors[:, kept]
        whiten = vectors / np.sqrt(values * variance)
        y = whiten.T @ scores
        if across is None:
            weight, T = values / variance, np.sqrt(values / variance)[:, None] * vectors.T
            B = T.reshape(len(y), -1, COLUMNS) @ FOCUS
        else:
            square, B = np.zeros((len(y), len(y))), np.empty((len(y), across.shape[1] // COLUMNS))
            for k in range(0, across.shape[1], TOGETHER * COLUMNS):
                T = whiten.T @ across[:, k : k + TOGETHER * COLUMNS]
                square += T @ T.T
                B[:, k // COLUMNS : k // COLUMNS + TOGETHER] = T.reshape(len(y), -1, COLUMNS) @ FOCUS
            weight, turn = eigh(square)
            y, B = turn.T @ y, turn.T @ B
        if B.shape[1] > len(y):  # only B B' counts
            square, vectors = eigh(B @ B.T)
            B = vectors * np.sqrt(np.maximum(square, 0.0))
    return Scores(y=y, weight=np.maximum(weight, 0.0), B=B)


def variance_components(samples: Sequence[Scores]) -> Components:
    """Floor phi >= 1, fields tau^2 >= 0 and focus^2 >= 0 by maximum likelihood from the scores of the residuals.

    A direction counts at most MOST times its variance.  Several samples count as if they were independent.  A focus
    that wanders is believed where its likelihood ratio is SIGNIFICANT: where heights absorb it, as over flat ground,
    what would be found is chance, and large.
    """
    y, weight = (np.concatenate([getattr(s, name) for s in samples]) for name in ("y", "weight"))
    if not len(y):
        return Components(phi=1.0, tau_square=0.0, focus_square=0.0, directions=0, chi_square=1.0)
    phi, tau_square = _floor_and_fields(weight, y**2)
    best = _cost(samples, phi, tau_square, 0.0), phi, tau_square, 0.0
    felt = float(np.mean(np.concatenate([(s.B**2).sum(axis=1) for s in samples])))
    scale = 1 / max(felt, 1e-300)
    # from what was found without a wandering focus, and from where it explains most of it
    starts = ((phi, max(tau_square, 1e-3 / float(np.median(weight))), scale), (1.2, tau_square / 10, 10 * scale))
    with as_many_threads_as_help(max(s.B.shape[1] for s in samples)):
        for start in starts if _falls(samples, phi, tau_square) else ():
            found = _descended(samples, start)
            if found[0] < best[0] - (SIGNIFICANT if best[3] == 0 else 0.0):
                best = found
    if best[2] > 0 and _cost(samples, best[1], 0.0, best[3]) <= best[0] + PRECISION:
        best = best[0], best[1], 0.0, best[3]
    square = float(np.mean(y**2))
    return Components(phi=best[1], tau_square=best[2], focus_square=best[3], directions=len(y), chi_square=square)


def _cost(samples: Sequence[Scores], phi: float, tau_square: float, focus_square: float) -> float:
    """Minus twice the log-likelihood, but for a constant."""
    from scipy.linalg import get_blas_funcs, get_lapack_funcs

    blas: Any = get_blas_funcs
    lapack: Any = get_lapack_funcs
    total = 0.0
    for s in samples:
        d = phi + tau_square * s.weight
        if focus_square <= 0:
            total += float(np.sum(np.log(d) + np.minimum(s.y**2 / d, MOST)))
            continue
        # C = D + focus^2 B B', with n columns B: its determinant and inverse by matrices of n rows
        most = np.sqrt(MOST * (d + focus_square * (s.B**2).sum(axis=1)))
        y = np.clip(s.y, -most, most)
        E = np.sqrt(focus_square / d)[:, None] * s.B
        # SciPy's BLAS: the threads of NumPy's wait for one another where processors are busy
        inner = blas(("syrk",), (E,))[0](1.0, E, trans=1)
        inner[np.diag_indices_from(inner)] += 1.0
        potrf, trtrs = lapack(("potrf", "trtrs"), (E,))
        U = potrf(inner, lower=0)[0]
        r = trtrs(U, E.T @ (y / np.sqrt(d)), lower=0, trans=1)[0]
        total += float(np.sum(np.log(d) + y**2 / d) + 2 * np.log(np.diagonal(U)).sum() - r @ r)
    return total


def _falls(samples: Sequence[Scores], phi: float, tau_square: float) -> bool:
    """Whether a little of a wandering focus makes the cost less."""
    slope = 0.0
    for s in samples:
        d = phi + tau_square * s.weight
        y = np.clip(s.y, -np.sqrt(MOST * d), np.sqrt(MOST * d))
        slope += float(np.sum(s.B**2 / d[:, None]) - np.sum((s.B.T @ (y / d)) ** 2))
    return slope < 0


def _descended(samples: Sequence[Scores], start: tuple[float, float, float]) -> tuple[float, float, float, float]:
    """Least cost near a start, and where: cost, phi, tau^2, focus^2."""
    from scipy.optimize import minimize

    first = np.log(np.maximum(start, 1e-300))
    middle = first.copy()

    def values(t: Array) -> tuple[float, float, float]:
        a, b, c = (float(v) for v in np.exp(np.clip(t, middle - REACH, middle + REACH)))
        return max(a, 1.0), b, c

    done = minimize(
        lambda t: _cost(samples, *values(t)), first, method="Nelder-Mead",
        options={"xatol": 0.02, "fatol": PRECISION, "maxfev": 200},
    )  # fmt: skip
    at = values(done.x)
    return _cost(samples, *at), *at


def _floor_and_fields(weight: Array, square: Array) -> tuple[float, float]:
    """Phi and tau^2 of squares whose expectations are phi + tau^2 weight."""

    def cost(phi: Array, tau_square: Array) -> Array:
        w = phi[..., None] + tau_square[..., None] * weight
        return np.sum(np.log(w) + np.minimum(square / w, MOST), axis=-1)

    # the surface may have two valleys and the borders phi = 1, tau = 0 count: a grid that closes in on its least value,
    # and follows a valley that leaves it before it does
    top = np.log(max(float(square.max()), 2.0))
    scale = float(np.median(weight))
    least, most = np.array([0.0, np.log(1e-6)]), np.array([top, top + np.log(1e3)])
    low, high, steps = least, most, np.linspace(0, 1, GRID)
    fields = np.inf, 1.0, 0.0
    for _ in range(CLOSINGS):
        a, b = (low[k] + (high[k] - low[k]) * steps for k in (0, 1))
        phi = np.exp(a)[:, None] * np.ones(GRID)
        tau_square = np.exp(b) * np.ones((GRID, 1)) / scale
        found = cost(phi, tau_square)
        i, j = np.unravel_index(int(found.argmin()), found.shape)
        fields = float(found[i, j]), float(phi[i, j]), float(tau_square[i, j])
        middle, at = np.array([a[i], b[j]]), np.array([i, j])
        leaves = ((at == 0) & (middle > least)) | ((at == GRID - 1) & (middle < most))
        width = (high - low) / 2 if leaves.any() else (high - low) / (GRID - 1) * 2
        if width.max() < PRECISION:
            break
        low, high = np.maximum(middle - width, [0.0, -np.inf]), middle + width
    bare = _floor_alone(square)
    if float(cost(np.array(bare), np.array(0.0))) <= fields[0] + PRECISION:
        return bare, 0.0
    return fields[1:]


def _floor_alone(square: Array) -> float:
    """Phi >= 1 without fields: the mean of the squares that count in full."""
    phi = max(1.0, float(np.median(square)) / 0.455)
    for _ in range(100):
        full = square < MOST * phi
        new = max(1.0, float(square[full].sum()) / len(square))
        if abs(new - phi) < 1e-9 * phi:
            break
        phi = new
    return phi
