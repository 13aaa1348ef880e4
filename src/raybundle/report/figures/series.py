"""Figures of values along a track, an arc or a flight line: dots, their running mean and its band."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.report.figures.svg import (
    Drawing,
    Plot,
    axes,
    band,
    dots,
    drawing,
    fitted,
    label,
    line,
    span,
    spread_rows,
)

WINDOWS = 60
"""Places at which a running mean is taken."""
FEWEST = 8
"""Values in a window from which on it has a mean."""
MOST_DOTS = 2500
CROWD = 800
"""Dots from which on they are drawn paler, so that the mean stays in sight."""
PALEST = 0.55
NORMAL_95 = 1.96


@dataclass(frozen=True, slots=True, kw_only=True)
class Running:
    """The mean of values in overlapping windows along an axis."""

    at: Array
    mean: Array
    """NaN where a window holds too few"""
    std: Array
    """Standard deviation of each mean, by the scatter within the window"""
    probability: float
    """Of deviations from zero this large by chance, from windows side by side; NaN where there are too few"""


def running(
    at: Array, values: Array, low: float, high: float, windows: int = WINDOWS, sigma: Array | None = None
) -> Running:
    """The running mean of values (n,) at places (n,), windows four steps wide.

    sigma  (n,) stated standard deviations, which weigh the values; None: all weigh the same
    """
    step = (high - low) / windows
    centre = low + step * (np.arange(windows) + 0.5)
    order = np.argsort(at, kind="stable")
    x, v = at[order], values[order]
    w = np.ones(len(v)) if sigma is None else 1 / np.maximum(sigma[order], 1e-12) ** 2
    first, last = np.searchsorted(x, centre - 2 * step), np.searchsorted(x, centre + 2 * step, side="right")
    mean, std = np.full(windows, np.nan), np.full(windows, np.nan)
    for k, (a, b) in enumerate(zip(first.tolist(), last.tolist(), strict=True)):
        if b - a >= FEWEST:
            own, total = w[a:b], float(w[a:b].sum())
            mean[k] = own @ v[a:b] / total
            std[k] = np.sqrt(own @ (v[a:b] - mean[k]) ** 2 / (b - a - 1) / total)
    return Running(at=centre, mean=mean, std=std, probability=_by_chance(mean[::4], std[::4]))


def _by_chance(mean: Array, std: Array) -> float:
    """Probability of the sum of squares of the normalised means."""
    from scipy.stats import chi2

    good = np.isfinite(mean) & (std > 0)
    if good.sum() < 3:
        return float("nan")
    return float(chi2(int(good.sum())).sf(float(((mean[good] / std[good]) ** 2).sum())))


def series_figure(
    at: Array, values: Array, found: Running, x_label: str, y_label: str, what: str, *, width: float = 430,
    x_range: tuple[float, float] | None = None,
) -> Drawing:  # fmt: skip
    """Dots, the running mean, and the band within which 95 % of means lie that are zero."""
    reach = float(np.quantile(np.abs(values[np.isfinite(values)]), 0.95)) if np.isfinite(values).any() else 1.0
    known = np.nan_to_num(np.concatenate([found.mean, NORMAL_95 * found.std]))
    reach = max(reach, float(np.abs(known).max(initial=0.0)) * 1.1, 1e-9)
    limits = x_range or (float(found.at[0]), float(found.at[-1]))
    plot = fitted(Plot(width=width, height=220, right=18, x_range=limits, y_range=span(np.array([-reach, reach]))))
    rows = spread_rows(len(at), MOST_DOTS)
    inside = rows[(np.abs(values[rows]) <= plot.y_range[1]) & (at[rows] >= limits[0]) & (at[rows] <= limits[1])]
    opacity = min(1.0, max(PALEST, CROWD / max(len(inside), 1)))
    parts = [
        axes(plot, x_label, y_label),
        band(plot, found.at, -NORMAL_95 * found.std, NORMAL_95 * found.std, "band second"),
        f'<g opacity="{opacity:.2g}">{dots(plot.x(at[inside]), plot.y(values[inside]), "points")}</g>',
        line(plot, np.array(limits), np.zeros(2), "zero"),
        line(plot, found.at, found.mean, "curve first"),
    ]
    return drawing(plot.width, plot.height, parts, what)


def line_figure(
    at: Array, series: Sequence[tuple[str, Array, Array | None]], x_label: str, y_label: str, what: str, *,
    width: float = 430, marks: bool = False,
) -> Drawing:  # fmt: skip
    """Up to two lines, each with its name and, where there is one, the standard deviation that bands it about zero."""
    values = [v for _, v, _ in series]
    values += [sign * NORMAL_95 * s for _, _, s in series if s is not None for sign in (-1, 1)]
    limits = span(at, margin=0.02)
    plot = fitted(Plot(width=width, height=220, top=26, right=18, x_range=limits, y_range=span(*values, zero=True)))
    x0, y0, _, _ = plot.box
    parts = [axes(plot, x_label, y_label), line(plot, np.array(limits), np.zeros(2), "zero")]
    place = x0 + 4
    for k, (name, v, sigma) in enumerate(series):
        style = ("first", "second")[k % 2]
        if sigma is not None:
            parts.append(band(plot, at, -NORMAL_95 * sigma, NORMAL_95 * sigma, f"band {style}"))
        parts.append(line(plot, at, v, f"curve {style}"))
        if marks:
            parts += [
                f'<circle class="fill {style}" cx="{a:.1f}" cy="{b:.1f}" r="2.2"/>'
                for a, b in zip(plot.x(at).tolist(), plot.y(v).tolist(), strict=True)
                if np.isfinite(b)
            ]
        if name:
            parts.append(f'<circle class="fill {style}" cx="{place:.1f}" cy="{y0 - 10:.1f}" r="3.5"/>')
            parts.append(label(place + 8, y0 - 6, name))
            place += 22 + 6 * len(name)
    return drawing(plot.width, plot.height, parts, what)
