"""Block adjustment with independent models: oriented parts in systems of their own brought into one.

Each part has a similarity transform; points and projection centres that two parts hold fall on each other as well as
they can (Ackermann, Ebner and Klein 1973), wrong ones without weight.  Rotations, scales and positions of all parts
together, not along a chain: what a chain would sum up is spread.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import breadth_first_order, connected_components, minimum_spanning_tree

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import cross_matrix, nearest_rotation, rotation_from_vector
from raybundle.numerics.transform import SimilarityTransform, robust_similarity

FEWEST = 12
"""Points and centres that must agree for two models to be tied."""
AGREEING = 0.5
"""Share of them that must."""
MOST = 150
"""Of the points of two models that take part: thousands would show no more."""
TOLERANCE = 0.02
"""Distance between two models' places of a point that agree, in distances from where it was taken.

Images of uncalibrated cameras are believed to 0.0015 of the format's diagonal while they are oriented: rays that meet
under a base-to-depth ratio of 0.3 leave 0.006 of the depth, of which this is three times.
"""
STEPS, STILL = 40, 1e-7


@dataclass(frozen=True, slots=True, kw_only=True)
class Model:
    """An oriented part in a system of its own."""

    images: Index
    """(k,) numbers, ascending"""
    centre: Array
    """(k, 3)"""
    points: Index
    """(q,) numbers, ascending"""
    xyz: Array
    """(q, 3)"""
    depth: float
    """median distance of points from where they were taken, in its own unit"""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Tie:
    first: int
    second: int
    a: Array
    """(c, 3) in the first's system"""
    b: Array
    """(c, 3) in the second's"""
    fit: SimilarityTransform
    """second from first"""
    agreeing: int


def joined_models(models: Sequence[Model]) -> list[SimilarityTransform | None]:
    """The transform of each model into the system of the one with the most images; None: nothing ties it.

    Limits: models that show different parts which look alike fall on each other like right ones.
    """
    if not models:
        return []
    ties = _ties(models)
    while True:
        part, root = _largest(ties, models)
        mine = [t for t in ties if part[t.first]]
        found = _adjusted(mine, _along_tree(mine, len(models), root), root, models)
        ties = [t for t in mine if _agreement(t, found, models) >= AGREEING]
        if len(ties) == len(mine):
            return found


def _ties(models: Sequence[Model]) -> list[_Tie]:
    """Pairs of models of which one similarity brings common points and centres together."""
    first = 1 + max((int(m.images.max(initial=-1)) for m in models), default=-1)
    things = [np.concatenate([m.images, first + m.points]) for m in models]
    each = np.cumsum([0, *map(len, things)])
    among = np.concatenate(things)
    shape = len(models), 1 + int(among.max(initial=0))
    held = csr_array((np.ones(len(among), np.int64), among, each), shape=shape)
    common = (held @ held.T).tocoo()
    enough = (common.row < common.col) & (common.data >= FEWEST)
    near = sorted(zip(common.row[enough].tolist(), common.col[enough].tolist(), strict=True))
    return [tie for a, b in near if (tie := _tie(models, a, b)) is not None]


def _tie(models: Sequence[Model], first: int, second: int) -> _Tie | None:
    m, o = models[first], models[second]
    _, mi, oi = np.intersect1d(m.images, o.images, return_indices=True)
    _, mp, op = np.intersect1d(m.points, o.points, return_indices=True)
    if len(mp) > MOST:
        some = np.sort(np.random.default_rng(len(mp)).choice(len(mp), MOST, replace=False))
        mp, op = mp[some], op[some]
    a = np.concatenate([m.centre[mi], m.xyz[mp]])
    b = np.concatenate([o.centre[oi], o.xyz[op]])
    if len(a) < FEWEST:
        return None
    try:
        fit, agree = robust_similarity(a, b, TOLERANCE * o.depth)
    except InputError:
        return None
    if agree.sum() < max(FEWEST, AGREEING * len(a)):
        return None
    return _Tie(first=first, second=second, a=a, b=b, fit=fit, agreeing=int(agree.sum()))


def _largest(ties: Sequence[_Tie], models: Sequence[Model]) -> tuple[Mask, int]:
    """Models (k,) of the tied part with the most images, and the one whose system it gets."""
    n = len(models)
    ends = np.array([(t.first, t.second) for t in ties], int).reshape(-1, 2).T
    _, label = connected_components(csr_array((np.ones(len(ties)), tuple(ends)), shape=(n, n)), directed=False)
    sizes = np.bincount(label, [len(m.images) for m in models])
    part = label == sizes.argmax()
    return part, int(np.argmax([len(m.images) if p else -1 for m, p in zip(models, part, strict=True)]))


def _along_tree(ties: Sequence[_Tie], n: int, root: int) -> list[SimilarityTransform | None]:
    """Transforms along the tree of the strongest ties."""
    ends = np.array([(t.first, t.second) for t in ties], int).reshape(-1, 2).T
    graph = csr_array(([1 / t.agreeing for t in ties], tuple(ends)), shape=(n, n))
    order, before = breadth_first_order(minimum_spanning_tree(graph), root, directed=False)
    of = {(t.first, t.second): t.fit for t in ties}
    found: list[SimilarityTransform | None] = [None] * n
    found[root] = SimilarityTransform()
    for k in order[1:].tolist():
        q = int(before[k])
        parent = found[q]
        assert parent is not None
        step = of[k, q] if (k, q) in of else of[q, k].inverse
        found[k] = parent.after(step)
    return found


def _adjusted(
    ties: Sequence[_Tie], start: Sequence[SimilarityTransform | None], root: int, models: Sequence[Model]
) -> list[SimilarityTransform | None]:
    """Gauss-Newton steps of all transforms but the root's; Cauchy weights of the distances in tolerances."""
    found = list(start)
    free = [k for k, t in enumerate(found) if t is not None and k != root]
    column = {k: 7 * j for j, k in enumerate(free)}
    for _ in range(STEPS if free else 0):
        N, g = np.zeros((7 * len(free), 7 * len(free))), np.zeros(7 * len(free))
        for tie in ties:
            a, b = found[tie.first], found[tie.second]
            assert a is not None
            assert b is not None
            xa, xb = a.points(tie.a), b.points(tie.b)
            unit = TOLERANCE * models[tie.second].depth * b.scale
            r = (xa - xb) / unit
            w = 1 / (1 + (r**2).sum(axis=1))
            blocks = [
                (column[k], sign * _partials(x, t) / unit)
                for k, sign, x, t in ((tie.first, 1.0, xa, a), (tie.second, -1.0, xb, b))
                if k in column
            ]
            for i, A in blocks:
                g[i : i + 7] -= np.einsum("n,nij,ni->j", w, A, r)
                for j, B in blocks:
                    N[i : i + 7, j : j + 7] += np.einsum("n,nij,nik->jk", w, A, B)
        d = np.sqrt(np.maximum(np.diagonal(N), 1e-300))
        step = np.linalg.lstsq(N / np.outer(d, d), g / d, rcond=1e-12)[0] / d
        for k in free:
            found[k] = _moved(found[k], step[column[k] : column[k] + 7])
        if np.abs(step * d).max() < STILL * np.sqrt(len(step)) or np.abs(step).max() < STILL:
            break
    return found


def _partials(x: Array, t: SimilarityTransform) -> Array:
    """(n, 3, 7) of transformed places with respect to translation, rotation about the origin's image, log of scale."""
    away = x - t.translation
    A = np.zeros((len(x), 3, 7))
    A[:, :, :3] = np.eye(3)
    A[:, :, 3:6] = -cross_matrix(away)
    A[:, :, 6] = away
    return A


def _moved(t: SimilarityTransform | None, step: Array) -> SimilarityTransform:
    assert t is not None
    turn = rotation_from_vector(np.clip(step[3:6], -0.5, 0.5))
    return replace(
        t, scale=t.scale * float(np.exp(np.clip(step[6], -1, 1))), rotation=nearest_rotation(turn @ t.rotation),
        translation=t.translation + step[:3],
    )  # fmt: skip


def _agreement(tie: _Tie, transforms: Sequence[SimilarityTransform | None], models: Sequence[Model]) -> float:
    """Share of a tie's points that fall on each other within three tolerances."""
    a, b = transforms[tie.first], transforms[tie.second]
    assert a is not None
    assert b is not None
    off = np.linalg.norm(a.points(tie.a) - b.points(tie.b), axis=1)
    return float(np.mean(off < 3 * TOLERANCE * models[tie.second].depth * b.scale))
