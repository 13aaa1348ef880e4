"""Photographs that are mirrored against the others, as a scanned slide that lay the wrong way up.

Few of their matches with the others are right, by chance or where things are symmetrical; they hang a photograph, or a
part of several, at a wrong place with small residuals.  Parts that hang together by weak pairs only are therefore
compared as they are, and mirrored: descriptors of the mirrored picture need no detection.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import KDTree

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.io.photos.photo import Photo
from raybundle.matching import pairs as choice
from raybundle.matching.features import Described, FeatureMethod
from raybundle.matching.verify import FEWEST, STRONG, VerifiedPair, verify
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.rows import rows_of_each
from raybundle.ties.points import FeatureStore

WEAK = 0.5
"""Share of the median of the strongest pairs of all photographs below which a pair is weak."""
LIKELY, TIMES, CERTAIN, FEW, ALONE = 0.3, 2.0, 8.0, 20, 120
"""Matches of a mirrored part: as a share of that median, for one as it is, and where it is left out also for one that
the scene has with its own mirror image, of which so few are always expected; at least, of a part that hangs on nothing.
`benchmarks/mirrored.py`."""
MIRRORING = (2, 4, 5, 7)
"""Orientations in EXIF of pictures that are stored mirrored"""
COMPARED, TRIED, LOOKED = 64, 2, 1000
"""Pairs of a part that are compared, by so many features, and those of them that are matched."""
FEW_PARTS, PAIRS_EACH = 8, 100
"""Parts that are compared at most, the weakest first; and one more for so many pairs of photographs."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Mirrored:
    """Photographs that are mirrored against the others."""

    photographs: tuple[int, ...]
    pair: tuple[int, int]
    """that shows it: the first one is mirrored against the second"""
    matches: int
    """of this pair, mirrored"""
    plain: int
    """of any pair of the same two parts, as it is"""
    certain: bool
    """whether nothing else explains it: a symmetrical object has matches with its own mirror image"""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Edge:
    """What joins two parts: matches as they are, or mirrored."""

    parts: tuple[int, int]
    matches: int
    shown: Mirrored | None = None


Flipped = Callable[[int, int], int]
"""Verified matches of two photographs, the first one mirrored"""
Alike = Callable[[int, int], int]
"""The same by a rough comparison"""


def mirrored_photographs(
    pairs: Sequence[VerifiedPair], photos: Sequence[Photo], store: FeatureStore, method: FeatureMethod
) -> Mirrored | None:
    """The photographs that are mirrored against most of those that they hang together with; None: not found.

    Limits: half a set, and a whole one; methods that do not know the descriptors of mirrored pictures.
    """
    ends = np.array([(p.first, p.second) for p in pairs], np.int64).reshape(-1, 2)
    count = np.array([len(p.matches) for p in pairs], np.int64)
    if not len(ends) or method.mirrored(np.zeros((1, 128), np.uint8)) is None:
        return None
    look = _Look(photos, store, method)
    return mirrored_among(ends, count, len(photos), look.alike, look.flipped)


def mirrored_among(ends: Index, count: Index, n: int, alike: Alike, flipped: Flipped) -> Mirrored | None:
    """The same of pairs (m, 2) of n photographs with so many matches."""
    best = np.zeros(n, np.int64)
    for k in (0, 1):
        np.maximum.at(best, ends[:, k], count)
    usual = float(np.median(best[best > 0])) if best.any() else 0.0
    if usual * LIKELY < FEWEST:
        return None
    part = choice.parts_of(ends[count >= WEAK * usual], n)
    across = np.flatnonzero((part[ends[:, 0]] != part[ends[:, 1]]) & (count >= FEWEST))
    join = np.zeros(int(part.max()) + 1, np.int64)
    for k in (0, 1):
        np.maximum.at(join, part[ends[across, k]], count[across])
    of_part = rows_of_each(part, len(join))
    largest = int(np.argmax([len(m) for m in of_part]))
    hanging = [g for g in np.argsort(join, kind="stable").tolist() if g != largest]
    hanging.sort(key=lambda g: not join[g])
    mirrored = list[_Edge]()
    for g in hanging[: max(FEW_PARTS, len(ends) // PAIRS_EACH)]:
        if not join[g] and not mirrored and len(hanging) > FEW_PARTS:  # they hang on nothing, and take no part
            break
        mine = of_part[g]
        candidates = _candidates(mine, part, ends, count)
        ranked = sorted(((alike(i, j), i, j) for i, j in candidates.tolist()), reverse=True)[:TRIED]
        m, i, j = max((flipped(i, j), i, j) for _, i, j in ranked)
        if m < (max(LIKELY * usual, TIMES * join[g], STRONG) if join[g] else ALONE):
            continue
        own = max(flipped(j, k) for k in [j, *_strongest(j, part, ends, count)])
        between = (part[ends[across]] == g).any(axis=1) & (part[ends[across]] == part[j]).any(axis=1)
        plain = int(count[across[between]].max(initial=0))
        shown = Mirrored(
            photographs=(), pair=(i, j), matches=m, plain=plain, certain=m >= CERTAIN * max(plain, own, FEW)
        )
        mirrored.append(_Edge(parts=(g, int(part[j])), matches=m, shown=shown))
    if not mirrored:
        return None
    plain = [
        _Edge(parts=(i, j), matches=m)
        for (i, j), m in zip(part[ends[across]].tolist(), count[across].tolist(), strict=True)
    ]
    return _minority([*plain, *mirrored], of_part)


def _candidates(mine: Index, part: Index, ends: Index, count: Index) -> Index:
    """(k, 2) photographs of a part and others: with the most matches, and next to each other in the sequence."""
    others = np.flatnonzero(part != part[mine[0]])
    if len(mine) * len(others) <= COMPARED:
        return np.stack(np.meshgrid(mine, others, indexing="ij"), axis=-1).reshape(-1, 2)
    inside = np.isin(ends, mine)
    rows = np.flatnonzero(inside[:, 0] != inside[:, 1])
    rows = rows[np.argsort(-count[rows], kind="stable")][: COMPARED // 2]
    weak = np.where(inside[rows, :1], ends[rows], ends[rows, ::-1])
    at = np.searchsorted(others, mine)
    near = [
        (i, others[k]) for i, a in zip(mine, at, strict=True) for k in range(max(a - 4, 0), min(a + 4, len(others)))
    ]
    near.sort(key=lambda e: abs(int(e[0]) - int(e[1])))
    return np.unique(np.vstack([weak, np.array(near[: COMPARED // 2], np.int64).reshape(-1, 2)]), axis=0)


def _strongest(j: int, part: Index, ends: Index, count: Index) -> list[int]:
    """The photographs of its part with which one has most matches."""
    rows = np.flatnonzero((ends == j).any(axis=1) & (part[ends] == part[j]).all(axis=1))
    rows = rows[np.argsort(-count[rows], kind="stable")][:TRIED]
    return [int(e[e != j][0]) for e in ends[rows]]


def _minority(edges: Sequence[_Edge], of_part: Sequence[Index]) -> Mirrored | None:
    """The strongest edges join the parts to trees; of each the smaller side is mirrored."""
    tree, side = list(range(len(of_part))), [False] * len(of_part)
    members = {g: [g] for g in tree}
    used: list[Mirrored] = []
    for e in sorted(edges, key=lambda e: -e.matches):
        a, b = (tree[g] for g in e.parts)
        if a == b:
            continue
        turn = side[e.parts[0]] ^ side[e.parts[1]] ^ (e.shown is not None)
        for g in members[b]:
            tree[g], side[g] = a, side[g] ^ turn
        members[a] += members.pop(b)
        used += [] if e.shown is None else [e.shown]
    if not used:  # stronger ones join the same parts as they are
        return None
    out, halves = list[int](), False
    for parts in members.values():
        sides = [[k for g in parts if side[g] is s for k in of_part[g].tolist()] for s in (False, True)]
        out += min(sides, key=len)
        halves |= len(sides[0]) == len(sides[1])
    shown = max(used, key=lambda m: m.matches)
    first, second = shown.pair if shown.pair[0] in out else shown.pair[::-1]
    certain = all(m.certain for m in used) and not halves
    return replace(shown, photographs=tuple(sorted(out)), pair=(first, second), certain=certain)


def same_handed(p: Array, q: Array) -> bool:
    """Whether most triangles of neighbours (n, 2) run the same way round in both pictures.

    Things that look like their own mirror image, as round ones, match at their own place, the wrong way round.
    """
    if len(p) < FEWEST:
        return False
    near = np.asarray(KDTree(p).query(p, k=3)[1])
    area = [_cross(x[near[:, 1]] - x[near[:, 0]], x[near[:, 2]] - x[near[:, 0]]) for x in (p, q)]
    return float(np.mean(area[0] * area[1] > 0)) > 0.5


def _cross(a: Array, b: Array) -> Array:
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


@dataclass(slots=True)
class _Look:
    """Comparisons of photographs, one of them mirrored."""

    photos: Sequence[Photo]
    store: FeatureStore
    method: FeatureMethod
    _last: tuple[int, Array] = (-1, np.zeros((0, 128), np.uint8))

    def alike(self, i: int, j: int) -> int:
        """By the strongest features."""
        return self.method.shared(self._mirrored(i)[:LOOKED], self.store.of(j).descriptors[:LOOKED])

    def flipped(self, i: int, j: int) -> int:
        """By all features, verified."""
        one, two = self.store.of(i), self.store.of(j)
        sizes = [(self.photos[k].width_px, self.photos[k].height_px) for k in (i, j)]
        xy = np.column_stack([sizes[0][0] - one.xy_px[:, 0], one.xy_px[:, 1]])
        a = Described(xy_px=xy, descriptors=self._mirrored(i), size_px=sizes[0])
        b = Described(xy_px=two.xy_px, descriptors=two.descriptors, size_px=sizes[1])
        found = verify(i, j, xy, two.xy_px, self.method.match(a, b), *sizes).matches
        return len(found) if same_handed(xy[found[:, 0]], two.xy_px[found[:, 1]]) else 0

    def _mirrored(self, i: int) -> Array:
        if self._last[0] != i:
            found = self.method.mirrored(self.store.of(i).descriptors)
            assert found is not None
            self._last = i, found
        return self._last[1]


def stored_mirrored(photos: Sequence[Photo]) -> list[Notice]:
    """A warning of photographs that are stored mirrored, as their EXIF orientation states; measured as they are."""
    names = [p.name for p in photos if p.orientation in MIRRORING]
    return [Notice(code="mirrored_photographs.stored", ids=tuple(names), values={"n": len(names), "names": names},
                   measured=Severity.WARNING)] if names else []  # fmt: skip


def mirrored_notice(m: Mirrored, photos: Sequence[Photo]) -> Notice:
    """What there is to say of photographs that are mirrored."""
    names = [photos[i].name for i in m.photographs]
    first, second = (photos[i].name for i in m.pair)
    return Notice(
        code="mirrored_photographs" if m.certain else "mirrored_photographs.possible", ids=tuple(names),
        values={
            "n": len(names), "names": names, "photograph": first, "other": second, "matches": m.matches,
            "plain": m.plain,
        },
        measured=Severity.WARNING,
    )  # fmt: skip
