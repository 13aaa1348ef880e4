"""A wanted accuracy in words: what is kept, what cannot be judged, and the statements that ASPRS prescribes."""

from __future__ import annotations

import math

from raybundle.adjustment.accuracy_class import AccuracyClass, Judged, all_kept
from raybundle.numerics.counting import counted
from raybundle.report.languages import Said
from raybundle.report.outcome import Outcome
from raybundle.report.text.numbers import plain, significant

STANDARD = "ASPRS Positional Accuracy Standards for Digital Geospatial Data, Edition 2, Version 2 (2024)"
_CLASS = {"horizontal": "Horizontal Positional Accuracy Class", "vertical": "Vertical Accuracy Class"}
_RMSE = {"horizontal": "RMSE_H", "vertical": "RMSE_V"}
_FOUND = {
    "horizontal": "The tested horizontal positional accuracy was found to be",
    "vertical": "The Non-Vegetated Vertical Accuracy (NVA) was found to be",
}


def length_words(metres: float) -> str:
    """A length with three digits: in metres from one metre on, else in millimetres."""
    return f"{significant(metres)} m" if abs(metres) >= 1 else f"{significant(1000 * metres)} mm"


def given_words(metres: float) -> str:
    """A length that was given, without zeros at its end."""
    return f"{plain(metres, 4)} m" if metres >= 1 else f"{plain(1000 * metres, 4)} mm"


def judged_words(j: Judged) -> str:
    """One part against what is wanted."""
    name, wanted = _RMSE[j.part], given_words(j.wanted)
    what = "plan" if j.part == "horizontal" else "height"
    if j.why == "heights":
        return f"{what}: {wanted} wanted, not judged, as no height was given: those of the result are relative"
    if j.why == "precision":
        return (
            f"{what}: {wanted} wanted: not kept, as the standard deviations of half of the object points are beyond it "
            f"(median {length_words(j.stated)})"
        )
    if j.why == "left out" or (j.why == "none" and math.isfinite(j.left_out)):
        return (
            f"{what}: {wanted} wanted, not judged, as no check point is compared in it; control left out is off by "
            f"{length_words(j.left_out)} rms"
        )
    if j.why == "none":
        return f"{what}: {wanted} wanted, not judged, as no check point is compared in it"
    size = f"{what}: {name} {length_words(j.found)} at {counted(j.points, 'check point')}, {wanted} wanted"
    if j.kept is not None:
        return f"{size}: {'kept' if j.kept else 'not kept'}"
    if j.why == "unsurveyed":
        return (
            f"{size}; not a tested ASPRS statement: check points state no standard deviation of their own, which the "
            "standard adds to what is found"
        )
    if j.why == "untested":
        return f"{size}; not a tested ASPRS statement, which asks for {j.needed} check points"
    return f"{size}; not judged: fewer than {j.needed} check points say too little"


def accuracy_outcome(parts: tuple[Judged, ...], wanted: AccuracyClass) -> Outcome:
    """What became of a wanted accuracy."""
    kept = all_kept(parts)
    head = {True: "kept: ", False: "not kept: ", None: ""}[kept]
    name = "ASPRS accuracy class" if wanted.asprs else "wanted accuracy"
    return Outcome(name=name, kept=kept, sentence=head + "; ".join(judged_words(j) for j in parts))


def asprs_statements(parts: tuple[Judged, ...]) -> tuple[Said, ...]:
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
    return tuple(Said(statement) for statement in found)  # the words are those of the standard, in every language


def _minimum(needed: int) -> str:
    return "thirty (30)" if needed == 30 else str(needed)
