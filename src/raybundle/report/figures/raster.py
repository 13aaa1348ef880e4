"""Pictures of cells within drawings: heights with shades, standard deviations in classes of colours."""

from __future__ import annotations

import io
from base64 import b64encode

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.report.figures.svg import CHARACTER, Drawing, Plot, axes, drawing, label, tick_labels, ticks
from raybundle.report.network.sigma_classes import Classes

NOTHING = (198, 202, 207)
"""Colour of cells without a number"""
RAMP = np.array([(38, 66, 104), (46, 117, 138), (116, 166, 130), (214, 196, 124), (240, 232, 208)], float)
"""From low to high; lighter and lighter, so that it reads in grey, too"""
LIGHT = np.array([-1.0, 1.0, 1.2]) / np.linalg.norm([-1.0, 1.0, 1.2])
"""From above left, as maps are lit"""
LEGEND_PX = 14


def embedded(rgb: Array, x: float, y: float, width: float, height: float) -> str:
    """A picture (h, w, 3) uint8 at a place of a drawing."""
    from PIL import Image

    file = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(rgb)).save(file, "PNG", optimize=True)
    data = b64encode(file.getvalue()).decode("ascii")
    return (
        f'<image x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" preserveAspectRatio="none" '
        f'href="data:image/png;base64,{data}"/>'
    )


def shaded(heights: Array, cell: float) -> tuple[Array, tuple[float, float]]:
    """Heights (h, w) as colours (h, w, 3) with hill shades, and the heights of the ends of the ramp."""
    known = np.isfinite(heights)
    low, high = np.quantile(heights[known], [0.01, 0.99]) if known.any() else (0.0, 1.0)
    high = high if high > low else low + 1.0
    place = np.nan_to_num((heights - low) / (high - low)).clip(0, 1) * (len(RAMP) - 1)
    at = np.minimum(place.astype(int), len(RAMP) - 2)
    rest = (place - at)[..., None]
    colours = RAMP[at] * (1 - rest) + RAMP[at + 1] * rest
    filled = np.where(known, heights, low)
    by_row, by_column = np.gradient(filled, cell) if min(heights.shape) > 1 else (filled * 0, filled * 0)
    # slopes are drawn so that their usual size reads, whatever the relief
    usual = np.median(np.hypot(by_row, by_column)[known]) if known.any() else 1.0
    steep = 0.35 / max(float(usual), 1e-9)
    normal = np.stack([-by_column * steep, by_row * steep, np.ones(heights.shape)], axis=-1)
    light = (normal @ LIGHT) / np.linalg.norm(normal, axis=-1)
    rgb = colours * (0.55 + 0.5 * np.clip(light, 0, 1))[..., None]
    rgb[~known] = NOTHING
    return rgb.clip(0, 255).astype(np.uint8), (float(low), float(high))


def classed(values: Array, classes: Classes) -> Array:
    """Numbers (h, w) as the colours (h, w, 3) of their classes."""
    colours = np.array([[int(c[k : k + 2], 16) for k in (1, 3, 5)] for c in classes.colours], float)
    at = np.searchsorted(np.array(classes.limits), np.nan_to_num(values), side="left")
    rgb = colours[at]
    rgb[~np.isfinite(values)] = NOTHING
    return rgb.astype(np.uint8)


def height_map(heights: Array, cell: float, left: float, top: float, unit: str, what: str) -> Drawing:
    """Heights above a plane with axes and a ramp."""
    rgb, (low, high) = shaded(heights, cell)
    plot, parts = _framed(rgb, cell, left, top, unit)
    x0, y0, w, h = plot.box
    x = x0 + w + 16
    strip = (RAMP[::-1].repeat(8, axis=0)[:, None]).astype(np.uint8)
    parts.append(embedded(strip, x, y0, 12, min(h, 120)))
    room = min(h, 120)
    values = ticks((low, high), 4)
    for value, words in zip(values, tick_labels(values), strict=True):
        y = y0 + room * (high - value) / (high - low)
        parts.append(label(x + 16, y + 3, f"{words} {unit}".strip()))
    return drawing(plot.width, plot.height, parts, what)


def photograph(rgba: Array, cell: float, left: float, top: float, unit: str, what: str) -> Drawing:
    """A picture (h, w, 4) to scale with axes."""
    rgb = np.where(rgba[..., 3:] > 0, rgba[..., :3], np.array(NOTHING, np.uint8))
    plot, parts = _framed(rgb, cell, left, top, unit)
    return drawing(plot.width, plot.height, parts, what)


def class_map(
    values: Array, classes: Classes, cell: float, left: float, top: float, unit: str, what: str
) -> Drawing:  # fmt: skip
    """Standard deviations on a grid in classes of colours, with axes and legend."""
    plot, parts = _framed(classed(values, classes), cell, left, top, unit)
    x0, y0, w, _ = plot.box
    parts += _legend(classes, x0 + w + 16, y0 + 8)
    return drawing(plot.width, plot.height, parts, what)


def small_map(values: Array, classes: Classes, name: str, reported: str, width: float = 200) -> Drawing:
    """Standard deviations of a depth map in classes of colours, with the name of its photograph above."""
    height = width * values.shape[0] / max(values.shape[1], 1)
    parts = [
        label(0, 11, name, "name"), embedded(classed(values, classes), 0, 16, width, height),
        label(0, height + 29, reported),
    ]  # fmt: skip
    return drawing(width, height + 34, parts, phrase("drawn.depth_map", name=name))


def legend_of(classes: Classes) -> Drawing:
    """The colours alone."""
    longest = max(len(words) for _, words in classes.legend)
    parts = _legend(classes, 0, 10)
    return drawing(24 + CHARACTER * longest, 8 + LEGEND_PX * len(classes.legend), parts, classes.legend[0][1])


def _framed(rgb: Array, cell: float, left: float, top: float, unit: str) -> tuple[Plot, list[str]]:
    """A picture with axes in the object's unit."""
    rows, columns = rgb.shape[:2]
    wide, high = columns * cell, rows * cell
    right, around = 200.0, 58.0
    width = 720.0
    height = (width - around - right) * high / wide
    if height > 560:
        height, width = 560.0, around + right + 560.0 * wide / high
    plot = Plot(
        width=width, height=height + 46, left=around, right=right, x_range=(left, left + wide),
        y_range=(top - high, top),
    )  # fmt: skip
    x0, y0, w, h = plot.box
    right_, up = (
        (phrase("axis.right_in", unit=unit), phrase("axis.up_in", unit=unit)) if unit
        else (phrase("axis.right"), phrase("axis.up"))
    )  # fmt: skip
    return plot, [embedded(rgb, x0, y0, w, h), axes(plot, right_, up, grid="")]


def _legend(classes: Classes, x: float, y: float) -> list[str]:
    parts = list[str]()
    for k, (colour, words) in enumerate(classes.legend):
        if colour:
            parts.append(f'<rect x="{x:.1f}" y="{y + LEGEND_PX * k - 8:.1f}" width="11" height="9" fill="{colour}"/>')
        parts.append(label(x + (16 if colour else 0), y + LEGEND_PX * k, words))
    return parts
