"""A project has one current result, whichever command made it; earlier ones are kept."""

import json
import shutil

import numpy as np
import pytest

import raybundle as rb
from raybundle.commands.adjust import AdjustSettings, run_adjust
from raybundle.commands.compare import CompareSettings, run_compare
from raybundle.commands.marked_results import write_marked
from raybundle.commands.status import status_of
from raybundle.errors import InputError
from raybundle.measuring.session import given_block, latest_block
from raybundle.results.project_results import base_result, earlier_results, made_of, replacing


def marked(project, *, length=2.0):
    """The project with two points of three marks each and a scale bar between them, adjusted."""
    block = rb.read_block(given_block(project))
    o = block.observations
    rays = np.argsort(-np.bincount(o.point), kind="stable")
    for name, p in (("A", rays[0]), ("B", rays[5])):
        for r in np.flatnonzero(o.point == p)[:4]:
            x, y = o.xy_px[r].tolist()
            rb.mark(project, "put", image=block.images.ids[o.image[r]], point=name, x_px=x, y_px=y)
    rb.mark(project, "bar", start="A", end="B", length=length, sigma=0.001)
    return adjusted(project)


def adjusted(project):
    return write_marked(project, rb.adjust_marks(project)[0], report="none")


def stated(folder):
    return json.loads((folder / "result.json").read_text())


def test_what_is_measured_is_in_the_result_that_every_command_uses(project):
    before = stated(project / "result")
    assert marked(project) == project / "result"
    base = project / "results" / "1-orient"
    assert stated(base) == before
    assert stated(project / "result")["made"] == {"by": "marks", "base": "1-orient"}
    assert "scale" in before["datum_defect"]
    assert "scale" not in stated(project / "result")["datum_defect"]
    assert rb.query(project, distance=("A", "B"))[0].values[0] == pytest.approx(2.0, abs=0.005)
    assert given_block(project) == base / "block" == given_block(project / "result")
    assert latest_block(project) == project / "result" / "block"


def test_marks_are_always_merged_into_the_result_without_marks(project):
    """A bar that is taken back leaves nothing of itself in the next result."""
    before = stated(project / "result")
    marked(project)
    rb.mark(project, "unbar", start="A", end="B")
    rb.mark(project, "forget", point="A")
    rb.mark(project, "forget", point="B")
    adjusted(project)
    after = stated(project / "result")
    assert after["datum_defect"] == before["datum_defect"]
    assert after["image_points"] == before["image_points"]
    assert [p.name for p in earlier_results(project)] == ["2-marks", "1-orient"]


def test_record_language_and_photographs_go_with_the_project(project, photo_folders):
    rb.record(project, client="Monument office")
    file = project / "project.toml"
    file.write_text(file.read_text().replace('language = "en"', 'language = "de"'))
    adjustment = rb.adjust_marks(project)[0]
    write_marked(project, adjustment)
    assert (project / "result" / "report.html").read_text().count("data:image/jpeg") == 1
    assert '<html lang="de"' in (project / "result" / "report.html").read_text()
    assert 'client = "Monument office"' in (project / "result" / "record.toml").read_text()
    assert "[photographs]" in (project / "result" / "record.toml").read_text()
    assert stated(project / "result")["photographs_in"]


def test_a_project_is_adjusted_again_in_its_place(project):
    marked(project)
    run_adjust(AdjustSettings(block=project, reject="snooping", report=False))
    assert made_of(project / "result").by == "adjust"
    assert base_result(project) == project / "results" / "1-orient"
    assert "A" in rb.read_result(project).block.points.ids
    first = run_compare(CompareSettings(first=project, out=project.parent / "page.html")).results[0]
    assert first.path.parent == project / "results"
    names = [k.path.name for k in status_of(project).results]
    assert names[0] == "result"
    assert names[-1] == "1-orient"
    with pytest.raises(InputError) as refused:
        run_adjust(AdjustSettings(block=shutil.copytree(project / "result", project.parent / "alone")))
    assert refused.value.code == "adjustment.out_missing"


def test_the_oldest_make_room_and_the_one_without_marks_stays(project, monkeypatch):
    monkeypatch.setattr("raybundle.results.project_results.MOST", 2)
    marked(project)
    for k in range(3):
        rb.mark(project, "bar", start="A", end="B", length=2.1 + k / 10, sigma=0.001)
        adjusted(project)
    names = [p.name for p in earlier_results(project)]
    assert names == ["4-marks", "3-marks", "1-orient"]


def test_an_adjustment_that_fails_leaves_the_results_as_they_were(project, monkeypatch):
    def broken(*_, **__):
        raise InputError("file.missing", file=project)

    adjustment = rb.adjust_marks(project)[0]
    monkeypatch.setattr("raybundle.report.write.written_folder", broken)
    with pytest.raises(InputError):
        write_marked(project, adjustment)
    assert earlier_results(project) == []
    assert not made_of(project / "result").base


def test_a_further_run_of_orient_adjusts_with_the_marks(project, photo_folders, monkeypatch):
    marked(project)
    photos = sorted(photo_folders[0].glob("*.jpg"))[:5]
    done = rb.orient(photos, project, precise=False, report=False)
    assert stated(project / "result")["made"] == {"by": "orient", "base": "1-orient"}
    assert "scale" not in done.adjustment.datum_defect
    assert rb.query(project, distance=("A", "B"))[0].values[0] == pytest.approx(2.0, abs=0.005)

    def contradict(*_, **__):
        raise InputError("file.missing", file=project)

    monkeypatch.setattr("raybundle.commands.marked_results.adjust_marks_of", contradict)
    done = rb.orient(photos, project, precise=False, report=False)
    assert "marks_not_adjusted" in {n.code for n in done.adjustment.notices}
    assert "scale" in done.adjustment.datum_defect
    assert not made_of(project / "result").base


def test_a_missing_or_damaged_base_is_named_and_orient_mends_it(project, photo_folders):
    marked(project)
    rb.mark(project, "unbar", start="A", end="B")
    base = project / "results" / "1-orient"
    (base / "block" / "block.toml").unlink()
    with pytest.raises(InputError) as refused:
        adjusted(project)
    assert refused.value.code == "project.base_missing"
    shutil.rmtree(base)
    with pytest.raises(InputError) as refused:
        adjusted(project)
    assert refused.value.code == "project.base_missing"
    done = rb.orient(sorted(photo_folders[0].glob("*.jpg"))[:5], project, precise=False, report=False)
    assert "scale" in done.adjustment.datum_defect
    assert adjusted(project) == project / "result"


def test_what_result_json_states_chooses_no_other_folder(project, tmp_path):
    file = project / "result" / "result.json"
    made = {"made": {"by": "x/../../../victim", "base": "../../victim"}}
    file.write_text(json.dumps({**stated(project / "result"), **made}))
    adjusted(project)
    assert {p.name for p in project.parent.iterdir()} == {"photos", "project"}
    assert [p.name for p in earlier_results(project)] == ["1-orient"]


def test_killed_runs_leave_one_copy_and_folders_of_others_stay(project, monkeypatch):
    foreign = project / "results" / "7-orient"
    foreign.mkdir(parents=True)
    (foreign / "notes.txt").write_text("mine")
    monkeypatch.setattr("raybundle.results.project_results.MOST", 1)
    killed = [replacing(project, "marks", marks=True) for _ in range(3)]
    for run in killed:  # between keeping and replacing; what ends them has no say
        run.__enter__()
    assert [p.name for p in earlier_results(project)] == ["8-orient"]
    assert [k.path.name for k in status_of(project).results] == ["result"]
    marked(project)
    for k in range(2):
        rb.mark(project, "bar", start="A", end="B", length=2.1 + k, sigma=0.001)
        adjusted(project)
    assert (foreign / "notes.txt").read_text() == "mine"
    assert base_result(project) == project / "results" / "8-orient"
