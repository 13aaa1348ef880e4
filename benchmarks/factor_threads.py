"""Does a second thread of BLAS help to factor normal equations: a sparse network, and full matrices.

    python benchmarks/factor_threads.py

A flight of 2000 photographs with an interior orientation each, and positive definite matrices of 1000 to 5000 unknowns:
seconds and CPU seconds of a factorisation by one thread and by two, best of three.
"""

from __future__ import annotations

import json
import time
from dataclasses import replace

import numpy as np
from scipy.linalg.lapack import dpotrf

from raybundle.adjustment.engine import free_parameters
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system import dense
from raybundle.adjustment.system.assemble import assemble
from raybundle.adjustment.system.normals import Normals
from raybundle.planning.flights.uav_networks import Flight, flight_scene
from raybundle.planning.simulate import Survey, simulate

DAMPING = 1e-4


def network() -> tuple[Normals, np.ndarray]:
    """Normal equations of the flight, and what is added to their diagonal: no datum is given."""
    scene = flight_scene(Flight(lines=40, photographs=50, size=1900.0, points=220))
    block = simulate(scene, Survey(seed=1, points="exact", orientation="exact", interior="exact")).observed
    n = len(block.images)
    own = tuple(replace(block.cameras[0], id=f"k{i}", estimate=("c", "K1", "K2")) for i in range(n))
    block = replace(block, cameras=own, images=replace(block.images, camera=np.arange(n, dtype=np.int32)))
    free = {c.id: free_parameters(c) for c in block.parametrised}
    system = assemble(block, AdjustmentOptions(), np.zeros(len(block.observations), bool), free)
    normals = Normals.of(system, 0)
    normals.reduce(system.initial_state(), damping=DAMPING)
    return normals, DAMPING * normals.diagonal


def best(work) -> dict[str, float]:
    """Wall and CPU seconds of the quickest of three."""
    found = []
    for _ in range(3):
        wall, cpu = time.perf_counter(), time.process_time()
        work()
        found.append((time.perf_counter() - wall, time.process_time() - cpu))
    return dict(zip(("s", "cpu_s"), (round(v, 4) for v in min(found)), strict=True))


def main() -> None:
    """Print the figures as JSON."""
    threads = dense.set_dense_kernels()
    if threads is None:
        print(json.dumps({"absent": ["OpenBLAS behind SciPy"]}))
        return
    normals, added = network()
    rows: dict = {"sparse": {"unknowns": len(normals.right), "meeting": normals.meeting}}
    limit, dense.SMALL = dense.SMALL, 0  # the number of threads is set here
    for count in (1, 2):
        threads.set(count)
        rows["sparse"][f"threads {count}"] = best(lambda: normals.factorise(added))
    dense.SMALL = limit
    for n in (1000, 2000, 5000):
        A = np.random.default_rng(n).random((n, n))
        full = np.asfortranarray((A + A.T) / 2 + n * np.eye(n))
        rows[f"full {n}"] = {}
        for count in (1, 2):
            threads.set(count)
            rows[f"full {n}"][f"threads {count}"] = best(lambda full=full: dpotrf(full, lower=1))
    print(json.dumps(rows, indent=1))


if __name__ == "__main__":
    main()
