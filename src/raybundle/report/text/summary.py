"""A result in a few lines, as commands print it."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from raybundle.adjustment.check_points import check_differences
from raybundle.adjustment.counts import counts
from raybundle.adjustment.fields import Noise
from raybundle.adjustment.network import classed
from raybundle.adjustment.result import Adjustment, Notice, as_told
from raybundle.adjustment.roughness import doubled
from raybundle.adjustment.spread import few_hold
from raybundle.block import Block
from raybundle.io.photos.start import NOMINAL_PIXEL_MM
from raybundle.numerics.arrays import Array
from raybundle.numerics.counting import counted, grouped, significant
from raybundle.report.text.words import left_out
from raybundle.report.view import length_unit, printed_lengths

SHOWN = 15
"""Notices that are printed."""


def summary_lines(adjustment: Adjustment) -> list[str]:
    """Counts, sigma0, relative precision, check points and warnings, a line each."""
    a = adjustment
    n = counts(a)
    tail = f"; {grouped(n.rejected)} rejected (listed in observations.csv)" if n.rejected else ""
    took_part = (
        (n.images_used, n.images_given, "image"),
        (n.points_used, n.points_given, "object point"),
        (n.image_observations_used, n.image_observations_given, "image observation"),
    )
    lines = [
        ", ".join(counted(u, noun) + (f" (of {grouped(g)})" if g != u else "") for u, g, noun in took_part) + tail,
        f"sigma0 {_sigma0(a)} (a priori {a_priori(a.given)}), redundancy {grouped(a.redundancy)}",
        f"datum: {a.datum}",
    ]
    lines += _precision(a) + noise_lines(a.noise) + _relief(a)
    lines += _check_points(a)
    lines += notice_lines(a.notices)
    return [f" {line}" for line in lines]


def notice_lines(notices: Sequence[Notice]) -> list[str]:
    """Notices with their severity, the gravest first; how many are not shown."""
    found = as_told(notices)
    lines = [line_of(n) for n in found[:SHOWN]]
    if len(found) > SHOWN:
        lines.append(f"and {counted(len(found) - SHOWN, 'more notice')}, see result.json")
    return lines


def line_of(notice: Notice) -> str:
    """A notice with its severity and what happened; its code leads to the rest (`raybundle explain`, the report)."""
    if notice.message:
        return f"{notice.severity.value}: {notice.message}"
    others = f" (+{len(notice.also)})" if notice.also else ""
    return f"{notice.severity.value}: {notice.data.headline()}{others} [{notice.data.code}]"


def _sigma0(a: Adjustment) -> str:
    return f"{a.sigma0:.4g}" if math.isfinite(a.sigma0) else "cannot be estimated"


def a_priori(block: Block) -> str:
    """The standard deviation of an image coordinate as given: "0.30 um = 0.06 px"; the median where they differ.

    In pixels alone where those of no camera have a size: of scenes, and of photographs that do not tell it.
    """
    std = np.sqrt(block.observations.cov_px2[:, :2])
    pixel = np.array([c.pixel_mm for c in block.cameras])[block.images.camera[block.observations.image]]
    px, um = float(np.median(std)), float(np.median(std * pixel * 1000))
    nominal = (NOMINAL_PIXEL_MM, NOMINAL_PIXEL_MM)
    sized = any(not c.is_scene and tuple(c.pixel_mm) != nominal for c in block.cameras)
    lengths = f"{um:.2g} um = " if sized else ""
    return f"{lengths}{px:.2g} px" + ("" if np.ptp(std) <= 1e-3 * px else ", median")


def _precision(a: Adjustment) -> list[str]:
    if a.precision is None:
        return ["no standard deviations (statistics are off)"]
    std: Array = a.precision.object_point_std
    free = np.isfinite(std).all(axis=1) & (std > 0).any(axis=1)
    if not free.any():
        return []
    factor, unit = printed_lengths(a)
    scale = " of a scale that is arbitrary" if a.free_scale else ""
    mean = np.sqrt((std[free] ** 2).mean(axis=0)) * factor
    each = ", ".join(f"{axis} {significant(m)}" for axis, m in zip("XYZ", mean, strict=True))
    lines = [f"standard deviation of object points (rms): {each} {unit}{scale}"]
    if (few := few_hold(std[free])) is not None:
        middle = ", ".join(f"{axis} {significant(m * factor)}" for axis, m in zip("XYZ", few.median, strict=True))
        lines[0] += (
            f"; median {middle} {unit}: {grouped(few.points)} of {counted(few.of, 'point')} "
            f"hold{'s' * (few.points == 1)} {100 * few.share:.0f} % of the variance"
        )
    if a.network is not None and math.isfinite(a.network.relative_precision):
        n = round(float(f"{a.network.relative_precision:.2g}"))
        meaning = f"(mean standard deviation {significant(a.network.mean_std * factor)} {unit} / largest extent "
        meaning += f"{significant(a.network.extent)} {length_unit(a)}{left_out(a.network)})"
        of_class = f"; {a.network.precision_class}" if classed(a.given) else ""
        lines.append(f"relative precision 1 : {grouped(n)} {meaning}{of_class}")
    return lines


def noise_lines(noise: Noise) -> list[str]:
    """What standard deviations rest on, where it is not white noise or was to be something else."""
    if noise.kind == "white":
        return [f"noise taken as white: {noise.reason}"] if noise.reason else []
    ratios = (
        ("the interior orientation", noise.ratio_interior), ("projection centres", noise.ratio_images),
        ("object points", noise.ratio_points),
    )  # fmt: skip
    wider = ", ".join(f"{ratio:.2g} for {what}" for what, ratio in ratios if math.isfinite(ratio))
    parts: list[str] = []
    if noise.tau_px > 0:
        parts.append(f"smooth errors of {noise.tau_px:.2g} px that differ from image to image")
    if noise.focus_px > 0:
        parts.append(f"a focus that wanders by {noise.focus_px:.2g} px")
    parts.append(f"errors that neighbouring points share (variance times {noise.phi:.2g})")
    return [f"standard deviations contain {', '.join(parts)}; times those of white noise (medians): {wider}"]


def _relief(a: Adjustment) -> list[str]:
    """For how many tie points relief within the window counts most."""
    wide, of = doubled(a.precision)
    if not of:
        return []
    return [
        f"standard deviations of {wide / of:.0%} of the tie points are more than doubled by relief in their windows"
    ]


def _check_points(a: Adjustment) -> list[str]:
    check, difference = check_differences(a)
    if not np.isfinite(difference).any():
        return []
    factor, unit = printed_lengths(a)
    rms: list[str] = []
    for axis, column in zip("XYZ", difference.T, strict=True):
        known = column[np.isfinite(column)]
        if len(known):
            rms.append(f"{axis} {significant(float(np.sqrt((known**2).mean())) * factor)}")
    return [f"{counted(len(check), 'check point')}, rms difference: {', '.join(rms)} {unit}"]
