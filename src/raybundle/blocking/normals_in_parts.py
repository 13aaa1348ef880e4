"""Normal equations in parts in place of those in one piece: everything above them is the same."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import count

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.assemble import System
from raybundle.adjustment.system.factoring import Factoring
from raybundle.adjustment.system.normals import Normals
from raybundle.blocking.columns import InMemory
from raybundle.blocking.fields_in_parts import NormalsInParts
from raybundle.blocking.memory import Memory, Serial
from raybundle.blocking.network import LEAF, cut
from raybundle.blocking.network_store import cut_columns
from raybundle.blocking.normals import Parts
from raybundle.blocking.store import Store
from raybundle.blocking.tree import WORTH
from raybundle.numerics.arrays import Mask
from raybundle.pipeline.executors import Executor


def in_parts(
    leaf: int = LEAF, *, worth: float = WORTH, store: Callable[[], Store] | None = None,
    executor: Executor | None = None, ready: float = float("inf"), notes: Store | None = None,
) -> Factoring:  # fmt: skip
    """The normal equations of a block in parts (Helmert 1880; Wolf 1978), as `adjust_block` takes them.

    leaf      unknowns of a leaf at most
    worth     as of `tree.dissect`
    store     where parts and products lie, for each system another one; None: in memory, parts with the block
    executor  who does the tasks, where they lie in a store; None: this process, one task after the other
    ready     bytes of parts that each process holds ready for use; others are made whenever they are worked on
    notes     where the numbers of each sweep stay, for a run that is started again
    """
    numbers = count()

    def factoring(
        system: System, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], rejected: Mask
    ) -> Normals:
        if store is None:
            network = cut(system.block, options, free, rejected, leaf, shift=system.shift, worth=worth, ready=ready)
            return NormalsInParts.whole(system, Parts(network, Memory(), Serial()))
        kept = store()
        made = cut_columns(
            InMemory(system.block), options, free, rejected, kept, leaf=leaf, ready=ready, worth=worth, notes=notes,
            shift=system.shift, number=next(numbers),
        )  # fmt: skip
        parts = Parts(made.network, kept, executor or Serial(), begin=made.keep_parts, notes=notes)
        return NormalsInParts.whole(system, parts)

    return factoring
