"""What a further date costs in CPU seconds, over what its photographs cost alone.

    python benchmarks/epochs_cost.py [FOLDER] [--stages]

FOLDER    photographs in sub-folders by dates, three at least; without it a rendered strip that moves, nine each
--stages  where the time of each run goes, by samples each 20 ms

One process, one thread.  Each date alone, then the second and third added one by one, then the same once more.
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.workflows.moved_ground import write_dates

import raybundle as rb

DATES, SAMPLE_S = ("2026-05-01", "2026-06-01", "2026-07-01"), 0.02
OUT = Path(__file__).with_name("results") / "epochs_cost.json"
STAGES = {
    "orient": "orientation", "weighted_apart": "variances", "repeatability": "halves of dates",
    "congruence": "congruence test", "adjusted_again": "adjustments", "_measured": "covariances",
    "_pairs": "covariances", "of": "matching errors", "_all_rows": "displacements", "trends": "velocities",
}  # fmt: skip
"""Functions of the workflow, and what they are called here: the outermost counts"""


def measured(run: Callable[[], Any], *, stages: bool) -> dict[str, Any]:
    """CPU seconds of a run, and of its stages."""
    count: Counter[str] = Counter()

    def sample(_: int, frame: FrameType | None) -> None:
        found = "other"
        while frame is not None:
            code = frame.f_code
            if "/workflows/" in code.co_filename or "/metrology/" in code.co_filename:
                found = STAGES.get(code.co_name, found)
            frame = frame.f_back
        count[found] += 1

    if stages:
        signal.signal(signal.SIGPROF, sample)
        signal.setitimer(signal.ITIMER_PROF, SAMPLE_S, SAMPLE_S)
    began = time.process_time()
    run()
    seconds = time.process_time() - began
    signal.setitimer(signal.ITIMER_PROF, 0)
    every = max(sum(count.values()), 1)
    return {"cpu_s": round(seconds, 1), **{n: round(seconds * c / every, 1) for n, c in count.most_common() if stages}}


def main() -> None:
    """Run, print and write."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path)
    parser.add_argument("--stages", action="store_true")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as work:
        place = Path(work)
        photos = asked.folder or write_dates(place / "photographs", dates=DATES)
        dates = sorted(p for p in photos.iterdir() if p.is_dir())[:3]

        def run(project: str, k: int, *, add: bool = True) -> None:
            rendered: dict[str, Any] = {}
            if asked.folder is None:
                rendered = {"positions": photos / f"{k}.csv", "crs": "EPSG:32633", "feature_count": 1500}
            rb.epochs(place / project, add=(dates[k],) if add else (), jobs=1, report=False, **rendered)

        run("warm", 0)  # imports
        found: dict[str, dict[str, Any]] = {}
        for k in range(3):
            found[f"{dates[k].name} alone"] = measured(lambda k=k: run(f"alone_{k}", k), stages=asked.stages)
        for k in range(3):
            found[f"{dates[k].name} added"] = measured(lambda k=k: run("project", k), stages=asked.stages)
        found["nothing added"] = measured(lambda: run("project", 2, add=False), stages=asked.stages)
        for k in (1, 2):
            added, alone = (found[f"{dates[k].name} {how}"]["cpu_s"] for how in ("added", "alone"))
            found[f"{dates[k].name} added"]["over_alone"] = round(added / alone, 1)
    for name, figures in found.items():
        print(f"{name:18s} {json.dumps(figures)}")
    OUT.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
