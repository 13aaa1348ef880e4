"""Subsets of digital image correlation: followed wherever they go, as precise as stated, or with a reason."""

import numpy as np
import pytest

from raybundle.matching.spline_pictures import Picture
from raybundle.matching.subset_noise import overlap_correlation
from raybundle.matching.subsets import State, SubsetGrid, follow, window_options
from raybundle.numerics.statistics import mahalanobis2
from tests.matching.specimen import HEIGHT, MIDDLE, TEXTURE, WIDTH, deformed, found, image, motion, moved

BIAS_PX = 0.005
CASES = {
    "shift": (motion(shift=(0.37, -0.21)), {}),
    "large": (motion(shift=(23.4, -11.7)), {}),
    "rotation": (motion(10.0, shift=(3.2, -7.1)), {}),
    "half a turn": (motion(175.0), {}),
    "strain": (motion(strain=(0.05, -0.02, 0.01), shift=(1.3, 0.1)), {}),
    "darker": (motion(strain=(0.004, -0.001, 0.0), shift=(0.6, 0.4)), {"level": 80.0, "contrast": 22.0}),
    "noisier": (motion(shift=(0.25, 0.5)), {"noise": 6.0}),
}


@pytest.fixture(scope="module")
def reference():
    return image(1)


@pytest.mark.parametrize("name", CASES)
def test_displacements_are_as_true_as_stated(reference, name):
    (F, shift), light = CASES[name]
    grid, f = found(reference, deformed(2, F, shift, **light))
    good = f.state == State.FOLLOWED
    inside = (np.abs(moved(grid.xy_px, F, shift) - MIDDLE) < MIDDLE - 20).all(axis=1)
    assert good[inside].mean() > 0.99
    assert set(np.unique(f.state[~good])) <= {State.OUTSIDE, State.UNSTEADY, State.UNREACHED, State.UNLIKE}
    error = (f.xy_px - moved(grid.xy_px, F, shift))[good]
    # windows overlap: of n displacements a quarter is independent
    sigma = np.sqrt(np.trace(f.cov_px2[good], axis1=1, axis2=2).mean() / 2)
    assert np.abs(error.mean(axis=0)).max() < BIAS_PX / 5 + 3 * sigma / np.sqrt(good.sum() / 4)
    assert 0.85 < mahalanobis2(error, f.cov_px2[good]).mean() / 2 < 1.15


def test_noise_of_each_image_is_estimated(reference):
    F, shift = motion(shift=(0.3, 0.4))
    for noise in (1.0, 2.0, 6.0):
        _, f = found(reference, deformed(2, F, shift, noise=noise))
        expected = np.hypot([2.0, noise], 12**-0.5)
        np.testing.assert_allclose(np.nanmedian(f.noise, axis=0), expected, rtol=0.12, atol=0.15)


def developed(how, grey):
    """As a camera writes it: compressed, or interpolated from a mosaic of colours."""
    import cv2

    if how == "mosaic":
        return cv2.cvtColor(cv2.cvtColor(grey, cv2.COLOR_BayerBG2RGB), cv2.COLOR_RGB2GRAY)
    return cv2.imdecode(cv2.imencode(".jpg", grey, [cv2.IMWRITE_JPEG_QUALITY, int(how)])[1], cv2.IMREAD_GRAYSCALE)


@pytest.mark.parametrize("how", ["95", "80", "mosaic"])
def test_noise_that_neighbouring_pixels_share_is_in_the_covariance(how):
    F, shift = motion(shift=(0.37, 0.61))
    chi = []
    for seed in (10, 12):
        a, b = (developed(how, g) for g in (image(seed), deformed(seed + 1, F, shift)))
        grid, f = found(a, b)
        good = f.state == State.FOLLOWED
        assert good.mean() > 0.95
        chi.append(mahalanobis2((f.xy_px - moved(grid.xy_px, F, shift))[good], f.cov_px2[good]).mean() / 2)
    assert 0.85 < np.mean(chi) < 1.2


def test_interpolation_of_coarse_speckles_gives_no_bias():
    """Waves down to 2.9 px: the convolution of the other windows errs by some hundredths of a pixel."""
    from raybundle.matching.least_squares import WindowOptions, match_windows

    size, rng = 256, np.random.default_rng(1)
    f = np.fft.fftfreq(size)
    fx, fy = np.meshgrid(f, f)
    spectrum = np.fft.fft2(rng.normal(size=(size, size))) * np.exp(-2 * (0.7 * np.pi * np.hypot(fx, fy)) ** 2)
    grey = np.fft.ifft2(spectrum).real
    wave = np.exp(-2j * np.pi * 0.25 * fx)
    a, b = (np.round(128 + 35 * np.fft.ifft2(s).real / grey.std()).clip(0, 255).astype(np.uint8)
            for s in (spectrum, spectrum * wave))  # fmt: skip
    free = np.zeros(a.shape, bool)
    free[12:-12, 12:-12] = True
    grid = SubsetGrid.of(free, 12, 10)
    error = follow(Picture.of(a, 1), Picture.of(b, 2), grid, window_options(10, quadratic=False)).xy_px - grid.xy_px
    assert np.abs(error.mean(axis=0) - [0.25, 0]).max() < 0.001
    wide = WindowOptions(half=10, sigma=1e6, loose=1e3, iterations=40)
    n = len(grid.xy_px)
    m = match_windows(
        a.astype(np.uint16), b.astype(np.uint16), grid.xy_px, grid.xy_px, np.tile(np.eye(2), (n, 1, 1)), wide
    )
    assert (m.xy_px - grid.xy_px).mean(axis=0)[0] - 0.25 > 0.02


def curved(xy):
    """Displacements with second derivatives of 1 / 500 px."""
    d = (xy - MIDDLE) / 500
    return np.stack([250 * d[..., 0] ** 2, -250 * d[..., 0] * d[..., 1]], axis=-1)


def test_a_quadratic_shape_follows_a_curved_field(reference):
    def source(xy):
        p = xy
        for _ in range(30):
            p = xy - curved(p)
        return p

    target = image(2, source)
    errors = []
    for quadratic in (False, True):
        grid, f = found(reference, target, half=14, quadratic=quadratic)
        good = f.state == State.FOLLOWED
        assert good.sum() > 0.8 * len(good)
        error = (f.xy_px - grid.xy_px - curved(grid.xy_px))[good]
        errors.append((np.abs(error.mean(axis=0)).max(), mahalanobis2(error, f.cov_px2[good]).mean() / 2))
    assert errors[0][0] > 0.03
    assert errors[1][0] < BIAS_PX
    assert 0.8 < errors[1][1] < 1.2


def cracked(seed, opening):
    """A cut along the middle row, left of the middle, opened by `opening` on either side; dark inside."""
    x, y = np.meshgrid(np.arange(WIDTH) + 0.5, np.arange(HEIGHT) + 0.5)
    grey = np.full(x.shape, 15.0)
    for side in (-1, 1):
        source = np.stack([x, y - side * opening * np.sqrt(np.clip(1 - x / MIDDLE[0], 0, None))], axis=-1)
        own = (source[..., 1] > MIDDLE[1]) == (side > 0)
        grey[own] = (120 + 35 * TEXTURE.at(source))[own]
    return np.clip(np.round(grey + np.random.default_rng(seed).normal(0, 2.0, grey.shape)), 0, 255).astype(np.uint8)


def test_both_sides_of_a_crack_are_followed_and_what_lies_across_has_a_reason(reference):
    grid, f = found(reference, cracked(2, 4.0), step=6)
    x, y = (grid.xy_px - MIDDLE).T
    across = (np.abs(y) <= 8) & (x < -40)
    assert (f.state[across] != State.FOLLOWED).all()
    assert {State.TORN, State.UNLIKE, State.CHANGED} & set(f.state[across])
    away = (np.abs(y) > 14) & (x < -40)
    assert (f.state[away] == State.FOLLOWED).mean() > 0.97
    truth = np.sign(y) * 4.0 * np.sqrt(np.clip(-x / MIDDLE[0], 0, None))
    assert np.nanmax(np.abs((f.xy_px - grid.xy_px)[away, 1] - truth[away])) < 0.1


def test_what_is_flat_changed_or_of_another_object_has_a_reason(reference):
    F, shift = motion(shift=(0.4, 0.2))
    flat, target = reference.copy(), deformed(2, F, shift)
    flat[:, :80] = 100
    target[200:260, 200:280] = image(9, lambda xy: xy + 1000)[200:260, 200:280]
    grid, f = found(flat, target)
    x, y = grid.xy_px.T
    assert set(f.state[x < 65]) == {State.FLAT}
    assert (f.state[(abs(x - 240) < 15) & (abs(y - 230) < 15)] != State.FOLLOWED).all()
    assert (f.state[(x > 100) & (y < 180)] == State.FOLLOWED).all()
    _, other = found(reference, image(9, lambda xy: xy + 1000))
    assert not (other.state == State.FOLLOWED).any()


def test_a_series_goes_on_where_the_last_image_ended(reference):
    window = window_options(10, quadratic=False)
    grid = SubsetGrid.of(np.ones(reference.shape, bool), 10, 10)
    before = None
    for k in range(1, 4):
        F, shift = motion(2.0 * k, strain=(0.01 * k, 0.0, 0.0), shift=(1.5 * k, 0.0))
        before = follow(Picture.of(reference, 1), Picture.of(deformed(k, F, shift), 2), grid, window, before)
    good = before.state == State.FOLLOWED
    assert good.mean() > 0.75
    error = (before.xy_px - moved(grid.xy_px, F, shift))[good]
    assert 0.85 < mahalanobis2(error, before.cov_px2[good]).mean() / 2 < 1.15


def test_subsets_stand_inside_what_is_free():
    free = np.zeros((120, 90), bool)
    free[20:100, 5:80] = True
    free[60, 60] = False
    grid = SubsetGrid.of(free, 4, 8)
    for x, y in grid.xy_px:
        assert free[int(y) - 8 : int(y) + 9, int(x) - 8 : int(x) + 9].all()
    raster = grid.raster(grid.xy_px[:, 0])
    assert raster.shape == grid.shape
    around = grid.neighbours()
    step = np.abs(grid.xy_px[around] - grid.xy_px[:, None])[around >= 0]
    assert set(np.unique(step)) == {0.0, 4.0}
    assert not len(SubsetGrid.of(np.zeros((50, 50), bool), 4, 8).xy_px)
    assert not len(SubsetGrid.of(np.ones((18, 50), bool), 4, 8).xy_px)


@pytest.mark.parametrize("quadratic", [False, True])
def test_neighbours_share_the_noise_of_common_pixels(reference, quadratic):
    """Correlations of errors at one and two steps are those of the overlap."""
    window = window_options(10, quadratic=quadratic)
    stated = overlap_correlation(window, 5, 2)
    F, shift = motion(shift=(0.3, 0.2))
    products, square = np.zeros(2), 0.0
    for seed in (2, 3):
        grid, f = found(reference, deformed(seed, F, shift), step=5, quadratic=quadratic)
        error = grid.raster(f.xy_px - moved(grid.xy_px, F, shift))
        square += np.nanmean(error**2)
        products += [np.nanmean(error[:, k:] * error[:, :-k]) for k in (1, 2)]
    np.testing.assert_allclose(products / square, stated[2, 3:], atol=0.08)
