"""Precision of flights with RTK, mean of ten seeds: what tests/truth/test_uav_precision.py holds with fewer.

python benchmarks/uav_precision.py [SEEDS]
"""

from __future__ import annotations

import json
import sys

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.numerics.arrays import Array
from raybundle.planning.flights.uav_networks import Flight, flight_block


def adjusted(plan: Flight) -> Adjustment:
    """The flight, adjusted."""
    return adjust_block(flight_block(plan), AdjustmentOptions(jobs=1))


def rms_mm(result: Adjustment) -> Array:
    """(3,) root mean square over the points of the a-priori standard deviations [mm]."""
    assert result.precision is not None
    return 1e3 * np.sqrt(np.mean((result.precision.object_point_std / result.sigma0) ** 2, axis=0))


def main() -> int:
    """Print one JSON object a line; 1 if a figure is outside its limits."""
    seeds = int(sys.argv[1]) if len(sys.argv) > 1 else 10
    good = True
    for name, make, low, high in (
        ("one heading", lambda s: Flight(seed=s), (24, 24, 58), (24, 24, 58)),
        ("headings alternate", lambda s: Flight(seed=s, alternating=True), (14, 16, 57), (14, 16, 57)),
        (
            "and tilted cross strips",
            lambda s: Flight(seed=s, alternating=True, cross_tilt_deg=30.0),
            (8, 8, 8),
            (10, 10, 11),
        ),
    ):
        rms = np.array([rms_mm(adjusted(make(s))) for s in range(1, seeds + 1)])
        mean, spread = rms.mean(axis=0), rms.std(axis=0, ddof=1)
        inside = bool((mean > 0.85 * np.array(low)).all() and (mean < 1.15 * np.array(high)).all())
        good &= inside
        line = {"flight": name, "mean_mm": mean.round(2).tolist(), "sd_of_a_seed_mm": spread.round(2).tolist()}
        print(json.dumps({**line, "expected_mm": [list(low), list(high)], "within_15_percent": inside}))
    for alternating, lost in ((True, {"c"}), (False, {"c", "x0", "y0"})):
        result = adjusted(Flight(alternating=alternating, height_jitter=0.0, angle_jitter_deg=0.0))
        found = {n.split()[0] for n in result.not_determinable}
        good &= found == lost
        print(json.dumps({"flight": f"no jitter, alternating {alternating}", "not_determinable": sorted(found)}))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
