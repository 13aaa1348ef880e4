"""Scale bars beside control: one of another unit is named and left out before the adjustment."""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.result import Notice
from raybundle.block import Block
from raybundle.block.block import Distances
from raybundle.numerics.arrays import Mask
from raybundle.numerics.length_units import BEYOND, unit_of


def without_strange_bars(block: Block) -> tuple[Block, list[Notice]]:
    """A block that control has placed without the scale bars that contradict it by more than BEYOND, each a fault.

    The tests of the adjustment find less: beyond it a bar pulls its ends behind the photographs, whose right
    measurements are rejected then.
    What it does not tell: whether control or the bar has the wrong unit, where there is one bar alone.
    """
    d, xyz = block.distances, block.points.xyz
    shown = np.linalg.norm(xyz[d.start] - xyz[d.end], axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = d.length / shown
    wrong: Mask = np.isfinite(ratio) & (np.abs(np.log(np.maximum(ratio, 1e-300))) > np.log(BEYOND))
    if not wrong.any():
        return block, []
    ids = block.points.ids
    found = [
        Notice(
            code="distance_suspect",
            message=f"scale bar {ids[d.start[k]]} - {ids[d.end[k]]} is left out: its length is given as "
            f"{d.length[k]:.6g} m, and the photographs show {shown[k]:.4g} m in the system of the control, "
            f"a factor of {ratio[k]:.4g} (limit {BEYOND:g}, either way){_unit(float(ratio[k]))}",
            ids=(ids[d.start[k]], ids[d.end[k]]),
        )
        for k in np.flatnonzero(wrong)
    ]
    keep = ~wrong
    kept = Distances(start=d.start[keep], end=d.end[keep], length=d.length[keep], sigma=d.sigma[keep])
    return block.having(kept), found


def _unit(ratio: float) -> str:
    """What may explain a factor: the unit in which the bar, or the control, was given."""
    for what, of in (("the bar's length is", ratio), ("the control's coordinates are", 1 / ratio)):
        if name := unit_of(of):
            return f": {what} in {name}, it seems; give metres"
    return "; look at its length, at the names of its ends and at the unit of the control"
