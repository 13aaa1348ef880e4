"""Which bias is advised: on QuickBird with five published points, and on simulated ones."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest

from raybundle.errors import InputError, NotSolvable
from raybundle.scenes.bias import BIAS_PARAMETERS
from raybundle.scenes.bias_blunders import agreeing
from raybundle.scenes.bias_choice import check_fit, choose_bias
from raybundle.scenes.rpc import Rpc, observe_rpc


@pytest.fixture
def quickbird(sensors):
    text = (sensors / "qb2/rpc_param.yaml").read_text()
    v = {k: json.loads(x) for k, x in re.findall(r"^\s+(\w+): (\[[^\]]*\]|-?[\d.]+)$", text, re.MULTILINE)}
    rpc = Rpc(
        coefficients=np.array([v[f"{k}_coeff"] for k in ("line_num", "line_den", "samp_num", "samp_den")]),
        ground_offset=np.array([v["long_off"], v["lat_off"], v["height_off"]]),
        ground_scale=np.array([v["long_scale"], v["lat_scale"], v["height_scale"]]),
        image_offset=np.array([v["samp_off"], v["line_off"]]) + 0.5,
        image_scale=np.array([v["samp_scale"], v["line_scale"]]),
        err_bias_m=v["err_bias"],
        err_rand_m=v["err_rand"],
    )
    features = json.loads((sensors / "qb2/gcps.geojson").read_text())["features"]
    ground = np.array([f["geometry"]["coordinates"] for f in features])
    return rpc, ground, np.array([f["properties"]["ji"] for f in features]) + 0.5


@pytest.mark.parametrize("sigma", [0.05, 0.3, 1.0])
def test_quickbird_needs_a_shift(quickbird, sigma):
    rpc, ground, measured = quickbird
    assert (rpc.project(ground) - measured).mean(axis=0) == pytest.approx([2.98, 2.09], abs=0.05)
    advice = choose_bias(rpc, ground, measured, sigma_px=sigma)
    assert advice.advised.kind == "shift"
    assert advice.advised.values == pytest.approx([-2.98, -2.09], abs=0.05)
    assert advice.advised.rms == pytest.approx([0.075, 0.071], abs=0.001)
    assert (advice.advised.left_out_rms < 0.12).all()
    assert advice.advised.left_out_rms == pytest.approx([0.094, 0.089], abs=0.001)
    affine = advice.fits[-1]
    assert affine.kind == "affine"
    assert affine.left_out_rms == pytest.approx([0.39, 0.34], abs=0.01)
    assert 1 < advice.prior_ratio < 2
    assert (advice.reason.code, advice.reason.values["test"]) == ("bias.improvement", "F")


def simulated(rpc, place, scene, kind, n, seed, size=30.0, sigma=0.3):
    rng = np.random.default_rng(seed)
    ground = rpc.localise(rng.uniform(0, [scene.width_px, scene.height_px], (n, 2)), rng.uniform(0, 800, n))
    bias = rng.choice([-1, 1], len(BIAS_PARAMETERS[kind])) * size
    seen = observe_rpc(rpc, place, place.local_from_geographic(ground), kind, bias).xy_px
    return ground, seen + rng.normal(0, sigma, (n, 2)), bias


@pytest.mark.parametrize("kind", BIAS_PARAMETERS)
def test_what_was_simulated_is_advised(rpc, place, scene, kind):
    ground, measured, bias = simulated(rpc, place, scene, kind, 20, 5)
    advice = choose_bias(rpc, ground, measured, sigma_px=0.3)
    assert advice.advised.kind == kind
    if kind != "none":
        error = advice.advised.values - bias
        assert error @ np.linalg.solve(advice.advised.covariance, error) < 25


@pytest.mark.long
def test_stated_covariance_is_true(rpc, place, scene):
    from scipy.stats import chi2, kstest

    squares = []
    for seed in range(400):
        ground, measured, bias = simulated(rpc, place, scene, "drift", 6, seed, size=5.0)
        fit = next(f for f in choose_bias(rpc, ground, measured, sigma_px=0.3).fits if f.kind == "drift")
        error = fit.values - bias
        squares.append(error @ np.linalg.solve(fit.covariance, error))
    assert kstest(squares, chi2(4).cdf).pvalue > 1e-3
    assert kstest(np.array(squares) * 1.3**2, chi2(4).cdf).pvalue < 1e-3


def test_small_shift_is_not_significant(rpc, place, scene):
    ground, measured, _ = simulated(rpc, place, scene, "shift", 5, 1, size=0.05, sigma=1.0)
    advice = choose_bias(rpc, ground, measured, sigma_px=1.0)
    assert advice.advised.kind == "none"
    assert advice.prior_ratio is None


def test_one_point_allows_a_shift_and_no_more(rpc, place, scene):
    ground, measured, bias = simulated(rpc, place, scene, "shift", 1, 2)
    advice = choose_bias(rpc, ground, measured, sigma_px=0.3)
    assert [f.kind for f in advice.fits] == ["none", "shift"]
    assert advice.advised.kind == "shift"
    assert advice.advised.values == pytest.approx(bias, abs=1.5)
    assert advice.reason.values["few"]


def test_points_in_one_row_allow_no_affine(rpc):
    n = 8
    xy = np.stack([np.linspace(500, 7500, n), np.full(n, 3000.0)], axis=1)
    ground = rpc.localise(xy, 100.0)
    assert [f.kind for f in choose_bias(rpc, ground, xy + 2, sigma_px=0.5).fits] == ["none", "shift"]


def test_sigma_of_ground_points_counts(rpc):
    xy = np.array([[1000.0, 1000], [7000, 6000], [2000, 5000]])
    ground = rpc.localise(xy, 100.0)
    exact = choose_bias(rpc, ground, xy, sigma_px=0.3).fits[1]
    rough = choose_bias(rpc, ground, xy, sigma_px=0.3, sigma_ground_m=np.full((3, 3), [2.0, 2.0, 0.0])).fits[1]
    pixel = np.linalg.norm(rpc.pixel_on_ground(), axis=1)
    assert np.diag(exact.covariance) == pytest.approx([0.03, 0.03])
    assert np.diag(rough.covariance) == pytest.approx((0.09 + (2 / pixel) ** 2) / 3, rel=0.05)


def test_a_prior_far_off_is_told(rpc, place, scene):
    ground, measured, _ = simulated(rpc, place, scene, "shift", 6, 3, size=100.0)
    ratio = choose_bias(replace(rpc, err_bias_m=2.0), ground, measured, sigma_px=0.3).prior_ratio
    assert ratio > 20


def test_bad_input(rpc):
    with pytest.raises(InputError, match=r"bias\.point_count"):
        choose_bias(rpc, np.zeros((0, 3)), np.zeros((0, 2)), sigma_px=1.0)
    with pytest.raises(InputError, match=r"image_point\.sigma_not_positive_px"):
        choose_bias(rpc, rpc.ground_offset[None], rpc.image_offset[None], sigma_px=0.0)


@pytest.mark.parametrize("kind", ["none", "shift", "drift", "affine"])
@pytest.mark.parametrize("seed", range(4))
def test_a_wrong_point_is_named_and_left_out(rpc, place, scene, kind, seed):
    ground, measured, bias = simulated(rpc, place, scene, kind, 10, seed)
    measured[seed] += [60, 0]
    advice = choose_bias(rpc, ground, measured, sigma_px=0.3)
    assert advice.set_aside == (seed,)
    assert advice.set_aside_px[0] == pytest.approx([60, 0], abs=3)
    assert advice.advised.kind == kind
    assert advice.advised.values == pytest.approx(bias, abs=2)
    assert [d.values for d in advice.reason.details] == [{"n": 1, "total": 10}]
    check_fit(advice, advice.advised)


def test_two_wrong_points_that_hide_each_other(rpc, place, scene):
    ground, measured, bias = simulated(rpc, place, scene, "shift", 8, 4)
    measured[[2, 5]] += [[25, 25], [22, 27]]
    advice = choose_bias(rpc, ground, measured, sigma_px=0.3)
    assert set(advice.set_aside) == {2, 5}
    assert advice.advised.values == pytest.approx(bias, abs=0.6)


@pytest.mark.long
def test_good_points_are_not_set_aside_more_often_than_stated(rpc, place, scene):
    """At 1 % over all points of a set, among 400 sets: 4, at most 12 by chance (probability 3e-4)."""
    rng = np.random.default_rng(8)
    lost = 0
    for n in (3, 5, 8, 12):
        covariance = np.broadcast_to(0.09 * np.eye(2), (n, 2, 2))
        for _ in range(100):
            lost += int((~agreeing(rng.uniform(-1, 1, (n, 2)), rng.normal(0, 0.3, (n, 2)), covariance)).any())
    assert lost <= 12


def test_points_that_fit_nothing_are_no_agreement(rpc, place, scene):
    """Noise of 5 px where 0.3 px are stated."""
    ground, measured, _ = simulated(rpc, place, scene, "none", 8, 3, sigma=5.0)
    advice = choose_bias(rpc, ground, measured, sigma_px=0.3)
    assert advice.set_aside == ()
    assert advice.reason.code == "bias.rpc_contradicted"
    assert 8 < advice.advised.misfit < 30
    with pytest.raises(NotSolvable, match=r"0\.3.*5.*bias\.misfit"):
        check_fit(advice, advice.advised)
    check_fit(told := choose_bias(rpc, ground, measured, sigma_px=5.0), told.advised)
    assert told.reason.code == "bias.rpc_confirmed"


def test_standard_deviations_grow_with_the_misfit(rpc, place, scene):
    ground, measured, _ = simulated(rpc, place, scene, "shift", 20, 3, sigma=0.9)
    fit = choose_bias(rpc, ground, measured, sigma_px=0.3).advised
    assert fit.misfit == pytest.approx(3, rel=0.35)
    assert fit.sigma == pytest.approx([0.9 / np.sqrt(20)] * 2, rel=0.35)
    honest = choose_bias(rpc, ground, measured, sigma_px=0.9).advised
    assert honest.misfit == 1
    assert honest.sigma == pytest.approx(np.sqrt(np.diag(honest.covariance)))


def test_two_points_that_contradict_each_other_are_both_kept_and_refused(rpc, place, scene):
    ground, measured, _ = simulated(rpc, place, scene, "shift", 2, 3)
    measured[0] += [60, 0]
    advice = choose_bias(rpc, ground, measured, sigma_px=0.3)
    assert advice.set_aside == ()
    shift = next(f for f in advice.fits if f.kind == "shift")
    with pytest.raises(NotSolvable, match=r"bias\.misfit"):
        check_fit(advice, shift)
