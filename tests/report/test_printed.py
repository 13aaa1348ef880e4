"""Values as they are printed: settings as they were typed, numbers of a log, a notice in short, the recording sheet."""

from dataclasses import replace
from html import unescape
from pathlib import Path

from raybundle.adjustment.result import Notice
from raybundle.adjustment.severity import Severity
from raybundle.report.chapters import Occasion
from raybundle.report.delivery import delivery_of
from raybundle.report.document import write_report
from raybundle.report.facts import PhotographFacts, StageFact
from raybundle.report.sections.photographs import processing_section
from raybundle.report.text.front_words import next_steps
from raybundle.report.text.numbers import unbroken
from raybundle.report.text.words import verdict
from raybundle.report.view import view_of
from raybundle.results.record import Record
from raybundle.settings import in_words
from raybundle.workflows.dropped import Dropped

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
    from raybundle.report.languages.language import language_of

    german = language_of("de")
    assert [[german.cell(c) for c in row] for row in shown.rows] == [["pdf", "ja"], ["title", "control"]]


def test_numbers_of_a_log_are_set_as_in_print():
    assert unbroken("in 8% of them, of 12 345 by 2e-04 (-5.4e-04) and 3e+05") == (
        "in 8 % of them, of 12\u202f345 by 2 × 10⁻⁴ (-5.4 × 10⁻⁴) and 3 × 10⁵"
    )
    assert unbroken("t2e-04 and IMG_1e5") == "t2e-04 and IMG_1e5"


def test_what_was_dropped_is_counted_in_sentences():
    dropped = Dropped(features=1000, matched=900, started=800, measured=700, added=100, adjusted=790)
    words = dropped.notice(800).message
    assert "21 % of the image points" in words
    assert "100 that least-squares matching did not measure, 10 that contradict the other rays" in words


def test_a_shortened_notice_ends_in_a_whole_clause():
    long = "x lies 3071 px from where its other measurements put it and is left out"
    message = f"the measurement of point {long}; point b is marked there, {'or elsewhere, ' * 9}not; look at it again"
    adjustment = replace(made("rich"), notices=(Notice(code="gps", message=message, measured=Severity.CAUTION),))
    view = view_of(adjustment)
    ((_, step),) = next_steps(Occasion(view=view, told=verdict(view), delivery=delivery_of(adjustment)))
    assert step.endswith("is left out (…); look at it again.")


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
