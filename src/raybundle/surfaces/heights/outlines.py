"""How much of each cell of a grid lies within an outline."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raybundle.numerics.arrays import Array, Index

AT_ONCE = 1_000_000
"""Pieces of edges, each within a cell, that are summed together."""
ROUNDING = 1e-9
"""Of a cell: what a share is off none or all by less than this is none or all."""


def coverage(rings: Sequence[Array], shape: tuple[int, int]) -> Array:
    """(rows, columns) share of each cell within rings (n, 2) of columns and rows; even-odd rule, so that holes count.

    Cell (0, 0) reaches from 0 to 1 in both.  Shares are exact: each edge is cut where it passes from cell to cell, and
    each piece adds the trapezoid between it and the right end of its row.  Rings that cross themselves or each other
    have no such area; they count as often as they wind round a cell.
    """
    rows, columns = shape
    beside = np.zeros((rows, columns + 2))
    for ring, sign in zip(rings, _signs(rings), strict=True):
        if not sign:
            continue
        begin, end = ring, np.roll(ring, -1, axis=0)
        begin, end = (v[begin[:, 1] != end[:, 1]] for v in (begin, end))
        several = np.cumsum(_crossed(begin[:, 1], end[:, 1], rows) + _crossed(begin[:, 0], end[:, 0], columns) + 1)
        first = 0
        while first < len(begin):
            last = max(first + 1, int(np.searchsorted(several, (several[first - 1] if first else 0) + AT_ONCE)))
            _add(beside, sign, begin[first:last], end[first:last])
            first = last
    found = np.cumsum(beside[:, :columns], axis=1)
    found[np.abs(found) < ROUNDING] = 0.0
    found[np.abs(found - 1) < ROUNDING] = 1.0
    return np.clip(found, 0.0, 1.0)


def _crossed(a: Array, b: Array, count: int) -> Index:
    """(n,) how many of the whole numbers 0 to count lie between two numbers."""
    low, high = np.minimum(a, b), np.maximum(a, b)
    first, last = np.maximum(np.ceil(low), 0.0), np.minimum(np.floor(high), float(count))
    return np.maximum(last - first + 1, 0).astype(int)


def _cuts(a: Array, b: Array, count: int) -> tuple[Index, Array]:
    """Of which edge, and at which share of it from a to b, each of the whole numbers 0 to count is passed."""
    many = _crossed(a, b, count)
    edge = np.repeat(np.arange(len(a)), many)
    number = np.arange(len(edge)) - np.repeat(np.cumsum(many) - many, many)
    number = number + np.maximum(np.ceil(np.minimum(a, b)), 0.0)[edge]
    apart = (b - a)[edge]
    # an edge along a border passes it nowhere
    return edge[apart != 0], (number[apart != 0] - a[edge[apart != 0]]) / apart[apart != 0]


def _add(beside: Array, sign: float, begin: Array, end: Array) -> None:
    """Add what edges (n, 2) leave on their right to differences of shares from column to column."""
    rows, columns = len(beside), beside.shape[1] - 2
    n = np.arange(len(begin))
    across, down = (_cuts(begin[:, k], end[:, k], count) for k, count in ((0, columns), (1, rows)))
    edge = np.concatenate([n, n, across[0], down[0]])
    share = np.clip(np.concatenate([np.zeros(len(n)), np.ones(len(n)), across[1], down[1]]), 0.0, 1.0)
    order = np.lexsort((share, edge))
    edge, share = edge[order], share[order]
    place = begin[edge] + share[:, None] * (end - begin)[edge]
    place = np.where(share[:, None] == 1, end[edge], place)
    same = edge[1:] == edge[:-1]
    middle, rise = ((place[1:] + place[:-1]) / 2)[same], np.diff(place[:, 1])[same]
    x, row = middle[:, 0], np.floor(middle[:, 1]).astype(int)
    kept = (rise != 0) & (row >= 0) & (row < rows) & (x < columns)
    x, row, rise = np.maximum(x[kept], 0.0), row[kept], sign * rise[kept]
    column = np.floor(x).astype(int)
    flat, at = beside.reshape(-1), row * (columns + 2) + column
    share = 1 - (x - column)
    flat += np.bincount(at, rise * share, minlength=len(flat))
    flat += np.bincount(at + 1, rise * (1 - share), minlength=len(flat))


def _signs(rings: Sequence[Array]) -> list[float]:
    """Of each ring 1 or -1, so that its edges add what lies within an odd number of rings; 0: it encloses nothing."""
    sizes = [_signed(r) for r in rings]
    places = [_inner(r) if size else np.zeros(2) for r, size in zip(rings, sizes, strict=True)]
    found = list[float]()
    for k, size in enumerate(sizes):
        larger = [n for n, s in enumerate(sizes) if (abs(s), n) > (abs(size), k)]
        depth = sum(len(_passed(rings[n], places[k][1], places[k][0])) % 2 for n in larger)
        # rows run downwards: edges that go down have what they enclose on their right where it counts
        found.append(float(-np.sign(size)) * (-1.0) ** depth)
    return found


def _signed(ring: Array) -> float:
    """Area of a ring (n, 2) of columns and rows, positive from columns to rows."""
    x, y = (ring - ring.mean(axis=0)).T
    return float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) / 2


def _inner(ring: Array) -> Array:
    """(2,) a place within a ring."""
    levels = np.unique(ring[:, 1])
    widest = int(np.diff(levels).argmax())
    y = float(levels[widest] + levels[widest + 1]) / 2
    x = np.sort(_passed(ring, y, -np.inf))
    k = 2 * int((x[1::2] - x[::2]).argmax())
    return np.array([(x[k] + x[k + 1]) / 2, y])


def _passed(ring: Array, y: float, beyond: float) -> Array:
    """Columns beyond a place where edges of a ring pass a row."""
    (x0, y0), (x1, y1) = ring.T, np.roll(ring, -1, axis=0).T
    cut = (y0 > y) != (y1 > y)
    x = x0[cut] + (y - y0[cut]) * (x1[cut] - x0[cut]) / (y1[cut] - y0[cut])
    return x[x > beyond]
