"""Section: panoramas, their residuals by direction and elevation, and the eccentricity of the projection centre."""

from __future__ import annotations

import math

import numpy as np

from raybundle.adjustment.records.figures import InteriorResult, ParameterResult
from raybundle.block import Camera
from raybundle.errors import Text, note, phrase
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.report.chapters import section
from raybundle.report.figures.series import running, series_figure
from raybundle.report.figures.svg import Drawing, drawing, label
from raybundle.report.parts import Figure, Figures, Heading, Paragraph, Part, Section, Statements
from raybundle.report.text.numbers import significant
from raybundle.report.view import View, rms

MODELS = ("panorama", "spherical")
BELIEVED = 0.001
"""Probability by chance below which a trend counts as seen."""
SECTORS = 36
SIZE = 300.0
"""Side of the sketch [px]."""


@section("panoramas", after="scenes")
def panorama_section(view: View) -> Section | None:
    """Residuals against direction and elevation and a sketch of each panoramic camera; None without one."""
    parts: list[Part] = []
    for index, mask in view.cameras():
        camera = view.adjusted.cameras[index]
        if camera.model in MODELS:
            parts += _camera_parts(view, camera, mask)
    return Section(anchor="panoramas", title=phrase("report_panoramas.title"), parts=tuple(parts)) if parts else None


def _camera_parts(view: View, camera: Camera, mask: Mask) -> list[Part]:
    rows = np.flatnonzero(mask).astype(np.int32)
    direction, elevation = _angles(view, camera, rows)
    v = view.adjustment.image_observations.residuals_px[rows]
    result = next((r for r in view.adjustment.interior if r.camera == camera.id), None)
    images = len(np.unique(view.given.observations.image[rows]))
    parts: list[Part] = [
        Heading(text=phrase("report_panoramas.camera", camera=camera.id)),
        Paragraph(
            text=Text.of(
                note("report_panoramas.count", n=images, points=len(rows)),
                note(
                    "report_panoramas.extent",
                    direction_from=float(direction.min()),
                    direction_to=float(direction.max()),
                    elevation_from=float(elevation.min()),
                    elevation_to=float(elevation.max()),
                ),
                note("report_panoramas.rms", arc_px=rms(v[:, 0]), line_px=rms(v[:, 1])),
            )
        ),
    ]
    words: list[tuple[str, str]] = []
    figures: list[Figure] = []
    for at, name in ((direction, "direction"), (elevation, "elevation")):
        for k in range(2):
            figure, word = _against(view, rows, at, v[:, k], name, k)
            figures.append(figure)
            words += word
    if not words:
        words = [(phrase("report_panoramas.residuals"), phrase("report_panoramas.no_trend"))]
    words += _eccentricity_words(view, result)
    parts.append(Statements(statements=tuple(words)))
    parts.append(Figures(figures=tuple(figures)))
    sketch = _sketch(view, result, direction)
    parts.append(
        Figures(
            figures=(
                Figure(
                    drawing=sketch,
                    caption=phrase("report_panoramas.sketch"),
                ),
            )
        )
    )
    return parts


def _angles(view: View, camera: Camera, rows: Index) -> tuple[Array, Array]:
    """Direction on the cylinder or sphere and elevation [deg] of image points."""
    c = float(camera.values["c"])
    xy = camera.image_from_pixel(view.given.observations.xy_px[rows])
    y = xy[:, 1] - float(camera.values.get("y0", 0.0))
    elevation = y / c if camera.model == "spherical" else np.arctan2(y, c)
    return np.degrees(xy[:, 0] / c), np.degrees(elevation)


def _against(
    view: View, rows: Index, at: Array, v: Array, name: str, axis: int
) -> tuple[Figure, list[tuple[str, str]]]:
    """Residuals against an angle, and what is to be stated of them."""
    low, high = float(at.min()), float(at.max())
    sigma = np.sqrt(view.given.observations.cov_px2[rows, axis])
    windows = int(np.clip(len(rows) // 12, 12, 60))
    curve = running(at, v, low, max(high, low + 1e-6), windows, sigma)
    arc = axis == 0
    chance = [note("report_panoramas.chance", p=float(curve.probability))] if math.isfinite(curve.probability) else []
    figure = Figure(
        drawing=series_figure(
            at,
            v,
            curve,
            phrase("axis.panorama", angle=name),
            phrase("axis.along", arc=arc),
            phrase("drawn.along_against", arc=arc, angle=name),
            x_range=(low, max(high, low + 1e-6)),
        ),
        caption=Text.of(note("report_panoramas.against", arc=arc, angle=name), *chance),
    )
    if not curve.probability < BELIEVED:
        return figure, []
    size = float(np.nanmax(np.abs(curve.mean)))
    trend = phrase("report_panoramas.trend", arc=arc, angle=name, size_px=size)
    return figure, [(phrase("report_panoramas.angle", angle=name), trend)]


def _parameter(result: InteriorResult | None, symbol: str) -> ParameterResult | None:
    return None if result is None else result.parameters.get(symbol)


def _eccentricity_words(view: View, result: InteriorResult | None) -> list[tuple[str, str]]:
    """The eccentricity with its standard deviation in words."""
    found = [note("report_panoramas.eccentric")]
    for symbol in ("e", "d"):
        p = _parameter(result, symbol)
        if p is not None and p.std:
            value, sigma = p.value * view.factor, p.std * view.factor
            found.append(note("report_panoramas.offset", symbol=symbol, value=value, sigma=sigma, unit=view.unit))
    if len(found) == 1:
        return []
    return [(phrase("report_panoramas.eccentricity"), Text.of(*found))]


def _sketch(view: View, result: InteriorResult | None, direction: Array) -> Drawing:
    """A rose of the image points by direction, and within it the axis and the eccentric projection centre."""
    middle, inner, outer = SIZE / 2, 58.0, SIZE / 2 - 18
    counts = np.histogram(direction % 360, np.linspace(0, 360, SECTORS + 1))[0]
    top = max(int(counts.max(initial=1)), 1)
    parts = [f'<circle class="format" cx="{middle}" cy="{middle}" r="{inner}"/>']
    half = math.pi / SECTORS * 0.85
    for k, n in enumerate(counts.tolist()):
        if not n:
            continue
        angle, r = 2 * math.pi * (k + 0.5) / SECTORS, inner + (outer - inner) * n / top
        ends = [(inner, angle - half), (r, angle - half), (r, angle + half), (inner, angle + half)]
        path = "L".join(f"{middle + q * math.sin(a):.1f} {middle - q * math.cos(a):.1f}" for q, a in ends)
        parts.append(f'<path class="bar" d="M{path}Z"/>')
    for words, x, y in (("0°", middle, 11), ("90°", SIZE - 1, middle + 4), ("180°", middle, SIZE - 4)):
        parts.append(label(x, y, words, anchor="end" if x > middle else "middle"))
    parts.append(label(1, middle + 4, "270°"))
    parts += _centre(view, result, middle, inner)
    return drawing(SIZE, SIZE, parts, phrase("drawn.panorama"))


def _centre(view: View, result: InteriorResult | None, middle: float, inner: float) -> list[str]:
    """The axis, the projection centre and its standard deviations."""
    parts = [f'<path class="mark" d="M{middle - 5} {middle}h10M{middle} {middle - 5}v10"/>']
    along, across = (_parameter(result, s) for s in ("e", "d"))
    e, d = (0.0 if p is None else p.value for p in (along, across))
    std = [0.0 if p is None or not p.std else p.std for p in (across, along)]
    size = max(abs(e), abs(d))
    if not size > 0:
        return parts
    scale = 0.5 * inner / size
    x, y = middle + d * scale, middle - e * scale
    rx, ry = (max(s * scale, 0.8) for s in std)
    parts.append(f'<path class="curve first" d="M{middle} {middle}L{x:.1f} {y:.1f}"/>')
    parts.append(f'<ellipse class="ellipse" cx="{x:.1f}" cy="{y:.1f}" rx="{rx:.1f}" ry="{ry:.1f}"/>')
    parts.append(f'<circle class="dot" cx="{x:.1f}" cy="{y:.1f}" r="2.5"/>')
    words = f"{significant(math.hypot(e, d) * view.factor, 3)} {view.unit}"
    below = middle + inner - 10 if y < middle + 12 else middle - inner + 16
    parts.append(label(middle, below, words, "t", "middle"))
    return parts
