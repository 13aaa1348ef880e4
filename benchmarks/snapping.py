"""Snapping of clicks: how well ten clicks agree on real photographs, and whether the stated covariance is true.

    python benchmarks/snapping.py [--runs 500]       figures into benchmarks/results/snapping.json

truth           simulated clicks within 5 px of points of rendered pictures: chi-square of the errors against the stated
                covariances, with the 99.9 % band; of patches that of the grey values alone, since these pictures are
                plane and their noise is white: what surfaces add is measured by tests/studio/test_patches.py
repeatability   ten clicks within 5 px of each of some points of real photographs: the largest standard deviation of a
                coordinate over the ten, median and 90 % quantile over the points
"""

import argparse
import json
import os
import sys
import time
from pathlib import Path

import numpy as np
from scipy.stats import chi2

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
from tests.measuring import pictures  # noqa: E402

from raybundle.io.photos.photo import find_photos, read_grey  # noqa: E402
from raybundle.measuring import snap as snapping  # noqa: E402
from raybundle.measuring.snap import Reference, Snapped, snap  # noqa: E402

DATA = Path(os.environ.get("RAYBUNDLE_DATA", ROOT.parent / "shared/data"))
PORTAL = ROOT / "demo_data/portal/photos/portal_05.jpg"
AS_IT_IS = snapping.SURFACE_PX, snapping.WINDOWS_PATCH
MAKE = {
    "ellipse": pictures.ellipse,
    "corner": pictures.corner,
    "cross": pictures.cross,
    "patch": lambda rng: pictures.patch(rng, PORTAL),
}


def errors(kind, runs, seed=0):
    """Errors (n, 2), covariances (n, 2, 2), refusals and seconds of clicks on rendered pictures."""
    rng = np.random.default_rng(seed)
    e, C, refused, seconds = [], [], [], []
    for _ in range(runs):
        image, at, reference = MAKE[kind](rng)
        x, y = pictures.click_near(rng, at)
        began = time.perf_counter()
        found = snap(image, x, y, kind, reference)
        seconds.append(time.perf_counter() - began)
        if isinstance(found, Snapped):
            xx, yy, xy = found.covariance
            e.append([found.x_px - at[0], found.y_px - at[1]])
            C.append([[xx, xy], [xy, yy]])
        else:
            refused.append(found.why)
    return np.array(e), np.array(C), refused, seconds


def truth(kind, runs):
    snapping.SURFACE_PX, snapping.WINDOWS_PATCH = 0.0, snapping.WINDOWS_PATCH[:1]
    try:
        return _truth(kind, runs)
    finally:
        snapping.SURFACE_PX, snapping.WINDOWS_PATCH = AS_IT_IS


def _truth(kind, runs):
    e, C, refused, seconds = errors(kind, runs)
    square = np.einsum("ni,nij,nj->n", e, np.linalg.inv(C), e)
    low, high = chi2(2 * len(e)).ppf([0.0005, 0.9995]) / (2 * len(e))
    found = {
        "clicks": runs,
        "refused": len(refused),
        "refused_why": refused[:3],
        "error_rms_px": round(float(np.sqrt((e**2).mean())), 4),
        "stated_rms_px": round(float(np.sqrt(np.trace(C, axis1=1, axis2=2).mean() / 2)), 4),
        "chi_square_per_freedom": round(float(square.sum() / (2 * len(e))), 3),
        "band_99.9": [round(float(low), 3), round(float(high), 3)],
        "largest_square": round(float(square.max()), 1),
        "milliseconds_median": round(1000 * float(np.median(seconds)), 1),
    }
    return found | {"within": bool(low < found["chi_square_per_freedom"] < high)}


def spread(grey, at, kind, rng, reference=None):
    """Largest standard deviation of a coordinate over ten clicks; None where a click is refused."""
    found = [snap(grey, *pictures.click_near(rng, at), kind, reference) for _ in range(10)]
    if not all(isinstance(f, Snapped) for f in found):
        return None
    return float(np.std([[f.x_px, f.y_px] for f in found], axis=0, ddof=1).max())


def repeated(spreads):
    good = np.array([s for s in spreads if s is not None])
    return {
        "points": len(spreads),
        "refused": len(spreads) - len(good),
        "median_px": round(float(np.median(good)), 5),
        "quantile_90_px": round(float(np.quantile(good, 0.9)), 5),
        "largest_px": round(float(good.max()), 5),
    }


def cern(points, rng):
    """Ellipses: the coded targets of cern-targets, at the places that MicMac measured."""
    folder = DATA / "photos/cern-targets"
    rows = np.genfromtxt(folder / "measured.csv", delimiter=",", dtype=None, encoding="utf-8", skip_header=1)
    rows = rows[rng.choice(len(rows), points, replace=False)]
    grey = {}
    spreads = []
    for image, _, x, y in rows:
        if image not in grey:
            grey[image] = read_grey(find_photos([folder / "images" / image]).photos[0])
        spreads.append(spread(grey[image], np.array([x + 0.5, y + 0.5]), "ellipse", rng))
    return repeated(spreads)


def sceaux(points, rng):
    """Patches: places of good texture of two photographs of sceaux-castle, and where the second shows them."""
    import cv2

    folder = DATA / "photos/sceaux-castle/images"
    one, two = (read_grey(find_photos([folder / f"100_71{k:02}.JPG"]).photos[0]) for k in (0, 1))
    sift = cv2.SIFT_create(3000)
    (k1, d1), (k2, d2) = (sift.detectAndCompute(g, None) for g in (one, two))
    pairs = cv2.BFMatcher().knnMatch(d1, d2, k=2)
    good = [a for a, b in pairs if a.distance < 0.6 * b.distance]
    chosen = [good[i] for i in rng.choice(len(good), points, replace=False)]
    patches, corners = [], []
    for m in chosen:
        a, b = (np.array(k.pt) + 0.5 for k in (k1[m.queryIdx], k2[m.trainIdx]))
        reference = Reference(grey=one, x_px=a[0], y_px=a[1])
        patches.append(spread(two, b, "patch", rng, reference))
    for x, y in cv2.goodFeaturesToTrack(one, 3000, 0.02, 30)[:, 0]:
        found = snap(one, float(x) + 0.5, float(y) + 0.5, "corner")
        if isinstance(found, Snapped):
            corners.append(spread(one, np.array([found.x_px, found.y_px]), "corner", rng))
        if len(corners) == points:
            break
    return {"patch": repeated(patches), "corner": repeated(corners)}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--runs", type=int, default=500)
    parser.add_argument("--points", type=int, default=60)
    given = parser.parse_args()
    result = {"truth": {kind: truth(kind, given.runs) for kind in MAKE}}
    rng = np.random.default_rng(7)
    if (DATA / "photos").is_dir():
        result["repeatability"] = {"ellipse": cern(given.points, rng), **sceaux(given.points, rng)}
    print(json.dumps(result, indent=1))
    if given.runs >= 500:
        (ROOT / "benchmarks/results/snapping.json").write_text(json.dumps(result, indent=1) + "\n")


if __name__ == "__main__":
    main()
