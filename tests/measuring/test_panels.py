"""Ground panels: found in pictures, told apart from stones, consistent over photographs and points."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.records.severity import Severity
from raybundle.block import Instrument, Role, Stations
from raybundle.errors import InputError
from raybundle.measuring.actions.control import GiveControl, Given
from raybundle.measuring.actions.verbs import Point, Put
from raybundle.measuring.control_names import check_reach
from raybundle.measuring.merge import merge
from raybundle.measuring.panel_candidates import measured_panel, panel_places
from raybundle.measuring.panel_search import search_panels
from raybundle.measuring.session import Session
from raybundle.measuring.state import folded
from raybundle.platforms.antenna import Antenna
from raybundle.workflows.adjust import adjust

from .panel_flight import KINDS, MODEL, draw_panel, flight, ground
from .scenes import simulation

CENTRES_PX = 0.3
"""Largest error of a centre: ten of its standard deviations would be 1 px"""


@pytest.mark.parametrize("kind", KINDS)
def test_a_panel_is_the_most_distinct_place(kind):
    rng = np.random.default_rng(KINDS.index(kind))
    for size in (16.0, 26.0, 40.0):
        picture, at = ground(rng, 240, 200, stones=150), np.array([118.3, 96.8])
        draw_panel(picture, kind, at, size, rng.uniform(0, 90))
        picture = np.clip(picture + rng.normal(0, 2, picture.shape), 0, 255).astype(np.uint8)
        first = panel_places(picture)[0]
        assert np.hypot(first.x_px - at[0], first.y_px - at[1]) < 2
        mark = measured_panel(picture, first)
        assert mark is not None
        assert np.hypot(mark.x_px - at[0], mark.y_px - at[1]) < CENTRES_PX
        assert mark.kind in {MODEL[kind], "patch"}


def test_ground_without_panels_is_less_distinct():
    rng = np.random.default_rng(5)
    picture = np.clip(ground(rng, 400, 300, stones=600), 0, 255).astype(np.uint8)
    places = panel_places(picture)
    drawn = picture.astype(np.float32)
    draw_panel(drawn, "cross", np.array([200.0, 150.0]), 26.0, 20.0)
    panel = panel_places(np.clip(drawn, 0, 255).astype(np.uint8))[0]
    assert all(p.worth < 0.5 * panel.worth for p in places)


@pytest.fixture(scope="module")
def flown():
    """G4 has no panel, G9 has coordinates that are wrong by a metre."""
    made = flight(left_out=("G4",), wrong={"G9": np.array([0.8, -0.6, 0.0])})
    session = Session.of_block(made.block, None)
    return made, search_panels(session, made.given, dict.fromkeys(made.given, 0.01), 6.0, made.pictures.get)


def test_panels_of_a_flight_are_found_and_no_others(flown):
    made, done = flown
    assert {f.point for f in done.found} == set(made.given) - {"G4", "G9"}
    assert done.missed["G9"] == "off"
    assert abs(done.off["G9"] - 1.0) < 0.2
    assert done.missed["G4"] in {"off", "nothing", "few_rays", "no_panel"}
    assert np.linalg.norm(done.shift - [1.4, -0.9, 2.3]) < 0.05


def test_their_marks_are_where_the_photographs_show_them(flown):
    made, done = flown
    marks = {(image, f.point): m for f in done.found for image, m in f.marks.items()}
    off = {k: np.hypot(m.x_px - made.seen[k][0], m.y_px - made.seen[k][1]) for k, m in marks.items() if k in made.seen}
    assert max(off.values()) < CENTRES_PX
    visible = [k for k in made.seen if k[1] in {f.point for f in done.found}]
    assert len(off) > 0.9 * len(visible)
    assert all(m.kind in {MODEL[made.kinds[point]], "patch"} for (_, point), m in marks.items())


def test_too_few_points_confirm_no_shift(flown):
    made, _ = flown
    two = {name: made.given[name] for name in ("G1", "G2")}
    done = search_panels(Session.of_block(made.block, None), two, dict.fromkeys(two, 0.01), 6.0, made.pictures.get)
    assert not done.found
    assert set(done.missed.values()) == {"few_points"}


def hand_marked(shift=(0.3, -0.2, 0.5), given=lambda xyz: xyz):
    """A block whose positions nothing confirmed have an antenna without a shift, and marks of control in another frame.

    given  what the table of control states of the true coordinates (n, 3)
    """
    made = simulation(control=5).observed
    o, p = made.observations, made.points
    control = np.flatnonzero(p.is_control.all(axis=1))
    rows = np.isin(o.point, control)
    antenna = Instrument(id="gnss", model=Antenna.name, values={q.symbol: 0.0 for q in Antenna.parameters}, estimate=())
    n = len(made.images)
    stations = Stations(
        image=np.arange(n), xyz=made.images.centre, sigma=np.full((n, 3), 0.02), antenna=np.zeros(n, np.int32),
    )  # fmt: skip
    free = np.full_like(p.sigma, np.nan)
    points = replace(p, role=np.where(p.is_control.any(axis=1), Role.TIE, p.role), sigma=free)
    base = replace(made, points=points, instruments=(antenna,), observations=o.rows(~rows)).having(stations)
    marks = [
        Put(image=made.images.ids[o.image[r]], point=p.ids[o.point[r]], x_px=o.xy_px[r, 0], y_px=o.xy_px[r, 1])
        for r in np.flatnonzero(rows)
    ]
    xyz = given(np.array(p.xyz[control])) - np.array(shift)
    known = [
        Point(point=p.ids[k], role="control", xyz=tuple(at), sigma=(0.01, 0.01, 0.01))
        for k, at in zip(control, xyz.tolist(), strict=True)
    ]
    return base, folded(marks), folded([*marks, *known])


def test_marked_control_frees_the_shift_of_the_positions():
    base, marks, both = hand_marked()
    assert merge(base, marks).block.instruments[0].estimate == ()
    merged = merge(base, both).block
    assert merged.instruments[0].estimate == ("sx", "sy", "sz")
    assert np.allclose([merged.instruments[0].values[s] for s in ("sx", "sy", "sz")], [0.3, -0.2, 0.5], atol=0.02)


@pytest.mark.parametrize("shift", [(0.02, -0.01, 0.0), (0.01, 0.0, -45.0), (3.0, -2.0, 1.0), (0.0, 0.0, 4000.0)])
def test_a_shift_that_the_positions_do_not_explain_is_reported(shift):
    base, _, both = hand_marked(shift)
    result = adjust(merge(base, both).block)
    assert result.sigma0 < 1.5
    found = [n for n in result.notices if n.code == "positions_shifted"]
    expected = {0.02: [], 3.0: [""]}
    assert [n.variant for n in found] == expected.get(shift[0], ["height"])
    if found:
        assert np.hypot(*shift[:2]) == pytest.approx(found[0].values["plan"], abs=0.1)
        assert shift[2] == pytest.approx(found[0].values["height"], abs=0.1)
        assert found[0].severity is (Severity.NOTE if abs(shift[2]) == 45 else Severity.WARNING)


def test_control_under_other_names_or_in_another_order_is_no_shift():
    base, _, both = hand_marked(given=lambda xyz: np.roll(xyz, 1, axis=0))
    with pytest.raises(InputError) as caught:
        merge(base, both)
    assert caught.value.code == "mark.control_names"
    assert caught.value.message is not None
    assert len(caught.value.message.details) == 5
    base, _, both = hand_marked(given=lambda xyz: xyz[:, [1, 0, 2]])
    with pytest.raises(InputError, match="do not fit their marks"):
        merge(base, both)


@pytest.mark.parametrize(
    ("shift", "apart"), [((0, 0, 0), None), ((142e3, 0, 0), 142e3), ((0, 0, 45.0), None)]
)  # fmt: skip
def test_control_in_another_zone_is_refused_when_it_is_given(shift, apart):
    base, _, both = hand_marked()
    rows = [
        Given(point=n, role="control", xyz=tuple(np.array(v.xyz) + shift), sigma=v.sigma)
        for n, v in both.points.items()
    ]
    action = GiveControl(file="gcps.csv", points=tuple(rows))
    if apart is None:
        check_reach(base, action)
        return
    with pytest.raises(InputError, match="the project has EPSG:25833") as caught:
        check_reach(base, action, "EPSG:25833")
    assert caught.value.code == "mark.control_apart"
    assert caught.value.message is not None
    assert caught.value.message.values["distance"] == pytest.approx(apart, rel=1e-3)


def test_control_has_no_place_to_miss_in_a_block_without_one():
    base, _, _ = hand_marked()
    row = Given(point="A", role="control", xyz=(4e5, 5e6, 100.0), sigma=(0.01, 0.01, 0.01))
    check_reach(base.having(base.stations.rows(np.zeros(0, int))), GiveControl(file="gcps.csv", points=(row,)))
