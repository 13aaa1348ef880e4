"""Settings of what a command writes for people to read, as several commands share them."""

from __future__ import annotations

from pathlib import Path
from typing import Protocol

from raybundle.report.languages import checked_language, language_codes
from raybundle.report.paper.needed import check_typesetter

NO_REPORT_HELP = "Leave out report.html and network.html."
TABLES_HELP = (
    "Format of the tables. csv; parquet (with pyarrow). auto: CSV, but Parquet for tables with more rows than a "
    "spreadsheet holds (1 048 575), if pyarrow is installed."
)
PDF_HELP = "Write the report as report.pdf: A4, with page numbers and bookmarks. Also possible without report.html."
LANGUAGE_HELP = f"Language of the report: {', '.join(language_codes())}. Tables and result.json stay English."
COORDINATES_HELP = (
    "List every object point in the appendix of the report. Without it, only the first of many are listed."
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
    checked_language(settings.language)
    if settings.pdf:
        check_typesetter()


def page_files(folder: Path, *, report: bool, pdf: bool, network: str = "network.html") -> list[Path]:
    """What was written for people into the folder of a result.

    network  the page in three dimensions; empty: there is none
    """
    names = [*(["report.html", network] if report else []), *(["report.pdf"] if pdf else [])]
    return [folder / name for name in names if name]
