"""Stage: approximate values of every part of the photographs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.block import Camera
from raybundle.errors import phrase
from raybundle.io.photos.cameras import CameraGroup, camera_of, with_what_is_known
from raybundle.io.photos.photo import Photo
from raybundle.matching.tracks import Tracks
from raybundle.matching.verify import VerifiedPair, trusted
from raybundle.numerics.arrays import Array, Index
from raybundle.pipeline.stage import Codec, Means, Stage
from raybundle.ties.arrangements import best_arrangement
from raybundle.ties.block import TieBlock, block_of_tracks
from raybundle.ties.missing import missing_notices
from raybundle.ties.parts import KINDS, MANY, by_parts
from raybundle.ties.points import FeatureStore
from raybundle.ties.repeated import sound_pairs
from raybundle.ties.start import StartMethod
from raybundle.ties.tracks import KINDS as KINDS_OF_TRACKS
from raybundle.ties.tracks import tracks_by_leaves
from raybundle.workflows.orienting.connected_components import start_components
from raybundle.workflows.orienting.excluded_features import Dropped
from raybundle.workflows.orienting.state import ORIENT, OrientState
from raybundle.workflows.stage_arrays import (
    arrays_of_tie,
    notices_as_array,
    notices_of_array,
    numbered,
    tie_of_arrays,
    unpacked,
)
from raybundle.workflows.stage_memory import room_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What approximate values depend on."""

    photos: tuple[Photo, ...]
    cameras: tuple[Camera, ...]
    camera_of_photo: Index
    pairs: tuple[VerifiedPair, ...]
    features: FeatureStore
    method: StartMethod


@dataclass(frozen=True, slots=True, kw_only=True)
class Started:
    """Tie points with approximate values."""

    ties: tuple[TieBlock, ...]
    features: int
    matched: int
    notices: tuple[Notice, ...]


def _inputs(state: OrientState) -> Inputs:
    cameras, of_photo = cameras_of(state.groups, len(state.photos))
    return Inputs(
        photos=state.photos, cameras=cameras, camera_of_photo=of_photo, pairs=state.pairs,
        features=state.found, method=state.asked.options.start,
    )  # fmt: skip


def cameras_of(groups: Sequence[CameraGroup], count: int) -> tuple[tuple[Camera, ...], Index]:
    """The cameras of groups of photographs, those without a calibration observed as known, and whose each is."""
    cameras: list[Camera] = []
    of_photo = np.zeros(count, np.int32)
    for k, group in enumerate(groups):
        camera = camera_of(group)
        if group.stored is None:
            camera = with_what_is_known(replace(camera, estimate="auto"), group)
        cameras.append(camera)
        of_photo[list(group.photos)] = k
    return tuple(cameras), of_photo


def begin(i: Inputs, means: Means) -> Started:
    """Tracks of the pairs that are sound, and the orientation of every part that hangs together."""

    def oriented_by(tracks: Tracks) -> tuple[TieBlock, ...]:
        features = i.features.of_tracks(tracks)
        raw = block_of_tracks(i.photos, i.cameras, i.camera_of_photo, features.xy_px, tracks)
        parts = None if i.method == "auto" and len(i.photos) < MANY else partial(by_parts, means=means)
        return start_components(raw, features.scale_px, features.angle, means.jobs, means.progress, i.method, parts)

    names, n = [p.name for p in i.photos], len(i.photos)
    diagonals = np.array([float(np.hypot(p.width_px, p.height_px)) for p in i.photos])
    join = partial(tracks_by_leaves, means, i.features)
    with room_of(means):
        xy = i.features.xy_px()
        verified = trusted(i.pairs, n)
        sound = sound_pairs(verified, xy, names, diagonals, oriented_by, join)
        sound, ties = best_arrangement(sound, verified, xy, names, diagonals, oriented_by, join)
    return Started(
        ties=ties, features=sum(i.features.count(k) for k in range(n)),
        matched=len(sound.tracks.image), notices=sound.notices,
    )  # fmt: skip


def _put(state: OrientState, started: Started) -> OrientState:
    ties = started.ties
    same = {
        state.photos[i].name: phrase("not_oriented.same_picture", other=state.photos[k].name)
        for i, k in state.repeats.items()
    } | {state.photos[i].name: phrase("not_oriented.mirrored") for i in state.mirrored}
    count = sum(len(t.block.observations) for t in ties)
    return replace(
        state,
        ties=ties,
        blocks=tuple(t.block for t in ties),
        lost=tuple((name, same.get(name, why)) for name, why in ties[0].not_oriented),
        dropped=Dropped(features=started.features, matched=started.matched, started=count, adjusted=count),
        notices=(*state.notices, *started.notices, *(n for t in ties for n in missing_notices(t.block))),
    )


def _outcome(state: OrientState) -> str:
    oriented = sum(int(t.block.images.oriented.sum()) for t in state.ties)
    points = sum(len(t.block.points) for t in state.ties)
    return phrase(
        "stage_summary.start", n=oriented, of=len(state.photos), parts=max(len(state.ties), 1), points=points
    )  # fmt: skip


def _arrays(s: Started) -> dict[str, Array]:
    return {
        **numbered([arrays_of_tie(t) for t in s.ties]),
        "counts": np.array([s.features, s.matched]),
        "notices": notices_as_array(s.notices),
    }


def _product(a: Mapping[str, Array]) -> Started:
    features, matched = a["counts"].tolist()
    ties = tuple(tie_of_arrays(t) for t in unpacked(a).values())
    return Started(ties=ties, features=features, matched=matched, notices=notices_of_array(a["notices"]))


STAGE = ORIENT.register(
    Stage(
        name="start",
        version=21,
        kinds=(*KINDS_OF_TRACKS, *KINDS),
        after=("scene_matching",),
        inputs=_inputs,
        function=begin,
        put=_put,
        reported=_outcome,
        codec=Codec(arrays=_arrays, product=_product),
        when=lambda s: bool(s.photos),
    )
)
