"""`raybundle orient` beside pycolmap on the same photographs, alternately, in one run.

    python benchmarks/orient.py [--repeat 3] [--sets portal fountain-p11 ...] [--no-peer]

Needs RAYBUNDLE_DATA (default ../shared/data) for all but the rendered set, and a Python that has pycolmap 4.2.1:
RAYBUNDLE_PEER_PYTHON (default: this one).  Both sides get two processors and two threads; time and memory are those
of the whole process with its children, ours with the report.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import shutil
import statistics
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from runs import errors, measured, of_block

HERE = Path(__file__).resolve().parent
DATA = Path(os.environ.get("RAYBUNDLE_DATA", HERE.parents[1] / "shared/data")) / "photos"
PEER = os.environ.get("RAYBUNDLE_PEER_PYTHON", sys.executable)
WORK = HERE / "work" / "orient"
STRECHA = "2759.48,2764.16,1520.69,1006.81"


@dataclass(frozen=True, kw_only=True)
class Case:
    """A set of photographs and what is given with it."""

    photos: Path
    calibration: Path | None = None
    pinhole: str = ""
    """the same for pycolmap: fx, fy, cx, cy"""
    truth: Path | None = None
    """a block folder, or a table of cameras"""
    arguments: tuple[str, ...] = ()
    """of ours, beside"""


PORTAL = HERE.parent / "demo_data/portal"
CASES = {
    "portal": Case(photos=PORTAL / "photos", truth=PORTAL / "truth"),
    **{
        name: Case(
            photos=DATA / name / "images", calibration=DATA / name / "calibration.toml", pinhole=STRECHA,
            truth=DATA / name / "cameras.csv",
        )
        for name in ("fountain-p11", "herzjesu-p8", "castle-p19")
    },
    "fountain-p11 free": Case(photos=DATA / "fountain-p11/images", truth=DATA / "fountain-p11/cameras.csv"),
    "sceaux-castle": Case(photos=DATA / "sceaux-castle/images"),
    "copr-uav": Case(photos=DATA / "copr-uav/images"),
}  # fmt: skip


def truth_of(case: Case) -> dict[str, dict]:
    """The true cameras, where the set has them."""
    if case.truth is None or not case.truth.exists():
        return {}
    if case.truth.is_dir():
        return of_block(case.truth)
    with case.truth.open(newline="") as file:
        return {
            row["image"]: {
                "centre": [float(row[k]) for k in "XYZ"],
                "rotation": np.array([float(row[f"R{i}{j}"]) for i in (1, 2, 3) for j in (1, 2, 3)]).reshape(3, 3),
            }
            for row in csv.DictReader(file)
        }


def ours(name: str, case: Case) -> dict:
    """One run of ours, from nothing."""
    out = WORK / name.replace(" ", "-") / "project"
    shutil.rmtree(out, ignore_errors=True)
    command = [sys.executable, "-m", "raybundle", "orient", str(case.photos), "--out", str(out), "--jobs", "2"]
    if case.calibration is not None:
        command += ["--calibration", str(case.calibration)]
    run = measured([*command, *case.arguments, "--progress", "none"])
    result = json.loads((out / "result/result.json").read_text())
    with (out / "result/observations.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    used = np.array([[float(r["vx_px"]), float(r["vy_px"])] for r in rows if not r["rejected"]])
    run.pop("output")
    return {
        **run,
        "given": result["images"]["given"],
        "oriented": result["images"]["oriented"],
        "image_observations": len(used),
        "rejected_share": 1 - len(used) / len(rows),
        "mean_residual_px": float(np.linalg.norm(used, axis=1).mean()),
        "image_sigma_px": result["image_sigma_px"],
        "sigma0": result["sigma0"],
        "stages": {s["name"]: round(s["cpu_seconds"], 2) for s in result["stages"]},
        **errors(of_block(out / "result/block"), truth_of(case)),
    }


def peer(name: str, case: Case) -> dict:
    """One run of pycolmap, from nothing."""
    work = WORK / name.replace(" ", "-") / "peer"
    command = [PEER, str(HERE / "peer_colmap.py"), str(case.photos), str(work)]
    run = measured(command + (["--pinhole", case.pinhole] if case.pinhole else []))
    found = json.loads(run.pop("output").strip().splitlines()[-1])
    images = found.pop("images")
    return {**run, **found, **errors(images, truth_of(case))}


def middle(runs: list[dict]) -> dict:
    """The first run, its times and memory replaced by the medians of all."""
    return {**runs[0], **{k: statistics.median(r[k] for r in runs) for k in ("wall_s", "cpu_s", "memory_mb")}}


def compare(name: str, repeat: int, *, with_peer: bool) -> dict:
    """Alternate runs; medians, and medians of the ratios of the pairs."""
    case = CASES[name]
    pairs = [(ours(name, case), peer(name, case) if with_peer else None) for _ in range(repeat)]
    row: dict = {"set": name, "runs": repeat, "raybundle": middle([a for a, _ in pairs])}
    if with_peer:
        row["pycolmap"] = middle([b for _, b in pairs])
        for key in ("wall_s", "cpu_s", "memory_mb"):
            row[f"{key} ratio"] = statistics.median(b[key] / a[key] for a, b in pairs)
    return row


def main() -> None:
    """Print the figures as JSON."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--repeat", type=int, default=int(os.environ.get("RAYBUNDLE_BENCH_REPEAT", "3")))
    parser.add_argument("--sets", nargs="*", choices=list(CASES), default=["fountain-p11", "fountain-p11 free"])
    parser.add_argument("--no-peer", action="store_true")
    options = parser.parse_args()
    there = [name for name in options.sets if CASES[name].photos.is_dir()]
    absent = [name for name in options.sets if name not in there]
    rows = [compare(name, options.repeat, with_peer=not options.no_peer) for name in there]
    print(json.dumps({"orientation": rows, "absent": absent}, indent=1))


if __name__ == "__main__":
    main()
