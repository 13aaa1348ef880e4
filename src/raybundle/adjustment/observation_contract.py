"""What a kind of observation must keep, for those who write one: its partial derivatives are those of its residuals."""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.engine import free_parameters
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.assemble import System, assemble
from raybundle.adjustment.system.normals import Normals
from raybundle.block import Block
from raybundle.errors import InputError

STEP = 1e-5
"""By which an unknown is moved to either side [length unit, rad, or the unit of a parameter]."""


def partials_off(block: Block, kind: str, *, most: int = 60) -> float:
    """How far the partial derivatives of a kind are from differences of its residuals, at the values of a block.

    block    with approximate values for everything that takes part
    kind     name of a kind of observation that has rows in the block
    most     unknowns that are looked at, drawn from those that its rows touch
    returns  the largest difference over the largest derivative by the same unknown (or 1 standard deviation a unit, if
             that is more): some 1e-7 where they are right
    raises   InputError where the kind has no rows, or its rows touch no unknown
    """
    free = {c.id: free_parameters(c) for c in block.parametrised}
    return partials_off_in(
        assemble(block, AdjustmentOptions(), np.zeros(len(block.observations), bool), free), kind, most
    )


def partials_off_in(system: System, kind: str, most: int = 60) -> float:
    """The same in an assembled system."""
    part = system.extra.of(kind)
    if part is None:
        raise InputError("observations.none_of_kind", block=system.block.name, kind=kind)
    normals, state = Normals.of(system, 1), system.initial_state()
    entries = normals.extra(state)
    mine = np.isin(entries.row, part.positions)
    unknowns = np.unique(entries.unknown[mine])
    if not len(unknowns):
        raise InputError("observations.without_partials", kind=kind)
    A = np.zeros((len(part.rows), len(unknowns)))
    at = np.searchsorted(unknowns, entries.unknown[mine])
    np.add.at(A, (entries.row[mine] - part.start, at), entries.value[mine])
    kept = np.flatnonzero(system.point_node >= 0)
    worst = 0.0
    for k in np.random.default_rng(2).permutation(len(unknowns))[:most]:
        residual = list[np.ndarray]()
        for sign in (1, -1):
            step, points = np.zeros(int(system.offsets[-1])), np.zeros_like(state.xyz)
            step[unknowns[k]] = sign * STEP
            points[kept] = step[system.offsets[system.point_node[kept]][:, None] + np.arange(3)]
            residual.append(normals.extra(system.updated(state, step, points)).residual[part.positions])
        by = (residual[0] - residual[1]) / (2 * STEP)
        off = float(np.abs(A[:, k] - by).max()) / max(float(np.abs(A[:, k]).max()), 1.0)
        worst = max(worst, off) if np.isfinite(off) else np.inf
    return worst
