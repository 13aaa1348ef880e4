"""The long truth test of lines that share a trajectory: 600 adjustments against the stated covariances.

python benchmarks/truth_lines.py [--runs 600] > benchmarks/results/truth_lines.json

Two strips of an ADS-like camera (lines at +27, 0, -14 degrees) with GNSS and INS; the same with one trajectory for each
line.  Beside the bands stand the standard deviations of points and the unknowns.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

from truth_bands import Errors, run

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.truth.mixed_blocks import MonteCarlo
from tests.truth.three_lines import Plan, three_line_block

BLOCKS = {
    "three lines, one trajectory a strip": Plan(),
    "three lines, a trajectory each": Plan(together=False),
    "one strip of three lines": Plan(headings=(80.0,)),
}


def errors_of(plan: Plan) -> Callable[[int], Errors]:
    """The errors of a block as a function of the number of runs."""

    def errors(runs: int) -> Errors:
        with tempfile.TemporaryDirectory() as folder:
            return MonteCarlo.of(three_line_block(Path(folder) / "block", plan)).errors(runs, seed=1)

    return errors


if __name__ == "__main__":
    sys.exit(run({name: errors_of(plan) for name, plan in BLOCKS.items()}, 600))
