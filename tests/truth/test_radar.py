"""Radar scenes by themselves and with an optical one: the stated covariances are true.

The short version; benchmarks/truth_radar.py runs 600 adjustments of each block.
"""

import functools

import pytest
from scipy.stats import chi2

from tests.truth.bands import assert_true_to_ten_percent
from tests.truth.mixed_blocks import errors_and_joint
from tests.truth.radar_blocks import BLOCKS

RUNS = 60
ENOUGH = 2200
"""Degrees of freedom from which no sample within its band is within it when it is wrong by 10 %"""


@functools.cache
def errors(name):
    return errors_and_joint(BLOCKS[name](), RUNS, seed=17)


@pytest.mark.long
@pytest.mark.parametrize("name", BLOCKS)
def test_errors_follow_the_stated_covariance(name):
    found, _ = errors(name)
    assert {"tie point", "check point", "control point", "parameters of A"} <= set(found)
    for kind, (d2, degrees) in found.items():
        low, high = chi2(degrees * len(d2)).interval(0.999)
        assert low < d2.sum() < high, kind


@pytest.mark.long
@pytest.mark.parametrize("name", BLOCKS)
def test_a_sigma_that_is_wrong_by_ten_percent_fails(name):
    _, joint = errors(name)
    for together, (d2, degrees) in joint.items():
        if degrees * RUNS > ENOUGH:
            assert_true_to_ten_percent(d2, degrees, f"{name}, {together}")
    assert joint["all points"][1] * RUNS > ENOUGH
