"""Which image pairs are worth matching: of a small set all, the likely ones of a large set, in rounds.

Pairs are rows (i, j), i < j, of one array.  Likely ones come from signatures, places and the sequence, and are ordered
by how many features of wide surroundings two images share.  What has been matched shows where to go on: images with
verified neighbours in common, and parts that do not yet hang together.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.matching.nearest import most_similar
from raybundle.matching.verify import STRONG
from raybundle.numerics.arrays import Array, Index, Mask

ALL = 60
"""Images up to which all pairs are looked at: 30 an image at most."""
EACH = 12
"""Pairs an image that are matched of larger sets: 24 partners for each, as many as overlap in a close flight."""
FIRST, COMMON = 8, 10
"""Pairs an image after the round of likely ones, and after that of neighbours in common; the rest joins parts."""
BEST = 5
"""Most alike that every image has matched first, so that none is left out where others share more."""
SIMILAR = 50
"""Images of like signature that are compared for each (docs/explanation/pairs.md: none is missed of those)."""
NEAR, NEARBY = 4, 16
"""Neighbours in space that are matched whatever they look like (on both sides, along and across), and compared."""
FEWEST_COMMON = 2
"""Verified neighbours in common that make a pair likely."""
JOINING = 3
"""Times that parts are joined, each time with the parts that have come of the last."""
PARTNERS = 2
"""Neighbours below which an image's pairs are matched whatever a first look finds."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Candidates:
    """Pairs that may be matched."""

    pairs: Index
    """(m, 2) i < j, sorted"""
    shared: Index
    """(m,) features of wide surroundings that both images show"""
    likeness: Index
    """(m,) of their signatures"""

    def new(self, matched: Index) -> Candidates:
        """Those that are not among the matched pairs."""
        return self.rows(~contained(self.pairs, matched))

    def rows(self, index: Index | Mask) -> Candidates:
        """Some of them."""
        return Candidates(pairs=self.pairs[index], shared=self.shared[index], likeness=self.likeness[index])

    def order(self, *before: Array) -> Index:
        """Positions, the likeliest first; by other numbers, the largest first, before that."""
        i, j = self.pairs.T
        return np.lexsort((j, i, -self.likeness, -self.shared, *(-b for b in reversed(before))))


def all_pairs(count: int) -> Index:
    """(m, 2) every pair of so many images."""
    return np.stack(np.triu_indices(count, 1), axis=1).astype(np.int64)


def unique_pairs(*parts: Index) -> Index:
    """Pairs of all arrays (m, 2), in either order, each once and sorted; none of an image with itself."""
    pairs = np.sort(np.concatenate([np.zeros((0, 2), np.int64), *parts]), axis=1)
    pairs = pairs[pairs[:, 0] < pairs[:, 1]]
    return np.stack(np.divmod(np.unique(_number(pairs)), LARGEST), axis=1)


LARGEST = 1 << 31


def _number(pairs: Index) -> Index:
    return pairs[:, 0].astype(np.int64) * LARGEST + pairs[:, 1]


def contained(pairs: Index, others: Index) -> Mask:
    """(m,) which pairs are among others; both (m, 2), i < j."""
    return np.isin(_number(pairs), _number(others))


def sequence_pairs(place: Index) -> Index:
    """(m, 2) images that follow each other; place (n,): of each in the sequence."""
    order = np.argsort(place, kind="stable")
    return np.stack([order[:-1], order[1:]], axis=1)


def nearby_pairs(positions: Array, count: int) -> Index:
    """(m, 2) each image and its nearest in plan; positions (n, 3) in metres, NaN where not known."""
    from scipy.spatial import KDTree

    known = np.flatnonzero(np.isfinite(positions[:, :2]).all(axis=1))
    if len(known) < 2:
        return np.zeros((0, 2), np.int64)
    k = min(count + 1, len(known))
    near: Array = np.reshape(KDTree(positions[known, :2]).query(positions[known, :2], k=k)[1], (len(known), k))
    return np.stack([np.repeat(known, k), known[near.ravel()]], axis=1)


def similar_pairs(signatures: Array, rows: Index | None = None, apart: Index | None = None) -> Index:
    """(m, 2) each image (of `rows`) and those most like it by signatures (n, k); `apart`: see `most_similar`."""
    return np.stack(most_similar(signatures, SIMILAR, rows=rows, apart=apart), axis=1)


def first_round(c: Candidates, certain: Index, count: int) -> Index:
    """The certain pairs, of each image those that share most with it, and of all others those that share most."""
    level = np.minimum(_ranks(c, count), BEST)
    held = contained(c.pairs, certain).astype(np.int64)
    ordered = c.pairs[c.order(held, -level)]
    return unique_pairs(ordered[: FIRST * count])


def _ranks(c: Candidates, count: int) -> Index:
    """(m,) place of each pair among those of an image, the likeliest first; of its two images the better one."""
    order = c.order()
    image = c.pairs[order].T.ravel()
    turn = np.concatenate([np.arange(len(order))] * 2)
    by_image = np.lexsort((turn, image))
    sorted_image = image[by_image]
    rank = np.arange(len(by_image)) - np.searchsorted(sorted_image, sorted_image)
    result = np.full(len(order), count, np.int64)
    np.minimum.at(result, order[turn[by_image]], rank)
    return result


def linked(matches: Index) -> Mask:
    """(m,) whether so many verified matches make a pair of neighbours: strong ones only, chance links any two."""
    return matches >= STRONG


def common_pairs(links: Index, matched: Index, count: int) -> tuple[Index, Index]:
    """Pairs that are not matched of images with two linked neighbours or more in common, and how many those are.

    links    (m, 2) pairs of neighbours
    matched  (m, 2) pairs
    The neighbours of a neighbour see the same surroundings; memory and time grow with the sum of squared degrees.
    """
    from scipy.sparse import coo_array, triu

    i, j = links.T
    a = coo_array((np.ones(2 * len(links), np.int32), (np.r_[i, j], np.r_[j, i])), shape=(count, count)).tocsr()
    both = triu(a @ a, 1).tocoo()
    pairs = np.stack([both.row, both.col], axis=1).astype(np.int64)
    new = (both.data >= FEWEST_COMMON) & ~contained(pairs, matched)
    return pairs[new], both.data[new].astype(np.int64)


def parts_of(links: Index, count: int) -> Index:
    """(n,) number of the part that each image belongs to; links (m, 2) join two images."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    graph = coo_array((np.ones(len(links)), (links[:, 0], links[:, 1])), shape=(count, count))
    return connected_components(graph, directed=False)[1].astype(np.int64)


def outside_largest(parts: Index) -> Index:
    """Images that do not belong to the largest part."""
    return np.flatnonzero(parts != np.argmax(np.bincount(parts)))


def needed(pairs: Index, links: Index, count: int) -> Mask:
    """(m,) pairs (m, 2) that may join two parts, or give an image the neighbours that it lacks; links (k, 2)."""
    parts, lacks = parts_of(links, count)[pairs], np.bincount(links.ravel(), minlength=count)[pairs] < PARTNERS
    return (parts[:, 0] != parts[:, 1]) | lacks.any(axis=1)


def joining_round(c: Candidates, parts: Index, most: int) -> Index:
    """At most so many of the candidates between two parts: the likeliest of every two parts, then the second, ...

    parts  (n,) number of the part that each image belongs to
    """
    two = np.sort(parts[c.pairs], axis=1)
    c, two = c.rows(two[:, 0] != two[:, 1]), two[two[:, 0] != two[:, 1]]
    order = c.order()
    between = _number(two[order])
    by_parts = np.argsort(between, kind="stable")
    turn = np.empty(len(order), np.int64)
    turn[by_parts] = np.arange(len(order)) - np.searchsorted(between[by_parts], between[by_parts])
    level = np.empty(len(order), np.int64)
    level[order] = turn
    return unique_pairs(c.pairs[c.order(-level)][: max(most, 0)])
