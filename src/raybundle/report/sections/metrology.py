"""Sections of `measure`: deviations from nominal coordinates, and errors of known lengths."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

import numpy as np

from raybundle.errors import Text, note, phrase
from raybundle.metrology.best_fit import BestFit
from raybundle.metrology.congruence import Congruence
from raybundle.metrology.lengths import COVERAGE, LengthTest
from raybundle.numerics.arrays import Array
from raybundle.numerics.natural import natural_order
from raybundle.report.chapters import Occasion, chapter
from raybundle.report.figures.displacements import displacement_views, length_errors
from raybundle.report.parts import (
    Fact,
    Facts,
    Figure,
    Figures,
    Paragraph,
    Part,
    Section,
    Statements,
    Table,
    number,
    pick,
    table,
    text,
    whole,
)
from raybundle.report.text.numbers import (
    NONE,
    cells,
    column_decimals,
    grouped,
    per_cent,
    plain,
    probability,
    significant,
)
from raybundle.report.view import FREE_UNIT

MM = 1000.0
MOST_LENGTHS = 500
F = TypeVar("F")


def finding(o: Occasion, kind: type[F]) -> F | None:
    """What a delivery states of a kind; None: nothing."""
    found = () if o.delivery is None else o.delivery.findings
    return next((f for f in found if isinstance(f, kind)), None)


@chapter("displacements", after="result")
def displacements(o: Occasion) -> tuple[Section, ...]:
    """What moved between the dates of one adjustment."""
    from raybundle.report.moved import displacement_section, reported

    done = finding(o, Congruence)
    if done is None:
        return ()
    stated = [Statements(statements=tuple(reported(done)))] if done.reported else []
    unit = (1.0, FREE_UNIT) if o.view.adjustment.free_scale else (MM, "mm")
    return (displacement_section(done, stated, rest="displacements.csv", joint=True, unit=unit),)


@chapter("deviations", after="result")
def deviations(o: Occasion) -> tuple[Section, ...]:
    """Measured against nominal coordinates."""
    fit = finding(o, BestFit)
    if fit is None:
        return ()
    strange = np.asarray(fit.significant, bool)
    views = displacement_views(fit.ids, fit.xyz, fit.deviation, strange, (MM, "mm"), "deviations")
    parts: list[Part] = [
        Facts(facts=_fit_facts(fit)),
        Figures(figures=tuple(Figure(drawing=d, caption=c) for d, c in views)),
        _deviation_table(fit),
    ]
    if fit.missing:
        missing = phrase("report_metrology.not_measured", n=len(fit.missing), names=list(fit.missing))
        parts.append(Paragraph(text=missing, note=True))
    return (Section(anchor="deviations", title=phrase("report_metrology.deviations"), parts=tuple(parts)),)


def _fit_facts(fit: BestFit) -> tuple[Fact, ...]:
    by = int(fit.fitted.sum())
    fitted = phrase(
        "report_metrology.fit", weights=fit.weighting == "covariance", estimated=fit.scale_sigma > 0,
        scale=float(fit.transform.scale), sigma_ppm=1e6 * float(fit.scale_sigma),
    )  # fmt: skip
    facts = [
        Fact(label=phrase("report_metrology.axes"), value=phrase("label.count_of_points", n=by), remark=fitted),
        Fact(
            label=phrase("report_metrology.coordinate_deviation"), value=f"{significant(MM * fit.rms, 2)} mm",
            remark=phrase("report_metrology.coordinate_deviation_meaning"),
        ),
        Fact(
            label=phrase("report_metrology.largest_deviation"),
            value=f"{significant(MM * float(fit.length.max()), 3)} mm",
            remark=phrase("report_metrology.point", name=fit.ids[int(fit.length.argmax())]),
        ),
        Fact(
            label=phrase("report_metrology.significant"), value=grouped(int(fit.significant.sum())),
            remark=phrase("report_metrology.significant_meaning", n=len(fit.ids)),
        ),
    ]  # fmt: skip
    if np.isfinite(fit.tolerance).any():
        verdict = fit.verdict
        counts = [verdict.count(v) for v in ("within", "beyond", "undecided")]
        facts.append(
            Fact(
                label=phrase("report_metrology.tolerances"),
                value=phrase("report_metrology.within", n=counts[0]),
                remark=phrase("report_metrology.beyond", n=counts[1], undecided=counts[2]),
            )
        )  # fmt: skip
    return tuple(facts)


def _deviation_table(fit: BestFit) -> Table:
    order = natural_order(fit.ids)
    std = MM * np.sqrt(np.maximum(np.diagonal(fit.covariance, axis1=1, axis2=2), 0))
    d, fine = MM * fit.deviation, column_decimals(std)
    length, own = MM * fit.length, MM * fit.length_sigma
    verdict, strange = fit.verdict, fit.significant.tolist()
    limited = np.isfinite(fit.tolerance).any()
    columns = [
        whole(phrase("label.point")), text(phrase("report_metrology.fitted")),
        *(number(f"d{a}", "mm") for a in "XYZ"), number(phrase("label.length"), "mm"),
        number(phrase("label.sigma"), "mm"), number("p"),
    ]  # fmt: skip
    values: list[Sequence[str]] = [
        pick(order, fit.ids), [phrase("label.yes") if fit.fitted[k] else "" for k in order],
        *(cells(d[order, k].tolist(), fine) for k in range(3)), cells(length[order].tolist(), fine),
        cells(own[order].tolist(), fine), [probability(float(fit.p_value[k])) for k in order],
    ]  # fmt: skip
    if limited:
        columns += [number(phrase("report_metrology.tolerance"), "mm"), text(phrase("report_metrology.verdict"))]
        values += [
            [plain(MM * float(v)) if np.isfinite(v) else NONE for v in fit.tolerance[order]],
            [phrase("report_metrology.verdict_of", verdict=verdict[k]) if verdict[k] else "" for k in order],
        ]
    remark = Text.of(note("report_metrology.d_note"), note("report_metrology.p_note"), note("report_metrology.marked"))
    marked = [i for i, k in enumerate(order) if strange[k]]
    return table(columns, values, note=remark, rest="nominal.csv", marked=marked)


@chapter("length errors", after="deviations")
def length_chapter(o: Occasion) -> tuple[Section, ...]:
    """Measured against known lengths."""
    test = finding(o, LengthTest)
    if test is None:
        return ()
    known = np.array([k.length for k in test.known])
    strange = np.asarray(test.significant, bool)
    drawn = length_errors(known, MM * test.error, MM * test.error_sigma, strange, MM * test.allowed, coverage=COVERAGE)
    limits = [note("report_metrology.dashed")] if np.isfinite(test.allowed).any() else []
    caption = Text.of(note("report_metrology.length_errors", n=len(known)), *limits)
    parts: list[Part] = [
        Facts(facts=_length_facts(test)),
        Figures(figures=(Figure(drawing=drawn, caption=caption),)),
        _length_table(test, known),
        Paragraph(
            text=Text.of(note("report_metrology.guideline"), note("report_metrology.no_acceptance_test")),
            note=True,
        ),
    ]
    return (Section(anchor="lengths", title=phrase("report_metrology.lengths"), parts=tuple(parts)),)


def _length_facts(test: LengthTest) -> tuple[Fact, ...]:
    F_, p = test.whole
    facts = [
        Fact(
            label=phrase("report_metrology.largest_error"), value=f"{significant(MM * test.largest, 3)} mm",
            remark=_ends(test, int(np.abs(test.error).argmax())),
        ),
        Fact(
            label=phrase("report_metrology.length_error"), value=f"{significant(MM * test.rms, 2)} mm",
            remark=phrase("label.rms"),
        ),
        Fact(
            label=phrase("report_metrology.stated_deviation"),
            value=f"{significant(MM * _rms(test.error_sigma), 2)} mm",
            remark=phrase("report_metrology.stated_deviation_meaning"),
        ),
        Fact(
            label=phrase("report_metrology.within_two"), value=per_cent(test.within),
            remark=phrase("report_metrology.within_two_meaning", f=float(F_), p=float(p)),
        ),
    ]  # fmt: skip
    if test.kept is not None:
        over = int((np.abs(test.error) > test.allowed).sum())
        facts.append(
            Fact(
                label=phrase("report_metrology.allowed_errors"),
                value=phrase("report_metrology.kept", kept=test.kept),
                remark=phrase("report_metrology.over", n=over),
            )
        )
    return tuple(facts)


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _ends(test: LengthTest, k: int) -> str:
    return f"{test.known[k].start} – {test.known[k].end}"


def _length_table(test: LengthTest, known: Array) -> Table:
    fine = column_decimals(MM * test.error_sigma)
    strange = test.significant.tolist()
    columns = [
        whole(phrase("label.from")), whole(phrase("label.to")), number(phrase("label.given"), "m"),
        number(phrase("label.measured"), "m"), number(phrase("label.error"), "mm"),
        number(phrase("label.sigma"), "mm"), number("p"),
    ]  # fmt: skip
    values: list[Sequence[str]] = [
        [k.start for k in test.known], [k.end for k in test.known], cells(known.tolist(), fine + 3),
        cells(test.measured.tolist(), fine + 3), cells((MM * test.error).tolist(), fine),
        cells((MM * test.error_sigma).tolist(), fine), [probability(float(p)) for p in test.p_value],
    ]  # fmt: skip
    if np.isfinite(test.allowed).any():
        columns.append(number(phrase("label.allowed"), "mm"))
        values.append(cells((MM * test.allowed).tolist(), fine))
    marked = [k for k, s in enumerate(strange) if s]
    remark = phrase("report_metrology.marked")
    return table(columns, values, note=remark, rest="lengths.csv", most=MOST_LENGTHS, marked=marked)
