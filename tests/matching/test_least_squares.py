"""Least-squares matching: right, as precise as it says, and the kernel like its twin."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2, kstest

from raybundle.matching.least_squares import (
    Outcome,
    WindowOptions,
    match_windows,
    match_windows_twin,
    with_noisy_gradients,
)
from raybundle.matching.refine import smoothed
from raybundle.numerics import native
from raybundle.numerics.statistics import mahalanobis2
from tests.matching.scenes import Texture, noisy, quantised

AFFINE = np.array([[1.06, 0.09], [-0.05, 0.97]])
MOVE = np.array([3.37, -2.61])
OPTIONS = WindowOptions(step=1e-4, iterations=40)
needs_kernel = pytest.mark.skipif(not native.available(), reason="the kernels are not built")


def target_from_reference(xy):
    return xy @ AFFINE.T + MOVE


def reference_from_target(xy):
    return (xy - MOVE) @ np.linalg.inv(AFFINE).T


def grid(width, height, step=18, margin=20):
    x, y = np.meshgrid(np.arange(margin, width - margin, step) + 0.5, np.arange(margin, height - margin, step) + 0.5)
    return np.stack([x.ravel(), y.ravel()], axis=1)


def identity(n):
    return np.tile(np.eye(2), (n, 1, 1))


@pytest.fixture(scope="module")
def affine_pair():
    """Two pictures of one texture, the second under an affine map, darker and with less contrast."""
    texture = Texture(5)
    reference = texture.image(420, 380)
    target = texture.image(420, 380, reference_from_target, level=21000.0, contrast=4200.0)
    xy = grid(420, 380, step=23, margin=60)
    return reference, target, xy


def start(xy, seed=1, size=0.6):
    return target_from_reference(xy) + np.random.default_rng(seed).uniform(-size, size, xy.shape)


def test_points_are_found_where_they_are(affine_pair):
    reference, target, xy = affine_pair
    m = match_windows(reference, target, xy, start(xy), identity(len(xy)), OPTIONS)
    good = m.outcome == Outcome.MATCHED
    assert good.mean() > 0.97
    error = (m.xy_px - target_from_reference(xy))[good]
    assert np.abs(error.mean(axis=0)).max() < 0.003
    assert np.sqrt((error**2).mean()) < 0.01
    assert np.abs(m.affine[good] - AFFINE).max(axis=(1, 2)).mean() < 0.01
    assert m.correlation[good].min() > 0.995


def test_brightness_contrast_and_a_slope_of_the_light_do_not_move_points(affine_pair):
    reference, target, xy = affine_pair
    x = np.arange(target.shape[1]) / target.shape[1]
    sloping = quantised(9000 + 0.8 * target * (1.0 - 0.35 * x))
    a, b = (match_windows(reference, t, xy, start(xy), identity(len(xy)), OPTIONS) for t in (target, sloping))
    good = (a.outcome == Outcome.MATCHED) & (b.outcome == Outcome.MATCHED)
    assert good.mean() > 0.95
    assert np.sqrt(((a.xy_px - b.xy_px)[good] ** 2).mean()) < 0.003


def test_the_result_does_not_depend_on_the_start(affine_pair):
    reference, target, xy = affine_pair
    a, b = (match_windows(reference, target, xy, start(xy, k), identity(len(xy)), OPTIONS) for k in (1, 2))
    good = (a.outcome == Outcome.MATCHED) & (b.outcome == Outcome.MATCHED)
    assert np.abs(a.xy_px - b.xy_px)[good].max() < 0.005


NOISE = 300.0
MANY = WindowOptions(sigma=1e3, step=1e-4, iterations=40, loose=1e3)
"""Equal weights, affine map not observed: the model to which white noise belongs."""


@pytest.fixture(scope="module")
def repeated():
    """Many windows that do not overlap, the target with white noise; errors and stated covariances."""
    texture = Texture(6, shortest=8)
    reference = texture.image(900, 900)
    xy = grid(900, 900)
    begin = xy + np.random.default_rng(3).uniform(-0.2, 0.2, xy.shape)

    def run(options):
        m = match_windows(reference, noisy(reference, NOISE, 4), xy, begin, identity(len(xy)), options)
        assert (m.outcome == Outcome.MATCHED).mean() > 0.99
        good = m.outcome == Outcome.MATCHED
        C = np.stack([m.cov_px2[:, [0, 2]], m.cov_px2[:, [2, 1]]], axis=1)
        return (m.xy_px - xy)[good], C[good]

    return run


def test_the_stated_covariance_is_true(repeated):
    error, C = repeated(MANY)
    d2 = mahalanobis2(error, C)
    assert kstest(d2, chi2(2).cdf).pvalue > 1e-3
    assert kstest(d2 * 1.1**2, chi2(2).cdf).pvalue < 1e-3
    assert kstest(d2 / 1.1**2, chi2(2).cdf).pvalue < 1e-3


def test_with_the_gaussian_weight_the_stated_covariance_promises_too_little_not_too_much(repeated):
    error, C = repeated(replace(MANY, sigma=4.8))
    factor = mahalanobis2(error, C).mean() / 2
    assert 0.3 < factor < 1.0


def test_where_both_windows_are_noisy_the_noise_of_gradients_is_no_information():
    texture = Texture(6, shortest=8)
    picture = texture.image(900, 900)
    xy = grid(900, 900) + np.random.default_rng(2).uniform(-0.5, 0.5, (len(grid(900, 900)), 2))
    factors = []
    for noise in (300.0, 900.0, 1500.0):
        a, b = (smoothed(noisy(picture, noise, k)) for k in (1, 2))
        m = match_windows(a, b, xy, xy, identity(len(xy)), OPTIONS)
        good = m.outcome == Outcome.MATCHED
        error = (m.xy_px - xy)[good]
        true = with_noisy_gradients(m, xy, OPTIONS)
        np.testing.assert_array_equal(true.cov_px2[~good], m.cov_px2[~good])
        factors.append([np.median(error**2 / f.cov_px2[good][:, :2]) / 0.455 for f in (m, true)])
    first, corrected = np.array(factors).T
    assert first[-1] > 3 * first[0]
    assert corrected.max() < 1.4 * corrected.min()
    # smooth textures see noise that the smoothing has correlated: sum of its correlations 4.5, half by the weights
    assert (np.abs(corrected / 2.26 - 1) < 0.4).all()


@needs_kernel
@pytest.mark.parametrize(
    "options",
    [
        OPTIONS,
        WindowOptions(),
        WindowOptions(half=5, sigma=2.5, loose=0.02),
        WindowOptions(half=12, sigma=100.0, iterations=6),
        WindowOptions(sigma=100.0, loose=1.0, spline=True),
    ],
)
def test_the_kernel_gives_what_the_twin_gives(affine_pair, options):
    reference, target, xy = affine_pair
    reference, target = noisy(reference, 150, 1), noisy(target, 150, 2)
    xy = np.concatenate([xy[::3], [[4.0, 100.0], [415.0, 376.0], [-30.0, 5.0]]])
    near = start(xy)
    near[-3:] = [200.0, 150.0]
    near[0] = [3.0, 3.0]
    a = match_windows(reference, target, xy, near, identity(len(xy)), options)
    b = match_windows_twin(reference, target, xy, near, identity(len(xy)), options)
    np.testing.assert_array_equal(a.outcome, b.outcome)
    good = a.outcome == Outcome.MATCHED
    assert good.sum() > 30
    np.testing.assert_allclose(a.xy_px[good], b.xy_px[good], atol=1e-6)
    np.testing.assert_allclose(a.affine[good], b.affine[good], atol=1e-6)
    np.testing.assert_allclose(a.cov_px2[good], b.cov_px2[good], rtol=1e-5)
    np.testing.assert_allclose(a.correlation[good], b.correlation[good], atol=1e-7)
    size = np.abs(b.residual[good]).max(axis=0)
    np.testing.assert_allclose(a.residual[good] / size, b.residual[good] / size, rtol=1e-3, atol=1e-6)


@needs_kernel
def test_curved_windows_by_the_kernel_are_those_of_the_twin(affine_pair):
    reference, target, xy = affine_pair
    reference, target, xy = noisy(reference, 150, 1), noisy(target, 150, 2), xy[::3]
    options = WindowOptions(half=10, sigma=100.0, loose=1.0, iterations=60, spline=True, quadratic=True)
    a, b = (
        match(reference, target, xy, start(xy), identity(len(xy)), options)
        for match in (match_windows, match_windows_twin)
    )
    np.testing.assert_array_equal(a.outcome, b.outcome)
    good = a.outcome == Outcome.MATCHED
    assert good.sum() > 30
    assert np.abs(b.bend[good]).max() > 1e-4
    for name, tolerance in (
        ("xy_px", 1e-6),
        ("affine", 1e-6),
        ("bend", 1e-7),
        ("cov_px2", 1e-9),
        ("correlation", 1e-7),
    ):
        np.testing.assert_allclose(getattr(a, name)[good], getattr(b, name)[good], atol=tolerance, err_msg=name)
    size = np.abs(b.residual[good, :8]).max(axis=0)
    np.testing.assert_allclose(a.residual[good, :8] / size, b.residual[good, :8] / size, rtol=1e-3, atol=1e-5)
    assert not a.residual[:, 8:].any()
    assert not b.residual[:, 8:].any()


KERNELS = [pytest.param(match_windows, id="kernel"), pytest.param(match_windows_twin, id="twin")]


def one(kernel, reference, target, xy, begin, **options):
    m = kernel(
        reference, target, np.array([xy], float), np.array([begin], float), identity(1), replace(OPTIONS, **options)
    )
    return Outcome(int(m.outcome[0]))


@pytest.mark.parametrize("kernel", KERNELS)
def test_what_cannot_be_matched_is_told_apart(kernel):
    picture = Texture(7).image(120, 100)
    flat = np.full_like(picture, 20000)
    middle = (60.5, 50.5)
    assert one(kernel, picture, picture, middle, middle) == Outcome.MATCHED
    assert one(kernel, picture, picture, (4.0, 50.0), middle) == Outcome.OUTSIDE
    assert one(kernel, picture, picture, middle, (117.0, 50.0)) == Outcome.OUTSIDE
    assert one(kernel, flat, picture, middle, middle) == Outcome.FLAT
    assert one(kernel, picture, flat, middle, middle) == Outcome.FLAT
    assert one(kernel, picture, picture, middle, (62.0, 50.5), reach=1.0) == Outcome.MOVED
    assert one(kernel, picture, picture, middle, (61.5, 50.5), iterations=1) == Outcome.UNSTEADY


@pytest.mark.parametrize("kernel", KERNELS)
def test_nothing_to_match_gives_nothing(kernel):
    picture = Texture(7).image(60, 60)
    m = kernel(picture, picture, np.zeros((0, 2)), np.zeros((0, 2)), np.zeros((0, 2, 2)), OPTIONS)
    assert m.xy_px.shape == (0, 2)
    assert len(m.outcome) == 0


@pytest.mark.parametrize("kernel", KERNELS)
def test_places_that_are_not_numbers_are_outside(kernel):
    picture = Texture(7).image(120, 100)
    assert one(kernel, picture, picture, (np.nan, 50.0), (60.0, 50.0)) == Outcome.OUTSIDE
    assert one(kernel, picture, picture, (60.0, 50.0), (60.0, np.nan)) == Outcome.OUTSIDE
    assert one(kernel, picture, picture, (60.0, 50.0), (1e300, 50.0)) == Outcome.OUTSIDE


@pytest.mark.parametrize("kernel", KERNELS)
def test_a_given_affine_map_that_is_held_firmly_stays(kernel, affine_pair):
    reference, target, xy = affine_pair
    xy = xy[::9]
    given = np.tile(AFFINE, (len(xy), 1, 1))
    m = kernel(reference, target, xy, target_from_reference(xy), given, replace(OPTIONS, loose=1e-5))
    good = m.outcome == Outcome.MATCHED
    assert good.mean() > 0.9
    assert np.abs(m.affine - AFFINE)[good].max() < 1e-3
