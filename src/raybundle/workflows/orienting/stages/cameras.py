"""Stage: which photographs are of one camera, and what is known of each."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from raybundle.block import Camera
from raybundle.errors import phrase
from raybundle.io.cameras.library import library_folder, with_library
from raybundle.io.photos.cameras import CameraGroup, camera_groups
from raybundle.io.photos.photo import Photo
from raybundle.numerics.counting import counted
from raybundle.pipeline.stage import Means, Stage
from raybundle.workflows.orienting.state import ORIENT, OrientState


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What the cameras depend on, beside the library."""

    photos: tuple[Photo, ...]
    calibration: tuple[Camera, ...]
    separate: tuple[str, ...]
    library: Path | None


def _inputs(state: OrientState) -> Inputs:
    options = state.asked.options
    return Inputs(
        photos=state.photos,
        calibration=state.asked.calibration,
        separate=options.own_camera,
        library=library_folder() if options.library else None,
    )


def notify(i: Inputs, means: Means) -> tuple[CameraGroup, ...]:
    """Photographs of one camera together; none of one photograph alone."""
    del means
    if len(i.photos) < 2:
        return camera_groups((), i.calibration, i.separate) if i.calibration else ()
    groups = camera_groups(i.photos, i.calibration, i.separate)
    return groups if i.library is None else with_library(i.photos, groups, i.library)


def _put(state: OrientState, groups: tuple[CameraGroup, ...]) -> OrientState:
    if len(state.photos) >= 2:
        return replace(state, groups=groups)
    return replace(
        state, groups=groups, photos=(), lost=tuple((p.name, phrase("not_oriented.alone")) for p in state.photos)
    )


STAGE = ORIENT.register(
    Stage(
        name="cameras",
        line="features",
        after=("features", "scene_features"),
        inputs=_inputs,
        function=notify,
        put=_put,
        little=True,
        reported=lambda s: counted(len(s.groups), "camera") if s.photos else "",
    )
)
