"""A command run by itself: wall time, CPU seconds and peak memory of it and its children; errors against a truth."""

from __future__ import annotations

import math
import os
import signal
import subprocess
import tempfile
import threading
import time
from pathlib import Path

import numpy as np


def measured(
    command: list[str], *, cpus: int = 2, environment: dict[str, str] | None = None, may_fail: bool = False,
    limit_s: float = math.inf,
) -> dict:  # fmt: skip
    """Run a command on so many processors; its output, exit status and what it took.

    Of peak memory no less is told than this process has itself.
    Raises RuntimeError where it fails and may not; after `limit_s` seconds it is interrupted, then killed.  Modules may
    be kept compiled, as where somebody installed them: else each run of either side would compile its own again.
    """
    here = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    allowed = set(sorted(os.sched_getaffinity(0))[:cpus])
    threads = {name: str(cpus) for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")}
    with tempfile.TemporaryFile("w+") as out, tempfile.TemporaryFile("w+") as err:
        began = time.perf_counter()
        running = subprocess.Popen(
            command, stdout=out, stderr=err, env={**here, **threads, **(environment or {})},
            preexec_fn=lambda: os.sched_setaffinity(0, allowed),  # noqa: PLW1509  (one thread here)
        )  # fmt: skip
        stops = [
            threading.Timer(limit_s + more, running.send_signal, [kind])
            for more, kind in ((0, signal.SIGINT), (30, signal.SIGKILL))
            if limit_s < math.inf
        ]
        for stop in stops:
            stop.start()
        _, status, usage = os.wait4(running.pid, 0)
        for stop in stops:
            stop.cancel()
        wall = time.perf_counter() - began
        running.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        err.seek(0)
        if running.returncode and not may_fail:
            raise RuntimeError(f"{' '.join(command)} ended with {running.returncode}\n{err.read()[-2000:]}")
        return {
            "output": out.read(),
            "errors": err.read(),
            "status": running.returncode,
            "wall_s": wall,
            "cpu_s": usage.ru_utime + usage.ru_stime,
            "memory_mb": usage.ru_maxrss / 1024,
        }


def peak_mb(pid: int | str = "self", *, anew: bool = False) -> float:
    """Peak memory of a process since it was last asked anew; NaN where the system does not tell.

    What `getrusage` says of a process that another one started counts that other one's memory, too.
    """
    folder = Path("/proc") / str(pid)
    try:
        if anew:
            (folder / "clear_refs").write_text("5")
        status = (folder / "status").read_text()
    except OSError:
        return math.nan
    return int(status.split("VmHWM:")[1].split()[0]) / 1024


def similarity(source: np.ndarray, target: np.ndarray) -> tuple[float, np.ndarray, np.ndarray]:
    """Scale, rotation and shift, target_from_source (Umeyama 1991)."""
    a, b = source - source.mean(axis=0), target - target.mean(axis=0)
    u, d, vt = np.linalg.svd(b.T @ a)
    turn = np.diag([1, 1, np.sign(np.linalg.det(u @ vt))])
    R = u @ turn @ vt
    m = float((d * np.diag(turn)).sum() / (a**2).sum())
    return m, R, target.mean(axis=0) - m * R @ source.mean(axis=0)


def errors(images: dict[str, dict], truth: dict[str, dict]) -> dict:
    """Errors of centres after a similarity, and of directions, over the images that both have.

    images, truth  name -> centre (3), rotation (3, 3) object to camera, both of one camera frame
    """
    names = sorted(set(images) & set(truth))
    if len(names) < 3:
        return {}
    found = np.array([images[n]["centre"] for n in names])
    known = np.array([truth[n]["centre"] for n in names])
    m, R, t = similarity(found, known)
    apart = m * found @ R.T + t - known
    turned = np.array([images[n]["rotation"] for n in names]) @ R.T
    beside = turned @ np.array([truth[n]["rotation"] for n in names]).transpose(0, 2, 1)
    angle = np.degrees(np.arccos(np.clip((np.trace(beside, axis1=1, axis2=2) - 1) / 2, -1, 1)))
    return {
        "compared": len(names),
        "centres_rms_mm": 1000 * float(np.sqrt((apart**2).sum(axis=1).mean())),
        "angles_mean_deg": float(angle.mean()),
    }


def of_block(folder: Path) -> dict[str, dict]:
    """The images of a block folder, rotations as computer vision has them: y down, z forward."""
    from raybundle.io.block.folder import read_block

    images = read_block(folder).images
    down = np.diag([1.0, -1.0, -1.0])
    return {
        name: {"centre": c.tolist(), "rotation": (down @ R).tolist()}
        for name, c, R in zip(images.file, images.centre, images.rotation, strict=True)
        if np.isfinite(c).all()
    }
