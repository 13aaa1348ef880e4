"""From how far away is what a photograph measures seen by the next one?

    python benchmarks/nearest_rays.py RESULT [RESULT ...]

For every photograph of result folders the median angle between its rays and the nearest other ray of their points
(`ties/far_apart.py`): features of one place do not look alike from too far apart, so that a large median of few
points says that the matches are wrong.  Prints JSON: the largest medians of all photographs, and of those with at most
`FEW` points.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np

from raybundle.io.block.folder import read_block
from raybundle.ties.far_apart import APART, FEW, nearest_rays

LARGEST = 5


def medians(folder: Path) -> list[dict]:
    """Points and median angle of each oriented photograph of a result folder."""
    block = read_block(folder / "block")
    found = []
    for i in np.flatnonzero(block.images.oriented).tolist():
        angle = next(nearest_rays(block, [i]))
        if len(angle):
            row = {
                "set": "/".join(folder.resolve().parts[-3:-1]),
                "photograph": block.images.ids[i],
                "points": len(angle),
            }
            found.append(row | {"median_deg": float(np.degrees(np.median(angle)))})
    return found


def main() -> int:
    """All result folders."""
    rows = [row for folder in sys.argv[1:] for row in medians(Path(folder))]
    rows.sort(key=lambda r: -r["median_deg"])
    few = [r for r in rows if r["points"] <= FEW]
    print(json.dumps({
        "photographs": len(rows), "sets": len({r["set"] for r in rows}), "limit_deg": float(np.degrees(APART)),
        "largest": rows[:LARGEST], "with_few": len(few), "few_at_most": FEW, "largest_with_few": few[:LARGEST],
    }, indent=1))  # fmt: skip
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
