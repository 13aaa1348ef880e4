"""The three parts of a report: what stands where, and that nothing gets lost between them."""

import re

import numpy as np
import pytest

from raybundle import words
from raybundle.adjustment.records.notice import Notice
from raybundle.report import chapters as rooms
from raybundle.report.arrangement import LONG, Measure, all_sections, arranged, rows_of_figures, undivided
from raybundle.report.chapters import Occasion, chapter
from raybundle.report.document import document_of
from raybundle.report.figures.svg import drawing
from raybundle.report.paper.copy import part_copies
from raybundle.report.parts import (
    PRINTED,
    Fact,
    Facts,
    Figure,
    Figures,
    Folded,
    Heading,
    Paragraph,
    Pointer,
    Section,
    number,
    on_a_page,
    table,
    text,
)
from raybundle.report.sections.result import result_section
from raybundle.report.sections.tables import tables_section
from raybundle.report.text.words import verdict
from raybundle.report.view import view_of
from raybundle.report.writing import write_report
from tests.report.conftest import rich


def rows(count, **more):
    return table(
        (text("name"), number("value")), ([f"n{k}" for k in range(count)], [str(k) for k in range(count)]), **more
    )


def figure(*, first=False):
    return Figures(figures=(Figure(drawing=drawing(300, 200, ["<g/>"], "a drawing"), caption="Drawn."),), first=first)


def section(anchor, *parts):
    return Section(anchor=anchor, title=anchor.capitalize(), parts=parts)


def flat(parts):
    """Parts with those that are folded."""
    for p in parts:
        yield from (flat(p.parts) if isinstance(p, Folded) else (p,))


def test_sections_are_numbered_by_their_part():
    made = (
        ("specialist", section("one", rows(LONG + 1))),
        ("appendix", section("points")),
        ("client", section("front")),
        ("specialist", section("two")),
        ("specialist", section("three", Folded(summary="more", parts=(rows(1),)))),
        ("specialist", section("four", Paragraph(text="."), rows(LONG + 1))),
    )
    client, body, appendix = arranged(made)
    assert [(p.number, p.section.anchor) for p in client.sections] == [("", "front")]
    assert [(p.number, p.section.anchor) for p in body.sections] == [("1", "two"), ("2", "four")]
    # of what nothing is read where it stands is no chapter for the specialist
    assert [(p.number, p.section.anchor) for p in appendix.sections] == [
        ("A2", "four-appendix"), ("A3", "one-appendix"), ("A4", "three-appendix"), ("A5", "points"),
    ]  # fmt: skip


def test_a_heading_above_nothing_but_its_own_name_is_left_out():
    parts = (
        Paragraph(text="."), Heading(text="Left out"), rows(LONG + 1), Heading(text="Where"), figure(),
        Heading(text="More"), Folded(summary="Held", parts=(rows(2),)), Heading(text="Last: 4 px"), rows(LONG + 1),
    )  # fmt: skip
    body, _ = arranged([("specialist", section("one", *parts))], Measure(figures=frozenset()))
    told = [p.text if not isinstance(p, Pointer) else p.items for p in body.sections[0].section.parts]
    assert told == [
        ".",
        (f"Left out, {LONG + 1} rows", "Where, 1 figure"),
        "More",
        ("Held",),
        "Last: 4 px",
        (f"Last, {LONG + 1} rows",),
    ]


def test_what_is_folded_or_long_is_looked_up_and_named_where_it_was():
    parts = (
        Heading(text="Control"), rows(LONG), rows(LONG + 1), Folded(summary="Held", parts=(rows(2),)),
        Paragraph(text="."),
    )  # fmt: skip
    body, appendix = arranged([("specialist", section("one", *parts))])
    kinds = [p.kind for p in body.sections[0].section.parts]
    assert kinds == ["heading", "table", "pointer", "paragraph"]
    (pointer,) = [p for p in body.sections[0].section.parts if isinstance(p, Pointer)]
    assert pointer.items == (f"Control, {LONG + 1} rows", "Held")
    assert (pointer.number, pointer.anchor) == (appendix.sections[0].number, appendix.sections[0].section.anchor)
    assert [p.summary for p in appendix.sections[0].section.parts] == list(pointer.items)


def test_a_part_without_sections_is_left_out():
    assert [d.name for d in arranged([("specialist", section("one"))])] == ["specialist"]
    assert [d.title for d in undivided([section("one")])] == [""]


def test_warnings_stay_however_many_they_are(case):
    from dataclasses import replace

    notices = tuple(Notice(code="not_determinable", message=f"warning {k}") for k in range(3 * LONG))
    view = view_of(replace(case("rich"), notices=notices))
    made = [("specialist", result_section(view, verdict(view)))]
    for measure in (None, Measure(rows=0, figures=frozenset())):
        body = arranged(made, measure)[0].sections[0].section
        told = [row[1] for p in body.parts if p.kind == "table" for row in p.rows]
        assert told == [n.text for n in notices]


def test_figures_that_come_first_stay_longest():
    sections = (section("one", figure(), figure()), section("two", figure(), figure(first=True)))
    assert rows_of_figures(sections) == [(1, 1), (0, 0), (1, 0), (0, 1)]
    body, _ = arranged([("specialist", s) for s in sections], Measure(figures=frozenset({0})))
    assert [[p.kind for p in s.section.parts] for s in body.sections] == [["pointer", "figures"]]


def test_nothing_is_lost_whatever_the_measure(any_case):
    view = view_of(any_case)
    made = [(c.part, s) for c in rooms.chapters() for s in c.make(Occasion(view=view, reported=verdict(view)))]
    for measure in (Measure(), Measure(rows=5, figures=frozenset({0, 2, 3})), Measure(rows=0, figures=frozenset())):
        everything_is_there(made, measure)


def everything_is_there(made, measure):
    before = [p for _, s in made for p in flat(s.parts)]
    after = [p for s in all_sections(arranged(made, measure)) for p in flat(s.section.parts)]
    assert sorted(str(type(p)) for p in after if not isinstance(p, Pointer | Heading)) == sorted(
        str(type(p)) for p in before if not isinstance(p, Heading)
    )
    placed = [p for s in all_sections(arranged(made, measure)) for p in s.section.parts]
    said = [p.text for p in after if isinstance(p, Heading)] + [p.summary for p in placed if isinstance(p, Folded)]
    for p in before:
        assert not isinstance(p, Heading) or any(w.startswith(p.text) for w in said)
    rows_before = sum(len(p.rows) for _, s in made for p in flat(s.parts) if p.kind == "table")
    assert sum(len(p.rows) for p in after if p.kind == "table") == rows_before


@pytest.fixture
def client(monkeypatch):
    """A page for the client, made for this test."""
    rooms.chapters()  # those of the package register themselves once, and not in a copy
    monkeypatch.setattr(rooms, "_chapters", dict(rooms._chapters))
    monkeypatch.setitem(rooms._chapters, "front", None)
    del rooms._chapters["front"]

    @chapter("front", after="", part="client")
    def front(_):
        facts = Facts(facts=(Fact(label="works", value="yes"),))
        return (Section(anchor="front", title="What was asked for", parts=(facts, Paragraph(text="It holds."))),)

    return front


@pytest.mark.usefixtures("client")
def test_the_clients_part_comes_first_and_takes_no_number(tmp_path):
    a = rich()
    view = view_of(a)
    document = document_of(Occasion(view=view, reported=verdict(view)))
    names = [d.name for d in document.divisions()]
    assert names == ["client", "specialist", "appendix"]
    assert [p.number for p in document.divisions()[1].sections][:2] == ["1", "2"]
    write_report(a, tmp_path / "report.html")
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert page.index('id="front"') < page.index('id="result"') < page.index('id="tables"')
    contents = page.partition("<nav")[2].partition("</nav>")[0]
    titles = [words.headline("report_page.division", {"name": name}) for name in names]
    assert re.findall(r'class="division"><a[^>]*>([^<]*)', contents) == titles


def test_points_stand_in_natural_order_and_all_where_asked(case, monkeypatch):
    from raybundle.report.sections import tables

    monkeypatch.setattr(tables, "MOST_ROWS", 7)
    view = view_of(case("rich"))
    few, every = (tables_section(view, every_point=a).parts[0].parts[0] for a in (False, True))
    ids = [row[0] for row in every.rows]
    assert ids == sorted(view.given.points.ids, key=int)
    assert [row[0] for row in few.rows] == ids[:7]
    assert "points.csv" in few.note
    assert not every.note
    at = {i: k for k, i in enumerate(view.adjusted.points.ids)}
    X = [float(row[2].replace("\u2212", "-")) for row in every.rows]
    assert np.allclose(X, view.adjusted.points.xyz[[at[i] for i in ids], 0], atol=1e-5)


def test_paper_holds_a_page_of_points_with_the_known_and_the_worst(case):
    from dataclasses import replace

    view = view_of(case("rich"))
    count = len(view.adjusted.points)
    table_ = tables_section(view).parts[0].parts[0]
    with pytest.MonkeyPatch.context() as patch:
        from raybundle.report.sections import tables

        patch.setattr(tables, "PRINTED", 12)
        shorter = tables_section(view).parts[0].parts[0]
        every = tables_section(view, every_point=True).parts[0].parts[0]
    assert count > 12
    assert table_.printed is None or len(table_.printed.rows) <= PRINTED
    assert every.printed is None
    assert len(shorter.rows) == count
    assert len(shorter.printed.rows) == 12
    assert "12 of" in shorter.printed.note
    assert "points.csv" in shorter.printed.note
    worst = int(np.argmax(np.square(np.nan_to_num(view.std)).sum(axis=1)))
    names = [row[0] for row in shorter.printed.rows]
    assert view.given.points.ids[worst] in names
    assert any(row[1] == "control" for row in shorter.printed.rows)
    (copied,) = part_copies((shorter,))
    assert len(copied["rows"]) == 12
    assert replace(shorter, printed=None).rows == shorter.rows


def test_a_long_list_is_printed_in_part_and_a_short_one_whole():
    long = rows(10 * PRINTED, marked=(0, 5))
    thin = on_a_page(long, range(0, 10 * PRINTED, 10), "some")
    assert [len(thin.rows), len(thin.printed.rows), thin.printed.note] == [10 * PRINTED, PRINTED, "some"]
    assert thin.printed.marked == {0}
    assert on_a_page(rows(PRINTED), (), "").printed is None
