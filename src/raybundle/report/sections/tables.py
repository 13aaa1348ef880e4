"""Section: points and images in full, settings, fingerprints of the input, versions."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import fields, replace

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Role
from raybundle.errors import Text, note, phrase
from raybundle.io.block.folder import angles_deg
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.natural import natural_order
from raybundle.numerics.rows import rows_of_largest
from raybundle.report.chapters import Occasion, chapter, section
from raybundle.report.figures.svg import spread_rows
from raybundle.report.fingerprint import fingerprints, versions
from raybundle.report.languages import Localised
from raybundle.report.parts import (
    MOST_ROWS,
    PRINTED,
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
from raybundle.report.text.numbers import NONE, cells, column_decimals, grouped
from raybundle.report.view import View
from raybundle.settings import in_words

MOST_CORRELATED = 200
"""Points up to which a list shows correlations of coordinates: one that is read, point by point"""


def tables_section(view: View, *, every_point: bool = False) -> Section:
    """Points and images in natural order: as many as can be read, or every point."""
    count = len(view.adjusted.points)
    order = natural_order(view.adjusted.points.ids)
    points = _points(view, np.array(order[: count if every_point else MOST_ROWS], np.int32))
    if not every_point and count > PRINTED:
        rows = printed_points(view, np.array(order, np.int32))
        points = replace(points, printed=replace(_points(view, rows), note=_printed_note(len(rows), count)))
    images = _images(view)
    return Section(
        anchor="tables",
        title=phrase("report_tables.title"),
        parts=(
            Folded(summary=phrase("report_tables.object_points", n=len(view.given.points)), parts=(points,)),
            Folded(summary=phrase("report_tables.images", n=len(view.given.images)), parts=(images,)),
        ),
    )


def printed_points(view: View, order: Index) -> Index:
    """Rows of the points that paper holds, so many as a page: known and named ones, the worst, and a sample.

    order  (n,) all rows in natural order
    Half of the page is for known and named points, evenly chosen where they are more, a quarter for the worst of all.
    """
    role = np.asarray(view.given.points.role)
    known = order[(role[order] != Role.TIE) | np.asarray(view.given.points_named)[order]]
    chosen = set(known[spread_rows(len(known), PRINTED // 2)].tolist())
    if view.std is not None:
        size = np.nan_to_num(np.square(view.std)).sum(axis=1)
        chosen |= set(rows_of_largest(size, PRINTED // 4).tolist())
    rest = order[~np.isin(order, list(chosen))]
    chosen |= set(rest[spread_rows(len(rest), PRINTED - len(chosen))].tolist())
    return order[np.isin(order, list(chosen))]


def _printed_note(shown: int, count: int) -> Text:
    return Text.of(note("report_tables.points_printed", n=shown, of=count), note("report_tables.all_points"))


def _points(view: View, rows: Index) -> Table:
    """A list of these points."""
    p, a = view.adjusted.points, view.adjustment
    std = np.full((len(p), 3), np.nan) if view.std is None else view.std
    fine = column_decimals(std)
    coarse = fine + round(math.log10(view.factor))
    angle = np.full(len(p), np.nan) if a.network is None else np.degrees(a.network.intersection_angle)
    shown = len(p) <= MOST_CORRELATED and a.precision is not None
    role = {r: phrase("label.role_of", role=r.name.lower()) for r in Role}
    r = correlation_of(a.precision.object_points[rows]) if shown and a.precision is not None else np.zeros((0, 3))
    return table(
        (
            text(phrase("label.point")), text(phrase("label.role")),
            *(number(axis, view.length_unit) for axis in "XYZ"),
            *(number(phrase("label.sigma_of", symbol=axis), view.unit) for axis in "XYZ"),
            *(number(f"r {pair}") for pair in ("XY", "XZ", "YZ") if shown), number(phrase("label.rays")),
            number(phrase("label.angle"), "°"),
        ),
        (
            pick(rows, p.ids), [role[Role(int(r))] for r in p.role[rows]],
            *(cells(p.xyz[rows, k].tolist(), coarse) for k in range(3)),
            *(cells(std[rows, k].tolist(), fine) for k in range(3)),
            *(cells(r[:, k].tolist(), 2) for k in range(3) if shown),
            [grouped(float(k)) for k in view.rays[rows]], cells(angle[rows].tolist(), 1),
        ),
        note=Text.of(note("report_tables.first_points", n=len(rows), of=len(p)), note("report_tables.all_points"))
        if len(p) > len(rows) else "",
        most=max(len(rows), 1),
    )  # fmt: skip


def correlation_of(covariances: Array) -> Array:
    """(k, 3) correlations of X and Y, X and Z, Y and Z of covariances (k, 3, 3); NaN where a coordinate has none."""
    std = np.sqrt(np.where((v := np.diagonal(covariances, axis1=1, axis2=2)) > 0, v, np.nan))
    return np.stack([covariances[:, i, j] / (std[:, i] * std[:, j]) for i, j in ((0, 1), (0, 2), (1, 2))], axis=1)


def _images(view: View) -> Table:
    images, a = view.adjusted.images, view.adjustment
    std = np.full((len(images), 6), np.nan) if a.precision is None else a.precision.image_std
    std = np.where(std > 0, std, np.nan)
    centre, angle = std[:, :3] * view.factor, np.degrees(std[:, 3:])
    fine, turn = column_decimals(centre), column_decimals(angle)
    coarse = fine + round(math.log10(view.factor))
    degrees = angles_deg(images)
    order = np.array(natural_order(images.ids), np.int32)
    return table(
        (
            text(phrase("label.image")), text(phrase("label.camera")),
            *(number(axis, view.length_unit) for axis in "XYZ"),
            *(number(s, "°") for s in "ωφκ"),
            *(number(phrase("label.sigma_of", symbol=axis), view.unit) for axis in "XYZ"),
            *(number(phrase("label.sigma_of", symbol=s), "°") for s in "ωφκ"),
        ),
        (
            pick(order, images.ids), [a.given.cameras[int(c)].id for c in images.camera[order]],
            *(cells(images.centre[order, k].tolist(), coarse) for k in range(3)),
            *(cells(degrees[order, k].tolist(), turn) for k in range(3)),
            *(cells(centre[order, k].tolist(), fine) for k in range(3)),
            *(cells(angle[order, k].tolist(), turn) for k in range(3)),
        ),
        rest="images.csv",
    )  # fmt: skip


@chapter("tables", after="network", part="appendix")
def _tables(o: Occasion) -> tuple[Section, ...]:
    return (tables_section(o.view, every_point=o.appendix == "all"),)


def stated(words: Iterable[str]) -> list[str]:
    """Names of settings and programs, and their values, which are the same in every language."""
    return [Localised(w) for w in words]


@section("settings", after="tables", part="appendix")
def provenance_section(view: View) -> Section:
    """What would be needed to repeat the adjustment."""
    default = AdjustmentOptions(datum_over="all")
    options = replace(view.adjustment.options, datum_over=view.adjustment.options.datum_over or "all")
    names = [f.name for f in fields(AdjustmentOptions)]
    values = [getattr(options, n) for n in names]
    changed = [
        "" if v == getattr(default, n) else phrase("report_tables.changed") for n, v in zip(names, values, strict=True)
    ]
    settings = table(
        (text(phrase("label.setting")), text(phrase("label.value")), text("")),
        (stated(names), [_shown(v) for v in values], changed),
    )
    prints = fingerprints(view.given)
    hashes = table(
        (text(phrase("report_tables.input_label")), text(phrase("label.rows")), text(phrase("report_tables.hash"))),
        (
            [phrase("report_tables.table", name=name, other=name) for name, _, _ in prints],
            [count for _, count, _ in prints], [print_ for _, _, print_ in prints],
        ),
    )  # fmt: skip
    found = versions()
    software = table(
        (text(phrase("report_tables.software_label")), text(phrase("label.version"))),
        (stated(found), [v if isinstance(v, Text) else Localised(v) for v in found.values()]),
    )
    parts: list[Part] = [
        Heading(text=phrase("report_tables.settings")),
        settings,
        Heading(text=phrase("report_tables.input")),
        hashes,
    ]
    for kind, words in (
        ("description", view.given.about),
        ("source", view.given.source),
        ("licence", view.given.licence),
    ):
        if words:
            parts.append(Paragraph(text=phrase("report_tables.about", kind=kind, text=words), note=True))
    parts += [Heading(text=phrase("report_tables.software")), software]
    return Section(anchor="provenance", title=phrase("report_tables.provenance"), parts=tuple(parts))


def _shown(value: object) -> str:
    if isinstance(value, tuple):
        return Localised(", ".join(str(v) for v in value[:50]) + (" …" if len(value) > 50 else "") or NONE)
    if isinstance(value, bool):
        return phrase("label.truth", value=value)
    return Localised(in_words(value))
