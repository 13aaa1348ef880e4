"""From photographs and satellite scenes to an oriented block with its report, in stages that can be stopped."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from raybundle.adjustment.records.options import RejectMode
from raybundle.adjustment.result import Adjustment
from raybundle.block import Camera
from raybundle.errors import InputError, text_json
from raybundle.io.geo.coordinate_systems import LocalFrame
from raybundle.io.photos.cameras import CameraGroup
from raybundle.io.photos.photo import Photo
from raybundle.io.trajectories import Trajectory
from raybundle.matching.methods import feature_method
from raybundle.matching.verify import VerifiedPair
from raybundle.numerics.counting import counted
from raybundle.numerics.progress import Progress, silent
from raybundle.pipeline.choosing import executor_for
from raybundle.pipeline.project import Project, StageRecord
from raybundle.pipeline.stage import Run, Stage
from raybundle.placing.marks import Given
from raybundle.placing.upright import Upright
from raybundle.ties.block import image_sigma_px
from raybundle.ties.match_weights import Matches
from raybundle.ties.precise import Weights
from raybundle.workflows.final_adjustment import left_out
from raybundle.workflows.orienting.connected_components import ConnectedComponent, component_folder
from raybundle.workflows.orienting.excluded_features import Dropped
from raybundle.workflows.orienting.options import PIXELS_GB, OrientOptions
from raybundle.workflows.orienting.previous_names import Earlier
from raybundle.workflows.orienting.stages import ORIENT
from raybundle.workflows.orienting.state import Asked, OrientState
from raybundle.workflows.photograph_contents import CONTENTS
from raybundle.workflows.scenes.images import SceneImage
from raybundle.workflows.scenes.ties import ScenePair

__all__ = ["OrientOptions", "Orientation", "component_folder", "orient", "stages"]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Orientation:
    """What came of the photographs."""

    adjustment: Adjustment
    photos: tuple[Photo, ...]
    groups: tuple[CameraGroup, ...]
    refused: tuple[tuple[str, str], ...]
    """files that are no usable photographs, and why"""
    not_oriented: tuple[tuple[str, str], ...]
    """photographs without orientation, and why"""
    pairs: tuple[VerifiedPair, ...]
    stages: tuple[StageRecord, ...]
    sigma_px: float
    """standard deviation of an image coordinate, from the residuals"""
    weights: Weights | None
    frame: LocalFrame | None
    """coordinate system of object space; None: a free system"""
    other_components: tuple[ConnectedComponent, ...] = ()
    """further parts of the photographs that nothing joins to the first"""
    scenes: tuple[SceneImage, ...] = ()
    """satellite scenes that take part"""
    scene_pairs: tuple[ScenePair, ...] = ()
    remarks: tuple[str, ...] = field(default=())
    wide_baselines: Mapping[str, object] = field(default_factory=dict[str, object])
    """CPU budget of further matching, and what each method gave; empty: none was needed"""
    upright: Upright | None = None
    """how the vertical was found, where neither control nor positions show it"""
    dropped: Dropped | None = None
    """what became of the photographs' features before the adjustment"""
    matches: tuple[Matches, ...] = ()
    """what the variances of image points depend on, of every part; (): nothing was matched precisely"""

    def __repr__(self) -> str:
        """One line."""
        parts = f" in {1 + len(self.other_components)} parts" if self.other_components else ""
        return (
            f"<Orientation of {self.oriented} of {counted(len(self.photos), 'photograph')}{parts}: {self.adjustment!r}>"
        )

    def _repr_html_(self) -> str:
        """For notebooks: that of its adjustment."""
        return self.adjustment._repr_html_()  # pyright: ignore[reportPrivateUsage]

    @property
    def oriented(self) -> int:
        """Number of photographs with an orientation, in whatever part."""
        photographs = {p.name for p in self.photos}
        return len(self.photos) - sum(1 for n, _ in self.not_oriented if n in photographs)

    @property
    def oriented_scenes(self) -> int:
        """Number of scenes in the adjustment."""
        lost = {n for n, _ in self.not_oriented}
        return sum(1 for s in self.scenes if s.name not in lost)

    @property
    def given(self) -> int:
        """Number of files that are photographs or scenes, refused ones included."""
        names = {p.name for p in self.photos} | {s.name for s in self.scenes} | {n for n, _ in self.not_oriented}
        return len(names) + len(self.refused)

    def additions(self) -> dict[str, object]:
        """What result.json states beside the adjustment."""
        lost = [{"file": f, "reason": r, **text_json(r)} for f, r in (*self.refused, *self.not_oriented)]
        return {
            "images": {
                "given": self.given,
                "oriented": self.oriented + self.oriented_scenes,
                "not_oriented": lost,
            },
            "components": 1 + len(self.other_components),
            "stages": [
                {k: v for k, v in asdict(s).items() if k in _STAGE_FIELDS} for s in self.stages
            ],
            **({"wide_baselines": self.wide_baselines} if self.wide_baselines else {}),
            "image_sigma_px": self.sigma_px,
            CONTENTS: {p.name: p.sha256 for p in self.photos},
            **({} if self.frame is None else {"frame": self.frame.as_mapping()}),
            **({} if self.upright is None else {"upright": self.upright.as_mapping()}),
            **({} if self.dropped is None else {"measurements": self.dropped.as_mapping(self.adjustment)}),
        }  # fmt: skip


_STAGE_FIELDS = ("name", "seconds", "cpu_seconds", "peak_memory_mb", "from_cache")


def orient(
    inputs: Sequence[Path],
    folder: Path,
    options: OrientOptions | None = None,
    *,
    calibration: Sequence[Camera] = (),
    given: Given | None = None,
    positions: Trajectory | None = None,
    earlier: Earlier | None = None,
    reject: RejectMode = "snooping",
    progress: Progress = silent,
) -> Orientation:
    """Orient photographs and satellite scenes within a project folder; finished stages are taken from there.

    inputs       folders and files
    folder       project folder; begun, or continued
    calibration  cameras whose interior orientation is known (`estimate` () holds it)
    given        control, check points, scale bars; GPS positions of the photographs place the block, or are observed
                 beside control
    positions    positions of the photographs from a file, in place of those that they state
    earlier      what an earlier run in the folder left: its tie points keep their names
    reject       none: gross errors stay in the final adjustment, of a block that is adjusted again
    raises       InputError, NoOrientation

    Limits: without control or scale bars the position, orientation and scale of the result are
    arbitrary; and a set of photographs whose parts look alike can be oriented wrongly with small residuals.
    """
    options = options or OrientOptions()
    given = given or Given()
    method = feature_method(options.features)
    jobs = options.jobs or os.cpu_count() or 1
    memory = (options.memory or PIXELS_GB) * 1e9
    executor = executor_for(options.cluster, jobs, memory, progress)
    project = Project.open(folder, store=options.store)
    run = Run(
        project=project,
        executor=executor,
        progress=progress,
        jobs=jobs,
        memory=memory,
        adjusting=options.memory * 1e9,
    )
    asked = Asked(
        inputs=tuple(inputs), name=folder.name, options=options, calibration=tuple(calibration), given=given,
        positions=positions, method=method, earlier=earlier, reject=reject,
    )  # fmt: skip
    try:
        project.products.place.check()
        if options.redo_from:
            run.forget(_to_be_redone(options.redo_from))
        return _orientation(run.workflow(ORIENT, OrientState(asked=asked, given=given, method=method)), project.records)
    finally:
        project.close()


def stages() -> tuple[str, ...]:
    """What the stages are called, in order; the report is written by the command."""
    return (*ORIENT.titles(), "report")


def _to_be_redone(title: str) -> tuple[Stage[OrientState, Any, Any], ...]:
    """The stages from one of this title on; raises InputError where there is none."""
    if title == "report":
        return ()
    if title not in ORIENT.titles():
        raise InputError("value.not_one_of", entry="stage", given=title, known=list(stages()))
    return ORIENT.from_title(title)


def _orientation(state: OrientState, records: Sequence[StageRecord]) -> Orientation:
    """What the last state states."""
    assert state.adjustment is not None
    assert state.placed is not None
    scenes, adjustment = state.scenes, state.adjustment
    of_scenes = () if scenes is None or scenes.weights is None else (scenes.weights,)
    lost = (*state.lost, *(() if scenes is None else scenes.lost))
    return Orientation(
        adjustment=adjustment,
        photos=state.photos,
        groups=state.groups,
        refused=state.refused,
        not_oriented=(*lost, *left_out(adjustment, state.other_components)),
        pairs=state.pairs,
        stages=tuple(records),
        sigma_px=image_sigma_px(adjustment),
        weights=next(iter((*state.weights, *of_scenes)), None),
        frame=state.placed.frame,
        upright=state.placed.upright,
        dropped=state.dropped,
        matches=state.matches,
        other_components=state.other_components,
        wide_baselines={"budget_s": state.further_budget_s, "methods": [asdict(s) for s in state.further]}
        if state.further
        else {},
        scenes=() if scenes is None else scenes.images,
        scene_pairs=() if scenes is None else scenes.pairs,
        remarks=(*state.remarks, *state.reported),
    )
