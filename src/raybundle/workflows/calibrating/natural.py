"""Stage: calibration by the natural points of the object, where there are no targets."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from raybundle.adjustment.options import NoiseModel
from raybundle.adjustment.result import Notice
from raybundle.pipeline.stage import Means, Stage
from raybundle.settings import option
from raybundle.workflows.calibrate_state import CALIBRATE, Adjusted, CalibrateState, Reasons
from raybundle.workflows.recognise import Recognised

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
    from raybundle.placing.marks import Given  # noqa: PLC0415  (loaded only where they are used, as features are)
    from raybundle.workflows.orient import OrientOptions, orient  # noqa: PLC0415

    done = orient(
        i.paths, means.project.folder / FOLDER,
        OrientOptions(jobs=means.jobs, separate=i.separate, noise=i.noise, masks=i.masks),
        given=Given(gps=False), progress=means.progress,
    )  # fmt: skip
    told = Notice(code="no_targets", message=_no_targets(i.shown))
    adjustment = replace(done.adjustment, notices=(told, *done.adjustment.notices))
    adjusted = Adjusted(adjustment=adjustment, groups=done.groups, lost=done.not_oriented)
    return Natural(adjusted=adjusted, refused=done.refused)


def _no_targets(shown: Recognised) -> str:
    """Why natural points were taken, and what to do."""
    looked = f"{len(shown.looked_at)} photographs that were looked at ({', '.join(shown.looked_at)})"
    if shown.few:
        return (
            f"fewer than half of the {looked} show targets, of {', '.join(shown.few)}: calibrated by natural points, "
            "which are several times less precise. Put the photographs of targets into a folder of their own, or name "
            f"them: {option('target', shown.few[0])}"
        )
    return (
        f"no coded targets and no board are seen in the {looked}: calibrated by natural points, which are several "
        "times less precise. If others show some, name what was photographed, as "
        f"{option('target', 'chessboard-12x9')} or "
        f"{option('target', 'aicon14')}, and put their photographs into a folder of their own"
    )


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
        told=lambda _: "by natural points",
        when=lambda s: not s.targets,
    )
)
