"""What an adjustment in parts takes: sweeps over the tree of a cut flight (`blocking.stored.adjust_columns`)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from raybundle.blocking.network import LEAF
from raybundle.workflows.costs.constants import Constants, Sweep
from raybundle.workflows.costs.cutting import Size, cut_flight
from raybundle.workflows.costs.stages import MESSAGE, Asked, StageCost, Work, moving

DOUBLE = 8
"""bytes"""
KEPT = 4
"""Parts that a process holds ready for use, as `blocking.stored.adjust_columns` does"""
COPIES = 3
"""Matrices of a front that a task holds at once: its own equations, those of a child, what is written"""
KINDS = {"up": 1, "down": 1, "covariances": 4, "statistics": 7}
"""Tasks of each tree node when a sweep is done once"""
NAMES = {"up": "reduction up", "down": "solution down", "covariances": "covariances", "statistics": "statistics"}


def operations(own: float, boundary: float, sweep: str) -> float:
    """Floating-point operations on a front: its elimination, or its cofactors; 0 of other sweeps."""
    if sweep == "up":
        return own**3 / 3 + own**2 * boundary + own * boundary**2
    return 2 * own**3 / 3 + 3 * own**2 * boundary + 2 * own * boundary**2 if sweep == "covariances" else 0.0


def kept_elements(own: float, boundary: float) -> tuple[float, float]:
    """Numbers of a tree node that are kept: of its factor and what it hands on, and of the inverse of its boundary."""
    return own**2 / 2 + own * boundary + boundary**2 / 2, boundary**2 / 2


def task_of(size: Size, sweep: str, c: Sweep) -> Work:
    """The tasks of a sweep at tree nodes of one size."""
    elements = (size.columns + size.rows) ** 2
    seconds = c.task_s + 1e-6 * c.point_us * size.points + 1e-9 * c.element_ns * elements
    return Work(
        count=size.count, cpu_s=seconds + 1e-12 * c.operation_ns * operations(size.columns, size.rows, sweep),
        read=c.read_point * size.points + c.read_element * elements,
        written=c.written_point * size.points + c.written_element * elements,
    )  # fmt: skip


def parts_of(a: Asked, *, shape: float = 1.0, leaf: int = LEAF) -> tuple[Size, ...]:
    """Parts of the flight that is asked for; shape and leaf as of `cutting.cut_flight`."""
    return cut_flight(a.images, a.overlap, a.image_points, shape=shape, leaf=leaf)


def adjustment(a: Asked, c: Constants, sizes: Sequence[Size]) -> tuple[StageCost, ...]:
    """Stages of an adjustment in parts over a store, each with what it adds to the disk."""
    cutting = 1e-6 * c.cutting_point_us * a.points * math.log2(max(a.points, 2.0))
    stored = 1e-9 * c.stored_point * a.points
    parts = StageCost(
        name="cutting", cpu_s=cutting, tasks=1, memory_mb=driver_memory(a, c), disk_gb=stored, moved_gb=stored,
        wall_s=cutting, serial_s=cutting,
    )  # fmt: skip
    times = {"up": a.iterations + 1, "down": a.iterations, "covariances": 1, "statistics": 1}
    swept = {s: _sweep(s, sizes, n, c, a) for s, n in times.items()}
    for k, sweep in enumerate(("up", "covariances")):
        elements = sum(s.count * kept_elements(s.columns, s.rows)[k] for s in sizes)
        swept[sweep] = replace(swept[sweep], disk_gb=1e-9 * DOUBLE * elements)
    return parts, *swept.values()


def _sweep(sweep: str, sizes: Sequence[Size], times: int, c: Constants, a: Asked) -> StageCost:
    """A sweep that is done so many times; tree nodes wait for those below or above, but in statistics."""
    of: Sweep = getattr(c, sweep)
    works = [(s.depth, task_of(s, sweep, of)) for s in sizes]
    tasks = times * KINDS[sweep] * sum(s.count for s in sizes)
    driver = 1e-3 * c.driver_task_ms * tasks
    moved = times * sum(w.count * (w.read + w.written) for _, w in works) + MESSAGE * tasks
    depths = sorted({d for d, _ in works}) if sweep != "statistics" else [-1]
    wall = serial = 0.0
    for depth in depths:
        level = [w for d, w in works if depth in {d, -1}]
        took = _together(level, a)
        wall += took
        serial += took if sum(w.count for w in level) < a.workers else 0.0
    return StageCost(
        name=NAMES[sweep], cpu_s=times * sum(w.count * w.cpu_s for _, w in works) + driver, tasks=tasks,
        memory_mb=max(front_memory(s, c) for s in sizes), disk_gb=0.0, moved_gb=1e-9 * moved,
        wall_s=times * wall + driver, serial_s=times * serial + driver,
    )  # fmt: skip


def _together(works: Sequence[Work], a: Asked) -> float:
    """Seconds in which workers do tasks of several sizes: never less than the longest."""
    at_once = min(float(a.workers), sum(w.count for w in works))
    each = [(w.count, w.cpu_s + moving(w, at_once, a)) for w in works]
    return max(sum(n * t for n, t in each) / a.workers, *(t for _, t in each))


def front_memory(size: Size, c: Constants) -> float:
    """Megabytes of a process that does tasks of this size: matrices of the front, and parts that are ready."""
    elements = (size.columns + size.rows) ** 2
    return c.base_mb + 1e-6 * (COPIES * DOUBLE * elements + KEPT * c.part_point * size.points)


def driver_memory(a: Asked, c: Constants) -> float:
    """Megabytes of the process that cuts the network and adds up: incidences of all image points."""
    return c.base_mb + 1e-6 * c.driver_point * a.points
