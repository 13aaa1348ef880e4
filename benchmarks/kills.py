"""Commands killed at random instants: 100 times orient, 30 times each of calibrate, adjust, rectify.

    python benchmarks/kills.py
    python benchmarks/kills.py orient 20 --seconds 300

After each kill the output is the old result whole, or the new one; what a run continues ends as without kills, and
nothing is left beside it.  Prints JSON; exit status 1 where one of them does not hold.
"""

import argparse
import json
import sys
import tempfile
import time
from dataclasses import asdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
COUNTS = {"orient": 100, "calibrate": 30, "adjust": 30, "rectify": 30}


def main():
    from tests.hostile.killing import JOBS, kill

    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", nargs="?", choices=sorted(COUNTS))
    parser.add_argument("count", nargs="?", type=int)
    parser.add_argument("--seconds", type=float, default=3600.0, help="for each command")
    parser.add_argument("--seed", type=int, default=time.time_ns())
    o = parser.parse_args()
    result = {"seed": o.seed, "commands": {}}
    for name in [o.command] if o.command else COUNTS:
        with tempfile.TemporaryDirectory() as folder:
            job = JOBS[name](Path(folder))
            if job is None:
                continue
            began = time.monotonic()
            told = kill(job, o.count or COUNTS[name], o.seed, began + o.seconds)
        result["commands"][name] = {**asdict(told), "seconds": round(time.monotonic() - began, 1)}
        print(f"{name}: {told.kills} kills, {len(told.wrong)} wrong", file=sys.stderr)
    print(json.dumps(result, indent=1))
    return int(any(r["wrong"] for r in result["commands"].values()))


if __name__ == "__main__":
    sys.exit(main())
