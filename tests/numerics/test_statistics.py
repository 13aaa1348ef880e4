"""Limits of tests, small angles, hulls and units against values known otherwise."""

import numpy as np
import pytest
from scipy.stats import chi2
from scipy.stats import t as student

from raybundle.numerics.length_units import precision_unit
from raybundle.numerics.maths import AngleRatio_numpy, AngleRatioSlope_numpy
from raybundle.numerics.planes import hull, plane_of_most
from raybundle.numerics.statistics import axis_tests, family_wise_tau, global_test


@pytest.mark.parametrize("redundancy", [1, 5, 200, 40_000])
def test_limits_of_the_global_test_are_quantiles(redundancy):
    low, value, high = global_test(3.5, redundancy, 0.05)
    assert (low, value, high) == pytest.approx(
        (chi2.ppf(0.025, redundancy), 3.5, chi2.ppf(0.975, redundancy)), rel=1e-9
    )
    assert np.isnan(global_test(1.0, 0)[::2]).all()


@pytest.mark.parametrize("redundancy", [2, 9, 300])
def test_tau_follows_from_student(redundancy):
    q = student.ppf(1 - 0.05 / 2 / 40, redundancy - 1)
    expected = np.sqrt(redundancy) * q / np.sqrt(redundancy - 1 + q**2)
    assert family_wise_tau(0.05, 40, redundancy) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("w", [0.5, 1.0, 3.0])
def test_small_angles_are_those_of_the_series(w):
    """atan(s) / r with s = r / w, and its derivative by r^2, to terms that no double sees."""
    for s in (1e-9, 1e-5, 3e-3, 9.9e-3):
        powers = [(-1) ** k * s ** (2 * k) / (2 * k + 1) for k in range(8)]
        slopes = [(-1) ** k * k * s ** (2 * k - 2) / (2 * k + 1) for k in range(1, 8)]
        assert AngleRatio_numpy((s * w) ** 2, w) == pytest.approx(sum(powers) / w, rel=1e-12)
        assert AngleRatioSlope_numpy((s * w) ** 2, w) == pytest.approx(sum(slopes) / w**3, rel=1e-11)


def test_a_hull_runs_round_its_corners():
    square = np.array([[0, 0], [1, 0], [0.5, 0.5], [1, 1], [0.5, 0], [0, 1], [0.2, 0.9], [0, 0.5]])
    assert hull(square).tolist() == [[0, 0], [1, 0], [1, 1], [0, 1]]


def test_points_of_unknown_precision_lie_in_a_plane_by_the_least_distance():
    rng = np.random.default_rng(2)
    points = rng.uniform(-1, 1, (200, 3)) * [1, 1, 0]
    points[:60, 2] = rng.uniform(0.2, 0.5, 60)
    found = plane_of_most(points, np.full((200, 3), np.nan), 0.01)
    assert found.inliers.sum() == 140


@pytest.mark.parametrize(
    ("sigma", "unit", "expected"),
    [
        (0.02, "m", (1000.0, "mm")),
        (1.5, "m", (1.0, "m")),
        (0.02, "mm", (1.0, "mm")),
        (float("nan"), "m", (1000.0, "mm")),
    ],
)
def test_precision_below_a_metre_is_read_in_millimetres(sigma, unit, expected):
    assert precision_unit(sigma, unit) == expected


def test_errors_of_correlated_coordinates_are_tested_by_their_weights():
    rng = np.random.default_rng(6)
    s = rng.uniform(0.5, 2, (20, 2))
    xy = rng.uniform(-0.99, 0.99, 20) * s.prod(axis=1)
    e = rng.normal(size=(20, 2))
    for (ex, ey), (sx, sy), c, found in zip(e, s, xy, axis_tests(e, np.column_stack([s**2, xy])), strict=True):
        P = np.linalg.inv([[sx**2, c], [c, sy**2]])
        assert found == pytest.approx(P @ [ex, ey] / np.sqrt(np.diag(P)), rel=1e-9)
    plain = np.column_stack([s**2, np.zeros(20)])
    assert axis_tests(e, plain) == pytest.approx(e / s, rel=1e-12)
