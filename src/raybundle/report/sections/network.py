"""Section: precision of the object points and geometry of the network."""

from __future__ import annotations

import math

import numpy as np

from raybundle.adjustment.result import NetworkFigures
from raybundle.numerics.arrays import Array
from raybundle.report.chapters import Occasion, chapter, section
from raybundle.report.figures.network import angle_histogram, network_views, ray_histogram, roll_rose
from raybundle.report.figures.residuals import image_columns
from raybundle.report.figures.svg import histogram, spread_rows
from raybundle.report.parts import (
    PRINTED,
    Figure,
    Figures,
    Folded,
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
from raybundle.report.text.numbers import NONE, cells, column_decimals, counted, fixed, grouped, per_cent, significant
from raybundle.report.view import View, rms, with_near_viewpoints

MOST_PAIRS = 300
"""Image pairs that are listed."""


@section("precision", after="accuracy")
def precision_section(view: View) -> Section:
    """Standard deviations of the object points."""
    title = "Precision of the object points"
    if view.std is None:
        why = Paragraph(text="Standard deviations were not computed (statistics are off).")
        return Section(anchor="precision", title=title, parts=(why,))
    std = view.std
    if not np.isfinite(std).any():
        why = Paragraph(text="All object points are held: they have no standard deviations of their own.")
        return Section(anchor="precision", title=title, parts=(why,))
    rows: list[list[str]] = []
    for axis, column in zip("XYZ", std.T, strict=True):
        good = column[np.isfinite(column)]
        if not len(good):
            continue
        worst = view.given.points.ids[int(np.nanargmax(column))]
        numbers = [rms(good), float(good.mean()), *(float(q) for q in np.quantile(good, [0, 0.5, 0.95, 1]))]
        rows.append([axis, grouped(len(good)), *(significant(v) for v in numbers), worst])
    u = view.unit
    summary = table(
        (
            text("coordinate"), number("points"), number("rms", u), number("mean", u), number("smallest", u),
            number("median", u),
            number("95 %", u), number("largest", u), text("at point"),
        ),
        zip(*rows, strict=True),
    )  # fmt: skip
    parts: list[Part] = [
        summary,
        Figures(figures=_histograms(std, view.unit)),
        Folded(summary="The weakest points", parts=(_weakest(view),)),
    ]
    return Section(anchor="precision", title=title, parts=tuple(parts))


def _histograms(std: Array, unit: str) -> tuple[Figure, ...]:
    good = std[np.isfinite(std)]
    top = float(np.quantile(good, 0.98)) * 1.1
    edges = np.linspace(0, top, 26)
    return tuple(
        Figure(
            drawing=histogram(std[:, k], f"sigma {axis} [{unit}]", f"standard deviations of {axis}", edges=edges,
                              y_label="points", width=286),
            caption=f"Standard deviations of {axis}; the last column holds all larger ones.",
        )
        for k, axis in enumerate("XYZ")
        if np.isfinite(std[:, k]).any()
    )  # fmt: skip


def _weakest(view: View) -> Table:
    assert view.std is not None
    size = np.sqrt(np.nansum(view.std**2, axis=1))
    rows = np.argsort(-size, kind="stable")[:15]
    network = view.adjustment.network
    angle = np.full(len(size), math.nan) if network is None else np.degrees(network.intersection_angle)
    decimals = column_decimals(view.std[rows])
    return table(
        (
            text("point"), number("rays"), number("intersection angle", "°"), number("sigma X", view.unit),
            number("sigma Y", view.unit), number("sigma Z", view.unit),
        ),
        (
            pick(rows, view.given.points.ids), [grouped(float(view.rays[i])) for i in rows],
            cells(angle[rows].tolist(), 1),
            *(cells(view.std[rows, k].tolist(), decimals) for k in range(3)),
        ),
        caption="Points with the largest standard deviations",
    )  # fmt: skip


def network_section(view: View) -> Section:
    """Views of the network and figures of its geometry."""
    parts: list[Part] = []
    views = network_views(view)
    if views is not None:
        where = " The coordinate system is arbitrary." if len(view.adjustment.datum_defect) == 7 else ""
        caption = (
            f"Plan (XY), front view (XZ) below, side view (ZY) beside it. {views.remark} Triangles: control, "
            f"circles: check points.{where}"
        )
        parts.append(Figures(figures=(Figure(drawing=views.drawing, caption=caption),), first=True))
    network = view.adjustment.network
    if network is None:
        parts.append(
            Paragraph(
                text="Angles, base-to-depth ratios and coverage were not computed (statistics are off).", note=True
            )
        )
    else:
        parts += [
            _figures_table(view, network),
            _diversity(view, network),
            *_pairs(view, network),
            *_coverage(view, network),
        ]
    return Section(anchor="network", title="Network", parts=tuple(parts))


def _range(values: Array, digits: int = 3, *, whole: bool = False) -> str:
    """Smallest, median and largest of the finite values."""
    good = values[np.isfinite(values)]
    if not len(good):
        return NONE
    low, mid, high = (float(q) for q in np.quantile(good, [0, 0.5, 1]))
    if whole:
        return f"{grouped(low)} … {fixed(mid, int(mid % 1 != 0))} … {grouped(high)}"
    return f"{significant(low, digits)} … {significant(mid, digits)} … {significant(high, digits)}"


def _figures_table(view: View, n: NetworkFigures) -> Table:
    used = n.rays > 0
    angle = np.degrees(n.intersection_angle)
    rows = [
        (
            "rays per point (smallest … median … largest)",
            _range(n.rays[used].astype(float), whole=True),
            f"mean {fixed(float(n.rays[used].mean()), 2)}",
        ),
        (
            "stations per point",
            _range(n.stations_per_point[used].astype(float), whole=True),
            "rays from distinct projection centres",
        ),
        ("largest intersection angle", f"{_range(angle)}°", f"{counted(int((angle < 5).sum()), 'point')} below 5°"),
        ("distance to the object", f"{_range(n.distance)} {view.length_unit}", "median of each image"),
        ("image scale number S", _range(n.image_scale), "distance over camera constant"),
        (
            "base-to-depth ratio",
            _range(n.base_to_depth),
            f"{counted(len(n.base_to_depth), 'pair')} with 6 common points or more",
        ),
        (
            "coverage of the format",
            f"{_range(100 * n.coverage[np.isfinite(n.distance)], 2)} %",
            "share of 10 × 10 cells that hold a point",
        ),
        ("connected parts", grouped(n.components), ""),
    ]
    if math.isfinite(n.q):
        rows += [
            ("q", significant(n.q), "σ = q S σ(xy) / √k, k the mean number of rays per point"),
            ("q by stations", significant(n.q_stations), "the same with the mean number of stations"),
            (
                "efficiency of the directions",
                per_cent(min(1.0, (n.bound / n.q) ** 2)),
                f"(bound / q)², bound {significant(n.bound)} for rays from all directions",
            ),
        ]
    return table((text("figure"), text("value"), text("meaning")), zip(*rows, strict=True))


def _diversity(view: View, n: NetworkFigures) -> Figures:
    figures = [
        Figure(drawing=ray_histogram(view.rays, "rays per point"), caption="Rays per object point."),
        Figure(drawing=angle_histogram(n, "intersection angles"), caption="Largest intersection angle of each point."),
        Figure(drawing=roll_rose(n.roll, "rolls of the images"), caption=_roll_words(view, n.roll)),
    ]
    scale = n.image_scale[np.isfinite(n.image_scale)]
    if len(scale) > 3:
        spread = float(scale.max() / scale.min()) if scale.min() > 0 else math.nan
        figures.append(
            Figure(
                drawing=histogram(scale, "image scale number", "image scales", y_label="images", width=286),
                caption=f"Image scale numbers; the largest is {significant(spread, 2)} times the smallest.",
            )
        )
    if len(n.base_to_depth):
        drawn = histogram(n.base_to_depth, "base-to-depth ratio", "base-to-depth ratios", y_label="pairs", width=286,
                          edges=np.append(np.linspace(0, 2, 21), [2.1]))  # fmt: skip
        words = (
            f"Base-to-depth ratio of {counted(len(n.base_to_depth), 'image pair')}; the last column holds all above 2."
        )
        figures.append(Figure(drawing=drawn, caption=words))
    return Figures(figures=tuple(figures))


def _roll_words(view: View, roll: Array) -> str:
    good = np.degrees(roll[np.isfinite(roll)])
    turned = int((np.abs(np.abs(good) - 90) < 30).sum())
    words = f"Roll about the viewing axis, most frequent up; {counted(turned, 'image')} near ±90°."
    estimated = {s for i in view.adjustment.interior for s in i.free}
    if turned or not estimated & {"x0", "y0", "P1", "P2"}:
        return words
    return f"{words} Without rolled images principal point and decentring stay correlated."


def _pairs(view: View, n: NetworkFigures) -> list[Part]:
    count = len(n.base_to_depth)
    if not count:
        return [Paragraph(text="No two images share six points or more.", note=True)]
    ids = view.given.images.ids
    order = np.argsort(-n.pair_points, kind="stable")[:MOST_PAIRS]
    cut = f" {grouped(len(order))} of {grouped(count)} pairs are shown." if len(order) < count else ""
    body = table(
        (text("image"), text("image"), number("common points"), number("base-to-depth")),
        (
            pick(n.pair_images[order, 0], ids), pick(n.pair_images[order, 1], ids),
            [grouped(float(k)) for k in n.pair_points[order]], cells(n.base_to_depth[order].tolist(), 3),
        ),
        note=f"Pairs in the order of their common points.{cut}",
    )  # fmt: skip
    shown = spread_rows(len(order), PRINTED)
    note = f"{grouped(len(shown))} of {grouped(count)} pairs, evenly chosen from the strongest to the weakest."
    return [Folded(summary=f"{counted(count, 'image pair')}", parts=(on_a_page(body, shown, note),))]


def _coverage(view: View, n: NetworkFigures) -> list[Part]:
    taken = np.flatnonzero(np.isfinite(n.distance))
    if len(taken) < 2:
        return []
    ids = pick(taken, view.given.images.ids)
    drawn = image_columns(ids, 100 * n.coverage[taken], "coverage [%]", "coverage of the image format")
    return [Figures(figures=(Figure(drawing=drawn, caption="Coverage of the format by image points, each image."),))]


@chapter("network", after="reliability")
def _network(o: Occasion) -> tuple[Section, ...]:
    return (network_section(with_near_viewpoints(o.view)),)
