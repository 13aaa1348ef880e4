"""A remedy that is named mends what is named: of flights by heights and by what hangs, of missions by their pattern."""

from dataclasses import replace

import numpy as np
import pytest
from tests.missions.cases import ACROSS_30, CAMERA, LEVEL, PLACE, change, mission

from raybundle.errors import InputError
from raybundle.planning.flights.aerial import NO_RTK, UNSOLVED, by_design, is_rtk, mended
from raybundle.planning.flights.flight import plan_flight
from raybundle.planning.flights.mission import Asked, mission_forecast
from raybundle.planning.flights.mission_mends import Mend
from raybundle.planning.flights.uav_networks import Flight, covering, flight_aerial, flight_scene

WALL = np.array([[0.0, 0], [100, 20]]) + PLACE


def test_without_rtk_control_mends_heights_and_not_c():
    """Five points bring Z from metres to centimetres and leave c as it was: tilted lines with them are named."""
    done = plan_flight(Flight(points=12, station_sigma=NO_RTK, alternating=True))
    five = next(r for r in done.remedies if change(r) == ("flight_change.control", {"n": 5}))
    tilted = next(r for r in done.remedies if change(r) == ("flight_change.across_tilted", ACROSS_30))
    assert five.sure
    assert done.gain(five) > 50
    assert done.gains(five)["c"] < 2**0.5  # less than as much again is known of it
    assert five.std_level["c"] > done.planned.std["c"]  # what it has of c is accident still
    assert not done.mends(five)
    assert done.mends(tilted)
    assert done.gain(tilted) < 2
    assert change(done.advised) == ("flight_change.across_tilted", {**ACROSS_30, "control": 5})
    assert done.gain(done.advised) > 50
    assert done.gains(done.advised)["c"] > 10


@pytest.mark.long
@pytest.mark.parametrize("more", [{}, {"lever_arm": True}, {"alternating": True}, {"station_sigma": NO_RTK}], ids=str)
def test_no_remedy_that_mends_everything_is_better_in_all_that_counts(more):
    done = plan_flight(Flight(points=12, **more))
    advised = done.advised
    assert not set(advised.lost_level) | set(advised.lost)
    counted = [lambda r: float(r.sigma_m[2]), *((lambda r, p=p: r.std[p]) for p in done.planned.hanging)]
    for other in (r for r in done.remedies if done.mends(r) and r is not advised):
        assert any(of(advised) <= of(other) * (1 + 1e-9) for of in counted)
    for p in done.planned.hanging:
        assert mended(done.planned.std.get(p, np.inf), advised.std_level[p], advised.std[p])


def test_a_parameter_is_mended_by_design_or_by_more_than_half_of_its_information():
    assert mended(9.3, 20.0, 0.6)
    assert not mended(9.3, 80.0, 9.2)
    assert mended(0.7, 0.6, 0.6)
    assert mended(np.inf, 5.0, 3.0)
    assert not mended(2.0, 2.1, 1.42)
    assert mended(2.0, 2.1, 1.41)


def test_a_lever_arm_is_held_without_rtk_and_the_row_says_so():
    arm = plan_flight(Flight(points=8, lever_arm=True, cross_tilt_deg=30.0))
    assert change(arm.without_rtk) == ("flight_change.without_rtk", {"lever_arm": True})
    assert not arm.without_rtk.plan.lever_arm
    assert not {"ax", "ay", "az"} & set(arm.without_rtk.std)
    plain = plan_flight(Flight(points=8, cross_tilt_deg=30.0)).without_rtk
    assert change(plain) == ("flight_change.without_rtk", {"lever_arm": False})


def test_positions_as_poor_as_a_plain_receivers_are_no_rtk():
    assert is_rtk((0.02, 0.02, 0.03))
    assert not is_rtk(NO_RTK)
    assert not is_rtk((0.02, 0.02, 1.0))
    poor = plan_flight(Flight(points=8, station_sigma=NO_RTK, cross_tilt_deg=30.0))
    assert poor.without_rtk is None
    assert "flight_change.without_rtk" not in [change(r)[0] for r in poor.remedies]


@pytest.mark.parametrize(
    ("pattern", "more", "arm", "expected"),
    [
        ("nadir", {}, False, (Mend(kind="control", control=1), Mend(kind="tilted-grid"))),
        pytest.param("nadir", {}, True, (Mend(kind="oblique-grid"),), marks=pytest.mark.long),
        pytest.param(
            "double-grid", {"tilt": np.radians(20)}, True, (Mend(kind="oblique-grid"),), marks=pytest.mark.long
        ),
        ("corridor", {}, False, (Mend(kind="control", control=1), Mend(kind="again"))),
        ("corridor", {}, True, (Mend(kind="again"),)),
        ("facade", {}, False, (Mend(kind="turned"),)),
    ],
)
def test_each_pattern_has_remedies_of_its_own(pattern, more, arm, expected):
    m = mission(pattern, more=more, outline=WALL if pattern == "facade" else None)
    forecast = mission_forecast(m, LEVEL, Asked(lever_arm=arm))
    assert forecast.lost_even
    kinds = {f.kind for f in forecast.mends}
    assert kinds == {e.kind for e in expected}
    if not arm:
        assert forecast.mends[-1] == expected[-1]


@pytest.mark.long
def test_what_the_pattern_that_is_named_determines_is_what_was_promised():
    """The remedy is tried on the photographs of the plan; the pattern itself, planned anew, keeps the promise."""
    assert "c" in mission_forecast(mission("nadir"), LEVEL).lost_even
    grid = mission("double-grid", more={"tilt": np.radians(20)})
    assert not mission_forecast(grid, LEVEL).lost_even
    assert not mission_forecast(mission("oblique-grid"), LEVEL, Asked(lever_arm=True)).lost_even


@pytest.mark.parametrize("pattern", ["nadir", "facade"])
def test_photographs_that_hold_together_badly_are_told_to_overlap_more(pattern):
    outline = WALL if pattern == "facade" else None
    more = {"heights": (0.0, 18.0), "distance": CAMERA.distance(0.003)} if pattern == "facade" else {}
    thin = mission_forecast(mission(pattern, outline=outline, more={**more, "overlap": (0.3, 0.02)}), LEVEL)
    assert thin.lost_even == (UNSOLVED,)
    assert thin.mends == (Mend(kind="overlap"),)
    thick = mission_forecast(mission(pattern, outline=outline, more={**more, "overlap": (0.3, 0.1)}), LEVEL)
    assert UNSOLVED not in thick.lost_even
    assert "overlap" not in {m.kind for m in thick.mends}


def test_poor_positions_are_forecast_once():
    poor = mission_forecast(mission("nadir"), LEVEL, Asked(station_sigma=NO_RTK))
    assert poor.without_rtk is None
    assert not any(m.kind == "control" for m in poor.mends)  # a point tells where the block is, not c


def test_a_flight_over_a_rectangle():
    sides = (200.0, 300.0)
    assert covering(sides, 40.0, 20.0) == (6, 18)
    assert covering((200.0, 300.0), 200.0, 250.0) == (2, 3)
    lines, photos = covering(sides, 33.0, 15.0)
    plan = Flight(
        lines=lines, photographs=photos, spacing=33.0, base=15.0, size=200.0, length=300.0, points=30,
        cross_tilt_deg=20.0, height_jitter=0.0, angle_jitter_deg=0.0,
    )  # fmt: skip
    scene = flight_scene(plan)
    np.testing.assert_allclose(np.ptp(scene.xyz[:, :2], axis=0), sides)
    step = [np.diff(np.unique(scene.xyz[:, k])).max() for k in (0, 1)]
    assert step[0] == pytest.approx(step[1], rel=0.05)
    for rows in (slice(0, lines * photos), slice(lines * photos, None)):  # along and across, both over all of it
        reach = np.abs(scene.centre[rows, :2]).max(axis=0)
        assert (reach >= np.array(sides) / 2).all()
        assert (reach <= np.array(sides) / 2 + 33.0 + 15.0).all()
    assert by_design(flight_aerial(plan))[0] == ()
    square = replace(plan, length=None)
    assert square.sides == (200.0, 200.0)
    with pytest.raises(InputError, match=r"200.*300.*simulation\.too_few_photographs"):
        flight_aerial(replace(plan, points=4, height=20.0))


def test_a_camera_of_a_mission_is_that_of_the_plan():
    assert mission_forecast(mission("nadir"), LEVEL).pixel_mm == CAMERA.pixel_mm
