"""Run a set and keep its figures: one JSON file a set."""

from __future__ import annotations

import json
import os
import platform
import resource
import subprocess
import time
import traceback
from importlib.metadata import version
from pathlib import Path
from typing import Any

from raybundle.errors import RaybundleError

from . import ROOT
from .judges import judge_named
from .sets import LedgerSet, NotHere, Places
from .statistics import statistics


def run(one: LedgerSet, places: Places) -> dict[str, Any]:
    """The figures of a set, or the reason why there are none."""
    began, wall = _cpu(), time.perf_counter()
    groups, reason = list[dict[str, Any]](), ""
    try:
        groups = [statistics(errors) for errors in judge_named(one.judge)(one, places) if len(errors.ratio)]
        reason = "" if groups else "the judge found nothing to compare"
    except NotHere as lost:
        reason = str(lost)
    except RaybundleError as error:
        reason = f"{type(error).__name__}: {error.headline}"
    except Exception as error:  # noqa: BLE001  (one set does not stop the others: its row shows the reason)
        traceback.print_exc()
        reason = f"{type(error).__name__}: {error}"
    return _row(one, groups, reason, _cpu() - began, time.perf_counter() - wall)


def killed(one: LedgerSet, wall_s: float) -> dict[str, Any]:
    """The row of a set whose process was ended from outside."""
    return _row(one, [], "its process was killed; the system may have run out of memory", 0.0, wall_s)


def _row(one: LedgerSet, groups: list[dict[str, Any]], reason: str, cpu_s: float, wall_s: float) -> dict[str, Any]:
    return {
        "name": one.name, "title": one.title, "means": one.truth["means"], "judged": list(one.judged),
        "split": one.split, "reason": reason, "groups": groups, "cpu_s": round(cpu_s, 1),
        "wall_s": round(wall_s, 1), "software": software(),
    }  # fmt: skip


def software() -> dict[str, Any]:
    """Versions, the commit and the machine."""
    head = subprocess.run(
        ["git", "-C", str(ROOT), "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=False
    ).stdout.strip()
    return {
        "commit": head, "python": platform.python_version(), "machine": platform.machine(), "cores": os.cpu_count(),
        **{name: version(name) for name in ("raybundle", "numpy", "scipy")},
    }  # fmt: skip


def write(found: dict[str, Any], folder: Path) -> Path:
    """One file, as a whole or not at all."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{found['name']}.json"
    draft = path.with_suffix(".tmp")
    draft.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    draft.replace(path)
    return path


def read(folder: Path) -> dict[str, dict[str, Any]]:
    """All results of a folder by name."""
    return {p.stem: json.loads(p.read_text(encoding="utf-8")) for p in sorted(folder.glob("*.json"))}


def _cpu() -> float:
    """CPU seconds of this process and of those that it started and that have ended."""
    own, others = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return own.ru_utime + own.ru_stime + others.ru_utime + others.ru_stime
