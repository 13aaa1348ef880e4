"""Every pattern: GSD and overlaps as asked for to 1 %, views, zones, batteries, and what cannot be flown."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from tests.missions.cases import CAMERA, LEVEL, OUTLINES, PLACE, VEHICLE, mission, wish

from raybundle.errors import InputError, Severity
from raybundle.missions.build import Task, plan_mission
from raybundle.missions.mission import exposures
from raybundle.missions.patterns import patterns
from raybundle.missions.polygons import distance_to, inside, within
from raybundle.missions.report import mission_facts, warnings
from raybundle.missions.zones import CLEAR_M, way_round


@pytest.mark.parametrize("overlap", [(0.8, 0.7), (0.6, 0.3), (0.9, 0.8)], ids=str)
@pytest.mark.parametrize("pattern", patterns)
def test_gsd_and_overlap_are_as_asked_for_to_one_per_cent(pattern, overlap):
    m = mission(pattern, more={"overlap": overlap})
    facts = mission_facts(m, LEVEL)
    assert facts.gsd.low == pytest.approx(m.gsd, rel=0.01)
    assert facts.gsd.high == pytest.approx(m.gsd, rel=0.01)
    if pattern != "orbit":  # where the views turn, neighbours are as near as the least angle asks
        assert facts.along.middle == pytest.approx(overlap[0], abs=0.01)
    if facts.across is not None:
        low = 0.0 if pattern == "corridor" else 0.01  # inside a bend lines lie abreast of nobody exactly
        assert facts.across.middle >= overlap[1] - max(low, 0.01)
        # rows that cover a facade may lie nearer than asked for; a tilted view sees a wider row behind
        more = {"facade": 0.5, "orbit": 0.5, "oblique-grid": 0.06}.get(pattern, 0.01)
        assert facts.across.middle <= overlap[1] + more


@pytest.mark.parametrize("pattern", [n for n, p in patterns.items() if p.shape == "area"])
def test_the_whole_area_is_seen_from_its_edge_on(pattern):
    facts = mission_facts(mission(pattern), LEVEL)
    assert facts.seen_rarely == 0
    assert facts.coverage.count.min() >= 6
    assert np.nanmax(facts.coverage.gsd) < 0.021


@pytest.mark.parametrize("pattern", patterns)
def test_stations_look_at_what_they_photograph(pattern):
    m = mission(pattern)
    e = exposures(m)
    axis = -e.rotation[:, 2]
    np.testing.assert_allclose(np.linalg.norm(axis, axis=1), 1)
    if pattern == "facade":
        wall = OUTLINES["line"]
        for k, (a, b) in enumerate(pairwise(wall)):
            own = np.array([m.lines[i].group == f"facade {k + 1}" for i in e.line])
            ahead = (b - a) / np.linalg.norm(b - a)
            normal = np.array([ahead[1], -ahead[0]])
            np.testing.assert_allclose((e.xyz[own, :2] - a) @ normal, CAMERA.distance(0.005), rtol=1e-9)
            np.testing.assert_allclose(axis[own, :2] @ normal, -1, atol=1e-9)
    elif pattern == "orbit":
        centre = np.mean(OUTLINES["place"], axis=0)
        inward = centre - e.xyz[:, :2]
        inward /= np.linalg.norm(inward, axis=1)[:, None]
        np.testing.assert_allclose(np.sum(inward * axis[:, :2], axis=1), 1, atol=1e-9)
    elif pattern == "oblique-grid":
        tilts = np.degrees(np.arccos(-axis[:, 2]))
        assert sorted(set(np.round(tilts, 6))) == [0, 35]
        views = {g: set(np.round(np.degrees(e.heading[[m.lines[i].group == g for i in e.line]]), 3)) for g in
                 {line.group for line in m.lines} if g.startswith("view")}  # fmt: skip
        assert len(views) == 4
        assert all(len(v) == 1 for v in views.values())
    else:
        np.testing.assert_allclose(axis, np.broadcast_to([0, 0, -1], axis.shape), atol=1e-9)
    block = m.camera.as_block_camera()
    assert (block.width_px, block.height_px) == (5280, 3956)
    assert block.values["c"] / block.pixel_mm[0] == pytest.approx(m.camera.c_px)


def test_tilted_rings_look_at_the_middle_of_the_object():
    m = mission("orbit", more={"tilt": np.radians(60), "rings": 2})
    e = exposures(m)
    centre = np.append(np.mean(OUTLINES["place"], axis=0), 110.0)
    radius = np.linalg.norm(OUTLINES["place"][0] - centre[:2])
    axis = -e.rotation[:, 2]
    assert len({round(v, 6) for v in e.pitch.tolist()}) == 2
    # the axis meets the object's mantle at half its height
    away = np.linalg.norm(e.xyz[:, :2] - centre[:2], axis=1) - radius
    np.testing.assert_allclose(e.xyz[:, 2] + away / np.linalg.norm(axis[:, :2], axis=1) * axis[:, 2], 110.0, atol=1e-6)


def test_tilted_lines_see_the_area_from_both_ends():
    m = mission("double-grid", more={"tilt": np.radians(25)})
    facts = mission_facts(m, LEVEL)
    assert facts.seen_rarely == 0
    assert facts.along.middle == pytest.approx(0.8, abs=0.01)
    assert facts.above.middle == pytest.approx(CAMERA.distance(0.02) * np.cos(np.radians(25)), abs=1e-6)


def test_lines_turn_back_and_carry_whole_bases():
    m = mission("nadir")
    w = m.way_points
    starts, stops = np.flatnonzero(w.trigger == 2), np.flatnonzero(w.trigger == 3)
    length = np.linalg.norm(w.xyz[stops, :2] - w.xyz[starts, :2], axis=1)
    np.testing.assert_allclose(length / m.base, np.rint(length / m.base), atol=1e-9)
    turn = np.degrees(np.diff(w.heading[starts])) % 360
    np.testing.assert_allclose(turn, 180, atol=1e-6)


ZONE = np.array([[100.0, 100], [150, 100], [150, 150], [100, 150]]) + PLACE


def speed_limits(m):
    """What limits the speed of a mission, and the speed."""
    found = [c for r in m.remarks for c in r.messages if c.code == "mission.speed_limited"]
    return [(c.values["limit"], c.values["speed"]) for c in found]


@pytest.mark.parametrize("pattern", ["nadir", "double-grid", "oblique-grid"])
def test_nothing_is_flown_over_a_no_go_zone(pattern):
    m = mission(pattern, no_go=(ZONE,))
    way = m.way_points.xyz[:, :2]
    for a, b in pairwise(way):
        assert not within([ZONE], a, b)
    on = exposures(m).xyz[:, :2]
    assert not inside(ZONE, on).any()
    assert distance_to(ZONE, on).min() >= CLEAR_M - 1.0
    assert any("mission.zones_taken_out" in {c.code for c in r.messages} for r in m.remarks)
    assert mission_facts(m, LEVEL).along.middle == pytest.approx(0.8, abs=0.01)


def test_an_orbit_goes_round_a_zone():
    zone = np.array([[25.0, -10], [60, -10], [60, 20], [25, 20]]) + PLACE
    m = mission("orbit", no_go=(zone,))
    way = m.way_points.xyz[:, :2]
    assert not any(within([zone], a, b) for a, b in pairwise(way))


def test_zones_that_leave_nothing_or_no_way():
    every = np.array([[-500.0, -500], [900, -500], [900, 900], [-500, 900]]) + PLACE
    with pytest.raises(InputError, match=r"mission\.area_in_zones"):
        mission("nadir", no_go=(every,))
    wall = [np.array(r, float) + PLACE for r in (
        [[-60, -60], [60, -60], [60, -40], [-60, -40]], [[-60, -60], [-40, -60], [-40, 60], [-60, 60]],
        [[40, -60], [60, -60], [60, 60], [40, 60]], [[-60, 40], [60, 40], [60, 60], [-60, 60]],
    )]  # fmt: skip
    with pytest.raises(InputError, match=r"mission\.no_way"):
        way_round(PLACE, PLACE + 200, wall)
    with pytest.raises(InputError, match=r"mission\.way_in_zone"):
        mission("nadir", no_go=(np.array([[-40.0, -40], [0, -40], [0, 0], [-40, 0]]) + PLACE,), more={"margin": 0.0})


def test_batteries_divide_a_flight_and_each_comes_home():
    small = replace(VEHICLE, minutes=4.0)
    m = mission("nadir", vehicle=small)
    facts = mission_facts(m, LEVEL)
    assert m.flights >= 2
    assert max(facts.minutes) <= small.usable_s / 60 * 1.02
    assert len(exposures(m)) >= len(exposures(mission("nadir")))
    for k in range(m.flights):
        w = m.way_points.of_flight(k)
        assert np.linalg.norm(w.xyz[-1, :2] - (PLACE - 20)) < 1e-6
    with pytest.raises(InputError, match=r"mission\.battery"):
        mission("nadir", vehicle=replace(VEHICLE, minutes=2.0), take_off=tuple(PLACE - 600))


def test_what_the_camera_cannot_do():
    with pytest.raises(InputError, match=r"0\.7.*11.*mission\.camera_interval"):
        mission("nadir", speed=14.0, more={"overlap": (0.9, 0.7)})
    with pytest.raises(InputError, match=r"20.*m/s.*15.*mission\.speed_of_vehicle"):
        mission("nadir", speed=20.0)
    m = mission("nadir", more={"overlap": (0.9, 0.7)})
    assert speed_limits(m) == [("camera_interval", pytest.approx(11.3, abs=0.05))]
    m = mission("facade")
    assert speed_limits(m) == [("blur", pytest.approx(4.0, abs=0.05))]
    assert mission_facts(m, LEVEL).blur_px == pytest.approx(1.0, abs=0.01)


def test_what_is_too_high_or_out_of_sight_is_told():
    m = mission("nadir", more={"distance": 150.0})
    found = {w.code: w for w in warnings(m, mission_facts(m, LEVEL), sight_m=200.0)}
    high = found["mission.too_high"]
    assert high.severity == Severity.FAULT
    assert high.values == {"height_m": pytest.approx(150), "limit_m": 120.0, "open_category": True}
    assert found["mission.out_of_sight"].severity == Severity.WARNING


@pytest.mark.parametrize(
    ("pattern", "outline", "words"),
    [
        ("nadir", [[0, 0], [10, 10], [10, 0], [0, 10]], r"flight_area\.crosses_itself"),
        (
            "nadir",
            [[0, 0], [5, 5], [10, 10]],
            r"flight_area\.no_area",
        ),
        ("corridor", [[0, 0], [0, 0]], r"mission\.line_no_extent"),
        ("corridor", [[0, 0], [100, 0], [0, 10]], r"174.*2.*corridor\.sharp_turn"),
        ("corridor", [[0, 0], [100, 0], [105, 5], [105, 100]], r"corridor\.tight_bend"),
    ],
)
def test_outlines_that_are_none(pattern, outline, words):
    with pytest.raises(InputError, match=words):
        mission(pattern, outline=np.array(outline, float), more={"width": 100.0})


def test_a_view_to_the_horizon_is_refused():
    with pytest.raises(InputError, match=r"mission\.view_to_horizon"):
        mission("double-grid", more={"tilt": np.radians(75)})
    with pytest.raises(InputError, match=r"mission\.unknown_pattern"):
        plan_mission(Task(pattern="spiral", outline=OUTLINES["area"], wish=wish("nadir"), ground=LEVEL))
