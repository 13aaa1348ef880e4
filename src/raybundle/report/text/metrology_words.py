"""Whether tolerances and permissible errors of lengths are kept, in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raybundle.errors import Message, Text, note
from raybundle.metrology.best_fit import BestFit
from raybundle.metrology.lengths import LengthTest
from raybundle.report.outcome import Outcome

MM = 1000.0
NAMED = 5
"""Points beyond their tolerance that an outcome names"""


def outcomes(fit: BestFit | None, lengths: LengthTest | None) -> tuple[Outcome, ...]:
    """What was asked for of a measurement, and whether it is kept."""
    found: list[Outcome] = []
    if fit is not None and np.isfinite(fit.tolerance).any():
        beyond, undecided = (fit.verdict.count(v) for v in ("beyond", "undecided"))
        kept = False if beyond else None if undecided else True
        found.append(Outcome(name="tolerances", kept=kept, sentence=Text.of(*tolerance_figures(fit))))
    if lengths is not None and lengths.kept is not None:
        over = int((np.abs(lengths.error) > lengths.allowed).sum())
        errors = note("outcome.lengths", over=over, n=len(lengths.known))
        found.append(Outcome(name="lengths", kept=lengths.kept, sentence=Text.of(errors, *length_figures(lengths))))
    return tuple(found)


def tolerance_figures(fit: BestFit) -> list[Message]:
    """How many points are within, beyond, undecided; those beyond with deviation and tolerance, the worst first."""
    within, beyond, undecided = (fit.verdict.count(v) for v in ("within", "beyond", "undecided"))
    rows = [k for k, v in enumerate(fit.verdict) if v == "beyond"]
    rows.sort(key=lambda k: -float(fit.length[k] - fit.tolerance[k]))
    named = [
        note(
            "outcome.beyond", point=fit.ids[k], deviation_mm=MM * float(fit.length[k]),
            tolerance_mm=MM * float(fit.tolerance[k]),
        )
        for k in rows[:NAMED]
    ]  # fmt: skip
    more = [note("outcome.more_beyond", n=len(rows) - NAMED)] if len(rows) > NAMED else []
    return [note("outcome.tolerances", within=within, beyond=beyond, undecided=undecided), *named, *more]


def length_figures(t: LengthTest) -> list[Message]:
    """The figures of a length test: largest error, rms, share within two standard deviations, F, what follows."""
    k, (F, p) = t.largest_at, t.whole
    return [
        note(
            "outcome.length_errors", n=int(t.compared.sum()), independent=t.independent > 0, largest_mm=MM * t.largest,
            start=t.known[k].start, end=t.known[k].end, rms_mm=MM * t.rms,
        ),
        note("outcome.length_test", within=t.within, f=F, p=p, contradicts=bool(t.contradicts)),
    ]  # fmt: skip


def length_of(findings: Sequence[object]) -> LengthTest | None:
    """The length test among what was found, if any of its lengths took no part; else None."""
    return next((f for f in findings if isinstance(f, LengthTest) and f.independent), None)
