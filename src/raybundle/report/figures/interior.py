"""Figures of an interior orientation: correlations, distortion curves and the field of corrections."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from raybundle.adjustment.statistics.network import CELLS, format_cells
from raybundle.block import Camera
from raybundle.calibration.maps import UncertaintyMap
from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.report.figures.distortion import Curve, Interior, field
from raybundle.report.figures.svg import (
    Drawing,
    Plot,
    axes,
    band,
    drawing,
    label,
    line,
    mixed,
    round_below,
    span,
    tick_labels,
    ticks,
    vectors,
)
from raybundle.report.text.numbers import fixed, significant

MOST_CELLS = 600
"""Cells of a map of uncertainty that are drawn: each shows the largest of those computed in it."""
NEGATIVE, POSITIVE = (31, 90, 138), (181, 83, 42)
"""Colours of a heat map at -1 and at +1."""


def heat_map(rows: Sequence[str], columns: Sequence[str], values: Array, what: str, *, signed: bool = True) -> Drawing:
    """Correlations (rows, columns) as coloured cells with their value; NaN stays white."""
    cell, left, top = 36.0, 34.0, 22.0
    width, height = left + cell * len(columns) + 2, top + cell * len(rows) * 0.72 + 2
    tall = cell * 0.72
    parts: list[str] = []
    for j, name in enumerate(columns):
        parts.append(label(left + (j + 0.5) * cell, top - 7, name, "name", "middle"))
    for i, name in enumerate(rows):
        parts.append(label(left - 6, top + (i + 0.5) * tall + 4, name, "name", "end"))
        for j in range(len(columns)):
            r = float(values[i, j])
            colour = mixed(abs(r) ** 1.5, POSITIVE if r > 0 else NEGATIVE) if np.isfinite(r) else "#ffffff"
            x, y = left + j * cell, top + i * tall
            parts.append(
                f'<rect class="cell" x="{x:g}" y="{y:.1f}" width="{cell:g}" height="{tall:.2f}" fill="{colour}"/>'
            )
            words = "" if not np.isfinite(r) else fixed(r if signed else abs(r), 2)
            style = "t light" if abs(r) > 0.7 else "t"
            parts.append(label(x + cell / 2, y + tall / 2 + 3.5, words, style, "middle"))
    return drawing(width, height, parts, what)


def _second_axis(plot: Plot, factor: float, name: str) -> str:
    """Ticks at the right side in another unit: value = factor times that of the left side."""
    x0, y0, w, h = plot.box
    values = ticks((plot.y_range[0] * factor, plot.y_range[1] * factor), 5)
    parts: list[str] = []
    for value, words in zip(values, tick_labels(values), strict=True):
        y = float(plot.y(value / factor))
        parts.append(f'<path class="grid" d="M{x0 + w:.1f} {y:.1f}h4"/>')
        parts.append(label(x0 + w + 7, y + 3.5, words))
    parts.append(label(plot.width - 4, y0 + h / 2, name, "name", "middle", -90))
    return "".join(parts)


def _beyond(plot: Plot, reach: float) -> str:
    """Shading of the radii that no observation reaches."""
    x0, y0, w, h = plot.box
    x = max(float(plot.x(reach)), x0)
    if not np.isfinite(x) or x >= x0 + w - 1:
        return ""
    words = phrase("drawn.no_observation") if x0 + w - x > 80 else ""
    return f'<rect class="beyond" x="{x:.1f}" y="{y0:.1f}" width="{x0 + w - x:.1f}" height="{h:.1f}"/>' + label(
        x0 + w - 4, y0 + 12, words, "t faint", "end"
    )


def curves(
    interior: Interior, drawn: Sequence[tuple[Curve, str, str]], reach: float, what: str, y_label: str = ""
) -> Drawing:
    """Corrections with their 1-sigma band against the radius; each curve with a style and a name.

    reach  the largest radius of an observation [mm]; beyond it a curve is extrapolated
    """
    um = [(c.radius_mm, 1000 * c.value_mm, None if c.std_mm is None else 1000 * c.std_mm) for c, _, _ in drawn]
    spans = [v for _, v, _ in um] + [v + k * s for _, v, s in um if s is not None for k in (-1, 1)]
    top = 26 if len(drawn) > 1 else 10  # names stand above, where no curve runs
    plot = Plot(
        width=400, height=252 + top, left=54, right=52, top=top, x_range=(0.0, interior.corner_mm),
        y_range=span(*spans, zero=True),
    )  # fmt: skip
    parts = [
        _beyond(plot, reach),
        axes(plot, phrase("axis.radius"), y_label or phrase("axis.correction", unit="µm")),
        _second_axis(plot, 1e-3 / interior.pixel, "[px]"),
        line(plot, np.array([0.0, interior.corner_mm]), np.zeros(2), "zero"),
    ]
    x0, y0, _, _ = plot.box
    place = x0
    for (r, v, s), (_, style, name) in zip(um, drawn, strict=True):
        if s is not None:
            parts.append(band(plot, r, v - s, v + s, f"band {style}"))
        parts.append(line(plot, r, v, f"curve {style}"))
        if len(drawn) > 1:
            parts.append(f'<path class="curve {style}" d="M{place:.1f} {y0 - 10:.1f}h18"/>')
            parts.append(label(place + 23, y0 - 6.5, name))
            place += 40 + 6 * len(name)
    return drawing(plot.width, plot.height, parts, what)


def sigma_curve(interior: Interior, curve: Curve, reach: float, what: str) -> Drawing | None:
    """Standard deviation of a correction against the radius; None without covariance."""
    if curve.std_mm is None:
        return None
    shown = Curve(radius_mm=curve.radius_mm, value_mm=curve.std_mm, std_mm=None)
    return curves(interior, [(shown, "first", "")], reach, what, phrase("axis.standard_deviation", unit="µm"))


def correction_field(interior: Interior, what: str) -> tuple[Drawing, float]:
    """Corrections over the format as vectors from the measured point, and the largest one [px]."""
    image, shift = field(interior)
    size_px = np.linalg.norm(shift / np.array(interior.camera.pixel_mm)[:, None], axis=0)
    largest = float(np.nanmax(size_px)) if np.isfinite(size_px).any() else 0.0
    plot, parts = format_plot(interior.camera.size_mm, 400)
    if largest > 0:
        step = plot.box[2] / 13
        reference = round_below(largest)
        per_px = step / largest / np.array(interior.camera.pixel_mm)
        dx, dy = shift[0] * per_px[0], -shift[1] * per_px[1]
        x, y = plot.x(image[0]), plot.y(image[1])
        # arrows point to the ideal place; the dot is the measured one
        parts += [
            vectors(x, y, dx, dy, "vector"),
            scale_bar(plot, reference * step / largest, f"{significant(reference, 1)} px"),
        ]
        keep = np.isfinite(dx)
        parts += [
            f'<circle class="dot" cx="{a:.1f}" cy="{b:.1f}" r="1.6"/>' for a, b in zip(x[keep], y[keep], strict=True)
        ]
    pp = interior.principal_point
    a, b = float(plot.x(pp[0])), float(plot.y(pp[1]))
    parts.append(f'<path class="mark" d="M{a - 5:.1f} {b:.1f}h10M{a:.1f} {b - 5:.1f}v10"/>')
    return drawing(plot.width, plot.height, parts, what), largest


def uncertainty_figure(camera: Camera, found: UncertaintyMap) -> Drawing:
    """Standard deviation of projection over the format, as cells of colour with a key."""
    plot, parts = format_plot(camera.size_mm, 400)
    most = found.largest
    std = coarser(found.std, MOST_CELLS)
    rows, columns = std.shape
    left, top, width, height = plot.box
    w, h = width / columns, height / rows
    for j in range(rows):
        for i in range(columns):
            if not math.isfinite(std[j, i]):
                continue
            title = f"<title>{significant(float(std[j, i]), 2)} px</title>"
            parts.append(
                f'<rect x="{left + i * w:.1f}" y="{top + j * h:.1f}" width="{w + 0.3:.1f}" height="{h + 0.3:.1f}" '
                f'fill="{mixed(0.05 + 0.95 * float(std[j, i]) / most if most > 0 else 0.0, POSITIVE)}">{title}</rect>'
            )
    y = plot.height - 12
    parts += [
        f'<rect x="{4 + 9 * k}" y="{y:.1f}" width="9" height="8" fill="{mixed(0.05 + 0.95 * k / 9, POSITIVE)}"/>'
        for k in range(10)
    ]
    parts.append(label(100, y + 8, f"0 … {significant(most, 2)} px", "t"))
    return drawing(plot.width, plot.height, parts, phrase("drawn.projection_uncertainty"))


def coverage_map(camera: Camera, xy_px: Array, what: str) -> Drawing:
    """Counts of image points (n, 2) in the 10 x 10 cells of the format: an empty cell is calibrated by none."""
    plot, parts = format_plot(camera.size_mm, 400, foot=4)
    n = CELLS
    counts = np.bincount(format_cells(xy_px / np.array([camera.width_px, camera.height_px])), minlength=n * n)
    most = float(max(counts.max(initial=0), 1))
    x0, y0, w, h = plot.box
    for k, count in enumerate(counts.tolist()):
        x, y = x0 + (k % n) * w / n, y0 + (k // n) * h / n
        share = math.sqrt(count / most)
        colour = mixed(0.1 + 0.8 * share, NEGATIVE) if count else "#ffffff"
        parts.append(
            f'<rect class="cell" x="{x:.1f}" y="{y:.1f}" width="{w / n:.1f}" height="{h / n:.1f}" fill="{colour}"/>'
        )
        style = "t cellvalue light" if share > 0.6 else "t cellvalue"
        parts.append(label(x + w / n / 2, y + h / n / 2 + 3, str(count), style, "middle"))
    return drawing(plot.width, plot.height, parts, what)


def coarser(values: Array, most: int) -> Array:
    """The largest of each block of cells (rows, columns), so that no more than so many are left; NaN is none."""
    rows, columns = values.shape
    step = math.ceil(math.sqrt(rows * columns / most))
    if step <= 1:
        return values
    low = np.full((-(-rows // step) * step, -(-columns // step) * step), -np.inf)
    low[:rows, :columns] = np.where(np.isfinite(values), values, -np.inf)
    blocks = low.reshape(low.shape[0] // step, step, low.shape[1] // step, step).max(axis=(1, 3))
    return np.where(np.isfinite(blocks), blocks, np.nan)


def format_plot(size: Array, width: float, foot: float = 22.0) -> tuple[Plot, list[str]]:
    """A plot of the image format (centred, y up) at true proportions, with its frame; room for a scale below.

    Upright formats are drawn narrower, so that they are no taller than 0.85 times the width asked for.
    """
    aspect = min(max(float(size[1] / size[0]), 0.15), 6.0)
    width = min(width, 4 + 0.85 * width / aspect)
    inner = width - 4
    height = inner * aspect + 4 + foot
    half = np.asarray(size) / 2
    plot = Plot(
        width=width, height=height, left=2, right=2, top=2, bottom=2 + foot,
        x_range=(-float(half[0]), float(half[0])), y_range=(-float(half[1]), float(half[1])),
    )  # fmt: skip
    x, y, w, h = plot.box
    return plot, [f'<rect class="format" x="{x:g}" y="{y:g}" width="{w:g}" height="{h:.1f}"/>']


def scale_bar(plot: Plot, length: float, words: str, style: str = "vector") -> str:
    """A reference length below a plot of the format."""
    y = plot.height - 8
    return f'<path class="{style}" d="M4 {y:.1f}h{length:.1f}"/>' + label(10 + length, y + 3.5, words)
