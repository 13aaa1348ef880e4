"""A calibration that is given with its covariance: contradicted by the photographs, or outweighed by them."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block.stored import observed_jointly
from raybundle.calibration.previous_calibration import calibration_notices, held_notices
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from tests.adjustment.test_noise import with_fields

FREE = ("c", "x0", "y0")


@pytest.fixture(scope="module")
def block():
    survey = Survey(orientation="exact", points="exact", interior="exact")
    return simulate(field_scene(TargetField(camera=brown_camera(estimate=FREE))), survey).observed


def given(block, sigma, off=0.0):
    camera = block.cameras[0]
    values = {**camera.values, "c": camera.values["c"] + off}
    known = observed_jointly(replace(camera, values=values), FREE, np.diag(np.full(3, sigma**2)))
    return replace(block, cameras=(known, *block.cameras[1:]))


def codes(result):
    return [n.code for n in result.notices if n.code.startswith("calibration_")]


def test_a_calibration_that_holds_is_not_mentioned(block):
    result = adjust(given(block, 0.005), AdjustmentOptions(jobs=1))
    assert not codes(result)


def test_a_calibration_of_another_focus_is_contradicted(block):
    result = adjust(given(block, 0.005, off=0.1), AdjustmentOptions(jobs=1))
    assert codes(result) == ["calibration_contradicted"]
    (notice,) = calibration_notices(result)
    assert notice.values["squares"] > notice.values["limit"]
    assert notice.ids == ("1", "c")
    (c,) = [d.values for d in notice.details]
    assert (c["symbol"], c["given"], c["unit"]) == ("c", 20.5, "mm")
    assert c["found"] == pytest.approx(20.4, abs=0.01)
    assert c["limit"] == pytest.approx(3.6, abs=0.05)
    assert notice.severity == "warning"


def test_a_parameter_less_precise_than_it_was_given_is_told_with_both(block):
    result = adjust(given(block, 0.0005), AdjustmentOptions(jobs=1))
    wide = {s: replace(p, std=0.002) if s == "x0" else p for s, p in result.interior[0].parameters.items()}
    wider = replace(result, interior=(replace(result.interior[0], parameters=wide), *result.interior[1:]))
    (notice,) = calibration_notices(wider)
    assert notice.code == "calibration_outweighed"
    (x0,) = [d.values for d in notice.details]
    assert (x0["symbol"], x0["after"]) == ("x0", 0.002)
    assert x0["before"] == pytest.approx(0.0005)


def test_smooth_errors_do_not_contradict_a_calibration_once_they_are_known():
    """A calibration that is right within its 1 um: white weights take fields of 0.5 px for another camera."""
    contradicted = {"white": 0, "fields": 0}
    for seed in range(5):
        survey = Survey(orientation="exact", points="exact", interior="exact", seed=seed)
        plain = simulate(field_scene(TargetField(camera=brown_camera(estimate=FREE))), survey).observed
        smooth = given(with_fields(plain, 0.5, seed), 0.001, off=np.random.default_rng(seed).normal(0, 0.001))
        for noise in contradicted:
            told = codes(adjust(smooth, AdjustmentOptions(jobs=1, noise=noise)))
            contradicted[noise] += "calibration_contradicted" in told
            assert ("calibration_outweighed" in told) == (noise == "fields")
    assert contradicted["white"] >= 2
    assert contradicted["fields"] == 0


@pytest.mark.parametrize("noise", ["white", "fields"])
def test_another_focus_is_found_under_either_noise(block, noise):
    smooth = given(with_fields(block, 0.3), 0.005, off=0.1)
    result = adjust(smooth, AdjustmentOptions(jobs=1, noise=noise))
    (notice,) = [n for n in result.notices if n.code == "calibration_contradicted"]
    assert notice.ids == ("1", "c")


def test_what_few_residuals_make_of_a_standard_deviation_is_no_loss(block):
    """Of a mean square of 20 residuals the root is up to 1.5 times its truth, in all but one of a thousand."""
    result = adjust(given(block, 0.0005), AdjustmentOptions(jobs=1))
    std = result.interior[0].parameters["c"].std
    wide = {s: replace(p, std=0.0007) if s == "x0" else p for s, p in result.interior[0].parameters.items()}
    wider = replace(result, interior=(replace(result.interior[0], parameters=wide), *result.interior[1:]))
    assert std < 0.0005
    assert [n.code for n in calibration_notices(wider)] == ["calibration_outweighed"]
    assert not calibration_notices(replace(wider, redundancy=20))


# --- a calibration that is held


def held(block, **off):
    """The block with its camera held, and some of its values changed."""
    camera = block.cameras[0]
    values = {s: v + off.get(s, 0.0) for s, v in camera.values.items()}
    return replace(block, cameras=(replace(camera, values=values, estimate=()), *block.cameras[1:]))


@pytest.mark.long
@pytest.mark.parametrize("noise", ["white", "fields"])
def test_a_held_calibration_that_is_right_is_not_mentioned(noise):
    """Twenty networks, of a test at 0.1 %."""
    told = 0
    for seed in range(20):
        survey = Survey(orientation="exact", points="exact", interior="exact", seed=seed)
        simulated = simulate(field_scene(TargetField(camera=brown_camera(estimate=FREE))), survey).observed
        if noise == "fields":
            simulated = with_fields(simulated, 0.3, seed)
        result = adjust(held(simulated), AdjustmentOptions(jobs=1, noise=noise))
        told += len(held_notices(result, ["1"]))
    assert told == 0


@pytest.mark.parametrize("noise", ["white", "fields"])
@pytest.mark.parametrize(("symbol", "off"), [("c", 0.1), ("x0", 0.05), ("K1", 2e-5)])
def test_a_held_value_that_the_photographs_contradict_is_a_fault(block, noise, symbol, off):
    result = adjust(held(with_fields(block, 0.05), **{symbol: off}), AdjustmentOptions(jobs=1, noise=noise))
    (notice,) = held_notices(result, ["1"])
    assert notice.severity == "fault"
    assert notice.data.code == "calibration_contradicted.held"
    moved = {d.values["symbol"]: d.values for d in notice.details}
    assert moved[symbol]["unit"] in {"mm", "mm^-2"}
    assert moved[symbol]["effect_px"] > 0
    assert not held_notices(result, [])


def test_a_difference_that_moves_nothing_in_the_image_is_not_mentioned(block):
    """Significant, and a tenth of what an image coordinate is good for."""
    camera = block.cameras[0]
    sigma = float(np.sqrt(np.median(block.observations.cov_px2[:, 0]))) * camera.pixel_mm[0]
    result = adjust(held(block, x0=0.1 * sigma), AdjustmentOptions(jobs=1))
    assert not held_notices(result, ["1"])


@pytest.mark.parametrize("noise", ["white", "fields"])
def test_a_held_calibration_is_tested_when_a_block_is_adjusted(block, noise):
    camera = block.cameras[0]
    options = AdjustmentOptions(jobs=1, noise=noise)
    right = replace(block, cameras=(replace(camera, estimate=()),))
    assert not codes(adjust(right, options))
    values = {**camera.values, "c": 1.02 * camera.values["c"]}
    result = adjust(replace(block, cameras=(replace(camera, values=values, estimate=()),)), options)
    (notice,) = [n for n in result.notices if n.code == "calibration_contradicted"]
    assert notice.severity == "fault"
    assert notice.data.code == "calibration_contradicted.held"
    assert notice.details[0].values["given"] == pytest.approx(20.8, abs=0.05)
    # what says it is the test: the same camera, free, is not contradicted
    assert not codes(adjust(replace(block, cameras=(replace(camera, values=values),)), options))


def test_a_calibration_that_moves_no_projection_centre_beyond_its_precision_is_no_fault(block):
    """A principal point that is 2.5 px off under smooth errors of 0.3 px: contradicted, and turns take it up."""
    smooth = with_fields(block, 0.3)
    found = {}
    for off in (0.01, 0.05):
        (found[off],) = held_notices(adjust(held(smooth, x0=off), AdjustmentOptions(jobs=1, noise="fields")), ["1"])
    assert {off: n.severity for off, n in found.items()} == {0.01: "warning", 0.05: "fault"}
    assert found[0.01].values["centres"] < found[0.01].values["centres_limit"] < found[0.05].values["centres"]
