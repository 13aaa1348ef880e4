"""Features by the compiled kernels beside those by OpenCV, in one run: processor time, right matches, repeatability.

    python benchmarks/features.py [--sets portal fountain-p11 ...] [--repeat 5]

Five pairs of each set.  A match is right within 2 px of the epipolar line: that of the true cameras (portal,
fountain-p11), else of the fundamental matrix that fits the matches of both detectors together.  For the repeatability
one photograph of each pair is distorted by a known homography, with other brightness and noise: shares of the
features that are found again within 1.5 px, and matches that are right there.  "vga" and "dark" are herzjesu-p8
at 640 px and the portal at a tenth of its grey values, "large" is fountain-p11 at 14 megapixels.
Needs RAYBUNDLE_DATA (default ../shared/data) for all but the rendered set.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import statistics
import time
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any
from unittest.mock import patch

os.environ.setdefault("OPENCV_FOR_THREADS_NUM", "1")

import cv2
import numpy as np
import poselib

from raybundle.io.block.folder import read_block
from raybundle.matching.features import Described, Features, feature_number
from raybundle.matching.methods import feature_method
from raybundle.numerics import native
from raybundle.numerics.arrays import Array

HERE = Path(__file__).resolve().parent
DATA = Path(os.environ.get("RAYBUNDLE_DATA", HERE.parents[1] / "shared/data")) / "photos"
PORTAL = HERE.parent / "demo_data/portal"
MOST, RIGHT_PX, AGAIN_PX = 10_000, 2.0, 1.5
WITHOUT: dict[str, Callable[[], AbstractContextManager[Any]]] = {
    "kernel": nullcontext,
    "OpenCV": lambda: patch.object(native, "module", lambda: None),
}


def dark(grey: Array) -> Array:
    """A tenth of the grey values, with noise."""
    noise = np.random.default_rng(1).normal(0, 0.3, grey.shape)
    return np.round(0.1 * grey + noise).clip(0, 255).astype(np.uint8)


def resized(width_px: int) -> Callable[[Array], Array]:
    """To another width."""

    def change(grey: Array) -> Array:
        size = width_px, round(width_px * grey.shape[0] / grey.shape[1])
        how = cv2.INTER_AREA if width_px < grey.shape[1] else cv2.INTER_CUBIC
        return cv2.resize(grey, size, interpolation=how)

    return change


@dataclass(frozen=True, kw_only=True)
class Case:
    """Photographs, by pairs, and how they are changed."""

    photos: Path
    pairs: tuple[tuple[int, int], ...]
    truth: Path | None = None
    change: Callable[[Array], Array] = np.asarray


NEAR = ((0, 1), (1, 2), (2, 3), (2, 4), (3, 5))
STRECHA = {name: DATA / name / "images" for name in ("fountain-p11", "herzjesu-p8", "castle-p19")}
CASES = {
    "portal": Case(
        photos=PORTAL / "photos", truth=PORTAL / "truth", pairs=((0, 1), (2, 3), (5, 6), (8, 9), (2, 12))
    ),
    "fountain-p11": Case(
        photos=STRECHA["fountain-p11"], truth=DATA / "fountain-p11/cameras.csv",
        pairs=((3, 4), (3, 6), (4, 6), (5, 7), (6, 9)),
    ),
    "herzjesu-p8": Case(photos=STRECHA["herzjesu-p8"], pairs=NEAR),
    "castle-p19": Case(photos=STRECHA["castle-p19"], pairs=NEAR),
    "sceaux-castle": Case(photos=DATA / "sceaux-castle/images", pairs=NEAR),
    "copr-uav": Case(photos=DATA / "copr-uav/images", pairs=NEAR),
    "vga": Case(photos=STRECHA["herzjesu-p8"], pairs=NEAR, change=resized(640)),
    "dark": Case(photos=PORTAL / "photos", pairs=((0, 1), (2, 3), (5, 6), (8, 9), (2, 12)), change=dark),
    "large": Case(photos=STRECHA["fountain-p11"], pairs=((3, 4), (4, 6)), change=resized(4608)),
}  # fmt: skip
SIX = ("portal", "fountain-p11", "herzjesu-p8", "castle-p19", "sceaux-castle", "copr-uav")
"""Sets of the acceptance; the others show small, dark and large photographs"""


def detect(grey: Array, how: str) -> tuple[Features, float]:
    """Features, and processor seconds."""
    height, width = grey.shape
    with WITHOUT[how]():
        began = time.process_time()
        found = feature_method("rootsift").detect(grey, feature_number(width, height, MOST))
        return found, time.process_time() - began


def matches(a: Features, b: Features) -> tuple[Array, Array]:
    """Places (n, 2) of matches in both photographs, each pair of places once."""
    first, second = (Described(xy_px=f.xy_px, descriptors=f.descriptors, size_px=(0, 0)) for f in (a, b))
    found = feature_method("rootsift").match(first, second)
    both = np.unique(np.hstack([a.xy_px[found[:, 0]], b.xy_px[found[:, 1]]]), axis=0)
    return both[:, :2], both[:, 2:]


def true_geometry(case: Case, i: str, j: str) -> Callable[[Array, Array], Array]:
    """Distances [px] from the epipolar lines of the true cameras, with y down."""
    assert case.truth is not None
    if case.truth.is_dir():
        block = read_block(case.truth)
        camera, images = block.cameras[0], block.images
        values = np.array([camera.values[s] for s in camera.sensor.symbols])
        row = {Path(f).name: k for k, f in enumerate(images.file)}
        down = np.diag([1.0, -1.0, -1.0])
        pose = {n: (down @ images.rotation[row[n]], images.centre[row[n]]) for n in (i, j)}
        focal = camera.values["c"] / camera.pixel_mm[0]

        def normal(xy: Array) -> Array:
            return down @ camera.sensor.ray(camera.image_from_pixel(xy).T, values)
    else:
        rows = {r["image"]: r for r in csv.DictReader(case.truth.open())}
        numbers = {n: {k: float(v) for k, v in rows[n].items() if k != "image"} for n in (i, j)}
        pose = {
            n: (
                np.array([[v[f"R{a}{b}"] for b in (1, 2, 3)] for a in (1, 2, 3)]),
                np.array([v[k] for k in "XYZ"]),
            )
            for n, v in numbers.items()
        }
        c = numbers[i]
        focal = c["fx"]

        def normal(xy: Array) -> Array:
            return np.stack([(xy[:, 0] - c["cx"]) / c["fx"], (xy[:, 1] - c["cy"]) / c["fy"], np.ones(len(xy))])

    (R1, X1), (R2, X2) = pose[i], pose[j]
    x, y, z = R2 @ (X1 - X2)
    E = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]) @ R2 @ R1.T

    def distance(a: Array, b: Array) -> Array:
        p, q = normal(a), normal(b)
        line = E @ (p / p[2])
        return focal * np.abs((line * (q / q[2])).sum(axis=0)) / np.hypot(line[0], line[1])

    return distance


def fitted_geometry(pooled: list[tuple[Array, Array]]) -> Callable[[Array, Array], Array]:
    """Distances from the epipolar lines that fit all matches."""
    a, b = (np.vstack([m[k] for m in pooled]) for k in (0, 1))
    F, _ = poselib.estimate_fundamental(a, b, {"max_epipolar_error": RIGHT_PX, "seed": 1}, {})

    def distance(p: Array, q: Array) -> Array:
        line = np.column_stack([p, np.ones(len(p))]) @ F.T
        return np.abs((line * np.column_stack([q, np.ones(len(q))])).sum(axis=1)) / np.hypot(line[:, 0], line[:, 1])

    return distance


def distorted(grey: Array, k: int) -> tuple[Array, Array]:
    """A photograph as from another side, and its homography in the pixel frame: turned, up to 1.4 times as far."""
    rng = np.random.default_rng(k)
    h, w = grey.shape
    angle, scale = np.radians(rng.uniform(-40, 40)), rng.uniform(0.7, 1.1)
    turned = scale * np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    H = np.eye(3)
    H[:2, :2] = turned @ (np.eye(2) + rng.uniform(-0.15, 0.15, (2, 2)))
    H[2, :2] = rng.uniform(-0.1, 0.1, 2) / w
    middle = H @ [w / 2, h / 2, 1]
    H[:2] += np.outer([w / 2, h / 2] - middle[:2] / middle[2], H[2])
    corner = np.array([[1, 0, 0.5], [0, 1, 0.5], [0, 0, 1]])
    inner = np.linalg.inv(corner) @ H @ corner
    smooth = cv2.GaussianBlur(grey.astype(np.float32), (0, 0), 0.5 / scale if scale < 1 else 0.3)
    other = cv2.warpPerspective(smooth, inner, (w, h), flags=cv2.INTER_CUBIC, borderMode=cv2.BORDER_REFLECT)
    other = 0.8 * other + 12 + rng.normal(0, 1.0, other.shape)
    return np.round(other).clip(0, 255).astype(np.uint8), H


def again(a: Features, b: Features, H: Array, size: tuple[int, int]) -> dict[str, float]:
    """How many features are found again, and matches there."""
    p = np.column_stack([a.xy_px, np.ones(len(a))]) @ H.T
    p = p[:, :2] / p[:, 2:]
    place = np.unique(p[((p > 8) & (p < np.array(size) - 8)).all(axis=1)], axis=0)
    near = cv2.FlannBasedMatcher({"algorithm": 1, "trees": 1}, {"checks": 64})
    nearest = near.knnMatch(place.astype(np.float32), b.xy_px.astype(np.float32), k=1)
    distance = np.array([m[0].distance for m in nearest])
    x, y = matches(a, b)
    q = np.column_stack([x, np.ones(len(x))]) @ H.T
    off = np.linalg.norm(q[:, :2] / q[:, 2:] - y, axis=1)
    right = off < RIGHT_PX
    return {
        "repeated": float((distance < AGAIN_PX).mean()), "right where distorted": int(right.sum()),
        "off px": float(np.median(off[right])) if right.any() else float("nan"),
    }  # fmt: skip


def judged(case: Case, repeat: int) -> dict[str, Any]:
    """All pairs of a set."""
    files = sorted(p for p in case.photos.iterdir() if p.suffix.lower() in {".jpg", ".png", ".tif"})

    @cache
    def grey(k: int) -> Array:
        read = cv2.imread(str(files[k]), cv2.IMREAD_GRAYSCALE | cv2.IMREAD_IGNORE_ORIENTATION)
        assert read is not None
        return case.change(read)

    found: dict[tuple[int, str], Features] = {}
    seconds: dict[str, list[float]] = {how: [] for how in WITHOUT}
    for k in sorted({k for pair in case.pairs for k in pair}):
        each: dict[str, list[float]] = {how: [] for how in WITHOUT}
        for _ in range(repeat):
            for how in WITHOUT:
                found[k, how], s = detect(grey(k), how)
                each[how].append(s)
        for how, values in each.items():
            seconds[how].append(statistics.median(values))
    result: dict[str, Any] = {how: {"seconds": sum(seconds[how])} for how in WITHOUT}
    pairs: list[dict[str, Any]] = []
    for i, j in case.pairs:
        both = {how: matches(found[i, how], found[j, how]) for how in WITHOUT}
        if case.truth is None:
            distance = fitted_geometry(list(both.values()))
        else:
            distance = true_geometry(case, files[i].name, files[j].name)
        other, H = distorted(grey(i), 10 * i + j)
        one: dict[str, Any] = {"pair": f"{files[i].stem}-{files[j].stem}"}
        for how, (a, b) in both.items():
            off = distance(a, b)
            right = off < RIGHT_PX
            one[how] = {"features": len(found[i, how]), "right": int(right.sum()), "matches": len(off)}
            one[how]["epipolar px"] = float(np.median(off[right])) if right.any() else float("nan")
            one[how] |= again(found[i, how], detect(other, how)[0], H, (other.shape[1], other.shape[0]))
        pairs.append(one)
    for how, r in result.items():
        for key in ("right", "matches", "right where distorted"):
            r[key] = sum(p[how][key] for p in pairs)
        for key in ("epipolar px", "off px", "repeated", "features"):
            r[key] = statistics.fmean(p[how][key] for p in pairs)
    return {**result, "megapixels": grey(case.pairs[0][0]).size / 1e6, "pairs": pairs}


def main() -> None:
    """Compare and write the figures."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--sets", nargs="*", default=list(CASES), choices=list(CASES))
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--out", type=Path, default=HERE / "results" / "features.json")
    args = parser.parse_args()
    cv2.setNumThreads(1)
    keys = ("seconds", "features", "right", "matches", "epipolar px", "repeated", "right where distorted", "off px")
    print(f"{'set':14} {'':7}" + "".join(f"{k:>22}" for k in keys))
    found: dict[str, Any] = {"instruction set": native.instruction_set()}
    for name in args.sets:
        f = found[name] = judged(CASES[name], args.repeat)
        for how in WITHOUT:
            print(f"{name:14} {how:7}" + "".join(f"{f[how][k]:22.5g}" for k in keys), flush=True)
        print(f"{name:14} {'ratio':7}" + "".join(f"{f['kernel'][k] / f['OpenCV'][k]:22.3f}" for k in keys), flush=True)
    six = [found[n] for n in SIX if n in found]
    if six:
        for k in ("seconds", "right", "right where distorted", "repeated"):
            print("sum of the six sets,", k, *(round(sum(f[how][k] for f in six), 3) for how in WITHOUT))
    args.out.write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
