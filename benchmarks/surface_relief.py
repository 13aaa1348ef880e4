"""What has moved between two surfaces of the rendered portal, of which the later has reliefs moved by 3 mm.

    python benchmarks/surface_relief.py [--renderer PYTHON] [--density 2] [--cell 0.01]

The odd photographs are those of the demonstration set.  In the even ones all that shows a square of 30 x 30 cm of the
wall that has moved outwards by 3 mm, or one that has moved inwards, is rendered anew by tools/render_demo.py
(--relief, --onto; PYTHON has mitsuba).  Each half is a project of its own, oriented by the same control points, and has
a surface of its own; `raybundle heights difference` compares them.

found    regions that lie over a relief: amount and area beside the exact ones, in standard deviations
others   regions that lie elsewhere: none is right
outline  largest distance of the region's cells from the relief, and share of the relief that it covers

Figures go into benchmarks/results/surface_relief.json.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import rasterio
from scipy.ndimage import distance_transform_edt

ROOT = Path(__file__).resolve().parents[1]
DEMO, WORK = ROOT / "demo_data/portal", ROOT / "benchmarks/work/relief"

from raybundle.block import Role  # noqa: E402
from raybundle.io.block.folder import read_block  # noqa: E402
from raybundle.surfaces.files.heights import read_heights  # noqa: E402

RELIEFS = ((-1.95, 1.05, 0.3, 0.003), (1.55, 0.75, 0.3, -0.003))
"""Lower left corner in x and z of the wall, side, movement outwards [m]"""
CONTROL_M, SEED = 0.0005, 12
"""Standard deviation of the control points; they are drawn by it."""
EXTENT = (-0.3, -0.5, 4.2, 2.6)
"""Of the wall, from the foot of T1"""


def raybundle(*arguments: str) -> str:
    """What a command prints."""
    command = [sys.executable, "-m", "raybundle", *arguments]
    return subprocess.run(command, check=True, cwd=ROOT, capture_output=True, text=True).stdout


def photographs(renderer: str) -> dict[str, Path]:
    """Folders of both epochs."""
    folders = {"before": WORK / "before", "after": WORK / "after"}
    names = sorted(p.name for p in (DEMO / "photos").glob("*.jpg"))
    rendered = WORK / "rendered"
    numbers = ",".join(str(k + 1) for k in range(1, len(names), 2))
    if not all((rendered / "photos" / name).exists() for name in names[1::2]):
        reliefs = [word for r in RELIEFS for word in ("--relief", *map(str, r))]
        script = [renderer, "tools/render_demo.py", "--out", str(rendered), "--onto", str(DEMO / "photos")]
        subprocess.run([*script, *reliefs, "--images", numbers], check=True, cwd=ROOT, env=dict(os.environ))
    for folder, source, mine in (
        (folders["before"], DEMO / "photos", names[0::2]), (folders["after"], rendered / "photos", names[1::2])
    ):  # fmt: skip
        folder.mkdir(parents=True, exist_ok=True)
        for name in mine:
            shutil.copyfile(source / name, folder / name)
    return folders


def control() -> Path:
    """Coordinates of the targets, drawn by their standard deviations, with their measurements beside them."""
    truth, rng = read_block(DEMO / "truth"), np.random.default_rng(SEED)
    path = WORK / "control.csv"
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["point", "X", "Y", "Z", "sX", "sY", "sZ", "role"])
        for k in range(len(truth.points.ids)):
            if truth.points.role[k] == Role.CHECK and truth.points.ids[k].startswith("T"):
                drawn = truth.points.xyz[k] + CONTROL_M * rng.standard_normal(3)
                writer.writerow([truth.points.ids[k], *(f"{x:.6f}" for x in drawn), *[CONTROL_M] * 3, "control"])
    rows = (DEMO / "measured.csv").read_text(encoding="utf-8").splitlines(keepends=True)
    mine = [row for row in rows if row.split(",")[1].startswith(("T", "point"))]
    (WORK / "control-measurements.csv").write_text("".join(mine), encoding="utf-8")
    return path


def compared(out: Path, before: Path) -> dict[str, object]:
    """The regions that are called moved, beside the reliefs."""
    _, file = read_heights(before)
    origin, right, up = (np.array(file.plane[k]) for k in ("origin", "right", "up"))
    with rasterio.open(out / "difference.tif") as tif:
        names = list(tif.descriptions)
        region = np.nan_to_num(tif.read(names.index("region") + 1)).astype(int)
        left, top, cell = tif.transform.c, tif.transform.f, tif.transform.a
    rows, columns = np.mgrid[: region.shape[0], : region.shape[1]]
    places = (
        origin
        + (left + (columns[..., None] + 0.5) * cell) * right
        + (top - (rows[..., None] + 0.5) * cell) * up
    )  # fmt: skip
    with (out / "moved.csv").open(newline="", encoding="utf-8") as text:
        rows_of = csv.DictReader(line for line in text if not line.startswith("#"))
        table = {int(r["region"]): {k: float(v) for k, v in r.items()} for r in rows_of}
    found, used = [], set[int]()
    for x, z, side, by in RELIEFS:
        inside = (
            (places[..., 0] > x) & (places[..., 0] < x + side) & (places[..., 2] > z) & (places[..., 2] < z + side)
        )  # fmt: skip
        mine = sorted(set(np.unique(region[inside]).tolist()) - {0})
        used |= set(mine)
        over = np.isin(region, mine) & (region > 0)
        beyond = distance_transform_edt(~inside)[over].max() * cell if over.any() else float("nan")
        largest = max(mine, key=lambda r: (region == r).sum()) if mine else 0
        found.append(
            {
                "by_mm": 1000 * by, "regions": len(mine), "told": table.get(largest, {}),
                "covered": round(float((over & inside).sum() / inside.sum()), 3),
                "beyond_mm": round(1000 * float(beyond), 1),
            }
        )  # fmt: skip
    return {"found": found, "others": [row for k, row in table.items() if k not in used]}


def main() -> None:
    """All of it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--renderer", default=sys.executable, help="a Python that has mitsuba")
    parser.add_argument("--density", default="2", choices=["1", "2", "4"])
    parser.add_argument("--cell", type=float, default=0.01)
    given = parser.parse_args()
    WORK.mkdir(parents=True, exist_ok=True)
    marks, surfaces = control(), {}
    for name, folder in photographs(given.renderer).items():
        project, surface = WORK / f"{name}-project", WORK / f"{name}-surface-{given.density}"
        if not (project / "result").exists():
            raybundle("orient", str(folder), "--out", str(project), "--control", str(marks))
        if not (surface / "heights.tif").exists():
            raybundle(
                "surface", str(project), "--out", str(surface), "--density", given.density, "--dsm", str(given.cell),
                "--plane", "T1,T2", "--vertical", "--axis", "T1", "T2", "--origin", "T1",
                "--extent", *map(str, EXTENT),
            )  # fmt: skip
        surfaces[name] = surface
    out = WORK / "moved"
    shutil.rmtree(out, ignore_errors=True)
    print(raybundle("heights", "difference", str(surfaces["before"]), str(surfaces["after"]), "--out", str(out)))
    found = {"density": given.density, "cell_m": given.cell, **compared(out, surfaces["before"])}
    print(json.dumps(found, indent=1))
    (ROOT / "benchmarks/results/surface_relief.json").write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
