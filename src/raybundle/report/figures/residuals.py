"""Figures of residuals and redundancy numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from statistics import NormalDist

import numpy as np

from raybundle.adjustment.evaluation.cell_means import CellMeans
from raybundle.block import Camera
from raybundle.errors import phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.report.figures.interior import format_plot, scale_bar
from raybundle.report.figures.svg import (
    Drawing,
    Plot,
    axes,
    columns,
    crosses,
    dots,
    drawing,
    fitted,
    label,
    line,
    mixed,
    round_below,
    span,
    spread_rows,
    vectors,
)
from raybundle.report.residuals import ImageRow, Profile, distribution, spread_vectors
from raybundle.report.text.numbers import grouped, significant
from raybundle.report.view import View

NORMAL = NormalDist()
MOST_VECTORS = 500
"""Vectors that are drawn in one image."""
MOST_TITLES = 1500
"""Images whose column in a chart shows its value under the pointer."""
GREEN, ORANGE = (46, 125, 90), (181, 83, 42)


def image_vectors(view: View, image: int, rows: Index, tests: Array, px_per_px: float, width: float = 219) -> Drawing:
    """Residuals of one image as vectors at the measured points; rejected points are crossed.

    rows       the image's observations
    tests      (m, 2) normalised residuals: the largest are always drawn, the others thinned evenly
    px_per_px  pixels of the drawing for a pixel of residual
    """
    camera = view.given.cameras[int(view.given.images.camera[image])]
    plot, parts = format_plot(camera.size_mm, width, foot=0)
    good, lost = rows[view.used[rows]], rows[~view.used[rows]]
    good = good[spread_vectors(tests[good], MOST_VECTORS)]
    xy = view.given.observations.xy_px
    scale = plot.box[2] / camera.width_px
    v = view.adjustment.image_observations.residuals_px[good] * px_per_px
    x, y = plot.left + xy[good, 0] * scale, plot.top + xy[good, 1] * plot.box[3] / camera.height_px
    parts.append(vectors(x, y, v[:, 0], v[:, 1], "vector"))
    if len(lost):
        parts.append(crosses(plot.left + xy[lost, 0] * scale, plot.top + xy[lost, 1] * scale, 2.5, "lost"))
    return drawing(plot.width, plot.height, parts, phrase("drawn.vectors_of_image", image=view.given.images.ids[image]))


def exaggeration(residuals_px: Array, width: float) -> float:
    """Pixels of a drawing for a pixel of residual: large ones (95 %) become a twelfth of its width, a round number."""
    size = np.linalg.norm(residuals_px, axis=1)
    size = size[np.isfinite(size)]
    large = float(np.quantile(size, 0.95)) if len(size) else 0.0
    return round_below(width / 12 / large) if large > 0 else 1.0


def reference(px_per_px: float, width: float) -> Drawing:
    """The scale of the vectors."""
    length = round_below(width / 8 / px_per_px)
    plot = Plot(width=width, height=18, x_range=(0, 1), y_range=(0, 1))
    return drawing(
        width, 18, [scale_bar(plot, length * px_per_px, f"{significant(length, 1)} px")], phrase("drawn.vector_scale")
    )


def mean_field(cells: CellMeans, camera: Camera, what: str) -> Drawing:
    """Mean residual of each cell as a vector, with the number of points; cells that differ from zero stand out."""
    plot, parts = format_plot(camera.size_mm, 430)
    x0, y0, w, h = plot.box
    cw, ch = w / cells.columns, h / cells.rows
    size = np.linalg.norm(cells.mean_px, axis=1)
    full = cells.well_filled
    largest = float(np.nanmax(size[full])) if full.any() else 0.0
    scale = 0.5 * min(cw, ch) / largest if largest > 0 else 1.0
    for k in range(len(cells.count)):
        x, y = x0 + (k % cells.columns) * cw, y0 + (k // cells.columns) * ch
        style = "cell strong" if cells.significant[k] else "cell weak"
        parts.append(f'<rect class="{style}" x="{x:.1f}" y="{y:.1f}" width="{cw:.1f}" height="{ch:.1f}"/>')
        if cells.count[k]:
            parts.append(label(x + cw - 3, y + ch - 3, grouped(float(cells.count[k])), "t tiny", "end"))
    k = np.flatnonzero(full)
    x, y = x0 + (k % cells.columns + 0.5) * cw, y0 + (k // cells.columns + 0.5) * ch
    parts.append(vectors(x, y, cells.mean_px[k, 0] * scale, cells.mean_px[k, 1] * scale, "vector bold"))
    parts += [
        f'<circle class="dot" cx="{a:.1f}" cy="{b:.1f}" r="1.5"/>' for a, b in zip(x.tolist(), y.tolist(), strict=True)
    ]
    if largest > 0:
        unit = round_below(largest)
        parts.append(scale_bar(plot, unit * scale, f"{significant(unit, 1)} px", "vector bold"))
    return drawing(plot.width, plot.height, parts, what)


def redundancy_map(cells: CellMeans, camera: Camera, what: str) -> Drawing:
    """Mean redundancy number of each cell: dark is well controlled."""
    plot, parts = format_plot(camera.size_mm, 430, foot=4)
    x0, y0, w, h = plot.box
    cw, ch = w / cells.columns, h / cells.rows
    for k, r in enumerate(cells.redundancy.tolist()):
        x, y = x0 + (k % cells.columns) * cw, y0 + (k // cells.columns) * ch
        known = math.isfinite(r)
        colour = (
            "#ffffff" if not known else mixed(0.85 * r, GREEN) if r >= 0.3 else mixed(0.8 * (1 - r / 0.3) + 0.2, ORANGE)
        )
        parts.append(f'<rect class="cell" x="{x:.1f}" y="{y:.1f}" width="{cw:.1f}" height="{ch:.1f}" fill="{colour}"/>')
        if known:
            style = "t cellvalue light" if r > 0.75 or r < 0.1 else "t cellvalue"
            parts.append(label(x + cw / 2, y + ch / 2 + 3, f"{r:.2f}", style, "middle"))
    return drawing(plot.width, plot.height, parts, what)


def normal_histogram(tests: Array, x_label: str, what: str) -> Drawing:
    """Histogram of normalised residuals with the normal curve; what lies beyond +-5 counts in the last column."""
    d = distribution(tests)
    top = max(float(d.counts.max(initial=1)), float(d.expected.max())) * 1.06
    plot = fitted(Plot(width=400, height=250, x_range=(-5, 5), y_range=(0, top)))
    parts = [
        axes(plot, x_label, phrase("label.number"), x_count=10),
        columns(plot, d.edges, d.counts),
        line(plot, d.at, d.expected, "curve second"),
    ]
    return drawing(plot.width, plot.height, parts, what)


def normal_quantiles(tests: Array, y_label: str, what: str) -> Drawing:
    """Quantiles of normalised residuals against those of the normal distribution: on the diagonal if they agree."""
    t = np.sort(tests[np.isfinite(tests)])
    rows = spread_rows(len(t), 300)
    tail = np.arange(min(30, len(t)))
    rows = np.unique(np.concatenate([tail, rows, len(t) - 1 - tail]))
    expected = np.array([NORMAL.inv_cdf((k + 0.5) / len(t)) for k in rows.tolist()])
    reach = float(min(max(np.abs(t).max(initial=3.0), 4.0) * 1.05, 12.0))
    plot = fitted(Plot(width=320, height=250, x_range=(-4.6, 4.6), y_range=(-reach, reach)))
    ends = min(4.5, reach) * np.array([-1.0, 1.0])  # within the frame
    parts = [
        axes(plot, phrase("axis.expected_quantile"), y_label, grid="xy", x_count=9),
        line(plot, ends, ends, "curve second"),
        dots(plot.x(expected), plot.y(np.clip(t[rows], -reach, reach)), "points"),
    ]
    return drawing(plot.width, plot.height, parts, what)


def image_columns(ids: Sequence[str], values: Array, y_label: str, what: str, dashed: float = math.nan) -> Drawing:
    """A column for each image, in the order of the block; a dashed line at a value for comparison."""
    n = len(values)
    few = n <= 12
    plot = fitted(
        Plot(
            width=110 + 62 * n if few else 860,
            height=180,
            x_range=(0, n),
            y_range=span(values, np.array([dashed]), zero=True),
        )
    )
    titles = [f"{i}: {significant(v)}" for i, v in zip(ids, values.tolist(), strict=True)] if n <= MOST_TITLES else []
    name = phrase("label.image") if few else phrase("axis.images_in_order")
    parts = [
        axes(plot, name, y_label, x_count=0 if few else 12),
        columns(plot, np.arange(n + 1.0), values, titles=titles),
    ]
    for k, i in enumerate(ids if few else ()):
        words = i if len(i) <= 9 else f"…{i[-8:]}"
        parts.append(label(float(plot.x(k + 0.5)), plot.height - plot.bottom + 14, words, anchor="middle"))
    if math.isfinite(dashed):
        parts.append(line(plot, np.array([0.0, n]), np.full(2, dashed), "limit"))
    return drawing(plot.width, plot.height, parts, what)


def profile_figure(profile: Profile, what: str) -> Drawing:
    """Mean radial and tangential residual against the radius, with the standard deviation of each mean."""
    mean, std = profile.mean_px, profile.std_px
    reach = float(profile.radius_mm.max(initial=0.0)) * 1.05 or 1.0
    limits = span(mean - std, mean + std, zero=True)
    plot = fitted(Plot(width=400, height=266, top=26, x_range=(0.0, reach), y_range=limits))
    parts = [
        axes(plot, phrase("axis.radius"), phrase("axis.mean_residual")),
        line(plot, np.array([0, reach]), np.zeros(2), "zero"),
    ]
    x0, y0, _, _ = plot.box
    for k, (style, name) in enumerate((("first", phrase("drawn.radial")), ("second", phrase("drawn.tangential")))):
        shift = (k - 0.5) * 3
        x = plot.x(profile.radius_mm) + shift
        low, high = plot.y(mean[:, k] - std[:, k]), plot.y(mean[:, k] + std[:, k])
        whiskers = "".join(
            f"M{a:.1f} {b:.1f}V{c:.1f}" for a, b, c in zip(x.tolist(), low.tolist(), high.tolist(), strict=True)
        )
        parts.append(f'<path class="curve {style}" d="{whiskers}"/>')
        parts += [
            f'<circle class="fill {style}" cx="{a:.1f}" cy="{b:.1f}" r="2.4"/>'
            for a, b in zip(x.tolist(), plot.y(mean[:, k]).tolist(), strict=True)
        ]
        # names stand above, where no whisker runs
        parts.append(f'<circle class="fill {style}" cx="{x0 + 4 + 70 * k:.1f}" cy="{y0 - 10:.1f}" r="3"/>')
        parts.append(label(x0 + 12 + 70 * k, y0 - 6.5, name))
    return drawing(plot.width, plot.height, parts, what)


def caption_of(row: ImageRow, name: str) -> str:
    """Image, rms residual of the points that took part, and how many were rejected, below its vectors."""
    size = math.hypot(*row.rms_px) / math.sqrt(2)
    return phrase("report_residuals.vectors_of_image", image=name, rms_px=size, n=row.count, rejected=row.rejected)
