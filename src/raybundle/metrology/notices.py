"""What a measurement has to say beside its adjustment: bars, known lengths, nominal points, control, photographs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from raybundle.adjustment.records.notice import Notice, notice_of_text
from raybundle.adjustment.records.severity import POOR_FIT, Severity
from raybundle.adjustment.result import Adjustment
from raybundle.errors import Message, Value, message, message_of_text
from raybundle.metrology.bars import BarTest
from raybundle.metrology.best_fit import BestFit
from raybundle.metrology.lengths import LengthTest

MM = 1000.0
FEW = 5
"""Lengths or bars that a notice lists with their figures"""


def bar_notices(test: BarTest | None) -> tuple[Notice, ...]:
    """A fault where scale bars contradict each other, with what each of them makes of the others."""
    if test is None or not test.contradict:
        return ()
    at = test.order if test.wrong is None else [test.wrong]
    values: dict[str, Value] = {
        "names": [test.bars[k].name for k in at], "p": test.whole[1],
        "uncertain": float(np.max(test.sigma / [b.length for b in test.bars])),
        "sigma_mm": MM * float(test.sigma.max()),
    }  # fmt: skip
    code = "bars_contradict"
    if test.exchanged is not None:
        code = "bars_contradict.exchanged"
        values["first"], values["second"] = (test.bars[k].name for k in test.exchanged)
    elif test.wrong is not None:
        code, values["sigma_mm"] = "bars_contradict.one", MM * float(test.sigma[test.wrong])
    ids = tuple(test.bars[k].name for k in at)
    return (Notice(code=code, values=values, ids=ids, details=tuple(_bar(test, k) for k in at[:FEW])),)


def _bar(test: BarTest, k: int) -> Message:
    return message(
        "bars_contradict.bar", bar=test.bars[k].name, given_mm=MM * test.bars[k].length,
        others=test.bars[1 - k].name if len(test.bars) == 2 else "", measured_mm=MM * float(test.shown[k]),
        apart_mm=MM * abs(float(test.apart[k])), sigma_mm=MM * float(test.shown_sigma[k]),
    )  # fmt: skip


def length_notices(test: LengthTest | None) -> tuple[Notice, ...]:
    """A caution, or a fault, where lengths that took no part contradict their standard deviations."""
    if test is None or not test.contradicts:
        return ()
    F, p = test.whole
    beyond = np.flatnonzero(test.strange)
    beyond = beyond[np.argsort(-np.abs(test.error[beyond]), kind="stable")].tolist()
    off, sigma = test.scale
    values: dict[str, Value] = {
        "n": test.independent, "factor": test.factor, "F": F, "p": p, "scale_ppm": 1e6 * off,
        "sigma_ppm": 1e6 * sigma, "beyond": len(beyond),
    }  # fmt: skip
    code = "lengths_contradict"
    if test.strange[test.worst] and not test.without_worst[1] < test.significance:
        k = test.known[test.worst]
        code = "lengths_contradict.one" if test.independent > 1 else "lengths_contradict.single"
        values["length"] = f"{k.start} - {k.end}"
    elif abs(off) > 2 * sigma:
        code = "lengths_contradict.scale"
    grave = Severity.FAULT if test.factor > POOR_FIT else Severity.WARNING
    ids = tuple(f"{test.known[k].start} - {test.known[k].end}" for k in beyond)
    details = tuple(
        message(
            "lengths_contradict.length", start=test.known[k].start, end=test.known[k].end,
            error_mm=MM * float(test.error[k]), sigma_mm=MM * float(test.error_sigma[k]),
        )
        for k in beyond[:FEW]
    )  # fmt: skip
    return (Notice(code=code, values=values, ids=ids, measured=grave, details=details),)


def nominal_notices(fit: BestFit | None) -> tuple[Notice, ...]:
    """A caution where nominal points were not measured."""
    if fit is None or not fit.missing:
        return ()
    return (Notice(code="nominal_missing", values={"n": len(fit.missing)}, ids=fit.missing[:100]),)


def control_assumed(file: str, off_mm: float) -> Notice:
    """Of control that states no standard deviation."""
    return Notice(code="control_file.no_sigma", values={"name": file, "off_mm": off_mm})


def control_remarks(remarks: Sequence[str]) -> tuple[Notice, ...]:
    """What was assumed of a file of control."""
    return tuple(notice_of_text("control_file", r) for r in remarks)


def control_lost(names: Sequence[str]) -> tuple[Notice, ...]:
    """Of control that was not measured."""
    if not names:
        return ()
    return (Notice(code="control_file.not_measured", values={"n": len(names)}, ids=tuple(names[:100])),)


def given_twice(kind: Literal["length", "scale_bar"], names: Sequence[str]) -> tuple[Notice, ...]:
    """Of lengths or scale bars that were given more than once, and count once."""
    return (Notice(code="given_twice", values={"kind": kind, "n": len(names)}, ids=tuple(names[:100])),)


def tolerances_ignored(file: str) -> Notice:
    """Of a column of a file of control that is for nominal coordinates."""
    return Notice(code="control_file.tolerance", values={"name": file}, measured=Severity.NOTE)


def photographs_lost(lost: Sequence[tuple[str, str]]) -> tuple[Notice, ...]:
    """Of photographs that take no part, and why."""
    return tuple(
        Notice(code="image_left_out", values={"image": name}, ids=(name,), reason=why, details=(message_of_text(why),))
        for name, why in lost
    )


def rests_on(folder: str, faults: int) -> tuple[Notice, ...]:
    """Of a result with faults that a measurement was made of."""
    if not faults:
        return ()
    return (Notice(code="result_unsettled", values={"name": folder, "n": faults}, ids=(folder,)),)


def of_a_tool(result: Adjustment, test: LengthTest | None) -> Adjustment:
    """The result with its own notices as they concern points, and not the calibration of a camera.

    Correlated parameters of a camera that is calibrated with the object are no weakness of the points: their common
    covariance is in that of the points.  Lengths that took no part and agree control a scale that no other bar does.
    """
    found: list[Notice] = []
    for n in result.notices:
        if n.code == "correlation":
            contained = message("correlation.contained")
            found.append(replace(n, details=(*n.details, contained), measured=Severity.NOTE))
        elif n.code == "scale_unchecked" and test is not None and test.controlled.any():
            found += [] if test.contradicts else [_scale_checked(n, test)]
        else:
            found.append(n)
    return replace(result, notices=tuple(found))


def _scale_checked(n: Notice, test: LengthTest) -> Notice:
    off, sigma = test.scale
    values: dict[str, Value] = {
        "n": test.independent, "scale_ppm": 1e6 * off, "sigma_ppm": 1e6 * sigma, "bars": len(n.ids)
    }  # fmt: skip
    return Notice(code="scale_checked", values=values, ids=n.ids)
