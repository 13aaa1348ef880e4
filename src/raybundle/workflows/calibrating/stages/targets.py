"""Stage: targets measured in the photographs."""

from __future__ import annotations

from dataclasses import dataclass, replace

from raybundle.io.photos.photo import Photo
from raybundle.pipeline.stage import Means, Stage
from raybundle.targets.marks import Marks, Target
from raybundle.workflows.calibrating.state import CALIBRATE, CalibrateState
from raybundle.workflows.target_tasks import measure_targets


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What is measured."""

    photos: tuple[Photo, ...]
    targets: tuple[Target, ...]


def measure(i: Inputs, means: Means) -> tuple[tuple[Marks, ...], ...]:
    """Each photograph is measured by a task of its own."""
    return measure_targets(means, i.photos, i.targets)


def _outcome(state: CalibrateState) -> str:
    read = sum(int(m.named.sum()) for sets in state.marks for m in sets)
    return f"{read} points of {', '.join(t.title for t in state.targets)}"


STAGE = CALIBRATE.register(
    Stage(
        name="targets",
        after=("recognised",),
        inputs=lambda s: Inputs(photos=s.photos, targets=s.targets),
        function=measure,
        put=lambda s, marks: replace(s, marks=marks),
        reported=_outcome,
        when=lambda s: bool(s.targets),
    )
)
