"""Sheets of targets as plain geometry: pages of circles, outlines and words in millimetres, drawn by `sheets`."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from raybundle.errors import InputError, joined_texts, phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.targets.codes import RingFamily, sectors

PAPERS = {"A0": (841, 1189), "A1": (594, 841), "A2": (420, 594), "A3": (297, 420), "A4": (210, 297)}
"""Width and height, upright [mm] (ISO 216)."""
MARGIN = 10.0
"""Unprinted edge of a page [mm]."""
FOOT = 16.0
"""Height of the line with the scale bar [mm]."""
OVERLAP = 10.0
"""What neighbouring tiles share [mm]."""
WORDS = 2.6
"""Height of the letters [mm]."""
ARC = np.radians(1.0)
"""Pieces of an arc: 0.04 thousandths of the radius from the circle."""
BARS = (500.0, 200.0, 100.0, 50.0, 20.0)

Orientation = Literal["upright", "lying"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Disc:
    """A filled circle."""

    x: float
    y: float
    radius: float
    black: bool = True


@dataclass(frozen=True, slots=True, kw_only=True)
class Outline:
    """A filled polygon (n, 2)."""

    xy: Array
    black: bool = True


@dataclass(frozen=True, slots=True, kw_only=True)
class Words:
    """A line of text, centred at x, standing on y."""

    x: float
    y: float
    text: str
    size: float = WORDS


@dataclass(frozen=True, slots=True, kw_only=True)
class Placed:
    """A target, or a point of a board, on a page."""

    name: str
    code: int
    """-1 for a point of a board"""
    x_mm: float
    y_mm: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Page:
    """One page; origin at the lower left corner of the paper, y up [mm]."""

    width: float
    height: float
    shapes: tuple[Disc | Outline | Words, ...]
    targets: tuple[Placed, ...] = ()
    bar_mm: float = 0.0
    part: str = ""
    """where this tile lies in a larger page: column and row from the lower left"""


@dataclass(frozen=True, slots=True, kw_only=True)
class SheetOptions:
    """What is printed on what."""

    dot_radius_mm: float = 5.0
    paper: str = "A4"
    orientation: Orientation = "upright"
    polarity: Literal["dark", "light"] = "dark"
    """dark: black on the white of the paper; light: white on black"""
    tile: str = ""
    """paper of the printer, where it is smaller than the sheet; the parts overlap by 10 mm"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Sheet:
    """All pages, and what is on them."""

    family: str
    title: str
    options: SheetOptions
    dot_radius_mm: float
    """NaN without dots"""
    ring_radii_mm: tuple[float, ...] = ()
    spacing_mm: float = math.nan
    """of a board; side of square tags"""
    bits: int = 0
    """sectors of rings by a table of one's own, whose codes must go with the sheet; 0: the family's name states all"""
    pages: tuple[Page, ...]
    """as designed, before they are cut into tiles"""
    printed: tuple[Page, ...] = field(default=())
    """as printed"""


def paper_size(name: str, orientation: Orientation = "upright") -> tuple[float, float]:
    """Width and height [mm]; raises InputError."""
    if name.upper() not in PAPERS:
        raise InputError("sheet.unknown_paper", name=str(name), known=list(PAPERS))
    w, h = PAPERS[name.upper()]
    return (float(h), float(w)) if orientation == "lying" else (float(w), float(h))


def design(family: RingFamily, ids: Index, options: SheetOptions) -> Sheet:
    """Targets in rows, as many to a page as there is room for; raises InputError where not even one fits."""
    o = options
    width, height = paper_size(o.paper, o.orientation)
    if not o.dot_radius_mm > 0:
        raise InputError("sheet.dot_radius_not_positive", radius_mm=o.dot_radius_mm)
    side = 2 * family.ground * o.dot_radius_mm
    line = 1.8 * WORDS
    columns = int((width - 2 * MARGIN) // side)
    rows = int((height - 2 * MARGIN - FOOT) // (side + line))
    if columns < 1 or rows < 1:
        most = min((width - 2 * MARGIN) / 2, (height - 2 * MARGIN - FOOT - line) / 2) / family.ground
        raise InputError(
            "sheet.target_too_large",
            radius_mm=o.dot_radius_mm,
            side_mm=side,
            paper=o.paper,
            width_mm=width,
            height_mm=height,
            most_mm=most,
        )
    codes = family.code_of(ids)
    pages: list[Page] = []
    for first in range(0, len(ids), columns * rows):
        shapes: list[Disc | Outline | Words] = []
        targets: list[Placed] = []
        last = min(first + columns * rows, len(ids))
        places = spread(last - first, (columns, rows), (side, side + line), (width, height))
        for k in range(first, last):
            x, top = places[k - first]
            y = top - side / 2
            shapes += target_shapes(family, int(codes[k]), x, y, o)
            shapes.append(Words(x=x, y=y - side / 2 - 1.2 * WORDS, text=f"{family.name}  {int(ids[k])}"))
            targets.append(Placed(name=str(int(ids[k])), code=int(codes[k]), x_mm=x, y_mm=y))
        bar = bar_length(width)
        text = phrase(
            "target_sheet.foot", target=family.title, quantity="radius", size_mm=o.dot_radius_mm, page=len(pages) + 1
        )
        shapes += foot(width, bar, text)
        pages.append(Page(width=width, height=height, shapes=tuple(shapes), targets=tuple(targets), bar_mm=bar))
    return Sheet(
        family=family.name, title=family.title, options=o, dot_radius_mm=o.dot_radius_mm,
        ring_radii_mm=(family.ring[0] * o.dot_radius_mm, family.ring[1] * o.dot_radius_mm),
        bits=0 if family.rule is not None else family.bits,
        pages=tuple(pages), printed=printed(pages, o.tile),
    )  # fmt: skip


def spread(
    count: int, most: tuple[int, int], cell: tuple[float, float], page: tuple[float, float]
) -> list[tuple[float, float]]:
    """Middle and upper edge of so many cells [mm], by rows: close together on a full page, else over all of it.

    most  columns and rows for which there is room
    cell  width and height of a cell, with its line of words

    Few targets in a corner of a sheet would hold the network by that corner.
    """
    columns, rows = most
    room = page[0] - 2 * MARGIN, page[1] - 2 * MARGIN - FOOT
    if count == columns * rows:
        return [
            (page[0] / 2 + (k % columns - (columns - 1) / 2) * cell[0], page[1] - MARGIN - k // columns * cell[1])
            for k in range(count)
        ]

    def apart(c: int) -> float:
        return min(room[0] / c, room[1] / -(-count // c))

    fitting = [c for c in range(1, columns + 1) if -(-count // c) <= rows]
    best = max(fitting, key=lambda c: (apart(c), -c))
    lines = -(-count // best)
    places: list[tuple[float, float]] = []
    for row in range(lines):
        own = min(best, count - row * best)
        y = page[1] - MARGIN - (row + 0.5) * room[1] / lines + cell[1] / 2
        places += [(MARGIN + (column + 0.5) * room[0] / own, y) for column in range(own)]
    return places


def printed(pages: Sequence[Page], tile: str) -> tuple[Page, ...]:
    """Pages as they leave the printer."""
    return tuple(t for p in pages for t in (tiles(p, tile) if tile else [p]))


def bar_length(width: float) -> float:
    """Of the scale bar on a page of this width [mm]."""
    return next((b for b in BARS if b <= width - 2 * MARGIN - 20), BARS[-1])


def target_shapes(family: RingFamily, code: int, x: float, y: float, o: SheetOptions) -> list[Disc | Outline | Words]:
    """Dot and ring, on their ground where it is black."""
    r, dark = o.dot_radius_mm, o.polarity == "dark"
    shapes: list[Disc | Outline | Words] = []
    if not dark:
        h = 0.98 * family.ground * r
        shapes.append(Outline(xy=np.array([x, y]) + h * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])))
    shapes.append(Disc(x=x, y=y, radius=r, black=dark))
    for begin, end in sectors(code, family.bits) * 2 * np.pi / family.bits:
        t = np.linspace(begin, end, 2 + int((end - begin) / ARC))
        u = np.stack([np.cos(t), np.sin(t)], axis=1)
        ring = np.concatenate([family.ring[1] * u, family.ring[0] * u[::-1]])
        shapes.append(Outline(xy=np.array([x, y]) + r * ring, black=dark))
    return shapes


def foot(width: float, bar: float, text: str) -> list[Disc | Outline | Words]:
    """A scale bar with its length, and what is printed."""
    x0, y0 = width / 2 - bar / 2, MARGIN + 6.0
    shapes: list[Disc | Outline | Words] = [box(x0, y0, bar, 0.3)]
    ticks = 10 if bar >= 50 else 4
    for k in range(ticks + 1):
        h = 3.0 if k in {0, ticks} else 1.5
        shapes.append(box(x0 + k * bar / ticks - 0.05, y0, 0.1, h))
    shapes.append(Words(x=width / 2, y=y0 + 3.6, text=phrase("target_sheet.scale_bar", length_mm=bar)))
    shapes.append(Words(x=width / 2, y=MARGIN, text=text))
    return shapes


def box(x: float, y: float, w: float, h: float, *, black: bool = True) -> Outline:
    """A filled rectangle."""
    return Outline(xy=np.array([[x, y], [x + w, y], [x + w, y + h], [x, y + h]]), black=black)


def tiles(page: Page, paper: str) -> list[Page]:
    """A page cut into parts for a smaller printer, with crosses where the parts meet."""
    w, h = paper_size(paper)
    if w >= page.width and h >= page.height:
        return [page]
    inner = np.array([w, h]) - 2 * MARGIN
    step = inner - OVERLAP
    count = np.maximum(1, np.ceil((np.array([page.width, page.height]) - OVERLAP) / step)).astype(int)
    crosses: list[Disc | Outline | Words] = []
    for i in range(count[0] + 1):
        for j in range(count[1] + 1):
            x, y = i * step[0] + OVERLAP / 2, j * step[1] + OVERLAP / 2
            crosses += [box(x - 3, y - 0.05, 6, 0.1), box(x - 0.05, y - 3, 0.1, 6)]
    parts: list[Page] = []
    for j in range(count[1]):
        for i in range(count[0]):
            low = np.array([i, j]) * step
            moved = tuple(_moved(s, MARGIN - low) for s in (*page.shapes, *crosses))
            within = tuple(s for s in moved if _touches(s, w, h))
            columns, rows = count.tolist()
            name = phrase("target_sheet.part", x=i + 1, y=j + 1, columns=columns, rows=rows)
            text = joined_texts(name, phrase("target_sheet.overlap", overlap_mm=OVERLAP))
            label = Words(x=w / 2, y=3.0, text=text)
            parts.append(Page(width=w, height=h, shapes=(*within, label), bar_mm=0.0, part=name))
    return parts


def _moved(shape: Disc | Outline | Words, by: Array) -> Disc | Outline | Words:
    if isinstance(shape, Outline):
        return Outline(xy=shape.xy + by, black=shape.black)
    if isinstance(shape, Disc):
        return Disc(x=shape.x + by[0], y=shape.y + by[1], radius=shape.radius, black=shape.black)
    return Words(x=shape.x + by[0], y=shape.y + by[1], text=shape.text, size=shape.size)


def _touches(shape: Disc | Outline | Words, w: float, h: float) -> bool:
    if isinstance(shape, Outline):
        low, high = shape.xy.min(axis=0), shape.xy.max(axis=0)
    else:
        reach = shape.radius if isinstance(shape, Disc) else 0.3 * shape.size * len(shape.text)
        low, high = np.array([shape.x, shape.y]) - reach, np.array([shape.x, shape.y]) + reach
    return bool((high > 0).all() and low[0] < w and low[1] < h)
