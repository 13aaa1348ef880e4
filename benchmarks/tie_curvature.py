"""The constants by which tie points are corrected for curvature within their windows, fitted to rendered sets.

    python benchmarks/tie_curvature.py FOLDER [FOLDER ...] [--judged FOLDER ...]

FOLDER is what tools/render.py wrote. Each is oriented without the correction. Those of `raybundle.ties.curvature` are
of the sets terrain-a1, terrain-a11, terrain-a13, terrain-b12 and facade-a1 of the ledger. Student's likelihood of
errors along the mean rays, as in `tie_roughness.py`; the last two constants are those of the fit times 1.43. Robust
chi-square and shares beyond five standard deviations: without the correction, with the constants in use, with those of
the fit.
Prints JSON.
"""

import argparse
import json
import sys
import tempfile
from pathlib import Path

import numpy as np
from renderer.judging import nearest_ways, robust_chi_square
from scipy.optimize import minimize
from tie_roughness import FEWEST, FREEDOM, NAMES, SCALE
from tie_roughness import Set as Oriented

from raybundle.cli.main import main as raybundle
from raybundle.ties import curvature, precise

NAMED = ("FITTING", "SIGNIFICANT", "SHARED", "BEYOND", "OF_RESIDUALS", "OF_CORRECTION")
USED = np.array([getattr(curvature, name) for name in NAMED])
LAST = np.array([1, 1, 1, 1, SCALE, SCALE])


def oriented(folder, project):
    """Orient photographs without the correction; what it would have been given."""
    held = []

    def instead(*given):
        held.append(given)
        return given[0]

    precise.without_curvature, kept = instead, precise.without_curvature
    sys.argv = ["raybundle", "orient", str(folder / "photos"), "--out", str(project), "--no-library", "--no-report",
                "--control", str(folder / "control.csv"), "--mark-sigma", "0.05"]  # fmt: skip
    try:
        raybundle()
    except SystemExit as ended:
        if ended.code:
            raise
    finally:
        precise.without_curvature = kept
    return held[0]


class Set(Oriented):
    """Tie points of a rendered set without the correction, and what it is made from."""

    def __init__(self, folder):
        with tempfile.TemporaryDirectory() as place:
            self.given = oriented(folder, Path(place) / "project")
            super().__init__(folder, Path(place) / "project")
        self.name = str(folder)
        block, _, reference, matched = self.given
        self.rows = np.flatnonzero(matched)
        self.parallax = curvature.parallax(block, self.rows, reference)
        number = {name: k for k, name in enumerate(block.points.ids)}
        self.at = np.array([number[name] for name in self.ids])
        self.along = self.seen.along + self.seen.variance()

    def corrected(self, constants):
        """(k,) each: by how much points move along their mean rays, and the variance of what is left."""
        for name, value in zip(NAMED, constants, strict=True):
            setattr(curvature, name, value)
        block = self.given[0]
        found, o, p = curvature.without_curvature(*self.given), block.observations, self.parallax
        shift = (found.observations.xy_px - o.xy_px)[self.rows]
        point, n = o.point[self.rows], len(block.points)
        depth, unit = (np.bincount(point, (p * v).sum(axis=1), n) for v in (shift, p))
        moved = np.divide(depth, unit, out=np.zeros(n), where=unit > 0)
        return -moved[self.at], np.nan_to_num(found.points.sigma_curvature[self.at]) ** 2

    def unlikely(self, constants):
        """Negative logarithm of the likelihood."""
        moved, more = self.corrected(constants)
        v, e = (self.along + more)[self.there], (self.error + moved)[self.there]
        return self.weight[self.there] @ (np.log(v) / 2 + (FREEDOM + 1) / 2 * np.log1p(e**2 / v / FREEDOM))

    def ratios(self, constants=None):
        """(k,) errors in standard deviations; NaN beyond the core."""
        moved, more = (0.0, 0.0) if constants is None else self.corrected(constants)
        added = self.seen.variance() + more
        ways, sigma = nearest_ways(
            self.normals, self.C + added[:, None, None] * self.rays[:, :, None] * self.rays[:, None]
        )
        xyz, found = self.xyz + np.multiply(moved, self.rays.T).T, np.full(len(self.xyz), np.nan)
        found[self.there] = self.surface.distances(xyz[self.there], ways[self.there]) / sigma[self.there]
        return found


def main():
    """Fit, and print the constants beside those in use."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fitted", nargs="*", type=Path)
    parser.add_argument("--judged", nargs="*", type=Path, default=[])
    options = parser.parse_args()
    sets = [Set(folder.resolve()) for folder in options.fitted]
    judged = [Set(folder.resolve()) for folder in options.judged]
    fit = USED
    if sets:
        begin = np.log(USED / LAST)
        fit = LAST * np.exp(minimize(lambda b: sum(s.unlikely(np.exp(b)) for s in sets), begin, method="Nelder-Mead").x)
    found = {}
    for one in [*sets, *judged]:
        ratios = [one.ratios(), one.ratios(USED), one.ratios(fit)]
        parts = {NAMES[k]: (one.classes == k) & np.isfinite(ratios).all(axis=0) for k in np.unique(one.classes)}
        found[one.name] = {
            name: {
                "points": int(m.sum()),
                "chi_square": [round(robust_chi_square(r[m]), 2) for r in ratios],
                "beyond_5": [round(float(np.mean(np.abs(r[m]) > 5)), 4) for r in ratios],
            }
            for name, m in parts.items()
            if m.sum() > FEWEST
        }
    used, best = (dict(zip(NAMED, b.round(3).tolist(), strict=True)) for b in (USED, fit))
    print(json.dumps({"used": used, "fitted": best, "without, used, fitted": found}, indent=1))


if __name__ == "__main__":
    main()
