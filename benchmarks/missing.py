"""By what share of barren cells (`ties/missing.py`) photographs hang together.

    python benchmarks/missing.py PROJECT ...

Takes the approximate values of each project folder that `raybundle orient` has left.  The bottleneck is the smallest
limit at which pairs join all photographs that hang together at all; the groups are what would be told.  Adds them to
benchmarks/results/missing.json under the folders' names.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np

from raybundle.block import Block
from raybundle.ties import missing
from raybundle.workflows.stage_arrays import tie_of_arrays, unpacked

RESULTS = Path(__file__).resolve().parent / "results/missing.json"


def starts(project: Path) -> list[Block]:
    """Blocks of the newest start of a project."""
    files = sorted(project.glob("cache/*/start-*.npz"), key=lambda f: f.stat().st_mtime)
    if not files:
        return []
    with np.load(files[-1], allow_pickle=False) as arrays:
        return [tie_of_arrays(a).block for a in unpacked({k: arrays[k] for k in arrays.files}).values()]


def bottleneck(block: Block) -> float:
    """The largest share in the tree of smallest shares (Kruskal 1956)."""
    seen = missing.seen_of(block)
    edges = []
    for i, j in missing.candidate_pairs(block):
        barren, mixed = missing.cells(block, seen, i, j)
        edges.append((barren / max(barren + mixed, 1), i, j))
    group, worst = np.arange(len(block.images)), 0.0
    for share, i, j in sorted(edges):
        if group[i] != group[j]:
            group[group == group[j]] = group[i]
            worst = share
    return worst


def main() -> int:
    """Run all."""
    rows = json.loads(RESULTS.read_text(encoding="utf-8")) if RESULTS.exists() else {}
    for name in sys.argv[1:]:
        blocks = starts(Path(name))
        if not blocks:
            continue
        label = Path(name).parent.name if Path(name).name == "project" else Path(name).name
        rows[label] = {
            "photographs": [int(b.images.oriented.sum()) for b in blocks],
            "bottleneck": round(max(bottleneck(b) for b in blocks), 3),
            "groups": [len(g) for b in blocks for g in missing.groups(b)[0]],
        }
        print(label, rows[label], flush=True)
        RESULTS.write_text(json.dumps(rows, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
