"""An interior orientation: curves of distortion, corrections over the format, uncertainty of projection."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from raybundle.adjustment.records.figures import InteriorResult
from raybundle.calibration.maps import UncertaintyMap
from raybundle.errors import InputError, Text, phrase
from raybundle.report.figures.distortion import (
    ADDITIONAL,
    Curve,
    Interior,
    balanced,
    decentring_curve,
    field,
    radial_curve,
)
from raybundle.report.figures.svg import round_below
from raybundle.report.interiors import drawable, reach_of, uncertainty_maps
from raybundle.report.plots.canvas import (
    BLACK,
    BLUE,
    GREY,
    PANEL,
    VERMILION,
    Canvas,
    begun,
    cells_over_format,
    format_axes,
)
from raybundle.report.text.numbers import significant
from raybundle.report.view import View, adjusted_interior, key_of, name_of

Panel = Callable[[Axes], None]
ACROSS = 3
"""Panels beside each other"""


def draw(view: View, camera: str | None, image: str | None, figure: Canvas | None) -> Figure:
    """The panels that an interior orientation has; raises InputError where there are none."""
    result = _chosen(view, camera, image)
    panels = _panels(view, result)
    if not panels:
        raise InputError("figure.no_distortion", name=name_of(result))
    across = min(ACROSS, len(panels))
    down = math.ceil(len(panels) / across)
    canvas, whole = begun(figure, (PANEL + 0.5) * across, 0.3 + (PANEL - 0.5) * down)
    canvas.suptitle(f"{name_of(result)}, model {adjusted_interior(view, result).camera.model}", fontsize="medium")
    grid = canvas.add_gridspec(down, across)
    for k, panel in enumerate(panels):
        panel(canvas.add_subplot(grid[k // across, k % across]))
    return whole


def _chosen(view: View, camera: str | None, image: str | None) -> InteriorResult:
    """The interior orientation that is asked for, or the first that has figures."""
    every = [r for r in view.adjustment.interior if drawable(view, r)]
    if not every:
        raise InputError("figure.no_camera")
    found = [r for r in every if camera in (None, r.camera) and image in (None, r.image)]
    if not found:
        raise InputError(
            "figure.none_of_camera", name=" ".join(filter(None, (camera, image))), known=[key_of(r) for r in every]
        )
    return found[0]


def _panels(view: View, result: InteriorResult) -> list[Panel]:
    interior = adjusted_interior(view, result)
    reach = reach_of(view, result, interior)
    found: list[Panel] = []
    sigmas: list[tuple[Curve, str, str, str]] = []
    if interior.has("radial"):
        curve = radial_curve(interior)
        flat, share = balanced(curve)
        words = f"{phrase('drawn.balanced')} ($c$ {'+' if share > 0 else ''}{significant(100 * share, 2)} %)"
        drawn = [(curve, BLUE, "-", phrase("drawn.gaussian")), (flat, VERMILION, "--", words)]
        found.append(partial(_curves, interior, drawn, reach, phrase("plot.radial"), _correction()))
        sigmas.append((curve, BLUE, "-", phrase("drawn.radial")))
    if interior.has("decentring"):
        curve = decentring_curve(interior)
        found.append(
            partial(_curves, interior, [(curve, BLUE, "-", "")], reach, phrase("plot.decentring"), _correction())
        )
        sigmas.append((curve, VERMILION, "--", phrase("plot.decentring_curve")))
    spread = [
        (Curve(radius_mm=c.radius_mm, value_mm=c.std_mm, std_mm=None), colour, style, name)
        for c, colour, style, name in sigmas
        if c.std_mm is not None
    ]
    if spread:
        title = phrase("plot.correction_sigma")
        found.append(partial(_curves, interior, spread, reach, title, phrase("axis.standard_deviation", unit="µm")))
    if any(interior.has(k) for k in sorted(ADDITIONAL)):
        found.append(partial(_grid, interior))
    found += [partial(_uncertainty, view, interior, m) for m in uncertainty_maps(view, result)]
    return found


def _correction() -> Text:
    """The name of an axis."""
    return phrase("axis.correction", unit="µm")


def _curves(
    interior: Interior, drawn: Sequence[tuple[Curve, str, str, str]], reach: float, title: str, name: str, axes: Axes
) -> None:
    """Curves with their bands against the radius, in µm and in px."""
    for curve, colour, style, words in drawn:
        um = 1000 * curve.value_mm
        axes.plot(curve.radius_mm, um, color=colour, linestyle=style, linewidth=1.5, label=words)
        if curve.std_mm is not None:
            s = 1000 * curve.std_mm
            axes.fill_between(curve.radius_mm, um - s, um + s, color=colour, alpha=0.25, linewidth=0)
    axes.axhline(0, color=BLACK, linewidth=0.6)
    axes.set(xlim=(0, interior.corner_mm), xlabel=phrase("axis.radius"), ylabel=name)
    axes.set_title(title, fontsize="medium")
    axes.grid(visible=True, alpha=0.3, linewidth=0.6)
    if reach < interior.corner_mm:
        axes.axvspan(
            reach, interior.corner_mm, color=GREY, alpha=0.25, linewidth=0, label=phrase("drawn.no_observation")
        )
    if len(drawn) > 1 or reach < interior.corner_mm:
        axes.legend(fontsize="small", loc="best", framealpha=0.7, handlelength=1.5)
    px = axes.secondary_yaxis(
        "right", functions=(partial(np.multiply, 1e-3 / interior.pixel), partial(np.multiply, 1e3 * interior.pixel))
    )
    px.set_ylabel("[px]")


def _grid(interior: Interior, axes: Axes) -> None:
    """A grid over the format, and where the corrections, enlarged, take its lines."""
    camera = interior.camera
    image, shift = field(interior, 21)
    columns = len(np.unique(np.round(image[0], 9)))
    pixel = np.array(camera.pixel_mm)[:, None]
    at = np.asarray(camera.pixel_from_image(image.T)).T.reshape(2, -1, columns)
    d = (shift / pixel * np.array([[1.0], [-1.0]])).reshape(2, -1, columns)
    size = np.linalg.norm(d, axis=0)
    largest = float(np.nanmax(size)) if np.isfinite(size).any() else 0.0
    enlarged = round_below(0.8 * camera.width_px / 21 / largest) if largest > 0 else 1.0
    moved = at + enlarged * d
    for lines, colour, width in ((at, GREY, 0.5), (moved, BLUE, 0.9)):
        axes.plot(lines[0], lines[1], color=colour, linewidth=width)
        axes.plot(lines[0].T, lines[1].T, color=colour, linewidth=width)
    x, y = np.asarray(camera.pixel_from_image(interior.principal_point[None])).ravel().tolist()
    axes.plot([x], [y], linestyle="none", marker="+", markersize=10, color=VERMILION, markeredgewidth=1.4)
    format_axes(axes, camera, phrase("plot.corrections", times=enlarged, largest_px=largest))
    m = 0.03 * max(camera.width_px, camera.height_px)
    axes.set(xlim=(-m, camera.width_px + m), ylim=(camera.height_px + m, -m))


def _uncertainty(view: View, interior: Interior, found: UncertaintyMap, axes: Axes) -> None:
    camera = interior.camera
    distance = 0.0 if found.distance is None else found.distance
    title = phrase("plot.projection", distance=distance, unit=view.length_unit, largest_px=found.largest)
    format_axes(axes, camera, title)
    cells_over_format(axes, camera, found.std, phrase("axis.standard_deviation", unit="px"), "viridis")
