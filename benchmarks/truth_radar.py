"""The long truth test of radar scenes: 600 adjustments of each block against the stated covariances.

python benchmarks/truth_radar.py [--runs 600] > benchmarks/results/truth_radar.json
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

from truth_bands import Errors, run

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.truth.mixed_blocks import MonteCarlo
from tests.truth.radar_blocks import BLOCKS


def errors_of(name: str) -> Callable[[int], Errors]:
    """The errors of a block as a function of the number of runs."""
    return lambda runs: MonteCarlo.of(BLOCKS[name]()).errors(runs, seed=1)


if __name__ == "__main__":
    sys.exit(run({name: errors_of(name) for name in BLOCKS}, 600))
