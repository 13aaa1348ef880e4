"""One verdict on every machine: each degenerate network under perturbations, instruction sets and kinds of BLAS.

    python benchmarks/verdicts.py [perturbations=20]

Every combination runs in a process of its own.  Prints a line for each case: number of verdicts (1 is right), how many
runs, and what was said; a JSON object at the end.
"""

from __future__ import annotations

import collections
import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
INSTRUCTIONS = ("avx512", "avx2", "baseline", "0")
BLAS = ("Prescott", "Nehalem", "Haswell", "Zen", "SkylakeX", "Cooperlake")


def main() -> int:
    """Run the matrix."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    said: dict[str, collections.Counter[str]] = collections.defaultdict(collections.Counter)
    refused = []
    for instructions in INSTRUCTIONS:
        for blas in BLAS:
            names = {"RAYBUNDLE_NATIVE": instructions, "OPENBLAS_CORETYPE": blas, "OPENBLAS_NUM_THREADS": "1"}
            runs = count if instructions != "0" else max(2, count // 10)  # the NumPy twins take a hundred times as long
            command = [sys.executable, "-m", "tests.verdicts.cases", str(runs)]
            done = subprocess.run(
                command, cwd=ROOT, env={**os.environ, **names}, capture_output=True, text=True, check=False
            )
            if done.returncode:
                refused.append(f"{instructions} {blas}: {done.stderr.strip().splitlines()[-1:]}")
            for line in done.stdout.splitlines():
                found = json.loads(line)
                said[found["case"]].update(json.dumps(v) for v in found["verdicts"])
            print(f"{instructions} {blas} done", file=sys.stderr)
    rows = {}
    for case, verdicts in said.items():
        print(f"{len(verdicts)} of {verdicts.total()}  {case}", file=sys.stderr)
        for verdict, runs in verdicts.most_common():
            print(f"      {runs}  {verdict[:160]}", file=sys.stderr)
        rows[case] = {"verdicts": len(verdicts), "runs": verdicts.total()}
    print(json.dumps({"perturbations": count, "cases": rows, "refused": refused}))
    return int(any(r["verdicts"] > 1 for r in rows.values()))


if __name__ == "__main__":
    raise SystemExit(main())
