"""Blocks through the whole door, as `benchmarks/truth_door.py` takes 500: a few of one kind, whose sum has teeth."""

import pytest

from tests.truth.door import score, verdict
from tests.truth.door_blocks import CASES

RUNS = 12


@pytest.mark.long
def test_points_after_all_decisions_are_as_precise_as_stated():
    case = CASES["close range"]()
    runs = [score(case, 1000 + seed) for seed in range(RUNS)]
    assert sum(r["gross"] for r in runs) > 2 * RUNS  # there was something to find
    assert sum(len(r["left"]) for r in runs) < 0.1 * sum(r["gross"] for r in runs)
    found = verdict(runs, "points", 1.0)
    assert found["inside"], found
    assert found["high"] / found["low"] < 1.1**4  # a band in which 10 % in sigma, either way, cannot hide
    for wrong in (1.1, 1 / 1.1):
        assert not verdict(runs, "points", wrong)["inside"]
