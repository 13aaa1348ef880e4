"""Letters of drawing sheets: DejaVu Sans Condensed, embedded, with Latin, Greek and Cyrillic."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any
from unicodedata import bidirectional

from raybundle.errors import InputError

PLAIN, BOLD = "DejaVuSansCondensed", "DejaVuSansCondensed-Bold"
FOLDER = Path(__file__).parent / "fonts"
CUT = "…"


def load_fonts() -> None:
    """Make the fonts known to reportlab; raises InputError where it is missing."""
    try:
        from reportlab.pdfbase import pdfmetrics
        from reportlab.pdfbase.ttfonts import TTFont
    except ImportError as error:
        raise InputError("package.reportlab_missing") from error
    for name in (PLAIN, BOLD):
        if name not in pdfmetrics.getRegisteredFontNames():
            pdfmetrics.registerFont(TTFont(name, FOLDER / f"{name}.ttf"))


@lru_cache(maxsize=1)
def _known() -> frozenset[int]:
    from reportlab.pdfbase import pdfmetrics

    face: Any = pdfmetrics.getFont(PLAIN)
    # letters that are read from right to left would stand in the wrong order
    return frozenset(c for c in face.face.charToGlyph if bidirectional(chr(c)) not in {"R", "AL"})


def shown(text: str) -> str:
    """A text of one line in letters that can be set; any other becomes "?"."""
    line = " ".join(text.split())
    return line.translate(dict.fromkeys(map(ord, lacking(line)), "?"))


def lacking(text: str) -> str:
    """The letters of a text that cannot be set, each once: the font does not have them, or not from right to left."""
    load_fonts()
    known = _known()
    return "".join(dict.fromkeys(c for c in text if not c.isspace() and not (ord(c) in known and c.isprintable())))


def width(text: str, size: float, font: str = PLAIN) -> float:
    """Of a line, in the unit of its size."""
    from reportlab.pdfbase.pdfmetrics import stringWidth

    return float(stringWidth(text, font, size))


def wrapped(text: str, size: float, room: float, most: int, font: str = PLAIN) -> list[str]:
    """A text in lines no wider than `room`, at most so many: what is left over is cut off, which "…" states.

    A word that is wider than the room is broken.
    """
    text = shown(text)
    lines: list[str] = []
    line = ""
    for word in text.split():
        rest = word
        while rest:
            tried = f"{line} {rest}".strip()
            if width(tried, size, font) <= room:
                line, rest = tried, ""
            elif line:
                lines.append(line)
                line = ""
            else:
                count = max(_fitting(rest, size, room, font), 1)
                lines.append(rest[:count])
                rest = rest[count:]
            if len(lines) > most:
                return _cut(lines[:most], size, room, font)
    lines += [line] if line else []
    return lines if len(lines) <= most else _cut(lines[:most], size, room, font)


def _fitting(word: str, size: float, room: float, font: str) -> int:
    """How many letters of a word fit in."""
    low, high = 0, len(word)
    while low < high:
        middle = (low + high + 1) // 2
        low, high = (middle, high) if width(word[:middle], size, font) <= room else (low, middle - 1)
    return low


def _cut(lines: list[str], size: float, room: float, font: str) -> list[str]:
    last = lines[-1]
    while last and width(last + CUT, size, font) > room:
        last = last[:-1]
    return [*lines[:-1], last.rstrip() + CUT]
