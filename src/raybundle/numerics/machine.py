"""What this machine has."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

CGROUP = Path("/sys/fs/cgroup")
"""Where Linux shows what a container may take"""


def available_memory() -> float:
    """Bytes that a process can take without others being paged out, and within what its container may take."""
    import psutil

    found = float(psutil.virtual_memory().available)
    with suppress(OSError, ValueError):  # no Linux, no limit ("max"), or an older kind of container
        limit, taken = (int((CGROUP / f"memory.{name}").read_text()) for name in ("max", "current"))
        kept = dict(line.split() for line in (CGROUP / "memory.stat").read_text().splitlines())
        found = min(found, float(limit - taken + int(kept.get("inactive_file", 0))))
    return max(found, 0.0)
