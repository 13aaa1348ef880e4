"""An adjustment within the memory that there is: arrays in files, normal equations in parts, where they have to be.

What is stated here in bytes for an image observation was measured (benchmarks/memory.py); the factor of the normal
equations is counted exactly, once it is known which unknowns meet.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Generator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass, fields, replace
from functools import cached_property
from pathlib import Path
from weakref import finalize

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.assemble import System
from raybundle.adjustment.system.factoring import Factoring, made_by
from raybundle.adjustment.system.normals import Normals
from raybundle.block import Block
from raybundle.blocking.network_in_memory import WholeNormals
from raybundle.blocking.normals_in_parts import in_parts
from raybundle.errors import InputError, NotSolvable
from raybundle.io.block.folder import read_block
from raybundle.io.block.pieces import image_points_in, read_in_pieces
from raybundle.io.folders import continued_folder
from raybundle.numerics import large
from raybundle.numerics.arrays import Mask
from raybundle.numerics.machine import available_memory
from raybundle.numerics.progress import Progress, silent
from raybundle.pipeline.choosing import staying_for
from raybundle.pipeline.clusters import token_of
from raybundle.pipeline.executors import Executor, Staying
from raybundle.pipeline.store import Folder, whole_url
from raybundle.workflows.unfinished_parts import NOTES, forget_left, forget_stores, note_store, part_store

SHARE = 0.8
"""Of the memory that is free, what is taken where nothing is asked for."""
ALWAYS = 1e9
"""Bytes that are taken unasked whatever is free: on a machine so short of memory, less would help nobody."""
BASE = 150e6
"""Bytes of the program itself."""
IN_MEMORY, IN_FILES, IN_PARTS = 800.0, 420.0, 300.0
"""Bytes for each image observation: all in memory; large arrays in files; and normal equations in parts besides."""
PROCESS = 2 * BASE
"""Bytes of a process that reduces parts: the program, and as much again for what it works on."""
AT_WORKERS = 1e9
"""Bytes of parts that a worker of a cluster holds ready: half of what docs/how-to/cluster.md asks for one."""
FACTOR = 3.0
"""Times its own size that a factor takes while it is made and inverted."""
SUMS = 7
"""Times the matrix itself that normal equations take with what four threads sum up: a number that does not follow the
processors, so that all machines cut alike."""
ORDERED = 100_000
"""Nodes of the normal equations (images, cameras) beyond which they are not ordered in one piece: so many of a flight
take 87 CPU seconds and 0.9 GB."""


class Room:
    """A folder beside a result for what does not fit into memory, made when it is asked for.

    It is gone with the last that holds it, at the latest with the process; what a run that is cut short leaves there is
    there for the next one with the same result.
    """

    def __init__(self, out: Path) -> None:
        """Beside this result."""
        self.out = out
        self._cut_short = [False]

    def leave(self) -> None:
        """Let it be there for the next run."""
        self._cut_short[0] = True

    @cached_property
    def folder(self) -> Path:
        """The folder."""
        stack, cut_short = ExitStack(), self._cut_short

        def ended() -> bool:
            if not cut_short[0]:  # parts of runs before this one may lie in other stores than its own
                forget_stores(found)
            return not cut_short[0]

        found = stack.enter_context(continued_folder(self.out, ended))
        finalize(self, stack.close)
        return found

    def forget(self, store: Folder) -> None:
        """Delete a store in it, unless the next run goes on from there."""
        if not self._cut_short[0]:
            with suppress(InputError):  # it cannot be reached any more
                store.place.clear()
            shutil.rmtree(store.path, ignore_errors=True)


@dataclass(slots=True)
class Within:
    """How normal equations are made within so much memory, and what became of it."""

    allowed: float
    """bytes"""
    room: Room
    observations: int
    executor: Executor | None = None
    """who reduces parts; None: this process"""
    workers: int = 1
    """processes here that do"""
    elsewhere: bool = False
    """whether workers of a cluster do"""
    always: bool = False
    """whether parts are wanted, whatever fits into memory"""
    little: float = 0.0
    """bytes of an adjustment that is made in one piece in any case"""
    store: str = ""
    """URL of the object store in which parts lie; empty: they lie in the room"""
    parts: int = 0
    """into which the normal equations were cut; 0: one piece"""
    needed: float = 0.0
    """bytes that one piece would take"""
    over: float = 0.0
    """bytes of the largest adjustment that was made in one piece though less was allowed, as `little` has it"""
    stores: int = 0
    """made so far: each system has its own"""
    _in_parts: Factoring | None = None

    @property
    def arrays_in_files(self) -> bool:
        """Whether large arrays have to lie in files."""
        return _beyond(self.observations, self.allowed)

    def factoring(
        self, system: System, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], rejected: Mask
    ) -> Normals:
        """The normal equations in one piece where that fits, or else in parts."""
        each = IN_FILES if self.arrays_in_files else IN_MEMORY
        needed = BASE + each * len(system.block.observations)
        most = max(self.allowed, BASE + self.little)
        if not self.always and needed <= most and len(system.sizes) <= ORDERED:
            whole = Normals.of(system, options.jobs)
            needed += bytes_of(whole)
            if needed <= most:
                self.over = max(self.over, needed if needed > self.allowed else 0.0)
                return whole
            del whole
        self.needed = needed  # of what was cut last: others that a stage adjusts fit
        if self._in_parts is None:
            left = max(self.allowed - BASE - IN_PARTS * self.observations, 0.0)
            ready = AT_WORKERS if self.elsewhere else left / 2 / self.workers
            self._in_parts = in_parts(store=self._next_store, ready=ready, executor=self.executor, notes=self._notes)
        made = self._in_parts(system, options, free, rejected)
        assert isinstance(made, WholeNormals)
        # a result is asked questions later: its parts stay for as long as it does
        finalize(made.parts.parts.known, self.room.forget, self._store(self.stores))
        self.parts = sum(bool(n) for n in made.parts.network.counts.tolist())
        return made

    def _next_store(self) -> Folder:
        self.stores += 1
        made = self._store(self.stores)
        if self.store:
            note_store(self._notes, self.stores, whole_url(self.store))
        made.place.check()
        return made

    @property
    def _notes(self) -> Folder:
        return Folder(self.room.folder / NOTES)

    def _store(self, number: int) -> Folder:
        """One of the stores, at a URL by a name that no other result has."""
        return part_store(self.room.folder, number, self.store, token_of(self._notes) if self.store else "")

    def notices(self) -> tuple[Notice, ...]:
        """What was done, where anything was."""
        if not self.parts:
            return self._over_notice()
        if self.elsewhere:
            return (Notice(code="in_parts.cluster", values={"parts": self.parts}),)
        least = BASE + IN_PARTS * self.observations
        values = {"parts": self.parts, "needed_gb": self.needed / 1e9, "allowed_gb": self.allowed / 1e9}
        if least > self.allowed:
            return (Notice(code="in_parts.least", values={**values, "least_gb": least / 1e9}),)
        return (Notice(code="in_parts", values=values),)

    def _over_notice(self) -> tuple[Notice, ...]:
        """That less was allowed than one piece took, where that was done all the same."""
        if not self.over:
            return self._too_little()
        values = {
            "allowed_gb": self.allowed / 1e9, "used_gb": self.over / 1e9, "whole_gb": (BASE + self.little) / 1e9,
            "program_gb": BASE / 1e9,
        }  # fmt: skip
        return (Notice(code="memory_exceeded", values=values),)

    def _too_little(self) -> tuple[Notice, ...]:
        """That less was allowed than the program itself takes."""
        if self.allowed >= BASE:
            return ()
        values = {"allowed_gb": self.allowed / 1e9, "program_gb": BASE / 1e9}
        return (Notice(code="memory_exceeded.program", values=values),)


def bytes_of(normals: Normals) -> float:
    """Bytes of normal equations and their factor while they are made and inverted."""
    entries = float(getattr(normals.solver, "factor_entries", 0))
    return 8.0 * (FACTOR * entries + SUMS * len(normals.values))


@contextmanager
def within_memory(
    source: Block | Path, out: Path, memory_gb: float, progress: Progress = silent, *, jobs: int = 1, cluster: str = "",
    store: str = "",
) -> Generator[tuple[Block, Within]]:  # fmt: skip
    """A block and room for its adjustment; what does not fit into memory lies beside the result meanwhile.

    source     the block, or its folder; image observations of a large one are read in pieces where they stand in
               observations.parquet
    out        where the result is to stand
    memory_gb  what the adjustment may take; 0: four fifths of what is free, 1 GB at least
    jobs       processes that reduce parts, as far as memory allows; 0: as many as there are processors
    cluster    who reduces parts elsewhere, as `staying_for` takes it; empty: nobody
    store      URL of the object store in which parts lie; empty: beside the result
    raises     InputError, for a folder as `read_block`

    Sweeps that a killed run has finished are there for the next one with the same result.
    """
    allowed = memory_gb * 1e9 or unasked()
    count = image_points_in(source) if isinstance(source, Path) else len(source.observations)
    if isinstance(source, Path) and (count is None or not _beyond(count, allowed)):
        source = read_block(source, progress=progress)
        count = len(source.observations)
    assert count is not None
    executor = staying_for(cluster, jobs, allowed, progress) if cluster else None
    with room_for(count, out, allowed, jobs=jobs, executor=executor, always=bool(cluster), store=store) as found:
        if isinstance(source, Path):
            yield read_in_pieces(source, progress=progress).whole(), found
        else:
            yield kept_large(source), found


def unasked() -> float:
    """Bytes that an adjustment takes where nothing is asked for."""
    return max(ALWAYS, SHARE * available_memory())


@contextmanager
def room_for(
    count: int, out: Path, allowed: float, *, jobs: int = 1, executor: Executor | None = None, always: bool = False,
    store: str = "", little: float = 0.0,
) -> Generator[Within]:  # fmt: skip
    """Room for adjustments with so many image observations; those that are made meanwhile keep to it.

    allowed   bytes that they may take
    executor  workers of a cluster that reduce parts; None: processes here
    always    parts, whatever fits into memory
    little    bytes of an adjustment that is made in one piece whatever is allowed
    and as of `within_memory`
    """
    left = allowed - BASE - IN_PARTS * count
    workers = max(1, min(jobs or os.cpu_count() or 1, int(left // PROCESS)))
    elsewhere = executor is not None
    if executor is None and workers > 1:
        executor = Staying(workers, left - workers * BASE)
    room = Room(out)
    found = Within(
        allowed,
        room,
        count,
        executor=executor,
        workers=workers,
        elsewhere=elsewhere,
        always=always,
        store=store,
        little=little,
    )
    try:
        with large.in_files(room.folder if found.arrays_in_files else None), made_by(found.factoring):
            yield found
        forget_left(out)  # of runs with other options
    except NotSolvable:
        raise
    except BaseException:
        if found.stores:  # sweeps, to go on from
            room.leave()
        raise
    finally:
        if isinstance(executor, Staying):
            executor.close()


def kept_large(block: Block) -> Block:
    """The block with its image observations where large arrays are now."""
    o = block.observations
    return replace(block, observations=replace(o, **{f.name: large.kept(getattr(o, f.name)) for f in fields(o)}))


def _beyond(count: int, allowed: float) -> bool:
    """Whether large arrays of so many image observations have to lie in files."""
    return BASE + IN_MEMORY * count > allowed
