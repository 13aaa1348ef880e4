"""What moved between three dates of simulated networks: found as often as computed beforehand, false alarms as stated.

python benchmarks/epochs.py [RUNS]

Each network is simulated, tested and adjusted as `raybundle epochs` does after orientation.  Points move by 0.5 to 20
standard deviations, each in its own direction, or a connected part as one piece.
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.workflows.dated_network import Plan, network

from raybundle.workflows.epochs.movements import movements

OUT = Path(__file__).with_name("results") / "epochs.json"
CASES = (("none", 0.0, False), ("20 %", 0.2, False), ("45 %", 0.45, False), ("45 % as one piece", 0.45, True))
SIZES = (0.5, 20.0)


def main(runs: int = 100) -> None:
    """Draw, test, print and write."""
    plan, every = Plan(), {}
    for name, share, piece in CASES:
        every[name] = case(plan, runs, share, piece=piece)
        print(name, json.dumps(every[name]), flush=True)
    OUT.write_text(json.dumps(every, indent=1) + "\n", encoding="utf-8")


def case(plan: Plan, runs: int, share: float, *, piece: bool) -> dict[str, float]:
    """Counts of one case."""
    n, place = len(plan.ids), {i: k for k, i in enumerate(plan.ids)}
    found = expected = variance = alarms = 0.0
    chi: list[float] = []
    began = time.process_time()
    for seed in range(runs):
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
        areas = any(a.moved and not moved[a.points].any() for a in c.areas)
        alarms += bool((c.moved & ~c.in_area & ~moved).any() or areas)
        found += float(c.moved[moved].sum())
        expected, variance = expected + float(power.sum()), variance + float((power * (1 - power)).sum())
        d = m.displacements
        for k, point in enumerate(d.point):
            e = d.vector[k] - truth[d.end[k] - 1, place[point]]
            chi.append(float(e @ np.linalg.solve(d.covariance[k], e)) / 3)
    return {
        "runs": runs, "found": found, "expected": expected, "expected_std": variance**0.5,
        "false_alarms": alarms / runs, "chi_square": float(np.mean(chi)), "cpu_s": time.process_time() - began,
    }  # fmt: skip


if __name__ == "__main__":
    with threadpool_limits(1):
        main(*map(int, sys.argv[1:]))
