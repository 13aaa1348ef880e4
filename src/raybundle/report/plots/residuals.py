"""Residuals of the image points: over the format, averaged in its cells, and distributed."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from raybundle.adjustment.evaluation.cell_means import CellMeans, cell_means
from raybundle.block import Camera
from raybundle.errors import phrase
from raybundle.numerics.arrays import Array, Mask
from raybundle.report.figures.residuals import exaggeration
from raybundle.report.figures.svg import round_below
from raybundle.report.plots.canvas import (
    ABOVE_KEY,
    BLACK,
    BLUE,
    GREY,
    VERMILION,
    Canvas,
    counts_axis,
    format_axes,
    rows_of_cameras,
    vectors,
)
from raybundle.report.residuals import distribution, normalised, normalised_symbol, spread_vectors
from raybundle.report.view import View, rms

MOST_VECTORS = 1500
"""Vectors over one format: more cannot be distinguished"""


def draw(view: View, camera: str | None, figure: Canvas | None) -> Figure:
    """A row of three panels for each camera; raises InputError where no image point took part."""
    cameras, rows, whole = rows_of_cameras(view, camera, figure)
    tests = normalised(view)
    for axes, (c, mask) in zip(rows, cameras, strict=True):
        own = view.given.cameras[c]
        _vectors(axes[0], view, own, mask, tests)
        _means(axes[1], own, cell_means(view.adjustment, own, mask, tests))
        _distribution(axes[2], tests[mask], normalised_symbol(view).replace("σ₀", r"$\sigma_0$"))
    return whole


def _vectors(axes: Axes, view: View, camera: Camera, mask: Mask, tests: Array) -> None:
    rows = np.flatnonzero(mask)
    drawn = rows[spread_vectors(tests[rows], MOST_VECTORS)]
    v = view.adjustment.image_observations.residuals_px
    enlarged = exaggeration(v[rows], camera.width_px)
    title = phrase("plot.residuals", camera=camera.id, n=len(drawn), of=len(rows))
    format_axes(axes, camera, title, ABOVE_KEY)
    vectors(axes, view.given.observations.xy_px[drawn], v[drawn], enlarged, (1.0, "px"), width=0.008)


def _means(axes: Axes, camera: Camera, means: CellMeans) -> None:
    tested = means.tested if means.well_filled.any() else 0
    title = phrase("plot.means_from_zero", n=int(means.significant.sum()), of=tested)
    format_axes(axes, camera, title, ABOVE_KEY)
    width, height = camera.width_px / means.columns, camera.height_px / means.rows
    k = np.flatnonzero(means.well_filled)
    axes.set_xticks(np.arange(means.columns + 1) * width, minor=True)
    axes.set_yticks(np.arange(means.rows + 1) * height, minor=True)
    axes.grid(visible=True, which="minor", linewidth=0.5, alpha=0.4)
    axes.tick_params(which="minor", length=0)
    largest = means.largest_px
    if not len(k) or not largest > 0:
        return
    at = np.stack([(k % means.columns + 0.5) * width, (k // means.columns + 0.5) * height], axis=1)
    enlarged = round_below(0.5 * min(width, height) / largest)
    strange = np.asarray(means.significant)[k]
    axes.plot(at[:, 0], at[:, 1], linestyle="none", marker=".", markersize=3, color=GREY)
    vectors(axes, at, means.mean_px[k], enlarged, (1.0, "px"), width=0.015)
    if strange.any():
        axes.quiver(
            at[strange, 0], at[strange, 1], *means.mean_px[k][strange].T, angles="xy", scale_units="xy",
            scale=1 / enlarged, units="inches", width=0.022, color=VERMILION, zorder=3,
        )  # fmt: skip


def _distribution(axes: Axes, tests: Array, symbol: str) -> None:
    t = tests[np.isfinite(tests)]
    counts_axis(axes, phrase("axis.image_coordinates"))
    axes.set(xlabel=f"{phrase('axis.normalised_residual')}  {symbol}", xlim=(-5, 5))
    if not len(t):
        axes.set_title(phrase("plot.no_sigma"), fontsize="medium")
        return
    d = distribution(tests)
    axes.stairs(d.counts, d.edges, fill=True, color=BLUE, alpha=0.45, label=phrase("plot.coordinates", n=len(t)))
    axes.plot(d.at, d.expected, color=BLACK, linewidth=1.4, label=phrase("plot.normal"))
    axes.set_ylim(0, 1.28 * max(float(d.counts.max()), float(d.expected.max())))
    axes.legend(loc="upper left", fontsize="small", frameon=False)
    beyond = int((np.abs(t) > 3.2905).sum())
    axes.set_title(
        phrase("plot.beyond", rms=rms(t), n=beyond, expected=0.001 * len(t)),
        fontsize="medium",
    )
