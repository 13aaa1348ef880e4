"""Volumes of three dates with drawn errors: are their standard deviations, tests and levels of detection true?

    python benchmarks/surface_time_series.py [--draws 400] [--keep]

A quarry with two piles, one growing, one shrinking (tests/surface/quarry.py); heights have noise that neighbours share
and errors of orientation, of dates of their own (`apart`) or of one adjustment (`one`).

chi2        of changes and of volumes over their stated variances, in the mean
false       share of tests at 5 % without a change that report one: net, fill, cut
any_false   share of runs in which the table without a change reports any, at 5 % for all
found       share of changes as large as the stated smallest detectable one that are found: 80 %

Bands are those that hold with 99.9 %; both piles of a run have the errors of one orientation, and count as one.
Figures go into benchmarks/results/surface_time_series.json.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

import numpy as np
from scipy.stats import binom, chi2

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.surface.quarry import CELL, DATES, SHAPE, exact, measured, of_one, rings  # noqa: E402

from raybundle.surfaces.heights.outlines import coverage  # noqa: E402
from raybundle.surfaces.heights.time_series import RegionWeights, probability, time_series  # noqa: E402

ONE = {"common": 0.05, "own": 0.004}
"""Shift that all dates of one adjustment share, and that of each [m]"""


def regions(base: float | None = None) -> list[RegionWeights]:
    """Of both piles, above the plane along their outlines or a height."""
    found = []
    for name, ring in rings().items():
        cells = np.column_stack([ring[:, 0] / CELL, SHAPE[0] - ring[:, 1] / CELL])
        found.append(RegionWeights(name=name, parts=((coverage([cells], SHAPE), (cells,) if base is None else base),)))
    return found


def drawn(rng: np.random.Generator, kind: str, heights: list[np.ndarray]) -> list:
    """Surfaces of all dates."""
    if kind == "apart":
        return [measured(k, rng, h) for k, h in enumerate(heights)]
    plain = [measured(k, rng, h, common=None) for k, h in enumerate(heights)]
    return of_one(plain, rng.normal(size=3 + len(heights)), **ONE)


def band(n: int, share: float) -> list[float]:
    """Shares of n that hold with 99.9 %."""
    return [round(float(binom.ppf(q, n, share)) / n, 4) for q in (5e-4, 1 - 5e-4)]


def truth(kind: str, draws: int, seed: int) -> dict[str, object]:
    """Chi-square, false changes, power."""
    rng, areas = np.random.default_rng(seed), regions()
    scene = [exact(k) for k in range(len(DATES))]
    weights = {r.name: r.parts[0][0] * CELL**2 for r in areas}
    errors, volumes, joint = [], [], []
    for _ in range(draws):
        for r in time_series(drawn(rng, kind, scene), areas, 0.05):
            w = weights[r.name]
            true = [float((w * (scene[c.end] - scene[c.begin])).sum()) for c in r.changes]
            errors.append([(c.net.value - t) / c.net.sigma for c, t in zip(r.changes, true, strict=True)])
            less = np.array([[-1.0, 1, 0], [0, -1, 1]])
            e = less @ r.volumes - true[:2]
            joint.append(float(e @ np.linalg.solve(less @ r.covariance @ less.T, e)) / 2)
    # the base is level, so that the truth of a volume is known
    for _ in range(draws):
        volumes += [
            (r.volumes - [float((weights[r.name] * (h - 100)).sum()) for h in scene]) / r.sigma
            for r in time_series(drawn(rng, kind, scene), regions(100.0), 0.05)
        ]
    still, alarms, any_false = [scene[0]] * len(DATES), {"net": [], "fill": [], "cut": []}, []
    for _ in range(draws):
        found = time_series(drawn(rng, kind, still), areas, 0.05)
        for r in found:
            for name, all_p in alarms.items():
                all_p.append(probability(getattr(r.changes[0], name)) < 0.05)
        any_false.append(any(c.significant(q) for r in found for c in r.changes for q in (c.net, c.fill, c.cut)))
    hits = []
    for k in range(draws):
        if not k:
            level = [r.changes[0].detectable for r in time_series(drawn(rng, kind, still), areas, 0.05)]
        after = still[0] + sum(d * (w > 0) / w.sum() for d, w in zip(level, weights.values(), strict=True))
        found = time_series(drawn(rng, kind, [still[0], after, after]), areas, 0.05)
        hits += [r.changes[0].significant(r.changes[0].net) for r in found]
    return {
        "draws": draws, "detectable_m3": [round(x, 2) for x in level],
        "chi2": {
            "changes": round(float(np.mean(np.square(errors))), 3), "joint": round(float(np.mean(joint)), 3),
            "volumes": round(float(np.mean(np.square(volumes))), 3),
            "band_of_joint": [round(float(chi2.ppf(q, draws)) / draws, 3) for q in (5e-4, 1 - 5e-4)],
        },
        "false": {name: round(float(np.mean(p)), 4) for name, p in alarms.items()}, "band_of_false": band(draws, 0.05),
        "any_false": round(float(np.mean(any_false)), 4), "any_false_at_most": band(draws, 0.05)[1],
        "found": round(float(np.mean(hits)), 4), "band_of_found": band(draws, 0.8),
    }  # fmt: skip


def main() -> None:
    """Both kinds."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--draws", type=int, default=400)
    parser.add_argument("--keep", action="store_true", help="into benchmarks/results/surface_time_series.json")
    given = parser.parse_args()
    found = {kind: truth(kind, given.draws, 5 + k) for k, kind in enumerate(("apart", "one"))}
    print(json.dumps(found, indent=1))
    if given.keep:
        path = ROOT / "benchmarks/results/surface_time_series.json"
        path.write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
