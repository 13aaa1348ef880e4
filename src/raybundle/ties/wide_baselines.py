"""Wide baselines: photographs that the first matching leaves out, or in other parts, are matched by further methods.

Each method (affine views, then learned ones) takes pairs of a photograph that is not in the largest part with oriented
ones.  Whatever proposes matches, a pair counts if chance makes one like it less than once in a thousand runs, all pairs
tried counted, and if it agrees with the others in the rotation between the parts (`ties.rotations`).  All photographs
are then oriented anew, with every test of repeated structure; what is no better is not taken.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from scipy.spatial import KDTree

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.errors import NoOrientation
from raybundle.io.photos.masks import Masks
from raybundle.io.photos.photo import Photo
from raybundle.matching import pairs as choice
from raybundle.matching.features import FeatureMethod, Features
from raybundle.matching.methods import LEARNED
from raybundle.matching.pairs import Candidates
from raybundle.matching.reduced import LONGEST_PX
from raybundle.matching.signatures import likeness
from raybundle.matching.verify import FEWEST, SHARE, STRONG, VerifiedPair
from raybundle.numerics.arrays import Index, Mask
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.stage import Means
from raybundle.ties.block import TieBlock
from raybundle.ties.pairs import shared_features, signatures_of
from raybundle.ties.points import FeatureStore, arrays_of_features, find_features, verified_pairs
from raybundle.ties.repeated import AGREEING
from raybundle.ties.rotations import Common, agreeing, fitting

KIND = "joined-features"
"""First word of the keys of features with those of further methods behind them"""
REPEATED = "repeated_structure"
"""Code of notices"""
COSTS = {"affine_views": (1.5, 0.35), "xfeat": (0.8, 0.6), "disk": (6.5, 2.5)}
"""CPU seconds of the features of a photograph of 6 megapixels, and of a pair."""
BUDGET_EACH_S, BUDGET_S, BUDGET_OF_ALL_S = 20.0, 60.0, 5.0
"""CPU seconds for each photograph that is not in the largest part; at most so many, and so many for each of all."""
PARTNERS, NEIGHBOURS = 6, 2
"""Pairs of such a photograph that a method tries at a time; pairs of an oriented partner with its strongest neighbours,
which give points a third ray."""
TURNS = 2
"""Times that a method goes on with what it has joined."""
DOUBT = 1e-3
"""Pairs that chance may make, of all that are tried."""
SAME_PX = 1.5
"""Distance up to which features of a photograph are one: only so do points get a third ray."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Step:
    """What a method gave."""

    method: str
    pairs: int = 0
    """tried"""
    verified: int = 0
    joined: tuple[str, ...] = ()
    """photographs that it brought into the largest part"""
    cpu_s: float = 0.0
    """by `COSTS`"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Arranged:
    """Pairs, the features that they match, and the parts that come of them."""

    pairs: tuple[VerifiedPair, ...]
    features: FeatureStore
    ties: tuple[TieBlock, ...]
    notices: tuple[Notice, ...] = ()
    """of repeated structure"""
    counted: tuple[int, int] = (0, 0)
    """features, and those in tracks"""

    @property
    def faults(self) -> int:
        """Faults among the notices."""
        return sum(n.code == REPEATED and n.severity == Severity.FAULT for n in self.notices)

    def parts(self, count: int) -> Index:
        """(n,) part of each photograph, 0 the largest; -1 without orientation."""
        part = np.full(count, -1)
        for k, t in reversed(list(enumerate(self.ties))):
            part[t.block.images.oriented] = k
        return part


Arrange = Callable[[tuple[VerifiedPair, ...], FeatureStore], Arranged]
"""Orients anew; raises NoOrientation"""
Proposed = tuple[VerifiedPair, FeatureStore]
"""A pair and the features that it matches"""


def budget_s(apart: int, photographs: int) -> float:
    """CPU seconds that further matching may take, where so many photographs are not in the largest part."""
    return min(BUDGET_EACH_S * apart, BUDGET_S + BUDGET_OF_ALL_S * photographs)


def cost_s(method: str, pairs: Index) -> float:
    """CPU seconds of pairs (m, 2) by a method, with the features of their photographs."""
    photo_s, pair_s = COSTS.get(method, (1.0, 1.0))
    return photo_s * len(np.unique(pairs)) + pair_s * len(pairs)


@dataclass(slots=True, kw_only=True)
class WideBaselines:
    """The work on a set of photographs."""

    means: Means
    photos: Sequence[Photo]
    masks: Masks | None
    method: FeatureMethod
    """of the first matching"""
    count: int
    """features of a photograph"""
    out: frozenset[int]
    """photographs that take no part"""
    arrange: Arrange
    best: Arranged
    trials: int
    """pairs that were verified"""
    budget_s: float = 0.0
    steps: list[Step] = field(default_factory=list[Step])
    proposed: list[Proposed] = field(default_factory=list[Proposed])
    """that chance does not make"""
    _candidates: Candidates | None = None

    def climb(self, methods: Sequence[FeatureMethod]) -> None:
        """Take one method after the other, until all photographs are in one part or the budget is spent."""
        self.budget_s = budget_s(len(self._outside()), len(self.photos))
        for method in methods:
            step, tried = Step(method=method.name), np.zeros((0, 2), np.int64)
            for _ in range(TURNS):
                pairs = self._affordable(method, self._likely(tried), tried)
                if not len(pairs):
                    break
                before, found = self._outside(), self._proven(method, pairs)
                tried = choice.unique_pairs(tried, pairs)
                if found:
                    around = self._affordable(method, self._around(found, tried), tried)
                    found += self._proven(method, around)
                    tried = choice.unique_pairs(tried, around)
                self.proposed += found
                better = bool(found) and self._taken()
                step = replace(
                    step, pairs=len(tried), verified=step.verified + len(found), cpu_s=cost_s(method.name, tried),
                    joined=(*step.joined, *(self.photos[i].name for i in before if i not in self._outside())),
                )  # fmt: skip
                if not better:
                    break
            if step.pairs:
                self.steps.append(step)

    def _parts(self) -> Index:
        return self.best.parts(len(self.photos))

    def _labels(self) -> Index:
        """(n,) as the parts, and a number of its own for each photograph without orientation."""
        n, part = len(self.photos), self._parts()
        return np.where(part < 0, n + np.arange(n), part)

    def _outside(self) -> list[int]:
        """Photographs that are not in the largest part."""
        return [i for i in np.flatnonzero(self._parts() != 0).tolist() if i not in self.out]

    def _likely(self, tried: Index) -> Index:
        """(m, 2) pairs that may hang photographs or join parts, the likeliest first, some of each photograph."""
        n, part, label, outside = len(self.photos), self._parts(), self._labels(), self._outside()
        if not outside:
            return tried[:0]
        if self._candidates is None:
            keys, signatures = signatures_of(self.means, self.best.features.keys, self.method)
            similar = choice.similar_pairs(signatures, np.array(outside), label)
            pairs = choice.unique_pairs(similar, choice.sequence_pairs(np.arange(n)))
            self._candidates = Candidates(
                pairs=pairs, shared=shared_features(self.means, keys, self.method, pairs),
                likeness=likeness(signatures, pairs),
            )  # fmt: skip
        c = self._candidates.new(tried)
        ends = label[c.pairs]
        useful = (ends[:, 0] != ends[:, 1]) & (part[c.pairs].max(axis=1) >= 0)
        c = c.rows(useful & ~np.isin(c.pairs, sorted(self.out)).any(axis=1))
        matches = {(p.first, p.second): len(p.matches) for p in self.best.pairs}
        before = np.array([matches.get((i, j), 0) for i, j in c.pairs.tolist()], np.int64)
        left, chosen = dict.fromkeys(outside, PARTNERS), list[tuple[int, int]]()
        for i, j in c.pairs[c.order(before)].tolist():
            if left.get(i, 0) > 0 or left.get(j, 0) > 0:
                chosen.append((i, j))
                left |= {k: left[k] - 1 for k in (i, j) if k in left}
        return np.array(chosen, np.int64).reshape(-1, 2)

    def _around(self, found: Sequence[Proposed], tried: Index) -> Index:
        """(m, 2) pairs of oriented partners and their strongest neighbours."""
        part = self._parts()
        strong = sorted((p for p in self.best.pairs if len(p.matches)), key=lambda p: -len(p.matches))
        within = [(p.first, p.second) for p in strong if part[p.first] == part[p.second] >= 0]
        partners = sorted({k for p, _ in found for k in (p.first, p.second) if part[k] >= 0})
        chosen = [e for i in partners for e in [w for w in within if i in w][:NEIGHBOURS]]
        pairs = choice.unique_pairs(np.array(chosen, np.int64).reshape(-1, 2))
        return pairs[~choice.contained(pairs, tried)]

    def _affordable(self, method: FeatureMethod, pairs: Index, tried: Index) -> Index:
        """As many of the pairs as the budget allows, the first ones."""
        left = self.budget_s - sum(s.cpu_s for s in self.steps)
        cost = [cost_s(method.name, np.vstack([tried, pairs[: k + 1]])) for k in range(len(pairs))]
        return pairs[: int(np.searchsorted(cost, left, side="right"))]

    def _proven(self, method: FeatureMethod, pairs: Index) -> list[Proposed]:
        """The pairs that chance does not make."""
        some = np.unique(pairs).tolist()
        found, lost = find_features(self.means, [self.photos[i] for i in some], method, self.count, self.masks)
        keys, gone = dict(zip(some, found.keys, strict=True)), {some[k] for k in lost}
        features = FeatureStore(found.store, tuple(keys.get(i, "") for i in range(len(self.photos))))
        rows = [(i, j) for i, j in choice.unique_pairs(pairs).tolist() if not {i, j} & gone]
        verified = verified_pairs(self.means, self.photos, features, method, rows)
        self.trials += len(rows)
        limit = np.log(DOUBT / self.trials) if rows else 0.0
        good = [p for p in verified if len(p.matches) and p.geometry != "rotation" and p.log_chance < limit]
        return [(replace(p, method=method.name), features) for p in good]

    def _agreeing(self) -> tuple[list[Proposed], dict[tuple[int, int], VerifiedPair]]:
        """The proposed pairs that agree with what is oriented, and pairs of before without what contradicts them."""
        n, part, label = len(self.photos), self._parts(), self._labels()
        proposed = [(p, _common(p, f)) for p, f in self.proposed]
        known = [(p, _common(p, self.best.features)) for p in self.best.pairs if len(p.matches)]
        good: dict[int, Mask] = {}
        pruned: dict[tuple[int, int], VerifiedPair] = {}
        for q, tie in enumerate(self.best.ties):
            for k, (p, c) in enumerate(proposed):
                if part[p.first] == part[p.second] == q and (fits := fitting(tie.block, c)).mean() >= AGREEING:
                    good[k] = fits
            for g in np.unique(label[self._outside()]).tolist():
                mine = [k for k, (p, _) in enumerate(proposed) if {label[p.first], label[p.second]} == {g, q}]
                if g == q or (q and g < n) or not mine:
                    continue
                before = [(p, c) for p, c in known if {label[p.first], label[p.second]} == {g, q}]
                other = self.best.ties[g].block if g < n else tie.block
                agree = agreeing(tie.block, other, [*(proposed[k][1] for k in mine), *(c for _, c in before)])
                if agree is None:
                    continue
                good |= {mine[m]: fits for m, fits in agree.items() if m < len(mine)}
                for m, (p, _) in enumerate(before, len(mine)):
                    fits = agree.get(m, np.zeros(len(p.matches), bool))
                    pruned[p.first, p.second] = replace(p, matches=p.matches[fits])
        chosen = [(*self.proposed[k], m) for k, m in good.items() if m.sum() >= FEWEST]
        return [(replace(p, matches=p.matches[m]), f) for p, f, m in chosen], pruned

    def _taken(self) -> bool:
        """Whether the orientation with the agreeing pairs is better; it is taken then.

        Better: more photographs in the largest part, or as many and more in all; none is lost, and no fault is new.
        """
        before = self._parts()
        found, pruned = self._agreeing()
        if not any(before[p.first] != before[p.second] or before[p.first] < 0 for p, _ in found):
            return False
        pairs = tuple(pruned.get((p.first, p.second), p) for p in self.best.pairs)
        features = self.best.features
        for name in dict.fromkeys(p.method for p, _ in found):
            pairs, features = with_pairs(pairs, features, [f for f in found if f[0].method == name], self.photos)
        try:
            new = self.arrange(pairs, features)
        except NoOrientation:
            return False
        after = new.parts(len(self.photos))
        lost = ((before == 0) & (after != 0)) | ((before >= 0) & (after < 0))
        more = (after == 0).sum() > (before == 0).sum() or (after >= 0).sum() > (before >= 0).sum()
        if lost.any() or not more or new.faults > self.best.faults:
            return False
        self.best = new
        return True


def _common(p: VerifiedPair, features: FeatureStore) -> Common:
    """A pair's matches by their places; by itself none of a learned method is believed."""
    first, second = (features.places(i).xy_px[p.matches[:, k]] for k, i in enumerate((p.first, p.second)))
    strong = p.method not in LEARNED and len(p.matches) >= max(STRONG, SHARE * p.candidates)
    return Common(first=p.first, second=p.second, strong=strong, xy=(first, second))


def with_pairs(
    old: Sequence[VerifiedPair], features: FeatureStore, found: Sequence[Proposed], photos: Sequence[Photo]
) -> tuple[tuple[VerifiedPair, ...], FeatureStore]:
    """All pairs, and the features with those that pairs found by one method match behind them."""
    keys, places = list(features.keys), dict[tuple[int, int, int], Index]()
    for i in sorted({k for p, _ in found for k in (p.first, p.second)}):
        ends = {
            (p.first, p.second, e): p.matches[:, e] for p, _ in found for e in (0, 1) if (p.first, p.second)[e] == i
        }
        used = np.unique(np.concatenate(list(ends.values())))
        theirs = next(f for p, f in found if i in (p.first, p.second))
        size = max(photos[i].width_px, photos[i].height_px)
        whole, place = joined_features(
            features.of(i), theirs.of(i).rows(used), SAME_PX * max(size / LONGEST_PX, 1.0)
        )  # fmt: skip
        arrays = arrays_of_features(whole)
        keys[i] = key_of(KIND, arrays)
        if not features.store.has(keys[i]):
            features.store.store(keys[i], arrays)
        places |= {k: place[np.searchsorted(used, end)] for k, end in ends.items()}
    pairs = {(p.first, p.second): p for p in old}
    for p, _ in found:
        was = pairs.get((p.first, p.second))
        matches = np.column_stack([places[p.first, p.second, 0], places[p.first, p.second, 1]])
        if was is not None and (was.method or len(was.matches) >= max(STRONG, SHARE * was.candidates)):
            matches = np.vstack([was.matches, matches])
        pairs[p.first, p.second] = replace(p, matches=np.unique(matches, axis=0).astype(np.int32))
    return tuple(pairs[k] for k in sorted(pairs)), FeatureStore(features.store, tuple(keys))


def joined_features(old: Features, new: Features, same_px: float) -> tuple[Features, Index]:
    """Features with new ones behind them, without descriptors, and the place (k,) of each new one among all.

    A new one closer to another than `same_px` is that one.
    """
    n, place, added = len(old), np.full(len(new), -1), list[int]()
    if n:
        distance, nearest = (np.asarray(a) for a in KDTree(old.xy_px).query(new.xy_px))
        place = np.where(distance <= same_px, nearest, place)
    tree = KDTree(new.xy_px)
    for k in range(len(new)):
        if place[k] < 0:
            others = np.array(tree.query_ball_point(new.xy_px[k], same_px), np.int64)
            place[others[place[others] < 0]] = n + len(added)
            added.append(k)
    more = new.rows(np.array(added, np.int64))
    whole = Features(
        xy_px=np.vstack([old.xy_px, more.xy_px]), scale_px=np.concatenate([old.scale_px, more.scale_px]),
        angle=np.concatenate([old.angle, more.angle]),
        descriptors=np.vstack([old.descriptors, np.zeros((len(more), old.descriptors.shape[1]), np.uint8)]),
    )  # fmt: skip
    return whole, place
