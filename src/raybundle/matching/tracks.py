"""Tracks: the features of many images that show one object point, at most one of every image.

What hangs together by matches is a part of its own: where a track comes to two places of one image is decided by the
matches of its part alone, strong pairs first.  So images may be taken leaf by leaf: parts that lie in one are joined
there (`within`), and all others together (`across`), with the same tracks however images are cut.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.matching.verify import VerifiedPair
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rows import rows_of_each

SAME_PX = 0.1
FEATURE_BITS = 32
TORN = 1 << 62
"""Set in the number of a track whose part came to two places of one image: these stand behind all others."""

Places = Callable[[Index], Array]
"""Where features (k,) lie, by their numbers (k, 2) [px]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Tracks:
    """Image points and the object point each belongs to."""

    image: Index
    """(m,)"""
    feature: Index
    """(m,) position among the features of its image"""
    point: Index
    """(m,) 0 .. points - 1, sorted"""
    conflicts: Index
    """(c,) of each match left out because a track would have had two places in one image: the image where they lie
    farthest apart"""
    apart_px: Array
    """(c,) how far"""

    @property
    def points(self) -> int:
        """Number of object points."""
        return int(self.point[-1]) + 1 if len(self.point) else 0


@dataclass(frozen=True, slots=True, kw_only=True)
class Matches:
    """Matches of strong pairs first; a feature's number is that of its image and its position there (`numbers`)."""

    first: Index
    """(m,) int64"""
    second: Index
    """(m,)"""
    order: Index
    """(m,) ascending, among the matches of all pairs"""

    def rows(self, which: Index | Mask) -> Matches:
        """Some of them, in their order."""
        return Matches(first=self.first[which], second=self.second[which], order=self.order[which])


@dataclass(frozen=True, slots=True, kw_only=True)
class JoinedParts:
    """Tracks of whole parts."""

    number: Index
    """(k,) of features in tracks"""
    track: Index
    """(k,) number that the track is known by, its first feature's or one of its own where its part was taken apart"""
    conflict: Index
    """(c,) orders of the matches left out"""
    conflict_image: Index
    """(c,) where the places lie farthest apart"""
    apart_px: Array
    """(c,)"""


def numbers(image: Index | int, feature: Index) -> Index:
    """The numbers of features: by image, then by position, as they stand."""
    return (np.asarray(image, np.int64) << FEATURE_BITS) | np.asarray(feature, np.int64)


def images_of(number: Index) -> Index:
    """The images of features."""
    return (number & ~TORN) >> FEATURE_BITS


def features_of(number: Index) -> Index:
    """Their positions among the features of their images."""
    return number & ((1 << FEATURE_BITS) - 1)


def strongest_first(pairs: Sequence[VerifiedPair]) -> list[VerifiedPair]:
    """The pairs with matches in the order in which these are joined."""
    return sorted((p for p in pairs if len(p.matches)), key=lambda p: (-len(p.matches), p.first, p.second))


def matches_of(ordered: Sequence[VerifiedPair], begin: Index) -> Matches:
    """Matches of pairs in their order; begin (pairs,): how many matches of all pairs come before each one's."""
    none = np.zeros(0, np.int64)
    return Matches(
        first=np.concatenate([none, *(numbers(p.first, p.matches[:, 0]) for p in ordered)]),
        second=np.concatenate([none, *(numbers(p.second, p.matches[:, 1]) for p in ordered)]),
        order=np.concatenate(
            [none, *(k + np.arange(len(p.matches)) for k, p in zip(begin.tolist(), ordered, strict=True))]
        ),
    )


def tracks_of(pairs: Sequence[VerifiedPair], features_xy: Sequence[Array]) -> Tracks:
    """Conflict-free tracks of verified pairs; features at one place in one image count as one.

    Matches of strong pairs come first; a match that would join two tracks which see one image at different
    places is left out.
    """
    ordered = strongest_first(pairs)
    matches = matches_of(ordered, np.cumsum([0, *(len(p.matches) for p in ordered)])[:-1])
    return tracks_of_parts([joined(at_first_places(matches, features_xy), placed(features_xy))])


def placed(features_xy: Sequence[Array]) -> Places:
    """Where the features of images lie."""

    def places(number: Index) -> Array:
        image, feature = images_of(number), features_of(number)
        xy = np.empty((len(number), 2))
        for i, mine in enumerate(rows_of_each(image, len(features_xy))):
            if len(mine):
                xy[mine] = features_xy[i][feature[mine]]
        return xy

    return places


def first_places(number: Index, features_xy: Sequence[Array]) -> Index:
    """(k,) numbers of the first features at the places of features."""
    size = [len(xy) for xy in features_xy]
    offset = np.concatenate([[0], np.cumsum(size)]).astype(np.int64)
    same = np.concatenate([np.zeros(0, np.int64), *(first_at_place(xy) for xy in features_xy)])
    image = images_of(number)
    return numbers(image, same[offset[image] + features_of(number)])


def at_first_places(matches: Matches, features_xy: Sequence[Array]) -> Matches:
    """Matches between the first features at each place."""
    ends = np.concatenate([matches.first, matches.second])
    first, second = np.split(first_places(ends, features_xy), 2)
    return Matches(first=first, second=second, order=matches.order)


def first_at_place(xy: Array) -> Index:
    """(k,) the first feature at the place of each: one point with two orientations is one point."""
    if not len(xy):
        return np.zeros(0, np.int64)
    cell = np.round(xy / SAME_PX).astype(np.int64)
    _, first, inverse = np.unique(cell[:, 0] * 10_000_000 + cell[:, 1], return_index=True, return_inverse=True)
    return first[inverse]


def within(matches: Matches, outside: Index) -> tuple[Matches, Matches]:
    """The matches of parts that lie in a leaf, and those of parts that reach out of it.

    matches  in the leaf
    outside  (k,) features of the leaf that are matched with other leaves
    """
    nodes, first, _, label = _parts(matches)
    reaching = np.zeros(int(label.max(initial=-1)) + 1, bool)
    reaching[label[np.isin(nodes, outside)]] = True
    out = reaching[label[first]]
    return matches.rows(~out), matches.rows(out)


def across(reaching: Sequence[Matches], between: Matches) -> Matches:
    """The matches of parts that reach out of their leaves, and those between leaves, strong ones first."""
    every = (*reaching, between)
    order = np.concatenate([m.order for m in every])
    rows = np.argsort(order, kind="stable")
    return Matches(
        first=np.concatenate([m.first for m in every])[rows],
        second=np.concatenate([m.second for m in every])[rows],
        order=order[rows],
    )


def joined(matches: Matches, places: Places) -> JoinedParts:
    """Tracks of whole parts; matches are between first features at a place."""
    nodes, first, second, label = _parts(matches)
    image = images_of(nodes)
    # parts that see an image twice are taken apart match by match
    key = label.astype(np.int64) * (int(image.max(initial=0)) + 1) + image
    _, one, count = np.unique(key, return_index=True, return_counts=True)
    torn = np.zeros(int(label.max(initial=-1)) + 1, bool)
    torn[label[one[count > 1]]] = True
    _, lowest = np.unique(label, return_index=True)
    track = nodes[lowest][label]
    conflicts: list[tuple[int, int, float]] = []
    if torn.any():
        doubtful = np.flatnonzero(torn[label[first]])
        own = np.flatnonzero(torn[label])
        at = np.zeros(len(nodes), np.int64)
        at[own] = np.arange(len(own))
        root, left_out = _grow(at[first[doubtful]], at[second[doubtful]], image[own], places(nodes[own]))
        track[own] = nodes[own][root] | TORN
        order = matches.order[doubtful].tolist()
        conflicts = [(order[row], i, d) for row, i, d in left_out]
    _, of = np.unique(track, return_inverse=True)
    several = np.bincount(of, minlength=1)[of] > 1
    return JoinedParts(
        number=nodes[several],
        track=track[several],
        conflict=np.array([row for row, _, _ in conflicts], np.int64),
        conflict_image=np.array([i for _, i, _ in conflicts], np.int64),
        apart_px=np.array([d for _, _, d in conflicts], float),
    )


def tracks_of_parts(parts: Sequence[JoinedParts]) -> Tracks:
    """All tracks, in an order that does not depend on which parts were joined where."""
    number = np.concatenate([p.number for p in parts])
    _, point = np.unique(np.concatenate([p.track for p in parts]), return_inverse=True)
    rows = np.lexsort((number, point))
    number, point = number[rows], point[rows]
    order = np.argsort(np.concatenate([p.conflict for p in parts]), kind="stable")
    return Tracks(
        image=images_of(number).astype(np.int32),
        feature=features_of(number).astype(np.int32),
        point=point.astype(np.int32),
        conflicts=np.concatenate([p.conflict_image for p in parts])[order].astype(np.int32),
        apart_px=np.concatenate([p.apart_px for p in parts])[order],
    )


def _parts(matches: Matches) -> tuple[Index, Index, Index, Index]:
    """Features (n,) that are matched, the rows (m,) (m,) of each match's among them, and the part (n,) of each."""
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import connected_components

    m = len(matches.first)
    nodes, ends = np.unique(np.concatenate([matches.first, matches.second]), return_inverse=True)
    first, second = ends[:m], ends[m:]
    if not m:
        return nodes, first, second, np.zeros(0, np.int32)
    shape = len(nodes), len(nodes)
    graph = csr_array((np.ones(m, bool), (first, second)), shape=shape)
    _, label = connected_components(graph, directed=False)
    return nodes, first, second, label


def _grow(a: Index, b: Index, image: Index, xy: Array) -> tuple[Index, list[tuple[int, int, float]]]:
    """Union of features match by match, none that would put two features of one image together.

    returns  (n,) the root of each feature's track; of each match left out its row, the image where the places lie
             farthest apart, and how far [px]
    """
    root = list(range(len(image)))
    seen = [{i: k} for k, i in enumerate(image.tolist())]
    conflicts: list[tuple[int, int, float]] = []
    for row, (x, y) in enumerate(zip(a.tolist(), b.tolist(), strict=True)):
        rx, ry = root[x], root[y]
        if rx == ry:
            continue
        twice = seen[rx].keys() & seen[ry].keys()
        if twice:
            d, i = max((math.dist(xy[seen[rx][i]], xy[seen[ry][i]]), i) for i in twice)
            conflicts.append((row, i, d))
            continue
        if len(seen[rx]) < len(seen[ry]):
            rx, ry = ry, rx
        for node in seen[ry].values():
            root[node] = rx
        seen[rx] |= seen[ry]
        seen[ry] = {}
    return np.array(root, np.int64), conflicts
