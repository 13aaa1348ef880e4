"""Section: the verdict on a calibration, before any number of it."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from raybundle.calibration.cross_validation import CrossValidation
from raybundle.calibration.quality import CalibrationQuality, Grade
from raybundle.errors import Message, Text, joined_texts, note, phrase
from raybundle.report.chapters import Occasion, chapter
from raybundle.report.parts import Fact, Facts, Heading, Paragraph, Part, Section, Statements, number, table, text
from raybundle.report.text.numbers import NONE, fixed, grouped, per_cent, significant
from raybundle.report.text.words import Grade as ReportGrade

GRADES: dict[Grade, ReportGrade] = {
    "good": "good",
    "usable": "remarks",
    "weak": "attention",
    "not determinable": "attention",
}
ORDER: tuple[Grade, ...] = ("not determinable", "weak", "usable", "good")


def worst(qualities: Sequence[CalibrationQuality]) -> CalibrationQuality:
    """The verdict that stands at the head of a report: the gravest."""
    return min(qualities, key=lambda q: ORDER.index(q.grade))


def graver(grade: ReportGrade, quality: CalibrationQuality) -> ReportGrade:
    """The graver of a report's grade and a calibration's."""
    order: tuple[ReportGrade, ...] = ("attention", "remarks", "good")
    return order[min(order.index(grade), order.index(GRADES[quality.grade]))]


def grade_code(quality: CalibrationQuality) -> str:
    """The grade as a value of phrases."""
    return quality.grade.replace(" ", "_")


def headline(qualities: Sequence[CalibrationQuality]) -> Text:
    """The first sentences of the report."""
    head = worst(qualities)
    if len(qualities) == 1:
        return head.headline
    return joined_texts(phrase("calibration_quality.of_camera", camera=head.camera), head.headline)


def calibration_section(qualities: Sequence[CalibrationQuality]) -> Section:
    """Is the calibration good, for what, and what to photograph next."""
    parts: list[Part] = []
    for q in qualities:
        head = phrase("calibration_quality.camera_grade", camera=q.camera, grade=grade_code(q))
        parts += [Heading(text=head), Paragraph(text=q.headline), Facts(facts=_facts(q))]
        if q.reasons:
            parts.append(table((text(phrase("calibration_quality.weaknesses")),), (list(q.reasons),)))
        parts += _advice(q)
        parts += _couplings(q)
    limits = (
        (phrase("calibration_quality.stability"), phrase("calibration_quality.same_setting")),
        (phrase("calibration_quality.edge"), phrase("calibration_quality.extrapolated")),
    )
    parts += [Heading(text=phrase("calibration_quality.limits")), Statements(statements=limits)]
    return Section(anchor="calibration", title=phrase("calibration_quality.title"), parts=tuple(parts))


def _facts(q: CalibrationQuality) -> tuple[Fact, ...]:
    validation = q.validation
    return (
        Fact(
            label=phrase("label.projection_uncertainty"), value=f"{significant(q.typical_px, 2)} px",
            remark=Text.of(
                note("front.uncertainty", largest_px=q.uncertainty_px),
                note("calibration_quality.largest_error", likely_px=q.likely_px, worst_px=q.worst_px),
            ),
        ),
        Fact(
            label=phrase("label.image_points"), value=f"{significant(q.image_sigma_px, 2)} px",
            remark=phrase("calibration_quality.image_sigma"),
        ),
        Fact(
            label=phrase("label.cross_validation"),
            value=NONE if validation is None else f"{fixed(validation.ratio, 2)} ×",
            remark=phrase("calibration_quality.no_validation") if validation is None else
            Text.of(
                note("calibration_quality.validation", rms_px=validation.rms_px, folds=validation.folds),
                _prediction(validation, unstable=q.unstable),
            ),
        ),
        Fact(
            label=phrase("label.format"), value=per_cent(q.coverage),
            remark=phrase("calibration_quality.covered", reach=q.reach),
        ),
        Fact(
            label=phrase("label.photographs"), value=grouped(q.photographs),
            remark=phrase("calibration_quality.views", rolls=q.rolls, angle_deg=math.degrees(q.convergence)),
        ),
    )  # fmt: skip


def _prediction(validation: CrossValidation, *, unstable: bool) -> Message:
    if validation.contradicts:
        return note("calibration_quality.farther", excess=validation.excess)
    return note("calibration_quality.as_predicted", unstable=unstable)


def _advice(q: CalibrationQuality) -> list[Part]:
    if q.unstable:
        return [Heading(text=phrase("front.next")), Paragraph(text=phrase("calibration_quality.unstable"))]
    if not q.advice:
        return [Paragraph(text=phrase("calibration_quality.no_advice"), note=True)]
    known = bool(np.isfinite(q.uncertainty_px)) and q.grade != "not determinable"
    now = significant(q.uncertainty_px, 2) if known else NONE
    remark = (
        note("calibration_quality.predicted", now_px=q.uncertainty_px) if known
        else note("calibration_quality.predicted_of_open")
    )  # fmt: skip
    return [
        Heading(text=phrase("calibration_quality.photograph_next")),
        table(
            (
                number(""),
                text(phrase("calibration_quality.photographs_in_order")),
                number(phrase("calibration_quality.uncertainty_now"), "px"),
                number(phrase("calibration_quality.uncertainty_then"), "px"),
                number(phrase("calibration_quality.smaller_by")),
            ),
            (
                [grouped(k + 1) for k in range(len(q.advice))],
                [p.words for p in q.advice],
                [now for _ in q.advice],
                [significant(p.uncertainty_px, 2) for p in q.advice],
                [per_cent(1 - p.ratio) if p.ratio > 0 else NONE for p in q.advice],
            ),
            note=Text.of(remark, note("calibration_quality.calibrate_again")),
        ),
    ]


def _couplings(q: CalibrationQuality) -> list[Part]:
    if not q.couplings:
        return []
    station = phrase("calibration_quality.station")
    return [
        table(
            (text(phrase("label.parameter")), text(phrase("calibration_quality.coupled_with")),
             number(phrase("label.correlation"))),
            (
                [a for a, _, _ in q.couplings],
                [station if b == "Z" else b for _, b, _ in q.couplings],
                [fixed(r, 2) for _, _, r in q.couplings],
            ),
            note=phrase("calibration_quality.coupling_effect"),
        )
    ]  # fmt: skip


@chapter("calibration", after="front")
def _calibration(o: Occasion) -> tuple[Section, ...]:
    return (calibration_section(o.qualities),) if o.qualities else ()
