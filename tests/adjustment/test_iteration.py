"""The iteration of an adjustment on curves that scipy fits as well, and its rule for the damping."""

import numpy as np
import pytest
from scipy.optimize import least_squares

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.solve import FLOOR, _gain, _less, _share, solve

T = np.linspace(0, 3, 40)


class Curve:
    """y = a exp(-b t) + c with errors of a known size, as normal equations."""

    unknowns = 3

    def __init__(self, sigma=0.02, seed=1):
        self.observations = len(T)
        self.sigma = sigma
        rng = np.random.default_rng(seed)
        self.y = 2 * np.exp(-1.3 * T) + 0.5 + rng.normal(0, sigma, len(T))

    def residual(self, x):
        return (x[0] * np.exp(-x[1] * T) + x[2] - self.y) / self.sigma

    def weight(self, r, huber):
        return np.minimum(1.0, huber / np.maximum(np.abs(r), 1e-12)) if huber else np.ones_like(r)

    def reduce(self, state, *, damping=0.0, huber=0.0):
        del damping
        e = np.exp(-state[1] * T)
        J = np.stack([e, -state[0] * T * e, np.ones_like(T)], axis=1) / self.sigma
        r = self.residual(state)
        w = self.weight(r, huber)
        self.N, self.g = (J.T * w) @ J, (J.T * w) @ r
        self.J, self.r, self.w = J, r, w
        return *self.cost(state, huber=huber), []

    def trial(self, state, *, damping=0.0, huber=0.0, passing=False):
        del huber, passing
        step = -np.linalg.solve(self.N + damping * np.diag(np.diag(self.N)), self.g)
        linear = 0.5 * float((self.w * (self.r + self.J @ step) ** 2).sum())
        return state + step, linear

    def cost(self, state, *, huber=0.0):
        r = np.abs(self.residual(state))
        square = np.where(r > huber, 2 * huber * (r - huber / 2), r**2) if huber else r**2
        return 0.5 * float(square.sum()), 0

    def excess(self, state, huber):
        if not huber:
            return 0.0
        r = np.abs(self.residual(state))
        return self.cost(state, huber=huber)[0] - 0.5 * float((self.weight(r, huber) * r**2).sum())

    def before(self, state):
        return state

    def beyond(self, state):
        del state
        return np.zeros(0, np.int64)


@pytest.mark.parametrize(("start", "most"), [((1.9, 1.2, 0.45), 5), ((0.5, 0.2, 0.0), 9), ((5.0, 4.0, -2.0), 12)])
def test_it_ends_where_others_do_and_soon(start, most):
    curve = Curve()
    found = solve(curve, np.array(start), AdjustmentOptions(tolerance=1e-8))
    expected = least_squares(curve.residual, start, xtol=1e-14, ftol=1e-14, gtol=1e-14)
    np.testing.assert_allclose(found.state, expected.x, atol=1e-8)
    assert found.cost == pytest.approx(expected.cost, rel=1e-12)
    assert found.converged
    assert found.iterations <= most
    assert found.step < 1e-6


def test_where_it_did_not_end_it_has_not_converged():
    found = solve(Curve(), np.array([5.0, 4.0, -2.0]), AdjustmentOptions(tolerance=1e-8, max_iterations=2))
    assert not found.converged
    assert found.iterations == 2


def test_blunders_weigh_little_in_the_robust_one():
    curve = Curve()
    curve.y[::10] += 1.0
    found = solve(curve, np.array([1.9, 1.2, 0.45]), AdjustmentOptions(tolerance=1e-8), huber=2.0)
    expected = least_squares(curve.residual, found.state, loss=lambda z: np.stack([
        np.where(z <= 4, z, 4 * np.sqrt(z) - 4), np.where(z <= 4, 1, 2 / np.sqrt(z)), np.where(z <= 4, 0, -1 / z**1.5),
    ]), xtol=1e-14, ftol=1e-14, gtol=1e-14)  # fmt: skip
    np.testing.assert_allclose(found.state, expected.x, rtol=1e-5)
    plain = solve(curve, np.array([1.9, 1.2, 0.45]), AdjustmentOptions(tolerance=1e-8))
    assert np.abs(found.state - [2, 1.3, 0.5]).max() < 0.5 * np.abs(plain.state - [2, 1.3, 0.5]).max()


def test_exact_observations_end_as_well():
    curve = Curve(sigma=1e-9)
    curve.y = 2 * np.exp(-1.3 * T) + 0.5
    found = solve(curve, np.array([2.0, 1.3, 0.5]), AdjustmentOptions())
    np.testing.assert_allclose(found.state, [2, 1.3, 0.5], atol=1e-12)
    assert found.converged


@pytest.mark.parametrize("gain", [0.1, 0.3, 0.5, 0.8, 0.94, 1.06, 1.7])
def test_the_damping_follows_the_gain(gain):
    """max(1/3, 1 - (2 rho - 1)^3) (Nielsen 1999); far less where the step brought just what it promised."""
    assert _less(1e-3, gain, floor=False) == pytest.approx(1e-3 * max(1 / 3, 1 - (2 * min(gain, 1) - 1) ** 3))
    assert _less(1e-3, 1.0, floor=False) == pytest.approx(1e-3 / 30)
    assert _less(1e-3, gain, floor=True) == _less(1e-12, gain, floor=False) == FLOOR


def test_the_gain_is_what_a_step_brought_over_what_it_promised():
    assert _gain(100.0, 60.0, 50.0) == pytest.approx(0.8)
    assert _gain(100.0, 130.0, 60.0) == pytest.approx(-0.5)
    # below the rounding of the costs nothing can be promised
    assert _gain(100.0, 100.0 * (1 + 5e-12), 1e-10) == 1.0
    assert _gain(100.0, 100.0 * (1 + 5e-11), 1e-10) == -1.0


def test_the_share_done_is_by_orders_of_magnitude():
    assert _share(1e2, 1e2, 1e-4) == 0
    assert _share(1e2, 1e-1, 1e-4) == pytest.approx(0.5)
    assert _share(1e2, 1e-5, 1e-4) == 1
    assert _share(1e-9, 1e-3, 1e-4) == 0
