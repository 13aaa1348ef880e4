"""The next best photographs: which of many that could be taken lowers standard deviations most, or frees the camera.

Every candidate is judged by the covariances that an adjustment with it would state, exactly and without making one
(`adjustment.additions`): for the image points that it is taken to see, of the precision of the others.  What this does
not tell: whether one can stand there, and whether the points can be recognised; the true surface may hide some.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.additions import Photographs, gain
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.planning.goals import Goal, Standing, measure_of
from raybundle.planning.outlook import Outlook


@dataclass(frozen=True, slots=True, kw_only=True)
class Chosen:
    """One photograph of a sequence, each the best after those before it."""

    candidate: int
    """Position among the candidates"""
    photograph: Photographs
    """It alone, with the points that it is taken to see"""
    before: Standing
    after: Standing
    ranked: Array
    """(n,) what every candidate would have brought in its place; infinite where it sees too little"""


def next_best(
    outlook: Outlook, candidates: Photographs, goal: Goal, count: int = 1, progress: Progress = silent
) -> tuple[Chosen, ...]:
    """The best photographs of many that could be taken, one after the other, each after those before it.

    candidates  with the points that each is taken to see
    returns     as many as are asked for, fewer where no other lowers anything

    Each is the best beside those before it; two that are poor alone and good together are not found.
    """
    found = list[Chosen]()
    open_ = np.ones(len(candidates), bool)
    for step in range(count):
        measure = measure_of(outlook, goal)
        now = measure(None)
        ranked = np.full(len(candidates), np.inf)
        rows = outlook.rows(candidates)
        images = np.flatnonzero(open_ & (np.bincount(candidates.image, minlength=len(candidates)) > 0))
        standing = dict[int, Standing]()
        for k, i in enumerate(images.tolist()):
            if k % 50 == 0:
                progress("candidates", (step + k / max(len(images), 1)) / count)
            g = gain(outlook.joint, rows.chosen(np.array([i])))
            if g is not None:
                standing[i] = measure(g)
                ranked[i] = standing[i].value
        if not standing:
            break
        best = int(np.argmin(ranked))
        if not ranked[best] < now.value:
            break
        taken = candidates.chosen(np.array([best]))
        found.append(Chosen(candidate=best, photograph=taken, before=now, after=standing[best], ranked=ranked))
        open_[best] = False
        if step + 1 < count:
            outlook = outlook.added(taken, (f"proposed {step + 1}",))
    progress("candidates", 1.0)
    return tuple(found)
