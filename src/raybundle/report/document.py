"""The report: one HTML file with everything in it, written from an adjustment."""

from __future__ import annotations

from collections.abc import Callable
from datetime import UTC, datetime
from functools import cache
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined

from raybundle.adjustment.result import Adjustment
from raybundle.calibration.quality import CalibrationQuality
from raybundle.io.folders import new_files
from raybundle.numerics.progress import Progress, silent
from raybundle.report.parts import Section
from raybundle.report.sections.accuracy import accuracy_section
from raybundle.report.sections.calibration import calibration_section, graver, headline, worst
from raybundle.report.sections.control import control_section
from raybundle.report.sections.interior import interior_section
from raybundle.report.sections.network import network_section, precision_section
from raybundle.report.sections.noise import noise_section
from raybundle.report.sections.panoramas import panorama_section
from raybundle.report.sections.photographs import PhotographFacts, photograph_sections
from raybundle.report.sections.reliability import reliability_section
from raybundle.report.sections.residuals import residual_section
from raybundle.report.sections.result import result_section, summary_section
from raybundle.report.sections.scenes import scene_section, strip_section, with_near_viewpoints
from raybundle.report.sections.tables import provenance_section, tables_section
from raybundle.report.sections.trajectories import trajectory_section
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
    steps: tuple[tuple[str, Callable[[], Section | None]], ...] = (
        ("result", lambda: result_section(view, told)),
        ("summary", lambda: summary_section(view)),
        ("accuracy", lambda: accuracy_section(view)),
        ("precision", lambda: precision_section(view)),
        ("noise", lambda: noise_section(view)),
        ("control", lambda: control_section(view)),
        ("trajectories", lambda: trajectory_section(view)),
        ("strips", lambda: strip_section(view)),
        ("scenes", lambda: scene_section(view)),
        ("panoramas", lambda: panorama_section(view)),
        ("interior orientation", lambda: interior_section(view)),
        ("residuals", lambda: residual_section(view)),
        ("reliability", lambda: reliability_section(view)),
        ("network", lambda: network_section(with_near_viewpoints(view))),
        ("tables", lambda: tables_section(view)),
        ("settings", lambda: provenance_section(view)),
    )
    sections: list[Section] = []
    for k, (name, make) in enumerate(steps):
        progress(f"report: {name}", k / len(steps))
        made = make()
        sections += [] if made is None else [made]
    block = adjustment.given
    if photographs is not None:
        # after result and summary: a client looks for the photographs first
        made = photograph_sections(with_near_viewpoints(view), photographs)
        scenes_only = all(c.is_scene for c in block.cameras)
        # scenes alone have no camera that starts from anything
        sections[2:2] = [s for s in made if not scenes_only or s.anchor != "cameras-start"]
    if qualities:
        sections.insert(0, calibration_section(qualities))
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
