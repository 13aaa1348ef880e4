"""`raybundle plan flight`: what a flight will not determine is said before it is flown, and what mends it."""

import json

import numpy as np
import pytest
from tests.cli.reported import refusal, reported, values_of

from raybundle.block import Role
from raybundle.cli.main import main
from raybundle.commands.planning.flight import FlightSettings
from raybundle.io.block.folder import read_block
from raybundle.planning.flights.flight import forecast, plan_flight
from raybundle.planning.flights.uav_networks import Flight, flight_block
from raybundle.words import headline

PUBLISHED = ("--base", "16", "--line-spacing", "48", "--ground", "120", "--tie-points", "9")


@pytest.mark.long
def test_one_heading_is_warned_of_and_mended(capsys, tmp_path):
    out = tmp_path / "block"
    found = reported(capsys, "plan", "flight", *PUBLISHED[:-1], "12", "--out", out)
    printed = values_of(found)
    assert [printed["flight.overlap"][k] for k in ("along", "across")] == pytest.approx([0.8, 0.6], abs=1e-3)
    assert (found["planned"]["lost"], found["planned"]["lost_level"]) == ([], ["c", "x0", "y0"])
    (turned,) = [f for f in found["remedies"] if f["name"] == "headings alternate"]
    assert (turned["lost"], turned["lost_level"]) == ([], ["c"])
    undetermined = values_of(found, ["warnings"])["plan.flight_undetermined"]
    assert undetermined["parameters"] == ["c", "x0", "y0"]
    assert "headings alternate" in undetermined["remedy"]
    assert len(read_block(out).images) == 32
    assert main(["plan", "flight", *PUBLISHED, "--out", str(out)]) == 2
    assert "[folder.exists]" in capsys.readouterr().err


def test_what_is_lost_is_no_figure(capsys):
    words = ["plan", "flight", *PUBLISHED, "--jitter", "0", "0", "--alternate"]
    assert main([*words, "--verbose"]) == 0
    (planned,) = [line for line in capsys.readouterr().out.splitlines() if line.startswith("  as planned")]
    assert planned.split()[2:] == ["32", "-", "-", "-", "-", "-", "c", "(c)"]
    lost = values_of(reported(capsys, *words), ["faults"])["plan.flight_undetermined"]
    assert (lost["parameters"], lost["lost"]) == (["c"], True)
    assert lost["remedy"] != "none"


@pytest.mark.long
def test_a_sound_plan_and_a_held_camera(capsys):
    for more in (("--cross", "30", "--control-points", "1"), ("--hold-camera",)):
        found = reported(capsys, "plan", "flight", *PUBLISHED, *more)
        assert "flight.determined" in values_of(found, ["summary"])
        assert found["planned"]["lost_level"] == []


@pytest.mark.long
def test_gaps_are_said(capsys):
    held = ("--hold-camera", "--cross", 20)
    words = ("--overlap", 0.4, 0.3, "--tie-points", 9, "--control-points", 5)
    found = reported(capsys, "plan", "flight", *words, *held)
    assert values_of(found, ["warnings"])["plan.little_overlap"]["overlap"] == pytest.approx(0.4)
    found = reported(capsys, "plan", "flight", "--base", 16, "--line-spacing", 130, "--tie-points", 14, *held)
    assert values_of(found, ["faults"])["plan.gaps_between_lines"]["overlap"] < 0


def test_the_forecast_is_that_of_the_adjustment_and_control_helps():
    free = forecast(Flight(alternating=True, points=9))
    one = forecast(Flight(alternating=True, points=9, control=1))
    assert not free.sure
    assert one.sure
    assert one.sigma_m[2] < 0.6 * free.sigma_m[2]
    assert one.sigma_c_px < free.sigma_c_px
    done = plan_flight(Flight(alternating=True, points=9, control=1))
    assert done.advised is None
    five, higher, tilted = (r.plan for r in done.remedies)
    assert (five.control, five.cross_tilt_deg) == (5, None)
    assert (higher.control, higher.cross_height) == (1, pytest.approx(1.3 * done.planned.plan.height))
    assert (tilted.control, tilted.cross_tilt_deg) == (1, 30)


def test_control_of_a_simulated_flight():
    plan = Flight(points=11, control=5, control_sigma=(0.01, 0.01, 0.02))
    block, bare = flight_block(plan), flight_block(Flight(points=11))
    known = np.flatnonzero(np.asarray(block.points.role) == Role.CONTROL)
    assert len(known) == 5
    assert block.points.sigma[known].tolist() == [[0.01, 0.01, 0.02]] * 5
    np.testing.assert_array_equal(block.observations.xy_px, bare.observations.xy_px)
    off = block.points.xyz[known] - bare.points.xyz[known]
    assert 0 < np.abs(off).max() < 0.1
    assert plan.overlap == pytest.approx((0.7999, 0.5997), abs=1e-3)
    assert plan.pixel_on_ground == pytest.approx(80 / 3650)


def test_a_flight_is_surveyed_again_with_new_positions(tmp_path, capsys):
    assert (
        main(["plan", "flight", "--alternate", "--tie-points", "9", "--free-lever-arm", "--out", str(tmp_path / "f")])
        == 0
    )
    for seed in ("3", "4"):
        assert main(["simulate", str(tmp_path / "f"), "--seed", seed, "--out", str(tmp_path / seed)]) == 0
    three, four, truth = (read_block(tmp_path / name) for name in ("3/block", "4/block", "3/truth"))
    np.testing.assert_allclose(truth.stations.xyz, truth.images.centre, rtol=0, atol=1e-9)
    errors = [(b.stations.xyz - truth.images.centre) / b.stations.sigma for b in (three, four)]
    assert np.std(errors) == pytest.approx(1, abs=0.15)
    assert abs(np.corrcoef(errors[0].ravel(), errors[1].ravel())[0, 1]) < 0.3
    capsys.readouterr()


def test_flights_that_are_too_large_are_refused_at_once(capsys):
    code, values = refusal(capsys, "plan", "flight", "--lines", "40", "--photographs-per-line", "80")
    assert code == "plan.flight_too_large"
    assert {3200, 1000, 40, 80} <= set(values.values())


def test_tie_points_are_as_dense_as_photographs_need_them():
    large = FlightSettings(lines=30, photographs_per_line=30).flight()
    assert large.size / large.points < min(large.footprint) / 2
    assert FlightSettings().flight().points == 30


def test_control_that_has_no_layout_is_refused(capsys):
    assert main(["plan", "flight", *PUBLISHED, "--control-points", "7"]) == 2
    printed = capsys.readouterr().err
    assert "1, 2, 3, 4, 5, 9, 13" in printed
    assert "[simulation.control_layout]" in printed


def test_control_by_number_and_place_is_told(capsys):
    words = ["plan", "flight", *PUBLISHED, "--alternate", "--hold-camera", "--control-table"]
    found = reported(capsys, *words)
    assert any(line.startswith("5 of 10 mm: ") for line in found["lines"])
    assert headline("flight.layouts", {}) in found["lines"]
    enough = {"sigma_mm": 10.0, "n": 5, "known": True}
    assert headline("flight.control_enough", enough).partition("5")[0] in "\n".join(found["lines"])
    assert found["without_rtk"] is not None


def test_a_mission_tells_its_precision(capsys, tmp_path):
    out = tmp_path / "plan"
    area = "7.1 50.1, 7.102 50.1005, 7.1018 50.102, 7.0998 50.1015"
    found = reported(capsys, "plan", "mission", area, "--vehicle", "mavic-3e", "--predict", "--out", out)
    rtk = values_of(found, ["summary"])["flight.predicted"]
    assert (rtk["rtk"], rtk["sigma_m"]) == (True, [0.02, 0.02, 0.03])
    assert values_of(found, ["warnings"])["plan.flown_lost"] == {"parameters": ["c"]}
    written = json.loads((out / "precision.json").read_text(encoding="utf-8"))
    assert written["not_determinable_as_planned"] == ["c"]
    assert written["rtk"]["not_determinable"] == []
    assert 0 < written["rtk"]["plan_mm"] < written["rtk"]["height_mm"] < written["without_rtk"]["height_mm"]
