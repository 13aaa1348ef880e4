"""A wanted accuracy in words: what is kept, what cannot be judged, and the statements that ASPRS prescribes."""

from __future__ import annotations

import math
from typing import Any

from raybundle.adjustment.blunders.accuracy_class import AccuracyClass, Judged, all_kept
from raybundle.errors import Message, Text, note
from raybundle.report.languages import Localised
from raybundle.report.outcome import Outcome
from raybundle.report.text.numbers import plain

STANDARD = "ASPRS Positional Accuracy Standards for Digital Geospatial Data, Edition 2, Version 2 (2024)"
_CLASS = {"horizontal": "Horizontal Positional Accuracy Class", "vertical": "Vertical Accuracy Class"}
_RMSE = {"horizontal": "RMSE_H", "vertical": "RMSE_V"}
_FOUND = {
    "horizontal": "The tested horizontal positional accuracy was found to be",
    "vertical": "The Non-Vegetated Vertical Accuracy (NVA) was found to be",
}


def length_values(name: str, metres: float) -> dict[str, Any]:
    """A length as values of a phrase, with its unit: metres from one metre on, else millimetres."""
    whole = abs(metres) >= 1
    return {name: metres if whole else 1000 * metres, f"{name}_unit": "m" if whole else "mm"}


def judged_figures(j: Judged) -> Message:
    """One part against what is wanted."""
    part, wanted = j.part, length_values("wanted", j.wanted)
    if j.why == "heights":
        return note("outcome.no_heights", **wanted)
    if j.why == "precision":
        return note("outcome.not_precise", part=part, **wanted, **length_values("median", j.stated))
    if j.why == "left out" or (j.why == "none" and math.isfinite(j.left_out)):
        return note("outcome.only_control", part=part, **wanted, **length_values("rms", j.left_out))
    if j.why == "none":
        return note("outcome.no_check_points", part=part, **wanted)
    verdict = {True: "kept", False: "lost", None: "few"}[j.kept]
    if j.kept is None and j.why in {"unsurveyed", "untested"}:
        verdict = j.why
    return note(
        "outcome.accuracy", part=part, n=j.points, needed=j.needed, verdict=verdict, **wanted,
        **length_values("found", j.found),
    )  # fmt: skip


def accuracy_outcome(parts: tuple[Judged, ...], wanted: AccuracyClass) -> Outcome:
    """What became of a wanted accuracy."""
    kept = all_kept(parts)
    head = [] if kept is None else [note("outcome.kept", kept=kept)]
    name = "asprs" if wanted.asprs else "accuracy"
    return Outcome(name=name, kept=kept, sentence=Text.of(*head, *map(judged_figures, parts)))


def asprs_statements(parts: tuple[Judged, ...]) -> tuple[Localised, ...]:
    """The statements of the standard (section 7.16) on each part, as far as they may be made.

    Tested to meet the class where enough check points keep it; where it is not kept, none, nor where what is known of
    the result denies it: standard deviations, control left out.  Fewer check points: tested as required, with the
    number of them, and produced to meet.  Without check points: produced to meet alone.  Heights are taken as of bare
    ground (NVA): nothing here knows what grows.
    """
    found: list[str] = []
    for j in parts:
        of = f"{plain(100 * j.wanted, 4)} (cm) {_RMSE[j.part]} {_CLASS[j.part]}"
        result = f"{_FOUND[j.part]} {_RMSE[j.part]} = {plain(100 * j.found, 3)} (cm)" if math.isfinite(j.found) else ""
        if not j.claimable:
            continue
        if j.kept:
            found.append(f"This data set was tested to meet {STANDARD} for a {of}. {result}.")
        elif j.why == "unsurveyed":
            found.append(f"This data set was produced to meet {STANDARD} for a {of}.")
        elif j.points:
            found.append(
                f"This data set was tested as required by {STANDARD}. Although the Standards call for a minimum of "
                f"{_minimum(j.needed)} checkpoints, this test was performed using ONLY {j.points} checkpoints. This "
                f"data set was produced to meet a {of}. {result} using the reduced number of checkpoints."
            )
        else:
            found.append(f"This data set was produced to meet {STANDARD} for a {of}.")
    return tuple(Localised(statement) for statement in found)  # the words are those of the standard, in every language


def _minimum(needed: int) -> str:
    return "thirty (30)" if needed == 30 else str(needed)
