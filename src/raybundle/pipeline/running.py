"""How far a stage in work is, for whoever looks at a project: PROJECT/running.json, gone when the stage is done."""

from __future__ import annotations

import os
import time
import uuid
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import msgspec

from raybundle.io.folders import lock_of, unlock

FILE = "running.json"
EVERY_S = 2.0
"""So often it is written."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Running:
    """A stage in work."""

    stage: str
    done: int
    """tasks, those of earlier runs included"""
    total: int
    noted: str
    """when, UTC"""


def note(folder: Path, stage: str, done: int, total: int) -> None:
    """Write down how far a stage is; where that cannot be, nobody is reported."""
    now = time.strftime("%Y-%m-%d %H:%M:%S", time.gmtime())
    temporary = folder / f".{FILE}.{uuid.uuid4().hex[:8]}"
    with suppress(OSError):
        try:
            temporary.write_bytes(msgspec.json.encode(Running(stage=stage, done=done, total=total, noted=now)))
            temporary.replace(folder / FILE)
        finally:
            temporary.unlink(missing_ok=True)


def forget(folder: Path) -> None:
    """The stage is done."""
    with suppress(OSError):
        (folder / FILE).unlink()


def running(folder: Path) -> Running | None:
    """The stage in work, or at which a run was cut short; None: there is none."""
    try:
        return msgspec.json.decode((folder / FILE).read_bytes(), type=Running)
    except (OSError, msgspec.DecodeError):
        return None


def works(folder: Path) -> bool:
    """Whether a run works in a folder now; never where the system has no such lock."""
    lock = lock_of(folder)
    unlock(lock)
    return lock is None and os.name != "nt"
