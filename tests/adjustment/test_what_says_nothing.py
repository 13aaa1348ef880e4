"""Blocks whose observations say nothing of what is asked, or nothing at all: clear errors instead of figures."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.engine import adjust_block
from raybundle.block.rejection import Rejection, RejectionKind
from raybundle.errors import InputError
from tests.adjustment.test_moving_sensors import RATES, SIGMA, observed, rolling
from tests.truth.mixed_blocks import room


def with_values(block, **values):
    cameras = (replace(c, values={**c.values, **values}) for c in block.cameras)
    return replace(block, cameras=tuple(cameras))


def test_a_block_without_observations():
    block = room()
    o = block.observations
    none = replace(o, image=o.image[:0], point=o.point[:0], xy_px=o.xy_px[:0], cov_px2=o.cov_px2[:0])
    with pytest.raises(InputError, match=r"adjustment\.no_observation"):
        adjust_block(replace(block, observations=none))
    with pytest.raises(InputError, match=r"tie_points\.too_few_rays"):
        adjust(replace(block, observations=none))


def test_a_block_whose_observations_are_all_rejected():
    block = room()
    n = len(block.observations)
    with pytest.raises(InputError, match=r"605.*adjustment\.all_rejected"):
        adjust_block(block, rejected=(Rejection(kind=RejectionKind.GIVEN),) * n)


@pytest.mark.parametrize("sigma", [{}, SIGMA, dict.fromkeys(RATES, 0.3)])
def test_a_shutter_without_read_out_shows_no_motion(sigma):
    block = with_values(observed(rolling(sigma=sigma)), r=0.0)
    with pytest.raises(InputError, match=r"0.*camera\.no_read_out_time"):
        adjust_block(block)
    still = replace(block, cameras=tuple(replace(c, estimate=(), per_image=()) for c in block.cameras))
    assert np.isfinite(adjust_block(replace(still, images=replace(still.images, interior={}))).sigma0)


def test_a_panorama_of_two_turns():
    block = room()
    c = block.cameras[0].values["c"]
    with pytest.raises(InputError, match=r"2.*60.*camera\.too_many_turns"):
        adjust_block(with_values(block, c=c / 2))
    adjust_block(with_values(block, c=c / 1.01))
