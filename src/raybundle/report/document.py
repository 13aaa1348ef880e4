"""The report: one HTML file with everything in it, and one PDF, written from an adjustment."""

from __future__ import annotations

from dataclasses import dataclass, field
from datetime import UTC, datetime
from functools import cache

from jinja2 import Environment, PackageLoader, StrictUndefined

from raybundle.errors import joined_texts, phrase
from raybundle.numerics.progress import Progress, silent
from raybundle.report.arrangement import Division, Measure, PartName, arranged, undivided
from raybundle.report.chapters import Occasion, chapters
from raybundle.report.languages import ENGLISH
from raybundle.report.languages.language import Language, language_of
from raybundle.report.languages.setting import section_in
from raybundle.report.parts import Section, Table
from raybundle.report.sections.calibration import headline
from raybundle.report.text.front_words import grade_of, not_kept, title_of
from raybundle.report.text.widths import least_width
from raybundle.report.text.words import unsettled

PDF = ".pdf"


@cache
def environment() -> Environment:
    """The templates of the package; every text is escaped, a missing name is an error."""
    return Environment(
        loader=PackageLoader("raybundle.report", "templates"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class Document:
    """A report before it is set: what pages and paper have in common."""

    title: str
    subtitle: str
    headline: str
    grade: str
    made: tuple[tuple[PartName, Section], ...]
    """the sections in the order of their chapters, and who reads each"""
    divided: bool = True
    """whether it has the three parts of a report"""
    appendix: bool = True
    """whether it is printed"""
    language: Language = field(default_factory=Language)
    """in which its texts are"""
    written: datetime = field(default_factory=lambda: datetime.now(UTC).astimezone())

    def divisions(self, measure: Measure | None = None) -> tuple[Division, ...]:
        """Its parts; `measure`: how much of the specialist's stands in the appendix."""
        if not self.divided:
            return undivided(s for _, s in self.made)
        return arranged(self.made, measure, self.language.text)

    @property
    def contents(self) -> str:
        """Heading of its list of sections."""
        return self.language.text(phrase("report_page.contents"))

    def name_of(self, table: Table) -> str:
        """A name of a table for those who do not see it."""
        columns = [c.label for c in table.columns if c.label]
        return table.caption or self.language.text(phrase("report_page.table", columns=columns))

    @property
    def when(self) -> str:
        """When it was written, in words."""
        return self.language.moment(self.written)


def page(
    *, title: str, subtitle: str, headline: str, grade: str, sections: tuple[Section, ...], language: str = ENGLISH
) -> str:
    """A whole HTML page of one part, with a table of contents."""
    say = language_of(language)
    made: tuple[tuple[PartName, Section], ...] = tuple(("specialist", section_in(s, say)) for s in sections)
    return html(
        Document(
            title=say.text(title), subtitle=say.text(subtitle), headline=say.text(headline), grade=grade, made=made,
            divided=False, language=say,
        )
    )  # fmt: skip


def html(document: Document) -> str:
    """A document as one HTML page that needs no other file."""
    return (
        environment()
        .get_template("page.html.j2")
        .render(document=document, divisions=document.divisions(), least_width=least_width)
    )


def document_of(occasion: Occasion, progress: Progress = silent) -> Document:
    """The report of an adjustment: every chapter that has something to say, in its part."""
    say = occasion.language
    made: list[tuple[PartName, Section]] = []
    every = chapters()
    for k, chapter in enumerate(every):
        progress(f"report: {chapter.name}", k / len(every))
        made.extend((chapter.part, section_in(section, say)) for section in chapter.make(occasion))
    block, reported, qualities = occasion.view.adjustment.given, occasion.reported, occasion.qualities
    head = joined_texts(headline(qualities), *unsettled(occasion.view)) if qualities else reported.headline
    return Document(
        title=say.text(title_of(occasion)),
        subtitle=block.about or block.source,
        headline=say.text(joined_texts(head, *not_kept(occasion))),
        grade=grade_of(occasion),
        made=tuple(made),
        appendix=occasion.appendix != "none",
        language=say,
    )
