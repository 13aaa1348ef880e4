"""What observations outside the images are off by is told in degrees or the block's unit; headlines are whole."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Attitudes
from raybundle.errors import NoOrientation
from tests.adjustment.test_bar_tests import with_bars
from tests.adjustment.test_wrong_control import CORNERS, network

OPTIONS = AdjustmentOptions(jobs=1)


def test_a_wrong_distance_is_told_in_the_unit_of_the_block():
    block, _ = with_bars([0.5, 0.5])
    told = [n for n in decide(block, OPTIONS).notices if n.code == "distance_suspect"]
    assert told
    assert all((n.values["sigma"], n.values["unit"]) == (pytest.approx(0.002), "m") for n in told)


def test_a_wrong_attitude_is_told_in_degrees():
    block, _ = network(CORNERS)
    angles = decide(block, OPTIONS).adjusted.images.angles.copy()
    n = len(angles)
    angles[3, 0] += np.radians(5.0)
    attitudes = Attitudes(image=np.arange(n, dtype=np.int32), angles=angles, sigma=np.full((n, 3), np.radians(0.1)))
    result = decide(block.having(attitudes), replace(OPTIONS, jobs=1))
    (notice,) = [m for m in result.notices if m.code == "attitude_suspect"]
    assert notice.values["off"] == pytest.approx(-5.0, abs=0.3)
    assert (notice.values["sigma"], notice.values["unit"]) == (pytest.approx(0.1), "degrees")


def test_a_headline_that_ends_in_a_colon_has_the_first_reason():
    head, first = "not oriented:", "image a"
    assert NoOrientation(f"{head}\n  {first}\n  Measure more.", images={}).headline == f"{head} {first}"
