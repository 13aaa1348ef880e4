"""Lines and areas drawn on a surface, written for CAD and GIS."""

import json
from dataclasses import replace

import numpy as np
import pytest
from tests.cli.test_heights import refused, reported
from tests.surface.height_models import folder_of, made, middles

from raybundle.errors import InputError
from raybundle.measuring.journal import Journal, journal_path
from raybundle.measuring.names import Known

SHAPE = 60, 90


@pytest.fixture(scope="module")
def surface(tmp_path_factory):
    """A slope of one in ten with a hole, and what is drawn on it."""
    x, _ = middles(SHAPE)
    model = made(0.1 * x, rng=np.random.default_rng(1), common=1e-9, sigma=1e-4)
    height = model.heights.height.copy()
    height[20:50, 4:24] = np.nan
    project = tmp_path_factory.mktemp("slope")
    folder = folder_of(replace(model, heights=replace(model.heights, height=height)), project / "surface")
    with Journal.open(journal_path(project), Known(size_px={}, names={})) as journal:
        for name, kind, corners, more in (
            ("edge", "line", [[0.4, 0.2], [0.8, 0.5]], {"layer": "breaklines", "note": "of the quarry"}),
            ("pile", "area", [[0.3, 0.1], [0.7, 0.1], [0.7, 0.3]], {}),
            ("across", "line", [[0.03, 0.05], [0.14, 0.25], [0.4, 0.25]], {}),
            ("hole", "line", [[0.12, 0.2], [0.15, 0.3]], {}),
            ("wall", "line", [[0.3, 0.2], [0.4, 0.2]], {"surface": "facade-1/surface"}),
        ):
            journal.append_verb("draw", {"drawing": name, "kind": kind, "corners": corners, **more})
    return folder


def test_drawings_have_heights_lengths_and_attributes(surface, capsys, tmp_path):
    pytest.importorskip("pyogrio")
    ezdxf = pytest.importorskip("ezdxf")
    import pyogrio.raw

    files = [tmp_path / f"plan.{e}" for e in ("geojson", "dxf", "gpkg")]
    found = reported(capsys, "heights", "drawing", surface, "--fill", 0, *(w for f in files for w in ("--out", f)))
    assert found["drawings"] == ["edge", "pile", "across"]
    assert found["layers"] == ["breaklines", "lines"]
    codes = {m["code"]: m["values"] for m in [*found["warnings"], *found["summary"]]}
    assert codes["surface_drawing.heights_between"]["names"] == ["across"]
    assert codes["surface_drawing.left_out"]["names"] == ["hole"]
    assert codes["surface_drawing.others"]["n"] == 1
    features = {f["properties"]["name"]: f for f in json.loads(files[0].read_text())["features"]}
    edge = np.array(features["edge"]["geometry"]["coordinates"])
    assert edge == pytest.approx(np.array([[0.4, 0.2, 0.04], [0.8, 0.5, 0.08]]), abs=6e-4)
    about = features["edge"]["properties"]
    assert (about["layer"], about["note"]) == ("breaklines", "of the quarry")
    assert about["length_in_plan"] == pytest.approx(0.5)
    assert about["length"] == pytest.approx(np.hypot(0.5, edge[1, 2] - edge[0, 2]))
    assert 5e-5 < about["largest_sigma_of_heights"] < 2e-4
    assert features["pile"]["properties"]["area_in_plan"] == pytest.approx(0.04)
    assert features["pile"]["geometry"]["type"] == "Polygon"
    # a corner in the hole: between its neighbours, by the distance along the line
    z = np.array(features["across"]["geometry"]["coordinates"])[:, 2]
    run = np.hypot(0.11, 0.2)
    assert z[1] == pytest.approx(z[0] + (z[2] - z[0]) * run / (run + 0.26))
    drawing = ezdxf.readfile(files[1])
    layers = {e.dxf.layer for e in drawing.modelspace() if e.dxftype() == "POLYLINE"}
    assert layers == {"breaklines", "lines"}
    assert {e.dxf.text for e in drawing.modelspace().query("TEXT")} == {"edge", "pile", "across"}
    assert {name for name, _ in pyogrio.list_layers(files[2])} == {"drawing_lines", "drawing_areas"}
    meta, _, shapes, fields = pyogrio.raw.read(files[2], layer="drawing_lines")
    assert len(shapes) == 2
    assert fields[list(meta["fields"]).index("note")].tolist() == ["of the quarry", ""]


def test_names_of_layers_are_those_that_dxf_allows_and_areas_are_sound(tmp_path, capsys):
    ezdxf = pytest.importorskip("ezdxf")
    slope = made(0.1 * middles(SHAPE)[0], rng=np.random.default_rng(1), common=1e-9, sigma=1e-6)
    height = slope.heights.height.copy()
    height[28:32, 28:32] = np.nan
    surface = folder_of(replace(slope, heights=replace(slope.heights, height=height)), tmp_path / "surface")
    area = [[0.3, 0.3], [0.5, 0.3], [0.5, 0.5]]  # its first corner has no height
    with Journal.open(journal_path(tmp_path), Known(size_px={}, names={})) as journal:
        for layer in ("a/b*c", "0", "Lines", "lines", "x" * 200):
            journal.append_verb("draw", {"drawing": layer, "kind": "area", "corners": area, "layer": layer})
        for wrong, more in (
            ([[0, 0], [1, 1], [1, 0], [0, 1]], {}), ([[0, 0], [1, 0], [2, 0]], {}), (area, {"surface": "../etc"}),
        ):  # fmt: skip
            with pytest.raises(InputError):
                journal.append_verb("draw", {"drawing": "wrong", "kind": "area", "corners": wrong, **more})
    files = [tmp_path / "a.dxf", tmp_path / "a.geojson"]
    reported(capsys, "heights", "drawing", surface, "--fill", 0, *(w for f in files for w in ("--out", f)))
    drawing = ezdxf.readfile(files[0])
    assert not drawing.audit().errors
    assert "a_b_c" in drawing.layers
    ring = np.array(json.loads(files[1].read_text())["features"][0]["geometry"]["coordinates"][0])
    assert ring[0] == pytest.approx(ring[-1])


def test_what_cannot_be_written_is_refused(surface, capsys, tmp_path):
    assert "[option.missing]" in refused(capsys, "heights", "drawing", surface)
    assert "[file.suffix]" in refused(capsys, "heights", "drawing", surface, "--out", tmp_path / "a.png")
    none = ("heights", "drawing", surface, "--layer", "walls", "--out", tmp_path / "a.dxf")
    assert "[surface_drawing.no_layer]" in refused(capsys, *none)
    assert not (tmp_path / "a.dxf").exists()
    apart = folder_of(made(np.zeros(SHAPE), rng=np.random.default_rng(1), common=1e-9, sigma=1e-4), tmp_path / "apart")
    assert "[surface_drawing.none]" in refused(capsys, "heights", "drawing", apart, "--out", tmp_path / "a.dxf")
    assert "[surface_drawing.line_or_area]" in refused(capsys, "mark", "draw", tmp_path, "x")
