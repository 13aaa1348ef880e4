"""Do two disjoint random halves of the tie points give the same projection centres?  A measure that needs no truth.

    python benchmarks/tie_halves.py [--project FOLDER] [--splits 3]

Without --project, fountain-p11 of RAYBUNDLE_DATA is oriented with its calibration given.  Each half of the tie points
is adjusted with everything else as it is, one set of centres is brought to the other by a similarity, and the
difference is counted in the scale of the truth.  `stated_mm` is what the standard deviations of the two halves make
one expect.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import sys
from pathlib import Path

import numpy as np
from orient import CASES, WORK, truth_of
from runs import errors, measured, similarity

HERE = Path(__file__).resolve().parent
CASE = CASES["fountain-p11"]


def oriented(project: Path) -> Path:
    """Orient the set into this project folder."""
    shutil.rmtree(project, ignore_errors=True)
    command = [sys.executable, "-m", "raybundle", "orient", str(CASE.photos), "--out", str(project), "--jobs", "2"]
    measured([*command, "--calibration", str(CASE.calibration), "--progress", "none", "--no-report"])
    return project


def main() -> None:
    """Print the figures as JSON."""
    from raybundle.adjustment.engine import adjust_block
    from raybundle.adjustment.records.options import AdjustmentOptions
    from raybundle.block.select import with_rows
    from raybundle.io.block.folder import read_block

    parser = argparse.ArgumentParser()
    parser.add_argument("--project", type=Path)
    parser.add_argument("--splits", type=int, default=3)
    options = parser.parse_args()
    if not CASE.photos.is_dir():
        print(json.dumps({"absent": [str(os.path.relpath(CASE.photos, HERE.parents[1]))]}))
        return
    project = options.project or oriented(WORK / "halves")
    block = read_block(project / "result" / "block")
    truth = truth_of(CASE)
    known = np.array([truth[f]["centre"] for f in block.images.file])
    metres = similarity(block.images.centre, known)[0]
    rng = np.random.default_rng(1)
    rows = []
    for _ in range(options.splits):
        first = rng.random(len(block.points)) < 0.5
        centres, stated, sigma0 = [], [], []
        for half in (first, ~first):
            part = with_rows(block, half[block.observations.point])
            done = adjust_block(part, AdjustmentOptions(datum_over="good"))
            assert done.precision is not None
            centres.append(done.adjusted.images.centre)
            stated.append(done.precision.image_std[:, :3])
            sigma0.append(done.sigma0)
        m, R, t = similarity(centres[0], centres[1])
        apart = (m * centres[0] @ R.T + t - centres[1]) * metres * 1000
        rows.append(
            {
                "rms_mm": float(np.sqrt((apart**2).sum(axis=1).mean())),
                "stated_mm": float(np.sqrt(sum((s**2).sum(axis=1).mean() for s in stated))) * metres * 1000,
                "sigma0": sigma0,
                "points": [int(first.sum()), int((~first).sum())],
            }
        )
    found = {f: {"centre": c, "rotation": R} for f, c, R in zip(
        block.images.file, block.images.centre,
        np.diag([1.0, -1.0, -1.0]) @ block.images.rotation, strict=True)}  # fmt: skip
    mean = float(np.mean([r["rms_mm"] for r in rows]))
    print(json.dumps({"mean_rms_mm": mean, "splits": rows, **errors(found, truth)}, indent=1))


if __name__ == "__main__":
    main()
