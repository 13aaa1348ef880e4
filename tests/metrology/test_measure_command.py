"""`raybundle measure`: coordinates held against nominal ones and known lengths."""

import csv
import os
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest

import raybundle as rb
from raybundle.cli.main import main
from raybundle.commands.measured import natural
from raybundle.errors import InputError
from raybundle.planning.scenes import TargetField, field_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.report.write import write_result

DATA = Path(os.environ.get("RAYBUNDLE_DATA", Path(__file__).resolve().parents[3] / "shared/data"))
CERN = DATA / "photos/cern-targets"
QUIET = ("--progress", "none", "--no-report")


def rows(path):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@pytest.fixture(scope="module")
def field(tmp_path_factory):
    """A result without a scale, the true coordinates, and their file in millimetres."""
    folder = tmp_path_factory.mktemp("field")
    done = simulate(field_scene(TargetField()), Survey(seed=5, image_sigma_px=0.1))
    write_result(
        rb.adjust(done.observed, rb.AdjustmentOptions(threads=1, datum="inner")), folder / "free", report="none"
    )
    truth = dict(zip(done.truth.points.ids, done.truth.points.xyz, strict=True))
    lines = [f"{name},{','.join(repr(float(1000 * v)) for v in xyz)},2" for name, xyz in truth.items()]
    (folder / "nominal.csv").write_text("\n".join(["point,X,Y,Z,tolerance", *lines]) + "\n")
    return folder, truth


def bar(truth, a, b, sigma=1e-5):
    return "--scale-bar", a, b, repr(float(np.linalg.norm(truth[a] - truth[b]))), repr(sigma)


def test_a_result_is_scaled_and_held_against_nominal(field, tmp_path, capsys):
    folder, truth = field
    words = ["measure", str(folder / "free"), *bar(truth, "1", "20"), *bar(truth, "3", "15"), *QUIET]
    words += ["--nominal", str(folder / "nominal.csv"), "--unit", "0.001", "--out", str(tmp_path / "m")]
    assert main(words) == 0
    said = capsys.readouterr().out
    assert f"fitted to nominal by {len(truth)} points: rms" in said
    assert f"tolerances: {len(truth)} within, 0 beyond, 0 undecided" in said
    table = rows(tmp_path / "m/nominal.csv")
    d = np.array([[float(r[f"d{a}_mm"]) for a in "XYZ"] for r in table])
    s = np.array([[float(r[f"sd{a}_mm"]) for a in "XYZ"] for r in table])
    assert np.sqrt(np.mean((d / s) ** 2)) == pytest.approx(1, abs=0.2)
    listed = rows(tmp_path / "m/coordinate_list.csv")
    assert [r["point"] for r in listed] == sorted(truth, key=natural)
    block = rb.read_block(tmp_path / "m/block")
    assert block.length_unit == "m"
    assert len(block.distances) == 2


def test_the_table_of_lengths_is_what_one_reckons_oneself(field, tmp_path, capsys):
    folder, truth = field
    pairs = list(combinations(["2", "7", "11", "19", "23"], 2))
    known = [float(np.linalg.norm(truth[a] - truth[b])) for a, b in pairs]
    (tmp_path / "known.csv").write_text(
        "from,to,length,sigma\n" + "".join(f"{a},{b},{d!r},0.000002\n" for (a, b), d in zip(pairs, known, strict=True))
    )
    words = ["measure", str(folder / "free"), *bar(truth, "1", "20"), *QUIET, "--lengths", str(tmp_path / "known.csv")]
    assert main([*words, "--allowed", "1", "0", "--out", str(tmp_path / "m")]) == 0
    assert "all errors are within what is allowed" in capsys.readouterr().out
    result = rb.read_result(tmp_path / "m")
    xyz = dict(zip(result.points.text["point"], result.points.numbers(*"XYZ"), strict=True))
    for r, d in zip(rows(tmp_path / "m/lengths.csv"), known, strict=True):
        measured = np.linalg.norm(xyz[r["from"]] - xyz[r["to"]])
        assert float(r["error_mm"]) == pytest.approx(1000 * (measured - d), abs=1e-6)
        (answer,) = rb.query(tmp_path / "m", distance=((r["from"], r["to"]),))
        assert float(r["sigma_mm"]) == pytest.approx(1000 * np.hypot(answer.sigma[0], 2e-6), rel=1e-6)
    assert main([*words, "--allowed", "0", "0", "--out", str(tmp_path / "n")]) == 4
    assert "10 errors are beyond what is allowed" in capsys.readouterr().out


def test_deviations_beyond_their_tolerance_are_told(field, tmp_path, capsys):
    folder, truth = field
    lines = (folder / "nominal.csv").read_text().splitlines()
    name, x, *others = lines[4].split(",")
    lines[4] = ",".join([name, repr(float(x) + 30.0), *others])
    (tmp_path / "moved.csv").write_text("\n".join(lines) + "\n")
    others = [p for p in truth if p != name]
    words = ["measure", str(folder / "free"), *bar(truth, "1", "20"), *QUIET, "--unit", "0.001", "--by", *others]
    assert main([*words, "--nominal", str(tmp_path / "moved.csv"), "--out", str(tmp_path / "m")]) == 4
    said = capsys.readouterr().out
    assert "1 beyond" in said
    assert f"{name}: 30" in said


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--scale-bar", "1", "99x", "1.0", "0.001"), "scale bars end at points that were not measured: 99x"),
        (("--check-length", "1", "2", "1.0"), "nothing measured the scale"),
        (("--target", "aicon14"), "belong to photographs"),
        (("--nominal", "none.csv"), "none.csv"),
    ],
)
def test_what_cannot_be_measured_is_told(field, tmp_path, capsys, words, said):
    folder, _ = field
    assert main(["measure", str(folder / "free"), *words, *QUIET, "--out", str(tmp_path / "m")]) == 2
    assert said in capsys.readouterr().err
    assert not (tmp_path / "m").exists()


@pytest.mark.parametrize("factor", [1000, 1.2])
def test_bars_that_contradict_are_told(field, tmp_path, factor):
    folder, truth = field
    lengths = {(a, b): float(np.linalg.norm(truth[a] - truth[b])) for a, b in (("1", "20"), ("3", "15"), ("2", "18"))}
    bars = [(a, b, d * (factor if a == "3" else 1), 0.1 * d) for (a, b), d in lengths.items()]
    if factor > 2:
        with pytest.raises(InputError, match=r"contradict each other by a factor of 1e\+03, 3 - 15 most"):
            rb.measure_targets(folder / "free", tmp_path / "m", scale_bar=bars, report=False)
    else:
        done = rb.measure_targets(folder / "free", tmp_path / "m", scale_bar=bars, report=False)
        assert "by a factor of 1.2, 3 - 15 most" in done.remarks[0]


@pytest.mark.long
@pytest.mark.skipif(not CERN.is_dir(), reason=f"no photographs of cern-targets at {CERN}")
def test_photographs_of_cern_give_its_coordinates(tmp_path):
    given = {r["id"]: np.array([float(r[a]) for a in "XYZ"]) / 1000 for r in rows(CERN / "points.csv")}
    coded = [i for i in given if int(i) <= 74]
    bars = [(a, b, float(np.linalg.norm(given[a] - given[b])), 1e-5) for a, b in (("2", "74"), ("8", "66"))]
    lengths = [(a, b, float(np.linalg.norm(given[a] - given[b]))) for a, b in combinations(coded, 2)]
    done = rb.measure_targets(
        CERN / "images", tmp_path / "m", target=("aicon14",), scale_bar=bars, check_length=lengths, report=False
    )
    assert len(done.points.ids) == 73
    assert done.lengths.rms < 1e-5  # the given coordinates have errors of their own, which nobody states
    assert done.lengths.within > 0.8
    page = " ".join((Path(__file__).parents[2] / "docs/how-to/measure-targets.md").read_text().split())
    assert (
        f"by {1000 * done.lengths.rms:.3f} mm (root mean square; {100 * done.lengths.within:.0f} % are within" in page
    )
