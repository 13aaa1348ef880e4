"""Section: control, check points, scale bars, observed projection centres and parameters, variance components."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.adjustment.accuracy import levelled
from raybundle.adjustment.result import ObservationGroup
from raybundle.block import Role
from raybundle.block.known import known_before
from raybundle.numerics.arrays import Array
from raybundle.numerics.natural import natural_order
from raybundle.observations import in_order, observation_kinds
from raybundle.report.arrangement import LONG
from raybundle.report.chapters import section
from raybundle.report.figures.control import marked_images, marks_figure
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
from raybundle.report.text.numbers import NONE, cells, column_decimals, counted, fixed, grouped, significant
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
                parts += [Heading(text=kind.title), *_group(view, g, kind.object, rest)]
    parts += _left_out(view)
    parts += _check(view) + _taken_out(view)
    parts += _marks(view)
    if not parts:
        parts.append(Paragraph(text="Neither control, check points, scale bars nor projection centres were given."))
    parts += _components(view)
    return Section(anchor="control", title="Control, check points and groups of observations", parts=tuple(parts))


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
        ids = [*pick(whole.rows, view.given.points.ids), "rms"]
        columns = [cells([*d[:, k].tolist(), rms(d[:, k])], fine) for k in range(3)]
        shape = (text("point"), *(number(f"d{n}", view.unit) for n in names))
        note = "Leave-one-out: adjusted minus given had the point, with all coordinates, taken no part, to first order."
        if not view.accuracy.check.any:
            note += " It stands in for check points, of which there are none."
        body = table(shape, (ids, *columns), note=note, rest="result.json")
        parts += [Heading(text="Control left out, one point at a time"), body]
    rows: list[Sequence[str]] = []
    for axis in "XYZ":
        found = [(abs(v), p) for p, c, v in view.accuracy.coordinates_left_out if c == axis and math.isfinite(v)]
        if found:
            d = np.array([f[0] for f in found]) * view.factor
            rows.append([axis, grouped(len(d)), significant(rms(d)), significant(float(d.max())), max(found)[1]])
    if rows:
        body = table(
            (
                text("coordinate"), number("points"), number("rms", view.unit), number("largest", view.unit),
                text("at"),
            ),
            zip(*rows, strict=True),
            note="The same of one coordinate at a time, the others of its point taking part: residual over redundancy "
            "number. It finds a single wrong coordinate; as an accuracy it is too good where coordinates of a point "
            "hold each other.",
        )  # fmt: skip
        parts += [Heading(text="Control left out, one coordinate at a time"), body]
    return parts


def _asprs(view: View) -> list[Part]:
    """Accuracy in the sense of ASPRS."""
    t = view.accuracy.tested
    if t is None or view.free_frame:
        return []
    found = [
        f"{name} {significant(size * view.factor)} {view.unit} from {counted(n, 'check point')}"
        for name, size, n in (("RMSE_H", t.rmse_h, t.horizontal), ("RMSE_V", t.rmse_v, t.vertical))
        if math.isfinite(size)
    ]
    words = f"Accuracy in the sense of ASPRS (2024), that of the check points included: {', '.join(found)}."
    if not t.stated:
        words += " Not all check points state their own standard deviation; theirs counts as 0."
    needed = view.accuracy.needed
    if min(t.horizontal, t.vertical or t.horizontal) < needed:
        words += f" At least {needed} are asked for there: with fewer it is a figure, not a proof."
    return [Paragraph(text=words)]


def _marks(view: View) -> list[Part]:
    """Control and check points where they were measured in the images."""
    drawn = marks_figure(view)
    if drawn is None:
        return []
    figure, _ = drawn
    rows, images = marked_images(view)
    o = view.given.observations
    all_images = len(np.unique(o.image[rows]))
    which = "" if all_images == len(images) else f" The {len(images)} of {all_images} images with the most of them."
    words = (
        f"{counted(len(rows), 'measurement')} of control points (red) and check points (green) in "
        f"{counted(all_images, 'image')}, residuals as vectors, adjusted minus measured; a cross: rejected.{which}"
    )
    return [Heading(text="Where they were measured"), Figures(figures=(Figure(drawing=figure, caption=words),))]


def _group(view: View, g: ObservationGroup, what: str, rest: str) -> list[Part]:
    weighted = g.sigma > 0
    factor, unit = _unit(view, g)
    parts: list[Part] = []
    if not weighted.any():
        text_ = f"{counted(len(g.ids), 'coordinate')} held as given; they have no residuals of their own."
        return [Paragraph(text=text_), Folded(summary="Held coordinates", parts=(_held_table(view, g),))]
    told = controlled(g)
    head = f"{counted(int(weighted.sum()), 'value')} observed, {grouped(int((~weighted).sum()))} held"
    if told.any() and observation_kinds[g.kind].unit == "own":
        # units differ from row to row: what they have in common is the residual by its sigma
        v, w = g.residual[told] / g.sigma[told], g.w[told]
        size = f"rms of residual by sigma {fixed(rms(v), 2)}"
        if np.isfinite(w).any():
            size += f", largest |w| {fixed(float(np.nanmax(np.abs(w))), 2)}"
        parts.append(Paragraph(text=f"{head}; {size}."))
    elif told.any():
        v = g.residual[told] * factor
        size = f"rms residual {significant(rms(v))} {unit}, largest {significant(float(np.nanmax(np.abs(v))))} {unit}"
        parts.append(Paragraph(text=f"{head}; {size.strip()}."))
    else:
        parts.append(Paragraph(text=f"{head}. All are needed to fix the datum: nothing controls them."))
    whole = _group_table(view, g, what, rest, factor, unit)
    if len(g.ids) <= LONG:
        return [*parts, whole]
    order = np.argsort(-np.nan_to_num(np.abs(g.w)), kind="stable")[:LARGEST]
    worst = replace(_group_table(view, g.rows(order), what, rest, factor, unit), caption="The largest |w|")
    return [
        *parts,
        worst,
        Folded(summary=f"{observation_kinds[g.kind].title}, all {counted(len(g.ids), 'row')}", parts=(whole,)),
    ]


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


def _quantities(view: View, g: ObservationGroup) -> tuple[list[str], str]:
    """What is observed in each row, and what is to be said of logarithms."""
    logarithms = {(c.id, r.name): s for c in view.given.parametrised for s, r in known_before(c).items() if r.logarithm}
    if g.kind != "relation" or not logarithms:
        return list(g.component), ""
    symbols = [logarithms.get((i.partition("/")[0], name)) for i, name in zip(g.ids, g.component, strict=True)]
    shown = [name if s is None else f"known before: ln {s}" for s, name in zip(symbols, g.component, strict=True)]
    told = ", ".join(dict.fromkeys(s for s in symbols if s is not None))
    note = (
        f" Of {told} a factor was known before: the natural logarithm of its value in mm is observed, and sigma and "
        "residual are shares of it, 0.01 about 1 %."
    )
    return shown, note if told else ""


def _held_table(view: View, g: ObservationGroup) -> Table:
    """Given coordinates that were held, a point a row; a dash where one was not given."""
    ids = list(dict.fromkeys(g.ids))
    given = dict(zip(zip(g.ids, g.component, strict=True), g.given.tolist(), strict=True))
    columns = [[given.get((i, axis), math.nan) for i in ids] for axis in "XYZ"]
    return table(
        (text("point"), *(number(axis, view.length_unit) for axis in "XYZ")),
        (ids, *(cells(c, 4 if view.length_unit == "m" else 2) for c in columns)),
        rest="control.csv",
    )


def _group_table(view: View, g: ObservationGroup, what: str, rest: str, factor: float, unit: str) -> Table:
    own = None if observation_kinds[g.kind].unit != "own" else _row_units(view, g)
    component, of_logarithms = _quantities(view, g)
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
    unit_column, unit_cells = ([], []) if own is None else ([text("unit")], [[u for _, u in own]])
    return table(
        (
            text(what), text(""), *unit_column, number("given", length), number("sigma", unit),
            number("adjusted", length), number("sigma", unit), number("residual", unit), number("r"), number("w"),
            number("τ"), number("mdb", unit),
        ),
        (
            g.ids, component, *unit_cells, given,
            ["held" if s == 0 else t for s, t in zip(g.sigma, sigma, strict=True)], adjusted,
            [NONE if s == 0 else t for s, t in zip(g.sigma, std, strict=True)],
            [NONE if s == 0 else t for s, t in zip(g.sigma, v, strict=True)],
            [NONE if s == 0 else t for s, t in zip(g.sigma, cells(g.redundancy.tolist(), 3), strict=True)],
            cells(g.w.tolist(), 2), cells(g.t.tolist(), 2), mdb,
        ),
        note="Residual: adjusted minus given; mdb: smallest detectable blunder." + (" Marked: |w| beyond its "
        "family-wise critical value." if beyond else "") + of_logarithms,
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
            text("point"), *(number(f"d{axis}", view.unit) for axis in "XYZ"),
            *(number(f"sigma d{axis}", view.unit) for axis in "XYZ"), number("rays"),
        ),
        (
            pick(rows, given.ids), *(cells(d[:, k].tolist(), fine) for k in range(3)),
            *(cells(sigma[:, k].tolist(), fine) for k in range(3)), [grouped(float(view.rays[i])) for i in rows],
        ),
        note="d: adjusted minus given. They contradict the others and took no part; they are no check points either, "
        "and count in no accuracy.",
    )  # fmt: skip
    return [Heading(text="Control points that were taken out"), body]


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
            text("point"), *(number(axis, view.length_unit) for axis in "XYZ"),
            *(number(f"d{axis}", view.unit) for axis in "XYZ"),
            *(number(f"sigma d{axis}", view.unit) for axis in "XYZ"), number("largest |d| / sigma"), number("rays"),
        ),
        (
            pick(rows, given.ids), *(cells(xyz[:, k].tolist(), coarse) for k in range(3)),
            *(cells(difference[:, k].tolist(), fine) for k in range(3)),
            *(cells(std[:, k].tolist(), fine) for k in range(3)),
            cells(np.where(np.isfinite(ratio).any(axis=1), np.max(np.nan_to_num(ratio), axis=1), np.nan).tolist(), 2),
            [grouped(float(view.rays[i])) for i in rows],
        ),
        note="d: adjusted minus given; its sigma holds that of the adjusted and that of the given coordinate. Check "
        "points took no part as control.",
        rest="check.csv",
        marked=np.flatnonzero(np.max(np.nan_to_num(ratio), axis=1) > 3.29).tolist(),
    )  # fmt: skip
    folded = Folded(summary=f"All {counted(len(rows), 'check point')}", parts=(body,))
    shown = body if len(rows) <= LONG else folded
    return [Heading(text="Check points"), _check_summary(difference, std, view.unit), *_asprs(view), shown]


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
            text("coordinate"), number("points"), number("mean", unit), number("rms", unit), number("largest", unit),
            number("rms of d / sigma"),
        ),
        zip(*rows, strict=True) if rows else [[] for _ in range(6)],
    )  # fmt: skip


def _components(view: View) -> list[Part]:
    """Variance components but those of single images, which stand with the residuals."""
    found = [v for v in view.adjustment.variance_components if v.kind != "image"]
    strange = sum(1 for v in view.adjustment.variance_components if v.kind == "image" and v.significant)
    verb = "differs" if strange == 1 else "differ"
    if not found:
        return []
    body = table(
        (
            text("observations"), text("group"), number("number"), number("redundancy"),
            number("σ a posteriori / a priori"), text(""),
        ),
        (
            [v.kind for v in found], [v.group for v in found], [grouped(v.count) for v in found],
            cells([v.redundancy for v in found], 1), cells([v.ratio for v in found], 3),
            ["differs from the others (1 %)" if v.significant else "" for v in found],
        ),
        note="A group that is marked differs from all others together (F test): it is weighted too high (ratio above "
        "theirs) or too low (below); change its a-priori sigma. Förstner 1979."
        + (f" {counted(strange, 'image')} {verb} on their own, see the images under “Residuals”." if strange else ""),
    )  # fmt: skip
    return [Heading(text="Variance components"), body]
