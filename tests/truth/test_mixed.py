"""Frames, pushbroom, panoramas, RPC and rigorous scenes in one adjustment: the stated covariances are true.

Together (all points of a run; all its images and parameters) they are true to 10 %, and the compiled kernels and their
NumPy twin agree on each block.

The short version; benchmarks/truth_sensors.py runs 1000 adjustments of each block.
"""

import functools

import numpy as np
import pytest
from scipy.stats import chi2, kstest

from raybundle.numerics import native
from tests.truth.bands import assert_true_to_ten_percent
from tests.truth.mixed_blocks import MonteCarlo, errors_and_joint, ikonos_pair, mixed, two_camera_rig
from tests.truth.twins import assert_the_twin_agrees

BLOCKS = {
    "pair": (ikonos_pair, 400),
    "pair, affine bias and rigorous scene": (functools.partial(ikonos_pair, "affine", ("backward",)), 120),
    "mixed": (mixed, 60),
    "rig": (two_camera_rig, 100),
}
KINDS = {
    "pair": {"tie point", "check point", "control point", "parameters of forward", "parameters of backward"},
    "mixed": {
        "tie point", "check point", "control point", "image of frame", "image of pushbroom", "image of panorama",
        "parameters of frame", "parameters of pushbroom by image", "parameters of panorama", "parameters of forward",
        "parameters of backward",
    },
    "rig": {"tie point", "check point", "control point", "image of left", "image of right", "parameters of right"},
}  # fmt: skip


TOGETHER = ("all points", "all images and parameters")


@functools.cache
def errors(name):
    block, runs = BLOCKS[name]
    return errors_and_joint(block(), runs, seed=17)


@pytest.mark.long
@pytest.mark.parametrize("name", BLOCKS)
def test_errors_follow_the_stated_covariance(name):
    found, _ = errors(name)
    assert KINDS.get(name, set(found)) == set(found)
    for kind, (d2, degrees) in found.items():
        low, high = chi2(degrees * len(d2)).interval(0.999)
        assert low < d2.sum() < high, kind
        assert kstest(d2, chi2(degrees).cdf).pvalue > 1e-4, kind


@pytest.mark.long
@pytest.mark.parametrize("together", TOGETHER)
@pytest.mark.parametrize("name", BLOCKS)
def test_stated_covariances_are_true_to_ten_percent(name, together):
    d2, degrees = errors(name)[1][together]
    assert_true_to_ten_percent(d2, degrees, together)
    assert kstest(d2, chi2(degrees).cdf).pvalue > 1e-3


@pytest.mark.skipif(not native.available(), reason="the kernels are not compiled")
@pytest.mark.parametrize("name", BLOCKS)
def test_the_twin_agrees(name, monkeypatch):
    """Shared stations, parameters of single images and scenes: the same step and statistics from both."""
    truth = BLOCKS[name][0]()
    assert_the_twin_agrees(MonteCarlo.of(truth).noisy(np.random.default_rng(1)), monkeypatch)
