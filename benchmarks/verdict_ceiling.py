"""How often can a verdict on a calibration be right at all?  One that knows the true covariance, against the verdict.

python benchmarks/verdict_ceiling.py [--networks 300] [--first 0]

The largest error of one network over the format is a random number, of which the network settles the distribution and
nothing else: in a Gauss-Markov model the error of the estimate does not depend on the residuals.  A verdict from the
network and the residuals can at best know that distribution.  The oracle here takes it from the covariance with the
standard deviation that the errors were drawn with; its probabilities are tested: the places of the true errors in
their distributions are even (Kolmogorov).  Of each network it says the grade of least cost (`Judged.oracle`), where
good is said from a probability `sure` on.  No rule is right more often at as many goods that are none: each network's
gain by good, P(good) - max(P(usable), P(weak)), and its cost, 1 - P(good), depend on P(good) (Neyman, Pearson 1933).

Two sets of networks: `mixed`, as in verdict_confusion.py; `even`, drawn evenly over all qualities.  Written to
benchmarks/results/verdict_ceiling.json.  Exit status 1 where the verdict agrees with the truth less often than the
oracle of the same certainty, beyond three standard deviations, or the oracle's probabilities are not even (0.1 %).
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

import numpy as np
from scipy.stats import kstest

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.truth.verdicts import GRADES, Judged, confusion, evenly, judged, network

from raybundle.calibration.quality import SURE

ROOT = Path(__file__).resolve().parents[1]
CERTAINTIES = (0.5, 0.7, 0.8, 0.9, SURE, 0.99)
ASKED = 0.85
"""Share on the diagonal that was asked for."""


def frontier(rows: list[Judged]) -> list[dict]:
    """What the oracle reaches, by the certainty that it asks of good."""
    chances = np.array([r.chances for r in rows])
    told = []
    for sure in CERTAINTIES:
        said = np.array([r.oracle(sure) for r in rows])
        wrong = (1 - chances[said == 0, 0]).sum() / len(rows)
        told.append({
            "sure": sure, "on_the_diagonal": float(chances[np.arange(len(rows)), said].mean()),
            "good_and_wrong_in_sixty": float(60 * wrong), "none_wrong_in_sixty": float(np.exp(-60 * wrong)),
        })  # fmt: skip
    return told


def summary(rows: list[Judged]) -> dict:
    """The verdict beside the oracle."""
    table, n = confusion(rows), len(rows)
    hit = np.array([r.chances[r.oracle()] for r in rows])
    said = np.array([r.chances[GRADES.index(r.verdict)] for r in rows])
    reached, std = float(np.trace(table) / n), float(np.sqrt((hit * (1 - hit)).sum()) / n)
    p = float(kstest([r.place for r in rows if np.isfinite(r.place)], "uniform").pvalue)
    return {
        "networks": n, "truth_down_verdict_across": table.tolist(), "on_the_diagonal": reached,
        "expected_of_the_verdict": float(said.mean()), "oracle": float(hit.mean()), "std": std,
        "good_and_wrong": int(table[1:, 0].sum()), "two_classes_off": int(table[0, 2] + table[2, 0]),
        "places_are_even_p": p, "frontier": frontier(rows),
        "good": bool(p > 1e-3 and reached > hit.mean() - 3 * std),
    }  # fmt: skip


def main() -> int:
    """Print both sets as JSON."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--networks", type=int, default=300)
    parser.add_argument("--first", type=int, default=0)
    asked = parser.parse_args()
    seeds = range(asked.first, asked.first + asked.networks)
    told = {
        name: summary([judged(seed, draw) for seed in seeds]) for name, draw in (("mixed", network), ("even", evenly))
    }
    text = json.dumps({"asked": ASKED, "first": asked.first} | told, indent=1)
    (ROOT / "benchmarks" / "results" / "verdict_ceiling.json").write_text(text + "\n")
    print(text)
    return int(not all(t["good"] for t in told.values()))


if __name__ == "__main__":
    sys.exit(main())
