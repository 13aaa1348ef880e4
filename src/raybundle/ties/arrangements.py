"""Competing arrangements: photographs as all their pairs place them, and as they stand without the doubtful ones.

Equal parts of an object draw photographs of different places together.  No residual shows it; what shows it is seen in
one photograph and missing in another that should show it (`ties.missing`).  The tree of the most similar pairs has as
many cuts as pairs, each between two groups of photographs.  Where much is missing between the two, the pairs in doubt
are left out, the most similar others place the photographs anew, as in `ties.repeated`, and further pairs count only
where their matches meet the object points.  An arrangement replaces the first if far less is missing in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.errors import NoOrientation, Value
from raybundle.matching.pairs import parts_of
from raybundle.matching.verify import STRONG, VerifiedPair
from raybundle.numerics.arrays import Array, Index
from raybundle.ties.block import TieBlock
from raybundle.ties.missing import SHOWN, Seen, candidate_pairs, one_sided, seen_of
from raybundle.ties.repeated import (
    AGREEING,
    CONTRADICTED,
    Join,
    Orient,
    SoundPairs,
    agreement,
    contradicted,
    spanning,
)

ROUNDS = 4
"""Arrangements that are tried after the first."""
LOOKED_AT = 400
"""Pairs of photographs that are compared, evenly among those with common points."""
MOST = 2000
"""Points of a photograph that are compared, on the average: 30 a cell."""
MISSING = 0.06
"""Share of cells between two groups of photographs in which one photograph alone shows points, from which on other
arrangements are tried.

Rendered arrangements that are wrong have 0.066 and more at their worst cut, right ones 0.054 at most and real sets
0.068 (benchmarks/doubles.py).
"""
TIMES, CERTAIN = 15.0, 0.12
"""So many times the share within the groups, or at least this share: real sets miss evenly (12 times at most)."""
CELLS = 20
"""Such cells between two groups at least."""
PAIR, PAIR_CELLS = 0.035, 3
"""The same of a pair of photographs and its neighbours that is left out then: the place where 1 and 8 % are equally
likely."""
NEIGHBOURS = 2
"""Most similar photographs on each side of a pair of which the pairs are counted with it: one pair has few cells."""
DECISIVE = 0.25
"""Ratio of missing cells up to which an arrangement replaces the first though some group is in doubt in it, too."""
CONTRARY, CONTRARY_SHARE = 2, 0.05
"""Strong pairs, and their share, that contradict an arrangement in parts: one that is right has none as a rule."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Arrangement:
    """An arrangement of the photographs and what is missing in it."""

    sound: SoundPairs
    ties: tuple[TieBlock, ...]
    rows: Index
    """(k, 4) two photographs, cells in which one alone shows points, and cells with common ones"""
    share: float
    """of cells that are missing at the worst cut between two groups"""
    groups: tuple[Index, ...]
    """these two; none where nothing is in doubt"""

    @property
    def oriented(self) -> int:
        """Photographs with an orientation."""
        return sum(int(t.block.images.oriented.sum()) for t in self.ties)

    @property
    def missing(self) -> int:
        """Cells in which one photograph alone shows points."""
        return int(self.rows[:, 2].sum())


def arrangement(sound: SoundPairs, ties: tuple[TieBlock, ...], features_xy: Sequence[Array]) -> Arrangement:
    """An arrangement with what is missing in it."""
    rows = np.zeros((0, 4), int)
    for t in ties:
        seen, pairs = _fewer(seen_of(t.block)), list(candidate_pairs(t.block))
        some = pairs[:: 1 + len(pairs) // LOOKED_AT]
        rows = np.vstack([rows, *(np.array([[i, j, *one_sided(t.block, seen, i, j)]]) for i, j in some)])
    share, groups = _worst_cut(rows, sound.pairs, features_xy)
    return Arrangement(sound=sound, ties=ties, rows=rows, share=share, groups=groups)


def _fewer(seen: Seen) -> Seen:
    """Every second, third ... point of photographs with many."""
    counts = [len(p) for p in seen.points if len(p)]
    step = 1 + int(np.median(counts) if counts else 0) // MOST
    return Seen(points=tuple(p[p % step == 0] for p in seen.points), field=seen.field)


def _worst_cut(
    rows: Index, pairs: Sequence[VerifiedPair], features_xy: Sequence[Array]
) -> tuple[float, tuple[Index, ...]]:
    """The largest share of missing cells between two groups of the tree of similar pairs, and these if it is large."""
    n = len(features_xy)
    tree = np.array([(p.first, p.second) for p in spanning(pairs, n, 1, similarity(pairs, features_xy))], int)
    worst, groups = 0.0, ()
    for k in range(len(tree)):
        part = parts_of(np.delete(tree, k, axis=0), n)
        between = part[rows[:, 0]] != part[rows[:, 1]]
        alone, common = rows[between, 2:].sum(axis=0).tolist()
        within, usual = rows[~between, 2:].sum(axis=0).tolist()
        share = alone / max(alone + common, 1)
        if alone < CELLS or (share < CERTAIN and share * (within + usual) < TIMES * within):
            continue
        if share > worst:
            seen = np.unique(rows[between & (rows[:, 2] > 0), :2])
            worst, groups = share, tuple(seen[part[seen] == part[end]] for end in tree[k])
    return worst, groups if worst > MISSING else ()


def best_arrangement(
    sound: SoundPairs, verified: Sequence[VerifiedPair], features_xy: Sequence[Array], names: Sequence[str],
    diagonals: Array, orient: Orient, join: Join,
) -> tuple[SoundPairs, tuple[TieBlock, ...]]:  # fmt: skip
    """The pairs and the tie points of the arrangement in which least is missing, as `sound_pairs` takes its arguments.

    verified  pairs of which the sound ones are some

    Limits: parts that look alike with nothing else around them in which their photographs differ.
    """
    first = best = last = arrangement(sound, orient(sound.tracks), features_xy)
    pairs = list(sound.pairs)
    for _ in range(ROUNDS):
        out = _doubted(last, features_xy)
        if not last.groups or not out:
            break
        pairs = [p for p in pairs if (p.first, p.second) not in out]
        try:
            last = _arranged(pairs, features_xy, diagonals, orient, join)
        except NoOrientation:
            break
        better = last.missing <= DECISIVE * first.missing or (last.missing < first.missing and not last.groups)
        better = better and last.oriented >= first.oriented  # a fault names what would lose photographs
        if better and (best is first or last.missing < best.missing):
            best = last
    notices = sound.notices
    if best is not first and contradicted(best.sound.pairs, best.sound.tracks, diagonals) <= CONTRADICTED:
        notices = tuple(n for n in notices if n.variant != "ambiguous")
    if first.groups:
        notices = (*notices, _notice(first, best, names))
    if not any(n.severity == Severity.FAULT for n in notices):
        notices = (
            *notices,
            *_unsettled(best, verified, features_xy, names, diagonals, contradictory=bool(sound.notices)),
        )
    return replace(best.sound, notices=notices), best.ties


def _unsettled(
    found: Arrangement, verified: Sequence[VerifiedPair], features_xy: Sequence[Array], names: Sequence[str],
    diagonals: Array, *, contradictory: bool,
) -> tuple[Notice, ...]:  # fmt: skip
    """The fault of photographs in parts, or without orientation, while strong pairs contradict where they stand."""
    part = np.full(len(names), -1)
    for k, t in enumerate(found.ties):
        part[t.block.images.oriented] = k
    strong = [p for p in verified if len(p.matches) >= STRONG]
    ends = part[np.array([(p.first, p.second) for p in strong], int).reshape(-1, 2)]
    apart, within = ends[:, 0] != ends[:, 1], (ends[:, 0] == ends[:, 1]) & (ends[:, 0] >= 0)
    if not apart.any():
        return ()
    share, _ = agreement(strong, features_xy, found.sound.tracks, found.ties, diagonals)
    against = within & (share < AGREEING)
    if not (contradictory or against.sum() >= max(CONTRARY, CONTRARY_SHARE * within.sum())):
        return ()
    pairs = [strong[k] for k in np.flatnonzero(against | apart)]
    ids = tuple(dict.fromkeys(names[k] for p in pairs for k in (p.first, p.second)))
    values: dict[str, Value] = {
        "parts": len(found.ties), "lost": int((part < 0).sum()), "pairs": len(pairs),
        "names": [f"{names[p.first]} - {names[p.second]}" for p in pairs[:SHOWN]],
    }  # fmt: skip
    return (Notice(code="repeated_structure.unsettled", ids=ids, values=values, measured=Severity.FAULT),)


def _doubted(found: Arrangement, features_xy: Sequence[Array]) -> set[tuple[int, int]]:
    """Pairs between which much is missing, counted with those of their most similar photographs."""
    n = len(features_xy)
    alike = np.zeros((n, n))
    for p, s in zip(found.sound.pairs, similarity(found.sound.pairs, features_xy).tolist(), strict=True):
        alike[p.first, p.second] = alike[p.second, p.first] = s
    near = np.argsort(-alike, axis=1, kind="stable")[:, :NEIGHBOURS]
    cells = {(i, j): np.array(c) for i, j, *c in found.rows.tolist()}
    result = set[tuple[int, int]]()
    for i, j in cells:
        with_it = {(i, j), *((min(i, b), max(i, b)) for b in near[j].tolist())}
        with_it |= {(min(a, j), max(a, j)) for a in near[i].tolist()}
        alone, common = np.sum([cells[p] for p in with_it if p in cells], axis=0)
        if alone >= PAIR_CELLS and alone > PAIR * (alone + common):
            result.add((i, j))
    return result


def _arranged(
    pairs: Sequence[VerifiedPair], features_xy: Sequence[Array], diagonals: Array, orient: Orient, join: Join
) -> Arrangement:
    """The arrangement of the most similar pairs, with the others that agree with it."""
    strongest = spanning(pairs, len(features_xy), weight=similarity(pairs, features_xy))
    tracks = join(strongest)
    share, astray = agreement(pairs, features_xy, tracks, orient(tracks), diagonals)
    kept = tuple(
        replace(p, matches=p.matches[~out])
        for p, a, out in zip(pairs, share.tolist(), astray, strict=True)
        if a >= AGREEING or (np.isnan(a) and p in strongest)
    )
    tracks = join(kept)
    return arrangement(SoundPairs(pairs=kept, tracks=tracks, notices=()), orient(tracks), features_xy)


def similarity(pairs: Sequence[VerifiedPair], features_xy: Sequence[Array]) -> Array:
    """(pairs,) matches of each, as a share of the features of both photographs that match anywhere."""
    used = [np.zeros(len(xy), bool) for xy in features_xy]
    for p in pairs:
        used[p.first][p.matches[:, 0]] = used[p.second][p.matches[:, 1]] = True
    count = np.array([u.sum() for u in used], int)
    n = np.array([len(p.matches) for p in pairs], float)
    ends = np.array([(p.first, p.second) for p in pairs], int).reshape(-1, 2)
    return n / np.maximum(count[ends].sum(axis=1) - n, 1)


def _notice(first: Arrangement, best: Arrangement, names: Sequence[str]) -> Notice:
    """Which photographs show parts that look alike, and whether another arrangement resolves it."""
    shown = best if best.groups else first
    groups = [[names[int(k)] for k in g] for g in shown.groups]
    values: dict[str, Value] = {
        "before": first.share, "after": best.share, "limit": MISSING, "first": groups[0][:SHOWN],
        "second": groups[1][:SHOWN],
    }  # fmt: skip
    ids = tuple(n for g in groups for n in g)
    if best.groups:
        return Notice(code="repeated_structure.missing", ids=ids, values=values, measured=Severity.FAULT)
    return Notice(code="repeated_structure.rearranged", ids=ids, values=values, measured=Severity.WARNING)
