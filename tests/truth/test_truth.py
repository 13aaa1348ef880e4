"""The stated covariances, redundancy numbers and detectable blunders are true; sigma wrong by 10 % is noticed.

The short version; benchmarks/truth.py runs 2000 and 4000 adjustments and keeps the figures.
"""

import functools

import numpy as np
import pytest
from scipy.stats import chi2, kstest

from tests.truth.monte_carlo import Network


@functools.cache
def network(kind):
    return Network.of(kind)


@functools.cache
def errors(kind, runs=800):
    return network(kind).errors(runs, seed=11)


QUANTITIES = [
    ("free", "point"), ("free", "image"), ("free", "interior"),
    ("control", "point"), ("control", "image"), ("control", "interior"),
    ("resection", "image"),
]  # fmt: skip


@pytest.mark.parametrize(("kind", "quantity"), QUANTITIES)
def test_errors_follow_the_stated_covariance(kind, quantity):
    d2, degrees = errors(kind)[quantity]
    assert kstest(d2, chi2(degrees).cdf).pvalue > 1e-3
    low, high = chi2(degrees * len(d2)).interval(0.999)
    assert low < d2.sum() < high


@pytest.mark.parametrize(("kind", "quantity"), QUANTITIES)
def test_ten_percent_too_small_a_sigma_is_noticed(kind, quantity):
    d2, degrees = errors(kind)[quantity]
    low, high = chi2(degrees * len(d2)).interval(0.999)
    assert not low < (d2 * 1.1**2).sum() < high
    assert not low < (d2 / 1.1**2).sum() < high


def test_false_alarms_come_as_often_as_stated():
    share, count = network("free").false_alarms(60, seed=5)
    assert abs(share - 0.001) < 4 * np.sqrt(0.001 * 0.999 / count)
    wrong, _ = network("free").false_alarms(60, seed=5, scale=1 / 1.1)
    assert abs(wrong - 0.001) > 4 * np.sqrt(0.001 * 0.999 / count)


def test_the_smallest_detectable_blunder_is_detected_in_eighty_percent():
    runs = 400
    allowed = 4 * np.sqrt(0.8 * 0.2 / runs)
    assert abs(network("free").detection(runs, seed=9) - 0.8) < allowed
    assert abs(network("free").detection(runs, seed=9, scale=1.25) - 0.8) > allowed
