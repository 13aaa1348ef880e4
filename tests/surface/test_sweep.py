"""Approximate depths: kernels beside their twins, and depths of the rendered portal beside its published points."""

from pathlib import Path

import cv2
import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.io.block.folder import read_block
from raybundle.numerics import native
from raybundle.surfaces.depths import sweep
from raybundle.surfaces.depths.pairs import sources_of_each
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.depths.sweep import NOWHERE, fixed
from raybundle.surfaces.depths.transfer import transfer
from tests.surface.census_oracle import ACROSS, DOWN, aggregate_twin, census_twin, costs_twin
from tests.surface.transfer_oracle import places_of

DEMO = Path(__file__).parents[2] / "demo_data"

compiled = pytest.mark.skipif(native.module() is None, reason="the twin alone is there: RAYBUNDLE_NATIVE=0")


def grey(rng, height, width):
    """Correlated grey values."""
    return cv2.GaussianBlur(rng.integers(0, 256, (height, width)).astype(np.uint8), (0, 0), 1.0)


@compiled
def test_kernels_are_their_twins_to_the_last_bit():
    rng = np.random.default_rng(1)
    h, w, levels, step = 21, 37, 16, sweep.STEP_PX
    image = grey(rng, h, w)
    reference = sweep._census(image)
    assert np.array_equal(reference, census_twin(image))
    assert (reference[:DOWN] == sweep.UNKNOWN).all()
    assert (reference[DOWN:-DOWN, ACROSS:-ACROSS] < sweep.UNKNOWN).all()
    rows, columns = len(np.arange(0, h + step, step)), len(np.arange(0, w + step, step))
    sources, places = [], []
    for k in range(3):
        sources.append(sweep._census(grey(rng, h + 5 * k, w + 9)))
        v, u = np.meshgrid(np.arange(rows) * step, np.arange(columns) * step, indexing="ij")
        at = np.stack([u, v], axis=-1) + 0.5 + np.linspace(-6, 9, levels)[:, None, None, None] * [1.0, 0.3 * k]
        at = at + rng.normal(0, 0.4, at.shape)
        at[3, 0, 0] = np.nan
        places.append(fixed(at))
    assert (places[0][3, 0, 0] == NOWHERE).all()
    cost = np.empty((h, w, levels), np.uint8)
    sweep._costs(reference, sources, places, cost)
    assert np.array_equal(cost, costs_twin(reference, sources, places, step))
    assert len(np.unique(cost)) > 10
    level, margin = sweep._aggregated(image, cost)
    theirs = aggregate_twin(image, cost, sweep.SLOPE, sweep.JUMP, sweep.LEAST)
    assert np.array_equal(level, theirs[0])
    assert np.array_equal(margin, theirs[1])


@compiled
def test_kernels_refuse_what_does_not_fit():
    module = native.module()
    cost, image = np.zeros((8, 9, 16), np.uint8), np.zeros((8, 9), np.uint8)
    level = np.zeros((8, 9), np.float32)
    with pytest.raises(ValueError, match="image's size"):
        module.aggregate_costs(image[:7].copy(), cost, 7, 50, 14, np.zeros(cost.shape, np.uint16), level, level.copy())
    with pytest.raises(ValueError, match="penalties"):
        module.aggregate_costs(image, cost, 7, 120, 14, np.zeros(cost.shape, np.uint16), level, level.copy())
    table = np.zeros((16, 2, 1, 2), np.int32)
    with pytest.raises(ValueError, match="do not cover"):
        module.sweep_costs(np.zeros((8, 9), np.uint64), [np.zeros((8, 9), np.uint64)], [table], 16, cost)


@pytest.fixture(scope="module")
def portal():
    """The rendered portal with its true orientation, and grey values of some of its photographs."""
    block = read_block(DEMO / "portal/truth")
    flags = cv2.IMREAD_GRAYSCALE | cv2.IMREAD_IGNORE_ORIENTATION
    return block, lambda k: cv2.imread(str(DEMO / "portal/photos" / block.images.file[k]), flags)


@pytest.mark.parametrize("image", ["portal_03", "portal_12", "portal_13"])  # the second and third are rolled
def test_depths_of_the_portal_are_those_of_its_points(portal, image):
    block, read = portal
    k = [f.removesuffix(".jpg") for f in block.images.file].index(image)
    o = block.observations
    mine = o.image == k
    xy, xyz = o.xy_px[mine], block.points.xyz[o.point[mine]]
    rays = ReferenceRays.of(block, k)
    t = rays.parameter(xy, xyz)
    between = float(t.min() / 1.15), float(t.max() * 1.15)
    chosen = sources_of_each(block)[k].sources
    tables = [transfer(block, rays, j, between) for j in chosen]
    found = sweep.swept(read(k), [read(j) for j in chosen], tables, scale=4)
    column, row = (np.floor(xy[:, i] / 4).astype(int) for i in (0, 1))
    there = found.t[row, column]
    known = np.isfinite(there)
    assert known.mean() > 0.75
    away = np.abs(there / t - 1)[known]
    # a reduced pixel is 0.4 % of the depth at these bases
    assert np.median(away) < 0.004
    assert (away < 0.02).mean() > 0.85
    assert 0.6 < np.isfinite(found.t).mean() <= 1.0


def test_a_grid_of_places_is_that_of_single_pixels(portal):
    block, _ = portal
    rays = ReferenceRays.of(block, 2)
    table = transfer(block, rays, 3, (0.15, 0.5))
    v, u, t = np.array([3.5, 400.5, 1100.5]), np.array([8.5, 700.5]), np.array([0.2, 0.31, 0.47])
    grid = sweep.on_grid(table, v, u, t)
    each = np.array([[[table.at(np.array([[x, y]]), np.array([w]))[0] for x in u] for y in v] for w in t])
    assert np.array_equal(np.isnan(grid), np.isnan(each))
    assert np.nanmax(np.abs(grid - each)) < 1e-9


@compiled
def test_places_are_those_of_the_twin(portal):
    block, _ = portal
    rng = np.random.default_rng(2)
    table = transfer(block, ReferenceRays.of(block, 2), 3, (0.15, 0.5))
    xy, t = rng.uniform(-20, 1650, (5000, 2)), rng.uniform(0.12, 0.55, 5000)
    t[7] = np.nan
    ours, theirs = table.at(xy, t), places_of(table, xy[:7], t[:7])
    assert np.isnan(ours[7]).all()
    assert np.allclose(ours[:7], theirs, rtol=0, atol=1e-9, equal_nan=True)
    rest = np.arange(8, 5000)
    assert np.allclose(ours[rest], places_of(table, xy[rest], t[rest]), rtol=0, atol=1e-9, equal_nan=True)
    assert np.isfinite(ours).any(axis=1).mean() > 0.3


def test_photographs_are_reduced_until_bands_of_costs_fit():
    assert sweep.reduction_for(1600, 1200, 400, 1e9) == 2
    assert sweep.reduction_for(8000, 6000, 2000, 1e9) == 2
    coarse = sweep.reduction_for(8000, 6000, 2000, 1e8)

    def rows(scale):
        return sweep.rows_at_once(8000 // scale, sweep.levels_of(2000 / scale), 1e8)

    assert rows(coarse - 1) < 4 * sweep.HALO <= rows(coarse)
    with pytest.raises(InputError, match=r"depth_map\.memory"):
        sweep.reduction_for(80000, 60000, 20000, 1e7)


@pytest.mark.parametrize(("height", "rows"), [(100, 100), (700, 256), (300, 299), (257, 200)])
def test_bands_count_each_row_once(height, rows):
    found = sweep.bands(height, rows)
    counted = np.concatenate([np.arange(begin, end) for _, begin, end, _ in found])
    assert np.array_equal(counted, np.arange(height))
    assert max(last - first for first, _, _, last in found) <= rows
    for first, begin, end, last in found:
        assert first == max(0, begin - sweep.HALO) or len(found) == 1
        assert last == min(height, end + sweep.HALO) or len(found) == 1


def test_depths_by_bands_are_those_of_all_rows(portal):
    block, read = portal
    chosen = sources_of_each(block)[2].sources[:2]
    rays = ReferenceRays.of(block, 2)
    o = block.observations
    mine = o.image == 2
    t = rays.parameter(o.xy_px[mine], block.points.xyz[o.point[mine]])
    tables = [transfer(block, rays, j, (float(t.min() / 1.15), float(t.max() * 1.15))) for j in chosen]
    photographs = [read(j) for j in chosen]
    whole = sweep.swept(read(2), photographs, tables, scale=4)
    memory = 200.0 * whole.t.shape[1] * whole.levels * sweep.ALONG
    parts = sweep.swept(read(2), photographs, tables, scale=4, memory=memory)
    both = np.isfinite(whole.t) & np.isfinite(parts.t)
    assert both.sum() > 0.97 * np.isfinite(whole.t).sum()
    away = np.abs(parts.t / whole.t - 1)[both]
    # a source is laid out anew for each band: by less than a reduced pixel
    assert np.median(away) < 0.001
    assert np.mean(away < 0.004) > 0.95


def test_one_photograph_has_no_surface():
    with pytest.raises(InputError, match=r"depth_map\.single_photograph"):
        sweep.swept(np.zeros((64, 64), np.uint8), [], [], scale=2)
