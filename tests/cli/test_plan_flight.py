"""`raybundle plan flight` by area and pixel, what it calls things, and in which units it tells them."""

import re
from dataclasses import replace

import numpy as np
import pytest
from tests.missions.cases import CAMERA, mission

from raybundle.cli.main import main
from raybundle.cli.plan.flight import _verdict
from raybundle.cli.plan.precision import cell, length
from raybundle.commands.planning.flight import FlightSettings
from raybundle.errors import InputError
from raybundle.missions.mission import exposures
from raybundle.planning.flight import FlightPlan, forecast
from raybundle.planning.uav_networks import Flight

FAST = ("--tie-points", "8", "--hold-camera")


def run(capsys, *words):
    status = main(["plan", "flight", *map(str, words)])
    got = capsys.readouterr()
    return status, got.out, got.err


def test_area_and_pixel_give_height_lines_and_photographs(capsys):
    status, told, _ = run(capsys, "--area", 100, 150, "--gsd", 0.02, "--tie-points", 10, "--hold-camera")
    assert status == 0
    # 0.02 m of 3650 px: 73 m; 3648 and 5472 px of it: 73.0 and 109.4 m; a fifth and three tenths of them
    assert " 5 lines of 14 photographs, 73 m above ground; base 14.6 m, lines 32.8 m apart; a pixel is 20 mm" in told
    assert " overlap 80 % along, 70 % across; tie points over 100 m x 150 m" in told
    assert " positions of 0.02, 0.02, 0.03 m (RTK)" in told


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
    told = _verdict(FlightPlan(planned=planned, without_rtk=None, remedies=()))
    assert told.endswith("c hangs on the unevenness of the flight alone; none of the changes above mends it: hold the "
                         "camera as calibrated (--hold-camera)")  # fmt: skip
    arm = replace(planned, lost_level=("c", "az"))
    assert "(--hold-camera), and measure the lever arm" in _verdict(
        FlightPlan(planned=arm, without_rtk=None, remedies=())
    )


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
    _, arm, _ = run(capsys, "--free-lever-arm", "--cross", 30, "--tie-points", 8)
    assert " the same without RTK, lever arm held " in arm
    _, poor, _ = run(capsys, "--rtk", 5, 5, 10, *FAST)
    assert " positions of 5, 5, 10 m (no RTK)" in poor
    assert poor.count("RTK") == 1


def test_what_mends_is_told_for_each_that_hangs(capsys):
    _, told, _ = run(capsys, "--no-rtk", "--alternate", "--tie-points", 12)
    verdict = told.splitlines()[-1]
    found = re.search(
        r"warning: c.* hangs? on .*; what mends it: lines across, tilted 30 deg, five control points; "
        r"sigma Z ([\d.]+) m to ([\d.]+) mm, c ([\d.]+) px to ([\d.]+) px",
        verdict,
    )
    assert found, verdict
    z, z_after, c, c_after = map(float, found.groups())
    assert 1000 * z > 50 * z_after
    assert c > 10 * c_after
    (five,) = [line for line in told.splitlines() if line.startswith(" five control points")]
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
    _, told, _ = run(capsys, "--no-rtk", *FAST)
    assert "e+0" not in told
    assert re.search(r"as planned +32 +[\d.]+ m +[\d.]+ m +[\d.]+ m", told)
    _, table, _ = run(capsys, "--no-rtk", "--control-table", *FAST)
    (none,) = [line for line in table.splitlines() if line.startswith(" none ")]
    assert re.search(r"none +[\d.]+ m +[\d.]+ m +", none)


@pytest.mark.long
def test_a_mission_tells_metres_and_its_positions(capsys, tmp_path):
    area = "7.1 50.1, 7.102 50.1005, 7.1018 50.102, 7.0998 50.1015"
    words = ["plan", "mission", area, "--vehicle", "mavic-3e", "--predict"]
    assert main([*words, "--free-lever-arm", "--out", str(tmp_path / "a")]) == 0
    told = capsys.readouterr().out
    assert "no RTK (5, 5, 10 m), lever arm held: plan 1." in told
    assert "e+0" not in told
    assert main([*words, "--rtk", "5", "5", "10", "--out", str(tmp_path / "b")]) == 0
    told = capsys.readouterr().out
    assert told.count("RTK") == 1
    assert "  no RTK (5, 5, 10 m): plan " in told
    assert main([*words, "--overlap", "0.3", "0.02", "--out", str(tmp_path / "c")]) == 0
    told = capsys.readouterr().out
    assert "what neighbours have in common is too narrow; ask for more overlap (--overlap)" in told
    assert "everything cannot" not in told


@pytest.mark.long
def test_a_facade_is_told_of_turned_views(capsys, tmp_path):
    wall = "7.1 50.1, 7.102 50.1005"
    words = ["--pattern", "facade", "--heights", "0", "18", "--gsd", "0.003", "--predict", "--out", str(tmp_path / "w")]
    assert main(["plan", "mission", wall, "--vehicle", "mavic-3e", *words]) == 0
    told = capsys.readouterr().out
    assert "what determines everything: the rows flown once more with the view turned" in told
    assert "oblique-grid" not in told
    assert "terrain" not in told
