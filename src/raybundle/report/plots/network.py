"""The network in plan, front and side view."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.lines import Line2D
from matplotlib.transforms import ScaledTranslation
from mpl_toolkits.axes_grid1.anchored_artists import AnchoredSizeBar

from raybundle.block import Role
from raybundle.errors import InputError, phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.report.figures.svg import Interval, round_below
from raybundle.report.network.shape import (
    NetworkShape,
    ellipse_rows,
    ellipses,
    frusta,
    frustum_size,
    network_shape,
)
from raybundle.report.plots.canvas import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    RASTERIZED,
    VERMILION,
    Canvas,
    begun,
    length_words,
    named,
)
from raybundle.report.view import View

WIDEST, TALLEST = 6.6, 6.6
"""Of the views, without what stands about them [inch]"""
HALF_AXIS = 0.014
"""Of an enlarged ellipse, as a share of the widest extent"""
PYRAMID = ((1, 2, 3, 4, 1, 0, 2), (3, 0, 4))
"""The lines of an image: positions of its projection centre and of the corners of its format"""
MOST_NAMES = 40


def draw(view: View, figure: Canvas | None) -> Figure:
    """The three views at one scale; raises InputError where nothing has coordinates."""
    shape = network_shape(view)
    if shape is None:
        raise InputError("figure.no_network")
    canvas, whole, views = _views(shape.limits, figure, view.length_unit)
    widest = max(high - low for low, high in shape.limits)
    rows, factor = ellipse_rows(view, shape.kept, HALF_AXIS * widest)
    pyramids = frusta(view.adjusted, shape.images, frustum_size(shape.limits, len(shape.images)))
    role = np.asarray(view.given.points.role)[shape.kept]
    for axes, a, b in views:
        _points(axes, view.adjusted.points.xyz[shape.kept][:, [a, b]], role)
        _images(axes, pyramids[:, :, [a, b]])
        _bars(axes, view, a, b)
        if factor:
            _ellipses(axes, view, rows, (a, b), factor)
    if factor:
        _scale(views[2][0], view, factor, widest)
    canvas.suptitle(_title(shape, len(rows), factor), fontsize="medium")
    _legend(canvas, view, role, factor)
    special = shape.kept[role != Role.TIE]
    if 0 < len(special) <= MOST_NAMES:
        named(views[0][0], view.adjusted.points.xyz[special][:, :2], [view.given.points.ids[i] for i in special])
    return whole


def _views(
    limits: Sequence[Interval], figure: Canvas | None, unit: str
) -> tuple[Canvas, Figure, list[tuple[Axes, int, int]]]:
    """Axes of the plan, the side view beside it and the front view below; each with the object axes right and up."""
    dx, dy, dz = (high - low for low, high in limits)
    scale = min(WIDEST / (dx + dz), TALLEST / (dy + dz))
    canvas, whole = begun(figure, max(scale * (dx + dz) + 1.4, 4.2), scale * (dy + dz) + 2.0, "compressed")
    grid = canvas.add_gridspec(2, 2, width_ratios=(dx, dz), height_ratios=(dy, dz))
    views: list[tuple[Axes, int, int]] = []
    for row, column, a, b in ((0, 0, 0, 1), (1, 0, 0, 2), (0, 1, 2, 1)):
        axes = canvas.add_subplot(grid[row, column])
        axes.set(xlim=limits[a], ylim=limits[b], aspect="equal", anchor="NW")
        axes.set(xlabel=f"{'XYZ'[a]} [{unit}]", ylabel=f"{'XYZ'[b]} [{unit}]")
        # as many ticks as there is room for
        extents = [(high - low) * scale for low, high in (limits[a], limits[b])]
        axes.locator_params("x", nbins=max(2, round(extents[0] / 0.75)))
        axes.locator_params("y", nbins=max(2, round(extents[1] / 0.5)))
        axes.ticklabel_format(style="plain", useOffset=False)
        axes.grid(visible=True, alpha=0.3, linewidth=0.6)
        axes.set_axisbelow(True)
        views.append((axes, a, b))
    return canvas, whole, views


def _points(axes: Axes, xy: Array, role: Array) -> None:
    tie = role == Role.TIE
    size = 6.0 if tie.sum() < RASTERIZED else 0.8
    axes.scatter(
        xy[tie, 0], xy[tie, 1], s=size, c=GREY, linewidths=0, rasterized=bool(tie.sum() > RASTERIZED), zorder=2
    )
    for kind, marker, colour in ((Role.CONTROL, "^", VERMILION), (Role.CHECK, "o", GREEN)):
        mine = role == kind
        axes.scatter(
            xy[mine, 0], xy[mine, 1], s=30, marker=marker, facecolors="none", edgecolors=colour, linewidths=1.2,
            rasterized=bool(mine.sum() > RASTERIZED), zorder=5,
        )  # fmt: skip


def _images(axes: Axes, pyramids: Array) -> None:
    lines = [pyramid[list(stroke)] for pyramid in pyramids for stroke in PYRAMID]
    axes.add_collection(
        LineCollection(lines, colors=BLUE, linewidths=0.7, rasterized=len(lines) > RASTERIZED, zorder=3),
        autolim=False,
    )


def _bars(axes: Axes, view: View, a: int, b: int) -> None:
    d, xyz = view.given.distances, view.adjusted.points.xyz[:, [a, b]]
    if len(d.start):
        axes.add_collection(
            LineCollection(list(np.stack([xyz[d.start], xyz[d.end]], axis=1)), colors=BLACK, linewidths=1.4, zorder=4),
            autolim=False,
        )


def _ellipses(axes: Axes, view: View, rows: Index, plane: tuple[int, int], factor: float) -> None:
    half, major = ellipses(view, rows, *plane)
    drawn = EllipseCollection(
        2 * factor * half[:, 1], 2 * factor * half[:, 0], np.degrees(np.arctan2(major[:, 1], major[:, 0])),
        units="xy", offsets=view.adjusted.points.xyz[rows][:, list(plane)], offset_transform=axes.transData,
        facecolors="none", edgecolors=ORANGE, linewidths=0.8, zorder=4,
    )  # fmt: skip
    axes.add_collection(drawn, autolim=False)


def _scale(axes: Axes, view: View, factor: float, widest: float) -> None:
    """A bar of known size for the semi-axes of the ellipses, below the side view, where nothing else stands."""
    unit = round_below(0.08 * widest / factor * view.factor) / view.factor
    words = f"{length_words(unit * view.factor, view.unit)}\n({phrase('plot.error_ellipses')})"
    below = axes.transAxes + ScaledTranslation(0, -0.55, axes.figure.dpi_scale_trans)
    bar = AnchoredSizeBar(
        axes.transData, unit * factor, words, "upper left", pad=0, borderpad=0, color=BLACK, sep=4, frameon=False,
        fontproperties=FontProperties(size="small"), bbox_to_anchor=(0, 0), bbox_transform=below,
    )  # fmt: skip
    bar.set_in_layout(False)
    axes.add_artist(bar)


def _title(shape: NetworkShape, drawn: int, factor: float) -> str:
    title = str(phrase("plot.network", images=len(shape.images), points=len(shape.kept), far=shape.far))
    return f"{title}\n{phrase('plot.ellipses', n=drawn, times=factor)}" if factor else title


def _legend(canvas: Canvas, view: View, role: Array, factor: float) -> None:
    def mark(name: str, marker: str, colour: str, *, filled: bool = False) -> Line2D:
        size, face, edge = (4, colour, 0.0) if filled else (6, "none", 1.2)
        return Line2D(
            [], [], linestyle="none", marker=marker, markersize=size, color=colour, markerfacecolor=face,
            markeredgewidth=edge, label=name,
        )  # fmt: skip

    handles = [Line2D([], [], color=BLUE, linewidth=0.9, label=phrase("label.images"))]
    handles += [mark(phrase("label.object_points"), "o", GREY, filled=True)] if (role == Role.TIE).any() else []
    handles += [mark(phrase("network_page.control_points"), "^", VERMILION)] if (role == Role.CONTROL).any() else []
    handles += [mark(phrase("label.check_points"), "o", GREEN)] if (role == Role.CHECK).any() else []
    if len(view.given.distances.start):
        handles.append(Line2D([], [], color=BLACK, linewidth=1.4, label=phrase("network_page.scale_bars")))
    handles += [Line2D([], [], color=ORANGE, linewidth=0.9, label=phrase("plot.error_ellipses"))] if factor else []
    canvas.legend(handles=handles, loc="outside lower center", ncols=min(len(handles), 3), fontsize="small",
                  frameon=False)  # fmt: skip
