"""The report on paper: every kind of part, every text as it is, pages, bookmarks, fonts."""

import re
import sys
from dataclasses import replace
from datetime import UTC, datetime
from io import BytesIO
from typing import get_args

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.block.folder import write_block
from raybundle.report.chapters import Occasion
from raybundle.report.document import Document, document_of
from raybundle.report.figures.svg import drawing, histogram, label
from raybundle.report.paper import press
from raybundle.report.paper.copy import COPIES, ROOM, STACKED, copy_of, laid_out, part_copies
from raybundle.report.paper.drawings import printed_svg
from raybundle.report.paper.press import BODY, pdf_of
from raybundle.report.parts import (
    Fact,
    Facts,
    Figure,
    Figures,
    Folded,
    Heading,
    Paragraph,
    Part,
    Pointer,
    Section,
    Statements,
    number,
    table,
    text,
    whole,
)
from raybundle.report.text.words import verdict
from raybundle.report.view import view_of
from raybundle.report.write import write_result
from raybundle.report.writing import write_report
from raybundle.words import headline
from tests.report.test_arrangement import client  # noqa: F401  (a fixture)

pypdf = pytest.importorskip("pypdf")
NOW = datetime(2026, 3, 4, 5, 6, tzinfo=UTC)
HOSTILE = (
    "#panic()", "[x](y)", "$x$", "@ref", "// gone", "/* gone */", "\\ \\u{41}", "*b* _i_ `c`", "<label>", "~ -- ---",
    "= no heading", "\"quoted\" 'so'", "#{1+1}", "https://example.org/#x", "& <b>", "+ no list", "1. no list",
)  # fmt: skip
SIGNS = "σ τ χ² ω φ κ σ₀ 10⁻⁵ 18\u202f803 \u22120.5 √ ± × ° µ ≤ … “q” 1 : 5"


def document(*parts, divided=True, title="Title"):
    made = (("specialist", Section(anchor="one", title="First", parts=tuple(parts))),)
    return Document(
        title=title,
        subtitle="about",
        headline="Headline.",
        grade="good",
        made=made,
        divided=divided,
        written=NOW,
    )


def read(pdf):
    return pypdf.PdfReader(BytesIO(pdf))


def words(pdf):
    """The text of a PDF without blanks, as lines may be broken anywhere."""
    return squeezed("".join(p.extract_text() for p in read(pdf).pages))


def squeezed(text_):
    return re.sub(r"[\s\u200b\u00ad]+", "", text_.replace("\u2011", "-"))


EXAMPLES = {
    "Table": table((text("name"), number("value", "mm")), (["first"], ["0.25"]), caption="Caption", note="Noted"),
    "Paragraph": Paragraph(text="A paragraph."),
    "Heading": Heading(text="A heading"),
    "Figures": Figures(figures=(Figure(drawing=drawing(300, 90, [label(9, 9, "drawn")], "seen"), caption="Shown"),)),
    "Facts": Facts(facts=(Fact(label="label", value="7 mm", remark="remark"),)),
    "Statements": Statements(statements=(("word", "A sentence."),)),
    "Folded": Folded(summary="Summary", parts=(Paragraph(text="inside"),)),
    "Pointer": Pointer(anchor="one", number="A1", items=("this", "that")),
}
TOLD = {
    "Table": "namevaluemmfirst0.25", "Paragraph": "Aparagraph.", "Heading": "Aheading", "Figures": "Shown",
    "Facts": "label7mmremark", "Statements": "wordAsentence.", "Folded": "inside", "Pointer": "this;that:A1",
}  # fmt: skip


@pytest.mark.parametrize("kind", get_args(Part), ids=lambda k: k.__name__)
def test_every_kind_of_part_is_printed(kind):
    assert kind in COPIES, f"say in report/paper/copy.py how {kind.__name__} is printed"
    assert TOLD[kind.__name__] in words(pdf_of(document(EXAMPLES[kind.__name__], divided=False)))


def test_a_part_that_paper_does_not_know_is_a_fault_of_the_program():
    class Unknown:
        kind = "unknown"

    with pytest.raises(TypeError, match=r"\bUnknown$"):
        part_copies([Unknown()])


def test_drawings_keep_their_words():
    picture = drawing(300, 90, [label(9, 9, "drawn σ [mm]")], "seen")
    assert "drawnσ[mm]" in words(pdf_of(document(Figures(figures=(Figure(drawing=picture, caption="Shown"),)))))


@pytest.mark.parametrize("hostile", HOSTILE)
def test_no_text_is_read_as_markup(hostile):
    parts = (
        Paragraph(text=f"({hostile})"), Heading(text=hostile), Statements(statements=((hostile, hostile),)),
        Facts(facts=(Fact(label=hostile, value=hostile, remark=hostile),)), Folded(summary=hostile, parts=()),
        table(
            (text(hostile), whole(hostile), number(hostile, hostile)), ([hostile],) * 3, caption=hostile, note=hostile
        ),
        Figures(figures=(Figure(drawing=drawing(200, 90, [label(1, 20, hostile)], hostile), caption=hostile),)),
    )  # fmt: skip
    printed = words(pdf_of(document(*parts, title=hostile)))
    assert printed.count(squeezed(hostile)) >= 12


# everything but what no font of a machine must have: letters of Latin, Greek and Cyrillic, signs, blanks, line breaks
TEXTS = st.text(
    st.one_of(
        st.sampled_from("#[]{}()\\$@/*_`<>~=+-\"'&;:.,\n\t \u202f\u2212\u200f"), st.characters(max_codepoint=0x4FF)
    ),
    max_size=60,
)


@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(TEXTS)
def test_any_text_is_printed(any_text):
    pdf = pdf_of(document(Paragraph(text=any_text), table((text(any_text),), ([any_text],)), title=any_text))
    letters = re.sub(r"[^A-Za-z0-9#\[\]$@]", "", any_text)
    assert len(read(pdf).pages) >= 1
    if any_text.isascii() and any_text.isprintable():
        assert letters in re.sub(r"[^A-Za-z0-9#\[\]$@]", "", words(pdf))


@pytest.mark.parametrize(
    "strange",
    ["half \ud800 character", "nul \x00 and bell \x07", "שלום world", "名前 of a point", "\u202e turned", "a\nb\r\nc"],
)
def test_strange_texts_do_no_harm(strange):
    picture = drawing(200, 90, [label(1, 20, strange)], strange)
    parts = (Paragraph(text=strange), Figures(figures=(Figure(drawing=picture, caption=strange),)))
    assert len(read(pdf_of(document(*parts, title=strange))).pages) == 1


def test_signs_of_the_trade_have_their_glyphs():
    pdf = pdf_of(document(Paragraph(text=SIGNS), Heading(text=SIGNS), table((text(SIGNS),), ([SIGNS],))))
    assert words(pdf).count(squeezed(SIGNS)) == 4
    fonts = {
        str(font["/BaseFont"])
        for page in read(pdf).pages
        for font in (f.get_object() for f in page["/Resources"]["/Font"].values())
    }
    assert fonts
    assert all(re.match(r"/[A-Z]{6}\+(Libertinus|NewCM|NewComputerModern|DejaVu)", f) for f in fonts), fonts


def test_pages_have_heads_numbers_and_bookmarks(case):
    view = view_of(case("rich"))
    made = document_of(Occasion(view=view, reported=verdict(view), appendix="short"))
    reader = read(pdf_of(made))
    count = len(reader.pages)
    for k, page in enumerate(reader.pages, 1):
        told = squeezed(page.extract_text())
        assert squeezed(made.title) in told
        assert squeezed(made.when) in told
        assert f"page{k}of{count}" in told
        assert [round(float(v)) for v in page.mediabox] == [0, 0, 595, 842]
    assert reader.metadata.title == made.title

    def titles(outline):
        return [t for o in outline for t in (titles(o) if isinstance(o, list) else [squeezed(o.title)])]

    marks = titles(reader.outline)
    for division in made.divisions():
        assert squeezed(division.title) in marks
    assert "1Result" in marks
    assert any(re.fullmatch(r"A\d+Coordinatesandorientations", m) for m in marks)


@pytest.mark.parametrize("name", ["rich", "two_cameras", "without_statistics"])
def test_no_more_than_six_pages_stand_before_the_appendix(case, name):
    view = view_of(case(name))
    pages = read(pdf_of(document_of(Occasion(view=view, reported=verdict(view), appendix="short")))).pages
    first = next(k for k, p in enumerate(pages) if "APPENDIX" in p.extract_text())
    assert first <= BODY
    alone = read(pdf_of(document_of(Occasion(view=view, reported=verdict(view))))).pages
    assert len(alone) <= BODY
    assert "report.html" in alone[-1].extract_text()


def test_a_calibration_begins_with_its_verdict(case, tmp_path):
    from raybundle.calibration.quality import calibration_qualities

    a = case("rich")
    qualities = tuple(calibration_qualities(a))
    write_report(a, tmp_path / "r.pdf", qualities=qualities)
    reader = pypdf.PdfReader(tmp_path / "r.pdf")
    assert reader.metadata.title == "Calibration"
    first, second = (squeezed(reader.pages[k].extract_text()) for k in (0, 1))
    assert squeezed(qualities[0].headline) in first
    assert squeezed(f"1{headline('calibration_quality.title', {})}") in second


@pytest.mark.usefixtures("client")
def test_the_client_has_a_page_of_its_own(case):
    view = view_of(case("rich"))
    made = document_of(Occasion(view=view, reported=verdict(view)))
    pages = [squeezed(p.extract_text()) for p in read(press._set(copy_of(made))).pages]
    assert "Whatwasaskedfor" in pages[0]
    assert "Itholds." in pages[0]
    assert squeezed(made.headline) in pages[0]
    assert "1Result" not in pages[0]
    assert "FORTHESPECIALIST" in pages[1]


def test_tables_break_with_their_heads_and_lose_no_row():
    for count, most in ((STACKED, 60), (3 * STACKED, 9)):
        ids = [f"p-{k}" for k in range(count)]
        body = table((text("point"), text("what it is like"), number("X", "m")), (ids, ["word " * most] * count, ids))
        reader = read(pdf_of(document(body, divided=False)))
        pages = [squeezed(p.extract_text()) for p in reader.pages]
        assert len(pages) > 1
        assert all("whatitislike" in p for p in pages)
        told = re.findall(r"p-\d+?(?=p-|word|raybundle|point|what|$)", "".join(pages))
        assert sorted(told) == sorted(2 * ids)


def test_a_marked_row_of_a_long_table_is_red():
    ids = [f"p{k}" for k in range(2 * STACKED)]
    plain, marked = (pdf_of(document(table((text("point"),), (ids,), marked=m), divided=False)) for m in ((), (7,)))
    red = b"0.70980394 0.3254902 0.16470589"
    assert [red in b"".join(p.get_contents().get_data() for p in read(f).pages) for f in (plain, marked)] == [
        False,
        True,
    ]


@pytest.mark.parametrize("columns", [1, 3, 9, 16, 30])
@pytest.mark.parametrize("length", [2, 20, 200])
def test_every_table_fits_the_page(columns, length):
    cells = [["word " * (length // 5) if k % 3 == 0 else "1" * min(length, 9)] * 4 for k in range(columns)]
    made = table(tuple(text("name") if k % 3 == 0 else number("value", "mm") for k in range(columns)), cells)
    laid = laid_out(made)
    assert sum(laid.widths) * laid.size <= ROOM + 1e-6
    assert min(laid.widths) > 0


def test_a_long_name_of_a_camera_takes_two_lines_at_most():
    name = "Canon EOS 5D Mark III-24mm"
    made = table(
        (text("camera"), *(number(f"value {k}", "mm") for k in range(9)), text("remark")),
        ([name], *[["-0.12345"]] * 9, ["a sentence about this camera that goes on and on " * 4]),
    )
    assert laid_out(made).widths[0] >= 0.45 * len(name)


def test_drawings_look_on_paper_as_on_a_page():
    """Lines in tenths of a pixel keep their width; no variable is left, nor what a printer of SVG does not know."""
    from raybundle.report.figures.svg import vectors

    one = np.ones(1)
    svg = printed_svg(drawing(100, 100, [vectors(one, one, one, one, "vector bold")], "x"))
    assert 'class="vector bold" transform="scale(.1)" style="stroke-width:16"' in svg
    assert "var(" not in svg
    assert "vector-effect" not in svg
    assert svg.startswith('<svg xmlns="http://www.w3.org/2000/svg"')


def test_the_same_report_gives_the_same_bytes():
    made = document(
        Figures(figures=(Figure(drawing=histogram(__import__("numpy").arange(9.0), "x", "y"), caption="."),))
    )
    assert pdf_of(made) == pdf_of(made)


def test_without_the_typesetter_it_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "typst", None)
    with pytest.raises(InputError, match=r"package\.typst_missing"):
        pdf_of(document())


def test_writing_by_the_name_of_the_file(case, tmp_path):
    write_report(case("free"), tmp_path / "r.PDF")
    assert (tmp_path / "r.PDF").read_bytes().startswith(b"%PDF")
    write_report(case("free"), tmp_path / "r.html")
    assert (tmp_path / "r.html").read_text(encoding="utf-8").lstrip().startswith("<!DOCTYPE html>")


@pytest.mark.parametrize("report", ["html", "none"])
def test_a_result_folder_holds_what_was_asked(case, tmp_path, report):
    for pdf in (True, False):  # what an older result held is gone
        write_result(case("free"), tmp_path / "out", report=report, pdf=pdf)
        found = {p.name for p in (tmp_path / "out").iterdir()}
        assert ("report.pdf" in found) == pdf
        assert ("report.html" in found) == (report == "html")


def test_the_command_line_asks_for_it(case, tmp_path, capsys):
    write_block(case("free").given, tmp_path / "block")
    status = main(["adjust", str(tmp_path / "block"), "--out", str(tmp_path / "out"), "--pdf", "--no-report"])
    assert status == 0
    assert "report.pdf" in capsys.readouterr().out
    assert (tmp_path / "out" / "report.pdf").is_file()
    assert not (tmp_path / "out" / "report.html").exists()


def specialist(copy):
    return next(d for d in copy["divisions"] if d["name"] == "specialist")


def test_a_report_too_long_gives_up_figures_before_rows(case, monkeypatch):
    tried = []
    view = view_of(case("rich"))
    made = document_of(Occasion(view=view, reported=verdict(view)))

    def pages(copy):
        shown = sum(q["kind"] == "figures" for s in specialist(copy)["sections"] for q in s["parts"])
        tried.append(shown)
        return 5 if shown <= 3 else 7

    monkeypatch.setattr(press, "body_pages", pages)
    body = specialist(press.fitted(made))
    assert sum(q["kind"] == "figures" for s in body["sections"] for q in s["parts"]) == 3
    assert tried[0] == max(tried)
    assert len(tried) < 15


def test_a_report_that_cannot_be_short_is_whole(case, monkeypatch):
    view = view_of(case("rich"))
    made = replace(document_of(Occasion(view=view, reported=verdict(view))), written=NOW)
    monkeypatch.setattr(press, "body_pages", lambda _: BODY + 1)
    assert specialist(press.fitted(made))["sections"]
