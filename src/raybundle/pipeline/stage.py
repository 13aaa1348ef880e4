"""Stages as values, and the run that does them.

A stage states what its product depends on (`inputs`), and its function sees nothing else but the means: so a product
that is kept under the hash of the inputs is the one that the function would make again.
"""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, Generic, TypeVar

from raybundle.errors import InputError, Message, Text
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Counted, Progress, silent
from raybundle.pipeline import running
from raybundle.pipeline.executors import Executor, Processes, Threads
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import Product, ProductGone
from raybundle.pipeline.project import Project, Timed
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Done, Task, made

S = TypeVar("S")
I = TypeVar("I")
P = TypeVar("P")
SAVE_EVERY_S = 2.0
"""Small products are kept so often: what a killed run loses."""
MENDS = 3
"""Times that a task is done again because of one and the same input that was found damaged."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Codec(Generic[P]):
    """How a stage's product is kept."""

    arrays: Callable[[P], Product]
    product: Callable[[Mapping[str, Array]], P]


@dataclass(slots=True)
class Counting:
    """Reports how far the tasks of a stage are, those included that earlier runs have done."""

    progress: Progress
    what: str
    total: int
    done: int
    costs: Sequence[Task]
    folder: Path | None = None
    """of the project, where it is noted for who looks at it"""
    began: float = field(default_factory=time.perf_counter)
    noted: float = 0.0
    spent: float = 0.0
    """cost of what this run has done"""
    cost: float = 0.0
    """of all that it has to do"""

    def __post_init__(self) -> None:
        """What there is to do."""
        self.cost = sum(t.cost for t in self.costs)
        self._note()

    def _note(self) -> None:
        if self.folder is not None and self.costs and time.monotonic() > self.noted + running.EVERY_S:
            running.note(self.folder, self.what, self.done, self.total)
            self.noted = time.monotonic()

    def one_more(self, cost: float) -> None:
        """A task has ended."""
        self.done, self.spent = min(self.done + 1, self.total), self.spent + cost
        spent = min(self.spent / self.cost, 1.0) if self.cost else 1.0
        left = (time.perf_counter() - self.began) * (1 / spent - 1) if spent else 0.0
        self.progress(self.what, Counted(self.done / max(self.total, 1), self.done, self.total, left))
        self._note()


@dataclass(slots=True, kw_only=True)
class Means:
    """What a stage's function works with; its product must not depend on any of it."""

    project: Project
    executor: Executor = field(default_factory=Threads)
    progress: Progress = silent
    jobs: int = 1
    memory: float = 4e9
    """bytes that may be held"""
    adjusting: float = 0.0
    """bytes that an adjustment may take; 0: what is free allows it"""
    asked: int | None = None
    """tasks of this stage, and those of them that had to be done; None: it has no tasks"""
    made: int = 0
    _small: dict[str, Product] = field(default_factory=dict[str, Product])

    @property
    def store(self) -> Folder:
        """Where the products of tasks are."""
        return self.project.products

    def do(self, tasks: Sequence[Task], what: str, *, apart: bool = False) -> dict[str, Text]:
        """Do the tasks whose products are not kept yet; keys of those that failed, and why.

        what   the work in words, for the progress
        apart  they keep the interpreter to themselves: processes do them where threads of this one would
        Products lie in the store, small ones are at hand (`small`).
        """
        self.asked = (self.asked or 0) + len(tasks)
        self._small |= self.project.small([t.key for t in tasks if t.small])
        self.store.makers.update({t.key: partial(made, t, self.store) for t in tasks if not t.small})
        there = self.store.those([t.key for t in tasks if not t.small])
        missing = [t for t in tasks if t.key not in (self._small if t.small else there)]
        self.made += len(missing)
        counting = Counting(
            self.progress, what, total=len(tasks), done=len(tasks) - len(missing), costs=missing,
            folder=self.project.folder,
        )  # fmt: skip
        failed: dict[str, Text] = {}
        executor = self.executor
        alone = not self.store.place.shared or len(missing) < 2
        if apart and isinstance(executor, Threads) and executor.jobs != 1 and not alone:
            executor = Processes(executor.jobs, executor.memory)
        lost = Counter[tuple[str, str]]()
        while True:
            again = self._once(missing, counting, failed, executor)
            lost.update((done.task.key, done.lost) for done in again)
            hopeless = [done for done in again if lost[done.task.key, done.lost] >= MENDS]
            failed |= {done.task.key: _in_one_line(done.failed) for done in hopeless if done.failed}
            missing = [done.task for done in again if done.task.key not in failed]
            if not missing:
                break
            self._mend([done for done in again if done.task.key not in failed])
        running.forget(self.project.folder)
        return failed

    def _mend(self, stopped: Sequence[Done]) -> None:
        """Make again what tasks found damaged, and what else they need of it: each of them names one product alone.

        raises  ProductGone where no task of this run makes it
        """
        makers = self.store.makers
        gone = next((done.lost for done in stopped if done.lost not in makers), "")
        for key in sorted({key for done in stopped for key in (done.lost, *done.task.inputs) if key in makers}):
            if self.store.mapped(key) is None:
                try:
                    makers[key]()
                except ProductGone as error:
                    if error.key not in makers:  # it is made from what a stage keeps: that stage makes it
                        gone = gone or error.key
                except InputError:  # those that need it say so
                    continue
        self.store.release()
        if gone:
            raise ProductGone(gone, self.store.place.name)

    def _once(
        self, missing: Sequence[Task], counting: Counting, failed: dict[str, Text], executor: Executor
    ) -> list[Done]:
        """Do tasks; those that found a product damaged."""
        waiting: list[tuple[str, Product]] = []
        again: list[Done] = []
        saved = time.perf_counter()
        try:
            for done in executor.run(missing, self.store):
                if done.lost:
                    self.store.mended.add(done.lost)
                    again.append(done)
                elif done.failed:
                    failed[done.task.key] = _in_one_line(done.failed)
                elif done.task.small:
                    waiting.append((done.task.key, done.product))
                    self._small[done.task.key] = done.product
                if not done.lost:
                    counting.one_more(done.task.cost)
                if done.keep_now or time.perf_counter() - saved > SAVE_EVERY_S:
                    self.project.store_small(waiting)
                    waiting, saved = [], time.perf_counter()
        finally:
            self.project.store_small(waiting)
            self.store.release()
        return again

    def small(self, key: str) -> Product:
        """The product of a small task that was done."""
        return self._small[key]


@dataclass(frozen=True, slots=True, kw_only=True)
class Stage(Generic[S, I, P]):
    """A step of a workflow whose state is of type S."""

    name: str
    """first word of the keys of its products"""
    line: str = ""
    """as users read it where that is not the name: stages that stand together with one line are reported as one"""
    version: int = 1
    """raised with every change of what the function gives"""
    after: tuple[str, ...] = ()
    """stages of the workflow behind which it stands, and those before which it does"""
    before: tuple[str, ...] = ()
    inputs: Callable[[S], I]
    """everything that the product depends on; as `key_of` takes it where there is a codec"""
    function: Callable[[I, Means], P]
    """makes the product from the inputs alone"""
    put: Callable[[S, P], S]
    """the state with the product"""
    reported: Callable[[S], str] = lambda _: ""
    """what came of it, in a few words"""
    codec: Codec[P] | None = None
    """None: the product is made each time, as of products that tasks keep"""
    when: Callable[[S], bool] = lambda _: True
    """whether it has anything to do"""
    kinds: tuple[str, ...] = ()
    """first words of the keys of what its tasks keep, beside its own name"""
    little: bool = False
    """so little work that it is not counted as done again"""

    @property
    def title(self) -> str:
        """As users read it."""
        return self.line or self.name


@dataclass(frozen=True, slots=True, kw_only=True)
class Alternative(Generic[S]):
    """Stages with another way that is tried where the first one gives nothing, or little."""

    first: tuple[str, ...]
    """stages of the first way, which stand together in the workflow"""
    second: tuple[str, ...]
    """stages of the second way"""
    begin: Callable[[S, S | None], S | None]
    """(state before, state after the first way or None where that gave nothing) -> the state with which the second
    way begins; None where there is no second way"""
    better: Callable[[S, S], S]
    """which of the two states goes on; (after the first, after the second)"""
    only: Callable[[S], S] = lambda s: s
    """the state after the second way where the first one gave nothing"""
    nothing: type[Exception]
    """what a way raises that gives nothing"""


@dataclass(frozen=True, slots=True)
class Workflow(Generic[S]):
    """The stages of a command; each is a value in a module of its own, which registers it."""

    name: str
    stages: dict[str, Stage[S, Any, Any]] = field(default_factory=dict[str, Any])
    alternatives: list[Alternative[S]] = field(default_factory=list[Any])

    def register(self, stage: Stage[S, I, P]) -> Stage[S, I, P]:
        """Make a stage one of this workflow."""
        if stage.name in self.stages:
            raise ValueError(f"{self.name} has two stages {stage.name}")
        self.stages[stage.name] = stage
        return stage

    def register_alternative(self, alternative: Alternative[S]) -> Alternative[S]:
        """Make known that some stages have another way."""
        self.alternatives.append(alternative)
        return alternative

    def in_order(self) -> tuple[Stage[S, Any, Any], ...]:
        """The stages, each behind those that it states; raises ValueError for a circle or a name that is none."""
        needs = {name: set(s.after) for name, s in self.stages.items()}
        for name, s in self.stages.items():
            for other in s.before:
                needs[other].add(name)
        order: list[Stage[S, Any, Any]] = []
        while needs:
            free = sorted(name for name, missing in needs.items() if not missing)
            if not free:
                raise ValueError(f"{self.name}: no stage can be next of {', '.join(sorted(needs))}")
            order.append(self.stages[free[0]])
            del needs[free[0]]
            for missing in needs.values():
                missing.discard(free[0])
        return tuple(order)

    def titles(self) -> tuple[str, ...]:
        """What users read of the stages, in order."""
        return tuple(dict.fromkeys(s.title for s in self.in_order()))

    def from_title(self, title: str) -> tuple[Stage[S, Any, Any], ...]:
        """The stages from the first of this title on."""
        order = self.in_order()
        return order[next(k for k, s in enumerate(order) if s.title == title) :]


@dataclass(frozen=True, slots=True, kw_only=True)
class Run:
    """A run of stages in a project."""

    project: Project
    executor: Executor = field(default_factory=Threads)
    progress: Progress = silent
    jobs: int = 1
    memory: float = 4e9
    adjusting: float = 0.0

    def workflow(self, workflow: Workflow[S], state: S) -> S:
        """The state after all stages of a workflow.

        Where a product is found damaged that a stage keeps for its tasks, the stages are gone through once more: what
        is whole is taken, what is not is made by the stage that it is of.  raises ProductGone where that is of no use.
        """
        gone, begin = set[str](), len(self.project.records)
        while True:
            try:
                return self._through(workflow, state)
            except ProductGone as error:
                if error.key in gone:
                    raise
                gone.add(error.key)
                del self.project.records[begin:]

    def _through(self, workflow: Workflow[S], state: S) -> S:
        behind = {name: a for a in workflow.alternatives for name in a.first}
        done = set[str]()
        for stage in workflow.in_order():
            if stage.name in done:
                continue
            found = behind.get(stage.name)
            if found is None:
                state = self.stages((stage,), state)
                continue
            state = self._either(workflow, found, state)
            done |= {*found.first}
        return state

    def stages(self, stages: Sequence[Stage[S, Any, Any]], state: S) -> S:
        """The state after some stages; products that are kept already are taken."""
        for stage in stages:
            if stage.when(state):
                with self.project.stage(stage.title) as timed:
                    state = self._done(stage, state, timed)
        return state

    def _either(self, workflow: Workflow[S], a: Alternative[S], state: S) -> S:
        """The state after the better of two ways."""
        first, trouble = None, None
        ordered = workflow.in_order()
        try:
            first = self.stages([s for s in ordered if s.name in a.first], state)
        except a.nothing as error:
            trouble = error
        begin = a.begin(state, first)
        second = None
        if begin is not None:
            with suppress(a.nothing):
                second = self.stages([s for s in ordered if s.name in a.second], begin)
        if first is not None:
            return first if second is None else a.better(first, second)
        if second is not None:
            return a.only(second)
        assert trouble is not None
        raise trouble

    def _done(self, stage: Stage[S, Any, Any], state: S, timed: Timed) -> S:
        means = Means(
            project=self.project,
            executor=self.executor,
            progress=self.progress,
            jobs=self.jobs,
            memory=self.memory,
            adjusting=self.adjusting,
        )
        if stage.codec is None:
            product = stage.function(stage.inputs(state), means)
            timed.from_cache = stage.little or (means.asked is not None and not means.made)
        else:
            product, timed.key, timed.from_cache = self._kept(stage, stage.codec, stage.inputs(state), means)
        state = stage.put(state, product)
        timed.summary = stage.reported(state)
        return state

    def _kept(self, stage: Stage[S, I, P], codec: Codec[P], inputs: I, means: Means) -> tuple[P, str, bool]:
        """The product of a stage, its key, and whether it was kept; one that is made is what the next run will read."""
        store = self.project.products
        key = key_of(stage.name, stage.version, inputs)
        kept = store.load(key)
        if kept is not None:
            with suppress(KeyError, TypeError, ValueError):  # another version of raybundle has other fields
                return codec.product(kept), key, True
        arrays = codec.arrays(stage.function(inputs, means))
        store.store(key, arrays)
        return codec.product(arrays), key, False

    def forget(self, stages: Sequence[Stage[S, Any, Any]]) -> None:
        """Remove what is kept of these stages: they are done again."""
        for stage in stages:
            for kind in (stage.name, *stage.kinds):
                self.project.forget_kind(kind)


def _in_one_line(why: Message) -> Text:
    text = Text.of(why)
    return text.with_text(" ".join(text.split()))
