"""Section: control, check points, scale bars, observed projection centres and parameters, variance components."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.adjustment.blunders.accuracy import levelled
from raybundle.adjustment.records.figures import ObservationGroup
from raybundle.block import Role
from raybundle.block.known import known_before
from raybundle.errors import Message, Text, note, phrase
from raybundle.numerics.arrays import Array
from raybundle.numerics.natural import natural_order
from raybundle.observations import in_order, observation_kinds
from raybundle.report.arrangement import LONG
from raybundle.report.chapters import section
from raybundle.report.figures.control import marked_images, marks_figure
from raybundle.report.map_axes import MapAxes, origin_words
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
    pick,
    table,
    text,
)
from raybundle.report.text.numbers import NONE, cells, column_decimals, fixed, grouped, significant
from raybundle.report.text.words import controlled, expected_check_std, printed
from raybundle.report.view import View, rms

LARGEST = 12
"""Rows that are shown of longer tables: those of the largest values."""


@section("control", after="noise")
def control_section(view: View) -> Section:
    """What was given besides image points, and what became of it."""
    parts: list[Part] = []
    for kind in in_order():
        file = "control" if kind.name == "control" else "result" if kind.table is None else kind.table.name
        rest = f"{file}.json" if file == "result" else f"{file}.csv"
        for whole in view.adjustment.groups:
            g = _without_levelling(view, _without_scenes(view, whole))
            if g.kind == "control":
                g = g.rows(np.array(natural_order(g.ids), np.int64))
            if g.kind == kind.name and len(g.ids):
                parts += [
                    Heading(text=phrase("report_control.kind", kind=kind.name, title=kind.title)),
                    *_group(view, g, kind.object, rest),
                ]
    parts += _left_out(view)
    parts += _check(view) + _taken_out(view)
    parts += _marks(view)
    if not parts:
        parts.append(Paragraph(text=phrase("report_control.none")))
    elif isinstance(view.accuracy.axes, MapAxes):
        parts.insert(0, Paragraph(text=origin_words(view.accuracy.axes.frame), note=True))
    parts += _components(view)
    return Section(anchor="control", title=phrase("report_control.title"), parts=tuple(parts))


def _without_scenes(view: View, g: ObservationGroup) -> ObservationGroup:
    """A group without the parameters of scenes, which stand in the section of these."""
    scenes = {c.id for c in view.given.cameras if c.is_scene}
    if g.kind != "parameter" or not scenes & set(g.ids):
        return g
    return g.rows(np.flatnonzero([i not in scenes for i in g.ids]))


def _without_levelling(view: View, g: ObservationGroup) -> ObservationGroup:
    """Control without the heights that level the block and that nobody gave."""
    invented = levelled(view.adjustment)
    if g.kind != "control" or not invented:
        return g
    given = [not (i in invented and c == "Z") for i, c in zip(g.ids, g.component, strict=True)]
    return g.rows(np.flatnonzero(given))


def observed_control(view: View) -> ObservationGroup | None:
    """Coordinates of control that were given with a standard deviation, without heights that nobody gave; None: none.

    Held ones have no residuals.
    """
    for whole in view.adjustment.groups:
        if whole.kind == "control":
            g = _without_levelling(view, whole)
            g = g.rows(np.flatnonzero(g.sigma > 0))
            return g if len(g.ids) else None
    return None


def _left_out(view: View) -> list[Part]:
    """What control would differ by had it taken no part: the accuracy where there are no check points."""
    parts: list[Part] = []
    whole, names = view.accuracy.left_out, view.accuracy.axes.names
    if whole.any:
        d = whole.difference * view.factor
        used = d[np.isfinite(d)]
        fine = column_decimals(np.abs(used) / 10)
        ids = [*pick(whole.rows, view.given.points.ids), phrase("label.rms")]
        columns = [cells([*d[:, k].tolist(), rms(d[:, k])], fine) for k in range(3)]
        shape = (text(phrase("label.point")), *(number(f"d{n}", view.unit) for n in names))
        remark = [note("report_control.leave_one_out"), note("report_control.first_order")]
        if not view.accuracy.check.any:
            remark.append(note("report_control.no_check_points"))
        body = table(shape, (ids, *columns), note=Text.of(*remark), rest="result.json")
        parts += [Heading(text=phrase("report_control.points_left_out")), body]
    rows: list[Sequence[str]] = []
    for axis in "XYZ":
        found = [(abs(v), p) for p, c, v in view.accuracy.coordinates_left_out if c == axis and math.isfinite(v)]
        if found:
            d = np.array([f[0] for f in found]) * view.factor
            rows.append([axis, grouped(len(d)), significant(rms(d)), significant(float(d.max())), max(found)[1]])
    if rows:
        body = table(
            (
                text(phrase("label.coordinate")), number(phrase("label.points")),
                number(phrase("label.rms"), view.unit),
                number(phrase("label.largest"), view.unit), text(phrase("label.at_point")),
            ),
            zip(*rows, strict=True),
            note=phrase("report_control.coordinate_left_out"),
        )  # fmt: skip
        parts += [Heading(text=phrase("report_control.coordinates_left_out")), body]
    return parts


def _asprs(view: View) -> list[Part]:
    """Accuracy in the sense of ASPRS."""
    t = view.accuracy.tested
    if t is None or view.free_frame:
        return []
    found = [note("report_control.asprs")]
    found += [
        note("report_control.rmse", name=name, rmse=size * view.factor, unit=view.unit, n=n)
        for name, size, n in (("RMSE_H", t.rmse_h, t.horizontal), ("RMSE_V", t.rmse_v, t.vertical))
        if math.isfinite(size)
    ]
    if not t.stated:
        found.append(note("report_control.check_sigma_missing"))
    needed = view.accuracy.needed
    if min(t.horizontal, t.vertical or t.horizontal) < needed:
        found.append(note("report_control.check_points_needed", least=needed))
    return [Paragraph(text=Text.of(*found))]


def _marks(view: View) -> list[Part]:
    """Control and check points where they were measured in the images."""
    drawn = marks_figure(view)
    if drawn is None:
        return []
    figure, _ = drawn
    rows, images = marked_images(view)
    o = view.given.observations
    all_images = len(np.unique(o.image[rows]))
    which = [] if all_images == len(images) else [note("report_control.marks_drawn", n=len(images), of=all_images)]
    words = Text.of(
        note("report_control.marks", n=len(rows), images=all_images), note("report_control.marks_vectors"), *which
    )
    return [
        Heading(text=phrase("report_control.marks_heading")),
        Figures(figures=(Figure(drawing=figure, caption=words),)),
    ]


def _group(view: View, g: ObservationGroup, what: str, rest: str) -> list[Part]:
    weighted = g.sigma > 0
    factor, unit = _unit(view, g)
    parts: list[Part] = []
    if not weighted.any():
        held = Folded(summary=phrase("report_control.held_list"), parts=(_held_table(view, g),))
        return [Paragraph(text=phrase("report_control.held", n=len(g.ids))), held]
    reported = controlled(g)
    head = note("report_control.observed", n=int(weighted.sum()), held=int((~weighted).sum()))
    if reported.any() and observation_kinds[g.kind].unit == "own":
        # units differ from row to row: what they have in common is the residual by its sigma
        v, w = g.residual[reported] / g.sigma[reported], g.w[reported]
        size = [note("report_control.rms_by_sigma", rms=rms(v))]
        if np.isfinite(w).any():
            size.append(note("report_control.largest_w", w=float(np.nanmax(np.abs(w)))))
        parts.append(Paragraph(text=Text.of(head, *size)))
    elif reported.any():
        v = g.residual[reported] * factor
        largest = float(np.nanmax(np.abs(v)))
        residual = note("report_control.rms_residual", rms=rms(v), largest=largest, unit=unit)
        parts.append(Paragraph(text=Text.of(head, residual)))
    else:
        parts.append(Paragraph(text=Text.of(head, note("report_control.uncontrolled"))))
    whole = _group_table(view, g, what, rest, factor, unit)
    if len(g.ids) <= LONG:
        return [*parts, whole]
    order = np.argsort(-np.nan_to_num(np.abs(g.w)), kind="stable")[:LARGEST]
    worst = replace(
        _group_table(view, g.rows(order), what, rest, factor, unit), caption=phrase("report_control.largest_rows")
    )
    summary = phrase("report_control.all_rows", kind=g.kind, title=observation_kinds[g.kind].title, n=len(g.ids))
    return [*parts, worst, Folded(summary=summary, parts=(whole,))]


def _unit(view: View, g: ObservationGroup) -> tuple[float, str]:
    """Factor and unit in print of all rows of a group; none where each row has its own."""
    if observation_kinds[g.kind].unit == "length":
        return view.factor, view.unit
    return (math.degrees(1), "°") if observation_kinds[g.kind].unit == "angle" else (1.0, "")


def _row_units(view: View, g: ObservationGroup) -> list[tuple[float, str]]:
    """Factor and unit in print of each row of a group that holds parameters."""
    units = {(c.id, p.symbol): p.unit for c in view.given.parametrised for p in c.sensor.parameters}
    for c in view.given.parametrised:
        units |= {(c.id, r.name): units[c.id, s] for s, r in known_before(c).items() if not r.logarithm}
    pairs = zip(g.ids, g.component, strict=True)
    return [printed(view, units.get((i.partition("/")[0], s), "1")) for i, s in pairs]


def _quantities(view: View, g: ObservationGroup) -> tuple[list[str], list[Message]]:
    """What is observed in each row, and what is to be stated of logarithms."""
    if g.kind != "relation":
        return list(g.component), []
    known = {(c.id, r.name): (s, r.logarithm) for c in view.given.parametrised for s, r in known_before(c).items()}
    found = [known.get((i.partition("/")[0], name)) for i, name in zip(g.ids, g.component, strict=True)]
    shown = [
        name if of is None else phrase("report_control.known_before", symbol=f"ln {of[0]}" if of[1] else of[0])
        for of, name in zip(found, g.component, strict=True)
    ]
    factors = list(dict.fromkeys(of[0] for of in found if of is not None and of[1]))
    return shown, [note("report_control.logarithms", symbols=factors)] if factors else []


def _held_table(view: View, g: ObservationGroup) -> Table:
    """Given coordinates that were held, a point a row; a dash where one was not given."""
    ids = list(dict.fromkeys(g.ids))
    given = dict(zip(zip(g.ids, g.component, strict=True), g.given.tolist(), strict=True))
    columns = [[given.get((i, axis), math.nan) for i in ids] for axis in "XYZ"]
    return table(
        (text(phrase("label.point")), *(number(axis, view.length_unit) for axis in "XYZ")),
        (ids, *(cells(c, 4 if view.length_unit == "m" else 2) for c in columns)),
        rest="control.csv",
    )


def _group_table(view: View, g: ObservationGroup, what: str, rest: str, factor: float, unit: str) -> Table:
    own = None if observation_kinds[g.kind].unit != "own" else _row_units(view, g)
    component, of_logarithms = _quantities(view, g)
    words = {"angle": phrase("label.angle"), "length": phrase("label.length")}
    component = [words.get(c, c) for c in component]
    if observation_kinds[g.kind].unit != "length":
        by = np.full(len(g.ids), factor) if own is None else np.array([f for f, _ in own])
        given, adjusted = ([significant(float(v), 6) for v in column * by] for column in (g.given, g.adjusted))
        sigma, std, v, mdb = (
            [significant(float(x), 3) for x in column * by] for column in (g.sigma, g.adjusted_std, g.residual, g.mdb)
        )
    else:
        fine = column_decimals(np.concatenate([g.sigma, g.adjusted_std]) * factor)
        coarse = fine + round(math.log10(factor))
        given, adjusted = (cells(column.tolist(), coarse) for column in (g.given, g.adjusted))
        sigma, std, v, mdb = (
            cells((column * factor).tolist(), fine) for column in (g.sigma, g.adjusted_std, g.residual, g.mdb)
        )
    limit = view.adjustment.critical_w * max(view.scale, 1.0)
    beyond = np.flatnonzero(np.abs(np.nan_to_num(g.w)) > limit).tolist()
    length = view.length_unit if observation_kinds[g.kind].unit == "length" else unit
    unit_column, unit_cells = ([], []) if own is None else ([text(phrase("label.unit"))], [[u for _, u in own]])
    return table(
        (
            text(phrase("report_control.object", kind=g.kind, what=what)), text(""), *unit_column,
            number(phrase("label.given"), length), number(phrase("label.sigma"), unit),
            number(phrase("label.adjusted"), length), number(phrase("label.sigma"), unit),
            number(phrase("label.residual"), unit), number("r"), number("w"), number("τ"), number("MDB", unit),
        ),
        (
            g.ids, component, *unit_cells, given,
            [phrase("label.held") if s == 0 else t for s, t in zip(g.sigma, sigma, strict=True)], adjusted,
            [NONE if s == 0 else t for s, t in zip(g.sigma, std, strict=True)],
            [NONE if s == 0 else t for s, t in zip(g.sigma, v, strict=True)],
            [NONE if s == 0 else t for s, t in zip(g.sigma, cells(g.redundancy.tolist(), 3), strict=True)],
            cells(g.w.tolist(), 2), cells(g.t.tolist(), 2), mdb,
        ),
        note=Text.of(
            note("report_control.residual_note"), note("label.mdb_note"),
            *([note("report_control.marked")] if beyond else []), *of_logarithms,
        ),
        rest=rest,
        marked=beyond,
    )  # fmt: skip


def _taken_out(view: View) -> list[Part]:
    """Control points that contradict the others: what became of them, apart from the check points."""
    given, std = view.given.points, view.std
    rows = np.flatnonzero((given.role == Role.CONTROL) & (view.adjusted.points.role == Role.CHECK))
    if not len(rows):
        return []
    d = np.where(given.is_control[rows], view.adjusted.points.xyz[rows] - given.xyz[rows], np.nan) * view.factor
    sigma = np.full((len(rows), 3), np.nan) if std is None else np.hypot(std[rows], given.sigma[rows] * view.factor)
    fine = column_decimals(sigma)
    body = table(
        (
            text(phrase("label.point")), *(number(f"d{axis}", view.unit) for axis in "XYZ"),
            *(number(phrase("label.sigma_of", symbol=f"d{axis}"), view.unit) for axis in "XYZ"),
            number(phrase("label.rays")),
        ),
        (
            pick(rows, given.ids), *(cells(d[:, k].tolist(), fine) for k in range(3)),
            *(cells(sigma[:, k].tolist(), fine) for k in range(3)), [grouped(float(view.rays[i])) for i in rows],
        ),
        note=Text.of(note("report_control.difference_note"), note("report_control.rejected_control")),
    )  # fmt: skip
    return [Heading(text=phrase("report_control.rejected_heading")), body]


def _check(view: View) -> list[Part]:
    given = view.given.points
    order = np.array(natural_order(pick(view.check_rows, given.ids)), np.int64)
    rows = view.check_rows[order]
    if not len(rows):
        return []
    difference = view.check_difference[order] * view.factor
    std = expected_check_std(view)[order]
    xyz = np.where(given.is_check[rows], given.xyz[rows], np.nan)
    fine = column_decimals(std) if np.isfinite(std).any() else 3
    coarse = fine + round(math.log10(view.factor))
    ratio = np.abs(difference) / std
    body = table(
        (
            text(phrase("label.point")), *(number(axis, view.length_unit) for axis in "XYZ"),
            *(number(f"d{axis}", view.unit) for axis in "XYZ"),
            *(number(phrase("label.sigma_of", symbol=f"d{axis}"), view.unit) for axis in "XYZ"),
            number(phrase("report_control.largest_ratio")), number(phrase("label.rays")),
        ),
        (
            pick(rows, given.ids), *(cells(xyz[:, k].tolist(), coarse) for k in range(3)),
            *(cells(difference[:, k].tolist(), fine) for k in range(3)),
            *(cells(std[:, k].tolist(), fine) for k in range(3)),
            cells(np.where(np.isfinite(ratio).any(axis=1), np.max(np.nan_to_num(ratio), axis=1), np.nan).tolist(), 2),
            [grouped(float(view.rays[i])) for i in rows],
        ),
        note=Text.of(note("report_control.difference_note"), note("report_control.check_sigma_note")),
        rest="check.csv",
        marked=np.flatnonzero(np.max(np.nan_to_num(ratio), axis=1) > 3.29).tolist(),
    )  # fmt: skip
    folded = Folded(summary=phrase("report_control.all_check_points", n=len(rows)), parts=(body,))
    shown = body if len(rows) <= LONG else folded
    return [
        Heading(text=phrase("report_control.check_points")),
        _check_summary(difference, std, view.unit),
        *_asprs(view),
        shown,
    ]


def _check_summary(difference: Array, std: Array, unit: str) -> Table:
    rows: list[Sequence[str]] = []
    for k, axis in enumerate("XYZ"):
        d = difference[np.isfinite(difference[:, k]), k]
        if len(d):
            ratio = rms(difference[:, k] / std[:, k])
            largest = float(np.abs(d).max())
            rows.append(
                [axis, grouped(len(d)), *(significant(v) for v in (float(d.mean()), rms(d), largest)), fixed(ratio, 2)]
            )
    return table(
        (
            text(phrase("label.coordinate")), number(phrase("label.points")), number(phrase("label.mean"), unit),
            number(phrase("label.rms"), unit), number(phrase("label.largest"), unit),
            number(phrase("report_control.rms_ratio")),
        ),
        zip(*rows, strict=True) if rows else [[] for _ in range(6)],
    )  # fmt: skip


def _components(view: View) -> list[Part]:
    """Variance components but those of single images, which stand with the residuals."""
    found = [v for v in view.adjustment.variance_components if v.kind != "image"]
    strange = sum(1 for v in view.adjustment.variance_components if v.kind == "image" and v.significant)
    if not found:
        return []
    body = table(
        (
            text(phrase("label.observations")), text(phrase("label.group")), number(phrase("label.number")),
            number(phrase("label.redundancy")), number(phrase("label.sigma_ratio")), text(""),
        ),
        (
            [phrase("report_control.component_kind", kind=v.kind.replace(" ", "_"), other=v.kind) for v in found],
            [phrase("report_control.component_group", name=v.group.replace(" ", "_"), other=v.group) for v in found],
            [grouped(v.count) for v in found],
            cells([v.redundancy for v in found], 1), cells([v.ratio for v in found], 3),
            [phrase("report_control.group_differs") if v.significant else "" for v in found],
        ),
        note=Text.of(
            note("report_control.group_note"), *([note("report_control.images_differ", n=strange)] if strange else [])
        ),
    )  # fmt: skip
    return [Heading(text=phrase("report_control.components")), body]
