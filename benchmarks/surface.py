"""What a pixel of the surface costs: refinement in four sources, and its ratio to OpenCV's SGBM in the same run.

    python benchmarks/surface.py [--rounds 7]       figures into benchmarks/results/surface.json

microseconds  processor time of one core for a pixel at every pixel of a part of portal_02 (tests/surface/truth.py makes
              its exact depths, once), by four sources from starts that are off by 0.3 px; medians over the rounds
sgbm          the same of OpenCV's three-way SGBM of two photographs at full size, with as many disparities as the
              depths of the portal ask for; they are not rectified, which its time does not depend on.  A ratio to it
              belongs to the same round
error_px      robust standard deviation of the refined depths against the exact ones, as shift in the most sensitive
              source
noise         white noise added twice to the photographs: mean chi-square of the differences against the stated noise,
              with and without the observed curvature, pixels beyond 5 sigma counted apart
"""

import argparse
import json
import platform
import sys
import time
from pathlib import Path

import cv2
import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
from tests.surface import portal  # noqa: E402

from raybundle.numerics import native  # noqa: E402
from raybundle.surfaces.depths.refine import PixelGrid, refine  # noqa: E402

PART = PixelGrid(x0=500, y0=350, stride=1, rows=80, columns=400)
NOISE = 1.0


def sgbm_microseconds(scene) -> tuple[float, int]:
    """Processor time for a pixel of a rectified pair, and the disparities."""
    base = np.linalg.norm(np.diff(scene.block.images.centre[[portal.REFERENCE, portal.SOURCES[0]]], axis=0))
    camera = scene.block.cameras[0]
    depth = 1 / np.nanpercentile(scene.depths.t, [0.5, 99.5])
    disparities = int(np.ceil(camera.values["c"] / camera.pixel_mm[0] * base * np.ptp(1 / depth) / 16)) * 16
    one, two = (g.astype(np.uint8) for g in (scene.reference, scene.sources[0].grey))
    matcher = cv2.StereoSGBM_create(0, disparities, 5, P1=200, P2=800, mode=cv2.STEREO_SGBM_MODE_SGBM_3WAY)
    began = time.process_time()
    matcher.compute(one, two)
    return 1e6 * (time.process_time() - began) / one.size, disparities


def main() -> None:
    """All of it."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=7)
    given = parser.parse_args()
    cv2.setNumThreads(1)
    scene = portal.scene(ROOT / ".pytest_cache/d/surface")
    start = scene.start(PART, 0.3)
    refine(scene.reference, scene.sources, PART, start)
    cost, ratio, peer = [], [], []
    for _ in range(given.rounds):
        sgbm, disparities = sgbm_microseconds(scene)
        began = time.process_time()
        found = refine(scene.reference, scene.sources, PART, start)
        cost.append(1e6 * (time.process_time() - began) / (PART.rows * PART.columns))
        ratio.append(cost[-1] / sgbm)
        peer.append(sgbm)
    good = found.found & np.isfinite(PART.of(scene.depths.t))
    e = (found.t - PART.of(scene.depths.t))[good] * scene.reach
    result = {
        "microseconds": round(float(np.median(cost)), 2),
        "sgbm_microseconds": round(float(np.median(peer)), 3),
        "sgbm_disparities": disparities,
        "ratio_to_sgbm": round(float(np.median(ratio)), 1),
        "iterations": round(float(found.iterations.mean()), 2),
        "found": round(float(found.found.mean()), 3),
        "error_px": round(float(np.median(np.abs(e)) / 0.6745), 3),
        "noise": portal.added_noise(scene, PixelGrid.over(scene.reference, 10, 8), NOISE),
        "about": {
            "instruction_set": native.instruction_set(),
            "machine": platform.machine(),
            "opencv": cv2.__version__,
        },
    }
    print(json.dumps(result, indent=1))
    (ROOT / "benchmarks/results/surface.json").write_text(json.dumps(result, indent=1) + "\n")


if __name__ == "__main__":
    main()
