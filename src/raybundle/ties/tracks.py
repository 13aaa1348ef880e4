"""Tracks of verified pairs by tasks: those that lie in a leaf of images by one of its own, the others by a last one.

How images are cut changes nothing of the tracks (`matching.tracks`); it states what a killed run loses, and that the
last step holds no more than the matches of tracks that reach out of their leaves.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.matching import tracks as joining
from raybundle.matching.tracks import JoinedParts, Matches, Tracks
from raybundle.matching.verify import VerifiedPair
from raybundle.numerics.arrays import Index
from raybundle.numerics.rows import rows_of_each
from raybundle.orientation.image_leaves import leaves_of_pairs
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import Product
from raybundle.pipeline.stage import Means
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task
from raybundle.ties.points import FeatureStore

VERSION = 1
KINDS = ("matches", "tracks")
"""First words of the keys of what is kept"""
LEAF = 200
"""Images of a leaf: what one process joins in seconds, and few enough leaves that most tracks lie in one."""
MATCH_S = 2e-6
"""CPU seconds of a match, for the order and the time that is left."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TracksTask:
    """Matches that are joined."""

    features: tuple[str, ...]
    """keys of the features of the images; they are numbered among these"""
    matches: str
    """key of the matches, and of the features that are matched with other leaves"""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Leaf:
    """A leaf and the pairs within it."""

    images: Index
    """(n,) ascending"""
    order: Index
    """(m,) of its matches among all"""
    task: Task


def tracks_by_leaves(
    means: Means, features: FeatureStore, pairs: Sequence[VerifiedPair], most: int | None = None
) -> Tracks:
    """The tracks of `matching.tracks.tracks_of`, bit by bit.

    most    images of a leaf
    raises  InputError where features are gone
    """
    ordered = joining.strongest_first(pairs)
    ends = np.array([(p.first, p.second, len(p.matches)) for p in ordered], np.int64).reshape(-1, 3)
    begin = np.cumsum([0, *ends[:, 2].tolist()])[:-1]
    n = len(features.keys)
    cut = leaves_of_pairs(ends, np.bincount(ends[:, :2].ravel(), minlength=n) > 0, LEAF if most is None else most)
    leaf = np.full(n, -1)
    for k, one in enumerate(cut):
        leaf[one.own] = k
    inside = leaf[ends[:, 0]] == leaf[ends[:, 1]]
    between = _some(ordered, begin, np.flatnonzero(~inside))
    outside = np.unique(np.concatenate([between.first, between.second]))
    of_leaf = rows_of_each(leaf[joining.images_of(outside)], len(cut))
    pairs_of_leaf = rows_of_each(np.where(inside, leaf[ends[:, 0]], -1), len(cut))
    leaves = [
        _leaf(means.store, features, one.own, _some(ordered, begin, rows), outside[mine])
        for one, rows, mine in zip(cut, pairs_of_leaf, of_leaf, strict=True)
    ]
    for reason in means.do([one.task for one in leaves], "tracks").values():
        raise InputError(reason)
    return _together(means.store, features, leaves, of_leaf, outside, between)


def _some(ordered: Sequence[VerifiedPair], begin: Index, which: Index) -> Matches:
    return joining.matches_of([ordered[k] for k in which.tolist()], begin[which])


def _leaf(store: Folder, features: FeatureStore, images: Index, matches: Matches, outside: Index) -> _Leaf:
    """The task of a leaf; its matches are in the store, images numbered within the leaf."""
    arrays = {
        "first": _moved(matches.first, images), "second": _moved(matches.second, images),
        "outside": _moved(outside, images),
    }  # fmt: skip
    inputs = key_of("matches", VERSION, arrays)
    if not store.has(inputs):
        store.store(inputs, arrays)
    own = tuple(features.keys[i] for i in images.tolist())
    task = Task(
        key=key_of("tracks", VERSION, own, inputs), function=f"{__name__}:tracks_within",
        options=TracksTask(features=own, matches=inputs), inputs=(inputs, *own), cost=len(matches.order) * MATCH_S,
        memory=len(matches.order) * 200.0, name=f"{len(images)} images",
    )  # fmt: skip
    return _Leaf(images=images, order=matches.order, task=task)


def _moved(number: Index, images: Index) -> Index:
    """Numbers of features with their images numbered among some."""
    return joining.numbers(np.searchsorted(images, joining.images_of(number)), joining.features_of(number))


def tracks_within(store: Folder, task: TracksTask) -> Product:
    """The task: tracks that lie in a leaf; the matches of those that reach out of it, and first features outside."""
    a = store.wanted(task.matches)
    xy = list(FeatureStore(store, task.features).xy_px())
    order = np.arange(len(a["first"]))
    matches = joining.at_first_places(Matches(first=a["first"], second=a["second"], order=order), xy)
    outside = joining.first_places(a["outside"], xy)
    mine, reaching = joining.within(matches, outside)
    parts = joining.joined(mine, joining.placed(xy))
    return {
        "number": parts.number, "track": parts.track, "conflict": parts.conflict,
        "conflict_image": parts.conflict_image, "apart_px": parts.apart_px, "first": reaching.first,
        "second": reaching.second, "order": reaching.order, "outside": outside,
    }  # fmt: skip


def _together(
    store: Folder, features: FeatureStore, leaves: Sequence[_Leaf], of_leaf: Sequence[Index], outside: Index,
    between: Matches,
) -> Tracks:  # fmt: skip
    """The last step: what reaches out of its leaf is joined, and all tracks are numbered."""
    parts: list[JoinedParts] = []
    reaching: list[Matches] = []
    at_first = outside.copy()
    for one, mine in zip(leaves, of_leaf, strict=True):
        a = store.wanted(one.task.key)
        number, track, first, second, at_first[mine] = (
            _back(a[name], one.images) for name in ("number", "track", "first", "second", "outside")
        )
        parts.append(
            JoinedParts(
                number=number, track=track, conflict=one.order[a["conflict"]],
                conflict_image=one.images[a["conflict_image"]], apart_px=a["apart_px"],
            )
        )  # fmt: skip
        reaching.append(Matches(first=first, second=second, order=one.order[a["order"]]))
    first, second = (at_first[np.searchsorted(outside, e)] for e in (between.first, between.second))
    every = joining.across(reaching, Matches(first=first, second=second, order=between.order))
    return joining.tracks_of_parts([*parts, joining.joined(every, joining.placed(features.xy_px()))])


def _back(number: Index, images: Index) -> Index:
    """Numbers of features, or of tracks, with their images numbered among all."""
    found = joining.numbers(images[joining.images_of(number)], joining.features_of(number))
    return found | (number & joining.TORN)
