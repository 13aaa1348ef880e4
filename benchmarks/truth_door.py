"""500 runs through the whole door: what `adjust` states of blocks as users give them, against their true errors.

    python benchmarks/truth_door.py [--runs 500] [--case NAME] [--wrong 1.1] [--clean]

Blocks without approximate values, with gross errors and standard deviations wrong by a factor, adjusted as
`raybundle adjust --estimate auto --reject snooping` does; runs are kept under build/ and an interrupted series goes on.
--clean: the same blocks without gross errors, with standard deviations as stated, and nothing decided.
--wrong multiplies all stated standard deviations when the runs are judged: 1.1 must fail.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import sys
from pathlib import Path

import numpy as np

from raybundle.errors import RaybundleError

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.truth.door import score, verdict
from tests.truth.door_blocks import CASES

ROOT = Path(__file__).resolve().parents[1]
KINDS = ("points", "stations", "interior")


def version() -> str:
    """A digest of what the figures depend on: another version begins anew."""
    tests = ROOT / "tests" / "truth"
    files = [*(ROOT / "src").rglob("*.py"), *(ROOT / "cpp").rglob("*.?pp"), *tests.glob("door*.py"), tests / "bands.py"]
    files.sort()
    return hashlib.sha256(b"".join(f.read_bytes() for f in files)).hexdigest()[:12]


VERSION = version()


def runs_of(name: str, count: int, *, clean: bool) -> list[dict]:
    """The first runs of a case: those that were made before, and the others."""
    kept = ROOT / "build" / "truth_door" / VERSION / f"{name.replace(' ', '_')}{'_clean' * clean}.jsonl"
    kept.parent.mkdir(parents=True, exist_ok=True)
    lines = kept.read_text().splitlines() if kept.exists() else []
    runs = [json.loads(line) for line in lines][:count]
    case = CASES[name]()
    with kept.open("a") as out:
        for seed in range(len(runs), count):
            try:
                run = score(case, seed, clean=clean)
            except RaybundleError as error:
                run = {"refused": f"{type(error).__name__}: {error.headline}", "kinds": {}}
            runs.append(run)
            out.write(json.dumps(run) + "\n")
            out.flush()
    return runs


def by_parameter(runs: list[dict], kind: str) -> dict[str, list[float]]:
    """Mean e^2 / s^2 of each parameter, and what its scatter between the runs makes of that mean's uncertainty."""
    found: dict[str, list[float]] = {}
    for run in runs:
        for name, value in run["kinds"].get(kind, {}).get("by", {}).items():
            found.setdefault(name, []).append(value)
    return {
        name: [round(float(np.mean(v)), 3), round(float(np.std(v) / np.sqrt(len(v))), 3), len(v)]
        for name, v in found.items()
    }


def facts(runs: list[dict]) -> dict:
    """What happened in the runs of a case beside its figures."""
    done = [r for r in runs if "refused" not in r]
    return {
        "runs": len(runs), "refused": [r["refused"] for r in runs if "refused" in r],
        "adjusted_again_as_told": sum(r["rounds"] > 1 for r in done), "gross": sum(r["gross"] for r in done),
        "gross_left": sum(len(r["left"]) for r in done), "largest_left": max(max(r["left"], default=0) for r in done),
        "good_image_points_lost": sum(r["good_lost"] for r in done),
    }  # fmt: skip


def rows_of(name: str, runs: list[dict], wrong: float) -> list[dict]:
    """The figures of a case: after all; and those of runs without a gross error left, and of the first results."""
    rows = []
    for kind in KINDS:
        clean = [r for r in runs if not r.get("left")]
        first = [r["first"] for r in runs if "first" in r]
        rows.append(
            {
                "case": name, "kind": kind, **verdict(runs, kind, wrong),
                "percent_without_gross_left": verdict(clean, kind, wrong)["sigma_off_percent"],
                "percent_at_first": verdict(first, kind, wrong)["sigma_off_percent"], "by": by_parameter(runs, kind),
            }
        )  # fmt: skip
    return rows


def main() -> int:
    """Print the figures as JSON, a table on stderr; 1 if a sum lies outside its band."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--runs", type=int, default=500)
    parser.add_argument("--case", choices=CASES, action="append")
    parser.add_argument("--wrong", type=float, default=1.0)
    parser.add_argument("--clean", action="store_true")
    asked = parser.parse_args()
    names = asked.case or list(CASES)
    every: dict[str, list[dict]] = {}
    for k, name in enumerate(names):
        every[name] = runs_of(name, asked.runs // len(names) + (k < asked.runs % len(names)), clean=asked.clean)
    rows = [row for name, runs in every.items() for row in rows_of(name, runs, asked.wrong)]
    rows += rows_of("all", [r for runs in every.values() for r in runs], asked.wrong)
    for r in rows:
        print(
            f"{r['case']:14} {r['kind']:9} {r['ratio']:.3f} ({r['low']:.3f} .. {r['high']:.3f}) "
            f"{'inside ' if r['inside'] else 'OUTSIDE'} sigma {r['sigma_off_percent']:+.1f} %, no gross error left "
            f"{r['percent_without_gross_left']:+.1f} %, first result {r['percent_at_first']:+.1f} %; "
            f"spread {r['spread_of_runs']:.2f}, largest {r['largest_run']:.1f}",
            file=sys.stderr,
        )
    cases = {name: facts(runs) for name, runs in every.items()}
    print(json.dumps({"wrong": asked.wrong, "clean": asked.clean, "cases": cases, "figures": rows}, indent=1))
    return int(not all(r["inside"] for r in rows))


if __name__ == "__main__":
    sys.exit(main())
