"""Stage: whether the calibration is good, for what, and what to photograph next."""

from __future__ import annotations

from dataclasses import dataclass, replace

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.calibration.quality import CalibrationQuality, calibration_qualities
from raybundle.errors import NotSolvable
from raybundle.pipeline.stage import Means, Stage
from raybundle.planning.next.calibration import advised
from raybundle.workflows.calibrating.defects import flat_only
from raybundle.workflows.calibrating.state import CALIBRATE, CalibrateState


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What is judged."""

    adjustment: Adjustment
    measured: Block | None
    """targets as they were measured; None for natural points"""


def _inputs(state: CalibrateState) -> Inputs:
    assert state.adjusted is not None
    measured = None if state.start is None else state.start.given.block
    return Inputs(adjustment=state.adjusted.adjustment, measured=measured)


def judge(i: Inputs, means: Means) -> tuple[CalibrationQuality, ...]:
    """A verdict for each camera; raises NotSolvable where flat, square views determine none."""
    quality = calibration_qualities(i.adjustment, means.progress)
    if i.measured is not None and all(q.grade == "not determinable" for q in quality):
        why = flat_only(i.measured)
        if why is not None:
            raise NotSolvable(why)
    means.progress("proposals", 0.0)
    found = tuple(advised(q, i.adjustment) for q in quality)
    means.progress("proposals", 1.0)
    return found


STAGE = CALIBRATE.register(
    Stage(
        name="verdict",
        after=("natural",),
        inputs=_inputs,
        function=judge,
        put=lambda s, q: replace(s, quality=q),
        reported=lambda s: "; ".join(q.grade for q in s.quality),
    )
)
