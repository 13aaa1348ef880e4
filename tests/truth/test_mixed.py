"""Frames, pushbroom, panoramas, RPC and rigorous scenes in one adjustment: the stated covariances are true.

The short version; benchmarks/truth_sensors.py runs 1000 adjustments of each block.
"""

import functools

import numpy as np
import pytest
from scipy.stats import chi2, kstest

from tests.truth.mixed_blocks import MonteCarlo, ikonos_pair, mixed, two_camera_rig

BLOCKS = {
    "pair": (ikonos_pair, 150),
    "pair, affine bias and rigorous scene": (functools.partial(ikonos_pair, "affine", ("backward",)), 30),
    "mixed": (mixed, 60),
    "rig": (two_camera_rig, 150),
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


@functools.cache
def errors(name):
    block, runs = BLOCKS[name]
    return MonteCarlo.of(block()).errors(runs, seed=17)


@pytest.mark.parametrize("name", BLOCKS)
def test_errors_follow_the_stated_covariance(name):
    found = errors(name)
    assert KINDS.get(name, set(found)) == set(found)
    for kind, (d2, degrees) in found.items():
        low, high = chi2(degrees * len(d2)).interval(0.999)
        assert low < d2.sum() < high, kind
        assert kstest(d2, chi2(degrees).cdf).pvalue > 1e-4, kind


@pytest.mark.parametrize("name", ["pair", "mixed", "rig"])
def test_ten_percent_too_small_a_sigma_is_noticed(name):
    d2, degrees = (
        np.concatenate(a) for a in zip(*((v, np.full(len(v), k)) for v, k in errors(name).values()), strict=True)
    )
    low, high = chi2(degrees.sum()).interval(0.999)
    assert not low < (d2 * 1.1**2).sum() < high
    assert not low < (d2 / 1.1**2).sum() < high
