"""Sensors on platforms: the stated covariances are true, for whatever sensor.

The short version; benchmarks/truth_platforms.py runs 100 adjustments of every combination.
"""

import functools

import numpy as np
import pytest
from scipy.stats import chi2

from tests.truth.mixed_blocks import MonteCarlo
from tests.truth.platform_blocks import COMBINATIONS, platform_block

SHORT = (
    "fisheye_mounted",
    "spherical_mounted",
    "rational_rolling",
    "fisheye_rolling",
    "brown_rolling_mounted",
    "brown_trajectory",
)


@functools.cache
def errors(model):
    return MonteCarlo.of(platform_block(model)).errors(25, seed=5)


@pytest.mark.parametrize("model", COMBINATIONS)
def test_every_combination_is_adjusted(model):
    block = platform_block(model)
    assert (np.bincount(block.observations.image, minlength=len(block.images)) > 15).all()
    found = MonteCarlo.of(block).errors(1, seed=3)
    assert {"tie point", "check point", "control point"} <= set(found)
    for kind, (d2, degrees) in found.items():
        assert d2.sum() < chi2(degrees * len(d2)).ppf(0.99999), kind


@pytest.mark.parametrize("model", SHORT)
def test_errors_follow_the_stated_covariance(model):
    for kind, (d2, degrees) in errors(model).items():
        low, high = chi2(degrees * len(d2)).interval(0.999)
        assert low < d2.sum() < high, kind


@pytest.mark.parametrize("model", SHORT)
def test_ten_percent_too_small_a_sigma_is_noticed(model):
    d2, degrees = (
        np.concatenate(a) for a in zip(*((v, np.full(len(v), k)) for v, k in errors(model).values()), strict=True)
    )
    low, high = chi2(degrees.sum()).interval(0.99)
    assert low < d2.sum() < high
    assert not (low < (d2 * 1.1**2).sum() < high and low < (d2 / 1.1**2).sum() < high)
