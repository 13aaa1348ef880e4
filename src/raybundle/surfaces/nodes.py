"""What changes slowly over a grid of heights, kept at nodes, the corners of blocks of cells, and linear between them.

Errors of orientation shift and tilt a surface: a value for each block would know of no tilt within it, and of a step
from one to the next.  Node (0, 0) stands at the upper left corner of the grid, (i, j) so many blocks further down and
to the right; those of the last blocks may stand beyond the grid.  Between four nodes values are bilinear.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import cast

import numpy as np
from scipy.ndimage import distance_transform_edt
from scipy.sparse import csr_array

from raybundle.numerics.arrays import Array, Index, Mask

CORNERS = ((0, 0), (0, 1), (1, 0), (1, 1))
"""Of a block, down and to the right"""
UNEVEN = 1e-3 / 12
"""Variance of places, in squares of a block's side, below which they tell no slope: a thousandth of that of a whole
block, that of a line of cells a thirtieth of a side wide"""
MOST_PRODUCTS = 1 << 24
"""Numbers that are held at once"""


def _weights(down: Array, right: Array) -> Array:
    """(..., 4) of the corners of a block at shares of its side."""
    return np.stack(
        [(down if y else 1 - down) * (right if x else 1 - right) for y, x in CORNERS], axis=-1
    )  # fmt: skip


def _of_middles(block: int) -> Array:
    """(block^2, 4) weights of the corners at the middles of a block's cells."""
    at = (np.arange(block) + 0.5) / block
    return _weights(*np.meshgrid(at, at, indexing="ij")).reshape(-1, 4)


def _by_block(values: Array, block: int, blocks: tuple[int, int]) -> Array:
    """(blocks, block^2) of cells, 0 beyond the grid."""
    rows, columns = blocks
    whole = np.zeros((rows * block, columns * block))
    whole[: values.shape[0], : values.shape[1]] = values
    return whole.reshape(rows, block, columns, block).transpose(0, 2, 1, 3).reshape(rows * columns, block**2)


def _of_cells(by_block: Array, block: int, blocks: tuple[int, int], shape: tuple[int, int]) -> Array:
    """The other way."""
    rows, columns = blocks
    whole = by_block.reshape(rows, columns, block, block).transpose(0, 2, 1, 3).reshape(rows * block, columns * block)
    return whole[: shape[0], : shape[1]]


def _blocks(nodes: Array) -> tuple[int, int]:
    return nodes.shape[0] - 1, nodes.shape[1] - 1


def _at_corners(nodes: Array) -> Array:
    """(blocks, 4, ...) of each block."""
    rows, columns = _blocks(nodes)
    each = [nodes[y : y + rows, x : x + columns] for y, x in CORNERS]
    return np.stack(each, axis=2).reshape(rows * columns, 4, *nodes.shape[2:])


def splat(values: Array, nodes: Array, block: int) -> Array:
    """(node rows, node columns) the weights of nodes in the sum of cells times values (rows, columns)."""
    rows, columns = _blocks(nodes)
    shares = (_by_block(values, block, (rows, columns)) @ _of_middles(block)).reshape(rows, columns, 4)
    found = np.zeros(nodes.shape[:2])
    for k, (y, x) in enumerate(CORNERS):
        found[y : y + rows, x : x + columns] += shares[..., k]
    return found


def at_cells(nodes: Array, block: int, shape: tuple[int, int]) -> Array:
    """(rows, columns) values of cells by those of nodes (node rows, node columns)."""
    return _of_cells(_at_corners(nodes) @ _of_middles(block).T, block, _blocks(nodes), shape)


def variances(nodes: Array, block: int, shape: tuple[int, int], covariance: Array | None = None) -> Array:
    """(rows, columns) variances of cells, by nodes (node rows, node columns, q) of q errors.

    covariance  (q, q) of the errors; None: they are independent, of variance 1
    """
    M = nodes.astype(float)
    other = M if covariance is None else M @ covariance
    grams = np.einsum("naq,nbq->nab", _at_corners(other), _at_corners(M), optimize=True).reshape(-1, 16)
    w = _of_middles(block)
    both = (w[:, :, None] * w[:, None, :]).reshape(-1, 16)
    return np.maximum(_of_cells(grams @ both.T, block, _blocks(nodes), shape), 0.0)


def information(nodes: Array, block: int, weights: Array) -> Array:
    """(q, q) the sum over all cells of weights (rows, columns) times the products of how errors move them."""
    rows, columns = _blocks(nodes)
    w = _of_middles(block)
    products = _by_block(weights, block, (rows, columns)) @ (w[:, :, None] * w[:, None, :]).reshape(-1, 16)
    number = np.arange(nodes.shape[0] * nodes.shape[1]).reshape(nodes.shape[:2])
    at = _at_corners(number)
    one, other = (np.broadcast_to(x, (len(at), 4, 4)).ravel() for x in (at[:, :, None], at[:, None, :]))
    between = csr_array((products.ravel(), (one, other)), shape=(number.size, number.size))
    M = nodes.reshape(number.size, nodes.shape[2]).astype(float)
    return M.T @ (between @ M)


def covariances(nodes: Array, block: int, one: tuple[Index, Index], other: tuple[Index, Index]) -> Array:
    """(n,) covariances of pairs of cells by rows and columns (n,) each."""
    columns, M = nodes.shape[1] - 1, _at_corners(nodes).astype(float)
    (at, w), (at2, w2) = (_place(r, c, block, columns) for r, c in (one, other))
    alike, which = np.unique(np.stack([at, at2]), axis=1, return_inverse=True)
    which = which.ravel()
    grams = np.empty((alike.shape[1], 4, 4))
    many = max(1, MOST_PRODUCTS // max(4 * M.shape[2], 1))
    for k in range(0, len(grams), many):
        a, b = alike[:, k : k + many]
        grams[k : k + many] = M[a] @ M[b].transpose(0, 2, 1)
    found = np.empty(len(which))
    for k in range(0, len(found), MOST_PRODUCTS // 16):
        part = slice(k, k + MOST_PRODUCTS // 16)
        found[part] = np.einsum("na,nab,nb->n", w[part], grams[which[part]], w2[part])
    return found


def _place(r: Index, c: Index, block: int, columns: int) -> tuple[Index, Array]:
    """Blocks of cells, and weights (n, 4) of their corners."""
    return r // block * columns + c // block, _weights((r % block + 0.5) / block, (c % block + 0.5) / block)


def at_places(nodes: Array, rows: Array, columns: Array) -> Array:
    """(len(rows), len(columns), q) values at places in blocks from the corner; beyond the nodes those of the slope."""
    (i, v), (j, u) = (_lower(x, n) for x, n in zip((rows, columns), nodes.shape[:2], strict=True))
    found = np.zeros((len(rows), len(columns), nodes.shape[2]))
    for y, x in CORNERS:
        w = (v if y else 1 - v)[:, None] * (u if x else 1 - u)
        found += w[..., None] * nodes[i + y][:, j + x]
    return found


def _lower(at: Array, count: int) -> tuple[Index, Array]:
    """The node before each place, and how far it is from there; a block beyond the nodes at most."""
    at = np.clip(at, -1, count)
    first = np.clip(np.floor(at), 0, count - 2).astype(int)
    return first, at - first


def of_blocks(values: Array) -> Array:
    """Nodes by one value (rows, columns, q) for each block, that of its middle; a block of zeros has none."""
    empty = np.asarray(~values.any(axis=2))
    if empty.all():
        return np.zeros((values.shape[0] + 1, values.shape[1] + 1, values.shape[2]), values.dtype)
    found = _from_nearest(values.astype(float), ~empty)
    for axis in (0, 1):
        found = np.moveaxis(found, axis, 0)
        second, last = min(1, len(found) - 1), max(len(found) - 2, 0)
        ends = 2 * found[:1] - found[second : second + 1], 2 * found[-1:] - found[last : last + 1]
        found = np.concatenate([ends[0], found, ends[1]])
        found = np.moveaxis((found[1:] + found[:-1]) / 2, 0, axis)
    return found.astype(values.dtype)


def fits(column: Array, row: Array, values: Array, begin: Index) -> Array:
    """(blocks, 3, q) of each block the value at its middle, and by how much it changes over it to the right and down.

    column, row  (n,) from the middle of its block, in sides of it; a block's places one after the other
    values       (n, q)
    begin        (blocks,) where each begins

    By least squares; places in one line tell nothing across it, and the slope there is taken for 0.
    """
    q = values.shape[1]
    if not len(begin):
        return np.zeros((0, 3, q))
    A = np.stack([np.ones(len(column)), column, row], axis=1)
    N = np.add.reduceat(A[:, :, None] * A[:, None, :], begin, axis=0)
    for k in (1, 2):
        N[:, k, k] += UNEVEN * N[:, 0, 0]
    y = np.stack([np.add.reduceat(A[:, k, None] * values, begin, axis=0) for k in range(3)], axis=1)
    return np.linalg.solve(N, y)


@dataclass(slots=True, kw_only=True)
class NodeSums:
    """Nodes by what is fitted to blocks, tile by tile: each block counts by what it knows of a corner."""

    total: Array
    weight: Array = field(init=False)

    def __post_init__(self) -> None:
        """Nothing is known yet."""
        self.weight = np.zeros(self.total.shape[:2])

    @classmethod
    def of(cls, shape: tuple[int, int], block: int, q: int) -> NodeSums:
        """For a grid of so many rows and columns."""
        rows, columns = (-(-n // block) + 1 for n in shape)
        return cls(total=np.zeros((rows, columns, q), np.float32))

    def add(self, first: tuple[int, int], found: Array, known: Mask, block: int) -> None:
        """Blocks (rows, columns, 3, q) of a tile, whose first one is given, and which of its cells have a height."""
        blocks = (found.shape[0], found.shape[1])
        there = _by_block(known.astype(float), block, blocks)
        n = there.sum(axis=1)
        at = (np.arange(block) + 0.5) / block - 0.5
        v, u = (x.ravel() for x in np.meshgrid(at, at, indexing="ij"))
        means = [there @ x / np.maximum(n, 1) for x in (v, u)]
        spreads = [there @ x**2 / np.maximum(n, 1) - m**2 + UNEVEN for x, m in zip((v, u), means, strict=True)]
        for y, x in CORNERS:
            apart = sum((k - 0.5 - m) ** 2 / s for k, m, s in zip((y, x), means, spreads, strict=True))
            w = (n / (1 + apart)).reshape(blocks)
            value = found[:, :, 0] + (x - 0.5) * found[:, :, 1] + (y - 0.5) * found[:, :, 2]
            rows, columns = (slice(f + k, f + k + m) for f, k, m in zip(first, (y, x), blocks, strict=True))
            self.total[rows, columns] += (w[..., None] * value).astype(np.float32)
            self.weight[rows, columns] += w

    @property
    def nodes(self) -> Array:
        """(node rows, node columns, q) float32; those that no height is near to as the nearest other."""
        known = self.weight > 0
        found = self.total / np.where(known, self.weight, 1.0)[..., None].astype(np.float32)
        return _from_nearest(found, known) if known.any() else found


def _from_nearest(values: Array, known: Mask) -> Array:
    """Where nothing is known the nearest that is."""
    _, (i, j) = cast("tuple[Array, Array]", distance_transform_edt(~known, return_indices=True))
    return values[i, j]
