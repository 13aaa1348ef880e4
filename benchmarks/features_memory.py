"""Memory of a process that finds the features of photographs, as a worker does them: one after the other.

    python benchmarks/features_memory.py [--megapixels 3 6 12 24 48]

Photographs of the portal in demo_data, enlarged and stored as JPEG; as they are, and blurred until so few features are
found that the finest octave is searched as well.  Each set of three has a process of its own.  Told is the largest
memory that it ever had (VmHWM), with the program itself, and what it had before the first photograph.
`FeatureMethod.bytes_needed`, by which tasks wait for each other and `raybundle estimate-cost` reckons, rests on it.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from itertools import product
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from runs import peak_mb

from raybundle.io.photos.photo import read_photo
from raybundle.matching.methods import feature_method
from raybundle.ties.points import detected, feature_count
from raybundle.workflows.costs.constants import shipped
from raybundle.workflows.costs.photographs import FEATURES

HERE = Path(__file__).resolve().parent
PHOTOS = HERE.parent / "demo_data" / "portal" / "photos"
COUNT = 3
BYTES = 1024**2 / 1e6
"""Millions of bytes in what `peak_mb` counts in"""
BLURRED_PX = {"sharp": 0.0, "soft": 6.0}
"""Pixels of the photographs before they are enlarged"""


def measured(folder: Path) -> dict[str, float]:
    """Features of all photographs of a folder, one after the other."""
    method = feature_method("rootsift")
    paths = sorted(folder.iterdir())
    photos = [read_photo(path) for path in paths]
    before, found, after = BYTES * peak_mb(), [], []
    for photo in photos:
        found.append(len(detected(method, photo, feature_count(photo, FEATURES))))
        after.append(BYTES * peak_mb())
    size = photos[0].width_px * photos[0].height_px
    return {
        "megapixels": size / 1e6, "features": max(found), "MB before": before, "MB after one": after[0],
        "MB after all": after[-1], "bytes a pixel": (after[-1] - before) * 1e6 / size,
    }  # fmt: skip


def enlarged(megapixels: float, blurred_px: float, folder: Path) -> None:
    """Photographs of so many pixels."""
    from PIL import Image, ImageFilter

    for path in sorted(PHOTOS.glob("*.jpg"))[:COUNT]:
        with Image.open(path) as picture:
            factor = (megapixels * 1e6 / (picture.width * picture.height)) ** 0.5
            size = round(picture.width * factor), round(picture.height * factor)
            blur = ImageFilter.GaussianBlur(blurred_px * factor)
            picture.resize(size, Image.Resampling.BICUBIC).filter(blur).save(folder / path.name, quality=92)


def main() -> None:
    """Measure and write the figures."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--megapixels", type=float, nargs="*", default=[3.0, 6.0, 12.0, 24.0, 48.0])
    parser.add_argument("--one", type=Path)
    args = parser.parse_args()
    if args.one:
        print(json.dumps(measured(args.one)))
        return
    found = {}
    for megapixels, how in product(args.megapixels, BLURRED_PX):
        with tempfile.TemporaryDirectory() as folder:
            enlarged(megapixels, BLURRED_PX[how], Path(folder))
            command = [sys.executable, __file__, "--one", folder]
            said = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        reckoned = shipped().base_mb + 1e-6 * feature_method("rootsift").bytes_needed(1e6 * said["megapixels"])
        found[f"{megapixels:g} megapixels, {how}"] = {**said, "reckoned with, MB": reckoned}
        print(found[f"{megapixels:g} megapixels, {how}"], flush=True)
    (HERE / "results" / "features_memory.json").write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
