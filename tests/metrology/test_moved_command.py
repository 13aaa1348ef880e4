"""`raybundle moved`: two measurements of a field of targets, some of which moved in between."""

import csv
import json
import shutil
from dataclasses import replace

import numpy as np
import pytest
from tests.fields import SMALL
from tests.messages import printed

import raybundle as rb
from raybundle import words as entries
from raybundle.cli.main import main
from raybundle.errors import phrase
from raybundle.numerics.natural import natural
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import field_scene
from raybundle.report.write import write_result
from raybundle.words import headline
from raybundle.words.numbers import probability

MOVED = {"5": (0.0, 0.004, 0.0), "17": (0.003, 0.0, -0.003)}


@pytest.fixture(scope="module")
def epochs(tmp_path_factory):
    """Two results in folders; the field, in metres, with one scale bar each time."""
    folder = tmp_path_factory.mktemp("epochs")
    scene = field_scene(SMALL)
    for k, name in enumerate(("spring", "autumn")):
        xyz = scene.xyz.copy()
        if k:
            for point, by in MOVED.items():
                xyz[int(point) - 1] += by
        survey = Survey(seed=3 + k, image_sigma_px=0.3, scale_bars=1, scale_bar_sigma=1e-5)
        block = simulate(replace(scene, xyz=xyz), survey).observed
        write_result(rb.adjust(block, rb.AdjustmentOptions(jobs=1)), folder / name, report="none")
    return folder / "spring", folder / "autumn"


def rows(path):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_what_moved_is_told_and_written(epochs, tmp_path, capsys):
    assert main(["moved", *map(str, epochs), "--out", str(tmp_path / "m"), "--progress", "none"]) == 0
    assert phrase("displacement.points", n=48, moved=2, names=["17", "5"], error_rate=0.05) in capsys.readouterr().out
    table = {r["point"]: r for r in rows(tmp_path / "m/points.csv")}
    assert {p for p, r in table.items() if r["moved"]} == set(MOVED)
    for point, by in MOVED.items():
        found = np.array([float(table[point][f"d{a}_mm"]) for a in "XYZ"])
        sigma = np.array([float(table[point][f"sd{a}_mm"]) for a in "XYZ"])
        assert np.linalg.norm(found) == pytest.approx(1000 * np.linalg.norm(by), abs=4 * sigma.max())
    stated = json.loads((tmp_path / "m/moved.json").read_text())
    assert sorted(stated["moved"]) == sorted(MOVED)
    assert stated["all_points"]["p"] < 0.01 < stated["points_that_stayed"]["p"]
    assert not stated["scale_free"]
    page = (tmp_path / "m/report.html").read_text(encoding="utf-8")
    values = {"n": 2, "of": 48, "significance": 0.05}
    heads = [entries.headline("report_moved.moved", {**values, "names": n}) for n in (["5", "17"], ["17", "5"])]
    assert any(h in page for h in heads)


def test_blocks_that_are_not_adjusted_yet_are_taken(epochs, tmp_path):
    raw = []
    for epoch in epochs:
        block = rb.read_block(epoch / "block")
        raw.append(tmp_path / epoch.name)
        nowhere = np.full_like(block.points.xyz, np.nan)
        rb.write_block(replace(block, points=replace(block.points, xyz=nowhere)), raw[-1])
    done = rb.moved_points(raw, tmp_path / "m", report=False)
    assert {i for i, m in zip(done.ids, done.moved, strict=True) if m} == {*MOVED}


def test_a_report_for_print(epochs, tmp_path):
    rb.moved_points(epochs, tmp_path / "m", report=False, pdf=True)
    assert (tmp_path / "m/report.pdf").read_bytes()[:5] == b"%PDF-"
    assert not (tmp_path / "m/report.html").exists()


def test_in_python_alike(epochs, tmp_path):
    done = rb.moved_points(epochs, tmp_path / "m", significance=0.01)
    assert {i for i, m in zip(done.ids, done.moved, strict=True) if m} == set(MOVED)
    again = rb.moved_points([rb.adjust(rb.read_block(e / "block")) for e in epochs], tmp_path / "n")
    np.testing.assert_allclose(again.displacement, done.displacement, atol=1e-7)


def test_points_of_the_datum_may_be_told(epochs, tmp_path, capsys):
    words = ["--datum-points", "1", "2", "3", "4", "6", "7", "8", "--out", str(tmp_path / "m")]
    assert main(["moved", *map(str, epochs), *words]) == 0
    assert {r["point"] for r in rows(tmp_path / "m/points.csv") if r["moved"]} >= set(MOVED)
    assert main(["moved", *map(str, epochs), "--datum-points", "1", "99x", "--out", str(tmp_path / "n")]) == 2
    assert printed("epochs.datum_points_missing", names=["99x"]) in capsys.readouterr().err


def test_what_cannot_be_tested_is_told(epochs, tmp_path, capsys):
    assert main(["moved", str(epochs[0]), "--out", str(tmp_path / "m")]) == 2
    assert "[epochs.only_one]" in capsys.readouterr().err
    assert main(["moved", *map(str, epochs), "--points", "1", "2", "3", "--out", str(tmp_path / "m")]) == 2
    assert "[epochs.too_few_common]" in capsys.readouterr().err
    assert not (tmp_path / "m").exists()


def nominal(tmp_path, turn, shift, names, off=()):
    """A file of nominal coordinates in mm: the field turned and shifted; some points made otherwise."""
    scene = field_scene(SMALL)
    lines = ["point,X,Y,Z,tolerance"]
    for k, xyz in enumerate(scene.xyz):
        if str(k + 1) in names:
            at = turn @ xyz + shift + (1.0 if str(k + 1) in off else 0.0)
            lines.append(f"{k + 1},{','.join(repr(1000 * float(v)) for v in at)},0.1")
    path = tmp_path / "nominal.csv"
    path.write_text("\n".join(lines) + "\n")
    return path


def test_displacements_in_the_axes_of_a_drawing(epochs, tmp_path, capsys):
    turn = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    names = [str(k) for k in range(1, 60)]
    file = nominal(tmp_path, turn, np.array([1.0, 2.0, 3.0]), names, off=set(MOVED))
    words = ["moved", *map(str, epochs), "--axes", str(file), "--unit", "0.001", "--progress", "none"]
    assert main([*words, "--json", "--out", str(tmp_path / "m")]) == 0
    (axes,) = [m for m in json.loads(capsys.readouterr().out)["details"] if m["code"] == "displacement.axes"]
    assert axes["values"] == {"file_name": "nominal.csv", "points": []}
    table = {r["point"]: r for r in rows(tmp_path / "m/points.csv")}
    assert list(table) == sorted(table, key=natural)
    scene = field_scene(SMALL)
    for point, by in MOVED.items():
        found = np.array([float(table[point][f"d{a}_mm"]) for a in "XYZ"])
        sigma = np.array([float(table[point][f"sd{a}_mm"]) for a in "XYZ"])
        np.testing.assert_allclose(found, 1000 * turn @ by, atol=4 * sigma.max())
        at = np.array([float(table[point][f"{a}_m"]) for a in "XYZ"])
        np.testing.assert_allclose(at, turn @ scene.xyz[int(point) - 1] + [1, 2, 3], atol=2e-3)
    plain = rb.moved_points(epochs, tmp_path / "n", report=False)
    turned = rb.moved_points(epochs, tmp_path / "o", report=False, axes=file, unit=0.001, by=("1", "2", "20", "40"))
    np.testing.assert_allclose(
        np.linalg.norm(turned.displacement, axis=2), np.linalg.norm(plain.displacement, axis=2), rtol=1e-9
    )
    np.testing.assert_array_equal(turned.p_value, plain.p_value)
    told = json.loads((tmp_path / "m/moved.json").read_text())
    assert told["axes"]["of"] == "nominal.csv"
    assert not set(MOVED) & set(told["axes"]["fitted_by"])
    here = turned.transforms[0].points(np.zeros((1, 3)))  # of the second epoch into the axes of the drawing
    assert np.isfinite(here).all()
    assert main(["moved", *map(str, epochs), "--by", "1", "2", "3", "--out", str(tmp_path / "p")]) == 2
    assert printed("option.needs", setting="by", other="axes") in capsys.readouterr().err


def test_a_report_says_whose_it_is_and_which_way_is_seen(epochs, tmp_path):
    record = {"title": "Part 7 under load", "client": "Works", "operator": "R. B."}
    words = [word for name, text in record.items() for word in (f"--{name}", text)]
    assert main(["moved", *map(str, epochs), *words, "--out", str(tmp_path / "m"), "--progress", "none"]) == 0
    page = (tmp_path / "m/report.html").read_text(encoding="utf-8")
    assert f"<h1>{record['title']}</h1>" in page
    assert record["client"] in page
    assert record["operator"] in page
    for across in (False, True):
        assert headline("drawn.vectors_in", {"kind": "displacements", "across": across}) in page
    assert json.loads((tmp_path / "m/moved.json").read_text())["record"] == record


def test_measurements_that_are_not_to_be_used_yet_are_told(epochs, tmp_path, capsys):
    spoilt = tmp_path / "spoilt"
    shutil.copytree(epochs[1], spoilt)
    stated = json.loads((spoilt / "result.json").read_text())
    stated["warnings"].append({"code": "bars_contradict", "severity": "fault", "message": "bars contradict", "ids": []})
    (spoilt / "result.json").write_text(json.dumps(stated))
    words = ["moved", str(epochs[0]), str(spoilt), "--out", str(tmp_path / "m"), "--progress", "none"]
    assert main(words) == 0
    line = f"fault: {phrase('epochs.faulty', name='spoilt', n=1).message.headline()} [epochs.faulty]"
    assert line in capsys.readouterr().out.splitlines()
    page = (tmp_path / "m/report.html").read_text(encoding="utf-8")
    assert entries.headline("report_moved.faulty", {"names": ["spoilt"]}) in page
    assert '"verdict attention"' in page
    assert f"spoilt: {stated['warnings'][-1]['message']}" in page
    assert json.loads((tmp_path / "m/moved.json").read_text())["not_to_be_used_yet"] == {"spoilt": ["bars contradict"]}


def test_a_probability_of_nothing_is_a_bound():
    assert probability(0.0) == "p < 1e-16"
    assert probability(0.031) == "p 0.031"


def in_axes_of(epochs, file, out, capsys, *more):
    words = ["moved", *map(str, epochs), "--axes", str(file), *more, "--no-report", "--progress", "none"]
    status = main([*words, "--out", str(out)])
    said = capsys.readouterr()
    return status, said.out, said.err


def test_axes_that_are_none_of_the_measurement_are_refused(epochs, tmp_path, capsys):
    names = [str(k) for k in range(1, 60)]
    file = nominal(tmp_path, np.eye(3), np.zeros(3), names)
    status, _, err = in_axes_of(epochs, file, tmp_path / "m", capsys)
    assert (status, "[fit.other_unit]" in err, "mm for m" in err) == (2, True, True)
    file = nominal(tmp_path, np.diag([-1.0, 1.0, 1.0]), np.zeros(3), names)
    status, _, err = in_axes_of(epochs, file, tmp_path / "m", capsys, "--unit", "0.001")
    assert (status, "[nominal_mirrored]" in err) == (2, True)
    assert not (tmp_path / "m").exists()


def test_exchanged_names_bend_no_axes_and_their_fit_is_told(epochs, tmp_path, capsys):
    names = [str(k) for k in range(1, 60)]
    file = nominal(tmp_path, np.eye(3), np.zeros(3), names, off=set(MOVED))
    lines = file.read_text().splitlines()
    at = [k for k, line in enumerate(lines) if line.split(",")[0] in {"8", "30"}]
    a, b = (lines[k].split(",", 1) for k in at)
    lines[at[0]], lines[at[1]] = f"{a[0]},{b[1]}", f"{b[0]},{a[1]}"
    file.write_text("\n".join(lines) + "\n")
    status, said, _ = in_axes_of(epochs, file, tmp_path / "m", capsys, "--unit", "0.001")
    assert status == 0
    assert "[nominal_wrong]" in said
    told = json.loads((tmp_path / "m/moved.json").read_text())["axes"]
    assert sorted(told["did_not_fit"]) == ["30", "8"]
    assert told["rms_m"] < 1e-3
    assert 0 < told["turn_sigma_rad"] < 1e-3


def renamed(epoch, folder, names=lambda i: i, **more):
    """The measurement of a result again, its points called otherwise."""
    block = rb.read_block(epoch / "block")
    points = replace(block.points, ids=tuple(names(i) for i in block.points.ids))
    write_result(rb.adjust(replace(block, points=points, **more), rb.AdjustmentOptions(jobs=1)), folder, report="none")
    return folder


def test_one_measurement_given_twice_is_refused(epochs, tmp_path, capsys):
    assert main(["moved", str(epochs[0]), str(epochs[0]), "--out", str(tmp_path / "m")]) == 2
    assert "[epochs.same_observations]" in capsys.readouterr().err


def test_scales_that_contradict_each_other_are_a_fault_with_their_bars(epochs, tmp_path, capsys):
    block = rb.read_block(epochs[1] / "block")
    longer = replace(block.distances, length=block.distances.length * 1.001)
    other = tmp_path / "other"
    write_result(rb.adjust(block.having(longer), rb.AdjustmentOptions(jobs=1)), other, report="none")
    done = rb.moved_points([epochs[0], other], tmp_path / "m")
    assert {i for i, m in zip(done.ids, done.moved, strict=True) if m} == set(MOVED)
    (told,) = [n for n in done.reported if n.code == "epochs_scale"]
    assert told.severity == "fault"
    assert told.values["bars"]
    page = (tmp_path / "m/report.html").read_text(encoding="utf-8")
    assert '"verdict attention"' in page
    mm = rb.transform_block(block, rb.SimilarityTransform(scale=1000.0), observed="follow")
    write_result(
        rb.adjust(mm, rb.AdjustmentOptions(jobs=1)), tmp_path / "mm", report="none"
    )  # and says it is in metres
    assert main(["moved", str(epochs[0]), str(tmp_path / "mm"), "--out", str(tmp_path / "n")]) == 2
    said = capsys.readouterr().err
    assert "[epochs.other_unit]" in said
    assert "m for mm" in said
    assert main(["moved", str(epochs[0]), str(other), "--points", "nope", "--out", str(tmp_path / "n")]) == 2
    assert "[measurement.unknown_points]" in capsys.readouterr().err


def test_names_shifted_by_one_are_a_fault(epochs, tmp_path):
    ids = list(rb.read_block(epochs[1] / "block").points.ids)
    after = dict(zip(ids, [*ids[1:], ids[0]], strict=True))
    done = rb.moved_points([epochs[0], renamed(epochs[1], tmp_path / "e", after.get)], tmp_path / "m", report=False)
    (told,) = [n for n in done.reported if n.code == "epochs_names"]
    assert told.severity == "fault"
    assert told.values["moved"] > told.values["n"] / 2


def test_of_four_points_those_that_may_have_moved_instead_are_told(epochs, tmp_path, capsys):
    words = ["moved", *map(str, epochs), "--points", "1", "2", "3", "5", "--no-report", "--out", str(tmp_path / "m")]
    assert main(words) == 0
    told = json.loads((tmp_path / "m/moved.json").read_text())
    may = {*told["moved"], *(a["other"] for a in told["may_have_moved_instead"])}
    assert "5" in may
    if told["moved"] != ["5"]:
        assert "[moved_ambiguous]" in capsys.readouterr().out
    all_points = rb.moved_points(epochs, tmp_path / "n", report=False)
    assert not all_points.alternatives
