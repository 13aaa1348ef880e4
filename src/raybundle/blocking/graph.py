"""Which nodes of unknowns meet: a sparse graph, made piece by piece."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.rows import distinct


def meeting(pieces: Iterable[tuple[Index, Index]], count: int, pairs: Array) -> Any:
    """The symmetric graph (count, count), CSR without loops, of nodes that stand in one row.

    pieces  tables of rows (k,), ascending, and the nodes (k,) that stand in them; every row lies in one piece
    pairs   (e, 2) nodes that meet beside
    """
    from scipy.sparse import csr_matrix

    low, high = np.minimum(*pairs.T), np.maximum(*pairs.T)
    keys = distinct(low[low < high].astype(np.int64) * count + high[low < high])
    for rows, nodes in pieces:
        row = np.cumsum(np.append(0, np.diff(rows) != 0)[: len(rows)])
        stands = csr_matrix((np.ones(len(row), np.int8), (row, nodes)), shape=(int(row.max(initial=-1)) + 1, count))
        stands.data[:] = 1  # a node stands twice in a row of two images of one station
        met = (stands.T.astype(np.int32) @ stands.astype(np.int32)).tocoo()
        upper = met.row < met.col
        keys = distinct(np.concatenate([keys, met.row[upper].astype(np.int64) * count + met.col[upper]]))
    low, high = keys // count, keys % count
    both = np.concatenate([low, high]), np.concatenate([high, low])
    return csr_matrix((np.ones(2 * len(keys), np.int8), both), shape=(count, count))
