"""Stage: calibration by the natural points of the object, where there are no targets."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import NoiseModel
from raybundle.pipeline.stage import Means, Stage
from raybundle.workflows.calibrating.recognise import Recognised
from raybundle.workflows.calibrating.state import CALIBRATE, Adjusted, CalibrateState, Reasons

FOLDER = "natural"
"""project of the natural points, in that of the calibration"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What is asked for."""

    paths: tuple[Path, ...]
    shown: Recognised
    separate: tuple[str, ...]
    noise: NoiseModel
    masks: Path | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Natural:
    """What natural points give."""

    adjusted: Adjusted
    refused: Reasons


def _inputs(state: CalibrateState) -> Inputs:
    assert state.shown is not None
    o = state.options
    return Inputs(paths=state.inputs, shown=state.shown, separate=o.separate, noise=o.noise, masks=o.masks)


def orient_natural(i: Inputs, means: Means) -> Natural:
    """Orient the photographs by their natural points, in a project of its own."""
    from raybundle.placing.marks import Given
    from raybundle.workflows.orient import OrientOptions, orient

    done = orient(
        i.paths, means.project.folder / FOLDER,
        OrientOptions(jobs=means.jobs, own_camera=i.separate, library=False, noise=i.noise, masks=i.masks),
        given=Given(gps=False), progress=means.progress,
    )  # fmt: skip
    adjustment = replace(done.adjustment, notices=(_no_targets(i.shown), *done.adjustment.notices))
    adjusted = Adjusted(adjustment=adjustment, groups=done.groups, lost=done.not_oriented)
    return Natural(adjusted=adjusted, refused=done.refused)


def _no_targets(shown: Recognised) -> Notice:
    """Why natural points were taken, and what to do."""
    looked = {"n": len(shown.looked_at), "names": list(shown.looked_at)}
    if shown.few:
        values = {**looked, "families": list(shown.few), "first": shown.few[0]}
        return Notice(code="no_targets.few", values=values)
    return Notice(code="no_targets", values=looked)


def _put(state: CalibrateState, done: Natural) -> CalibrateState:
    return replace(state, adjusted=done.adjusted, groups=done.adjusted.groups, refused=done.refused)


STAGE = CALIBRATE.register(
    Stage(
        name="natural",
        line="adjustment",
        after=("adjustment",),
        inputs=_inputs,
        function=orient_natural,
        put=_put,
        reported=lambda _: "by natural points",
        when=lambda s: not s.targets,
    )
)
