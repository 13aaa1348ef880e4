"""Figures of a surface: a profile with its band, correlation by distance."""

from __future__ import annotations

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.report.figures.svg import Drawing, Plot, axes, band, drawing, fitted, line, span


def profile_of(profile: Array, unit: str) -> Drawing:
    """Heights (n, 3) of place, height and standard deviation, with the band of 1.96 of these."""
    x, z, s = profile.T
    x_label = phrase("axis.right_in", unit=unit) if unit else phrase("axis.right")
    y_label = phrase("axis.height_in", unit=unit) if unit else phrase("axis.height")
    plot = fitted(Plot(width=720, height=200, x_range=(float(x[0]), float(x[-1])), y_range=span(z)))
    known = np.flatnonzero(np.isfinite(z))
    pieces = np.split(known, np.flatnonzero(np.diff(known) > 1) + 1)
    bands = [band(plot, x[k], (z - 1.96 * s)[k], (z + 1.96 * s)[k], "band second") for k in pieces]
    parts = [axes(plot, x_label, y_label), *bands, line(plot, x, z, "curve first")]
    return drawing(plot.width, plot.height, parts, phrase("drawn.profile"))


def correlation_of(values: Array) -> Drawing:
    """Distance and correlation (n, 2) as a curve."""
    x, y = values.T
    plot = fitted(Plot(width=360, height=200, x_range=(0.0, float(x[-1])), y_range=(0.0, 1.05)))
    parts = [axes(plot, phrase("axis.distance"), phrase("label.correlation")), line(plot, x, y, "curve first")]
    return drawing(plot.width, plot.height, parts, phrase("drawn.correlation_by_distance"))
