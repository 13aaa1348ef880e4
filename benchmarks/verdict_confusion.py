"""Sixty simulated calibrations: the verdict against the worst true error of projection over the format, at infinity.

python benchmarks/verdict_confusion.py [--networks 60] [--first 0]

Truth: good up to 0.1 px, usable up to 0.3 px, else weak.  All photographs are of one and the same camera, so that a
cross-validation that accuses it is wrong.  Exit status 1 where "good" is wrong, a verdict is two classes off, or less
than 85 % agree.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.truth.verdicts import GRADES, confusion, judged


def main() -> int:
    """Print the confusion matrix and each network as JSON."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--networks", type=int, default=60)
    parser.add_argument("--first", type=int, default=0)
    asked = parser.parse_args()
    rows = [judged(seed) for seed in range(asked.first, asked.first + asked.networks)]
    table = confusion(rows)
    accused = [r.seed for r in rows if r.quality is not None and any("carry over" in s for s in r.quality.reasons)]
    told = {
        "grades": GRADES,
        "truth_down_verdict_across": table.tolist(),
        "on_the_diagonal": float(np.trace(table) / len(rows)),
        "good_and_wrong": int(table[1:, 0].sum()),
        "two_classes_off": int(table[0, 2] + table[2, 0]),
        "camera_accused": accused,
        "networks": [
            {
                "seed": r.seed, "truth": r.truth, "verdict": r.verdict, "worst_px": round(r.worst_px, 4),
                "stated_px": None if r.quality is None else round(r.quality.uncertainty_px, 4),
                "reasons": [] if r.quality is None else list(r.quality.reasons),
            }
            for r in rows
        ],
    }  # fmt: skip
    print(json.dumps(told, indent=1))
    return int(told["good_and_wrong"] > 0 or told["two_classes_off"] > 0 or told["on_the_diagonal"] < 0.85)


if __name__ == "__main__":
    sys.exit(main())
