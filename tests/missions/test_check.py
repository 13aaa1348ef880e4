"""Photographs against their plan: what is missing, blurred, tilted, too high; and what is to be flown again."""

import json
from dataclasses import replace

import numpy as np
import pytest
from tests.cli.reported import reported, values_of
from tests.conftest import DATA
from tests.missions.cases import LEVEL, OUTLINES, mission
from tests.missions.flying import fly, texture

import raybundle as rb
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.missions.flown import flown_of, upper_part
from raybundle.io.missions.mission_file import write_mission
from raybundle.io.photos.photo import find_photos
from raybundle.missions.check import Limits, check_flight
from raybundle.missions.mission import exposures
from raybundle.missions.polygons import inside, signed_area
from raybundle.missions.sharpness import _running_median, blur_of, blurred, sharpness, tiles

UAV = DATA / "photos/copr-uav/images"
needs_uav = pytest.mark.skipif(not UAV.is_dir(), reason=f"{UAV} is absent")

PLAN = mission("nadir")
COUNT = len(exposures(PLAN))


def checked(plan, folder, limits=None, **more):
    photos = find_photos([folder]).photos
    flown, remarks = flown_of(photos, plan, **more)
    return check_flight(plan, flown, LEVEL, limits), remarks


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    folder = tmp_path_factory.mktemp("flown")
    e = fly(PLAN, folder, off=1.0, tilt={40}, blur={60, 61})
    return folder, e


def test_a_sound_flight_needs_nothing(good):
    folder, e = good
    c, remarks = checked(PLAN, folder)
    assert remarks == ()
    assert len(c.missing) == 0
    assert sorted(c.match.tolist()) == list(range(len(e)))
    assert not c.refly
    assert np.median(c.off_plan_m) == pytest.approx(1.18, abs=0.2)  # Rayleigh, sigma 1 m
    assert np.abs(c.off_height_m).max() < 0.01
    assert c.flown.height_known
    names = np.array(c.flown.names)
    assert names[~c.counted].tolist() == ["DJI_0041.jpg", "DJI_0061.jpg", "DJI_0062.jpg"]
    assert names[c.flown.blurred & (c.flown.blur_px > 1)].tolist() == ["DJI_0061.jpg", "DJI_0062.jpg"]
    np.testing.assert_allclose(c.flown.blur_px[60:62], 5.0, atol=1.0)  # five whole pixels
    assert np.delete(c.flown.blur_px, [60, 61]).max() < 0.3
    assert np.degrees(c.tilt[40]) == pytest.approx(15, abs=0.02)
    assert np.degrees(np.delete(c.tilt, 40)).max() < 0.1
    # 15.8 m in 1.2 s at 1/1000 s over 20 mm pixels
    assert np.nanmedian(c.motion_px) == pytest.approx(PLAN.base / 1.2 / 1000 / 0.02, abs=0.05)
    assert c.along.middle == pytest.approx(0.8, abs=0.03)
    assert c.across.middle == pytest.approx(0.7, abs=0.03)


def test_a_line_that_is_missing_is_a_gap(tmp_path):
    e = fly(PLAN, tmp_path, drop=set(range(60, 110)))
    c, _ = checked(PLAN, tmp_path, sharp=False)
    assert c.missing.tolist() == list(range(60, 110))
    assert c.refly
    assert len(c.gaps) == 1
    gap = c.gaps[0]
    assert gap.seen < gap.wanted
    lost = e.xyz[60:110, :2]
    seen_there = lost[inside(OUTLINES["area"], lost)]
    assert inside(gap.outline, seen_there).mean() > 0.8
    assert gap.area_m2 <= signed_area(gap.outline) * 1.05
    assert not np.isfinite(c.flown.blur_px).any()


def test_one_missing_photograph_is_none(tmp_path):
    fly(PLAN, tmp_path, drop={100})
    c, _ = checked(PLAN, tmp_path, sharp=False)
    assert c.missing.tolist() == [100]
    assert not c.refly
    assert c.along.low == pytest.approx(0.6, abs=0.01)
    strict, _ = checked(PLAN, tmp_path, Limits(seen=30), sharp=False)
    assert strict.refly


@pytest.mark.long
def test_blurred_photographs_do_not_count(tmp_path):
    fly(PLAN, tmp_path, blur=set(range(60, 90)))
    c, _ = checked(PLAN, tmp_path)
    assert len(c.missing) == 0
    assert (~c.counted).sum() == 30
    assert c.refly
    loose, _ = checked(PLAN, tmp_path, Limits(blur_px=20.0))
    assert not loose.refly


def test_heights_of_another_zero_are_brought_together(tmp_path):
    fly(PLAN, tmp_path, bare=True, up=3.0)
    c, _ = checked(PLAN, tmp_path, sharp=False)
    assert not c.flown.height_known
    assert c.height_offset_m == pytest.approx(51.0, abs=1e-3)
    assert np.abs(c.off_height_m).max() < 1e-3
    assert np.isnan(c.tilt).all()
    assert not c.refly


def test_a_flight_that_is_too_high_is_told_where_heights_are_known(tmp_path):
    fly(PLAN, tmp_path, up=12.0)
    c, _ = checked(PLAN, tmp_path, sharp=False)
    np.testing.assert_allclose(c.off_height_m, 12.0, atol=0.01)
    assert c.height_offset_m == 0


@pytest.mark.parametrize("pattern", ["double-grid", "oblique-grid", "corridor", "facade", "orbit"])
def test_every_pattern_is_checked(pattern, tmp_path):
    plan = mission(pattern, more={"overlap": (0.7, 0.6)})
    e = fly(plan, tmp_path / "all", off=0.2)
    c, _ = checked(plan, tmp_path / "all", sharp=False)
    assert (c.match == np.arange(len(e))).mean() > 0.97  # views that cross at one place may be exchanged
    assert len(c.missing) == 0
    assert not c.refly
    lost = set(range(len(e) // 3, 2 * len(e) // 3))
    if pattern == "orbit":  # rings see beyond each other: what is lost is a side
        lost = set(np.flatnonzero(np.abs(e.heading - np.pi) < 1.0).tolist())
    fly(plan, tmp_path / "some", drop=lost)
    c, _ = checked(plan, tmp_path / "some", sharp=False)
    assert c.refly


def test_photographs_from_elsewhere(tmp_path, good):
    folder, _ = good
    away = replace(PLAN, way_points=replace(PLAN.way_points, xyz=PLAN.way_points.xyz + np.array([3000.0, 0, 0])))
    with pytest.raises(InputError, match=r"3000.*flight_check\.other_place"):
        checked(away, folder, sharp=False)
    fly(PLAN, tmp_path, position=False, drop=set(range(20, 1000)))
    with pytest.raises(InputError, match=r"flight_check\.no_positions"):
        checked(PLAN, tmp_path, sharp=False)


@pytest.fixture(scope="module")
def sharp():
    """Twelve pictures, their tiles and their sharpness."""
    pictures = [texture(k).astype(np.float32) for k in range(12)]
    squares = [tiles(p) for p in pictures]
    return pictures, squares, [sharpness(s) for s in squares]


@pytest.mark.parametrize("length", [2.0, 3.0, 5.0])
@pytest.mark.parametrize("axis", [0, 1])
def test_blur_is_found_in_pixels(length, axis, sharp):
    pictures, squares, found = sharp
    found = list(found)
    found[5] = sharpness(tiles(blurred(pictures[5], length, axis)))
    blur = blur_of(found, squares[:3])
    assert blur.other.tolist() == [k == 5 for k in range(12)]
    assert blur.px[5] == pytest.approx(length, abs=0.3)


def test_photographs_are_compared_with_those_before_and_after():
    """Of 12 with one unknown: each with the four on either side, at the ends with the nearest nine."""
    values, known = np.arange(12.0)[:, None] ** 2 * [1.0, 2.0], np.arange(12) != 7
    rows = np.delete(np.arange(12.0), 7)
    found = _running_median(values, known)
    assert np.isnan(found[7]).all()
    first = np.clip(np.arange(11) - 4, 0, 2)
    np.testing.assert_array_equal(found[known], rows[first + 4][:, None] ** 2 * [1.0, 2.0])


def test_pictures_without_texture_are_not_known():
    flat = [sharpness(tiles(np.full((300, 300), 7.0, np.float32)))] * 3
    assert len(tiles(texture())) == 12  # of 25, the half with the most texture
    blur = blur_of(flat, [tiles(texture())])
    assert np.isnan(blur.px).all()
    assert not blur.other.any()


@pytest.mark.long
@needs_uav
@pytest.mark.data
def test_real_photographs_of_a_flight_whose_blur_is_known():
    """The beach of copr-uav: one photograph smeared by six pixels is found, in any place."""
    photos = find_photos([UAV]).photos
    grey = [upper_part(p).astype(np.float32) for p in photos]
    squares = [tiles(g) for g in grey]
    whole = [sharpness(s) for s in squares]
    assert blur_of(whole, squares[::8]).other.sum() <= 3
    for k in range(0, len(photos), 5):
        found = list(whole)
        found[k] = sharpness(tiles(blurred(grey[k], 6.0, 1)))
        blur = blur_of(found, squares[::8])
        assert blur.other[k]
        assert 3 < blur.px[k] < 9


def test_the_command_tells_and_writes(tmp_path, capsys):
    write_mission(PLAN, tmp_path / "mission.toml")
    fly(PLAN, tmp_path / "flown", drop=set(range(60, 110)), blur={30}, tilt={150})
    out = tmp_path / "check"
    found = values_of(reported(capsys, "plan", "check", tmp_path, tmp_path / "flown", "--out", out, status=4))
    counts = found["flight_check.photographs"]
    assert (counts["planned"], counts["missing"], counts["beside"]) == (COUNT, 50, 0)
    (blurred,) = found["flight_check.blurred"]["names"]
    assert blurred.startswith("DJI_0031.jpg (")
    assert found["flight_check.tilted"]["names"] == ["DJI_0151.jpg"]
    assert found["flight_check.gaps"]["n"] == 1
    assert sorted(p.name for p in out.iterdir()) == ["check.svg", "gaps.geojson", "gaps.kml", "photographs.csv"]
    rows = (out / "photographs.csv").read_text().splitlines()
    assert sum(r.endswith(",no,missing") for r in rows) == 50
    assert any(r.startswith("DJI_0031.jpg,31,") and r.endswith("no,blurred") for r in rows)
    assert any(r.startswith("DJI_0151.jpg,151,") and r.endswith("no,tilted") for r in rows)
    assert not any(r.endswith("not planned") for r in rows)
    assert len(json.loads((out / "gaps.geojson").read_text())["features"]) == 1
    again = rb.plan_mission(out / "gaps.geojson", tmp_path / "again", vehicle="mavic-3e", gsd=0.02)
    assert again.facts.photographs < COUNT
    assert rb.plan_mission(out / "gaps.kml", tmp_path / "again2", vehicle="mavic-3e").facts.lines > 0
    assert json.loads((out / "gaps.geojson").read_text())["features"][0]["properties"]["wanted"] >= 3
    assert main(["plan", "check", str(tmp_path), str(tmp_path / "flown"), "--out", str(out)]) == 2
    assert "[folder.exists]" in capsys.readouterr().err
    done = rb.check_flight(tmp_path, tmp_path / "flown", sharpness=False)
    assert done.check.refly


def test_nothing_to_fly_again_ends_with_status_0(tmp_path, capsys, good):
    write_mission(PLAN, tmp_path / "mission.toml")
    found = reported(capsys, "plan", "check", tmp_path / "mission.toml", good[0], "--no-sharpness")
    assert "flight_check.nothing_again" in values_of(found, ["summary"])


def test_positions_from_a_file(tmp_path, capsys):
    write_mission(PLAN, tmp_path / "mission.toml")
    e = fly(PLAN, tmp_path / "flown", position=False, bare=True)
    rows = ["image,X,Y,Z"] + [
        f"DJI_{k + 1:04d}.jpg,{x:.3f},{y:.3f},{z:.3f}" for k, (x, y, z) in enumerate(e.xyz.tolist())
    ]
    (tmp_path / "positions.csv").write_text("\n".join(rows) + "\n")
    words = ["plan", "check", str(tmp_path), str(tmp_path / "flown"), "--positions", str(tmp_path / "positions.csv")]
    assert main([*words, "--crs", PLAN.crs, "--no-sharpness"]) == 0
    assert "0 missing" in capsys.readouterr().out


def test_bad_input_of_the_command(tmp_path, capsys, good):
    (tmp_path / "empty").mkdir()
    assert main(["plan", "check", str(tmp_path / "none.toml"), str(good[0])]) == 2
    assert "[file.missing]" in capsys.readouterr().err
    write_mission(PLAN, tmp_path / "mission.toml")
    assert main(["plan", "check", str(tmp_path), str(tmp_path / "empty")]) == 2
    assert "[photograph.none]" in capsys.readouterr().err
    write_mission(replace(PLAN, crs=""), tmp_path / "local.toml")
    assert main(["plan", "check", str(tmp_path / "local.toml"), str(good[0])]) == 2
    assert "[flight_check.no_crs]" in capsys.readouterr().err
