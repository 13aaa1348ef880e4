"""Time of `fit_rpc` by the number of threads of BLAS: its QR decompositions in one piece, or by blocks of rows.

Run: python benchmarks/rpc_fit_threads.py          a process for each
"""

import json
import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from raybundle.scenes import rpc_fit


def one(how):
    """Seconds of the second of two fits of a scene of 0.7 s from 617 km."""
    from tests.scenes.conftest import make_scene

    scene = make_scene()
    if how == "one piece":
        rpc_fit.triangle = lambda A: np.asarray(np.linalg.qr(A, mode="r"))
    for _ in range(2):
        wall, cpu = time.perf_counter(), time.process_time()
        fit = rpc_fit.fit_rpc(scene.localise, (scene.width_px, scene.height_px), (-100.0, 900.0))
        found = {"s": time.perf_counter() - wall, "CPU s": time.process_time() - cpu}
    print(json.dumps({**found, "rms px": fit.rms_px.max()}))


def main():
    """Both ways with 1, 2 and 16 threads."""
    for threads in ("1", "2", "16"):
        for how in ("one piece", "blocks"):
            environment = {**os.environ, "OPENBLAS_NUM_THREADS": threads}
            out = subprocess.run(
                [sys.executable, __file__, how], check=True, capture_output=True, text=True, env=environment
            )
            row = {k: round(v, 4) for k, v in json.loads(out.stdout).items()}
            print(f"threads {threads:>2}, {how}: {row}")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        one(sys.argv[1])
    else:
        main()
