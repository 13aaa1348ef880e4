"""The minimum of small problems: found, from afar too, and what is not determined stays."""

from __future__ import annotations

import numpy as np
import pytest

from raybundle.numerics.arrays import Array
from raybundle.numerics.least_squares import added, minimum
from raybundle.numerics.rotation import rotation_from_vector, vector_from_rotation


def decay(x: Array) -> tuple[Array, Array]:
    """A sum of two exponentials with errors: residuals and derivatives."""
    t = np.linspace(0, 4, 60)
    truth = 2.0 * np.exp(-1.3 * t) + 0.5 * np.exp(-0.2 * t) + 1e-3 * np.sin(37 * t)
    a, b = np.exp(-x[1] * t), np.exp(-x[3] * t)
    return x[0] * a + x[2] * b - truth, np.stack([a, -x[0] * t * a, b, -x[2] * t * b], axis=1)


@pytest.mark.parametrize("damping", [0.0, 1e-3])
def test_curve_as_scipy_finds_it(damping: float) -> None:
    """Equal to SciPy's minimum, and what is left to gain is the rounding of the sum of squares on any processor."""
    from scipy.optimize import least_squares

    start = np.array([1.0, 2.0, 1.0, 0.1])
    peer = least_squares(lambda x: decay(x)[0], start, jac=lambda x: decay(x)[1], xtol=1e-15, ftol=1e-15, gtol=1e-15)
    found = minimum(decay, start, added, damping=damping)
    assert found.settled
    np.testing.assert_allclose(found.values, peer.x, rtol=1e-9)
    J, gradient = found.jacobian, found.jacobian.T @ found.residuals
    assert gradient @ np.linalg.solve(J.T @ J, gradient) < 8 * np.finfo(float).eps * found.square_sum
    assert found.square_sum == pytest.approx(2 * peer.cost, rel=1e-12)


def test_a_step_that_goes_too_far_is_shortened() -> None:
    """Atan from 10: Newton's own steps run away."""
    found = minimum(lambda x: (np.arctan(x), np.diag(1 / (1 + x**2))), np.array([10.0]), added)
    assert found.settled
    assert abs(found.values[0]) < 1e-12


def test_a_turn_is_moved_by_turns() -> None:
    """Values of any kind: a rotation onto turned directions."""
    rng = np.random.default_rng(5)
    d, truth = rng.normal(size=(9, 3)), rotation_from_vector(np.array([0.4, -1.1, 0.7]))

    def function(R: Array) -> tuple[Array, Array]:
        x = d @ R.T
        J = np.stack([np.cross(e, x) for e in np.eye(3)], axis=2)
        return (x - d @ truth.T).ravel(), J.reshape(-1, 3)

    found = minimum(function, np.eye(3), lambda R, step: rotation_from_vector(step) @ R)
    assert found.settled
    assert np.abs(vector_from_rotation(found.values @ truth.T)).max() < 1e-12


def test_what_is_not_felt_stays() -> None:
    """Only the sum of two unknowns is observed: their difference stays as it was, exact data end at rounding."""
    found = minimum(lambda x: (np.array([x[0] + x[1] - 3.0] * 2), np.ones((2, 2))), np.array([5.0, 1.0]), added)
    np.testing.assert_allclose(found.values, [3.5, -0.5], atol=1e-12)
    assert found.settled


def test_values_that_cannot_be_are_not_taken() -> None:
    """A logarithm of a negative number is no residual."""
    found = minimum(lambda x: (np.log(x), np.diag(1 / x)), np.array([30.0]), added)
    assert found.settled
    assert found.values[0] == pytest.approx(1.0, abs=1e-12)


def test_steps_that_run_out_are_said() -> None:
    """One step does not find it."""
    assert not minimum(decay, np.array([1.0, 2.0, 1.0, 0.1]), added, steps=1).settled
