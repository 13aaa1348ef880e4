"""Symbols of points, lines of their kinds, north arrow and register marks."""

from __future__ import annotations

from typing import Any

SIZE = 1.3
"""Half the size of a symbol [mm]"""
INK: dict[str, tuple[float, float, float]] = {
    "control": (0.80, 0.10, 0.10), "check": (0.10, 0.25, 0.75), "point": (0.0, 0.0, 0.0), "tie": (0.35, 0.35, 0.35),
}  # fmt: skip
LINE_INK: dict[str, tuple[float, float, float]] = {
    "distance": (0.55, 0.25, 0.0), "plumb line": (0.0, 0.35, 0.6), "level": (0.0, 0.45, 0.45),
    "straight line": (0.0, 0.0, 0.0), "plane": (0.4, 0.0, 0.5),
}  # fmt: skip
DASHES: dict[str, list[float]] = {"distance": [2.0, 1.0], "plumb line": [4.0, 1.0, 0.6, 1.0], "level": [0.6, 0.8]}
HALO = 0.5
"""White round what is drawn on a picture [mm]"""


def draw_symbol(c: Any, kind: str, x: float, y: float) -> None:
    """A point: control a triangle, check points a square, measured ones a cross, tie points a dot."""
    for halo in (True, False):
        if kind == "tie":
            if halo:
                continue
            c.setFillColorRGB(*INK[kind])
            c.circle(x, y, 0.18, stroke=0, fill=1)
            continue
        if halo:
            c.setStrokeGray(1)
            c.setLineWidth(0.25 + 2 * HALO)
        else:
            c.setStrokeColorRGB(*INK.get(kind, INK["point"]))
            c.setLineWidth(0.3)
        s = SIZE
        if kind == "control":
            _closed(c, ((x - s, y - 0.7 * s), (x + s, y - 0.7 * s), (x, y + s)))
        elif kind == "check":
            c.rect(x - 0.8 * s, y - 0.8 * s, 1.6 * s, 1.6 * s, stroke=1, fill=0)
        else:
            c.line(x - s, y, x + s, y)
            c.line(x, y - s, x, y + s)
    if kind in {"control", "check"}:
        c.setFillColorRGB(*INK[kind])
        c.circle(x, y, 0.2, stroke=0, fill=1)


def draw_line(c: Any, kind: str, xy: list[tuple[float, float]], *, closed: bool) -> None:
    """A line of its kind, white beneath."""
    for halo in (True, False):
        if halo:
            c.setStrokeGray(1)
            c.setLineWidth(0.35 + HALO)
            c.setDash([], 0)
        else:
            c.setStrokeColorRGB(*LINE_INK.get(kind, (0.0, 0.0, 0.0)))
            c.setLineWidth(0.35)
            c.setDash(DASHES.get(kind, []), 0)
        _closed(c, xy) if closed else _open(c, xy)
    c.setDash([], 0)


def draw_words(c: Any, words: str, x: float, y: float, font: str, size: float) -> None:
    """Words in black on a white rim, so that they can be read on a picture."""
    c.saveState()
    c.setStrokeGray(1)
    c.setLineWidth(0.3 * size)
    c.setLineJoin(1)
    c.setFont(font, size)
    c.drawString(x, y, words, mode=1)
    c.restoreState()
    c.saveState()
    c.setFillGray(0)
    c.setFont(font, size)
    c.drawString(x, y, words, mode=0)
    c.restoreState()


def draw_north(c: Any, x: float, y: float, size: float, font: str) -> None:
    """An arrow to grid north with its foot there."""
    c.setStrokeGray(0)
    c.setLineWidth(0.3)
    tip, foot, half = y + size, y, 0.22 * size
    path = c.beginPath()
    path.moveTo(x, tip)
    path.lineTo(x - half, foot)
    path.lineTo(x, foot + 0.25 * size)
    path.close()
    c.setFillGray(0)
    c.drawPath(path, stroke=1, fill=1)
    path = c.beginPath()
    path.moveTo(x, tip)
    path.lineTo(x + half, foot)
    path.lineTo(x, foot + 0.25 * size)
    path.close()
    c.setFillGray(1)
    c.drawPath(path, stroke=1, fill=1)
    c.setFillGray(0)
    c.setFont(font, 3.2)
    c.drawCentredString(x, tip + 0.8, "N")


def draw_register(c: Any, x: float, y: float) -> None:
    """A mark that stands at the same place of the object on neighbouring sheets."""
    for grey, width in ((1.0, 0.9), (0.0, 0.2)):
        c.setStrokeGray(grey)
        c.setLineWidth(width)
        c.circle(x, y, 2.0, stroke=1, fill=0)
        c.line(x - 3.5, y, x + 3.5, y)
        c.line(x, y - 3.5, x, y + 3.5)


def _closed(c: Any, xy: Any) -> None:
    path = _path(c, xy)
    path.close()
    c.drawPath(path, stroke=1, fill=0)


def _open(c: Any, xy: Any) -> None:
    c.drawPath(_path(c, xy), stroke=1, fill=0)


def _path(c: Any, xy: Any) -> Any:
    path = c.beginPath()
    path.moveTo(*xy[0])
    for place in xy[1:]:
        path.lineTo(*place)
    return path
