"""Charts of the rules of network design as SVG files that stand alone; called by rules_page.py."""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.planning.rules import Chart, Curve
from raybundle.report.figures.svg import CHARACTER, Plot, label, line, span, tick_labels, ticks

WIDTH, HEIGHT = 430.0, 270.0
LEGEND = 14.0
"""Height of a row of the legend [px]"""
COLOURS = ("#1d5c77", "#b5532a", "#5b8c3e", "#7a4b94", "#8a6d1d")
STYLE = (
    "text{font-family:sans-serif;font-size:10.5px;fill:#46525e}.name{font-size:11px}"
    ".title{font-size:12px;font-weight:bold}.frame{fill:none;stroke:#9aa6b0}.grid{fill:none;stroke:#dde2e7}"
    ".curve{fill:none;stroke-width:1.6}"
)


def picture(charts: Sequence[Chart], what: str) -> str:
    """All charts of a rule beside each other."""
    rows = max(len(c.curves) for c in charts)
    height = HEIGHT + LEGEND * rows
    parts = [f'<g transform="translate({k * WIDTH:.0f} 0)">{_chart(c)}</g>' for k, c in enumerate(charts)]
    width = WIDTH * len(charts)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" role="img" '
        f'aria-label="{escape(what)}">\n<style>{STYLE}</style>\n<rect width="100%" height="100%" fill="#fff"/>\n'
        + "\n".join(parts)
        + "\n</svg>\n"
    )


def _chart(chart: Chart) -> str:
    x = [_scaled(c.x, chart.logarithmic[0]) for c in chart.curves]
    y = [_scaled(c.y, chart.logarithmic[1]) for c in chart.curves]
    zero = not chart.logarithmic[1]
    plot = Plot(
        width=WIDTH, height=HEIGHT, left=58, right=14, top=28,
        x_range=span(*x, margin=0.02), y_range=span(*y, zero=zero, margin=0.06),
    )  # fmt: skip
    parts = [label(plot.left, 16, chart.title, "title"), *_axes(plot, chart)]
    for k, (curve, xs, ys) in enumerate(zip(chart.curves, x, y, strict=True)):
        parts += _curve(plot, curve, xs, ys, COLOURS[k % len(COLOURS)])
        parts += _legend(plot, curve, HEIGHT + LEGEND * (k + 0.2), COLOURS[k % len(COLOURS)])
    return f"{''.join(parts)}"


def _scaled(values: Array, logarithmic: bool) -> Array:  # noqa: FBT001  (a chart's own setting, handed on)
    values = np.asarray(values, float)
    return np.log10(np.where(values > 0, values, np.nan)) if logarithmic else values


def _curve(plot: Plot, curve: Curve, x: Array, y: Array, colour: str) -> list[str]:
    dash = ' stroke-dasharray="5 4"' if curve.dashed else ""
    parts = [f'<g stroke="{colour}"{dash}>{line(plot, x, y, "curve")}</g>']
    if not curve.dashed:
        parts += [
            f'<circle cx="{a:.1f}" cy="{b:.1f}" r="2.2" fill="{colour}"/>'
            for a, b in zip(plot.x(x).tolist(), plot.y(y).tolist(), strict=True)
            if math.isfinite(a) and math.isfinite(b)
        ]
    return parts


def _legend(plot: Plot, curve: Curve, y: float, colour: str) -> list[str]:
    dash = ' stroke-dasharray="5 4"' if curve.dashed else ""
    at = plot.left
    stroke = f'<path d="M{at:.1f} {y:.1f}h22" stroke="{colour}" stroke-width="1.6"{dash}/>'
    return [stroke, label(at + 28, y + 3.5, curve.name)]


def _axes(plot: Plot, chart: Chart) -> list[str]:
    x0, y0, w, h = plot.box
    parts = [f'<rect class="frame" x="{x0:.1f}" y="{y0:.1f}" width="{w:.1f}" height="{h:.1f}"/>']
    last = -math.inf
    for value, words in _ticks(plot.x_range, chart.logarithmic[0]):
        x = float(plot.x(value))
        parts.append(f'<path class="grid" d="M{x:.1f} {y0:.1f}V{y0 + h + 4:.1f}"/>')
        half = CHARACTER * len(words) / 2
        if x - half > last + 4:
            parts.append(label(x, y0 + h + 14, words, "t", "middle"))
            last = x + half
    last = math.inf
    for value, words in _ticks(plot.y_range, chart.logarithmic[1]):
        y = float(plot.y(value))
        parts.append(f'<path class="grid" d="M{x0 - 4:.1f} {y:.1f}H{x0 + w:.1f}"/>')
        if last - y > 10:
            parts.append(label(x0 - 7, y + 3.5, words, "t", "end"))
            last = y
    parts.append(label(x0 + w / 2, y0 + h + 29, chart.x_label, "name", "middle"))
    parts.append(label(13, y0 + h / 2, chart.y_label, "name", "middle", -90))
    return parts


def _ticks(interval: tuple[float, float], logarithmic: bool) -> list[tuple[float, str]]:  # noqa: FBT001
    """Places and words; of a logarithmic axis at 1, 2, 5 times powers of ten."""
    if not logarithmic:
        values = ticks(interval, 5)
        return list(zip(values, tick_labels(values), strict=True))
    low, high = interval
    round_values = [m * 10.0**e for e in range(math.floor(low), math.ceil(high) + 1) for m in (1, 2, 5)]
    return [(math.log10(v), f"{v:g}") for v in round_values if low <= math.log10(v) <= high]
