"""Heights of the rendered portal, their means, volumes and profiles, beside its exact geometry.

    python benchmarks/surface_heights.py SURFACE

SURFACE is a folder of `raybundle surface --dsm CELL` of the demonstration set portal.  The mesh of the set is met by
rays along the plane's normal from above, at the middles of all cells.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.surface.truth import Portal  # noqa: E402

from raybundle.workflows.height_files import read_heights  # noqa: E402

SIDE = 0.2
"""Of the squares whose means are compared [m]"""
FILLED = 0.9
"""Share of a square's cells that need a height"""


def robust(x: np.ndarray) -> float:
    """Chi-square by the median."""
    return float((np.median(np.abs(x)) / 0.6745) ** 2)


def told(x: np.ndarray) -> dict[str, float]:
    """Of normalised errors."""
    return {
        "count": len(x), "robust_chi2": round(robust(x), 3), "mean_chi2": round(float(np.mean(x**2)), 3),
        "chi2_within_5": round(float(np.mean(x[np.abs(x) < 5] ** 2)), 3),
        "within_1": round(float(np.mean(np.abs(x) < 1)), 3), "within_1.96": round(float(np.mean(np.abs(x) < 1.96)), 3),
        "beyond_5": round(float(np.mean(np.abs(x) > 5)), 5),
    }  # fmt: skip


def main() -> None:
    """All of it."""
    parser = argparse.ArgumentParser()
    parser.add_argument("surface", type=Path)
    parser.add_argument("--keep", action="store_true", help="into benchmarks/results/surface_heights.json")
    given = parser.parse_args()
    model, file = read_heights(given.surface)
    (ROOT / ".pytest_cache/d/surface").mkdir(parents=True, exist_ok=True)
    truth = Portal(ROOT / ".pytest_cache/d/surface")
    origin, right, up, normal = (np.array(file.plane[k]) for k in ("origin", "right", "up", "normal"))
    v, u = np.mgrid[: file.height, : file.width] + 0.5
    at = (file.left + u.ravel() * file.cell)[:, None] * right + (file.top - v.ravel() * file.cell)[:, None] * up
    far = 1.0
    distance, _ = truth.cast(origin + at + far * normal, np.broadcast_to(-normal, at.shape))
    exact = (far - distance).reshape(file.height, file.width)
    h = model.heights
    e = h.height - exact
    known = np.isfinite(e)
    x = e[known] / h.sigma[known]
    # not beside a step: there the middle of a cell has one height, and what was measured in it another
    step = np.zeros(exact.shape)
    step[1:-1, 1:-1] = np.max(
        [np.abs(exact[1 + j : exact.shape[0] - 1 + j, 1 + i : exact.shape[1] - 1 + i] - exact[1:-1, 1:-1])
         for j in (-1, 0, 1) for i in (-1, 0, 1)], axis=0,
    )  # fmt: skip
    smooth = known & (step < file.cell)
    found = {
        "cell_m": file.cell, "known": round(float(known.sum() / np.isfinite(exact).sum()), 4),
        "error_mm": round(float(1000 * np.median(np.abs(e[known])) / 0.6745), 3),
        "sigma_mm": round(float(1000 * np.median(h.sigma[known])), 3),
        "sigma_orientation_mm": round(float(1000 * np.median(h.orientation[known])), 3),
        "bias_mm": round(float(1000 * np.median(e[smooth])), 3),
        "cells": told(x), "cells_off_steps": told((e / h.sigma)[smooth]),
    }  # fmt: skip
    side = max(2, round(SIDE / file.cell))
    means, stated, locals_, common, moved = [], [], [], [], []
    for j in range(0, file.height - side + 1, side):
        for i in range(0, file.width - side + 1, side):
            w = np.zeros(e.shape)
            w[j : j + side, i : i + side] = smooth[j : j + side, i : i + side]
            n = w.sum()
            if n < FILLED * side**2:
                continue
            s = model.sum_of(w / n)
            means.append(s.value - float((w * np.nan_to_num(exact)).sum() / n))
            stated.append(s.sigma)
            locals_.append(s.local)
            common.append(s.orientation)
            moved.append(s.moved)
    m, s = np.array(means), np.array(stated)
    # one orientation has moved all of them: by their joint covariance they are as many independent draws
    C = np.array(moved) @ np.array(moved).T + np.diag(np.square(locals_))
    apart = np.linalg.solve(np.linalg.cholesky(C), m)
    found["means"] = {
        "side_m": SIDE, "count": len(m), "robust_mm": round(1000 * float(np.median(np.abs(m))) / 0.6745, 4),
        "bias_mm": round(1000 * float(np.median(m)), 4), "sigma_mm": round(1000 * float(np.median(s)), 4),
        "local_mm": round(1000 * float(np.median(locals_)), 4),
        "orientation_mm": round(1000 * float(np.median(common)), 4), **told(m / s),
        "apart": told(apart),
    }  # fmt: skip
    print(json.dumps(found, indent=1))
    if given.keep:
        path = ROOT / "benchmarks/results/surface_heights.json"
        path.write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
