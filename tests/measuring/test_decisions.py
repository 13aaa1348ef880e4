"""Rejection beyond a limit and parameters free or held: on the command line, in Python, in the next adjustment."""

import os
import shutil

import numpy as np
import pytest
from click.testing import CliRunner

import raybundle as rb
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.cli.main import cli
from raybundle.errors import InputError
from raybundle.measuring.actions.decisions import with_decisions
from raybundle.measuring.journal import entries_of, journal_path, measured_result
from raybundle.measuring.names import Known
from raybundle.measuring.selection import figures_of, figures_of_result, latest_figures, latest_result, selected
from raybundle.measuring.state import EMPTY, State
from raybundle.pipeline.project import photographs_of
from raybundle.report.write import write_result
from raybundle.results.folder import read_result
from raybundle.settings import as_typed
from tests.measuring.scenes import small_block


@pytest.fixture(scope="module")
def adjusted():
    return rb.adjust(small_block())


@pytest.fixture
def folder(adjusted, tmp_path):
    write_result(adjusted, tmp_path / "ring", report="none")
    return tmp_path / "ring"


def run(*words):
    return CliRunner().invoke(cli, [str(w) for w in words], catch_exceptions=True)


def test_a_result_folder_says_the_same_as_the_adjustment(adjusted, folder):
    a, b = figures_of(adjusted), figures_of_result(read_result(folder))
    for name, values in a.values.items():
        np.testing.assert_allclose(values, b.values[name], rtol=1e-4, atol=0.51e-3 if name == "w" else 1e-5)
    assert (a.images, a.points) == (b.images, b.points)
    assert np.array_equal(a.image, b.image)
    assert np.array_equal(a.tie, b.tie)


def test_what_is_rejected_is_looked_up_in_the_later_result(folder):
    """That of what was measured, unless the block itself was adjusted again after."""
    measured = measured_result(folder)
    shutil.copytree(folder, measured)
    toml = folder / "block" / "block.toml", measured / "block" / "block.toml"
    for later in (0, 1):
        for k, file in enumerate(toml):
            os.utime(file, (1000 + (k == later), 1000 + (k == later)))
        assert latest_result(folder) == (folder, measured)[later]


@pytest.mark.parametrize(("quantity", "limit"), [("w", 2.5), ("rays", 4.5), ("redundancy", 0.5)])
def test_one_command_rejects_what_python_finds(folder, quantity, limit):
    rows = selected(latest_figures(folder), EMPTY, quantity, limit).rows
    assert rows
    done = run("mark", "reject", folder, f"--{quantity}", limit)
    assert done.exit_code == 0, done.output
    assert "reject_beyond" in done.output
    assert rb.marks(folder).rejected == set(rows)
    assert rb.mark(folder, "undo") == 2
    assert rb.mark(folder, "reject_beyond", quantity=quantity, limit=limit) == 3
    assert rb.marks(folder).rejected == set(rows)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ((), "[mark.nothing_to_reject]"),
        (("1",), "[mark.nothing_to_reject]"),
        (("--w", "4", "--rays", "3"), "[mark.nothing_to_reject]"),
        (("1", "2", "--w", "4"), "[mark.nothing_to_reject]"),
        (("--w", "1e6"), "[selection.nothing_beyond]"),
    ],
)
def test_rejections_that_cannot_be(folder, words, told):
    done = run("mark", "reject", folder, *words)
    assert done.exit_code
    assert told in str(done.exception) + done.output
    assert entries_of(journal_path(folder)) == []


def test_a_limit_below_zero_is_refused(folder):
    assert "--w" in run("mark", "reject", folder, "--w", "-1").output


def test_quantities_and_rows_that_are_not_there(folder):
    with pytest.raises(InputError, match=r"selection\.unknown_quantity"):
        rb.mark(folder, "reject_beyond", quantity="beauty", limit=1.0)
    with pytest.raises(InputError, match=r"number\.not_finite"):
        rb.mark(folder, "reject_beyond", quantity="w")
    with pytest.raises(InputError, match=r"mark\.no_observation"):
        rb.mark(folder, "reject_beyond", quantity="w", limit=1.0, rows=[("1", "nowhere")])


def test_points_that_have_another_name_since(adjusted):
    f = figures_of(adjusted)
    rows = selected(f, EMPTY, "w", 2.0).rows
    (image, point), *_ = rows
    renamed = State(renamed={point: "gate"})
    assert selected(f, renamed, "w", 2.0).rows[0] == (image, "gate")


def test_the_command_line_follows_the_journal(folder):
    camera = rb.read_block(folder / "block").cameras[0].id
    assert run("mark", "parameter", folder, camera, "P1", "held").exit_code == 0
    assert run("mark", "parameter", folder, camera, "A", "free").exit_code == 0
    assert "P1" in run("mark", "list", folder).output
    adjustment, _ = rb.adjust_marks(folder)
    assert (adjustment.options.hold, adjustment.options.free) == (((camera, "P1"),), ((camera, "A"),))
    parameters = adjustment.interior[0].parameters
    assert (parameters["P1"].status, parameters["A"].status) == ("held", "estimated")
    adjustment, _ = rb.adjust_marks(folder, free=[(camera, "P1")])
    assert adjustment.interior[0].parameters["P1"].status == "estimated"
    done = run("mark", "adjust", folder, "--hold", camera, "K1", "--no-report", "--progress", "none")
    assert done.exit_code == 0, done.output
    told = read_result(folder.with_name("ring-measured")).result["options"]
    assert told["hold"] == [[camera, "K1"], [camera, "P1"]]


def test_what_is_named_goes_before_the_journal():
    state = State(parameters={("a", "K1"): "held", ("a", "K2"): "held", ("b", "K1"): "free"})
    options = with_decisions(AdjustmentOptions(free=(("a", "K1"),)), state)
    assert options.free == (("a", "K1"), ("b", "K1"))
    assert options.hold == (("a", "K2"),)


def test_options_as_they_are_typed():
    options = AdjustmentOptions(
        hold=(("a b", "K1"), ("a", "K2")), datum_points=("1", "2"), robust_start=True, jobs=3, datum="inner"
    )
    assert as_typed(AdjustmentOptions()) == []
    assert as_typed(options) == [
        "--datum", "inner", "--datum-points", "1,2", "--hold", "a b", "K1", "--hold", "a", "K2", "--robust-start",
        "--jobs", "3",
    ]  # fmt: skip


def test_known_pairs(adjusted):
    known = Known.of(adjusted.given)
    assert len(known.pairs()) == len(adjusted.given.observations)
    assert Known.of_photos({"a": (10, 10)}).pairs() == frozenset()


def test_a_result_elsewhere_knows_where_the_photographs_of_its_project_are(adjusted, tmp_path):
    photos = tmp_path / "photos"
    photos.mkdir()
    project = tmp_path / "project"
    write_result(adjusted, project / "result", report="none")
    (project / "project.toml").write_text(f"[orient]\nphotos = ['{photos}']\n")
    out = tmp_path / "elsewhere/scaled"
    out.parent.mkdir()
    made = run("mark", "adjust", project / "result", "--out", out, "--no-report")
    assert made.exit_code == 0, made.output
    assert photographs_of(out) == (photos,)
    photos.rmdir()
    assert photographs_of(out) == ()
