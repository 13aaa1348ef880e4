"""RMSE at check points as ASPRS defines it, wanted accuracies, and control left out point by point."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.special import chdtrc

from raybundle.adjustment.blunders.accuracy import Accuracy, required_check_points
from raybundle.adjustment.blunders.accuracy_class import AccuracyClass, accuracy_class, all_kept, judged
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import InputError
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from tests.docs.figures import in_a_row

OPTIONS = AdjustmentOptions(jobs=1, noise="white")
SURVEY = Survey(
    control=9, control_sigma=(0.03, 0.03, 0.04), check=12, check_sigma=0.02, orientation="exact", points="exact",
    interior="exact",
)  # fmt: skip


def flight(**changed):
    return simulate(aerial_scene(AerialStrips()), replace(SURVEY, **changed)).observed


@pytest.fixture(scope="module")
def block():
    return flight()


@pytest.fixture(scope="module")
def result(block):
    return adjust_block(block, OPTIONS)


def test_rmse_has_the_differences_and_the_error_of_the_check_points(result):
    given, adjusted = result.given.points, result.adjusted.points
    rows = [k for k, r in enumerate(given.role) if r == 2]
    d, s = adjusted.xyz[rows] - given.xyz[rows], given.sigma[rows]
    assert len(rows) == 12
    e, n, h = np.sqrt((d**2).mean(axis=0))
    t = Accuracy(result).tested
    assert t.rmse_h == pytest.approx(math.sqrt(e**2 + n**2 + (s[:, :2] ** 2).sum(axis=1).mean()))
    assert t.rmse_v == pytest.approx(math.sqrt(h**2 + (s[:, 2] ** 2).mean()))
    assert t.rmse_3d == pytest.approx(math.hypot(t.rmse_h, t.rmse_v))
    assert t.stated
    said = Accuracy(result).as_mapping()["asprs"]
    assert (said["check_points_horizontal"], said["check_points_needed"], said["enough"]) == (12, 30, False)


def test_check_points_that_state_nothing_are_told(block):
    sigma = block.points.sigma.copy()
    sigma[block.points.role == 2] = np.nan
    t = Accuracy(adjust_block(replace(block, points=replace(block.points, sigma=sigma)), OPTIONS)).tested
    assert not t.stated
    assert t.second_h == 0


@pytest.mark.parametrize(
    ("km2", "points"),
    [(math.nan, 30), (0.1, 30), (1000, 30), (1000.5, 40), (2000, 40), (2001, 50), (9500, 120), (50_000, 120)],
)
def test_large_areas_need_more_check_points(km2, points):
    assert required_check_points(km2) == points


def without(block, name):
    """The block in which a control point is measured and no more."""
    k = block.points.ids.index(name)
    role = block.points.role.copy()
    role[k] = 0
    return replace(block, points=replace(block.points, role=role)), k


def test_a_point_left_out_is_where_the_adjustment_without_it_puts_it(block, result):
    left = Accuracy(result).left_out
    assert len(left.rows) == 9
    for row, d in zip(left.rows, left.difference, strict=True):
        less, k = without(block, block.points.ids[row])
        truly = adjust_block(less, OPTIONS).adjusted.points.xyz[k] - block.points.xyz[k]
        assert np.linalg.norm(d - truly) < 0.03 * np.linalg.norm(truly)


def test_a_held_point_left_out_as_well():
    held = flight(control_sigma=(0.0, 0.0, 0.0))
    left = Accuracy(adjust_block(held, OPTIONS)).left_out
    for row, d in zip(left.rows[:3], left.difference[:3], strict=True):
        less, k = without(held, held.points.ids[row])
        truly = adjust_block(less, OPTIONS).adjusted.points.xyz[k] - held.points.xyz[k]
        assert np.linalg.norm(d - truly) < 0.03 * np.linalg.norm(truly)


def test_a_whole_point_left_out_is_that_of_its_residual_and_covariance(result):
    """d = (I - Q P)^-1 v from what the result states."""
    left = Accuracy(result).left_out
    given = result.given.points
    k = int(left.rows[0])
    Q = result.precision.object_points[k] / result.sigma0**2
    P = np.diag(1 / given.sigma[k] ** 2)
    v = result.adjusted.points.xyz[k] - given.xyz[k]
    np.testing.assert_allclose(left.difference[0], np.linalg.solve(np.eye(3) - Q @ P, v), rtol=1e-5, atol=1e-9)


def test_coordinates_one_at_a_time_differ_from_whole_points(result):
    """The other coordinates of a point hold one that is left out alone."""
    accuracy = Accuracy(result)
    single = np.array([v for _, _, v in accuracy.coordinates_left_out]).reshape(-1, 3)
    whole = accuracy.left_out.difference
    assert single.shape == whole.shape
    assert not np.allclose(single, whole, rtol=1e-6, atol=0)


def test_without_statistics_no_point_is_left_out(block):
    bare = adjust_block(block, replace(OPTIONS, statistics=False))
    assert not Accuracy(bare).left_out.any
    assert Accuracy(bare).tested is not None


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", None),
        ("0.03", (0.03, 0.03, False)),
        ("0.03,0.05", (0.03, 0.05, False)),
        ("30mm, 5 cm", (0.03, 0.05, False)),
        ("-,0.05", (None, 0.05, False)),
        ("asprs:2.5cm,5cm", (0.025, 0.05, True)),
        ("ASPRS:5cm", (0.05, 0.05, True)),
        ("asprs:2.5cm,-", (0.025, None, True)),
    ],
)
def test_what_a_setting_asks_for(text, expected):
    found = accuracy_class(text)
    told = None if found is None else (found.horizontal, found.vertical, found.asprs)
    assert told == (expected if expected is None else pytest.approx(expected))


@pytest.mark.parametrize(
    "text", ["good", "0", "-1", "-,-", "1,2,3", "3 feet", "asprs:", "nan", "0.03,", "asprs:x,5cm", "asprs:5"]
)
def test_what_is_no_accuracy_is_refused_with_what_to_give(text):
    with pytest.raises(InputError, match=r"accuracy_class\.no_unit|accuracy_class\.not_readable"):
        accuracy_class(text)


def told(result, horizontal=None, vertical=None, *, asprs=False):
    wanted = AccuracyClass(horizontal=horizontal, vertical=vertical, asprs=asprs)
    parts = judged(Accuracy(result), wanted)
    return parts, all_kept(parts)


def test_figures_in_metres_are_kept_or_not(result):
    t = Accuracy(result).tested
    assert told(result, 1.01 * t.rmse_h, 1.01 * t.rmse_v)[1] is True
    parts, kept = told(result, 0.99 * t.rmse_h, 1.01 * t.rmse_v)
    assert kept is False
    assert [p.kept for p in parts] == [False, True]


def test_twelve_check_points_are_no_test_of_asprs_but_may_deny_it(result):
    t = Accuracy(result).tested
    parts, kept = told(result, 1.01 * t.rmse_h, asprs=True)
    assert kept is None
    assert (parts[0].why, parts[0].points, parts[0].needed) == ("untested", 12, 30)
    assert told(result, 0.99 * t.rmse_h, asprs=True)[1] is False


def test_a_few_check_points_deny_what_chance_does_not_explain():
    few = adjust_block(flight(check=3), OPTIONS)
    t = Accuracy(few).tested
    # a little beyond is within chance of three points, thrice is not
    parts, kept = told(few, 0.99 * t.rmse_h, asprs=True)
    assert kept is None
    assert not parts[0].claimable
    assert told(few, t.rmse_h / 3, asprs=True)[1] is False


def test_standard_deviations_deny_a_class_that_no_check_point_tests():
    none = adjust_block(flight(check=0), OPTIONS)
    accuracy = Accuracy(none)
    std = np.sqrt(np.diagonal(none.precision.object_points, axis1=1, axis2=2))
    std = std[(std > 0).all(axis=1)]
    half = float(np.median(np.linalg.norm(std[:, :2], axis=1)))
    assert accuracy.promised("horizontal") == pytest.approx(half, rel=1e-12)
    assert accuracy.promised("vertical") == pytest.approx(float(np.median(std[:, 2])), rel=1e-12)
    parts, kept = told(none, 0.99 * half, 1e3 * half, asprs=True)
    assert kept is False
    assert [(p.kept, p.why) for p in parts] == [(False, "precision"), (None, "none")]
    assert [p.claimable for p in parts] == [False, True]


def test_control_left_out_denies_a_claim_and_heights_that_nobody_gave_are_none():
    none = adjust_block(flight(check=0), OPTIONS)
    accuracy = Accuracy(none)
    d = accuracy.left_out.difference
    rmse = float(np.sqrt((d[:, :2] ** 2).sum(axis=1).mean()))
    assert accuracy.rmse_left_out("horizontal", 1) == pytest.approx(rmse, rel=1e-12)
    assert math.isnan(accuracy.rmse_left_out("horizontal", len(d) + 1))
    between = AccuracyClass(horizontal=(rmse + accuracy.promised("horizontal")) / 2, vertical=1e3, asprs=True)
    plan, height = judged(accuracy, between, heights=False)
    assert len(d) == 9
    assert (plan.kept, plan.why, plan.claimable) == (None, "left out", False)
    assert (height.kept, height.why, height.claimable) == (None, "heights", False)


def test_what_no_check_point_has_is_not_judged(block):
    sigma = block.points.sigma.copy()
    sigma[block.points.role == 2, 2] = np.nan
    plan = adjust_block(replace(block, points=replace(block.points, sigma=sigma)), OPTIONS)
    parts, kept = told(plan, 10.0, 10.0)
    assert kept is None
    assert [(p.kept, p.why) for p in parts] == [(True, ""), (None, "none")]
    assert math.isnan(parts[1].found)
    none = adjust_block(flight(check=0), OPTIONS)
    assert told(none, 10.0, 10.0)[1] is None


def test_too_few_check_points_are_not_called_kept(block):
    few = adjust_block(flight(check=3), OPTIONS)
    parts, kept = told(few, 10.0, 10.0)
    assert kept is None
    assert {p.why for p in parts} == {"few"}
    assert told(few, 1e-4, 1e-4)[1] is False


def test_the_chances_that_the_page_tells_are_those_of_chi_square():
    page = (Path(__file__).parents[2] / "docs/how-to/accuracy-class.md").read_text(encoding="utf-8")
    chance = {(n, share): round(100 * float(chdtrc(n, n / share**2))) for n in (5, 30) for share in (1.0, 0.8)}
    right, better = ([f"{chance[n, share]}" for n in (5, 30)] for share in (1.0, 0.8))
    assert in_a_row(page, right[0], "5", right[1], "30", "0.8", *better)
