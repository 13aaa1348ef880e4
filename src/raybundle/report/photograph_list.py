"""A list of photographs to take along, as a PDF: sketches of the stations, what to heed, a line with a box for each."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array

MARGIN, LINE = 40.0, 13.0
"""Points of a PDF"""
WIDTH, HEIGHT = 595.0, 842.0
"""A4"""
COLOURS = ((0.76, 0.25, 0.05), (0.11, 0.31, 0.85), (0.08, 0.5, 0.24), (0.49, 0.13, 0.81), (0.05, 0.45, 0.56))
"""Of the groups, one after the other"""
LABEL = 7.0
MOST_EDGES = 4000


@dataclass(frozen=True, slots=True, kw_only=True)
class ListedPhotograph:
    """A line of the list."""

    number: str
    group: str
    centre: Array
    at: Array
    how: str
    """Distance, height and turn in words"""
    see: str
    ticked: str = ""
    """Name of the photograph that was taken; empty: not yet"""


@dataclass(frozen=True, slots=True, kw_only=True)
class PhotographList:
    """What is printed."""

    title: str
    facts: tuple[str, ...]
    rules: tuple[str, ...]
    photographs: tuple[ListedPhotograph, ...]
    edges: Array
    """(k, 2, 3) edges of the object"""
    table: tuple[tuple[str, ...], ...] = ()
    """A table of targets, its head first"""


def list_pdf(listed: PhotographList) -> bytes:
    """The PDF; the same list gives the same bytes."""
    try:
        from reportlab.pdfgen.canvas import Canvas  # noqa: PLC0415  (only for printing)
    except ImportError as error:
        raise InputError("a PDF needs the package reportlab: pip install reportlab") from error
    buffer = io.BytesIO()
    sheet = _Paper(Canvas(buffer, pagesize=(WIDTH, HEIGHT), invariant=1), listed.title)
    sheet.heading(listed.title)
    for fact in listed.facts:
        sheet.text(fact)
    sheet.gap()
    _sketches(sheet, listed)
    sheet.gap()
    sheet.heading("To heed", size=11)
    for rule in listed.rules:
        sheet.text(rule, bullet=True)
    group = ""
    sheet.page()
    for p in listed.photographs:
        if p.group != group:
            group = p.group
            sheet.room(3)
            sheet.heading(group[:1].upper() + group[1:], size=11, colour=_colour(listed, group))
        sheet.photograph(p)
    if listed.table:
        sheet.page()
        sheet.table(listed.table)
    sheet.canvas.save()
    return buffer.getvalue()


def _colour(listed: PhotographList, group: str) -> tuple[float, float, float]:
    groups = list(dict.fromkeys(p.group for p in listed.photographs))
    return COLOURS[groups.index(group) % len(COLOURS)]


class _Paper:
    """A page that is filled from above; a new one where it is full."""

    def __init__(self, canvas: Any, title: str) -> None:
        self.canvas, self.title, self.y, self.number = canvas, title, HEIGHT - MARGIN, 1
        canvas.setTitle(title)
        self._foot()

    def _foot(self) -> None:
        self.canvas.setFont("Helvetica", 8)
        self.canvas.setFillGray(0.4)
        self.canvas.drawString(MARGIN, MARGIN / 2, self.title)
        self.canvas.drawRightString(WIDTH - MARGIN, MARGIN / 2, str(self.number))

    def page(self) -> None:
        self.canvas.showPage()
        self.number += 1
        self.y = HEIGHT - MARGIN
        self._foot()

    def room(self, lines: float) -> None:
        if self.y - lines * LINE < MARGIN:
            self.page()

    def gap(self) -> None:
        self.y -= LINE / 2

    def heading(self, text: str, size: float = 15, colour: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> None:
        self.room(2)
        self.y -= size + 3
        self.canvas.setFont("Helvetica-Bold", size)
        self.canvas.setFillColorRGB(*colour)
        self.canvas.drawString(MARGIN, self.y, _latin(text))
        self.y -= 4

    def text(self, text: str, *, bullet: bool = False, size: float = 9) -> None:
        left = MARGIN + (10 if bullet else 0)
        self.canvas.setFont("Helvetica", size)
        for k, line in enumerate(self._lines(_latin(text), size, WIDTH - MARGIN - left)):
            self.room(1)
            self.y -= LINE - 1
            self.canvas.setFont("Helvetica", size)
            self.canvas.setFillGray(0.1)
            if bullet and k == 0:
                self.canvas.circle(MARGIN + 3, self.y + 3, 1.4, stroke=0, fill=1)
            self.canvas.drawString(left, self.y, line)

    def _lines(self, text: str, size: float, width: float, font: str = "Helvetica") -> list[str]:
        from reportlab.lib.utils import simpleSplit  # noqa: PLC0415

        return list(simpleSplit(text, font, size, width))

    def photograph(self, p: ListedPhotograph) -> None:
        see = self._lines(_latin(p.see), 9, WIDTH - 2 * MARGIN - 62)
        how = self._lines(_latin(p.how), 8, WIDTH - 2 * MARGIN - 62)
        tall = LINE * (len(see) + len(how)) + 4
        if self.y - tall < MARGIN:
            self.page()
        c, top = self.canvas, self.y - 4
        c.setStrokeGray(0.2)
        c.setFillGray(0.1)
        c.rect(MARGIN, top - 10, 10, 10, stroke=1, fill=0)
        if p.ticked:
            c.setLineWidth(1.6)
            c.lines([(MARGIN + 2, top - 5, MARGIN + 4.5, top - 8.5), (MARGIN + 4.5, top - 8.5, MARGIN + 9.5, top + 1)])
            c.setLineWidth(1)
        c.setFont("Helvetica-Bold", 10)
        c.drawString(MARGIN + 18, top - 9, p.number)
        self.y = top
        for lines, size, grey in ((see, 9, 0.1), (how, 8, 0.4)):
            c.setFont("Helvetica", size)
            c.setFillGray(grey)
            for line in lines:
                self.y -= LINE - 2
                c.drawString(MARGIN + 62, self.y + 1, line)
        if p.ticked:
            c.setFont("Helvetica-Oblique", 7)
            c.drawRightString(WIDTH - MARGIN, top - 9, _latin(p.ticked)[:40])
        self.y -= 3

    def table(self, rows: Sequence[Sequence[str]]) -> None:
        wide = (WIDTH - 2 * MARGIN) / len(rows[0])
        for k, row in enumerate(rows):
            if self.y - LINE < MARGIN:
                self.page()
            self.y -= LINE
            self.canvas.setFont("Helvetica-Bold" if k == 0 else "Helvetica", 8)
            self.canvas.setFillGray(0.1)
            for j, cell in enumerate(row):
                self.canvas.drawString(MARGIN + j * wide, self.y, _latin(cell))


def _latin(text: str) -> str:
    """What the built-in fonts of PDF can show; the rest as a question mark."""
    return text.encode("cp1252", "replace").decode("cp1252")


def _sketches(sheet: _Paper, listed: PhotographList) -> None:
    """From above and from the front, side by side."""
    wide, tall = (WIDTH - 2 * MARGIN - 20) / 2, 250.0
    centre = np.array([p.centre for p in listed.photographs])
    low = np.minimum(listed.edges.reshape(-1, 3).min(axis=0), centre.min(axis=0))
    high = np.maximum(listed.edges.reshape(-1, 3).max(axis=0), centre.max(axis=0))
    sheet.room((tall + 20) / LINE)
    top = sheet.y
    for k, (axes, word) in enumerate((((0, 1), "from above (Y up)"), ((0, 2), "from the front (Z up)"))):
        left = MARGIN + k * (wide + 20)
        a, b = axes
        size = np.array([high[a] - low[a], high[b] - low[b]])
        scale = min((wide - 24) / max(size[0], 1e-9), (tall - 30) / max(size[1], 1e-9))
        middle = (low + high) / 2

        def place(
            xyz: Array, a: int = a, b: int = b, left: float = left, scale: float = scale, m: Array = middle
        ) -> Any:
            return left + wide / 2 + scale * (xyz[a] - m[a]), top - 16 - (tall - 16) / 2 + scale * (xyz[b] - m[b])

        sheet.canvas.setFont("Helvetica", 8)
        sheet.canvas.setFillGray(0.3)
        sheet.canvas.drawString(left, top - 9, f"{word}, 1 : {_scale_words(scale)}")
        _sketch(sheet.canvas, listed, place)
    sheet.y = top - tall - 6


def _scale_words(scale: float) -> str:
    """Denominator of a scale of so many points of a PDF a metre."""
    return f"{72 / 0.0254 / scale:.0f}"


def _sketch(canvas: Any, listed: PhotographList, place: Any) -> None:
    canvas.setStrokeGray(0.55)
    canvas.setLineWidth(0.6)
    for a, b in listed.edges[:MOST_EDGES]:
        canvas.line(*place(a), *place(b))
    taken = list[tuple[float, float]]()
    canvas.setFont("Helvetica", LABEL)
    for p in listed.photographs:
        x, y = place(p.centre)
        u, v = place(p.at)
        long = float(np.hypot(u - x, v - y)) or 1.0
        canvas.setStrokeColorRGB(*_colour(listed, p.group))
        canvas.setFillColorRGB(*_colour(listed, p.group))
        canvas.circle(x, y, 1.8, stroke=0, fill=1)
        short = min(long, 14.0) / long
        canvas.line(x, y, x + short * (u - x), y + short * (v - y))
        lx, ly = x - 7 * (u - x) / long - 3, y - 7 * (v - y) / long - 2
        # a number that would lie on another one is left out; the list has the place
        if all(abs(lx - i) > 9 or abs(ly - j) > LABEL for i, j in taken):
            canvas.drawString(lx, ly, p.number)
            taken.append((lx, ly))


def edges_of(triangles: Array) -> Array:
    """(k, 2, 3) edges of triangles (m, 3, 3) where the surface bends or ends."""
    corners = np.round(triangles, 9)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    found = dict[tuple[tuple[float, ...], tuple[float, ...]], list[int]]()
    for k in range(len(corners)):
        for i in range(3):
            a, b = sorted((tuple(corners[k, i].tolist()), tuple(corners[k, (i + 1) % 3].tolist())))
            found.setdefault((a, b), []).append(k)
    kept = [
        edge for edge, of in found.items()
        if len(of) != 2 or float(normal[of[0]] @ normal[of[1]]) < np.cos(np.radians(20))
    ]  # fmt: skip
    return np.array(kept or [(c[0], c[1]) for c in corners])
