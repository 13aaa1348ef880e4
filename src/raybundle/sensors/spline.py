"""A lens without a formula: stereographic projection, radial terms, and B-spline surfaces for all that they leave."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.maths import Scalar
from raybundle.sensors.model import Parameter, SensorModel

COLUMNS, ROWS = 12, 9
"""Knots of each surface: nine by six cells and a cubic spline's three beyond."""
FIRST = (
    Parameter("c", "mm", "parameter.camera_constant_stereographic", 10.0, kind="scale"),
    Parameter("x0", "mm", "parameter.principal_point", typical=0.03, kind="principal point"),
    Parameter("y0", "mm", "parameter.principal_point", typical=-0.02, kind="principal point"),
    Parameter("K1", "mm^-2", "parameter.radial", typical=-3e-5, kind="radial"),
    Parameter("K2", "mm^-4", "parameter.radial", typical=1e-8, kind="radial"),
    Parameter("K3", "mm^-6", "parameter.radial", typical=1e-12, kind="radial"),
    Parameter("w", "mm", "parameter.knots_width", 24.0),
    Parameter("h", "mm", "parameter.knots_height", 16.0),
)


def _knots() -> tuple[Parameter, ...]:
    return tuple(
        Parameter(
            f"s{axis}{i + 1:02d}{j + 1:02d}",
            "mm",
            meaning,
            typical=0.1 + 0.02 * float(np.cos(1.3 * i + 0.7 * j + phase)),
            values=(("first", i + 1), ("second", j + 1)),
        )
        for axis, meaning, phase in (("x", "parameter.knot_x", 0.2), ("y", "parameter.knot_y", 1.1))
        for i in range(COLUMNS)
        for j in range(ROWS)
    )


def _stated(names: tuple[str, ...]) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Give a function the parameters x, y, X, Y, Z and these names."""

    def state(function: Callable[..., Any]) -> Callable[..., Any]:
        kind = inspect.Parameter.POSITIONAL_ONLY
        parameters = [inspect.Parameter(n, kind) for n in ("x", "y", "X", "Y", "Z", *names)]
        vars(function)["__signature__"] = inspect.Signature(parameters)
        return function

    return state


def _basis(t: Array, count: int) -> tuple[Index, Array, Array]:
    """First knot (n,), values (4, n) of the uniform cubic B-splines at t in -1/2 .. 1/2, and their slopes by t.

    Constant from half a cell beyond the field on.
    """
    cells = count - 3
    s = (t + 0.5) * cells
    inside = (s > -0.5) & (s < cells + 0.5)
    s = np.clip(s, -0.5, cells + 0.5)
    first = np.clip(np.floor(s), 0, cells - 1).astype(np.int32)
    f = s - first
    g = 1 - f
    value = np.stack([g**3, 3 * f**3 - 6 * f**2 + 4, -3 * f**3 + 3 * f**2 + 3 * f + 1, f**3]) / 6
    slope = np.stack([-(g**2), 3 * f**2 - 4 * f, -3 * f**2 + 2 * f + 1, f**2]) / 2
    return first, value, slope * (cells * inside)


def _depth(X: Array, Y: Array, Z: Array) -> tuple[Array, Array]:
    """Distances |P| and |P| - Z, NaN straight behind, where the stereographic projection has no image."""
    distance = np.sqrt(X * X + Y * Y + Z * Z)
    seen = distance - Z > 1e-12 * distance
    return np.where(seen, distance, np.nan), np.where(seen, distance - Z, np.nan)


class Spline(SensorModel):
    """Stereographic projection, three radial terms and two cubic B-spline surfaces of shifts over the format.

    Corrections are taken at the measured point, as in Brown's model: u + u (K1 r^2 + K2 r^4 + K3 r^6) + sx(x, y) =
    2 c X / (|P| - Z), likewise in y.  The surfaces have 12 x 9 knots over w x h, the format, and follow whatever a lens
    does that has no formula (splined corrections: Schöps et al. 2020; stereographic base for fields beyond 120
    degrees).  They contain shifts of the principal point, a change of c and nearly a rotation of the camera, and
    knots in corners without observations say nothing.  Their parameters therefore take part as observed ones: each is
    0 with the standard deviation that `Camera.sigma` states, which is a statement about the lens ("within 20 px of
    the radial terms").  What the sigmas of single knots do not show: how sure an image point is; ask the map of
    projection uncertainty.
    """

    name = "spline"
    parameters = (*FIRST, *_knots())
    explicit = False
    local_width = len(FIRST) + 32

    @staticmethod
    @_stated(tuple(p.symbol for p in (*FIRST, *_knots())))
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, x0: Scalar, y0: Scalar, K1: Scalar, K2: Scalar, K3: Scalar, w: Scalar, h: Scalar,
        *knots: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Corrected image point minus stereographic projection."""
        u, v = x - x0, y - y0
        r2 = u * u + v * v
        radial = 1 + r2 * (K1 + r2 * (K2 + r2 * K3))
        i, bx, _ = _basis(x / w, COLUMNS)
        j, by, _ = _basis(y / h, ROWS)
        n = np.arange(np.size(x))
        surface = np.array([np.broadcast_to(k, np.shape(x)) for k in knots]).reshape(2, COLUMNS, ROWS, -1)
        sx, sy = (sum(bx[a] * by[b] * s[i + a, j + b, n] for a in range(4) for b in range(4)) for s in surface)
        _, depth = _depth(X, Y, Z)
        return u * radial + sx - 2 * c * X / depth, v * radial + sy - 2 * c * Y / depth

    @cached_property
    def condition_and_jacobian(self) -> Callable[..., tuple[Array, Array]]:
        """G (2, n) and its Jacobian (2, 5 + k, n): `local` with zeros for the knots that a point does not touch."""

        def evaluate(x: Array, y: Array, X: Array, Y: Array, Z: Array, *values: Array) -> tuple[Array, Array]:
            shape = np.broadcast_shapes(*(np.shape(a) for a in (x, y, X, Y, Z, *values[:1])))
            flat = [np.broadcast_to(a, shape).ravel() for a in (x, y, X, Y, Z)]
            if not any(np.ndim(v) for v in values):
                whole = np.array(values, float)
            elif all(np.shape(v) == shape for v in values):
                whole = np.array(values, float).reshape(len(values), -1)
            else:
                whole = np.array([np.broadcast_to(v, shape).ravel() for v in values])
            g, near, touched = self.local(np.array(flat[:2]), np.array(flat[2:]), whole)
            J = np.zeros((2, 5 + len(values), flat[0].size))
            J[:, :5] = near[:, :5]
            J[:, 5 + touched.T, np.arange(flat[0].size)] = near[:, 5:]
            return g.reshape(2, *shape), J.reshape(2, -1, *shape)

        return evaluate

    def local(self, image: Array, points: Array, values: Array) -> tuple[Array, Array, Index]:
        """G (2, n), its Jacobian (2, 5 + 40, n) and the positions (n, 40) of the parameters that it is taken by."""
        (x, y), (X, Y, Z) = image, points
        n, k = x.size, len(FIRST)
        V = values if values.ndim == 2 else values[:, None]
        c, x0, y0, K1, K2, K3, w, h = V[:k]
        u, v = x - x0, y - y0
        r2 = u * u + v * v
        radial = 1 + r2 * (K1 + r2 * (K2 + r2 * K3))
        bend = 2 * (K1 + r2 * (2 * K2 + r2 * 3 * K3))
        (i, bx, dx), (j, by, dy) = _basis(x / w, COLUMNS), _basis(y / h, ROWS)
        a, b = (e.ravel()[:, None] for e in np.meshgrid(np.arange(4), np.arange(4), indexing="ij"))
        knot = (i + a) * ROWS + j + b
        weight = (bx[:, None] * by[None]).reshape(16, n)
        by_x, by_y = (dx[:, None] * by[None]).reshape(16, n) / w, (bx[:, None] * dy[None]).reshape(16, n) / h
        at = np.arange(n) if V.shape[1] > 1 else 0
        shift = [V[k + axis * COLUMNS * ROWS + knot, at] for axis in range(2)]
        distance, depth = _depth(X, Y, Z)
        ideal = 2 * np.array([X, Y]) / depth
        g, J = np.empty((2, n)), np.zeros((2, 5 + self.local_width, n))
        for axis, (e, t) in enumerate(zip((u, v), shift, strict=True)):
            sx, sy = np.sum(by_x * t, axis=0), np.sum(by_y * t, axis=0)
            g[axis] = e * radial + np.sum(weight * t, axis=0) - c * ideal[axis]
            J[axis, 0], J[axis, 1] = e * u * bend + sx, e * v * bend + sy
            J[axis, axis] += radial
            by_depth = c * ideal[axis] / depth
            J[axis, 2:5] = by_depth * np.array([X / distance, Y / distance, Z / distance - 1])
            J[axis, 2 + axis] -= 2 * c / depth
            J[axis, 5] = -ideal[axis]
            J[axis, 6], J[axis, 7] = -e * u * bend, -e * v * bend
            J[axis, 6 + axis] -= radial
            J[axis, 8], J[axis, 9], J[axis, 10] = e * r2, e * r2 * r2, e * r2**3
            J[axis, 11], J[axis, 12] = -sx * x / w, -sy * y / h
            J[axis, 5 + k + 16 * axis : 21 + k + 16 * axis] = weight
        touched = np.empty((n, self.local_width), np.int32)
        touched[:, :k] = np.arange(k)
        touched[:, k : k + 16] = (k + knot).T
        touched[:, k + 16 :] = (k + COLUMNS * ROWS + knot).T
        return g, J, touched

    def start(self, points: Array, values: Array) -> Array:
        """Stereographic projection without corrections."""
        return 2 * values[0] * points[:2] / (np.linalg.norm(points, axis=0) - points[2])

    def in_front(self, points: Array, image: Array | None = None, values: Array | None = None) -> Mask:
        """Up to 120 degrees off the axis: no lens shows more."""
        del image, values
        return points[2] < 0.5 * np.linalg.norm(points, axis=0)
