"""Blocks with rigs and read-outs as other programs can take them."""

from dataclasses import replace

import numpy as np
import pytest
from tests.truth.mixed_blocks import mixed, two_camera_rig
from tests.truth.platform_blocks import platform_block

from raybundle.adjustment.system.predict import predicted_px, residuals_px
from raybundle.io.cameras.single_exposure import at_one_instant
from raybundle.planning.simulate import measured


def whole(block):
    """Its image points where the model has them, without errors."""
    return measured(block, 0.1)


MODELS = ("brown_rolling", "fisheye_rolling", "brown_mounted", "brown_rolling_mounted", "brown_trajectory_mounted")


@pytest.mark.parametrize("model", MODELS)
def test_image_points_are_those_of_the_sensor_alone(model):
    block = whole(platform_block(model))
    alone, remarks = at_one_instant(block)
    assert {c.model for c in alone.cameras} == {c.model.split("_")[0] for c in block.cameras}
    rows = np.arange(len(alone.observations))
    moved = np.linalg.norm(alone.observations.xy_px - block.observations.xy_px, axis=1)
    left = np.linalg.norm(residuals_px(alone, rows), axis=1)
    # to first order: what is left is the square of the motion
    assert left.max() < max(1e-6, 0.02 * moved.max())
    moving = "rolling" in model or "trajectory" in model
    assert moving == (moved.max() > 0.5)
    assert any("read-out" in r for r in remarks) == moving
    assert any("rig" in r for r in remarks) == ("mounted" in model)


def test_cameras_of_a_rig_stand_where_they_were():
    block = whole(two_camera_rig())
    alone, _ = at_one_instant(block)
    assert alone.images.station is None
    for i in range(len(alone.images)):
        there = predicted_px(block, i, block.points.xyz)
        np.testing.assert_allclose(predicted_px(alone, i, alone.points.xyz), there, atol=1e-6)


def test_a_line_has_no_instant():
    block = mixed()
    push = next(k for k, c in enumerate(block.cameras) if c.model == "pushbroom")
    assert at_one_instant(block)[0].cameras[push] == block.cameras[push]


def test_other_blocks_stay_as_they_are():
    block = two_camera_rig()
    plain = replace(block, cameras=tuple(replace(c, model="brown") for c in block.cameras))
    assert at_one_instant(plain)[0] is plain
