"""Redundancy numbers and smallest detectable blunders of the image points."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from raybundle.adjustment.evaluation.cell_means import cell_means
from raybundle.block import Camera
from raybundle.errors import InputError, phrase
from raybundle.numerics.arrays import Array, Mask
from raybundle.report.detectable import UNTESTED, detectable
from raybundle.report.plots.canvas import (
    BLACK,
    BLUE,
    VERMILION,
    Canvas,
    cells_over_format,
    counts_axis,
    format_axes,
    rows_of_cameras,
)
from raybundle.report.residuals import normalised
from raybundle.report.view import View

BEYOND = 0.99
"""Share of the smallest detectable blunders that a histogram shows; the last column holds the larger ones"""


def draw(view: View, camera: str | None, figure: Canvas | None) -> Figure:
    """A row of three panels for each camera; raises InputError without statistics."""
    if view.adjustment.precision is None:
        raise InputError("figure.no_redundancy_numbers")
    cameras, rows, whole = rows_of_cameras(view, camera, figure)
    tests = normalised(view)
    mdb, _ = detectable(view)
    for axes, (c, mask) in zip(rows, cameras, strict=True):
        own = view.given.cameras[c]
        cells = cell_means(view.adjustment, own, mask, tests)
        format_axes(axes[0], own, phrase("plot.cell_means", camera=own.id))
        means = cells.redundancy.reshape(cells.rows, cells.columns)
        cells_over_format(axes[0], own, means, phrase("axis.redundancy_number"), "cividis", high=1.0)
        _redundancy(axes[1], view, own, mask)
        _detectable(axes[2], mdb[mask])
    return whole


def _redundancy(axes: Axes, view: View, camera: Camera, mask: Mask) -> None:
    r = view.adjustment.image_observations.redundancy[mask].ravel()
    r = r[np.isfinite(r)]
    counts_axis(axes, phrase("axis.image_coordinates"))
    axes.set(xlim=(0, 1), xlabel=phrase("axis.redundancy_number"))
    if not len(r):
        axes.set_title(phrase("plot.none_of_camera", camera=camera.id), fontsize="medium")
        return
    axes.hist(np.clip(r, 0, 1), bins=20, range=(0, 1), color=BLUE, alpha=0.45)
    mean = float(r.mean())
    if 0 <= mean <= 1:
        axes.axvline(mean, color=BLACK, linewidth=1.2)
    axes.set_title(phrase("plot.mean_and_smallest", mean=mean, smallest=float(r.min())), fontsize="medium")


def _detectable(axes: Axes, mdb: Array) -> None:
    found = mdb[np.isfinite(mdb)]
    counts_axis(axes, phrase("axis.image_coordinates"))
    axes.set(xlabel=phrase("axis.smallest_blunder"))
    lost = mdb.size - len(found)
    if not len(found):
        axes.set_title(phrase("report_reliability.uncontrolled"), fontsize="medium")
        axes.set_xticks([])
        axes.set_yticks([])
        return
    middle, most = (float(q) for q in np.quantile(found, [0.5, BEYOND]))
    low, top = 0.9 * float(found.min()), most * 1.05
    axes.hist(np.clip(found, low, top), bins=30, range=(low, top), color=VERMILION, alpha=0.5)
    axes.axvline(middle, color=BLACK, linewidth=1.2)
    axes.set_xlim(low, top)
    reported = phrase("plot.median_and_largest", median_px=middle, largest_px=float(found.max()))
    uncounted = f"\n{phrase('plot.not_counted', n=lost, limit=UNTESTED)}" if lost else ""
    axes.set_title(f"{reported}{uncounted}", fontsize="medium")
