"""Memory and time of writing the table of image observations: its cells all at once, or some rows at a time.

Run: python benchmarks/result_tables.py [ROWS]          a process for each; the bytes are compared
"""

import hashlib
import json
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from raybundle.io import tables

NUMBERS = 14


def columns(rows):
    """A table like that of the image observations of a result."""
    rng = np.random.default_rng(1)
    names = {f"n{k}": rng.normal(0, 1000, rows) for k in range(NUMBERS)}
    names["n13"][rng.random(rows) < 0.3] = np.nan
    ids, points = [f"IMG_{k:04d}" for k in range(2000)], [f"p{k}" for k in range(rows // 5 + 1)]
    image, point = rng.integers(0, len(ids), rows), rng.integers(0, len(points), rows)
    return {
        "image": [ids[k] for k in image],
        "point": [points[k] for k in point],
        **names,
        "rejected": [""] * rows,
    }


def one(how, rows):
    """Write, and say what it took beyond what the table itself takes."""
    table = columns(rows)
    if how == "at once":
        tables.WRITTEN_ROWS = rows
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "observations.csv"
        start = time.process_time()
        tables.write_table(path, table)
        seconds = time.process_time() - start
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        with path.open("rb") as file:
            digest = hashlib.file_digest(file, "sha256").hexdigest()
    print(
        json.dumps(
            {"MB before": round(before), "MB at the peak": round(peak), "CPU s": round(seconds, 2), "sha256": digest}
        )
    )


def main():
    """Both ways, in processes of their own."""
    rows = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
    found = {}
    for how in ("at once", "some rows at a time"):
        out = subprocess.run([sys.executable, __file__, str(rows), how], check=True, capture_output=True, text=True)
        found[how] = json.loads(out.stdout)
        print(f"{how}: {found[how]}")
    same = len({f["sha256"] for f in found.values()}) == 1
    print(f"{rows} rows; same bytes: {same}")


if __name__ == "__main__":
    if len(sys.argv) > 2:
        one(sys.argv[2], int(sys.argv[1]))
    else:
        main()
