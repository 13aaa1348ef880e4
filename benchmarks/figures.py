"""Time and size of figures of matplotlib, of blocks from tiny to large: drawn, and saved as PNG and SVG.

Run: python benchmarks/figures.py > benchmarks/results/figures.json
"""

import json
import os
import platform
import time
from importlib import metadata
from io import BytesIO

import raybundle as rb
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene, brown_camera

NAMES = ("network", "residuals", "interior", "reliability", "control")
BLOCKS = ((1, 2, 60), (3, 8, 1500), (16, 20, 1100))
"""Strips, images in each, points an image: 2 to 320 images, up to 100 000 points"""


def one(strips: int, images: int, density: int) -> list[dict]:
    """A block from the air, adjusted, and its figures."""
    camera = brown_camera(values={"c": 50.0}, size_px=(10000, 7500), pixel_mm=0.005, estimate=("c", "K1", "P1", "P2"))
    plan = AerialStrips(strips=strips, images_per_strip=images, points_per_image=density, camera=camera)
    survey = Survey(
        control=8, control_sigma=(0.02, 0.02, 0.03), check=min(100 * strips, 10 * images), check_sigma=0.02,
        station_sigma=0.05, orientation="exact", points="exact", interior="exact",
    )  # fmt: skip
    result = rb.adjust(simulate(aerial_scene(plan), survey).observed)
    rows = []
    for name in NAMES:
        row: dict = {"images": len(result.given.images), "points": len(result.given.points), "figure": name}
        began = time.perf_counter()
        figure = getattr(rb, f"plot_{name}")(result)
        row["drawn s"] = round(time.perf_counter() - began, 2)
        for kind in ("png", "svg"):
            held, began = BytesIO(), time.perf_counter()
            figure.savefig(held, format=kind)
            row[f"{kind} s"] = round(time.perf_counter() - began, 2)
            row[f"{kind} MB"] = round(len(held.getvalue()) / 1e6, 2)
        rows.append(row)
    return rows


def main() -> None:
    """All of them."""
    simulate_first = one(1, 2, 60)  # loads what is loaded once
    assert len(simulate_first) == len(NAMES)
    found = [row for block in BLOCKS for row in one(*block)]
    about = {"machine": platform.machine(), "processors": os.cpu_count(), "python": platform.python_version(),
             "matplotlib": metadata.version("matplotlib")}  # fmt: skip
    print(json.dumps({"about": about, "figures": found}, indent=1))


if __name__ == "__main__":
    main()
