"""Ordinary sets of photographs that raybundle did not grow up with: does each end as a result, beside pycolmap?

    RAYBUNDLE_PEER_PYTHON=peer/bin/python python benchmarks/ordinary_sets.py FOLDER [FOLDER ...]

FOLDERs of photographs, a gcp_list.txt in one is its control.  Public ones: alicevision/dataset_monstree (full),
natowi/dataset_flowerpot (every fifth), mapillary/OpenSfM (data/lund), merkato/odm_boruszyn_kap.  Prints for each:
photographs oriented, sigma0, observations used of those that the start measured, CPU seconds of both.
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
from pathlib import Path

from runs import measured

HERE = Path(__file__).resolve().parent


def ours(photos: Path, work: Path) -> dict:
    """One run of `raybundle orient`."""
    control = photos / "gcp_list.txt"
    command = [str(Path(sys.executable).parent / "raybundle"), "orient", str(photos), "--out", str(work / "project")]
    run = measured([*command, *(["--control", str(control)] if control.exists() else [])])
    result = json.loads((work / "project/result/result.json").read_text())
    images = result["images"]
    stage = {s["name"]: s for s in result["stages"]}
    return {
        "given": images["given"], "oriented": images["oriented"], "sigma0": result["sigma0"],
        "image_sigma_px": result["image_sigma_px"], "observations": result["observations"],
        "cpu_s": run["cpu_s"], "memory_mb": run["memory_mb"],
        "stages_cpu_s": {k: s["cpu_seconds"] for k, s in stage.items()},
    }  # fmt: skip


def peer(photos: Path, work: Path) -> dict:
    """One run of pycolmap's incremental mapper, if there is one."""
    python = os.environ.get("RAYBUNDLE_PEER_PYTHON")
    if not python:
        return {}
    run = measured([python, str(HERE / "peer_colmap.py"), str(photos), str(work / "peer")])
    told = json.loads(run["output"].strip().splitlines()[-1])
    return {"registered": len(told.get("images", [])), "cpu_s": run["cpu_s"], "memory_mb": run["memory_mb"]}


def main() -> int:
    """All folders."""
    rows = {}
    for folder in map(Path, sys.argv[1:]):
        with tempfile.TemporaryDirectory() as work:
            rows[folder.name] = {"raybundle": ours(folder, Path(work)), "pycolmap": peer(folder, Path(work))}
        print(folder.name, json.dumps(rows[folder.name]), file=sys.stderr)
    print(json.dumps({"sets": rows}))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
