"""Whether epochs can be held against each other at all: the same measurement twice, other units or scales, names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.errors import InputError, Message, Value, message
from raybundle.metrology.congruence import Congruence, common_ids
from raybundle.metrology.misfit import in_one_line, misfit
from raybundle.metrology.misfit_words import fit_values
from raybundle.metrology.point_set import PointSet
from raybundle.numerics.length_units import is_other_unit
from raybundle.numerics.transform import similarity

ONE = 0.01
"""Differences in standard deviations below which two epochs are one measurement: the six degrees of freedom of four
points are as small by chance once in 1e12"""


def comparable(
    epochs: Sequence[PointSet], bars: Mapping[str, Sequence[str]] | None = None
) -> tuple[list[PointSet], tuple[Notice, ...]]:  # fmt: skip
    """Epochs as they can be held against each other, and what is wrong with them.

    bars    of an epoch, by its name, the scale bars that it rests on
    raises  InputError for one measurement given twice, epochs of other units, mirrored ones, names of other points
    Epochs of which the measured scales contradict each other may differ in scale from then on, and that is a fault.
    """
    ids = common_ids(epochs)
    sets = [e.named(ids) for e in epochs]
    found: list[Notice] = []
    if any(in_one_line(e.xyz) for e in sets):
        e = next(e for e in sets if in_one_line(e.xyz))
        raise InputError(
            "epochs.points_in_line", n=len(ids), epochs=[x.name for x in epochs], epoch=e.name, names=list(ids)
        )
    _check_apart(sets)
    first, free = sets[0], False
    for e in sets[1:]:
        known = None if first.free_scale or e.free_scale else float(np.hypot(first.scale_sigma(), e.scale_sigma()))
        m = misfit(e.xyz, first.xyz, scale_sigma=known)
        if m.mirrored:
            raise InputError(
                Message(code="epochs.mirrored", values={"first": e.name, "second": first.name, **fit_values(m)})
            )
        if m.scattered:
            raise InputError(
                Message(code="epochs.scattered", values={"first": e.name, "second": first.name, **fit_values(m)})
            )
        if not m.scaled:
            continue
        if is_other_unit(m.factor):
            raise InputError(
                Message(code="epochs.other_unit", values={"first": first.name, "second": e.name, **fit_values(m)})
            )
        free = True
        values: dict[str, Value] = {
            "first": e.name, "second": first.name, **fit_values(m),
            "sigmas": float(abs(np.log(m.factor)) / max(known or 0.0, 1e-300)),
            "bars": [name for x in (first, e) for name in (bars or {}).get(x.name, ())],
        }  # fmt: skip
        found.append(
            Notice(code="epochs_scale", values=values, ids=(first.name, e.name), measured=Severity.FAULT)
        )  # fmt: skip
    return [replace(e, free_scale=True) if free else e for e in epochs], tuple(found)


def _check_apart(sets: Sequence[PointSet]) -> None:
    """Raise InputError where two epochs are one measurement: no two differ so little."""
    for a, b in combinations(sets, 2):
        size = float(np.sqrt(np.mean(np.trace(a.own + b.own, axis1=1, axis2=2) / 3)))
        apart = float(np.sqrt(np.mean(similarity(b.xyz, a.xyz, scale=1.0).residuals ** 2)))
        if size > 0 and apart < ONE * size:
            raise InputError(
                "epochs.same_observations", first=a.name, second=b.name, apart_mm=1000 * apart, sigma_mm=1000 * size
            )


def most_moved(done: Congruence) -> tuple[Notice, ...]:
    """A fault where more points moved than stayed: which half is open; as a rule names are wrong."""
    moved, n = int(done.moved.sum()), len(done.ids)
    if 2 * moved <= n:
        return ()
    values: dict[str, Value] = {"moved": moved, "n": n, "epochs": list(done.epochs)}
    return (Notice(code="epochs_names", values=values, ids=done.epochs, measured=Severity.FAULT),)


def others_as_well(done: Congruence) -> tuple[Notice, ...]:
    """A caution for each moved point in place of which another may have moved."""
    found: list[Notice] = []
    for point in dict.fromkeys(a.point for a in done.alternatives):
        others = [a for a in done.alternatives if a.point == point]
        each = tuple(message("moved_ambiguous.other", point=a.other, F=a.F) for a in others)
        values: dict[str, Value] = {"point": point, "others": [a.other for a in others], "F": done.after[0]}
        found.append(
            Notice(code="moved_ambiguous", values=values, ids=(point,), measured=Severity.WARNING, details=each)
        )
    return tuple(found)
