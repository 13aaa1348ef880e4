"""The constants by which relief and noise of a place widen tie points, fitted to rendered sets.

    python benchmarks/tie_roughness.py FOLDER=PROJECT [FOLDER=PROJECT ...] [--judged FOLDER=PROJECT ...]

FOLDER is what tools/render.py wrote, PROJECT that of `raybundle orient FOLDER/photos --control FOLDER/control.csv
--mark-sigma 0.05 --no-library --out PROJECT`.  Those of `raybundle.adjustment.evaluation.tie_roughness` are of 18
sets, terrain with
--seed 1 --photographs 12 --width 1600 --quality 93 --full-well 12000;
--seed 12 --photographs 9 --width 1600 --gsd 0.004 --quality 80 --camera B --full-well 12000;
--seed 13 --photographs 9 --width 1600 --gsd 0.001 --quality 95 --subsampling 4:4:4 --blur 0.8 --full-well 12000;
--seed 11 --photographs 14 --width 2000; --seed 41 --photographs 8 --width 1200;
--seed 321 --photographs 9 --width 1200 --quality 90; --seed 7351 --photographs 9 --width 1200 --quality 85;
--photographs 8 --width 1200 --kinds weak,weak,weak,weak,clutter,clutter and --seed 301 --quality 80, --seed 311
--quality 93 --full-well 12000, --seed 312 --quality 80 --full-well 12000;
--photographs 10 --width 1200 and --seed 77550 --gsd 0.003 --quality 88 --camera B, --seed 17597 --gsd 0.0015 --quality
95 --blur 0.6, --seed 41280 --gsd 0.0025 --quality 80, --seed 27089 --gsd 0.001 --quality 90 --blur 0.8 --camera B,
--seed 27288 --gsd 0.002 --quality 85, --seed 11475 --gsd 0.0035 --quality 92 --blur 0.7, --seed 37063 --gsd 0.002
--quality 90 --kinds step,step,ridge,clutter,weak,step, --seed 63038 --gsd 0.0025 --quality 85 --camera B --kinds
weak,step,ridge,weak,pattern,step.
Student's likelihood of the errors along the mean rays; a class of n points of a set weighs as the root of n.  Factors
are those of the fit times 1.43: its scale then holds 68 % of the errors as a standard deviation does, not 61 %.
OF_PLACE takes no part in the fit.  Robust chi-square and shares beyond five standard deviations are those of
tools/judge_points.py: "without" what is added, with the constants in "use", and with those "fitted" to the other sets
(of a judged set: to all).  Prints JSON.
"""

import argparse
import json
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.optimize import minimize
from scipy.stats import t

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.tie_roughness import (
    BY_MISFIT,
    BY_NOISE,
    BY_RELIEF,
    BY_RESIDUALS,
    BY_WINDOW,
    FACTOR,
    OF_SCATTER,
    mean_rays,
    witnesses,
)
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Role
from raybundle.io.block.folder import read_block

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tools"))
from renderer.classes import NAMES
from renderer.judging import nearest_ways, robust_chi_square
from renderer.truth import read_surface

HALF_PX = 6.0
FREEDOM = 3
FEWEST = 20
SCALE = t.ppf((1 + 0.6827) / 2, FREEDOM) ** 2
USED = np.array([np.log(FACTOR), BY_MISFIT, BY_RELIEF, BY_RESIDUALS, BY_WINDOW, BY_NOISE, np.log(OF_SCATTER)])


class Set:
    """Tie points of a rendered set, with what they show, and their errors."""

    def __init__(self, folder, project):
        self.name = folder.name
        block = read_block(project / "result/block")
        plain = replace(block, points=replace(block.points, window=None))  # without it nothing is added
        result = adjust_block(plain, AdjustmentOptions(noise="fields", datum="control"))
        p = replace(result.adjusted.points, window=block.points.window)
        result = replace(result, adjusted=replace(result.adjusted, points=p))
        C = result.precision.object_points
        rays, towards = mean_rays(result)
        known = towards & np.isfinite(p.misfit) & np.isfinite(p.relief) & np.isfinite(C).all(axis=(1, 2))
        known &= np.asarray(p.role) == Role.TIE
        self.ids = np.asarray(p.ids)[known]
        self.seen = witnesses(result, known, rays[known])
        self.bent = 0.0 if p.sigma_curvature is None else np.nan_to_num(p.sigma_curvature[known]) ** 2
        self.surface = read_surface(folder)
        self.xyz, self.rays, self.C = p.xyz[known], rays[known], C[known]
        half = HALF_PX * self.surface.gsd
        self.normals, self.classes = self.surface.normals(self.xyz, half), self.surface.classes_at(self.xyz, half)
        self.error = np.full(len(self.xyz), np.nan)
        self.there = self.surface.in_core(self.xyz)
        self.error[self.there] = self.surface.distances(self.xyz[self.there], self.rays[self.there])
        self.there &= np.isfinite(self.error)
        self.weight = np.zeros(len(self.xyz))
        for k, n in zip(*np.unique(self.classes[self.there], return_counts=True), strict=True):
            self.weight[self.there & (self.classes == k)] = n**-0.5 if n > FEWEST else 0.0

    def unlikely(self, b):
        """Of constants: negative logarithm of the likelihood."""
        m = self.there
        added = self.bent + self.seen.variance(np.exp(b[0]), b[1:6], np.exp(b[6]), of_place=0.0)
        v = (self.seen.along + added)[m]
        return self.weight[m] @ (np.log(v) / 2 + (FREEDOM + 1) / 2 * np.log1p(self.error[m] ** 2 / v / FREEDOM))

    def ratios(self, b=None):
        """(k,) errors in standard deviations; NaN beyond the core."""
        added = np.zeros(len(self.xyz))
        if b is not None:
            added += self.bent + self.seen.variance(np.exp(b[0]), b[1:6], np.exp(b[6]))
        C = self.C + added[:, None, None] * self.rays[:, :, None] * self.rays[:, None, :]
        ways, sigma = nearest_ways(self.normals, C)
        found = np.full(len(self.xyz), np.nan)
        found[self.there] = self.surface.distances(self.xyz[self.there], ways[self.there]) / sigma[self.there]
        return found


def pair(text):
    """Folder and project of FOLDER=PROJECT."""
    folder, project = text.split("=")
    return Path(folder), Path(project)


def fitted(sets, start=USED):
    """Constants (7,) of most likelihood."""
    begin = start.copy()
    begin[[0, 6]] -= np.log(SCALE)
    found = minimize(lambda b: sum(s.unlikely(b) for s in sets), begin, method="BFGS", options={"gtol": 1e-2}).x
    found[[0, 6]] += np.log(SCALE)
    return found


def main():
    """Fit, and print the constants beside those in use."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fitted", nargs="*", type=pair)
    parser.add_argument("--judged", nargs="*", type=pair, default=[])
    options = parser.parse_args()
    sets = [Set(*one) for one in options.fitted]
    judged = [Set(*one) for one in options.judged]
    every = fitted(sets) if sets else USED
    found = {}
    for one in [*sets, *judged]:
        others = [s for s in sets if s is not one]
        b = fitted(others, every) if others and one in sets else every
        ratios = [one.ratios(), one.ratios(USED), one.ratios(b)]
        parts = {NAMES[k]: one.classes == k for k in np.unique(one.classes)} | {"all": np.ones(len(one.xyz), bool)}
        found[one.name] = {
            name: {
                "points": int(m.sum()),
                "chi_square": [round(robust_chi_square(r[m]), 2) for r in ratios],
                "beyond_5": [round(float(np.mean(np.abs(r[m]) > 5)), 4) for r in ratios],
            }
            for name, mine in parts.items()
            for m in [mine & one.there & np.isfinite(ratios).all(axis=0)]
            if m.sum() > FEWEST
        }
        added = one.seen.variance()
        even = one.there & (one.classes == NAMES.index("smooth"))
        if even.any():
            wider = np.sqrt(1 + added[even] / one.seen.along[even])
            found[one.name]["smooth"]["wider"] = round(float(np.median(wider)), 4)
    constants = {
        name: [*np.exp(b[:1]).tolist(), *b[1:6].tolist(), *np.exp(b[6:]).tolist()]
        for name, b in (("fitted", every), ("used", USED))
    }
    print(json.dumps({**constants, "without, used, fitted": found}, indent=1))


if __name__ == "__main__":
    main()
