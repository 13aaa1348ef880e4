"""Scale bars against each other in a free network: false alarms, the wrong one, what they get."""

import numpy as np
import pytest
from scipy.special import chdtrc
from tests.metrology.measured_sets import TURN, drawn, free_covariance, places, root_of

from raybundle.metrology.bars import Bar, bars_compared

XYZ = places(8)
C = free_covariance(XYZ, np.random.default_rng(0))
ROOT = root_of(C)
PAIRS = ((0, 1), (2, 3), (4, 5), (1, 6))
SIGMA = 2e-5


def network(rng):
    return drawn("free", XYZ, C, ROOT, rng, TURN, (1, 2, 3))


def bars(rng, count, *off):
    """With errors of their certificates, and blunders."""
    made = []
    for k, (a, b) in enumerate(PAIRS[:count]):
        wrong = off[k] if k < len(off) else 0.0
        length = float(np.linalg.norm(XYZ[a] - XYZ[b])) + SIGMA * rng.normal() + wrong
        made.append(Bar(start=f"P{a + 1}", end=f"P{b + 1}", length=length, sigma=SIGMA))
    return made


@pytest.mark.parametrize("count", [2, 4])
def test_right_bars_differ_as_their_standard_deviations_say(count):
    rng = np.random.default_rng(count)
    tests = [bars_compared(network(rng), bars(rng, count)) for _ in range(400)]
    F = np.array([t.whole[0] for t in tests])
    assert F.mean() == pytest.approx(1, abs=4 * np.sqrt(2 / (count - 1) / 400))
    ratio = np.concatenate([t.apart / t.shown_sigma for t in tests])
    assert ratio.std() == pytest.approx(1, abs=0.1)
    assert np.mean([t.contradict for t in tests]) < 0.01
    assert np.mean([t.whole[1] for t in tests]) == pytest.approx(0.5, abs=0.06)
    assert tests[0].whole[1] == pytest.approx(float(chdtrc(count - 1, (count - 1) * tests[0].whole[0])), rel=1e-6)


def test_the_wrong_one_of_several_gets_what_it_differs_by_and_the_others_what_they_state():
    rng = np.random.default_rng(5)
    found = [bars_compared(network(rng), bars(rng, 4, 0.0, 0.0, 0.003)) for _ in range(50)]
    assert all(t.contradict and t.wrong == 2 for t in found)
    assert found[0].apart[2] == pytest.approx(0.003, abs=5 * found[0].shown_sigma[2])
    np.testing.assert_allclose(found[0].sigma, [SIGMA, SIGMA, abs(found[0].apart[2]), SIGMA])


def test_of_two_nobody_knows_which_and_both_get_what_makes_them_agree():
    rng = np.random.default_rng(6)
    t = bars_compared(network(rng), bars(rng, 2, 0.003))
    assert t.contradict
    assert t.wrong is None
    assert t.exchanged is None
    wide = [Bar(start=b.start, end=b.end, length=b.length, sigma=s) for b, s in zip(t.bars, t.sigma, strict=True)]
    again = bars_compared(network(np.random.default_rng(6)), wide)
    assert again.whole[0] == pytest.approx(1, abs=0.3)


def test_exchanged_lengths_are_found_and_points_that_are_not_there_are_passed_over():
    rng = np.random.default_rng(7)
    a, b, c, _ = bars(rng, 4)
    swapped = [
        Bar(start=a.start, end=a.end, length=b.length, sigma=SIGMA),
        Bar(start=b.start, end=b.end, length=a.length, sigma=SIGMA), c,
    ]  # fmt: skip
    assert bars_compared(network(rng), swapped).exchanged == (0, 1)
    assert bars_compared(network(rng), [a, Bar(start="nowhere", end="P1", length=1.0, sigma=SIGMA)]) is None
