"""Sheets of boards and square tags as plain geometry, drawn by `sheets`."""

from __future__ import annotations

import math
from collections.abc import Sequence

import cv2
import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.numerics.arrays import Array
from raybundle.targets.kinds import photomodeler
from raybundle.targets.kinds.charuco import Charuco
from raybundle.targets.kinds.chessboard import Chessboard
from raybundle.targets.kinds.circles import Circles
from raybundle.targets.kinds.tags import Tags, dictionary
from raybundle.targets.layout import (
    FOOT,
    MARGIN,
    WORDS,
    Disc,
    Outline,
    Page,
    Placed,
    Sheet,
    SheetOptions,
    Words,
    bar_length,
    box,
    foot,
    paper_size,
    printed,
    spread,
)
from raybundle.targets.marks import Target

Shape = Disc | Outline | Words
GROUND = 2.2
"""Dark ground around light dots, in radii of the dots."""


def design_board(target: Target, spacing_mm: float, options: SheetOptions) -> Sheet:
    """A chessboard, ChArUco board or raster of dots on one page; raises InputError where it does not fit.

    spacing_mm  side of a square, or distance of neighbouring dots (staggered: half of it within a row)
    """
    if not spacing_mm > 0:
        raise InputError("sheet.spacing_not_positive", spacing_mm=spacing_mm)
    _dark(options)
    size, origin, shapes = _drawn(target, spacing_mm, options)
    width, height = paper_size(options.paper, options.orientation)
    room = np.array([width - 2 * MARGIN, height - 2 * MARGIN - FOOT])
    if (size * spacing_mm > room).any():
        raise InputError(
            "sheet.board_too_large",
            board=target.family,
            spacing_mm=spacing_mm,
            width_mm=size[0] * spacing_mm,
            height_mm=size[1] * spacing_mm,
            paper=options.paper,
            room_width_mm=room[0],
            room_height_mm=room[1],
            most_mm=(room / size).min(),
        )
    left, top = width / 2 - size[0] * spacing_mm / 2, (height + FOOT) / 2 + size[1] * spacing_mm / 2
    corner = np.array([left, top])
    points = tuple(
        Placed(name=n, code=-1, x_mm=float(x), y_mm=float(y))
        for n, p in target.objects.items()
        for x, y in [corner + spacing_mm * (p[:2] + np.array([origin[0], -origin[1]]))]
    )
    bar = bar_length(width)
    text = phrase("target_sheet.foot", target=target.family, quantity="spacing", size_mm=spacing_mm, page=0)
    page = Page(
        width=width, height=height, targets=points, bar_mm=bar,
        shapes=(*(_placed(s, corner, spacing_mm) for s in shapes), *foot(width, bar, text)),
    )  # fmt: skip
    return Sheet(
        family=target.family, title=target.title, options=options, spacing_mm=spacing_mm, pages=(page,),
        dot_radius_mm=options.dot_radius_mm if isinstance(target, Circles | photomodeler.Sheet) else math.nan,
        printed=printed((page,), options.tile),
    )  # fmt: skip


def design_tags(target: Tags, ids: Sequence[int], side_mm: float, options: SheetOptions) -> Sheet:
    """Square tags in rows; raises InputError where not even one fits, or the dictionary has no such tag."""
    tags = dictionary(target.name)
    count = len(tags.bytesList)
    if not side_mm > 0:
        raise InputError("sheet.side_not_positive", side_mm=side_mm)
    for i in ids:
        if not 0 <= i < count:
            raise InputError("sheet.no_such_tag", family=target.name, tag=i, last=count - 1)
    _dark(options)
    n = tags.markerSize + 2
    width, height = paper_size(options.paper, options.orientation)
    pitch, line = side_mm * (n + 2) / n, 1.8 * WORDS
    columns, rows = int((width - 2 * MARGIN) // pitch), int((height - 2 * MARGIN - FOOT) // (pitch + line))
    if columns < 1 or rows < 1:
        raise InputError("sheet.tag_too_large", side_mm=side_mm, paper=options.paper)
    pages: list[Page] = []
    for first in range(0, len(ids), columns * rows):
        shapes: list[Shape] = []
        points: list[Placed] = []
        part = ids[first : first + columns * rows]
        places = spread(len(part), (columns, rows), (pitch, pitch + line), (width, height))
        for number, (middle, top) in zip(part, places, strict=True):
            x, y = middle - side_mm / 2, top - side_mm / n
            at = np.array([x, y])
            shapes += [_placed(s, at, side_mm) for s in _tag(target.name, number, np.zeros(2), 1.0)]
            shapes.append(
                Words(x=x + side_mm / 2, y=y - pitch + side_mm / n - 1.2 * WORDS, text=f"{target.name}  {number}")
            )
            corners = at + side_mm * np.array([[0, 0], [1, 0], [1, -1], [0, -1]])
            points += [
                Placed(name=f"{number}/{c + 1}", code=number, x_mm=float(p[0]), y_mm=float(p[1]))
                for c, p in enumerate(corners)
            ]
        bar = bar_length(width)
        text = phrase("target_sheet.foot", target=target.name, quantity="side", size_mm=side_mm, page=len(pages) + 1)
        shapes += foot(width, bar, text)
        pages.append(Page(width=width, height=height, shapes=tuple(shapes), targets=tuple(points), bar_mm=bar))
    return Sheet(
        family=target.family, title=target.title, options=options, spacing_mm=side_mm, dot_radius_mm=math.nan,
        pages=tuple(pages), printed=printed(tuple(pages), options.tile),
    )  # fmt: skip


def design_dots(spacing_mm: float, count: int | None, options: SheetOptions) -> Sheet:
    """Dots without a code in rows and columns on one page; raises InputError where they do not fit.

    count  of dots, by rows from the upper left one; None: as many as there is room for
    """
    o = options
    width, height = paper_size(o.paper, o.orientation)
    dark = o.polarity == "dark"
    edge = (GROUND if not dark else 1.3) * o.dot_radius_mm
    room = np.array([width - 2 * MARGIN, height - 2 * MARGIN - FOOT]) - 2 * edge
    if not 0 < 2.6 * o.dot_radius_mm < spacing_mm:
        raise InputError(
            "sheet.dots_too_large", radius_mm=o.dot_radius_mm, spacing_mm=spacing_mm, most_mm=spacing_mm / 2.6
        )
    columns, rows = (1 + int(r // spacing_mm) if r >= 0 else 0 for r in room)
    most = columns * rows
    if most < 1 or (count or 1) > most:
        raise InputError("sheet.too_many_dots", paper=o.paper, most=most, spacing_mm=spacing_mm, n=count or 1)
    place = [divmod(k, columns) for k in range(count or most)]
    left = width / 2 - (columns - 1) / 2 * spacing_mm
    top = height - MARGIN - edge
    at = [(f"r{r}c{c}", left + c * spacing_mm, top - r * spacing_mm) for r, c in place]
    shapes: list[Shape] = []
    if not dark:
        low, high = np.min([a[1:] for a in at], axis=0) - edge, np.max([a[1:] for a in at], axis=0) + edge
        shapes.append(box(*low, *(high - low)))
    shapes += [Disc(x=x, y=y, radius=o.dot_radius_mm, black=dark) for _, x, y in at]
    bar = bar_length(width)
    shapes += foot(width, bar, phrase("target_sheet.dots_foot", radius_mm=o.dot_radius_mm))
    points = tuple(Placed(name=n, code=-1, x_mm=float(x), y_mm=float(y)) for n, x, y in at)
    page = Page(width=width, height=height, shapes=tuple(shapes), targets=points, bar_mm=bar)
    return Sheet(
        family="dots", title="dots without a code", options=o, spacing_mm=spacing_mm, dot_radius_mm=o.dot_radius_mm,
        pages=(page,), printed=printed((page,), o.tile),
    )  # fmt: skip


def _dark(options: SheetOptions) -> None:
    if options.polarity != "dark":
        raise InputError("sheet.boards_are_dark")


def _drawn(target: Target, spacing: float, o: SheetOptions) -> tuple[Array, Array, list[Shape]]:
    """Size of a board (2,), its first point (2,) from its upper left corner, its shapes; in spacings, y down."""
    if isinstance(target, Chessboard):
        size = np.array([target.columns + 1, target.rows + 1])
        dark = [(i, j) for i in range(size[0]) for j in range(size[1]) if (i + j) % 2 == 0]
        return size, np.array([1.0, 1.0]), [box(i, j, 1, 1) for i, j in dark]
    if isinstance(target, Charuco):
        return np.array([target.columns, target.rows]), np.array([1.0, 1.0]), _charuco(target)
    if isinstance(target, Circles):
        places = np.array([p[:2] * [1, -1] for p in target.objects.values()])
        step = math.sqrt(2) if target.staggered else 1.0
        if not 0 < 2.6 * o.dot_radius_mm < step * spacing:
            raise InputError(
                "sheet.dots_too_large", radius_mm=o.dot_radius_mm, spacing_mm=spacing, most_mm=step * spacing / 2.6
            )
        discs: list[Shape] = [Disc(x=x + 0.5, y=y + 0.5, radius=o.dot_radius_mm / spacing) for x, y in places]
        return places.max(axis=0) + 1, np.array([0.5, 0.5]), discs
    if isinstance(target, photomodeler.Sheet):
        return _photomodeler(target, spacing, o)
    raise InputError("sheet.not_printable", family=target.family)


def _photomodeler(target: photomodeler.Sheet, spacing: float, o: SheetOptions) -> tuple[Array, Array, list[Shape]]:
    """Dots, and four of them within arcs, which take the room to the next dots."""
    radius = o.dot_radius_mm / spacing
    inner, outer = photomodeler.RING
    if not 0 < radius * (outer + 1.6) <= 1:
        raise InputError(
            "sheet.dots_too_large",
            radius_mm=o.dot_radius_mm,
            spacing_mm=spacing,
            most_mm=np.floor(10 * spacing / (outer + 1.6)) / 10,
        )
    shapes: list[Shape] = [Disc(x=p[0] + 0.5, y=0.5 - p[1], radius=radius) for p in target.objects.values()]
    for count, (column, row) in photomodeler.CONTROL.items():
        width = 2 * np.pi * photomodeler.FILLED[count] / count
        for k in range(count):
            t = 2 * np.pi * k / count + np.linspace(0, width, 60)
            u = np.stack([np.cos(t), np.sin(t)], axis=1)
            arc = radius * np.concatenate([outer * u, inner * u[::-1]])
            shapes.append(Outline(xy=np.array([column, row]) + 0.5 + arc))
    return np.array([photomodeler.SIDE, photomodeler.SIDE]), np.array([0.5, 0.5]), shapes


def _charuco(target: Charuco) -> list[Shape]:
    board = target.board(old=False)
    corners = [np.asarray(c)[:, :2] for c in board.getObjPoints()]
    light = {tuple(np.floor(c.mean(axis=0)).astype(int).tolist()) for c in corners}
    shapes: list[Shape] = [
        box(i, j, 1, 1) for i in range(target.columns) for j in range(target.rows) if (i, j) not in light
    ]
    for c, number in zip(corners, board.getIds().ravel(), strict=True):
        shapes += _tag(target.dictionary, int(number), c.min(axis=0), target.ratio)
    return shapes


def _tag(name: str, number: int, corner: Array, side: float) -> list[Shape]:
    """A tag as one dark square and light strips on it; y down from its upper left corner."""
    tags = dictionary(name)
    n = tags.markerSize + 2
    cells = np.asarray(cv2.aruco.generateImageMarker(tags, number, n)) > 127
    x, y = corner
    shapes: list[Shape] = [box(x, y, side, side)]
    for j, row in enumerate(cells):
        edges = np.flatnonzero(np.diff(np.concatenate([[0], row.astype(int), [0]])))
        for a, b in edges.reshape(-1, 2):
            shapes.append(box(x + a * side / n, y + j * side / n, (b - a) * side / n, side / n, black=False))
    return shapes


def _placed(shape: Shape, corner: Array, scale: float) -> Shape:
    """From spacings, y down, to the millimetres of a page, y up."""
    if isinstance(shape, Outline):
        return Outline(xy=corner + scale * shape.xy * [1, -1], black=shape.black)
    if isinstance(shape, Disc):
        return Disc(
            x=corner[0] + scale * shape.x, y=corner[1] - scale * shape.y, radius=scale * shape.radius, black=shape.black
        )
    return shape
