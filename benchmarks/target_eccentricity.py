"""Twelve calibrations from rendered photographs of large dots through strong distortion, truth against covariance.

python benchmarks/target_eccentricity.py [--keep FOLDER]

Formats of 1000, 1600 and 4000 px, dots of 12 to 23 px radius (4000 px: the 5 mm dots of an A3 sheet, some 40 px),
barrel distortion of 25 px in the corners (4000 px: 60 px), ten free parameters.  `first order`: perspective in closed
form, distortion carried to first order only, as it was before; `whole model`: as the program does it.  Exit status 1
where the mean normalised squared error of the whole model leaves the 99.9 % band.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from unittest import mock

from scipy.stats import chi2

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.targets.photographs import (
    FAMILY,
    FREE,
    SheetNetwork,
    first_order_images,
    normalised_error,
    photographed,
    true_camera,
)

from raybundle.workflows.calibrate import CalibrateOptions, Calibration, calibrate

OPTIONS = CalibrateOptions(targets=(FAMILY,), estimate=FREE, shear=True)


def plans() -> list[SheetNetwork]:
    """Four networks of each format."""
    return [
        SheetNetwork(
            width_px=w, height_px=w * 3 // 4, barrel_px=barrel, radius_mm=radius + 0.6 * (k % 2), fine=fine,
            seed=10 * w + k,
        )
        for w, barrel, radius, fine in ((1000, 25.0, 7.5, 3), (1600, 25.0, 4.8, 3), (4000, 60.0, 5.0, 2))
        for k in range(4)
    ]  # fmt: skip


def first_order(work: Callable[[], Calibration]) -> Calibration:
    """A calibration with the closed form of first order."""
    with (
        mock.patch("raybundle.calibration.eccentricity.circle_images", first_order_images),
        mock.patch("raybundle.workflows.calibrating.target_block.circle_images", first_order_images),
    ):
        return work()


def main() -> int:
    """Print each network's figures and the sums, as JSON."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--keep", type=Path, help="where photographs lie or are put")
    keep = parser.parse_args().keep
    rows: list[dict] = []
    with TemporaryDirectory() as scratch:
        for plan in plans():
            folder = (keep or Path(scratch)) / f"{plan.width_px}_{plan.seed}"
            camera = true_camera(plan) if folder.is_dir() else photographed(plan, folder)

            def work(folder: Path = folder) -> Calibration:
                return calibrate([folder], OPTIONS)

            before, degrees = normalised_error(first_order(work), camera)
            done = work()
            after, _ = normalised_error(done, camera)
            radius = plan.radius_mm * plan.width_px / 460
            rows.append(
                {
                    "width_px": plan.width_px, "dot_radius_px": round(radius, 1), "barrel_px": plan.barrel_px,
                    "largest_eccentricity_px": round(done.largest_eccentricity_px, 3),
                    "image_sigma_px": round(done.quality[0].image_sigma_px, 4), "degrees": degrees,
                    "first_order": round(before, 1), "whole_model": round(after, 1),
                }
            )  # fmt: skip
            print(rows[-1], file=sys.stderr, flush=True)
    n = sum(r["degrees"] for r in rows)
    low, high = (b / len(rows) for b in chi2(n).interval(0.999))
    mean = {k: sum(r[k] for r in rows) / len(rows) for k in ("first_order", "whole_model")}
    inside = bool(low < mean["whole_model"] < high)
    print(json.dumps({"networks": rows, "mean": mean, "band": [low, high], "inside": inside}, indent=1))
    return int(not inside)


if __name__ == "__main__":
    sys.exit(main())
