"""Stage: features of the satellite scenes."""

from __future__ import annotations

from dataclasses import dataclass, replace

from raybundle.matching.features import FeatureMethod
from raybundle.numerics.counting import counted
from raybundle.pipeline.stage import Means, Stage
from raybundle.ties.points import FeatureStore
from raybundle.workflows.orienting.stages.photographs import check_number
from raybundle.workflows.orienting.state import ORIENT, OrientState
from raybundle.workflows.scenes.images import SceneImage
from raybundle.workflows.scenes.ties import find_scene_features


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What features of scenes depend on."""

    images: tuple[SceneImage, ...]
    method: FeatureMethod
    count: int


Found = tuple[FeatureStore, dict[int, str]]
"""Features, and scenes whose pixels could not be read, with the reason"""


def _inputs(state: OrientState) -> Inputs:
    return Inputs(images=state.with_scenes.images, method=state.method, count=state.asked.options.feature_count)


def find(i: Inputs, means: Means) -> Found:
    """Features of each scene, found by a task of its own."""
    return find_scene_features(means, i.images, i.method, i.count)


def _put(state: OrientState, found: Found) -> OrientState:
    features, failed = found
    scenes, known = state.with_scenes, state.scenes_found
    refused = (
        *state.refused,
        *(() if known is None else known.refused),
        *((scenes.images[i].name, why) for i, why in failed.items()),
    )
    kept = [i for i in range(len(scenes.images)) if i not in failed]
    scenes = replace(scenes, features=features).rows(kept)
    check_number(state.asked.inputs, state.photos, len(scenes.images), refused)
    return replace(state, scenes=scenes, refused=refused)


STAGE = ORIENT.register(
    Stage(
        name="scene_features",
        line="features",
        after=("features",),
        inputs=_inputs,
        function=find,
        put=_put,
        reported=lambda s: counted(len(s.with_scenes.images), "scene"),
        when=lambda s: s.scenes is not None,
    )
)
