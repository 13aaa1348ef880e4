"""Normal equations in parts in place of those in one piece: everything above them is the same."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from raybundle.adjustment.assemble import System
from raybundle.adjustment.engine import Factoring
from raybundle.adjustment.normals import Normals
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.blocking.network import LEAF, cut
from raybundle.blocking.normals import Memory, Runner
from raybundle.blocking.whole import WholeNormals
from raybundle.numerics.arrays import Mask


def in_parts(leaf: int = LEAF, runner: Callable[[], Runner] = Memory) -> Factoring:
    """The normal equations of a block in parts (Helmert 1880; Wolf 1978), as `adjust_block` takes them.

    leaf    unknowns of a leaf at most
    runner  who does the tasks and keeps their products
    """

    def factoring(
        system: System, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], rejected: Mask
    ) -> Normals:
        network = cut(system.block, options, free, rejected, leaf, shift=system.shift)
        return WholeNormals.whole(system, network, runner())

    return factoring
