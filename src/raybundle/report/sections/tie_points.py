"""Section: precision of tie points by their number of rays, and residuals over the format."""

from __future__ import annotations

import math

import numpy as np

from raybundle.adjustment.roughness import doubled
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
        return Section(
            anchor="tie-points", title="Tie points", parts=(Paragraph(text="No object point has a used ray."),)
        )
    scale = (
        " The scale is arbitrary: only ratios of these numbers mean anything until a scale bar or control is given."
        if view.arbitrary_scale
        else ""
    )
    parts += [_ray_table(view, size, scale)]
    figures = [Figure(drawing=ray_histogram(view.rays, "rays per point"), caption="Number of rays of each point.")]
    good = np.zeros(0) if size is None else size[np.isfinite(size)]
    if len(good):
        top = float(np.quantile(good, 0.97)) * 1.1
        edges = np.linspace(0, top, 26) if top > 0 else None
        figures.append(
            Figure(
                drawing=histogram(good, f"sigma of a point [{view.unit}]", "precision of points", edges=edges,
                                  y_label="points", width=300),
                caption="Standard deviation of position, √(σX² + σY² + σZ²); the last column holds all larger ones.",
            )
        )  # fmt: skip
    else:
        parts.append(
            Paragraph(text="Standard deviations of points are not known (statistics are off, or all are held).")
        )
    wide, of = doubled(view.adjustment.precision)
    if of:
        parts.append(
            Paragraph(
                text="A tie point is the mean of the surface in its matching window. Its standard deviations contain "
                f"what relief within the window adds; it more than doubles those of {per_cent(wide / of)} of the "
                "points (column roughness of points.csv)."
            )
        )
    profile = radius_profile(view)
    if np.isfinite(profile[1]).any():
        figures.append(Figure(drawing=radius_figure(profile), caption=_radius_words(profile, sigma_px)))
    parts.append(Figures(figures=tuple(figures), small=True))
    return Section(anchor="tie-points", title="Tie points", parts=tuple(parts))


def _radius_words(profile: tuple[Array, Array, Array], sigma_px: float) -> str:
    _, residual, count = profile
    inner, outer = count[:5] > 20, count[5:] > 20
    words = "Residuals of a coordinate against the distance of the image point from the middle of the format."
    if math.isfinite(sigma_px):
        words += f" Over the whole format an image coordinate has a sigma of {significant(sigma_px, 2)} px (rms)."
    if inner.any() and outer.any():
        ratio = float(residual[5:][outer].max() / max(residual[:5][inner].min(), 1e-12))
        if ratio > 2:
            words += (
                f" The largest outside is {significant(ratio, 2)} times the smallest inside: look at the mean "
                "residuals over the format for distortion that the model lacks."
            )
    return words


def _ray_table(view: View, size: Array | None, scale: str) -> Table:
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
    note = (
        f"sigma: standard deviation of position. {per_cent(two)} of the points have 2 rays: for them a wrong match "
        f"along the line of sight stays hidden.{scale}"
    )
    return table(
        (
            text("rays"), number("points"), number("share"), number("median sigma", view.unit),
            number("rms sigma", view.unit),
        ),
        zip(*rows, strict=True),
        note=note,
    )  # fmt: skip
