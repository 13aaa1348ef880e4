"""CPU time of a run: of this process, and of the processes here and elsewhere that did tasks for it."""

from __future__ import annotations

import os
from threading import Lock

_lock = Lock()
_workers = [0.0]


def add_worker_time(seconds: float) -> None:
    """Count CPU seconds of a task that another process did."""
    with _lock:
        _workers[0] += seconds


def cpu_seconds() -> float:
    """CPU seconds so far; of processes that end without a result nothing is known."""
    t = os.times()
    return t.user + t.system + _workers[0]
