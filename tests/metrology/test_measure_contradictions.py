"""`raybundle measure`: nominal coordinates, control and lengths that contradict the measurement are told as that."""

import numpy as np
import pytest
from tests.fields import SMALL
from tests.messages import refused

import raybundle as rb
from raybundle.cli.main import main
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import field_scene
from raybundle.report.write import write_result


@pytest.fixture(scope="module")
def field(tmp_path_factory):
    """A result without a scale, and true coordinates."""
    folder = tmp_path_factory.mktemp("field")
    done = simulate(field_scene(SMALL), Survey(seed=5, image_sigma_px=0.1))
    write_result(rb.adjust(done.observed, rb.AdjustmentOptions(jobs=1, datum="inner")), folder / "free", report="none")
    return folder / "free", dict(zip(done.truth.points.ids, done.truth.points.xyz, strict=True))


def bar(truth, a="1", b="20", off=0.0):
    return a, b, float(np.linalg.norm(truth[a] - truth[b])) + off, 1e-5


def table(path, truth, names=None, turn=(1, 1, 1), off=None):
    """Coordinates in mm; some of them off by so much [m]."""
    lines = []
    for n in names or truth:
        xyz = 1000 * (truth[n] * np.array(turn) + (off or {}).get(n, 0.0))
        lines.append(",".join([n, *(repr(float(v)) for v in xyz)]))
    path.write_text("\n".join(["point,X,Y,Z", *lines]) + "\n")
    return path


def codes(done):
    return {n.code: n for n in done.adjustment.notices}


def measured(field, out, **more):
    folder, truth = field
    return rb.measure(folder, out, scale_bar=[bar(truth)], unit=0.001, report=False, **more)


def test_mirrored_nominal_coordinates_are_told_first(field, tmp_path, capsys):
    folder, truth = field
    file = table(tmp_path / "n.csv", truth, turn=(-1, 1, 1))
    a, b, length, sigma = bar(truth)
    words = ["measure", str(folder), "--scale-bar", a, b, repr(length), repr(sigma), "--nominal", str(file)]
    assert main([*words, "--unit", "0.001", "--no-report", "--progress", "none", "--out", str(tmp_path / "m")]) == 0
    first = next(line for line in capsys.readouterr().out.splitlines() if line.endswith("]"))
    assert first.startswith("fault: ")
    assert "[nominal_mirrored]" in first


def test_a_wrong_bar_is_one_factor_of_all_deviations(field, tmp_path):
    folder, truth = field
    file = table(tmp_path / "n.csv", truth)
    wrong = bar(truth, off=0.7 * bar(truth)[2])
    done = rb.measure(folder, tmp_path / "m", scale_bar=[wrong], nominal=file, unit=0.001, report=False)
    told = codes(done)["nominal_scale"]
    assert told.severity == "fault"
    assert told.values["factor"] == pytest.approx(0.588, abs=1e-3)


def test_one_wrong_nominal_value_bends_no_deviation(field, tmp_path):
    _, truth = field
    file = table(tmp_path / "n.csv", truth, off={"5": np.array([0.05, 0, 0])})
    done = measured(field, tmp_path / "m", nominal=file)
    assert [i for i, v in zip(done.fit.ids, done.fit.significant, strict=True) if v] == ["5"]
    assert [i for i, f in zip(done.fit.ids, done.fit.fitted, strict=True) if not f] == ["5"]
    (apart,) = codes(done)["nominal_wrong"].details
    assert apart.values == {"point": "5", "apart_mm": pytest.approx(50.0, abs=0.5)}
    assert codes(done)["nominal_wrong"].values["excluded"]
    named = measured(field, tmp_path / "n", nominal=file, by=("1", "2", "5", "9", "20", "33"))
    assert named.fit.fitted.sum() == 6  # who names them has them
    assert not codes(named)["nominal_wrong"].values["excluded"]


def test_names_that_were_exchanged_are_told(field, tmp_path):
    _, truth = field
    done = measured(
        field, tmp_path / "m", nominal=table(tmp_path / "n.csv", {**truth, "1": truth["2"], "2": truth["1"]})
    )
    (pair,) = [d for d in codes(done)["nominal_wrong"].details if d.code == "points_fit.names_exchanged"]
    assert pair.values == {"first": "1", "second": "2"}


FIVE = ("1", "7", "28", "34", "48")


@pytest.mark.parametrize(("turn", "code", "variant"), [
    ((-1, 1, 1), "control_mirrored", ""),
    ((1.01, 1.01, 1.01), "control_contradicts", "scale"),
])  # fmt: skip
def test_control_that_contradicts_all_is_a_fault_and_bends_nothing(field, tmp_path, turn, code, variant):
    _, truth = field
    done = measured(field, tmp_path / "m", control=table(tmp_path / "c.csv", truth, FIVE, turn))
    told = codes(done)[code]
    assert told.severity == "fault"
    assert told.variant == variant
    assert set(done.points.ids) == set(truth)
    assert not {"control_not_observed", "distance_lost"} & set(codes(done))
    length = np.linalg.norm(np.diff(done.points.named(["1", "20"]).xyz, axis=0))
    assert length == pytest.approx(bar(truth)[2], abs=5e-5)


def test_one_wrong_control_point_of_five_is_named_and_compared(field, tmp_path):
    _, truth = field
    file = table(tmp_path / "c.csv", truth, FIVE, off={"28": np.array([0.02, 0, 0])})
    done = measured(field, tmp_path / "m", control=file)
    told = codes(done)["control_left_out"]
    assert told.severity == "fault"
    assert told.ids == ("28",)
    assert told.details[0].values == {"point": "28", "apart_mm": pytest.approx(20.0, abs=0.5)}
    assert not any(n.variant == "no_sigma" for n in done.adjustment.notices)  # the others are as good as ever
    off = done.points.xyz - np.array([truth[n] for n in done.points.ids])
    assert np.sqrt((off**2).mean()) < 1e-4


def test_control_in_a_line_or_another_unit_is_told_with_its_file(field, tmp_path):
    _, truth = field
    file = table(tmp_path / "c.csv", {n: np.array([k, 2.0 * k, 3.0 * k]) for k, n in enumerate(FIVE)})
    with refused("control.points_in_line", file="c.csv", n=5):
        measured(field, tmp_path / "m", control=file)
    with refused("control.other_unit", ratio=pytest.approx(1000, rel=1e-3), units="m for mm"):
        measured(field, tmp_path / "m", control=table(tmp_path / "d.csv", truth, FIVE, (1e-3, 1e-3, 1e-3)))


def test_what_is_asked_of_a_table_that_is_not_given_is_refused(field, tmp_path):
    with refused("lengths.tolerance_without_lengths"):
        measured(field, tmp_path / "m", allowed=(1.0, 0.0))
    with refused("option.needs", setting="by", other="nominal"):
        measured(field, tmp_path / "m", by=("1", "2", "3"))


def lengths(path, truth, *rows):
    """A table of lengths in mm."""
    lines = [
        f"{a},{b},{1000 * float(np.linalg.norm(truth[a] - truth[b])) * factor!r},{sigma}"
        for a, b, factor, sigma in rows
    ]
    path.write_text("\n".join(["from,to,length,sigma", *lines]) + "\n")
    return path


def test_a_length_that_could_find_nothing_controls_no_scale(field, tmp_path):
    _, truth = field
    done = measured(field, tmp_path / "m", lengths=lengths(tmp_path / "l.csv", truth, ("2", "7", 1, 1e9)))
    assert "scale_unchecked" in codes(done)
    done = measured(field, tmp_path / "n", lengths=lengths(tmp_path / "l.csv", truth, ("2", "7", 1, 0.01)))
    assert "scale_checked" in codes(done)


def test_a_bar_or_a_length_given_twice_counts_once(field, tmp_path):
    folder, truth = field
    twice = [bar(truth), bar(truth, "20", "1")]
    done = rb.measure(folder, tmp_path / "m", scale_bar=twice, report=False)
    assert {"scale_unchecked", "given_twice"} <= set(codes(done))
    file = lengths(tmp_path / "l.csv", truth, ("2", "7", 1, ""), ("7", "2", 1, ""), ("3", "9", 1, ""))
    done = measured(field, tmp_path / "n", lengths=file)
    assert len(done.lengths.known) == 2


def test_what_is_wrong_with_a_length_is_told_with_its_place(field, tmp_path):
    _, truth = field
    file = lengths(tmp_path / "l.csv", truth, ("2", "7", 1e-3, ""), ("3", "9", 1e-3, ""))
    with refused("length_test.other_unit", file="l.csv", ratio=pytest.approx(1e-3, rel=1e-3), units="m for mm"):
        measured(field, tmp_path / "m", lengths=file)
    file.write_text("from,to,length\n2,7,1\n2,zz,1\n")
    with refused("length_test.ends_not_measured", file="l.csv", line=3, points=["zz"]):
        measured(field, tmp_path / "m", lengths=file)
    with refused("length_test.same_ends"):
        measured(field, tmp_path / "m", check_length=[("1", "1", 0.5)])
    with refused("scale_bar.sigma_too_large", start="1", end="20", length_m=1e-9, sigma_m=0.01):
        rb.measure(field[0], tmp_path / "m", scale_bar=[("1", "20", 1e-9, 0.01)])
