"""The first page in words: its title, the verdict, what to do next, what is handed over."""

from __future__ import annotations

import re
from collections.abc import Sequence

from raybundle.adjustment.result import as_told
from raybundle.adjustment.severity import POOR_FIT, Severity
from raybundle.numerics.counting import counted
from raybundle.report.chapters import Occasion
from raybundle.report.languages import Said
from raybundle.report.sections.calibration import GRADES, graver, worst
from raybundle.report.text.numbers import unbroken
from raybundle.report.text.words import Grade, unsettled

MOST_STEPS = 5
LONG = 200
"""Characters of a step beyond which its middle is left to the warnings"""
_CLAUSE = re.compile(r"(?<=[.;]) (?=\D)")
_REFERS = re.compile(
    r"(if (so|not|it|they)|otherwise|else|then|so|it|its|they|their|this|that|these|those|both|neither|"
    r"wenn (ja|nicht|nein|es|sie)|andernfalls|sonst|dann|so|er|es|sie|ihre?|diese[rs]?|dies|das|beide)\b",
    re.IGNORECASE,
)
"""How a clause begins that means something of one before it"""
FILES = {
    "points.csv": "coordinates of the object points with standard deviations",
    "map.csv": "the same and the stations in the coordinate system",
    "map_control.csv": "control and check points in the coordinate system",
    "coordinate_list.csv": "coordinates of the targets with standard deviations and correlations",
    "nominal.csv": "deviations from nominal coordinates",
    "lengths.csv": "errors of known lengths",
    "images.csv": "orientations of the photographs",
    "calibration.toml": "the calibrated cameras, as other runs take them",
    "record.toml": "the recording sheet",
    "check.csv": "check points",
    "control.csv": "control points",
    "block": "everything, to be adjusted again",
    "network.html": "the network in three dimensions",
}
"""What a client takes, in this order"""


def title_of(o: Occasion) -> str:
    """The title that was given, else what was done."""
    given = "" if o.delivery is None else o.delivery.record.title
    return given or ("Calibration" if o.qualities else f"Adjustment of {o.view.given.name}")


def grade_of(o: Occasion) -> Grade:
    """The grade of the whole: never better than a notice, a calibration or what was asked for."""
    grade = o.told.grade
    if o.qualities:
        grade = graver(grade if unsettled(o.view) else "good", worst(o.qualities))
    outcomes = () if o.delivery is None else o.delivery.outcomes
    if any(x.kept is False for x in outcomes):
        return "attention"
    cautious = any(n.severity is Severity.WARNING for n in o.view.adjustment.notices)
    if grade == "good" and (cautious or any(x.kept is None for x in outcomes)):
        return "remarks"
    return grade


def not_kept(o: Occasion) -> str:
    """What a headline has to add where something that was asked for is not kept; else empty."""
    lost = [x.name for x in (() if o.delivery is None else o.delivery.outcomes) if x.kept is False]
    return f" Not kept: {', '.join(lost)}." if lost else ""


def verdict_sentence(o: Occasion) -> str:
    """Whether the result can be used, in one sentence that is never better than the gravest notice."""
    a = o.view.adjustment
    faults = sum(1 for n in a.notices if n.severity is Severity.FAULT)
    cautions = sum(1 for n in as_told(a.notices, many=1) if n.severity is Severity.WARNING)
    outcomes = () if o.delivery is None else o.delivery.outcomes
    if faults:
        return f"Not to be used yet: {counted(faults, 'matter')} to settle first."
    if a.precision is None:
        return "Not to be relied upon: the statistics were switched off, so that nothing tells how good it is."
    if a.redundancy == 0:
        return "Not to be relied upon: there are no more observations than unknowns, so that nothing checks it."
    if o.told.grade == "attention" or a.sigma0 > POOR_FIT:
        return "Not to be used yet: the observations contradict each other."
    if o.qualities and GRADES[worst(o.qualities).grade] == "attention":
        return f"Not to be used for other photographs: the calibration is {worst(o.qualities).grade}."
    if any(x.kept is False for x in outcomes):
        return "Not as good as was asked for."
    open_ = any(x.kept is None for x in outcomes)
    compared = o.view.accuracy.check.any or o.view.lengths is not None
    rest = ""
    if open_:
        rest = "; whether it is as good as was asked for cannot be judged"
    elif not compared and not o.qualities:
        rest = "; nothing that took no part was compared with it"
    if cautions:
        head = f"Usable with {counted(cautions, 'warning')}"
        return f"{head}: part of it is weaker, or less, than it might be taken for{rest}."
    if rest:
        return f"Usable{rest}."
    return "Usable as it stands."


def next_steps(o: Occasion) -> tuple[tuple[str, str], ...]:
    """What is to be done next, the gravest first, each with how grave it is; () where nothing is."""
    return _steps(o)[:MOST_STEPS]


def steps_left(o: Occasion) -> int:
    """Faults and cautions that the first page does not name."""
    return max(0, len(_steps(o)) - MOST_STEPS)


def _steps(o: Occasion) -> tuple[tuple[str, str], ...]:
    """Faults, what to photograph next for a calibration, cautions."""
    say = o.language.text
    found = [(n.severity, _sentence(say(unbroken(n.text)))) for n in as_told(o.view.adjustment.notices, many=1)]
    next_ = [("next", _sentence(say(f"camera {q.camera}: {q.advice[0].words}"))) for q in o.qualities if q.advice]
    faults, cautions = ([(s.value, w) for s, w in found if s is of] for of in (Severity.FAULT, Severity.WARNING))
    return (*faults, *next_, *cautions)


def handed_over(files: tuple[str, ...]) -> tuple[tuple[str, str], ...]:
    """Files and what is in them."""
    return tuple((f"{name}/" if name == "block" else name, words) for name, words in FILES.items() if name in files)


def taken_words(o: Occasion) -> str:
    """When the photographs were taken, as they say; empty where none does."""
    if o.photographs is None:
        return ""
    days = sorted({p.taken.split()[0] for p in o.photographs.photographs if p.taken.strip()})
    if not days:
        return ""
    return days[0] if days[0] == days[-1] else f"{days[0]} to {days[-1]}"


def _sentence(message: str) -> Said:
    """A notice in short: how it begins, and how it ends, where the remedy stands; in full with the warnings.

    It is in the reader's language already, as half a sentence could not be found in its catalogue.
    """
    clauses = _CLAUSE.split(message)
    if len(message) > LONG and len(clauses) > 2:
        message = _shortened(clauses)
    first = message.partition(" ")[0]
    if first.rstrip(",:;").isalpha() and len(first) > 1:  # names of files and symbols stay as they are
        message = message[:1].upper() + message[1:]
    words = unbroken(message)
    return Said(words if words.endswith(".") else f"{words}.")


def _shortened(clauses: Sequence[str]) -> str:
    """The first clauses of a message and the last ones, from one on that refers to none before it."""
    last = len(clauses) - 1
    while last > 0 and _REFERS.match(clauses[last]):
        last -= 1
    first = 1
    while first < last and len(" ".join(clauses[: first + 1])) <= LONG // 2:
        first += 1
    begin, end, whole = f"{' '.join(clauses[:first]).rstrip('.;:,')} (…)", " ".join(clauses[last:]), " ".join(clauses)
    if first >= last:  # all of them hang together
        return whole if len(whole) <= 2 * LONG else begin
    stop = clauses[last - 1][-1]  # the last clauses are a sentence, or end one
    if len(end) > LONG:  # what refers to a clause goes before it does
        end = f"{clauses[last].rstrip('.;:,')} (…)" if last < len(clauses) - 1 and len(clauses[last]) <= LONG else ""
    return f"{begin}{stop} {end}" if end else begin
