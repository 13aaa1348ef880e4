"""Of a contradiction between control and a scale bar, the bar is named where it alone explains it."""

import numpy as np
import pytest

from raybundle.adjustment.blunders.bar_tests import wrong_bar
from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Distances
from tests.adjustment.test_wrong_control import CORNERS, network

OPTIONS = AdjustmentOptions(jobs=1)
PLACES = (*CORNERS, (0.0, 0.0), (0.0, 1.0))


def with_bars(errors, *, wrong=None, seed=1, sigma=0.02):
    """The network with bars of these errors between tie points, and the names of the bars."""
    block, _ = network(PLACES, sigma=sigma, wrong=wrong, seed=seed)
    xyz, rays = block.points.xyz, np.bincount(block.observations.point, minlength=len(block.points))
    ties = np.flatnonzero((rays >= 4) & ~block.points.is_control.any(axis=1))
    order = ties[np.argsort(xyz[ties, 0])]
    ends = [(int(order[k]), int(order[-1 - k])) for k in range(len(errors))]
    length = np.array([np.linalg.norm(xyz[a] - xyz[b]) for a, b in ends]) + np.array(errors)
    start, end = (np.array(e, np.int32) for e in zip(*ends, strict=True))
    bars = Distances(start=start, end=end, length=length, sigma=np.full(len(errors), 0.002))
    names = [f"{block.points.ids[a]}-{block.points.ids[b]}" for a, b in ends]
    return block.having(bars), names


def faults(result):
    return [n for n in result.notices if n.severity == "fault" and n.code != "global_test"]


@pytest.mark.parametrize("error", [0.3, 1.0, -1.0])
def test_a_wrong_bar_is_named_and_control_is_not(error):
    block, (name,) = with_bars([error])
    result = decide(block, OPTIONS)
    (first,) = faults(result)
    assert (first.data.code, first.ids) == ("distance_suspect.control", (name,))
    assert first.values["before"] > first.values["after"]
    bar = wrong_bar(result, result.critical_w)
    assert bar.length - bar.shown == pytest.approx(error, abs=0.1)


def test_what_is_foretold_without_the_bar_is_what_an_adjustment_without_it_gives():
    block, _ = with_bars([0.6])
    bar = wrong_bar(decide(block, OPTIONS), 3.0)
    (control,) = [g for g in decide(block.having(Distances.empty()), OPTIONS).groups if g.kind == "control"]
    assert bar.after == pytest.approx(np.sqrt(control.square.sum() / control.redundancy.sum()), rel=0.01)


def test_the_wrong_one_of_two_bars_is_named():
    block, names = with_bars([0.0, 0.8])
    (first,) = faults(decide(block, OPTIONS))
    assert first.ids == (names[1],)


@pytest.mark.parametrize("seed", range(6))
def test_right_bars_and_control_are_not_doubted(seed):
    block, _ = with_bars([0.0, 0.0], seed=seed)
    result = decide(block, OPTIONS)
    assert wrong_bar(result, result.critical_w) is None
    assert not faults(result)


def test_a_wrong_control_point_beside_right_bars_is_said_of_the_control():
    block, _ = with_bars([0.0, 0.0], wrong={2: [2.0, 0.0, 0.0]})
    result = decide(block, OPTIONS)
    assert wrong_bar(result, result.critical_w) is None
    assert any(n.code in {"group_less_precise", "control_suspect", "control_not_located"} for n in faults(result))
