"""Many scenes on one file of control: one table of biases, and a bad scene costs that scene."""

import csv

import numpy as np
import pytest

import raybundle as rb
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.scenes import read_scene
from raybundle.io.scenes.rpc_text import write_rpb, write_rpc_text
from raybundle.words import headline
from tests.messages import refused
from tests.scenes.test_rpc_writing import of_gdal, same_in_gdal, write_picture

SHIFTS = {"a": (3.0, -2.0), "b": (-5.0, 1.0), "c": (0.5, 8.0)}


@pytest.fixture
def folder(rpc, tmp_path):
    """A picture with its tag, one with an RPC beside it, an RPC alone; a damaged scene, another raster, and notes."""
    scenes = tmp_path / "scenes"
    scenes.mkdir()
    write_picture(scenes / "a.tif", rpc)
    write_picture(scenes / "b.tif", None)
    write_rpb(rpc, scenes / "b.RPB")
    write_rpc_text(rpc, scenes / "c_RPC.TXT")
    write_picture(scenes / "dem.tif", None)
    (scenes / "notes.txt").write_text("nothing of interest")
    (scenes / "d_RPC.TXT").write_text("LINE_OFF: 12\nLINE_NUM_COEFF_1: east\n")
    return scenes


@pytest.fixture
def control(rpc, tmp_path):
    rng = np.random.default_rng(1)
    ground = rpc.ground_offset + rpc.ground_scale * rng.uniform(-0.7, 0.7, (9, 3))
    rows = ["point,lon_deg,lat_deg,h_m,x_px,y_px,image,role"]
    for name, shift in {**SHIFTS, "d": (0, 0)}.items():
        for k, (g, xy) in enumerate(zip(ground, rpc.project(ground) + shift + rng.normal(0, 0.2, (9, 2)), strict=True)):
            numbers = ",".join(repr(float(v)) for v in (*g, *xy))
            rows.append(f"P{k},{numbers},{name}.tif,{'check' if k > 6 else ''}")
    (tmp_path / "control.csv").write_text("\n".join(rows) + "\n")
    return tmp_path / "control.csv"


def table(path):
    with path.open(newline="") as file:
        return {row["scene"]: row for row in csv.DictReader(file)}


def test_a_folder(folder, control, rpc, tmp_path, capsys):
    out = tmp_path / "out"
    words = ["rpc", "batch", str(folder), "--control", str(control), "--image-sigma", "0.2", "--out", str(out)]
    assert main(words) == 0
    printed = capsys.readouterr().out
    assert headline("scene.corrected", {"n": 3, "of": 4}) in printed
    assert headline("rpc.scene_left_out", {"scene": "d_RPC.TXT"}) in printed
    assert sorted(p.name for p in out.iterdir()) == ["a_RPC.TXT", "b_RPC.TXT", "biases.csv", "c_RPC.TXT"]
    rows = table(out / "biases.csv")
    assert list(rows) == ["a.tif", "b.tif", "c_RPC.TXT", "d_RPC.TXT"]
    for name, row in rows.items():
        if name == "d_RPC.TXT":
            assert row["bias"] == row["file"] == row["A0_px"] == ""
            assert "0 of 20" in row["problem"]
            continue
        shift = SHIFTS[name[0]]
        assert (row["bias"], row["points"], row["check_points"], row["problem"]) == ("shift", "7", "2", "")
        assert float(row["A0_px"]) == pytest.approx(shift[0], abs=4 * float(row["sA0_px"]))
        assert float(row["B0_px"]) == pytest.approx(shift[1], abs=4 * float(row["sB0_px"]))
        assert row["A1_px"] == ""
        written = read_scene(out / row["file"]).rpc
        assert written.err_bias_m == pytest.approx(float(row["err_bias_m"]))
        told = 1e-3 * float(row["sA0_px"])  # of the table's digits
        shifts = [float(row["A0_px"]), float(row["B0_px"])]
        assert written.image_offset - rpc.image_offset == pytest.approx(shifts, abs=2 * told)
    assert main(words) == 2
    assert "[folder.exists]" in capsys.readouterr().err


def test_pictures_and_the_same_from_python(folder, control, tmp_path):
    done = rb.rpc_batch([folder / "a.tif", folder / "b.tif"], control, tmp_path / "out", image_sigma=0.2, to="tif")
    assert [s.file.name for s in done.corrected] == ["a.tif", "b.tif"]
    assert not done.failed
    for scene in done.corrected:
        same_in_gdal(scene.correction.corrected, of_gdal(scene.file))
    one = rb.rpc_correct(folder / "a.tif", control, image_sigma=0.2)
    assert np.array_equal(one.fit.values, done.corrected[0].correction.fit.values)


def test_what_costs_a_scene_and_what_costs_all(folder, control, tmp_path):
    done = rb.rpc_batch([folder / "c_RPC.TXT", folder / "dem.tif"], control, tmp_path / "out", to="rpb")
    assert done.failed[0].problem.code == "scene.rpc_not_in_picture"
    with refused("scene.none_corrected", n=1) as caught:
        rb.rpc_batch(folder / "d_RPC.TXT", control, tmp_path / "none")
    assert "d_RPC.TXT:" in str(caught.value)
    assert not (tmp_path / "none").exists()
    done = rb.rpc_batch([folder / "a.tif", folder / "c_RPC.TXT"], control, tmp_path / "tif", to="tif")
    assert "GeoTIFF" in done.failed[0].problem_line
    twice = rb.rpc_batch([folder / "a.tif", folder / "a.tif"], control, tmp_path / "twice")
    assert twice.failed[0].problem.code == "scene.name_twice"
    text = control.read_text().replace("a.tif", "")
    nameless = tmp_path / "nameless.csv"
    nameless.write_text(text)
    with pytest.raises(InputError, match=r"scene_control\.image_missing"):
        rb.rpc_batch(folder, nameless, tmp_path / "x")
    (tmp_path / "empty").mkdir()
    with pytest.raises(InputError, match=r"scene\.none_here"):
        rb.rpc_batch(tmp_path / "empty", control, tmp_path / "x")
