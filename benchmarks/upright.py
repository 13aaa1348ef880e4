"""Do results that nothing places stand upright?  Rendered truth, plumb edges measured by hand, flights, a strip.

python benchmarks/upright.py [--keep FOLDER]

The portal (rendered) must stand within 2 degrees of the truth; sceaux-castle, castle-p19 and herzjesu-p8 within 3
degrees of the plumb edges of upright_edges.toml, measured by hand; copr-uav and simulated nadir and oblique flights
must be found as such; a strip square to a plane must be called ambiguous.  --keep: where project folders lie or are
put.  Sets that are not there are left out by name.  Exit status 1 where one fails.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tomllib
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.orientation.test_upright import found
from tests.orientation.upright_cases import nadir, oblique, one_strip

from raybundle.block import Block
from raybundle.io.block.folder import read_block

HERE = Path(__file__).resolve().parent
DATA = Path(os.environ.get("RAYBUNDLE_DATA", HERE.parents[1] / "shared" / "data")) / "photos"
PORTAL = HERE.parent / "demo_data" / "portal"
SETS = {"sceaux-castle": False, "castle-p19": True, "herzjesu-p8": True, "copr-uav": False}
"""Photographs, and whether a calibration comes with them."""


def oriented(name: str, folder: Path) -> tuple[Block, dict]:
    """The result of `raybundle orient`, and what it says of the vertical."""
    photos = PORTAL / "photos" if name == "portal" else DATA / name / "images"
    command = ["raybundle", "orient", str(photos), "--out", str(folder), "--progress", "none", "--no-report"]
    if SETS.get(name):
        command += ["--calibration", str(DATA / name / "calibration.toml")]
    subprocess.run([str(Path(sys.executable).parent / command[0]), *command[1:]], check=True, stdout=subprocess.DEVNULL)
    said = json.loads((folder / "result" / "result.json").read_text())
    return read_block(folder / "result" / "block"), said["upright"]


def edges_vertical(block: Block, edges: list[dict]) -> tuple[np.ndarray, float, float]:
    """Direction (3,) upwards of plumb edges, their rms distance from it, and its own standard deviation [deg].

    The last is of the less determined component: a few edges seen to one side leave the other open.
    """
    normals, upward = [], np.zeros(3)
    for e in edges:
        i = block.images.file.index(e["image"])
        camera = block.cameras[int(block.images.camera[i])]
        at = camera.image_from_pixel(np.array([e["lower"], e["upper"]])).T
        low, high = camera.sensor.ray(at, camera.parameters).T @ block.images.rotation[i]
        n = np.cross(low, high)
        normals.append(n / np.linalg.norm(n))
        upward += high - low
    _, size, axes = np.linalg.svd(np.array(normals))
    z = axes[2]
    away = np.degrees(np.arcsin(np.array(normals) @ z))
    sigma = np.sqrt((away**2).sum() / max(len(edges) - 2, 1)) / size[1]
    return z * np.sign(z @ upward), float(np.sqrt(np.mean(away**2))), float(sigma)


def portal_vertical(block: Block) -> np.ndarray:
    """The true vertical in the frame of a result."""
    truth = read_block(PORTAL / "truth")
    names = {f: k for k, f in enumerate(truth.images.file)}
    both = sum(
        block.images.rotation[i].T @ truth.images.rotation[names[f]]
        for i, f in enumerate(block.images.file)
        if f in names and block.images.oriented[i]
    )
    u, _, v = np.linalg.svd(both)
    return (u @ v)[:, 2]


def angle(z: np.ndarray) -> float:
    """Of a vertical against the result's Z [deg]."""
    return float(np.degrees(np.arccos(np.clip(z[2] / np.linalg.norm(z), -1, 1))))


def main() -> int:
    """Print each set as JSON."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--keep", type=Path)
    keep = parser.parse_args().keep
    edges = tomllib.loads((HERE / "upright_edges.toml").read_text())
    rows: list[dict] = []
    with TemporaryDirectory() as scratch:
        for name in ("portal", *SETS):
            if name != "portal" and not (DATA / name).is_dir():
                rows.append({"set": name, "left_out": f"{DATA / name} is absent", "good": True})
                continue
            block, said = oriented(name, (keep or Path(scratch)) / name)
            row: dict = {"set": name, **said}
            if name == "portal":
                row |= {"off_deg": angle(portal_vertical(block)), "limit_deg": 2.0}
            elif name in edges:
                z, scatter, own = edges_vertical(block, edges[name]["edges"])
                row |= {
                    "off_deg": angle(z),
                    "limit_deg": 3.0,
                    "edges": len(edges[name]["edges"]),
                    "scatter_deg": scatter,
                    "sigma_of_these_deg": own,
                }
            good = row["off_deg"] < row["limit_deg"] and said["kind"] == "terrestrial" if "off_deg" in row else (
                said["kind"] == "aerial" and said["probability"] > 0.95
            )  # fmt: skip
            rows.append(row | {"good": bool(good)})
    for name, case, kind in (("nadir", nadir, "aerial"), ("oblique", oblique, "oblique"), ("strip", one_strip, "")):
        h, up = found(case, 1)
        good = h.ambiguous if not kind else h.kind == kind and not h.ambiguous
        off = float(np.degrees(np.arccos(np.clip(h.up @ up, -1, 1))))
        rows.append(
            {
                "set": f"{name} (simulated)", "kind": h.kind, "probability": h.probability,
                "sigma_deg": float(np.degrees(h.sigma)), "off_deg": off, "good": bool(good),
            }
        )  # fmt: skip
    print(json.dumps(rows, indent=1))
    return int(not all(r["good"] for r in rows))


if __name__ == "__main__":
    sys.exit(main())
