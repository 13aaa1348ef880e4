"""What `raybundle estimate-cost` says beside what an adjustment takes; efficiency of many workers, simulated.

    python benchmarks/scaling.py --columns FOLDER [--record FILE.json] [--orient PROJECT]

--columns  a block as columns (benchmarks/blocking.py --large makes them), adjusted in parts while what each task takes is
           recorded; the estimate for its size stands beside it, with constants that are measured in the same run
--record   the recorded tasks, to be used again, or where they are kept
--orient   a project of `raybundle orient` on a made flight (benchmarks/many_images.py --keep): the stages before

Then the recorded tasks are done by 1 to 256 workers in a simulation: one store of 10 Gbit/s, 1 Gbit/s a worker, 0.5 ms
(benchmarks/simulated_workers.py).  Peak memory is that of the process that adjusts, driver and worker in one.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import tempfile
from dataclasses import asdict
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
from run import machine
from simulated_workers import efficiencies

from raybundle.blocking.columns import InFiles
from raybundle.io.block.arrays import block_of_arrays
from raybundle.pipeline.project import Project
from raybundle.workflows.costs import photographs
from raybundle.workflows.costs.adjustment import NAMES, adjustment, parts_of
from raybundle.workflows.costs.constants import SWEEPS, Constants
from raybundle.workflows.costs.measure import SWEEP_OF, measure, recorded
from raybundle.workflows.costs.stages import Asked

HERE = Path(__file__).resolve().parent
FREE = {"1": ("c", "k1", "k2")}
OVERLAP = 12.5
"""Of the blocks of ../shared/bench/generate_block.py: photographs of 120 m by 80 m each 16 m along and 48 m across"""
SHAPE = 1.8
"""Their longer side over the shorter one"""


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
    sizes = parts_of(a, shape=SHAPE)
    stages = {s.name: s for s in adjustment(a, c, sizes)}
    tasks = {s: sum(r["seconds"] for r in run["records"] if SWEEP_OF[r["name"]] == s) for s in SWEEPS}
    driver = run["CPU s"] - run["cutting s"] - sum(tasks.values())
    share = {s: driver * sum(SWEEP_OF[r["name"]] == s for r in run["records"]) / len(run["records"]) for s in SWEEPS}
    measured = {"cutting": run["cutting s"], **{NAMES[s]: tasks[s] + share[s] for s in SWEEPS}}
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


def before_adjustment(project: Path, c: Constants) -> dict:
    """CPU seconds of the stages before an adjustment, estimated and measured, of a project of `raybundle orient`."""
    opened = Project.open(project, create=False)
    done = {r.name: r for r in opened.stages()}
    opened.close()
    result = json.loads((project / "result/result.json").read_text())
    images, observed = result["images"]["oriented"], result["observations"]
    a = Asked(
        images=images, megapixels=0.75, overlap=OVERLAP, image_points=observed / images, iterations=6, workers=1,
        memory_gb=1.0, network_gbit=0.0, store_gbit=10.0, latency_ms=0.5,
    )  # fmt: skip
    matching = photographs.choice_of_pairs(a, c).cpu_s + photographs.matching(a, c).cpu_s
    estimated = {
        "features": photographs.features(a, c).cpu_s, "matching": matching, "start": photographs.start(a, c).cpu_s,
        "precision": photographs.precision(a, c).cpu_s, "report": photographs.results(a, c).cpu_s,
    }  # fmt: skip
    stages = {n: _pair(s, done[n].cpu_seconds) for n, s in estimated.items()}
    return {"photographs": images, "image points": observed, "stages": stages}


def main() -> None:
    """Measure, and write the results."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--columns", type=Path, default=HERE / "work/blocking/columns10000")
    parser.add_argument("--leaf", type=int, default=1000)
    parser.add_argument("--record", type=Path)
    parser.add_argument("--orient", type=Path)
    given = parser.parse_args()
    constants = measure()
    if given.record and given.record.exists():
        run = json.loads(given.record.read_text())
    else:
        run = record(given.columns, given.leaf)
        if given.record:
            given.record.write_text(json.dumps(run))
    out = HERE / "results/scaling.json"
    results = json.loads(out.read_text()) if out.exists() else {}
    results |= {"machine": machine(), "constants": asdict(constants)}
    results[f"adjustment of {run['images']}"] = beside(run, constants)
    results[f"workers, from the tasks of {run['images']}"] = efficiencies(run, asked(run), constants)
    if given.orient:
        results["stages before"] = before_adjustment(given.orient, constants)
    out.write_text(json.dumps(results, indent=1) + "\n")


if __name__ == "__main__":
    main()
