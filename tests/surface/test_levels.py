"""Photographs at half the size: where pixels are, what is measured in them, and what a map takes of it."""

import cv2
import numpy as np
import pytest

from raybundle.surfaces.depths import depth_map as maps
from raybundle.surfaces.depths.depth_map import DepthOptions, depth_map
from raybundle.surfaces.depths.filters import Flag
from raybundle.surfaces.depths.levels import Level, halved, holes_of, nearest_of, on_level, rim_of, wanted_of
from tests.surface.scene import RANGE, scene
from tests.surface.tied import CHOSEN, robust, with_tie_points

NOISE = 2.0


@pytest.fixture(scope="module")
def ground():
    return scene()


@pytest.fixture(scope="module")
def block(ground):
    return with_tie_points(ground)


def photographs(ground, gain=1.0, noise=0.0):
    """With less contrast, and noise."""
    rng = np.random.default_rng(4)
    weak = [100 + gain * (g - g.mean()) + noise * rng.standard_normal(g.shape) for g in ground.grey]
    return [np.clip(np.round(g), 0, 255).astype(np.uint8) for g in weak].__getitem__


def level_of(ground, density=1):
    return Level(
        rays=ground.rays, reference=ground.grey[0], grey=ground.grey[0].astype(np.float32),
        sources=list(ground.sources), t_range=RANGE, density=density, threads=1, shown=None,
    )  # fmt: skip


@pytest.mark.parametrize("density", [1, 2, 4])
def test_pixels_of_a_half_lie_on_those_of_the_photograph(ground, density):
    whole = level_of(ground, density)
    grid = whole.grid(density)
    half = halved(whole)
    own = half.grid(half.density)
    place = half.in_photograph(own)
    assert place.stride == max(2, density)
    (row, column), (right, down) = nearest_of(place, grid)
    assert row.shape == (grid.rows, grid.columns)
    xy = place.xy_px[row, column]
    assert np.array_equal(xy + np.stack([right, down], axis=-1), grid.xy_px)
    assert right[:, :-4].max() == down[:-4].max() == (1 if density == 1 else 0)
    # the last ones lie in the half, too
    h, w = half.reference.shape
    assert own.xy_px[-1, -1][0] < w
    assert own.xy_px[-1, -1][1] < h


def test_places_and_grey_values_of_a_half_are_those_of_the_photograph(ground):
    whole = level_of(ground)
    table, grey = whole.sources[0].transfer, whole.sources[0].grey
    half = halved(whole)
    assert not whole.sources
    xy = np.array([[40.5, 30.5], [80.5, 60.5], [100.5, 90.5]])
    t = np.full(3, 0.1)
    at = half.sources[0].transfer.at((xy + 0.5) / 2, t)
    np.testing.assert_allclose(2 * at - 0.5, table.at(xy, t), atol=1e-9)
    np.testing.assert_allclose(half.sources[0].grey[5:-5, 5:-5], smoothed(grey)[::2, ::2][5:-5, 5:-5], rtol=1e-5)


def smoothed(grey):
    """By a binomial filter of five values along rows and columns."""
    line = np.array([1, 4, 6, 4, 1]) / 16
    for axis in (0, 1):
        grey = np.apply_along_axis(np.convolve, axis, grey.astype(float), line, "same")
    return grey


def test_what_is_not_measured_takes_its_surroundings_out_of_a_half(ground):
    whole = level_of(ground)
    whole.grey[40, 60] = np.nan
    half = halved(whole)
    lost = np.argwhere(np.isnan(half.grey))
    assert lost.tolist() == [[r, c] for r in (19, 20, 21) for c in (29, 30, 31)]


def test_holes_are_where_most_is_missing():
    known = np.ones((40, 50), bool)
    known[10:20, 10:30] = False
    known[30, 40] = False  # one alone is told by what is around it
    found = holes_of(known, 1)
    assert found[11:19, 13:27].all()
    assert not found[:9].any()
    assert not found[:, 32:].any()
    assert not holes_of(np.ones((8, 8), bool), 2).any()
    assert holes_of(np.zeros((8, 8), bool), 2).all()


@pytest.mark.parametrize("density", [1, 2, 4])
def test_what_a_level_measures_holds_the_holes_and_what_they_are_compared_with(ground, density):
    whole = level_of(ground, density)
    grid = whole.grid(density)
    holes = np.zeros((grid.rows, grid.columns), bool)
    xy = grid.xy_px
    holes[(np.abs(xy - [80, 60]) < 12).all(axis=-1)] = True
    half = halved(whole)
    own = half.grid(half.density)
    place = half.in_photograph(own)
    mine = on_level(holes, grid, place)
    (row, column), _ = nearest_of(place, grid)
    assert mine[row[holes], column[holes]].all()
    far = np.abs(place.xy_px - [80, 60]).max(axis=-1)
    assert not mine[far > 14].any()
    wanted = wanted_of(mine, own.stride)
    # and as far around as the test looks: 4 px of the level, 8 of the photograph
    assert wanted[far < 18].all()
    assert not wanted[far > 26].any()
    # windows reach 7 px of the photograph
    rim = rim_of(mine, own.stride)
    assert not rim[~mine].any()
    assert rim[(far > 7) & mine].all()
    assert not rim[far < 3].any()


@pytest.mark.parametrize("density", [1, 2, 4])
def test_depths_of_halves_are_those_of_the_ground(ground, block, monkeypatch, density):
    """Of a table a quarter of a pixel beside they would be off by more than ten times as much."""
    whole = maps.measured

    def nothing_in_the_photographs(level, *more):
        fine = whole(level, *more)
        if level.scale == 1:
            fine.t[:] = np.nan
        return fine

    monkeypatch.setattr(maps, "measured", nothing_in_the_photographs)
    found = depth_map(block, CHOSEN, photographs(ground), DepthOptions(density=density))
    even = (found.flags & (Flag.COARSE | Flag.LONELY | Flag.EDGE)) == Flag.COARSE
    assert even.mean() > 0.5
    off = (found.t - found.grid.of(ground.t))[even]
    assert robust(off) < 3e-5  # 0.3 mm of a depth of 10 m per 1e-5
    assert abs(np.median(off)) < 0.3 * robust(off)
    for k in (0, 1):
        assert robust((found.slopes[k] - found.grid.of(ground.slopes[k]))[even]) < 1e-5


def test_weak_texture_is_measured_in_halves_and_as_well_as_is_stated(ground, block):
    """Contrast of 1.6 grey values beside noise of 2: hardly a pixel has a depth."""
    found = depth_map(block, CHOSEN, photographs(ground, 0.08, NOISE), DepthOptions(density=1))
    known, coarse = np.isfinite(found.t), found.flags & Flag.COARSE > 0
    assert known.mean() > 0.8
    assert (known & ~coarse).mean() < 0.15
    assert not coarse[~known].any()
    even = (found.flags & (Flag.COARSE | Flag.LONELY | Flag.EDGE)) == Flag.COARSE
    assert even.mean() > 0.25
    x = ((found.t - found.grid.of(ground.t)) / np.sqrt(found.variance()))[even]
    assert 0.6 < robust(x) ** 2 < 1.4
    assert np.mean(np.abs(x) < 1.96) > 0.93
    assert np.mean(np.abs(x) > 5) < 0.005
    assert (found.reason[known] == 0).all()
    # they stay where other maps confirm them
    assert found.doubtful[even].all()
    assert np.isnan(found.sure().t[coarse]).all()


def test_good_texture_is_measured_in_the_photographs_alone(ground, block):
    found = depth_map(block, CHOSEN, photographs(ground, 1.0, NOISE), DepthOptions(density=1))
    assert np.isfinite(found.t).mean() > 0.9
    assert np.mean(found.flags & Flag.COARSE > 0) < 0.01


def test_a_map_of_halves_is_the_same_for_any_number_of_threads_and_by_strips(ground, block, monkeypatch):
    weak = photographs(ground, 0.08, NOISE)
    whole = depth_map(block, CHOSEN, weak, DepthOptions(density=2))
    monkeypatch.setattr("raybundle.surfaces.depths.levels.STRIP_BYTES", 1.0)
    parts = depth_map(block, CHOSEN, weak, DepthOptions(density=2, threads=2))
    for name, values in whole.as_arrays().items():
        assert np.array_equal(values, parts.as_arrays()[name], equal_nan=values.dtype.kind == "f"), name


def test_what_may_not_be_measured_has_no_depth_in_halves_either(ground, block):
    weak = photographs(ground, 0.08, NOISE)
    free = np.ones(ground.grey[0].shape, bool)
    free[30:70, 60:100] = False
    found = depth_map(
        block, CHOSEN, weak, DepthOptions(density=1), free=lambda image: free if image == 0 else None
    )  # fmt: skip
    inner = cv2.erode((~free).astype(np.uint8), np.ones((7, 7), np.uint8)) > 0
    assert not np.isfinite(found.t[found.grid.of(inner)]).any()
    assert np.isfinite(found.t).mean() > 0.5
