"""The congruence test over many drawn epochs: what moved is found, what stayed is left alone, as often as is promised.

python benchmarks/congruence.py [RUNS]

Sixty points, free networks with full covariances.  In each run three points move by six standard deviations of their
difference in any direction; in as many runs none moves.  The power is computed beforehand.
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.metrology.test_congruence import Epochs

from raybundle.metrology.congruence import congruence, probability_to_find

OUT = Path(__file__).with_name("results") / "congruence.json"
SIZE, SHIFTED, COUNT = 6.0, 3, 60


def main(runs: int = 500) -> None:
    """Draw, test, print and write."""
    epochs, rng = Epochs(COUNT), np.random.default_rng(11)
    found = all_found = others = none = 0
    began = time.process_time()
    for _ in range(runs):
        which = rng.choice(COUNT, SHIFTED, replace=False)
        done = congruence(epochs.draw(rng, {k: epochs.standard_shift(k, SIZE, rng) for k in which}))
        found += int(done.moved[which].sum())
        all_found += bool(done.moved[which].all())
        others += int(done.moved.sum()) > int(done.moved[which].sum())
        none += bool(congruence(epochs.draw(rng, {})).moved.any())
    told = {
        "runs": runs, "points": COUNT, "moved": SHIFTED, "standard_deviations": SIZE,
        "power_of_one_by_its_own_covariance": probability_to_find(SIZE, COUNT),
        "found": found / runs / SHIFTED, "all_found": all_found / runs, "others_called_moved": others / runs,
        "called_moved_where_none_moved": none / runs, "cpu_s": time.process_time() - began,
    }  # fmt: skip
    print(json.dumps(told, indent=1))
    OUT.write_text(json.dumps(told, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    with threadpool_limits(1):
        main(*map(int, sys.argv[1:]))
