"""What `raybundle estimate-cost` says beside what an adjustment takes; efficiency of many workers, simulated.

    python benchmarks/scaling.py --columns FOLDER [--record FILE.json] [--orient FILE.json [--ship]]

--columns  a block as columns (benchmarks/blocking.py --large makes them), adjusted in parts while what each task takes
           is recorded; the estimate for its size stands beside it, with constants that are measured in the same run
--record   the recorded tasks, to be used again, or where they are kept
--orient   figures of a made flight, as benchmarks/many_images.py --strips 8 --each 10 prints them: the stages before
--ship     with all of these and benchmarks/results/stage_shares.json (benchmarks/stage_shares.py), write the constants
           that come with the package

Then the recorded tasks are done by 1 to 256 workers in a simulation: one store of 10 Gbit/s, 1 Gbit/s a worker, 0.5 ms
(benchmarks/simulated_workers.py).  Peak memory is that of the process that adjusts, driver and worker in one.
"""

from __future__ import annotations

import argparse
import datetime as dt
import json
import os
import tempfile
from dataclasses import asdict, replace
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import msgspec
import numpy as np
from run import machine
from runs import peak_mb
from simulated_workers import efficiencies

from raybundle.blocking.columns import InFiles
from raybundle.io.block.arrays import block_of_arrays
from raybundle.workflows.costs import photographs
from raybundle.workflows.costs.adjustment import KINDS, NAMES, adjustment, kept_elements, parts_of
from raybundle.workflows.costs.constants import SWEEPS, Constants
from raybundle.workflows.costs.measure import SWEEP_OF, Fronts, measure, recorded, sweep_of
from raybundle.workflows.costs.recording import TaskRecord
from raybundle.workflows.costs.stages import Asked

HERE = Path(__file__).resolve().parent
FREE = {"1": ("c", "k1", "k2")}
OVERLAP = 12.5
"""Of the blocks of ../shared/bench/generate_block.py: photographs of 120 m by 80 m each 16 m along and 48 m across"""
SOURCES = HERE.parent / "src/raybundle/workflows/costs"
PROJECT_MPX = 0.75
"""Of the photographs of benchmarks/many_images.py"""
MEMORY = {
    "base_mb": 120.0,
    "driver_point": 50.0,
    "part_point": 250.0,
    "start_point": 1000.0,
    "start_image": 130e3,
    "decisions_point": 2000.0,
    "decisions_image": 400e3,
    "precision_point": 2500.0,
    "report_point": 3000.0,
}
"""Memory, read off peaks: driver, of 1.5 and 11.4 million image points before the first sweep; start and precision, of
made flights of 80 and 300 photographs, 1200 and 1200, 1900 and 2500 bytes an image point; the report of the first
alone; a part, as `blocking.normals` says of its tasks"""
FITTED = {
    "start_point_ms": 0.08, "start_image_ms": 31.0, "decisions_point_ms": 0.11, "decisions_image_ms": 21.0,
    "report_image_ms": 2.8,
}  # fmt: skip
"""To the records of benchmarks/results/stages_at_size.json and many_images.json, and to the flight of 80 photographs"""
REPORT = {"report_point_ms": 0.0245, "result_point": 302.0}
"""Of the flight of 80 photographs, whose report is written after its figures: 6.4 CPU s, 79 MB"""
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
        "peak MB": peak_mb(),
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
    told = {
        n: {"estimated s": stages[n].cpu_s, "measured s": m, "ratio": stages[n].cpu_s / m} for n, m in measured.items()
    }
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


def walls(run: dict, c: Constants, simulated: dict) -> dict:
    """Wall time of the recorded run by so many workers of other machines: as estimated, and as simulated."""
    found = {}
    for workers, of in simulated.items():
        a = asked(run, int(workers))
        estimated = sum(s.wall_s for s in adjustment(a, c, parts_of(a, shape=SHAPE)))
        if a.workers > 1:  # one worker is estimated as on the machine of the store
            found[workers] = _pair(estimated, of["with the driver s"])
    return found


def before_adjustment(flight: dict, c: Constants) -> dict:
    """CPU seconds of the stages before an adjustment, estimated and measured, of a made flight."""
    images, observed = flight["oriented"], flight["observations"] / 2
    a = Asked(
        images=images, megapixels=PROJECT_MPX, overlap=OVERLAP, image_points=observed / images, iterations=6, workers=1,
        memory_gb=1.0, network_gbit=0.0, store_gbit=10.0, latency_ms=0.5,
    )  # fmt: skip
    matching = photographs.choice_of_pairs(a, c).cpu_s + photographs.matching(a, c).cpu_s
    estimated = {
        "features": photographs.features(a, c).cpu_s, "matching": matching, "start": photographs.start(a, c).cpu_s,
        "precision": photographs.precision(a, c).cpu_s,
        "adjustment": photographs.decisions(a, c).cpu_s + sum(s.cpu_s for s in adjustment(a, c, parts_of(a))),
    }  # fmt: skip
    stages = {
        s["name"]: _pair(estimated[s["name"]], s["cpu_seconds"]) for s in flight["stages"] if s["name"] in estimated
    }
    return {"photographs": images, "image points": observed, "stages": stages}


def shipped(run: dict, flight: dict, measured: Constants) -> Constants:
    """The constants that come with the package: those measured, bytes of a recorded run, stages of a made flight."""
    size, own, points = (np.array(run[k], float) for k in ("size", "own", "counts"))
    fronts = Fronts(own=own, size=size, points=points)
    dense = 8 * sum(float(x.sum()) for x in kept_elements(own, size - own))
    sweeps = {}
    for sweep, tasks in KINDS.items():
        mine = [TaskRecord(**r) for r in run["records"] if SWEEP_OF[r["name"]] == sweep]
        of = sweep_of(mine, fronts, sweep, operation_ns=0.0, element_ns=0.0, tasks=tasks)
        names = ("read_point", "read_element", "written_point", "written_element")
        sweeps[sweep] = replace(getattr(measured, sweep), **{n: getattr(of, n) for n in names})
    done = {s["name"]: s["cpu_seconds"] for s in flight["stages"]}
    shares = json.loads((HERE / "results/stage_shares.json").read_text())
    observed, images = flight["observations"] / 2, flight["oriented"]
    pairs = photographs.pairs_of(images)
    chosen = images * (measured.signature_s + 1e-3 * measured.compare_ms * photographs.COMPARED)
    features = photographs.features_of(PROJECT_MPX)
    verified = done["matching"] - chosen - pairs * measured.nearest_s * (features / 1000) ** 2
    return replace(
        measured, **sweeps, measured=f"{dt.datetime.now(dt.UTC).date().isoformat()}, by benchmarks/scaling.py",
        stored_point=float((run["disk"] - dense) / points.sum()), verify_ms=1e6 * verified / pairs / features,
        precision_point_ms=1e3 * done["precision"] / observed,
        start_shared=round(shares["start"]["share"], 3), precision_shared=round(shares["precision"]["share"], 3),
        **MEMORY, **REPORT, **FITTED,
    )  # fmt: skip


def main() -> None:
    """Measure, and write the results."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--columns", type=Path, default=HERE / "work/blocking/columns10000")
    parser.add_argument("--leaf", type=int, default=1000)
    parser.add_argument("--record", type=Path)
    parser.add_argument("--orient", type=Path)
    parser.add_argument("--ship", action="store_true", help="write the constants that come with the package")
    given = parser.parse_args()
    if given.record and given.record.exists():
        run = json.loads(given.record.read_text())
    else:
        run = record(given.columns, given.leaf)
        if given.record:
            given.record.write_text(json.dumps(run))
    flight = json.loads(given.orient.read_text())["many_images"] if given.orient else None
    if given.ship and flight:
        found = msgspec.json.format(msgspec.json.encode(shipped(run, flight, measure())), indent=1)
        (SOURCES / "constants.json").write_bytes(found + b"\n")
        return
    constants = measure()
    out = HERE / "results/scaling.json"
    results = json.loads(out.read_text()) if out.exists() else {}
    results |= {"machine": machine(), "constants": asdict(constants)}
    results[f"adjustment of {run['images']}"] = beside(run, constants)
    found = efficiencies(run, asked(run), constants)
    results[f"workers, from the tasks of {run['images']}"] = found
    results[f"wall time of {run['images']}"] = walls(run, constants, found["the recorded run"])
    if flight:
        results["stages before"] = before_adjustment(flight, constants)
    out.write_text(json.dumps(results, indent=1) + "\n")


if __name__ == "__main__":
    main()
