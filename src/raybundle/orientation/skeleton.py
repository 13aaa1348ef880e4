"""The part of a large block that its orientation needs: points spread over every image and over every pair.

Thousands of tie points in an image make its approximate orientation no better than a few hundred, only slower.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from scipy.sparse import csr_matrix

from raybundle.block import Block, Role
from raybundle.numerics.arrays import Index, Mask

GRID = 6
"""Cells of an image, in rows and columns."""
PER_CELL = 8
"""Points wanted in each cell of an image."""
PER_PAIR = 40
"""Common points wanted for each pair of images that has so many."""
LINK = 8
"""Common points from which on two images are a pair."""
LARGE = 1.5
"""How many times the points wanted a block must have to be thinned."""
LONG = 4
"""Rays from which on a point has many: the longest tracks of automatic matching are wrong more often."""
CHUNK = 256
"""Points that are looked at together."""


def skeleton(block: Block) -> Mask:
    """(p,) points that orient the block: many-rayed ones first, spread over the cells of each image; all control.

    Each pair of images keeps common points as well, so that parts joined by few stay joined.  A small block
    keeps all its points.
    """
    o, n, p = block.observations, len(block.images), len(block.points)
    if len(o) <= LARGE * GRID**2 * PER_CELL * n:
        return np.ones(p, bool)
    rays = np.minimum(np.bincount(o.point, minlength=p), LONG)
    needed = np.asarray(block.points.role) != Role.TIE
    needed[block.distances.start] = needed[block.distances.end] = True
    # in a random order among points of as many rays, so that neighbours do not stand together
    order = np.lexsort((np.random.default_rng(3).random(p), -rays, ~needed))
    rank = np.empty(p, np.int64)
    rank[order] = np.arange(p)
    rows = np.argsort(rank[o.point], kind="stable")
    chosen = needed | _spread(_cells(block)[rows], rank[o.point[rows]], n, p)[rank]
    return chosen | _linked(block, chosen, order)


def _cells(block: Block) -> Index:
    """(m,) cell of each observation, numbered through all images."""
    o = block.observations
    size = np.array([(c.width_px, c.height_px) for c in block.cameras], float)[block.images.camera[o.image]]
    cell = np.clip((o.xy_px / size * GRID).astype(np.int64), 0, GRID - 1)
    return (o.image.astype(np.int64) * GRID + cell[:, 1]) * GRID + cell[:, 0]


def _spread(cell: Index, rank: Index, images: int, points: int) -> Mask:
    """(p,) points by rank that are taken: those that some cell still wants when it is their turn."""
    count = np.zeros(images * GRID**2, np.int64)
    taken = np.zeros(points, bool)
    bounds = np.searchsorted(rank, np.arange(0, points + CHUNK, CHUNK))
    for a, b in pairwise(bounds):
        wanted = count[cell[a:b]] < PER_CELL
        taken[rank[a:b][wanted]] = True
        count += np.bincount(cell[a:b][taken[rank[a:b]]], minlength=len(count))
    return taken


def _linked(block: Block, chosen: Mask, order: Index) -> Mask:
    """(p,) further points for pairs of images that have too few of those chosen."""
    o, n, p = block.observations, len(block.images), len(block.points)
    seen = csr_matrix((np.ones(len(o), np.int32), (o.image, o.point)), shape=(n, p))
    all_common = (seen @ seen.T).tocoo()
    part = seen[:, np.flatnonzero(chosen)]
    have = np.asarray((part @ part.T).tocsr()[all_common.row, all_common.col]).ravel()
    want = np.minimum(all_common.data, PER_PAIR)
    short = (all_common.row < all_common.col) & (all_common.data >= LINK) & (have < want)
    more = np.zeros(p, bool)
    rank = np.empty(p, np.int64)
    rank[order] = np.arange(p)
    for k in np.flatnonzero(short):
        a, b = (seen.indices[seen.indptr[i] : seen.indptr[i + 1]] for i in (all_common.row[k], all_common.col[k]))
        common = np.intersect1d(a, b)
        missing = int(want[k]) - int((chosen | more)[common].sum()) if len(common) else 0
        if missing > 0:
            free = common[~(chosen | more)[common]]
            more[free[np.argsort(rank[free])[:missing]]] = True
    return more
