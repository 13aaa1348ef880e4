"""Weak texture under JPEG, photographed by parallel cameras that are not turned: what the lattice of blocks does.

    python benchmarks/surface_lattice.py FOLDER [--seed 311] [--quality 93] [--tables standard] [--even]

Renders four tiles of weak texture and two of clutter (tools/renderer) as flown in two strips, all photographs alike in
height and rotation, so that every photograph has its blocks of 8 x 8 pixels at the same angle and scale on the ground;
tools/judge_surface.py judges what `raybundle surface` makes of it. With --even the ground is weak alone.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tools"))

from renderer import sets  # noqa: E402
from renderer.camera import Camera, Photograph  # noqa: E402
from renderer.sensor import Sensor  # noqa: E402
from renderer.sets import SetSettings, render_set  # noqa: E402

BASE, STRIP = 0.2, 0.25
"""Between neighbours of a strip, and between strips, as shares of the width of a photograph"""


def parallel(camera: Camera, count: int, gsd: float, rng: np.random.Generator, **_: object) -> Sequence[Photograph]:
    """Photographs in two strips, all looking straight down from one height, columns along the strip."""
    width = camera.width_px * gsd
    distance = gsd * camera.interior.c / camera.pixel_mm
    found = []
    for k in range(count):
        strip, place = divmod(k, (count + 1) // 2)
        x = (place - ((count + 1) // 2 - 1) / 2) * BASE * width
        centre = np.array([x, (strip - 0.5) * STRIP * width, distance])
        centre += rng.normal(0, 0.004 * width, 3) * (1, 1, 0.2)
        found.append(
            Photograph(
                name=f"{camera.name}{k + 1:03d}.jpg", camera=camera, interior=camera.interior, centre=centre,
                rotation=np.eye(3), velocity=np.zeros(3), turn=np.zeros(3),
            )
        )  # fmt: skip
    return found


def main() -> None:
    """Read the command line and render."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seed", type=int, default=311)
    parser.add_argument("--quality", type=int, default=93)
    parser.add_argument("--subsampling", default="4:2:0")
    parser.add_argument("--tables", default="standard")
    parser.add_argument("--no-bayer", action="store_true")
    parser.add_argument("--even", action="store_true")
    o = parser.parse_args()
    sets.photographs = parallel
    kinds = ("weak",) * (6 if o.even else 4) + (() if o.even else ("clutter", "clutter"))
    sensor = Sensor(
        quality=o.quality, subsampling=o.subsampling, tables=o.tables, full_well=12000, bayer=not o.no_bayer
    )
    render_set(SetSettings(seed=o.seed, photographs=8, width=1200, kinds=kinds, sensor=sensor), o.folder)


if __name__ == "__main__":
    main()
