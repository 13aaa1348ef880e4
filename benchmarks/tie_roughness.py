"""The constants by which relief within the windows widens tie points, fitted to rendered sets.

    python benchmarks/tie_roughness.py FOLDER=PROJECT [FOLDER=PROJECT ...] [--judged FOLDER=PROJECT ...]

FOLDER is what tools/render.py wrote, PROJECT that of `raybundle orient FOLDER/photos --control FOLDER/control.csv
--mark-sigma 0.05 --no-library --out PROJECT`.  Those of `raybundle.adjustment.roughness` are of three sets:
terrain --seed 1 --photographs 12 --width 1600 --quality 93;
terrain --seed 12 --photographs 9 --width 1600 --gsd 0.004 --quality 80 --camera B;
terrain --seed 13 --photographs 9 --width 1600 --gsd 0.001 --quality 95 --subsampling 4:4:4 --blur 0.8.
Student's likelihood of the errors along the normal; a class of n points of a set weighs as the root of n.  The factor
is that of the fit times 1.43: its scale then holds 68 % of the errors as a standard deviation does, not 61 %.  Sets
that are judged alone: terrain --seed 11; terrain --seed 31 --photographs 8 --width 1200 --kinds
pattern,pattern,pattern,pattern,step,clutter --bricks 0.03; terrain --seed 32 --camera B --photographs 5 --width 1200
--kinds pattern,pattern,pattern,pattern,pattern,slope --bricks 0.02 --quality 85.  Prints JSON.
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
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.roughness import BY_MISFIT, BY_RELIEF, BY_RESIDUALS, BY_WINDOW, FACTOR, terms
from raybundle.block import Role
from raybundle.io.block.folder import read_block

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tools"))
from renderer.classes import NAMES
from renderer.judging import robust_chi_square
from renderer.truth import read_surface

HALF_PX = 6.0
FREEDOM = 3
FEWEST = 20


def points_of(folder, project):
    """Terms (n, 5), variances without relief, errors along the normal and classes of the tie points of a set."""
    block = read_block(project / "result/block")
    plain = replace(block, points=replace(block.points, window=None))  # without it nothing is added
    result = adjust_block(plain, AdjustmentOptions(noise="fields", datum="control"))
    p = replace(result.adjusted.points, window=block.points.window)
    result = replace(result, adjusted=replace(result.adjusted, points=p))
    variance = np.diagonal(result.precision.object_points, axis1=1, axis2=2)
    known = np.isfinite(p.misfit) & np.isfinite(p.relief) & np.isfinite(variance).all(axis=1)
    known &= np.asarray(p.role) == Role.TIE
    surface = read_surface(folder)
    xyz, half = p.xyz[known], HALF_PX * surface.gsd
    normal = surface.window_planes(xyz, half)[1]
    square = np.einsum("pi,pij,pj->p", normal, result.precision.object_points[known], normal)
    there = surface.in_core(xyz)
    error = np.full(len(xyz), np.nan)
    error[there] = surface.distances(xyz[there], normal[there])
    there &= np.isfinite(error)
    logs = np.column_stack([np.ones(len(xyz)), terms(result, known)])
    return logs[there], square[there], error[there], surface.classes_at(xyz, half)[there]


def pair(text):
    """Folder and project of FOLDER=PROJECT."""
    folder, project = text.split("=")
    return Path(folder), Path(project)


def weights(classes):
    """(n,) so that a class counts as the root of its points."""
    found = np.zeros(len(classes))
    for k, n in zip(*np.unique(classes, return_counts=True), strict=True):
        found[classes == k] = n**-0.5 if n > FEWEST else 0.0
    return found


def main():
    """Fit, and print the constants beside those in use."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fitted", nargs="+", type=pair)
    parser.add_argument("--judged", nargs="*", type=pair, default=[])
    options = parser.parse_args()
    given = [*options.fitted, *options.judged]
    every = [points_of(*one) for one in given]
    sets = every[: len(options.fitted)]

    def unlikely(b):
        total = 0.0
        for logs, square, error, classes in sets:
            v = square * (1 + np.exp(np.clip(logs @ b, -40, 30)))
            each = np.log(v / square) / 2 + (FREEDOM + 1) / 2 * np.log1p(error**2 / v / FREEDOM)
            total += weights(classes) @ each
        return total

    used = np.array([np.log(FACTOR), BY_MISFIT, BY_RELIEF, BY_RESIDUALS, BY_WINDOW])
    fit = minimize(unlikely, used, method="Nelder-Mead", options={"maxiter": 2000, "xatol": 0.01, "fatol": 0.01})
    fit.x[0] += 2 * np.log(t.ppf((1 + 0.6827) / 2, FREEDOM))
    judged = {}
    for (folder, _), (logs, square, error, classes) in zip(given, every, strict=True):
        ratios = [
            error / np.sqrt(square * (1 + np.exp(logs @ b))) for b in (np.array([-40.0, 0, 0, 0, 0]), used, fit.x)
        ]
        parts = {NAMES[k]: classes == k for k in np.unique(classes)} | {"all": np.ones(len(classes), bool)}
        judged[folder.name] = {
            name: {
                "chi_square": [round(robust_chi_square(r[m]), 2) for r in ratios],
                "beyond_5": [round(float(np.mean(np.abs(r[m]) > 5)), 4) for r in ratios],
            }
            for name, m in parts.items()
            if m.sum() > FEWEST
        }
    constants = {"fitted": [float(np.exp(fit.x[0])), *fit.x[1:].tolist()], "used": [FACTOR, *used[1:].tolist()]}
    print(json.dumps({**constants, "without, used, fitted": judged}, indent=1))


if __name__ == "__main__":
    main()
