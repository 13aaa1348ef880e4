"""`raybundle sheet`: a drawing true to scale, as PDF, of pictures to scale and of measured points and lines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.commands.plane_settings import OF_PLANE
from raybundle.commands.sheet_settings import DrawingSheetSettings
from raybundle.errors import InputError, phrase
from raybundle.io.folders import check_free
from raybundle.numerics.progress import Progress, silent
from raybundle.report.languages import checked_language
from raybundle.settings import keywords, made, other_than_usual, path_of

if TYPE_CHECKING:
    from raybundle.numerics.arrays import Array
    from raybundle.report.drawing.content import Drawing
    from raybundle.report.drawing.sheet import Sheets


@dataclass(frozen=True, slots=True, kw_only=True)
class DrawingSheet:
    """A drawn sheet."""

    file: Path
    scale: int
    """denominator"""
    paper: str
    sheets: int
    columns: int
    rows: int
    low: Array
    high: Array
    """(2,) corners of what is shown, in the plane or the map"""
    millimetres: float
    """of paper in a unit of the plane"""
    corner_mm: Array
    """(2,) where the lower left corner of the first sheet's window lies on the paper"""
    corner: Array
    """(2,) the place in the plane that lies there"""
    pictures: int
    points: int
    lines: int
    remarks: tuple[str, ...] = ()
    state: str = ""
    """why what is drawn is not to be used yet; empty: nothing states it"""


@keywords(DrawingSheetSettings)
def drawing_sheet(
    sources: str | Path | Sequence[str | Path], out: str | Path, *, progress: Progress = silent, **settings: Any
) -> DrawingSheet:
    """Draw pictures to scale and measured points and lines on a sheet true to scale.

    sources   pictures of `rectify` (or others with a world file), and a result folder or project
    out       new PDF
    settings  as of the command line, by the names of `DrawingSheetSettings`: scale=50, paper="A2", title="South side"
    raises    InputError for what has no plane or no unit, for pictures of different planes, and where the object does
              not fit, with a scale and a paper that do

    Limits: whether the printer keeps the scale; measure the scale bar on the print.
    """
    several = [sources] if isinstance(sources, str | Path) else list(sources)
    given = {"sources": tuple(path_of("sources", s) for s in several), "out": path_of("out", out), **settings}
    return run_drawing_sheet(made(DrawingSheetSettings, given), progress)


def run_drawing_sheet(settings: DrawingSheetSettings, progress: Progress = silent) -> DrawingSheet:
    """Draw what the settings ask for, and write the PDF."""
    from raybundle.commands.drawing_sheet import drawn
    from raybundle.io.folders import new_files
    from raybundle.report.drawing.sheet import planned, sheets_pdf

    s = settings
    _check(s)
    drawing, remarks, state = drawn(s, progress)
    landscape = None if s.landscape == s.portrait else s.landscape
    sheets = planned(drawing, s.paper, scale=s.scale, landscape=landscape, several=s.several)
    progress("drawing", 0.0)
    pdf = sheets_pdf(drawing, sheets)
    with new_files(s.out) as (file,):
        file.write_bytes(pdf)
    progress("drawing", 1.0)
    return _answer(s, sheets, drawing.millimetres, (
        len(drawing.pictures), sum(len(p.xy) for p in drawing.points), len(drawing.lines)
    ), (*remarks, *_shortened(sheets), *_lacking(drawing)), state)  # fmt: skip


def _answer(
    s: DrawingSheetSettings,
    sheets: Sheets,
    millimetres: float,
    counts: tuple[int, int, int],
    remarks: tuple[str, ...],
    state: str,
) -> DrawingSheet:
    import numpy as np

    div, per_unit = sheets.division, millimetres / sheets.scale
    low = div.parts[(div.rows - 1) * div.columns].corner
    high = div.parts[div.columns - 1].corner + div.size
    left, bottom, _, _ = sheets.paper.window
    return DrawingSheet(
        file=s.out, scale=sheets.scale, paper=sheets.paper.words, sheets=len(div.parts), columns=div.columns,
        rows=div.rows, low=low, high=high, millimetres=per_unit, corner_mm=np.array([left, bottom]),
        corner=div.parts[0].corner, pictures=counts[0], points=counts[1], lines=counts[2], remarks=remarks,
        state=state,
    )  # fmt: skip


def _shortened(sheets: Sheets) -> tuple[str, ...]:
    cut = sheets.block.shortened
    return (phrase("drawing_sheet.shortened", names=cut),) if cut else ()


def _lacking(drawing: Drawing) -> tuple[str, ...]:
    """A remark about letters that are question marks on the sheet."""
    from raybundle.report.drawing.fonts import lacking

    texts = [drawing.title, *(f.text for f in drawing.fields), *drawing.notes, *(n.words for n in drawing.lines)]
    names = [name for group in drawing.points for name in group.names]
    letters = lacking(" ".join([*texts, *names]))
    if not letters:
        return ()
    return (phrase("drawing_sheet.letters", letters=list(letters)),)


def _check(s: DrawingSheetSettings) -> None:
    """Raise InputError for what can be determined before anything is read."""
    if not s.sources:
        raise InputError("drawing.no_source")
    if s.language:
        checked_language(s.language)
    if s.out.suffix.lower() != ".pdf":
        raise InputError("file.suffix", known=[".pdf"], file=s.out)
    check_free(s.out)
    if not s.out.parent.is_dir():
        raise InputError("folder.missing", file=s.out)
    if s.landscape and s.portrait:
        raise InputError("option.exclusive", first="landscape", second="portrait")
    missing = next((p for p in s.sources if not p.exists()), None)
    if missing is not None:
        raise InputError("file.missing", file=missing)
    pictures, folders = [p for p in s.sources if p.is_file()], [p for p in s.sources if p.is_dir()]
    if len(folders) > 1:
        raise InputError("drawing.several_results", file=folders[1])
    if pictures and (given := [n for n in OF_PLANE if n in other_than_usual(s)]):
        raise InputError("drawing.plane_of_picture", setting=given[0])
