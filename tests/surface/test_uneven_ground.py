"""How errors of orientation move heights of uneven ground: as they move the object, in plan and by its height, too."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.surfaces.heights.cell_factors import factors_of, slopes_of_surface
from raybundle.surfaces.heights.displacement import movements
from raybundle.surfaces.heights.hole_filling import spanned
from raybundle.surfaces.heights.node_sums import NodeSums, moments
from raybundle.surfaces.heights.nodes import at_cells, variances
from raybundle.surfaces.heights.resampling import difference, resampled
from raybundle.surfaces.heights.terrain_filter import ground
from tests.surface.height_models import BLOCK, made

SHAPE, CELL = (96, 128), 0.01
LENGTHS = 0.42, 0.55
"""Of waves, 42 and 55 cells"""
HIGH = 0.04
FAR = np.array([3.0, -2.0, 8.0])
"""About which errors of scale and rotation move the object"""


def waves(x, y):
    """Heights of a wavy ground, and how they rise with x and y."""
    a, b = (2 * np.pi / k for k in LENGTHS)
    z = 100 + 0.2 * x + HIGH * (np.sin(a * x) + np.cos(b * y))
    return z, 0.2 + HIGH * a * np.cos(a * x), -HIGH * b * np.sin(b * y)


def shifts(x, y, z):
    """Three of (n, 7): up, right and upwards in plan, by shifts of 2 mm, rotations of 0.3 mrad, 1 / 1000 of scale."""
    X, Y, Z = (v - f for v, f in zip((x, y, z - 100), FAR, strict=True))
    one, none = np.ones(len(x)), np.zeros(len(x))
    up = 2e-3 * one, none, none, 3e-4 * Y, -3e-4 * X, none, 1e-3 * Z
    right = none, 2e-3 * one, none, none, 3e-4 * Z, -3e-4 * Y, 1e-3 * X
    above = none, none, 2e-3 * one, -3e-4 * Z, none, 3e-4 * X, 1e-3 * Y
    return tuple(np.stack(each, axis=1) for each in (up, right, above))


def middles():
    r, c = np.mgrid[: SHAPE[0], : SHAPE[1]] + 0.5
    return c.ravel() * CELL, -r.ravel() * CELL


def exact():
    """(rows, columns, 7) how heights at places that are held in plan move."""
    x, y = middles()
    z, by_x, by_y = waves(x, y)
    up, right, above = shifts(x, y, z)
    return (up - by_x[:, None] * right - by_y[:, None] * above).reshape(*SHAPE, -1)


def told(rng, sigma=0.0, surface=waves):
    """Heights with noise, and what 48 points of each block tell of their motions."""
    rows, columns = (n // BLOCK for n in SHAPE)
    block = np.repeat(np.arange(rows * columns), 48)
    right, down = rng.uniform(-0.5, 0.5, (2, len(block)))
    c, r = block % columns + 0.5 + right, block // columns + 0.5 + down
    x, y = c * BLOCK * CELL, -r * BLOCK * CELL
    z = surface(x, y)[0]
    found = moments(
        right, down, z + rng.normal(0, sigma, len(z)), shifts(x, y, z), np.flatnonzero(np.diff(block, prepend=-1))
    )
    whole = replace(
        found, products=found.products.reshape(rows, columns, 4, 4), base=found.base.reshape(rows, columns),
        sums=found.sums.reshape(rows, columns, *found.sums.shape[1:]),
    )  # fmt: skip
    sums = NodeSums.of(SHAPE, BLOCK, 7)
    sums.add((0, 0), whole, np.ones(SHAPE, bool), BLOCK)
    moved, levels = sums.solved(BLOCK * CELL)
    flat = made(surface(*middles())[0].reshape(SHAPE), cell=CELL, sigma=sigma, common=None)
    height = (flat.heights.height + flat.heights.local * rng.normal(size=SHAPE)).astype(np.float32)
    model = replace(flat, heights=replace(flat.heights, height=height), moved=moved, levels=levels)
    return with_factors(model)


def with_factors(model):
    h = model.heights
    found = factors_of(h.height, h.local, model.levels, BLOCK, CELL)
    return replace(model, factors=found)


def windows(side=12):
    """Weights of means of windows, all over the grid."""
    for r in range(2, SHAPE[0] - side, 13):
        for c in range(2, SHAPE[1] - side, 17):
            w = np.zeros(SHAPE)
            w[r : r + side, c : c + side] = 1 / side**2
            yield w


def standard_deviations(model):
    """Those of means and of differences of means that are told, and the exact ones, (n, 2) each."""
    each, moved = list(windows()), exact()
    statistics_of = np.array([model.sum_of(w).moved for w in each])
    true = np.array([np.einsum("rc,rcq->q", w, moved) for w in each])
    one, other = np.triu_indices(len(each), 1)
    means, differences = (
        np.stack([np.linalg.norm(a, axis=1) for a in both], axis=1)
        for both in ((statistics_of, true), (statistics_of[one] - statistics_of[other], true[one] - true[other]))
    )
    return means, differences


@pytest.mark.parametrize("sigma", [0.0, 5e-4])
def test_means_and_differences_have_the_standard_deviations_of_the_motions(sigma):
    model = told(np.random.default_rng(1), sigma)
    means, differences = standard_deviations(model)
    assert np.abs(means[:, 0] / means[:, 1] - 1).max() < 0.01
    # differences are of far smaller motions than the motions themselves
    ratio = differences[:, 0] / differences[:, 1]
    assert np.abs(ratio - 1).max() < 0.1
    assert np.abs(np.median(ratio) - 1) < 0.02
    cells = np.sqrt(variances(model.moved, BLOCK, SHAPE, factors=model.factors))
    assert np.quantile(np.abs(cells / np.linalg.norm(exact(), axis=2) - 1), 0.99) < 0.02


def test_shifts_and_tilts_of_blocks_alone_tell_less():
    """What moves heights of a block in the mean, linear over it: neither the slope nor the height within it counts."""
    whole = told(np.random.default_rng(1))
    x, y = middles()
    r, c = -y / CELL, x / CELL
    block = (r // BLOCK * (SHAPE[1] // BLOCK) + c // BLOCK).astype(int)
    moved = exact().reshape(-1, 7)
    fitted = np.zeros_like(moved)
    for k in np.unique(block):
        at = block == k
        A = np.stack([np.ones(at.sum()), c[at], r[at]], axis=1)
        fitted[at] = A @ np.linalg.lstsq(A, moved[at], rcond=None)[0]
    _, differences = standard_deviations(whole)
    each = np.array([np.einsum("rc,rcq->q", w, fitted.reshape(*SHAPE, 7)) for w in windows()])
    one, other = np.triu_indices(len(each), 1)
    ratio = np.linalg.norm(each[one] - each[other], axis=1) / differences[:, 1]
    assert np.quantile(ratio, 0.1) < 0.6


def niche(x, y, deep=0.33):
    """A wall with a niche of 16 x 16 cells within a block."""
    inside = (np.abs(x / CELL - 48) < 8) & (np.abs(-y / CELL - 48) < 8)
    return np.where(inside, 100 - deep, 100.0), 0 * x, 0 * x


@pytest.mark.parametrize("sigma", [0.0, 1e-3])
def test_an_error_of_scale_moves_what_lies_in_a_niche(sigma):
    model = told(np.random.default_rng(2), sigma, niche)
    one, other = np.zeros(SHAPE), np.zeros(SHAPE)
    one[44:52, 44:52], other[44:52, 34:38] = 1 / 64, 1 / 32
    scale = (model.sum_of(other).moved - model.sum_of(one).moved)[-1]
    assert scale == pytest.approx(1e-3 * 0.33, rel=0.03)
    number = np.array([48 * SHAPE[1] + 48]), np.array([48 * SHAPE[1] + 36])
    a, b, both = (model.covariance(i, j)[0] for i, j in ((number[0],) * 2, (number[1],) * 2, number))
    depth = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.33e-3])
    depth[3:5] = 0.0, -3e-4 * 0.12  # the rotation over twelve cells
    local = float(model.heights.local[48, 48]) ** 2 + float(model.heights.local[48, 36]) ** 2
    assert a + b - 2 * both == pytest.approx(float(depth @ depth) + local, rel=0.1)


def test_shifts_in_plan_do_not_move_a_wall_that_is_flat_but_for_noise():
    """A shift by 2 mm, 1 mm of noise in cells of 1 cm: neighbours' slopes are of noise, and no shift moves these."""
    rng = np.random.default_rng(3)
    model = told(rng, 1e-3, lambda x, y: (100 + 0.5 * x - 0.2 * y, 0 * x + 0.5, 0 * x - 0.2))
    h = model.heights
    right, up = slopes_of_surface(h.height, h.local, CELL)
    assert np.abs(right - 0.5).max() < 0.03
    assert np.abs(up + 0.2).max() < 0.03
    moved = np.sqrt(variances(model.moved[..., 1:3], BLOCK, SHAPE, factors=model.factors))
    assert np.abs(moved / (2e-3 * np.hypot(0.5, 0.2)) - 1).max() < 0.05


def test_a_step_is_no_slope():
    rng = np.random.default_rng(4)
    x, _ = middles()
    z = np.where(x > 0.605, 0.3, 0.0).reshape(SHAPE) + 0.1 * x.reshape(SHAPE)
    z += rng.normal(0, 3e-4, SHAPE)
    right, up = slopes_of_surface(z, np.full(SHAPE, 3e-4), CELL)
    assert np.abs(right - 0.1).max() < 0.05
    assert np.abs(up).max() < 0.05
    z[20:40, 50:70] = np.nan
    right, up = slopes_of_surface(z, np.full(SHAPE, 3e-4), CELL)
    assert np.isfinite(right).all()
    assert not right[20:40, 50:70].any()
    assert np.abs(right - 0.1)[np.isfinite(z)].max() < 0.05
    for shape in ((1, 1), (1, 7), (3, 2)):
        right, up = slopes_of_surface(np.zeros(shape), np.zeros(shape), CELL)
        assert not right.any()
        assert not up.any()


def test_heights_that_were_filled_or_replaced_move_by_their_own_slope_and_height():
    model = told(np.random.default_rng(5))
    hole = np.zeros(SHAPE, bool)
    hole[40:52, 60:72] = True
    h = model.heights
    open_ = replace(model, heights=replace(h, height=np.where(hole, np.nan, h.height)))
    found = spanned(with_factors(open_), hole)
    above = found.heights.height - at_cells(model.levels[..., None], BLOCK, SHAPE)
    assert np.allclose(found.factors[..., 1], above, atol=1e-6)
    kept = ~hole
    assert np.array_equal(found.factors[kept], with_factors(open_).factors[kept])
    assert np.abs(found.factors[45, 65, 2:]).max() > 0.01


def test_two_surfaces_of_one_adjustment_cancel_where_they_are_the_same():
    rng = np.random.default_rng(6)
    a, b = (replace(told(rng, 1e-5), errors="one", adjustment="one") for _ in range(2))
    d = difference(a, b)
    apart = difference(a, replace(b, errors="another"))
    w = next(windows())
    both = np.hypot(a.sum_of(w).orientation, b.sum_of(w).orientation)
    assert d.sum_of(w).orientation < 0.01 * both
    assert apart.sum_of(w).orientation == pytest.approx(both, rel=1e-4)
    # what was taken down by 0.2 moves by the scale of that
    lower = replace(b, heights=replace(b.heights, height=b.heights.height - np.float32(0.2)))
    d = difference(a, with_factors(lower))
    assert d.sum_of(w).orientation == pytest.approx(0.2e-3, rel=0.1)
    assert np.median(d.heights.orientation) == pytest.approx(0.2e-3, rel=0.1)


def test_the_ground_moves_against_what_stood_on_it_by_its_height_alone():
    model = replace(told(np.random.default_rng(7), 1e-5, lambda x, y: niche(x, y, -0.33)), errors="one")
    below, stands = ground(model, 24, 0.3)
    assert stands[48, 48]
    d = difference(below, model)
    orientation = d.heights.orientation
    assert orientation[48, 48] == pytest.approx(1e-3 * 0.33, rel=0.05)
    assert not orientation[~stands][np.abs(d.heights.height[~stands]) == 0].any()


def test_heights_at_cells_of_another_grid_move_as_they_did():
    model = told(np.random.default_rng(8))
    like = made(np.zeros((50, 60)), cell=2 * CELL)
    found = resampled(model, 4.5, 6.5, 2.0, like)
    known = np.isfinite(found.heights.height)
    at = np.ix_(np.arange(50) * 2 + 7, np.arange(60) * 2 + 5)
    there = known & (np.arange(50) * 2 + 7 < SHAPE[0])[:, None] & (np.arange(60) * 2 + 5 < SHAPE[1])
    some = np.argwhere(there)
    own = np.sqrt(variances(found.moved, BLOCK, (50, 60), factors=found.factors))
    before = np.sqrt(variances(model.moved, BLOCK, SHAPE, factors=model.factors))
    r, c = some.T
    assert np.allclose(own[r, c], before[at[0].ravel()[r], at[1].ravel()[c]], rtol=5e-3)


def test_what_errors_of_orientation_explain_is_taken_off():
    """Drawn errors of orientation, two millimetres in plan: nothing has moved."""
    rng = np.random.default_rng(9)
    model = told(rng, 2e-4)
    moves = exact() @ rng.normal(size=7)
    again = told(rng, 2e-4)
    h = again.heights
    other = replace(again, heights=replace(h, height=(h.height + moves).astype(np.float32)))
    found = movements(difference(model, other))
    assert not found.regions
    assert np.nanmax(np.abs(found.peak)) < found.limit
