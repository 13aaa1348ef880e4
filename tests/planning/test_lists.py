"""Lists of photographs: what they hold, what they promise, and how they are ticked off."""

import csv
import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.cli.reported import reported, values_of

import raybundle as rb
from raybundle.block.select import select_block
from raybundle.cli.main import main
from raybundle.commands.planning.photograph_list import ListSettings, task_of
from raybundle.errors import InputError
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.network.assistants import assistants
from raybundle.planning.network.candidates import Stations
from raybundle.planning.network.of_result import stations_of_result
from raybundle.planning.network.taken_stations import ticked

PORTAL = Path(__file__).parents[2] / "demo_data" / "portal" / "photos"
OBJECTS = {k: a.example for k, a in assistants.items()}


def listed(tmp_path, kind, *words, name="list"):
    if kind == "targets" and "--stations" not in words:
        if not (tmp_path / "plan").exists():
            plan = ["plan", "network", OBJECTS[kind], "--photographs", "10", "--rays", "2", "--object-points", "40"]
            assert main([*plan, "--effort", "quick", "--progress", "none", "--out", str(tmp_path / "plan")]) == 0
        words = (*words, "--stations", str(tmp_path / "plan/stations.csv"))
    return main(["plan", "list", kind, OBJECTS[kind], *words, "--out", str(tmp_path / name)])


def rows(path):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@pytest.mark.long
@pytest.mark.parametrize("kind", sorted(assistants))
def test_every_list_is_written_and_keeps_its_promise(tmp_path, kind, capsys):
    assert listed(tmp_path, kind, "--f-number", "16") == 0
    assert "Listed: " in capsys.readouterr().out
    folder = tmp_path / "list"
    table, block = rows(folder / "list.csv"), rb.read_block(folder / "block")
    assert len(table) == len(block.images) == json.loads((folder / "plan.json").read_text())["photographs"]
    assert all(r["see"] and r["how"] and r["group"] for r in table)
    pdf = (folder / "list.pdf").read_bytes()
    assert pdf.startswith(b"%PDF")
    assert pdf.rstrip().endswith(b"%%EOF")
    result = rb.adjust(block, rb.AdjustmentOptions(datum="inner", datum_points=block.points.ids, jobs=1))
    known = {r["point"]: [float(r[f"s{a}_mm"]) for a in "XYZ"] for r in rows(folder / "points.csv")}
    promised = np.array([known[p] for p in block.points.ids]) / 1000
    stated = result.precision.object_point_std / result.sigma0
    good = np.isfinite(stated).all(axis=1) & (stated > 0).all(axis=1)
    assert good.mean() > 0.9
    # natural points are drawn: some are found less often than to be expected
    assert np.median(stated[good] / promised[good]) == pytest.approx(1, abs=0.15)


def turned(stations, rows_taken, rng, off=0.04):
    """Stations as they are met, in a frame of their own."""
    depth = np.linalg.norm(stations.at - stations.centre, axis=1, keepdims=True)
    centre = stations.centre + rng.normal(0, off, stations.centre.shape) * depth
    at = stations.at + rng.normal(0, off, stations.at.shape) * depth
    met = Stations(centre=centre, at=at, roll=stations.roll).rows(rows_taken)
    Q = rotation_from_vector(np.array([[0.3, 1.2, -2.0]]))[0]
    block = rb.Block(
        cameras=(), images=rb.Images(
            ids=tuple(str(k) for k in range(len(met))), camera=np.zeros(len(met), np.int32), file=("",) * len(met),
            centre=7.3 * met.centre @ Q.T + 5, rotation=met.rotation @ Q.T,
        ),
        observations=rb.Observations(
            image=np.zeros(0, np.int32), point=np.zeros(0, np.int32), xy_px=np.zeros((0, 2)), cov_px2=np.zeros((0, 3))
        ),
        points=rb.Points(ids=(), role=np.zeros(0, np.int32), xyz=np.zeros((0, 3)), sigma=np.zeros((0, 3))),
    )  # fmt: skip
    return stations_of_result(block)


@pytest.mark.long
@pytest.mark.parametrize("kind", ["calibration", "cipa", "turntable"])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_what_was_left_out_is_missed_whatever_the_frame(kind, seed):
    settings = ListSettings(kind=kind, object=OBJECTS[kind], out=Path("x"), f_number=16.0)
    stations = assistants[kind].shots(task_of(settings)).stations
    rng = np.random.default_rng(seed)
    order = rng.permutation(len(stations))
    kept, left = np.sort(order[3:]), np.sort(order[:3])
    other = replace(stations, roll=stations.roll + np.where(np.arange(len(stations)) == kept[2], np.pi / 2, 0.0))
    found = ticked(stations, turned(other, np.append(kept, kept[5]), rng))
    assert found.missing.tolist() == left.tolist()
    assert found.of[:-1].tolist() == kept.tolist()
    assert found.doubled.tolist() == [kept[5]]
    assert 2 in found.rolled


def views(kind, text, **more):
    return (
        assistants[kind]
        .shots(task_of(ListSettings(kind=kind, object=text, out=Path("x"), f_number=16.0, **more)))
        .stations
    )


@pytest.mark.long
@pytest.mark.parametrize("missed", [(), (32,), (44, 45), (9, 19, 29)])
@pytest.mark.parametrize("order", ["reversed", "any"])
def test_a_list_that_looks_the_same_from_no_other_side_needs_no_order(tmp_path, missed, order):
    (tmp_path / "l.csv").write_text("0,0\n12,0\n12,5\n6,5\n6,9\n0,9\n")
    stations = views("cipa", f"building:{tmp_path / 'l.csv'},6", around=15.0)
    rng = np.random.default_rng(4)
    kept = np.setdiff1d(np.arange(len(stations)), missed)
    taken = kept[::-1] if order == "reversed" else rng.permutation(kept)
    found = ticked(stations, turned(stations, taken, rng, off=0.03))
    assert found.missing.tolist() == list(missed)
    assert found.of.tolist() == taken.tolist()
    assert not found.alike


@pytest.mark.long
def test_a_list_that_looks_the_same_after_a_turn_says_so():
    stations = views("cipa", "box:12,8,6", around=15.0)
    kept = np.setdiff1d(np.arange(len(stations)), [0, 5])
    rng = np.random.default_rng(4)
    follows = ticked(stations, turned(stations, kept, rng))
    assert follows.missing.tolist() == [0, 5]
    any_order = ticked(stations, turned(stations, rng.permutation(kept), rng))
    assert len(any_order.missing) == 2
    assert follows.alike
    assert any_order.alike


@pytest.mark.parametrize("other", [("turntable", "cylinder:0.3,0.4"), ("calibration", "sheet:0.42,0.297")])
def test_photographs_of_another_list_are_refused(other):
    house = views("cipa", "box:12,8,6", around=15.0)
    stations = views(*other)
    with pytest.raises(InputError, match=r"plan\.other_list"):
        ticked(house, turned(stations, np.arange(len(stations)), np.random.default_rng(4)))


def test_another_list_is_not_ticked_off():
    settings = ListSettings(kind="cipa", object=OBJECTS["cipa"], out=Path("x"))
    cipa = assistants["cipa"].shots(task_of(settings)).stations
    rng = np.random.default_rng(1)
    centre = rng.normal(0, 5, (20, 3))
    others = Stations(centre=centre, at=centre + rng.normal(0, 5, (20, 3)), roll=rng.uniform(0, 6, 20))
    with pytest.raises(InputError, match=r"plan\.other_list"):
        ticked(cipa, turned(others, np.arange(20), rng))


@pytest.mark.long
def test_a_result_is_ticked_off(tmp_path, capsys):
    assert listed(tmp_path, "cipa") == 0
    assert main(["simulate", str(tmp_path / "list"), "--out", str(tmp_path / "taken")]) == 0
    assert main(["plan", "check", str(tmp_path / "list"), str(tmp_path / "taken"), "--progress", "none"]) == 0
    block = rb.read_block(tmp_path / "taken/block")
    some = np.arange(len(block.images)) != 4
    rb.write_block(select_block(block, "image", some), tmp_path / "some")
    capsys.readouterr()
    words = ["plan", "check", tmp_path / "list", tmp_path / "some", "--out", tmp_path / "checked"]
    found = values_of(reported(capsys, *words, status=4))
    assert found["photograph_list.ticked"]["missing"] == 1
    assert found["photograph_list.not_taken"]["number"] == "05"
    assert found["photograph_list.not_taken"]["text"].startswith("front")
    table = rows(tmp_path / "checked/list.csv")
    assert [r["image"] for r in table if not r["taken"]] == ["05"]
    assert (tmp_path / "checked/list.pdf").read_bytes().startswith(b"%PDF")


@pytest.mark.long
def test_photographs_are_ticked_off_by_what_they_show(tmp_path, capsys):
    for name, count in (("first", 6), ("again", 5)):
        (tmp_path / name).mkdir()
        for photo in sorted(PORTAL.glob("*.jpg"))[:count]:
            shutil.copy(photo, tmp_path / name)
    rb.orient([tmp_path / "first"], tmp_path / "project", precise=False, report=False)
    project = str(tmp_path / "project")
    words = ["plan", "list", "targets", project, "--stations", project, "--count", "12", "--across", "3"]
    assert main([*words, "--out", str(tmp_path / "list")]) == 0
    capsys.readouterr()
    found = values_of(reported(capsys, "plan", "check", tmp_path / "list", tmp_path / "again", status=4))
    assert found["photograph_list.ticked"] == {"n": 6, "oriented": 5, "missing": 1, "beside": 0}
    assert found["photograph_list.not_taken"]["number"] == "06"


@pytest.mark.long
def test_a_ring_goes_round_any_footprint(tmp_path, capsys):
    (tmp_path / "foot.csv").write_text("X,Y\n0,0\n14,0\n14,6\n8,6\n8,11\n0,11\n")
    for name, text in (("l", f"building:{tmp_path / 'foot.csv'},6"), ("round", "cylinder:9,6")):
        assert main(["plan", "list", "cipa", text, "--out", str(tmp_path / name)]) == 0
        promised = [float(r["sX_mm"]) for r in rows(tmp_path / name / "points.csv")]
        assert max(promised) < 3  # it hangs together
    block = rb.read_block(tmp_path / "l/block")
    inside = (block.images.centre[:, :2] > [0, 0]).all(axis=1) & (block.images.centre[:, :2] < [14, 6]).all(axis=1)
    assert not inside.any()
    (tmp_path / "bow.csv").write_text("0,0\n9,9\n9,0\n0,9\n")
    capsys.readouterr()
    assert main(["plan", "list", "cipa", f"building:{tmp_path / 'bow.csv'},6", "--out", str(tmp_path / "x")]) == 2
    assert "[outline.crosses_itself]" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("kind", "words", "said"),
    [
        ("cipa", ("--around", "2"), "[plan.height_not_shown]"),
        ("cipa", ("--focus", "2"), "[plan.not_sharp]"),
        ("calibration", ("--focus", "1", "--f-number", "4"), "[plan.not_sharp]"),
        ("turntable", ("--steps", "5"), "[plan.turn_too_large]"),
        pytest.param(
            "targets", ("--across", "200", "--count", "400"), "[plan.targets_too_large]", marks=pytest.mark.long
        ),
        ("targets", ("--stations", "none.csv"), "none.csv"),
    ],
)  # fmt: skip
def test_what_cannot_be_listed_is_told(tmp_path, capsys, kind, words, said):
    assert listed(tmp_path, kind, *words, name="x") == 2
    told = capsys.readouterr().err
    assert said in told
    assert not (tmp_path / "x").exists()


@pytest.mark.long
def test_folders_that_hold_something_are_left_alone(tmp_path, capsys):
    kept = tmp_path / "photos"
    (kept / "sub").mkdir(parents=True)
    (kept / "IMG_1.JPG").write_bytes(b"a photograph")
    (tmp_path / "link").symlink_to(kept)
    (tmp_path / "empty").mkdir()
    network = [
        "plan",
        "network",
        "facade:6,4",
        "--photographs",
        "8",
        "--rays",
        "2",
        "--object-points",
        "40",
        "--effort",
        "quick",
    ]
    assert main([*network, "--progress", "none", "--out", str(tmp_path / "empty")]) == 0
    block = str(tmp_path / "empty/block")
    follow = ["plan", "next", block, "--photographs", "1", "--candidates", "50"]
    ask = ["plan", "list", "calibration", "sheet:0.42,0.297", "--f-number", "16"]
    capsys.readouterr()
    for words in (network, follow, ask):
        for out in (kept, tmp_path / "link"):
            assert main([*words, "--progress", "none", "--out", str(out)]) == 2
            assert "[folder.exists]" in capsys.readouterr().err
            assert (kept / "IMG_1.JPG").read_bytes() == b"a photograph"
            assert (kept / "sub").is_dir()


def test_damaged_lists_are_told(tmp_path, capsys):
    assert listed(tmp_path, "calibration", "--f-number", "16") == 0
    folder = tmp_path / "list"
    text = (folder / "list.csv").read_text()
    (folder / "list.csv").write_text("\n".join(text.splitlines()[:-2]) + "\n")
    assert main(["plan", "check", str(folder), str(folder)]) == 2
    assert "[plan.list_count]" in capsys.readouterr().err
    (folder / "list.csv").write_text(text.replace("see", "seen", 1))
    assert main(["plan", "check", str(folder), str(folder)]) == 2
    assert "[table.unknown_column]" in capsys.readouterr().err
