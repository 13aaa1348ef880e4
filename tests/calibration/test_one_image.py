"""One image of a control field: with depth it calibrates a camera; flat, what it leaves open is named."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.planning.simulate import measured
from raybundle.planning.synthetic_networks import brown_camera, look_at
from tests.truth.bands import assert_true_to_ten_percent
from tests.truth.mixed_blocks import MonteCarlo, block_of, control_table

INTERIOR = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2")
SIGMA_PX = 0.1


def one_image(depth, *, aside=0.0):
    """62 control points in a field of this depth [m], seen from 1.9 m; `aside` obliquely."""
    plane = np.stack(np.meshgrid(np.linspace(-1, 1, 9), np.linspace(-0.65, 0.65, 7)), -1).reshape(-1, 2)
    xyz = np.column_stack([plane, depth * np.random.default_rng(1).uniform(-1, 1, len(plane))])
    centre = np.array([[aside, 0.05, 1.9]])
    block = block_of(
        [brown_camera(estimate=INTERIOR)], [0], centre, look_at(centre, np.zeros((1, 3))), xyz,
        *control_table(len(xyz), len(xyz), 0, 1e-4),
    )  # fmt: skip
    return measured(block, SIGMA_PX)


def adjusted(block, estimate="given"):
    o, rng = block.observations, np.random.default_rng(4)
    noisy = replace(block, observations=replace(o, xy_px=o.xy_px + rng.normal(0, SIGMA_PX, o.xy_px.shape)))
    return decide(noisy, AdjustmentOptions(jobs=1, datum="control", estimate=estimate))


def test_a_field_with_depth_calibrates_the_camera():
    block = one_image(0.3)
    result = adjusted(block)
    found = result.interior[0].parameters
    for symbol in INTERIOR:
        assert found[symbol].status == "estimated"
        assert abs(found[symbol].value - block.cameras[0].values[symbol]) < 4 * found[symbol].std
    assert found["c"].std < 0.004
    assert not {"not_determinable", "held_not_determinable", "correlation"} & {n.code for n in result.notices}


def test_its_stated_covariance_is_true():
    errors = MonteCarlo.of(one_image(0.3)).errors(300, seed=3)
    assert_true_to_ten_percent(*errors["parameters of 1"])


@pytest.mark.parametrize(("estimate", "code"), [("given", "not_determinable"), ("auto", "held_not_determinable")])
def test_a_flat_field_leaves_the_camera_constant_open(estimate, code):
    result = adjusted(one_image(0.0), estimate)
    named = [n for n in result.notices if n.code == code]
    assert len(named) == 1
    if estimate == "given":
        assert result.interior[0].parameters["c"].status == "not determinable"
    distortion = result.interior[0].parameters["K1"]
    assert distortion.std < 4e-6  # K1 is determined all the same


def test_a_flat_field_seen_obliquely_names_what_hangs_together():
    result = adjusted(one_image(0.0, aside=1.5))
    assert "correlation" in {n.code for n in result.notices}
    assert result.interior[0].parameters["c"].std > 20 * adjusted(one_image(0.3)).interior[0].parameters["c"].std
