"""`raybundle plan flight` by area and pixel, what it calls things, and in which units it tells them."""

import re
from dataclasses import replace

import numpy as np
import pytest
from tests.cli.reported import reported, texts_of, values_of
from tests.missions.cases import CAMERA, mission

from raybundle.cli.main import main
from raybundle.cli.plan.flight import verdict
from raybundle.cli.plan.precision import cell, length
from raybundle.commands.planning.flight import FlightSettings
from raybundle.errors import InputError
from raybundle.missions.mission import exposures
from raybundle.planning.flights.flight import FlightPlan, forecast
from raybundle.planning.flights.uav_networks import Flight

FAST = ("--tie-points", "8", "--hold-camera")


def run(capsys, *words):
    status = main(["plan", "flight", *map(str, words)])
    got = capsys.readouterr()
    return status, got.out, got.err


def reports(capsys, *words):
    """Values of what the command reports, by code."""
    return values_of(reported(capsys, "plan", "flight", *words))


def predictions(found):
    """What a mission predicts, with RTK and without."""
    return [m["values"] for m in (*found["summary"], *found["details"]) if m["code"] == "flight.predicted"]


def test_area_and_pixel_give_height_lines_and_photographs(capsys):
    found = reports(capsys, "--area", 100, 150, "--gsd", 0.02, "--tie-points", 10, "--hold-camera")
    # 0.02 m of 3650 px: 73 m; 3648 and 5472 px of it: 73.0 and 109.4 m; a fifth and three tenths of them
    assert found["flight.lines"] == pytest.approx({"lines": 5, "n": 14, "height_m": 73.0, "pixel_mm": 20.0})
    assert found["flight.spacing"] == pytest.approx({"base_m": 14.592, "spacing_m": 32.832})
    overlap = {"along": 0.8, "across": 0.7, "width_m": 100.0, "length_m": 150.0}
    assert found["flight.overlap"] == pytest.approx(overlap)
    assert found["flight.positions"] == {"sigma_m": [0.02, 0.02, 0.03], "rtk": True}


@pytest.mark.parametrize("area", [(50.0, 80.0), (131.0, 64.0), (32.832, 29.184)])
@pytest.mark.parametrize("overlap", [(0.8, 0.7), (0.6, 0.3)])
def test_lines_cover_the_area_with_the_overlap_asked_for_and_no_line_too_many(area, overlap):
    plan = FlightSettings(area=area, gsd=0.02, overlap=overlap).flight()
    assert plan.height == pytest.approx(0.02 * 3650)
    assert plan.pixel_on_ground == pytest.approx(0.02)
    assert plan.overlap == pytest.approx(overlap)
    wide, long = area[0] + plan.spacing, area[1] + plan.spacing  # half a spacing beyond each edge
    assert (plan.lines - 1) * plan.spacing < wide <= plan.lines * plan.spacing * (1 + 1e-9)
    assert (plan.photographs - 2) * plan.base < long <= (plan.photographs - 1) * plan.base * (1 + 1e-9)
    assert plan.sides == area


def test_lines_and_photographs_are_those_of_a_mission_over_the_same_area():
    sides = (200.0, 300.0)
    settings = FlightSettings(area=sides, gsd=0.02, camera=f"{CAMERA.width_px}x{CAMERA.height_px},{CAMERA.c_px}")
    flight = settings.flight()
    ring = np.array([[0.0, 0], [sides[0], 0], sides, [0, sides[1]]])
    m = mission("nadir", outline=ring, more={"direction": 0.0}, take_off=(0.0, 0.0))
    assert (flight.lines, flight.lines * flight.photographs) == (len(m.lines), len(exposures(m)))
    assert (flight.base, flight.spacing) == pytest.approx((m.base, m.spacing))


def test_what_no_change_mends_is_to_be_known_from_elsewhere():
    plan = Flight(points=9, alternating=True)
    planned = forecast(plan)
    for lost, hold in ((("c",), "camera"), (("c", "az"), "both"), (("az",), "lever_arm")):
        some = replace(planned, lost_level=lost)
        (found,) = verdict(FlightPlan(planned=some, without_rtk=None, remedies=()))
        assert (found.code, found.severity) == ("plan.flight_undetermined", "warning")
        assert found.values["parameters"] == list(lost)
        assert (found.values["remedy"], found.values["hold"]) == ("none", hold)


def test_an_area_without_a_pixel_and_a_pixel_without_an_area():
    assert FlightSettings(area=(100.0, 100.0)).flight().height == 80.0
    usual, fine = FlightSettings().flight(), FlightSettings(gsd=0.01).flight()
    assert (usual.lines, usual.photographs, usual.length) == (4, 8, None)
    assert (fine.lines, fine.photographs) == (4, 8)
    assert fine.height == pytest.approx(36.5)
    given = FlightSettings(area=(100.0, 100.0), base=10.0, line_spacing=25.0).flight()
    assert (given.lines, given.photographs) == (5, 14)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--area", 100, 100, "--lines", 4), "--area and --lines exclude each other. [option.exclusive]"),
        (
            ("--area", 100, 100, "--lines", 4, "--photographs-per-line", 8),
            "--area and --lines exclude each other. [option.exclusive]",
        ),
        (("--area", 100, 100, "--ground", 90), "--area and --ground exclude each other. [option.exclusive]"),
        (("--gsd", 0.02, "--height", 80), "--gsd and --height exclude each other. [option.exclusive]"),
        (("--area", 2000, 300), "57 lines of 23 photographs cover 2000 x 300 m (base 16 m, lines 36 m apart)"),
    ],
)  # fmt: skip
def test_contradictions_are_refused(words, told, capsys):
    status, _, err = run(capsys, *words)
    assert status == 2
    assert told in err


def test_contradictions_are_told_in_python_as_python_writes_them():
    with pytest.raises(InputError, match=r"gsd=.*height=.*option\.exclusive"):
        FlightSettings(gsd=0.02, height=80.0).flight()


@pytest.mark.long
def test_rows_are_called_what_they_are(capsys):
    arm = reported(capsys, "plan", "flight", "--free-lever-arm", "--cross", 30, "--tie-points", 8)
    assert arm["without_rtk"]["name"].endswith(" held")
    assert reports(capsys, "--rtk", 5, 5, 10, *FAST)["flight.positions"] == {"sigma_m": [5, 5, 10], "rtk": False}
    _, poor, _ = run(capsys, "--rtk", 5, 5, 10, *FAST, "--verbose")
    assert poor.count("RTK") == 1


def test_what_mends_is_told_for_each_that_hangs(capsys):
    words = ("--no-rtk", "--alternate", "--tie-points", 12)
    found = reports(capsys, *words)["plan.flight_undetermined"]
    assert "c" in found["parameters"]
    assert ("30 deg" in found["remedy"], "five" in found["remedy"]) == (True, True)
    first, second = (re.fullmatch(r"(\w+) ([\d.]+) m?\w+ to ([\d.]+) \w+", f) for f in found["figures"][:2])
    assert (first[1], second[1]) == ("Z", "c")
    assert 1000 * float(first[2]) > 50 * float(first[3])
    assert float(second[2]) > 10 * float(second[3])
    _, printed, _ = run(capsys, *words, "--verbose")
    (five,) = [line.strip() for line in printed.splitlines() if line.startswith("  five ")]
    assert re.search(r"Z x\d+, (c|K1) x1(\.\d+)? ", five), five


@pytest.mark.long
def test_metres_from_one_metre_on(capsys):
    assert [length(v) for v in (0.0161, 0.9994, 0.9996, 1.491, np.nan)] == [
        "16.1 mm",
        "999 mm",
        "1.00 m",
        "1.49 m",
        "-",
    ]
    assert [cell(v, 0) for v in (0.0161, 0.9994, 1.491, np.nan)] == ["16", "999", "1.49 m", "-"]
    _, told, _ = run(capsys, "--no-rtk", *FAST, "--verbose")
    assert "e+0" not in told
    assert re.search(r"as planned +32 +[\d.]+ m +[\d.]+ m +[\d.]+ m", told)
    _, table, _ = run(capsys, "--no-rtk", "--control-table", *FAST)
    (none,) = [line for line in table.splitlines() if line.startswith("none ")]
    assert re.search(r"none +[\d.]+ m +[\d.]+ m +", none)


@pytest.mark.long
def test_a_mission_tells_metres_and_its_positions(capsys, tmp_path):
    area = "7.1 50.1, 7.102 50.1005, 7.1018 50.102, 7.0998 50.1015"
    words = ["plan", "mission", area, "--vehicle", "mavic-3e", "--predict"]
    arm = predictions(reported(capsys, *words, "--free-lever-arm", "--out", tmp_path / "a"))[-1]
    assert (arm["rtk"], arm["sigma_m"], arm["held"]) == (False, [5, 5, 10], True)
    assert re.fullmatch(r"1\.\d\d m", arm["plan"])
    (poor,) = predictions(reported(capsys, *words, "--rtk", 5, 5, 10, "--out", tmp_path / "b"))
    assert (poor["rtk"], poor["sigma_m"], poor["held"]) == (False, [5, 5, 10], False)
    narrow = reported(capsys, *words, "--overlap", 0.3, 0.02, "--out", tmp_path / "c")
    assert "plan.flown_apart" in values_of(narrow, ["warnings"])
    assert "plan.flown_lost" not in values_of(narrow)


@pytest.mark.long
def test_a_facade_is_told_of_turned_views(capsys, tmp_path):
    wall = "7.1 50.1, 7.102 50.1005"
    words = ["--pattern", "facade", "--heights", "0", "18", "--gsd", "0.003", "--predict", "--out", str(tmp_path / "w")]
    found = reported(capsys, "plan", "mission", wall, "--vehicle", "mavic-3e", *words)
    kinds = [m["values"]["kind"] for m in found["notes"] if m["code"] == "flight.mend"]
    assert kinds[0] == "turned"
    assert "oblique-grid" not in kinds
    assert "terrain" not in texts_of(found)
