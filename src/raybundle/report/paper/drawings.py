"""Drawings as the typesetter takes them: their styles within them, no variables, lines of the width that pages show."""

from __future__ import annotations

import re
from functools import cache
from importlib.resources import files

from raybundle.io.reading.words import number_of
from raybundle.report.figures.svg import Drawing

FONT = "Libertinus Serif"
"""Its characters are a seventh narrower than those that the drawings were laid out for, and are set larger by that."""
LARGER = 8 / 7
_RULE = re.compile(r"(svg[^{}]*)\{([^{}]*)\}")
_TENTH = re.compile(r'class="([^"]*)" transform="scale\(\.1\)"')
_INVALID = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]")
"""What XML cannot hold."""


def printed_svg(drawing: Drawing) -> str:
    """A drawing as a document of its own."""
    body = _INVALID.sub("\ufffd", str(drawing.svg))
    body = _TENTH.sub(lambda found: _tenth(found[1]), body)
    return body.replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" ', 1).replace(">", f">{_styles()}", 1)


def size_of(drawing: Drawing) -> tuple[float, float]:
    """Width and height of a drawing [px]."""
    found = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', str(drawing.svg))
    width, height = (number_of(w) for w in found.groups()) if found else (None, None)
    return width or drawing.width, height or drawing.width


def words_of(drawing: Drawing) -> str:
    """What a drawing shows, in words."""
    found = re.search(r'aria-label="([^"]*)"', str(drawing.svg))
    return found[1] if found else ""


def _tenth(names: str) -> str:
    """Lines in tenths of a pixel keep their width on pages by `vector-effect`, which printers of SVG do not know."""
    own = {f".{n}" for n in names.split()}
    width = [w for which, w in _widths() if which <= own]
    return f'class="{names}" transform="scale(.1)" style="stroke-width:{10 * (width[-1] if width else 1.0):g}"'


@cache
def _rules() -> tuple[tuple[str, str], ...]:
    """Selectors and declarations of drawings in the style of the pages."""
    css = (files("raybundle.report") / "templates" / "style.css").read_text(encoding="utf-8")
    variables = dict(re.findall(r"(--\w+):\s*([^;]+);", css))
    css = re.sub(r"var\((--\w+)\)", lambda m: variables[m[1]], css)
    return tuple((s.strip(), d.strip()) for s, d in _RULE.findall(css.partition("@media print")[0]))


@cache
def _widths() -> tuple[tuple[frozenset[str], float], ...]:
    """Classes that a line has, and its width by that [px], in the order of the style."""
    found: list[tuple[frozenset[str], float]] = []
    for selectors, declarations in _rules():
        width = re.search(r"stroke-width: ([\d.]+)", declarations)
        if width:
            found += [(frozenset(re.findall(r"\.\w+", s)), float(width[1])) for s in selectors.split(",")]
    return tuple(found)


@cache
def _styles() -> str:
    """The style of drawings, the font of the paper in it."""
    lines = [f'svg {{ font-family: "{FONT}"; font-size: {10.5 * LARGER:g}px }}']
    for selectors, declarations in _rules():
        if selectors == "svg":
            continue
        kept = [d.strip() for d in declarations.split(";") if d.strip() and not d.strip().startswith("vector-effect")]
        kept = [re.sub(r"(font-size: )([\d.]+)", lambda m: f"{m[1]}{float(m[2]) * LARGER:.3g}", d) for d in kept]
        lines.append(f"{selectors} {{ {'; '.join(kept)} }}")
    return f"<style>{' '.join(lines)}</style>"
