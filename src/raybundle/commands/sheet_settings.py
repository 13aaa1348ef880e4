"""Settings of `raybundle sheet`: contents, scale and title block."""

from __future__ import annotations

from dataclasses import MISSING, dataclass, fields
from pathlib import Path
from typing import Literal

from raybundle.commands.plane_settings import PlaneSettings
from raybundle.report.languages import language_codes
from raybundle.results.record import Record
from raybundle.settings import ANY, NOT_NEGATIVE, Range, setting

PaperName = Literal["A4", "A3", "A2", "A1", "A0"]


@dataclass(frozen=True, slots=True, kw_only=True)
class DrawingSheetSettings(PlaneSettings):
    """Contents, scale and title block of a sheet."""

    sources: tuple[Path, ...]
    """pictures to scale, and a result folder or project with points and lines"""
    out: Path = setting(MISSING, "New PDF.", metavar="FILE.pdf")
    scale: int | None = setting(
        None, "Denominator of the scale: 50 is 1 : 50.  [default: the largest of 1, 2, 5, 10, 20, 50 ... that fits]",
        metavar="N", limits=Range(low=1, high=1e8),
    )  # fmt: skip
    paper: PaperName = setting("A3", "Paper size.")
    landscape: bool = setting(False, "Use the paper with its longer side horizontal.  [default: by the drawing]")
    portrait: bool = setting(False, "Use the paper with its longer side vertical.")
    several: bool = setting(False, "Use several sheets for a large object. Register marks in their overlaps join them.")
    extent: tuple[float, float, float, float] | None = setting(
        None, "Part to draw, in the coordinates of the plane or the map.  [default: the pictures, else the points]",
        metavar="LEFT BOTTOM RIGHT TOP", limits=(ANY, ANY, ANY, ANY),
    )  # fmt: skip
    grid: float | None = setting(
        None, "Spacing of the grid crosses, in the unit of the plane; 0: none.  [default: a usual one]",
        metavar="LENGTH", limits=NOT_NEGATIVE,
    )  # fmt: skip
    draw_points: Literal["named", "all", "none"] = setting("named", "Points to draw; all: also tie points.")
    lengths: bool = setting(True, "Leave out the values of measured lengths at their lines.", flag="no-lengths")
    language: str = setting(
        "", f"Language of the sheet: {', '.join(language_codes())}.  [default: that of the project's reports]",
        metavar="CODE",
    )  # fmt: skip
    title: str = setting(
        "", "Title of the drawing.  [default: the object, or the name of the first source]", metavar="TEXT"
    )
    object: str = setting("", "Name of the object, in the title block.", metavar="TEXT")
    place: str = setting("", "Place of the object.", metavar="TEXT")
    date: str = setting("", "Date of the recording.", metavar="TEXT")
    client: str = setting("", "Client of the drawing.", metavar="TEXT")
    operator: str = setting("", "Operator.", metavar="TEXT")
    instruments: str = setting("", "Instruments.", metavar="TEXT")
    reference: str = setting("", "Numbers of object and order.", metavar="TEXT")
    rights: str = setting("", "Owner and licence.", metavar="TEXT")


def record_of_sheet(s: DrawingSheetSettings, known: Record) -> Record:
    """The entries of the title block: those given, else those known."""
    names = {f.name for f in fields(Record)}
    entries = known.as_mapping()
    given = {f.name: getattr(s, f.name) for f in fields(s) if f.name in names and getattr(s, f.name)}
    return Record(**{**entries, **given})
