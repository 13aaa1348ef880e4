"""Heights on a grid, and sums of them, beside simulated surfaces whose errors are correlated as is stated."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

from raybundle.errors import InputError
from raybundle.surfaces.depths.filters import Flag
from raybundle.surfaces.depths.pairs import PairOfImages, Sources
from raybundle.surfaces.heights.height_model import HeightModel
from raybundle.surfaces.heights.heights import (
    BETWEEN_MAPS,
    Heights,
    PointsOfCells,
    between,
    between_maps,
    on_grid,
    within,
)
from raybundle.surfaces.stages.heights import _alike

FINE = 4
"""Points along the side of a cell"""


def points_above(shape, *, height, sigma=0.01, orientation=0.0, image=0, rng=None):
    """Points all over a grid, at heights given by their places."""
    n = FINE**2 * shape[0] * shape[1]
    rng = rng or np.random.default_rng(1)
    column, row = rng.random(n) * shape[1], rng.random(n) * shape[0]
    z, slope = height(column, row)
    return PointsOfCells(
        column=column, row=row, height=z, slope=np.broadcast_to(slope, (n, 2)), local=np.full(n, sigma),
        orientation=np.full(n, orientation), image=np.full(n, image, np.int32),
    )  # fmt: skip


def test_a_plane_is_met_in_the_middle_of_each_cell():
    def plane(column, row):
        return 3.0 + 0.2 * column - 0.5 * row, (0.2, -0.5)

    found, weights = on_grid(points_above((20, 30), height=plane), (20, 30), 0.5)
    row, column = np.mgrid[:20, :30] + 0.5
    known = found.points > 0
    assert known.mean() > 0.99
    assert np.abs(found.height - plane(column, row)[0])[known].max() < 1e-5
    assert weights.sum() == pytest.approx(known.sum())
    assert np.isnan(found.height[~known]).all()


def test_the_upper_of_two_layers_is_taken_and_blunders_above_it_are_not():
    rng = np.random.default_rng(2)

    def floor(column, row):
        return 0.01 * rng.normal(size=len(column)), (0.0, 0.0)

    lower = points_above((10, 10), height=floor, rng=rng)
    upper = points_above((10, 10), height=lambda c, r: (1.0 + floor(c, r)[0], (0.0, 0.0)), rng=rng)
    upper = upper.rows(np.flatnonzero(upper.column < 5))
    high = points_above((10, 10), height=lambda c, _: (4.0 + 0 * c, (0.0, 0.0)), rng=rng)
    few = high.rows(np.flatnonzero(np.arange(len(high)) % 20 == 0))
    found, _ = on_grid(PointsOfCells.joined([lower, few, upper]), (10, 10), 0.1)
    assert np.abs(found.height[:, :5] - 1).max() < 0.02
    assert np.abs(found.height[:, 5:]).max() < 0.02


def test_nothing_above_the_grid_gives_no_heights():
    found, weights = on_grid(
        points_above((3, 3), height=lambda c, _: (c, (1.0, 0.0))).rows(np.zeros(0, int)), (3, 3), 1
    )
    assert np.isnan(found.height).all()
    assert not len(weights)
    assert (found.image == -1).all()


@pytest.mark.parametrize("length", [0.3, 2.0])
def test_the_correlation_of_two_cells_is_the_mean_over_their_places(length):
    rng = np.random.default_rng(3)
    a = rng.random((200_000, 2))
    for apart in ((0, 0), (1, 0), (2, 1)):
        b = rng.random((200_000, 2)) + apart
        drawn = np.exp(-(((a - b) / length) ** 2).sum(axis=1)).mean()
        stated = float(between(np.array(apart[0]), np.array(apart[1]), length))
        assert stated == pytest.approx(drawn, rel=0.05, abs=1e-4)
    assert within(1e4) == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("length", [0.4, 1.5])
def test_cells_and_means_scatter_as_is_stated(length):
    """Errors of points as a field that is correlated by exp(-(d / length)^2), and one error common to all."""
    shape, sigma, common = (24, 24), 0.02, 0.004
    rng = np.random.default_rng(4)
    side = FINE * shape[0]
    row, column = (np.mgrid[:side, :side] + 0.5) / FINE
    smooth = length * FINE / 2
    cells, means = [], []
    weights = np.zeros(shape)
    weights[4:20, 6:18] = 1 / (16 * 12)
    for _ in range(120):
        field = gaussian_filter(rng.normal(size=(3 * side, 3 * side)), smooth, mode="wrap")[side:-side, side:-side]
        field *= sigma * np.sqrt(4 * np.pi) * smooth
        points = PointsOfCells(
            column=column.ravel(), row=row.ravel(), height=field.ravel() + common * rng.normal(),
            slope=np.zeros((side**2, 2)), local=np.full(side**2, sigma), orientation=np.full(side**2, common),
            image=np.zeros(side**2, np.int32),
        )  # fmt: skip
        found, _ = on_grid(points, shape, length)
        model = HeightModel(
            heights=found, moved=np.full((2, 2, 1, 1), common, np.float32), block=32, cell=1.0, length=length
        )
        total = model.sum_of(weights)
        cells.append(np.mean((found.height / found.sigma) ** 2))
        means.append(total.value / total.sigma)
    assert np.mean(cells) == pytest.approx(1.0, abs=0.15)
    assert np.mean(np.square(means)) == pytest.approx(1.0, abs=0.35)


@pytest.mark.parametrize("count", [1, 8])
def test_errors_of_slopes_do_not_go_over_half_a_cell(count):
    """Points whose slopes are as uncertain as their heights are over the length of correlation."""
    shape, sigma, length = (60, 60), 0.02, 0.4
    rng = np.random.default_rng(9)
    n = count * 3600
    row, column = (np.repeat(k.ravel(), count) + rng.random(n) for k in np.mgrid[:60, :60])
    points = PointsOfCells(
        column=column, row=row, height=0.3 * column + sigma * rng.normal(size=n),
        slope=np.array([0.3, 0.0]) + sigma / length * rng.normal(size=(n, 2)), local=np.full(n, sigma),
        orientation=np.zeros(n), image=np.zeros(n, np.int32),
    )  # fmt: skip
    found, _ = on_grid(points, shape, length)
    if count == 1:
        z = (found.height - 0.3 * (np.arange(60) + 0.5)) / found.local
        assert np.std(z) == pytest.approx(1.0, abs=0.05)
    mean = np.add.reduceat(points.height - 0.3 * (column - np.floor(column) - 0.5), np.arange(0, n, count)) / count
    assert np.std(found.height.ravel() - mean) < 1.1 * sigma / length * 0.41 / count


def test_orientation_does_not_get_better_with_more_cells():
    shape = (64, 64)
    flat = np.zeros(shape, np.float32)
    heights = Heights(
        height=flat, local=flat + 0.01, step=flat, orientation=flat + 0.02, point=flat + 0.01,
        points=np.ones(shape, np.uint16), image=np.zeros(shape, np.int32),
    )  # fmt: skip
    moved = np.zeros((3, 3, 1, 2), np.float32)
    moved[..., 0], moved[:, 0, 0, 1], moved[:, 2, 0, 1] = 0.01, 0.02, -0.02
    model = HeightModel(heights=heights, moved=moved, block=32, cell=0.1, length=0.5)
    mean = model.sum_of(np.full(shape, 1 / 64**2))
    assert mean.orientation == pytest.approx(0.01)  # what tilts the whole has no part in its mean
    assert mean.local < 0.01 / 20
    left = np.zeros(shape)
    left[:, :32] = 1 / (64 * 32)
    assert model.sum_of(left).orientation == pytest.approx(np.hypot(0.01, 0.01))


def test_a_sum_over_holes_is_refused():
    shape = (4, 4)
    flat = np.zeros(shape, np.float32)
    hole = flat.copy()
    hole[1, 1] = np.nan
    heights = Heights(
        height=hole, local=flat, step=flat, orientation=flat, point=flat, points=np.ones(shape, np.uint16),
        image=np.zeros(shape, np.int32),
    )  # fmt: skip
    model = HeightModel(heights=heights, moved=np.zeros((2, 2, 1, 1), np.float32), block=32, cell=1.0, length=1.0)
    with pytest.raises(InputError, match=r"1.*16.*height_grid\.void_cells"):
        model.sum_of(np.ones(shape))


def sources(reference, *mine, angle_deg, points=100):
    pairs = tuple(
        PairOfImages(reference=reference, source=k, points=points, angle_deg=angle_deg, scale=1.0)
        for k in range(4)
        if k != reference
    )
    return Sources(reference=reference, sources=mine, pairs=pairs, seen=1.0)


def test_maps_correlate_more_the_more_photographs_they_share_and_the_more_alike_they_look():
    same = between_maps([sources(0, 1, angle_deg=10), sources(1, 0, angle_deg=10)])
    assert same == pytest.approx(0.31 + 0.23 * np.cos(np.radians(10)), abs=1e-3)
    apart = between_maps([sources(0, 2, angle_deg=10), sources(1, 3, angle_deg=10)])
    assert apart == pytest.approx(0.23 * np.cos(np.radians(10)), abs=1e-3)
    steep = between_maps([sources(0, 1, angle_deg=60), sources(1, 0, angle_deg=60)])
    assert apart < steep < same
    assert between_maps([sources(0, 1, angle_deg=10)]) == BETWEEN_MAPS  # of one map nothing is known


def test_a_cell_of_several_maps_is_the_worse_the_more_they_correlate():
    def flat(column, _):
        return 0 * column, (0.0, 0.0)

    both = PointsOfCells.joined([points_above((8, 8), height=flat, image=k) for k in (0, 1)])
    little, much = (on_grid(both, (8, 8), 50.0, apart)[0].local for apart in (0.2, 0.6))
    # points of one map in a small cell are all but one: half of the variance is common, half as far as maps are
    expected = [np.sqrt(0.5 * (1 + apart)) for apart in (0.2, 0.6)]
    assert np.median(little) == pytest.approx(0.01 * expected[0], rel=0.03)
    assert np.median(much) == pytest.approx(0.01 * expected[1], rel=0.03)


def test_points_of_halves_count_with_a_doubled_standard_deviation():
    """In place of a length of correlation that is twice as large: of a mean over an area it comes to the same."""
    flags = np.array([[0, Flag.COARSE], [Flag.STEP, Flag.COARSE | Flag.EDGE]], np.uint8)
    store = SimpleNamespace(wanted=lambda key, names: {"flags": flags} if (key, names) == ("a map", ("flags",)) else {})
    found = _alike(store, SimpleNamespace(map="a map"), np.array([3, 0, 1, 2, 1]))
    assert found.tolist() == [2, 1, 2, 1, 2]
