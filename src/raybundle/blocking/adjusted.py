"""Normal equations in parts in place of those in one piece: everything above them is the same."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from raybundle.adjustment.assemble import System
from raybundle.adjustment.engine import Factoring
from raybundle.adjustment.normals import Normals
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.blocking.memory import Memory, Serial
from raybundle.blocking.network import LEAF, cut
from raybundle.blocking.tasks import Store
from raybundle.blocking.tree import WORTH
from raybundle.blocking.whole import WholeNormals
from raybundle.numerics.arrays import Mask
from raybundle.pipeline.executors import Executor


def in_parts(
    leaf: int = LEAF, *, worth: float = WORTH, store: Callable[[], Store] = Memory, executor: Executor | None = None,
    ready: float = float("inf"),
) -> Factoring:  # fmt: skip
    """The normal equations of a block in parts (Helmert 1880; Wolf 1978), as `adjust_block` takes them.

    leaf      unknowns of a leaf at most
    worth     as of `tree.dissect`
    store     where products are kept
    executor  who does the tasks, in processes that know the network; None: this one, one task after the other
    ready     bytes of parts that stay ready for use; others are made of the block whenever they are worked on
    """

    def factoring(
        system: System, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], rejected: Mask
    ) -> Normals:
        network = cut(system.block, options, free, rejected, leaf, shift=system.shift, worth=worth, ready=ready)
        return WholeNormals.whole(system, network, store(), executor or Serial())

    return factoring
