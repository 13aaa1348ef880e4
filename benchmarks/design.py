"""`raybundle`'s optimiser of stations beside the long search of `design_search.py`, on the same problems.

Both are judged by `design_problems.Judge`, which knows nothing of raybundle: benchmarks/results/design.json.

    python benchmarks/design.py [NAME ...]
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

import numpy as np
from design_problems import Judge, Problem, look, problems

from raybundle.objects.surface import Surface, SurfacePoints
from raybundle.planning.network.candidates import Stations
from raybundle.planning.network.configuration import Designer, improved
from raybundle.planning.network.expected import Networks
from raybundle.planning.network.site import Access, Site
from raybundle.planning.synthetic_networks import brown_camera

RESULTS = Path(__file__).with_name("results")
NONE = ("x0", "y0", "K1", "K2", "K3", "P1", "P2")


def site_of(p: Problem, judge: Judge) -> Site:
    values = {**dict.fromkeys(NONE, 0.0), "c": 0.004 * p.c_px}
    camera = brown_camera(values=values, size_px=p.size_px, estimate=("c", "x0", "y0", "K1") if p.free else ())
    return Site(
        surface=Surface(name=p.name, vertices=np.array(p.vertices), triangles=np.array(p.triangles)),
        points=SurfacePoints(xyz=p.targets, normal=p.normals), camera=camera, sigma_px=p.sigma_px, depth=p.depth,
        access=Access(low=p.low, high=p.high, allowed=lambda centre: judge.violation(centre) == 0),
        incidence_deg=p.incidence_deg,
    )  # fmt: skip


def run(p: Problem) -> dict[str, object]:
    judge = Judge(p)
    site = site_of(p, judge)
    centre, at, roll = p.start
    begun = time.process_time()
    design = improved(Designer(Networks(site), p.objective), Stations(centre=centre, at=at, roll=roll))
    cpu = time.process_time() - begun
    s = design.stations
    start, found = judge.sigma(centre, look(centre, at, roll)), judge.sigma(s.centre, look(s.centre, s.at, s.roll))
    return {
        "objective": p.objective,
        "start_mm": 1e3 * start if np.isfinite(start) else None,
        "raybundle_mm": 1e3 * found if np.isfinite(found) else None,
        "cpu_s": round(cpu, 1),
        "allowed": bool((judge.violation(s.centre) == 0).all()),
        "tried": design.tried,
    }


if __name__ == "__main__":
    searched = json.loads((RESULTS / "design_search.json").read_text())
    out = RESULTS / "design.json"
    done = json.loads(out.read_text()) if out.exists() else {}
    for p in problems():
        if sys.argv[1:] and p.name not in sys.argv[1:]:
            continue
        r = run(p)
        if p.name in searched:
            r["search_mm"] = searched[p.name]["sigma_mm"]
            r["ratio"] = r["raybundle_mm"] / r["search_mm"]
        done[p.name] = r
        print(p.name, r, flush=True)
        out.write_text(json.dumps(done, indent=1) + "\n")
