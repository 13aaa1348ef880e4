"""Section: precision of the object points and geometry of the network."""

from __future__ import annotations

import math

import numpy as np

from raybundle.adjustment.records.figures import NetworkFigures
from raybundle.adjustment.statistics.network import COMMON
from raybundle.errors import Text, note, phrase
from raybundle.numerics.arrays import Array
from raybundle.numerics.rows import rows_of_largest
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
from raybundle.report.text.numbers import NONE, cells, column_decimals, fixed, grouped, per_cent, significant
from raybundle.report.view import View, rms, with_near_viewpoints

MOST_PAIRS = 300
"""Image pairs that are listed."""


@section("precision", after="accuracy")
def precision_section(view: View) -> Section:
    """Standard deviations of the object points."""
    title = phrase("report_network.precision_title")
    if view.std is None:
        why = Paragraph(text=phrase("report_network.no_statistics"))
        return Section(anchor="precision", title=title, parts=(why,))
    std = view.std
    if not np.isfinite(std).any():
        why = Paragraph(text=phrase("report_network.all_held"))
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
            text(phrase("label.coordinate")), number(phrase("label.points")), number(phrase("label.rms"), u),
            number(phrase("label.mean"), u), number(phrase("label.smallest"), u), number(phrase("label.median"), u),
            number("95 %", u), number(phrase("label.largest"), u), text(phrase("label.at_point")),
        ),
        zip(*rows, strict=True),
    )  # fmt: skip
    parts: list[Part] = [
        summary,
        Figures(figures=_histograms(std, view.unit)),
        Folded(summary=phrase("report_network.weakest_list"), parts=(_weakest(view),)),
    ]
    return Section(anchor="precision", title=title, parts=tuple(parts))


def _histograms(std: Array, unit: str) -> tuple[Figure, ...]:
    good = std[np.isfinite(std)]
    top = float(np.quantile(good, 0.98)) * 1.1
    edges = np.linspace(0, top, 26)
    return tuple(
        Figure(
            drawing=histogram(
                std[:, k], phrase("axis.sigma", axis=axis, unit=unit), phrase("drawn.deviations_of", axis=axis),
                edges=edges, y_label=phrase("label.points"), width=286,
            ),
            caption=phrase("report_network.deviations", axis=axis),
        )
        for k, axis in enumerate("XYZ")
        if np.isfinite(std[:, k]).any()
    )  # fmt: skip


def _weakest(view: View) -> Table:
    assert view.std is not None
    size = np.sqrt(np.nansum(view.std**2, axis=1))
    rows = rows_of_largest(size, 15)
    network = view.adjustment.network
    angle = np.full(len(size), math.nan) if network is None else np.degrees(network.intersection_angle)
    decimals = column_decimals(view.std[rows])
    return table(
        (
            text(phrase("label.point")), number(phrase("label.rays")), number(phrase("label.intersection_angle"), "°"),
            *(number(phrase("label.sigma_of", symbol=axis), view.unit) for axis in "XYZ"),
        ),
        (
            pick(rows, view.given.points.ids), [grouped(float(view.rays[i])) for i in rows],
            cells(angle[rows].tolist(), 1),
            *(cells(view.std[rows, k].tolist(), decimals) for k in range(3)),
        ),
        caption=phrase("report_network.weakest"),
    )  # fmt: skip


def network_section(view: View) -> Section:
    """Views of the network and figures of its geometry."""
    parts: list[Part] = []
    views = network_views(view)
    if views is not None:
        where = [note("report_network.arbitrary_system")] if len(view.adjustment.datum_defect) == 7 else []
        caption = Text.of(note("report_network.views"), *views.remark, note("report_network.symbols"), *where)
        parts.append(Figures(figures=(Figure(drawing=views.drawing, caption=caption),), first=True))
    network = view.adjustment.network
    if network is None:
        parts.append(Paragraph(text=phrase("report_network.geometry_not_computed"), note=True))
    else:
        parts += [
            _figures_table(view, network),
            _diversity(view, network),
            *_pairs(view, network),
            *_coverage(view, network),
        ]
    return Section(anchor="network", title=phrase("report_network.title"), parts=tuple(parts))


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
            phrase("report_network.rays"),
            _range(n.rays[used].astype(float), whole=True),
            phrase("report_network.mean_rays", mean=float(n.rays[used].mean())),
        ),
        (
            phrase("report_network.stations"),
            _range(n.stations_per_point[used].astype(float), whole=True),
            phrase("report_network.stations_meaning"),
        ),
        (
            phrase("report_network.largest_angle"),
            f"{_range(angle)}°",
            phrase("report_network.small_angles", n=int((angle < 5).sum())),
        ),
        (
            phrase("report_network.distance"),
            f"{_range(n.distance)} {view.length_unit}",
            phrase("report_network.distance_meaning"),
        ),
        (
            phrase("report_network.image_scale"),
            _range(n.image_scale),
            phrase("report_network.image_scale_meaning"),
        ),
        (
            phrase("report_network.base_to_depth"),
            _range(n.base_to_depth),
            phrase("report_network.pairs_with_points", n=len(n.base_to_depth), least=COMMON),
        ),
        (
            phrase("report_network.coverage"),
            f"{_range(100 * n.coverage[np.isfinite(n.distance)], 2)} %",
            phrase("report_network.coverage_meaning"),
        ),
        (phrase("report_network.parts"), grouped(n.components), ""),
    ]
    if math.isfinite(n.q):
        rows += [
            ("q", significant(n.q), phrase("report_network.q_meaning")),
            (
                phrase("report_network.q_stations"),
                significant(n.q_stations),
                phrase("report_network.q_stations_meaning"),
            ),
            (
                phrase("report_network.efficiency"),
                per_cent(min(1.0, (n.bound / n.q) ** 2)),
                phrase("report_network.efficiency_meaning", bound=n.bound),
            ),
        ]
    columns = (text(phrase("label.figure")), text(phrase("label.value")), text(phrase("label.meaning")))
    return table(columns, zip(*rows, strict=True))


def _diversity(view: View, n: NetworkFigures) -> Figures:
    figures = [
        Figure(
            drawing=ray_histogram(view.rays, phrase("axis.rays_per_point")),
            caption=phrase("report_network.ray_histogram"),
        ),
        Figure(
            drawing=angle_histogram(n, phrase("drawn.intersection_angles")),
            caption=phrase("report_network.angle_histogram"),
        ),
        Figure(drawing=roll_rose(n.roll, phrase("drawn.rolls")), caption=_roll_words(view, n.roll)),
    ]
    scale = n.image_scale[np.isfinite(n.image_scale)]
    if len(scale) > 3:
        spread = float(scale.max() / scale.min()) if scale.min() > 0 else math.nan
        figures.append(
            Figure(
                drawing=histogram(
                    scale,
                    phrase("axis.image_scale"),
                    phrase("drawn.image_scales"),
                    y_label=phrase("label.images"),
                    width=286,
                ),
                caption=phrase("report_network.scale_histogram", ratio=spread),
            )
        )
    if len(n.base_to_depth):
        drawn = histogram(
            n.base_to_depth, phrase("axis.base_to_depth"), phrase("drawn.base_to_depth"), y_label=phrase("label.pairs"),
            width=286, edges=np.append(np.linspace(0, 2, 21), [2.1]),
        )  # fmt: skip
        words = phrase("report_network.ratio_histogram", n=len(n.base_to_depth), most=2)
        figures.append(Figure(drawing=drawn, caption=words))
    return Figures(figures=tuple(figures))


def _roll_words(view: View, roll: Array) -> Text:
    good = np.degrees(roll[np.isfinite(roll)])
    turned = int((np.abs(np.abs(good) - 90) < 30).sum())
    words = note("report_network.roll", n=turned)
    estimated = {s for i in view.adjustment.interior for s in i.free}
    if turned or not estimated & {"x0", "y0", "P1", "P2"}:
        return Text.of(words)
    return Text.of(words, note("report_network.not_rolled"))


def _pairs(view: View, n: NetworkFigures) -> list[Part]:
    count = len(n.base_to_depth)
    if not count:
        return [Paragraph(text=phrase("report_network.no_pairs", least=COMMON), note=True)]
    ids = view.given.images.ids
    order = np.argsort(-n.pair_points, kind="stable")[:MOST_PAIRS]
    cut = [note("report_network.pairs_shown", n=len(order), of=count)] if len(order) < count else []
    body = table(
        (
            text(phrase("label.image")), text(phrase("label.image")), number(phrase("label.common_points")),
            number(phrase("report_network.base_to_depth")),
        ),
        (
            pick(n.pair_images[order, 0], ids), pick(n.pair_images[order, 1], ids),
            [grouped(float(k)) for k in n.pair_points[order]], cells(n.base_to_depth[order].tolist(), 3),
        ),
        note=Text.of(note("report_network.pairs_order"), *cut),
    )  # fmt: skip
    shown = spread_rows(len(order), PRINTED)
    chosen = phrase("report_network.pairs_chosen", n=len(shown), of=count)
    return [Folded(summary=phrase("report_network.image_pairs", n=count), parts=(on_a_page(body, shown, chosen),))]


def _coverage(view: View, n: NetworkFigures) -> list[Part]:
    taken = np.flatnonzero(np.isfinite(n.distance))
    if len(taken) < 2:
        return []
    ids = pick(taken, view.given.images.ids)
    drawn = image_columns(ids, 100 * n.coverage[taken], phrase("axis.coverage"), phrase("drawn.coverage"))
    return [Figures(figures=(Figure(drawing=drawn, caption=phrase("report_network.coverage_of_images")),))]


@chapter("network", after="reliability")
def _network(o: Occasion) -> tuple[Section, ...]:
    return (network_section(with_near_viewpoints(o.view)),)
