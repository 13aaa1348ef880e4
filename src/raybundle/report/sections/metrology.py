"""Sections of `measure`: deviations from nominal coordinates, and errors of known lengths."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

import numpy as np

from raybundle.metrology.best_fit import BestFit
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
    counted,
    grouped,
    listed,
    per_cent,
    plain,
    probability,
    significant,
)

MM = 1000.0
MOST_LENGTHS = 500
F = TypeVar("F")

VERDICTS = {"within": "within", "beyond": "beyond", "undecided": "undecided", "": ""}


def _finding(o: Occasion, kind: type[F]) -> F | None:
    found = () if o.delivery is None else o.delivery.findings
    return next((f for f in found if isinstance(f, kind)), None)


@chapter("deviations", after="result")
def deviations(o: Occasion) -> tuple[Section, ...]:
    """Measured against nominal coordinates."""
    fit = _finding(o, BestFit)
    if fit is None:
        return ()
    strange = np.asarray(fit.significant, bool)
    views = displacement_views(fit.ids, fit.xyz, fit.deviation, strange, (MM, "mm"), "deviations from nominal")
    parts: list[Part] = [
        Facts(facts=_fit_facts(fit)),
        Figures(figures=tuple(Figure(drawing=d, caption=c) for d, c in views)),
        _deviation_table(fit),
    ]
    if fit.missing:
        words = f"{counted(len(fit.missing), 'nominal point')} not measured: {listed(fit.missing)}."
        parts.append(Paragraph(text=words, note=True))
    return (Section(anchor="deviations", title="Deviations from nominal coordinates", parts=tuple(parts)),)


def _fit_facts(fit: BestFit) -> tuple[Fact, ...]:
    by = int(fit.fitted.sum())
    how = "their joint covariance" if fit.weighting == "covariance" else "equal weights"
    scale = f"scale {plain(fit.transform.scale, 8)} ± {significant(1e6 * fit.scale_sigma, 2)} ppm" if (
        fit.scale_sigma > 0
    ) else "the scale was kept"  # fmt: skip
    facts = [
        Fact(label="axes fitted by", value=counted(by, "point"), remark=f"{how}; {scale}"),
        Fact(
            label="deviation of a coordinate", value=f"{significant(MM * fit.rms, 2)} mm",
            remark="rms of the points that the axes were fitted by",
        ),
        Fact(
            label="largest deviation", value=f"{significant(MM * float(fit.length.max()), 3)} mm",
            remark=f"point {fit.ids[int(fit.length.argmax())]}",
        ),
        Fact(
            label="not explained by errors of measurement", value=grouped(int(fit.significant.sum())),
            remark=f"of {counted(len(fit.ids), 'point')}, family-wise",
        ),
    ]  # fmt: skip
    if np.isfinite(fit.tolerance).any():
        verdict = fit.verdict
        counts = [verdict.count(v) for v in ("within", "beyond", "undecided")]
        facts.append(
            Fact(
                label="tolerances", value=f"{grouped(counts[0])} within",
                remark=f"{grouped(counts[1])} beyond, {grouped(counts[2])} undecided (ISO 14253-1, two standard "
                "deviations)",
            )
        )  # fmt: skip
    return tuple(facts)


def _deviation_table(fit: BestFit) -> Table:
    order = natural_order(fit.ids)
    std = MM * np.sqrt(np.maximum(np.diagonal(fit.covariance, axis1=1, axis2=2), 0))
    d, fine = MM * fit.deviation, column_decimals(std)
    length, own = MM * fit.length, MM * fit.length_sigma
    verdict, strange = fit.verdict, fit.significant.tolist()
    told = np.isfinite(fit.tolerance).any()
    columns = [
        whole("point"), text("fitted"), *(number(f"d{a}", "mm") for a in "XYZ"), number("length", "mm"),
        number("its sigma", "mm"), number("p"),
    ]  # fmt: skip
    values: list[Sequence[str]] = [
        pick(order, fit.ids), ["yes" if fit.fitted[k] else "" for k in order],
        *(cells(d[order, k].tolist(), fine) for k in range(3)), cells(length[order].tolist(), fine),
        cells(own[order].tolist(), fine), [probability(float(fit.p_value[k])) for k in order],
    ]  # fmt: skip
    if told:
        columns += [number("tolerance", "mm"), text("verdict")]
        values += [
            [plain(MM * float(v)) if np.isfinite(v) else NONE for v in fit.tolerance[order]],
            [VERDICTS[verdict[k]] for k in order],
        ]
    note = (
        "d: measured minus nominal, in nominal axes, errors of the fit contained in sigma. p: probability of a larger "
        "deviation by errors of measurement alone; rows that stand out are significant, family-wise."
    )
    marked = [i for i, k in enumerate(order) if strange[k]]
    return table(columns, values, note=note, rest="nominal.csv", marked=marked)


@chapter("length errors", after="deviations")
def length_chapter(o: Occasion) -> tuple[Section, ...]:
    """Measured against known lengths."""
    test = _finding(o, LengthTest)
    if test is None:
        return ()
    known = np.array([k.length for k in test.known])
    strange = np.asarray(test.significant, bool)
    drawn = length_errors(known, MM * test.error, MM * test.error_sigma, strange, MM * test.allowed, coverage=COVERAGE)
    limits = " Dashed: what is allowed." if np.isfinite(test.allowed).any() else ""
    caption = f"Errors of {counted(len(known), 'length')} with two standard deviations.{limits}"
    parts: list[Part] = [
        Facts(facts=_length_facts(test)),
        Figures(figures=(Figure(drawing=drawn, caption=caption),)),
        _length_table(test, known),
        Paragraph(
            text="Errors are told as the guideline VDI/VDE 2634 part 1 does, against A + K L where that is stated. It "
            "is no acceptance test by that guideline: where lines run through the volume, and how many, is not looked "
            "at, and lengths that were scale bars are no test.",
            note=True,
        ),
    ]
    return (Section(anchor="lengths", title="Errors of known lengths", parts=tuple(parts)),)


def _length_facts(test: LengthTest) -> tuple[Fact, ...]:
    F_, p = test.whole
    facts = [
        Fact(
            label="largest error", value=f"{significant(MM * test.largest, 3)} mm",
            remark=_ends(test, int(np.abs(test.error).argmax())),
        ),
        Fact(label="error of a length", value=f"{significant(MM * test.rms, 2)} mm", remark="rms"),
        Fact(
            label="standard deviation stated", value=f"{significant(MM * _rms(test.error_sigma), 2)} mm",
            remark="rms, that of the known lengths contained",
        ),
        Fact(
            label="within two standard deviations", value=per_cent(test.within),
            remark=f"95 % are to be expected; all together F {significant(F_)}, p {probability(p)}",
        ),
    ]  # fmt: skip
    if test.kept is not None:
        over = int((np.abs(test.error) > test.allowed).sum())
        facts.append(Fact(label="allowed errors", value="kept" if test.kept else "not kept", remark=f"{over} beyond"))
    return tuple(facts)


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _ends(test: LengthTest, k: int) -> str:
    return f"{test.known[k].start} – {test.known[k].end}"


def _length_table(test: LengthTest, known: Array) -> Table:
    fine = column_decimals(MM * test.error_sigma)
    strange = test.significant.tolist()
    columns = [
        whole("from"), whole("to"), number("given", "m"), number("measured", "m"), number("error", "mm"),
        number("sigma", "mm"), number("p"),
    ]  # fmt: skip
    values: list[Sequence[str]] = [
        [k.start for k in test.known], [k.end for k in test.known], cells(known.tolist(), fine + 3),
        cells(test.measured.tolist(), fine + 3), cells((MM * test.error).tolist(), fine),
        cells((MM * test.error_sigma).tolist(), fine), [probability(float(p)) for p in test.p_value],
    ]  # fmt: skip
    if np.isfinite(test.allowed).any():
        columns.append(number("allowed", "mm"))
        values.append(cells((MM * test.allowed).tolist(), fine))
    marked = [k for k, s in enumerate(strange) if s]
    note = "Rows that stand out: errors of measurement do not explain them, family-wise."
    return table(columns, values, note=note, rest="lengths.csv", most=MOST_LENGTHS, marked=marked)
