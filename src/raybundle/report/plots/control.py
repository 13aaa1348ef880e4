"""Differences at control and check points with their standard deviations, and in plan."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from raybundle.errors import InputError, Text, phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.natural import natural_order
from raybundle.report.figures.svg import span
from raybundle.report.parts import pick
from raybundle.report.plots.canvas import (
    ABOVE_KEY,
    BLACK,
    GREEN,
    RASTERIZED,
    VERMILION,
    Canvas,
    begun,
    named,
    vectors,
)
from raybundle.report.sections.control import observed_control
from raybundle.report.text.numbers import significant
from raybundle.report.text.words import expected_check_std
from raybundle.report.view import View, rms

MOST_NAMES = 30
"""Points that are named at the axis"""
WIDTH, HEIGHT = 10.5, 5.8


@dataclass(frozen=True, slots=True, kw_only=True)
class Differences:
    """Adjusted minus given, of one kind of points."""

    kind: str
    rows: Index
    """of the object points"""
    difference: Array
    """(k, 3) [view.unit]; NaN where none is"""
    std: Array
    """(k, 3) of the difference [view.unit]; NaN where nothing shows it"""

    @property
    def label(self) -> Text:
        """Of the points."""
        return phrase("network_page.control_points" if self.kind == "control" else "label.check_points")


def draw(view: View, figure: Canvas | None) -> Figure:
    """The three coordinates, and the plan; raises InputError where nothing was compared."""
    found = [d for d in (_control(view), _check(view)) if np.isfinite(d.difference).any()]
    if not found:
        raise InputError("figure.no_control")
    canvas, whole = begun(figure, WIDTH, HEIGHT)
    grid = canvas.add_gridspec(3, 2, width_ratios=(1.35, 1))
    first: Axes | None = None
    for k in range(3):
        axes = canvas.add_subplot(grid[k, 0], sharex=first)
        first = first or axes
        _coordinate(axes, view, found, k)
    _plan(canvas.add_subplot(grid[:, 1]), view, found)
    return whole


def _control(view: View) -> Differences:
    """Residuals of control that was observed; their a-posteriori standard deviations follow from redundancy numbers."""
    group = observed_control(view)
    rows = np.unique(group.item) if group is not None else np.zeros(0, np.int32)
    d, std = np.full((2, len(rows), 3), np.nan)
    if group is not None:
        at = np.searchsorted(rows, group.item)
        axis = np.array(["XYZ".index(c) for c in group.component], int)
        d[at, axis] = group.residual * view.factor
        with np.errstate(invalid="ignore"):
            std[at, axis] = view.adjustment.sigma0 * group.sigma * np.sqrt(group.redundancy) * view.factor
    return _sorted(view, Differences(kind="control", rows=rows, difference=d, std=std))


def _check(view: View) -> Differences:
    found = Differences(
        kind="check points", rows=view.check_rows, difference=view.check_difference * view.factor,
        std=expected_check_std(view),
    )  # fmt: skip
    return _sorted(view, found)


def _sorted(view: View, d: Differences) -> Differences:
    """In the order in which people count, without points that have nothing to compare."""
    order = np.array(natural_order(pick(d.rows, view.given.points.ids)), np.int64)
    order = order[np.isfinite(d.difference[order]).any(axis=1)] if len(order) else order
    return Differences(kind=d.kind, rows=d.rows[order], difference=d.difference[order], std=d.std[order])


def _style(kind: str) -> tuple[str, str]:
    return (VERMILION, "^") if kind == "control" else (GREEN, "o")


def _coordinate(axes: Axes, view: View, found: list[Differences], k: int) -> None:
    """Differences of one coordinate, a point beside the other."""
    start, reported = 0, list[str]()
    names: list[str] = []
    for d in found:
        colour, marker = _style(d.kind)
        at = np.arange(start, start + len(d.rows))
        known = np.isfinite(d.difference[:, k])
        many = len(d.rows) > RASTERIZED
        spread = np.where(np.isfinite(d.std[:, k]), d.std[:, k], 0.0)
        axes.errorbar(
            at[known], d.difference[known, k], yerr=spread[known], linestyle="none", marker=marker,
            markersize=4 if len(d.rows) <= 100 else 2, color=colour, markerfacecolor="none", elinewidth=1.0,
            capsize=2 if len(d.rows) <= 100 else 0, rasterized=many, label=d.label,
        )  # fmt: skip
        if known.any():
            reported.append(f"{d.label}: rms {significant(rms(d.difference[:, k]), 2)} {view.unit}")
        names += pick(d.rows, view.given.points.ids)
        start += len(d.rows)
    axes.axhline(0, color=BLACK, linewidth=0.6)
    axes.set_ylabel(f"d{'XYZ'[k]} [{view.unit}]")
    axes.set_title("; ".join(reported), fontsize="small", loc="left")
    axes.grid(visible=True, axis="y", alpha=0.3, linewidth=0.6)
    axes.set_xlim(-0.7, start - 0.3)
    if start > MOST_NAMES:
        axes.set_xticks([])
    else:
        long = max(len(n) for n in names) * start > 90
        axes.set_xticks(range(start), names, rotation=90 if long else 0, fontsize="small")
    axes.tick_params(axis="x", labelbottom=k == 2)
    if k == 2 and start > MOST_NAMES:
        axes.set_xlabel(phrase("plot.in_order_of_names"))


def _plan(axes: Axes, view: View, found: list[Differences]) -> None:
    """Differences in X and Y as vectors at the points."""
    rows = np.concatenate([d.rows for d in found])
    xy = view.adjusted.points.xyz[rows][:, :2]
    every = np.nan_to_num(np.concatenate([d.difference for d in found])[:, :2]) / view.factor
    x, y = span(xy[:, 0], margin=0.15), span(xy[:, 1], margin=0.15)
    reach = max(x[1] - x[0], y[1] - y[0])
    # a narrow field keeps a strip that vectors have room in
    x, y = (_widened(i, 0.3 * reach) for i in (x, y))
    axes.set(xlim=x, ylim=y, aspect="equal", xlabel=f"X [{view.length_unit}]", ylabel=f"Y [{view.length_unit}]")
    axes.ticklabel_format(style="plain", useOffset=False)
    axes.locator_params(nbins=5)
    axes.grid(visible=True, alpha=0.3, linewidth=0.6)
    axes.set_title(phrase("plot.differences_in_plan"), fontsize="medium", pad=ABOVE_KEY)
    for d in found:
        colour, marker = _style(d.kind)
        at = view.adjusted.points.xyz[d.rows][:, :2]
        axes.plot(
            at[:, 0], at[:, 1], linestyle="none", marker=marker, markersize=6 if len(rows) <= 100 else 2,
            color=colour, markerfacecolor="none", rasterized=len(at) > RASTERIZED, label=d.label,
        )  # fmt: skip
    size = np.linalg.norm(every, axis=1)
    usual = max(float(np.quantile(size, 0.9)), float(size.max()) / 3)
    if usual > 0:
        vectors(
            axes, xy, every, min(0.12, 1 / math.sqrt(len(rows))) * reach / usual, (view.factor, view.unit), colour=BLACK
        )
    axes.legend(
        loc="lower left", bbox_to_anchor=(0, 1.0), ncols=2, fontsize="small", frameon=False, borderaxespad=0.2,
        handletextpad=0.2, columnspacing=1.0,
    )  # fmt: skip
    if len(rows) <= MOST_NAMES:
        named(axes, xy, pick(rows, view.given.points.ids))


def _widened(interval: tuple[float, float], least: float) -> tuple[float, float]:
    lack = max(0.0, least - (interval[1] - interval[0])) / 2
    return interval[0] - lack, interval[1] + lack
