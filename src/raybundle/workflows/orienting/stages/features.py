"""Stage: features of the photographs."""

from __future__ import annotations

from dataclasses import dataclass, replace

from raybundle.errors import NoOrientation
from raybundle.io.photos.masks import Masks
from raybundle.io.photos.photo import Photo
from raybundle.matching.features import FeatureMethod
from raybundle.pipeline.stage import Means, Stage
from raybundle.ties.points import FeatureStore, find_features
from raybundle.workflows.orienting.stages.photographs import check_number
from raybundle.workflows.orienting.state import ORIENT, OrientState


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What features depend on."""

    photos: tuple[Photo, ...]
    method: FeatureMethod
    count: int
    masks: Masks | None


Found = tuple[FeatureStore, dict[int, str]]
"""Features, and photographs whose pixels could not be read, with the reason"""


def _inputs(state: OrientState) -> Inputs:
    return Inputs(photos=state.photos, method=state.method, count=state.asked.options.feature_count, masks=state.masks)


def find(i: Inputs, means: Means) -> Found:
    """Features of each photograph, found by a task of its own."""
    return find_features(means, i.photos, i.method, i.count, i.masks)


def _put(state: OrientState, found: Found) -> OrientState:
    features, failed = found
    if failed and state.again:
        raise NoOrientation("photograph.no_longer_readable")
    kept = [i for i in range(len(state.photos)) if i not in failed]
    state = replace(
        state,
        photos=tuple(state.photos[i] for i in kept),
        features=features.rows(kept),
        refused=(*state.refused, *((state.photos[i].name, why) for i, why in failed.items())),
    )
    if state.scenes is None:  # which may yet be refused themselves
        missing = () if state.scenes_found is None else state.scenes_found.refused
        state = replace(state, refused=(*state.refused, *missing) if not state.again else state.refused)
        check_number(state.asked.inputs, state.photos, 0, state.refused)
    return state


STAGE = ORIENT.register(
    Stage(
        name="features",
        after=("known",),
        inputs=_inputs,
        function=find,
        put=_put,
        reported=lambda s: f"{len(s.photos)} photographs",
    )
)
