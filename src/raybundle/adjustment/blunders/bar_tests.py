"""Scale bars against control: the one bar without which control fits as it was stated."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.components import differs
from raybundle.errors import Value

MOST = 40
"""Bars that are tried, those that fit worst."""
CONTROLLED = 1e-6
"""Share of a bar's information that must show in its residual for it to be left out: rounding is far below."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WrongBar:
    """A scale bar that explains alone why control does not fit."""

    name: str
    w: float
    length: float
    """as given [object unit]"""
    shown: float
    """as the other observations would have it [object unit]"""
    before: float
    """sqrt(weighted square sum / redundancy) of the control and the bars that are doubted"""
    after: float
    """the same without it"""


def wrong_bar(result: Adjustment, limit: float) -> WrongBar | None:
    """The bar that explains a contradiction with weighted control; None where none does, or control does not differ.

    limit  of |w|

    Leaving out the observation b with the whitened partials a, residual v and leverage h = a' N^-1 a changes the
    unknowns by N^-1 a v / (1 - h) and every whitened residual accordingly, and takes (a_c' N^-1 a)^2 / (1 - h) from
    the redundancy of each other observation c (Cook and Weisberg 1982, sec. 2.2).  That explains it where control and
    the bars that are doubted fit worse than all other observations, and no longer without this one.
    """
    work, bars = result.handle.work, next((g for g in result.groups if g.kind == "distance"), None)
    control = next((g for g in result.groups if g.kind == "control"), None)
    part = None if work is None else work.system.extra.of("distance")
    if work is None or work.found is None or bars is None or control is None or part is None:
        return None
    weighted = control.sigma > 0
    square, r = float(control.square[weighted].sum()), float(np.nansum(control.redundancy[weighted]))
    W = result.weighted_square_sum, float(result.redundancy)
    if len(bars.ids) != len(part.rows.sigma):
        return None
    w = np.abs(np.nan_to_num(bars.w))
    doubted = np.flatnonzero(w > limit)
    doubted = doubted[np.argsort(-w[doubted], kind="stable")][:MOST]
    with_bars = square + float(bars.square[doubted].sum()), r + float(np.nansum(bars.redundancy[doubted]))
    if not len(doubted) or not _worse(*with_bars, W):
        return None
    system, state = work.system, work.state
    residual, nodes = work.normals.rows_of(state, part.start + doubted)
    x, y = work.normals.solve(state, nodes, np.zeros((*state.xyz.shape, len(doubted))))
    v, meet = residual, nodes.T @ x
    points = np.flatnonzero((system.prior & system.points_used[:, None]).any(axis=1))
    step = y[points]
    retained = system.point_node[points] >= 0
    step[retained] = x[system.offsets[system.point_node[points[retained]]][:, None] + np.arange(3)]
    given = system.prior[points]
    sigma = system.block.points.sigma[points][given]
    u = (state.xyz[points] + system.shift - system.block.points.xyz[points])[given] / sigma
    best: WrongBar | None = None
    for k, row in enumerate(doubted):
        check, others = 1 - float(meet[k, k]), np.arange(len(doubted)) != k
        if check < CONTROLLED:
            continue
        a = np.concatenate([step[:, :, k][given] / sigma, meet[others, k]])
        left = float(((np.concatenate([u, v[others]]) + a * v[k] / check) ** 2).sum())
        fewer = r + float(np.nansum(bars.redundancy[doubted[others]])) - float((a**2).sum()) / check
        after = float(np.sqrt(left / max(fewer, 1e-12)))
        if _worse(left, fewer, (W[0] - v[k] ** 2 / check, W[1] - 1)) or (best is not None and after >= best.after):
            continue
        length = float(bars.given[row])
        best = WrongBar(
            name=bars.ids[row], w=float(w[row]), length=length, shown=length + v[k] / check * float(bars.sigma[row]),
            before=float(np.sqrt(with_bars[0] / with_bars[1])), after=after,
        )  # fmt: skip
    return best


def _worse(square: float, r: float, total: tuple[float, float]) -> bool:
    """Whether a group fits worse than all other observations, beyond chance."""
    return differs(square, r, total) and square * total[1] > total[0] * r


def bar_notice(bar: WrongBar, limit: float, unit: str) -> Notice:
    """The fault of it."""
    values: dict[str, Value] = {
        "name": bar.name, "length": bar.length, "shown": bar.shown, "unit": unit, "w": bar.w, "limit": limit,
        "before": bar.before, "after": bar.after,
    }  # fmt: skip
    return Notice(code="distance_suspect.control", values=values, ids=(bar.name,))
