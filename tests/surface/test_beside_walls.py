"""Heights beside walls: holes that a step hides, cells whose heights are hardly known, areas of both."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.surfaces.heights.hole_filling import filled
from raybundle.surfaces.heights.terrain_filter import ground
from raybundle.surfaces.heights.true_areas import true_area
from raybundle.surfaces.heights.volumes import volume
from tests.surface.height_models import made

SHAPE, CELL, HIGH = (60, 80), 0.2, 6.0
HOUSE = slice(20, 40), slice(30, 50)


def yard(rng, *, hidden=5, slope=0.0, high=HIGH):
    """Ground with a house on it, to the right of which some columns are hidden; and the true heights."""
    true = np.zeros(SHAPE) + slope * CELL * np.arange(SHAPE[1])
    true[HOUSE] += high
    model = made(true, cell=CELL, sigma=0.01, length=0.8, rng=rng)
    lost = np.zeros(SHAPE, bool)
    lost[22:38, 50 : 50 + hidden] = True
    h = model.heights
    return replace(model, heights=replace(h, height=np.where(lost, np.nan, h.height).astype(np.float32))), true, lost


@pytest.mark.parametrize("slope", [0.0, 0.2])
def test_what_a_wall_hides_lies_at_its_foot(slope):
    model, true, lost = yard(np.random.default_rng(2), slope=slope)
    full = filled(model, 9)
    off = full.heights.height[lost] - true[lost]
    assert np.abs(off).max() < 0.1 + slope * 5 * CELL
    # it may lie as high as the house
    sigma = full.holes.sigma[lost] / (HIGH / np.sqrt(12))
    assert sigma.min() > 0.9
    assert sigma.max() < 1.4  # what the surface does between, judged by its surroundings with the wall, comes to it
    covered = np.zeros(SHAPE)
    covered[22:38, 50:55] = 1
    told = volume(full, covered, 0.0)
    area = covered.sum() * CELL**2
    assert abs(told.net.value - (true * covered).sum() * CELL**2) < 0.1 * area + 0.1 * slope * area
    assert told.net.sigma == pytest.approx(area * HIGH / np.sqrt(12), rel=0.4)


def test_a_hole_on_a_slope_or_on_rough_ground_has_no_step():
    rng = np.random.default_rng(3)
    for true in (0.5 * CELL * np.arange(80) + np.zeros(SHAPE), rng.normal(size=SHAPE) * 0.2):
        model = made(true, cell=CELL, sigma=0.01, rng=rng)
        lost = np.zeros(SHAPE, bool)
        lost[25:33, 40:48] = True
        h = model.heights
        model = replace(model, heights=replace(h, height=np.where(lost, np.nan, h.height).astype(np.float32)))
        assert filled(model, 9).holes.sigma[lost].max() < 0.6


def test_a_height_that_is_hardly_known_is_no_ground():
    """Beside the wall, 4.9 m too high, with a standard deviation of 4.2 m."""
    model, *_ = yard(np.random.default_rng(4), hidden=0)
    h = model.heights
    height, local, point = h.height.copy(), h.local.copy(), h.point.copy()
    height[30, 51], local[30, 51], point[30, 51] = 4.9, 4.2, 4.2
    model = replace(model, heights=replace(h, height=height, local=local, point=point))
    found, stands = ground(model, 24, 0.3)
    assert stands[30, 51]
    assert stands[HOUSE].all()
    assert np.abs(found.heights.height[19:41, 29:53]).max() < 0.1


def test_areas_of_heights_that_are_hardly_known_are_doubted_not_absurd():
    rng = np.random.default_rng(5)
    model, *_ = yard(rng, hidden=0)
    h = model.heights
    height, local, point = h.height.copy(), h.local.copy(), h.point.copy()
    wild = np.zeros(SHAPE, bool)
    wild[22:30, 10:14] = True
    height[wild] += rng.normal(size=wild.sum()) * 2
    local[wild] = point[wild] = 2.0
    noisy = replace(model, heights=replace(h, height=height, local=local, point=point))
    covered = np.zeros(SHAPE)
    covered[15:45, 5:20] = 1
    flat = covered.sum() * CELL**2
    told = true_area(noisy, covered)
    assert flat <= told.value < 2 * flat
    assert told.value - 3 * told.sigma < flat + 0.1
    assert told.sigma < flat
    quiet = true_area(model, covered)
    assert quiet.value == pytest.approx(flat, rel=0.01)
    assert quiet.sigma < 0.02 * flat


def test_the_area_in_a_hole_beside_a_wall_is_of_the_size_of_the_wall():
    model, *_ = yard(np.random.default_rng(6))
    full = filled(model, 9)
    covered = np.zeros(SHAPE)
    covered[20:40, 45:60] = 1
    told = true_area(full, covered)
    wall = 20 * CELL * HIGH
    flat = covered.sum() * CELL**2
    assert abs(told.value - flat - wall) < 2 * told.sigma
    assert told.sigma < 2 * wall
