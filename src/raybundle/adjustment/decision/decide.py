"""Decisions: which observations are blunders, which parameters of the interior orientation are worth estimating.

Every decision is listed with its reason; nothing is decided that the options do not ask for.
"""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np

from raybundle.adjustment.blunders.exchanged_points import exchanged_notices
from raybundle.adjustment.blunders.pixel_shape import under_its_noise
from raybundle.adjustment.blunders.reintersection import reintersected
from raybundle.adjustment.blunders.rejected_groups import rejected_group_notices
from raybundle.adjustment.decision.masking import Unmasked, is_suspect, masked_notices, unmasked
from raybundle.adjustment.decision.parameter_choice import Adjusting, Decisions, choose, hold_next, quiet, with_values
from raybundle.adjustment.decision.previous_knowledge import against_known
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
from raybundle.adjustment.decision.wrong_control import (
    WrongControl,
    judged,
    kept_notice,
    left_out,
    rejected_notice,
    suspected,
)
from raybundle.adjustment.engine import adjust_block, free_parameters
from raybundle.adjustment.estimation import Start
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.adjusted_values import as_start
from raybundle.adjustment.system.chosen_parameters import check_asked, with_asked
from raybundle.block import Block
from raybundle.block.rejection import Rejections, given_rejections
from raybundle.block.stored import is_observed_jointly
from raybundle.errors import DatumDefect, NoConvergence, NotSolvable, RankDefect
from raybundle.numerics.progress import Progress, silent

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


def decide(
    block: Block, options: AdjustmentOptions, progress: Progress = silent, *, notices: tuple[Notice, ...] = ()
) -> Adjustment:
    """Adjust a block with approximate values, with the decisions that the options and the block ask for."""
    began = time.perf_counter()
    start, choices = decisions(block, options, adjust_block, progress)
    final = replace(options, robust_start=options.robust_start and start is block)
    result = adjust_block(
        start, final, progress, free=choices.free, rejected=choices.reasons, notices=(*notices, *choices.notices),
        start="approximate" if start is block else "adjusted",
    )  # fmt: skip
    result = against_known(_labelled(under_its_noise(result), choices))
    return replace(result, given=block, options=options, seconds=time.perf_counter() - began)


def decisions(
    block: Block, options: AdjustmentOptions, adjusting: Adjusting, progress: Progress = silent
) -> tuple[Block, Decisions]:
    """What is decided of a block with approximate values, and the block with the values that this led to.

    adjusting  who adjusts it on the way
    """
    check_asked(block, options)
    choices = Decisions(
        free={c.id: with_asked(c, free_parameters(c), options) for c in block.parametrised},
        reasons=given_rejections(block),
        kept_free=frozenset(options.free),
        known={c.id: {**c.values, **{s: v for s, v in c.known.items() if s in c.values}} for c in block.parametrised},
        adjusting=adjusting,
    )
    automatic = [
        c.id
        for c in block.cameras
        if c.scene is None
        and (c.estimate == "auto" or (options.estimate == "auto" and c.estimate and not is_observed_jointly(c)))
    ]
    start = block
    if options.reject == "snooping":
        start = _snoop_what_is_determined(start, options, choices, automatic, progress)
    if automatic:
        start = choose(start, options, choices, automatic, progress)
        if options.reject == "snooping":
            start = _snoop(start, options, choices, progress, start="adjusted")
    return start, choices


def _snoop_what_is_determined(
    block: Block, options: AdjustmentOptions, choices: Decisions, automatic: list[str], progress: Progress
) -> Block:
    """As `_snoop`; parameters that make the block singular are held first, the least needed ones before the others."""
    while True:
        try:
            return _snoop(block, options, choices, progress)
        except RankDefect as error:
            held = hold_next(block, choices, automatic, error)
            if held is None:
                raise
            block = with_values(block, *held)


def _snoop(
    block: Block, options: AdjustmentOptions, choices: Decisions, progress: Progress, *, start: Start = "approximate"
) -> Block:
    """Reject blunders in rounds, each round those that do not touch one another; then let rejected ones return.

    Test: tau = v / (sigma0 s sqrt r), largest of the two coordinates of an image point, against the family-wise
    critical value (Pope 1976).  A rejected observation returns once if its residual is below that limit.  Where
    rejections would leave position, orientation or scale open, it is the control that contradicts: its image
    observations return and stay, and the contradiction is reported.
    """
    returned: set[int] = set()
    guarded = np.zeros(len(block.observations), bool)
    tried: Unmasked | None = None
    before: tuple[Block, Rejections] | None = None
    robust = True
    tried_again: set[int] = set()
    for number in range(ROUNDS):
        try:
            result = quiet(block, options, choices, progress, extent="tests", start=start)
        except NotSolvable as error:
            if before is not None:  # without what a robust estimate left out the block is not determined
                block, choices.reasons, tried, before, robust = *before, None, None, False
                continue
            if robust and tried is None and _may_be_torn(error):
                tried = unmasked(block, options, choices.free, choices.reasons, guarded)
                if tried is not None:
                    block, choices.reasons, start = tried.block, tried.reasons, "adjusted"
                    continue
            if not isinstance(error, DatumDefect):
                raise
            guarded = np.asarray(block.points.is_control.any(axis=1))[block.observations.point]
            back = [i for i, r in enumerate(choices.reasons) if is_blunder(r) and guarded[i]]
            if not back:
                raise
            returned.update(back)
            choices.reasons = without_reasons(choices.reasons, back)
            continue
        start, before = "adjusted", None
        block = as_start(block, result.adjusted)
        choices.reasons = result.image_observations.rejected
        size = np.nan_to_num(np.abs(result.image_observations.t).max(axis=1))
        suspects = np.flatnonzero((size > result.critical_tau) & ~guarded)
        wrong = _wrong_control(result, choices, float(size.max(initial=0.0)))
        if wrong is not None and wrong.may_go:
            block, choices.reasons = left_out(block, wrong.name, choices.reasons)
            choices.notices.append(rejected_notice(wrong))
            continue
        if wrong is not None:  # it is the points that are wrong, not their image observations
            taken = [block.points.ids.index(name) for name in (wrong.name, *wrong.others)]
            suspects = suspects[~np.isin(block.observations.point[suspects], taken)]
        suspects = suspects[~bent_by_distances(result, suspects, size)]
        chosen = apart(block, size, suspects)
        stuck = not chosen or number in MASKING_ROUNDS
        if robust and tried is None and wrong is None and stuck and is_suspect(result):
            r = result.image_observations.redundancy
            tried = unmasked(block, options, choices.free, choices.reasons, guarded, r)
            if tried is not None:
                before = block, choices.reasons
                block, choices.reasons = tried.block, tried.reasons
                continue
        if not chosen:
            again = reintersected(result, block, tried_again)
            if again is not None:
                block, choices.reasons, found = again
                tried_again |= found
                continue
            back = [i for i in innocent(result) if i not in returned]
            if not back:
                choices.notices = [n for n in choices.notices if n.code not in OF_THE_END]
                choices.notices += [] if wrong is None else [kept_notice(wrong)]
                choices.notices += [*masked_notices(result, tried), *rejected_group_notices(result)]
                choices.notices += exchanged_notices(result)
                return block
            returned.update(back)
            choices.reasons = without_reasons(choices.reasons, back)
            block = _returning(block, options, choices, result, returned, progress)
            continue
        choices.reasons = with_rejected(result, choices.reasons, np.array(chosen), size)
        if wrong is None and not guarded.any() and is_spread(result, chosen, suspects):
            block = _leaving(block, options, choices, result, chosen, progress)
    choices.notices.append(Notice(code="snooping_unfinished", values={"rounds": ROUNDS}))
    return block


def _leaving(
    block: Block, options: AdjustmentOptions, choices: Decisions, result: Adjustment, chosen: list[int],
    progress: Progress,
) -> Block:  # fmt: skip
    """Reject what becomes suspect without a few observations, by their redundancy numbers in `result`.

    The next round tests with its own.  It also decides of points that have lost a ray since `result`.
    """
    point = block.observations.point
    without = set(point[chosen].tolist())
    for _ in range(ROUNDS):
        now = _nearby(block, options, choices, progress)
        if now is None:
            return block
        block, choices.reasons = as_start(block, now.adjusted), now.image_observations.rejected
        size = tau_values(result, now)
        suspects = np.flatnonzero(size > now.critical_tau)
        chosen = apart(block, size, suspects)
        if len(chosen) < len(suspects) or not without.isdisjoint(point[chosen].tolist()) or not chosen:
            return block
        without.update(point[chosen].tolist())
        choices.reasons = with_rejected(result, choices.reasons, np.array(chosen), size)
    return block


def _returning(
    block: Block, options: AdjustmentOptions, choices: Decisions, result: Adjustment, returned: set[int],
    progress: Progress,
) -> Block:  # fmt: skip
    """Let return what is no blunder any more with those that have returned, until a test value is too large."""
    for _ in range(ROUNDS):
        now = _nearby(block, options, choices, progress)
        if now is None:
            return block
        block, choices.reasons = as_start(block, now.adjusted), now.image_observations.rejected
        back = [i for i in innocent(now) if i not in returned]
        if not back or (tau_values(result, now) > now.critical_tau).any():
            return block
        returned.update(back)
        choices.reasons = without_reasons(choices.reasons, back)
    return block


def _nearby(block: Block, options: AdjustmentOptions, choices: Decisions, progress: Progress) -> Adjustment | None:
    """An adjustment without a few observations of the last one, or with them; None where there is none."""
    try:
        return quiet(block, options, choices, progress, extent="residuals", tolerance=NEARBY)
    except NotSolvable:
        return None


def _may_be_torn(error: NotSolvable) -> bool:
    """Whether gross errors may be why there is no solution: no convergence, or points alone that are not determined."""
    torn = isinstance(error, RankDefect) and {u.kind for u in error.undetermined} == {"point"}
    return torn or isinstance(error, NoConvergence)


def _wrong_control(result: Adjustment, choices: Decisions, largest: float) -> WrongControl | None:
    """The control point that contradicts the others more than any image observation does, and what is known of it.

    More: letting it go takes more from the square sum than leaving out the image coordinate with the largest tau.
    """
    worst = suspected(result)
    if worst is None or worst.square <= (largest * result.sigma0) ** 2:
        return None
    return judged(result, worst, choices.free, choices.reasons)


def _labelled(result: Adjustment, choices: Decisions) -> Adjustment:
    """The result with the decisions in its parameter tables."""
    status = dict.fromkeys(choices.not_significant, "not significant")
    status |= dict.fromkeys(choices.not_determinable, "not determinable")
    interior = tuple(
        replace(
            i,
            parameters={
                s: replace(p, status=status[i.camera, s]) if (i.camera, s) in status else p
                for s, p in i.parameters.items()
            },
        )
        for i in result.interior
    )
    names = tuple(f"{s} (camera {c})" for c, s in choices.not_determinable)
    return replace(
        result,
        interior=interior,
        not_determinable=tuple(dict.fromkeys((*result.not_determinable, *names))),
        not_significant=tuple(f"{s} (camera {c})" for c, s in choices.not_significant),
    )
