"""Section: every figure of precision and accuracy of the report, with what it is taken over and what it rests on."""

from __future__ import annotations

import math

import numpy as np

from raybundle.adjustment.statistics.network import MANY
from raybundle.errors import Text, note, phrase
from raybundle.numerics.arrays import Array
from raybundle.report.chapters import section
from raybundle.report.parts import Heading, Part, Section, Table, table, text, whole
from raybundle.report.text.metrology_words import MM as LENGTH_MM
from raybundle.report.text.numbers import NONE, grouped, significant
from raybundle.report.text.words import expected_check_std, free_std
from raybundle.report.view import View, in_unit, rms

WHITE, FIELDS, NO_NOISE = "white", "fields", "none"
"""Noise that a figure supposes"""

Row = tuple[str, str, str, str, str]
"""Figure, value, points or lengths that it is taken over, noise that it supposes, meaning"""


@section("accuracy", after="photographs")
def accuracy_section(view: View) -> Section:
    """What each figure of precision and accuracy is taken over, in object space and in the images."""
    object_rows = [*_object_rows(view), *_check_rows(view), *_length_rows(view), *_control_rows(view)]
    parts: list[Part] = []
    if object_rows:
        remark = Text.of(note("report_accuracy.object_note"), note("report_accuracy.all_points"))
        parts += [Heading(text=phrase("report_accuracy.in_object_space")), _table(object_rows, remark)]
    parts += [
        Heading(text=phrase("report_accuracy.in_images")),
        _table(_image_rows(view), phrase("report_accuracy.image_note")),
    ]
    return Section(anchor="accuracy", title=phrase("report_accuracy.title"), parts=tuple(parts))


def _table(rows: list[Row], remark: Text) -> Table:
    columns = (
        text(phrase("label.figure")),
        whole(phrase("label.value")),
        text(phrase("report_accuracy.over")),
        text(phrase("report_accuracy.noise_column")),
        text(phrase("label.meaning")),
    )
    return table(columns, zip(*rows, strict=True), note=remark)


def _row(figure: str, value: str, over: str, noise: str, meaning: str) -> Row:
    return figure, value, over, phrase("report_accuracy.noise", noise=noise), meaning


def noise_of(view: View) -> str:
    """The noise that standard deviations suppose."""
    return WHITE if view.adjustment.noise.kind == "white" else FIELDS


def _over(kind: str, n: int, coordinates: int) -> Text:
    """What a figure is taken over."""
    return phrase("report_accuracy.points", kind=kind, n=n, coordinates=coordinates)


def _object_rows(view: View) -> list[Row]:
    std, network = free_std(view), view.adjustment.network
    if not len(std):
        return []
    good = std[np.isfinite(std)]
    over = _over("object", len(std), len(good))
    noise = noise_of(view)
    related = network is not None and math.isfinite(network.relative_precision)
    mean = network.mean_std * view.factor if network is not None and related else float(good.mean())
    omitted = 1 - network.mean_share if network is not None and related else 0.0
    rows: list[Row] = [
        _row(phrase("report_accuracy.deviation", kind="rms"), in_unit(rms(std), view.unit), over, noise,
             phrase("report_accuracy.deviation_rms")),
        _row(phrase("report_accuracy.deviation", kind="mean"), in_unit(mean, view.unit), over, noise,
             phrase("report_accuracy.deviation_mean", omitted=omitted, related=related)),
        _row(phrase("report_accuracy.deviation", kind="median"), in_unit(float(np.median(good)), view.unit),
             over, noise, phrase("report_accuracy.deviation_median")),
    ]  # fmt: skip
    if network is not None and related:
        n = grouped(float(f"{network.relative_precision:.2g}"))
        cut = bool(np.sum(network.rays > 0) > MANY)
        meaning = phrase("report_accuracy.relative_meaning", extent=network.extent, unit=view.length_unit, cut=cut)
        rows.append(_row(phrase("report_accuracy.relative"), f"1 : {n}", over, noise, meaning))
    return rows


def _check_rows(view: View) -> list[Row]:
    difference = view.check_difference * view.factor
    known = np.isfinite(difference)
    if not known.any():
        return []
    over = _over("check", int(known.any(axis=1).sum()), int(known.sum()))
    size = in_unit(rms(difference), view.unit)
    meaning = phrase("report_accuracy.check_meaning")
    rows = [_row(phrase("report_accuracy.check"), size, over, NO_NOISE, meaning)]
    expected = expected_check_std(view)
    if (known & np.isfinite(expected)).any():
        size = in_unit(rms(np.where(known, expected, math.nan)), view.unit)
        meaning = phrase("report_accuracy.check_expected")
        rows.append(_row(phrase("report_accuracy.expected"), size, over, noise_of(view), meaning))
    return [*rows, *_asprs_rows(view)]


def _length_rows(view: View) -> list[Row]:
    t = view.lengths
    if t is None:
        return []
    over = phrase("report_accuracy.lengths", n=t.independent)
    expected = float(np.sqrt(np.mean(t.error_sigma[t.compared] ** 2)))
    return [
        _row(phrase("report_accuracy.length_error"), f"{significant(LENGTH_MM * t.rms)} mm", over, NO_NOISE,
             phrase("report_accuracy.length_meaning")),
        _row(phrase("report_accuracy.expected"), f"{significant(LENGTH_MM * expected)} mm", over, noise_of(view),
             phrase("report_accuracy.length_expected")),
    ]  # fmt: skip


def _asprs_rows(view: View) -> list[Row]:
    tested = view.accuracy.tested
    if tested is None or view.free_frame:
        return []
    rows: list[Row] = []
    for name, size, count, plan in (
        ("RMSE_H (ASPRS 2024)", tested.rmse_h, tested.horizontal, True),
        ("RMSE_V (ASPRS 2024)", tested.rmse_v, tested.vertical, False),
    ):
        if math.isfinite(size):
            value = in_unit(size * view.factor, view.unit)
            meaning = phrase("report_accuracy.asprs", plan=plan)
            rows.append(_row(name, value, phrase("report_accuracy.check_points", n=count), NO_NOISE, meaning))
    return rows


def _control_rows(view: View) -> list[Row]:
    rows: list[Row] = []
    points = view.accuracy.left_out
    if points.any:
        d = points.difference * view.factor
        over = _over("control", len(d), int(np.isfinite(d).sum()))
        size = in_unit(rms(d), view.unit)
        meaning = phrase("report_accuracy.points_meaning")
        rows.append(_row(phrase("report_accuracy.points_left_out"), size, over, NO_NOISE, meaning))
    found = view.accuracy.coordinates_left_out
    d = np.array([v for _, _, v in found], float)
    known = np.isfinite(d)
    if known.any():
        over = _over("control", len({found[k][0] for k in np.flatnonzero(known)}), int(known.sum()))
        size = in_unit(rms(d[known] * view.factor), view.unit)
        meaning = phrase("report_accuracy.coordinates_meaning")
        rows.append(_row(phrase("report_accuracy.coordinates_left_out"), size, over, NO_NOISE, meaning))
    return rows


def _image_rows(view: View) -> list[Row]:
    observations = view.adjustment.image_observations
    std = np.sqrt(view.given.observations.cov_px2[view.used, :2])
    if not len(std):
        name, over = phrase("report_accuracy.image_coordinate"), phrase("report_accuracy.no_image_point")
        return [_row(name, NONE, over, NO_NOISE, phrase("report_accuracy.not_measured"))]
    over = phrase("report_accuracy.image_observations", n=len(std), coordinates=std.size)
    uniform = float(np.ptp(std)) < 1e-3 * float(np.median(std))
    kind = "one" if uniform else "median"
    median = float(np.median(std))
    stated = phrase("report_accuracy.stated", kind=kind)
    rows = [_row(stated, _px(median), over, WHITE, phrase("report_accuracy.stated_meaning"))]
    if not uniform:
        stated = phrase("report_accuracy.stated", kind="rms")
        rows.append(_row(stated, _px(rms(std)), over, WHITE, phrase("report_accuracy.stated_rms")))
    if math.isfinite(view.adjustment.sigma0) and view.adjustment.redundancy > 0:
        for kind_, size in ((kind, median), *(() if uniform else (("rms", rms(std)),))):
            scaled = phrase("report_accuracy.scaled", kind=kind_)
            meaning = phrase("report_accuracy.by_sigma0", sigma0=view.adjustment.sigma0, kind=kind_)
            rows.append(_row(scaled, _px(size * view.scale), over, WHITE, meaning))
    residual: Array = observations.residuals_px[view.used]
    r = observations.redundancy[view.used]
    known = bool(np.isfinite(r).any())
    meaning = phrase("report_accuracy.residual_meaning", known=known, r=float(np.nanmean(r)) if known else 0.0)
    return [*rows, _row(phrase("report_accuracy.residual"), _px(rms(residual)), over, NO_NOISE, meaning)]


def _px(value: float) -> str:
    return f"{significant(value)} px"
