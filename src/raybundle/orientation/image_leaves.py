"""Images in leaves: sets that hang together, each with the images around it that share most points with it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components, dijkstra

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.orientation.rays import common_counts

AROUND = 0.3
"""Images around a leaf in shares of its own: what joins it to its neighbours."""
LINK = 8
"""Common points from which on an image stands around a leaf."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ImageLeaf:
    """Images that are oriented together."""

    own: Index
    """ascending; every image is of one leaf's own"""
    around: Index
    """ascending, of other leaves"""

    @property
    def images(self) -> Index:
        """All of them, ascending."""
        return np.sort(np.concatenate([self.own, self.around]))


def leaves_of(image: Index, point: Index, images: int, points: int, most: int) -> tuple[ImageLeaf, ...]:
    """Cut images into leaves of at most `most` of their own, by the points that they share; observations (m,).

    Halves are cut by how much nearer an image is to one end of the others than to the opposite end, along the ways of
    many common points: so the cut goes where the images hang together least, whatever they show.  An image without
    observations is of no leaf.
    """
    seen = np.bincount(image, minlength=images) > 0
    return leaves_of_pairs(common_counts(image, point, seen, points), seen, most)


def leaves_of_pairs(pairs: Index, seen: Mask, most: int) -> tuple[ImageLeaf, ...]:
    """The same by pairs of images (k, 3): first, second and how many points they share; seen (images,) those to cut."""
    images = len(seen)
    first, second, common = pairs.T
    both = np.concatenate([first, second]), np.concatenate([second, first])
    graph = csr_array((np.tile(common.astype(float), 2), both), shape=(images, images))
    own: list[Index] = []
    waiting = [np.flatnonzero(seen)]
    while waiting:
        ids = waiting.pop()
        if len(ids) <= most:
            own.append(ids)
            continue
        side = _halves(graph[ids][:, ids])
        waiting += [ids[side], ids[~side]]
    return tuple(
        ImageLeaf(own=ids, around=_around(graph, ids))
        for ids in sorted((ids for ids in own if len(ids)), key=lambda ids: int(ids[0]))
    )


def _halves(graph: Any) -> Mask:
    """(n,) which half each node is of; both hang together where the graph does."""
    ways = graph.copy()
    ways.data = 1 / ways.data
    n = ways.shape[0]
    end = _farthest(dijkstra(ways, indices=0))
    from_end = dijkstra(ways, indices=end)
    from_other = dijkstra(ways, indices=_farthest(from_end))
    from_end, from_other = (np.where(np.isfinite(d), d, 1e9) for d in (from_end, from_other))
    side = np.zeros(n, bool)
    side[np.argsort(from_end - from_other, kind="stable")[: n // 2]] = True
    for half in (True, False):
        mine = np.flatnonzero(side == half)
        _, label = connected_components(graph[mine][:, mine], directed=False)
        lost = mine[label != np.bincount(label).argmax()]
        if len(lost) < n // 4:  # what has been cut off goes to the other half, which surrounds it
            side[lost] = not half
    return side


def _farthest(distance: Array) -> int:
    return int(np.argmax(np.where(np.isfinite(distance), distance, -1.0)))


def _around(graph: Any, own: Index) -> Index:
    """The images outside that share most points with these."""
    common = np.asarray(graph[own].sum(axis=0)).ravel()
    common[own] = 0
    near = np.flatnonzero(common >= LINK)
    best = near[np.argsort(-common[near], kind="stable")[: int(AROUND * len(own)) + 1]]
    return np.sort(best)
