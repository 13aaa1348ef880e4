"""Depth maps of a wavy ground and of the rendered portal: depths, and their variances beside the errors."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from raybundle.block import Observations, Points
from raybundle.errors import InputError
from raybundle.surfaces.depths import filters, planes, roughness
from raybundle.surfaces.depths.depth_map import DepthMap, DepthOptions, depth_map, depth_range
from raybundle.surfaces.depths.filters import Flag
from raybundle.surfaces.depths.noise import autocovariance
from raybundle.surfaces.depths.refine import PixelGrid, Refined, Source, refine
from raybundle.surfaces.depths.sweep import Start
from tests.surface.scene import scene
from tests.surface.tied import CHOSEN, robust, with_tie_points

NOISE = 2.0


@pytest.fixture(scope="module")
def ground():
    return scene()


@pytest.fixture(scope="module")
def block(ground):
    return with_tie_points(ground)


@pytest.fixture(scope="module")
def greys(ground):
    rng = np.random.default_rng(4)
    noisy = [g + NOISE * rng.standard_normal(g.shape) for g in ground.grey]
    return [np.clip(np.round(g), 0, 255).astype(np.uint8) for g in noisy]


@pytest.fixture(scope="module")
def measured(block, greys):
    return depth_map(block, CHOSEN, greys.__getitem__, DepthOptions(density=1)).sure()


def test_depths_are_right_and_vary_as_stated(ground, measured):
    e = measured.t - measured.grid.of(ground.t)
    known = np.isfinite(measured.t)
    assert known.mean() > 0.75
    x = e[known] / np.sqrt(measured.variance())[known]
    assert 0.6 < robust(x) ** 2 < 1.4
    assert np.mean(np.abs(x) < 1.96) > 0.92
    assert np.mean(np.abs(x) > 5) < 0.005
    assert (measured.noise[known] > 0).all()
    assert (measured.roughness[known] >= 0).all()


def test_errors_of_neighbours_correlate_as_stated(ground, measured):
    x = (measured.t - measured.grid.of(ground.t)) / np.sqrt(measured.variance())
    x = np.where(np.abs(x) < 4, x, np.nan)
    distances = np.array([0, 1, 2, 3, 4, 6, 10])
    stated = measured.correlation_between(distances)
    assert stated[0] == pytest.approx(1)
    assert (np.diff(stated) < 0).all()
    for k, correlation in zip(distances[1:], stated[1:], strict=True):
        a, b = x[:, k:], x[:, :-k]
        both = np.isfinite(a) & np.isfinite(b)
        assert np.corrcoef(a[both], b[both])[0, 1] == pytest.approx(correlation, abs=0.15)


def test_points_lie_on_the_ground(block, measured):
    from tests.surface.scene import surface

    xyz = measured.points(block, 0)
    assert len(xyz) == np.isfinite(measured.t).sum()
    assert robust(xyz[:, 2] - surface(xyz[:, 0], xyz[:, 1])) < 0.03


def test_incidences_are_those_of_the_ground(block, measured):
    known = np.isfinite(measured.t)
    x, y, _ = measured.points(block, 0).T
    slope = np.stack(
        [-0.1 * np.cos(x / 1.5) * np.cos(y / 1.7), 0.15 / 1.7 * np.sin(x / 1.5) * np.sin(y / 1.7), np.ones(len(x))]
    )
    from raybundle.surfaces.depths.rays import ReferenceRays

    d = ReferenceRays.of(block, 0).rays(measured.grid.xy_px[known])[1].T
    cosine = -(slope * d).sum(axis=0) / np.linalg.norm(slope, axis=0) / np.linalg.norm(d, axis=0)
    assert robust(measured.incidence[known] - cosine) < 0.03


def test_a_map_is_kept_and_is_the_same_for_any_number_of_threads(block, greys):
    a, b = (depth_map(block, CHOSEN, greys.__getitem__, DepthOptions(density=4, threads=n)) for n in (1, 2))
    kept = DepthMap.of_arrays(a.as_arrays())
    assert kept.grid == a.grid
    assert kept.sources == a.sources
    for name, values in a.as_arrays().items():
        assert np.array_equal(values, b.as_arrays()[name], equal_nan=True)
        assert np.array_equal(values, kept.as_arrays()[name], equal_nan=True)


def test_a_map_by_strips_is_that_of_all_rows(block, greys, measured, monkeypatch):
    """To the last bit: growing reaches as far as strips overlap, and no local variance looks further."""
    monkeypatch.setattr("raybundle.surfaces.depths.levels.STRIP_BYTES", 1.0)
    for name in ("depth_map", "filters", "roughness"):
        monkeypatch.setattr(f"raybundle.surfaces.depths.{name}.ROWS", 7)
    parts = depth_map(block, CHOSEN, greys.__getitem__, DepthOptions(density=1)).sure()
    for name, values in measured.as_arrays().items():
        assert np.array_equal(values, parts.as_arrays()[name], equal_nan=values.dtype.kind == "f"), name


@pytest.mark.parametrize(("things", "rays", "reached"), [(3, 3, True), (2, 3, False), (3, 2, False)])
def test_depths_are_looked_for_as_far_as_three_points_of_three_rays(ground, things, rays, reached):
    """A chimney: far fewer than a hundredth of the tie points, half as far away as the ground."""
    xy = np.stack(np.meshgrid(np.arange(5, 155, 6.0), np.arange(5, 115, 5.0)), axis=-1).reshape(-1, 2)
    t = ground.t[xy[:, 1].astype(int), xy[:, 0].astype(int)].astype(float)
    t[:things] = 0.2
    n = len(xy)
    points = Points(
        ids=tuple(str(k) for k in range(n)), role=np.zeros(n, np.int32), xyz=ground.rays.points(xy, t),
        sigma=np.full((n, 3), np.nan),
    )  # fmt: skip
    seen = np.concatenate([np.arange(n) if k < rays else np.arange(things, n) for k in range(3)]).astype(np.int32)
    image = np.repeat([0, 1, 2], [n, n, n if rays == 3 else n - things]).astype(np.int32)
    observations = Observations(
        image=image, point=seen, xy_px=xy[seen], cov_px2=np.tile([1.0, 1, 0], (len(seen), 1))
    )  # fmt: skip
    block = replace(ground.block, points=points, observations=observations)
    low, high = depth_range(block, ground.rays, 0)
    assert low < ground.t.min()
    assert (high > 0.2) == reached


def test_what_cannot_be_measured_is_told(ground, block, greys):
    with pytest.raises(InputError, match=r"3.*depth_map\.density"):
        depth_map(block, CHOSEN, greys.__getitem__, DepthOptions(density=3))
    with pytest.raises(InputError, match=r"depth_map\.no_source"):
        depth_map(block, replace(CHOSEN, sources=()), greys.__getitem__)
    with pytest.raises(InputError, match=r"0.*depth_map\.too_few_points"):
        depth_map(ground.block, CHOSEN, greys.__getitem__)


def test_a_thing_that_juts_out_alone_is_doubtful(block, greys):
    """Another picture over 5 x 5 pixels: what is found there, if anything, does not agree with what is around."""
    hidden = greys[0].copy()
    hidden[58:63, 78:83] = np.random.default_rng(1).integers(0, 255, (5, 5))
    found = depth_map(block, CHOSEN, [hidden, *greys[1:]].__getitem__, DepthOptions(density=1))
    g = found.grid
    there = slice(58 - g.y0, 63 - g.y0), slice(78 - g.x0, 83 - g.x0)
    sure = found.sure()
    assert np.isnan(sure.t[there]).mean() > 0.5
    taken = (found.flags & filters.DOUBTFUL) > 0
    assert (taken == found.doubtful).all()
    assert np.isnan(sure.t[taken]).all()
    assert np.isfinite(found.t[taken]).all()
    # how far they may be off by: as far as their neighbours stand apart
    assert (found.variance()[taken] >= found.step[taken]).all()
    assert np.median(found.step[taken] / (found.noise + found.roughness)[taken]) > 1
    assert not found.step[~taken].any()


@pytest.mark.parametrize("stride", [1, 2, 4])
def test_depths_beside_a_step_say_how_far_apart_its_sides_stand(stride):
    """A ledge in a plane: its edge stays, with the step in its variance; a single pixel that wanders off goes."""
    n, sigma, step = 160 // stride, 1e-4, 2e-2
    x = np.arange(n) * stride
    t = 0.3 + 1e-5 * x + np.where(x < 80, 0.0, step) + np.zeros((n, 1))
    t[n // 4, n // 4] += step
    empty = np.zeros_like(t)
    slopes = np.stack([empty + 1e-5, empty])
    flags, more = filters.tested(t, slopes, empty + sigma**2, empty + 1, empty > 1, stride, None)
    taken = (flags & (Flag.LONELY | Flag.EDGE)) > 0
    assert taken[n // 4, n // 4]
    beside = np.abs(x - 80 + stride / 2) < 4
    row = n // 2
    assert not taken[row][~beside & (x > 8) & (x < 150)].any()
    doubtful = ~taken & (more > 0)
    assert np.allclose(np.sqrt(more[doubtful]), step, rtol=0.05)
    assert (flags[row][beside] & Flag.STEP).all()


@pytest.mark.parametrize("blur", [0.0, 0.7])
def test_correlation_of_the_noise_is_measured(ground, blur):
    rng = np.random.default_rng(2)

    def noise(shape):
        n = rng.standard_normal(shape)
        n = cv2.GaussianBlur(n, (0, 0), blur) if blur else n
        return 4.0 * n / n.std()

    grey = [(g + noise(g.shape)).astype(np.float32) for g in ground.grey]
    sources = [Source(grey=g, transfer=s.transfer) for g, s in zip(grey[1:], ground.sources, strict=True)]
    grid = ground.grid(2, 6)
    found = refine(grey[0], sources, grid, ground.start(grid))
    table = autocovariance(grey[0], sources, grid, found)
    assert table.shape == (5, 7, 7)
    assert (table[:, 3, 3] == 1).all()
    lags = np.arange(-3, 4)
    expected = np.exp(-(lags[:, None] ** 2 + lags**2) / (4 * blur**2)) if blur else np.outer(lags == 0, lags == 0)
    assert np.abs(table[0] - expected).max() < 0.12


def test_roughness_of_a_place_is_that_of_its_surroundings():
    """White relief, four times as high on one side, and a step, which few second differences cross."""
    rng = np.random.default_rng(3)
    sigma = np.where(np.arange(200) < 100, 1e-3, 4e-3)
    t = sigma * rng.standard_normal((80, 200))
    t[:, 150:] += 1.0
    found = roughness.local_roughness(t, np.full(t.shape, 1e-9), 4)
    for columns, height in ((slice(20, 80), 1e-3), (slice(120, 180), 4e-3)):
        assert np.median(found.square[:, columns]) == pytest.approx(6 * height**2, rel=0.15)
    assert np.median(found.power) < 0.5


def test_variance_of_a_place_is_that_of_its_power():
    rng = np.random.default_rng(4)
    side = np.arange(-3, 4)
    response = rng.uniform(0.8, 1.2, (6, 5, 49)) * np.exp(-np.add.outer(side**2, side**2) / 7).ravel()
    response = response.astype(np.float32)
    response /= response.sum(axis=-1, keepdims=True)
    for power in (roughness.LEAST_POWER, 1.0, roughness.MOST_POWER):
        of_lag = 8 * 8.0**power - 2 * 16.0**power
        square = np.full((4, 4), 3e-6 * of_lag, np.float32)
        rough = roughness.LocalRoughness(power=np.full((4, 4), power, np.float32), square=square, lag_px=8)
        at = np.ones((6, 5), int), np.ones((6, 5), int)
        assert rough.variance(at, response) == pytest.approx(3e-6 * roughness.of_window(response, power), rel=0.15)


def test_variance_of_a_window_is_that_of_draws():
    """Of an increment of weights over a random surface with |r|, as draws of it have it."""
    rng = np.random.default_rng(5)
    v, u = (x.ravel() for x in np.mgrid[:3, :3])
    r = np.hypot(u[:, None] - u, v[:, None] - v)
    # covariance of what is left of it without its mean
    M = np.eye(9) - 1 / 9
    C = -M @ r @ M
    draws = np.linalg.cholesky(C + 1e-9 * np.eye(9)) @ rng.standard_normal((9, 200_000))
    h = rng.uniform(0, 1, 9)
    h /= h.sum()
    error = draws[4] - h @ draws
    assert roughness.of_window(h[None].astype(np.float32), 1.0)[0] == pytest.approx(error.var(), rel=0.02)


@pytest.mark.parametrize("stride", [1, 2, 4])
def test_surfaces_of_second_degree_have_no_misfit(stride):
    x, y = np.meshgrid(np.arange(30.0) * stride, np.arange(20.0) * stride)
    t = 1 + 1e-3 * x - 2e-3 * y + 1e-5 * x * y + 3e-5 * y**2
    slopes = np.stack([1e-3 + 1e-5 * y, -2e-3 + 1e-5 * x + 6e-5 * y])
    found = roughness.misfits(t, slopes, stride)
    assert np.isfinite(found).all(axis=0).sum() > 100
    assert np.nanmax(np.abs(found)) < 1e-6
    assert np.isnan(roughness.of_neighbours(found)[~(np.isfinite(found).sum(axis=0) >= 3)]).all()


def test_local_variances_follow_neighbours_and_residuals():
    rng = np.random.default_rng(6)
    shape = 60, 80
    variance, brightness = np.full(shape, 4e-6), np.full(shape, 100.0)
    drawn = [4e-6 * rng.chisquare(8, shape) / 8 for _ in range(3)]
    shown = roughness.Witnesses(misfit=drawn[0], near=drawn[1], bend=drawn[2])
    residual = 9 * rng.chisquare(60, shape) / 60
    usual = roughness.local_factor(variance, shown, residual, brightness)
    assert np.median(usual) == pytest.approx(np.exp(roughness.LEFT / 2), rel=0.1)
    # below BEYOND times the usual variance residuals show nothing
    for times, expected in ((1.5, 1.0), (8.0, (8.0 / roughness.BEYOND) ** roughness.BY_RESIDUAL)):
        rough = roughness.local_factor(
            variance, shown, np.where(np.arange(60)[:, None] == 20, times, 1) * residual, brightness
        )
        assert np.median((rough / usual)[20]) == pytest.approx(expected, rel=0.05)
    for name, exponent in (("misfit", roughness.BY_MISFIT), ("near", roughness.BY_NEAR), ("bend", roughness.BY_BEND)):
        values = getattr(shown, name).copy()
        values[40:50] *= 10
        apart = roughness.local_factor(variance, replace(shown, **{name: values}), residual, brightness)
        assert np.median((apart / usual)[42:48]) == pytest.approx(10**exponent, rel=0.1)
    # a sensor whose noise grows with the brightness tells nothing of the surface
    brightness[:, 40:] = 200
    residual = np.where(brightness > 150, 36.0, 9.0) * rng.chisquare(60, shape) / 60
    both = roughness.local_factor(variance, shown, residual, brightness)
    assert np.median(both[:, 40:]) == pytest.approx(np.median(both[:, :40]), rel=0.1)


@pytest.mark.parametrize("stride", [1, 2])
def test_neighbours_show_creases_and_waves_within_windows(stride):
    """Slopes differ across a crease; what waves within windows stands out among near neighbours."""
    x = np.arange(120.0) * stride
    crease = 40.0 * stride
    wave = np.where(x > 60 * stride, 1e-3 * np.cos(np.pi * x / 4), 0.0)
    t = np.tile(1e-2 * np.abs(x - crease) + wave, (40, 1)).astype(np.float32)
    slope = np.tile(1e-2 * np.clip((x - crease) / 4, -1, 1), (40, 1)).astype(np.float32)
    shown = roughness.witnesses(t, np.stack([slope, np.zeros_like(slope)]), stride)
    even, bent, rough = 20, 40, 100
    assert np.median(shown.bend[10:30, bent]) == pytest.approx((roughness.APART_PX * 1e-2) ** 2, rel=1e-3)
    assert np.median(shown.bend[10:30, even]) == 0
    assert np.median(shown.near[10:30, rough]) > 1e-7
    assert np.median(shown.near[10:30, even]) < 1e-12


def test_planes_keep_to_what_they_stand_on():
    x, y = np.meshgrid(np.arange(40.0), np.arange(30.0))
    t = np.where(x < 20, 0.3 + 1e-4 * x, 0.2 + 2e-4 * y)
    found = planes.fitted(t, 1e-3)
    assert np.allclose(found[1, :, 3:18], 1e-4, atol=1e-6)
    assert np.allclose(found[2, 3:-3, 22:], 2e-4, atol=1e-6)
    assert np.allclose(found[0], t, atol=1e-6)
    start = Start(t=t.astype(np.float32), scale=2, levels=300)
    grid = PixelGrid(x0=10, y0=10, stride=1, rows=10, columns=10)
    assert np.allclose(planes.of_start(start, grid)[0], 0.3 + 1e-4 * (grid.xy_px[..., 0] / 2 - 0.5), atol=1e-6)


def test_planes_of_refined_pixels_go_on_between_them():
    coarse = PixelGrid(x0=3, y0=3, stride=4, rows=6, columns=6)
    x, y = coarse.xy_px[..., 0], coarse.xy_px[..., 1]
    numbers = np.zeros((9, 6, 6), np.float32)
    numbers[0], numbers[1], numbers[2], numbers[7] = 1 + 1e-3 * x - 2e-3 * y, 1e-3, -2e-3, 0.9
    reason = np.zeros((6, 6), np.uint8)
    reason[2, 2] = 4
    found = Refined(
        numbers=numbers, reason=reason, iterations=reason, views=np.ones((6, 6), np.int32),
        shift=np.zeros((6, 6, 1, 2), np.float32), left=np.ones(2), response=None,
    )  # fmt: skip
    fine = PixelGrid(x0=3, y0=3, stride=1, rows=21, columns=21)
    t = planes.of_refined(found, coarse, fine)
    expected = 1 + 1e-3 * fine.xy_px[..., 0] - 2e-3 * fine.xy_px[..., 1]
    known = np.isfinite(t[0])
    assert known.sum() == known.size - 1
    assert np.allclose(t[0][known], expected[known], atol=1e-6)


@pytest.mark.long
def test_a_map_of_the_portal_is_as_good_as_it_says(truth):
    from raybundle.surfaces.depths.pairs import sources_of_each
    from tests.surface.portal import grey

    chosen = sources_of_each(truth.block)[12]  # a rolled one
    every = depth_map(truth.block, chosen, lambda k: grey(truth.block, k).astype(np.uint8), DepthOptions(density=4))
    found = every.sure()
    exact = found.grid.of(truth.depths(12).t)
    known = np.isfinite(found.t) & np.isfinite(exact)
    assert known.sum() / np.isfinite(exact).sum() > 0.6
    assert np.isfinite(every.t - exact).sum() / np.isfinite(exact).sum() > 0.75
    x = ((found.t - exact) / np.sqrt(found.variance()))[known]
    assert 0.6 < robust(x) ** 2 < 1.25
    assert np.mean(np.abs(x) < 1.96) > 0.91
    assert np.mean(np.abs(x) > 5) < 0.012
    depth = (1 / found.t - 1 / exact)[known]
    assert robust(depth) < 0.9e-3
    assert np.mean(np.abs(depth) < 0.02) > 0.99
