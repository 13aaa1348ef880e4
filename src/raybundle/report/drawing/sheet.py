"""A drawing on paper, true to scale: the pages of its PDF."""

from __future__ import annotations

import io
import math
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.errors import InputError, message, phrase
from raybundle.numerics.arrays import Array
from raybundle.report.drawing.content import Drawing, Field, within
from raybundle.report.drawing.fonts import PLAIN, load_fonts, shown, width
from raybundle.report.drawing.legend import Legend, draw_legend, legend
from raybundle.report.drawing.paper import (
    MOST_SHEETS,
    OVERLAP,
    PAPERS,
    SMALLEST,
    Division,
    Paper,
    Part,
    divided,
    scale_that_fits,
    usual_length,
)
from raybundle.report.drawing.pictures import cut, opened
from raybundle.report.drawing.symbols import SIZE, draw_line, draw_register, draw_symbol, draw_words
from raybundle.report.drawing.title_block import WIDTH, TitleBlock, draw_title_block, title_block
from raybundle.report.figures.labels import placed_labels

POINT = 72 / 25.4
"""Points of a PDF in a millimetre"""
NAME, NUMBER = 2.4, 2.1
"""Sizes of letters [mm]: names of points, numbers of the grid"""
GRID = 50.0
"""Usual distance of grid lines [mm], at most"""
ABOVE = 0.8
"""Between a line and the words along it [mm]"""
CROSS = 2.5
"""Half a cross of the grid [mm]"""
BESIDE = 75.0
"""Width that a legend beside the title block needs [mm]; where there is less it stands above"""


LEAST_GRID = 10.0
"""Distance of grid lines [mm], at least: their numbers need it"""
LEAST_ROOM = 40.0
"""Width and height that are left for the drawing [mm], at least"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Sheets:
    """How a drawing comes to lie on paper."""

    paper: Paper
    scale: int
    division: Division
    block: TitleBlock
    legend: Legend
    beside: bool
    """whether the legend stands beside the title block, and not above"""


def planned(drawing: Drawing, name: str, *, scale: int | None, landscape: bool | None, several: bool) -> Sheets:
    """Choose the paper's direction where that is free, the largest usual scale where none is given, and the sheets.

    name       of the paper
    landscape  None: as the object is larger
    several    whether more than one sheet may be taken
    raises     InputError where the object does not fit, with a scale and a paper that do
    """
    load_fonts()
    ways = (False, True) if landscape is None else (landscape,)
    found = [s for way in ways if (s := _on(drawing, name, scale, landscape=way, several=several)) is not None]
    if found:
        best = min(found, key=lambda s: (s.scale, len(s.division.parts), not s.paper.width > s.paper.height))
        _check_grid(drawing, best)
        return best
    raise _misfit(drawing, name, scale, ways, several=several)


def _check_grid(drawing: Drawing, sheets: Sheets) -> None:
    """Raise InputError for a grid whose numbers would lie on each other."""
    apart = (drawing.grid or 0.0) * drawing.millimetres / sheets.scale
    if 0 < apart < LEAST_GRID:
        need = usual_length(2 * LEAST_GRID * sheets.scale / drawing.millimetres)
        raise InputError(
            "drawing.grid_too_dense", grid=drawing.grid or 0.0, apart_mm=apart, least_mm=LEAST_GRID, needed=need
        )


def _on(drawing: Drawing, name: str, scale: int | None, *, landscape: bool, several: bool) -> Sheets | None:
    """The sheets on one paper; None where the object does not fit."""
    wide, tall = PAPERS[name][::-1] if landscape else PAPERS[name]
    none = Division(parts=(), columns=1, rows=1, overlap=np.zeros(2), size=np.zeros(2))
    first = _laid(drawing, name, wide, tall, scale, none, several=several)
    # once more with the scale and the number of sheets that title block and legend are to say
    return None if first is None else _laid(
        drawing, name, wide, tall, scale, first.division, several=several, least=first.scale
    )  # fmt: skip


def _laid(
    drawing: Drawing, name: str, wide: float, tall: float, scale: int | None, division: Division, *, several: bool,
    least: int = SMALLEST,
) -> Sheets | None:  # fmt: skip
    paper, block, key, beside = _furnished(drawing, name, wide, tall, least, division)
    if (paper.room < LEAST_ROOM).any():
        return None
    chosen = scale or scale_that_fits(drawing.size, paper.room)
    if chosen is None:
        return None
    unit = chosen / drawing.millimetres
    found = divided(drawing.low, drawing.high, paper.room * unit, OVERLAP * unit)
    if found is None or (len(found.parts) > 1 and not several):
        return None
    return Sheets(paper=paper, scale=chosen, division=found, block=block, legend=key, beside=beside)


def _furnished(
    drawing: Drawing, name: str, wide: float, tall: float, scale: int, division: Division
) -> tuple[Paper, TitleBlock, Legend, bool]:
    paper = Paper(name=name, width=wide, height=tall, strip=0.0)
    block = title_block(drawing.title, _fields(drawing, paper, scale, 1, max(len(division.parts), 1)))
    left, _, right, _ = paper.frame
    beside = right - left - WIDTH >= BESIDE
    key = legend(drawing, right - left - WIDTH if beside else right - left, division)
    strip = max(block.height, key.height) if beside else block.height + key.height
    return Paper(name=name, width=wide, height=tall, strip=strip), block, key, beside


def _fields(drawing: Drawing, paper: Paper, scale: int, number: int, of: int) -> Sequence[Field]:
    say = drawing.language.text
    least = (
        Field(
            label=say(phrase("drawing_sheet.field", name="scale")), text=f"1 : {scale:,}".replace(",", " "), first=True
        ),
        Field(label=say(phrase("drawing_sheet.field", name="paper")), text=say(paper.words)),
        Field(label=say(phrase("drawing_sheet.field", name="sheet")), text=say(phrase("label.n_of", n=number, of=of))),
    )
    return (*drawing.fields, *least)


def _misfit(drawing: Drawing, name: str, scale: int | None, ways: Sequence[bool], *, several: bool) -> InputError:
    size = drawing.size / 1000
    fits = [s.scale for way in ways if (s := _on(drawing, name, None, landscape=way, several=False)) is not None]
    larger = [n for n in PAPERS if n != name and any(
        _on(drawing, n, scale, landscape=way, several=False) is not None for way in (False, True)
    )]  # fmt: skip
    remedies = [message("drawing.fitting_scale", scale=min(fits))] if fits else []
    remedies += [message("drawing.fitting_paper", paper=larger[0])] if larger else []
    if scale and not several:
        remedies.append(message("drawing.joined_sheets"))
    return InputError(
        "drawing.does_not_fit", width_m=size[0], height_m=size[1], paper=name, scale=scale or 0,
        sheets=MOST_SHEETS if several else 0, details=remedies or [message("drawing.title_block")],
    )  # fmt: skip


def sheets_pdf(drawing: Drawing, sheets: Sheets) -> bytes:
    """The PDF; with the environment variable SOURCE_DATE_EPOCH the same drawing gives the same bytes.

    Without it the file states when it was made.
    """
    from reportlab import rl_config
    from reportlab.pdfgen.canvas import Canvas

    settings: Any = rl_config
    buffer, kept = io.BytesIO(), settings.useA85
    settings.useA85 = 0  # pictures as they are, and not a quarter longer as text
    try:
        # the library states a number for what is the name of a font
        canvas = Canvas(buffer, invariant=0, pageCompression=1, initialFontName=PLAIN)  # pyright: ignore[reportArgumentType]
        canvas.setTitle(shown(drawing.title))
        canvas.setCreator("raybundle")
        canvas.setAuthor(shown(drawing.author))
        with ExitStack() as files:
            pictures = [files.enter_context(opened(p.file)) for p in drawing.pictures]
            for part in sheets.division.parts:
                canvas.setPageSize((sheets.paper.width * POINT, sheets.paper.height * POINT))
                canvas.scale(POINT, POINT)
                _Page(canvas, drawing, sheets, part).draw(pictures)
                canvas.showPage()
        canvas.save()
    finally:
        settings.useA85 = kept
    return buffer.getvalue()


class _Page:
    """One sheet."""

    def __init__(self, canvas: Any, drawing: Drawing, sheets: Sheets, part: Part) -> None:
        self.c, self.d, self.s, self.part = canvas, drawing, sheets, part
        self.per_unit = drawing.millimetres / sheets.scale
        self.left, self.bottom, self.right, self.top = sheets.paper.window
        self.low = part.corner
        self.high = part.corner + sheets.paper.room / self.per_unit

    def at(self, xy: Array) -> Array:
        """Millimetres on the paper of places (..., 2) in the plane."""
        return np.array([self.left, self.bottom]) + (xy - self.low) * self.per_unit

    def draw(self, pictures: Sequence[Any]) -> None:
        c = self.c
        c.saveState()
        path = c.beginPath()
        path.rect(self.left, self.bottom, self.right - self.left, self.top - self.bottom)
        c.clipPath(path, stroke=0, fill=0)
        self._pictures(pictures)
        self._grid()
        for line in self.d.lines:
            draw_line(c, line.kind, [tuple(p) for p in self.at(line.xy).tolist()], closed=line.closed)
        written = self._lengths()
        self._points(written)
        self._joints()
        c.restoreState()
        self._frame()
        self._numbers()
        self._strip()

    def _pictures(self, pictures: Sequence[Any]) -> None:
        from reportlab.lib.utils import ImageReader

        for drawn, picture in zip(self.d.pictures, pictures, strict=True):
            found = cut(picture, drawn, self.low, self.high, self.per_unit)
            if found is not None:
                (x, y), (right, top) = self.at(found[1][:2]), self.at(found[1][2:])
                self.c.drawImage(ImageReader(io.BytesIO(found[0])), x, y, right - x, top - y)

    def _lengths(self) -> Array:
        """Words along lines, where these are longer than they; the strips (k, 2, 2) that they take [mm]."""
        c, taken = self.c, list[Array]()
        for line in self.d.lines:
            ends = self.at(line.xy)[[0, -1]]
            ends = ends if tuple(ends[0]) <= tuple(ends[1]) else ends[::-1]  # read from the left, or from below
            along, long = ends[1] - ends[0], float(np.linalg.norm(ends[1] - ends[0]))
            words, wide = shown(line.words), width(shown(line.words), NUMBER)
            if not words or long < wide + 2 * SIZE:
                continue
            c.saveState()
            c.translate(*ends.mean(axis=0).tolist())
            c.rotate(math.degrees(math.atan2(along[1], along[0])))
            draw_words(c, words, -wide / 2, ABOVE, PLAIN, NUMBER)
            c.restoreState()
            off = np.array([-along[1], along[0]]) / long * (ABOVE + 0.4 * NUMBER)
            taken.append(ends.mean(axis=0) + off + np.outer([-0.5, 0.5], along) * (wide / long))
        return np.array(taken).reshape(-1, 2, 2)

    def _points(self, written: Array) -> None:
        c, names, dots = self.c, list[str](), list[Array]()
        for group in sorted(self.d.points, key=lambda p: p.kind != "tie"):
            here = within(group.xy, self.low, self.high)
            for k in np.flatnonzero(here).tolist():
                x, y = self.at(group.xy[k]).tolist()
                draw_symbol(c, group.kind, x, y)
                if group.names[k]:
                    names.append(shown(group.names[k]))
                    dots.append(np.array([x, y]))
        if not names:
            return
        at = np.array(dots) * POINT
        sizes = np.array([(width(n, NAME) * POINT, 0.75 * NAME * POINT) for n in names])
        lines = [np.stack([self.at(line.xy)[:-1], self.at(line.xy)[1:]], axis=1) for line in self.d.lines]
        taken = np.concatenate([written, *lines]) * POINT if len(names) < 500 else np.zeros((0, 2, 2))
        area = np.array([[self.left + 1, self.bottom + 1], [self.right - 1, self.top - 1]]) * POINT
        ways = np.tile([0.8, 0.6], (len(names), 1))
        placed = placed_labels(at, SIZE * POINT, sizes, ways, taken, area)
        for k in np.flatnonzero(placed.fits).tolist():
            if placed.led[k]:
                c.setStrokeGray(0.2)
                c.setLineWidth(0.1)
                (x, y), (u, v) = (placed.start[k] / POINT).tolist(), (placed.end[k] / POINT).tolist()
                c.line(x, y, u, v)
            x, y = (placed.box[k, :2] / POINT).tolist()
            draw_words(c, names[k], x, y, PLAIN, NAME)

    # ---- grid

    @property
    def grid(self) -> float:
        """Distance of its lines in the plane; 0: none."""
        return usual_length(GRID / self.per_unit) if self.d.grid is None else self.d.grid

    def _lines(self, axis: int) -> Array:
        step = self.grid
        if not step:
            return np.zeros(0)
        first, last = math.ceil(self.low[axis] / step - 1e-9), math.floor(self.high[axis] / step + 1e-9)
        return np.arange(first, last + 1) * step

    def _grid(self) -> None:
        """Crosses, so that little of the picture is covered."""
        c = self.c
        for grey, thick in ((1.0, 0.5), (0.0, 0.13)):
            c.setStrokeGray(grey)
            c.setLineWidth(thick)
            for u in self._lines(0):
                for v in self._lines(1):
                    x, y = self.at(np.array([u, v])).tolist()
                    c.line(x - CROSS, y, x + CROSS, y)
                    c.line(x, y - CROSS, x, y + CROSS)

    def _numbers(self) -> None:
        """Ticks at all four sides with coordinates beside them."""
        c, step = self.c, self.grid
        digits = max(-math.floor(math.log10(step) + 1e-9), 0) if step else 0
        c.setStrokeGray(0)
        c.setLineWidth(0.18)
        c.setFillGray(0)
        c.setFont(PLAIN, NUMBER)
        for axis in (0, 1):
            for k, value in enumerate(self._lines(axis)):
                words = f"{value:.{digits}f}".replace("-0", "0") if abs(value) < step / 2 else f"{value:.{digits}f}"
                words = self.d.language.text(words)
                words = f"{self.d.axes[axis]} {words}" if k == 0 else words
                here = float(self.at(np.array([value, value]))[axis])
                if axis == 0:
                    for y, way, base in ((self.bottom, -1, -2.0 - 0.75 * NUMBER), (self.top, 1, 2.0)):
                        c.line(here, y, here, y + 1.5 * way)
                        c.drawCentredString(here, y + base, words)
                else:
                    for x, way, base in ((self.left, -1, -2.0), (self.right, 1, 2.0 + 0.75 * NUMBER)):
                        c.line(x, here, x + 1.5 * way, here)
                        c.saveState()
                        c.translate(x + base, here)
                        c.rotate(90)
                        c.drawCentredString(0, 0, words)
                        c.restoreState()

    # ---- frame and joints

    def _frame(self) -> None:
        c = self.c
        left, bottom, right, top = self.s.paper.frame
        c.setStrokeGray(0)
        c.setLineWidth(0.7)
        c.rect(left, bottom, right - left, top - bottom, stroke=1, fill=0)
        c.setLineWidth(0.25)
        c.rect(self.left, self.bottom, self.right - self.left, self.top - self.bottom, stroke=1, fill=0)

    def _joints(self) -> None:
        """Where neighbouring sheets begin, and marks that both have at the same places."""
        c, div, p = self.c, self.s.division, self.part
        lap = div.overlap * self.per_unit
        wide, tall = self.right - self.left, self.top - self.bottom
        sides = [
            (0, self.left, p.column > 0, p.number - 1),
            (0, self.right - lap[0], p.column < div.columns - 1, p.number + 1),
            (1, self.bottom, p.row < div.rows - 1, p.number + div.columns),
            (1, self.top - lap[1], p.row > 0, p.number - div.columns),
        ]  # fmt: skip
        for axis, begin, there, number in sides:
            if not there:
                continue
            middle = float(begin + lap[axis] / 2)
            for share in (0.2, 0.8):
                # at places of the object, so that they are the same on both sheets
                x, y = (middle, self.bottom + share * tall) if axis == 0 else (self.left + share * wide, middle)
                draw_register(c, x, y)
            words = self.d.language.text(phrase("drawing_sheet.other_sheet", number=number))
            if axis == 0:
                c.saveState()
                c.translate(middle + 0.4 * NAME, self.bottom + tall / 2)
                c.rotate(90)
                draw_words(c, words, -width(words, NAME) / 2, 0, PLAIN, NAME)
                c.restoreState()
            else:
                draw_words(c, words, self.left + wide / 2 - width(words, NAME) / 2, middle - 0.4 * NAME, PLAIN, NAME)

    def _strip(self) -> None:
        """Title block and legend."""
        s, c = self.s, self.c
        left, bottom, right, _ = s.paper.frame
        least = _fields(self.d, s.paper, s.scale, self.part.number, len(s.division.parts))
        draw_title_block(c, title_block(self.d.title, least), right - WIDTH, bottom)
        c.setStrokeGray(0)
        c.setLineWidth(0.25)
        c.line(left, bottom + s.paper.strip, right, bottom + s.paper.strip)
        draw_legend(c, s.legend, self.d, s.scale, self.part, left, bottom + s.paper.strip)
