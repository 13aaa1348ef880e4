"""The state that decisions pass on, and the loop that adjusts a block and asks them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Protocol

from raybundle.adjustment.decision.masking import Unmasked
from raybundle.adjustment.estimation import Start
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.result_figures import Extent
from raybundle.adjustment.statistics.fields import Components
from raybundle.adjustment.system.adjusted_values import as_start
from raybundle.block import Block, Camera
from raybundle.block.rejection import Rejections
from raybundle.errors import NotSolvable
from raybundle.numerics.arrays import Mask
from raybundle.numerics.progress import Progress


@dataclass(frozen=True, slots=True, kw_only=True)
class Snooped:
    """What rounds of data snooping remember."""

    returned: frozenset[int] = frozenset()
    """rejected rows that came back: they do so once"""
    guarded: Mask | None = None
    """(m,) rays to control whose rejection would leave the datum open; None: no ray"""
    tried: Unmasked | None = None
    """what a robust estimate found"""
    robust: bool = True
    """whether a robust estimate may be tried"""
    intersected: frozenset[int] = frozenset()
    """points that were intersected anew"""
    before: State | None = None
    """the state before a robust estimate that no adjustment has confirmed yet"""


@dataclass(frozen=True, slots=True, kw_only=True)
class State:
    """A block with what is decided of it so far."""

    block: Block
    """with the values of the last adjustment"""
    free: dict[str, tuple[str, ...]]
    """camera id -> parameters that are estimated"""
    reasons: Rejections
    """of image observations that take no part"""
    start: Start = "approximate"
    """adjusted: the block's values come from an adjustment of nearly the same"""
    notices: tuple[Notice, ...] = ()
    not_significant: tuple[tuple[str, str], ...] = ()
    """camera and symbol"""
    not_determinable: tuple[tuple[str, str], ...] = ()
    settled: bool = False
    """whether the decisions that are being asked change nothing more"""
    snooped: Snooped = Snooped()
    noise: Components | None = None
    """smooth errors, as found last"""

    def freed(self, camera: str, symbols: tuple[str, ...]) -> State:
        """With these parameters of a camera free."""
        return replace(self, free={**self.free, camera: symbols})

    def held(self, camera: str, values: Mapping[str, float]) -> State:
        """With parameters of a camera held at these values."""
        cameras = tuple(replace(c, values={**c.values, **values}) if c.id == camera else c for c in self.block.cameras)
        left = tuple(s for s in self.free[camera] if s not in values)
        return replace(self.freed(camera, left), block=replace(self.block, cameras=cameras))

    def noted(self, *notices: Notice) -> State:
        """With these notices."""
        return replace(self, notices=(*self.notices, *notices))

    def camera(self, name: str) -> Camera:
        """The camera of this id."""
        return next(c for c in self.block.cameras if c.id == name)


class Adjusting(Protocol):
    """Adjusts a block as `adjust_block` does, as far as decisions ask."""

    def __call__(
        self, block: Block, options: AdjustmentOptions, progress: Progress, *, free: dict[str, tuple[str, ...]],
        rejected: Rejections, extent: Extent, start: Start,
    ) -> Adjustment:  # fmt: skip
        """The result, with these image observations rejected and these parameters free."""
        ...


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """What is asked of all decisions on a block."""

    options: AdjustmentOptions
    automatic: tuple[str, ...]
    """cameras of which it is decided which parameters are estimated"""
    kept_free: frozenset[tuple[str, str]]
    """camera, symbol: estimated in any case"""
    known: Mapping[str, Mapping[str, float]]
    """By camera, what was known before anything was measured: where what is not determinable is held"""
    adjusting: Adjusting
    progress: Progress = field(repr=False)

    def adjusted(self, state: State, extent: Extent, tolerance: float = 1e-4) -> Adjustment:
        """An adjustment on the way to a decision."""
        brief = replace(
            self.options, statistics=extent != "residuals", robust_start=state.start == "approximate",
            tolerance=max(self.options.tolerance, tolerance),
        )  # fmt: skip
        return self.adjusting(
            state.block, brief, self.progress, free=state.free, rejected=state.reasons, extent=extent,
            start=state.start,
        )  # fmt: skip


class Phase(Protocol):
    """Decisions that are asked after each of some adjustments."""

    rounds: int
    """adjustments at most"""
    extent: Extent
    """of their statistics"""

    def decide(self, state: State, result: Adjustment, number: int, task: Task) -> State:
        """What to change after round `number`; settled where nothing is."""
        ...

    def unsolved(self, state: State, error: NotSolvable, task: Task) -> State | None:
        """What to change where there is no adjustment; None: nothing can be."""
        ...

    def unfinished(self, state: State, task: Task) -> Notice:
        """That the rounds did not suffice."""
        ...


def settle(phase: Phase, state: State, task: Task) -> State:
    """Adjust and ask the decisions of a phase what to change, until they settle."""
    for number in range(phase.rounds):
        try:
            result = task.adjusted(state, phase.extent)
        except NotSolvable as error:
            changed = phase.unsolved(state, error, task)
            if changed is None:
                raise
            state = changed
            continue
        state = replace(state, block=as_start(state.block, result.adjusted), start="adjusted")
        state = phase.decide(state, result, number, task)
        if state.settled:
            return replace(state, settled=False)
    return state.noted(phase.unfinished(state, task))
