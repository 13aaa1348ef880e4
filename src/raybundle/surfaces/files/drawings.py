"""Drawings of heights as SVG: profiles with their band, contour lines with their heights."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.surfaces.heights.contours import Contour
from raybundle.surfaces.heights.sections import Section

BAND = 1.96
"""Standard deviations of the band: 95 %"""
WIDTH, PANEL, LEFT, RIGHT, TOP, BOTTOM = 900.0, 300.0, 84.0, 24.0, 40.0, 56.0
"""Of a profile and its margins [px]"""
STYLE = (
    "text{font:13px system-ui,sans-serif;fill:#333}.small{font-size:11px;fill:#666}.grid{stroke:#e4e4e4;stroke-width:1}"
    ".axis{stroke:#888;stroke-width:1;fill:none}.band{fill:#4a7fb5;fill-opacity:.28;stroke:none}"
    ".line{stroke:#12365c;stroke-width:1.4;fill:none;stroke-linejoin:round}.bar{stroke:#12365c;stroke-width:1.4}"
    ".dot{fill:#12365c}.corner{stroke:#b55;stroke-dasharray:3 3}"
    ".thin{stroke:#8a6d4b;stroke-width:.7;fill:none}.thick{stroke:#6b4f2c;stroke-width:1.4;fill:none}"
    ".name{font-size:10px;fill:#6b4f2c;paint-order:stroke;stroke:#fff;stroke-width:3px}"
)
FONT = 'font-family="sans-serif"'
PLAIN = f'{FONT} font-size="13" fill="#333"'
RIM = {"paint-order", "stroke", "stroke-width"}
"""Of names, white: programs that heed no style sheet may draw it over the letters"""
EVERY = 5
"""Contour lines from one thick one to the next"""


def _attributes(name: str, rule: str) -> str:
    """A rule of the style sheet for programs that heed none, as MuPDF, and draw all in black."""
    entries = [r.split(":") for r in rule.split(";")]
    entries = [(k, v.removesuffix("px")) for k, v in entries if name != "name" or k not in RIM]
    font = [FONT] if any(k == "font-size" for k, _ in entries) else []
    return " ".join([*font, *(f'{k}="{v}"' for k, v in entries)])


ATTRIBUTES = {name: _attributes(name, rule) for name, rule in re.findall(r"\.(\w+)\{([^}]*)\}", STYLE)}
"""By class"""


def ticks(low: float, high: float, count: int) -> tuple[Array, int]:
    """Round numbers between two, about so many, and the decimals that they need."""
    step = (high - low) / max(count, 1)
    if not step > 0:
        return np.array([low]), 3
    power = 10.0 ** np.floor(np.log10(step))
    step = next(f * power for f in (1, 2, 5, 10) if f * power >= step * (1 - 1e-9))
    # 0.0 is added so that no zero has a sign
    values = np.arange(np.ceil(low / step - 1e-9), np.floor(high / step + 1e-9) + 1) * step + 0.0
    return values, max(0, -int(np.floor(np.log10(step) + 1e-9)))


@dataclass(frozen=True, slots=True, kw_only=True)
class Frame:
    """From distance and height to the sheet, of one panel."""

    low: float
    high: float
    length: float
    top: float

    def x(self, distance: Array) -> Array:
        """On the sheet."""
        return LEFT + (WIDTH - LEFT - RIGHT) * np.asarray(distance) / max(self.length, 1e-300)

    def y(self, height: Array | float) -> Array:
        """On the sheet."""
        inner = PANEL - TOP - BOTTOM
        return self.top + TOP + inner * (self.high - np.asarray(height)) / (self.high - self.low)


def sections_svg(sections: Sequence[Section], names: Sequence[str], unit: str) -> str:
    """Profiles below each other, each with the band in which 95 % of the surface lies."""
    parts = [_panel(s, name, unit, k * PANEL) for k, (s, name) in enumerate(zip(sections, names, strict=True))]
    return sheet(WIDTH, PANEL * len(sections), "".join(parts))


def _panel(s: Section, name: str, unit: str, top: float) -> str:
    known = np.isfinite(s.height)
    length = float(s.distance[-1])
    if not known.any():
        without = escape(phrase("height_drawing.no_height", name=name))
        return f'<text x="{LEFT}" y="{top + PANEL / 2:.0f}">{without}</text>'
    low, high = float((s.height - BAND * s.sigma)[known].min()), float((s.height + BAND * s.sigma)[known].max())
    # a step has a wide band: what is measured is to be seen, the band as far as it fits
    span = float(np.ptp(s.height[known]))
    reach = max(0.25 * span, float(3 * BAND * np.median(s.sigma[known])), 1e-9)
    low, high = max(low, float(s.height[known].min()) - reach), min(high, float(s.height[known].max()) + reach)
    f = Frame(low=low - 0.04 * (high - low), high=high + 0.04 * (high - low), length=length, top=top)
    out = [f'<text x="{LEFT}" y="{top + 22:.0f}">{escape(name)}</text>']
    out += level_lines(f)
    bottom = top + PANEL - BOTTOM
    places, digits = ticks(0, length, 9)
    for v in places.tolist():
        x = float(f.x(v))
        out.append(f'<line class="grid" x1="{x:.1f}" x2="{x:.1f}" y1="{top + TOP}" y2="{bottom}"/>')
        out.append(f'<text class="small" x="{x:.1f}" y="{bottom + 17:.0f}" text-anchor="middle">{v:.{digits}f}</text>')
    run = np.cumsum(np.linalg.norm(np.diff(s.corners, axis=0), axis=1)) * s.model.cell
    for v in run[:-1].tolist():
        x = float(f.x(v))
        out.append(f'<line class="corner" x1="{x:.1f}" x2="{x:.1f}" y1="{top + TOP}" y2="{bottom}"/>')
    for part in runs(known):
        x, h, q = f.x(s.distance[part]), s.height[part], BAND * s.sigma[part]
        up, down = (np.clip(f.y(h + k * q), top + TOP, bottom) for k in (1, -1))
        edge = points(np.concatenate([x, x[::-1]]), np.concatenate([up, down[::-1]]))
        out.append(f'<polygon class="band" points="{edge}"/><polyline class="line" points="{points(x, f.y(h))}"/>')
    right = WIDTH - RIGHT
    out.append(f'<rect class="axis" x="{LEFT}" y="{top + TOP}" width="{right - LEFT}" height="{bottom - top - TOP}"/>')
    across, along = (
        escape(phrase("height_drawing.axis", axis=axis, unit=unit or "none")) for axis in ("distance", "height")
    )
    middle = (LEFT + right) / 2
    out.append(f'<text x="{middle}" y="{bottom + 38:.0f}" text-anchor="middle">{across}</text>')
    y = (top + TOP + bottom) / 2
    out.append(f'<text transform="translate(18 {y:.0f}) rotate(-90)" text-anchor="middle">{along}</text>')
    stretch = 0.0
    if high - low > 0 and length > 0:
        stretch = (PANEL - TOP - BOTTOM) / (f.high - f.low) / ((right - LEFT) / length)
    entries = escape(phrase("height_drawing.band", factor=BAND, stretch=stretch))
    out.append(f'<text class="small" x="{right}" y="{top + 22:.0f}" text-anchor="end">{entries}</text>')
    return "".join(out)


def level_lines(f: Frame) -> list[str]:
    """Lines at round heights, with these."""
    out, (levels, digits) = list[str](), ticks(f.low, f.high, 6)
    for v in levels.tolist():
        y = float(f.y(v))
        out.append(f'<line class="grid" x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{y:.1f}" y2="{y:.1f}"/>')
        out.append(f'<text class="small" x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{v:.{digits}f}</text>')
    return out


def runs(known: Array) -> list[slice]:
    """Parts of a profile without a hole."""
    edge = np.flatnonzero(np.diff(np.concatenate([[0], known.astype(np.int8), [0]])))
    return [slice(int(a), int(b)) for a, b in zip(edge[::2], edge[1::2], strict=True)]


def contours_svg(
    found: Sequence[Contour], shape: tuple[int, int], cell: float, corner: tuple[float, float], unit: str
) -> str:
    """Contour lines, each fifth thick and with its height.

    corner  coordinates of the upper left one
    """
    rows, columns = shape
    scale = WIDTH / columns
    height = rows * scale
    thin, thick, names = list[str](), list[str](), list[str]()
    decimals = decimals_of([c.height for c in found])
    interval = min(np.diff([c.height for c in found]), default=1.0)
    for c in found:
        main = round(c.height / interval) % EVERY == 0
        for line in c.lines:
            (thick if main else thin).append(f"M{points(line[:, 0] * scale, line[:, 1] * scale, 'L')}")
            place = label_of(line, 60 / scale) if main else None
            if place is not None:
                (x, y), angle = place
                turn = np.degrees(angle)
                names.append(
                    f'<text class="name" transform="translate({x * scale:.1f} {y * scale:.1f}) rotate({turn:.0f})" '
                    f'text-anchor="middle" dy="3">{c.height:.{decimals}f}</text>'
                )
    entries = phrase(
        "height_drawing.contours", left=corner[0], top=corner[1], width=columns * cell, interval=interval,
        unit=unit or "none",
    )  # fmt: skip
    body = (
        f'<path class="thin" d="{"".join(thin)}"/><path class="thick" d="{"".join(thick)}"/>{"".join(names)}'
        f'<rect class="axis" width="{WIDTH}" height="{height:.1f}"/>'
        f'<text class="small" x="4" y="{height + 18:.0f}">{escape(entries)}</text>'
    )
    return sheet(WIDTH, height + 28, body)


def decimals_of(values: Sequence[float]) -> int:
    """Decimals that heights of contour lines need."""
    return next((k for k in range(9) if all(abs(v - round(v, k)) < 1e-9 * max(1, abs(v)) for v in values)), 9)


def label_of(line: Array, least: float) -> tuple[Array, float] | None:
    """Where the height of a line stands, and how it is turned; None for a line that is too short.

    least  length of line, in its units, that a label needs
    """
    run = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    if run[-1] < least:
        return None
    a, b = (np.array([np.interp(run[-1] / 2 + d, run, line[:, k]) for k in (0, 1)]) for d in (-least / 6, least / 6))
    angle = float(np.arctan2(*(b - a)[::-1]))
    return (a + b) / 2, (angle + np.pi / 2) % np.pi - np.pi / 2


def points(x: Array, y: Array, between: str = " ") -> str:
    """Coordinates on the sheet as a path or polygon takes them."""
    return between.join(f"{a:.1f},{b:.1f}" for a, b in zip(x.tolist(), y.tolist(), strict=True))


def sheet(width: float, height: float, body: str) -> str:
    """The text of an SVG file, with the styles that programs without style sheets need."""
    body = re.sub(r'class="(\w+)"', lambda found: f"{found[0]} {ATTRIBUTES[found[1]]}", body)
    body = re.sub(r"<text (?!class=)", f"<text {PLAIN} ", body)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}" '
        f'height="{height:.0f}"><style>{STYLE}</style><rect width="100%" height="100%" fill="#fff"/>{body}</svg>\n'
    )
