"""Which photograph each cell takes: seams that run where photographs look alike, and brightness levelled between them.

The choice is a Markov random field: each cell has a cost for each photograph that sees it, and neighbours that take
different ones pay by how much the photographs differ there (Kwatra et al. 2003).  Messages between neighbours find the
choice, by trees (Wainwright et al. 2005: on a grid each edge is in half of them), since plain belief propagation states
everything twice there and stays where it begins.  Messages go one cell a round: a cell knows nothing that is further
than as many cells as there are rounds, so that parts with such a margin are chosen as the whole would be.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask

ROUNDS = 48
"""Of messages: cells beyond which a cell is not asked."""
SHARE = np.float32(0.5)
"""Of the trees that an edge is in"""
KEPT = np.float32(0.2)
"""Of what was stated before: without it black and white cells of a chess board answer each other in turn"""
UNSEEN = np.float32(1e4)
"""Cost of a photograph that does not see a cell."""
LEAST_COST, OF_DIFFERENCE = 0.1, 0.05
"""Of a seam between two cells, in parts of a logarithm of the size of pixels: a tenth of resolution for a cell's side,
and the same for each two grey values that the photographs differ by."""
FEWEST = 30
"""Places that two photographs have in common, to show how their brightness differs."""
DARK, BRIGHT = 8, 247
"""Grey values beyond which brightness shows nothing."""
PRIOR = 0.3
"""Standard deviation of the logarithms of gains before anything is known: a stop is 0.69 before gamma."""
UNLIKE = 0.02
"""Least standard deviation of the logarithm by which two photographs differ: what a seam does not show."""


def chosen(cost: Array, across: Array, down: Array, rounds: int = ROUNDS) -> Index:
    """(rows, columns) number of the photograph that each cell takes; -1 where none sees it.

    cost    (photographs, rows, columns); inf where one does not see a cell
    across  (rows, columns - 1) of a seam between a cell and the next of its row
    down    (rows - 1, columns) of a seam between a cell and the next of its column
    """
    n, rows, columns = cost.shape
    if not n:
        return np.full((rows, columns), -1, np.int32)
    known: Mask = np.asarray(np.isfinite(cost).any(axis=0))
    own = np.where(np.isfinite(cost), cost, UNSEEN).astype(np.float32)
    # a hole hands nothing on
    across = np.where(known[:, 1:] & known[:, :-1], across, 0).astype(np.float32)
    down = np.where(known[1:] & known[:-1], down, 0).astype(np.float32)
    # by direction in which a message goes: right, left, down, up
    messages = [np.zeros_like(own) for _ in range(4)]
    limits = (across, across, down, down)
    ends = (
        (np.s_[:, :, :-1], np.s_[:, :, 1:]), (np.s_[:, :, 1:], np.s_[:, :, :-1]),
        (np.s_[:, :-1], np.s_[:, 1:]), (np.s_[:, 1:], np.s_[:, :-1]),
    )  # fmt: skip
    back = (1, 0, 3, 2)
    for _ in range(rounds):
        total = own + SHARE * ((messages[0] + messages[1]) + (messages[2] + messages[3]))
        new = list[Array]()
        for k, (here, there) in enumerate(ends):
            message = (total - messages[back[k]])[here]
            message = np.minimum(message - message.min(axis=0), limits[k] / SHARE)
            made = np.zeros_like(own)
            made[there] = message
            new.append((1 - KEPT) * made + KEPT * messages[k])
        messages = new
    total = own + SHARE * ((messages[0] + messages[1]) + (messages[2] + messages[3]))
    return np.where(known, total.argmin(axis=0), -1).astype(np.int32)


def seam_costs(colours: Array, seen: Array) -> tuple[Array, Array]:
    """Costs (rows, columns - 1) and (rows - 1, columns) of a seam between neighbours.

    colours  (photographs, rows, columns, 3) levelled
    seen     (photographs, rows, columns) whether one sees a cell
    """
    spread = spread_of(colours, seen)
    cost = np.float32(LEAST_COST) + np.float32(OF_DIFFERENCE) * spread
    return (cost[:, 1:] + cost[:, :-1]) / 2, (cost[1:] + cost[:-1]) / 2


def spread_of(colours: Array, seen: Array) -> Array:
    """(rows, columns) largest difference of the photographs that see a cell, mean of the channels."""
    with_ = np.where(seen[..., None], colours, -np.inf).max(axis=0)
    without = np.where(seen[..., None], colours, np.inf).min(axis=0)
    return np.where(seen.any(axis=0), (with_ - without).mean(axis=2), 0.0).astype(np.float32)


def gains(samples: Mapping[int, tuple[Index, Array]]) -> dict[int, Array]:
    """Factors (3,) of red, green and blue that make photographs alike where they overlap, around 1 in the mean.

    samples  of each photograph: places (n,) ascending, and its colours (n, 3) there

    Medians of the logarithms of ratios of each two photographs, adjusted with Huber's weights; gain compensation of
    Brown and Lowe (2007) for each channel.  Limits: light that changes within a photograph.
    """
    names = sorted(samples)
    first, second, ratio, spread = list[int](), list[int](), list[Array](), list[Array]()
    for a, i in enumerate(names):
        for b, j in enumerate(names[a + 1 :], start=a + 1):
            _, mine, theirs = np.intersect1d(samples[i][0], samples[j][0], assume_unique=True, return_indices=True)
            x, y = (samples[k][1][at].astype(float) for k, at in ((i, mine), (j, theirs)))
            usable = ((x > DARK) & (x < BRIGHT) & (y > DARK) & (y < BRIGHT)).all(axis=1)
            if usable.sum() < FEWEST:
                continue
            d = np.log(y[usable] / x[usable])
            middle = np.median(d, axis=0)
            first.append(a)
            second.append(b)
            ratio.append(middle)
            scatter = 1.4826 * np.median(np.abs(d - middle), axis=0)
            spread.append(np.hypot(UNLIKE, scatter * np.sqrt(np.pi / 2 / min(usable.sum(), 1000))))
    if not first:
        return {k: np.ones(3) for k in names}
    found = _adjusted(len(names), np.array(first), np.array(second), np.array(ratio), np.array(spread))
    return {k: np.exp(g) for k, g in zip(names, found, strict=True)}


def _adjusted(n: int, first: Index, second: Index, ratio: Array, spread: Array) -> Array:
    """(n, 3) logarithms of the factors: those of both differ by the ratio."""
    found = np.zeros((n, 3))
    each = np.arange(len(first))
    A = np.zeros((len(first), n))
    A[each, first], A[each, second] = 1.0, -1.0
    for channel in range(3):
        w = 1 / spread[:, channel] ** 2
        huber = np.ones(len(w))
        for _ in range(20):
            N = A.T @ (A * (w * huber)[:, None]) + np.eye(n) / PRIOR**2
            found[:, channel] = np.linalg.solve(N, A.T @ (w * huber * ratio[:, channel]))
            v = np.abs(A @ found[:, channel] - ratio[:, channel]) / spread[:, channel]
            huber = np.minimum(1.0, 1.5 / np.maximum(v, 1e-12))
    return found - found.mean(axis=0)
