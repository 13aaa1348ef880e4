"""Rigs in a room, from rough starts and from none: does `adjust` end where it ends from the truth?

    python benchmarks/rigs.py [draws=100] [case ...]

A room of 6 x 5 x 3 m with 160 points on its walls, six of them control (1 mm); 12 stations of a pair of cameras, of two
that look back to back, of six that look all around; image points with 0.5 px.  Starts by case:

    empty    no exterior orientation, no tie points; mounting near (1 cm, 0.5 degrees) or unknown
    near     stations good to 5 cm and 1.5 degrees, tie points to 5 cm or absent; mounting near
    unknown  the same stations, or none; mounting unknown
    rough    stations good to 20 cm and 5 degrees, tie points to 20 cm or absent; mounting near

A draw is `right` if sigma0 and all coordinates of points, stations and mountings are those of the adjustment from the
truth within 1e-6 of their size, and all image observations take part.
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tests.orientation.rig_blocks import MOUNTING, RIGS, ROOM, rig_block, rough

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import InputError, NotSolvable
from raybundle.numerics.rotation import rotation_from_angles

OPTIONS = AdjustmentOptions(jobs=1, statistics=False, tolerance=1e-9, max_iterations=300)
NAN = float("nan")
CASES = ("empty", "near", "unknown", "rough")
SAME = 1e-6


def started(block, case: str, seed: int):
    """The block with the start of a case; odd seeds have another one than even ones."""
    odd = bool(seed % 2)
    how = {
        "empty": {"centre": NAN, "degrees": 0.0, "points": None, "mounting": "unknown" if odd else "near"},
        "near": {"centre": 0.05, "degrees": 1.5, "points": None if odd else 0.05, "mounting": "near"},
        "unknown": {
            "centre": NAN if odd else 0.05, "degrees": 1.5, "points": None if odd else 0.05, "mounting": "unknown",
        },
        "rough": {"centre": 0.2, "degrees": 5.0, "points": None if odd else 0.2, "mounting": "near"},
    }  # fmt: skip
    return rough(block, seed, **how[case])


def numbers(result) -> np.ndarray:
    """All coordinates, as shares of the room, rotations and mountings of a result."""
    a = result.adjusted
    own = np.array([[c.values[s] for s in MOUNTING] for c in a.cameras if "bx" in c.values])
    mounting = [own[:, :3] / ROOM.max(), rotation_from_angles(own[:, 3:])]
    used = np.isin(np.arange(len(a.points)), a.observations.point)
    parts = [a.points.xyz[used] / ROOM.max(), a.images.centre / ROOM.max(), a.images.rotation, *mounting]
    return np.concatenate([np.ravel(p) for p in parts])


def run(case: str, kind: str, seed: int, block, truth) -> dict:
    """What became of one draw; `truth` is the result from the truth."""
    row = {"case": case, "rig": kind, "seed": seed}
    began = time.process_time()
    try:
        result = adjust(started(block, case, seed), OPTIONS)
    except (NotSolvable, InputError) as error:
        words = " / ".join(str(error).splitlines()[:3])[:220]
        return {**row, "end": "error", "error": f"{type(error).__name__}: {words}"}
    seconds = time.process_time() - began
    lost = int(len(block.observations) - result.image_observations.used.sum())
    off = float(np.abs(numbers(result) - numbers(truth)).max()) if truth is not None else NAN
    same = lost == 0 and off < SAME and abs(result.sigma0 / truth.sigma0 - 1) < SAME
    return {
        **row, "end": "right" if same else "lost" if lost else "elsewhere", "sigma0": round(result.sigma0, 4),
        "lost": lost, "off": off, "notices": sorted({n.code for n in result.notices}), "seconds": round(seconds, 2),
    }  # fmt: skip


def of_truth(block):
    """The result from the truth; None where there is none."""
    try:
        return adjust(block, OPTIONS)
    except (NotSolvable, InputError):
        return None


def main() -> int:
    """All draws, and their ends by case and rig."""
    draws = int(sys.argv[1]) if len(sys.argv) > 1 else 100
    cases = sys.argv[2:] or CASES
    kinds = list(RIGS)
    rows, without_truth = [], 0
    for seed in range(draws):
        kind = kinds[seed // 2 % len(kinds)]
        block = rig_block(kind, seed)
        truth = of_truth(block)
        without_truth += truth is None
        for case in cases:
            rows.append(run(case, kind, seed, block, truth))
            if rows[-1]["end"] != "right":
                print(json.dumps(rows[-1]), file=sys.stderr, flush=True)
    table = {}
    for case in cases:
        mine = [r for r in rows if r["case"] == case]
        of_rig = {k: [r["end"] for r in mine if r["rig"] == k] for k in kinds}
        table[case] = {
            "draws": draws, **{e: sum(r["end"] == e for r in mine) for e in ("right", "lost", "elsewhere", "error")},
            "right_of_rig": {k: f"{e.count('right')} of {len(e)}" for k, e in of_rig.items()},
            "median_cpu_s": round(float(np.median([r["seconds"] for r in mine if "seconds" in r] or [0.0])), 2),
        }  # fmt: skip
    wrong = sum(r["end"] != "right" for r in rows)
    print(
        json.dumps(
            {"draws": draws, "not_right": wrong, "no_result_from_truth": without_truth, "by_case": table}, indent=1
        )
    )
    return int(wrong > 0)


if __name__ == "__main__":
    raise SystemExit(main())
