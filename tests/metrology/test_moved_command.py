"""`raybundle moved`: two measurements of a field of targets, some of which moved in between."""

import csv
import json
from dataclasses import replace

import numpy as np
import pytest

import raybundle as rb
from raybundle.cli.main import main
from raybundle.planning.scenes import TargetField, field_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.report.write import write_result

MOVED = {"5": (0.0, 0.004, 0.0), "17": (0.003, 0.0, -0.003)}


@pytest.fixture(scope="module")
def epochs(tmp_path_factory):
    """Two results in folders; the field, in metres, with one scale bar each time."""
    folder = tmp_path_factory.mktemp("epochs")
    scene = field_scene(TargetField())
    for k, name in enumerate(("spring", "autumn")):
        xyz = scene.xyz.copy()
        if k:
            for point, by in MOVED.items():
                xyz[int(point) - 1] += by
        survey = Survey(seed=3 + k, image_sigma_px=0.3, scale_bars=1, scale_bar_sigma=1e-5)
        block = simulate(replace(scene, xyz=xyz), survey).observed
        write_result(rb.adjust(block, rb.AdjustmentOptions(threads=1)), folder / name, report="none")
    return folder / "spring", folder / "autumn"


def rows(path):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_what_moved_is_told_and_written(epochs, tmp_path, capsys):
    assert main(["moved", *map(str, epochs), "--out", str(tmp_path / "m"), "--progress", "none"]) == 0
    said = capsys.readouterr().out
    assert "common points of spring and autumn: 2 moved" in said
    assert "\n 17 moved by " in said
    assert "\n 5 moved by " in said
    table = {r["point"]: r for r in rows(tmp_path / "m/points.csv")}
    assert {p for p, r in table.items() if r["moved"]} == set(MOVED)
    for point, by in MOVED.items():
        found = np.array([float(table[point][f"d{a}_mm"]) for a in "XYZ"])
        sigma = np.array([float(table[point][f"sd{a}_mm"]) for a in "XYZ"])
        assert np.linalg.norm(found) == pytest.approx(1000 * np.linalg.norm(by), abs=4 * sigma.max())
    told = json.loads((tmp_path / "m/moved.json").read_text())
    assert told["moved"] == sorted(MOVED, key=list(table).index)
    assert told["all_points"]["p"] < 0.01 < told["points_that_stayed"]["p"]
    assert not told["scale_free"]


def test_in_python_alike(epochs, tmp_path):
    done = rb.moved_points(epochs, tmp_path / "m", significance=0.01)
    assert {i for i, m in zip(done.ids, done.moved, strict=True) if m} == set(MOVED)
    again = rb.moved_points([rb.adjust(rb.read_block(e / "block")) for e in epochs], tmp_path / "n")
    np.testing.assert_allclose(again.displacement, done.displacement, atol=1e-7)


def test_points_of_the_datum_may_be_told(epochs, tmp_path, capsys):
    words = ["--datum", "1", "2", "3", "4", "6", "7", "8", "--out", str(tmp_path / "m")]
    assert main(["moved", *map(str, epochs), *words]) == 0
    assert {r["point"] for r in rows(tmp_path / "m/points.csv") if r["moved"]} >= set(MOVED)
    assert main(["moved", *map(str, epochs), "--datum", "1", "99x", "--out", str(tmp_path / "n")]) == 2
    assert "not common to all epochs: 99x" in capsys.readouterr().err


def test_what_cannot_be_tested_is_told(epochs, tmp_path, capsys):
    assert main(["moved", str(epochs[0]), "--out", str(tmp_path / "m")]) == 2
    assert "two or more measurements" in capsys.readouterr().err
    assert main(["moved", *map(str, epochs), "--points", "1", "2", "3", "--out", str(tmp_path / "m")]) == 2
    assert "have 3 points in common" in capsys.readouterr().err
    assert not (tmp_path / "m").exists()
