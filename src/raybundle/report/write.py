"""Result folders with all that people look at: report, network, map, calibration."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from raybundle.adjustment.result import Adjustment
from raybundle.io.table_files import TableFormat
from raybundle.io.tables import write_table
from raybundle.numerics.progress import Progress, silent
from raybundle.report.appendix import Appendix
from raybundle.report.languages import ENGLISH, checked_language
from raybundle.report.languages.language import language_of
from raybundle.report.paper.needed import check_typesetter
from raybundle.report.readme import README, readme
from raybundle.results.folder import MAP, MAP_CONTROL, written_folder
from raybundle.results.record import RECORD_FILE, Record
from raybundle.results.recording_sheet import KnownByPhotographs, known_by_photographs, recorded_text

if TYPE_CHECKING:
    from raybundle.adjustment.blunders.accuracy_class import AccuracyClass
    from raybundle.calibration.quality import CalibrationQuality
    from raybundle.io.geo.coordinate_systems import LocalFrame
    from raybundle.report.facts import PhotographFacts
    from raybundle.report.outcome import Outcome

SURFACE_PAGE = "../surface/surface.html"
"""Where `surface` writes it, if nobody names another folder"""


def write_result(
    adjustment: Adjustment,
    path: str | Path,
    *,
    report: Literal["html", "none"] = "html",
    pdf: bool = False,
    appendix: Appendix = "none",
    language: str = ENGLISH,
    additions: Mapping[str, object] | None = None,
    photographs: PhotographFacts | None = None,
    frame: LocalFrame | None = None,
    qualities: tuple[CalibrationQuality, ...] = (),
    wanted: AccuracyClass | None = None,
    record: Record | None = None,
    known: KnownByPhotographs | None = None,
    pictures: Mapping[str, Path] | None = None,
    outcomes: tuple[Outcome, ...] = (),
    findings: tuple[object, ...] = (),
    more: Callable[[Path], None] | None = None,
    tables: TableFormat = "auto",
    progress: Progress = silent,
) -> None:
    """Write a result folder, whole or not at all; an older result there is replaced when the new one is complete.

    report       "html": report.html and network.html, the network in three dimensions
    pdf          whether report.pdf is written, beside report.html or without it
    appendix     of report.pdf: "none"; "short"; "all": with every object point. report.html has the short one at least
    language     of the report: "de"; tables and result.json are English in any
    additions    further keys of result.json
    photographs  what is known of the photographs that the adjustment comes from
    frame        the coordinate system in which the local frame of the adjustment stands; map.csv is in that system
    qualities    verdicts on calibrated cameras; calibration.toml, as orient takes it, is written beside them
    wanted       accuracy that is asked for at check points
    record       title, client and the like
    pictures     file of an image in the block -> where the photograph is, for the client's page
    known        dates and cameras of the photographs, where `photographs` is not there
    outcomes     outcomes of further requests
    findings     what else was found with the points, for the report: a best fit, a length test
    more         writes further files of the result into the folder
    tables       "csv" or "parquet" (with pyarrow); "auto": CSV, Parquet for tables that no spreadsheet holds
    raises       InputError where something else stands at `path`, or reports are not written in the language
    """
    from raybundle.report.delivery import delivery_of

    checked_language(language)
    if pdf:
        check_typesetter()
    delivery = delivery_of(adjustment, frame=frame, wanted=wanted, record=record, outcomes=outcomes, findings=findings)
    added = {**(additions or {}), **delivery.as_mapping(), "language": language}
    with written_folder(adjustment, path, added, progress, tables) as folder:
        if frame is not None:
            from raybundle.results.map_table import (
                map_control_table,
                map_table,
            )

            write_table(folder / MAP, *map_table(adjustment, frame))
            compared = [("control", delivery.accuracy.control), ("check", delivery.accuracy.check)]
            if any(len(c.rows) for _, c in compared):
                write_table(folder / MAP_CONTROL, *map_control_table(adjustment, frame, compared))
        if qualities:
            from raybundle.results.calibrated import calibration_text

            text = calibration_text(adjustment, qualities)
            (folder / "calibration.toml").write_text(text, encoding="utf-8", newline="\n")
        if photographs is not None or known is not None or delivery.record.as_mapping():
            text = _recorded(adjustment, delivery.record, photographs, known)
            (folder / RECORD_FILE).write_text(text, encoding="utf-8")
        if more is not None:
            more(folder)
        pages = [folder / name for name, wanted in (("report.html", report == "html"), ("report.pdf", pdf)) if wanted]
        names = [*(entry.name for entry in folder.iterdir() if not _empty(entry)), *(p.name for p in pages)]
        names += ["network.html"] * (report == "html")
        every = {entry.name for entry in folder.iterdir()} | set(names)
        text = readme(adjustment, sorted(every), language_of(language, [adjustment.adjusted.name]), frame)
        (folder / README).write_text(text, encoding="utf-8", newline="\n")
        if pages:
            from raybundle.report.writing import write_reports

            write_reports(
                adjustment, pages, progress, photographs=photographs, qualities=qualities,
                delivery=replace(
                    delivery, files=tuple(sorted(names)), surface=_surface_beside(Path(path)), pictures=pictures or {}
                ),
                appendix=appendix,
                language=language,
            )  # fmt: skip
        if report == "html":
            from raybundle.report.network.page import write_network_page

            write_network_page(adjustment, folder / "network.html", title=delivery.record.title, language=language)


def _recorded(
    adjustment: Adjustment, record: Record, facts: PhotographFacts | None, known: KnownByPhotographs | None
) -> str:
    """The recording sheet with what the photographs know."""
    if facts is not None:
        devices = {p.camera: p.device for p in facts.photographs if p.device}
        known = known_by_photographs(adjustment, devices, tuple(p.taken for p in facts.photographs))
    return recorded_text(record, known)


def _surface_beside(result: Path) -> str:
    """The page of the dense points of a project, from its result on; empty where there is none."""
    return SURFACE_PAGE if (result.parent / SURFACE_PAGE[3:]).is_file() else ""


def _empty(entry: Path) -> bool:
    """Whether a file is a table without rows, which nobody needs."""
    if entry.suffix != ".csv":
        return False
    with entry.open("rb") as file:
        return not (file.readline() and file.readline())
