"""The report of a congruence test: what moved, by how much, and what could have been found."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from raybundle.adjustment.records.severity import Severity
from raybundle.errors import Text, note, phrase
from raybundle.io.folders import new_files
from raybundle.metrology.best_fit import BestFit
from raybundle.metrology.congruence import Congruence
from raybundle.metrology.congruence_model import POWER
from raybundle.numerics.natural import natural_order
from raybundle.report.arrangement import PartName
from raybundle.report.document import PDF, Document, html
from raybundle.report.figures.displacements import displacement_views
from raybundle.report.languages import ENGLISH, Localised
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
    grouped,
    probability,
    significant,
)
from raybundle.results.record import Record

MM = 1000.0
MOST_FAULTS = 3
"""Faults of a measurement that are quoted"""


@dataclass(frozen=True, slots=True, kw_only=True)
class MovedFacts:
    """What a report of a congruence test states beside the test."""

    record: Record = field(default_factory=Record)
    faults: Mapping[str, Sequence[str]] = field(default_factory=dict[str, Sequence[str]])
    """of measurements whose own results are not to be used yet, by their names: what they state"""
    axes: str = ""
    """in which axes it stands, in words; empty: in those of the first epoch"""


def axes_words(file: str, fit: BestFit) -> str:
    """In which axes displacements stand, in words."""
    return phrase("report_moved.axes_fitted", name=file, n=int(fit.fitted.sum()), rms_mm=MM * fit.rms)


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
                from raybundle.report.paper.press import pdf_of

                file.write_bytes(pdf_of(document))
            else:
                file.write_text(html(document), encoding="utf-8")


def _document(done: Congruence, about: MovedFacts, language: Language) -> Document:
    moved = np.flatnonzero(done.moved)
    of = len(done.ids)
    head = [
        note(
            "report_moved.moved", names=[done.ids[k] for k in moved], n=len(moved), of=of,
            significance=done.significance,
        )
        if len(moved) else note("report_moved.none_moved", of=of, significance=done.significance)
    ]  # fmt: skip
    doubtful = done.after[1] < done.significance
    wrong = any(n.severity is Severity.FAULT for n in done.reported)
    if wrong:
        head.append(note("report_moved.contradiction"))
    if doubtful:
        f, p = done.after
        head.append(note("report_moved.inconsistent", f=f, p=p, factor=float(np.sqrt(f))))
    if about.faults:
        head.append(note("report_moved.faulty", names=list(about.faults)))
    grave = doubtful or wrong or bool(about.faults)
    made: list[tuple[PartName, Section]] = [
        ("client", section_in(_result(done, about, language), language)),
        ("specialist", section_in(_tests(done), language)),
    ]  # fmt: skip
    say = language.text
    return Document(
        title=about.record.title or say(phrase("report_moved.title", epochs=list(done.epochs))),
        subtitle=say(phrase("report_moved.subtitle")),
        headline=say(Text.of(*head)), grade="attention" if grave else "remarks" if len(moved) else "good",
        made=tuple(made), divided=False, language=language,
    )  # fmt: skip


def displacement_section(
    done: Congruence,
    stated: Sequence[Part] = (),
    rest: str = "points.csv",
    *,
    joint: bool = False,
    unit: tuple[float, str] = (MM, "mm"),
) -> Section:
    """What moved, by how much, and what could have been found.

    rest  the file of all displacements
    unit  factor from that of the block, and name, of displacements
    """
    size, name = unit
    largest = np.linalg.norm(done.displacement, axis=2)
    epoch = largest.argmax(axis=0)
    d = done.displacement[epoch, np.arange(len(done.ids))]
    moved = np.asarray(done.moved, bool)
    untested = ~moved & ~done.stayed
    views = displacement_views(done.ids, done.xyz, d, moved, unit, "displacements")
    least = size * np.quantile(done.detectable[np.isfinite(done.detectable)], [0.5, 1.0])
    facts = (
        Fact(
            label=phrase("report_moved.points_moved"), value=grouped(int(moved.sum())),
            remark=phrase("report_moved.of_joint" if joint else "report_moved.of_points", n=len(done.ids)),
        ),
        *(
            (Fact(label=phrase("report_moved.untested"), value=grouped(int(untested.sum())),
                  remark=phrase("report_moved.untested_why")),)
            if untested.any() else ()
        ),
        Fact(
            label=phrase("report_moved.largest"), value=f"{significant(size * float(largest.max()), 3)} {name}",
            remark=phrase("report_moved.at_point", name=done.ids[int(largest.max(axis=0).argmax())]),
        ),
        Fact(
            label=phrase("report_moved.detectable"), value=f"{significant(least[0], 2)} {name}",
            remark=phrase("report_moved.power", power=POWER, worst=least[1], unit=name),
        ),
    )  # fmt: skip
    parts: list[Part] = [
        *stated, Facts(facts=facts), Figures(figures=tuple(Figure(drawing=x, caption=c) for x, c in views)),
        *(_points(done, k, rest, unit) for k in range(len(done.displacement))),
    ]  # fmt: skip
    return Section(anchor="moved", title=phrase("report_moved.displacements"), parts=tuple(parts))


def reported(done: Congruence) -> list[tuple[Text, str]]:
    """What the test states, with its severity."""
    return [(phrase("front.severity", level=n.severity.value), n.text) for n in done.reported]


def _result(done: Congruence, about: MovedFacts, language: Language) -> Section:
    axes = about.axes or phrase("report_moved.axes_of", name=done.epochs[0])
    faults = [(name, m) for name, messages in about.faults.items() for m in list(messages)[:MOST_FAULTS]]
    stated = [
        *reported(done),
        *(
            (phrase("front.severity", level="fault"), Localised(f"{name}: {language.text(m)}")) for name, m in faults
        ),
        (phrase("front.client"), about.record.client), (phrase("front.operator"), about.record.operator),
        (phrase("report_moved.measurements"), " – ".join(done.epochs)), (phrase("report_moved.axes"), axes),
    ]  # fmt: skip
    return displacement_section(done, [Statements(statements=tuple((word, words) for word, words in stated if words))])


def _points(done: Congruence, k: int, rest: str, unit: tuple[float, str]) -> Table:
    size, name = unit
    std = size * np.sqrt(np.maximum(np.diagonal(done.covariance[k], axis1=1, axis2=2), 0))
    order = np.array(natural_order(done.ids))
    d, fine = size * done.displacement[k], column_decimals(std)
    words, untested = ("", phrase("label.yes"), phrase("report_moved.untested")), ~done.moved & ~done.stayed
    return table(
        (
            whole(phrase("label.point")), text(phrase("report_moved.column_moved")),
            *(number(f"d{a}", name) for a in "XYZ"),
            *(number(phrase("label.sigma_of", symbol=f"d{a}"), name) for a in "XYZ"),
            number(phrase("label.length"), name), number("p"), number(phrase("report_moved.detectable"), name),
        ),
        (
            pick(order, done.ids), [words[int(done.moved[i]) + 2 * int(untested[i])] for i in order],
            *(cells(d[order, a].tolist(), fine) for a in range(3)),
            *(cells(std[order, a].tolist(), fine) for a in range(3)),
            cells(np.linalg.norm(d[order], axis=1).tolist(), fine),
            [probability(float(done.p_value[i])) for i in order], cells((size * done.detectable[order]).tolist(), fine),
        ),
        caption=phrase("report_moved.difference", epoch=done.epochs[k + 1], first=done.epochs[0]),
        note=phrase("report_moved.p_meaning"),
        rest=rest, marked=[i for i, j in enumerate(order) if done.moved[j]],
    )  # fmt: skip


def _tests(done: Congruence) -> Section:
    (F0, p0), (F1, p1) = done.before, done.after
    rows = (
        (phrase("report_moved.all_points"), significant(F0), probability(p0)),
        (phrase("report_moved.stable_points"), significant(F1), probability(p1)),
    )
    body = table((text(phrase("report_moved.global_test")), number("F"), number("p")), zip(*rows, strict=True))
    known = bool(np.isfinite(done.freedom))
    words = [
        phrase("report_moved.limit", limit=done.limit),
        phrase("report_moved.freedom", known=known, n=done.freedom if known else 0.0),
        phrase("report_moved.scale", free=done.scale), phrase("report_moved.limits"),
    ]  # fmt: skip
    parts: list[Part] = [body, *(Paragraph(text=w, note=True) for w in words)]
    return Section(anchor="tests", title=phrase("report_moved.tests"), parts=tuple(parts))
