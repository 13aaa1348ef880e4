"""A control point is left out where an adjustment with it rejects it, it is located, and the datum stays."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.decision.wrong_control import WrongControl, kept_notice, suspected
from raybundle.adjustment.records.figures import ObservationGroup
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Role
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene

OPTIONS = AdjustmentOptions(jobs=1, reject="snooping")
CORNERS = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))


def network(places, sigma=0.02, wrong=None, seed=1, strips=2):
    """An aerial block with control near these shares of its half extents, and the names; `wrong` {number: shift}."""
    survey = Survey(seed=seed, orientation="approximate", points="exact", interior="exact")
    simulated = simulate(aerial_scene(AerialStrips(strips=strips)), survey)
    block, truth = simulated.observed, simulated.truth.points.xyz
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    good = np.flatnonzero(rays >= 4)
    middle, half = (np.max(truth[good], axis=0) + np.min(truth[good], axis=0)) / 2, np.ptp(truth[good], axis=0) / 2
    chosen = [good[np.linalg.norm((truth[good] - middle)[:, :2] / half[:2] - p, axis=1).argmin()] for p in places]
    role, xyz, sigmas = block.points.role.copy(), block.points.xyz.copy(), block.points.sigma.copy()
    role[chosen], sigmas[chosen] = Role.CONTROL, sigma
    xyz[chosen] = truth[chosen] + np.random.default_rng(seed).normal(0, sigma, (len(chosen), 3))
    for k, shift in (wrong or {}).items():
        xyz[chosen[k]] += shift
    points = replace(block.points, role=role, xyz=xyz, sigma=sigmas)
    return replace(block, points=points), [block.points.ids[k] for k in chosen]


def told(result, code):
    return [n for n in result.notices if n.code == code]


def test_a_wrong_one_of_many_is_left_out_by_name():
    block, names = network((*CORNERS, (0.0, 0.0), (0.0, 1.0)), wrong={2: [2.0, 0.0, 0.0]})
    result = decide(block, OPTIONS)
    assert [n.ids for n in told(result, "control_rejected")] == [(names[2],)]
    assert not told(result, "control_not_located")


def test_what_two_or_three_points_say_of_one_another_locates_none():
    """Of three points that disagree in their distances, none is known to be the wrong one."""
    block, names = network(CORNERS[:3], wrong={1: [3.0, 0.0, 0.0]})
    result = decide(block, OPTIONS)
    assert not told(result, "control_rejected")
    assert result.datum_defect == ()
    (kept,) = told(result, "control_not_located")
    assert set(kept.ids) == set(names)
    assert kept.severity == "fault"
    assert kept.code == "control_not_located"


def test_a_point_without_which_the_datum_is_open_stays():
    """Points that lie on a line, as far as they were measured, and one beside it that alone tells the rotation."""
    line = [(x, 0.0) for x in (-1.0, -0.5, 0.0, 0.5, 1.0)]
    block, names = network((*line, (0.0, 1.0)), sigma=25.0, wrong={5: [900.0, 0.0, 0.0]}, strips=5)
    result = decide(block, OPTIONS)
    assert not told(result, "control_rejected")
    assert result.datum_defect == ()
    (kept,) = told(result, "control_not_located")
    assert kept.ids == (names[5],)
    assert (kept.data.code, kept.values["part"]) == ("control_not_located.datum", "about_line")


def test_right_control_is_kept_and_nothing_said():
    for seed in range(3):
        result = decide(network(CORNERS[:3], sigma=1.0, seed=seed)[0], OPTIONS)
        assert result.datum_defect == ()
        assert not told(result, "control_rejected")
        assert not told(result, "control_not_located")


def test_a_redundancy_number_that_is_rounding_tests_nothing():
    """Three points tell heights and tilts exactly; what rounding leaves of redundancy made a test value of any size."""
    block, _ = network(((-1.0, -0.05), (-1.0, 0.05), (1.0, 0.05)), sigma=1.0)
    result = decide(block, OPTIONS)
    control: ObservationGroup = next(g for g in result.groups if g.kind == "control")
    height = np.array(control.component) == "Z"
    assert (control.redundancy[height] == 0).all()
    assert np.isnan(control.t[height]).all()
    assert suspected(result) is None


@pytest.mark.parametrize(
    ("wrong", "code"),
    [
        (WrongControl(name="a", w=9.0, limit=4.0, open=("scale",)), "control_not_located.datum"),
        (WrongControl(name="a", w=9.0, limit=4.0, settled=False), "control_not_located.unfinished"),
        (WrongControl(name="a", w=9.0, limit=4.0, others=("b",)), "control_not_located"),
    ],
)
def test_why_it_takes_part_is_said(wrong, code):
    assert not wrong.may_go
    assert kept_notice(wrong).data.code == code


SIX = (*CORNERS, (0.0, 0.0), (0.0, 1.0))
TEN = (*SIX, (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0), (0.5, 0.5))


def accused(result):
    """All control points that a fault names."""
    return {i for n in result.notices if n.severity == "fault" and n.code.startswith("control_") for i in n.ids}


def precision_of(block, name):
    """Standard deviation (3,) with which the others know a point."""
    k = block.points.ids.index(name)
    role, sigma = block.points.role.copy(), block.points.sigma.copy()
    role[k], sigma[k] = Role.TIE, np.nan
    free = adjust(replace(block, points=replace(block.points, role=role, sigma=sigma)), AdjustmentOptions(jobs=1))
    return free.precision.object_point_std[k]


def six_held(seed, by, strips):
    """A block with six held points of which one is wrong by so many of its standard deviations, and its name."""
    block, names = network(SIX, sigma=0.0, seed=seed, strips=strips)
    sign = np.random.default_rng(seed).choice([-1.0, 1.0], 3)
    shift = by * sign * precision_of(block, names[seed]) / np.sqrt(3)
    return network(SIX, sigma=0.0, seed=seed, wrong={seed: shift}, strips=strips)[0], names[seed]


@pytest.mark.parametrize("reject", ["none", "snooping"])
@pytest.mark.parametrize("by", [10.0, 50.0])
@pytest.mark.parametrize("seed", range(5))
def test_held_control_that_is_wrong_is_named_and_no_right_one(seed, by, reject):
    """Wrong by 10 and 50 standard deviations of what the others know of it: large errors bend the block to them."""
    wrong, name = six_held(seed, by, strips=3)
    assert accused(adjust(wrong, replace(OPTIONS, reject=reject))) == {name}


def test_two_held_points_that_cannot_be_told_apart_are_both_named():
    """Corners at one end of two strips: of 10 standard deviations of one, 5 % remain for the other to explain."""
    wrong, name = six_held(0, 10.0, strips=2)
    (notice,) = told(adjust(wrong, replace(OPTIONS, reject="none")), "control_not_located")
    assert name in notice.ids
    assert len(notice.ids) == 2


@pytest.mark.parametrize("seed", range(5))
def test_three_wrong_ones_of_ten_are_named_the_worst_first(seed):
    sigma = 0.02
    rng = np.random.default_rng(seed)
    chosen = rng.choice(10, 3, replace=False)
    d = rng.normal(size=(3, 3))
    d *= np.array([[20], [35], [50]]) * sigma / np.linalg.norm(d, axis=1, keepdims=True)
    shifts = dict(zip(chosen.tolist(), d, strict=True))
    block, names = network(TEN, sigma=sigma, seed=seed, wrong=shifts, strips=3)
    result = adjust(block, AdjustmentOptions(jobs=1))
    assert accused(result) == {names[k] for k in chosen}
    assert not told(result, "group_less_precise")
    (notice,) = told(result, "control_suspect")
    w = [d.values["w"] for d in notice.details if d.code == "control_suspect.point"]
    assert len(w) == 3
    assert w == sorted(w, reverse=True)


@pytest.mark.parametrize("sigma", [0.0, 0.02])
@pytest.mark.parametrize("shift", [0.3, 3.0])
@pytest.mark.parametrize("reject", ["none", "snooping"])
def test_that_one_of_three_is_wrong_is_said_once(sigma, shift, reject):
    block, names = network(CORNERS[:3], sigma=sigma, wrong={1: [shift, 0.0, 0.0]})
    result = adjust(block, replace(OPTIONS, reject=reject))
    faults = [n for n in result.notices if n.severity == "fault" and n.code.startswith("control_")]
    assert [set(n.ids) for n in faults] == [set(names)]
    assert faults[0].code == "control_not_located" or faults[0].variant == "one_of_few"
    assert all(r is None for r in result.image_observations.rejected)


@pytest.mark.long
def test_many_wrong_ones_of_eighty_end_in_a_result():
    """The choices of 27 of 80 points are more than 2^63."""
    places = [(x, y) for x in np.linspace(-1, 1, 10) for y in np.linspace(-1, 1, 10)]
    rng = np.random.default_rng(3)
    wrong = {int(k): rng.normal(0, 0.15, 3) for k in rng.choice(100, 45, replace=False)}
    block, names = network(places, wrong=wrong, strips=5)
    assert len(set(names)) == 80
    assert any(n.severity == "fault" for n in decide(block, AdjustmentOptions(jobs=1)).notices)
