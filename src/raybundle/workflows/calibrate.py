"""Calibration of cameras from photographs of targets or boards: free network, circle centres, model, one camera or two.

The steps: targets are measured; a board, or pairs of photographs, give the start; dots whose code could not be read are
found where they must be; photographs of two cameras are distinguished; the distortion model is chosen; the centres of
ellipses are corrected; parameters are chosen by significance and determinability, blunders rejected.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from tempfile import TemporaryDirectory

from raybundle.errors import InputError
from raybundle.numerics.progress import Progress, silent
from raybundle.pipeline.executors import Threads
from raybundle.pipeline.project import Project, StageRecord
from raybundle.pipeline.stage import Run
from raybundle.sensors import sensor_models
from raybundle.workflows.calibrating.options import CalibrateOptions
from raybundle.workflows.calibrating.stages import CALIBRATE
from raybundle.workflows.calibrating.state import CalibrateState, Calibration

__all__ = ["CalibrateOptions", "Calibration", "calibrate"]


def calibrate(
    inputs: Sequence[Path], options: CalibrateOptions | None = None, progress: Progress = silent, *,
    folder: Path | None = None,
) -> Calibration:  # fmt: skip
    """Calibrate the cameras of photographs of targets.

    inputs  folders and files; targets stand anywhere, flat or in depth, their places need not be known
    folder  project folder, where finished stages are kept and taken from; None: nothing is kept
    raises  InputError where too few targets are found; NotSolvable where they orient no photographs

    A name must occur once on the object.  Limits: the calibration holds for the zoom and focus of the
    photographs, and for the part of the format in which targets were seen.
    """
    options = options or CalibrateOptions()
    _check_model(options.model)
    jobs = options.jobs or os.cpu_count() or 1
    with ExitStack() as stack:
        kept = Path(stack.enter_context(TemporaryDirectory())) / "calibration" if folder is None else folder
        project = Project.open(kept)
        stack.callback(project.close)
        run = Run(project=project, executor=Threads(jobs), progress=progress, jobs=jobs)
        state = run.workflow(CALIBRATE, CalibrateState(inputs=tuple(inputs), options=options))
        return _calibration(state, project.records)


def _calibration(state: CalibrateState, records: Sequence[StageRecord]) -> Calibration:
    """What the last state states."""
    a, found, start = state.adjusted, state.found, state.start
    assert a is not None
    assert found is not None
    return Calibration(
        adjustment=a.adjustment,
        quality=state.quality,
        photos=found.photos,
        groups=state.groups,
        refused=state.refused,
        not_used=(*(() if start is None else start.given.not_used), *a.lost),
        marks=state.marks,
        targets=state.targets,
        completed=a.completed,
        dots=a.dots,
        largest_eccentricity_px=a.largest_eccentricity_px,
        radius=a.radius,
        seconds={r.name: r.seconds for r in records},
    )


def _check_model(name: str) -> None:
    """Raise InputError for what is not the interior orientation of a camera with a plane sensor."""
    if name != "auto" and name not in sensor_models:
        raise InputError(
            "camera.calibration_model_unknown",
            model=name,
            known=["auto", *sorted(n for n, m in sensor_models.items() if m.one_exposure)],
        )
    if name != "auto" and not sensor_models[name].one_exposure:
        raise InputError(
            "camera.not_by_targets",
            model=name,
            known=["auto", *sorted(n for n, m in sensor_models.items() if m.one_exposure)],
        )
