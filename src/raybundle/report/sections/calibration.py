"""Section: the verdict on a calibration, before any number of it."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from raybundle.calibration.cross_validation import CrossValidation
from raybundle.calibration.quality import CalibrationQuality, Grade
from raybundle.errors import Text
from raybundle.report.chapters import Occasion, chapter
from raybundle.report.parts import Fact, Facts, Heading, Paragraph, Part, Section, Statements, number, table, text
from raybundle.report.text.numbers import NONE, fixed, grouped, per_cent, significant
from raybundle.report.text.words import Grade as ReportGrade
from raybundle.settings import option

GRADES: dict[Grade, ReportGrade] = {
    "good": "good",
    "usable": "remarks",
    "weak": "attention",
    "not determinable": "attention",
}
ORDER: tuple[Grade, ...] = ("not determinable", "weak", "usable", "good")

NOT_TOLD = (
    ("Stability", "Zoom, focus, stabilisation and temperature move a lens. Calibrate with the setting that is used."),
    ("Edge of the format", "Beyond the farthest image point distortion is extrapolated, whatever its sigma says."),
)


def worst(qualities: Sequence[CalibrationQuality]) -> CalibrationQuality:
    """The verdict that stands at the head of a report: the gravest."""
    return min(qualities, key=lambda q: ORDER.index(q.grade))


def graver(grade: ReportGrade, quality: CalibrationQuality) -> ReportGrade:
    """The graver of a report's grade and a calibration's."""
    order: tuple[ReportGrade, ...] = ("attention", "remarks", "good")
    return order[min(order.index(grade), order.index(GRADES[quality.grade]))]


def headline(qualities: Sequence[CalibrationQuality]) -> str:
    """The first sentence of the report."""
    head = worst(qualities)
    return head.headline if len(qualities) == 1 else f"Camera {head.camera}: {head.headline}"


def calibration_section(qualities: Sequence[CalibrationQuality]) -> Section:
    """Is the calibration good, for what, and what to photograph next."""
    parts: list[Part] = []
    for q in qualities:
        parts += [Heading(text=f"Camera {q.camera}: {q.grade}"), Paragraph(text=q.headline), Facts(facts=_facts(q))]
        if q.reasons:
            parts.append(table((text("what speaks against it"),), ([_sentence(r) for r in q.reasons],)))
        parts += _advice(q)
        parts += _couplings(q)
    parts += [Heading(text="What this verdict does not tell"), Statements(statements=NOT_TOLD)]
    return Section(anchor="calibration", title="Verdict on the calibration", parts=tuple(parts))


def _facts(q: CalibrationQuality) -> tuple[Fact, ...]:
    validation = q.validation
    return (
        Fact(
            label="uncertainty of projection",
            value=f"{significant(q.typical_px, 2)} px",
            remark=f"median over the format at infinity; {significant(q.uncertainty_px, 2)} px at worst. The largest "
            f"error somewhere in the format: {significant(q.likely_px, 2)} px is to be expected, "
            f"{significant(q.worst_px, 2)} px are not exceeded with 95 % certainty",
        ),
        Fact(
            label="image points", value=f"{significant(q.image_sigma_px, 2)} px",
            remark="standard deviation of a coordinate of median weight, from the residuals",
        ),
        Fact(
            label="cross-validation", value=NONE if validation is None else f"{fixed(validation.ratio, 2)} ×",
            remark="too few photographs" if validation is None else
            f"residuals of photographs left out ({significant(validation.rms_px, 2)} px) against those that took part; "
            f"{validation.folds} folds. {_prediction(validation, unstable=q.unstable)}",
        ),
        Fact(
            label="format", value=per_cent(q.coverage),
            remark=f"covered by image points of all photographs; {per_cent(q.reach)} of the way to the corners reached",
        ),
        Fact(
            label="photographs", value=grouped(q.photographs),
            remark=f"{q.rolls} of 4 quarter turns about the axis; axes within {math.degrees(q.convergence):.0f}° of "
            "their mean",
        ),
    )  # fmt: skip


def _prediction(validation: CrossValidation, *, unstable: bool) -> str:
    if validation.contradicts:
        return f"{fixed(validation.excess, 1)} times as far from their prediction as its covariance explains"
    if unstable:
        return (
            "They lie within the covariance of points and camera, which is as wide as the photographs differ: no proof "
            "that they had one camera"
        )
    return "They lie where the covariance of points and camera predicts them"


def _sentence(words: str) -> str:
    if isinstance(words, Text):
        return words
    first = words.partition(" ")[0]
    symbol = len(first) <= 2 and first not in {"a", "an"}  # c, x0, K1: their case is their meaning
    return f"{words if symbol else words[:1].upper() + words[1:]}."


def _advice(q: CalibrationQuality) -> list[Part]:
    if q.unstable:
        words = (
            "More photographs of a camera that changes between them do not help. Switch autofocus, zoom and "
            "stabilisation off and photograph anew, or calibrate the two groups apart, with the "
            f"{option('own_camera')} named above."
        )
        return [Heading(text="What to do next"), Paragraph(text=words)]
    if not q.advice:
        return [Paragraph(text="No four further photographs would improve it by a tenth.", note=True)]
    now = "not determinable" if not np.isfinite(q.uncertainty_px) or q.grade == "not determinable" else (
        f"{significant(q.uncertainty_px, 2)} px"
    )  # fmt: skip
    return [
        Heading(text="What to photograph next"),
        table(
            (
                text("photographs, in this order"),
                number("uncertainty now", "px"),
                number("then", "px"),
                number("smaller by"),
            ),
            (
                [f"{k + 1}. {p.words}" for k, p in enumerate(q.advice)],
                [NONE if now == "not determinable" else significant(q.uncertainty_px, 2) for _ in q.advice],
                [significant(p.uncertainty_px, 2) for p in q.advice],
                [per_cent(1 - p.ratio) if p.ratio > 0 else NONE for p in q.advice],
            ),
            note=f"Predicted: largest uncertainty of projection over the format, now {now}, with this photograph and "
            "those before it, of the precision of the others. Take them, calibrate again, and look again.",
        ),
    ]


def _couplings(q: CalibrationQuality) -> list[Part]:
    if not q.couplings:
        return []
    names = {"Z": "station along the viewing axis"}
    return [
        table(
            (text("parameter"), text("coupled with"), number("correlation")),
            (
                [a for a, _, _ in q.couplings],
                [names.get(b, b) for _, b, _ in q.couplings],
                [fixed(r, 2) for _, _, r in q.couplings],
            ),
            note="Coupled parameters do no harm to object points measured with the same network; a calibration that is "
            "carried over to other photographs suffers from them.",
        )
    ]


@chapter("calibration", after="front")
def _calibration(o: Occasion) -> tuple[Section, ...]:
    return (calibration_section(o.qualities),) if o.qualities else ()
