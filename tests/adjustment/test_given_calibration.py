"""A calibration that is given with its covariance: contradicted by the photographs, or outweighed by them."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.given_calibration import calibration_notices
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.block.simulate import Survey, TargetField, brown_camera, field_scene, simulate
from raybundle.block.stored import observed_jointly

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
    result = adjust(given(block, 0.005), AdjustmentOptions(threads=1))
    assert not codes(result)


def test_a_calibration_of_another_focus_is_contradicted(block):
    result = adjust(given(block, 0.005, off=0.1), AdjustmentOptions(threads=1))
    assert codes(result) == ["calibration_contradicted"]
    (notice,) = calibration_notices(result)
    assert "chi-square" in notice.message
    assert notice.severity == "caution"


def test_a_parameter_less_precise_than_it_was_given_is_told_with_both(block):
    result = adjust(given(block, 0.0005), AdjustmentOptions(threads=1))
    wide = {s: replace(p, std=0.002) if s == "x0" else p for s, p in result.interior[0].parameters.items()}
    wider = replace(result, interior=(replace(result.interior[0], parameters=wide), *result.interior[1:]))
    (notice,) = calibration_notices(wider)
    assert notice.code == "calibration_outweighed"
    assert "x0 0.0005 before, 0.002 now" in notice.message
    assert "c 0" not in notice.message
