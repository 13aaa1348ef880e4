"""Recorded tasks on many workers that share one store: what they would take, event by event.

A worker reads what its task needs, computes, and writes: bytes go at its own rate, or at an equal share of the store's.
Tasks begin in the order in which they are given, as soon as what they wait for is done and a worker is free.  The
driver waits for the last task of a sweep before it begins the next.
"""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.workflows.costs.adjustment import parts_of, task_of
from raybundle.workflows.costs.constants import Constants, Sweep
from raybundle.workflows.costs.cutting import Size
from raybundle.workflows.costs.measure import SWEEP_OF, Fronts, sweep_of
from raybundle.workflows.costs.recording import TaskRecord
from raybundle.workflows.costs.stages import Asked

WORKER, STORE, LATENCY = 1e9 / 8, 10e9 / 8, 0.5e-3
"""bytes a second of a worker's line and of the store's; seconds of a message"""
WORKERS = (1, 4, 16, 64, 256)
LOADS = (160, 640)
"""Images for each worker: a leaf, four leaves"""
THREADS = 16
"""Of a machine whose processors together eliminate a front in the case that is not built, at 0.7 of their number"""
UPWARDS, DOWNWARDS = {"up", "right_up"}, {"down", "inverse", "right_down"}


@dataclass(frozen=True, kw_only=True)
class Job:
    """A task as it was recorded."""

    seconds: float
    read: float
    written: float
    waits: tuple[int, ...] = ()
    """positions of others in the list"""


def elapsed(jobs: Sequence[Job], workers: int, *, worker: float = WORKER, store: float = STORE) -> float:
    """Seconds in which workers do jobs."""
    left = [len(j.waits) for j in jobs]
    after: list[list[int]] = [[] for _ in jobs]
    for k, j in enumerate(jobs):
        for w in j.waits:
            after[w].append(k)
    ready = [k for k in range(len(jobs)) if not left[k]]
    heapq.heapify(ready)
    computing: list[tuple[float, int]] = []
    # all that move bytes have the same rate: each ends when so many bytes have passed for everyone since it began
    moving: list[tuple[float, int, bool]] = []
    now, passed, free = 0.0, 0.0, workers
    while ready or moving or computing:
        while ready and free:
            k = heapq.heappop(ready)
            free -= 1
            heapq.heappush(moving, (passed + jobs[k].read + 2 * LATENCY * worker, k, False))
        rate = min(worker, store / len(moving)) if moving else worker
        first = (moving[0][0] - passed) / rate if moving else np.inf
        then = min(now + first, computing[0][0] if computing else np.inf)
        passed += rate * (then - now)
        now = then
        while computing and computing[0][0] <= now:
            k = heapq.heappop(computing)[1]
            heapq.heappush(moving, (passed + jobs[k].written + 2 * LATENCY * worker, k, True))
        while moving and moving[0][0] <= passed + 1.0:
            _, k, written = heapq.heappop(moving)
            if not written:
                heapq.heappush(computing, (now + jobs[k].seconds, k))
                continue
            free += 1
            for n in after[k]:
                left[n] -= 1
                if not left[n]:
                    heapq.heappush(ready, n)
    return now


def sweeps_of(run: dict) -> list[list[dict]]:
    """The tasks of a run, a list for each sweep."""
    found: list[list[dict]] = []
    seen: set[int] = set()
    for r in run["records"]:
        if not found or found[-1][0]["name"] != r["name"] or r["node"] in seen:
            found.append([])
            seen = set()
        found[-1].append(r)
        seen.add(r["node"])
    return found


def recorded_jobs(run: dict) -> list[list[Job]]:
    """The sweeps of a run as they were."""
    found = []
    for sweep in sweeps_of(run):
        at = {r["key"]: k for k, r in enumerate(sweep)}
        waits = [tuple(at[key] for key in r["inputs"] if key in at) for r in sweep]
        found.append([
            Job(seconds=r["seconds"], read=r["read"], written=r["written"], waits=w)
            for r, w in zip(sweep, waits, strict=True)
        ])  # fmt: skip
    return found


@dataclass(frozen=True, kw_only=True)
class Kind:
    """Tasks of one kind: those of leaves as they were recorded, those of separators by constants fitted to all."""

    leaves: list[dict]
    fitted: Sweep
    operations: str
    """sweep whose floating-point operations it does; "": few"""


def kinds_of(run: dict, c: Constants) -> dict[str, Kind]:
    """By the name of the function."""
    sizes = Fronts(
        own=np.array(run["own"], float), size=np.array(run["size"], float), points=np.array(run["counts"], float)
    )
    above = {p for p in run["parent"] if p >= 0}
    found = {}
    for name in {r["name"] for r in run["records"]}:
        mine = [r for r in run["records"] if r["name"] == name]
        operations = SWEEP_OF[name] if name in {"up", "inverse"} else ""
        of = getattr(c, operations) if operations else None
        fitted = sweep_of(
            [TaskRecord(**r) for r in mine], sizes, operations, tasks=1, operation_ns=of.operation_ns if of else 0.0,
            element_ns=of.element_ns if of else 0.0,
        )  # fmt: skip
        found[name] = Kind(leaves=[r for r in mine if r["node"] not in above], fitted=fitted, operations=operations)
    return found


def tree_of(sizes: Sequence[Size]) -> list[tuple[int, int]]:
    """Position of the size, and parent, of each tree node of a flight; the root first."""
    found: list[tuple[int, int]] = [(0, -1)]
    k = 0
    while k < len(found):
        found += [(half, k) for half in sizes[found[k][0]].halves]
        k += 1
    return found


def made_jobs(run: dict, kinds: dict[str, Kind], a: Asked, threads: float = 1.0) -> list[list[Job]]:
    """The sweeps of a run over a flight of another size.

    threads  by which so many times faster fronts of separators are eliminated; 1: as it is
    """
    sizes = parts_of(a)
    tree = tree_of(sizes)
    below: list[list[int]] = [[] for _ in tree]
    for k, (_, parent) in enumerate(tree[1:], 1):
        below[parent].append(k)
    rng = np.random.default_rng(1)
    found = []
    for name in (s[0]["name"] for s in sweeps_of(run)):
        kind = kinds[name]
        order = range(len(tree) - 1, -1, -1) if name in UPWARDS else range(len(tree))
        at = {k: place for place, k in enumerate(order)}
        jobs = []
        for k in order:
            size = sizes[tree[k][0]]
            waits = tuple(at[b] for b in below[k]) if name in UPWARDS else ()
            if name in DOWNWARDS and k:
                waits = (at[tree[k][1]],)
            if size.leaf:
                r = kind.leaves[int(rng.integers(len(kind.leaves)))]
                jobs.append(Job(seconds=r["seconds"], read=r["read"], written=r["written"], waits=waits))
            else:
                w = task_of(size, kind.operations, kind.fitted)
                jobs.append(Job(seconds=w.cpu_s / threads, read=w.read, written=w.written, waits=waits))
        found.append(jobs)
    return found


def efficiencies(run: dict, a: Asked, c: Constants) -> dict:
    """Weak scaling: a flight that grows with the workers; and the recorded run on more and more of them."""
    kinds = kinds_of(run, c)
    per_task, cutting = 1e-3 * c.driver_task_ms, run["cutting s"]
    strong = {}
    for w in WORKERS:
        took = sum(elapsed(s, w) for s in recorded_jobs(run))
        strong[w] = {"sweeps s": took, "with the driver s": took + per_task * len(run["records"]) + cutting}
    weak = {}
    for load in LOADS:
        rows = {}
        for w in WORKERS:
            b = replace(a, images=load * w)
            jobs = made_jobs(run, kinds, b)
            tasks = sum(map(len, jobs))
            rows[w] = {
                "images": b.images, "tree nodes": len(jobs[0]), "sweeps s": sum(elapsed(s, w) for s in jobs),
                "no network s": sum(elapsed(s, w, worker=1e15, store=1e18) for s in jobs),
                "driver s": per_task * tasks + cutting * b.points / a.points,
                "fronts by threads s": sum(elapsed(s, w) for s in made_jobs(run, kinds, b, 0.7 * THREADS)),
            }  # fmt: skip
        for row in rows.values():
            row["efficiency of the sweeps"] = rows[1]["sweeps s"] / row["sweeps s"]
            row["without network"] = rows[1]["no network s"] / row["no network s"]
            row["with the driver"] = _whole(rows[1]) / _whole(row)
            row["if fronts were eliminated by threads"] = rows[1]["fronts by threads s"] / row["fronts by threads s"]
        weak[f"{load} images a worker"] = rows
    return {"the recorded run": strong, **weak}


def _whole(row: dict) -> float:
    return row["sweeps s"] + row["driver s"]
