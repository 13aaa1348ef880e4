"""What flights determine before they are flown: lever arms, relief, rolling shutters, control."""

from dataclasses import replace

import numpy as np
import pytest
from tests.missions.cases import ACROSS_30, PLACE, change
from tests.missions.cases import LEVEL as LEVEL_GROUND
from tests.missions.cases import mission as planned_mission

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import InputError
from raybundle.planning.flights.aerial import LAYOUTS, NUMBERS, PLACES, SIGMAS_M, control_rows, open_in, precision
from raybundle.planning.flights.aerial_block import aerial_block
from raybundle.planning.flights.flight import flight_control, forecast, plan_flight
from raybundle.planning.flights.mission import MOST, Asked, mission_forecast
from raybundle.planning.flights.uav_networks import Flight, flight_aerial, flight_block

LEVEL = Flight(points=10, alternating=True, height_jitter=0.0, angle_jitter_deg=0.0)
ARM = replace(LEVEL, lever_arm=True)
ACROSS = replace(ARM, cross_tilt_deg=30.0)
RELIEF = 0.10


def lost(plan):
    return set(open_in(flight_aerial(plan)))


def test_a_nadir_block_at_one_height_determines_neither_c_nor_the_height_of_the_lever_arm():
    """Whatever its control: a longer c and a higher flight give the same photographs, the lever arm takes the rest."""
    for control in (0, 1, 5):
        assert {"c", "az"} <= lost(replace(ARM, control=control))
    assert lost(LEVEL) == {"c"}
    assert not lost(replace(LEVEL, control=1))


def test_relief_changes_the_verdict_as_it_should():
    """Of parallel axes depth and c are one affinity, so that relief alone tells c no better than flat ground.

    What it does tell is what flat ground hides: x0, y0 apart from ax, ay; and c, where control knows its heights.
    """
    flat = {"c", "x0", "y0", "ax", "ay", "az"}
    assert lost(replace(ARM, control=1)) == flat
    assert lost(replace(ARM, control=1, relief=RELIEF)) == {"c", "az"}
    assert lost(replace(ARM, control=5)) == flat
    assert lost(replace(ARM, control=5, relief=RELIEF)) == {"az"}
    assert lost(replace(LEVEL, relief=RELIEF)) == {"c"}
    # one tilt over flat ground leaves a family of c, y0 and lever arms; relief closes it, as one control point does
    assert lost(ACROSS) == {"c", "y0", "ay", "az"}
    assert not lost(replace(ACROSS, relief=RELIEF))
    assert not lost(replace(ACROSS, control=1))


@pytest.mark.long
def test_oblique_strips_are_the_remedy_and_what_they_bring_is_told():
    done = plan_flight(Flight(points=12, alternating=True, lever_arm=True))
    assert "az" in done.planned.lost
    assert {"c", "az"} <= set(done.planned.lost_level)
    assert np.isnan(done.planned.sigma_m).all()
    assert change(done.advised) == ("flight_change.across_tilted", {**ACROSS_30, "control": 1})
    assert done.gain(done.advised) == np.inf
    assert done.advised.sigma_m[2] < 0.04
    hills = plan_flight(Flight(points=12, alternating=True, lever_arm=True, relief=RELIEF))
    oblique = next(r for r in hills.remedies if change(r) == ("flight_change.across_tilted", ACROSS_30))
    assert not hills.planned.sure
    assert oblique.sure
    assert hills.gain(oblique) > 3


def test_strips_at_another_height_tell_c_by_rtk_and_leave_the_lever_arm():
    assert not lost(replace(LEVEL, cross_height=104.0))
    assert lost(replace(ARM, cross_height=104.0)) == {"az"}


@pytest.mark.parametrize("change", [{}, {"lever_arm": True, "control": 5, "cross_tilt_deg": 30.0}, {"relief": 0.1}])
def test_what_is_predicted_is_what_an_adjustment_of_noisy_photographs_states(change):
    """One sample of noise and its linearisation: some per cent."""
    plan = Flight(points=12, alternating=True, **change)
    predicted = precision(flight_aerial(plan)).sigma_m
    result = adjust_block(flight_block(plan), AdjustmentOptions(jobs=1))
    stated = np.sqrt(np.nanmean((result.precision.object_point_std / result.sigma0) ** 2, axis=0))
    np.testing.assert_allclose(stated, predicted, rtol=0.1)


def test_a_rolling_shutter_is_estimated_and_costs_something():
    plan = Flight(points=12, alternating=True, cross_tilt_deg=30.0)
    rolling = precision(flight_aerial(replace(plan, read_out_s=0.03)))
    still = precision(flight_aerial(plan))
    assert not rolling.lost
    assert 1.0 <= rolling.sigma_m[1] / still.sigma_m[1] < 1.5
    height_mm = plan.camera.size_mm[1]
    assert 0 < rolling.std["r"] * height_mm < 0.003  # of 30 ms, with velocities that are known
    velocity = flight_aerial(plan).velocity
    np.testing.assert_allclose(np.linalg.norm(velocity, axis=1), plan.speed)
    block = aerial_block(flight_aerial(replace(plan, read_out_s=0.03, angle_jitter_deg=0.0)))
    assert block.images.interior[0]["vy"] == pytest.approx(plan.speed)


@pytest.mark.long
def test_rtk_and_none():
    plan = Flight(points=12, alternating=True, control=5)
    done = plan_flight(plan)
    assert done.without_rtk.sigma_m[2] > done.planned.sigma_m[2]
    assert plan_flight(done.without_rtk.plan).without_rtk is None


def test_control_table():
    plan = Flight(points=12, alternating=True)
    table = flight_control(plan)
    assert len(table.rows) == 1 + len(NUMBERS) * len(SIGMAS_M)
    worst = {(r.points, r.sigma_m): r.found.height_worst_m for r in table.rows[1:]}
    for s in SIGMAS_M:
        mine = [worst[n, s] for n in NUMBERS]
        assert mine == sorted(mine, reverse=True)  # more never harm
        enough = table.enough(s)
        beyond = [v for n, v in zip(NUMBERS, mine, strict=True) if n >= enough.points]
        assert min(beyond) > 0.9 * enough.found.height_worst_m
    assert worst[5, 0.005] < worst[5, 0.01] < worst[5, 0.03]
    where = {r.where: r.found.height_worst_m for r in table.layouts}
    assert min(where, key=where.get) == "corners"
    assert where["corners"] == pytest.approx(worst[5, 0.01], rel=1e-6)


@pytest.mark.parametrize("places", [*PLACES.values(), *LAYOUTS.values()], ids=str)
def test_control_lies_where_it_is_said(places):
    ground = flight_aerial(Flight(points=31)).ground
    rows = control_rows(ground, places)
    assert len(rows) == len(places)
    off = ground[rows, :2] - np.array(places, float) * 0.4 * 120
    assert np.abs(off).max() <= 2.01  # half the distance of tie points


def test_relief_is_what_it_says():
    plan = replace(LEVEL, relief=RELIEF)
    assert np.ptp(flight_aerial(plan).ground[:, 2]) == pytest.approx(8.0)
    assert forecast(replace(plan, control=5)).lost == ()


@pytest.mark.parametrize("pattern", ["nadir", "double-grid", "corridor", "facade"])
def test_missions_are_forecast_as_flights_are(pattern):
    """The larger block of the same machinery: what stays open is told by how the photographs look."""
    more = {"tilt": np.radians(20)} if pattern == "double-grid" else {}
    f = mission_forecast(planned_mission(pattern, more=more), LEVEL_GROUND, Asked())
    assert f.rtk.photographs <= MOST
    assert f.thinned == (f.photographs > MOST)
    assert set(f.lost_even) == ({"c"} if pattern in {"nadir", "corridor"} else set())
    assert not f.rtk.lost
    assert 0.002 < f.rtk.plan_m < 0.03
    assert f.without_rtk.plan_m > 20 * f.rtk.plan_m


def test_a_nadir_mission_with_a_free_lever_arm():
    arm = mission_forecast(planned_mission("nadir"), LEVEL_GROUND, Asked(lever_arm=True))
    assert {"c", "az"} <= set(arm.lost_even)
    assert np.isnan(arm.rtk.sigma_m[2])


@pytest.mark.long
def test_relief_changes_the_verdict_of_a_mission():
    """One tilt everywhere hides what of the lever arm is vertical; views straight down beside it and relief tell it."""
    tilted = planned_mission("double-grid", more={"tilt": np.radians(30)})
    assert {"c", "az"} <= set(mission_forecast(tilted, LEVEL_GROUND, Asked(lever_arm=True)).lost_even)
    assert set(mission_forecast(tilted, HillGround(), Asked(lever_arm=True)).lost_even) == {"ay", "az"}
    both = mission_forecast(planned_mission("oblique-grid"), HillGround(), Asked(lever_arm=True))
    assert not both.lost_even
    assert both.rtk.sigma_m[2] < 0.03


class HillGround:
    """10 % of 75 m of relief."""

    def __call__(self, xy):
        x, y = (xy - PLACE).T / 150
        return 100 + 3.75 * np.sin(2 * np.pi * 1.3 * x) * np.cos(2 * np.pi * 1.1 * y)


def test_an_orbit_is_not_forecast():
    with pytest.raises(InputError, match=r"plan\.mission_pattern"):
        mission_forecast(planned_mission("orbit"), LEVEL_GROUND)
