"""What an orthophoto is made of, one by one: lines of sight, seams, brightness, gaps, displacement."""

import numpy as np
import pytest

from raybundle.surfaces.heights.interpolation import bends_of, beside_steps, closed, height_at, slopes_of
from raybundle.surfaces.heights.orthophoto_error import displacement, gram
from raybundle.surfaces.heights.seams import ROUNDS, chosen, gains, seam_costs, spread_of
from raybundle.surfaces.heights.sight_lines import seen_from


def test_a_wall_hides_what_lies_in_its_shadow():
    height = np.zeros((9, 60))
    height[:, 20] = 5.0
    viewer = np.array([-20.0, 4.5, 25.0])  # its line over the wall comes down at 20.5 + 5 * 40.5 / 20
    cells = np.arange(height.size)
    seen = seen_from(height, np.full(height.shape, 0.01), viewer, cells).reshape(height.shape)[4]
    assert seen[:21].all()
    assert not seen[21:30].any()
    assert seen[32:].all()
    above = seen_from(height, np.full(height.shape, 0.01), np.array([20.5, 4.5, 100.0]), cells)
    assert above.mean() > 0.95
    assert not seen_from(height, np.full(height.shape, 0.01), np.array([0.0, 4.5, -3.0]), cells).any()


def test_holes_hide_nothing_and_noise_does_not_either():
    rng = np.random.default_rng(1)
    sigma = np.full((40, 40), 0.05)
    height = 0.05 * rng.normal(size=sigma.shape)
    viewer = np.array([-30.0, 20.0, 25.0])
    assert seen_from(height, sigma, viewer, np.arange(1600)).mean() > 0.99
    height[10:30, 10:20] = np.nan
    cells = np.flatnonzero(np.isfinite(height))
    assert seen_from(height, sigma[: len(height)], viewer, cells).mean() > 0.99


def test_a_seam_goes_where_photographs_look_alike():
    """Two photographs, each better on its side; they differ but for a lane through the middle of one side."""
    rows, columns, lane = 40, 60, 38
    x = np.arange(columns) + np.zeros((rows, 1))
    cost = np.stack([0.004 * (x - 30), 0.004 * (30 - x)])
    colour = np.zeros((2, rows, columns, 3), np.float32)
    colour[1] = 40
    colour[1, :, lane : lane + 2] = 0
    seen = np.ones(cost.shape, bool)
    taken = chosen(cost, *seam_costs(colour, seen))
    assert (np.diff(taken, axis=0) == 0).all()
    (at,) = np.flatnonzero(np.diff(taken[0]))
    assert at == lane
    free = chosen(cost, np.zeros((rows, columns - 1)), np.zeros((rows - 1, columns)))
    assert np.flatnonzero(np.diff(free[0])).tolist() == [30]  # without costs of seams, where both are as good


def test_a_part_with_its_margin_is_chosen_as_in_the_whole():
    rng = np.random.default_rng(2)
    cost = rng.random((4, 120, 130)).astype(np.float32)
    cost[rng.random(cost.shape) < 0.2] = np.inf
    colour = rng.integers(0, 255, (*cost.shape, 3)).astype(np.float32)
    whole = chosen(cost, *seam_costs(colour, np.isfinite(cost)))
    assert (np.isfinite(cost).any(axis=0) == (whole >= 0)).all()
    assert np.isfinite(np.take_along_axis(cost, np.maximum(whole, 0)[None], 0)[0][whole >= 0]).all()
    part = np.s_[:, 10:105, 20:122]
    alone = chosen(cost[part], *seam_costs(colour[part], np.isfinite(cost[part])))
    inner = np.s_[ROUNDS:-ROUNDS, ROUNDS:-ROUNDS]
    assert np.array_equal(alone[inner], whole[10:105, 20:122][inner])


def test_nothing_to_choose_from():
    assert (chosen(np.zeros((0, 3, 4)), np.zeros((3, 3)), np.zeros((2, 4))) == -1).all()
    none = chosen(np.full((2, 3, 4), np.inf), np.ones((3, 3)), np.ones((2, 4)))
    assert (none == -1).all()
    assert (spread_of(np.zeros((2, 3, 4, 3)), np.zeros((2, 3, 4), bool)) == 0).all()


def test_gains_make_photographs_alike_and_do_not_follow_what_moved():
    rng = np.random.default_rng(3)
    scene = rng.uniform(60, 160, (4000, 3))
    true = {1: np.array([1.0, 1.1, 0.9]), 5: np.array([1.2, 1.0, 1.0]), 9: np.array([0.85, 0.9, 1.1])}
    samples = {}
    for k, (image, factor) in enumerate(true.items()):
        at = np.arange(1000 * k, 1000 * k + 2000)
        colours = scene[at] / factor * np.exp(rng.normal(0, 0.05, (2000, 3)))
        colours[rng.random(2000) < 0.2] = 20  # a shadow that moved
        samples[image] = at, np.clip(np.rint(colours), 0, 255).astype(np.uint8)
    found = gains(samples)
    relative = np.array([found[k] / true[k] for k in true])
    assert np.abs(relative / relative.mean(axis=0) - 1).max() < 0.01
    assert np.log(list(found.values())).mean(axis=0) == pytest.approx(np.zeros(3), abs=1e-12)
    alone = gains({3: samples[1]})
    assert alone[3].tolist() == [1, 1, 1]


def test_small_gaps_are_closed_with_what_is_around_and_outlines_stay():
    height = np.full((30, 30), np.nan, np.float32)
    height[5:25, 5:25] = 2.0
    height[10, 10] = height[12, 12:14] = np.nan
    sigma = np.where(np.isfinite(height), 0.1, np.nan).astype(np.float32)
    found, local, orientation = closed(height, sigma, sigma)
    assert np.isfinite(found[5:25, 5:25]).all()
    assert found[10, 10] == pytest.approx(2.0)
    assert local[10, 10] == pytest.approx(0.1, abs=1e-3)
    assert orientation[12, 12] == pytest.approx(0.1)
    assert np.isnan(found[:4]).all()
    height[:, 15:] += 1  # at a step nobody knows on which side the gap is
    height[10, 15] = np.nan
    assert closed(height, sigma, sigma)[1][10, 15] > 0.3


def test_heights_between_cells_are_linear_but_for_steps():
    row, column = np.mgrid[:20, :30] + 0.5
    height = 0.1 * column - 0.05 * row
    x, y = np.array([3.3, 10.9, 29.9]), np.array([4.2, 0.1, 19.5])
    z, i, j = height_at(height, x, y, 1.0)
    assert z[:2] == pytest.approx((0.1 * x - 0.05 * y)[:2], abs=0.03)
    assert z[0] == pytest.approx(0.1 * 3.3 - 0.05 * 4.2)
    assert i.tolist() == [3, 10, 29]
    assert j.tolist() == [4, 0, 19]
    right, up = slopes_of(height, 1.0)
    assert right == pytest.approx(np.full(height.shape, 0.1))
    assert up == pytest.approx(np.full(height.shape, 0.05))
    height[:, 15:] += 10
    z, _, _ = height_at(height, np.array([14.9, 15.1]), np.array([5.5, 5.5]), 1.0)
    assert z == pytest.approx([height[5, 14], height[5, 15]])
    assert (beside_steps(height, 1.0) > 3).sum() == 2 * 20
    assert (beside_steps(height, 1.0) > 0).sum() == 2 * 20
    assert bends_of(0.02 * column**2)[5, 5] == pytest.approx(0.02 * 2 / 4)


def test_what_a_pixel_shows_lies_off_as_is_stated():
    """Rays, heights and their errors drawn; where the ray then meets the surface."""
    rng = np.random.default_rng(4)
    n, q = 4000, 6
    tangent, slope, local = np.array([[0.5, -0.3]]), np.array([[0.3, 0.2]]), np.array([0.02])
    ray, moved = 0.01 * rng.normal(size=(3, q)), 0.01 * rng.normal(size=q)
    stated = displacement(tangent, slope, local, gram(ray, moved)[None])[0]
    each = rng.normal(size=(n, q))
    a, m, e = each @ ray.T, each @ moved, local * rng.normal(size=n)
    # true ray through X - a; true height h - m - e + slope . (place - X); X is the origin
    s = (a[:, 2] - a[:, :2] @ slope[0] - m - e) / (1 - slope[0] @ tangent[0])
    off = a[:, :2] - s[:, None] * tangent[0]
    assert off.std(axis=0) == pytest.approx(stated, rel=0.05)
    # a block that moves as a whole, heights with it, moves what is shown by just that
    alike = displacement(tangent, np.zeros((1, 2)), np.zeros(1), gram(np.eye(3), np.array([0.0, 0, 1]))[None])[0]
    assert alike == pytest.approx([1.0, 1.0])
