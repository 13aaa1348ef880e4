"""The report of a congruence test: what moved, by how much, and what could have been found."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from raybundle.adjustment.severity import Severity
from raybundle.io.folders import new_files
from raybundle.metrology.best_fit import BestFit
from raybundle.metrology.congruence import POWER, Congruence
from raybundle.numerics.natural import natural_order
from raybundle.report.arrangement import PartName
from raybundle.report.document import PDF, Document, html
from raybundle.report.figures.displacements import displacement_views
from raybundle.report.languages import ENGLISH, Said
from raybundle.report.languages.language import Language, language_of
from raybundle.report.languages.setting import section_in
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
    cells,
    column_decimals,
    counted,
    grouped,
    listed,
    per_cent,
    probability,
    significant,
)
from raybundle.results.record import Record

MM = 1000.0
MOST_FAULTS = 3
"""Faults of a measurement that are quoted"""


@dataclass(frozen=True, slots=True, kw_only=True)
class MovedFacts:
    """What a report of a congruence test says beside the test."""

    record: Record = field(default_factory=Record)
    faults: Mapping[str, Sequence[str]] = field(default_factory=dict[str, Sequence[str]])
    """of measurements whose own results are not to be used yet, by their names: what they state"""
    axes: str = ""
    """in which axes it stands, in words; empty: in those of the first epoch"""


def axes_told(file: str, fit: BestFit) -> str:
    """In which axes displacements stand, in words."""
    by = counted(int(fit.fitted.sum()), "point")
    return f"the axes of {file}, fitted by {by} with {significant(MM * fit.rms, 2)} mm rms"


def write_moved_report(
    done: Congruence, paths: Sequence[Path], language: str = ENGLISH, about: MovedFacts | None = None
) -> None:
    """Write the report of a congruence test, a page or a PDF as the names of the files say."""
    about = about or MovedFacts()
    names = [*done.ids, *done.epochs, *about.record.as_mapping().values()]
    document = _document(done, about, language_of(language, names))
    with new_files(*paths) as files:
        for path, file in zip(paths, files, strict=True):
            if path.suffix.lower() == PDF:
                from raybundle.report.paper.press import pdf_of  # noqa: PLC0415  (typst only where it is used)

                file.write_bytes(pdf_of(document))
            else:
                file.write_text(html(document), encoding="utf-8")


def _document(done: Congruence, about: MovedFacts, language: Language) -> Document:
    moved = np.flatnonzero(done.moved)
    names = [done.ids[k] for k in moved]
    what = f"{listed(names)} moved" if len(moved) else "No point moved"
    told = (
        f"{what}: {len(moved)} of {counted(len(done.ids), 'common point')}, at {per_cent(done.significance)} for any "
        "false alarm."
    )
    doubtful = done.after[1] < done.significance
    wrong = any(n.severity is Severity.FAULT for n in done.told)
    if wrong:
        told += " But the measurements contradict each other; see below."
    if doubtful:
        told += (
            " But points that stayed differ by more than their standard deviations say, which would have to be "
            f"{_factor(done)} times as large (F {significant(done.after[0])}, p {probability(done.after[1])})."
        )
    if about.faults:
        told += f" But {listed(list(about.faults))}: not to be used yet, by the own report; see below."
    grave = doubtful or wrong or bool(about.faults)
    made: list[tuple[PartName, Section]] = [
        ("client", section_in(_result(done, about, language), language)),
        ("specialist", section_in(_tests(done), language)),
    ]  # fmt: skip
    say = language.text
    return Document(
        title=about.record.title or say(f"What has moved: {' – '.join(done.epochs)}"),
        subtitle=say("Congruence test over common points, in the datum of those that stayed"),
        headline=say(told), grade="attention" if grave else "remarks" if len(moved) else "good",
        made=tuple(made), divided=False, language=language,
    )  # fmt: skip


def _factor(done: Congruence) -> str:
    """By how much larger standard deviations would explain the points that stayed: the root of their variance ratio."""
    return significant(float(np.sqrt(done.after[0])), 3)


def _result(done: Congruence, about: MovedFacts, language: Language) -> Section:
    largest = np.linalg.norm(done.displacement, axis=2)
    epoch = largest.argmax(axis=0)
    d = done.displacement[epoch, np.arange(len(done.ids))]
    moved = np.asarray(done.moved, bool)
    views = displacement_views(done.ids, done.xyz, d, moved, (MM, "mm"), "displacements")
    least = MM * np.quantile(done.detectable[np.isfinite(done.detectable)], [0.5, 1.0])
    facts = (
        Fact(label="points that moved", value=grouped(int(moved.sum())), remark=f"of {grouped(len(done.ids))}"),
        Fact(
            label="largest displacement", value=f"{significant(MM * float(largest.max()), 3)} mm",
            remark=f"point {done.ids[int(largest.max(axis=0).argmax())]}",
        ),
        Fact(
            label="found from", value=f"{significant(least[0], 2)} mm",
            remark=f"with a probability of {per_cent(POWER)}, median; {significant(least[1], 2)} mm at the worst point",
        ),
    )  # fmt: skip
    axes = about.axes or f"the axes of {done.epochs[0]}"
    faults = [(name, m) for name, messages in about.faults.items() for m in list(messages)[:MOST_FAULTS]]
    stated = [
        *((n.severity.value, n.text) for n in done.told),
        *(("fault", Said(f"{name}: {language.text(m)}")) for name, m in faults), ("Client", about.record.client),
        ("Operator", about.record.operator), ("Measurements", " – ".join(done.epochs)), ("Axes", axes),
    ]  # fmt: skip
    parts: list[Part] = [
        Statements(statements=tuple((word, words) for word, words in stated if words)), Facts(facts=facts),
        Figures(figures=tuple(Figure(drawing=x, caption=c) for x, c in views)),
        *(_points(done, k) for k in range(len(done.displacement))),
    ]  # fmt: skip
    return Section(anchor="moved", title="Displacements", parts=tuple(parts))


def _points(done: Congruence, k: int) -> Table:
    std = MM * np.sqrt(np.maximum(np.diagonal(done.covariance[k], axis1=1, axis2=2), 0))
    order = np.array(natural_order(done.ids))
    d, fine = MM * done.displacement[k], column_decimals(std)
    return table(
        (
            whole("point"), text("moved"), *(number(f"d{a}", "mm") for a in "XYZ"),
            *(number(f"sigma d{a}", "mm") for a in "XYZ"), number("length", "mm"), number("p"),
            number("found from", "mm"),
        ),
        (
            pick(order, done.ids), ["moved" if done.moved[i] else "" for i in order],
            *(cells(d[order, a].tolist(), fine) for a in range(3)),
            *(cells(std[order, a].tolist(), fine) for a in range(3)),
            cells(np.linalg.norm(d[order], axis=1).tolist(), fine),
            [probability(float(done.p_value[i])) for i in order], cells((MM * done.detectable[order]).tolist(), fine),
        ),
        caption=f"{done.epochs[k + 1]} against {done.epochs[0]}",
        note="p: probability of a larger displacement by errors of measurement alone, of this point alone.",
        rest="points.csv", marked=[i for i, j in enumerate(order) if done.moved[j]],
    )  # fmt: skip


def _tests(done: Congruence) -> Section:
    (F0, p0), (F1, p1) = done.before, done.after
    rows = (
        ("all points, as if none had moved", significant(F0), probability(p0)),
        ("points that stayed", significant(F1), probability(p1)),
    )
    body = table((text("global test"), number("F"), number("p")), zip(*rows, strict=True))
    freedom = f"{grouped(done.freedom)} degrees of freedom." if np.isfinite(done.freedom) else "no uncertainty."
    words = [
        (
            f"Points moved where their probability is below {significant(done.limit, 2)} (the significance over the "
            f"number of points). The variance factor has {freedom}"
        ),
        "Epochs may differ in scale: lengths are those of the first." if done.scale else "The scale of each epoch is "
        "the one that it measured.",
        "What the test does not tell: a motion that all points share, and one below what can be found.",
    ]  # fmt: skip
    parts: list[Part] = [body, *(Paragraph(text=w, note=True) for w in words)]
    return Section(anchor="tests", title="Tests", parts=tuple(parts))
