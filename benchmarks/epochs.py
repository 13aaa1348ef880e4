"""What moved between three dates of simulated networks: found as often as computed beforehand, false alarms as stated.

python benchmarks/epochs.py [SECONDS]

Each network is simulated, tested and adjusted as `raybundle epochs` does after orientation.  Points move by 0.5 to 20
standard deviations, each in its own direction, or a connected part as one piece.
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
from scipy.stats import binom, norm
from threadpoolctl import threadpool_limits

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.workflows.dated_network import Plan, network

from raybundle.metrology.congruence import SIGNIFICANCE
from raybundle.workflows.epochs.movements import movements

OUT = Path(__file__).with_name("results") / "epochs.json"
CASES = (("none", 0.0, False), ("20 %", 0.2, False), ("45 %", 0.45, False), ("45 % as one piece", 0.45, True))
SIZES, FIRST, BAND = (0.5, 20.0), 1000, 0.999
"""Displacements in standard deviations; first seed; probability of the bands"""


def main(seconds: float = 900.0) -> None:
    """Draw, test, print and write; so many CPU seconds, as many for each case."""
    plan, every = Plan(), {}
    for name, share, piece in CASES:
        every[name] = case(plan, seconds / len(CASES), share, piece=piece)
        print(name, json.dumps(every[name]), flush=True)
    OUT.write_text(json.dumps(every, indent=1) + "\n", encoding="utf-8")


def case(plan: Plan, seconds: float, share: float, *, piece: bool) -> dict[str, Any]:
    """Counts of one case.

    A false alarm is a stable point that is called moved, or an area without any moved point that is.  What is called
    `moved_area` is not called moved: stable points in an area with moved ones are counted for themselves.
    """
    n, place = len(plan.ids), {i: k for k, i in enumerate(plan.ids)}
    found = expected = variance = apart = untested = 0.0
    alarms = runs = 0
    chi: list[float] = []
    began = time.process_time()
    seed = FIRST - 1
    while time.process_time() - began < seconds:
        seed += 1
        rng = np.random.default_rng(seed)
        count = int(share * n)
        which = rng.choice(n, count, replace=False)
        sizes, ways = rng.uniform(*SIZES, count), list(rng.normal(size=(count, 2, 3)))
        if piece:
            way = rng.normal(size=2)
            which = np.argsort(plan.xyz[:, :2] @ way)[:count]
            sizes, ways = np.full(count, rng.uniform(*SIZES)), [np.outer([0.5, 1.0], rng.normal(size=3))] * count
        truth, power = plan.drawn(which, sizes, ways) if count else (np.zeros((2, n, 3)), np.zeros(0))
        block, dates = network(seed, plan.moves(truth))
        m = movements(block, dates)
        c = m.stability.congruence
        moved = np.zeros(n, bool)
        moved[which] = True
        if c.ids != plan.ids or c.in_area is None:
            continue
        runs += 1
        areas = any(a.moved and not moved[a.points].any() for a in c.areas)
        alarms += bool((c.moved & ~c.in_area & ~moved).any() or areas)
        apart += float((c.in_area & ~moved).sum())
        found += float(c.moved[moved].sum())
        untested += float((c.untested & moved).sum()) if c.untested is not None else 0.0
        expected, variance = expected + float(power.sum()), variance + float((power * (1 - power)).sum())
        d = m.displacements
        for k, point in enumerate(d.point):
            e = d.vector[k] - truth[d.end[k] - 1, place[point]]
            chi.append(float(e @ np.linalg.solve(d.covariance[k], e)) / 3)
    band = binom.interval(BAND, runs, SIGNIFICANCE)
    reach = float(norm.isf((1 - BAND) / 2)) * variance**0.5
    return {
        "runs": runs, "found": found, "expected": expected, "band_of_found": [expected - reach, expected + reach],
        "false_alarms": alarms, "band_of_false_alarms": [float(b) for b in band], "stable_points_in_areas": apart,
        "moved_but_untested": untested,
        "chi_square": float(np.mean(chi)) if chi else None, "cpu_s": time.process_time() - began,
    }  # fmt: skip


if __name__ == "__main__":
    with threadpool_limits(1):
        main(*map(float, sys.argv[1:]))
