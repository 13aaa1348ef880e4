"""Of a wrong observation it is told what was given and what all else shows, and which others may be meant."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.blunders.suspects import leverages
from raybundle.adjustment.decision import variance_groups
from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.decision.variance_groups import by_groups
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.numerics.counting import decimals_for
from tests.adjustment.test_bar_tests import with_bars

OPTIONS = AdjustmentOptions(jobs=1, datum="auto")


def free_with(errors):
    """A free network whose scale comes from bars alone."""
    block, names = with_bars(errors)
    points = block.points
    return replace(block, points=replace(points, role=np.zeros_like(points.role))), names


def suspects(result):
    return {n.ids[0]: n for n in result.notices if n.code == "distance_suspect"}


def test_of_two_bars_that_contradict_each_other_nobody_knows_which_is_wrong():
    block, names = free_with([0.0, 0.5])
    told = suspects(decide(block, OPTIONS))
    assert set(told) == set(names)
    for name, other in (names, names[::-1]):
        (detail,) = told[name].details
        assert (detail.code, detail.values["names"]) == ("suspect.others", [other])
    given, shown, off = (told[names[1]].values[k] for k in ("given", "shown", "off"))
    assert given == pytest.approx(block.distances.length[1], abs=0.01)
    assert off == pytest.approx(-0.5, abs=0.02)
    assert given - shown == pytest.approx(0.5, abs=0.02)


def test_of_three_the_wrong_one_is_named_alone():
    block, names = free_with([0.0, 0.5, 0.0])
    told = suspects(decide(block, OPTIONS))
    assert set(told) == {names[1]}
    assert [d.code for d in told[names[1]].details] == ["suspect.beside"]
    assert told[names[1]].values["off"] == pytest.approx(-0.5, abs=0.02)


def test_leverages_are_one_less_the_redundancy_numbers():
    block, _ = free_with([0.0, 0.5, 0.0])
    result = decide(block, OPTIONS)
    (group,) = [g for g in result.groups if g.kind == "distance"]
    meet = leverages(result, "distance", np.arange(3))
    np.testing.assert_allclose(1 - np.diagonal(meet), group.redundancy, atol=1e-8)


def test_what_is_left_out_shows_what_was_foretold():
    block, names = free_with([0.0, 0.5, 0.0])
    notice = suspects(decide(block, OPTIONS))[names[1]]
    without = decide(block.having(block.distances.rows(np.array([0, 2]))), OPTIONS).adjusted.points.xyz
    a, b = int(block.distances.start[1]), int(block.distances.end[1])
    assert notice.values["shown"] == pytest.approx(float(np.linalg.norm(without[a] - without[b])), abs=0.01)


@pytest.mark.parametrize(("size", "digits"), [(0.5, 2), (0.0053, 4), (12.0, 0), (1e-6, 7), (0.0, 3), (np.nan, 3)])
def test_numbers_have_the_digits_of_what_they_are_off_by(size, digits):
    assert decimals_for(size) == digits


def test_factors_of_groups_that_do_not_settle_leave_one_factor_and_name_what_contradicts(monkeypatch):
    monkeypatch.setattr(variance_groups, "ROUNDS", 1)
    block, names = free_with([0.0, 0.5])
    result = by_groups(block, replace(OPTIONS, variance_groups=True), decide)
    assert not result.options.variance_groups
    assert result.variance_factor == pytest.approx(result.sigma0**2)
    assert [n.severity for n in result.notices if n.data.code == "variance_groups.unsettled"] == ["warning"]
    assert set(suspects(result)) == set(names)
