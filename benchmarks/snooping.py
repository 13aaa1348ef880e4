"""Data snooping on facade strips with 3 % gross errors: what is found, what is lost, what is left untrue.

    python benchmarks/snooping.py [runs=10]

A wall photographed in two strips with 60 % overlap, so that most points have two to four rays.  Counted over the runs:
gross errors that are out at the end, good image points of points that stay which are out, points that leave whole, and
the mean normalised squared error (of 3) of points that lost a ray and stay with two, and of all others but those in
which a gross error lies hidden along the epipolar plane of two rays, which no test can see.
"""

from __future__ import annotations

import json
import sys
from dataclasses import replace

import numpy as np

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import NotSolvable
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene, brown_camera

SHARE, SIZE_PX, SIGMA_PX = 0.03, (3.0, 40.0), 0.3
PLAIN = {"c": 24.0, **dict.fromkeys(("x0", "y0", "K1", "K2", "K3", "P1", "P2"), 0.0)}


def strips(seed: int):
    """A block with gross errors, its truth, and which rows are wrong."""
    camera = brown_camera(values=PLAIN, estimate=())
    plan = AerialStrips(
        camera=camera, height=12.0, relief=0.5, strips=2, images_per_strip=8, points_per_image=40, seed=seed
    )
    survey = Survey(
        seed=seed, orientation="exact", points="exact", interior="exact", image_sigma_px=SIGMA_PX, control=6,
        control_sigma=(0.002, 0.002, 0.002),
    )  # fmt: skip
    simulation = simulate(aerial_scene(plan), survey)
    block, rng = simulation.observed, np.random.default_rng(seed + 1000)
    o = block.observations
    wrong = (rng.random(len(o)) < SHARE) & ~block.points.is_control.any(axis=1)[o.point]
    turn = rng.uniform(0, 2 * np.pi, len(o))
    size = np.exp(rng.uniform(*np.log(SIZE_PX), len(o)))
    shift = np.stack([np.cos(turn), np.sin(turn)], axis=1) * size[:, None] * wrong[:, None]
    return replace(block, observations=replace(o, xy_px=o.xy_px + shift)), simulation.truth, wrong


def run(seed: int) -> dict:
    """Counts of one block."""
    block, truth, wrong = strips(seed)
    result = decide(block, AdjustmentOptions(jobs=1, reject="snooping"))
    used = result.image_observations.used
    o = block.observations
    rays = np.bincount(o.point, minlength=len(block.points))
    left = np.bincount(o.point[used], minlength=len(block.points))
    tie = ~block.points.is_control.any(axis=1)
    e = result.adjusted.points.xyz - truth.points.xyz
    C = result.precision.object_points
    good = tie & (left >= 2) & np.isfinite(C).all(axis=(1, 2))
    nse = np.full(len(e), np.nan)
    nse[good] = np.einsum("ni,nij,nj->n", e[good], np.linalg.inv(C[good]), e[good])
    thinned = good & (left < rays) & (left == 2)
    gone = tie & (left == 0)
    # along the epipolar plane nothing contradicts an error in one of two rays: no test finds those
    hidden = good & (np.bincount(o.point[wrong & used], minlength=len(good)) > 0)
    thinned_clean, clean = thinned & ~hidden, good & ~thinned & ~hidden
    return {
        "gross": int(wrong.sum()), "found": int((wrong & ~used).sum()),
        "good_lost": int((~wrong & ~used & ~gone[o.point]).sum()), "points_left_out": int(gone.sum()),
        "right_points_left_out": int((gone & (np.bincount(o.point[wrong], minlength=len(gone)) == 0)).sum()),
        "thinned": int(thinned.sum()), "thinned_sum": float(np.nansum(nse[thinned])),
        "hidden": int(hidden.sum()), "thinned_hidden": int((thinned & ~thinned_clean).sum()),
        "others": int(clean.sum()), "others_sum": float(np.nansum(nse[clean])),
    }  # fmt: skip


def main() -> int:
    """All runs together."""
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 10
    rows = []
    for seed in range(runs):
        try:
            rows.append(run(seed))
        except NotSolvable as error:
            print(f"run {seed}: {error}", file=sys.stderr)
    total = {k: sum(r[k] for r in rows) for k in rows[0]}
    total["nse_of_3_thinned"] = total.pop("thinned_sum") / max(total["thinned"], 1)
    total["nse_of_3_others"] = total.pop("others_sum") / max(total["others"], 1)
    print(json.dumps({"runs": len(rows), **total}))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
