"""A list of photographs to take along, as a PDF: sketches of the stations, what to heed, a line with a box for each."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.numerics.arrays import Array
from raybundle.report.figures.labels import Placed, placed_labels

MARGIN, LINE = 40.0, 13.0
"""Points of a PDF"""
WIDTH, HEIGHT = 595.0, 842.0
"""A4"""
COLOURS = ((0.76, 0.25, 0.05), (0.11, 0.31, 0.85), (0.08, 0.5, 0.24), (0.49, 0.13, 0.81), (0.05, 0.45, 0.56))
"""Of the groups, one after the other"""
FONT, LABEL, DOT, TICK = "Helvetica", 7.0, 1.8, 14.0
"""Of the sketches: their font and its size, radius of a station, length of its axis"""
TALL, GAP, HEAD = 250.0, 20.0, 16.0
"""Height of the sketches, between them, and for the words above them"""
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
        from reportlab.pdfgen.canvas import Canvas
    except ImportError as error:
        raise InputError("package.reportlab_missing") from error
    buffer = io.BytesIO()
    sheet = _Paper(Canvas(buffer, pagesize=(WIDTH, HEIGHT), invariant=1), listed.title)
    sheet.heading(listed.title)
    for fact in listed.facts:
        sheet.text(fact)
    sheet.gap()
    _sketches(sheet, listed)
    sheet.gap()
    if listed.rules:
        sheet.heading(phrase("photograph_list.rules"), size=11)
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
        from reportlab.lib.utils import simpleSplit

        return list(simpleSplit(text, font, size, width))

    def photograph(self, p: ListedPhotograph) -> None:
        reported = [(p.see, FONT, 9, 0.1), (p.how, FONT, 8, 0.4)]
        reported += [(phrase("photograph_list.taken", name=p.ticked), "Helvetica-Oblique", 8, 0.1)] if p.ticked else []
        lines = [
            (line, font, size, grey)
            for words, font, size, grey in reported
            for line in self._lines(_latin(words), size, WIDTH - 2 * MARGIN - 62, font)
        ]
        if self.y - LINE * len(lines) - 4 < MARGIN:
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
        for line, font, size, grey in lines:
            self.room(1)
            c.setFont(font, size)
            c.setFillGray(grey)
            self.y -= LINE - 2
            c.drawString(MARGIN + 62, self.y + 1, line)
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


@dataclass(frozen=True, slots=True, kw_only=True)
class Sketch:
    """Stations and object seen along one axis, in points of the PDF."""

    words: str
    place: Callable[[Array], Array]
    """(..., 3) to (..., 2)"""
    dots: Array
    """(n, 2) stations"""
    ticks: Array
    """(n, 2, 2) from there towards what is looked at"""
    labels: Placed


VIEWS = ((0, 1, "above"), (0, 2, "front"))


def sketches(listed: PhotographList, top: float) -> tuple[Sketch, ...]:
    """From above and from the front, side by side below `top`."""
    from reportlab.pdfbase.pdfmetrics import stringWidth

    centre, at = (np.array([getattr(p, n) for p in listed.photographs], float) for n in ("centre", "at"))
    every = np.concatenate([listed.edges.reshape(-1, 3), centre])
    low, high = every.min(axis=0), every.max(axis=0)
    sizes = np.array([(stringWidth(p.number, FONT, LABEL), 0.72 * LABEL) for p in listed.photographs])
    wide, found = (WIDTH - 2 * MARGIN - GAP) / 2, list[Sketch]()
    for k, (a, b, view) in enumerate(VIEWS):
        left, axes = MARGIN + k * (wide + GAP), [a, b]
        room = np.array([wide - 24, TALL - 36])
        scale = float((room / np.maximum((high - low)[axes], 1e-9)).min())
        middle, there = (low + high)[axes] / 2, np.array([left + wide / 2, top - HEAD - (TALL - HEAD) / 2])

        def place(
            xyz: Array, axes: Sequence[int] = axes, scale: float = scale, m: Array = middle, t: Array = there
        ) -> Array:
            return t + scale * (xyz[..., axes] - m)

        dots, to = place(centre), place(at) - place(centre)
        long = np.linalg.norm(to, axis=1, keepdims=True)
        way = to / np.maximum(long, 1e-9)
        ticks = np.stack([dots, dots + np.minimum(long, TICK) * way], axis=1)
        # what stands behind is in the sketch from above
        before = None if b == 1 else centre[:, 1] <= (low + high)[1] / 2
        area = np.array([[left, top - TALL], [left + wide, top - HEAD + 4]])
        found.append(
            Sketch(
                words=phrase("photograph_list.view", view=view, scale=round(72 / 0.0254 / scale)),
                place=place, dots=dots, ticks=ticks,
                labels=placed_labels(dots, DOT, sizes, np.where(long > DOT, -way, [0.0, 1.0]), ticks, area, before),
            )
        )  # fmt: skip
    return tuple(found)


def _sketches(sheet: _Paper, listed: PhotographList) -> None:
    """Draw both."""
    sheet.room((TALL + 20) / LINE)
    top, c = sheet.y, sheet.canvas
    for k, sketch in enumerate(sketches(listed, top)):
        left = MARGIN + k * ((WIDTH - 2 * MARGIN - GAP) / 2 + GAP)
        c.setFont(FONT, 8)
        c.setFillGray(0.3)
        left_out = len(sketch.dots) - int(sketch.labels.fits.sum())
        more = [phrase("photograph_list.in_other_sketch", n=left_out)] if left_out and k else []
        c.drawString(left, top - 9, "; ".join([sketch.words, *more]))
        c.setStrokeGray(0.55)
        c.setLineWidth(0.6)
        for a, b in listed.edges[:MOST_EDGES]:
            c.line(*sketch.place(a).tolist(), *sketch.place(b).tolist())
        _stations(c, listed, sketch)
    sheet.y = top - TALL - 6


def _stations(c: Any, listed: PhotographList, sketch: Sketch) -> None:
    labels = sketch.labels
    c.setFont(FONT, LABEL)
    for k, p in enumerate(listed.photographs):
        c.setStrokeColorRGB(*_colour(listed, p.group))
        c.setFillColorRGB(*_colour(listed, p.group))
        c.setLineWidth(0.6)
        c.circle(*sketch.dots[k].tolist(), DOT, stroke=0, fill=1)
        c.line(*sketch.ticks[k].ravel().tolist())
        if labels.led[k]:
            c.setLineWidth(0.2)
            c.line(*labels.start[k].tolist(), *labels.end[k].tolist())
        if labels.fits[k]:
            c.drawString(*labels.box[k, :2].tolist(), p.number)


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
