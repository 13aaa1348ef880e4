"""Are standard deviations true where noise is not white: halves of real photographs, simulated smooth errors, the time.

python benchmarks/real_sigmas.py [--splits 20] [--runs 25] [RESULT ...]

RESULTs are result folders of `raybundle orient` or `calibrate`, or block folders.  Each is halved at random by
photographs; both halves are adjusted by themselves, each with its own floor and fields, and the difference of their
interior orientations (and of 20 common points after a similarity) is taken over its stated covariance: chi-square per
parameter, 1 where the covariance is true.  Without RESULTs, white noise and smooth errors are simulated.
"""

from __future__ import annotations

import argparse
import csv
import json
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.truth.real_noise import adjusted, halves, interior_error, with_smooth_errors

from raybundle import adjust
from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.evaluation.noise_covariance import under_noise
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block.select import with_rows
from raybundle.errors import RaybundleError
from raybundle.io.block.folder import read_block
from raybundle.planning.flights.uav_networks import Flight, flight_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, Ring, TargetField, aerial_scene, field_scene, ring_scene

FREE = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2")


def block_of(folder: Path):
    """The block of a result folder without what was rejected, or a block folder; the parameters that were free."""
    if not (folder / "result.json").exists():
        block = read_block(folder)
        there = adjust(block).adjusted  # approximate values, where the folder has none
        return replace(
            block, cameras=there.cameras, images=there.images, points=replace(block.points, xyz=there.points.xyz)
        )
    block = read_block(folder / "block")
    with (folder / "observations.csv").open() as file:
        used = np.array([not row["rejected"] for row in csv.DictReader(file)])
    told = json.loads((folder / "result.json").read_text())["cameras"]
    free = {
        c: tuple(s for s, p in parameters.items() if p["status"] not in {"held", "not determinable", "not significant"})
        for c, parameters in told.items()
    }
    # a camera that was held is calibrated here: what halves are to agree in
    cameras = tuple(replace(c, estimate=free.get(c.id) or FREE) for c in block.cameras)
    return with_rows(replace(block, cameras=cameras), used)


def of_halves(folder: Path, count: int) -> dict:
    """One set."""
    began = time.perf_counter()
    whole, rows, lost = halves(block_of(folder), count)
    if not rows:
        return {"images": whole.noise.images, "splits": 0, "not_solvable": lost}
    names = [f"{of}_{by}" for of in ("interior", "points") for by in ("white", "fields")]
    table = {k: v for k in names if len(v := np.array([r[k] for r in rows if k in r]))}
    noise = whole.noise
    found = {
        "images": noise.images, "splits": len(rows), "not_solvable": lost,
        "phi": noise.phi, "tau_px": noise.tau_px, "share": noise.share,
        "directions": noise.directions, "ratio_interior": noise.ratio_interior,
        "parameters": sum(len(i.free) for i in whole.interior),
    }  # fmt: skip
    for k, v in table.items():
        found[k] = {"median": float(np.median(v)), "p90": float(np.quantile(v, 0.9)), "max": float(v.max())}
    return found | {"seconds": time.perf_counter() - began}


def scenes():
    """Five geometries."""
    yield "field", field_scene(TargetField(rows=12, columns=16))
    yield "ring", ring_scene(Ring(points=400))
    yield "strips", aerial_scene(AerialStrips())
    yield "flight", flight_scene(Flight())
    yield "few", field_scene(TargetField(rows=10, columns=14, stations=6, frontal=2))


CASES = {
    "white": {},
    "fields of degree 2": {"degree": 2, "tau_px": 0.3},
    "fields of degree 8": {"degree": 8, "tau_px": 0.3},
    "common field of 0.1 px": {"degree": 3, "tau_px": 0.0, "common_px": 0.1},
    "focus wanders by 0.1 %": {"degree": 1, "tau_px": 0.0, "focus": 1e-3},
}


def simulated(scene, errors: dict, runs: int) -> dict:
    """Interior orientations against the truth."""
    rows, phi, tau = [], [], []
    camera = replace(scene.camera, estimate=FREE)
    for seed in range(runs):
        near = Survey(seed=seed, image_sigma_px=0.2, points="exact", orientation="exact", interior="exact")
        done = simulate(replace(scene, camera=camera), near)
        rng = np.random.default_rng(1000 + seed)
        block = with_smooth_errors(done.observed, rng, **errors) if errors else done.observed
        result = adjusted(block)
        rows.append(interior_error(result, done.truth))
        phi.append(result.noise.phi)
        tau.append(result.noise.tau_px)
    white, fields = np.array(rows).T
    return {
        "runs": runs, "white": float(white.mean()), "fields": float(fields.mean()),
        "over_plain": float((fields / white).mean()), "phi": float(np.median(phi)), "tau_px": float(np.median(tau)),
    }  # fmt: skip


def seconds(folder: Path) -> dict:
    """CPU seconds of the final adjustment, and of what the noise adds."""
    block = block_of(folder)
    began = time.process_time()
    result = decide(block, AdjustmentOptions(reject="snooping", tolerance=1e-4, noise="white"))
    between = time.process_time()
    under_noise(result)
    return {"adjustment_cpu_s": between - began, "noise_cpu_s": time.process_time() - between}


def main() -> int:
    """Halves of all results, or the simulations."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--splits", type=int, default=20)
    parser.add_argument("--runs", type=int, default=25)
    parser.add_argument("results", nargs="*", type=Path)
    asked = parser.parse_args()
    found = {}
    for folder in asked.results:
        name = folder.parent.name if folder.name == "result" else folder.name
        try:
            found[name] = of_halves(folder, asked.splits) | seconds(folder)
        except RaybundleError as error:
            found[name] = {"failed": str(error)}
        print(name, json.dumps(found[name]), file=sys.stderr, flush=True)
    if not asked.results:
        for name, scene in scenes():
            for case, errors in CASES.items():
                found[f"{name}, {case}"] = simulated(scene, errors, asked.runs)
                print(name, case, json.dumps(found[f"{name}, {case}"]), file=sys.stderr, flush=True)
    print(json.dumps({"sets" if asked.results else "simulated": found}, indent=1))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
