"""Search for the most alike among many signatures: exact, in blocks, without an index."""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array, Index

ROWS, COLUMNS = 1024, 8192
"""Signatures that are compared at once: 33 MB of products."""


def most_similar(
    signatures: Array, count: int, *, rows: Index | None = None, apart: Index | None = None
) -> tuple[Index, Index]:
    """Pairs of a signature and one of those most like it: positions (m,) and (m,), the most alike first for each.

    signatures  (n, k) whole numbers; norms below 4096, so that products are exact and the same on every machine
    rows        those that are asked for, all of them if None
    apart       (n,) only such count as like that differ in this number
    Of equal likeness the one of smaller position is taken.  Beside the signatures it needs 150 MB; n^2 k operations.
    """
    asked = np.arange(len(signatures)) if rows is None else rows
    found = [_nearest(signatures, asked[b : b + ROWS], count, apart) for b in range(0, len(asked), ROWS)]
    none = np.zeros(0, np.int64)
    return np.concatenate([none, *(f[0] for f in found)]), np.concatenate([none, *(f[1] for f in found)])


def _nearest(signatures: Array, mine: Index, count: int, apart: Index | None) -> tuple[Index, Index]:
    own = signatures[mine].astype(np.float32)
    row, column, value = np.zeros(0, np.int64), np.zeros(0, np.int64), np.zeros(0, np.float32)
    least = np.full((len(mine), 1), -np.inf, np.float32)
    for begin in range(0, len(signatures), COLUMNS):
        part = signatures[begin : begin + COLUMNS].astype(np.float32)
        product = own @ part.T
        here = np.arange(begin, begin + len(part))
        if apart is not None:
            product[apart[mine][:, None] == apart[here]] = -np.inf
        self_ = np.flatnonzero((mine >= begin) & (mine < begin + len(part)))
        product[self_, mine[self_] - begin] = -np.inf
        if begin == 0 and len(part) > count:  # a bound from some of them, so that few are sorted
            some = product[:, :COLUMNS:4] if len(part) > 8 * count else product
            least = np.partition(some, some.shape[1] - count, axis=1)[:, some.shape[1] - count][:, None]
        i, j = np.divmod(np.flatnonzero((product >= least) & (product > -np.inf)), len(part))
        row, column = np.concatenate([row, i]), np.concatenate([column, j + begin])
        value = np.concatenate([value, product[i, j]])
        order = np.lexsort((column, -value, row))
        row, column, value = row[order], column[order], value[order]
        rank = np.arange(len(row)) - np.searchsorted(row, row)
        kept = rank < count
        row, column, value, rank = row[kept], column[kept], value[kept], rank[kept]
        least[row[rank == count - 1], 0] = value[rank == count - 1]
    return mine[row], column
