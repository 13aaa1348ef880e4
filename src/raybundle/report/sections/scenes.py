"""Sections: satellite scenes, and strips of aerial line scanners: corrections, residuals along the track, jitter."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, cast

import numpy as np

from raybundle.adjustment.records.figures import InteriorResult
from raybundle.block import Camera
from raybundle.errors import Message, Text, message_of_text, note, phrase, text_of_error
from raybundle.numerics.arrays import Array, Index
from raybundle.report.chapters import section
from raybundle.report.figures.corrections import correction_figures
from raybundle.report.figures.interior import format_plot, scale_bar
from raybundle.report.figures.residuals import exaggeration, image_vectors
from raybundle.report.figures.series import Running, line_figure, running, series_figure
from raybundle.report.figures.svg import Drawing, drawing, round_below, vectors
from raybundle.report.parts import (
    Column,
    Figure,
    Figures,
    Folded,
    Heading,
    Paragraph,
    Part,
    Section,
    Statements,
    Table,
    number,
    table,
    text,
)
from raybundle.report.residuals import normalised
from raybundle.report.text.numbers import NONE, fixed, grouped, significant, with_sigma
from raybundle.report.text.words import printed
from raybundle.report.view import View, rms, rows_of

if TYPE_CHECKING:
    from raybundle.scenes.sensor import SceneSensor

OPEN_ROWS = 60
"""Longer tables are folded."""
MOST_DRAWN = 6
"""Scenes with figures of their own."""
GRID = 8
"""Bias vectors along the longer side of a scene."""
LINES, COLUMNS = 240, 5
"""Lines and columns at which a rigorous scene is compared with its RPC."""
RELIEF_M = 300.0
MOST_WAVES = 8
"""Trends along the track that a sentence lists"""
BELIEVED = 0.001
"""Probability by chance below which a wave along the track counts as seen."""
SMOOTH_PX = 0.001
"""A rigorous model that is nearer than that to its RPC has no jitter to draw."""
WIDTH = 300.0


@section("scenes", after="strips")
def scene_section(view: View) -> Section | None:
    """Bias, residuals along the track and jitter of every satellite scene; None for a block without any."""
    images = [i for i in _images(view) if not is_strip(_camera(view, i))]
    if not images:
        return None
    about = Text.of(note("report_scenes.scenes", n=len(images)), note("report_scenes.bias"), note("report_scenes.maps"))
    known = Text.of(note("report_scenes.sigma_of_scenes"), note("report_scenes.marked"))
    parts = [Paragraph(text=about), _bias_table(view, images, known), *_figures_and_words(view, images, "scene")]
    return Section(anchor="scenes", title=phrase("report_scenes.title"), parts=tuple(parts))


@section("strips", after="trajectories")
def strip_section(view: View) -> Section | None:
    """Corrections of position and attitude of aerial line scanners over time; None for a block without any."""
    images = [i for i in _images(view) if is_strip(_camera(view, i))]
    if not images:
        return None
    about = Text.of(
        note("report_scenes.strips", n=len(images)),
        note("report_scenes.corrections"),
        note("report_scenes.further_parameters"),
    )
    known = Text.of(note("report_scenes.sigma_of_strips"), note("report_scenes.marked"))
    body = _bias_table(view, images, known)
    shown: list[Part] = (
        [body]
        if len(body.rows) <= OPEN_ROWS
        else [Folded(summary=phrase("report_scenes.every_parameter"), parts=(body,))]
    )
    parts = [Paragraph(text=about), *shown, *_figures_and_words(view, images, "strip")]
    return Section(anchor="strips", title=phrase("report_scenes.strips_title"), parts=tuple(parts))


def is_strip(camera: Camera) -> bool:
    """Whether a camera is a line scanner on an aircraft: below the height of any satellite."""
    return _sensor(camera).airborne


def _images(view: View) -> list[int]:
    return [i for i, c in enumerate(view.given.images.camera) if view.given.cameras[int(c)].is_scene]


def _figures_and_words(view: View, images: list[int], noun: str) -> list[Part]:
    found = {i: _track(view, i) for i in images}
    parts: list[Part] = [Statements(statements=_words(view, images, found, noun))]
    for n, i in enumerate(images[:MOST_DRAWN]):
        own = _scene_parts(view, i, found[i])
        name = phrase("report_scenes.name", kind=noun, name=view.given.images.ids[i])
        parts += [Heading(text=name), *own] if n < 2 else [Folded(summary=name, parts=tuple(own))]
    if len(images) > MOST_DRAWN:
        parts.append(
            Paragraph(text=phrase("report_scenes.figures_drawn", n=MOST_DRAWN, of=len(images), kind=noun), note=True)
        )
    return parts


def _camera(view: View, image: int) -> Camera:
    return view.adjusted.cameras[int(view.adjusted.images.camera[image])]


def _result(view: View, camera: Camera) -> InteriorResult | None:
    return next((r for r in view.adjustment.interior if r.camera == camera.id), None)


def _bias_table(view: View, images: list[int], remark: Text) -> Table:
    """A row for every parameter of every scene."""
    ground = any(_on_ground(_camera(view, i), s, 0.0) != NONE for i in images for s in _camera(view, i).sensor.symbols)
    columns: tuple[Column, ...] = (
        text(phrase("report_scenes.kind", kind="strip" if is_strip(_camera(view, images[0])) else "scene")),
        text(phrase("label.model")), number(phrase("label.image_points")), text(phrase("label.parameter")),
        number(phrase("label.value")), number(phrase("label.sigma")),
        *([number(phrase("report_scenes.on_ground"), "m")] if ground else []),
        number(phrase("label.stated_sigma")), number(phrase("report_scenes.value_by_sigma")), number("r"), number("w"),
    )  # fmt: skip
    rows: list[list[str]] = []
    marked: list[int] = []
    given = {c.id: c.sigma for c in view.given.parametrised}
    listed = set[tuple[str, str]]()
    for i in images:
        camera = _camera(view, i)
        result = _result(view, camera)
        first = [view.given.images.ids[i], _sensor(camera).title, grouped(len(rows_of(view, i)))]
        symbols = camera.sensor.symbols
        if not symbols or result is None:
            rows.append([*first, *[NONE] * (len(columns) - 3)])
            continue
        for s in symbols:
            owner = camera.sensor.links.get(s, camera.id)
            if (owner, s) in listed:  # of a trajectory once, with its first scene
                continue
            listed.add((owner, s))
            p, sigma = result.parameters.get(s), given[owner].get(s, math.nan)
            value, std = (camera.values[s], None) if p is None else (p.value, p.std)
            factor, unit = printed(view, camera.sensor.parameters[symbols.index(s)].unit)
            shown = (
                with_sigma(value * factor, std * factor)
                if std
                else (significant(value * factor, 4), phrase("label.held"))
            )
            ratio = abs(value) / sigma if sigma > 0 else math.nan
            if ratio > 3:
                marked.append(len(rows))
            name = f"{_named(owner, camera, s)} [{unit}]"
            rows.append([*first, name, *shown, *([_on_ground(camera, s, value)] if ground else []),
                         significant(sigma * factor, 3), fixed(ratio, 1), *_tested(view, owner, s)])  # fmt: skip
            first = ["", "", ""]
    return table(
        columns,
        zip(*rows, strict=True),
        note=remark,
        marked=marked,
        rest="result.json",
    )


def _sensor(camera: Camera) -> SceneSensor:
    return cast("SceneSensor", camera.scene)


def _named(owner: str, camera: Camera, symbol: str) -> str:
    return symbol if owner == camera.id else f"{owner}: {symbol}"


def _tested(view: View, owner: str, symbol: str) -> tuple[str, str]:
    """Redundancy number and test value of an observed parameter."""
    for g in view.adjustment.groups:
        if g.kind == "parameter":
            for k, pair in enumerate(zip(g.ids, g.component, strict=True)):
                if pair == (owner, symbol):
                    return fixed(float(g.redundancy[k]), 3), fixed(float(g.w[k]), 2)
    return NONE, NONE


def _on_ground(camera: Camera, symbol: str, value: float) -> str:
    """A parameter of the image in metres on the ground."""
    return fixed(value * _sensor(camera).metres(symbol), 2)


def _track(view: View, image: int) -> tuple[Index, Running, Running] | None:
    """Used rows of a scene and the running means of its residuals in x and y along its lines; None with too few."""
    rows = rows_of(view, image)
    if len(rows) < 40:
        return None
    at = view.given.observations.xy_px[rows, 1]
    v = view.adjustment.image_observations.residuals_px[rows]
    height = float(_camera(view, image).height_px)
    windows = int(np.clip(len(rows) // 12, 12, 60))
    sigma = np.sqrt(view.given.observations.cov_px2[rows, :2])
    x, y = (running(at, v[:, k], 0.0, height, windows, sigma[:, k]) for k in (0, 1))
    return rows, x, y


def _words(
    view: View, images: list[int], found: dict[int, tuple[Index, Running, Running] | None], noun: str
) -> tuple[tuple[str, str], ...]:
    """What the residuals along the track say, and what they do not."""
    ids = view.given.images.ids
    waves: list[Message] = []
    for i in images:
        track = found[i]
        if track is None:
            continue
        for axis, curve in zip("xy", track[1:], strict=True):
            if curve.probability < BELIEVED:
                size = float(np.nanmax(np.abs(curve.mean)))
                waves.append(note("report_scenes.wave", name=ids[i], axis=axis, size_px=size))
    if len(waves) > MOST_WAVES:
        waves = [*waves[:MOST_WAVES], note("report_scenes.more_waves", n=len(waves) - MOST_WAVES)]
    trend = Text.of(note("report_scenes.trend", level=BELIEVED), *waves, note("report_scenes.cause", kind=noun))
    words: list[tuple[str, str]] = [
        (phrase("report_scenes.along_track"), trend if waves else phrase("report_scenes.no_trend"))
    ]
    rays = view.rays[view.given.observations.point]
    two = [i for i in images if found[i] is not None and float(np.median(rays[rows_of(view, i)])) < 3]
    if two:
        words.append(
            (
                phrase("report_scenes.hidden"),
                Text.of(note("report_scenes.two_rays", kind=noun), note("report_scenes.jitter_in_heights")),
            )
        )
    return tuple(words)


def _scene_parts(view: View, image: int, track: tuple[Index, Running, Running] | None) -> list[Part]:
    """The figures of one scene."""
    camera, parts = _camera(view, image), list[Part]()
    figures: list[Figure] = []
    bias = _bias_figure(camera)
    if bias is not None:
        figures.append(bias)
    rows = np.flatnonzero(view.given.observations.image == image).astype(np.int32)
    v = view.adjustment.image_observations.residuals_px
    if len(rows):
        scale = exaggeration(v[rows_of(view, image)], WIDTH)
        drawn = image_vectors(view, image, rows, normalised(view), scale, WIDTH)
        length = round_below(WIDTH / 8 / scale)
        figures.append(
            Figure(
                drawing=drawn,
                caption=Text.of(
                    note(
                        "report_scenes.residuals",
                        rms_px=rms(v[rows_of(view, image)].ravel()),
                        length_px=length,
                        drawn_px=round(length * scale),
                    ),
                    note("report_residuals.crossed"),
                ),
            )
        )
    if figures:
        parts.append(Figures(figures=tuple(figures)))
    if track is not None:
        parts.append(Figures(figures=_track_figures(view, image, track)))
    drawn_over_time = correction_figures(view, camera)
    parts += [Figures(figures=drawn_over_time)] if drawn_over_time else []
    if _sensor(camera).rigorous and not is_strip(camera):
        jitter = _jitter(camera)
        parts += [jitter] if jitter is not None else []
    return parts


def _bias_figure(camera: Camera) -> Figure | None:
    """The bias of an RPC over the scene."""
    size = np.array([camera.width_px, camera.height_px], float)
    steps = np.maximum(np.round(GRID * size / size.max()), 2).astype(int)
    nodes = [(np.arange(n) + 0.5) / n * s for n, s in zip(steps.tolist(), size.tolist(), strict=True)]
    xy = np.stack([a.ravel() for a in np.meshgrid(*nodes)], axis=1)
    shift = _sensor(camera).shift(xy, camera.parameters)
    if shift is None:
        return None
    largest = float(np.linalg.norm(shift, axis=1).max())
    plot, parts = format_plot(camera.size_mm, WIDTH)
    x0, y0, w, h = plot.box
    x, y = x0 + xy[:, 0] / size[0] * w, y0 + xy[:, 1] / size[1] * h
    if largest > 0:
        scale = 0.7 * min(w / steps[0], h / steps[1]) / largest
        x, y = x - shift[:, 0] * scale / 2, y - shift[:, 1] * scale / 2
        parts.append(vectors(x, y, shift[:, 0] * scale, shift[:, 1] * scale, "vector bold"))
        parts += [
            f'<circle class="dot" cx="{a:.1f}" cy="{b:.1f}" r="1.6"/>'
            for a, b in zip(x.tolist(), y.tolist(), strict=True)
        ]
        unit = round_below(1.6 * largest)
        parts.append(scale_bar(plot, unit * scale, f"{significant(unit, 1)} px", "vector bold"))
    return Figure(
        drawing=drawing(plot.width, plot.height, parts, phrase("drawn.rpc_bias")),
        caption=phrase("report_scenes.bias_map", constant=bool((shift == shift[0]).all())),
    )


def _track_figures(view: View, image: int, track: tuple[Index, Running, Running]) -> tuple[Figure, ...]:
    rows, *curves = track
    at = view.given.observations.xy_px[rows, 1]
    v = view.adjustment.image_observations.residuals_px[rows]
    height = float(_camera(view, image).height_px)
    figures: list[Figure] = []
    for k, (axis, curve) in enumerate(zip("xy", curves, strict=True)):
        known = math.isfinite(curve.probability)
        chance = [note("report_panoramas.chance", p=float(curve.probability))] if known else []
        figures.append(
            Figure(
                drawing=series_figure(
                    at, v[:, k], curve, phrase("axis.line"), phrase("axis.residual_in", axis=axis),
                    phrase("drawn.residuals_along_track", axis=axis),
                    x_range=(0.0, height),
                ),
                caption=Text.of(note("report_scenes.track", axis=axis), *chance),
            )
        )  # fmt: skip
    return tuple(figures)


def _jitter(camera: Camera) -> Part | None:
    """A rigorous scene minus the RPC that stands for it, along the lines."""
    from raybundle.errors import RaybundleError
    from raybundle.scenes.rpc_fit import fit_rpc

    sensor, values = _sensor(camera), camera.parameters

    def localise(xy: Array, height: Array) -> Array:
        return sensor.place.geographic_from_block(sensor.localise(xy, height, values))

    middle = sensor.height_m
    try:
        fit = fit_rpc(localise, sensor.size_px, (middle - RELIEF_M, middle + RELIEF_M))
        lines = np.linspace(0, sensor.size_px[1], LINES)
        xs = (np.arange(COLUMNS) + 0.5) / COLUMNS * sensor.size_px[0]
        xy = np.stack([a.ravel() for a in np.meshgrid(xs, lines)], axis=1)
        miss = (xy - fit.rpc.project(localise(xy, np.full(len(xy), middle)))).reshape(LINES, COLUMNS, 2).mean(axis=1)
    except RaybundleError as error:
        reason = Text.of(note("report_scenes.no_jitter_plot"), message_of_text(text_of_error(error)))
        return Paragraph(text=reason, note=True)
    size = [rms(miss[:, k]) for k in (0, 1)]
    if max(size) < SMOOTH_PX:
        return Paragraph(text=phrase("report_scenes.no_jitter", limit_px=SMOOTH_PX))
    drawn: Drawing = line_figure(
        lines, (("x", miss[:, 0], None), ("y", miss[:, 1], None)), phrase("axis.line"),
        phrase("axis.rigorous_minus_rpc"), phrase("drawn.jitter"), width=860,
    )  # fmt: skip
    return Figures(
        figures=(
            Figure(
                drawing=drawn,
                caption=phrase("report_scenes.jitter", x_px=size[0], y_px=size[1]),
            ),
        )
    )
