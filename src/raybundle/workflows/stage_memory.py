"""Adjustments of a stage within the memory of a run: in parts, by its processes or workers, where that is needed."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager

from raybundle.pipeline.executors import Threads
from raybundle.pipeline.shards import Shards
from raybundle.pipeline.stage import Means
from raybundle.workflows.unfinished_parts import OF_STAGES
from raybundle.workflows.within_memory import Within, room_for, unasked

LITTLE = 50e6
"""Bytes of an adjustment that is made in one piece whatever is allowed: beside the program itself, parts would save
nothing.  The start of photographs makes thousands of such."""


@contextmanager
def room_of(means: Means, count: int = 0) -> Generator[Within]:
    """Room for the adjustments that a stage makes meanwhile, all of them.

    count  image observations of the largest of them; 0: not known yet
    """
    here = isinstance(means.executor, Threads | Shards)  # shards do not wait for each other, as sweeps do
    with room_for(
        count, means.project.folder / OF_STAGES, means.adjusting or unasked(), jobs=means.jobs,
        executor=None if here else means.executor, store=means.store.url, little=LITTLE,
    ) as found:  # fmt: skip
        yield found
