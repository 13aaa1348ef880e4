"""Sections: key figures, warnings with remedies, limits of the numbers, and the summary table."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from raybundle.adjustment.evaluation.counts import counts
from raybundle.adjustment.records.notice import Notice, sorted_notices
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.far_points_share import few_hold
from raybundle.adjustment.statistics.network import classed
from raybundle.errors import Message, Text, Value, note, phrase
from raybundle.numerics.arrays import Array
from raybundle.report.chapters import Occasion, chapter, section
from raybundle.report.parts import (
    Column,
    Fact,
    Facts,
    Heading,
    Paragraph,
    Part,
    Section,
    Statements,
    Table,
    table,
    text,
)
from raybundle.report.text.numbers import NONE, grouped, significant, unbroken
from raybundle.report.text.words import (
    Verdict,
    class_of,
    datum_words,
    each_axis,
    free_std,
    held_by,
    limits,
    open_values,
    relative_values,
)
from raybundle.report.view import View, in_unit, rms

NOTHING_OPEN: dict[str, Value] = {"which": "nothing", "parts": []}


def result_section(view: View, verdict: Verdict) -> Section:
    """What a client reads."""
    parts: list[Part] = [Facts(facts=_key_figures(view)), Statements(statements=verdict.statements)]
    notices = sorted_notices(view.adjustment.notices)
    if notices:
        parts += [Heading(text=phrase("result_section.warnings")), warnings_table(notices)]
    parts.append(Heading(text=phrase("result_section.limits")))
    parts.append(Statements(statements=limits(view)))
    return Section(anchor="result", title=phrase("result_section.title"), parts=tuple(parts))


def warnings_table(notices: Sequence[Notice]) -> Table:
    """Notices in full, one a row."""
    severities = [phrase("front.severity", level=n.severity.value) for n in notices]
    marked = [k for k, n in enumerate(notices) if n.severity is Severity.FAULT]
    columns = (text(""), text(phrase("result_section.message")))
    rows = [severities, [unbroken(n.text) for n in notices]]
    remark = phrase("result_section.severities")
    return table(columns, rows, most=200, rest="result.json", marked=marked, note=remark, stays=True)


def _median(std: Array, unit: str) -> list[Message]:
    """The median beside the rms, where few points make that."""
    few = few_hold(std)
    if few is None:
        return []
    return [note("result_section.median", median=few.coordinate, unit=unit), held_by(few)]


def _key_figures(view: View) -> tuple[Fact, ...]:
    a, network = view.adjustment, view.adjustment.network
    facts: list[Fact] = []
    values = relative_values(view)
    if network is not None and values is not None:
        value = f"1\u00a0:\u00a0{grouped(float(str(values['relative'])))}"
        known = [note("verdict.precision_class", name=class_of(network))] if classed(view.given) else []
        remark = Text.of(*known, note("front.quotient", **values))
        facts.append(Fact(label=phrase("label.relative_precision"), value=value, remark=remark))
    std = free_std(view)
    if len(std):
        each = each_axis(std, view.unit)
        facts.append(Fact(
            label=phrase("label.point_standard_deviation"), value=in_unit(rms(std), view.unit, 2),
            remark=Text.of(note("front.std_of_coordinate", median=False), each, *_median(std, view.unit)),
        ))  # fmt: skip
    if np.isfinite(view.check_difference).any():
        facts.append(Fact(
            label=phrase("label.check_points"),
            value=in_unit(rms(view.check_difference) * view.factor, view.unit, 2),
            remark=phrase("result_section.check_rms", n=len(view.check_rows)),
        ))  # fmt: skip
    sigma0 = significant(a.sigma0) if math.isfinite(a.sigma0) else NONE
    facts.append(Fact(label=phrase("result_section.sigma0"), value=sigma0, remark=_image_sigma(view)))
    observed = phrase("result_section.observations", n=a.observations)
    facts.append(Fact(label=phrase("label.redundancy"), value=grouped(a.redundancy), remark=observed))
    return tuple(facts)


def _image_sigma(view: View) -> Text:
    """The a-posteriori standard deviation of an image coordinate."""
    std = np.sqrt(view.given.observations.cov_px2[view.used, :2])
    if not len(std):
        return phrase("result_section.no_image_observations")
    px = float(np.median(std)) * view.scale
    return phrase("result_section.image_sigma", px=px, median=bool(np.ptp(std) >= 1e-3 * px))


@section("summary", after="result")
def summary_section(view: View) -> Section:
    """Counts, datum, tests."""
    a = view.adjustment
    rows = [*_counts(view), *_solution(a), *_tests(a)]
    columns = (text(phrase("label.quantity")), Column(label=phrase("label.value"), text=True))
    body = table(columns, zip(*rows, strict=True), stays=True)
    remark = Paragraph(text=datum_words(view), note=True)
    return Section(anchor="summary", title=phrase("result_section.summary"), parts=(body, remark))


def _counts(view: View) -> list[tuple[str, str]]:
    a, block = view.adjustment, view.given
    n = counts(a)
    rows: list[tuple[str, str]] = [
        (phrase("label.block"), block.name),
        (phrase("label.heading_cameras"), grouped(len(block.cameras))),
        (phrase("label.images"), phrase("result_section.used", used=n.images_used, given=n.images_given, rejected=0)),
        (
            phrase("label.object_points"),
            phrase("result_section.used", used=n.points_used, given=n.points_given, rejected=0),
        ),
        (
            phrase("label.image_observations"),
            phrase(
                "result_section.used", used=n.image_observations_used, given=n.image_observations_given,
                rejected=n.rejected,
            ),
        ),
    ]  # fmt: skip
    for g in a.groups:
        weighted, held = int((g.sigma > 0).sum()), int((g.sigma == 0).sum())
        kind = phrase("result_section.quantities", kind=g.kind)
        rows.append((kind, phrase("result_section.observed", n=weighted, held=held)))
    return [
        *rows,
        (phrase("label.observations"), grouped(a.observations)),
        (phrase("label.unknowns"), grouped(a.unknowns)),
        (phrase("result_section.constraints"), grouped(a.constraints)),
        (phrase("label.redundancy"), grouped(a.redundancy)),
    ]


def _solution(a: Adjustment) -> list[tuple[str, str]]:
    residuals = a.given.residuals if a.options.residuals == "as_block" else a.options.residuals
    open_ = phrase("result_section.open_parts", **(open_values(a.datum_defect) if a.datum_defect else NOTHING_OPEN))
    return [
        (phrase("label.datum"), a.datum),
        (phrase("result_section.not_fixed"), open_),
        (phrase("result_section.residuals"), phrase("result_section.refer_to", corrected=residuals == "corrected")),
        (
            phrase("result_section.convergence"),
            phrase("result_section.converged", converged=a.converged, n=a.iterations, seconds=a.seconds),
        ),
        (phrase("result_section.condition"), significant(a.condition, 2)),
    ]


def _tests(a: Adjustment) -> list[tuple[str, str]]:
    lower, value, upper = a.global_test
    outcome = phrase("result_section.untestable")
    if math.isfinite(lower):
        verdict = "passed" if lower <= value <= upper else "larger" if value > upper else "smaller"
        outcome = phrase("result_section.tested", lower=lower, upper=upper, verdict=verdict)
    sigma0 = significant(a.sigma0, 5) if math.isfinite(a.sigma0) else NONE
    level = a.options.significance
    critical = ((name, float(v)) for name, v in (("w", a.critical_w), ("tau", a.critical_tau)))
    return [
        (phrase("result_section.sigma0_both"), f"1, {sigma0}"),
        (phrase("result_section.square_sum"), significant(a.weighted_square_sum, 6)),
        (phrase("result_section.global_test"), outcome),
        *(
            (
                phrase("result_section.critical", statistic=name),
                phrase("result_section.at_level", critical=v, level=level) if math.isfinite(v) else NONE,
            )
            for name, v in critical
        ),
    ]


@chapter("result", after="calibration")
def _result(o: Occasion) -> tuple[Section, ...]:
    return (result_section(o.view, o.reported),)
