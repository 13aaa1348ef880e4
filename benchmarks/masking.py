"""Data snooping on blocks with 5 to 40 % gross errors: found, lost, and whether the result names what is left.

    python benchmarks/masking.py [blocks=200]

Three networks (testfield, ring, aerial strips), shares of 5, 10, 15, 20, 25, 30, 35, 40 %, sizes of 20, 200 and 2000
standard deviations, a seed each.  A run is `found` if at most 5 % of the gross errors take part at the end and sigma0
is below 1.5; `named` if it is not found and a fault (snooping_masked, snooping_unfinished, an error) says so; `hidden`
if more are left and sigma0 is below 1.5: errors along epipolar planes of points with few rays, which no test sees;
`silent` otherwise.
"""

from __future__ import annotations

import itertools
import json
import sys
import time

import numpy as np

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import NotSolvable
from raybundle.planning import synthetic_networks
from raybundle.planning.simulate import Survey, simulate

SHARES = (0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4)
SIZES_PX = (2.0, 20.0, 200.0)
BARS = {"scale_bars": 1}
CONTROL = {"control": 8, "control_sigma": (0.01, 0.01, 0.01)}
NETWORKS = {
    "testfield": (lambda: synthetic_networks.field_scene(synthetic_networks.TargetField()), BARS),
    "ring": (lambda: synthetic_networks.ring_scene(synthetic_networks.Ring()), BARS),
    "aerial": (lambda: synthetic_networks.aerial_scene(synthetic_networks.AerialStrips()), CONTROL),
}
ENDS = ("found", "named", "hidden", "silent")
SAID = {"snooping_masked", "snooping_unfinished"}


def run(network: str, share: float, size_px: float, seed: int) -> dict:
    """Counts of one block."""
    scene, given = NETWORKS[network]
    simulation = simulate(scene(), Survey(seed=seed, gross_share=share, gross_px=size_px, **given))
    began = time.process_time()
    row = {"network": network, "share": share, "size_px": size_px, "seed": seed, "gross": int(simulation.gross.sum())}
    try:
        result = adjust(simulation.observed, AdjustmentOptions(jobs=1, reject="snooping"))
    except NotSolvable as error:
        return {**row, "end": "named", "error": str(error).splitlines()[0]}
    used = result.image_observations.used
    wrong = simulation.gross
    left = int((wrong & used).sum())
    done = left <= 0.05 * wrong.sum() and result.sigma0 < 1.5
    found = any(n.subject in SAID for n in result.notices)
    end = "found" if done else "named" if found else "hidden" if result.sigma0 < 1.5 else "silent"
    return {
        **row, "end": end, "sigma0": round(result.sigma0, 3),
        "left": left, "good": int((~wrong).sum()), "good_lost": int((~wrong & ~used).sum()),
        "seconds": round(time.process_time() - began, 2),
    }  # fmt: skip


def main() -> int:
    """All blocks, and their counts by network and share."""
    blocks = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    kinds = list(itertools.product(NETWORKS, SHARES, SIZES_PX))
    rows = [run(*kinds[k % len(kinds)], seed=k) for k in range(blocks)]
    table = {}
    for network, share in itertools.product(NETWORKS, SHARES):
        mine = [r for r in rows if (r["network"], r["share"]) == (network, share)]
        counted = [r for r in mine if r["end"] == "found"]
        table[f"{network} {share:.0%}"] = {
            "blocks": len(mine), **{end: sum(r["end"] == end for r in mine) for end in ENDS},
            "gross": sum(r["gross"] for r in counted), "gross_left": sum(r["left"] for r in counted),
            "good": sum(r["good"] for r in counted), "good_lost": sum(r["good_lost"] for r in counted),
        }  # fmt: skip
    ends = {end: sum(r["end"] == end for r in rows) for end in ENDS}
    longest = float(np.max([r.get("seconds", 0.0) for r in rows]))
    print(json.dumps({"blocks": blocks, **ends, "longest_cpu_s": longest, "by_network_and_share": table}, indent=1))
    return int(ends["silent"] > 0)


if __name__ == "__main__":
    raise SystemExit(main())
