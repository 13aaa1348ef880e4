"""`raybundle rpc`: what it says and writes."""

import csv
import json
import re

import numpy as np
import pytest

from raybundle.cli.main import main
from raybundle.io.scenes import read_scene
from raybundle.io.scenes.rpc_text import write_rpc_text
from raybundle.scenes.rpc import observe_rpc
from raybundle.words import headline
from tests.cli.reported import reported, values_of


@pytest.fixture
def file(rpc, tmp_path):
    path = tmp_path / "scene_RPC.TXT"
    write_rpc_text(rpc, path)
    return path


def table(path):
    with path.open(newline="") as rows:
        return list(csv.DictReader(rows))


def test_there_and_back(file, rpc, tmp_path, capsys):
    points, image, ground = (tmp_path / f"{n}.csv" for n in ("points", "image", "ground"))
    lon, lat, _ = rpc.ground_offset.tolist()
    points.write_text(f"point,lon_deg,lat_deg,h_m\nA,{lon!r},{lat!r},120\nB,{lon + 0.001!r},{lat!r},1000\n")
    found = reported(capsys, "rpc", "project", file, points, "--out", image)
    assert values_of(found, ["notes"])["rpc.points_beyond"]["points"] == ["B"]
    expected = rpc.project(np.array([[lon, lat, 120.0]]))[0]
    rows = table(image)
    assert [float(rows[0][k]) for k in ("x_px", "y_px")] == pytest.approx(expected, abs=1e-6)
    lines = [f"{r['point']},{r['x_px']},{r['y_px']},{r['h_m']}" for r in rows]
    points.write_text("\n".join(["point,x_px,y_px,h_m", *lines]) + "\n")
    assert main(["rpc", "project", str(file), str(points), "--to-ground", "--out", str(ground)]) == 0
    assert float(table(ground)[0]["lon_deg"]) == pytest.approx(lon, abs=1e-9)


@pytest.mark.parametrize("bias", ["auto", "shift", "affine"])
def test_correct(file, rpc, place, scene, tmp_path, capsys, bias):
    rng = np.random.default_rng(1)
    ground = rpc.localise(rng.uniform(0, [8000, 7000], (8, 2)), rng.uniform(0, 800, 8))
    shift = np.array([12.0, -7.0])
    seen = observe_rpc(rpc, place, place.local_from_geographic(ground), "shift", shift).xy_px + rng.normal(
        0, 0.2, (8, 2)
    )
    pairs = zip(ground.tolist(), seen.tolist(), strict=True)
    rows = [",".join([f"P{k}", *(repr(v) for v in (*g, *p))]) for k, (g, p) in enumerate(pairs)]
    points, out = tmp_path / "control.csv", tmp_path / "new_RPC.TXT"
    points.write_text("\n".join(["point,lon_deg,lat_deg,h_m,x_px,y_px", *rows]) + "\n")
    words = ["rpc", "correct", str(file), str(points), "--image-sigma", "0.2", "--scene-bias", bias, "--verbose"]
    assert main([*words, "--out", str(out)]) == 0
    said = capsys.readouterr().out
    assert re.search(r"(?m)^  advised: .*shift", said)
    corrected = read_scene(out).rpc
    assert np.abs(corrected.project(ground) - seen).max() < 1.0
    assert ("Refitted" in said) == (bias == "affine")
    terms = {"auto": "A0 B0", "shift": "A0 B0", "affine": "A0 A1 A2 B0 B1 B2"}[bias].split()
    assert re.findall(r"([AB]\d) [+-]\d+\.\d+ ± ", said) == terms  # what is built in, and all of it


def test_info_and_fit(sensors, tmp_path, capsys):
    source, out = sensors / "maxar/dg_example1.xml", tmp_path / "new_RPC.TXT"
    found = reported(capsys, "rpc", "info", source)
    assert "35170 x 23708 px" in values_of(found)["scene.file"]["parts"]
    assert found["rigorous_minus_rpc"]["limit_px"] > 0
    largest = values_of(reported(capsys, "rpc", "fit", source, "--out", out))["scene.fitted"]["largest"]
    assert 0 < largest < 0.5
    assert read_scene(out).rpc.image_scale[0] == pytest.approx(35170 / 2)
    assert main(["rpc", "fit", str(source), "--out", str(out)]) == 2
    assert "[file.exists]" in capsys.readouterr().err


def test_errors_in_words(file, tmp_path, capsys, sensors):
    points = tmp_path / "p.csv"
    points.write_text("point,lon_deg,lat_deg,h_m\nA,1,x,3\n")
    out = tmp_path / "o.csv"
    assert main(["rpc", "project", str(file), str(points), "--out", str(out)]) == 2
    printed = capsys.readouterr().err
    assert "line 2" in printed
    assert "lat_deg" in printed
    assert main(["rpc", "fit", str(file), "--out", str(tmp_path / "b.txt")]) == 2
    assert "[scene.model_missing]" in capsys.readouterr().err
    assert main(["rpc", "project", str(file), str(points), "--model", "rigorous", "--out", str(out)]) == 2
    assert "[scene.model_missing]" in capsys.readouterr().err
    isd = sensors / "usgscsm/orbitalLineScan.json"
    assert main(["rpc", "fit", str(isd), "--out", str(tmp_path / "b.txt")]) == 2
    assert "--heights LOW HIGH" in capsys.readouterr().err
    assert main(["rpc", "correct", str(isd), str(points)]) == 2
    assert "[scene.rpc_missing]" in capsys.readouterr().err
    assert main(["rpc", "info", str(tmp_path / "none")]) == 2
    assert json.loads(isd.read_text())["image_lines"] == 16
    assert not out.exists()


def test_info_of_a_scene_that_looks_past_its_body(sensors, capsys):
    assert main(["rpc", "info", str(sensors / "usgscsm/constVelocityLineScan.json")]) == 0
    past = headline("scene.corner", {"x": 0.0, "y": 0.0, "known": False}).rpartition(": ")[2]
    assert capsys.readouterr().out.count(past) == 4


@pytest.mark.parametrize(("name", "kind"), [("juno_isd", "frame"), ("orbitalPushFrame", "push_frame")])
def test_a_frame_is_no_push_frame(sensors, capsys, name, kind):
    assert main(["rpc", "info", str(sensors / f"pushframe/{name}.json")]) == 0
    line = headline("scene.rigorous", {"kind": kind, "seconds": 2.9, "height": 0.0})
    assert line in capsys.readouterr().out
    assert ("2.9 s" in line) == (kind == "push_frame")


def test_points_of_another_place_are_refused(file, tmp_path, capsys):
    (tmp_path / "p.csv").write_text("point,lon_deg,lat_deg,h_m\na,10.0,10.0,0\n")
    assert main(["rpc", "project", str(file), str(tmp_path / "p.csv"), "--out", str(tmp_path / "o.csv")]) == 2
    printed = capsys.readouterr().err
    assert "point a " in printed
    assert "10.000000°" in printed
    assert "[rpc.points_far_away]" in printed
    assert not (tmp_path / "o.csv").exists()
    (tmp_path / "q.csv").write_text("point,x_px,y_px,h_m\na,10,10,1e6\n")
    arguments = ["rpc", "project", str(file), str(tmp_path / "q.csv"), "--to-ground", "--out", str(tmp_path / "o.csv")]
    assert main(arguments) == 3
    printed = capsys.readouterr().err
    assert headline("scene.no_place", {"name": str(file), "point": "a", "n": 1}) in printed
    assert "line 9.50, sample 9.50" in printed
    assert "[rpc.no_ground_point]" in printed


def test_help_names_the_conventions(capsys):
    assert main(["rpc", "--help"]) == 0
    assert "0.5, 0.5" in capsys.readouterr().out


def control(rpc, path, wrong=None, sigma=0.2):
    rng = np.random.default_rng(1)
    ground = rpc.localise(rng.uniform(0, [8000, 7000], (8, 2)), rng.uniform(0, 800, 8))
    seen = rpc.project(ground) + np.array([12, -7]) + rng.normal(0, sigma, (8, 2))
    if wrong is not None:
        seen[wrong, 0] += 60
    pairs = zip(ground.tolist(), seen.tolist(), strict=True)
    rows = [",".join([f"P{k}", *(repr(v) for v in (*g, *p))]) for k, (g, p) in enumerate(pairs)]
    path.write_text("\n".join(["point,lon_deg,lat_deg,h_m,x_px,y_px", *rows]) + "\n")
    return str(path)


def test_correct_names_a_wrong_point_and_leaves_it_out(file, rpc, tmp_path, capsys):
    points, out = control(rpc, tmp_path / "c.csv", wrong=3), tmp_path / "new_RPC.TXT"
    found = reported(capsys, "rpc", "correct", file, points, "--image-sigma", 0.2, "--out", out)
    (wrong,) = [m for m in found["warnings"] if m["code"] == "rpc.points_contradict"]
    assert re.search(r"1 of 8 .*: P3 \(.*6\d px\)", wrong["text"])
    assert read_scene(out).rpc.image_offset - rpc.image_offset == pytest.approx([12, -7], abs=0.4)


def test_correct_writes_nothing_where_nothing_fits(file, rpc, tmp_path, capsys):
    points, out = control(rpc, tmp_path / "c.csv", sigma=30.0), tmp_path / "new_RPC.TXT"
    assert main(["rpc", "correct", str(file), points, "--image-sigma", "0.2", "--out", str(out)]) == 3
    said = capsys.readouterr()
    assert said.out == ""
    assert "[bias.misfit]" in said.err
    assert not out.exists()


def test_every_point_keeps_its_row(file, rpc, tmp_path, capsys):
    lon, lat, _ = rpc.ground_offset.tolist()
    points, out, back = (tmp_path / n for n in ("p.csv", "o.csv", "b.csv"))
    rows = [("in", lon, lat, 120), ("high", lon, lat, 1500), ("away", lon - 60, lat, 100)]
    points.write_text("point,lon_deg,lat_deg,h_m\n" + "".join(f"{i},{a!r},{b!r},{h}\n" for i, a, b, h in rows))
    found = values_of(reported(capsys, "rpc", "project", file, points, "--out", out))
    inside, high, away = table(out)
    expected = rpc.project(np.array([[lon, lat, 120.0]]))[0]
    assert [float(inside[k]) for k in ("x_px", "y_px")] == pytest.approx(expected, abs=1e-6)
    assert inside["note"] == ""
    assert found["rpc.points_beyond"] == {"n": 1, "points": ["high"]}
    assert found["rpc.points_lost"] == {"n": 1, "points": ["away"], "which": "image"}
    assert (away["x_px"], away["y_px"]) == ("", "")
    assert "[rpc.point_far_away]" in away["note"]
    assert high["x_px"] != ""
    points.write_text("point,x_px,y_px,h_m\nA,100,100,200\nB,100,100,90000\n")
    assert main(["rpc", "project", str(file), str(points), "--to-ground", "--out", str(back)]) == 0
    assert "[rpc.points_lost]" in capsys.readouterr().out
    found, none = table(back)
    assert [none[k] for k in ("x_px", "y_px", "lon_deg", "lat_deg", "h_m")] == ["100", "100", "", "", "90000"]
    assert "[rpc.no_ground_point]" in none["note"]
    assert float(found["lon_deg"]) == pytest.approx(rpc.localise(np.array([[100.0, 100.0]]), 200.0)[0, 0])


def test_the_ending_says_what_is_written(rpc, file, tmp_path, capsys):
    control(rpc, tmp_path / "control.csv")
    out = tmp_path / "corr.RPB"
    assert main(["rpc", "correct", str(file), str(tmp_path / "control.csv"), "--out", str(out)]) == 0
    assert out.read_text().startswith("satId")
    assert "BEGIN_GROUP = IMAGE" in out.read_text()
    capsys.readouterr()
    assert main(["rpc", "correct", str(file), str(tmp_path / "control.csv"), "--out", str(tmp_path / "corr.xml")]) == 2
    assert "NAME_RPC.TXT, NAME.RPB" in capsys.readouterr().err
    assert not (tmp_path / "corr.xml").exists()
