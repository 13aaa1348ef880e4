"""What became of tolerances and lengths, in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raybundle.metrology.best_fit import BestFit
from raybundle.metrology.lengths import LengthTest
from raybundle.report.outcome import Outcome
from raybundle.report.text.numbers import counted, per_cent, plain, probability, significant

MM = 1000.0
NAMED = 5
"""Points beyond their tolerance that an outcome names"""


def outcomes(fit: BestFit | None, lengths: LengthTest | None) -> tuple[Outcome, ...]:
    """What was asked for of a measurement, and whether it is kept."""
    found: list[Outcome] = []
    if fit is not None and np.isfinite(fit.tolerance).any():
        beyond, undecided = (fit.verdict.count(v) for v in ("beyond", "undecided"))
        kept = False if beyond else None if undecided else True
        told = f"{tolerances_told(fit)}, two standard deviations allowed for"
        found.append(Outcome(name="tolerances", kept=kept, sentence=told))
    if lengths is not None and lengths.kept is not None:
        over, n = int((np.abs(lengths.error) > lengths.allowed).sum()), len(lengths.known)
        if over:
            told = f"{over} of {n} errors beyond what is allowed; {lengths_told(lengths)}"
        else:
            told = f"all {n} errors are within what is allowed; {lengths_told(lengths)}"
        found.append(Outcome(name="lengths", kept=lengths.kept, sentence=told))
    return tuple(found)


def tolerances_told(fit: BestFit) -> str:
    """How many points are within, beyond, undecided; those beyond with deviation and tolerance, the worst first."""
    within, beyond, undecided = (fit.verdict.count(v) for v in ("within", "beyond", "undecided"))
    named = _beyond(fit)
    return f"{within} within, {beyond} beyond{f' ({named})' if named else ''}, {undecided} undecided"


def _beyond(fit: BestFit) -> str:
    rows = [k for k, v in enumerate(fit.verdict) if v == "beyond"]
    rows.sort(key=lambda k: -float(fit.length[k] - fit.tolerance[k]))
    names = [
        f"{fit.ids[k]}: {significant(MM * float(fit.length[k]), 2)} mm of {plain(MM * float(fit.tolerance[k]))} mm"
        for k in rows
    ]
    return "; ".join([*names[:NAMED], *(["..."] if len(names) > NAMED else [])])


def lengths_told(t: LengthTest) -> str:
    """The figures of a length test: largest error, rms, share within two standard deviations, F, what follows."""
    k, (F, p) = t.largest_at, t.whole
    what = counted(int(t.compared.sum()), "length")
    what = f"{what} that took no part" if t.independent else f"{what} that served as scale bars, which is no test"
    follows = "more than standard deviations explain" if t.contradicts else "no more than standard deviations explain"
    return (
        f"{what}: largest error {significant(MM * t.largest, 2)} mm ({t.known[k].start} – {t.known[k].end}), "
        f"rms {significant(MM * t.rms, 2)} mm, {per_cent(t.within)} within two standard deviations, F {significant(F)} "
        f"(p {probability(p)}), {follows}"
    )


def length_of(findings: Sequence[object]) -> LengthTest | None:
    """The length test among what was found, if any of its lengths took no part; else None."""
    return next((f for f in findings if isinstance(f, LengthTest) and f.independent), None)
