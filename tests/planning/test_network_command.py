"""`raybundle plan network`: from an object to a folder that other commands take."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest
import trimesh
from tests.cli.reported import reported, values_of

import raybundle as rb
from raybundle.cli.main import main
from raybundle.errors import phrase
from raybundle.io.block.folder import read_block
from raybundle.objects.kinds import object_kinds

EVERYWHERE = ("-99", "-99", "-99", "99", "99", "99")
SMALL = ("--object-points", "30", "--effort", "quick", "--progress", "none")


def plan(tmp_path, *words, name="plan"):
    return main(["plan", "network", *words, *SMALL, "--out", str(tmp_path / name)])


def planned(capsys, tmp_path, *words, name="plan"):
    """Values of what a plan reports, by code."""
    return values_of(reported(capsys, "plan", "network", *words, *SMALL, "--out", tmp_path / name))


def rows(path):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@pytest.mark.long
def test_the_block_of_a_plan_is_adjusted_to_what_was_promised(tmp_path, capsys):
    found = planned(capsys, tmp_path, "facade:6,4", "--photographs", 8, "--aim", "mean", "--heights", 0.5, 4)
    stations = found["network.stations"]
    assert (stations["n"], stations["object"], stations["aim"]) == (8, "facade 6 x 4 m", "mean")
    folder = tmp_path / "plan"
    told = json.loads((folder / "plan.json").read_text())
    block = read_block(folder / "block")
    assert len(block.images) == told["photographs"] == 8
    result = rb.adjust(block, rb.AdjustmentOptions(datum="inner", datum_points=block.points.ids, jobs=1))
    stated = result.precision.object_point_std / result.sigma0
    promised = np.array([[float(r[f"s{a}_mm"]) for a in "XYZ"] for r in rows(folder / "points.csv")]) / 1000
    assert np.abs(stated / promised - 1).max() < 0.01  # the first is taken at the adjusted values
    assert result.sigma0 == pytest.approx(1, abs=0.2)
    stations = rows(folder / "stations.csv")
    assert [r["image"] for r in stations] == list(block.images.ids)
    assert all(r["what_for"] for r in stations)
    page = (folder / "network.html").read_text()
    assert phrase("network_page.sigma_of_object") in page
    assert stations[0]["what_for"].split(".")[0] in page


QUICK = {"facade", "box"}
"""Kinds that every run of the tests plans; the others take longer together than all other commands"""


@pytest.mark.parametrize(
    "kind",
    [pytest.param(k, marks=() if name in QUICK else pytest.mark.long) for name, k in object_kinds.items()],
    ids=lambda k: k.name,
)
def test_every_kind_of_object_is_planned(tmp_path, kind, capsys):
    size = ",".join(f"{v:g}" for v in kind.example)
    words = (f"{kind.name}:{size}", "--photographs", 10, "--rays", 2, "--hold-camera")
    assert planned(capsys, tmp_path, *words)["network.stations"]["object"].startswith(kind.name)


@pytest.mark.long
def test_meshes_are_objects(tmp_path, capsys):
    machine = trimesh.creation.box(bounds=[[0, 0, 0], [2000, 1000, 1500]])
    machine.export(tmp_path / "machine.stl")
    wanted = (str(tmp_path / "machine.stl"), "--photographs", "12", "--rays", "2", "--hold-camera")
    found = planned(capsys, tmp_path, *wanted, "--unit", "0.001")
    assert "2 x 1 x 1.5 m, 12 triangles" in found["network.stations"]["object"]
    assert rb.read_block(tmp_path / "plan/block").points.xyz[:, 2].max() <= 1.5
    (tmp_path / "broken.ply").write_bytes(b"ply\nformat ascii 1.0\nelement vertex 3\n")
    (tmp_path / "cloud.obj").write_text("v 0 0 0\nv 1 0 0\n")
    for name, word in (
        ("broken.ply", "[mesh.not_readable]"),
        ("cloud.obj", "triangles"),
        ("none.stl", "[file.missing]"),
    ):
        assert plan(tmp_path, str(tmp_path / name), "--photographs", "8", name="x") == 2
        assert word in capsys.readouterr().err
    machine.apply_scale(1e-6)
    machine.export(tmp_path / "tiny.stl")
    assert plan(tmp_path, str(tmp_path / "tiny.stl"), "--photographs", "8", name="x") == 2
    assert "--unit" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("box:4,3", "--photographs", "8"), "[object.number_count]"),
        (("box:4,3,-1", "--photographs", "8"), "[object.dimension_out_of_range]"),
        (("boks:4,3,1", "--photographs", "8"), "(box:4,3,2.5"),
        (("box:4,3,2", ), "[plan.no_goal]"),
        (("facade:6,4", "--photographs", "8", "--heights", "4", "1"), "[site.empty]"),
        (("facade:6,4", "--photographs", "8", "--focus", "0.02"), "[lens.focus_too_near]"),
        (("facade:6,4", "--photographs", "8", "--around", "1"), "1 m away. [plan.never_sharp]"),
        (("facade:6,4", "--photographs", "8", "--forbid", *EVERYWHERE), "[plan.no_station_allowed]"),
        (("box:4,3,2", "--photographs", "3", "--incidence", "20"), "points of the object"),
        pytest.param(("facade:60,40", "--sigma", "0.000001"), "[plan.beyond_reach]", marks=pytest.mark.long),
    ],
)  # fmt: skip
def test_bad_input_is_told_what_to_do(tmp_path, capsys, words, said):
    assert plan(tmp_path, *words) in {2, 3}
    told = capsys.readouterr().err
    assert said in told
    assert "Traceback" not in told
    assert not (tmp_path / "plan").exists()


LINES = '[cameras.{id}]\nmodel = "{model}"\nwidth_px = 600\nheight_px = 400\npixel_mm = [0.01, 0.01]\nc_mm = 4.0\n'


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "0; exactly one is needed. [calibration.camera_count]"),
        (
            LINES.format(id="a", model="brown") + LINES.format(id="b", model="brown"),
            "2; exactly one is needed. [calibration.camera_count]",
        ),
        (
            LINES.format(id="a", model="brown_rolling") + "r = 0.005\n",
            "a (brown_rolling) is not a frame camera of single stations. [plan.no_frame_camera]",
        ),
    ],
)
def test_cameras_of_a_calibration(tmp_path, capsys, text, said):
    (tmp_path / "camera.toml").write_text(text)
    assert plan(tmp_path, "box:4,3,2", "--photographs", "8", "--camera", str(tmp_path / "camera.toml")) == 2
    assert said in capsys.readouterr().err


@pytest.mark.long
def test_what_cannot_be_seen_is_told(tmp_path, capsys):
    found = planned(capsys, tmp_path, "box:4,3,2.5", "--photographs", 10, "--rays", 2, "--incidence", 60)
    unseen = found["plan.points_out_of_sight"]
    assert (unseen["sides"], unseen["rays"]) == (["+Z"], 2)


@pytest.mark.long
def test_in_python_alike(tmp_path):
    done = rb.plan_network("facade:6,4", tmp_path / "p", photographs=6, object_points=30, rays=2, effort="quick")
    assert len(done.design.stations) == 6
    assert (tmp_path / "p/network.html").exists()


@pytest.mark.long
def test_outlines_and_axes_are_objects(tmp_path, capsys):
    (tmp_path / "gable.csv").write_text("X,Z\n0,0\n8,0\n8,5\n4,8\n0,5\n")
    found = planned(capsys, tmp_path, f"facade:{tmp_path / 'gable.csv'}", "--photographs", 9, "--rays", 2)
    assert found["network.stations"]["object"] == "facade 8 x 8 m"
    assert rb.read_block(tmp_path / "plan/block").points.xyz[:, 2].max() > 6.5
    axis = {"type": "LineString", "coordinates": [[7.1, 50.1], [7.1004, 50.1], [7.1006, 50.1002]]}
    (tmp_path / "road.geojson").write_text(json.dumps(axis))
    words = (f"corridor:{tmp_path / 'road.geojson'},6", "--photographs", "12", "--rays", "2", "--hold-camera")
    assert "6 m wide" in planned(capsys, tmp_path, *words, name="road")["network.stations"]["object"]
    for text, said in (
        ("1,2\n3\n", "line 2"),
        ("a,b\n", "[outline.empty]"),
        ("0,0\n2,2\n2,0\n0,2\n", "[outline.crosses_itself]"),
    ):
        (tmp_path / "bad.csv").write_text(text)
        assert plan(tmp_path, f"facade:{tmp_path / 'bad.csv'}", "--photographs", "9", name="x") == 2
        assert said in capsys.readouterr().err


@pytest.mark.long
def test_rasters_of_heights_are_objects(tmp_path, capsys):
    pytest.importorskip("rasterio")
    raster = str(Path(__file__).parents[1] / "missions/jacksboro.tif")
    words = (raster, "--photographs", "12", "--rays", "2", "--hold-camera", "--measured", "natural")
    found = planned(capsys, tmp_path, *words, "--crs", "EPSG:32614", "--c", "24")
    assert "cells of" in found["network.stations"]["object"]
    assert plan(tmp_path, raster, "--photographs", "8", name="x") == 2
    assert "degrees" in capsys.readouterr().err


@pytest.mark.long
def test_results_are_objects_and_their_stations_are_judged(tmp_path, capsys):
    found = planned(capsys, tmp_path, "facade:6,4", "--photographs", 10, "--rays", 2, "--scale-bars", 2)
    assert found["network.known"]["bars"] == len(found["network.known"]["lengths_m"]) == 2
    first = tmp_path / "plan"
    assert json.loads((first / "plan.json").read_text())["known"]["scale_bars"] == 2
    assert main(["simulate", str(first), "--seed", "3", "--out", str(tmp_path / "measured")]) == 0
    assert main(["adjust", str(tmp_path / "measured/block"), "--out", str(tmp_path / "done")]) == 0
    promised = np.array([[float(r[f"s{a}_mm"]) for a in "XYZ"] for r in rows(first / "points.csv")])
    result = json.loads((tmp_path / "done/result.json").read_text())
    stated = 1000 * np.array([[float(r[f"s{a}"]) for a in "XYZ"] for r in rows(tmp_path / "done/points.csv")])
    assert np.abs(stated / result["sigma0"] / promised - 1).max() < 0.05  # stated at adjusted values
    truth, block = rb.read_block(tmp_path / "measured/truth"), rb.read_block(tmp_path / "measured/block")
    pixels = (block.observations.xy_px - truth.observations.xy_px) / 0.05
    assert np.mean(pixels**2) == pytest.approx(1, abs=0.15)
    same = (str(tmp_path / "done"), "--stations", str(tmp_path / "done"), "--rays", "2", "--control-points", "4")
    assert plan(tmp_path, *same, name="again") == 0
    told = json.loads((tmp_path / "again/plan.json").read_text())
    assert told["photographs"] == 10
    assert told["known"]["control"] == 4
    assert "control" in {r["known"] for r in rows(tmp_path / "again/points.csv")}
    turned = [line.split(",") for line in (first / "stations.csv").read_text().splitlines()]
    turned[1][4:7] = turned[1][1], turned[1][2], "99"  # looks up
    (tmp_path / "up.csv").write_text("\n".join(",".join(r) for r in turned) + "\n")
    assert plan(tmp_path, "facade:6,4", "--stations", str(tmp_path / "up.csv"), "--rays", "2", name="x") == 2
    assert "[plan.station_sees_too_few]" in capsys.readouterr().err
    assert plan(tmp_path, *same[:-1], "2", name="x") == 2
    assert "[plan.too_few_control]" in capsys.readouterr().err
    assert main(["simulate", str(first), "--control-points", "3", "--out", str(tmp_path / "y")]) == 2
    assert "[simulation.setting_of_scenes]" in capsys.readouterr().err


@pytest.mark.long
def test_whole_surfaces_and_photographs_once_more(tmp_path, capsys):
    words = ("facade:6,4", "--sigma", "0.3", "--rays", "2", "--hold-camera", "--measured", "natural", "--everywhere")
    found = reported(capsys, "plan", "network", *words, *SMALL, "--repeat", 2, "--out", tmp_path / "plan")
    added = [m["values"] for m in found["details"] if m["code"] == "network.added"]
    assert [(m["again"], m["n"]) for m in added][1] == (True, 2)
    assert added[0]["again"] is False
    told = json.loads((tmp_path / "plan/plan.json").read_text())
    everywhere, repeated = told["added"]
    assert everywhere["again_from"] == []
    assert repeated["photographs"] == len(repeated["again_from"]) == 2
    # the map has finer tiles than those by which stations are added: 0.20 to 0.34 mm on five kinds of processor
    assert told["object"]["largest_m"] < 0.3e-3 * 1.25
    assert plan(tmp_path, "facade:6,4", "--photographs", "8", "--everywhere", name="x") == 2
    assert "--everywhere needs" in capsys.readouterr().err
