"""The next best photographs: which of many that could be taken lowers standard deviations most, or frees the camera.

Every candidate is judged by the covariances that an adjustment with it would state, exactly and without making one
(`adjustment.evaluation.additions`): for the image points that it is taken to see, of the precision of the others.
What this does not show: whether one can stand there, and whether the points can be recognised; the true surface may
hide some.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.evaluation.additions import Photographs, gain
from raybundle.adjustment.system.dense import one_thread
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.planning.next.goals import Goal, Standing, measure_of
from raybundle.planning.next.outlook import Outlook

TOGETHER = 50
"""Candidates whose partial derivatives are formed at once: of a camera with hundreds of parameters they are large."""


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
    std_before: Array
    """(t, 3) of the coordinates of the points that are regarded, without the photograph; `std_after` with it"""
    std_after: Array
    interior_std_before: Array
    """(u,) of all interior orientations, in the order of the joint cofactors; `interior_std_after` with it"""
    interior_std_after: Array


def next_best(
    outlook: Outlook, candidates: Photographs, goal: Goal, count: int = 1, progress: Progress = silent
) -> tuple[Chosen, ...]:
    """The best photographs of many that could be taken, one after the other, each after those before it.

    candidates  with the points that each is taken to see
    returns     as many as are asked for, fewer where no other lowers anything

    Each is the best beside those before it; two that are poor alone and good together are not found.
    """
    found = list[Chosen]()
    open_ = np.bincount(candidates.image, minlength=len(candidates)) > 0
    for step in range(count):

        def notify(share: float, step: int = step) -> None:
            progress("candidates", (step + share) / count)

        now, standing = measure_of(outlook, goal).standing(None), ranking(outlook, candidates, goal, open_, notify)
        ranks = np.array([s.rank if s is not None else (np.inf, np.inf) for s in standing]).reshape(-1, 2)
        best = int(np.lexsort((ranks[:, 1], ranks[:, 0]))[0])
        after = standing[best]
        if after is None or not after.rank < now.rank:
            break
        taken = candidates.chosen(np.array([best]))
        before, left = _deviations(outlook, taken)
        t = 3 * len(outlook.joint.points)
        found.append(
            Chosen(
                candidate=best, photograph=taken, before=now, after=after, ranked=ranks[:, 0],
                std_before=before[:t].reshape(-1, 3), std_after=left[:t].reshape(-1, 3),
                interior_std_before=before[t:], interior_std_after=left[t:],
            )
        )  # fmt: skip
        open_[best] = False
        if step + 1 < count:
            outlook = outlook.added(taken, (f"proposed {step + 1}",))
    progress("candidates", 1.0)
    return tuple(found)


def _deviations(outlook: Outlook, taken: Photographs) -> tuple[Array, Array]:
    """Standard deviations (n,) of all that the joint cofactors hold, without and with a photograph."""
    g = gain(outlook.joint, outlook.rows(taken), slice(None))
    now = np.diagonal(outlook.joint.matrix)
    assert g is not None  # it was ranked
    wider = np.concatenate([outlook.wider.ravel(), np.ones(len(now) - outlook.wider.size)])
    before, after = (np.sqrt(np.maximum(outlook.variance * v, 0.0)) * wider for v in (now, now - g.lost()))
    return before, after


def ranking(
    outlook: Outlook, candidates: Photographs, goal: Goal, asked: Mask, notify: Callable[[float], None] | None = None
) -> list[Standing | None]:
    """What a goal amounts to with each candidate (n,) by itself; None for those not asked, or seeing too little.

    asked  (n,) which are
    notify   is given the share that is done
    """
    measure = measure_of(outlook, goal)
    found: list[Standing | None] = [None] * len(candidates)
    # small matrices: a second thread waits longer than it works, where processors are busy otherwise
    with one_thread():
        wanted = np.flatnonzero(asked)
        for first in range(0, len(wanted), TOGETHER):
            if notify is not None:
                notify(first / len(wanted))
            part = wanted[first : first + TOGETHER]
            rows = outlook.rows(candidates.chosen(part))
            for k, i in enumerate(part.tolist()):
                g = gain(outlook.joint, rows.chosen(np.array([k])), measure.columns)
                found[i] = None if g is None else measure.standing(g)
    return found
