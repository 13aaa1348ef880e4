"""A small graph of numeric tasks: leaves, their products in pairs up to a root, and small numbers of each leaf."""

import hashlib
import os
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task
from tests.barriers import wait_for

HERE = "tests.pipeline.graph"
SIZE = 60
NO_MATRIX = "leaf.csv: is no matrix"
"""Why a leaf with bad input fails"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Node:
    """Options of a task."""

    number: int
    below: tuple[str, ...] = ()
    log: Path | None = None
    """gets a line for each execution"""
    seconds: float = 0.0
    """that it takes beside"""
    crash: str = ""
    """what goes wrong"""
    gate: Path | None = None
    """file for which it waits"""
    burn: float = 0.0
    """CPU seconds of a leaf"""


def _logged(options):
    if options.log is not None:
        with options.log.open("a") as file:
            file.write(f"{options.number} {os.getpid()} {time.time():.3f}\n")
    time.sleep(options.seconds)
    if options.gate is not None:
        wait_for(options.gate.exists, "the gate is open")


def leaf(store: Folder, options: Node):
    """A matrix whose last digits depend on the order of sums."""
    del store
    _logged(options)
    until = time.thread_time() + options.burn
    while time.thread_time() < until:
        pass
    if options.crash == "bad input":
        raise InputError("is no matrix", file="leaf.csv")
    if options.crash == "exit":
        os._exit(3)
    if options.crash:
        raise RuntimeError(options.crash)
    a = np.random.default_rng(options.number).normal(size=(SIZE, SIZE))
    return {"a": np.linalg.qr(a @ a.T)[0], "names": np.array([f"leaf {options.number}"])}


def node(store: Folder, options: Node):
    """The product of two matrices, orthogonal again."""
    _logged(options)
    one, other = (store.held(k) for k in options.below)
    return {"a": np.linalg.qr(one["a"] @ other["a"])[0], "names": np.concatenate([one["names"], other["names"]])}


def trace(store: Folder, options: Node):
    """Small numbers of a leaf."""
    _logged(options)
    a = store.held(options.below[0])["a"]
    return {"trace": np.array(np.trace(a)), "matches": np.array([[options.number, len(a)]], np.int32)}


def tasks_of(leaves, *, log=None, seconds=0.0, crash=None, small=True, cost=1.0, gate=None, free=4, burn=0.0):
    """The tasks of a graph; `crash`: what goes wrong by numbers of leaves; `gate`: that all await but `free` leaves."""
    crash = crash or {}

    def task(kind, number, *below, is_small=False):
        options = Node(
            number=number, below=tuple(t.key for t in below), log=log, seconds=seconds, crash=crash.get(number, ""),
            gate=gate if number >= free else None, burn=burn,
        )  # fmt: skip
        key = key_of(kind, number, options.below, leaves)
        return Task(
            key=key, function=f"{HERE}:{kind}", options=options, inputs=options.below, small=is_small, cost=cost,
            name=f"{kind} {number}",
        )  # fmt: skip

    level = [task("leaf", k) for k in range(leaves)]
    tasks = [*level, *(task("trace", 10_000 + k, t, is_small=True) for k, t in enumerate(level) if small)]
    count = leaves
    while len(level) > 1:
        above = [task("node", count + k, *level[2 * k : 2 * k + 2]) for k in range(len(level) // 2)]
        count += len(above)
        tasks += above
        level = above
    return tasks


def digest(store, tasks, small):
    """Of all products, bit by bit."""
    total = hashlib.sha256()
    for t in sorted(tasks, key=lambda t: t.key):
        product = small[t.key] if t.small else store.load(t.key)
        for name in sorted(product):
            total.update(np.ascontiguousarray(product[name]).tobytes())
    return total.hexdigest()


def done_by(executor, tasks, store, meanwhile=lambda: None):
    """The digest of what an executor makes of tasks; `meanwhile` is called after each of them, before the next."""
    small = {}
    for done in executor.run(tasks, store):
        assert not done.failed, done.failed
        if done.task.small:
            small[done.task.key] = done.product
        meanwhile()
    return digest(store, tasks, small)


def executions(log):
    """How often each task was begun."""
    numbers = [line.split()[0] for line in log.read_text().splitlines()]
    return {n: numbers.count(n) for n in set(numbers)}
