"""The order of the report is what its chapters say, and a new one is one function."""

import pytest

from raybundle.report import chapters as rooms
from raybundle.report.chapters import Occasion, chapters, section
from raybundle.report.parts import Paragraph, Section
from raybundle.report.text.words import verdict
from raybundle.report.view import view_of
from raybundle.report.writing import write_report
from tests.report.conftest import free

ORDER = (
    "front", "calibration", "result", "deviations", "length errors", "displacements", "velocities", "summary",
    "photographs", "accuracy", "precision", "noise", "control", "trajectories", "strips", "scenes", "panoramas",
    "interior orientation", "residuals", "reliability", "network", "record", "tables", "settings", "processing",
)  # fmt: skip
LOOKED_UP = {"record", "tables", "settings", "processing"}


def test_chapters_are_read_in_this_order():
    assert tuple(c.name for c in chapters()) == ORDER


def test_each_chapter_has_its_readers():
    assert {c.name for c in chapters() if c.part == "appendix"} == LOOKED_UP
    assert {c.part for c in chapters()} <= {"client", "specialist", "appendix"}


@pytest.fixture
def more(monkeypatch):
    chapters()  # those of the package register themselves once, and not in a copy
    monkeypatch.setattr(rooms, "_chapters", dict(rooms._chapters))


@pytest.mark.usefixtures("more")
def test_a_new_chapter_stands_behind_the_one_that_it_follows_and_in_the_report(tmp_path):
    @section("volumes", after="precision")
    def volumes(view):
        return Section(anchor="volumes", title="Volumes", parts=(Paragraph(text=f"{len(view.given.points)} points"),))

    names = [c.name for c in chapters()]
    assert names[names.index("precision") + 1] == "volumes"
    assert [n for n in names if n != "volumes"] == list(ORDER)
    write_report(free(), tmp_path / "report.html")
    text = (tmp_path / "report.html").read_text()
    assert text.index('id="precision"') < text.index('id="volumes"') < text.index('id="control"')


@pytest.mark.usefixtures("more")
def test_a_chapter_behind_none_is_a_fault_of_the_program():
    section("lost", after="nowhere")(lambda _: None)
    with pytest.raises(TypeError, match=r"\blost\b.*\bnowhere\b"):
        chapters()


def test_what_says_nothing_is_left_out():
    view = view_of(free())
    occasion = Occasion(view=view, reported=verdict(view))
    assert {c.name for c in chapters() if not c.make(occasion)} == {
        "calibration", "displacements", "velocities", "deviations", "length errors", "photographs", "noise",
        "trajectories", "strips", "scenes", "panoramas", "processing", "record",
    }  # fmt: skip
