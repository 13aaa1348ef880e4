"""Speed against COLMAP's Ceres on the problems of the shared benchmark folder, alternately, in one run.

    python benchmarks/speed.py [--repeat 3] [--problems uav200 ...]

Needs RAYBUNDLE_BENCH (default ../shared/bench) with the generator and the peers' scripts, and a Python that has
pycolmap 4.2.1, pyceres 2.6 and scipy: RAYBUNDLE_PEER_PYTHON (default: this one).  Both sides use 2 threads, start
from the same values with arrays in memory, and are timed with their preprocessing.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
BENCH = Path(os.environ.get("RAYBUNDLE_BENCH", HERE.parents[1] / "shared/bench"))
PEER = os.environ.get("RAYBUNDLE_PEER_PYTHON", sys.executable)
WORK = HERE / "work"
PROBLEMS = {
    "ladybug49": ["bal", str(BENCH / "ladybug-49-7776.txt")],
    "uav200": ["uav", "200", "50000"],
    "uav1000": ["uav", "1000", "180000"],
    "community500": ["community", "500", "150000"],
    "uav500": ["uav", "500", "100000"],
    "uav2000": ["uav", "2000", "300000"],
}
ADJUST = """
import json, resource, sys, time
sys.path.insert(0, {here!r})
from blocks import block_from_npz
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
import scipy.linalg, scipy.stats, scipy.sparse.csgraph
from raybundle.adjustment.system.assemble import assemble
from raybundle.adjustment.system.normals import Normals
from raybundle.adjustment.system.solve import solve
import numpy as np
block = block_from_npz({problem!r})
options = AdjustmentOptions(jobs=2, tolerance={tolerance})
began = time.perf_counter()
system = assemble(block, options, np.zeros(len(block.observations), bool), {{"1": ("c", "k1", "k2")}})
normals = Normals.of(system, 2)
solution = solve(normals, system.initial_state(), options)
wall = time.perf_counter() - began
residuals, flags = normals.residuals(solution.state)
found = np.full((len(block.observations), 2), np.nan)
found[system.rows] = np.stack([(residuals**2).sum(axis=1), flags & 1], axis=1)
np.save({dump!r}, found)
print(json.dumps(dict(wall=wall, diverging=len(solution.beyond), cost=solution.cost, steps=solution.iterations,
      converged=solution.converged, memory_mb=resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)))
"""
PEER_RESIDUALS = """
import sys
import numpy as np
sys.path.insert(0, {bench!r})
import pyceres
from peer_ceres import R, adjuster, to_rec
d = dict(np.load({problem!r}))
rec = to_rec(d)
problem = adjuster(rec).problem
options = pyceres.SolverOptions()
options.num_threads, options.max_num_iterations, options.function_tolerance = 2, 50, 1e-6
options.logging_type = pyceres.LoggingType.SILENT
options.linear_solver_type = pyceres.LinearSolverType.SPARSE_SCHUR
pyceres.solve(options, problem, pyceres.SolverSummary())
matrices = np.array([rec.images[i + 1].cam_from_world().matrix() for i in range(len(d["cam0"]))])
params = np.array([rec.cameras[i + 1].params for i in range(len(d["cam0"]))])
xyz = np.array([rec.points3D[j + 1].xyz for j in range(len(d["pts0"]))])
T, c = matrices[d["ci"]], params[d["ci"]]
x = np.einsum("mij,mj->mi", T[:, :, :3], xyz[d["pi"]]) + T[:, :, 3]
p = x[:, :2] / x[:, 2:]
r2 = (p**2).sum(axis=1)
v = (c[:, 0] * (1 + c[:, 3] * r2 + c[:, 4] * r2**2))[:, None] * p - d["xy"]
np.save({dump!r}, np.stack([(v**2).sum(axis=1), x[:, 2] <= 0], axis=1))
"""
COVARIANCE = """
import json, resource, sys, time
sys.path.insert(0, {here!r})
from blocks import block_from_npz
from raybundle.adjustment.system.assemble import assemble
from raybundle.adjustment.system.datum import analyse, hold_minimal
from raybundle.adjustment.system.normals import Normals
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.precision import cofactors
import numpy as np, scipy.linalg
block = block_from_npz({problem!r}, truth=True)
options = AdjustmentOptions(jobs=2, datum={datum!r})
system = assemble(block, options, np.zeros(len(block.observations), bool), {{"1": ("c", "k1", "k2")}})
state = system.initial_state()
datum = analyse(system, state, options)
system.held = system.control_held | hold_minimal(system, state, datum)
normals = Normals.of(system, 2)
began = time.perf_counter()
normals.reduce(state)
assert normals.solver.factorise(normals.values, np.zeros(0)) == 0
found = cofactors(normals, state, datum)
wall = time.perf_counter() - began
total = float(2 * len(found.hat) - found.hat[:, :2].sum())
print(json.dumps(dict(wall=wall, redundancy=total, expected=system.observations - system.unknowns + datum.defect,
      memory_mb=resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)))
"""


def problem(name: str) -> Path:
    """The npz of a problem, generated once."""
    path = WORK / f"{name}.npz"
    if not path.exists():
        WORK.mkdir(exist_ok=True)
        command = [PEER, str(BENCH / "generate_block.py"), *PROBLEMS[name], str(path)]
        subprocess.run(command, check=True, cwd=WORK, capture_output=True)
    return path


def last_json(command: list[str]) -> dict:
    """The JSON object a command prints last."""
    out = subprocess.run(command, check=True, capture_output=True, text=True, cwd=BENCH).stdout
    return json.loads(out.strip().splitlines()[-1])


def ours(name: str, tolerance: float = 1e-3) -> dict:
    """One adjustment of ours in a process of its own."""
    code = ADJUST.format(here=str(HERE), problem=str(problem(name)), tolerance=tolerance, dump=str(dump(name, "ours")))
    return last_json([sys.executable, "-c", code])


def peer(name: str) -> dict:
    """One run of Ceres."""
    return last_json([PEER, str(BENCH / "peer_ceres.py"), str(problem(name)), "SPARSE_SCHUR", "2"])


def dump(name: str, side: str) -> Path:
    """Where the squared residuals (m,) and the flags of observations behind their camera (m,) of a side are kept."""
    return WORK / f"{name}-{side}.npy"


def same_observations(name: str) -> dict:
    """Observations behind their camera on both sides, and the costs of those that are before it on both.

    ours is that of the last run of `ours`; residuals of the peer are formed anew from its result, in a run of its own.
    """
    code = PEER_RESIDUALS.format(bench=str(BENCH), problem=str(problem(name)), dump=str(dump(name, "peer")))
    subprocess.run([PEER, "-c", code], check=True, capture_output=True, cwd=BENCH)
    a, b = np.load(dump(name, "ours")), np.load(dump(name, "peer"))
    both = (a[:, 1] == 0) & (b[:, 1] == 0)
    return {
        "ours_behind": int(a[:, 1].sum()),
        "ceres_behind": int(b[:, 1].sum()),
        "same_observations": int(both.sum()),
        "ours_cost_of_same": 0.5 * float(a[both, 0].sum()),
        "ceres_cost_of_same": 0.5 * float(b[both, 0].sum()),
    }


def compare(name: str, repeat: int) -> dict:
    """Alternate runs; medians and the median of the pairwise ratios."""
    pairs = [(ours(name), peer(name)) for _ in range(repeat)]
    return {
        "problem": name,
        "ours_s": statistics.median(a["wall"] for a, _ in pairs),
        "ceres_s": statistics.median(b["wall"] for _, b in pairs),
        "ratio": statistics.median(b["wall"] / a["wall"] for a, b in pairs),
        "ours_cost": pairs[0][0]["cost"],
        "ceres_cost": pairs[0][1]["cost1"],
        "cost_excess": pairs[0][0]["cost"] / pairs[0][1]["cost1"] - 1,
        "ours_steps": pairs[0][0]["steps"],
        "ceres_steps": pairs[0][1]["steps"],
        "ours_memory_mb": pairs[0][0]["memory_mb"],
        "ceres_memory_mb": pairs[0][1]["rss_MB"],
        **same_observations(name),
    }


def covariance(name: str, repeat: int) -> dict:
    """All 3 x 3 point covariances and redundancy numbers against pycolmap's covariance."""
    rows = []
    for _ in range(repeat):
        a = {}
        for datum in ("minimal", "auto"):
            code = COVARIANCE.format(here=str(HERE), problem=str(problem(name)), datum=datum)
            a[datum] = last_json([sys.executable, "-c", code])
        b = last_json([PEER, str(BENCH / "peer_covariance.py"), str(problem(name)), "all"])
        rows.append((a, b))
    first, other = rows[0]
    return {
        "problem": name,
        "minimal_datum_s": statistics.median(a["minimal"]["wall"] for a, _ in rows),
        "inner_constraints_s": statistics.median(a["auto"]["wall"] for a, _ in rows),
        "pycolmap_s": statistics.median(b["wall"] for _, b in rows),
        "ratio_minimal": statistics.median(b["wall"] / a["minimal"]["wall"] for a, b in rows),
        "ratio_inner": statistics.median(b["wall"] / a["auto"]["wall"] for a, b in rows),
        "memory_mb": first["auto"]["memory_mb"],
        "pycolmap_memory_mb": other["rss_MB"],
        "redundancy_sum": first["auto"]["redundancy"],
        "redundancy": first["auto"]["expected"],
    }


def growth(repeat: int) -> list[dict]:
    """Time from 200 to 2000 images of the same kind."""
    rows = []
    for name in ("uav200", "uav500", "uav1000", "uav2000"):
        runs = [ours(name) for _ in range(repeat)]
        rows.append({"problem": name, "seconds": statistics.median(r["wall"] for r in runs), "steps": runs[0]["steps"]})
    return rows


def main() -> None:
    """Print and return the figures as JSON."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--repeat", type=int, default=int(os.environ.get("RAYBUNDLE_BENCH_REPEAT", "3")))
    parser.add_argument("--problems", nargs="*", default=["ladybug49", "uav200", "uav1000", "community500"])
    options = parser.parse_args()
    result = {"adjustment": [compare(n, options.repeat) for n in options.problems]}
    if "uav1000" in options.problems:
        result["covariance"] = covariance("uav1000", options.repeat)
        result["growth"] = growth(options.repeat)
    print(json.dumps(result, indent=1))


if __name__ == "__main__":
    main()
