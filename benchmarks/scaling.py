"""What `raybundle estimate-cost` says beside what an adjustment takes; efficiency of many workers, simulated.

    python benchmarks/scaling.py [--columns FOLDER] [--record FILE.json] [--simulate] [--ship]

--columns   a block as columns (benchmarks/blocking.py --large makes them), adjusted in parts with what each task took;
            the estimate for its size stands beside it, with constants that are measured in the same run
--record    where the tasks of that run are kept, or read from where they stand there
--simulate  workers from 1 to 256 on the recorded tasks: one store of 10 Gbit/s, 1 Gbit/s a worker, 0.5 ms
--ship      measure the constants that come with the package, after the runs of `raybundle orient` in --orient
Peak memory is that of the process that adjusts, which is driver and worker in one.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
from dataclasses import asdict, replace
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
import store_line
from run import machine

from raybundle.blocking.columns import InFiles
from raybundle.io.block.arrays import block_of_arrays
from raybundle.workflows.costs import constants as kept
from raybundle.workflows.costs.adjustment import adjustment, parts_of
from raybundle.workflows.costs.constants import SWEEPS, Constants
from raybundle.workflows.costs.measure import SWEEP_OF, measure, recorded
from raybundle.workflows.costs.stages import Asked

HERE = Path(__file__).resolve().parent
FREE = {"1": ("c", "k1", "k2")}
OVERLAP = 12.5
"""Of the blocks of ../shared/bench/generate_block.py: photographs of 120 m by 80 m each 16 m along and 48 m across"""
SHAPE = 1.8 / 1.0 * 48 / 48
"""Their longer side over the shorter one, in images of equal area"""


def record(columns: Path, leaf: int) -> dict:
    """An adjustment in parts with what each of its tasks took."""
    with np.load(columns / "bare.npz") as f:
        bare = block_of_arrays(dict(f))
    with tempfile.TemporaryDirectory(dir=columns.parent) as folder:
        of = recorded(InFiles(bare, columns), FREE, leaf, Path(folder) / "store")
    network = of.found.network
    return {
        "images": len(bare.images), "image points": int(network.counts.sum()), "object points": of.points,
        "iterations": of.found.iterations, "CPU s": of.seconds, "cutting s": of.cutting_s, "disk": of.disk,
        "peak MB": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
        "parent": network.tree.parent.tolist(), "own": [f.columns for f in network.fronts],
        "size": [f.size for f in network.fronts], "counts": network.counts.tolist(),
        "records": [asdict(r) for r in of.records],
    }  # fmt: skip


def asked(run: dict, workers: int = 1) -> Asked:
    """The size of a recorded run."""
    return Asked(
        images=run["images"], megapixels=6.0, overlap=OVERLAP, image_points=run["image points"] / run["images"],
        iterations=run["iterations"], workers=workers, memory_gb=1.0, network_gbit=1.0, store_gbit=10.0,
        latency_ms=0.5,
    )  # fmt: skip


def beside(run: dict, c: Constants) -> dict:
    """Estimate and measurement, stage by stage."""
    a = asked(run)
    sizes = parts_of(a)
    stages = {s.name: s for s in adjustment(a, c, sizes)}
    tasks = {s: sum(r["seconds"] for r in run["records"] if SWEEP_OF[r["name"]] == s) for s in SWEEPS}
    driver = run["CPU s"] - run["cutting s"] - sum(tasks.values())
    share = {s: driver * sum(SWEEP_OF[r["name"]] == s for r in run["records"]) / len(run["records"]) for s in SWEEPS}
    names = {"up": "reduction up", "down": "solution down", "covariances": "covariances", "statistics": "statistics"}
    measured = {"cutting": run["cutting s"], **{names[s]: tasks[s] + share[s] for s in SWEEPS}}
    size = np.array(run["size"])
    told = {n: {"estimated s": stages[n].cpu_s, "measured s": m, "ratio": stages[n].cpu_s / m} for n, m in measured.items()}
    cpu = sum(s.cpu_s for s in stages.values())
    peak = max(s.memory_mb for s in stages.values())
    disk = sum(s.disk_gb for s in stages.values())
    moved = sum(r["read"] + r["written"] for r in run["records"]) / 1e9
    moved_estimated = sum(s.moved_gb for n, s in stages.items() if n != "cutting")
    return {
        "images": run["images"], "image points": run["image points"], "iterations": run["iterations"], "stages": told,
        "CPU s": _pair(cpu, run["CPU s"]), "peak MB": _pair(peak, run["peak MB"]),
        "disk GB": _pair(disk, run["disk"] / 1e9), "moved GB": _pair(moved_estimated, moved),
        "leaves": _pair(sum(s.count for s in sizes if s.leaf), _leaves(run)),
        "largest front": _pair(max(s.columns + s.rows for s in sizes), int(size.max())),
    }  # fmt: skip


def _pair(estimated: float, measured: float) -> dict:
    return {"estimated": estimated, "measured": measured, "ratio": estimated / measured}


def _leaves(run: dict) -> int:
    return len(run["parent"]) - len({p for p in run["parent"] if p >= 0})


# -- many workers


def jobs_of(run: dict) -> list[list[Job]]:
    """The tasks of a run, a list for each sweep: the driver waits for the last task of one before the next."""
    sweeps: list[list[dict]] = []
    for r in run["records"]:
        if not sweeps or sweeps[-1][0]["name"] != r["name"] or any(r["node"] == q["node"] for q in sweeps[-1]):
            sweeps.append([])
        sweeps[-1].append(r)
    found = []
    for sweep in sweeps:
        at = {r["key"]: k for k, r in enumerate(sweep)}
        found.append([
            Job(seconds=r["seconds"], read=r["read"], written=r["written"],
                waits=tuple(at[key] for key in r["inputs"] if key in at))
            for r in sweep
        ])  # fmt: skip
    return found


@dataclass(frozen=True)
class Kind:
    """The tasks of one kind: of leaves as they were recorded, of separators by constants fitted to them."""

    sweep: str
    leaves: list[dict]
    fitted: Sweep


def kinds_of(run: dict, rates: dict[str, float]) -> dict[str, Kind]:
    """By the name of the function."""
    fronts = Fronts(own=np.array(run["own"], float), size=np.array(run["size"], float), points=np.array(run["counts"], float))
    above = {p for p in run["parent"] if p >= 0}
    found = {}
    for name, sweep in SWEEP_OF.items():
        mine = [r for r in run["records"] if r["name"] == name]
        if not mine:
            continue
        dense = sweep if name in {"up", "inverse"} else "none"
        one = [TaskRecord(**r) for r in mine]
        whole = sweep_of(one, fronts, sweep if dense == sweep else "none", rates.get(sweep, 0.0))
        found[name] = Kind(sweep, [r for r in mine if r["node"] not in above], whole)
    return found


def tree_of(sizes: tuple[Size, ...]) -> list[tuple[int, int]]:
    """Size and parent of each tree node of a flight, the root first."""
    found: list[tuple[int, int]] = [(0, -1)]
    k = 0
    while k < len(found):
        found += [(half, k) for half in sizes[found[k][0]].halves]
        k += 1
    return found


def synthetic(run: dict, kinds: dict[str, Kind], images: int, threads: float) -> list[list[Job]]:
    """The sweeps of a flight of so many images with the image points of the run.

    threads  by which fronts above the leaves are eliminated; 1: as it is
    """
    a = replace(asked(run), images=images)
    sizes = parts_of(a)
    tree = tree_of(sizes)
    below: list[list[int]] = [[] for _ in tree]
    for k, (_, parent) in enumerate(tree):
        if parent >= 0:
            below[parent].append(k)
    rng = np.random.default_rng(1)
    names = [s[0]["name"] for s in _sweeps(run)]
    found = []
    for name in names:
        kind = kinds[name]
        upwards = name in {"up", "right_up"}
        downwards = name in {"down", "inverse", "right_down"}
        order = range(len(tree) - 1, -1, -1) if upwards else range(len(tree))
        at = {k: place for place, k in enumerate(order)}
        jobs = []
        for k in order:
            size = sizes[tree[k][0]]
            waits = tuple(at[c] for c in below[k]) if upwards else (at[tree[k][1]],) if downwards and k else ()
            if size.leaf and name != "right_down":
                r = kind.leaves[int(rng.integers(len(kind.leaves)))]
                jobs.append(Job(seconds=r["seconds"], read=r["read"], written=r["written"], waits=waits))
            else:
                w = task_of(size, kind.sweep if name in {"up", "inverse"} else "none", kind.fitted)
                jobs.append(Job(seconds=w.cpu_s / KINDS_OF(kind, threads), read=w.read, written=w.written, waits=waits))
        found.append(jobs)
    return found
