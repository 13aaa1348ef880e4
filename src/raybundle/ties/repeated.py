"""Repeated structure: pairs of photographs whose matches one geometry explains although they show different parts.

A facade of equal bays or a tower with equal windows gives pairs that an epipolar geometry explains with hundreds of
matches and that are wrong.  By itself such a pair looks like a right one; together they contradict each other: tracks
come to two places of one image.  Where that happens often, photographs are oriented by their strongest pairs alone
first, which as a rule are those of neighbours, and the object points that result are projected into the images of all
other pairs (after Zach et al. 2010 and Heinly et al. 2014, who compare with what is seen elsewhere in another way).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import Block, Observations
from raybundle.block.points import automatic_name
from raybundle.errors import NoOrientation, Value
from raybundle.matching.tracks import Tracks
from raybundle.matching.verify import FEWEST, VerifiedPair
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.platforms.station import sensor_from_object
from raybundle.ties.block import TieBlock

SHOWN = 4
"""Pairs that a notice lists."""
CONTRADICTED = 0.04
"""Share of matches that would give a track two places in one image, from which on pairs are doubted.

Wrong matches that are left by the verification of right pairs make 0 to 0.01 on fifteen ordinary sets, 0.023 before a
patterned wallpaper and 0.026 along a street; equal windows and bays 0.09 to 0.28 (benchmarks/contradictions.py).
"""
TREES = 2
"""Spanning trees of strongest pairs that orient the photographs first: each hangs on two others by two ways."""
ASTRAY = 0.05
"""Share of the format's diagonal by which a match misses its object point, or another place of its track, where it
counts as another place.

Photographs that hang together by their neighbours only lie some degrees off after many of them; what repeats on an
object, and is large enough to give a pair by itself, lies farther apart.
"""
AGREEING = 0.5
"""Share of a pair's matches that must meet their object points."""

Orient = Callable[[Tracks], tuple[TieBlock, ...]]
Join = Callable[[Sequence[VerifiedPair]], Tracks]


@dataclass(frozen=True, slots=True, kw_only=True)
class SoundPairs:
    """Pairs whose matches are believed, their tracks, and what is to be reported."""

    pairs: tuple[VerifiedPair, ...]
    tracks: Tracks
    notices: tuple[Notice, ...]


def sound_pairs(
    pairs: Sequence[VerifiedPair], features_xy: Sequence[Array], names: Sequence[str], diagonals: Array, orient: Orient,
    join: Join,
) -> SoundPairs:  # fmt: skip
    """The pairs without those that show different parts which look alike.

    pairs        trusted ones
    features_xy  (n, 2) of each photograph [px]
    names        of the photographs
    diagonals    (photographs,) of the formats [px]
    orient       approximate values of tracks
    join         tracks of pairs

    Limits: an object that looks the same from all sides, and repeated parts that lie closer together
    than a twentieth of the format, are not recognised.
    """
    whole = join(pairs)
    share = contradicted(pairs, whole, diagonals)
    if share <= CONTRADICTED:
        return SoundPairs(pairs=tuple(pairs), tracks=whole, notices=())
    strongest = spanning(pairs, len(features_xy))
    tracks = join(strongest)
    try:
        parts = orient(tracks)
    except NoOrientation:
        return SoundPairs(pairs=tuple(pairs), tracks=whole, notices=_notices([], names, share, share))
    share_met, astray = agreement(pairs, features_xy, tracks, parts, diagonals)
    left = [p for p, a in zip(pairs, share_met.tolist(), strict=True) if a < AGREEING]
    # what nothing can be determined of is believed of the strongest only
    kept = tuple(
        replace(p, matches=p.matches[~out])
        for p, a, out in zip(pairs, share_met.tolist(), astray, strict=True)
        if a >= AGREEING or (np.isnan(a) and p in strongest)
    )
    tracks = join(kept)
    notices = _notices(left, names, share, contradicted(kept, tracks, diagonals))
    return SoundPairs(pairs=kept, tracks=tracks, notices=notices)


def contradicted(pairs: Sequence[VerifiedPair], tracks: Tracks, diagonals: Array) -> float:
    """Share of the matches that would have given a track two places in one image that lie `ASTRAY` apart.

    What lies closer is one detail found at two scales, or a point that slid along its epipolar line.
    """
    far = tracks.apart_px > ASTRAY * diagonals[tracks.conflicts]
    return float(far.sum()) / max(sum(len(p.matches) for p in pairs), 1)


def spanning(
    pairs: Sequence[VerifiedPair], count: int, trees: int = TREES, weight: Array | None = None
) -> list[VerifiedPair]:
    """The pairs of spanning trees with the most matches, or weight (pairs,), no pair in two of them (Kruskal 1956)."""
    of = {(p.first, p.second): len(p.matches) if weight is None else weight[k] for k, p in enumerate(pairs)}
    left = sorted((p for p in pairs if len(p.matches)), key=lambda p: (-of[p.first, p.second], p.first, p.second))
    chosen: list[VerifiedPair] = []
    for _ in range(trees):
        root = list(range(count))

        def find(i: int, root: list[int] = root) -> int:
            while root[i] != i:
                root[i] = root[root[i]]
                i = root[i]
            return i

        rest: list[VerifiedPair] = []
        for pair in left:
            a, b = find(pair.first), find(pair.second)
            if a == b:
                rest.append(pair)
            else:
                root[a] = b
                chosen.append(pair)
        left = rest
    return sorted(chosen, key=lambda p: (p.first, p.second))


def agreement(
    pairs: Sequence[VerifiedPair], features_xy: Sequence[Array], tracks: Tracks, parts: Sequence[TieBlock],
    diagonals: Array,
) -> tuple[Array, list[Mask]]:  # fmt: skip
    """How the matches of each pair meet the object points of tracks.

    returns  (pairs,) share that meets them, NaN for too few; the matches (k,) of each that go astray
    """
    offset = np.concatenate([[0], np.cumsum([len(xy) for xy in features_xy])])
    places = np.vstack(list(features_xy))
    count = [len(p.matches) for p in pairs]
    pair = np.repeat(np.arange(len(pairs)), count)
    ends = np.array([(p.first, p.second) for p in pairs], int).reshape(-1, 2)[pair]
    rows = np.vstack([np.zeros((0, 2), int), *(p.matches for p in pairs)]) + offset[ends]
    judged, astray = np.zeros(len(rows), bool), np.zeros(len(rows), bool)
    for part in parts:
        point_of = _points_of_features(part.block, tracks, offset)
        for source, target in ((0, 1), (1, 0)):
            image = ends[:, target]
            known = np.flatnonzero((point_of[rows[:, source]] >= 0) & part.block.images.oriented[image])
            image = image[known]
            met = _meets(
                part.block, image, point_of[rows[known, source]], places[rows[known, target]], ASTRAY * diagonals[image]
            )
            judged[known] = True
            astray[known] |= ~met
    n, out = np.bincount(pair, judged, len(pairs)), np.bincount(pair, astray, len(pairs))
    with np.errstate(invalid="ignore"):
        share = np.where(n >= FEWEST, 1 - out / n, np.nan)
    return share, np.split(astray, np.cumsum(count)[:-1])


def _points_of_features(block: Block, tracks: Tracks, offset: Index) -> Index:
    """(features,) object point of the block that each shows, -1 for none; the block has left some rays out."""
    result = np.full(int(offset[-1]), -1)
    of_id = {name: k for k, name in enumerate(block.points.ids)}
    number = np.array([of_id.get(automatic_name(k), -1) for k in range(tracks.points)])
    o = block.observations
    kept = set(zip(o.image.tolist(), o.point.tolist(), strict=True))
    point = number[tracks.point]
    stays = np.array([(i, p) in kept for i, p in zip(tracks.image.tolist(), point.tolist(), strict=True)], bool)
    rows = np.flatnonzero(stays)
    result[offset[tracks.image[rows]] + tracks.feature[rows]] = point[rows]
    return result


def _meets(block: Block, image: Index, point: Index, xy: Array, limit_px: Array) -> Mask:
    """(k,) whether object points lie before the cameras, and within a distance of image points (k, 2)."""
    if not len(image):
        return np.zeros(0, bool)
    o = Observations(
        image=image.astype(np.int32), point=point.astype(np.int32), xy_px=xy, cov_px2=np.ones((len(image), 3))
    )
    with np.errstate(all="ignore"):
        off = np.linalg.norm(residuals_px(replace(block, observations=o), np.arange(len(image))), axis=1)
    P = sensor_from_object(block.images.rotation[image], block.images.centre[image], block.points.xyz[point])
    return (P[2] < 0) & (off < limit_px)


def _notices(left: Sequence[VerifiedPair], images: Sequence[str], before: float, after: float) -> tuple[Notice, ...]:
    """The pairs that are left out, and whether contradictions remain."""
    names = [f"{images[p.first]} - {images[p.second]}" for p in left]
    values: dict[str, Value] = {
        "before": before, "limit": CONTRADICTED, "after": after, "pairs": len(left), "names": names[:SHOWN],
    }  # fmt: skip
    if after > CONTRADICTED:
        return (Notice(code="repeated_structure.ambiguous", values=values, measured=Severity.FAULT),)
    return (Notice(code="repeated_structure", values=values, measured=Severity.WARNING),)
