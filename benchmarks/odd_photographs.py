"""Odd photographs among ordinary ones: rendered with their truth, oriented from nothing.

    python benchmarks/odd_photographs.py [--only PATTERN] [--work FOLDER] [--out NAME]

Twelve kinds, each in a house with wings and a tower of which all parts differ.  The camera of the format is given, but
where several have it.

right   every oriented photograph stands within 0.1 of the distance of neighbours and 2 degrees of the truth
named   photographs that do not are named by a fault or a warning
silent  neither: photographs that stand wrong and are not named
"""

from __future__ import annotations

import argparse
import json
import re
import resource
import tempfile
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
from doubles import KINDS, RESULTS, RIGHT, RIGHT_DEG, C, H, Photograph, W, off, rendered, written

ODD = 5
"""Place of the odd photograph"""
NOWHERE = np.full(3, 1e3)
"""Stands for the station of a picture that no camera at one place took."""


def mirrored(grey: np.ndarray) -> np.ndarray:
    """Left and right exchanged."""
    return grey[:, ::-1]


def cropped(grey: np.ndarray) -> np.ndarray:
    """A part off the centre."""
    return grey[: int(0.72 * H), int(0.26 * W) :]


def enlarged(grey: np.ndarray) -> np.ndarray:
    """The middle, resampled to the format."""
    a, b = int(0.12 * H), int(0.12 * W)
    return cv2.resize(grey[a : H - a, b : W - b], (W, H), interpolation=cv2.INTER_CUBIC)


def stretched(grey: np.ndarray) -> np.ndarray:
    """Wider than it was."""
    return cv2.resize(grey, (int(1.2 * W), H), interpolation=cv2.INTER_CUBIC)


def turned(grey: np.ndarray) -> np.ndarray:
    """By 90 degrees, without a tag."""
    return np.rot90(grey)


def reprinted(grey: np.ndarray) -> np.ndarray:
    """A print on a table, photographed obliquely."""
    source = np.array([[0, 0], [W, 0], [W, H], [0, H]], np.float32)
    target = np.array([[70, 40], [590, 85], [545, 440], [40, 400]], np.float32)
    return cv2.warpPerspective(grey, cv2.getPerspectiveTransform(source, target), (W, H), borderValue=120)


def screenshot(grey: np.ndarray) -> np.ndarray:
    """Reduced, with a border, in the format."""
    page = np.full((H, W), 240, np.uint8)
    small = cv2.resize(grey, (int(0.8 * W), int(0.8 * H)), interpolation=cv2.INTER_AREA)
    page[70 : 70 + small.shape[0], 20 : 20 + small.shape[1]] = small
    return page


def thumbnail(grey: np.ndarray) -> np.ndarray:
    """A copy of a quarter the size."""
    return cv2.resize(grey, (W // 4, H // 4), interpolation=cv2.INTER_AREA)


CHANGED = {f.__name__: f for f in (mirrored, cropped, enlarged, stretched, turned, reprinted, screenshot)}
NO_STATION = ("mirrored", "reprinted")
UNKNOWN = ("two cameras", "zoom")
"""Kinds whose camera is not given"""
OTHERS = ("two cameras", "zoom", "panorama", "burst", "thumbnail")
NAMING = (
    "image_contradicts", "identical_images", "weak_photographs", "cropped_photographs", "camera_kept_apart",
    "mirrored_photographs",
)  # fmt: skip
"""Warnings that name a photograph as one not to rely on"""
ORDINARY = "ordinary"
SETS = {"wings": "chain", "tower": "chain"}


def panorama(quads: list, station: tuple[np.ndarray, np.ndarray]) -> Photograph:
    """Three photographs of one place on a cylinder."""
    centre, target = station
    step = np.radians(35)
    ahead = target - centre
    views = []
    for k in (1, 0, -1):
        c, s = np.cos(k * step), np.sin(k * step)
        views.append(rendered(quads, centre, centre + np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ ahead, 90 + k))
    angle = (np.arange(1100) + 0.5 - 550) / C
    height = (np.arange(H) + 0.5 - H / 2) / C
    grey = np.full((H, 1100), 128, np.uint8)
    for k, v in zip((1, 0, -1), views, strict=True):
        a = angle[None] + k * step
        x, y = C * np.tan(a) + W / 2, C * height[:, None] / np.cos(a) + H / 2
        shown = cv2.remap(
            v.grey, np.broadcast_to(x, grey.shape).astype(np.float32) - 0.5, y.astype(np.float32) - 0.5, 1
        )
        mine = np.broadcast_to(abs(a) <= step / 2 + 0.02, grey.shape)
        grey[mine] = shown[mine]
    return replace(views[1], grey=grey)


def photographs(kind: str, scene: str) -> tuple[dict[str, Photograph], list[str]]:
    """Photographs of a set with the truth, and the names of the odd ones."""
    quads, ways = KINDS[scene](rich=True, equal=False)
    path = ways[SETS[scene]]
    lengths = np.full(len(path), C)
    if kind == "two cameras":
        lengths[1::2] = 1.35 * C
    if kind == "zoom":
        lengths = C * np.linspace(0.85, 1.5, len(path))[np.random.default_rng(1).permutation(len(path))]
    each = enumerate(zip(path, lengths, strict=True))
    result = {f"p{k:02d}.jpg": rendered(quads, c, target, k, f) for k, ((c, target), f) in each}
    name = f"p{ODD:02d}.jpg"
    if kind in CHANGED:
        whole = result[name]
        grey = np.ascontiguousarray(CHANGED[kind](whole.grey))
        quarter = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
        R = quarter @ whole.rotation if kind == "turned" else whole.rotation
        result[name] = Photograph(grey, NOWHERE if kind in NO_STATION else whole.centre, R)
        return result, [name]
    c, target = path[ODD]
    if kind == "panorama":
        result["odd.jpg"] = panorama(quads, path[ODD])
        return result, ["odd.jpg"]
    if kind == "burst":
        for k in range(4):
            result[f"burst{k}.jpg"] = rendered(quads, c, target + np.array([0.05 * k, 0, 0.04 * k]), 50 + k)
        return result, [f"burst{k}.jpg" for k in range(4)]
    if kind == "thumbnail":
        result["odd.jpg"] = replace(result[name], grey=thumbnail(result[name].grey))
        return result, ["odd.jpg"]
    return result, []


def outcome(truth: dict[str, Photograph], odd: list[str], folder: Path) -> dict:
    """What `orient` makes of them, by the truth."""
    import raybundle as rb

    before = resource.getrusage(resource.RUSAGE_SELF)
    calibration = folder / "camera.toml"
    done = rb.orient(
        folder / "photos", folder / "project", calibration=calibration if calibration.exists() else None,
        precise=False, jobs=1, report=False, library=False,
    )  # fmt: skip
    after = resource.getrusage(resource.RUSAGE_SELF)
    parts = [done.adjustment, *(p.adjustment for p in done.other_components)]
    centres = np.array([p.centre for n, p in truth.items() if n not in odd])
    step = float(np.median(np.linalg.norm(np.diff(centres, axis=0), axis=1)))
    wrong, oriented = dict[str, float](), list[str]()
    for part in parts:
        block = part.adjusted
        usual = [k for k in np.flatnonzero(block.images.oriented) if block.images.ids[k] not in odd]
        found = off(block, truth, step, fitted=usual)
        oriented += list(found)
        wrong |= {n: round(a, 3) for n, (a, b) in found.items() if a > RIGHT or b > RIGHT_DEG}
    notices = [n for part in parts for n in part.notices]
    grave = [n for n in notices if n.severity.value == "fault" or n.code in NAMING]
    cameras = {g.id: [done.photos[k].name for k in g.photos] for g in done.groups}
    named = {i: n.code for n in grave for i in (*n.ids, *n.also)}
    named |= {p: named[c] for c, photos in cameras.items() if c in named for p in photos}
    silent = sorted(n for n in wrong if n not in named)
    return {
        "outcome": "right" if not wrong else "silent" if silent else "named",
        "oriented": len(oriented), "photographs": len(truth),
        "odd": {n: named.get(n, "") if n in oriented else "not oriented" for n in odd}, "wrong": wrong,
        "silent": silent,
        "faults": sorted({n.code for n in grave if n.severity.value == "fault"}),
        "cpu_s": round(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, 1),
    }  # fmt: skip


def main() -> int:
    """Run all."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--only", default="")
    parser.add_argument("--work", type=Path)
    parser.add_argument("--out", default="odd_photographs")
    a = parser.parse_args()
    rows: dict[str, dict] = {}
    with tempfile.TemporaryDirectory() as scratch:
        work = a.work or Path(scratch)
        for kind in (ORDINARY, *CHANGED, *OTHERS):
            for scene in SETS:
                name = f"{kind}, {scene}"
                if not re.search(a.only, name):
                    continue
                truth, odd = photographs(kind, scene)
                folder = work / re.sub(r"\W+", "-", name)
                camera = None if kind in UNKNOWN else (W, H, C)
                written({n: p.grey for n, p in truth.items()}, folder, camera)
                rows[name] = outcome(truth, odd, folder)
                print(name, json.dumps(rows[name]), flush=True)
    count = {k: sum(r["outcome"] == k for r in rows.values()) for k in ("right", "named", "silent")}
    print(json.dumps(count))
    (RESULTS / f"{a.out}.json").write_text(json.dumps({"summary": count, "sets": rows}, indent=1) + "\n", "utf-8")
    return int(count["silent"] > 0)


if __name__ == "__main__":
    raise SystemExit(main())
