"""What a measurement has to say beside its adjustment: bars, known lengths, nominal points, control, photographs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.adjustment.result import Adjustment, Notice
from raybundle.adjustment.severity import POOR_FIT, Severity
from raybundle.metrology.bars import BarTest
from raybundle.metrology.best_fit import BestFit
from raybundle.metrology.lengths import LengthTest
from raybundle.numerics.counting import counted, decimals_for, significant, some_of

MM = 1000.0
FEW = 5
"""Lengths that a notice names with their figures"""
LEAST_P = 1e-16
"""Probabilities below are those of no distribution of real errors: they are told as a bound"""


def p_words(p: float) -> str:
    """A probability behind its letter: "p 0.35", "p < 1e-16"."""
    return f"p {p:.2g}" if p >= LEAST_P else f"p < {LEAST_P:g}"


def bar_notices(test: BarTest | None) -> tuple[Notice, ...]:
    """A fault where scale bars contradict each other, with what each of them makes of the others."""
    if test is None or not test.contradict:
        return ()
    at = test.order if test.wrong is None else [test.wrong]
    told = "; ".join(_bar(test, k) for k in at[:FEW])
    wide = float(test.sigma.max())
    scale = float(np.max(test.sigma / [b.length for b in test.bars]))
    if test.exchanged is not None:
        a, b = (test.bars[k].name for k in test.exchanged)
        rest = (
            f"Until that is settled lengths are uncertain by {100 * scale:.2g} %. With the lengths of {a} and {b} "
            "exchanged all bars agree: was each given the certificate of the other?"
        )
    elif test.wrong is not None:
        rest = (
            f"It takes part with a standard deviation of {significant(MM * float(test.sigma[test.wrong]), 2)} mm, so "
            "that it bends nothing. Without this one the others agree: check its certificate, its unit and the names "
            "of its ends"
        )
    else:
        rest = (
            f"They take part with standard deviations of up to {significant(MM * wide, 2)} mm, so that they bend "
            f"nothing, and until that is settled lengths are uncertain by {100 * scale:.2g} %. Which of them is wrong "
            "the photographs cannot tell: check certificates, units and the names of ends, or give one more bar"
        )
    return (
        Notice(
            code="bars_contradict",
            message=f"scale bars contradict each other ({p_words(test.whole[1])}): {told}. {rest}",
            ids=tuple(test.bars[k].name for k in at),
        ),
    )


def _bar(test: BarTest, k: int) -> str:
    sigma = MM * float(test.shown_sigma[k])
    n = decimals_for(sigma)
    shown, apart = MM * float(test.shown[k]), MM * abs(float(test.apart[k]))
    own, given = test.bars[k].name, MM * test.bars[k].length
    others = test.bars[1 - k].name if len(test.bars) == 2 else "the others"
    return (
        f"{own} is given as {given:.{n}f} mm, by {others} it is {shown:.{n}f} mm, {apart:.{n}f} mm apart at a standard "
        f"deviation of {sigma:.{n}f} mm"
    )


def length_notices(test: LengthTest | None) -> tuple[Notice, ...]:
    """A caution, or a fault, where lengths that took no part contradict their standard deviations."""
    if test is None or not test.contradicts:
        return ()
    F, p = test.whole
    first = (
        f"{counted(test.independent, 'length')} that took no part against standard deviations: errors are "
        f"{significant(test.factor, 2)} times as large as these say (F {significant(F)}, {p_words(p)})"
    )
    told = [first]
    beyond = np.flatnonzero(test.strange)
    beyond = beyond[np.argsort(-np.abs(test.error[beyond]), kind="stable")].tolist()
    if beyond:
        each = "; ".join([*(_length(test, k) for k in beyond[:FEW]), *["..."] * (len(beyond) > FEW)])
        told.append(f"By themselves beyond chance: {each}")
    off, sigma = test.scale
    if test.strange[test.worst] and not test.without_worst[1] < test.significance:
        k = test.known[test.worst]
        first = f"Without {k.start} - {k.end} the others agree: check its certificate and its ends first"
        told.append(first if test.independent > 1 else "Check its certificate and its ends, and the scale bars")
    else:
        if abs(off) > 2 * sigma:
            told.append(
                f"As a scale they differ by {1e6 * off:+.2g} ± {1e6 * sigma:.2g} ppm, measured minus known: check the "
                "scale bars"
            )
        told.append(
            "Standard deviations, also those of points and deviations, are too small by about that factor, or "
            "certificates of these lengths, or of the scale bars, are wrong"
        )
    grave = Severity.FAULT if test.factor > POOR_FIT else Severity.CAUTION
    ids = tuple(f"{test.known[k].start} - {test.known[k].end}" for k in beyond)
    return (Notice(code="lengths_contradict", message=". ".join(told), ids=ids, measured=grave),)


def _length(test: LengthTest, k: int) -> str:
    """One length with its error."""
    error, sigma = MM * float(test.error[k]), MM * float(test.error_sigma[k])
    return (
        f"{test.known[k].start} - {test.known[k].end} by {significant(error, 3)} mm at a standard deviation of "
        f"{significant(sigma, 2)} mm"
    )


def nominal_notices(fit: BestFit | None) -> tuple[Notice, ...]:
    """A caution where nominal points were not measured."""
    if fit is None or not fit.missing:
        return ()
    message = f"{counted(len(fit.missing), 'nominal point')} not measured: {some_of(fit.missing)}"
    return (Notice(code="nominal_missing", message=message, ids=fit.missing[:100]),)


def control_assumed(file: str, off_mm: float) -> Notice:
    """Of control that states no standard deviation."""
    message = (
        f"{file} states no standard deviation, and its points fit the network to {off_mm:.2g} mm: that is taken; give "
        "sX, sY, sZ if you know better"
    )
    return Notice(code="control_file", message=message)


def control_remarks(file: str, remarks: Sequence[str]) -> tuple[Notice, ...]:
    """What was assumed of a file of control."""
    return tuple(Notice(code="control_file", message=f"{file}: {r.removeprefix(f'{file}: ')}") for r in remarks)


def control_lost(names: Sequence[str]) -> tuple[Notice, ...]:
    """Of control that was not measured."""
    if not names:
        return ()
    message = f"control that was not measured: {some_of(names)}"
    return (Notice(code="control_file", message=message, ids=tuple(names[:100])),)


def given_twice(what: str, names: Sequence[str]) -> tuple[Notice, ...]:
    """Of lengths or scale bars that were given more than once, and count once."""
    message = f"{what} given twice, counted once: {some_of(names)}; it checks nothing"
    return (Notice(code="given_twice", message=message, ids=tuple(names[:100])),)


def tolerances_ignored(file: str) -> Notice:
    """Of a column of a file of control that is for nominal coordinates."""
    message = f"{file}: the column tolerance is for nominal coordinates, and control has none: it is not used"
    return Notice(code="control_file", message=message, measured=Severity.REMARK)


def photographs_lost(lost: Sequence[tuple[str, str]]) -> tuple[Notice, ...]:
    """Of photographs that take no part, and why."""
    return tuple(
        Notice(code="image_left_out", message=f"{name} is left out: {why}", ids=(name,), reason=why)
        for name, why in lost
    )


def rests_on(folder: str, faults: int) -> tuple[Notice, ...]:
    """Of a result with faults that a measurement was made of."""
    if not faults:
        return ()
    message = (
        f"the result {folder}, of which this one is made, has {counted(faults, 'matter')} to settle first: see its "
        "report. What is wrong there is wrong here"
    )
    return (Notice(code="result_unsettled", message=message, ids=(folder,)),)


def of_a_tool(result: Adjustment, test: LengthTest | None) -> Adjustment:
    """The result with its own notices as they concern points, and not the calibration of a camera.

    Correlated parameters of a camera that is calibrated with the object are no weakness of the points: their common
    covariance is in that of the points.  Lengths that took no part and agree control a scale that no other bar does.
    """
    found: list[Notice] = []
    for n in result.notices:
        if n.code == "correlation":
            message = (
                f"{n.text.rstrip()} Standard deviations of the points contain that; it concerns who takes the "
                "calibration for other photographs"
            )
            found.append(replace(n, message=message, measured=Severity.REMARK))
        elif n.code == "scale_unchecked" and test is not None and test.controlled.any():
            found += [] if test.contradicts else [_scale_checked(n, test)]
        else:
            found.append(n)
    return replace(result, notices=tuple(found))


def _scale_checked(n: Notice, test: LengthTest) -> Notice:
    off, sigma = test.scale
    message = (
        f"the scale rests on {counted(len(n.ids), 'scale bar')} ({', '.join(n.ids)}) that the photographs cannot "
        f"check; {counted(test.independent, 'length')} that took no part agree with it: measured {1e6 * off:+.2g} ± "
        f"{1e6 * sigma:.2g} ppm too long"
    )
    return Notice(code="scale_checked", message=message, ids=n.ids)
