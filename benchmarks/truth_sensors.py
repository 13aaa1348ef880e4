"""The long truth tests of mixed sensors: 1000 adjustments of each block against the stated covariances.

python benchmarks/truth_sensors.py [--runs 1000] > benchmarks/results/truth_sensors.json
"""

from __future__ import annotations

import argparse
import functools
import json
import sys
from pathlib import Path

import numpy as np
from scipy.stats import chi2, kstest

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.truth.mixed_blocks import MonteCarlo, ikonos_pair, mixed, room, two_camera_rig

BLOCKS = {
    "IKONOS-like pair, one control point, RPC with shift": ikonos_pair,
    "the same, one scene rigorous, RPC with affine bias": functools.partial(ikonos_pair, "affine", ("backward",)),
    "frames, pushbroom, panoramas, RPC": mixed,
    "four panoramas in a room": room,
    "rig of two cameras": two_camera_rig,
}


def figures(name: str, runs: int) -> list[dict]:
    """Each kind of unknown: the sum of the normalised squared errors against the 99.9 % band of chi-square."""
    rows = []
    for kind, (d2, degrees) in MonteCarlo.of(BLOCKS[name]()).errors(runs, seed=1).items():
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
    parser.add_argument("--runs", type=int, default=1000)
    runs = parser.parse_args().runs
    rows = [row for name in BLOCKS for row in figures(name, runs)]
    print(json.dumps(rows, indent=1))
    return int(not all(row["inside"] for row in rows))


if __name__ == "__main__":
    sys.exit(main())
