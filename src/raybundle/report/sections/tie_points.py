"""Section: precision of tie points by their number of rays, and residuals over the format."""

from __future__ import annotations

import math

import numpy as np

from raybundle.adjustment.evaluation.tie_roughness import doubled
from raybundle.errors import Message, Text, note, phrase
from raybundle.numerics.arrays import Array
from raybundle.report.figures.network import ray_histogram
from raybundle.report.figures.photographs import CLASSES, radius_figure, radius_profile, seen_points
from raybundle.report.figures.svg import histogram
from raybundle.report.parts import Figure, Figures, Paragraph, Part, Section, Table, number, table, text
from raybundle.report.text.numbers import grouped, per_cent, significant
from raybundle.report.view import View, rms


def tie_point_section(view: View, sigma_px: float) -> Section:
    """How precise the points are, by their number of rays, and how the residuals change over the format."""
    parts: list[Part] = []
    size = None if view.std is None else np.sqrt((view.std**2).sum(axis=1))
    rays = seen_points(view)
    if not len(rays):
        none = Paragraph(text=phrase("report_tie_points.none"))
        return Section(anchor="tie-points", title=phrase("report_tie_points.title"), parts=(none,))
    scale = [note("report_tie_points.arbitrary_scale")] if view.arbitrary_scale else []
    parts += [_ray_table(view, size, scale)]
    figures = [
        Figure(
            drawing=ray_histogram(view.rays, phrase("axis.rays_per_point")),
            caption=phrase("report_tie_points.ray_histogram"),
        )
    ]
    good = np.zeros(0) if size is None else size[np.isfinite(size)]
    if len(good):
        top = float(np.quantile(good, 0.97)) * 1.1
        edges = np.linspace(0, top, 26) if top > 0 else None
        figures.append(
            Figure(
                drawing=histogram(
                    good, phrase("axis.sigma_of_point", unit=view.unit), phrase("drawn.precision_of_points"),
                    edges=edges, y_label=phrase("label.points"), width=300,
                ),
                caption=phrase("report_tie_points.deviations"),
            )
        )  # fmt: skip
    else:
        parts.append(Paragraph(text=phrase("report_tie_points.no_deviations")))
    wide, of = doubled(view.adjustment.precision)
    if of:
        parts.append(
            Paragraph(
                text=Text.of(note("report_tie_points.relief", share=wide / of), note("report_tie_points.roughness"))
            )
        )
    profile = radius_profile(view)
    if np.isfinite(profile[1]).any():
        figures.append(Figure(drawing=radius_figure(profile), caption=_radius_words(profile, sigma_px)))
    parts.append(Figures(figures=tuple(figures), small=True))
    return Section(anchor="tie-points", title=phrase("report_tie_points.title"), parts=tuple(parts))


def _radius_words(profile: tuple[Array, Array, Array], sigma_px: float) -> Text:
    _, residual, count = profile
    inner, outer = count[:5] > 20, count[5:] > 20
    found = [note("report_tie_points.radius")]
    if math.isfinite(sigma_px):
        found.append(note("report_tie_points.sigma", sigma_px=sigma_px))
    if inner.any() and outer.any():
        ratio = float(residual[5:][outer].max() / max(residual[:5][inner].min(), 1e-12))
        if ratio > 2:
            found.append(note("report_tie_points.outer_residuals", ratio=ratio))
    return Text.of(*found)


def _ray_table(view: View, size: Array | None, scale: list[Message]) -> Table:
    """Points by number of rays, with their precision."""
    rows: list[list[str]] = []
    total = int((view.rays > 0).sum())
    for k, (low, high, words) in enumerate(CLASSES):
        mine = (view.rays > 0) & (view.rays <= high) & ((view.rays >= low) | (k == 0))
        n = int(mine.sum())
        if n:
            sigma = math.nan if size is None else rms(size[mine])
            middle = np.zeros(0) if size is None else size[mine & np.isfinite(size)]
            median = float(np.median(middle)) if len(middle) else math.nan
            rows.append([words, grouped(n), per_cent(n / total), significant(median), significant(sigma)])
    two = int(((view.rays > 0) & (view.rays <= 2)).sum()) / max(total, 1)
    remark = Text.of(note("report_tie_points.sigma_note"), note("report_tie_points.two_rays", share=two), *scale)
    return table(
        (
            text(phrase("label.rays")), number(phrase("label.points")), number(phrase("label.share")),
            number(phrase("report_tie_points.median_sigma"), view.unit),
            number(phrase("report_tie_points.rms_sigma"), view.unit),
        ),
        zip(*rows, strict=True),
        note=remark,
    )  # fmt: skip
