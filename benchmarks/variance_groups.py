"""How true the standard deviation of a length is that a scale bar carries, where image points are wrongly weighted.

python benchmarks/variance_groups.py [RUNS]

A testfield with one scale bar of 0.2 mm; the standard deviation of image points is stated twice as large as their
errors are.  The error of the length over the whole field is held against what the adjustment states of it: with one
variance factor for all observations, and with factors of groups.
"""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

import raybundle as rb
from raybundle.block import Block
from raybundle.measuring.joint import Joint
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene

OUT = Path(__file__).with_name("results") / "variance_groups.json"
ENDS = "1", "30"
STATED = 2.0


def length(block: Block) -> tuple[float, np.ndarray]:
    """The length between the ends, and its derivatives (6,)."""
    a, b = (block.points.xyz[block.points.ids.index(name)] for name in ENDS)
    across = float(np.linalg.norm(a - b))
    return across, np.concatenate([a - b, b - a]) / across


def main(runs: int = 200) -> None:
    """Draw, adjust, print and write."""
    ratio: dict[bool, list[float]] = {False: [], True: []}
    survey = Survey(image_sigma_px=0.1, scale_bars=1, scale_bar_sigma=2e-4, interior="exact")
    for seed in range(runs):
        drawn = simulate(field_scene(TargetField(rows=5, columns=6, stations=8)), replace(survey, seed=seed))
        o = drawn.observed.observations
        block = replace(drawn.observed, observations=replace(o, cov_px2=STATED**2 * o.cov_px2))
        true, _ = length(drawn.truth)
        for groups, found in ratio.items():
            options = rb.AdjustmentOptions(variance_groups=groups, jobs=1, noise="white")
            result = rb.adjust(block, options)
            met, J = length(result.adjusted)
            C = Joint.of(result).of_points([result.adjusted.points.ids.index(name) for name in ENDS])
            found.append((met - true) / float(np.sqrt(J @ C @ J)))
    told = {
        "runs": runs, "stated_over_true_sigma_of_image_points": STATED,
        "rms_of_error_over_stated_one_factor": float(np.sqrt(np.mean(np.square(ratio[False])))),
        "rms_of_error_over_stated_groups": float(np.sqrt(np.mean(np.square(ratio[True])))),
    }  # fmt: skip
    print(json.dumps(told, indent=1))
    OUT.write_text(json.dumps(told, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    with threadpool_limits(1):
        main(*map(int, sys.argv[1:]))
