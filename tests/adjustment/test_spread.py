"""A mean standard deviation that few points make is told with the median; another is not."""

import numpy as np
import pytest

from raybundle.adjustment.statistics.far_points_share import few_hold
from raybundle.adjustment.statistics.network import _without_few


def test_three_far_points_of_thousands_are_told_with_their_share():
    std = np.full((5000, 3), 0.0026)
    std[:3] = 8.0
    few = few_hold(std)
    assert (few.points, few.of) == (2, 5000)
    assert few.share == pytest.approx(2 / 3, abs=1e-3)
    assert few.coordinate == pytest.approx(0.0026)
    assert few.median == pytest.approx([0.0026] * 3)


@pytest.mark.parametrize("spread", [0.0, 0.35, 0.7])
def test_points_that_differ_as_they_do_are_not(spread):
    rng = np.random.default_rng(2)
    assert few_hold(np.exp(rng.normal(0, spread, (400, 1))) * np.ones((400, 3))) is None


def test_nothing_is_said_of_no_points_or_exact_ones():
    assert few_hold(np.zeros((0, 3))) is None
    assert few_hold(np.zeros((4, 3))) is None


def test_a_few_far_points_do_not_govern_the_relative_precision():
    std = np.full((400, 3), 0.001)
    std[:3] = 5.0
    assert _without_few(std).max() == 0.001
    assert len(_without_few(std)) == 380
    even = np.full((400, 3), 0.001)
    assert _without_few(even) is even
