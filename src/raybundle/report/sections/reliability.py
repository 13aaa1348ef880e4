"""Section: redundancy numbers, largest test values, rejected observations, smallest detectable blunders, suspects."""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.cell_means import cell_means
from raybundle.numerics.arrays import Array, Index
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
from raybundle.report.text.numbers import NONE, cells, column_decimals, counted, fixed, grouped, per_cent, significant
from raybundle.report.view import View

LARGEST, WEAKEST, MOST_REJECTED = 20, 15, 500
BELOW = -1e-6
"""Redundancy number below which it lies outside 0 .. 1, and not by rounding alone."""
POORLY = 0.1
"""Redundancy number below which an observation is hardly controlled by the others."""


@section("reliability", after="residuals")
def reliability_section(view: View) -> Section:
    """How well the observations control one another."""
    title = "Reliability"
    a = view.adjustment
    rejected = _rejected(view)
    if a.precision is None:
        why = Paragraph(text="Redundancy numbers and tests were not computed (statistics are off).")
        return Section(anchor="reliability", title=title, parts=(why, *rejected))
    parts: list[Part] = [Paragraph(text=_words(view)), *_figures(view), *_detectable(view)]
    parts += [Heading(text="Largest residuals"), _largest(view), *rejected, *_suspects(view), _critical(view)]
    return Section(anchor="reliability", title=title, parts=tuple(parts))


def _words(view: View) -> str:
    r = view.adjustment.image_observations.redundancy[view.used]
    r = r[np.isfinite(r)]
    if not len(r):
        return "No image observation has a redundancy number."
    share = controlled_share(view)[view.used]
    poor = int((share < POORLY).sum())
    text_ = (
        "The redundancy number r is the share of an observation's error that shows in its own residual. Its mean "
        f"over the image coordinates is {fixed(float(r.mean()), 3)}, its smallest {fixed(float(r.min()), 3)}."
    )
    if poor:
        text_ += (
            f" {counted(poor, 'image coordinate')} ({per_cent(poor / len(r))}) with r below {POORLY:g}: a blunder "
            "there would go almost whole into the result."
        )
    return text_ + _below_zero(view)


def _below_zero(view: View) -> str:
    """What redundancy numbers below zero mean, where there are any; empty where there are none."""
    s = view.adjustment.image_observations
    r = np.nan_to_num(s.redundancy)
    rows = (r < BELOW).any(axis=1)
    if not rows.any():
        return ""
    least = s.least_control[rows]
    largest = r[rows].sum(axis=1) - least
    count = int((r < BELOW).sum())
    return (
        f" {counted(count, 'redundancy number')} ({per_cent(count / (2 * int(view.used.sum())))}) "
        f"{'lie' if count > 1 else 'lies'} below zero, down to {fixed(float(r.min()), 3)}. That is no error: x and y "
        "of these observations are correlated, and r is then no share of one coordinate's error alone. The eigenvalues "
        "of such a point's 2 × 2 block, whose sum is r x + r y, lie within 0 … 1: the smaller ones here from "
        f"{fixed(float(least.min()), 3)} to {fixed(float(least.max()), 3)}, the larger ones from "
        f"{fixed(float(largest.min()), 3)} to {fixed(float(largest.max()), 3)}. Tests and smallest detectable blunders "
        "rest on the variance of P v, which is positive."
    )


def _figures(view: View) -> list[Part]:
    a = view.adjustment
    tests = normalised(view)
    r = a.image_observations.redundancy[view.used].ravel()
    figures = [
        Figure(
            drawing=redundancy_map(cell_means(a, view.given.cameras[c], mask, tests), view.given.cameras[c],
                                   f"redundancy numbers over the format of camera {view.given.cameras[c].id}"),
            caption=f"Mean redundancy number over the format, camera {view.given.cameras[c].id}; red where the "
            "observations hardly control one another.",
        )
        for c, mask in view.cameras()[:6]
    ]  # fmt: skip
    figures.append(
        Figure(
            drawing=histogram(
                np.clip(r, 0, 1), "redundancy number", "histogram of redundancy numbers", edges=np.linspace(0, 1, 21)
            ),
            caption="Redundancy numbers of the image coordinates.",
        )
    )
    parts: list[Part] = [Figures(figures=tuple(figures))]
    rows = image_rows(view, tests)
    if len(rows) > 1:
        ids = [view.given.images.ids[row.image] for row in rows]
        drawn = image_columns(
            ids, np.array([row.redundancy for row in rows]), "mean r", "mean redundancy number of each image"
        )
        parts.append(Figures(figures=(Figure(drawing=drawn, caption="Mean redundancy number of each image."),)))
    return parts


def _names(view: View, rows: Index) -> tuple[list[str], list[str]]:
    o = view.given.observations
    return pick(o.image[rows], view.given.images.ids), pick(o.point[rows], view.given.points.ids)


def _detectable(view: View) -> list[Part]:
    """Smallest detectable blunders and what they would do to the object points."""
    mdb, external = detectable(view)
    if not np.isfinite(mdb).any():
        return [Paragraph(text="No image observation is controlled: no blunder can be found.")]
    words = _detectable_words(view, mdb[np.isfinite(mdb)], external[np.isfinite(external)])
    parts: list[Part] = [Heading(text="Smallest detectable blunders"), Paragraph(text=words)]
    weakest = _weakest(view, mdb, external)
    if weakest.rows:
        parts.append(Folded(summary="The weakest image coordinates", parts=(weakest,)))
    return parts


def _detectable_words(view: View, mdb: Array, effect: Array) -> str:
    px = [significant(float(q)) for q in np.quantile(mdb, [0.5, 0.95, 1.0])]
    words = (
        f"A blunder in an image coordinate is found with {per_cent(POWER)} probability at a level of "
        f"{per_cent(ALPHA)} if it is larger than {px[0]} px (median), {px[1]} px (95 % of the coordinates), {px[2]} "
        "px (all)."
    )
    if len(effect) and (effect > 0).any():
        size = [f"{significant(float(q))} {view.unit}" for q in np.quantile(effect, [0.5, 0.95, 1.0])]
        words += (
            f" Undetected, one of that size would move its object point by up to {size[0]} (median), {size[1]} (95 "
            f"%), {size[2]} (largest)."
        )
    lost = 2 * int(view.used.sum()) - len(mdb)
    if lost:
        words += (
            f" Not counted: {counted(lost, 'image coordinate')} with r below {UNTESTED:g}, where practically no "
            "blunder is found (along the epipolar line of points with two rays)."
        )
    return words


def _weakest(view: View, mdb: Array, external: Array) -> Table:
    """The image coordinates whose undetected blunders have the largest effect."""
    s, o = view.adjustment.image_observations, view.given.observations
    effect = np.nan_to_num(external, nan=-1.0)
    worst = effect.max(axis=1)
    rows = np.argsort(-worst, kind="stable")[:WEAKEST].astype(np.int32)
    rows = rows[worst[rows] > 0]
    images, points = _names(view, rows)
    axis, at = effect[rows].argmax(axis=1), np.arange(len(rows))
    return table(
        (
            text("image"), text("point"), text("axis"), number("rays"), number("r"), number("mdb", "px"),
            number("effect on the point", view.unit),
        ),
        (
            images, points, ["xy"[k] for k in axis], [grouped(float(view.rays[i])) for i in o.point[rows]],
            cells(s.redundancy[rows][at, axis].tolist(), 3), cells(mdb[rows][at, axis].tolist(), 2),
            [significant(float(v)) for v in external[rows][at, axis]],
        ),
        caption="Image coordinates whose undetected blunders would do most harm",
        note="mdb: smallest detectable blunder.",
    )  # fmt: skip


def _largest(view: View) -> Table:
    a, o = view.adjustment, view.given.observations
    s = a.image_observations
    size = np.where(view.used, np.nan_to_num(np.abs(s.w)).max(axis=1), -1.0)
    rows = np.argsort(-size, kind="stable")[:LARGEST].astype(np.int32)
    rows = rows[size[rows] > 0]
    images, points = _names(view, rows)
    decimals = column_decimals(np.sqrt(o.cov_px2[rows, :2])) + 1

    def pair(values: Array, places: int) -> list[list[str]]:
        return [cells(values[rows, k].tolist(), places) for k in (0, 1)]

    beyond = [k for k, row in enumerate(rows) if np.nan_to_num(np.abs(s.t[row])).max() > a.critical_tau]
    return table(
        (
            text("image"), text("point"), number("x", "px"), number("y", "px"), number("v x", "px"),
            number("v y", "px"),
            number("r x"), number("r y"), number("w x"), number("w y"), number("τ x"), number("τ y"),
            number("mdb x", "px"), number("mdb y", "px"),
        ),
        (
            images, points, *pair(o.xy_px, 1), *pair(s.residuals_px, decimals), *pair(s.redundancy, 2), *pair(s.w, 2),
            *pair(s.t, 2), *pair(s.mdb_px, 2),
        ),
        note=f"The {grouped(len(rows))} largest |w|. w = v / (s √r) with the a-priori sigma, τ = w / σ₀; mdb: "
        "smallest detectable blunder; marked where |τ| exceeds its family-wise critical value "
        f"{significant(a.critical_tau)}.",
        marked=beyond,
    )  # fmt: skip


def _rejected(view: View) -> list[Part]:
    rows = view.rejected
    if not len(rows):
        return [Heading(text="Rejected observations"), Paragraph(text="No image observation was rejected.")]
    images, points = _names(view, rows)
    xy, reasons = view.given.observations.xy_px[rows], view.adjustment.image_observations.rejected
    listed = table(
        (text("image"), text("point"), number("x", "px"), number("y", "px"), text("reason")),
        (
            images,
            points,
            cells(xy[:, 0].tolist(), 2),
            cells(xy[:, 1].tolist(), 2),
            [str(reasons[int(k)]) for k in rows],
        ),
        most=MOST_REJECTED,
        rest="observations.csv",
    )
    shown = spread_rows(len(listed.rows), PRINTED)
    note = f"{grouped(len(shown))} of {grouped(len(rows))} rows, evenly chosen; all are in observations.csv."
    listed = on_a_page(listed, shown, note)
    share = per_cent(len(rows) / len(view.used))
    words = Paragraph(text=f"{counted(len(rows), 'image observation')} ({share}) took no part.")
    heading = Heading(text="Rejected observations")
    return (
        [heading, words, listed]
        if len(rows) <= 30
        else [heading, words, Folded(summary="List of rejected observations", parts=(listed,))]
    )


def _suspects(view: View) -> list[Part]:
    suspects = view.adjustment.suspects
    if not suspects:
        return []
    listed = table(
        (text("image"), text("point"), number("largest |w|"), number("largest correlation with another")),
        (
            [s[0] for s in suspects], [s[1] for s in suspects], [fixed(s[2], 2) for s in suspects],
            [fixed(s[3], 2) if np.isfinite(s[3]) else NONE for s in suspects],
        ),
        note="Two suspects whose test values correlate strongly cannot be told apart: only one of them may be wrong.",
        rest="observations.csv",
        most=200,
    )  # fmt: skip
    return [Heading(text="Suspects and how well they can be told apart"), listed]


def _critical(view: View) -> Folded:
    a = view.adjustment
    level = per_cent(a.options.significance)
    rows = [
        ("|w| of a single test", f"{CRITICAL_W:.4f}", per_cent(ALPHA), "Baarda 1968"),
        ("|w|, all tests together", f"{a.critical_w:.4f}", level, "Bonferroni"),
        ("|τ|, all tests together", fixed(a.critical_tau, 4), level, "Pope 1976"),
        ("shift of w that is found", f"{DELTA0:.4f}", f"{per_cent(ALPHA)}, power {per_cent(POWER)}", "Baarda 1968"),
    ]
    body = table((text("test"), number("value"), text("level"), text("source")), zip(*rows, strict=True))
    return Folded(summary="Critical values", parts=(body,))
