"""Memory, time and size of writing the table of image observations.

Its cells all at once, or some rows at a time; with all digits, or with those that its numbers deserve; as Parquet.

Run: python benchmarks/result_tables.py [ROWS]          a process for each, five writings, of which the quickest counts;
the bytes of the first two are compared; writes benchmarks/results/result_tables.json
"""

import hashlib
import json
import platform
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from runs import peak_mb

from raybundle.io import tables
from raybundle.io.digits import EVERY
from raybundle.results.digits import observation_digits

RESULTS = Path(__file__).parent / "results/result_tables.json"
WRITINGS = 5


def columns(rows):
    """A table like that of the image observations of a result."""
    rng = np.random.default_rng(1)
    ids, points = [f"IMG_{k:04d}.jpg" for k in range(41)], [f"t{k}" for k in range(rows // 5 + 1)]
    image, point = rng.integers(0, len(ids), rows), rng.integers(0, len(points), rows)
    table = {"image": [ids[k] for k in image], "point": [points[k] for k in point]}
    s, r = rng.uniform(0.05, 0.3, (2, rows)), rng.beta(4, 1.5, (2, rows))
    w = rng.normal(0, 1, (2, rows))
    parts = {
        "{}_px": rng.uniform(0, 4000, (2, rows)), "s{}_px": s, "v{}_px": w * s * np.sqrt(r), "r{}": r, "w{}": w,
        "t{}": w / 0.991, "mdb{}_px": 4.1321 * s / np.sqrt(r),
    }  # fmt: skip
    for name, values in parts.items():
        table |= {name.format(x): v for x, v in zip("xy", values, strict=True)}
    return {**table, "rejected": [""] * rows}


def one(how, rows):
    """Write, and say what it took beyond what the table itself takes."""
    table = columns(rows)
    numbers = {n: c for n, c in table.items() if isinstance(c, np.ndarray)}
    digits = EVERY if how in {"at once", "some rows at a time"} else observation_digits(numbers)
    if how == "at once":
        tables.WRITTEN_ROWS = rows
    before = peak_mb()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / ("observations.parquet" if how == "Parquet" else "observations.csv")
        seconds = []
        for _ in range(WRITINGS):
            start = time.process_time()
            tables.write_table(path, table, digits)
            seconds.append(time.process_time() - start)
        size = path.stat().st_size / 1e6
        peak = peak_mb()
        with path.open("rb") as file:
            digest = hashlib.file_digest(file, "sha256").hexdigest()
    print(
        json.dumps(
            {
                "MB before": round(before),
                "MB at the peak": round(peak),
                "CPU s": round(min(seconds), 3),
                "MB of the file": round(size, 1),
                "sha256": digest,
            }
        )
    )


def main():
    """All ways, in processes of their own."""
    rows = int(sys.argv[1]) if len(sys.argv) > 1 else 400_000
    found = {}
    for how in ("at once", "some rows at a time", "digits deserved", "Parquet"):
        out = subprocess.run([sys.executable, __file__, str(rows), how], check=True, capture_output=True, text=True)
        found[how] = json.loads(out.stdout)
        print(f"{how}: {found[how]}")
    same = len({found[how]["sha256"] for how in ("at once", "some rows at a time")}) == 1
    print(f"{rows} rows; same bytes: {same}")
    machine = {"machine": platform.machine(), "python": platform.python_version()}
    told = {how: {k: v for k, v in f.items() if k != "sha256"} for how, f in found.items()}
    RESULTS.write_text(
        json.dumps({**machine, "rows": rows, "same bytes": same, **told}, indent=1) + "\n", encoding="utf-8"
    )


if __name__ == "__main__":
    if len(sys.argv) > 2:
        one(sys.argv[2], int(sys.argv[1]))
    else:
        main()
