"""Surfaces that are curved within the windows: matches are displaced, by what residuals and neighbours show."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.matching.least_squares import FIGURES, WindowOptions, match_windows
from raybundle.ties.curvature import of_neighbours, without_curvature
from tests.matching.test_relief import C_PX, block_of, pair

SMALL, LARGE = WindowOptions(half=5, sigma=3.0, step=0.01), WindowOptions(half=8, sigma=4.8, step=0.01)
PER_DEPTH = C_PX / 100
"""Pixels by which the second photograph moves for a unit of depth, at a distance of 10 from a base of 1."""


def waves(x, y, length):
    return 0.8 * np.cos(2 * np.pi * x / length) * np.cos(2 * np.pi * y / length)


def matched(length, options, noise=30.0, step=15.0):
    """Places, true and measured places in the second photograph of waves of relief, figures of the matches."""
    grid = np.arange(60.0, 340, step)
    xy = np.stack(np.meshgrid(grid, grid), axis=-1).reshape(-1, 2)
    first, second = pair(lambda x, y: waves(x, y, length), noise)
    true = xy.copy()
    for _ in range(30):  # the second photograph shows at x what the first shows at x + waves
        true[:, 0] = xy[:, 0] - waves(true[:, 0], xy[:, 1], length)
    found = match_windows(first, second, xy, true, np.tile(np.eye(2), (len(xy), 1, 1)), options)
    good = (found.outcome == 0) & (found.correlation > 0.75)
    return xy[good], true[good], found.xy_px[good], found.residual[good]


def corrected(xy, seen, figures):
    """The block of the matches, its second photograph after the correction, sigmas of what is left."""
    n = len(xy)
    block = block_of(xy)
    depth = 10 + (seen - xy)[:, 0] / PER_DEPTH
    points = replace(block.points, xyz=block.points.xyz * (depth / 10)[:, None])
    o = replace(block.observations, xy_px=np.concatenate([xy, seen]), cov_px2=np.tile([9e-4, 9e-4, 0], (2 * n, 1)))
    residual = np.concatenate([np.zeros((n, FIGURES)), figures])
    reference = np.arange(2 * n) < n
    found = without_curvature(replace(block, observations=o, points=points), residual, reference, ~reference)
    assert np.array_equal(found.observations.xy_px[:n], xy)
    return found.observations.xy_px[n:], found.points.sigma_curvature


@pytest.mark.parametrize("options", [SMALL, LARGE])
def test_residuals_show_how_far_a_curved_window_is_displaced(options):
    _, true, seen, r = matched(48.0, options, noise=5.0)
    k = r[:, 8] / r[:, 10]  # the parallax lies along x
    error = (seen - true)[:, 0]
    assert np.abs(error).max() > 0.05
    slope = (error @ (k * r[:, 13])) / ((k * r[:, 13]) ** 2).sum()
    assert slope == pytest.approx(1, abs=0.15)
    assert np.corrcoef(error, k * r[:, 13])[0, 1] > 0.8
    curvature = (2 * np.pi / 48) ** 2 * waves(*true.T, 48)
    assert np.corrcoef(curvature, k)[0, 1] > 0.9
    side = np.arange(-options.half, options.half + 1)
    weights = np.exp(-(side**2) / (2 * options.sigma**2))
    assert np.median(r[:, 13]) == pytest.approx((weights @ side**2) / weights.sum(), rel=0.15)


def test_neighbours_correct_even_curvature_and_residuals_steep_one():
    for length in (110.0, 48.0):
        xy, true, seen, figures = matched(length, SMALL)
        fixed, left = corrected(xy, seen, figures)
        before, after = np.abs(seen - true)[:, 0], np.abs(fixed - true)[:, 0]
        steep = np.abs(waves(*true.T, length)) > 0.5
        assert np.median(after[steep]) < 0.7 * np.median(before[steep])
        assert np.sqrt((after**2).mean()) < np.sqrt((before**2).mean())
        assert (left[np.isfinite(left)] > 0).all()
    assert np.nansum(left[steep] ** 2) > 2 * np.nansum(left[~steep] ** 2)
    assert np.isfinite(left[steep]).mean() > 0.5


def test_a_quadratic_surface_counts_where_it_fits():
    rng = np.random.default_rng(4)
    xyz = rng.uniform(-1, 1, (400, 3))
    xyz[:, 2] = -(0.3 * xyz[:, 0] ** 2 + 0.1 * xyz[:, 1] ** 2) / 2 + 0.05 * xyz[:, 0]
    down = np.tile([0.0, 0.0, -1.0], (400, 1))
    inner = np.abs(xyz[:, :2]).max(axis=1) < 0.8
    np.testing.assert_allclose(of_neighbours(xyz, down, np.full(400, 1e-8))[inner], 0.2, rtol=1e-6)
    xyz[:, 2] = np.where(xyz[:, 0] > 0, 0.3, 0.0)
    assert np.abs(of_neighbours(xyz, down, np.full(400, 1e-8))[inner]).max() < 0.1
    assert not of_neighbours(xyz[:12], down[:12], np.full(12, 1e-8)).any()


def test_no_match_no_correction():
    block = block_of(np.array([[150.0, 180.0], [220.0, 240.0]]))
    found = without_curvature(block, np.zeros((4, FIGURES)), np.arange(4) < 2, np.arange(4) > 1)
    np.testing.assert_array_equal(found.observations.xy_px, block.observations.xy_px)
    assert np.isnan(found.points.sigma_curvature).all()
