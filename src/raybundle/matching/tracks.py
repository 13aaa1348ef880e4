"""Tracks: the features of many images that show one object point, at most one of every image."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.matching.verify import VerifiedPair
from raybundle.numerics.arrays import Array, Index

SAME_PX = 0.1


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


def tracks_of(pairs: Sequence[VerifiedPair], features_xy: Sequence[Array]) -> Tracks:
    """Conflict-free tracks of verified pairs; features at one place in one image count as one.

    Matches of strong pairs come first; a match that would join two tracks which see one image at different
    places is left out.
    """
    from scipy.sparse import coo_matrix  # noqa: PLC0415
    from scipy.sparse.csgraph import connected_components  # noqa: PLC0415

    offset = np.concatenate([[0], np.cumsum([len(xy) for xy in features_xy])]).astype(np.int64)
    image = np.repeat(np.arange(len(features_xy)), np.diff(offset)).astype(np.int32)
    same = _same_place(features_xy, offset)
    order = sorted((p for p in pairs if len(p.matches)), key=lambda p: (-len(p.matches), p.first, p.second))
    if not order:
        none = np.zeros(0, np.int32)
        return Tracks(image=none, feature=none, point=none, conflicts=none, apart_px=np.zeros(0))
    a = same[np.concatenate([offset[p.first] + p.matches[:, 0] for p in order])]
    b = same[np.concatenate([offset[p.second] + p.matches[:, 1] for p in order])]
    n = int(offset[-1])
    _, label = connected_components(coo_matrix((np.ones(len(a)), (a, b)), shape=(n, n)), directed=False)
    used = np.zeros(n, bool)
    used[a] = used[b] = True
    nodes = np.flatnonzero(used)
    # components that see an image twice are taken apart match by match
    key = label[nodes].astype(np.int64) * len(features_xy) + image[nodes]
    _, first, count = np.unique(key, return_index=True, return_counts=True)
    torn = np.zeros(int(label.max()) + 1, bool)
    torn[label[nodes[first[count > 1]]]] = True
    conflicts: list[tuple[float, int]] = []
    if torn.any():
        doubtful = np.flatnonzero(torn[label[a]])
        part, conflicts = _grow(a[doubtful], b[doubtful], image, np.vstack(list(features_xy)))
        label = label.astype(np.int64)
        own = torn[label]
        label[own] = label.max() + 1 + np.flatnonzero(own)
        node = np.fromiter(part.keys(), np.int64, len(part))
        label[node] = label[np.fromiter(part.values(), np.int64, len(part))]
    _, point = np.unique(label[nodes], return_inverse=True)
    rays = np.bincount(point)
    nodes, point = nodes[rays[point] > 1], point[rays[point] > 1]
    _, point = np.unique(point, return_inverse=True)
    order_ = np.lexsort((image[nodes], point))
    nodes, point = nodes[order_], point[order_]
    return Tracks(
        image=image[nodes],
        feature=(nodes - offset[image[nodes]]).astype(np.int32),
        point=point.astype(np.int32),
        conflicts=np.array([i for _, i in conflicts], np.int32),
        apart_px=np.array([d for d, _ in conflicts], float),
    )


def _same_place(features_xy: Sequence[Array], offset: Array) -> Index:
    """(n,) the first feature at the place of each: one point with two orientations is one point."""
    same = np.arange(int(offset[-1]))
    for i, xy in enumerate(features_xy):
        if not len(xy):
            continue
        cell = np.round(xy / SAME_PX).astype(np.int64)
        _, first, inverse = np.unique(cell[:, 0] * 10_000_000 + cell[:, 1], return_index=True, return_inverse=True)
        same[offset[i] : offset[i + 1]] = offset[i] + first[inverse]
    return same


def _grow(a: Array, b: Array, image: Index, xy: Array) -> tuple[dict[int, int], list[tuple[float, int]]]:
    """Union of nodes match by match, none that would put two nodes of one image together: {node: root}, left out."""
    root: dict[int, int] = {}
    seen: dict[int, dict[int, int]] = {}
    conflicts: list[tuple[float, int]] = []
    for x, y in zip(a.tolist(), b.tolist(), strict=True):
        for node in (x, y):
            if node not in root:
                root[node] = node
                seen[node] = {int(image[node]): node}
        rx, ry = root[x], root[y]
        if rx == ry:
            continue
        twice = seen[rx].keys() & seen[ry].keys()
        if twice:
            conflicts.append(max((math.dist(xy[seen[rx][i]], xy[seen[ry][i]]), i) for i in twice))
            continue
        if len(seen[rx]) < len(seen[ry]):
            rx, ry = ry, rx
        for node in seen[ry].values():
            root[node] = rx
        seen[rx] |= seen.pop(ry)
    return root, conflicts
