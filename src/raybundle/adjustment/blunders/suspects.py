"""Observations outside the images that contradict the others: what was given, what all else shows, what may be meant.

The residual of an observation that hardly anything else controls states little of its error: of an error e the share
r e shows (r its redundancy number).  Stated is the error itself as the others have it, adjusted minus given had it
taken no part: w sigma_e with sigma_e = mdb / 4.13, which is v / r where observations are independent (Baarda 1968).
"""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.blunders.separability import SURE
from raybundle.adjustment.records.figures import ObservationGroup
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment
from raybundle.errors import Value, message
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.counting import decimals_for
from raybundle.numerics.statistics import DELTA0
from raybundle.observations import observation_kinds

MOST = 40
"""Suspects of a group that are distinguished from each other: each costs a solution of the normal equations."""
MOST_DECIMALS = 9
ROUNDING = 1e-6
"""Share of w below which a difference is that of rounding: two observations that only check each other have one w."""
LINEAR = 0.1
"""Share of a length up to which its error is linear: of a larger one the estimate may be any number, a negative too."""


def leverages(result: Adjustment, kind: str, rows: Index) -> Array | None:
    """(k, k) a' N^-1 b of whitened rows a and b of a kind of observation; None without the normal equations."""
    work = result.handle.work
    part = None if work is None else work.system.extra.of(kind)
    group = next((g for g in result.groups if g.kind == kind), None)
    if work is None or work.found is None or part is None or group is None or len(group.ids) != len(part.rows.sigma):
        return None
    _, nodes = work.normals.rows_of(work.state, part.start + rows)
    return np.asarray(nodes.T @ work.normals.solved_nodes(nodes))


def suspect_notices(result: Adjustment, g: ObservationGroup, limit: float) -> list[Notice]:
    """One for each observation of a group whose |w| is beyond the limit."""
    rows = np.flatnonzero(np.abs(np.nan_to_num(g.w)) > limit)
    if not len(rows):
        return []
    rows = rows[np.argsort(-np.abs(g.w[rows]), kind="stable")]
    explained = _explained(result, g, rows[:MOST])
    factor, unit = shown_unit(result, g)
    found: list[Notice] = []
    for k in rows.tolist():
        by = explained.get(k, ())
        if any(k not in explained.get(j, ()) for j in by):
            continue  # stated with the one whose blunder explains it, and which it does not explain
        beside = [g.ids[j] for j in rows.tolist() if k in explained.get(j, ()) and j not in by]
        off = factor * float(g.w[k] * g.mdb[k] / DELTA0)
        given, digits = factor * float(g.given[k]), decimals_for(abs(off), MOST_DECIMALS)
        each = [message("suspect.others", name=g.ids[k], names=[g.ids[j] for j in by])] if by else []
        each += [message("suspect.beside", name=g.ids[k], names=beside)] if beside else []
        values: dict[str, Value] = {
            "kind": observation_kinds[g.kind].key, "name": g.ids[k], "component": g.component[k],
            "given": round(given, digits), "off": off, "sigma": factor * float(g.sigma[k]), "unit": unit.strip(),
            "w": abs(float(g.w[k])), "limit": limit,
        }  # fmt: skip
        if g.kind == "distance" and abs(off) > LINEAR * given:
            words = "distance_suspect.far"
            values["share"] = LINEAR
        else:
            words = "suspect.value"
            values["shown"] = round(given + off, digits)
        found.append(
            Notice(
                code=f"{g.kind}_suspect", words=words, values=values, ids=(g.ids[k],), details=tuple(each),
                measured=Severity.FAULT,
            )
        )  # fmt: skip
    return found


def _explained(result: Adjustment, g: ObservationGroup, rows: Index) -> dict[int, tuple[int, ...]]:
    """Of each row those whose blunder would explain its residual as well: w - rho w' < 2.33 sqrt(1 - rho^2)."""
    meet = leverages(result, g.kind, rows) if len(rows) > 1 else None
    if meet is None:
        return {}
    check = np.sqrt(np.maximum(1 - np.diagonal(meet), 1e-12))
    rho = np.clip(np.abs(meet) / np.outer(check, check), 0, 1)
    w = np.abs(g.w[rows])
    free = w[:, None] - rho * w[None, :] < SURE * np.sqrt(1 - rho**2) + ROUNDING * w[:, None]
    np.fill_diagonal(free, val=False)
    return {int(row): tuple(rows[np.flatnonzero(free[k])].tolist()) for k, row in enumerate(rows)}


def shown_unit(result: Adjustment, g: ObservationGroup) -> tuple[float, str]:
    """By what values of a group are multiplied to be shown, and their unit, with the space before it."""
    kind = observation_kinds[g.kind].unit
    if kind == "angle":
        return float(np.degrees(1.0)), " degrees"
    return 1.0, f" {result.length_unit}".rstrip() if kind == "length" else ""
