"""Stage: the photographs and scenes among the inputs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from raybundle.adjustment.records.notice import Notice
from raybundle.errors import InputError, Text, excluded, note
from raybundle.io.geo.coordinate_systems import LocalFrame
from raybundle.io.photos.photo import Found, Photo, find_photos
from raybundle.io.trajectories import Trajectory, with_positions
from raybundle.io.trajectories.photographs import frame_of_positions
from raybundle.pipeline.stage import Means, Stage
from raybundle.placing.distant_positions import distant_positions
from raybundle.placing.marks import under_kept_names
from raybundle.workflows.orienting.state import ORIENT, OrientState, SceneState
from raybundle.workflows.scenes.images import FoundScenes, find_scenes
from raybundle.workflows.stage_arrays import Reasons


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What the search depends on, beside the files themselves."""

    paths: tuple[Path, ...]
    control: tuple[Path, ...]
    positions: Trajectory | None
    crs: str | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Searched:
    """What was found."""

    found: Found
    scenes: FoundScenes
    positions_frame: LocalFrame | None = None
    notices: tuple[Notice, ...] = ()


def _inputs(state: OrientState) -> Inputs:
    asked = state.asked
    return Inputs(
        paths=asked.inputs, control=tuple(c.path for c in state.given.control), positions=asked.positions,
        crs=asked.options.crs,
    )  # fmt: skip


def search(given: Inputs, means: Means) -> Searched:
    """The photographs and scenes among files; raises InputError where they are too few."""
    scenes = find_scenes(given.paths)
    used = _beside(given.paths, [*given.control, *([] if given.positions is None else [given.positions.path])])
    found = find_photos(given.paths, leave=[*scenes.files, *used], progress=means.progress)
    frame = None
    notices: tuple[Notice, ...] = ()
    if given.positions is not None:
        placed, notes = with_positions(found.photos, given.positions, given.crs)
        fault, exchanged = distant_positions(found.photos, given.positions, given.crs)
        notices = () if fault is None else (fault,)
        if not exchanged:
            frame = frame_of_positions(found.photos, given.positions, given.crs)
            later = () if frame is None else frame.remarks  # stated with the place of the block
            found = replace(found, photos=placed, remarks=(*found.remarks, *(r for r in notes if r not in later)))
    check_number(
        given.paths, found.photos, len(scenes.scenes), (*_refused(found), *scenes.refused), found.remarks
    )  # fmt: skip
    return Searched(found=found, scenes=scenes, positions_frame=frame, notices=notices)


def _refused(found: Found) -> Reasons:
    return tuple((p.name, r) for p, r in found.refused)


def _beside(inputs: Sequence[Path], files: Sequence[Path]) -> list[Path]:
    """Files as they are called in the folders that are looked into."""
    folders = [p for p in inputs if p.is_dir()]
    return [f / file.name for f in folders for file in files if file.resolve() == (f / file.name).resolve()]


def _put(state: OrientState, product: Searched) -> OrientState:
    found, scenes = product.found, product.scenes
    return replace(
        state,
        photos=found.photos,
        refused=_refused(found),
        remarks=found.remarks,
        notices=(*state.notices, *product.notices),
        given=replace(
            state.given,
            control=under_kept_names(state.given.control, found.copies),
            positions_frame=product.positions_frame,
        ),
        scenes=SceneState(images=scenes.scenes) if scenes.scenes else None,
        scenes_found=scenes,
    )


def _outcome(state: OrientState) -> str:
    found = [note("stage_summary.photographs", n=len(state.photos), refused=len(state.refused))]
    scenes = state.scenes_found
    if scenes is not None and (scenes.scenes or scenes.refused):
        found.append(note("stage_summary.scenes", n=len(scenes.scenes), refused=len(scenes.refused)))
    return Text.of(*found)


def check_number(
    inputs: Sequence[Path], photos: Sequence[Photo], scenes: int, refused: Sequence[tuple[str, str]],
    remarks: Sequence[str] = (),
) -> None:  # fmt: skip
    """Raise InputError where there are neither two photographs nor a scene."""
    if len(photos) >= 2 or scenes >= 2 or (scenes and photos):
        return
    if not scenes:
        raise _too_few(inputs, photos, refused, remarks)
    raise InputError("scene.single", details=excluded(refused), file=", ".join(map(str, inputs)))


def _too_few(
    inputs: Sequence[Path], photos: Sequence[Photo], refused: Sequence[tuple[str, str]], remarks: Sequence[str]
) -> InputError:
    return InputError(
        "photograph.too_few_usable", n=len(photos), least=2, details=excluded(refused, remarks),
        file=", ".join(map(str, inputs)),
    )  # fmt: skip


STAGE = ORIENT.register(Stage(name="photographs", inputs=_inputs, function=search, put=_put, reported=_outcome))
