"""Overlaps across, of tilted cameras and grids of two directions, against footprints that are computed here anew."""

from dataclasses import replace

import numpy as np
import pytest
from tests.missions.cases import CAMERA, LEVEL, PLACE, mission, wish

from raybundle.missions.mission import Trigger, WayPoints, exposures
from raybundle.missions.patterns import patterns
from raybundle.missions.report import Spread, beside, mission_facts, overlaps, seconds_of, warnings

GROUND = 100.0
HALF = CAMERA.width_px / 2 / CAMERA.c_px, CAMERA.height_px / 2 / CAMERA.c_px


def footprint(xyz, heading, pitch):
    """(4, 2) corners of what a photograph shows of level ground, and where its axis meets it: plain trigonometry."""
    ahead = np.array([np.sin(heading) * np.cos(pitch), np.cos(heading) * np.cos(pitch), np.sin(pitch)])
    right = np.array([np.cos(heading), -np.sin(heading), 0.0])
    up = np.cross(right, ahead)
    rays = [ahead, *(ahead + u * HALF[0] * right + v * HALF[1] * up for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)))]
    met = [xyz + (GROUND - xyz[2]) / ray[2] * ray for ray in rays]
    return np.array(met)[1:, :2], met[0][:2]


def crossed(corners, at, ahead):
    """Interval to the right of a line along which a footprint is cut square to it, at a distance along."""
    side = np.array([ahead[1], -ahead[0]])
    s, t = corners @ ahead - at, corners @ side
    ends = []
    for k in range(4):
        a, b = k, (k + 1) % 4
        if (s[a] > 0) != (s[b] > 0):
            ends.append(t[a] + (t[b] - t[a]) * s[a] / (s[a] - s[b]))
    return min(ends), max(ends)


def own_overlaps(m):
    """Of each photograph with that of the next line whose axis meets the ground nearest: shares of its middle row."""
    e = exposures(m)
    group = np.array([m.lines[k].group for k in e.line])
    seen = [footprint(x, h, p) for x, h, p in zip(e.xyz, e.heading, e.pitch, strict=True)]
    middle = np.array([c for _, c in seen])
    found = []
    for i in range(len(e)):
        ahead = np.array([np.sin(e.heading[i]), np.cos(e.heading[i])])
        side = np.array([ahead[1], -ahead[0]])
        d = middle - middle[i]
        off = np.abs(d @ side)
        near = (group == group[i]) & (off > 1) & (off < 1.5 * m.spacing) & (np.abs(d @ ahead) <= m.base / 2)
        if not near.any():
            continue
        j = np.flatnonzero(near)[np.argmin(off[near])]
        own = crossed(seen[i][0], middle[i] @ ahead, ahead)
        other = crossed(seen[j][0], middle[j] @ ahead, ahead)  # at its own middle: moved along until abreast
        found.append(max(0.0, min(own[1], other[1]) - max(own[0], other[0])) / (own[1] - own[0]))
    return np.array(found)


@pytest.mark.parametrize("overlap", [(0.8, 0.7), (0.3, 0.1)], ids=str)
@pytest.mark.parametrize("tilt", [0, 10, 20, 30])
@pytest.mark.parametrize("pattern", ["nadir", "double-grid", "oblique-grid"])
def test_across_is_what_footprints_on_the_ground_have_in_common(pattern, tilt, overlap):
    m = mission(pattern, more={"tilt": np.radians(tilt), "overlap": overlap})
    _, across = overlaps(m, exposures(m), LEVEL)
    own = own_overlaps(m)
    assert len(own) > 20
    np.testing.assert_allclose(own, overlap[1], atol=0.002)  # the own computation is of the middle row alone
    assert across.low == pytest.approx(own.min(), abs=0.01)
    assert across.middle == pytest.approx(np.median(own), abs=0.01)


def test_neighbours_look_at_neighbouring_places_and_run_the_same_way():
    m = mission("double-grid", more={"tilt": np.radians(20)})
    e = exposures(m)
    first, second = beside(m, e, LEVEL)
    assert len(first) > 0.9 * len(e) - 40
    assert all(m.lines[a].group == m.lines[b].group for a, b in zip(e.line[first], e.line[second], strict=True))
    turn = np.abs(np.sin(e.heading[second] - e.heading[first]))
    assert turn.max() < 1e-9  # to and fro
    # stations of lines flown to and fro lie 2 h tan(20 deg) apart along, what they look at half a base at most
    middle = np.array([footprint(x, h, p)[1] for x, h, p in zip(e.xyz, e.heading, e.pitch, strict=True)])
    ahead = np.stack([np.sin(e.heading[first]), np.cos(e.heading[first])], axis=1)
    assert np.abs(np.sum((middle[second] - middle[first]) * ahead, axis=1)).max() <= m.base / 2 + 1e-5
    assert np.abs(np.sum((e.xyz[second] - e.xyz[first])[:, :2] * ahead, axis=1)).min() > 40


@pytest.mark.parametrize("overlap", [(0.8, 0.7), (0.6, 0.3), (0.3, 0.1)], ids=str)
def test_rows_of_a_facade_that_the_ground_lifts_overlap_more_not_less(overlap):
    """A row that may not lie lower lies nearer to the next one, and is held against that one, not the one beyond."""
    wall = np.array([[0.0, 0], [140, 40]]) + PLACE
    m = mission(
        "facade", outline=wall, more={"heights": (0.0, 18.0), "distance": CAMERA.distance(0.003), "overlap": overlap}
    )
    rows = np.unique(np.round(exposures(m).xyz[:, 2], 6))
    height = CAMERA.height_px * 0.003
    own = 1 - np.diff(rows) / height
    across = mission_facts(m, LEVEL).across
    assert across.low == pytest.approx(own.min(), abs=0.006)
    assert across.low >= overlap[1] - 0.006
    assert not [w for w in warnings(m, mission_facts(m, LEVEL)) if w.code == "mission.overlap_low"]


@pytest.mark.parametrize("pattern", patterns)
def test_advice_is_that_of_the_pattern(pattern):
    m = mission(pattern)
    thin = replace(mission_facts(m, LEVEL), across=Spread(low=0.4, middle=0.7, high=0.7))
    (found,) = [w for w in warnings(m, thin) if w.code == "mission.overlap_low"]
    assert found.values == {"direction": "across", "overlap": 0.4, "asked": 0.7, "cause": pattern}
    assert "(overlap=" in found.text()
    assert "(gsd=" not in found.text()
    (over,) = [w for w in warnings(replace(m, terrain="dsm.tif"), thin) if w.code == "mission.overlap_low"]
    assert (over.values["cause"] == "relief") == ("(gsd=" in over.text()) == patterns[pattern].ground


def test_places_that_few_photographs_show_are_told_by_where_they_lie():
    low = mission("nadir", more={"overlap": (0.3, 0.1)})

    def rarely(m, facts):
        return next(w for w in warnings(m, facts) if w.code == "mission.seen_rarely")

    found = rarely(low, mission_facts(low, LEVEL))
    assert (found.values["where"], found.values["along"], found.values["across"]) == ("middle", 0.3, 0.1)
    assert "(overlap=" in found.text()
    edge = mission("nadir", more={"margin": 0.0, "overlap": (0.7, 0.6)}, take_off=None)
    facts = mission_facts(edge, LEVEL)
    assert facts.seen_rarely > 0
    assert facts.rarely_inside == 0
    assert rarely(edge, facts).values["where"] == "edges"
    assert "(margin=" in rarely(edge, facts).text()
    zone = np.array([[80.0, 80], [200, 80], [200, 190], [80, 190]]) + PLACE
    cut = mission("nadir", no_go=(zone,))
    facts = mission_facts(cut, LEVEL)
    assert facts.rarely_at_zones > 0
    assert facts.rarely_inside == 0
    assert rarely(cut, facts).values["where"] == "zones"


def test_overlaps_asked_for_alike_by_every_command():
    from raybundle.commands.planning.flight import FlightSettings
    from raybundle.commands.planning.mission import MissionSettings

    usual = {FlightSettings().overlap, MissionSettings(area="", out="").overlap, wish("nadir").overlap}
    assert usual == {(0.8, 0.7)}


def test_time_in_the_air_is_that_of_its_parts():
    """Up, ahead, up, down, down to where it began; braking at what is stopped for, a photograph taken standing."""
    m = mission("nadir")
    v = replace(m.vehicle, climb=4.0, descent=3.0, acceleration=2.0)
    xyz = np.add(m.take_off, [[0, 0, 40], [0, 90, 40], [0, 90, 100], [0, 90, 20]])
    way = WayPoints(
        xyz=xyz, heading=np.zeros(4), pitch=np.zeros(4), speed=np.array([5.0, 6.0, 7.0, 8.0]), base=np.full(4, np.nan),
        trigger=np.array([Trigger.START, Trigger.STOP, Trigger.NONE, Trigger.HERE]), line=np.zeros(4, int),
        flight=np.zeros(4, int),
    )  # fmt: skip
    parts = [40 / 4, 90 / 5, 60 / 4, 80 / 3, 20 / 3, (5 + 6 + 8) / 2 / 2, 1.0]
    fast, slow = (replace(m.camera, interval_s=s) for s in (0.7, 2.0))
    assert seconds_of(replace(m, vehicle=v, way_points=way, camera=fast), 0) == pytest.approx(sum(parts), abs=1e-9)
    assert seconds_of(replace(m, vehicle=v, way_points=way, camera=slow), 0) == pytest.approx(sum(parts) + 1, abs=1e-9)


def test_figures_of_a_nadir_flight_are_those_of_its_height_and_speed():
    m = mission("nadir")
    facts = mission_facts(m, LEVEL)
    height = m.way_points.xyz[0, 2] - 100.0
    assert (facts.gsd.low, facts.gsd.high) == pytest.approx((height / m.camera.c_px,) * 2, rel=1e-9)
    first = m.way_points.rows(m.way_points.line == 0)
    lone = mission_facts(replace(m, way_points=first, lines=m.lines[:1]), LEVEL)
    assert lone.interval_s == pytest.approx(np.nanmin(first.base / first.speed))
