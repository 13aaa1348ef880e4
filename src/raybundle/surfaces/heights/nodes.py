"""What changes slowly over a grid of heights, kept at nodes, the corners of blocks of cells, and linear between them.

Errors of orientation shift and tilt a surface: a value for each block would know of no tilt within it, and of a step
from one to the next.  Node (0, 0) stands at the upper left corner of the grid, (i, j) so many blocks further down and
to the right; those of the last blocks may stand beyond the grid.  Between four nodes values are bilinear.

A height moves by K parts, each times a factor of its cell: up; by how much it stands above a level, as an error of
scale moves it; and as what it belongs to shifts in plan, by the slope there.  Nodes are (node rows, node columns, K,
...), factors (rows, columns, K); without factors there is one part, and it counts once.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import cast

import numpy as np
from scipy.ndimage import distance_transform_edt
from scipy.sparse import csr_array

from raybundle.numerics.arrays import Array, Index, Mask

CORNERS = ((0, 0), (0, 1), (1, 0), (1, 1))
"""Of a block, down and to the right"""
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
    """(blocks, block^2, ...) of cells, 0 beyond the grid."""
    (rows, columns), more = blocks, values.shape[2:]
    whole = np.zeros((rows * block, columns * block, *more))
    whole[: values.shape[0], : values.shape[1]] = values
    parted = whole.reshape(rows, block, columns, block, *more).swapaxes(1, 2)
    return parted.reshape(rows * columns, block**2, *more)


def _at_corners(nodes: Array) -> Array:
    """(blocks, 4, ...) of each block."""
    rows, columns = nodes.shape[0] - 1, nodes.shape[1] - 1
    each = [nodes[y : y + rows, x : x + columns] for y, x in CORNERS]
    return np.stack(each, axis=2).reshape(rows * columns, 4, *nodes.shape[2:])


def _designs(
    nodes: Array, block: int, shape: tuple[int, int], factors: Array | None
) -> Iterator[tuple[slice, Array, Array]]:
    """Row of blocks by row: its cells, the weights (blocks, block^2, 4 K) of corners' parts in them, and these parts.

    The parts (blocks, 4 K, ...) are those of nodes (node rows, node columns, K, ...).
    """
    columns, w = nodes.shape[1] - 1, _of_middles(block)
    for row in range(nodes.shape[0] - 1):
        cells = slice(row * block, min((row + 1) * block, shape[0]))
        mine = np.ones((cells.stop - cells.start, shape[1], 1)) if factors is None else factors[cells]
        F = _by_block(mine, block, (1, columns))
        corners = _at_corners(nodes[row : row + 2])
        D = (w[:, :, None] * F[:, :, None]).reshape(columns, block**2, -1)
        yield cells, D, corners.reshape(columns, D.shape[2], *nodes.shape[3:]).astype(float)


def _row_of_cells(by_block: Array, block: int, cells: slice, columns: int) -> Array:
    """(rows, columns) of the cells of a row of blocks (blocks, block^2)."""
    whole = by_block.reshape(-1, block, block).swapaxes(0, 1).reshape(block, -1)
    return whole[: cells.stop - cells.start, :columns]


def splat(values: Array, nodes: Array, block: int, factors: Array | None = None) -> Array:
    """(node rows, node columns, K) the weights of nodes' parts in the sum of cells times values (rows, columns)."""
    found = np.zeros(nodes.shape[:3])
    columns, shape = nodes.shape[1] - 1, (values.shape[0], values.shape[1])
    for row, (cells, D, _) in enumerate(_designs(nodes[..., :0], block, shape, factors)):
        shares = np.einsum("bs,bsk->bk", _by_block(values[cells], block, (1, columns)), D, optimize=True)
        for k, (y, x) in enumerate(CORNERS):
            found[row + y, x : x + columns] += shares.reshape(columns, 4, -1)[:, k]
    return found


def at_cells(nodes: Array, block: int, shape: tuple[int, int], factors: Array | None = None) -> Array:
    """(rows, columns) values of cells by those of nodes (node rows, node columns, K)."""
    found = np.zeros(shape)
    for cells, D, M in _designs(nodes, block, shape, factors):
        found[cells] = _row_of_cells(np.einsum("bsk,bk->bs", D, M), block, cells, shape[1])
    return found


def variances(
    nodes: Array, block: int, shape: tuple[int, int], covariance: Array | None = None, factors: Array | None = None
) -> Array:
    """(rows, columns) variances of cells, by nodes (node rows, node columns, K, q) of q errors.

    covariance  (q, q) of the errors; None: they are independent, of variance 1
    """
    found = np.zeros(shape)
    for cells, D, M in _designs(nodes, block, shape, factors):
        grams = (M if covariance is None else M @ covariance) @ M.swapaxes(1, 2)
        found[cells] = _row_of_cells(((D @ grams) * D).sum(axis=2), block, cells, shape[1])
    return np.maximum(found, 0.0)


def information(nodes: Array, block: int, weights: Array, factors: Array | None = None) -> Array:
    """(q, q) the sum over all cells of weights (rows, columns) times the products of how errors move them."""
    columns, parts, q = nodes.shape[1] - 1, nodes.shape[2], nodes.shape[3]
    number = np.arange(2 * (columns + 1) * parts).reshape(2, columns + 1, parts)
    at = _at_corners(number).reshape(columns, 4 * parts)
    one, other = (np.broadcast_to(x, (columns, *2 * (4 * parts,))) for x in (at[:, :, None], at[:, None, :]))
    found = np.zeros((q, q))
    shape = weights.shape[0], weights.shape[1]
    for row, (cells, D, _) in enumerate(_designs(nodes[..., :0], block, shape, factors)):
        w = _by_block(weights[cells], block, (1, columns))
        products = D.swapaxes(1, 2) @ (w[:, :, None] * D)
        between = csr_array((products.ravel(), (one.ravel(), other.ravel())), shape=2 * (number.size,))
        M = nodes[row : row + 2].reshape(number.size, q).astype(float)
        found += M.T @ (between @ M)
    return found


def covariances(
    nodes: Array, block: int, one: tuple[Index, Index], other: tuple[Index, Index], factors: Array | None = None
) -> Array:
    """(n,) covariances of pairs of cells by rows and columns (n,) each."""
    columns, parts = nodes.shape[1] - 1, nodes.shape[2]
    M = _at_corners(nodes)
    M = M.reshape(len(M), 4 * parts, nodes.shape[3])
    (at, w), (at2, w2) = (_place(r, c, block, columns, factors) for r, c in (one, other))
    alike, which = np.unique(np.stack([at, at2]), axis=1, return_inverse=True)
    which = which.ravel()
    grams = np.empty((alike.shape[1], 4 * parts, 4 * parts))
    many = max(1, MOST_PRODUCTS // max(M.shape[1] * M.shape[2], 1))
    for k in range(0, len(grams), many):
        a, b = alike[:, k : k + many]
        grams[k : k + many] = M[a].astype(float) @ M[b].astype(float).transpose(0, 2, 1)
    found = np.empty(len(which))
    many = MOST_PRODUCTS // (4 * parts) ** 2
    for k in range(0, len(found), many):
        part = slice(k, k + many)
        found[part] = np.einsum("na,nab,nb->n", w[part], grams[which[part]], w2[part])
    return found


def _place(r: Index, c: Index, block: int, columns: int, factors: Array | None) -> tuple[Index, Array]:
    """Blocks of cells, and weights (n, 4 K) of their corners' parts."""
    w = _weights((r % block + 0.5) / block, (c % block + 0.5) / block)
    if factors is not None:
        w = (w[:, :, None] * factors[r, c][:, None]).reshape(len(w), -1)
    return r // block * columns + c // block, w


def at_places(nodes: Array, rows: Array, columns: Array) -> Array:
    """(len(rows), len(columns), ...) at places in blocks from the corner; beyond the nodes those of the slope."""
    (i, v), (j, u) = (_lower(x, n) for x, n in zip((rows, columns), nodes.shape[:2], strict=True))
    found = np.zeros((len(rows), len(columns), *nodes.shape[2:]))
    for y, x in CORNERS:
        w = (v if y else 1 - v)[:, None] * (u if x else 1 - u)
        found += w.reshape(*w.shape, *(1,) * (nodes.ndim - 2)) * nodes[i + y][:, j + x]
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
    found = from_nearest(values.astype(float), ~empty)
    for axis in (0, 1):
        found = np.moveaxis(found, axis, 0)
        second, last = min(1, len(found) - 1), max(len(found) - 2, 0)
        ends = 2 * found[:1] - found[second : second + 1], 2 * found[-1:] - found[last : last + 1]
        found = np.concatenate([ends[0], found, ends[1]])
        found = np.moveaxis((found[1:] + found[:-1]) / 2, 0, axis)
    return found.astype(values.dtype)


def from_nearest(values: Array, known: Mask) -> Array:
    """Where nothing is known the nearest that is."""
    _, (i, j) = cast("tuple[Array, Array]", distance_transform_edt(~known, return_indices=True))
    return values[i, j]
