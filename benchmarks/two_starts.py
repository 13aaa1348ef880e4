"""Do the growing and the averaging start end at the same orientation, as far as the stated covariance tells?

    python benchmarks/two_starts.py [--set castle-p19]

Both runs go through all stages; one set of centres is brought to the other by a similarity.  The same photographs and
tie points were adjusted twice, so that the difference should be far below the stated standard deviations.  In mm where
the set has true centres to tell the scale, else in thousandths of the block's unit.
"""

from __future__ import annotations

import argparse
import csv
import json
import shutil
import sys

import numpy as np
from orient import CASES, WORK, truth_of
from runs import errors, measured, of_block, similarity


def main() -> None:
    """Print the figures as JSON."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--set", default="castle-p19", choices=list(CASES))
    name = parser.parse_args().set
    case = CASES[name]
    if not case.photos.is_dir():
        print(json.dumps({"absent": [name]}))
        return
    rows, found = {}, {}
    for start in ("growing", "averaging"):
        project = WORK / f"{name}-{start}"
        shutil.rmtree(project, ignore_errors=True)
        command = [sys.executable, "-m", "raybundle", "orient", str(case.photos), "--out", str(project), "--jobs", "2"]
        if case.calibration is not None:
            command += ["--calibration", str(case.calibration)]
        run = measured([*command, "--start", start, "--progress", "none", "--no-report"])
        found[start] = of_block(project / "result/block")
        with (project / "result/images.csv").open(newline="") as file:
            sigma = np.array([[float(r[k]) for k in ("sX", "sY", "sZ")] for r in csv.DictReader(file)])
        rows[start] = {
            "oriented": len(found[start]), "cpu_s": run["cpu_s"],
            "stated_units": float(np.sqrt((sigma**2).sum(axis=1).mean())), **errors(found[start], truth_of(case)),
        }  # fmt: skip
    truth = truth_of(case)
    names = sorted(set(found["growing"]) & set(found["averaging"]))
    centres = [np.array([found[start][n]["centre"] for n in names]) for start in ("growing", "averaging")]
    metres = 1.0
    if known := [n for n in names if n in truth]:
        there = np.array([truth[n]["centre"] for n in known])
        metres = similarity(np.array([found["averaging"][n]["centre"] for n in known]), there)[0]
    m, R, t = similarity(centres[0], centres[1])
    apart = (m * centres[0] @ R.T + t - centres[1]) * metres * 1000
    for start, row in rows.items():
        scale = metres * (m if start == "growing" else 1.0)
        row["stated_mm"] = row.pop("stated_units") * scale * 1000
    difference = float(np.sqrt((apart**2).sum(axis=1).mean()))
    print(json.dumps({"set": name, "difference_mm": difference, **rows}, indent=1))


if __name__ == "__main__":
    main()
