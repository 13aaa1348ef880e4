"""Tasks on many workers that share one store: what they take, event by event.

A worker reads what its task needs, computes, and writes: bytes go at its own rate, or an equal share of the store's.
Tasks begin in the order in which they are given as soon as what they wait for is done and a worker is free.
"""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

WORKER, STORE, LATENCY = 1e9 / 8, 10e9 / 8, 0.5e-3
"""bytes a second of a worker's line and of the store's; seconds of a message"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Job:
    """A task as it was recorded."""

    seconds: float
    read: float
    written: float
    waits: tuple[int, ...] = ()
    """positions of others in the list"""


def elapsed(jobs: Sequence[Job], workers: int, *, worker: float = WORKER, store: float = STORE) -> float:
    """Seconds in which workers do jobs."""
    left = np.array([len(j.waits) for j in jobs])
    after: list[list[int]] = [[] for _ in jobs]
    for k, j in enumerate(jobs):
        for w in j.waits:
            after[w].append(k)
    ready = [k for k in range(len(jobs)) if not left[k]]
    heapq.heapify(ready)
    moving: dict[int, float] = {}  # bytes left of those that read or write
    writes: set[int] = set()
    computing: list[tuple[float, int]] = []
    now, free = 0.0, workers
    while ready or moving or computing:
        while ready and free:
            k = heapq.heappop(ready)
            free -= 1
            moving[k] = jobs[k].read + 2 * LATENCY * worker
        rate = min(worker, store / len(moving)) if moving else 0.0
        next_moved = now + min(moving.values()) / rate if moving else np.inf
        next_done = computing[0][0] if computing else np.inf
        then = min(next_moved, next_done)
        for k in moving:
            moving[k] -= rate * (then - now)
        now = then
        while computing and computing[0][0] <= now:
            _, k = heapq.heappop(computing)
            writes.add(k)
            moving[k] = jobs[k].written + 2 * LATENCY * worker
        for k in [k for k, b in moving.items() if b <= 1.0]:
            del moving[k]
            if k not in writes:
                heapq.heappush(computing, (now + jobs[k].seconds, k))
                continue
            free += 1
            for n in after[k]:
                left[n] -= 1
                if not left[n]:
                    heapq.heappush(ready, n)
    return now
