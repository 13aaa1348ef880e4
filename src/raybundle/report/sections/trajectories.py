"""Section: orientation by GNSS and INS against that of the adjustment."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.records.figures import InteriorResult, ObservationGroup
from raybundle.errors import Text, note, phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.counting import decimals_for
from raybundle.report.chapters import section
from raybundle.report.figures.series import line_figure
from raybundle.report.parts import (
    Figure,
    Figures,
    Folded,
    Heading,
    Paragraph,
    Part,
    Section,
    Table,
    number,
    table,
    text,
)
from raybundle.report.text.numbers import NONE, fixed, grouped, significant, with_sigma
from raybundle.report.text.words import printed
from raybundle.report.view import View, rms

FEWEST = 3
"""Observed images from which there is a line to draw."""
MOST_LINES = 8
MARKED = 150
"""Images of a line up to which each is marked with a dot."""
NAMES = {"X": "east", "Y": "north", "Z": "height"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Line:
    """The observed images of one flight line, in their order."""

    kind: str
    """antenna | positions | attitudes"""
    name: str
    """Of the antenna; else empty"""
    images: Index
    """Positions in the block"""
    at: Array
    """(k,) distance along the line, or time where it is known"""
    unit: str


@section("trajectories", after="control")
def trajectory_section(view: View) -> Section | None:
    """Observed minus adjusted positions and attitudes along each line, antennas, motion; None without any."""
    groups = {g.kind: g for g in view.adjustment.groups if g.kind in {"station", "attitude"} and len(g.ids)}
    carried = [r for r in view.adjustment.interior if _is_carried(view, r)]
    moving = _motion(view)
    if not (groups or moving):
        return None
    parts: list[Part] = []
    if groups:
        parts += [Paragraph(text=_about(view)), _comparison(view, groups)]
    if carried:
        parts += [Heading(text=phrase("report_trajectories.carried")), _carried_table(view, carried)]
    lines = _lines(view, groups)
    for n, line in enumerate(lines[:MOST_LINES]):
        figures = _line_figures(view, groups, line)
        own: list[Part] = [Figures(figures=figures)] if figures else []
        title = phrase("report_trajectories.line", kind=line.kind, name=line.name, n=len(line.images))
        parts += [Heading(text=title), *own] if n < 3 else [Folded(summary=title, parts=tuple(own))]
    if len(lines) > MOST_LINES:
        drawn = phrase("report_trajectories.lines_drawn", n=MOST_LINES, of=len(lines))
        parts.append(Paragraph(text=drawn, note=True))
    parts += moving
    return Section(anchor="trajectories", title=phrase("report_trajectories.title"), parts=tuple(parts))


def _name(view: View, component: str) -> str:
    """A component in words: east, north, height where the frame is one of the ground."""
    ground = view.length_unit == "m" and not view.free_frame
    return NAMES.get(component, component) if ground else component


def _is_carried(view: View, result: InteriorResult) -> bool:
    return any(i.id == result.camera for i in view.given.instruments)


def _about(view: View) -> Text:
    block = view.given
    positions = len(np.unique(block.stations.image)) if len(block.stations) else 0
    return Text.of(
        note("report_trajectories.observed", positions=positions, attitudes=len(block.attitudes)),
        note("report_trajectories.methods"),
        note("report_trajectories.difference"),
    )


def _differences(g: ObservationGroup, component: str) -> tuple[tuple[str, ...], Array, Array, Array]:
    """Ids, observed minus adjusted, stated standard deviation and that of the adjusted value, of one component."""
    rows = [k for k, c in enumerate(g.component) if c == component]
    return tuple(g.ids[k] for k in rows), -g.residual[rows], g.sigma[rows], g.adjusted_std[rows]


def _comparison(view: View, groups: dict[str, ObservationGroup]) -> Table:
    """Mean, rms and largest difference of each component, direct against integrated."""
    rows: list[list[str]] = []
    marked: list[int] = []
    for kind, components, factor, unit in (
        ("station", ("X", "Y", "Z"), view.factor, view.unit),
        ("attitude", ("omega", "phi", "kappa"), math.degrees(1), "°"),
    ):
        if kind not in groups:
            continue
        for component in components:
            _, d, sigma, adjusted = _differences(groups[kind], component)
            if not len(d):
                continue
            stated = float(np.sqrt(np.mean(sigma**2))) * factor
            size = rms(d) * factor
            if stated > 0 and size > 2 * stated * view.scale:
                marked.append(len(rows))
            known = adjusted[np.isfinite(adjusted)]
            after = float(np.sqrt(np.mean(known**2))) * factor if len(known) else math.nan
            values = (float(d.mean()) * factor, size, float(np.abs(d).max()) * factor, stated, after)
            # to what a standard deviation can show: finer digits of a mean or rms say nothing
            decimals = decimals_for(stated if stated > 0 else size) + 1
            name = phrase("report_trajectories.component", component=_name(view, component))
            rows.append([name, unit, grouped(len(d)), *(fixed(v, min(decimals, 9)) for v in values)])
    return table(
        (
            text(phrase("report_trajectories.component_label")), text(phrase("label.unit")),
            number(phrase("label.observed")), number(phrase("label.mean")), number(phrase("label.rms")),
            number(phrase("label.largest")), number(phrase("label.stated_sigma")),
            number(phrase("report_trajectories.sigma_after")),
        ),
        zip(*rows, strict=True),
        caption=phrase("report_trajectories.comparison"),
        note=Text.of(
            note("report_trajectories.corrected"), note("report_trajectories.marked"),
            note("report_trajectories.sigma_after_note"),
        ),
        marked=marked,
    )  # fmt: skip


def _carried_table(view: View, carried: list[InteriorResult]) -> Table:
    """Parameters of antennas and IMUs."""
    rows: list[list[str]] = []
    marked: list[int] = []
    for r in carried:
        for p in r.parameters.values():
            if p.status == "held" and not p.value:
                continue
            factor, unit = printed(view, p.unit)
            shown = (
                with_sigma(p.value * factor, p.std * factor)
                if p.std
                else (significant(p.value * factor, 4), phrase("label.held"))
            )
            if p.status == "not determinable":
                marked.append(len(rows))
            status = phrase("report_interior.status", status=p.status.replace(" ", "_"))
            rows.append([r.camera, p.symbol, p.words, unit, *shown, NONE if p.t is None else fixed(p.t, 1), status])
    return table(
        (
            text(phrase("report_trajectories.carrier")), text(phrase("label.symbol")), text(phrase("label.meaning")),
            text(phrase("label.unit")), number(phrase("label.value")), number(phrase("label.sigma")), number("t"),
            text(phrase("label.status")),
        ),
        zip(*rows, strict=True),
        note=Text.of(
            note("report_trajectories.shift"), note("report_interior.t_note"), note("report_trajectories.separability")
        ),
        marked=marked,
    )  # fmt: skip


def _lines(view: View, groups: dict[str, ObservationGroup]) -> list[Line]:
    """Flight lines: images of one antenna, else of one camera, in the order of time or of the block."""
    block = view.given
    ids = {name: k for k, name in enumerate(block.images.ids)}
    seen = {ids[i] for g in groups.values() for i in g.ids if i in ids}
    stations = block.stations
    key: dict[int, tuple[tuple[str, str], float]] = {}
    for row, image in enumerate(stations.image.tolist()):
        antenna = -1 if stations.antenna is None else int(stations.antenna[row])
        name = ("antenna", block.instruments[antenna].id) if antenna >= 0 else ("positions", "")
        key[image] = name, math.nan if stations.time is None else float(stations.time[row])
    members: dict[tuple[str, str], list[int]] = {}
    for image in sorted(seen):
        members.setdefault(key[image][0] if image in key else ("attitudes", ""), []).append(image)
    found: list[Line] = []
    for (kind, name), images in members.items():
        if len(images) < FEWEST:
            continue
        time = np.array([key[i][1] if i in key else math.nan for i in images])
        if np.isfinite(time).all() and np.ptp(time) > 0:
            order = np.argsort(time, kind="stable")
            found.append(
                Line(kind=kind, name=name, images=np.array(images)[order], at=time[order], unit=phrase("axis.time"))
            )
            continue
        centre = view.adjusted.images.centre[images]
        steps = np.linalg.norm(np.diff(centre, axis=0), axis=1)
        at = np.concatenate([[0.0], np.cumsum(np.nan_to_num(steps))])
        found.append(
            Line(
                kind=kind,
                name=name,
                images=np.array(images),
                at=at,
                unit=phrase("axis.way_flown", unit=view.length_unit),
            )
        )
    return found


def _line_figures(view: View, groups: dict[str, ObservationGroup], line: Line) -> tuple[Figure, ...]:
    """Observed minus adjusted along one line, a figure for each component."""
    names = [view.given.images.ids[int(i)] for i in line.images]
    figures: list[Figure] = []
    for kind, components, factor, unit in (
        ("station", ("X", "Y", "Z"), view.factor, view.unit),
        ("attitude", ("omega", "phi", "kappa"), math.degrees(1), "°"),
    ):
        if kind not in groups:
            continue
        for component in components:
            ids, d, sigma, _ = _differences(groups[kind], component)
            row = {name: k for k, name in enumerate(ids)}
            pick = [row.get(n, -1) for n in names]
            if sum(k >= 0 for k in pick) < FEWEST:
                continue
            value = np.array([d[k] * factor if k >= 0 else math.nan for k in pick])
            stated = np.array([sigma[k] * factor * view.scale if k >= 0 else math.nan for k in pick])
            name = _name(view, component)
            words = phrase("report_trajectories.component", component=name)
            drawn = line_figure(
                line.at, ((words, value, stated),), line.unit, phrase("axis.observed_minus_adjusted", unit=unit),
                phrase("drawn.along_line", component=name, kind=line.kind, name=line.name), width=285,
                marks=len(names) <= MARKED,
            )  # fmt: skip
            figures.append(
                Figure(
                    drawing=drawn,
                    caption=phrase("report_trajectories.along_line", component=name, rms=rms(value), unit=unit),
                )
            )
    return tuple(figures)


def _motion(view: View) -> list[Part]:
    """Velocity and rotation of single images with a rolling shutter."""
    own = [r for r in view.adjustment.interior if r.image is not None and {"vx", "vy", "vz"} & set(r.parameters)]
    if len(own) < FEWEST:
        return []
    at = np.arange(1, len(own) + 1, dtype=float)
    figures: list[Figure] = []
    for symbols, factor, unit, kind in (
        (("vx", "vy", "vz"), 1.0, f"{view.length_unit}/s", "velocity"),
        (("wx", "wy", "wz"), math.degrees(1), "°/s", "rotation"),
    ):
        value, sigma = (
            np.array(
                [[getattr(r.parameters[s], what) if s in r.parameters else math.nan for s in symbols] for r in own],
                float,
            )
            for what in ("value", "std")
        )
        size = np.sqrt(np.nansum(value**2, axis=1)) * factor
        spread = (
            np.sqrt(np.nanmean(sigma**2, axis=1)) * factor if np.isfinite(sigma).any() else np.full(len(own), math.nan)
        )
        name = phrase("drawn.motion", kind=kind)
        drawn = line_figure(
            at,
            ((name, size, None), (phrase("drawn.its_sigma"), spread, None)),
            phrase("label.image"),
            phrase("axis.motion", kind=kind, unit=unit),
            name,
            marks=len(own) <= MARKED,
        )
        figures.append(Figure(drawing=drawn, caption=phrase("report_trajectories.motion", kind=kind)))
    return [Heading(text=phrase("report_trajectories.motion_heading")), Figures(figures=tuple(figures))]
