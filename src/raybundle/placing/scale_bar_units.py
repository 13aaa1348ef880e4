"""Scale bars beside control: one of another unit is named and left out before the adjustment."""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.block import Block
from raybundle.block.block import Distances
from raybundle.errors import Value
from raybundle.numerics.arrays import Mask
from raybundle.numerics.length_units import BEYOND, unit_of


def without_strange_bars(block: Block) -> tuple[Block, list[Notice]]:
    """A block that control has placed without the scale bars that contradict it by more than BEYOND, each a fault.

    The tests of the adjustment find less: beyond it a bar pulls its ends behind the photographs, whose right
    measurements are rejected then.
    Limits: whether control or the bar has the wrong unit, where there is one bar alone.
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
            code="distance_suspect.beside_control", ids=(ids[d.start[k]], ids[d.end[k]]),
            values={
                "start": ids[d.start[k]], "end": ids[d.end[k]], "given_m": float(d.length[k]),
                "measured_m": float(shown[k]), "ratio": float(ratio[k]), "limit": BEYOND, **_unit(float(ratio[k])),
            },
        )
        for k in np.flatnonzero(wrong)
    ]  # fmt: skip
    keep = ~wrong
    kept = Distances(start=d.start[keep], end=d.end[keep], length=d.length[keep], sigma=d.sigma[keep])
    return block.having(kept), found


def _unit(ratio: float) -> dict[str, Value]:
    """The unit in which the bar, or the control, was likely given."""
    for of, factor in (("bar", ratio), ("control", 1 / ratio)):
        if name := unit_of(factor):
            return {"of": of, "likely": name}
    return {"of": "none", "likely": ""}
