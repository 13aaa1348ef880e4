"""The report: one HTML file with everything in it, written from an adjustment."""

from __future__ import annotations

from datetime import UTC, datetime
from functools import cache
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined

from raybundle.adjustment.result import Adjustment
from raybundle.calibration.quality import CalibrationQuality
from raybundle.io.folders import new_files
from raybundle.numerics.progress import Progress, silent
from raybundle.report.chapters import Occasion, chapters
from raybundle.report.facts import PhotographFacts
from raybundle.report.parts import Section
from raybundle.report.sections.calibration import graver, headline, worst
from raybundle.report.text.words import unsettled, verdict
from raybundle.report.view import view_of


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


def page(*, title: str, subtitle: str, headline: str, grade: str, sections: tuple[Section, ...]) -> str:
    """A whole HTML page with a table of contents."""
    context: dict[str, Any] = {
        "title": title,
        "subtitle": subtitle,
        "headline": headline,
        "grade": grade,
        "sections": sections,
        "written": datetime.now(UTC).astimezone().strftime("%Y-%m-%d %H:%M"),
    }
    return environment().get_template("page.html.j2").render(context)


def write_report(
    adjustment: Adjustment,
    path: str | Path,
    progress: Progress = silent,
    photographs: PhotographFacts | None = None,
    qualities: tuple[CalibrationQuality, ...] = (),
) -> None:
    """Write report.html: one file that needs no other, no network and no font.

    adjustment   any result: without statistics, control or redundancy the parts that need them say so
    path         the file; its folder exists; an older file is overwritten
    photographs  what is known of the photographs that the adjustment comes from; None: those sections are left out
    qualities    verdicts on calibrated cameras; they come first then

    Long tables and dense figures are thinned evenly and say so; the result folder's tables hold every row.
    """
    view = view_of(adjustment)
    told = verdict(view)
    occasion = Occasion(view=view, told=told, photographs=photographs, qualities=qualities)
    sections: list[Section] = []
    every = chapters()
    for k, chapter in enumerate(every):
        progress(f"report: {chapter.name}", k / len(every))
        sections += chapter.make(occasion)
    block = adjustment.given
    html = page(
        title=f"Adjustment of {block.name}" if not qualities else "Calibration",
        subtitle=block.about or block.source,
        headline=told.headline if not qualities else headline(qualities) + unsettled(view),
        grade=told.grade if not qualities else graver(told.grade if unsettled(view) else "good", worst(qualities)),
        sections=tuple(sections),
    )
    with new_files(Path(path)) as (file,):
        file.write_text(html, encoding="utf-8")
    progress("report", 1.0)
