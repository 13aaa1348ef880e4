"""Section: redundancy numbers, largest test values, rejected observations, smallest detectable blunders, suspects."""

from __future__ import annotations

from typing import Any

import numpy as np

from raybundle.adjustment.evaluation.cell_means import cell_means
from raybundle.errors import Message, Text, note, phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.rows import rows_of_largest
from raybundle.numerics.statistics import ALPHA, CRITICAL_W, DELTA0, POWER
from raybundle.report.chapters import section
from raybundle.report.detectable import UNTESTED, controlled_share, detectable
from raybundle.report.figures.residuals import image_columns, redundancy_map
from raybundle.report.figures.svg import histogram, spread_rows
from raybundle.report.parts import (
    PRINTED,
    Figure,
    Figures,
    Folded,
    Heading,
    Paragraph,
    Part,
    Section,
    Table,
    number,
    on_a_page,
    pick,
    table,
    text,
)
from raybundle.report.residuals import image_rows, normalised
from raybundle.report.text.numbers import NONE, cells, column_decimals, fixed, grouped, per_cent, significant
from raybundle.report.view import View

LARGEST, WEAKEST, MOST_REJECTED = 20, 15, 500
BELOW = -1e-6
"""Redundancy number below which it lies outside 0 .. 1, and not by rounding alone."""
POORLY = 0.1
"""Redundancy number below which an observation is hardly controlled by the others."""


@section("reliability", after="residuals")
def reliability_section(view: View) -> Section:
    """How well the observations control one another."""
    title = phrase("report_reliability.title")
    a = view.adjustment
    rejected = _rejected(view)
    if a.precision is None:
        why = Paragraph(text=phrase("report_reliability.no_statistics"))
        return Section(anchor="reliability", title=title, parts=(why, *rejected))
    parts: list[Part] = [Paragraph(text=_words(view)), *_figures(view), *_detectable(view)]
    parts += [
        Heading(text=phrase("report_reliability.largest")),
        _largest(view),
        *rejected,
        *_suspects(view),
        _critical(view),
    ]
    return Section(anchor="reliability", title=title, parts=tuple(parts))


def _words(view: View) -> Text:
    r = view.adjustment.image_observations.redundancy[view.used]
    r = r[np.isfinite(r)]
    if not len(r):
        return phrase("report_reliability.no_redundancy_number")
    share = controlled_share(view)[view.used]
    poor = int((share < POORLY).sum())
    found = [note("report_reliability.redundancy", mean=float(r.mean()), least=float(r.min()))]
    if poor:
        found.append(note("report_reliability.poor", n=poor, share=poor / len(r), limit=POORLY))
    return Text.of(*found, *_below_zero(view))


def _below_zero(view: View) -> list[Message]:
    """What redundancy numbers below zero mean, where there are any."""
    s = view.adjustment.image_observations
    r = np.nan_to_num(s.redundancy)
    rows = (r < BELOW).any(axis=1)
    if not rows.any():
        return []
    smaller = s.least_control[rows]
    larger = r[rows].sum(axis=1) - smaller
    count = int((r < BELOW).sum())
    return [
        note(
            "report_reliability.below_zero",
            n=count,
            share=count / (2 * int(view.used.sum())),
            least=float(r.min()),
        ),
        note(
            "report_reliability.eigenvalues",
            smaller_from=float(smaller.min()),
            smaller_to=float(smaller.max()),
            larger_from=float(larger.min()),
            larger_to=float(larger.max()),
        ),
    ]


def _figures(view: View) -> list[Part]:
    a = view.adjustment
    tests = normalised(view)
    r = a.image_observations.redundancy[view.used].ravel()
    figures = [
        Figure(
            drawing=redundancy_map(cell_means(a, view.given.cameras[c], mask, tests), view.given.cameras[c],
                                   phrase("drawn.redundancy_map", camera=view.given.cameras[c].id)),
            caption=phrase("report_reliability.map", camera=view.given.cameras[c].id),
        )
        for c, mask in view.cameras()[:6]
    ]  # fmt: skip
    figures.append(
        Figure(
            drawing=histogram(
                np.clip(r, 0, 1),
                phrase("axis.redundancy_number"),
                phrase("drawn.redundancy_histogram"),
                edges=np.linspace(0, 1, 21),
            ),
            caption=phrase("report_reliability.histogram"),
        )
    )
    parts: list[Part] = [Figures(figures=tuple(figures))]
    rows = image_rows(view, tests)
    if len(rows) > 1:
        ids = [view.given.images.ids[row.image] for row in rows]
        drawn = image_columns(
            ids,
            np.array([row.redundancy for row in rows]),
            phrase("axis.mean_redundancy"),
            phrase("drawn.redundancy_of_images"),
        )
        caption = phrase("report_reliability.of_images")
        parts.append(Figures(figures=(Figure(drawing=drawn, caption=caption),)))
    return parts


def _names(view: View, rows: Index) -> tuple[list[str], list[str]]:
    o = view.given.observations
    return pick(o.image[rows], view.given.images.ids), pick(o.point[rows], view.given.points.ids)


def _detectable(view: View) -> list[Part]:
    """Smallest detectable blunders and what they would do to the object points."""
    mdb, external = detectable(view)
    if not np.isfinite(mdb).any():
        return [Paragraph(text=phrase("report_reliability.uncontrolled"))]
    words = _detectable_words(view, mdb[np.isfinite(mdb)], external[np.isfinite(external)])
    parts: list[Part] = [Heading(text=phrase("report_reliability.detectable_heading")), Paragraph(text=words)]
    weakest = _weakest(view, mdb, external)
    if weakest.rows:
        parts.append(Folded(summary=phrase("report_reliability.weakest_list"), parts=(weakest,)))
    return parts


def _detectable_words(view: View, mdb: Array, effect: Array) -> Text:
    def sizes(values: Array) -> dict[str, Any]:
        names = ("median", "most", "largest")
        return dict(zip(names, np.quantile(values, [0.5, 0.95, 1.0]).tolist(), strict=True))

    found = [note("report_reliability.detectable", power=POWER, level=ALPHA, **sizes(mdb))]
    if len(effect) and (effect > 0).any():
        found.append(note("report_reliability.effect", unit=view.unit, **sizes(effect)))
    uncounted = 2 * int(view.used.sum()) - len(mdb)
    if uncounted:
        found.append(note("report_reliability.untested", n=uncounted, limit=UNTESTED))
    return Text.of(*found)


def _weakest(view: View, mdb: Array, external: Array) -> Table:
    """The image coordinates whose undetected blunders have the largest effect."""
    s, o = view.adjustment.image_observations, view.given.observations
    effect = np.nan_to_num(external, nan=-1.0)
    worst = effect.max(axis=1)
    rows = rows_of_largest(worst, WEAKEST).astype(np.int32)
    rows = rows[worst[rows] > 0]
    images, points = _names(view, rows)
    axis, at = effect[rows].argmax(axis=1), np.arange(len(rows))
    return table(
        (
            text(phrase("label.image")), text(phrase("label.point")), text(phrase("label.axis")),
            number(phrase("label.rays")), number("r"), number("MDB", "px"),
            number(phrase("report_reliability.effect_on_point"), view.unit),
        ),
        (
            images, points, ["xy"[k] for k in axis], [grouped(float(view.rays[i])) for i in o.point[rows]],
            cells(s.redundancy[rows][at, axis].tolist(), 3), cells(mdb[rows][at, axis].tolist(), 2),
            [significant(float(v)) for v in external[rows][at, axis]],
        ),
        caption=phrase("report_reliability.weakest"),
        note=phrase("label.mdb_note"),
    )  # fmt: skip


def _largest(view: View) -> Table:
    a, o = view.adjustment, view.given.observations
    s = a.image_observations
    size = np.where(view.used, np.nan_to_num(np.abs(s.w)).max(axis=1), -1.0)
    rows = rows_of_largest(size, LARGEST).astype(np.int32)
    rows = rows[size[rows] > 0]
    images, points = _names(view, rows)
    decimals = column_decimals(np.sqrt(o.cov_px2[rows, :2])) + 1

    def pair(values: Array, places: int) -> list[list[str]]:
        return [cells(values[rows, k].tolist(), places) for k in (0, 1)]

    beyond = [k for k, row in enumerate(rows) if np.nan_to_num(np.abs(s.t[row])).max() > a.critical_tau]
    return table(
        (
            text(phrase("label.image")), text(phrase("label.point")), number("x", "px"), number("y", "px"),
            number("v x", "px"), number("v y", "px"),
            number("r x"), number("r y"), number("w x"), number("w y"), number("τ x"), number("τ y"),
            number("MDB x", "px"), number("MDB y", "px"),
        ),
        (
            images, points, *pair(o.xy_px, 1), *pair(s.residuals_px, decimals), *pair(s.redundancy, 2), *pair(s.w, 2),
            *pair(s.t, 2), *pair(s.mdb_px, 2),
        ),
        note=Text.of(
            note("report_reliability.largest_note", n=len(rows)), note("label.mdb_note"),
            note("report_reliability.marked", limit=a.critical_tau),
        ),
        marked=beyond,
    )  # fmt: skip


def _rejected(view: View) -> list[Part]:
    rows, heading = view.rejected, Heading(text=phrase("report_reliability.rejected"))
    if not len(rows):
        return [heading, Paragraph(text=phrase("report_reliability.none_rejected"))]
    images, points = _names(view, rows)
    xy, reasons = view.given.observations.xy_px[rows], view.adjustment.image_observations.rejected
    listed = table(
        (
            text(phrase("label.image")),
            text(phrase("label.point")),
            number("x", "px"),
            number("y", "px"),
            text(phrase("label.reason")),
        ),
        (
            images,
            points,
            cells(xy[:, 0].tolist(), 2),
            cells(xy[:, 1].tolist(), 2),
            ["" if (why := reasons[int(k)]) is None else why.text for k in rows],
        ),
        most=MOST_REJECTED,
        rest="observations.csv",
    )
    shown = spread_rows(len(listed.rows), PRINTED)
    chosen = phrase("label.rows_chosen", n=len(shown), of=len(rows), rest="observations.csv")
    listed = on_a_page(listed, shown, chosen)
    words = Paragraph(text=phrase("report_reliability.rejected_share", n=len(rows), share=len(rows) / len(view.used)))
    return (
        [heading, words, listed]
        if len(rows) <= 30
        else [heading, words, Folded(summary=phrase("report_reliability.rejected_list"), parts=(listed,))]
    )


def _suspects(view: View) -> list[Part]:
    suspects = view.adjustment.suspects
    if not suspects:
        return []
    listed = table(
        (
            text(phrase("label.image")), text(phrase("label.point")), number(phrase("label.largest_w")),
            number(phrase("report_reliability.correlation_of_suspects")),
        ),
        (
            [s[0] for s in suspects], [s[1] for s in suspects], [fixed(s[2], 2) for s in suspects],
            [fixed(s[3], 2) if np.isfinite(s[3]) else NONE for s in suspects],
        ),
        note=phrase("report_reliability.suspects_note"),
        rest="observations.csv",
        most=200,
    )  # fmt: skip
    return [Heading(text=phrase("report_reliability.suspects")), listed]


def _critical(view: View) -> Folded:
    a = view.adjustment
    level = per_cent(a.options.significance)
    rows = [
        (phrase("report_reliability.single_test"), f"{CRITICAL_W:.4f}", per_cent(ALPHA), "Baarda 1968"),
        (phrase("report_reliability.all_tests", symbol="w"), f"{a.critical_w:.4f}", level, "Bonferroni"),
        (phrase("report_reliability.all_tests", symbol="τ"), fixed(a.critical_tau, 4), level, "Pope 1976"),
        (
            phrase("report_reliability.noncentrality"), f"{DELTA0:.4f}",
            phrase("report_reliability.level_and_power", level=ALPHA, power=POWER), "Baarda 1968",
        ),
    ]  # fmt: skip
    columns = (
        text(phrase("label.test")),
        number(phrase("label.value")),
        text(phrase("label.level")),
        text(phrase("label.source")),
    )
    body = table(columns, zip(*rows, strict=True))
    return Folded(summary=phrase("report_reliability.critical_values"), parts=(body,))
