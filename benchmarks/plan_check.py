"""`raybundle plan check`: seconds for 500 photographs of 20 megapixels, and what share of smeared photographs it finds.

Run: python benchmarks/plan_check.py [PHOTOGRAPHS]        1.5 GB in a temporary folder
"""

import json
import os
import platform
import sys
import tempfile
import time
from pathlib import Path

import cv2
import numpy as np
from PIL import Image

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from raybundle.io.missions.flown import flown_of, upper_part
from raybundle.io.photos.photo import find_photos
from raybundle.missions.check import check_flight
from raybundle.missions.mission import exposures
from raybundle.missions.sharpness import blur_of, blurred, sharpness, tiles

RESULT = Path(__file__).parent / "results/plan_check.json"
DATA = Path(os.environ.get("RAYBUNDLE_DATA", Path(__file__).resolve().parents[2] / "shared/data"))
SIZE = (5472, 3648)


def flight(folder, count):
    """A plan of at least so many photographs, and the files: real pictures of five places, enlarged, with grain."""
    from tests.missions.cases import OUTLINES, PLACE, mission
    from tests.missions.flying import fly

    outline = (OUTLINES["area"] - PLACE) * (count / 183) ** 0.5 + PLACE
    plan = mission("nadir", outline=outline)
    states, pixels = folder / "states", folder / "flown"
    fly(plan, states, off=0.5, drop=set(range(40, 60)))
    pixels.mkdir()
    rng = np.random.default_rng(1)
    bodies = []
    for source in sorted((DATA / "photos/copr-uav/images").glob("*.jpg"))[::9]:
        large = cv2.resize(cv2.imread(str(source)), SIZE, interpolation=cv2.INTER_CUBIC).astype(np.int16)
        grain = rng.integers(-5, 6, large.shape, np.int16)
        bodies.append(cv2.imencode(".jpg", np.clip(large + grain, 0, 255).astype(np.uint8), [1, 92])[1].tobytes())
    for k, file in enumerate(sorted(states.glob("*.jpg"))):
        head = Image.open(file).info
        exif, xmp = head["exif"], b"http://ns.adobe.com/xap/1.0/\0" + head["xmp"]
        segments = b"".join(b"\xff\xe1" + (len(s) + 2).to_bytes(2, "big") + s for s in (exif, xmp))
        (pixels / file.name).write_bytes(b"\xff\xd8" + segments + bodies[k % len(bodies)][2:])
    return plan, pixels


def seconds(count):
    """Of the whole check with and without pixels."""
    with tempfile.TemporaryDirectory() as temporary:
        plan, pixels = flight(Path(temporary), count)
        files = sorted(pixels.glob("*.jpg"))
        found = {
            "planned": len(exposures(plan)), "photographs": len(files),
            "MB": round(sum(f.stat().st_size for f in files) / 1e6),
        }  # fmt: skip
        for name, sharp in (("pixels", True), ("no pixels", False)):
            start = time.perf_counter()
            photos = find_photos([pixels]).photos
            flown, _ = flown_of(photos, plan, sharp=sharp)
            result = check_flight(plan, flown, lambda xy: np.full(len(xy), 100.0))
            found[f"s, {name}"] = round(time.perf_counter() - start, 2)
        found["missing"] = len(result.missing)
        return found


def power():
    """Shares of the photographs of copr-uav that are called blurred, when one is smeared, and when none is."""
    photos = find_photos([DATA / "photos/copr-uav/images"]).photos
    photos = sorted(photos, key=lambda p: p.metadata.taken)
    grey = [upper_part(p).astype(np.float32) for p in photos]
    squares = [tiles(g) for g in grey]
    usual = [sharpness(s) for s in squares]
    found = {"as they are": f"{int(blur_of(usual, squares[::8]).other.sum())} of {len(photos)}"}
    for length in (2.0, 3.0, 4.0, 5.0, 6.0):
        hits, px = 0, []
        for k, picture in enumerate(grey):
            mine = list(usual)
            mine[k] = sharpness(tiles(blurred(picture, length, 1)))
            blur = blur_of(mine, squares[::8])
            hits += bool(blur.other[k])
            px.append(float(blur.px[k]))
        found[f"{length:g} px"] = {"found": round(hits / len(grey), 2), "median px": round(float(np.median(px)), 2)}
    return found


def main():
    """Both, written beside the other results."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 500
    machine = {"processors": os.cpu_count(), "machine": platform.machine(), "python": platform.python_version()}
    result = {"machine": {**machine, "opencv": cv2.__version__}, "check": seconds(count), "smeared": power()}
    RESULT.write_text(json.dumps(result, indent=1) + "\n")
    print(json.dumps(result, indent=1))


if __name__ == "__main__":
    main()
