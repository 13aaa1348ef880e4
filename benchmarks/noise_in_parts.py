"""Processor time and memory of noise fields: normal equations in one piece, and in parts in a store.

    python benchmarks/noise_in_parts.py one 16 40 300
    python benchmarks/noise_in_parts.py store 16 40 300

Strips, images of a strip, points of an image; Linux alone. White noise first: the figures are of what fields add.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tests.adjustment.test_noise import with_fields

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.noise_covariance import under_noise
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.factoring import in_one_piece, made_by
from raybundle.blocking.normals_in_parts import in_parts
from raybundle.pipeline.store import Folder
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene

READY = 50e6
NEAR = Survey(
    image_sigma_px=0.3, control=6, control_sigma=(0.02, 0.02, 0.02), seed=1, interior="exact", orientation="exact",
    points="exact",
)  # fmt: skip


def memory(of: str) -> float:
    """MB of this process: VmRSS now, VmHWM at most."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith(of)) / 1e3


def main(way: str, strips: int, images: int, points: int) -> None:
    plan = AerialStrips(strips=strips, images_per_strip=images, points_per_image=points)
    plan = replace(plan, camera=replace(plan.camera, estimate=("c", "x0", "y0")))
    block = with_fields(simulate(aerial_scene(plan), NEAR).observed, 0.3)
    with tempfile.TemporaryDirectory() as folder:
        parts = in_parts(store=lambda: Folder(Path(folder) / "parts"), ready=READY)
        with made_by(parts if way == "store" else in_one_piece):
            white = adjust_block(block, AdjustmentOptions(jobs=1, noise="white"))
        Path("/proc/self/clear_refs").write_text("5")
        before, began = memory("VmRSS"), time.process_time()
        noise = under_noise(white).noise
        took, most = time.process_time() - began, memory("VmHWM")
    print(f"{len(block.images)} images, {len(block.observations)} image points, {way}: {took:.1f} CPU s, "
          f"{most - before:.0f} MB more; tau {noise.tau_px:.9f} px, points {noise.ratio_points:.9f}")  # fmt: skip


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:]))
