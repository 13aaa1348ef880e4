"""Values as they are printed: settings as they were typed, numbers of a log, a notice in short, the recording sheet."""

from dataclasses import replace
from html import unescape
from pathlib import Path

import numpy as np
import pytest

from raybundle import words
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.errors import phrase
from raybundle.metrology.congruence import Congruence
from raybundle.report.chapters import Occasion
from raybundle.report.delivery import delivery_of
from raybundle.report.facts import PhotographFacts, StageFact
from raybundle.report.languages.language import language_of
from raybundle.report.moved import write_moved_report
from raybundle.report.sections.photographs import processing_section
from raybundle.report.text.front_words import next_steps
from raybundle.report.text.numbers import unbroken
from raybundle.report.text.widths import broken, kept_together
from raybundle.report.text.words import verdict
from raybundle.report.view import view_of
from raybundle.report.writing import write_report
from raybundle.results.record import Record
from raybundle.settings import in_words
from raybundle.words.render import Reader
from raybundle.workflows.orienting.excluded_features import Dropped

from .conftest import made


def test_settings_are_printed_as_they_were_typed():
    assert in_words((Path("folder/marks.csv"), Path("more.csv"))) == "marks.csv more.csv"
    assert in_words((("M1", "M5", 20.4, 0.005), ("M2", "M3", 3.0, 0.01))) == "M1 M5 20.4 0.005; M2 M3 3 0.01"
    assert [in_words(v) for v in (True, False, 2.0, 1e-4, 3, "de", None)] == [
        "yes",
        "no",
        "2",
        "0.0001",
        "3",
        "de",
        "None",
    ]


def test_settings_of_a_run_speak_the_language_of_the_report(tmp_path):
    stage = StageFact(
        name="photographs", seconds=1.0, cpu_seconds=1.0, peak_memory_mb=10.0, from_cache=False, summary=""
    )
    facts = PhotographFacts(photographs=(), cameras=(), refused=(), not_oriented=(), pairs=(), stages=(stage,),
                            settings=(("pdf", in_words(True)), ("title", "control")))  # fmt: skip
    (_, _, shown) = processing_section(facts).parts
    german = language_of("de")
    assert [[german.cell(c) for c in row] for row in shown.rows] == [["pdf", "ja"], ["title", "control"]]


def test_numbers_of_a_log_are_set_as_in_print():
    assert unbroken("in 8%, 12 345 by 2e-04 (-5.4e-04), 3e+05") == (
        "in 8 %, 12\u202f345 by 2 × 10⁻⁴ (-5.4 × 10⁻⁴), 3 × 10⁵"
    )
    assert unbroken("t2e-04 and IMG_1e5") == "t2e-04 and IMG_1e5"


def test_what_was_dropped_is_counted_in_sentences():
    dropped = Dropped(features=1000, matched=900, started=800, measured=700, added=100, adjusted=790)
    found = dropped.notice(800).values
    assert found["share"] == pytest.approx(0.21)
    assert (found["not_measured"], found["contradict_others"]) == (100, 10)


@pytest.mark.parametrize("language", ["en", "de"])
def test_a_step_is_what_happened_and_the_remedy(language):
    (values,) = [words.examples("scale_unchecked")]
    notice = Notice(code="scale_unchecked", values=values, measured=Severity.WARNING)
    adjustment = replace(made("rich"), notices=(notice,))
    view = view_of(adjustment)
    occasion = Occasion(
        view=view, reported=verdict(view), delivery=delivery_of(adjustment), language=language_of(language)
    )  # fmt: skip
    ((_, step),) = next_steps(occasion)
    head, do, why = (
        unbroken(part("scale_unchecked", values, Reader(language)))
        for part in (words.headline, words.action, words.why)
    )
    assert step == f"{head} {do}".strip()
    assert not why or why not in step


def test_entries_of_the_recording_sheet_are_translated(tmp_path):
    adjustment = made("rich")
    record = Record(title="Mill", kind="mill", conditions="rain", control="tape", reference="12-7", archive="town")
    delivery = delivery_of(adjustment, record=record)
    write_report(adjustment, tmp_path / "r.html", delivery=delivery, language="de")
    page = unescape((tmp_path / "r.html").read_text(encoding="utf-8"))
    sheet = page[page.index("Dokumentationsblatt", page.index('id="record"')) :]
    for label in ("Titel", "Art", "Bedingungen", "Passpunkte und Maßstab", "Nachweise", "Archiv"):
        assert f">{label}<" in sheet
    for name in ("conditions", "reference", "control"):
        assert f">{name}<" not in sheet


def test_words_are_divided_where_they_may_be_and_names_behind_a_hyphen():
    soft, cut = "\u00ad", "\u200b"
    assert broken(f"Standard{soft}ab{soft}weichung", 4.5) == f"Standard{soft}ab{soft}weichung"
    name = "kodak-z612-zoom-digital-camera-5.85mm"
    lines = broken(name, 9.0).split(cut)
    assert len(lines) > 1
    assert "".join(lines) == name
    assert all(line.endswith("-") for line in lines[:-1])
    assert lines[-1].endswith("5.85mm")
    assert broken("x" * 40, 5.0).replace(cut, "") == "x" * 40
    assert cut in broken("x" * 40, 5.0)


def test_headings_of_german_columns_can_be_divided():
    german = language_of("de")
    for code in ("label.coordinate", "label.residual", "report_interior.determinability"):
        made = german.heading(phrase(code))
        assert max(len(part) for part in made.replace(" ", "\u00ad").split("\u00ad")) <= 9


def test_a_unit_stays_with_its_value():
    assert kept_together("4.000 µm, 8 % of 12 px, 3 minutes, 4 m²") == (
        "4.000\u00a0µm, 8\u00a0% of 12\u00a0px, 3 minutes, 4 m²"
    )


def test_a_client_has_one_page_however_many_warnings(case, tmp_path):
    pypdf = pytest.importorskip("pypdf")
    notices = tuple(
        Notice(code="gps", message=f"warning {k} " + "says a good deal of what is weaker in this " * 7, measured=c)
        for k in range(9) for c in (Severity.WARNING,)
    )  # fmt: skip
    adjustment = replace(case("rich"), notices=notices)
    delivery = replace(delivery_of(adjustment), files=("points.csv", "block"))
    write_report(adjustment, tmp_path / "r.pdf", delivery=delivery)
    pages = ["".join(p.extract_text().split()) for p in pypdf.PdfReader(tmp_path / "r.pdf").pages]
    heading, more = words.headline("front.handed_over", {}), words.headline("front.more_matters", {"n": 7})
    assert heading in pages[0]
    assert "".join(more.partition(" ")[2].split()) in pages[0]
    assert "FORTHESPECIALIST" in pages[1]


def test_a_global_test_that_fails_says_by_which_factor(tmp_path):
    rng, n = np.random.default_rng(3), 8
    covariance = np.broadcast_to(1e-10 * np.eye(3), (1, n, 3, 3))
    done = Congruence(
        epochs=("m1", "m2"), ids=tuple(f"p{k}" for k in range(n)), xyz=rng.normal(size=(n, 3)), moved=np.zeros(n, bool),
        displacement=1e-5 * rng.normal(size=(1, n, 3)), covariance=covariance, statistic=np.ones(n), p_value=np.ones(n),
        limit=0.05 / n, detectable=np.full(n, 1e-4), before=(1.44, 0.024), after=(1.44, 0.024), freedom=500.0,
        significance=0.05, scale=False, transforms=(),
    )  # fmt: skip
    told = {}
    for code in ("en", "de"):
        write_moved_report(done, (tmp_path / "m.html",), code)
        told[code] = unescape((tmp_path / "m.html").read_text(encoding="utf-8"))
    values = {"f": 1.44, "p": 0.024, "factor": 1.2}
    for code, page in told.items():
        assert words.sentences("report_moved.inconsistent", values, Reader(code)) in page
