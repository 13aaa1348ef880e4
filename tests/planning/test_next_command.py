"""`raybundle plan next`: from a result to a folder that other commands take."""

import csv
import json
from dataclasses import replace

import numpy as np
import pytest
import trimesh
from tests.cli.reported import reported, values_of

import raybundle as rb
from raybundle.cli.main import main
from raybundle.cli.plan.next import summary
from raybundle.commands.planning.next import NextSettings, write_next_plan
from raybundle.errors import phrase
from raybundle.io.block.folder import read_block, write_block
from raybundle.planning.next.goals import Standing
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Ring, TargetField, field_scene, ring_scene
from raybundle.settings import made

SURVEY = Survey(image_sigma_px=0.2, points="exact", orientation="exact", interior="exact")
EVERYWHERE = ("-99", "-99", "-99", "99", "99", "99")


@pytest.fixture(scope="module")
def ring(tmp_path_factory):
    """A result folder of photographs round a cylinder that stands upright."""
    scene = ring_scene(Ring(stations=8, rings=1, points=80))
    block = simulate(scene, replace(SURVEY, control=5, control_sigma=(0.0005,) * 3)).observed
    out = tmp_path_factory.mktemp("ring") / "result"
    rb.write_result(rb.adjust(block), out)
    return out


@pytest.fixture(scope="module")
def field(tmp_path_factory):
    """A block folder of targets without anything that fixes the datum."""
    scene = field_scene(TargetField(rows=6, columns=8, stations=6, frontal=1, roll_deg=(0.0,), tilt_deg=15.0))
    out = tmp_path_factory.mktemp("field") / "block"
    write_block(simulate(scene, SURVEY).observed, out)
    return out


def plan(source, out, *words):
    asked = words if "--photographs" in words else (*words, "--photographs", "2")
    return main(["plan", "next", str(source), *asked, "--out", str(out), "--progress", "none"])


def rows(path):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_a_result_and_what_is_written(ring, tmp_path, capsys):
    out = tmp_path / "next"
    words = ("--heights", 0, 3, "--candidates", 200, "--photographs", 2)
    found = reported(capsys, "plan", "next", ring, *words, "--out", out)
    assert values_of(found)["network.lowered"]["n"] == 2
    assert values_of(found)["network.judged"]["judged"] > 0
    assert [m["values"]["name"] for m in found["summary"][1:]] == ["next-1", "next-2"]
    table, told = rows(out / "next.csv"), json.loads((out / "next.json").read_text())
    assert [r["image"] for r in table] == ["next-1", "next-2"]
    assert told["vertical_known"] is True
    assert [p["words"] for p in told["proposals"]] == [r["words"] for r in table]
    assert float(table[1]["sigma_after"]) < float(table[0]["sigma_after"]) < float(table[0]["sigma_before"])
    assert float(table[1]["sigma_before"]) == pytest.approx(float(table[0]["sigma_after"]), rel=1e-9)
    block = read_block(out / "block")
    assert block.images.ids[-2:] == ("next-1", "next-2")
    assert block.images.centre[-2:] == pytest.approx(np.array([[float(r[a]) for a in "XYZ"] for r in table]), abs=1e-5)
    assert phrase("next_photograph.about", n=2) in block.about
    low = block.points.xyz[:, 2].min()
    assert all(-1e-3 <= float(r["Z"]) - low <= 3 for r in table)
    page = (out / "network.html").read_text()
    assert phrase("network_page.proposals") in page
    assert table[0]["words"] in page
    again = rb.adjust(block)
    stated = again.precision.object_point_std.max() / again.sigma0 * told["sigma0"]
    assert stated == pytest.approx(float(table[1]["sigma_after"]), rel=1e-3)  # what is written is rounded


def test_a_block_without_a_datum_and_its_calibration(field, tmp_path, capsys):
    words = ("--aim", "calibration", "--candidates", 150, "--photographs", 2)
    found = reported(capsys, "plan", "next", field, *words, "--out", tmp_path / "a")
    lowered = values_of(found)["network.lowered"]
    assert lowered["before"].endswith(" px")
    assert lowered["after"].endswith(" px")
    told = json.loads((tmp_path / "a/next.json").read_text())
    assert told["unit"] == "px"
    assert told["vertical_known"] is False
    assert set(told["proposals"][0]["parameters"]) == {"c", "x0", "y0", "K1", "K2", "K3", "P1", "P2"}


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--heights", "2", "1"), "[site.empty]"),
        (("--forbid", *EVERYWHERE), "[plan.no_station_within]"),
        (("--clearance", "50"), "[plan.no_station_within]"),
        (("--focus", "4"), "[option.needs]"),
        (("--focus", "0.02", "--f-number", "8"), "[lens.focus_too_near]"),
        (("--camera", "Leica"), "[plan.unknown_camera]"),
        (("--points", "nobody"), "[plan.points_not_adjusted]"),
        (("--points", "1", "--aim", "mean"), "--aim worst. [plan.points_and_aim]"),
        (("--hidden-by", "boks:1,2,3"), "[object.unknown]"),
        (("--hidden-by", "box:99,99,99"), "[plan.object_elsewhere]"),
        (("--photographs", "90", "--candidates", "30"), "[plan.too_few_candidates]"),
    ],
)
def test_bad_input_is_told_what_to_do(ring, tmp_path, capsys, words, said):
    assert plan(ring, tmp_path / "x", *words) == 2
    told = capsys.readouterr().err
    assert said in told
    assert "Traceback" not in told
    assert not (tmp_path / "x").exists()


def test_what_hides_what_and_what_is_sharp(ring, tmp_path, capsys):
    """A thick mast beside the cylinder, in millimetres: nobody sees through it, and only what is sharp counts."""
    block = read_block(ring / "block")
    radius, high = np.linalg.norm(block.points.xyz[:, :2], axis=1).max(), 2 * np.abs(block.points.xyz[:, 2]).max()
    body = trimesh.creation.cylinder(radius=1000 * radius, height=1000 * high, sections=90)
    mast = trimesh.creation.box(bounds=1000 * np.array([[1.5, -1.0, -3.0], [2.0, 1.0, 3.0]]))
    trimesh.util.concatenate([body, mast]).export(tmp_path / "site.ply")
    words = ("--hidden-by", str(tmp_path / "site.ply"), "--unit", "0.001", "--clearance", "0.4", "--candidates", "200")
    assert plan(ring, tmp_path / "free", "--candidates", "200") == 0
    assert plan(ring, tmp_path / "next", *words, "--f-number", "8", "--focus", "3") == 0
    free, told = (json.loads((tmp_path / f"{name}/next.json").read_text()) for name in ("free", "next"))
    assert told["judged"] < told["reached"] <= free["reached"]
    for p in told["proposals"]:
        shown = block.points.xyz[[block.points.ids.index(name) for name in p["shows"]]]
        x = np.array(p["centre"])
        t = (1.75 - x[0]) / (shown[:, 0] - x[0])
        through = x + t[:, None] * (shown - x)
        assert not ((t > 0) & (t < 1) & (np.abs(through[:, 1]) < 0.9)).any()
    capsys.readouterr()


def test_blocks_that_cannot_be_asked(field, tmp_path, capsys):
    block = read_block(field)
    unoriented = replace(block.images, centre=block.images.centre * np.nan)
    write_block(replace(block, images=unoriented), tmp_path / "unoriented")
    own = replace(block.cameras[0], interior="per_image", estimate=())
    write_block(replace(block, cameras=(own,)), tmp_path / "own")
    for source, word in (
        (tmp_path, "[session.no_project]"),
        (tmp_path / "unoriented", "[block.not_adjusted]"),
        (tmp_path / "own", "[plan.no_frame_camera]"),
    ):
        assert plan(source, tmp_path / "x") == 2
        assert word in capsys.readouterr().err
    assert plan(field, tmp_path / "x", "--focus", "2", "--f-number", "8") == 2
    assert "[plan.focus_without_scale]" in capsys.readouterr().err


def test_what_is_not_determinable_yet_has_no_figure(field, tmp_path):
    done = rb.plan_next(field, photographs=2, candidates=60, aim="calibration")
    first, second = done.proposals
    open_ = Standing(value=np.inf, carried=1.0)
    done = replace(done, proposals=(replace(first, before=open_, after=open_), replace(second, before=open_)))
    settings = made(NextSettings, {"result": field, "out": tmp_path / "n", "photographs": 2})
    write_next_plan(done, settings)
    table = rows(tmp_path / "n/next.csv")
    assert [(r["sigma_before"], r["sigma_after"] == "") for r in table] == [("", True), ("", False)]
    told = json.loads((tmp_path / "n/next.json").read_text())
    assert [p["after"] is None for p in told["proposals"]] == [True, False]
    assert summary(done, settings).done[0].values["before"] == "not determinable"


def test_in_python_alike(ring, tmp_path):
    done = rb.plan_next(ring, tmp_path / "p", photographs=1, candidates=90, aim="mean")
    assert (tmp_path / "p/network.html").exists()
    result = rb.adjust(read_block(ring / "block"))
    alone = rb.plan_next(result, photographs=1, candidates=90, aim="mean")
    assert alone.proposals[0].after.value == pytest.approx(done.proposals[0].after.value, rel=1e-6)
    assert alone.judged == done.judged
