"""Drawing with SVG: a plot area with round ticks, lines, bands, bars and heat maps.  Colours stand in style.css."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from html import escape
from json import dumps

import numpy as np
from markupsafe import Markup

from raybundle.errors import Text, phrase
from raybundle.io.reading.texts import stored_text
from raybundle.numerics.arrays import Array
from raybundle.report.text.numbers import MINUS, fixed, grouped

Interval = tuple[float, float]
CHARACTER = 5.6
"""Mean width of a character of the ticks [px]."""
_OPEN, _CLOSE = "\ue000", "\ue001"
"""About the messages of a text, until the drawing is whole; characters for private use"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Plot:
    """A drawing area in pixels and the values that it spans; y runs up."""

    width: float = 360
    height: float = 240
    x_range: Interval
    y_range: Interval
    left: float = 48
    right: float = 10
    top: float = 10
    bottom: float = 36

    def x(self, values: Array | float) -> Array:
        """Pixels of x values."""
        low, high = self.x_range
        return self.left + (np.asarray(values, float) - low) / (high - low) * (self.width - self.left - self.right)

    def y(self, values: Array | float) -> Array:
        """Pixels of y values."""
        low, high = self.y_range
        inner = self.height - self.top - self.bottom
        return self.height - self.bottom - (np.asarray(values, float) - low) / (high - low) * inner

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Left, top, width and height of the area within the axes."""
        return self.left, self.top, self.width - self.left - self.right, self.height - self.top - self.bottom


def span(*values: Array, zero: bool = False, margin: float = 0.05) -> Interval:
    """The interval that holds all finite values, with a margin; never empty.  `zero` makes it hold zero."""
    every = np.concatenate([np.ravel(v) for v in values] or [np.zeros(0)])
    every = every[np.isfinite(every)]
    if zero:
        every = np.append(every, 0.0)
    if not len(every):
        return 0.0, 1.0
    low, high = float(every.min()), float(every.max())
    if high - low <= 1e-12 * max(abs(low), abs(high)):
        pad = abs(high) * 0.1 or 1.0
        return low - pad, high + pad
    pad = (high - low) * margin
    return (low if zero and low == 0 else low - pad), (high if zero and high == 0 else high + pad)


def round_step(width: float, count: int) -> float:
    """A step of 1, 2 or 5 times a power of ten that divides a width into about so many parts."""
    raw = width / max(count, 1)
    size = 10.0 ** math.floor(math.log10(raw))
    return min((f * size for f in (1.0, 2.0, 5.0, 10.0)), key=lambda step: abs(width / step - count))


def round_below(value: float) -> float:
    """The largest of 1, 2, 5 times a power of ten that does not exceed a positive value."""
    size = 10.0 ** math.floor(math.log10(value))
    return max(f * size for f in (0.5, 1.0, 2.0, 5.0) if f * size <= value * (1 + 1e-9))


def ticks(interval: Interval, count: int = 5) -> list[float]:
    """Round values within an interval."""
    low, high = interval
    step = round_step(high - low, count)
    first = math.ceil(low / step - 1e-9)
    return [k * step for k in range(first, math.floor(high / step + 1e-9) + 1)]


def tick_labels(values: Sequence[float]) -> list[str]:
    """Labels of equally spaced values, with the decimals that they need."""
    if not values:
        return []
    step = values[1] - values[0] if len(values) > 1 else abs(values[0]) or 1.0
    decimals = max(0, -math.floor(math.log10(step) + 1e-9)) if step > 0 else 0
    if decimals > 5 or max(abs(v) for v in values) >= 1e9:
        return [f"{v:.3g}".replace("-", MINUS) for v in values]
    if decimals == 0 and max(abs(v) for v in values) >= 1e4:
        return [grouped(v) for v in values]
    return [fixed(v, decimals) for v in values]


def coordinates(xs: Array, ys: Array) -> str:
    """Path of a polyline in pixels; a gap where a value is not finite."""
    parts: list[str] = []
    pen = "M"
    for x, y in zip(np.asarray(xs).tolist(), np.asarray(ys).tolist(), strict=True):
        if not (math.isfinite(x) and math.isfinite(y)):
            pen = "M"
            continue
        parts.append(f"{pen}{x:.1f} {y:.1f}")
        pen = "L"
    return "".join(parts)


def line(plot: Plot, xs: Array, ys: Array, style: str) -> str:
    """A polyline of values."""
    return f'<path class="{style}" d="{coordinates(plot.x(xs), plot.y(ys))}"/>'


def band(plot: Plot, xs: Array, low: Array, high: Array, style: str) -> str:
    """The area between two lines."""
    good = np.isfinite(low) & np.isfinite(high) & np.isfinite(xs)
    if good.sum() < 2:
        return ""
    x = np.concatenate([xs[good], xs[good][::-1]])
    y = np.concatenate([low[good], high[good][::-1]])
    return f'<path class="{style}" d="{coordinates(plot.x(x), plot.y(y))}Z"/>'


def written(words: str) -> str:
    """Words as a part of a drawing; a text of the catalogue keeps its messages for another reader."""
    if isinstance(words, Text):
        return f"{_OPEN}{dumps([m.json() for m in words.messages])}{_CLOSE}"
    return escape(words.translate({ord(_OPEN): None, ord(_CLOSE): None}))


def _pieces(svg: str) -> tuple[str, ...]:
    """SVG and the texts within it, in turns."""
    found = list[str]()
    for k, piece in enumerate(re.split(f"[{_OPEN}{_CLOSE}]", svg)):
        found.append(stored_text(piece) if k % 2 else piece)
    return tuple(found)


def label(x: float, y: float, words: str, style: str = "t", anchor: str = "start", turn: float = 0.0) -> str:
    """A piece of text at a pixel."""
    turned = f' transform="rotate({turn:g} {x:.1f} {y:.1f})"' if turn else ""
    return f'<text class="{style}" x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{turned}>{written(words)}</text>'


def labels_apart(
    x: Sequence[float],
    y: Sequence[float],
    names: Sequence[str],
    box: tuple[float, float, float, float],
    style: str = "t",
) -> list[str]:
    """Names beside points, each where it covers no other one; a name that has no room is left to the pointer.

    x, y  pixels of the points; box  x0, y0, width and height within which a name stays
    """
    parts: list[str] = []
    for k, right, up in spots_apart(x, y, [CHARACTER * len(name) for name in names], box):
        top = y[k] - 12 if up else y[k] + 3
        parts.append(label(x[k] + (5 if right else -5), top + 8.5, names[k], style, "start" if right else "end"))
    return parts


def spots_apart(
    x: Sequence[float], y: Sequence[float], widths: Sequence[float], box: tuple[float, float, float, float]
) -> list[tuple[int, bool, bool]]:
    """Which names have room beside their points: position, whether right of the point, and whether above it.

    x, y  pixels of the points, y down; widths of the names; box  x0, y0, width and height within which they stay
    """
    taken = [(u - 3, v - 3, u + 3, v + 3) for u, v in zip(x, y, strict=True)]  # nor does a name cover a point
    x0, y0, w, h = box
    found: list[tuple[int, bool, bool]] = []
    for k, (u, v, width) in enumerate(zip(x, y, widths, strict=True)):
        wide = width + 2
        for right, up in ((True, True), (False, True), (True, False), (False, False)):
            left, top = (u + 5 if right else u - 5 - wide), (v - 12 if up else v + 3)
            spot = (left, top, left + wide, top + 10)
            if left < x0 or left + wide > x0 + w or top < y0 or top + 10 > y0 + h:
                continue
            if any(spot[0] < b[2] and b[0] < spot[2] and spot[1] < b[3] and b[1] < spot[3] for b in taken):
                continue
            taken.append(spot)
            found.append((k, right, up))
            break
    return found


def fitted(plot: Plot) -> Plot:
    """The plot with room at the left for its ticks and the axis' name."""
    longest = max((len(s) for s in tick_labels(ticks(plot.y_range))), default=1)
    return replace(plot, left=26 + CHARACTER * longest + 6)


def axes(plot: Plot, x_label: str, y_label: str, *, grid: str = "y", x_count: int = 6, y_count: int = 5) -> str:
    """Frame, round ticks, their labels, the axes' names, and grid lines along "x", "y" or "xy"."""
    x0, y0, w, h = plot.box
    parts = [f'<rect class="frame" x="{x0:.1f}" y="{y0:.1f}" width="{w:.1f}" height="{h:.1f}"/>']
    values = ticks(plot.x_range, x_count) if x_count else []
    labels = tick_labels(values)
    while len(values) > 1 and max(len(s) for s in labels) * CHARACTER > 0.9 * (plot.x(values[1]) - plot.x(values[0])):
        values, labels = values[::2], labels[::2]
    for value, words in zip(values, labels, strict=True):
        x = float(plot.x(value))
        top = y0 if "x" in grid else y0 + h
        parts.append(f'<path class="grid" d="M{x:.1f} {top:.1f}V{y0 + h + 4:.1f}"/>')
        parts.append(label(x, y0 + h + 14, words, anchor="middle"))
    values = ticks(plot.y_range, y_count)
    for value, words in zip(values, tick_labels(values), strict=True):
        y = float(plot.y(value))
        right = x0 + w if "y" in grid else x0
        parts.append(f'<path class="grid" d="M{x0 - 4:.1f} {y:.1f}H{right:.1f}"/>')
        parts.append(label(x0 - 6, y + 3.5, words, anchor="end"))
    parts.append(label(x0 + w / 2, y0 + h + 29, x_label, "name", "middle"))
    parts.append(label(11, y0 + h / 2, y_label, "name", "middle", -90))
    return "".join(parts)


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawing:
    """A whole drawing."""

    pieces: tuple[str, ...]
    """SVG; each second one is a text of the catalogue"""
    width: float
    """[px]"""

    @property
    def svg(self) -> Markup:
        """SVG with its texts."""
        whole = "".join(escape(p) if isinstance(p, Text) else p for p in self.pieces)
        return Markup(whole)  # noqa: S704  (every text in it is escaped where it is set)


def drawing(width: float, height: float, parts: Sequence[str], what: str) -> Drawing:
    """A whole drawing; `what` is read to those who do not see it."""
    body = "".join(parts)
    svg = (
        f'<svg viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}" height="{height:.0f}" role="img" '
        f'aria-label="{written(what)}">{body}</svg>'
    )
    return Drawing(pieces=_pieces(svg), width=width)


def columns(
    plot: Plot, edges: Array, heights: Array, style: str = "bar", titles: Sequence[str] = ()
) -> str:  # fmt: skip
    """Columns between edges (n + 1,) from zero to heights (n,), with words that show under the pointer."""
    left, right = plot.x(edges[:-1]), plot.x(edges[1:])
    top = plot.y(np.nan_to_num(heights))
    base = float(plot.y(max(0.0, plot.y_range[0])))
    gap = 0.5 if len(heights) <= 200 else 0.0
    if not titles:
        d = "".join(
            f"M{a + gap:.1f} {base:.1f}V{t:.1f}H{b - gap:.1f}V{base:.1f}Z"
            for a, b, t in zip(left.tolist(), right.tolist(), top.tolist(), strict=True)
            if t < base
        )
        return f'<path class="{style}" d="{d}"/>'
    return "".join(
        f'<rect class="{style}" x="{a + gap:.1f}" y="{t:.1f}" width="{max(b - a - 2 * gap, 0.5):.1f}" '
        f'height="{max(base - t, 0.0):.1f}"><title>{written(words)}</title></rect>'
        for a, b, t, words in zip(left.tolist(), right.tolist(), top.tolist(), titles, strict=True)
    )


def count_ticks(counts: Array) -> int:
    """Number of ticks of an axis of counts: none between whole numbers."""
    return int(min(5, max(1, counts.max(initial=1))))


def histogram(
    values: Array, x_label: str, what: str, *, edges: Array | None = None, y_label: str = "", width: float = 300
) -> Drawing:
    """A histogram; values beyond the edges count in the outermost columns."""
    good = values[np.isfinite(values)]
    if edges is None:
        low, high = span(good, margin=0.0)
        step = round_step(high - low, 20)
        edges = step * np.arange(math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9) + 1)
        if len(edges) < 2:
            edges = np.array([low, high])
    counts = np.histogram(np.clip(good, edges[0], edges[-1]), edges)[0].astype(float)
    x_range, y_range = (float(edges[0]), float(edges[-1])), (0.0, max(float(counts.max()), 1.0) * 1.06)
    plot = fitted(Plot(width=width, height=190, x_range=x_range, y_range=y_range))
    y_name = y_label or phrase("label.number")
    parts = [axes(plot, x_label, y_name, y_count=count_ticks(counts)), columns(plot, edges, counts)]
    return drawing(plot.width, plot.height, parts, what)


def vectors(x: Array, y: Array, dx: Array, dy: Array, style: str) -> str:
    """Many vectors in pixels as one path, with a resolution of a tenth of a pixel."""
    good = np.isfinite(x) & np.isfinite(y) & np.isfinite(dx) & np.isfinite(dy)
    table = np.rint(10 * np.stack([x, y, dx, dy], axis=1)[good]).astype(int)
    d = "".join(f"M{a} {b}l{c} {e}" for a, b, c, e in table.tolist())
    return f'<path class="{style}" transform="scale(.1)" d="{d}"/>'


def dots(x: Array, y: Array, style: str) -> str:
    """Many dots in pixels as one path (round line caps)."""
    good = np.isfinite(x) & np.isfinite(y)
    table = np.rint(10 * np.stack([x, y], axis=1)[good]).astype(int)
    d = "".join(f"M{a} {b}h0" for a, b in table.tolist())
    return f'<path class="{style}" transform="scale(.1)" d="{d}"/>'


def crosses(x: Array, y: Array, size: float, style: str) -> str:
    """Diagonal crosses in pixels as one path."""
    d = "".join(
        f"M{a - size:.1f} {b - size:.1f}l{2 * size:g} {2 * size:g}m0 {-2 * size:g}l{-2 * size:g} {2 * size:g}"
        for a, b in zip(x.tolist(), y.tolist(), strict=True)
        if math.isfinite(a) and math.isfinite(b)
    )
    return f'<path class="{style}" d="{d}"/>'


def spread_rows(count: int, most: int) -> Array:
    """Positions of at most `most` of `count` rows, evenly spread and always the same."""
    if count <= most:
        return np.arange(count)
    return np.unique(np.linspace(0, count - 1, most).round().astype(int))


def mixed(share: float, colour: tuple[int, int, int]) -> str:
    """White mixed with a colour: share 0 is white, 1 the colour."""
    s = min(max(share, 0.0), 1.0)
    return "#" + "".join(f"{round(255 + s * (c - 255)):02x}" for c in colour)
