"""Refined depths: right, as precise as they say, the kernel as its twin, and a reason where there is none."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.numerics import native
from raybundle.surfaces.depths import refine as module
from raybundle.surfaces.depths.refine import NUMBERS, PixelGrid, Reason, RefineOptions, Source, grow, refine
from tests.surface import scene
from tests.surface.refine_oracle import refine_rows

needs_kernel = pytest.mark.skipif(not native.available(), reason="the kernels are not built")
OPTIONS = RefineOptions(step=0.01, iterations=12)


@pytest.fixture(scope="module")
def ground():
    return scene.scene()


def errors_px(s, grid, found):
    return ((found.t - grid.of(s.t)) * s.reach())[found.found]


def noisy(s, sigma, seed):
    """Reference and sources with white noise."""
    rng = np.random.default_rng(seed)
    more = [g + sigma * rng.standard_normal(g.shape).astype(np.float32) for g in s.grey]
    return more[0], [Source(grey=g, transfer=q.transfer) for g, q in zip(more[1:], s.sources, strict=True)]


@pytest.mark.parametrize("model", scene.VALUES)
def test_depths_are_found_with_every_sensor(model):
    s = scene.scene(model)
    grid = s.grid(3, 10)
    found = refine(s.grey[0], s.sources, grid, s.start(grid, 0.3))
    e = errors_px(s, grid, found)
    assert found.found.mean() > 0.9
    # interpolation of grey values and the curvature of the ground are left
    assert np.sqrt(np.mean(e**2)) < 0.04
    slopes = (found.slopes - [grid.of(q) for q in s.slopes])[:, found.found] * s.reach()
    assert np.sqrt(np.mean(slopes**2)) < 0.02


@pytest.mark.parametrize("on", [pytest.param(True, marks=needs_kernel), False])
def test_windows_that_reach_where_nothing_may_be_measured_are_not_used(ground, monkeypatch, on):
    """Grey values there are NaN, of the reference and of sources; elsewhere nothing changes."""
    if not on:
        monkeypatch.setattr(module, "_run", by_oracle)
    grid = ground.grid(9)
    start = ground.start(grid, 0.3)
    whole = refine(ground.grey[0], ground.sources, grid, start)
    height, width = ground.grey[0].shape
    grey = ground.grey[0].copy()
    grey[:, : width // 3] = np.nan
    sources = list(ground.sources)
    hidden = sources[0].grey.copy()
    hidden[: height // 2] = np.nan
    sources[0] = replace(sources[0], grey=hidden)
    found = refine(grey, sources, grid, start)
    x = grid.xy_px[..., 0]
    assert not found.found[x < width // 3 + 3].any()
    assert whole.found[x < width // 3 + 3].any()
    away = whole.found & (x > width // 3 + 4)
    assert found.found[away].mean() > 0.95
    first = found.views & 1
    assert first[found.found].any()
    assert not first[found.found].all()
    same = away & found.found & (found.views == whole.views)
    assert same.any()
    assert np.array_equal(found.numbers[:, same], whole.numbers[:, same])
    assert np.isfinite(found.numbers[:, found.found]).all()
    assert np.isfinite(found.shift).all()


def by_oracle(work, found, todo, chain):
    """In place of `refine._run`."""
    refine_rows(work.reference, work.sources, work.grid, work.options, work.autocovariance, found, todo, chain)


@needs_kernel
@pytest.mark.parametrize("chain", [0, 1, -1])
@pytest.mark.parametrize("coloured", [False, True])
def test_kernel_is_its_oracle(ground, monkeypatch, chain, coloured):
    grey, sources = noisy(ground, 3.0, 1)
    sources[2] = replace(sources[2], grey=sources[2].grey[:, ::-1])  # shows something else
    grid = ground.grid(9)
    start = ground.start(grid, 1.5)
    if chain:
        start[:, :, 3:6] = np.nan
    start[1:, 2] = np.nan
    lag = np.abs(np.arange(-3, 4.0))
    cov = np.tile(0.5 ** np.add.outer(lag, lag), (5, 1, 1)) if coloured else None
    work = module._Work.of(grey, sources, grid, OPTIONS, cov, 1)
    found = []
    for on in (True, False):
        result = module._empty(work, start, response=True)
        if not on:
            monkeypatch.setattr(module, "_run", by_oracle)
        module._run(work, result, np.ones((grid.rows, grid.columns), np.uint8), chain)
        found.append(result)
    kernel, twin = found
    same = kernel.reason == twin.reason
    # a limit may be met on one side in single precision
    assert same.mean() > 0.99
    good = kernel.found & twin.found & (kernel.views == twin.views) & (kernel.iterations == twin.iterations)
    assert good.sum() > 0.5 * good.size
    for k, name in enumerate(NUMBERS):
        a, b = kernel.numbers[k][good], twin.numbers[k][good]
        assert np.quantile(np.abs(a - b) / np.median(np.abs(b)), 0.98) < 1e-3, name
    assert np.allclose(kernel.response[good], twin.response[good], atol=2e-3)
    assert np.quantile(np.abs(kernel.shift - twin.shift)[good], 0.99) < 1e-4 * np.abs(twin.shift[good]).max()
    assert len(set(kernel.reason.ravel())) > 2


@pytest.mark.parametrize("chain", [0, 1, -1])
def test_oracle_has_a_reason_where_no_pixel_can_be_refined(ground, monkeypatch, chain):
    """As in columns that no refined neighbour reaches, or of grey values that are all alike."""
    monkeypatch.setattr(module, "_run", by_oracle)
    grid = ground.grid(9)
    nowhere = np.full((3, grid.rows, grid.columns), np.nan, np.float32)
    work = module._Work.of(ground.grey[0], ground.sources, grid, OPTIONS, None, 1)
    all_of_it = np.ones((grid.rows, grid.columns), np.uint8)
    for start, grey, reason in (
        (nowhere, ground.grey[0], Reason.NO_START),
        (ground.start(grid), np.full_like(ground.grey[0], 100.0), Reason.NO_TEXTURE),
    ):
        found = module._empty(work, start, response=True)
        module._run(replace(work, reference=grey), found, all_of_it, chain)
        assert (found.reason == reason).all()
        assert np.array_equal(found.numbers[:3], start, equal_nan=True)


@needs_kernel
@pytest.mark.parametrize("part", [False, True])
def test_pixels_grow_with_the_twin_as_with_the_kernel(ground, monkeypatch, part):
    """From few starts, so that whole columns have none; with a part that alone is wanted, too."""
    grey, sources = noisy(ground, 3.0, 1)
    grid = ground.grid(8)
    start = np.full((3, grid.rows, grid.columns), np.nan, np.float32)
    start[:, 2::5, 3::7] = ground.start(grid, 0.3)[:, 2::5, 3::7]
    wanted = None
    if part:
        wanted = np.zeros((grid.rows, grid.columns), bool)
        wanted[:9, :13] = True
    found = []
    for on in (True, False):
        if not on:
            monkeypatch.setattr(module, "_run", by_oracle)
        first = refine(grey, sources, grid, start, OPTIONS, response=True, wanted=wanted)
        found.append(grow(grey, sources, grid, first, OPTIONS, passes=6, wanted=wanted))
    kernel, twin = found
    # a limit may be met on one side in single precision, and neighbours go on from there
    assert (kernel.reason == twin.reason).mean() > 0.97
    good = kernel.found & twin.found & (kernel.views == twin.views) & (kernel.iterations == twin.iterations)
    inner = np.ones_like(good) if wanted is None else wanted
    assert good[inner].mean() > 0.8
    assert not twin.found[~inner].any()
    for k, name in enumerate(NUMBERS):
        a, b = kernel.numbers[k][good], twin.numbers[k][good]
        assert np.quantile(np.abs(a - b) / np.median(np.abs(b)), 0.95) < 1e-3, name
    assert np.allclose(kernel.response[good], twin.response[good], atol=2e-3)


@needs_kernel
def test_threads_make_the_same_bits(ground):
    grid = ground.grid(2)
    start = ground.start(grid, 0.5)
    start[0, ::3, ::2] = np.nan
    results = []
    for threads in (1, 3):
        first = refine(ground.grey[0], ground.sources, grid, start, response=True, threads=threads)
        results.append(grow(ground.grey[0], ground.sources, grid, first, threads=threads))
    one, many = results
    for name in ("numbers", "reason", "views", "iterations", "shift", "response"):
        assert np.array_equal(getattr(one, name), getattr(many, name), equal_nan=name == "numbers"), name


def test_added_noise_moves_depths_as_much_as_is_stated(ground):
    """And not as much as the normal matrix promises: noise in the gradients passes for information there."""
    grid = ground.grid(2)
    start = ground.start(grid, 0.2)
    amplitude = 9.0
    runs = [refine(*noisy(ground, amplitude, seed), grid, start) for seed in (1, 2)]
    same = runs[0].found & runs[1].found & (runs[0].views == runs[1].views)
    assert same.sum() > 1000
    difference = (runs[0].t - runs[1].t)[same].astype(float)
    stated = sum((amplitude / r.contrast) ** 2 * r.noise * r.inflation**2 for r in runs)[same]
    promised = sum((amplitude / r.contrast) ** 2 * r.noise for r in runs)[same]
    assert 0.9 < np.mean(difference**2 / stated) < 1.1
    assert np.mean(difference**2 / promised) > 1.5
    # the residuals tell how large the noise was
    variance = (runs[0].grey_variance * runs[0].contrast ** 2)[same]
    assert np.median(variance) == pytest.approx(amplitude**2, rel=0.15)


def test_noise_that_is_correlated_weighs_more(ground):
    import cv2

    grid = ground.grid(3)
    start = ground.start(grid, 0.2)
    kernel = cv2.getGaussianKernel(7, 0.8) @ cv2.getGaussianKernel(7, 0.8).T
    lags = cv2.filter2D(np.pad(kernel, 6), -1, kernel, borderType=cv2.BORDER_CONSTANT)[6:13, 6:13]
    cov = np.tile(lags / lags[3, 3], (5, 1, 1))
    amplitude = 4.0
    runs = []
    for seed in (1, 2):
        rng = np.random.default_rng(seed)
        noise = [cv2.filter2D(rng.standard_normal(g.shape), -1, kernel) for g in ground.grey]
        grey = [
            (g + amplitude / np.sqrt((kernel**2).sum()) * n).astype(np.float32)
            for g, n in zip(ground.grey, noise, strict=True)
        ]
        sources = [Source(grey=g, transfer=q.transfer) for g, q in zip(grey[1:], ground.sources, strict=True)]
        runs.append((refine(grey[0], sources, grid, start, autocovariance=cov), refine(grey[0], sources, grid, start)))
    (a, white_a), (b, white_b) = runs
    same = a.found & b.found & (a.views == b.views)
    e2 = (a.t - b.t)[same].astype(float) ** 2
    chi2, white = (
        np.mean(e2 / sum((amplitude / r.contrast) ** 2 * r.noise * r.inflation**2 for r in pair)[same])
        for pair in ((a, b), (white_a, white_b))
    )
    assert 0.85 < chi2 < 1.15
    assert white > 1.5


def test_white_noise_is_an_autocovariance_without_lags(ground):
    grid = ground.grid(6)
    one = np.zeros((5, 7, 7))
    one[:, 3, 3] = 1
    plain = refine(ground.grey[0], ground.sources, grid, ground.start(grid))
    given = refine(ground.grey[0], ground.sources, grid, ground.start(grid), autocovariance=one)
    f = plain.found
    # turned lags take part of their neighbours
    assert np.allclose(plain.noise[f], given.noise[f], rtol=0.3)
    assert np.median(given.noise[f] / plain.noise[f]) == pytest.approx(1, abs=0.15)


def test_a_source_that_lies_elsewhere_moves_depths_as_is_stated(ground):
    grid = ground.grid(4, 12)
    options = RefineOptions(step=1e-4, iterations=30)
    before = refine(ground.grey[0], ground.sources, grid, ground.start(grid), options)
    for k, s in ((0, 1), (1, 2)):
        moved = list(ground.sources)
        offset = np.zeros(2)
        offset[k] = 0.05
        moved[s] = replace(moved[s], transfer=replace(moved[s].transfer, places=moved[s].transfer.places + offset))
        after = refine(ground.grey[0], moved, grid, ground.start(grid), options)
        good = before.found & after.found & (before.views == after.views) & (before.views >> s & 1 == 1)
        expected, seen = 0.05 * before.shift[good][:, s, k], (after.t - before.t)[good]
        assert np.corrcoef(expected, seen)[0, 1] > 0.98
        assert (expected @ seen) / (expected @ expected) == pytest.approx(1, abs=0.05)


def test_tables_that_are_shifted_as_by_a_larger_depth_parameter_make_it_smaller_by_as_much(ground):
    grid = ground.grid(4, 12)
    found = refine(ground.grey[0], ground.sources, grid, ground.start(grid))
    f = found.found
    xy, t, h = grid.xy_px[f], found.t[f].astype(float), 1e-5 * float(np.median(found.t[f]))
    by_t = np.stack([(s.transfer.at(xy, t + h) - s.transfer.at(xy, t - h)) / (2 * h) for s in ground.sources], axis=1)
    total = (found.shift[f] * np.nan_to_num(by_t)).sum(axis=(1, 2))
    assert np.median(total) == pytest.approx(-1, abs=1e-3)


def test_responses_leave_planes_as_they_are(ground):
    grid = ground.grid(5)
    found = refine(ground.grey[0], ground.sources, grid, ground.start(grid), replace(OPTIONS, slope=1e3), response=True)
    h = found.response[found.found].reshape(-1, 7, 7)
    u = np.arange(-3, 4)
    assert np.allclose(h.sum(axis=(1, 2)), 1, atol=1e-4)
    assert np.abs((h * u).sum(axis=(1, 2))).max() < 1e-3
    assert np.abs((h * u[:, None]).sum(axis=(1, 2))).max() < 1e-3


def test_pixels_without_a_start_take_their_neighbours_planes(ground):
    grid = ground.grid(2, 12)
    start = np.full((3, grid.rows, grid.columns), np.nan, np.float32)
    start[:, ::12, ::12] = ground.start(grid, 0.3)[:, ::12, ::12]
    first = refine(ground.grey[0], ground.sources, grid, start)
    assert first.found.mean() < 0.02
    grown = grow(ground.grey[0], ground.sources, grid, first, passes=16)
    assert grown.found.mean() > 0.95
    assert np.sqrt(np.mean(errors_px(ground, grid, grown) ** 2)) < 0.05
    assert np.array_equal(grown.numbers[:, first.found], first.numbers[:, first.found])


def test_a_reason_is_given_where_there_is_no_depth(ground):
    grid = PixelGrid(x0=0, y0=60, stride=1, rows=1, columns=60)
    start = ground.start(grid)
    start[0, 0, 20] = np.nan
    found = refine(ground.grey[0], ground.sources, grid, start)
    assert (found.reason[0, :3] == Reason.LEFT_IMAGE).all()
    assert found.reason[0, 20] == Reason.NO_START
    middle = PixelGrid(x0=70, y0=50, stride=2, rows=10, columns=10)
    start = ground.start(middle)
    flat = np.full_like(ground.grey[0], 100.0)
    rng = np.random.default_rng(1)
    other = [replace(s, grey=rng.normal(120, 20, s.grey.shape)) for s in ground.sources]
    dull = [replace(s, grey=flat[: len(s.grey)]) for s in ground.sources]

    def reasons(reference, sources, start, options=None):
        return refine(reference, sources, middle, start, options).reason

    assert (reasons(flat, ground.sources, start) == Reason.NO_TEXTURE).all()
    assert (reasons(ground.grey[0], dull, start) == Reason.NO_TEXTURE).all()
    assert (reasons(ground.grey[0], other, start) == Reason.NO_CORRELATION).mean() > 0.9
    beyond = start.copy()
    beyond[0] = 0.5
    assert (reasons(ground.grey[0], ground.sources, beyond) == Reason.LEFT_IMAGE).all()
    far = ground.start(middle)
    far[0] += 1.5 / ground.reach()
    assert (reasons(ground.grey[0], ground.sources, far, RefineOptions(reach=0.5)) == Reason.MOVED_FAR).mean() > 0.5
    hasty = RefineOptions(iterations=1, step=1e-6)
    assert (reasons(ground.grey[0], ground.sources, start, hasty) == Reason.NO_CONVERGENCE).all()
    strict = RefineOptions(share=1.5)
    assert (reasons(ground.grey[0], ground.sources, start, strict) == Reason.NO_CURVATURE).all()


def test_brightness_and_contrast_do_not_matter(ground):
    grid = ground.grid(6)
    darker = [replace(s, grey=(30 + 0.5 * s.grey).astype(np.float32)) for s in ground.sources]
    a = refine(ground.grey[0], ground.sources, grid, ground.start(grid))
    b = refine(ground.grey[0], darker, grid, ground.start(grid))
    both = a.found & b.found
    assert both.mean() > 0.9
    assert np.abs(a.t - b.t)[both].max() * ground.reach() < 1e-3


def test_arrays_that_do_not_fit_are_refused(ground):
    grid = ground.grid(6)
    start = ground.start(grid)
    with pytest.raises(InputError, match=r"0.*depth_map\.source_count"):
        refine(ground.grey[0], [], grid, start)
    with pytest.raises(InputError, match=r"starts.*depth_map\.array_shape"):
        refine(ground.grey[0], ground.sources, grid, start[:, 1:])
    with pytest.raises(InputError, match=r"autocovariances.*depth_map\.array_shape"):
        refine(ground.grey[0], ground.sources, grid, start, autocovariance=np.ones((2, 7, 7)))
    with pytest.raises(InputError, match=r"depth_map\.grid_outside"):
        refine(ground.grey[0], ground.sources, replace(grid, x0=150), start)


@pytest.mark.parametrize("stride", [1, 2, 3, 5])
def test_a_grid_over_an_image_leaves_its_margin(stride):
    for height, width in ((9, 20), (8, 8), (7, 31), (30, 9), (2, 40)):
        grid = PixelGrid.over(np.zeros((height, width)), stride, 4)
        places = [len(range(4, n - 4, stride)) for n in (height, width)]
        assert [grid.rows, grid.columns] == places
        assert (grid.x0, grid.y0, grid.stride) == (4, 4, stride)


def test_interpolated_noise_has_the_covariance_of_the_cubic_kernel():
    """Integrals of h(x) h(x + k), h the kernel of Keys 1981; what does not change from pixel to pixel stays whole."""
    x = np.linspace(-2, 2, 40_001)
    near, far = np.abs(x) <= 1, np.abs(x) > 1
    h = near * (1.5 * np.abs(x) ** 3 - 2.5 * x**2 + 1)
    h += far * (-0.5 * np.abs(x) ** 3 + 2.5 * x**2 - 4 * np.abs(x) + 2)
    expected = [np.trapezoid(h * np.interp(x + k, x, h, left=0, right=0), x) for k in range(-3, 4)]
    lags = module.interpolated_lags()
    np.testing.assert_allclose(lags, expected, atol=2e-4)
    assert lags.sum() == pytest.approx(1)
    f = np.linspace(0, 1, 11)
    weight, slope = module.cubic(f)
    places = np.arange(-1, 3)
    for power in range(3):  # exact for parabolas
        np.testing.assert_allclose(weight @ places**power, f**power, atol=1e-12)
        np.testing.assert_allclose(slope @ places**power, power * f ** max(power - 1, 0), atol=1e-12)
    white = np.zeros((3, 7, 7))
    white[:, 3, 3] = 1
    left = module.left_by_interpolation(None, 3)
    np.testing.assert_allclose(left, [1, expected[3] ** 2, expected[3] ** 2], atol=2e-4)
    np.testing.assert_allclose(module.left_by_interpolation(white, 3), left)
    np.testing.assert_allclose(module.left_by_interpolation(np.ones((3, 7, 7)), 3), 1)


def test_the_variance_of_a_grey_value_is_that_of_the_residuals_before_interpolation(ground):
    """Residuals of noise of variance s^2 have s^2 in the reference, and what interpolation leaves of it elsewhere."""
    grid = ground.grid(9)
    found = refine(ground.grey[0], ground.sources, grid, ground.start(grid))
    assert len(found.left) == 5
    for views, of in ((0b0001, [1]), (0b1010, [2, 4]), (0b1111, [1, 2, 3, 4])):
        left = np.array([1.0, 0.9, 0.6, 0.5, 0.4])
        residual = 7.0 * left[[0, *of]].mean()
        numbers = found.numbers.copy()
        numbers[6] = residual
        whole = replace(found, numbers=numbers, left=left, views=np.full_like(found.views, views))
        np.testing.assert_allclose(whole.grey_variance, 7.0, rtol=1e-6)


def test_correlation_contrast_and_slopes_are_those_of_the_pictures(ground):
    grid = ground.grid(9)
    found = refine(ground.grey[0], ground.sources, grid, ground.start(grid))
    f = found.found
    assert (found.correlation[f] > RefineOptions().correlation).all()
    assert (found.correlation[f] <= 1 + 1e-6).all()
    assert np.median(found.correlation[f]) > 0.95  # pictures without noise
    flat = [replace(s, grey=(30 + 0.5 * s.grey).astype(np.float32)) for s in ground.sources]
    half = refine((0.5 * ground.grey[0]).astype(np.float32), flat, grid, ground.start(grid))
    both = f & half.found
    np.testing.assert_allclose(half.contrast[both], 0.5 * found.contrast[both], rtol=1e-4)
    np.testing.assert_allclose(half.correlation[both], found.correlation[both], atol=1e-3)


@pytest.mark.parametrize("on", [pytest.param(True, marks=needs_kernel), False])
@pytest.mark.parametrize("last", [False, True])
def test_one_pass_goes_forth_along_the_rows_and_the_next_one_back(ground, monkeypatch, last, on):
    """From one row or column at an edge: all in the direction of the pass, beside it a neighbour a pass."""
    if not on:
        monkeypatch.setattr(module, "_run", by_oracle)
    grid = ground.grid(6, 14)
    start = np.full((3, grid.rows, grid.columns), np.nan, np.float32)
    edge = (slice(None), slice(None), -1 if last else 0)
    start[edge] = ground.start(grid, 0.2)[edge]
    first = refine(ground.grey[0], ground.sources, grid, start)
    shares = [
        grow(ground.grey[0], ground.sources, grid, first, passes=passes).found.mean() for passes in (1, 2)
    ]  # fmt: skip
    assert (shares[0] > 0.8) == (not last), shares
    assert shares[1] > 0.8
