"""Which observations are blunders: data snooping in rounds, each round those that do not touch one another.

Test: tau = v / (sigma0 s sqrt r), largest of the two coordinates of an image point, against the family-wise critical
value (Pope 1976).  A rejected observation returns once if its residual is below that limit.  Where rejections would
leave position, orientation or scale open, it is the control that contradicts: its image observations return and stay,
and the contradiction is reported.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from raybundle.adjustment.blunders.exchanged_points import exchanged_notices
from raybundle.adjustment.blunders.reintersection import reintersected
from raybundle.adjustment.blunders.rejected_groups import rejected_group_notices
from raybundle.adjustment.decision.masking import is_suspect, masked_notices, unmasked
from raybundle.adjustment.decision.snooping import (
    apart,
    bent_by_distances,
    innocent,
    is_blunder,
    is_spread,
    tau_values,
    with_rejected,
    without_reasons,
)
from raybundle.adjustment.decision.state import State, Task
from raybundle.adjustment.decision.wrong_control import (
    WrongControl,
    judged,
    kept_notice,
    left_out,
    rejected_notice,
    suspected,
)
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.result_figures import Extent
from raybundle.adjustment.system.adjusted_values import as_start
from raybundle.errors import DatumDefect, NoConvergence, NotSolvable, RankDefect
from raybundle.numerics.arrays import Array, Index, Mask

ROUNDS = 40
OF_THE_END = {
    "control_not_located",
    "snooping_masked",
    "image_contradicts",
    "control_contradicts",
    "names_exchanged",
    "ties_mismatched",
}
"""Codes of notices on what snooping leaves: those of an earlier run are replaced"""
NEARBY = 0.3
"""Steps, in standard deviations of the unknowns, that end an adjustment without a few observations: within one standard
deviation it is linear, or standard deviations mean nothing."""
MASKING_ROUNDS = (10, 20, 30)
"""Rounds of data snooping at which masked gross errors are looked for, beside where no suspect is left."""


class Snooping:
    """Reject blunders in rounds, then let rejected ones return."""

    rounds = ROUNDS
    extent: Extent = "tests"

    def decide(self, state: State, result: Adjustment, number: int, task: Task) -> State:
        """What the first of the decisions changes that changes anything."""
        snooped = replace(state.snooped, before=None)
        seen = _Seen(replace(state, reasons=result.image_observations.rejected, snooped=snooped), result, number, task)
        return next(changed for decision in DECISIONS if (changed := decision(seen)) is not None)

    def unsolved(self, state: State, error: NotSolvable, task: Task) -> State | None:
        """The state before a robust estimate, one of a robust estimate, or with the rays to control that were lost."""
        snooped = state.snooped
        if snooped.before is not None:  # without what a robust estimate left out the block is not determined
            return replace(snooped.before, snooped=replace(snooped, tried=None, before=None, robust=False))
        if snooped.robust and snooped.tried is None and _may_be_torn(error):
            tried = unmasked(state.block, task.options, state.free, state.reasons, _guarded(state))
            if tried is not None:
                return replace(
                    state, block=tried.block, reasons=tried.reasons, start="adjusted",
                    snooped=replace(snooped, tried=tried),
                )  # fmt: skip
        if not isinstance(error, DatumDefect):
            return None
        guarded = np.asarray(state.block.points.is_control.any(axis=1))[state.block.observations.point]
        back = frozenset(i for i, r in enumerate(state.reasons) if is_blunder(r) and guarded[i])
        if not back:
            return None
        snooped = replace(snooped, returned=snooped.returned | back, guarded=guarded)
        return replace(state, reasons=without_reasons(state.reasons, back), snooped=snooped)

    def unfinished(self, state: State, task: Task) -> Notice:
        """Blunders may be left."""
        del state, task
        return Notice(code="snooping_unfinished", values={"rounds": self.rounds})


@dataclass(frozen=True)
class _Seen:
    """What an adjustment shows of the observations."""

    state: State
    result: Adjustment
    number: int
    """of the round"""
    task: Task

    @cached_property
    def size(self) -> Array:
        """(m,) larger test value of each image observation."""
        return np.asarray(np.nan_to_num(np.abs(self.result.image_observations.t).max(axis=1)))

    @cached_property
    def wrong(self) -> WrongControl | None:
        """The control point that contradicts the others more than any image observation does, and what is known of it.

        More: letting it go takes more from the square sum than leaving out the image coordinate with the largest tau.
        """
        worst = suspected(self.result)
        if worst is None or worst.square <= (float(self.size.max(initial=0.0)) * self.result.sigma0) ** 2:
            return None
        return judged(self.result, worst, self.state.free, self.state.reasons)

    @cached_property
    def suspects(self) -> Index:
        """Rows beyond the critical value, without those of points that are wrong themselves."""
        block = self.state.block
        found = np.flatnonzero((self.size > self.result.critical_tau) & ~_guarded(self.state))
        if self.wrong is not None:
            taken = [block.points.ids.index(name) for name in (self.wrong.name, *self.wrong.others)]
            found = found[~np.isin(block.observations.point[found], taken)]
        return np.asarray(found[~bent_by_distances(self.result, found, self.size)])

    @cached_property
    def chosen(self) -> list[int]:
        """Suspects that leave in this round."""
        return apart(self.state.block, self.size, self.suspects)


def control_leaves(seen: _Seen) -> State | None:
    """Without the control point that is known to be wrong and can be spared."""
    if seen.wrong is None or not seen.wrong.may_go:
        return None
    block, reasons = left_out(seen.state.block, seen.wrong.name, seen.state.reasons)
    return replace(seen.state, block=block, reasons=reasons).noted(rejected_notice(seen.wrong))


def masked_leave(seen: _Seen) -> State | None:
    """Without the gross errors that mask one another, where a robust estimate finds them."""
    state, snooped = seen.state, seen.state.snooped
    if not snooped.robust or snooped.tried is not None or seen.wrong is not None:
        return None
    if (seen.chosen and seen.number not in MASKING_ROUNDS) or not is_suspect(seen.result):
        return None
    redundancy = seen.result.image_observations.redundancy
    tried = unmasked(state.block, seen.task.options, state.free, state.reasons, _guarded(state), redundancy)
    if tried is None:
        return None
    snooped = replace(snooped, tried=tried, before=state)
    return replace(state, block=tried.block, reasons=tried.reasons, snooped=snooped)


def suspects_leave(seen: _Seen) -> State | None:
    """Without the suspects of this round, and where they are single ones, without those that follow from these."""
    if not seen.chosen:
        return None
    reasons = with_rejected(seen.result, seen.state.reasons, np.array(seen.chosen), seen.size)
    state = replace(seen.state, reasons=reasons)
    if seen.wrong is None and not _guarded(state).any() and is_spread(seen.result, seen.chosen, seen.suspects):
        return _leaving(state, seen)
    return state


def points_return(seen: _Seen) -> State | None:
    """With points that left while gross errors bent the block, intersected anew."""
    state, done = seen.state, seen.state.snooped.intersected
    again = reintersected(seen.result, state.block, set(done))
    if again is None:
        return None
    block, reasons, found = again
    return replace(state, block=block, reasons=reasons, snooped=replace(state.snooped, intersected=done | found))


def innocent_return(seen: _Seen) -> State | None:
    """With rejected observations that are no blunders beside the others."""
    back = frozenset(innocent(seen.result)) - seen.state.snooped.returned
    return _returning(_back(seen.state, back), seen) if back else None


def nothing_changes(seen: _Seen) -> State:
    """Settled, with what there is to know of the end."""
    notices = tuple(n for n in seen.state.notices if n.code not in OF_THE_END)
    return replace(seen.state, notices=notices, settled=True).noted(
        *(() if seen.wrong is None else (kept_notice(seen.wrong),)),
        *masked_notices(seen.result, seen.state.snooped.tried),
        *rejected_group_notices(seen.result),
        *exchanged_notices(seen.result),
    )


DECISIONS = (control_leaves, masked_leave, suspects_leave, points_return, innocent_return, nothing_changes)
"""In the order in which they are asked: the first that changes anything decides a round"""


def _guarded(state: State) -> Mask:
    """(m,) rays that no test rejects."""
    guarded = state.snooped.guarded
    return np.zeros(len(state.block.observations), bool) if guarded is None else guarded


def _leaving(state: State, seen: _Seen) -> State:
    """Without what becomes suspect without a few observations, by their redundancy numbers in the last result.

    The next round tests with its own.  It also decides of points that have lost a ray since then.
    """
    point = state.block.observations.point
    without = set(point[seen.chosen].tolist())
    for _ in range(ROUNDS):
        now = _nearby(state, seen.task)
        if now is None:
            return state
        state = replace(state, block=as_start(state.block, now.adjusted), reasons=now.image_observations.rejected)
        size = tau_values(seen.result, now)
        suspects = np.flatnonzero(size > now.critical_tau)
        chosen = apart(state.block, size, suspects)
        if len(chosen) < len(suspects) or not without.isdisjoint(point[chosen].tolist()) or not chosen:
            return state
        without.update(point[chosen].tolist())
        state = replace(state, reasons=with_rejected(seen.result, state.reasons, np.array(chosen), size))
    return state


def _returning(state: State, seen: _Seen) -> State:
    """With what is no blunder any more beside those that have returned, until a test value is too large."""
    for _ in range(ROUNDS):
        now = _nearby(state, seen.task)
        if now is None:
            return state
        state = replace(state, block=as_start(state.block, now.adjusted), reasons=now.image_observations.rejected)
        back = frozenset(innocent(now)) - state.snooped.returned
        if not back or (tau_values(seen.result, now) > now.critical_tau).any():
            return state
        state = _back(state, back)
    return state


def _back(state: State, rows: frozenset[int]) -> State:
    snooped = replace(state.snooped, returned=state.snooped.returned | rows)
    return replace(state, reasons=without_reasons(state.reasons, rows), snooped=snooped)


def _nearby(state: State, task: Task) -> Adjustment | None:
    """An adjustment without a few observations of the last one, or with them; None where there is none."""
    try:
        return task.adjusted(state, "residuals", NEARBY)
    except NotSolvable:
        return None


def _may_be_torn(error: NotSolvable) -> bool:
    """Whether gross errors may be why there is no solution: no convergence, or points alone that are not determined."""
    torn = isinstance(error, RankDefect) and {u.kind for u in error.undetermined} == {"point"}
    return torn or isinstance(error, NoConvergence)
