"""Section: every figure of precision and accuracy of the report, with what it is taken over and what it rests on."""

from __future__ import annotations

import math

import numpy as np

from raybundle.adjustment.network import MANY
from raybundle.numerics.arrays import Array
from raybundle.report.chapters import section
from raybundle.report.parts import Heading, Part, Section, Table, table, text, whole
from raybundle.report.text.metrology_words import MM as LENGTH_MM
from raybundle.report.text.numbers import counted, grouped, significant
from raybundle.report.text.words import expected_check_std, free_std, left_out
from raybundle.report.view import View, rms

WHITE, FIELDS, NO_NOISE = "independent errors", "independent and smooth errors", "none: differences"
COLUMNS = (text("figure"), whole("value"), text("over"), text("noise"), text("what it means"))

Row = tuple[str, str, str, str, str]
"""Figure, value, what it is taken over, noise that it supposes, meaning."""


@section("accuracy", after="photographs")
def accuracy_section(view: View) -> Section:
    """What each figure of precision and accuracy is taken over, in object space and in the images."""
    object_rows = [*_object_rows(view), *_check_rows(view), *_length_rows(view), *_control_rows(view)]
    parts: list[Part] = []
    if object_rows:
        note = (
            "Standard deviations tell how far random errors go, differences at check points how far the result is "
            "off. All object points are the same set wherever this report says so: those that took part and have a "
            "free coordinate."
        )
        parts += [Heading(text="In object space"), _told(object_rows, note)]
    note = (
        "Stated times σ₀ is the precision of a measurement; its residual is smaller, as the adjustment takes up the "
        "share 1\u00a0−\u00a0r of each error (r: mean redundancy number)."
    )
    parts += [Heading(text="In the images"), _told(_image_rows(view), note)]
    return Section(anchor="accuracy", title="Accuracy: what each figure rests on", parts=tuple(parts))


def _told(rows: list[Row], note: str) -> Table:
    return table(COLUMNS, zip(*rows, strict=True), note=note)


def noise_of(view: View) -> str:
    """The noise that standard deviations suppose, in words."""
    return WHITE if view.adjustment.noise.kind == "white" else FIELDS


def _object_rows(view: View) -> list[Row]:
    std, network = free_std(view), view.adjustment.network
    if not len(std):
        return []
    over = f"{counted(len(std), 'object point')}, {grouped(int(np.isfinite(std).sum()))} coordinates"
    good = std[np.isfinite(std)]
    noise = noise_of(view)
    mean, of_which = float(good.mean()), "of a coordinate"
    if network is not None and math.isfinite(network.relative_precision):
        few = left_out(network)
        mean, of_which = network.mean_std * view.factor, f"of a coordinate{few}; that of 1 : N"
    rows: list[Row] = [
        ("standard deviation, rms", f"{significant(rms(std))} {view.unit}", over, noise,
         "of a coordinate; a few weak points enlarge it"),
        ("standard deviation, mean", f"{significant(mean)} {view.unit}", over, noise, of_which),
        ("standard deviation, median", f"{significant(float(np.median(good)))} {view.unit}", over, noise,
         "half of the coordinates are more precise"),
    ]  # fmt: skip
    if network is not None and math.isfinite(network.relative_precision):
        n = grouped(float(f"{network.relative_precision:.2g}"))
        outer = ", without the outermost 0.25 % at either end of an axis" if np.sum(network.rays > 0) > MANY else ""
        extent = f"{significant(network.extent)} {view.length_unit}"
        words = (
            f"mean standard deviation over the largest extent, {extent}: the diagonal of the box along the principal "
            f"axes{outer}"
        )
        rows.append(("relative precision", f"1 : {n}", over, noise, words))
    return rows


def _check_rows(view: View) -> list[Row]:
    difference = view.check_difference * view.factor
    known = np.isfinite(difference)
    if not known.any():
        return []
    points = int(known.any(axis=1).sum())
    over = f"{counted(points, 'check point')}, {grouped(int(known.sum()))} coordinates"
    rows: list[Row] = [
        ("difference at check points, rms", f"{significant(rms(difference))} {view.unit}", over, NO_NOISE,
         "adjusted minus given; holds the errors of the given coordinates, and those that all photographs share"),
    ]  # fmt: skip
    expected = expected_check_std(view)
    if (known & np.isfinite(expected)).any():
        size = rms(np.where(known, expected, math.nan))
        rows.append((
            "what is expected of it", f"{significant(size)} {view.unit}", over, noise_of(view),
            "standard deviation of adjusted and given coordinate together, of these points alone",
        ))  # fmt: skip
    return [*rows, *_asprs_rows(view)]


def _length_rows(view: View) -> list[Row]:
    t = view.lengths
    if t is None:
        return []
    over = counted(t.independent, "length")
    expected = float(np.sqrt(np.mean(t.error_sigma[t.compared] ** 2)))
    return [
        ("error of known lengths, rms", f"{significant(LENGTH_MM * t.rms)} mm", over, NO_NOISE,
         "measured minus known, of lengths that took no part; holds the errors of their certificates"),
        ("what is expected of it", f"{significant(LENGTH_MM * expected)} mm", over, noise_of(view),
         "standard deviation of measured and known length together"),
    ]  # fmt: skip


def _asprs_rows(view: View) -> list[Row]:
    told = view.accuracy.tested
    if told is None or view.free_frame:
        return []
    rows: list[Row] = []
    for name, size, count, words in (
        ("RMSE_H (ASPRS 2024)", told.rmse_h, told.horizontal, "both axes of the plan together"),
        ("RMSE_V (ASPRS 2024)", told.rmse_v, told.vertical, "height"),
    ):
        if math.isfinite(size):
            value = f"{significant(size * view.factor)} {view.unit}"
            meaning = f"{words}: difference at check points, with the stated error of these added"
            rows.append((name, value, counted(count, "check point"), NO_NOISE, meaning))
    return rows


def _control_rows(view: View) -> list[Row]:
    rows: list[Row] = []
    whole = view.accuracy.left_out
    if whole.any:
        d = whole.difference * view.factor
        over = f"{counted(len(d), 'control point')}, {grouped(int(np.isfinite(d).sum()))} coordinates"
        words = "leave-one-out: adjusted minus given had the whole point taken no part, to first order"
        rows.append(("control points left out, rms", f"{significant(rms(d))} {view.unit}", over, NO_NOISE, words))
    told = view.accuracy.coordinates_left_out
    d = np.array([v for _, _, v in told], float)
    known = np.isfinite(d)
    if known.any():
        points = len({told[k][0] for k in np.flatnonzero(known)})
        over = f"{counted(points, 'control point')}, {grouped(int(known.sum()))} coordinates"
        words = "the same of one coordinate at a time, the others of its point taking part"
        name, size = "control coordinates left out, rms", f"{significant(rms(d[known] * view.factor))} {view.unit}"
        rows.append((name, size, over, NO_NOISE, words))
    return rows


def _image_rows(view: View) -> list[Row]:
    observations = view.adjustment.image_observations
    std = np.sqrt(view.given.observations.cov_px2[view.used, :2])
    if not len(std):
        return [("image coordinate", "none", "no image point", NO_NOISE, "nothing was measured in images")]
    over = f"{counted(len(std), 'image observation')} that took part, {grouped(std.size)} coordinates"
    uniform = float(np.ptp(std)) < 1e-3 * float(np.median(std))
    rows: list[Row] = [
        (f"stated{'' if uniform else ', median'}", _px(float(np.median(std))), over, WHITE,
         "what each was given with (its weight)")
    ]  # fmt: skip
    if not uniform:
        rows.append(("stated, rms", _px(rms(std)), over, WHITE, "the less precise points count more"))
    if math.isfinite(view.adjustment.sigma0) and view.adjustment.redundancy > 0:
        which = "" if uniform else ", median"
        scaled = float(np.median(std)) * view.scale
        rows.append((f"stated times σ₀{which}", _px(scaled), over, WHITE, _by_sigma0(view)))
        if not uniform:
            rows.append(
                (
                    "stated times σ₀, rms",
                    _px(rms(std) * view.scale),
                    over,
                    WHITE,
                    f"{_by_sigma0(view)}; that of a measured image point",
                )
            )
    residual: Array = observations.residuals_px[view.used]
    r = observations.redundancy[view.used]
    share = f", mean redundancy number {significant(float(np.nanmean(r)), 2)}" if np.isfinite(r).any() else ""
    words = f"adjusted minus measured{share}"
    return [*rows, ("residual, rms", _px(rms(residual)), over, NO_NOISE, words)]


def _by_sigma0(view: View) -> str:
    return f"what the residuals say of it: σ₀ = {significant(view.adjustment.sigma0)}"


def _px(value: float) -> str:
    return f"{significant(value)} px"
