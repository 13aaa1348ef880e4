"""Arrays that carry derivatives: each function has those of differences, and a function without is refused."""

import numpy as np
import pytest

from raybundle.numerics.duals import Dual

X = np.array([[0.3, 0.7, -0.4], [0.8, -0.2, 0.5]])
R = np.linalg.qr(np.arange(9.0).reshape(3, 3) + np.eye(3))[0]
FUNCTIONS = {
    "arithmetic": lambda x: (2 - x) * x / (x + 3) - -x + (+x) ** 3 + x % 0.23,
    "power of two": lambda x: (x + 2) ** (x[:, :1] + 1.5),
    "roots and squares": lambda x: np.sqrt(np.square(x) + 1) + np.reciprocal(x + 4) + np.abs(x),
    "exponential": lambda x: np.exp(x) + np.log(x + 2),
    "angles": lambda x: np.sin(x) * np.cos(x) + np.tan(x) + np.arcsin(x) + np.arccos(x) + np.arctan(x),
    "two arguments": lambda x: np.arctan2(x[:, 0], x[:, 1]) + np.hypot(x[:, 1], x[:, 2]),
    "larger and smaller": lambda x: np.maximum(x, 0.1) + np.minimum(0.2, x),
    "sum": lambda x: np.sum(x * x, axis=-1),
    "norm": lambda x: np.linalg.norm(x, axis=1),
    "stack": lambda x: np.stack([x[:, 0], np.ones(2), x[:, 2] * x[:, 1]], axis=-1),
    "where": lambda x: np.where(x > 0, x * x, -x),
    "einsum": lambda x: np.einsum("ij,kj->ki", R, x) * np.einsum("ki,ki->k", x, x)[:, None],
    "einsum without an arrow": lambda x: np.einsum("ki,i", x, X[0] + 1),
    "where of numbers": lambda x: np.where([2, 0], x[:, 0], x[:, 1] * x[:, 1]),
    "cross": lambda x: np.cross(x, x[:, [1, 2, 0]] ** 2),
    "ellipsis": lambda x: x[..., 1] * x[..., 0],
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_derivatives_are_those_of_differences(name):
    f, step = FUNCTIONS[name], 1e-6
    found = f(Dual(X, {0: np.broadcast_to(np.eye(3), (2, 3, 3))}))
    assert np.allclose(found.value, f(X), rtol=1e-15)
    for j, axis in enumerate(np.eye(3)):
        by = (f(X + step * axis) - f(X - step * axis)) / (2 * step)
        assert np.allclose(found.by[0][..., j], by, atol=1e-8)


def test_derivatives_by_two_groups_stay_apart():
    a, b = (
        Dual(X, {0: np.broadcast_to(np.eye(3), (2, 3, 3))}),
        Dual(X[::-1], {1: np.broadcast_to(np.eye(3), (2, 3, 3))}),
    )
    found = (a * b).sum(axis=-1)
    assert np.array_equal(found.by[0], X[::-1])
    assert np.array_equal(found.by[1], X)


def test_comparisons_are_plain():
    assert np.array_equal(Dual(X, {}) > 0, X > 0)


def test_functions_without_a_derivative_are_refused_by_name():
    for f in (np.sinh, np.argsort):
        with pytest.raises(TypeError, match=f.__name__):
            f(Dual(X, {}))


def test_axes_that_there_are_not_are_refused():
    for f in (np.linalg.norm, lambda x: np.sum(x, axis=2), lambda x: np.einsum("ki,Z", x, X[0])):
        with pytest.raises(TypeError):
            f(Dual(X, {}))
