"""Decisions: which observations are blunders, which parameters of the interior orientation are worth estimating.

Every decision is listed with its reason; nothing is decided that the options do not ask for.  The order of the phases
is here; what is rejected is decided in `blunder_rejection`, against the limit `critical_tau` of `result_figures`.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, replace

from raybundle.adjustment.blunders.pixel_shape import under_its_noise
from raybundle.adjustment.decision.blunder_rejection import Snooping
from raybundle.adjustment.decision.parameter_choice import Choice, all_free, hold_next
from raybundle.adjustment.decision.previous_knowledge import against_known
from raybundle.adjustment.decision.state import Adjusting, Snooped, State, Task, settle
from raybundle.adjustment.engine import adjust_block, free_parameters
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.result_figures import Extent
from raybundle.adjustment.system.chosen_parameters import check_asked, with_asked
from raybundle.block import Block
from raybundle.block.rejection import Rejections, given_rejections
from raybundle.block.stored import is_observed_jointly
from raybundle.errors import RankDefect
from raybundle.numerics.progress import Progress, silent


@dataclass(frozen=True, slots=True, kw_only=True)
class Earlier:
    """What data snooping decided of nearly the same block: it goes on from there."""

    reasons: Rejections
    """of image observations"""
    returned: frozenset[int]
    """rejected rows that have come back once, in vain"""


def decide(
    block: Block, options: AdjustmentOptions, progress: Progress = silent, *, notices: tuple[Notice, ...] = (),
    earlier: Earlier | None = None, extent: Extent = "report",
) -> Adjustment:  # fmt: skip
    """Adjust a block with approximate values, with the decisions that the options and the block ask for.

    extent  of the statistics of the result, as of `adjust_block`
    """
    began = time.perf_counter()
    state = decisions(block, options, adjust_block, progress, earlier)
    final = replace(options, robust_start=options.robust_start and state.block is block)
    result = adjust_block(
        state.block, final, progress, free=state.free, rejected=state.reasons, notices=(*notices, *state.notices),
        start="approximate" if state.block is block else "adjusted", extent=extent,
    )  # fmt: skip
    result = against_known(_labelled(under_its_noise(result), state))
    return replace(result, given=block, options=options, seconds=time.perf_counter() - began)


def decisions(
    block: Block, options: AdjustmentOptions, adjusting: Adjusting, progress: Progress = silent,
    earlier: Earlier | None = None,
) -> State:  # fmt: skip
    """What is decided of a block with approximate values, with the values that this led to.

    adjusting  who adjusts it on the way
    """
    check_asked(block, options)
    task = Task(
        options=options,
        automatic=tuple(
            c.id
            for c in block.cameras
            if c.scene is None
            and (c.estimate == "auto" or (options.estimate == "auto" and c.estimate and not is_observed_jointly(c)))
        ),
        kept_free=frozenset(options.free),
        known={c.id: {**c.values, **{s: v for s, v in c.known.items() if s in c.values}} for c in block.parametrised},
        adjusting=adjusting,
        progress=progress,
    )
    state = State(
        block=block,
        free={c.id: with_asked(c, free_parameters(c), options) for c in block.parametrised},
        reasons=given_rejections(block) if earlier is None else earlier.reasons,
        snooped=Snooped() if earlier is None else Snooped(returned=earlier.returned),
    )
    snooping = options.reject == "snooping"
    if snooping:
        state = _snooped_where_determined(state, task)
    if task.automatic:
        before = _model(state, task)
        state = settle(Choice(), all_free(state, task), task)
        if snooping and _model(state, task) != before:
            state = settle(Snooping(), replace(state, snooped=Snooped()), task)
    return state


def _model(state: State, task: Task) -> list[tuple[set[str], dict[str, float]]]:
    """Of each automatic camera what is estimated, and the values of what is not: blunders are judged beside these."""
    cameras = [state.camera(name) for name in task.automatic]
    free = [set(state.free[c.id]) for c in cameras]
    return [(f, {s: v for s, v in c.values.items() if s not in f and v}) for f, c in zip(free, cameras, strict=True)]


def _snooped_where_determined(state: State, task: Task) -> State:
    """Without blunders; parameters that make the block singular are held first, the least needed ones before others."""
    while True:
        try:
            return settle(Snooping(), state, task)
        except RankDefect as error:
            held = hold_next(state, error, task)
            if held is None:
                raise
            state = held


def _labelled(result: Adjustment, state: State) -> Adjustment:
    """The result with the decisions in its parameter tables."""
    status = dict.fromkeys(state.not_significant, "not significant")
    status |= dict.fromkeys(state.not_determinable, "not determinable")
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
    names = tuple(f"{s} (camera {c})" for c, s in state.not_determinable)
    return replace(
        result,
        interior=interior,
        not_determinable=tuple(dict.fromkeys((*result.not_determinable, *names))),
        not_significant=tuple(f"{s} (camera {c})" for c, s in state.not_significant),
    )
