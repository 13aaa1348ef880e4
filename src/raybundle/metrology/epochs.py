"""Whether epochs can be held against each other at all: the same measurement twice, other units or scales, names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np

from raybundle.adjustment.result import Notice
from raybundle.adjustment.severity import Severity
from raybundle.errors import InputError
from raybundle.metrology.congruence import Congruence, common_ids
from raybundle.metrology.misfit import in_one_line, misfit
from raybundle.metrology.misfit_words import factor_words, mirrored_words, scattered_words, unit_of
from raybundle.metrology.point_set import PointSet
from raybundle.numerics.counting import some_of
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
    told: list[Notice] = []
    if any(in_one_line(e.xyz) for e in sets):
        e = next(e for e in sets if in_one_line(e.xyz))
        raise InputError(
            f"the {len(ids)} points that {' and '.join(x.name for x in epochs[:3])} have in common lie in one line, "
            f"or are one point ({e.name}; {some_of(ids, 5)}): a datum needs three that are not in one line"
        )
    _check_apart(sets)
    first, free = sets[0], False
    for e in sets[1:]:
        known = None if first.free_scale or e.free_scale else float(np.hypot(first.scale_sigma(), e.scale_sigma()))
        m = misfit(e.xyz, first.xyz, scale_sigma=known)
        what = f"the points of {e.name} and {first.name}"
        if m.mirrored:
            raise InputError(f"{mirrored_words(m, what)}: look at the images, or the coordinates, of both")
        if m.scattered:
            raise InputError(scattered_words(m, what))
        if not m.scaled:
            continue
        if is_other_unit(m.factor):
            unit = unit_of(m.factor)
            raise InputError(
                f"the points of {first.name} lie {m.factor:.6g} times as far apart as those of {e.name}: is the length "
                f"unit of one another than it says{f' ({unit})' if unit else ''}, or a scale bar?"
            )
        free = True
        named = "; ".join(f"{x.name}: {some_of(bars[x.name])}" for x in (first, e) if bars and bars.get(x.name))
        message = (
            f"{factor_words(m, what)} That is {abs(np.log(m.factor)) / max(known or 0.0, 1e-300):.3g} standard "
            f"deviations of both scales{f' (scale bars of {named})' if named else ''}. They are held against each "
            "other with the scale free: a growth of all is not seen"
        )
        told.append(
            Notice(code="epochs_scale", message=message, ids=(first.name, e.name), measured=Severity.FAULT)
        )  # fmt: skip
    return [replace(e, free_scale=True) if free else e for e in epochs], tuple(told)


def _check_apart(sets: Sequence[PointSet]) -> None:
    """Raise InputError where two epochs are one measurement: no two differ so little."""
    for a, b in combinations(sets, 2):
        size = float(np.sqrt(np.mean(np.trace(a.own + b.own, axis1=1, axis2=2) / 3)))
        apart = float(np.sqrt(np.mean(similarity(b.xyz, a.xyz, scale=1.0).residuals ** 2)))
        if size > 0 and apart < ONE * size:
            raise InputError(
                f"{a.name} and {b.name} are of the same observations: their points differ by {1000 * apart:.2g} mm rms "
                f"at standard deviations of {1000 * size:.2g} mm. One measurement held against itself tells nothing"
            )


def most_moved(done: Congruence) -> tuple[Notice, ...]:
    """A fault where more points moved than stayed: which half it was cannot be told, as a rule names are wrong."""
    moved, n = int(done.moved.sum()), len(done.ids)
    if 2 * moved <= n:
        return ()
    message = (
        f"{moved} of {n} points that {' and '.join(done.epochs)} call alike moved, more than half: are the names those "
        "of another object, exchanged or shifted by one? Which half stayed the test cannot tell"
    )
    return (Notice(code="epochs_names", message=message, ids=done.epochs, measured=Severity.FAULT),)


def others_as_well(done: Congruence) -> tuple[Notice, ...]:
    """A caution for each moved point in place of which another may have moved."""
    found: list[Notice] = []
    for point in dict.fromkeys(a.point for a in done.alternatives):
        others = [a for a in done.alternatives if a.point == point]
        each = some_of([f"{a.other} (F {a.F:.2f})" for a in others])
        one = "another" if len(others) == 1 else "others"
        message = (
            f"in place of {point} {one} may have moved: {each} left out, the rest agrees as well (F "
            f"{done.after[0]:.2f} without {point}). More common points would tell"
        )
        found.append(Notice(code="moved_ambiguous", message=message, ids=(point,), measured=Severity.CAUTION))
    return tuple(found)
