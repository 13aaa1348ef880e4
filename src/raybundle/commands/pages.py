"""Settings of what a command writes for people to read, as several commands share them."""

from __future__ import annotations

from pathlib import Path
from typing import Protocol

from raybundle.report.languages import ENGLISH, checked_language, language_codes
from raybundle.report.paper.needed import check_typesetter

NO_REPORT_HELP = "Leave out report.html and network.html."
TABLES_HELP = (
    "Format of the tables. csv; parquet (with pyarrow). auto: CSV, but Parquet for tables with more rows than a "
    "spreadsheet holds (1 048 575), if pyarrow is installed."
)
PDF_HELP = "Write the report as report.pdf: A4, with page numbers and bookmarks. Also possible without report.html."
LANGUAGE_HELP = f"Language of the report: {', '.join(language_codes())}. Tables and result.json stay English."
PROJECT_LANGUAGE_HELP = f"{LANGUAGE_HELP}  [default: that of the project, else en]"
PROJECT_FILE, SECTIONS = "project.toml", ("orient", "calibrate")
"""Where a project states in which language its reports are"""
APPENDIX_HELP = (
    "Appendix of report.pdf. none; short: all but most of many object points; all: every object point, in report.html "
    "too. report.html always has the short one."
)


class Pages(Protocol):
    """Settings of the pages that a command writes."""

    @property
    def pdf(self) -> bool:
        """Whether the pages are also printed, as report.pdf or surface.pdf."""
        ...

    @property
    def language(self) -> str:
        """Of the pages."""
        ...


def check_pages(settings: Pages) -> None:
    """Raise InputError, before anything is computed, for a report that cannot be written: its language, the PDF."""
    if settings.language:
        checked_language(settings.language)
    if settings.pdf:
        check_typesetter()


def language_in(folder: Path | None, given: str = "") -> str:
    """Of the pages: as asked for, else that of the current result of the project, or of the settings of the project.

    raises  InputError for a language that there is not
    """
    from raybundle.io.reading.trees import read_toml
    from raybundle.results.project_results import language_of_result, project_of

    if given:
        return checked_language(given)
    own = None if folder is None else project_of(folder)
    if own is not None and (current := language_of_result(own)) in language_codes():
        return current
    places = () if folder is None else (folder, folder.parent, folder.parent.parent)
    project = next((p / PROJECT_FILE for p in places if (p / PROJECT_FILE).is_file()), None)
    if project is None:
        return ENGLISH
    tree = read_toml(project).tree()
    found = [tree.get(n).get("language").text() for n in SECTIONS if tree.has(n) and tree.get(n).has("language")]
    return checked_language(found[0]) if found else ENGLISH


def page_files(folder: Path, *, report: bool, pdf: bool, network: str = "network.html") -> list[Path]:
    """What was written for people into the folder of a result.

    network  the page in three dimensions; empty: there is none
    """
    names = [*(["report.html", network] if report else []), *(["report.pdf"] if pdf else [])]
    return [folder / name for name in names if name]
