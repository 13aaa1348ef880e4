"""Figure: displacements over time along the mean direction, with standard deviations and the fitted motion."""

from __future__ import annotations

import numpy as np

from raybundle.errors import phrase
from raybundle.metrology.trends import CONSTANT, Trend
from raybundle.numerics.arrays import Array
from raybundle.report.figures.svg import Drawing, Plot, axes, drawing, fitted, line, span

MM = 1000.0


def displacement_over_time(t: Trend, verdict: str) -> Drawing:
    """The displacements of a trend along its velocity [mm] over the days, with bars of one standard deviation."""
    s, n = t.series, len(t.series.days)
    speed = float(np.linalg.norm(t.velocity))
    way = t.velocity / max(speed, 1e-300)
    C = s.covariance.reshape(n, 3, n, 3)
    sigma = MM * np.sqrt([way @ C[k, :, k] @ way for k in range(n)])
    d = MM * s.displacement @ way
    fit = np.linspace(0, s.days[-1], 60)
    motion = _motion(t, verdict, fit, way)
    y_range = span(d - sigma, d + sigma, motion, zero=True)
    plot = fitted(Plot(width=330, height=180, x_range=span(s.days, zero=True), y_range=y_range))
    parts = [axes(plot, phrase("axis.days"), phrase("axis.displacement"), grid="xy"), line(plot, fit, motion, "limit")]
    px, low, high, mid = plot.x(s.days), plot.y(d - sigma), plot.y(d + sigma), plot.y(d)
    bars = "".join(f"M{u:.1f} {b:.1f}V{v:.1f}" for u, b, v in zip(px, low, high, strict=True))
    parts.append(f'<path class="vector" d="{bars}"/>')
    x, y = np.append(plot.x(0.0), px), np.append(plot.y(0.0), mid)
    parts += [f'<circle class="control" cx="{u:.1f}" cy="{v:.1f}" r="2.4"/>' for u, v in zip(x, y, strict=True)]
    return drawing(plot.width, plot.height, parts, phrase("drawn.displacement_over_time", name=s.name))


def _motion(t: Trend, verdict: str, days: Array, way: Array) -> Array:
    """The fitted motion [mm]: constant velocity, or constant acceleration where that describes it better."""
    if verdict == CONSTANT:
        return MM * days * float(np.linalg.norm(t.velocity))
    return MM * (days * float(t.start @ way) + days**2 / 2 * float(t.acceleration @ way))
