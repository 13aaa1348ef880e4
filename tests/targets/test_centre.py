"""Centres of dots on rendered photographs: no bias, the precision that is possible, a covariance that is true."""

import numpy as np
import pytest
from scipy.stats import chi2, kstest

from raybundle.numerics import native
from raybundle.targets.centre import (
    DotOptions,
    DotOutcome,
    blurred_ellipse,
    ellipse_from_triangle,
    fit_dots,
    fit_dots_twin,
    triangle_from_ellipse,
)
from raybundle.targets.detect import DetectionOptions, detect_targets
from tests.targets.render import shot


def fitted(rng, radius, tilt, window=2.0, **light):
    """A rendered dot and its fit from a start that is wrong by some tenths of a pixel."""
    s = shot(rng, radius, np.radians(tilt), size=2 * int(radius * 2.2 + 10), **light)
    start = s.centre + rng.normal(0, 0.15, 2), s.ellipse * (1 + rng.normal(0, 0.05))
    return s, fit_dots(s.image, start[0][None], start[1][None], np.array([window]))


def test_ellipse_and_triangle():
    C = np.array([[[9.0, 2.0], [2.0, 4.0]], [[1.0, -0.5], [-0.5, 3.0]]])
    assert np.allclose(ellipse_from_triangle(triangle_from_ellipse(C)), C)


def test_blurred_ellipse_against_sums_over_fine_pixels():
    """Green's theorem against the plain convolution of a finely sampled ellipse; derivatives by differences."""
    v = np.array([6.3, 5.8, 3.1, 0.9, 1.4, 0.8, 0, 1, 0, 0])
    x, y = np.arange(12) + 0.5, np.arange(11) + 0.5
    f, derivatives = blurred_ellipse(v, x, y)
    fine = (np.arange(0, 240) + 0.5) / 20
    X, Y = np.meshgrid(fine - v[0], fine - v[1])
    inside = (X / v[2]) ** 2 + ((Y - v[3] * X / v[2]) / v[4]) ** 2 <= 1
    kernel = [np.exp(-(((fine - a[:, None]) / v[5]) ** 2) / 2) / (v[5] * np.sqrt(2 * np.pi)) / 20 for a in (x, y)]
    assert abs(kernel[1] @ inside @ kernel[0].T - f).max() < 2e-3
    for k in range(6):
        h = 1e-5 * np.eye(10)[k]
        numeric = (blurred_ellipse(v + h, x, y)[0] - blurred_ellipse(v - h, x, y)[0]) / 2e-5
        assert abs(numeric - derivatives[k]).max() < 1e-5


@pytest.mark.parametrize(("radius", "limit"), [(5, 0.0089), (8, 0.0060), (15, 0.0041)])
def test_centres_are_as_precise_as_those_of_the_best_rival(radius, limit):
    rng = np.random.default_rng(radius)
    error = [(d.xy_px[0] - s.centre) for s, d in (fitted(rng, radius, 0) for _ in range(40))]
    assert np.sqrt(np.mean(np.square(error))) < limit


def bound(s, blur, noise=2.0, low=40.0, contrast=160.0):
    """Cramér and Rao: least variance of a coordinate, mean of both; ten unknowns, all pixels, noise and rounding."""
    v = np.array(
        [*s.centre, *triangle_from_ellipse(s.ellipse[None])[0], np.hypot(blur, np.sqrt(1 / 12)), low, contrast, 0, 0]
    )
    y, x = (np.arange(n) + 0.5 for n in s.image.shape)
    f, derivatives = blurred_ellipse(v, x, y)
    dx, dy = np.meshgrid(x - v[0], y - v[1])
    level = low + contrast * f
    J = np.stack([*(contrast * derivatives), np.ones_like(f), f, level * dx, level * dy]).reshape(10, -1)
    N = J @ J.T / (noise**2 + 1 / 12) + np.diag([0] * 8 + [1 / DotOptions().slope ** 2] * 2)
    return np.trace(np.linalg.inv(N)[:2, :2]) / 2


@pytest.mark.long
def test_centres_come_near_the_bound():
    """Over tilts, blurs and slopes of the light; each error in units of its own bound."""
    rng = np.random.default_rng(11)
    ratios = []
    for _ in range(120):
        blur = rng.uniform(0.5, 2)
        radius = rng.choice([5, 8])
        s = shot(
            rng, radius, np.radians(rng.uniform(0, 60)), size=2 * (int(radius * 2.2) + 14), blur=blur,
            slope=rng.uniform(-0.2, 0.2, 2),
        )  # fmt: skip
        (xy,) = detect_targets(s.image, None, DetectionOptions(polarity="light")).xy_px
        ratios.append(np.mean((xy - s.centre) ** 2) / bound(s, blur))
    assert np.sqrt(np.mean(ratios)) < 1.25


def mahalanobis(seed, runs=160):
    rng = np.random.default_rng(seed)
    values = []
    for _ in range(runs):
        s, d = fitted(
            rng, rng.choice([4, 6, 9]), rng.uniform(0, 60), blur=rng.uniform(0.5, 2), slope=rng.uniform(-0.2, 0.2, 2),
            inverse=bool(rng.integers(2)),
        )  # fmt: skip
        assert d.outcome[0] == DotOutcome.MEASURED
        e = d.xy_px[0] - s.centre
        values.append(e @ np.linalg.solve(d.cov_px2[0], e))
    return np.array(values)


def test_stated_covariance_is_true():
    assert kstest(mahalanobis(1), chi2(2).cdf).pvalue > 1e-3


def test_slope_of_the_light_does_not_move_the_centre():
    rng = np.random.default_rng(3)
    error = [d.xy_px[0] - s.centre for s, d in (fitted(rng, 10, 30, noise=0.5, slope=(0.4, 0.0)) for _ in range(20))]
    assert abs(np.mean(error, axis=0)).max() < 0.002


@pytest.mark.skipif(not native.available(), reason="kernels were not compiled")
def test_kernel_against_its_twin():
    rng = np.random.default_rng(5)
    for radius, tilt, window in ((2.5, 0, 1.5), (5, 55, 2.5), (12, 30, 1.4), (25, 10, 1.5)):
        s = shot(rng, radius, np.radians(tilt), size=int(7 * radius + 12), slope=(0.1, 0.2))
        for scale in (1.0, 1.4):  # the second start is bad
            start = s.centre[None] + 0.2, s.ellipse[None] * scale, np.array([window])
            image = s.image.astype(np.uint16)
            a = fit_dots(image, *start)
            b = fit_dots_twin(image, start[0], triangle_from_ellipse(start[1]), start[2], DotOptions())
            assert a.outcome == b.outcome
            if a.measured[0]:
                assert abs(a.xy_px - b.xy_px).max() < 1e-6
                assert np.allclose(a.values, b.values, rtol=1e-5, atol=1e-6)
                assert np.allclose(a.cov_px2, b.cov_px2, rtol=1e-4)
                assert np.allclose(a.residual, b.residual, rtol=1e-5)


@pytest.mark.parametrize("twin", [False, True])
def test_what_cannot_be_measured(twin):
    rng = np.random.default_rng(2)
    image = rng.normal(100, 2, (60, 60)).astype(np.uint16)
    s = shot(rng, 6, size=60)
    image[30:, :] = s.image[30:, :]

    def outcome(picture, xy, radius):
        start = np.array([xy], float), np.eye(2)[None] * radius**2, np.array([1.5])
        if twin:
            abd = triangle_from_ellipse(start[1])
            return fit_dots_twin(picture, start[0], abd, start[2], DotOptions()).outcome[0]
        return fit_dots(picture, *start).outcome[0]

    assert outcome(image, (5, 5), 6) == DotOutcome.OUTSIDE
    assert outcome(image, (15, 15), 0.3) == DotOutcome.FLAT
    assert outcome(np.full((60, 60), 90, np.uint16), (30, 30), 6) == DotOutcome.FLAT
    assert outcome(s.image.astype(np.uint16), s.centre + np.array([5.5, 0]), 6) != DotOutcome.MEASURED
