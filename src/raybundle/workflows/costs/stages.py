"""What stages take: what is asked for, tasks and their time on a network."""

from __future__ import annotations

import math
from dataclasses import dataclass

MESSAGE = 1500
"""bytes of a task on its way to a worker, and of its answer (`pipeline.tasks.written`, paths and options included)"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Asked:
    """What is to be adjusted, and by whom."""

    images: int
    megapixels: float
    overlap: float
    """photographs that show a place of the object"""
    image_points: float
    """of a photograph, that are adjusted"""
    iterations: int
    workers: int
    memory_gb: float
    """of a machine"""
    network_gbit: float
    """of a worker; 0: one machine does all"""
    store_gbit: float
    """of the store that all share"""
    latency_ms: float

    @property
    def points(self) -> float:
        """Image points of all photographs."""
        return self.images * self.image_points


@dataclass(frozen=True, slots=True, kw_only=True)
class StageCost:
    """What a stage takes."""

    name: str
    cpu_s: float
    tasks: float
    memory_mb: float
    """of the largest process"""
    disk_gb: float
    """that it adds"""
    moved_gb: float
    """bytes between store and workers, where they are not of one machine"""
    wall_s: float
    serial_s: float = 0.0
    """of the wall time, that of one process while others wait"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Work:
    """Equal tasks that wait for nothing of each other."""

    count: float
    cpu_s: float
    """of each"""
    read: float = 0.0
    """bytes of each"""
    written: float = 0.0


def wall_of(work: Work, a: Asked) -> float:
    """Seconds in which workers do equal tasks, each with its share of the store's line."""
    at_once = min(float(a.workers), work.count)
    return math.ceil(work.count / a.workers) * (work.cpu_s + moving(work, at_once, a))


def moving(work: Work, at_once: float, a: Asked) -> float:
    """Seconds of a task's bytes on the line, of so many workers that share it; none on one machine."""
    if a.workers <= 1 or not a.network_gbit:
        return 0.0
    rate = min(a.network_gbit, a.store_gbit / max(at_once, 1.0)) * 1e9 / 8
    return (work.read + work.written) / rate + 2 * a.latency_ms / 1000
