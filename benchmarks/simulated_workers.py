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
TILED, PANELS = 0.6, 4
"""In the case that is not built: fronts of so much of the largest one's unknowns are eliminated in tiles, and into how
many panels their boundary is cut; measured best of 0.4 to 0.9 and of 2 to 8 panels"""
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


def message(size: Size) -> float:
    """Bytes of the triangle that a tree node hands to its parent, and gets back of the inverse."""
    return 4 * size.rows**2


def made_jobs(
    run: dict, kinds: dict[str, Kind], a: Asked, *, stays: bool = False, tiles: bool = False
) -> list[list[Job]]:
    """The sweeps of a run over a flight of another size.

    stays  parts, values and factors stay with the worker that made them: only triangles pass between tree nodes
    tiles  the largest fronts are eliminated in tiles
    """
    sizes = parts_of(a)
    tree = tree_of(sizes)
    below: list[list[int]] = [[] for _ in tree]
    for k, (_, parent) in enumerate(tree[1:], 1):
        below[parent].append(k)
    rng = np.random.default_rng(1)
    large = TILED * max(s.columns + s.rows for s in sizes) if tiles else np.inf
    found = []
    for name in (s[0]["name"] for s in sweeps_of(run)):
        kind, jobs = kinds[name], list[Job]()
        order = range(len(tree) - 1, -1, -1) if name in UPWARDS else range(len(tree))
        last = dict[int, tuple[int, ...]]()
        for k in order:
            size = sizes[tree[k][0]]
            waits: tuple[int, ...] = ()
            if name in UPWARDS:
                waits = tuple(j for b in below[k] for j in last[b])
            elif name in DOWNWARDS and k:
                waits = last[tree[k][1]]
            if size.leaf:
                r = kind.leaves[int(rng.integers(len(kind.leaves)))]
                job = Job(seconds=r["seconds"], read=r["read"], written=r["written"], waits=waits)
            else:
                w = task_of(size, kind.operations, kind.fitted)
                job = Job(seconds=w.cpu_s, read=w.read, written=w.written, waits=waits)
            others = sum(message(sizes[tree[b][0]]) for b in below[k])
            if stays:
                up, inverse = name == "up", name == "inverse"
                own = message(size)
                job = replace(job, read=up * others + inverse * own, written=up * own + inverse * others)
            if name == "up" and size.columns + size.rows >= large:
                last[k] = in_tiles(jobs, job, size, others, kind.fitted)
            else:
                jobs.append(job)
                last[k] = (len(jobs) - 1,)
        found.append(jobs)
    return found


def in_tiles(jobs: list[Job], whole: Job, size: Size, others: float, c: Sweep) -> tuple[int, ...]:
    """The elimination of a front in tiles, as jobs: own unknowns, then panels of the boundary, then tiles of what is
    handed on; those on which the parent waits.

    others  bytes that the children hand on
    """
    o, b, q = size.columns, size.rows, PANELS
    operation, elements = 1e-12 * c.operation_ns, (o + b) ** 2
    share = [o * o / elements, 2 * o * b / elements, b * b / elements]
    rest = max(whole.seconds - operation * (o**3 / 3 + o * o * b + o * b * b), 0.0)
    jobs.append(
        Job(
            seconds=rest * share[0] + operation * o**3 / 3, read=others * share[0], written=4 * o * o, waits=whole.waits
        )
    )
    first = len(jobs) - 1
    for _ in range(q):
        seconds = c.task_s + (rest * share[1] + operation * o * o * b) / q
        jobs.append(
            Job(seconds=seconds, read=others * share[1] / q + 4 * o * o, written=8 * o * b / q, waits=(first,))
        )  # fmt: skip
    panels, begin = range(first + 1, first + 1 + q), len(jobs)
    for i in range(q):
        for j in range(i + 1):
            part = (1 if i == j else 2) / q**2
            read = others * share[2] * part + 8 * o * b / q * (1 if i == j else 2)
            seconds = c.task_s + (rest * share[2] + operation * o * b * b) * part
            waits = (panels[i],) if i == j else (panels[i], panels[j])
            jobs.append(Job(seconds=seconds, read=read, written=message(size) * part, waits=waits))
    return tuple(range(begin, len(jobs)))


def efficiencies(run: dict, a: Asked, c: Constants) -> dict:
    """Weak scaling: a flight that grows with the workers; and the recorded run on more and more of them."""
    kinds = kinds_of(run, c)
    per_task, cutting = 1e-3 * c.driver_task_ms, run["cutting s"]
    strong = {}
    for w in WORKERS:
        took = sum(elapsed(s, w) for s in recorded_jobs(run))
        strong[w] = {"sweeps s": took, "with the driver s": took + per_task * len(run["records"]) + cutting}
    return {
        "the recorded run": strong,
        **{f"{load} images a worker": _weak(run, kinds, a, load, per_task, cutting) for load in LOADS},
    }


def _weak(
    run: dict, kinds: dict[str, Kind], a: Asked, load: int, per_task: float, cutting: float
) -> dict[int, dict[str, float]]:
    """Rows by the number of workers, each with so many images."""
    rows = {}
    names = [s[0]["name"] for s in sweeps_of(run)]
    handed = names.count("up") + names.count("inverse")
    for w in WORKERS:
        b = replace(a, images=load * w)
        jobs, stays = made_jobs(run, kinds, b), made_jobs(run, kinds, b, stays=True)
        work = sum(j.seconds for s in jobs for j in s)
        # each triangle is written once, and read where the one who made it does not read it: by one child of two
        least = 1.5 * handed * sum(s.count * message(s) for s in parts_of(b)) / STORE
        rows[w] = {
            "images": b.images, "tree nodes": len(jobs[0]), "sweeps s": sum(elapsed(s, w) for s in jobs),
            "work s": work, "no network s": sum(elapsed(s, w, worker=1e15, store=1e18) for s in jobs),
            "no limit of the store s": sum(elapsed(s, w, store=1e18) for s in jobs),
            "what is made stays s": sum(elapsed(s, w) for s in stays),
            "fronts in tiles s": sum(elapsed(s, w) for s in made_jobs(run, kinds, b, tiles=True)),
            "least for the store s": least if w > 1 else 0.0,
            "driver s": per_task * sum(map(len, jobs)) + cutting * b.points / a.points,
        }  # fmt: skip
    for w, row in rows.items():
        row["efficiency of the sweeps"] = rows[1]["sweeps s"] / row["sweeps s"]
        row["without network"] = rows[1]["no network s"] / row["no network s"]
        row["with the driver"] = _whole(rows[1]) / _whole(row)
        row["if the work were shared evenly"] = rows[1]["work s"] * w / row["work s"]
        row["if what is made stayed"] = rows[1]["what is made stays s"] / row["what is made stays s"]
        row["if fronts were in tiles"] = rows[1]["sweeps s"] / row["fronts in tiles s"]
    return rows


def _whole(row: dict) -> float:
    return row["sweeps s"] + row["driver s"]
