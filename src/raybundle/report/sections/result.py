"""Section 1 and 2: key figures, warnings with remedies, limits of the numbers, and the summary table."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from raybundle.adjustment.counts import counts
from raybundle.adjustment.network import classed
from raybundle.adjustment.result import Adjustment, Notice, as_told
from raybundle.adjustment.severity import Severity
from raybundle.adjustment.spread import few_hold
from raybundle.numerics.arrays import Array
from raybundle.observations import observation_kinds
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
from raybundle.report.text.numbers import NONE, counted, fixed, grouped, listed, significant, unbroken
from raybundle.report.text.words import Verdict, datum_words, free_std, held_by, not_told, open_datum, relative_words
from raybundle.report.view import View, rms


def result_section(view: View, verdict: Verdict) -> Section:
    """What a client reads."""
    parts: list[Part] = [Facts(facts=_key_figures(view)), Statements(statements=verdict.statements)]
    notices = as_told(view.adjustment.notices)
    if notices:
        parts += [Heading(text="Warnings and remedies"), warnings_table(notices)]
    parts.append(Heading(text="What these numbers do not tell"))
    parts.append(Statements(statements=not_told(view)))
    return Section(anchor="result", title="Result", parts=tuple(parts))


def warnings_table(notices: Sequence[Notice]) -> Table:
    """Notices in full, one a row."""
    rows = [[n.severity.value for n in notices], [unbroken(n.text) for n in notices]]
    marked = [k for k, n in enumerate(notices) if n.severity is Severity.FAULT]
    columns = (text(""), text("what, how much, and what to do"))
    note = (
        "Fault: settle it before the result is used. Caution: part of the result is weaker, or less, than it might "
        "be taken for. Remark: what was done or chosen."
    )
    return table(columns, rows, most=200, rest="result.json", marked=marked, note=note, stays=True)


def _median(std: Array, unit: str) -> str:
    """The median beside the rms, where few points make that."""
    few = few_hold(std)
    if few is None:
        return ""
    return f"; median {significant(few.coordinate, 2)} {unit}: {held_by(few)}"


def _key_figures(view: View) -> tuple[Fact, ...]:
    a, network = view.adjustment, view.adjustment.network
    facts: list[Fact] = []
    if network is not None and math.isfinite(network.relative_precision):
        n = grouped(float(f"{network.relative_precision:.2g}"))
        facts.append(
            Fact(
                label="relative precision",
                value=f"1 : {n}",
                remark=(f"{network.precision_class}; " if classed(view.given) else "") + relative_words(view),
            )
        )
    std = free_std(view)
    if len(std):
        each = ", ".join(f"{axis}\u00a0{significant(rms(std[:, k]), 2)}" for k, axis in enumerate("XYZ"))
        facts.append(
            Fact(
                label="standard deviation of object points",
                value=f"{significant(rms(std), 2)} {view.unit}",
                remark=f"rms of a coordinate; {each}{_median(std, view.unit)}",
            )
        )
    if np.isfinite(view.check_difference).any():
        facts.append(
            Fact(
                label="check points",
                value=f"{significant(rms(view.check_difference) * view.factor, 2)} {view.unit}",
                remark=f"rms difference of a coordinate, {counted(len(view.check_rows), 'point')}",
            )
        )
    sigma0 = significant(a.sigma0) if math.isfinite(a.sigma0) else "none"
    facts.append(Fact(label="σ₀ a posteriori", value=sigma0, remark=f"a priori 1; {_image_sigma(view)}"))
    facts.append(
        Fact(label="redundancy", value=grouped(a.redundancy), remark=f"{grouped(a.observations)} observations")
    )
    return tuple(facts)


def _image_sigma(view: View) -> str:
    """The a-posteriori standard deviation of an image coordinate."""
    std = np.sqrt(view.given.observations.cov_px2[view.used, :2])
    if not len(std):
        return "no image observations"
    px = float(np.median(std)) * view.scale
    return f"an image coordinate {significant(px, 2)} px" + ("" if np.ptp(std) < 1e-3 * px else " (median)")


@section("summary", after="result")
def summary_section(view: View) -> Section:
    """Counts, datum, tests."""
    a = view.adjustment
    rows = [*_counts(view), *_solution(a), *_tests(a)]
    body = table((text("quantity"), Column(label="value", text=True)), zip(*rows, strict=True), stays=True)
    note = Paragraph(text=datum_words(view), note=True)
    return Section(anchor="summary", title="Summary of the adjustment", parts=(body, note))


def _counts(view: View) -> list[tuple[str, str]]:
    a, block = view.adjustment, view.given
    n = counts(a)
    rejected = f", {grouped(n.rejected)} rejected" if n.rejected else ""
    observed = f"{grouped(n.image_observations_used)} took part; {grouped(n.image_observations_given)} given{rejected}"
    rows = [
        ("block", block.name),
        ("cameras", grouped(len(block.cameras))),
        ("images", f"{grouped(n.images_used)} took part; {grouped(n.images_given)} given"),
        ("object points", f"{grouped(n.points_used)} took part; {grouped(n.points_given)} given"),
        ("image observations", observed),
    ]
    for g in a.groups:
        weighted, held = int((g.sigma > 0).sum()), int((g.sigma == 0).sum())
        rows.append((
            observation_kinds[g.kind].quantities,
            f"{grouped(weighted)} observed" + (f", {grouped(held)} held" if held else ""),
        ))  # fmt: skip
    return [
        *rows,
        ("observations", grouped(a.observations)),
        ("unknowns", grouped(a.unknowns)),
        ("datum constraints", grouped(a.constraints)),
        ("redundancy", grouped(a.redundancy)),
    ]


def _solution(a: Adjustment) -> list[tuple[str, str]]:
    residuals = a.given.residuals if a.options.residuals == "as_block" else a.options.residuals
    return [
        ("datum", a.datum),
        ("left open by the observations", listed(open_datum(a.datum_defect), 7) or "nothing"),
        ("residuals refer to", "the corrected image point" if residuals == "corrected" else "the measured image point"),
        (
            "converged",
            f"{'yes' if a.converged else 'no'}, {counted(a.iterations, 'iteration')}, {fixed(a.seconds, 2)} s",
        ),
        (
            "condition of the scaled normal matrix, about (by its smallest pivot, which the order changes)",
            significant(a.condition, 2),
        ),
    ]


def _tests(a: Adjustment) -> list[tuple[str, str]]:
    lower, value, upper = a.global_test
    limits = f"{significant(lower, 5)} … {significant(upper, 5)}"
    if not math.isfinite(lower):
        outcome = "not possible without redundancy"
    elif lower <= value <= upper:
        outcome = f"{limits}: passed"
    else:
        outcome = f"{limits}: failed, {'residuals larger' if value > upper else 'residuals smaller'} than stated"
    return [
        ("σ₀ a priori, a posteriori", f"1, {significant(a.sigma0, 5) if math.isfinite(a.sigma0) else NONE}"),
        ("weighted square sum of residuals", significant(a.weighted_square_sum, 6)),
        ("global test (χ², 95 %, two-sided)", outcome),
        (
            "critical value of |w|, family-wise",
            f"{significant(a.critical_w)} at {fixed(100 * a.options.significance, 0)} %",
        ),
        (
            "critical value of |τ|, family-wise",
            f"{significant(a.critical_tau)} at {fixed(100 * a.options.significance, 0)} %",
        ),
    ]


@chapter("result", after="calibration")
def _result(o: Occasion) -> tuple[Section, ...]:
    return (result_section(o.view, o.told),)
