"""The long truth tests of mixed sensors: 1000 adjustments of each block against the stated covariances.

python benchmarks/truth_sensors.py [--runs 1000] > benchmarks/results/truth_sensors.json
"""

from __future__ import annotations

import functools
import sys
from collections.abc import Callable
from pathlib import Path

from truth_bands import Errors, run

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.truth.mixed_blocks import MonteCarlo, ikonos_pair, mixed, room, two_camera_rig

BLOCKS = {
    "IKONOS-like pair, one control point, RPC with shift": ikonos_pair,
    "the same, one scene rigorous, RPC with affine bias": functools.partial(ikonos_pair, "affine", ("backward",)),
    "frames, pushbroom, panoramas, RPC": mixed,
    "four panoramas in a room": room,
    "rig of two cameras": two_camera_rig,
}


def errors_of(name: str) -> Callable[[int], Errors]:
    """The errors of a block as a function of the number of runs."""
    return lambda runs: MonteCarlo.of(BLOCKS[name]()).errors(runs, seed=1)


if __name__ == "__main__":
    sys.exit(run({name: errors_of(name) for name in BLOCKS}, 1000))
