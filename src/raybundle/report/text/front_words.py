"""The first page in words: its title, the verdict, what to do next, what is handed over."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle import words
from raybundle.adjustment.records.notice import Notice, sorted_notices
from raybundle.adjustment.records.severity import POOR_FIT, Severity
from raybundle.calibration.quality import CalibrationQuality
from raybundle.errors import Message, Text, note, phrase
from raybundle.report.chapters import Occasion
from raybundle.report.languages import Localised
from raybundle.report.languages.language import Language
from raybundle.report.sections.calibration import GRADES, grade_code, graver, worst
from raybundle.report.sections.front_lengths import CONTROLLED
from raybundle.report.text.numbers import unbroken
from raybundle.report.text.words import Grade, unsettled
from raybundle.report.view import View, in_unit

MOST_STEPS = 5
FILES = (
    "points.csv", "map.csv", "map_control.csv", "coordinate_list.csv", "nominal.csv", "lengths.csv", "images.csv",
    "displacements.csv", "velocities.csv", "surface_strain.csv", "epochs.json", "animation.gif", "calibration.toml",
    "record.toml", "check.csv", "control.csv", "block", "network.html",
)  # fmt: skip
"""What a client takes, in this order"""


def title_of(o: Occasion) -> str:
    """The title that was given, else what was done."""
    given = "" if o.delivery is None else o.delivery.record.title
    if given:
        return Localised(given)
    return phrase("front.calibration") if o.qualities else phrase("front.adjustment", name=o.view.given.name)


def grade_of(o: Occasion) -> Grade:
    """The grade of the whole: never better than a notice, a calibration or what was asked for."""
    grade = o.reported.grade
    if o.qualities:
        grade = graver(grade if unsettled(o.view) else "good", worst(o.qualities))
    outcomes = () if o.delivery is None else o.delivery.outcomes
    if any(x.kept is False for x in outcomes):
        return "attention"
    cautious = any(n.severity is Severity.WARNING for n in o.view.adjustment.notices)
    if grade == "good" and (cautious or any(x.kept is None for x in outcomes)):
        return "remarks"
    return grade


def not_kept(o: Occasion) -> tuple[Text, ...]:
    """What a headline has to add where something that was asked for is not kept."""
    outcomes = () if o.delivery is None else o.delivery.outcomes
    return tuple(phrase("outcome.not_kept", name=x.name) for x in outcomes if x.kept is False)


def verdict_sentence(o: Occasion) -> Text:
    """Whether the result can be used; never better than the gravest notice."""
    return Text.of(*_verdict(o))


def _verdict(o: Occasion) -> list[Message]:
    a = o.view.adjustment
    faults = sum(1 for n in a.notices if n.severity is Severity.FAULT)
    warnings = sum(1 for n in sorted_notices(a.notices, many=1) if n.severity is Severity.WARNING)
    outcomes = () if o.delivery is None else o.delivery.outcomes
    if faults:
        return [note("front.faults", n=faults)]
    if a.precision is None:
        return [note("front.no_statistics")]
    if a.redundancy == 0:
        return [note("front.no_redundancy")]
    if o.reported.grade == "attention" or a.sigma0 > POOR_FIT:
        return [note("front.contradicting")]
    if o.qualities and GRADES[worst(o.qualities).grade] == "attention":
        return [note("front.calibration_unusable", grade=grade_code(worst(o.qualities)))]
    if any(x.kept is False for x in outcomes):
        return [note("front.not_as_required")]
    found = [note("front.usable", n=warnings)]
    if any(x.kept is None for x in outcomes):
        found.append(note("front.not_judged"))
    elif not o.qualities and not (o.view.accuracy.check.any or o.view.lengths is not None):
        found.append(_scale_only(o.view) or note("front.not_checked"))
    return found


def _scale_only(view: View) -> Message | None:
    """That known lengths agree with each other, where that is all that is checked; None where they do not test."""
    group = next((g for g in view.adjustment.groups if g.kind == "distance"), None)
    if group is None:
        return None
    r = np.nan_to_num(group.redundancy)
    tested = r > CONTROLLED
    if not tested.any():
        return None
    worst = float(np.abs(group.residual[tested] / r[tested]).max()) * view.factor
    return note("front.scale_checked", n=int(tested.sum()), worst=in_unit(worst, view.unit, 2))


def next_steps(o: Occasion) -> tuple[tuple[str, str], ...]:
    """What is to be done next, the gravest first, each after its severity, or "next"; () where nothing is."""
    return _steps(o)[:MOST_STEPS]


def steps_left(o: Occasion) -> int:
    """Faults and warnings that the first page does not name."""
    return max(0, len(_steps(o)) - MOST_STEPS)


def _steps(o: Occasion) -> tuple[tuple[str, str], ...]:
    """Faults, what to photograph next for a calibration, warnings."""
    found = [(n.severity, _step(n, o.language)) for n in sorted_notices(o.view.adjustment.notices, many=1)]
    next_ = [("next", _advice(q, o.language)) for q in o.qualities if q.advice]
    faults, warnings = ([(s.value, w) for s, w in found if s is of] for of in (Severity.FAULT, Severity.WARNING))
    if o.view.adjustment.free_scale and not o.qualities:
        next_.append(("next", Localised(o.language.text(Text.of(note("summary.next_scale"))))))
    return (*faults, *next_, *warnings)


def _step(n: Notice, language: Language) -> Localised:
    """What happened and what to do, in the reader's language; why it matters stands with the warnings."""
    if n.message:
        return Localised(language.text(unbroken(n.text)))
    who = words.Reader(language.code, flags=words.reader().flags)
    also = [note("notice.also", n=len(n.also), names=n.also)] if n.also else []
    parts = [part(m.code, m.values, who) for m in (n.data, *also) for part in (words.headline, words.action)]
    return Localised(unbroken(" ".join(filter(None, parts))))


def _advice(q: CalibrationQuality, language: Language) -> Localised:
    """The first photograph that is proposed for a camera."""
    return Localised(
        language.text(Text.of(note("next_photograph.camera", camera=q.camera), *q.advice[0].words.messages))
    )


def handed_over(files: tuple[str, ...]) -> tuple[tuple[str, Text], ...]:
    """Files and what is in them."""
    return tuple(
        (f"{name}/" if name == "block" else name, phrase("front.file", file_name=Path(name).stem))
        for name in FILES if name in files
    )  # fmt: skip


def taken_words(o: Occasion) -> str:
    """When the photographs were taken; empty where none has a date."""
    if o.photographs is None:
        return ""
    days = sorted({p.taken.split()[0] for p in o.photographs.photographs if p.taken.strip()})
    if not days:
        return ""
    return days[0] if days[0] == days[-1] else f"{days[0]} – {days[-1]}"
