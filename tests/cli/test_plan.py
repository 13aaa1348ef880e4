"""`raybundle plan flight`: what a flight will not determine is said before it is flown, and what mends it."""

import json

import numpy as np
import pytest

from raybundle.block import Role
from raybundle.cli.main import main
from raybundle.commands.planning.flight import FlightSettings
from raybundle.io.block.folder import read_block
from raybundle.planning.flight import forecast, plan_flight
from raybundle.planning.uav_networks import Flight, flight_block
from raybundle.words import headline

PUBLISHED = ("--base", "16", "--line-spacing", "48", "--ground", "120", "--tie-points", "9")


@pytest.mark.long
def test_one_heading_is_warned_of_and_mended(capsys, tmp_path):
    out = tmp_path / "block"
    assert main(["plan", "flight", *PUBLISHED[:-1], "12", "--out", str(out)]) == 0
    told = capsys.readouterr().out
    assert "overlap 80 % along, 60 % across" in told
    (planned,) = [line for line in told.splitlines() if line.startswith(" as planned")]
    assert planned.endswith("none (c, x0, y0)")
    (turned,) = [line for line in told.splitlines() if line.startswith(" headings alternate  ")]
    assert turned.endswith("none (c)")
    assert "warning: c, x0, y0 hang on the unevenness of the flight alone; what mends it: lines across" in told
    assert len(read_block(out).images) == 32
    assert main(["plan", "flight", *PUBLISHED, "--out", str(out)]) == 2
    assert "stands there already" in capsys.readouterr().err


def test_what_is_lost_is_no_figure(capsys):
    assert main(["plan", "flight", *PUBLISHED, "--jitter", "0", "0", "--alternate"]) == 0
    told = capsys.readouterr().out
    (planned,) = [line for line in told.splitlines() if line.startswith(" as planned")]
    assert planned.split()[2:] == ["32", "-", "-", "-", "-", "-", "c", "(c)"]
    assert "fault: c cannot be determined by this flight; what mends it" in told


@pytest.mark.long
def test_a_sound_plan_and_a_held_camera(capsys):
    assert main(["plan", "flight", *PUBLISHED, "--cross", "30", "--control-points", "1"]) == 0
    assert "everything is determined by design" in capsys.readouterr().out
    assert main(["plan", "flight", *PUBLISHED, "--hold-camera"]) == 0
    assert "everything is determined by design" in capsys.readouterr().out


@pytest.mark.long
def test_gaps_are_said(capsys):
    assert (
        main(
            [
                "plan",
                "flight",
                "--overlap",
                "0.4",
                "0.3",
                "--tie-points",
                "9",
                "--hold-camera",
                "--control-points",
                "5",
                "--cross",
                "20",
            ]
        )
        == 0
    )
    assert "below 50 % along" in capsys.readouterr().out
    assert (
        main(
            [
                "plan",
                "flight",
                "--base",
                "16",
                "--line-spacing",
                "130",
                "--tie-points",
                "14",
                "--hold-camera",
                "--cross",
                "20",
            ]
        )
        == 0
    )
    assert "the lines leave gaps" in capsys.readouterr().out


def test_the_forecast_is_that_of_the_adjustment_and_control_helps():
    free = forecast(Flight(alternating=True, points=9))
    one = forecast(Flight(alternating=True, points=9, control=1))
    assert not free.sure
    assert one.sure
    assert one.sigma_m[2] < 0.6 * free.sigma_m[2]
    assert one.sigma_c_px < free.sigma_c_px
    done = plan_flight(Flight(alternating=True, points=9, control=1))
    assert done.advised is None
    assert [r.name for r in done.remedies] == [
        "five control points", "lines across, 1.3 times as high", "lines across, tilted 30 deg",
    ]  # fmt: skip


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
    assert main(["plan", "flight", "--lines", "40", "--photographs-per-line", "80"]) == 2
    assert "3 200 photographs; forecasts are possible for up to 1 000. [plan.flight_too_large]\n  40 lines of 80 " in (
        capsys.readouterr().err
    )


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
    assert main(["plan", "flight", *PUBLISHED, "--alternate", "--hold-camera", "--control-table"]) == 0
    told = capsys.readouterr().out
    assert "5 of 10 mm: corners and middle" in told
    assert "are enough; more bring less than 10 % of the worst height" in told
    assert "where five of 10 mm lie" in told
    assert " the same without RTK" in told


def test_a_mission_tells_its_precision(capsys, tmp_path):
    out = tmp_path / "plan"
    area = "7.1 50.1, 7.102 50.1005, 7.1018 50.102, 7.0998 50.1015"
    assert main(["plan", "mission", area, "--vehicle", "mavic-3e", "--predict", "--out", str(out)]) == 0
    told = capsys.readouterr().out
    assert "predicted without control" in told
    assert "  RTK (0.02, 0.02, 0.03 m): plan " in told
    assert headline("plan.flown_lost", {"parameters": ["c"]}) in told
    written = json.loads((out / "precision.json").read_text(encoding="utf-8"))
    assert written["not_determinable_as_planned"] == ["c"]
    assert written["rtk"]["not_determinable"] == []
    assert 0 < written["rtk"]["plan_mm"] < written["rtk"]["height_mm"] < written["without_rtk"]["height_mm"]
