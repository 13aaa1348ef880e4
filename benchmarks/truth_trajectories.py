"""The long truth tests of trajectories: adjustments of each block against the stated covariances.

python benchmarks/truth_trajectories.py [--runs 200] > benchmarks/results/truth_trajectories.json
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

from truth_bands import Errors, run

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.adjustment.test_attitudes import Carried, flight
from tests.scenes.test_airborne import strips
from tests.scenes.test_corrections import FIXES, SIGMA, pair

from raybundle.planning.simulate import measured
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


def errors_of(name: str) -> Callable[[int], Errors]:
    """The errors of a block as a function of the number of runs."""
    return lambda runs: Carried.of(BLOCKS[name]()).errors(runs, seed=1)


if __name__ == "__main__":
    sys.exit(run({name: errors_of(name) for name in BLOCKS}, 200))
