"""Older height models that are aligned to a surface: are the stated errors of transformation and volumes true?

    python benchmarks/surface_alignment.py [--draws 100] [--keep]

The quarry of tests/surface/quarry.py: an older model lies elsewhere (shift in height and plan, two tilts) and has noise
of cells and of neighbours, which nobody states; the surface is that of the same date (`still`), of a later one, when
both piles have changed (`moved`), or of the same date with 20 to 40 % of the ground raised by 2 m (`part`).

chi2    of each of the five unknowns over its stated variance, in the mean, and of the volume of a pile's change;
joint   of all five with their covariance, per degree of freedom
false   share of runs in which a region of what did not change is called moved
share   of the heights that are taken as stable;  noise  estimated, beside the drawn one

Bands hold with 99.9 %.  Figures go into benchmarks/results/surface_alignment.json.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

import numpy as np
from scipy.ndimage import map_coordinates
from scipy.stats import binom, chi2

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.surface.quarry import CELL, PLACED, SHAPE, exact, measured, older, rings  # noqa: E402

from raybundle.errors import InputError  # noqa: E402
from raybundle.surfaces.heights.alignment import aligned  # noqa: E402
from raybundle.surfaces.heights.displacement import movements  # noqa: E402
from raybundle.surfaces.heights.outlines import coverage  # noqa: E402
from raybundle.surfaces.heights.resampling import difference  # noqa: E402

NAMES = ("up", "tilt_right", "tilt_up", "right", "above")


def truth(date: int, draws: int, seed: int, *, part: bool = False) -> dict[str, object]:
    """Of one later date; or of a part of the ground that was raised."""
    rng = np.random.default_rng(seed)
    r, c = np.mgrid[: SHAPE[0], : SHAPE[1]].astype(float)
    piles = [coverage([np.column_stack([x[:, 0] / CELL, SHAPE[0] - x[:, 1] / CELL])], SHAPE) for x in rings().values()]
    z, joint, volumes, shares, noise, alarms, refused = [], [], [], [], [], 0, 0
    for _ in range(draws):
        raised = 2.0 * (c < rng.uniform(0.2, 0.4) * SHAPE[1]) if part else 0.0
        new, old = measured(date, rng, exact(date) + raised), older(rng)

        def at(plan: np.ndarray, old: np.ndarray = old) -> np.ndarray:
            places = [r + plan[1] / CELL, c - plan[0] / CELL]
            return map_coordinates(old, places, order=1, mode="constant", cval=np.nan)

        try:
            before, after, a = aligned(at, new)
        except InputError:  # two alignments fit alike
            refused += 1
            continue
        d = difference(before, after)
        e = a.values - PLACED
        z.append(e / a.sigma)
        joint.append(float(e @ np.linalg.solve(a.covariance, e)) / len(e))
        shares.append(a.share)
        noise.append([a.noise.own, a.noise.common, a.noise.reach])
        for w in () if part else piles:
            s = d.sum_of(w * CELL**2)
            volumes.append((s.value - float((w * (exact(date) - exact(0))).sum()) * CELL**2) / s.sigma)
        alarms += not date and not part and bool(movements(d).regions)
    draws -= refused
    found: dict[str, object] = {
        "draws": draws, "refused": refused, "stable": round(float(np.mean(shares)), 3),
        "chi2": {n: round(float(v), 3) for n, v in zip(NAMES, np.mean(np.square(z), axis=0), strict=True)},
        "band_of_chi2": [round(float(chi2.ppf(q, draws)) / draws, 3) for q in (5e-4, 1 - 5e-4)],
        "joint": round(float(np.mean(joint)), 3),
        "band_of_joint": [round(float(chi2.ppf(q, 5 * draws)) / draws / 5, 3) for q in (5e-4, 1 - 5e-4)],
        "noise": [round(float(v), 4) for v in np.mean(noise, axis=0)],
    }  # fmt: skip
    if volumes:
        found["chi2_volumes"] = round(float(np.mean(np.square(volumes))), 3)
    if not date and not part:
        found |= {"false": alarms / draws, "false_at_most": float(binom.ppf(1 - 5e-4, draws, 0.05)) / draws}
    return found


def main() -> None:
    """Both."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--draws", type=int, default=100)
    parser.add_argument("--keep", action="store_true", help="into benchmarks/results/surface_alignment.json")
    given = parser.parse_args()
    found = {name: truth(date, given.draws, 11 + date) for name, date in (("still", 0), ("moved", 2))}
    found["part"] = truth(0, given.draws, 12, part=True)
    print(json.dumps(found, indent=1))
    if given.keep:
        path = ROOT / "benchmarks/results/surface_alignment.json"
        path.write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
