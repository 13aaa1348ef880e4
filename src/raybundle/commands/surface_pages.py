"""Pages of a surface: how complete and how good it is, on which adjustment it rests, and itself in three dimensions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from raybundle.commands.pages import Pages
from raybundle.commands.record_settings import Recorded
from raybundle.errors import phrase
from raybundle.numerics.progress import Progress, silent

if TYPE_CHECKING:
    from raybundle.adjustment.records.notice import Notice
    from raybundle.io.formats import Export
    from raybundle.report.chapters import Occasion
    from raybundle.surfaces.depths.summary import SurfaceSummary
    from raybundle.surfaces.product import Context
    from raybundle.surfaces.product_grids import Grids
    from raybundle.surfaces.run import Surface

PAGE, IN_3D, PDF = "surface.html", "surface_3d.html", "surface.pdf"
PAGES = (PAGE, IN_3D, PDF)
OF_ALL = (
    "levelled", "up_ambiguous", "up_uncertain", "scale_unchecked", "check_points_apart", "lengths_contradict",
    "coordinate_system", "datum_lost", "relative_control", "calibration_contradicted", "systematic_residuals",
    "residual_structure", "errors_independent",
)  # fmt: skip
"""Cautions about all points alike, which are reported before those about single marks and photographs"""


class RecordedPages(Recorded, Pages, Protocol):
    """Settings of the pages and of the record of the recording."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SurfacePages:
    """What was written for people, and what it states."""

    files: tuple[Path, ...]
    summary: SurfaceSummary
    verdict: str
    """on the adjustment that the points rest on, in a sentence"""
    warnings: tuple[Notice, ...]
    """faults and cautions of that adjustment, the gravest first"""


def write_pages(
    done: Surface, result: Path, out: Path, context: Context, remarks: tuple[str, ...], settings: RecordedPages,
    others: Mapping[str, float | None], progress: Progress = silent,
) -> SurfacePages:  # fmt: skip
    """Write them.

    result   folder of the result that was measured: its notices, its record and its system are those of the points
    remarks  what was stated while the surface was measured
    others   files of earlier runs with more points, or fewer, by which length they are thinned; None: not at all
    """
    from raybundle.adjustment.records.notice import sorted_notices
    from raybundle.adjustment.records.severity import Severity
    from raybundle.io.folders import names_in
    from raybundle.report.languages.language import language_of
    from raybundle.report.network.page import write_network_page
    from raybundle.report.text.front_words import verdict_sentence
    from raybundle.surfaces.files.heights import HeightFile
    from raybundle.surfaces.page import write_surface_page
    from raybundle.surfaces.summary import sample_of, summary_of

    file = None
    if done.heights is not None and context.plane is not None:
        file = HeightFile.of(done.heights.grid, context.plane, context.unit, done.block.name)
    thinned = len(context.points) if len(context.points) < len(done) else 0
    summary = summary_of(done, context.unit, file, thinned)
    name = done.block.name or result.resolve().name
    rests = _occasion(done, result, context, settings)
    pages = [out / PAGE, *([out / PDF] if settings.pdf else [])]
    written = (*names_in(out), IN_3D)
    write_surface_page(
        summary, *pages, name=name, remarks=remarks, language=settings.language, rests=rests, written=written,
        others=others, lost=len(done.lost), progress=progress,
    )  # fmt: skip
    given = "" if rests.delivery is None else rests.delivery.record.title
    title = given or language_of(settings.language, [name]).text(phrase("report_surface.title", name=name))
    cloud = sample_of(done) if len(done) else None
    write_network_page(done.adjustment, out / IN_3D, title=title, language=settings.language, cloud=cloud)
    faults = sorted_notices(n for n in rests.view.adjustment.notices if n.severity is not Severity.NOTE)
    rank = {code: k for k, code in enumerate(OF_ALL)}
    faults.sort(key=lambda n: (n.severity is not Severity.FAULT, rank.get(n.code, len(OF_ALL))))
    return SurfacePages(
        files=(*pages, out / IN_3D), summary=summary, verdict=verdict_sentence(rests), warnings=tuple(faults)
    )


def _occasion(done: Surface, result: Path, context: Context, settings: RecordedPages) -> Occasion:
    """The adjustment as its report has it: its verdict, who it is for, in which system it stands."""
    from raybundle.commands.record_settings import record_of
    from raybundle.report.chapters import Occasion
    from raybundle.report.delivery import delivery_of
    from raybundle.report.languages.language import language_of
    from raybundle.report.languages.names import names_of
    from raybundle.report.outcome import Outcome
    from raybundle.report.text.words import verdict
    from raybundle.report.view import view_of
    from raybundle.results.notices import as_its_result, lost_accuracy
    from raybundle.results.record import Record

    adjustment = as_its_result(done.adjustment, result)
    names = {f.name for f in fields(Record)}
    record = record_of(settings).over(Record(**{k: v for k, v in context.export.record.items() if k in names}))
    sentence = phrase("outcome.see_report")
    lost = (Outcome(name="accuracy", kept=False, sentence=sentence),) if lost_accuracy(result) else ()
    delivery = delivery_of(adjustment, frame=context.export.frame, record=record, outcomes=lost)
    view = view_of(adjustment, delivery.accuracy)
    language = language_of(settings.language, names_of(adjustment, None, delivery))
    return Occasion(view=view, reported=verdict(view), delivery=delivery, language=language)


def heights_files(faults: tuple[str, ...], export: Export) -> tuple[str, ...]:
    """What is reported of a plane, without what heights count from where they count from nothing that was measured."""
    from raybundle.io.geo.parsed_systems import system_name
    from raybundle.results.record import STATE
    from raybundle.results.state import relative_heights

    if export.frame is None or not relative_heights(export.record.get(STATE, "")):
        return faults
    relative = phrase("surface_remark.heights_relative", system=system_name(export.frame.crs))
    return (*(t for t in faults if t not in export.frame.remarks), relative)


def outside_words(done: Surface, grids: Grids) -> tuple[str, ...]:
    """How many points lie beside the area of heights, orthophoto and mesh, and how to have them."""
    from raybundle.surfaces.product_grids import area_of_points

    if grids.heights is None or done.options.region is not None:
        return ()
    outside, area = area_of_points(done, grids.heights)
    if not outside:
        return ()
    x_min, y_min, x_max, y_max = (float(f"{v:.10g}") for v in area)
    return (
        phrase(
            "surface_remark.outside", n=outside, share=outside / len(done), x_min=x_min, y_min=y_min, x_max=x_max,
            y_max=y_max,
        ),
    )  # fmt: skip
