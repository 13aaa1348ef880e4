"""A result as a block again: what was found is its start, what was observed stays as it was given."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.readjust import block_again
from raybundle.adjustment.records.options import AdjustmentOptions
from tests.native.cases import block_of


@pytest.fixture(scope="module")
def result():
    block = block_of(control=5, control_sigma=(1e-3,) * 3, check=2)
    camera = replace(block.cameras[0], sigma={"c": 0.02})
    held = np.arange(len(block.images)) == 1
    given = replace(block, cameras=(camera,), images=replace(block.images, held=held))
    return adjust_block(given, AdjustmentOptions(jobs=1))


def test_what_was_observed_stays(result):
    again, given, adjusted = block_again(result), result.given, result.adjusted
    observed = given.points.is_control | given.points.is_check
    assert observed.any()
    np.testing.assert_array_equal(again.points.xyz, np.where(observed, given.points.xyz, adjusted.points.xyz))
    np.testing.assert_array_equal(again.images.centre, adjusted.images.centre)
    assert again.images.held.tolist() == given.images.held.tolist()
    values = again.cameras[0].values
    assert values == {**adjusted.cameras[0].values, "c": given.cameras[0].values["c"]}
    assert values["c"] != adjusted.cameras[0].values["c"]
    assert adjust_block(again, AdjustmentOptions(jobs=1)).sigma0 == pytest.approx(result.sigma0, rel=1e-6)


@pytest.mark.parametrize(("noise", "over"), [("auto", "all"), ("white", "good"), ("fields", "all"), ("auto", "good")])
def test_choices_are_kept_unless_they_are_left_to_the_program(result, noise, over):
    options = replace(result.options, noise=noise, datum_over=over)
    again = block_again(replace(result, options=options))
    assert again.noise == ("" if noise == "auto" else noise)
    assert again.datum_over == ("" if over == "all" else over)
