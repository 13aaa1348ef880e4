"""Rotations, statistics and transforms."""

import numpy as np
import pytest
from scipy.stats import chi2, kstest, norm

from raybundle.errors import InputError
from raybundle.numerics.maths import angle_ratio
from raybundle.numerics.rotation import (
    angle_derivatives,
    angles_from_rotation,
    cross_matrix,
    nearest_rotation,
    rotation_from_angles,
    rotation_from_vector,
    vector_from_rotation,
)
from raybundle.numerics.rows import distinct, rows_of_each
from raybundle.numerics.statistics import (
    CRITICAL_W,
    DELTA0,
    family_wise_normal,
    family_wise_tau,
    global_test,
    mahalanobis2,
    noncentrality,
)
from raybundle.numerics.transform import robust_similarity, similarity

RNG = np.random.default_rng(4)


def test_angles_and_matrices_are_inverse():
    angles = RNG.uniform([-np.pi, -1.5, -np.pi], [np.pi, 1.5, np.pi], (500, 3))
    np.testing.assert_allclose(angles_from_rotation(rotation_from_angles(angles)), angles, atol=1e-12)


def test_the_matrix_is_the_product_of_the_three_turns():
    o, p, k = 0.3, -0.4, 1.2
    R1 = np.array([[1, 0, 0], [0, np.cos(o), np.sin(o)], [0, -np.sin(o), np.cos(o)]])
    R2 = np.array([[np.cos(p), 0, -np.sin(p)], [0, 1, 0], [np.sin(p), 0, np.cos(p)]])
    R3 = np.array([[np.cos(k), np.sin(k), 0], [-np.sin(k), np.cos(k), 0], [0, 0, 1]])
    np.testing.assert_allclose(rotation_from_angles(np.array([o, p, k])), R3 @ R2 @ R1, atol=1e-15)


def test_angle_derivatives():
    R = rotation_from_angles(RNG.uniform(-1.3, 1.3, (50, 3)))
    D = angle_derivatives(R)
    for k in range(3):
        d = np.zeros(3)
        d[k] = 1e-6
        up, down = (angles_from_rotation(rotation_from_vector(s * d) @ R) for s in (1, -1))
        np.testing.assert_allclose(D[:, :, k], (up - down) / 2e-6, atol=1e-7)


def test_rotation_vectors():
    v = RNG.uniform(-1.5, 1.5, (200, 3))
    v[:5] *= 1e-9
    np.testing.assert_allclose(vector_from_rotation(rotation_from_vector(v)), v, atol=1e-10)
    np.testing.assert_allclose(cross_matrix(v[9]) @ v[8], np.cross(v[9], v[8]))
    noisy = rotation_from_vector(v) + RNG.normal(0, 1e-3, (200, 3, 3))
    R = nearest_rotation(noisy)
    np.testing.assert_allclose(R @ np.swapaxes(R, 1, 2), np.tile(np.eye(3), (200, 1, 1)), atol=1e-12)


def test_angle_ratio_is_smooth_on_the_axis():
    r2 = np.array([0, 1e-14, 1e-9, 1e-4, 1.0, 4.0])
    expected = [1 / 2, *(np.arctan2(np.sqrt(r2[1:]), 2.0) / np.sqrt(r2[1:]))]
    np.testing.assert_allclose(angle_ratio(r2, 2.0), expected, rtol=1e-13)
    assert angle_ratio(1.0, -1.0) == pytest.approx(np.arctan2(1.0, -1.0))


@pytest.mark.parametrize(
    ("alpha", "power", "k", "delta0"),
    [
        (0.001, 0.80, 3.2905, 4.1321),
        (0.001, 0.90, 3.2905, 4.5721),
        (0.01, 0.80, 2.5758, 3.4175),
        (0.05, 0.80, 1.9600, 2.8016),
    ],
)
def test_baardas_constants(alpha, power, k, delta0):
    assert noncentrality(alpha, power) == pytest.approx((k, delta0), abs=5e-5)


def test_the_constants_are_those_of_the_formula():
    assert noncentrality(0.001, 0.80) == pytest.approx((CRITICAL_W, DELTA0), abs=1e-12)
    assert pytest.approx(17.0746, abs=1e-3) == DELTA0**2


def test_critical_values():
    assert family_wise_normal(0.05, 19945) == pytest.approx(norm.isf(0.05 / 2 / 19945))
    assert family_wise_tau(0.05, 1, 10_000_000) == pytest.approx(1.96, abs=1e-3)
    assert family_wise_tau(0.05, 100, 10) < np.sqrt(10)
    assert np.isnan(family_wise_tau(0.05, 100, 1))
    low, value, high = global_test(100.0, 100)
    assert low < value < high
    assert np.isnan(global_test(1.0, 0)[0])


def test_mahalanobis():
    C = np.array([[4.0, 1.0], [1.0, 2.0]])
    e = RNG.multivariate_normal([0, 0], C, 3000)
    assert kstest(mahalanobis2(e, C), chi2(2).cdf).pvalue > 1e-3


def test_similarity_recovers_itself_and_states_its_precision():
    source = RNG.uniform(-5, 5, (12, 3))
    R, s, t = rotation_from_vector(np.array([0.3, -1.0, 0.7])), 2.5, np.array([10.0, -4.0, 3.0])
    exact = similarity(source, s * source @ R.T + t)
    assert exact.scale == pytest.approx(s)
    np.testing.assert_allclose(exact.rotation, R, atol=1e-12)
    errors, sigma = [], 0.01
    centre = source.mean(axis=0)
    for _ in range(600):
        found = similarity(source, s * source @ R.T + t + RNG.normal(0, sigma, source.shape))
        turn = vector_from_rotation(found.rotation @ R.T)
        e = np.concatenate([found.points(centre) - (s * R @ centre + t), turn, [found.scale - s]])
        C = found.covariance * (sigma / found.sigma0) ** 2
        errors.append(mahalanobis2(e[None], C)[0])
    assert kstest(errors, chi2(7).cdf).pvalue > 1e-3
    assert kstest(np.array(errors) * 1.2, chi2(7).cdf).pvalue < 1e-3


def test_similarity_refuses_what_it_cannot_do():
    with pytest.raises(InputError, match=r"similarity\.too_few_points"):
        similarity(np.eye(3)[:2], np.eye(3)[:2])
    with pytest.raises(InputError, match=r"similarity\.points_in_line"):
        similarity(np.arange(4)[:, None] * np.ones(3), np.arange(4)[:, None] * np.ones(3))


def test_robust_similarity_leaves_outliers_out():
    source = RNG.uniform(-5, 5, (15, 3))
    target = source.copy()
    target[:4] += 3
    found, inliers = robust_similarity(source, target, 0.1)
    assert not inliers[:4].any()
    assert inliers[4:].all()
    np.testing.assert_allclose(found.points(source[4:]), target[4:], atol=1e-9)


def test_rows_of_each_are_those_of_a_search():
    owner = RNG.integers(-1, 6, 200)
    owner[owner == 3] = 4
    rows = rows_of_each(owner, 8)
    assert len(rows) == 8
    for k, mine in enumerate(rows):
        np.testing.assert_array_equal(mine, np.flatnonzero(owner == k))
    assert [len(r) for r in rows_of_each(owner[:0], 2)] == [0, 0]


def test_square_roots_are_printed_for_both_kernels():
    sympy = pytest.importorskip("sympy")
    from raybundle.numerics import derive

    x = sympy.Symbol("x")
    assert derive._Cxx().doprint(sympy.sqrt(x)) == "std::sqrt(x)"
    assert "pow(x, 0.5)" in derive._Cxx().doprint(x**0.5) or "sqrt(x)" in derive._Cxx().doprint(x**0.5)
    assert "sqrt(x)" in derive._NumPy().doprint(sympy.sqrt(x))


@pytest.mark.parametrize("count", [0, 1, 500])
def test_distinct_numbers_are_those_of_a_set(count):
    numbers = np.random.default_rng(2).integers(-50, 50, count)
    found = distinct(numbers)
    assert found.tolist() == sorted(set(numbers.tolist()))
    assert found.dtype == numbers.dtype
