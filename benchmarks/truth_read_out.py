"""Rolling shutters told from photographs: are read-out time and object points as good as stated?

    python benchmarks/truth_read_out.py [--runs 20]

Simulated flights (four strips there and back, 28 photographs, 0.2 px, positions of 2 cm, a read-out of 30 ms, exposures
every 2 s) are adjusted without and with what `workflows.orienting.read_out` finds.  Prints JSON: rms error of the
object points, its mean square in units of the stated covariance, and the read-out times.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.workflows.test_read_out import SECONDS, adjusted, flight, photographs, placed

from raybundle.workflows.orienting.read_out import rolling_shutters


def points(result, truth):
    """Rms error of each coordinate [m], and the mean square in units of the stated covariance."""
    C = result.precision.object_points
    known = np.isfinite(C[:, 0, 0]) & (result.network.rays > 1)
    d = (result.adjusted.points.xyz - truth)[known]
    square = np.einsum("ni,nij,nj->n", d, np.linalg.inv(C[known]), d) / 3
    return np.sqrt(np.mean(d**2, axis=0)), float(square.mean())


def main() -> None:
    """Run, print."""
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("--runs", type=int, default=20)
    found = {"without": [], "with": []}
    times, t = [], []
    for seed in range(1, asked.parse_args().runs + 1):
        block, when = flight(SECONDS, seed=seed)
        truth, block = block.points.xyz, placed(block)
        plain = adjusted(block)
        told = rolling_shutters(plain, block, photographs(when))
        assert told.block is not None
        rolling = adjusted(told.block)
        found["without"].append(points(plain, truth))
        found["with"].append(points(rolling, truth))
        r = next(i.parameters["r"] for i in rolling.interior if i.image is None)
        height = float(told.block.cameras[0].size_mm[1])
        times.append(1000 * r.value * height)
        t.append((r.value * height - SECONDS) / (r.std * height))
    told = {
        name: {
            "points_rms_m": np.mean([p for p, _ in v], axis=0).round(4).tolist(),
            "points_chi_square": round(float(np.mean([c for _, c in v])), 2),
        }
        for name, v in found.items()
    }
    told["read_out_ms"] = {
        "mean": round(float(np.mean(times)), 2),
        "t_rms": round(float(np.sqrt(np.mean(np.square(t)))), 2),
    }
    print(json.dumps(told, indent=1))


if __name__ == "__main__":
    main()
