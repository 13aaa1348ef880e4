"""Velocities and accelerations by the joint covariance of all dates: true sigmas, true rates of the verdicts."""

import numpy as np
import pytest
from scipy.stats import chi2, kstest

from raybundle.metrology.trends import CONSTANT, FASTER, IRREGULAR, SLOWER, Series, trend

DAYS = np.array([31.0, 59, 90, 151])
V, A = np.array([0.4, -0.1, 0.2]) / 1000, np.array([8.0, -2, 4]) / 1e6
INF = float("inf")


def covariance(seed, k=4):
    """Of differences against a first date, whose errors all of them share."""
    rng = np.random.default_rng(seed)
    C = np.zeros((3 * k, 3 * k))
    for date in range(k + 1):
        L = rng.normal(size=(3, 3)) * 1e-3
        at = np.zeros((3 * k, 3))
        for j in range(k) if date == 0 else [date - 1]:
            at[3 * j : 3 * j + 3] = -L if date == 0 else L
        C += at @ at.T
    return C + 1e-9 * np.eye(3 * k)


def drawn(truth, C, rng, days=DAYS):
    d = truth.ravel() + np.linalg.cholesky(C) @ rng.normal(size=len(C))
    return Series(
        name="P", area=False, first=0, dates=tuple(range(1, len(days) + 1)), days=days, displacement=d.reshape(-1, 3),
        covariance=C,
    )  # fmt: skip


def moving(v=V, a=0 * V, days=DAYS):
    return days[:, None] * v + days[:, None] ** 2 / 2 * a


def square(error, C):
    return float(error @ np.linalg.solve(C, error))


def test_velocities_and_accelerations_have_true_sigmas():
    C, rng, runs = covariance(1), np.random.default_rng(2), 300
    found = [trend(drawn(moving(), C, rng), INF) for _ in range(runs)]
    curved = [trend(drawn(moving(a=A), C, rng), INF) for _ in range(runs)]
    sums = [
        sum(square(t.velocity - V, t.velocity_covariance) for t in found),
        sum(square(t.acceleration - A, t.acceleration_covariance) for t in curved),
    ]
    low, high = chi2.ppf([0.0005, 0.9995], 3 * runs)
    assert low < min(sums)
    assert max(sums) < high
    assert kstest([t.p_constant for t in found], "uniform").pvalue > 1e-3
    assert kstest([t.p_accelerated for t in curved], "uniform").pvalue > 1e-3


@pytest.mark.parametrize(
    ("truth", "verdict"),
    [
        (moving(V * 30), CONSTANT),
        (moving(V * 30, A * 30), FASTER),
        (moving(V * 100, -A * 30), SLOWER),
        (np.array([[0.0, 0, 0], [0.1, 0, 0], [0.1, 0, 0], [0.1, 0, 0]]), IRREGULAR),
    ],
)
def test_the_motion_is_named(truth, verdict):
    rng = np.random.default_rng(5)
    found = [trend(drawn(truth, covariance(k), rng), INF).verdict(0.01) for k in range(40)]
    assert found.count(verdict) >= 37


def test_three_dates_leave_no_test_of_an_acceleration():
    t = trend(drawn(moving(V * 30, A * 30, DAYS[:2]), covariance(6, 2), np.random.default_rng(7), DAYS[:2]), 50.0)
    assert np.isnan(t.p_accelerated)
    assert t.p_none < 1e-6
    assert t.verdict(0.01) in {CONSTANT, FASTER}
