"""Stage: pairs of photographs, matched and verified."""

from __future__ import annotations

import math
from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.errors import NoOrientation, as_detail, message_of_text, phrase
from raybundle.io.photos.photo import Photo
from raybundle.matching.features import FeatureMethod
from raybundle.matching.verify import VerifiedPair
from raybundle.numerics.arrays import Array
from raybundle.pipeline.stage import Means, Stage
from raybundle.ties.mirrored import mirrored_notice, mirrored_photographs, stored_mirrored
from raybundle.ties.pairs import Round, pairs_of
from raybundle.ties.points import FeatureStore, match_pairs
from raybundle.ties.same_picture import same_picture_notice, same_pictures
from raybundle.ties.static_background import FEWEST_PHOTOGRAPHS, RING_PX, static_background
from raybundle.workflows.orienting.state import ORIENT, OrientState


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What pairs depend on."""

    photos: tuple[Photo, ...]
    features: FeatureStore
    method: FeatureMethod
    masked: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Matched:
    """What the photographs share."""

    pairs: tuple[VerifiedPair, ...]
    rounds: tuple[Round, ...]
    """in which they were chosen, of a large set"""
    repeats: dict[int, int]
    """photographs that show the same picture as another, by their index"""
    mirrored: tuple[int, ...]
    """photographs that are mirrored against the others, by their index"""
    notices: tuple[Notice, ...]


def _inputs(state: OrientState) -> Inputs:
    return Inputs(photos=state.photos, features=state.found, method=state.method, masked=state.masks is not None)


def match(i: Inputs, means: Means) -> Matched:
    """Each pair is matched by a task of its own; what stands still and what repeats is reported of them together."""
    chosen = pairs_of(means, i.photos, i.features, i.method, _positions(i.photos))
    try:
        pairs = match_pairs(means, i.photos, i.features, i.method, chosen.pairs, chosen.whole)
    except NoOrientation as error:
        still = static_background(i.photos, i.features, i.method)
        if still is None:
            raise
        notice = still.notice(masked=i.masked)
        first = as_detail(error)
        other = message_of_text(notice.message) if notice.message else notice.data
        raise NoOrientation(
            replace(first, details=(*first.details, other)), images=error.images, undetermined=error.undetermined
        ) from error
    notices = stored_mirrored(i.photos)
    if _stands_still(pairs):
        still = static_background(i.photos, i.features, i.method)
        notices += [] if still is None else [still.notice(masked=i.masked)]
    repeats = same_pictures(pairs, i.photos, i.features, i.method)
    if repeats:
        notices.append(same_picture_notice(repeats, i.photos))
        pairs = _without(pairs, repeats.keys())
    mirrored = mirrored_photographs(pairs, i.photos, i.features, i.method)
    if mirrored is not None:
        notices.append(mirrored_notice(mirrored, i.photos))
    out = mirrored.photographs if mirrored is not None and mirrored.certain else ()
    pairs = _without(pairs, set(out)) if out else pairs
    return Matched(pairs=tuple(pairs), rounds=chosen.rounds, repeats=repeats, mirrored=out, notices=tuple(notices))


def _without(pairs: Sequence[VerifiedPair], out: AbstractSet[int]) -> list[VerifiedPair]:
    """The pairs, without the matches of those photographs."""
    return [replace(p, matches=p.matches[:0]) if {p.first, p.second} & out else p for p in pairs]


def _positions(photos: Sequence[Photo]) -> Array | None:
    """(n, 3) rough metres by GPS for the choice of pairs; None where fewer than two photographs have any."""
    result = np.full((len(photos), 3), np.nan)
    for i, photo in enumerate(photos):
        gps = photo.metadata.gps
        if gps is not None:
            result[i] = gps.latitude_deg, gps.longitude_deg, gps.altitude_m or 0.0
    known = np.isfinite(result[:, 0])
    if known.sum() < 2:
        return None
    result[:, 1] *= np.cos(np.radians(np.nanmean(result[:, 0])))
    result[:, :2] *= 111_000
    return result[:, [1, 0, 2]]


def _stands_still(pairs: Sequence[VerifiedPair]) -> bool:
    """Whether verified pairs show that something may stand still, so that it is worth while to look."""
    still = (p for p in pairs if len(p.matches) or p.geometry == "watermark")
    return sum(p.displacement_px < RING_PX for p in still) >= FEWEST_PHOTOGRAPHS - 1


def _put(state: OrientState, m: Matched) -> OrientState:
    return replace(
        state,
        pairs=m.pairs,
        rounds=m.rounds,
        repeats=m.repeats,
        mirrored=m.mirrored,
        notices=(*state.notices, *m.notices),
    )


def _outcome(state: OrientState) -> str:
    good = sum(1 for p in state.pairs if len(p.matches))
    tried, skipped = len(state.pairs), sum(1 for p in state.pairs if not p.candidates)
    if not state.rounds:
        return phrase("stage_summary.matching", pairs=tried, skipped=skipped, verified=good)
    every = math.comb(len(state.photos), 2)
    likely, common, between = (r.pairs for r in state.rounds)
    return phrase(
        "stage_summary.matching_rounds", pairs=tried, of=every, likely=likely, common=common, between=between,
        skipped=skipped, verified=good,
    )  # fmt: skip


STAGE = ORIENT.register(
    Stage(
        name="matching",
        after=("cameras",),
        inputs=_inputs,
        function=match,
        put=_put,
        reported=_outcome,
        when=lambda s: bool(s.photos),
    )
)
