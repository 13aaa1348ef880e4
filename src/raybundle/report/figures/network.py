"""Figures of the network: plan and side views with images, points and error ellipses; rays, angles, rolls."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

import numpy as np

from raybundle.adjustment.records.figures import NetworkFigures
from raybundle.block import Role
from raybundle.errors import Message, note, phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.report.figures.svg import (
    CHARACTER,
    Drawing,
    Interval,
    Plot,
    axes,
    columns,
    count_ticks,
    dots,
    drawing,
    fitted,
    histogram,
    label,
    labels_apart,
    round_below,
    round_step,
    spread_rows,
    tick_labels,
    ticks,
    written,
)
from raybundle.report.network.shape import ellipse_rows, ellipses, frusta, frustum_size, network_shape
from raybundle.report.text.numbers import significant
from raybundle.report.view import View

MOST_POINTS, MOST_IMAGES, MOST_NAMES = 1500, 250, 40
GAP, FOOT = 30.0, 44.0
Panel = tuple[Plot, int, int]
"""A view: its plot and the object axes (0 X, 1 Y, 2 Z) that run right and up."""


@dataclass(frozen=True, slots=True, kw_only=True)
class NetworkViews:
    """The drawing and what has to be stated below it."""

    drawing: Drawing
    remark: tuple[Message, ...]


def network_views(view: View) -> NetworkViews | None:
    """Plan XY with the side views XZ below and ZY beside it, at one scale; None if nothing has coordinates."""
    shape = network_shape(view)
    if shape is None:
        return None
    xyz, seen, kept, images = view.adjusted.points.xyz, shape.seen, shape.kept, shape.images
    panels, width, height, px_per_unit = _panels(shape.limits)
    shown = kept[spread_rows(len(kept), MOST_POINTS)]
    drawn_images = images[spread_rows(len(images), MOST_IMAGES)]
    remark = [
        note("report_network.drawn", points=len(shown), of=len(seen), images=len(drawn_images), of_images=len(images))
    ]
    if shape.far:
        remark.append(note("report_network.far_points", n=shape.far))
    drawn, factor = ellipse_rows(view, shown, 8 / px_per_unit)
    if factor:
        remark.append(note("report_network.ellipses", n=len(drawn), factor=factor))
    frames = frusta(view.adjusted, drawn_images, frustum_size(shape.limits, len(drawn_images)))
    parts: list[str] = []
    for plot, a, b in panels:
        parts.append(axes(plot, f"{'XYZ'[a]} [{view.length_unit}]", f"{'XYZ'[b]} [{view.length_unit}]", grid="xy"))
        x, y, w, h = plot.box
        clip = f"panel{a}{b}"
        parts.append(
            f'<clipPath id="{clip}"><rect x="{x:.1f}" y="{y:.1f}" width="{w:.1f}" height="{h:.1f}"/></clipPath>'
        )
        parts.append(f'<g clip-path="url(#{clip})">')
        parts.append(_frames(plot, frames[:, :, [a, b]], [view.given.images.ids[i] for i in drawn_images]))
        parts.append(dots(plot.x(xyz[shown, a]), plot.y(xyz[shown, b]), "points"))
        if factor:
            parts.append(_ellipses(view, drawn, (plot, a, b), factor * px_per_unit))
        parts += [_scale_bars(view, (plot, a, b)), _symbols(view, kept, (plot, a, b)), "</g>"]
    if factor:
        parts.append(_ellipse_key(view, factor * px_per_unit, width, height))
    return NetworkViews(drawing=drawing(width, height, parts, phrase("drawn.network_views")), remark=tuple(remark))


def _panels(limits: Sequence[Interval]) -> tuple[list[Panel], float, float, float]:
    """The three views at one scale within about 880 x 900 pixels, the size of the drawing, and pixels per unit."""
    dx, dy, dz = (high - low for low, high in limits)
    left = 30 + CHARACTER * max(len(s) for limit in limits for s in tick_labels(ticks(limit)))
    scale = min((880 - 2 * left - GAP) / (dx + dz), (900 - 2 * FOOT) / (dy + dz), 560 / dy)
    w, d, h = dx * scale, dz * scale, dy * scale
    width, height = left + w + GAP + left + d + 12, 10 + h + FOOT + d + FOOT + 10
    plan = Plot(width=width, height=height, left=left, right=width - left - w, top=10, bottom=height - 10 - h,
                x_range=limits[0], y_range=limits[1])  # fmt: skip
    side_left = left + w + GAP + left
    side = Plot(width=width, height=height, left=side_left, right=width - side_left - d, top=10, bottom=height - 10 - h,
                x_range=limits[2], y_range=limits[1])  # fmt: skip
    top = 10 + h + FOOT
    front = Plot(width=width, height=height, left=left, right=width - left - w, top=top, bottom=height - top - d,
                 x_range=limits[0], y_range=limits[2])  # fmt: skip
    return [(plan, 0, 1), (side, 2, 1), (front, 0, 2)], width, height, scale


def _frames(plot: Plot, frusta: Array, names: list[str]) -> str:
    """The pyramids of the images, each with its name under the pointer."""
    parts: list[str] = []
    for pyramid, name in zip(frusta, names, strict=True):
        p = [
            f"{x:.1f} {y:.1f}"
            for x, y in zip(plot.x(pyramid[:, 0]).tolist(), plot.y(pyramid[:, 1]).tolist(), strict=True)
        ]
        d = f"M{p[1]}L{p[2]}L{p[3]}L{p[4]}ZM{p[1]}L{p[0]}L{p[2]}M{p[3]}L{p[0]}L{p[4]}"
        parts.append(f'<path class="camera" d="{d}"><title>{escape(name)}</title></path>')
    return "".join(parts)


def _ellipses(view: View, rows: Index, panel: Panel, px_per_unit: float) -> str:
    """Error ellipses in a view: the covariance projected onto its plane."""
    plot, a, b = panel
    axes_, major_axis = ellipses(view, rows, a, b)
    radius = axes_ * px_per_unit
    turn = np.degrees(np.arctan2(-major_axis[:, 1], major_axis[:, 0]))
    x, y = plot.x(view.adjusted.points.xyz[rows, a]), plot.y(view.adjusted.points.xyz[rows, b])
    table = zip(x.tolist(), y.tolist(), radius[:, 1].tolist(), radius[:, 0].tolist(), turn.tolist(), strict=True)
    return "".join(
        f'<ellipse class="ellipse" rx="{major:.1f}" ry="{max(minor, 0.3):.1f}" '
        f'transform="translate({u:.1f} {v:.1f})rotate({t:.0f})"/>'
        for u, v, major, minor, t in table
    )


def _ellipse_key(view: View, px_per_unit: float, width: float, height: float) -> str:
    """A circle of known size, below the side view."""
    unit = round_below(10 / px_per_unit)
    x, y = width - 110, height - 24
    words = f"{significant(unit * view.factor, 1)} {view.unit}"
    return f'<circle class="ellipse" cx="{x:.1f}" cy="{y:.1f}" r="{unit * px_per_unit:.1f}"/>' + label(
        x + 18, y + 3.5, words
    )


def _scale_bars(view: View, panel: Panel) -> str:
    plot, a, b = panel
    d, xyz = view.given.distances, view.adjusted.points.xyz
    ends = [(plot.x(xyz[i, a]), plot.y(xyz[i, b])) for i in (d.start, d.end)]
    (x1, y1), (x2, y2) = ends
    good = np.isfinite(x1) & np.isfinite(x2)
    path = "".join(
        f"M{p:.1f} {q:.1f}L{r:.1f} {s:.1f}" for p, q, r, s in zip(x1[good], y1[good], x2[good], y2[good], strict=True)
    )
    return f'<path class="bar-line" d="{path}"/>' if path else ""


def _symbols(view: View, kept: Index, panel: Panel) -> str:
    """Control points as triangles, check points as circles, with their names where they are few."""
    plot, a, b = panel
    role = np.asarray(view.given.points.role)[kept]
    special = kept[role != Role.TIE]
    parts: list[str] = []
    for i in special[:: max(1, len(special) // 400)]:
        x, y = (float(f(view.adjusted.points.xyz[i, k])) for f, k in ((plot.x, a), (plot.y, b)))
        name = view.given.points.ids[i]
        shape = (
            f'<path class="control" d="M{x:.1f} {y - 4.5:.1f}l4.2 7.2h-8.4z">'
            if view.given.points.role[i] == Role.CONTROL
            else f'<circle class="check" cx="{x:.1f}" cy="{y:.1f}" r="3.6">'
        )
        parts.append(f"{shape}<title>{escape(name)}</title></{'path' if 'path' in shape else 'circle'}>")
    if len(special) <= MOST_NAMES and (a, b) == (0, 1):
        xyz, names = view.adjusted.points.xyz[special], [view.given.points.ids[i] for i in special]
        parts += labels_apart(plot.x(xyz[:, a]).tolist(), plot.y(xyz[:, b]).tolist(), names, plot.box)
    return "".join(parts)


def ray_histogram(rays: Array, what: str) -> Drawing:
    """Number of object points against their number of rays."""
    counts = np.bincount(rays[rays > 0].astype(int))
    step = 1 if len(counts) <= 60 else math.ceil(round_step(len(counts), 40))
    least = int(np.flatnonzero(counts)[0]) if counts.any() else 0
    edges = np.arange(least - 1, len(counts) + step, step) - 0.5
    heights = np.histogram(rays[rays > 0], edges)[0].astype(float)
    x_range, y_range = (float(edges[0]), float(edges[-1])), (0.0, max(float(heights.max()), 1.0) * 1.06)
    plot = fitted(Plot(width=286, height=190, x_range=x_range, y_range=y_range))
    parts = [
        axes(
            plot,
            phrase("axis.rays_per_point"),
            phrase("label.points"),
            x_count=min(6, max(1, int(edges[-1] - edges[0]))),
            y_count=count_ticks(heights),
        ),
        columns(plot, edges, heights),
    ]
    return drawing(plot.width, plot.height, parts, what)


def angle_histogram(figures: NetworkFigures, what: str) -> Drawing:
    """Number of object points against their largest intersection angle."""
    return histogram(
        np.degrees(figures.intersection_angle), phrase("axis.largest_intersection_angle"), what,
        edges=np.arange(0, 181, 10.0), y_label=phrase("label.points"), width=286,
    )  # fmt: skip


def roll_rose(roll: Array, what: str) -> Drawing:
    """Rolls of the images about the viewing axis as spokes; zero, the most frequent one, is up."""
    good = roll[np.isfinite(roll)]
    size, r = 190.0, 70.0
    m = size / 2
    counts = np.bincount(np.round(np.degrees(good) / 5).astype(int) % 72, minlength=72)
    parts = [f'<circle class="frame" cx="{m:g}" cy="{m:g}" r="{r:g}"/>']
    for angle, words in ((0, "0°"), (90, "90°"), (180, "180°"), (270, "−90°")):
        x, y = m + math.sin(math.radians(angle)) * (r + 13), m - math.cos(math.radians(angle)) * (r + 13)
        parts.append(label(x, y + 3.5, words, "t", "middle"))
    most = max(int(counts.max(initial=0)), 1)
    for k, n in enumerate(counts.tolist()):
        if n:
            length = r * (0.25 + 0.75 * math.sqrt(n / most))
            x, y = m + math.sin(math.radians(5 * k)) * length, m - math.cos(math.radians(5 * k)) * length
            title = written(phrase("drawn.spoke", angle_deg=5 * k, n=n))
            parts.append(f'<path class="spoke" d="M{m:g} {m:g}L{x:.1f} {y:.1f}"><title>{title}</title></path>')
    return drawing(size, size, parts, what)
