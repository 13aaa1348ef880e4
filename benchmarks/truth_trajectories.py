"""The long truth tests of trajectories: adjustments of each block against the stated covariances.

python benchmarks/truth_trajectories.py [--runs 200] > benchmarks/results/truth_trajectories.json
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from pathlib import Path

import numpy as np
from scipy.stats import chi2, kstest

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.adjustment.test_attitudes import Carried, flight
from tests.scenes.test_airborne import strips
from tests.scenes.test_corrections import FIXES, SIGMA, pair

from raybundle.block.simulate import measured
from raybundle.scenes.corrections import Fixes, Pieces
from raybundle.scenes.trajectory import CorrectionModel

ARM = ("ax", "ay", "az")
SPLINE = CorrectionModel(position_degree=0, attitude_curve=Pieces(count=4))
STRIP = CorrectionModel(
    position_curve=Fixes(count=3), attitude_degree=0, attitude_curve=Fixes(count=5), time_offset=True
)
BLOCKS = {
    "satellite pair, attitude fixes": lambda: pair(FIXES, SIGMA, points=40),
    "satellite pair, attitude spline": lambda: pair(
        SPLINE, {"rx": 5e-6, "ry": 5e-6, "rz": 5e-5, **dict.fromkeys(("along0", "across0", "up0"), 2.0)}, points=40
    ),
    "aerial strips: drift, boresight, clock": lambda: measured(strips(Path(tempfile.mkdtemp()), STRIP), 0.3),
    "photographs: boresight": flight,
    "photographs: boresight, lever arm, clock": lambda: flight(
        clock=("dt",), arm=ARM, arm_sigma=dict.fromkeys(ARM, 0.05)
    ),
    "photographs: boresight, no control": lambda: flight(control=0, boresight_sigma={"bz": 1e-3}),
}


def figures(name: str, runs: int) -> list[dict]:
    """Each kind of unknown: the sum of the normalised squared errors against the 99.9 % band of chi-square."""
    rows = []
    for kind, (d2, degrees) in Carried.of(BLOCKS[name]()).errors(runs, seed=1).items():
        low, high = chi2(degrees * len(d2)).interval(0.999)
        rows.append(
            {
                "block": name, "unknowns": kind, "runs": len(d2), "degrees": degrees,
                "mean_over_degrees": float(np.mean(d2) / degrees), "sum": float(d2.sum()), "low": float(low),
                "high": float(high), "inside": bool(low < d2.sum() < high),
                "ks_p": float(kstest(d2, chi2(degrees).cdf).pvalue),
            }
        )  # fmt: skip
    return rows


def main() -> int:
    """Print the figures as JSON; 1 if one of them lies outside its band."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--runs", type=int, default=200)
    runs = parser.parse_args().runs
    rows = [row for name in BLOCKS for row in figures(name, runs)]
    print(json.dumps(rows, indent=1))
    return int(not all(row["inside"] for row in rows))


if __name__ == "__main__":
    sys.exit(main())
