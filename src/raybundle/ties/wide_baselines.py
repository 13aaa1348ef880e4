"""Wide baselines: photographs that the first matching leaves out or apart are matched in further ways, step by step.

Each method (all features, affine views, learned ones) takes pairs between a photograph that is not in the largest part
and the others.  Whatever proposes matches, a pair counts only if chance makes one like it less than once in a thousand
runs, all pairs tried counted; and the photographs are oriented anew with it, with every test of repeated structure.
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
"""First word of the keys of features with those of wide baselines behind them"""
COSTS = {
    "rootsift, affine views": (1.5, 0.35), "xfeat": (0.8, 0.6), "disk": (6.5, 2.5),
}  # fmt: skip
"""CPU seconds of the features of a photograph and of a pair (6 megapixels)."""
OTHER_COST = (1.0, 1.0)
BUDGET_EACH_S, BUDGET_S, BUDGET_OF_ALL_S = 20.0, 60.0, 5.0
"""CPU seconds for each photograph that is not in the largest part; at most so many, and so many for each of all."""
NEIGHBOURS = 2
"""Of an oriented photograph, with which it is matched by a method that joined another to it."""
PARTNERS = 6
"""Pairs of such a photograph that one method tries at a time."""
TURNS = 2
"""Times that a method goes on with what it has joined."""
REPEATED = "repeated_structure"
DOUBT = 1e-3
"""Pairs of all that are tried which chance may make."""
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
    """by the costs on which the budget is based"""


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


def budget_s(apart: int, photographs: int) -> float:
    """CPU seconds that further matching may take, where so many photographs are not in the largest part."""
    return min(BUDGET_EACH_S * apart, BUDGET_S + BUDGET_OF_ALL_S * photographs)


def cost_s(method: str, pairs: Index) -> float:
    """CPU seconds of pairs (m, 2) by a method, with the features of their photographs."""
    photo_s, pair_s = COSTS.get(method, OTHER_COST)
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
    proposed: list[tuple[VerifiedPair, FeatureStore]] = field(default_factory=list[tuple[VerifiedPair, FeatureStore]])
    """pairs that chance does not make, and the features that they match"""
    _candidates: Candidates | None = None

    def climb(self, methods: Sequence[FeatureMethod]) -> None:
        """Take one method after the other, until all photographs are in one part or the budget is spent."""
        n = len(self.photos)
        self.budget_s = budget_s(len(self._outside()), n)
        for method in methods:
            step, tried = Step(method=method.name), np.zeros((0, 2), np.int64)
            for _ in range(TURNS):
                pairs = self._affordable(method, self._likely(tried), tried)
                if not len(pairs):
                    break
                found, before = self._proven(method, pairs), self._outside()
                tried = choice.unique_pairs(tried, pairs)
                if found:
                    around = self._affordable(method, self._around(found, tried), tried)
                    found += self._proven(method, around)
                    tried = choice.unique_pairs(tried, around)
                self.proposed += [(p, self._features(method, (p.first, p.second))[0]) for p in found]
                better = bool(found) and self._taken()
                step = replace(
                    step, pairs=len(tried), verified=step.verified + len(found), cpu_s=cost_s(method.name, tried),
                    joined=(*step.joined, *(self.photos[i].name for i in before if i not in self._outside())),
                )  # fmt: skip
                if not better:
                    break
            if step.pairs:
                self.steps.append(step)

    def _outside(self) -> list[int]:
        """Photographs that are not in the largest part."""
        return [i for i in np.flatnonzero(self.best.parts(len(self.photos)) != 0).tolist() if i not in self.out]

    def _likely(self, tried: Index) -> Index:
        """(m, 2) pairs that may hang photographs or join parts, the likeliest first, some of each photograph."""
        n, part, outside = len(self.photos), self.best.parts(len(self.photos)), self._outside()
        if not outside:
            return tried[:0]
        label = np.where(part < 0, n + np.arange(n), part)
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
            if left.get(i, 0) or left.get(j, 0):
                chosen.append((i, j))
                left |= {k: left[k] - 1 for k in (i, j) if k in left}
        return np.array(chosen, np.int64).reshape(-1, 2)

    def _affordable(self, method: FeatureMethod, pairs: Index, tried: Index) -> Index:
        """As many of the pairs as the budget allows, the first ones."""
        left = self.budget_s - sum(s.cpu_s for s in self.steps)
        cost = [cost_s(method.name, np.vstack([tried, pairs[: k + 1]])) for k in range(len(pairs))]
        return pairs[: int(np.searchsorted(cost, left, side="right"))]

    def _around(self, found: Sequence[VerifiedPair], tried: Index) -> Index:
        """(m, 2) pairs of oriented photographs and their strongest neighbours: points need a third ray."""
        part = self.best.parts(len(self.photos))
        strong = sorted((p for p in self.best.pairs if len(p.matches)), key=lambda p: -len(p.matches))
        chosen = [tried[:0]]
        for i in sorted({k for p in found for k in (p.first, p.second) if part[k] >= 0}):
            near = [(p.first, p.second) for p in strong if i in (p.first, p.second) and part[p.first] == part[p.second]]
            chosen.append(np.array(near[:NEIGHBOURS], np.int64).reshape(-1, 2))
        pairs = choice.unique_pairs(*chosen)
        return pairs[~choice.contained(pairs, tried)]

    def _features(self, method: FeatureMethod, some: Sequence[int]) -> tuple[FeatureStore, set[int]]:
        """Features by a method of some photographs, and those that could not be read."""
        found, lost = find_features(self.means, [self.photos[i] for i in some], method, self.count, self.masks)
        keys = dict(zip(some, found.keys, strict=True))
        return FeatureStore(found.store, tuple(keys.get(i, "") for i in range(len(self.photos)))), {some[k] for k in lost}

    def _proven(self, method: FeatureMethod, pairs: Index) -> list[VerifiedPair]:
        """The pairs that chance does not make."""
        features, lost = self._features(method, np.unique(pairs).tolist())
        rows = [(i, j) for i, j in choice.unique_pairs(pairs).tolist() if not {i, j} & lost]
        found = verified_pairs(self.means, self.photos, features, method, rows)
        self.trials += len(rows)
        limit = np.log(DOUBT) - np.log(self.trials)
        good = [p for p in found if len(p.matches) and p.geometry != "rotation" and p.log_chance < limit]
        return [replace(p, method=method.name) for p in good]

    def _supported(self) -> tuple[list[tuple[VerifiedPair, FeatureStore]], dict[tuple[int, int], VerifiedPair]]:
        """Of the proposed pairs those that agree with what is oriented; and earlier ones without what contradicts them."""
        n, part = len(self.photos), self.best.parts(len(self.photos))
        proposed = [(p, self._common(p, f)) for p, f in self.proposed]
        known = [(p, self._common(p, self.best.features)) for p in self.best.pairs if len(p.matches)]
        good: dict[int, Mask] = {}
        pruned: dict[tuple[int, int], VerifiedPair] = {}
        for q, tie in enumerate(self.best.ties):
            block = tie.block
            for k, (p, c) in enumerate(proposed):
                if part[p.first] == part[p.second] == q:
                    fits = fitting(block, c)
                    if fits.mean() >= AGREEING:
                        good[k] = fits
            label = np.where(part < 0, n + np.arange(n), part)
            for g in np.unique(label[self._outside()]).tolist():
                if g == q or (q and g < n):
                    continue
                mine = [k for k, (p, _) in enumerate(proposed) if {label[p.first], label[p.second]} == {g, q}]
                before = [(p, c) for p, c in known if {label[p.first], label[p.second]} == {g, q}]
                if not mine:
                    continue
                other = self.best.ties[g].block if g < n else block
                agree = agreeing(block, other, [*(proposed[k][1] for k in mine), *(c for _, c in before)])
                if agree is None:
                    continue
                good |= {mine[m]: fits for m, fits in agree.items() if m < len(mine)}
                for m, (p, _) in enumerate(before, len(mine)):
                    fits = agree.get(m, np.zeros(len(p.matches), bool))
                    pruned[p.first, p.second] = replace(p, matches=p.matches[fits])
        chosen = [(*self.proposed[k], m) for k, m in good.items()]
        return [(replace(p, matches=p.matches[m]), f) for p, f, m in chosen if m.sum() >= FEWEST], pruned

    def _common(self, p: VerifiedPair, features: FeatureStore) -> Common:
        xy = tuple(features.places(i).xy_px[p.matches[:, e]] for e, i in enumerate((p.first, p.second)))
        strong = p.method not in LEARNED and len(p.matches) >= max(STRONG, SHARE * p.candidates)
        return Common(first=p.first, second=p.second, strong=strong, xy=(xy[0], xy[1]))

    def _taken(self) -> bool:
        """Whether the orientation with the supported pairs is better; it is taken then.

        Better: more photographs in the largest part, or as many and more in all; none is lost, and no fault is new.
        """
        n = len(self.photos)
        found, pruned = self._supported()
        if not any(len({*self.best.parts(n)[[p.first, p.second]]}) > 1 for p, _ in found):
            return False
        pairs = tuple(pruned.get((p.first, p.second), p) for p in self.best.pairs)
        features = self.best.features
        for name in dict.fromkeys(p.method for p, _ in found):
            some = [(p, f) for p, f in found if p.method == name]
            keys = [next((f.keys[i] for _, f in some if f.keys[i]), "") for i in range(n)]
            own = FeatureStore(features.store, tuple(keys))
            pairs, features = with_pairs(pairs, features, [p for p, _ in some], own, self.photos)
        try:
            new = self.arrange(pairs, features)
        except NoOrientation:
            return False
        before, after = self.best.parts(n), new.parts(n)
        largest, total = (int((after == 0).sum() - (before == 0).sum()), int((after >= 0).sum() - (before >= 0).sum()))
        if max(largest, total) <= 0 or min(largest, total) < 0 or new.faults > self.best.faults:
            return False
        self.best = new
        return True


def same_px(size: int) -> float:
    """Distance [px] up to which features of a photograph of this longer side are one."""
    return SAME_PX * max(size / LONGEST_PX, 1.0)


def with_pairs(
    old: Sequence[VerifiedPair], old_features: FeatureStore, found: Sequence[VerifiedPair], features: FeatureStore,
    photos: Sequence[Photo],
) -> tuple[tuple[VerifiedPair, ...], FeatureStore]:
    """All pairs, and the features with those that further pairs match behind them.

    features  that the pairs match, of their photographs alone
    """
    keys, new = list(old_features.keys), dict[tuple[int, int, int], Index]()
    for i in sorted({k for p in found for k in (p.first, p.second)}):
        ends = [p.matches[:, 0 if p.first == i else 1] for p in found if i in (p.first, p.second)]
        used = np.unique(np.concatenate(ends))
        size = max(photos[i].width_px, photos[i].height_px)
        whole, place = joined_features(old_features.of(i), features.of(i).rows(used), same_px(size))
        arrays = arrays_of_features(whole)
        keys[i] = key_of(KIND, arrays)
        if not features.store.has(keys[i]):
            features.store.store(keys[i], arrays)
        for p, end in zip((p for p in found if i in (p.first, p.second)), ends, strict=True):
            side = 0 if p.first == i else 1
            new[p.first, p.second, side] = place[np.searchsorted(used, end)]
    pairs = {(p.first, p.second): p for p in old}
    for p in found:
        was = pairs.get((p.first, p.second))
        matches = np.column_stack([new[p.first, p.second, 0], new[p.first, p.second, 1]])
        if was is not None and (was.method or len(was.matches) >= max(STRONG, SHARE * was.candidates)):
            matches = np.vstack([was.matches, matches])
        pairs[p.first, p.second] = replace(p, matches=np.unique(matches, axis=0).astype(np.int32))
    return tuple(pairs[k] for k in sorted(pairs)), FeatureStore(features.store, tuple(keys))


def joined_features(old: Features, new: Features, same_px: float) -> tuple[Features, Index]:
    """Features with new ones behind them, without descriptors, and the place (k,) of each new one among all.

    A new one closer to another than `same_px` is that one.
    """
    tree = KDTree(np.vstack([old.xy_px, new.xy_px]))
    place, added = np.empty(len(new), np.int64), list[int]()
    n = len(old)
    distance, nearest = KDTree(old.xy_px).query(new.xy_px) if n else (np.full(len(new), np.inf), place)
    for k in range(len(new)):
        if distance[k] <= same_px:
            place[k] = nearest[k]
            continue
        near = [m - n for m in tree.query_ball_point(new.xy_px[k], same_px) if n <= m < n + k and place[m - n] >= n]
        if near:
            place[k] = place[near[0]]
        else:
            place[k] = n + len(added)
            added.append(k)
    more = new.rows(np.array(added, np.int64))
    return Features(
        xy_px=np.vstack([old.xy_px, more.xy_px]), scale_px=np.concatenate([old.scale_px, more.scale_px]),
        angle=np.concatenate([old.angle, more.angle]),
        descriptors=np.vstack([old.descriptors, np.zeros((len(more), old.descriptors.shape[1]), np.uint8)]),
    ), place  # fmt: skip
