"""Tests of groups by tables of F, and shares of what was rejected by counting."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import f

import raybundle as rb
from raybundle.adjustment.blunders.rejected_groups import rejected_group_notices
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.components import _tested, differs, without_worst
from raybundle.block.rejection import Rejection, RejectionKind
from tests.native.cases import block_of


@pytest.mark.parametrize(("r", "others"), [(0.5, 30.0), (6.0, 30.0), (40.0, 3.0), (500.0, 2000.0)])
def test_a_group_differs_at_one_percent_two_sided(r, others):
    """A value of which the others check a half only is v^2 / (s^2 r) = w^2, of one degree of freedom all the same."""
    law = f(max(r, 1), others)
    for p, outside in ((0.0049, True), (0.0051, False), (0.9949, False), (0.9951, True)):
        ratio = law.ppf(p) * 1.7
        assert differs(ratio * r, r, (ratio * r + 1.7 * others, r + others)) is outside
    assert not differs(9 * r, r, (9 * r + 0.9, r + 0.9)), "what is left has no redundancy"
    assert not differs(1.0, 0.009, (40.0, 30.0))


def test_the_worst_kind_leaves_before_the_others_are_tested():
    """Distances ten times as far off as control: beside them control seems to fit too well, and does not."""
    image = ("image observations", "all", 400, 300.0, 300.0)
    control = ("control", "all", 30, 20.0, 20.0)
    raw = [image, control, ("distances", "all", 10, 900.0, 8.0), ("image", "A", 40, 30.0, 30.0),
           ("image", "B", 40, 90.0, 30.0), ("stations", "all", 3, 0.0, 0.001)]  # fmt: skip
    found = {(c.kind, c.group): c for c in _tested(raw)}
    assert {k for k, c in found.items() if c.significant} == {("distances", "all"), ("image", "B")}
    for kind, group, count, square, r in raw[:-1]:
        c = found[kind, group]
        assert (c.count, c.redundancy) == (count, r)
        assert c.ratio == pytest.approx(np.sqrt(square / r))
    assert np.isnan(found["stations", "all"].ratio)
    too_good = [image, control, ("distances", "all", 10, 0.01, 8.0)]
    assert [c.significant for c in _tested(too_good)] == [False, False, True]
    # cameras stand for the image observations that they share
    cameras = [image, ("camera", "1", 200, 150.0, 150.0), ("camera", "2", 200, 600.0, 150.0)]
    assert [c.significant for c in _tested(cameras)] in ([False, True, False], [False, False, True])


@pytest.fixture(scope="module")
def result():
    return adjust_block(block_of(control=6, control_sigma=(1e-3,) * 3, scale_bars=1), AdjustmentOptions(jobs=1))


def test_a_group_without_its_largest_test_value(result):
    g = next(g for g in result.groups if g.kind == "control")
    square, r = without_worst(g)
    assert square == pytest.approx(g.square.sum() - np.nanmax(g.w**2))
    assert r == pytest.approx(np.nansum(g.redundancy) - 1)


def with_blunders(result, lost):
    reasons = tuple(Rejection(kind=RejectionKind.BLUNDER) if k else None for k in lost)
    return replace(result, image_observations=replace(result.image_observations, rejected=reasons))


def test_images_and_control_of_which_most_was_rejected_are_named(result):
    """More than half of the ten or more points of an image, and three times what is usual; of control two points."""
    block, o = result.given, result.given.observations
    control = np.flatnonzero(block.points.is_control.any(axis=1) & (block.ray_count > 3))
    mine = np.flatnonzero(o.image == 1)
    half = len(mine) // 2
    for number, due in ((half, False), (half + 1, True)):
        lost = np.zeros(len(o), bool)
        lost[mine[:number]] = True
        found = [n for n in rejected_group_notices(with_blunders(result, lost)) if n.code == "image_contradicts"]
        assert [n.ids for n in found] == ([(block.images.ids[1],)] if due else [])
    few = with_blunders(result, lost & (o.image < 0))
    assert not rejected_group_notices(few)
    for points, due in ((control[:1], True), (control[:2], True)):
        lost = np.isin(o.point, points) & (o.image > 0)
        found = [n for n in rejected_group_notices(with_blunders(result, lost)) if n.code == "control_contradicts"]
        assert [n.ids for n in found] == ([tuple(block.points.ids[k] for k in points)] if due else [])


def test_a_joint_covariance_of_several_things_is_that_of_each_pair(result):
    ids = result.given.points.ids
    names = [f"point:{ids[0]}", "camera:1", f"image:{result.given.images.ids[2]}", f"point:{ids[4]}"]
    found = rb.covariance(result, names)
    assert len(found.names) == len(found.matrix) == 3 + len(result.interior[0].free) + 6 + 3
    np.testing.assert_allclose(found.matrix, found.matrix.T)
    at = {name: [k for k, n in enumerate(found.names) if n.startswith(name)] for name in names}
    for a in names:
        for b in names:
            np.testing.assert_allclose(found.matrix[np.ix_(at[a], at[b])], result.covariance(a, b), rtol=1e-9, atol=0)
