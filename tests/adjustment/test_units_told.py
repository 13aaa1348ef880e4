"""What observations outside the images are off by is told in degrees or the block's unit; headlines are whole."""

import re
from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.decide import decide
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.block import Attitudes
from raybundle.errors import NoOrientation
from tests.adjustment.test_bar_tests import with_bars
from tests.adjustment.test_wrong_control import CORNERS, network

OPTIONS = AdjustmentOptions(jobs=1)


def test_a_wrong_distance_is_told_in_the_unit_of_the_block():
    block, _ = with_bars([0.5, 0.5])
    told = [n.message for n in decide(block, OPTIONS).notices if n.code == "distance_suspect"]
    assert told
    assert all(re.search(r"[0-9] m, at a sigma of 0.002 m \(\|w\|", m) for m in told)


def test_a_wrong_attitude_is_told_in_degrees():
    block, _ = network(CORNERS)
    angles = decide(block, OPTIONS).adjusted.images.angles.copy()
    n = len(angles)
    angles[3, 0] += np.radians(5.0)
    attitudes = Attitudes(image=np.arange(n, dtype=np.int32), angles=angles, sigma=np.full((n, 3), np.radians(0.1)))
    result = decide(block.having(attitudes), replace(OPTIONS, jobs=1))
    (message,) = [m.message for m in result.notices if m.code == "attitude_suspect"]
    off = float(re.search(r": -([0-9.]+) degrees, at a sigma of 0.1 degrees \(\|w\|", message)[1])
    assert off == pytest.approx(5.0, abs=0.3)


def test_a_headline_that_ends_in_a_colon_has_the_first_reason():
    message = "no approximate orientation for 1 of 20 images:\n  image a: too few\n  Measure more points."
    assert (
        NoOrientation(message, images={}).headline == "no approximate orientation for 1 of 20 images: image a: too few"
    )
