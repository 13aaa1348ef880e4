"""Zoom lenses: settings combined into functions of the EXIF focal length."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.adjustment.engine import adjust_block
from raybundle.block.zoom import between_focuses, focal_resolution, refocused
from raybundle.calibration.maps import calibration_difference
from raybundle.calibration.zoom import calibrate_zoom, setting_of, zoom_residuals
from raybundle.errors import InputError
from raybundle.io.cameras.zoom_files import read_zoom, write_zoom
from raybundle.numerics.statistics import mahalanobis2
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from tests.messages import coded

FREE = ("c", "x0", "y0", "K1", "K2", "P1", "P2")
SETTINGS = np.array([24.0, 30.0, 38.0, 48.0, 62.0, 85.0])
HELD_OUT = (27.0, 34.0, 54.0, 72.0)
PIXEL = 0.006


def lens(f):
    """A zoom lens 24-85 mm: the nominal focal length is not c, distortion grows towards the wide end by a power."""
    c = 0.35 + 1.004 * f + 0.6 * np.log(f / 45)
    r = c / 45
    return {
        "c": c, "x0": 0.05 + 0.02 * np.log(r), "y0": -0.04 + 0.015 / r, "K1": -2e-5 + 9e-5 * r**-2.2,
        "K2": 1e-8 - 1.6e-7 * r**-3.0, "K3": 0.0, "P1": 4e-6 / r, "P2": -3e-6 + 1e-6 * r, "A": 0.0, "S": 0.0,
    }  # fmt: skip


def calibrated(f, exif, seed):
    camera = brown_camera(values=lens(f), size_px=(6000, 4000), pixel_mm=PIXEL, estimate=FREE)
    field = TargetField(camera=camera, depth=0.5, rows=8, columns=10, stations=12, frontal=4, distance=2.2 * f / 24)
    survey = Survey(seed=seed, image_sigma_px=0.05, orientation="exact", points="exact", interior="exact")
    return setting_of(adjust_block(simulate(field_scene(field), survey).observed), "1", exif)


def settings(seed, resolution):
    rng = np.random.default_rng(seed)
    true = SETTINGS + (rng.uniform(-0.5, 0.5, 6) if resolution else 0.37)
    exif = SETTINGS if resolution else true
    return [calibrated(f, e, 100 * seed + k) for k, (f, e) in enumerate(zip(true, exif, strict=True))]


@pytest.fixture(scope="module")
def exact():
    return settings(1, 0.0)


@pytest.fixture(scope="module")
def rounded():
    return settings(2, 1.0)


def error(prediction, f):
    true = lens(f)
    e = np.array([prediction.camera.values[s] - true[s] for s in prediction.free])
    return float(mahalanobis2(e[None], prediction.covariance)[0]), replace(prediction.camera, values=true)


def test_held_out_settings_are_predicted_to_three_tenths_of_a_pixel_within_their_sigma(exact):
    zoom = calibrate_zoom(exact, resolution_mm=0.0)
    sums = []
    for f in HELD_OUT:
        prediction = zoom.predict(f + 0.123)
        q, true = error(prediction, f + 0.123)
        difference = calibration_difference(prediction.camera, true)
        assert difference.rms < 0.2
        assert difference.largest < (0.3 if f < 62 else 0.32), "the widest gap, 62 to 85 mm, is the hardest"
        sums.append(q)
    m = len(FREE)
    assert max(sums) < chi2.isf(1e-3, m)
    assert sum(sums) > 0.25 * m * len(sums)  # neither too large
    assert 0.4 < zoom.variance_factor < 2.0


def test_rounded_focal_lengths_let_sigma_grow_and_still_cover(exact, rounded):
    zoom, sharp = calibrate_zoom(rounded), calibrate_zoom(exact, resolution_mm=0.0)
    assert zoom.resolution_mm == 1.0
    rng = np.random.default_rng(5)
    sums = []
    for f in HELD_OUT:
        prediction = zoom.predict(f)
        sigma_c = np.sqrt(prediction.covariance[0, 0])
        assert 0.28 < sigma_c < 0.45  # 1 / sqrt(12) mm at least
        assert sigma_c > 50 * np.sqrt(sharp.predict(f).covariance[0, 0])
        sums.append(error(prediction, f + rng.uniform(-0.5, 0.5))[0])
    assert max(sums) < chi2.isf(1e-3, len(FREE))
    assert 0.2 < zoom.variance_factor < 3.0


def test_orders_are_chosen_by_significance(exact):
    zoom = calibrate_zoom(exact, resolution_mm=0.0)
    orders = dict(zip(zoom.symbols, zoom.orders, strict=True))
    assert orders["K1"] >= 2
    assert orders["P2"] <= 3
    v = zoom_residuals(zoom, exact)
    sigma = np.array([np.sqrt(np.diagonal(s.covariance)) for s in exact])
    assert np.abs(v / sigma).max() < 4.5
    # constants where nothing varies
    still = [replace(s, camera=exact[2].camera, covariance=exact[2].covariance) for s in exact]
    assert calibrate_zoom(still, resolution_mm=0.0).square_sum < 1e-6


def test_a_scatter_beyond_the_covariances_lets_sigma_grow(exact):
    moved = list(exact)
    values = dict(moved[3].camera.values)
    values["x0"] += 0.02  # twenty standard deviations: play of the lens
    moved[3] = replace(moved[3], camera=replace(moved[3].camera, values=values))
    zoom, before = calibrate_zoom(moved, resolution_mm=0.0), calibrate_zoom(exact, resolution_mm=0.0)
    k = FREE.index("x0")
    assert zoom.predict(50.0).covariance[k, k] > 5 * before.predict(50.0).covariance[k, k]


def test_beyond_the_range_it_is_refused(exact):
    zoom = calibrate_zoom(exact, resolution_mm=0.0)
    with pytest.raises(InputError, match=r"100.*24\.37.*85\.37.*zoom\.out_of_range"):
        zoom.predict(100.0)
    with pytest.raises(InputError, match=r"23\.9.*zoom\.out_of_range"):
        zoom.predict(23.9)


def test_settings_that_do_not_belong_together_are_refused(exact):
    with pytest.raises(InputError, match=r"2.*3.*zoom\.too_few_settings"):
        calibrate_zoom(exact[:2])
    with pytest.raises(InputError, match=r"EXIF.*zoom\.setting_given_twice"):
        calibrate_zoom([exact[0], exact[0], exact[1], exact[2]])
    with pytest.raises(InputError, match=r"zoom\.settings_differ"):
        calibrate_zoom([exact[0], exact[1], replace(exact[2], free=exact[2].free[:-1])])
    other = replace(exact[2].camera, values={**exact[2].camera.values, "K3": 1e-12})
    with pytest.raises(InputError, match=r"K3.*zoom\.held_values_differ"):
        calibrate_zoom([exact[0], exact[1], replace(exact[2], camera=other)])


def test_it_comes_back_from_its_files(exact, tmp_path):
    zoom = calibrate_zoom([replace(s, focus_m=2.5) for s in exact], resolution_mm=0.0)
    write_zoom(zoom, tmp_path)
    back = read_zoom(tmp_path)
    a, b = zoom.predict(41.0, 2.5), back.predict(41.0, 2.5)
    assert a.camera.values == b.camera.values
    assert a.free == b.free
    np.testing.assert_array_equal(a.covariance, b.covariance)
    text = (tmp_path / "zoom.toml").read_text()
    (tmp_path / "zoom.toml").write_text(text.replace('"K2"', '"K9"'))
    with pytest.raises(InputError, match=r"K9.*parameter\.unknown"):
        read_zoom(tmp_path)
    (tmp_path / "zoom.toml").write_text(text.replace("[covariance]\nrows = [\n", "[covariance]\nrows = [\n  [1.0],\n"))
    with pytest.raises(InputError, match=r"value\.count"):
        read_zoom(tmp_path)


def test_resolution_of_focal_lengths():
    assert focal_resolution(np.array([24.0, 35.0, 70.0])) == 1.0
    assert focal_resolution(np.array([7.4, 12.1])) == 0.1
    assert focal_resolution(np.array([24.013, 35.2])) == 0.0


def test_focus_that_is_not_known_is_said(exact):
    zoom = calibrate_zoom(exact, resolution_mm=0.0)
    assert coded(zoom.predict(40.0, 3.0).remarks) == {"zoom.focus_unknown": {"of": "calibration"}}
    known = calibrate_zoom([replace(s, focus_m=2.0) for s in exact], resolution_mm=0.0)
    assert coded(known.predict(40.0).remarks) == {"zoom.focus_unknown": {"of": "photograph"}}
    assert known.predict(40.0, 2.0).remarks == ()
    there = known.predict(40.0, 5.0)
    moved = there.camera.values["c"] - known.predict(40.0, 2.0).camera.values["c"]
    assert moved == pytest.approx(-(40.6**2) / 1000 * (1 / 2 - 1 / 5), rel=0.02)
    remark = {"focus_m": 5.0, "calibrated_m": 2.0, "change_mm": pytest.approx(moved)}
    assert coded(there.remarks) == {"zoom.refocused": remark}


def test_between_two_focuses_everything_is_linear_in_magnification(exact):
    """A thin lens of 50 mm whose distortion varies as Magill's formula says, at a third distance."""
    f = 50.0
    zoom = calibrate_zoom(exact, resolution_mm=0.0).predict(50.0)

    def at(s):
        m = f / (1000 * s - f)
        values = {**zoom.camera.values, "c": f * (1 + m), "K1": 4e-5 - 3e-4 * m, "x0": 0.01 + 0.2 * m}
        return replace(zoom, camera=replace(zoom.camera, values=values))

    between = between_focuses(at(0.8), at(6.0), {"near": 0.8, "far": 6.0, "wanted": 1.7})
    for key, value in at(1.7).camera.values.items():
        assert between.camera.values[key] == pytest.approx(value, rel=1e-12)
    assert refocused(at(0.8).camera.values["c"], 0.8, 1.7) == pytest.approx(at(1.7).camera.values["c"], rel=1e-12)
    same = between_focuses(at(0.8), at(6.0), {"near": 0.8, "far": 6.0, "wanted": 0.8})
    np.testing.assert_allclose(same.covariance, zoom.covariance, rtol=1e-9)
    far = between_focuses(at(0.8), at(float("inf")), {"near": 0.8, "far": float("inf"), "wanted": 1.7})
    assert far.camera.values["c"] == pytest.approx(at(1.7).camera.values["c"], rel=1e-12)
    with pytest.raises(InputError, match=r"9.*0\.8.*6.*focus\.out_of_range"):
        between_focuses(at(0.8), at(6.0), {"near": 0.8, "far": 6.0, "wanted": 9.0})
