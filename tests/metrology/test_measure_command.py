"""`raybundle measure`: coordinates held against nominal ones and known lengths."""

import csv
import html
import json
import os
import re
from dataclasses import replace
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from tests.cli.reported import reported, values_of
from tests.docs.figures import in_a_row
from tests.fields import SMALL
from tests.messages import refused

import raybundle as rb
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.cli.main import main
from raybundle.errors import InputError, code_of, note, phrase
from raybundle.io.block.folder import read_block, write_block
from raybundle.metrology.notices import of_a_tool
from raybundle.numerics.natural import natural
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import field_scene
from raybundle.report.text.metrology_words import length_figures, outcomes
from raybundle.report.write import write_result
from raybundle.words import Reader, headline
from raybundle.workflows.calibrate import Calibration

DATA = Path(os.environ.get("RAYBUNDLE_DATA", Path(__file__).resolve().parents[3] / "shared/data"))
CERN = DATA / "photos/cern-targets"
QUIET = ("--progress", "none", "--no-report")
CLIENT = "Müller & Söhne"


def rows(path):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@pytest.fixture(scope="module")
def field(tmp_path_factory):
    """A result without a scale, the true coordinates, and their file in millimetres."""
    folder = tmp_path_factory.mktemp("field")
    done = simulate(field_scene(SMALL), Survey(seed=5, image_sigma_px=0.1))
    write_result(rb.adjust(done.observed, rb.AdjustmentOptions(jobs=1, datum="inner")), folder / "free", report="none")
    truth = dict(zip(done.truth.points.ids, done.truth.points.xyz, strict=True))
    lines = [f"{name},{','.join(repr(float(1000 * v)) for v in xyz)},2" for name, xyz in truth.items()]
    (folder / "nominal.csv").write_text("\n".join(["point,X,Y,Z,tolerance", *lines]) + "\n")
    return folder, truth


def bar(truth, a, b, sigma=1e-5):
    return "--scale-bar", a, b, repr(float(np.linalg.norm(truth[a] - truth[b]))), repr(sigma)


def check_drawing(folder, listed):
    """A drawing of a measurement has its points, in the order of its list, and their names."""
    ezdxf = pytest.importorskip("ezdxf")
    rb.convert(folder / "m", folder / "m.dxf", to="dxf")
    drawing = ezdxf.readfile(folder / "m.dxf")
    assert drawing.header["$INSUNITS"] == 6
    space = drawing.modelspace()
    points = [tuple(p.dxf.location) for p in space.query("POINT[layer=='points-named']")]
    np.testing.assert_allclose(points, [[float(r[f"{a}_m"]) for a in "XYZ"] for r in listed], rtol=0, atol=1e-7)
    names = [t.plain_text() for t in space.query("TEXT[layer=='points-named-names']")]
    assert names == [r["point"] for r in listed]
    assert len(space.query("LINE[layer=='distances']")) == 2


def test_control_gives_the_axes_and_check_points_are_compared(field, tmp_path):
    folder, truth = field
    names = ["1", "9", "20", "29", "33"]
    lines = [",".join([n, *(f"{1000 * v + 500:.4f}" for v in truth[n]), "control"]) for n in names]
    lines += [",".join([n, *(f"{1000 * v + 500:.4f}" for v in truth[n]), "check"]) for n in ("12", "25")]
    control = tmp_path / "control.csv"
    control.write_text("\n".join(["point,X,Y,Z,role", *lines]))
    done = rb.measure(folder / "free", tmp_path / "r", control=str(control), unit=0.001, report=False)
    true = np.array([truth[n] for n in done.points.ids]) + 0.5
    off = done.points.xyz - true
    assert np.sqrt((off**2).mean()) < 1e-4
    assert np.sqrt(((off / done.points.sigma) ** 2).mean()) < 1.6
    assert any(g.kind == "control" for g in done.adjustment.groups)
    assert len(rows(tmp_path / "r/check.csv")) > 1


def test_control_that_states_no_deviation_is_as_good_as_it_fits(field, tmp_path):
    folder, truth = field
    rng = np.random.default_rng(7)
    names = ["1", "8", "41", "48"]
    at = {n: truth[n] + rng.normal(0, 1e-3, 3) for n in names}
    control = tmp_path / "control.csv"
    control.write_text("\n".join(["point,X,Y,Z", *(",".join([n, *(f"{v:.6f}" for v in at[n])]) for n in names)]))
    done = rb.measure(folder / "free", tmp_path / "r", control=str(control), report=False)
    off = done.points.xyz - np.array([truth[n] for n in done.points.ids])
    assert 0.3 < np.sqrt(((off / done.points.sigma) ** 2).mean()) < 2
    (told,) = [n for n in done.adjustment.notices if (n.code, n.variant) == ("control_file", "no_sigma")]
    assert told.values["name"] == "control.csv"
    assert [code_of(r) for r in done.remarks].count("control_file.no_sigma") == 1


def test_control_needs_three_measured_points(field, tmp_path):
    folder, _ = field
    control = tmp_path / "control.csv"
    control.write_text("point,X,Y,Z\n1,0,0,0.1\n2,1,0,0\nnowhere,0,1,0.2\n")
    with pytest.raises(InputError, match=r"2.*3.*control\.too_few_for_datum"):
        rb.measure(folder / "free", tmp_path / "r", control=str(control))


def test_a_report_tells_deviations_lengths_and_who_it_is_for(field, tmp_path):
    folder, truth = field
    lengths = [("2", "7", float(np.linalg.norm(truth["2"] - truth["7"])))]
    lengths += [("3", "15", float(np.linalg.norm(truth["3"] - truth["15"])) + 0.002)]
    scale = [("1", "20", float(np.linalg.norm(truth["1"] - truth["20"])), 1e-5)]
    rb.measure(
        folder / "free", tmp_path / "r", scale_bar=scale, nominal=folder / "nominal.csv", unit=0.001,
        check_length=lengths, allowed=(0.5, 0.0), client=CLIENT, pdf=True,
    )  # fmt: skip
    page = (tmp_path / "r/report.html").read_text(encoding="utf-8")
    assert html.escape(CLIENT) in page
    assert headline("report_metrology.deviations", {}) in page
    assert headline("report_metrology.lengths", {}) in page
    assert headline("outcome.not_kept", {"name": "lengths"}) in page
    assert headline("outcome.lengths", {"over": 1, "n": 2}) in page
    assert (tmp_path / "r/report.pdf").read_bytes()[:5] == b"%PDF-"


def test_a_result_is_scaled_and_held_against_nominal(field, tmp_path, capsys):
    folder, truth = field
    words = ["measure", str(folder / "free"), *bar(truth, "1", "20"), *bar(truth, "3", "15"), *QUIET]
    words += ["--nominal", str(folder / "nominal.csv"), "--unit", "0.001", "--out", str(tmp_path / "m"), "--json"]
    assert main(words) == 0
    found = values_of(reported(capsys))
    assert {"significant": 0, "of": len(truth)}.items() <= found["measurement.fit"].items()
    assert found["measurement.tolerances"] == {"within": len(truth), "beyond": 0, "names": [], "undecided": 0}
    table = rows(tmp_path / "m/nominal.csv")
    d = np.array([[float(r[f"d{a}_mm"]) for a in "XYZ"] for r in table])
    s = np.array([[float(r[f"sd{a}_mm"]) for a in "XYZ"] for r in table])
    assert np.sqrt(np.mean((d / s) ** 2)) == pytest.approx(1, abs=0.2)
    listed = rows(tmp_path / "m/coordinate_list.csv")
    assert [r["point"] for r in listed] == sorted(truth, key=natural)
    check_drawing(tmp_path, listed)
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
    assert "; limits met" in capsys.readouterr().out
    result = rb.read_result(tmp_path / "m")
    xyz = dict(zip(result.points.text["point"], result.points.numbers(*"XYZ"), strict=True))
    for r, d in zip(rows(tmp_path / "m/lengths.csv"), known, strict=True):
        measured = np.linalg.norm(xyz[r["from"]] - xyz[r["to"]])
        assert float(r["error_mm"]) == pytest.approx(1000 * (measured - d), abs=3e-3 * float(r["sigma_mm"]))
        (answer,) = rb.query(tmp_path / "m", distance=((r["from"], r["to"]),))
        assert float(r["sigma_mm"]) == pytest.approx(1000 * np.hypot(answer.sigma[0], 2e-6), rel=1e-4)
    assert main([*words, "--allowed", "0", "0", "--out", str(tmp_path / "n"), "--json"]) == 4
    found = values_of(reported(capsys))["measurement.lengths"]
    assert (found["judged"], found["over"]) == ("exceeded", 10)


def test_deviations_beyond_their_tolerance_are_told(field, tmp_path, capsys):
    folder, truth = field
    lines = (folder / "nominal.csv").read_text().splitlines()
    name, x, *others = lines[4].split(",")
    lines[4] = ",".join([name, repr(float(x) + 30.0), *others])
    (tmp_path / "moved.csv").write_text("\n".join(lines) + "\n")
    others = [p for p in truth if p != name]
    words = ["measure", str(folder / "free"), *bar(truth, "1", "20"), *QUIET, "--unit", "0.001", "--by", *others]
    assert main([*words, "--nominal", str(tmp_path / "moved.csv"), "--out", str(tmp_path / "m")]) == 4
    assert f"1 exceeded ({name})" in capsys.readouterr().out
    assert main([*words, "--nominal", str(tmp_path / "moved.csv"), "--verbose", "--out", str(tmp_path / "v")]) == 4
    assert f"{name}: 30" in capsys.readouterr().out
    words = [w for w in words if w != "--no-report"]
    more = ["--nominal", str(tmp_path / "moved.csv"), "--title", "Part 7", "--client", "Works", "--operator", "R. B."]
    assert main([*words, *more, "--out", str(tmp_path / "r")]) == 4
    page = (tmp_path / "r/report.html").read_text(encoding="utf-8")
    assert "<h1>Part 7</h1>" in page
    assert headline("front.not_as_required", {}) in page
    assert "1 beyond" in page
    assert '"verdict attention"' in page
    assert rb.read_result(tmp_path / "r").result["record"] == {
        "title": "Part 7",
        "client": "Works",
        "operator": "R. B.",
    }


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            ("--scale-bar", "1", "99x", "1.0", "0.001"),
            "scale bars that are not measured: 99x. [length_test.ends_not_measured]",
        ),
        (("--check-length", "1", "2", "1.0"), "[length_test.no_scale]"),
        (("--target", "aicon14"), "[target.needs_photographs]"),
        (("--nominal", "none.csv"), "none.csv"),
        (("--scale-bar", "1", "20", "2.0", "0.001", "--nominal", "{folder}/nominal.csv"), "[fit.other_unit]"),
    ],
)
def test_what_cannot_be_measured_is_told(field, tmp_path, capsys, words, said):
    folder, _ = field
    words = [w.format(folder=folder) for w in words]
    assert main(["measure", str(folder / "free"), *words, *QUIET, "--out", str(tmp_path / "m")]) == 2
    assert said in capsys.readouterr().err
    assert not (tmp_path / "m").exists()


def bars_of(truth, *pairs, sigma=1e-5):
    return [(a, b, float(np.linalg.norm(truth[a] - truth[b])) + off, sigma) for a, b, off in pairs]


def warnings_of(folder):
    return {w["code"]: w for w in rb.read_result(folder).result["warnings"]}


def test_a_bar_in_another_unit_ends_the_run_and_is_named(field, tmp_path):
    folder, truth = field
    bars = bars_of(truth, ("1", "20", 0), ("3", "15", 0), ("2", "18", 0))
    bars[1] = (*bars[1][:2], 1000 * bars[1][2], 1e-5)
    for given, named in ((bars, ["3 - 15"]), (bars[:2], ["1 - 20", "3 - 15"])):
        with refused("scale_bar.contradict", factor=pytest.approx(1000, rel=1e-3)) as error:
            rb.measure(folder / "free", tmp_path / "m", scale_bar=given, report=False)
        assert [d.values["bar"] for d in error.value.message.details] == named


@pytest.mark.parametrize("off", [0.0005, 0.005, 0.3])
def test_of_two_bars_that_contradict_both_are_named_with_their_sizes(field, tmp_path, capsys, off):
    folder, truth = field
    bars = bars_of(truth, ("1", "20", off), ("3", "15", 0))
    words = [w for b in bars for w in ("--scale-bar", b[0], b[1], repr(b[2]), repr(b[3]))]
    assert main(["measure", str(folder / "free"), *words, *QUIET, "--out", str(tmp_path / "m")]) == 0
    shown = capsys.readouterr().out
    stated = warnings_of(tmp_path / "m")
    assert stated["bars_contradict"]["severity"] == "fault"
    assert "distance_suspect" not in stated  # once is enough
    assert any(t.startswith("fault: ") and t.endswith("[bars_contradict]") for t in shown.splitlines())
    found = {d["values"]["bar"]: d["values"] for d in stated["bars_contradict"]["details"]}
    assert {a: v["others"] for a, v in found.items()} == {"1 - 20": "3 - 15", "3 - 15": "1 - 20"}
    assert found["1 - 20"]["given_mm"] - found["1 - 20"]["measured_mm"] == pytest.approx(1000 * off, abs=0.15)
    # nothing is bent: image points are as precise as ever
    (images,) = [g for g in rb.read_result(tmp_path / "m").result["group_factors"] if "image" in g["kind"]]
    assert images["factor"] == pytest.approx(1, abs=0.1)


def test_of_three_bars_the_wrong_one_is_named_alone(field, tmp_path):
    folder, truth = field
    bars = bars_of(truth, ("1", "20", 0), ("3", "15", 0.004), ("2", "18", 0))
    done = rb.measure(folder / "free", tmp_path / "m", scale_bar=bars, report=False)
    (told,) = [n for n in done.adjustment.notices if n.code == "bars_contradict"]
    assert told.ids == ("3 - 15",)
    assert told.variant == "one"
    assert [d.values["bar"] for d in told.details] == ["3 - 15"]
    off = np.linalg.norm(np.diff(done.points.named(["1", "20"]).xyz, axis=0)) - bars[0][2]
    assert abs(off) < 5e-5  # the others give the scale


def test_exchanged_certificates_are_told_as_that(field, tmp_path):
    folder, truth = field
    a, b = bars_of(truth, ("1", "14", 0), ("3", "9", 0))
    bars = [(*a[:2], *b[2:]), (*b[:2], *a[2:])]
    with refused("scale_bar.contradict", exchanged=True, first="1 - 14", second="3 - 9"):
        rb.measure(folder / "free", tmp_path / "m", scale_bar=bars, report=False)
    a, b = bars_of(truth, ("1", "14", 0), ("3", "7", 0))
    bars = [(*a[:2], *b[2:]), (*b[:2], *a[2:])]
    done = rb.measure(folder / "free", tmp_path / "m", scale_bar=bars, report=False)
    (told,) = [n for n in done.adjustment.notices if n.code == "bars_contradict"]
    assert told.variant == "exchanged"
    assert {told.values["first"], told.values["second"]} == {"1 - 14", "3 - 7"}
    assert told.severity is Severity.FAULT


def test_right_bars_are_seldom_called_contradicting(field, tmp_path):
    folder, truth = field
    bars = bars_of(truth, ("1", "20", 0), ("3", "15", 0), ("2", "18", 0))
    rb.measure(folder / "free", tmp_path / "m", scale_bar=bars, report=False)
    assert "bars_contradict" not in warnings_of(tmp_path / "m")


def known_lengths(truth, *pairs, off=0.0):
    return [(a, b, float(np.linalg.norm(truth[a] - truth[b])) + off) for a, b in pairs]


SIX = tuple(combinations(("2", "7", "11", "19"), 2))


def test_lengths_that_took_no_part_are_a_comparison(field, tmp_path):
    folder, truth = field
    bars, lengths = bars_of(truth, ("1", "20", 0)), known_lengths(truth, *SIX)
    done = rb.measure(folder / "free", tmp_path / "m", scale_bar=bars, check_length=lengths)
    page = html.unescape((tmp_path / "m/report.html").read_text(encoding="utf-8")).replace("\u00a0", " ")
    for wrong in ("front.not_checked", "verdict.not_tested", "limits.no_comparison", "verdict.scale_unchecked"):
        assert headline(wrong, {}) not in page
    largest, rms = 1000 * done.lengths.largest, 1000 * done.lengths.rms
    k = done.lengths.known[done.lengths.largest_at]
    errors, test = length_figures(done.lengths)
    assert errors.values == {
        "n": 6, "independent": True, "largest_mm": largest, "start": k.start, "end": k.end, "rms_mm": rms
    }  # fmt: skip
    assert not test.values["contradicts"]
    for message in (errors, test, note("verdict.at_lengths", n=6, rms_mm=rms), note("front.usable", n=0)):
        assert message.text() in page
    told = warnings_of(tmp_path / "m")
    assert "scale_unchecked" not in told
    assert "lengths_contradict" not in told
    assert told["scale_checked"]["values"]["n"] == 6
    off, sigma = done.lengths.scale
    assert abs(off) < 3.5 * sigma


def test_lengths_that_were_bars_are_no_comparison(field, tmp_path, capsys):
    folder, truth = field
    command = ["measure", str(folder / "free"), *bar(truth, "1", "20"), "--progress", "none"]
    command += ["--check-length", "20", "1", repr(float(np.linalg.norm(truth["1"] - truth["20"])))]
    assert main([*command, "--json", "--out", str(tmp_path / "m")]) == 0
    (served,) = [m for m in json.loads(capsys.readouterr().out)["details"] if m["code"] == "measurement.lengths_served"]
    assert served["values"] == {"n": 1, "independent": False}
    page = (tmp_path / "m/report.html").read_text(encoding="utf-8")
    assert headline("limits.no_comparison", {}) in page
    assert "scale_unchecked" in warnings_of(tmp_path / "m")
    assert [r["was_bar"] for r in rows(tmp_path / "m/lengths.csv")] == ["yes"]


@pytest.mark.parametrize("language", ["en", "de"])
def test_what_the_terminal_cautions_of_lengths_stands_everywhere(field, tmp_path, capsys, language):
    folder, truth = field
    lengths = known_lengths(truth, *SIX[:5]) + known_lengths(truth, SIX[5], off=0.0006)
    (tmp_path / "l.csv").write_text("from,to,length\n" + "".join(f"{a},{b},{d!r}\n" for a, b, d in lengths))
    words = ["measure", str(folder / "free"), *bar(truth, "1", "20"), *bar(truth, "3", "15"), "--progress", "none"]
    words += ["--lengths", str(tmp_path / "l.csv"), "--language", language, "--out", str(tmp_path / "m")]
    assert main(words) == 0
    said = capsys.readouterr().out
    told = warnings_of(tmp_path / "m")["lengths_contradict"]
    assert told["severity"] in {"warning", "fault"}
    assert f"{told['severity']}: Errors of" in said
    assert "[lengths_contradict.one]" in said
    a, b = SIX[5]
    assert told["values"]["length"] == f"{a} - {b}"
    assert told["details"][0]["values"]["error_mm"] == pytest.approx(-0.6, abs=0.1)
    page = html.unescape((tmp_path / "m/report.html").read_text(encoding="utf-8"))
    words = {"en": "times as large as stated", "de": "so groß wie angegeben"}
    assert words[language] in page
    assert headline("front.usable", {"n": 0}, Reader(language)) not in page


def test_lengths_that_contradict_together_say_by_what_factor(field, tmp_path):
    folder, truth = field
    lengths = known_lengths(truth, *SIX)
    lengths = [(a, b, d + off) for (a, b, d), off in zip(lengths, (2e-4, -2e-4, 2e-4, -2e-4, 2e-4, -2e-4), strict=True)]
    bars = bars_of(truth, ("1", "20", 0), ("3", "15", 0))
    done = rb.measure(folder / "free", tmp_path / "m", scale_bar=bars, check_length=lengths, report=False)
    (told,) = [n for n in done.adjustment.notices if n.code == "lengths_contradict"]
    assert done.lengths.whole[1] < 0.05
    assert told.values["factor"] == pytest.approx(done.lengths.factor)
    assert told.variant != "one"


def test_nominal_points_that_were_not_measured_are_a_caution(field, tmp_path, capsys):
    folder, truth = field
    (tmp_path / "more.csv").write_text((folder / "nominal.csv").read_text() + "nowhere,1,2,3,2\n")
    words = ["measure", str(folder / "free"), *bar(truth, "1", "20"), *QUIET, "--unit", "0.001"]
    main([*words, "--nominal", str(tmp_path / "more.csv"), "--out", str(tmp_path / "m")])
    told = warnings_of(tmp_path / "m")["nominal_missing"]
    assert told["ids"] == ["nowhere"]
    assert capsys.readouterr().out.count("[nominal_missing]") == 1


def test_control_may_have_a_column_of_tolerances(field, tmp_path, capsys):
    folder, _ = field
    lines = (folder / "nominal.csv").read_text().splitlines()
    (tmp_path / "five.csv").write_text("\n".join([lines[0], *(lines[k] for k in (1, 9, 20, 29, 46))]))
    words = ["measure", str(folder / "free"), "--control", str(tmp_path / "five.csv"), "--unit", "0.001", *QUIET]
    assert main([*words, "--out", str(tmp_path / "m")]) == 0
    (told,) = [w for w in rb.read_result(tmp_path / "m").result["warnings"] if w.get("variant") == "tolerance"]
    assert told["severity"] == "note"
    bad = tmp_path / "bad.csv"
    bad.write_text("point,X,Y,Z,tolerance\n1,0,0,0,1\n2,0,x,0,1\n")
    assert main([*words[:3], str(bad), *QUIET, "--out", str(tmp_path / "n")]) == 2
    assert f"{bad}, line 3, column Y" in capsys.readouterr().err


def test_who_builds_on_a_result_with_faults_is_told(field, tmp_path):
    folder, truth = field
    bars = bars_of(truth, ("1", "20", 0.005), ("3", "15", 0))
    rb.measure(folder / "free", tmp_path / "m", scale_bar=bars, report=False)
    done = rb.measure(tmp_path / "m", tmp_path / "n", report=False)
    (told,) = [n for n in done.adjustment.notices if n.code == "result_unsettled"]
    assert told.values == {"name": "m", "n": 1}


def test_points_beyond_their_tolerance_are_named_on_page_one(field, tmp_path):
    folder, truth = field
    lines = (folder / "nominal.csv").read_text().splitlines()
    for k in range(3, 10):
        name, x, *others = lines[k].split(",")
        lines[k] = ",".join([name, repr(float(x) + 3.0 * k), *others])
    (tmp_path / "off.csv").write_text("\n".join(lines) + "\n")
    by = tuple(p for p in truth if p not in {line.split(",")[0] for line in lines[3:10]})
    scale = bars_of(truth, ("1", "20", 0), ("3", "15", 0))
    done = rb.measure(folder / "free", tmp_path / "m", scale_bar=scale, nominal=tmp_path / "off.csv", by=by, unit=0.001)
    (told,) = outcomes(done.fit, None)
    counts, *named, more = told.sentence.messages
    assert counts.values == {"within": len(truth) - 7, "beyond": 7, "undecided": 0}
    assert [m.values["point"] for m in named[:2]] == ["9", "8"]
    assert [m.values["deviation_mm"] for m in named[:2]] == pytest.approx([27, 24], abs=0.5)
    assert {m.values["tolerance_mm"] for m in named} == {2}
    assert (len(named), more.values) == (5, {"n": 2})
    assert named[0].text() in (tmp_path / "m/report.html").read_text(encoding="utf-8").replace("\u00a0", " ")


@pytest.mark.parametrize("language", ["en", "de"])
def test_a_photograph_that_takes_no_part_is_named_with_its_reason(field, tmp_path, capsys, monkeypatch, language):
    _, truth = field
    block = simulate(field_scene(SMALL), Survey(seed=5, image_sigma_px=0.1)).observed
    done = Calibration(
        adjustment=rb.adjust(block, rb.AdjustmentOptions(jobs=1, datum="inner")), quality=(), photos=(), groups=(),
        refused=(("broken.jpg", phrase("photograph.copy", original="a.jpg")),), marks=(), targets=(),
        completed=0, dots=0, not_used=(("wall.jpg", phrase("not_oriented.few_targets", n=0, least=6)),),
        largest_eccentricity_px=0.0,
    )  # fmt: skip
    monkeypatch.setattr("raybundle.workflows.calibrate.calibrate", lambda *_, **__: done)
    photos = tmp_path / "photos"
    photos.mkdir()
    words = ["measure", str(photos), *bar(truth, "1", "20"), "--progress", "none", "--language", language]
    assert main([*words, "--out", str(tmp_path / "m")]) == 0
    said = capsys.readouterr().out
    assert all(re.search(rf"warning: .*{name}.*\[image_left_out\]", said) for name in ("wall.jpg", "broken.jpg"))
    result = rb.read_result(tmp_path / "m").result
    assert {w["ids"][0] for w in result["warnings"] if w["code"] == "image_left_out"} == {"broken.jpg", "wall.jpg"}
    assert {x["code"] for x in result["images"]["not_oriented"]} == {"photograph.copy", "not_oriented.few_targets"}
    page = (tmp_path / "m/report.html").read_text(encoding="utf-8").replace("\u00a0", " ")
    assert headline("not_oriented.few_targets", {"n": 0, "least": 6}, Reader(language)).rstrip(".") in page


def test_correlated_parameters_of_a_camera_are_a_remark_here():
    notice = Notice(code="correlation", message="of an earlier result", ids=("1", "x0", "P1"))
    result = rb.adjust(
        simulate(field_scene(SMALL), Survey(seed=5)).observed, rb.AdjustmentOptions(jobs=1, datum="inner")
    )
    (stated,) = of_a_tool(replace(result, notices=(notice,)), None).notices
    assert stated.severity is Severity.NOTE
    assert [d.code for d in stated.details] == ["correlation.contained"]
    assert stated.text.startswith(notice.message)


@pytest.mark.long
@pytest.mark.skipif(not CERN.is_dir(), reason=f"no photographs of cern-targets at {CERN}")
def test_photographs_of_cern_give_its_coordinates(tmp_path):
    given = {r["id"]: np.array([float(r[a]) for a in "XYZ"]) / 1000 for r in rows(CERN / "points.csv")}
    coded = [i for i in given if int(i) <= 74]
    bars = [(a, b, float(np.linalg.norm(given[a] - given[b])), 1e-5) for a, b in (("2", "74"), ("8", "66"))]
    lengths = [(a, b, float(np.linalg.norm(given[a] - given[b]))) for a, b in combinations(coded, 2)]
    done = rb.measure(
        CERN / "images", tmp_path / "m", target=("aicon14",), scale_bar=bars, check_length=lengths, report=False
    )
    assert len(done.points.ids) == 73
    assert done.lengths.rms < 1e-5  # the given coordinates have errors of their own, which nobody states
    assert done.lengths.within > 0.8
    page = (Path(__file__).parents[2] / "docs/how-to/measure-targets.md").read_text()
    assert in_a_row(page, "2000", "1333", f"{1000 * done.lengths.rms:.3f}", f"{100 * done.lengths.within:.0f}")


def test_control_is_held_against_what_was_measured_not_against_approximate_values(field, tmp_path):
    """A block whose points begin 2 mm off: control that is right to 10 um is not taken for millimetres."""
    folder, truth = field
    block = read_block(folder / "free" / "block")
    rng = np.random.default_rng(3)
    moved = replace(block.points, xyz=block.points.xyz + rng.normal(0, 2e-3, block.points.xyz.shape))
    write_block(replace(block, points=moved), tmp_path / "b")
    names = ["1", "8", "41", "48"]
    lines = [",".join([n, *(f"{v + rng.normal(0, 1e-5):.7f}" for v in truth[n])]) for n in names]
    (tmp_path / "c.csv").write_text("\n".join(["point,X,Y,Z", *lines]))
    done = rb.measure(tmp_path / "b", tmp_path / "r", control=str(tmp_path / "c.csv"), report=False)
    (group,) = [g for g in done.adjustment.groups if g.kind == "control"]
    assert np.median(group.sigma) < 3e-4
    assert not [r for r in done.remarks if code_of(r) == "control_file.no_sigma" and r.message.values["off_mm"] > 1]
