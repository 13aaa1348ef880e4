"""The pairs of photographs that are looked at and matched: of small sets all, of large ones the likely ones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.io.photos.photo import Photo
from raybundle.matching import pairs as choice
from raybundle.matching.features import FeatureMethod
from raybundle.matching.methods import feature_method
from raybundle.matching.pairs import ALL, Candidates
from raybundle.matching.signatures import (
    COARSE,
    DESCRIBED,
    SAMPLE,
    SAMPLED,
    VERSION,
    likeness,
    shipped_codebook,
    signature,
    widest,
    words_of,
)
from raybundle.numerics.arrays import Array, Index
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import Product
from raybundle.pipeline.stage import Means
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task
from raybundle.ties.points import FeatureStore, features_from, verified_pairs

COMPARISON = 1
"""Raised with every change of what comparing photographs gives."""
SIGNATURE_S, COMPARE_S, TOGETHER = 0.05, 0.002, 500
"""Of a signature and of comparing a pair; and pairs that are compared by one task."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Round:
    """Pairs that were matched for one reason."""

    why: str
    pairs: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Chosen:
    """The pairs to match."""

    pairs: tuple[tuple[int, int], ...]
    """i < j, sorted"""
    rounds: tuple[Round, ...] = ()
    """of a large set"""
    whole: frozenset[tuple[int, int]] = frozenset()
    """those of them that are matched whatever a first look finds"""


@dataclass(frozen=True, slots=True, kw_only=True)
class WordsTask:
    """What words are learnt from."""

    features: tuple[str, ...]
    """keys of the features of some photographs"""
    method: str


def words_product(store: Folder, task: WordsTask) -> Product:
    """The task: words of a set of photographs, where the method brings none."""
    method, each = feature_method(task.method), max(1, SAMPLE // len(task.features))
    samples = [method.vectors(store.wanted(key, ("descriptors",))["descriptors"][:each]) for key in task.features]
    return {"words": words_of(samples)}


@dataclass(frozen=True, slots=True, kw_only=True)
class SignatureTask:
    """What the signature of a photograph is made of."""

    features: str
    """key"""
    method: str
    words: str = ""
    """key; empty: those that the method brings"""


def signature_product(store: Folder, task: SignatureTask) -> Product:
    """The task: the signature of a photograph, and the features by which it is compared."""
    method, found = feature_method(task.method), features_from(store.wanted(task.features))
    words = store.held(task.words)["words"] if task.words else shipped_codebook(method.codebook).words
    chosen = widest(found, DESCRIBED)
    vectors = method.vectors(found.descriptors[chosen])
    return {"signature": signature(vectors, words), "descriptors": found.descriptors[chosen[:COARSE]]}


@dataclass(frozen=True, slots=True, kw_only=True)
class CompareTask:
    """Which photographs are compared."""

    signatures: tuple[str, ...]
    """keys"""
    pairs: tuple[tuple[int, int], ...]
    """of them, by their positions"""
    method: str


def compared(store: Folder, task: CompareTask) -> Product:
    """The task: how many features of wide surroundings the photographs of each pair share."""
    method = feature_method(task.method)
    found = [store.wanted(key, ("descriptors",))["descriptors"] for key in task.signatures]
    return {"shared": np.array([method.shared(found[i], found[j]) for i, j in task.pairs], np.int64)}


@dataclass(slots=True, kw_only=True)
class Rounds:
    """The choice of pairs of a large set; photographs stand in the order of their features' keys, not their names."""

    means: Means
    photos: Sequence[Photo]
    store: FeatureStore
    method: FeatureMethod
    place: Index
    """of each photograph in the sequence"""
    keys: list[str]
    """of signatures"""
    signatures: Array
    matched: Index
    """(m, 2) i < j"""
    links: Index
    """(k, 2) those of them that strong matches verify"""
    skipped: Index
    """(k, 2) those of them that were not matched for what a first look found"""

    @property
    def count(self) -> int:
        """Photographs."""
        return len(self.keys)

    def candidates(self, pairs: Index) -> Candidates:
        """Pairs with what shows how likely they are; none that is matched already."""
        pairs = pairs[~choice.contained(pairs, self.matched)]
        shared = shared_features(self.means, self.keys, self.method, pairs)
        return Candidates(pairs=pairs, shared=shared, likeness=likeness(self.signatures, pairs))

    def match(self, pairs: Index) -> None:
        """Match pairs that are not matched yet."""
        names = np.sort(self.place[pairs], axis=1)
        found = verified_pairs(self.means, self.photos, self.store, self.method, _rows(names))
        good = choice.linked(np.array([len(p.matches) for p in found], np.int64))
        self.matched = choice.unique_pairs(self.matched, pairs)
        self.links = choice.unique_pairs(self.links, pairs[good])
        if self.method.looks:
            self.skipped = choice.unique_pairs(self.skipped, pairs[[not p.candidates for p in found]])

    def go_on(self, most: int) -> int:
        """Match pairs with linked neighbours in common until none is left or `most` pairs are matched; their number."""
        begun = len(self.matched)
        while len(self.matched) < most:
            pairs, common = choice.common_pairs(self.links, self.matched, self.count)
            if not len(pairs):
                break
            c = self.candidates(pairs)
            self.match(choice.unique_pairs(c.pairs[c.order(common)][: most - len(self.matched)]))
        return len(self.matched) - begun

    def join(self, most: int) -> int:
        """Match likely pairs between parts, until one part is left or `most` pairs are matched; their number."""
        begun = len(self.matched)
        for turn in range(choice.JOINING):
            parts = choice.parts_of(self.links, self.count)
            if not parts.any():
                break
            outside = choice.outside_largest(parts)
            c = self.candidates(choice.unique_pairs(choice.similar_pairs(self.signatures, outside, parts)))
            self.match(choice.joining_round(c, parts, (most - len(self.matched)) // (choice.JOINING - turn)))
        return len(self.matched) - begun

    def chosen(self, reported: tuple[Round, ...]) -> Chosen:
        """The matched pairs by the order of names; skipped ones that the whole needs are matched after all."""
        whole = self.skipped[choice.needed(self.skipped, self.links, self.count)]
        rows = _rows(choice.unique_pairs(self.place[self.matched]))
        return Chosen(pairs=rows, rounds=reported, whole=frozenset(_rows(choice.unique_pairs(self.place[whole]))))


def _rows(pairs: Index) -> tuple[tuple[int, int], ...]:
    return tuple((int(i), int(j)) for i, j in pairs)


def pairs_of(
    means: Means, photos: Sequence[Photo], store: FeatureStore, method: FeatureMethod, positions: Array | None
) -> Chosen:
    """The pairs to match; they are matched on the way, since what is needed beyond the first look depends on it.

    positions  (n, 3) where photographs were taken, NaN where not known; metres
    The choice depends neither on the number of jobs nor, but for neighbours in the sequence, on names.
    """
    n = len(photos)
    none = np.zeros((0, 2), np.int64)
    if n <= ALL:
        pairs = choice.all_pairs(n)
        if not method.looks:
            return Chosen(pairs=_rows(pairs))
        rounds = Rounds(
            means=means, photos=photos, store=store, method=method, place=np.arange(n), keys=list(store.keys),
            signatures=none, matched=none, links=none, skipped=none,
        )  # fmt: skip
        rounds.match(pairs)
        return rounds.chosen(())
    place = np.array(sorted(range(n), key=lambda i: (store.keys[i], i)), np.int64)
    features = [store.keys[i] for i in place]
    keys, signatures = signatures_of(means, features, method)
    rounds = Rounds(
        means=means, photos=photos, store=store, method=method, place=place, keys=keys, signatures=signatures,
        matched=none, links=none, skipped=none,
    )  # fmt: skip
    reported = [Round(why="likely", pairs=_begin(rounds, None if positions is None else positions[place]))]
    reported.append(Round(why="neighbours in common", pairs=rounds.go_on(choice.COMMON * n)))
    reported.append(Round(why="between parts", pairs=rounds.join(choice.EACH * n)))
    reported[1] = Round(why=reported[1].why, pairs=reported[1].pairs + rounds.go_on(choice.EACH * n))
    return rounds.chosen(tuple(reported))


def _begin(r: Rounds, positions: Array | None) -> int:
    """Match the first round; the number of its pairs."""
    certain, near = choice.sequence_pairs(r.place), np.zeros((0, 2), np.int64)
    if positions is not None:
        certain = np.concatenate([certain, choice.nearby_pairs(positions, choice.NEAR)])
        near = choice.nearby_pairs(positions, choice.NEARBY)
    certain = choice.unique_pairs(certain)
    c = r.candidates(choice.unique_pairs(certain, near, choice.similar_pairs(r.signatures)))
    r.match(choice.first_round(c, certain, r.count))
    return len(r.matched)


def signatures_of(means: Means, features: Sequence[str], method: FeatureMethod) -> tuple[list[str], Array]:
    """Keys of the signatures of photographs, and the signatures (n, LENGTH)."""
    words, known = "", ""
    if method.codebook:
        known = shipped_codebook(method.codebook).version
    else:
        some = tuple(features[:: max(1, len(features) // SAMPLED)][:SAMPLED])
        words = known = key_of("words", method.content, some)
        task = WordsTask(features=some, method=method.name)
        _all(means, [Task(key=words, function=f"{__name__}:words_product", inputs=some, options=task, cost=20.0)])
    tasks = [
        Task(
            key=key_of("signature", VERSION, known, key), function=f"{__name__}:signature_product",
            inputs=(key, *([words] if words else [])), cost=SIGNATURE_S,
            options=SignatureTask(features=key, method=method.name, words=words),
        )
        for key in features
    ]  # fmt: skip
    _all(means, tasks)
    keys = [t.key for t in tasks]
    first = means.store.wanted(keys[0], ("signature",))["signature"]
    signatures = np.empty((len(keys), len(first)), np.int16)
    for i, key in enumerate(keys):
        signatures[i] = means.store.wanted(key, ("signature",))["signature"]
    return keys, signatures


def shared_features(means: Means, keys: list[str], method: FeatureMethod, pairs: Index) -> Index:
    """(m,) features that the photographs of each pair share, by tasks of some pairs each."""
    tasks: list[Task] = []
    for begin in range(0, len(pairs), TOGETHER):
        images, some = np.unique(pairs[begin : begin + TOGETHER], return_inverse=True)
        own = tuple([keys[i] for i in images])
        rows = tuple([(int(i), int(j)) for i, j in some.reshape(-1, 2)])
        tasks.append(
            Task(
                key=key_of("comparison", COMPARISON, method.content, own, rows), function=f"{__name__}:compared",
                inputs=own, options=CompareTask(signatures=own, pairs=rows, method=method.name),
                cost=COMPARE_S * len(rows),
            )
        )  # fmt: skip
    _all(means, tasks)
    return np.concatenate([np.zeros(0, np.int64), *(means.store.wanted(t.key)["shared"] for t in tasks)])


def _all(means: Means, tasks: Sequence[Task]) -> None:
    """Do all tasks; InputError where one fails."""
    for reason in means.do(tasks, "choosing pairs").values():
        raise InputError(reason)
