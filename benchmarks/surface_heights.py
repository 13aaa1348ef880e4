"""Heights of the rendered portal, their means, volumes and profiles, beside its exact geometry.

    python benchmarks/surface_heights.py SURFACE [--halves SURFACE SURFACE]

SURFACE is a folder of `raybundle surface --dsm CELL` of the demonstration set portal.  The mesh of the set is met by
rays along the plane's normal from above, at 5 x 5 places of each cell: the height of a cell is the mean over it.
Errors that one orientation has given to all are one draw: sums are compared by their joint covariance, too ("apart").
The halves are surfaces from the odd and from the even photographs alone (--photos), with the same --extent: nothing of
them has moved, and reliefs of 30 x 30 cm are raised and sunk by 3 mm.
"""

from __future__ import annotations

import argparse
import json
import sys
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
from scipy.ndimage import maximum_filter, minimum_filter

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.surface.truth import Portal  # noqa: E402

from raybundle.surfaces.files.heights import HeightFile, read_heights  # noqa: E402
from raybundle.surfaces.files.input import on_same_grid, opened  # noqa: E402
from raybundle.surfaces.heights.displacement import movements  # noqa: E402
from raybundle.surfaces.heights.height_model import HeightModel  # noqa: E402
from raybundle.surfaces.heights.resampling import difference  # noqa: E402
from raybundle.surfaces.heights.steps import alike  # noqa: E402

SIDE = 0.2
"""Of the squares whose means are compared [m]"""
FILLED = 0.7
"""Share of a square's cells that need a height"""
FINE = 5
"""Places along the side of a cell"""
CLASSES = (0.0, 0.005, 0.01, 0.02, 0.04, 0.1, np.inf)
"""What the object spans in a cell and its neighbours [m]"""
CHUNK = 500_000
LAGS = (1, 2, 3, 4, 6, 8, 12, 16, 24)
"""Cells from one to the other whose errors by steps are compared"""
MOVED, MOVED_SIDE = (((-2.1, -0.18), 0.003), ((-0.4, -0.78), -0.003)), 0.3
"""Upper left corners of reliefs that are moved, and by how much [m]"""


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


def exact_of(truth: Portal, file: HeightFile) -> tuple[np.ndarray, np.ndarray]:
    """Mean heights of the cells, and what the object spans in each and its neighbours."""
    origin, right, up, normal = (np.array(file.plane[k]) for k in ("origin", "right", "up", "normal"))
    v, u = ((x.ravel() + 0.5) / FINE for x in np.mgrid[: FINE * file.height, : FINE * file.width])
    far, found = 1.0, np.empty(len(u))
    for begin in range(0, len(u), CHUNK):
        part = slice(begin, begin + CHUNK)
        at = (file.left + u[part] * file.cell)[:, None] * right + (file.top - v[part] * file.cell)[:, None] * up
        distance, _ = truth.cast(origin + at + far * normal, np.broadcast_to(-normal, at.shape))
        found[part] = far - distance
    cells = (
        found.reshape(file.height, FINE, file.width, FINE).transpose(0, 2, 1, 3).reshape(file.height, file.width, -1)
    )
    mean = cells.mean(axis=2)
    high, low = (np.where(np.isfinite(mean), f(cells, axis=2), w) for f, w in ((np.max, -9.0), (np.min, 9.0)))
    return mean, maximum_filter(high, 3) - minimum_filter(low, 3)


def apart(model: HeightModel, e: np.ndarray, sums: list[np.ndarray]) -> tuple[dict[str, object], np.ndarray]:
    """Errors of sums with weights: what their median is, each by its own sigma, and all by their joint covariance."""
    found = [(model.sum_of(w), float((w * np.nan_to_num(e)).sum())) for w in sums]
    error = np.array([x for _, x in found])
    sigma, local = (np.array([getattr(s, k) for s, _ in found]) for k in ("sigma", "local"))
    moved = np.array([s.moved for s, _ in found])
    C = moved @ moved.T + np.diag(local**2)
    free = np.linalg.solve(np.linalg.cholesky(C), error)
    return {
        "count": len(sums), "robust_error": float(f"{robust(error) ** 0.5:.4g}"),
        "sigma": float(f"{np.median(sigma):.4g}"), "local": float(f"{np.median(local):.4g}"),
        "each": told(error / sigma), "apart": told(free),
    }, free  # fmt: skip


def along_steps(model: HeightModel, e: np.ndarray) -> dict[str, object]:
    """Correlation of normalised errors of cells with a step, by distance along rows and columns, and what is stated."""
    step = model.heights.step.astype(float)
    there = np.isfinite(e) & (step > 0)
    z = np.where(there, np.clip(np.nan_to_num(e) / np.hypot(step, model.heights.local), -5, 5), 0.0)
    variance, found, stated = float((z[there] ** 2).mean()), {}, {}
    for lag in LAGS:
        pairs = [(z[:, lag:] * z[:, :-lag], there[:, lag:] & there[:, :-lag])]
        pairs.append((z[lag:] * z[:-lag], there[lag:] & there[:-lag]))
        both = sum(int(good.sum()) for _, good in pairs)
        found[lag] = round(sum(float(p[good].sum()) for p, good in pairs) / max(both, 1) / variance, 3)
        stated[lag] = round(sum(share * np.exp(-((lag / far) ** 2)) for share, far in alike(model.length)), 3)
    return {"cells": int(there.sum()), "mean": round(float(z[there].mean()), 3), "measured": found, "stated": stated}


def squares(good: np.ndarray, side: int) -> list[np.ndarray]:
    """Weights of means over squares, of the cells that are good."""
    found = []
    for j in range(0, good.shape[0] - side + 1, side):
        for i in range(0, good.shape[1] - side + 1, side):
            w = np.zeros(good.shape)
            w[j : j + side, i : i + side] = good[j : j + side, i : i + side]
            if w.sum() >= FILLED * side**2:
                found.append(w / w.sum())
    return found


def halves(one: Path, other: Path) -> dict[str, object]:
    """What is called moved between two surfaces, before and after a relief was."""
    before, after = opened(one), opened(other)
    same = on_same_grid(before, after)
    still = movements(difference(before.model, same))
    z = (still.local / still.sigma)[np.isfinite(still.local)]
    found = {
        "cell_m": before.file.cell, "alarms": len(still.regions), "cells": told(z), "moved": [],
        "off_steps": told(z[(difference(before.model, same).heights.step == 0)[np.isfinite(still.local)]]),
    }  # fmt: skip
    side = round(MOVED_SIDE / before.file.cell)
    for corner, by in MOVED:
        column, row = np.round(before.cells(np.array([corner])))[0].astype(int)
        height = same.heights.height.copy()
        height[row : row + side, column : column + side] += by
        now = movements(difference(before.model, replace(same, heights=replace(same.heights, height=height))))
        found["moved"].append({
            "by_mm": 1000 * by, "regions": len(now.regions),
            **({k: round(float(v), 6) for k, v in (("mean_mm", 1000 * r.amount), ("sigma_mm", 1000 * r.amount_sigma),
               ("area", r.area), ("area_sigma", r.area_sigma))} if now.regions and (r := now.regions[0]) else {}),
        })  # fmt: skip
    return found


def main() -> None:
    """All of it."""
    parser = argparse.ArgumentParser()
    parser.add_argument("surface", type=Path)
    parser.add_argument("--halves", type=Path, nargs=2, help="surfaces of the odd and of the even photographs")
    parser.add_argument("--keep", action="store_true", help="into benchmarks/results/surface_heights.json")
    given = parser.parse_args()
    model, file = read_heights(given.surface)
    (ROOT / ".pytest_cache/d/surface").mkdir(parents=True, exist_ok=True)
    exact, span = exact_of(Portal(ROOT / ".pytest_cache/d/surface"), file)
    h = model.heights
    e = h.height - exact
    known = np.isfinite(e)
    found = {
        "cell_m": file.cell, "known": round(float(known.sum() / np.isfinite(exact).sum()), 4),
        "error_mm": round(float(1000 * np.median(np.abs(e[known])) / 0.6745), 3),
        "sigma_mm": round(float(1000 * np.median(h.sigma[known])), 3),
        "sigma_orientation_mm": round(float(1000 * np.median(h.orientation[known])), 3),
        "with_steps": round(float((h.step[known] > 0).mean()), 3),
        "cells": told((e / h.sigma)[known]),
        "cells_by_span": {
            f"{low:g}-{high:g} m": told((e / h.sigma)[known & (span >= low) & (span < high)])
            for low, high in pairwise(CLASSES)
        },
    }  # fmt: skip
    found["steps"] = along_steps(model, e)
    side = max(2, round(SIDE / file.cell))
    found["means"], _ = apart(model, e, squares(known, side))
    found["means_off_steps"], _ = apart(model, e, squares(known & (span < 0.02), side))
    rows = known & (span < 0.1)
    profiles = []
    for j in range(0, file.height, side):
        for i in range(0, file.width - 2 * side + 1, 2 * side):
            if rows[j, i : i + 2 * side].mean() > FILLED:
                w = np.zeros(e.shape)
                w[j, i : i + 2 * side] = rows[j, i : i + 2 * side]
                profiles.append(w / w.sum())
    found["profiles"], _ = apart(model, e, profiles)
    found["volumes"], _ = apart(model, e, [w.astype(bool) * file.cell**2 for w in squares(known, 3 * side)])
    if given.halves:
        found["halves"] = halves(*given.halves)
    print(json.dumps(found, indent=1))
    if given.keep:
        path = ROOT / "benchmarks/results/surface_heights.json"
        path.write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
