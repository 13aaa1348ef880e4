"""Equal parts of an object: rendered arrangements, oriented from nothing and compared with the truth.

    python benchmarks/doubles.py [--only PATTERN] [--work FOLDER] [--out NAME]

Two panels on a wall, the four sides of a tower, the wings of a house, rows of windows, shelves of books, floor tiles;
each along a chain of photographs (dense, and in wide steps) and in two groups with nothing between, with a rich and a
poor background.  A poor background is a plain wall with some ten patches of
0.2 m in a photograph.  The controls are the same
arrangements with parts that all differ.

right   every oriented photograph stands within 0.1 of the distance of neighbours and 2 degrees of the truth, each part
        of the photographs by a similarity of its own; what is not oriented is named by `orient`
named   a fault names repeated structure with its photographs
folded  neither
"""

from __future__ import annotations

import argparse
import json
import re
import resource
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from repeated_structure import wall, window
from runs import similarity
from scipy.ndimage import gaussian_filter

from raybundle.block import Block

RESULTS = Path(__file__).resolve().parent / "results"
W, H, C = 640, 480, 560.0
SUPER = 2
"""Samples of a pixel each way"""
NOISE, QUALITY = 2.0, 92
SCALE = 140
"""Texels of a metre"""
RIGHT, RIGHT_DEG = 0.1, 2.0
PLAIN = 150.0


@dataclass(frozen=True)
class Quad:
    """A textured rectangle: its corner, the directions and lengths of its sides [m], its grey values."""

    corner: np.ndarray
    right: np.ndarray
    down: np.ndarray
    grey: np.ndarray


@dataclass(frozen=True)
class Photograph:
    """A photograph and its orientation: axes of the camera x right, y up, looking along -z."""

    grey: np.ndarray
    centre: np.ndarray
    rotation: np.ndarray


def background(width: float, height: float, seed: int, *, rich: bool, scale: float = SCALE) -> np.ndarray:
    """Grey values of a surface of so many metres: texture, or a plain one with few small patches."""
    h, w = round(height * scale), round(width * scale)
    rng = np.random.default_rng(seed)
    if rich:
        return wall(h, w, rng, 18).astype(np.float32)
    grey = np.full((h, w), PLAIN, np.float32)
    for _ in range(round(0.8 * width * height)):
        side = round(rng.uniform(0.14, 0.22) * scale)
        a, b = int(rng.uniform(0, max(w - side, 1))), int(rng.uniform(0, max(h - side, 1)))
        grain = gaussian_filter(rng.normal(size=(side, side)).astype(np.float32), 0.015 * scale)
        spot = np.clip(PLAIN - 30 + 40 * grain / grain.std(), 5, 250)
        grey[b : b + side, a : a + side] = spot[: h - b, : w - a]
    return grey


def put(grey: np.ndarray, x: float, y: float, width: float, height: float, seed: int, scale: float = SCALE) -> None:
    """A picture of this seed on a surface, its upper left corner at x, y [m]."""
    a, b, h, w = (round(v * scale) for v in (x, y, height, width))
    grey[b : b + h, a : a + w] = window(h, w, seed)


def upright(
    x: float, y: float, z: float, along: tuple[float, float], width: float, height: float, grey: np.ndarray
) -> Quad:
    """A wall with its upper left corner there, seen from the right-hand side of its direction."""
    d = np.array([*along, 0.0])
    return Quad(np.array([x, y, z]), width * d / np.linalg.norm(d), np.array([0, 0, -height]), grey)


def ground(x: float, y: float, z: float, width: float, depth: float, grey: np.ndarray) -> Quad:
    """A floor with its far left corner there."""
    return Quad(np.array([x, y, z]), np.array([width, 0, 0.0]), np.array([0, -depth, 0.0]), grey)


def looking(centre: np.ndarray, target: np.ndarray) -> np.ndarray:
    """Rotation sensor_from_object."""
    z = (centre - target) / np.linalg.norm(centre - target)
    x = np.cross([0, 0, 1.0] if abs(z[2]) < 0.99 else [0, 1.0, 0], z)
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(z, x), z])


def rendered(quads: list[Quad], centre: np.ndarray, target: np.ndarray, seed: int, c: float = C) -> Photograph:
    """A photograph of the rectangles, of a camera constant c [px]."""
    R = looking(centre, target)
    n = SUPER
    y, x = np.mgrid[0 : H * n, 0 : W * n].astype(np.float32) / n + 0.5 / n
    d = np.stack([x - W / 2, H / 2 - y, np.full_like(x, -c)], axis=-1) @ R.astype(np.float32)
    nearest, grey = np.full(x.shape, np.inf, np.float32), np.full(x.shape, 215.0, np.float32)
    for q in quads:
        normal = np.cross(q.right, q.down)
        with np.errstate(all="ignore"):
            t = (float((q.corner - centre) @ normal) / (d @ normal.astype(np.float32))).astype(np.float32)
            P = d * t[..., None] + (centre - q.corner).astype(np.float32)
            u, v = (
                P @ (q.right / (q.right @ q.right)).astype(np.float32),
                P @ (q.down / (q.down @ q.down)).astype(np.float32),
            )
            hit = (t > 0) & (t < nearest) & (u >= 0) & (u <= 1) & (v >= 0) & (v <= 1)
        h, w = q.grey.shape
        shown = cv2.remap(q.grey, (u * w - 0.5).astype(np.float32), (v * h - 0.5).astype(np.float32), cv2.INTER_LINEAR,
                          borderMode=cv2.BORDER_REPLICATE)  # fmt: skip
        grey[hit], nearest[hit] = shown[hit], t[hit]
    grey = cv2.resize(grey, (W, H), interpolation=cv2.INTER_AREA)
    noise = np.random.default_rng(seed).normal(0, NOISE, grey.shape)
    return Photograph(np.clip(grey + noise, 0, 255).astype(np.uint8), centre, R)


Station = tuple[np.ndarray, np.ndarray]
Scene = tuple[list[Quad], dict[str, list[Station]]]


def stations(places: list[tuple[float, float, float]], ahead: Callable[[int, np.ndarray], np.ndarray]) -> list[Station]:
    """Projection centres and what each looks at."""
    return [(c := np.array(p, float), ahead(k, c)) for k, p in enumerate(places)]


def along(xs: np.ndarray, distance: float, height: float = 2.0) -> list[Station]:
    """Before a wall in the plane y = 0, in turn a little nearer, lower and turned."""
    return stations(
        [(x, -distance - 0.5 * (k % 2), height - 0.2 + 0.3 * (k % 3)) for k, x in enumerate(xs)],
        lambda k, c: np.array([c[0] + 0.35 * (-1) ** k, 0, height]),
    )


def paths(
    begin: float, end: float, distance: float, around: tuple[float, float], spread: float
) -> dict[str, list[Station]]:
    """Chains along a wall, dense and in wide steps, and two groups about two places."""
    groups = np.concatenate([a + np.linspace(-spread, spread, 5) for a in around])
    return {
        "chain": along(np.linspace(begin, end, 14), distance),
        "wide": along(np.linspace(begin, end, 9), distance),
        "groups": along(groups, distance),
    }


def panels(*, rich: bool, equal: bool) -> Scene:
    """Two panels ten metres apart on a wall."""
    grey = background(14, 4, 1, rich=rich)
    for k, x in enumerate((2.0, 10.0)):
        put(grey, x, 1.1, 2, 1.6, 7 if equal else 7 + k)
    floor = ground(0, 0, 0, 14, 4, background(14, 4, 2, rich=rich, scale=70))
    return [upright(0, 0, 4, (1, 0), 14, 4, grey), floor], paths(2, 12, 4, (3, 11), 0.9)


def tower(*, rich: bool, equal: bool) -> Scene:
    """A tower of four equal sides on a floor."""
    quads = [ground(-9, 9, 0, 18, 18, background(18, 18, 3, rich=rich, scale=60))]
    corners = [(-2, -2), (2, -2), (2, 2), (-2, 2)]
    for k, (x, y) in enumerate(corners):
        grey = background(4, 5, 10 + k, rich=rich)
        for n, (a, b) in enumerate([(0.5, 0.8), (2.4, 0.8), (0.5, 2.9), (2.4, 2.9)]):
            put(grey, a, b, 1.1, 1.5, 20 + n if equal else 20 + n + 4 * k)
        to = corners[(k + 1) % 4]
        quads.append(upright(x, y, 5, (to[0] - x, to[1] - y), 4, 5, grey))

    def ring(angles: np.ndarray) -> list[Station]:
        a = np.radians(angles)
        r = [7.5 + 0.6 * (k % 2) for k in range(len(a))]
        places = [(r[k] * np.cos(a[k]), r[k] * np.sin(a[k]), 2.2 + 0.5 * (k % 2)) for k in range(len(a))]
        return stations(places, lambda _k, _c: np.array([0, 0, 2.3]))

    faces = np.concatenate([a + np.linspace(-16, 16, 5) for a in (-90, 0)])
    return quads, {
        "chain": ring(np.arange(16) * 22.5 + 5),
        "wide": ring(np.arange(12) * 30.0 + 5),
        "groups": ring(faces),
    }


def wings(*, rich: bool, equal: bool) -> Scene:
    """A house with equal wings left and right of its middle, which stands back."""
    quads = [ground(-1, 1.5, 0, 16, 6, background(16, 6, 4, rich=rich, scale=70))]
    for k, x in enumerate((0.0, 10.0)):
        grey = background(4, 4, 30 + k, rich=rich)
        for n, (a, b) in enumerate([(0.4, 0.5), (2.4, 0.5), (0.4, 2.2), (2.4, 2.2)]):
            put(grey, a, b, 1.2, 1.3, 40 + n if equal else 40 + n + 4 * k)
        quads.append(upright(x, 0, 4, (1, 0), 4, 4, grey))
    middle = background(6, 4, 35, rich=rich)
    put(middle, 2, 1, 2, 2.6, 50)
    quads += [upright(4, 1.5, 4, (1, 0), 6, 4, middle)]
    quads += [upright(4, 0, 4, (0, 1), 1.5, 4, background(1.5, 4, 36, rich=rich))]
    quads += [upright(10, 1.5, 4, (0, -1), 1.5, 4, background(1.5, 4, 37, rich=rich))]
    return quads, paths(1.5, 12.5, 4.5, (2, 12), 0.8)


def windows(*, rich: bool, equal: bool) -> Scene:
    """Two rows of equal windows."""
    grey = background(16, 5, 5, rich=rich)
    for k in range(8):
        for row in range(2):
            put(grey, 0.5 + 2 * k, 0.5 + 2.3 * row, 1.0, 1.5, 60 if equal else 60 + 2 * k + row)
    floor = ground(0, 0, 0, 16, 4, background(16, 4, 6, rich=rich, scale=70))
    return [upright(0, 0, 5, (1, 0), 16, 5, grey), floor], paths(2.2, 13.8, 4.5, (3, 11), 0.8)


def shelves(*, rich: bool, equal: bool) -> Scene:
    """Three shelves of books before a wall: the same twelve volumes again and again."""
    quads = [upright(0, 0.6, 4.2, (1, 0), 12, 4.2, background(12, 4.2, 8, rich=rich))]
    for row in range(3):
        grey = np.full((round(1.0 * SCALE), round(10 * SCALE)), 90, np.float32)
        for k in range(40):
            volume = k % 8 if equal else 100 * row + k
            put(grey, 0.25 * k, 0.1 + 0.02 * (volume % 4), 0.24, 0.8, 200 + volume)
        quads.append(upright(1, 0, 3.6 - 1.15 * row, (1, 0), 10, 1.0, grey))
        quads.append(ground(1, 0.6, 2.58 - 1.15 * row, 10, 0.6, background(10, 0.6, 80 + row, rich=rich)))
    return quads, paths(2, 10, 3.2, (3, 9), 0.7)


def tiles(*, rich: bool, equal: bool) -> Scene:
    """A floor of equal tiles, worn here and there, photographed from a height."""
    size = 10
    grey = background(size, size, 9, rich=rich)
    for k in range(size):
        for n in range(size):
            put(grey, k + 0.15, n + 0.15, 0.7, 0.7, 300 if equal else 300 + size * k + n)
    # wear: what is left of the wall's texture on the tiles
    grey += 0.3 * (background(size, size, 19, rich=rich) - PLAIN)
    floor = ground(0, size, 0, size, size, grey)

    def above(xy: list[tuple[float, float]]) -> list[Station]:
        return stations(
            [(x, y, 3.2 + 0.4 * (k % 2)) for k, (x, y) in enumerate(xy)],
            lambda k, c: np.array([c[0] + 0.4 * (-1) ** k, c[1] + 0.9, 0]),
        )

    chain = [(x if n % 2 == 0 else 10 - x, y) for n, y in enumerate((2.2, 4.4, 6.6)) for x in (2.2, 4.0, 5.8, 7.6)]
    wide = [(x if n % 2 == 0 else 10 - x, y) for n, y in enumerate((2.4, 5.4)) for x in (2.0, 4.2, 6.4, 8.0)]
    spots = [
        (x + dx, y + dy)
        for x, y in ((2.5, 2.5), (7.0, 6.5))
        for dx, dy in ((0, 0), (0.5, 0.1), (0, 0.6), (0.6, 0.7), (-0.5, 0.3))
    ]
    return [floor], {"chain": above(chain), "wide": above(wide), "groups": above(spots)}


KINDS = {f.__name__: f for f in (panels, tower, wings, windows, shelves, tiles)}
SETS = [
    (f"{kind}, {'rich' if rich else 'poor'}, {path}", kind, rich, path)
    for kind in KINDS
    for rich, path in ((True, "chain"), (True, "wide"), (True, "groups"), (False, "chain"), (False, "groups"))
]


def photographs(kind: str, path: str, *, rich: bool, equal: bool) -> list[Photograph]:
    """Those of a set."""
    quads, ways = KINDS[kind](rich=rich, equal=equal)
    return [rendered(quads, c, target, k) for k, (c, target) in enumerate(ways[path])]


def written(pictures: dict[str, np.ndarray], folder: Path, camera: tuple[int, int, float] | None = (W, H, C)) -> Path:
    """Files of photographs; the camera is given, since a plane and level views hardly determine it."""
    (folder / "photos").mkdir(parents=True)
    for name, grey in pictures.items():
        cv2.imwrite(str(folder / "photos" / name), grey, [cv2.IMWRITE_JPEG_QUALITY, QUALITY])
    if camera:
        w, h, c = camera
        (folder / "camera.toml").write_text(
            f'[cameras.1]\nmodel = "brown"\nwidth_px = {w}\nheight_px = {h}\npixel_mm = [0.001, 0.001]\n'
            f"c_mm = {c * 0.001}\nestimate = []\n",
            encoding="utf-8",
        )
    return folder


def off(
    block: Block, truth: dict[str, Photograph], step: float, fitted: list[int] | None = None
) -> dict[str, tuple[float, float]]:
    """Errors of a part's photographs after a similarity: of centres in steps, of rotations in degrees.

    fitted  images from which the similarity is taken; None: all
    """
    o = np.flatnonzero(block.images.oriented)
    names = [block.images.ids[k] for k in o]
    own, true = block.images.centre[o], np.array([truth[n].centre for n in names])
    if len(o) < 2:
        return dict.fromkeys(names, (0.0, 0.0))
    looks, known = block.images.rotation[o], np.array([truth[n].rotation for n in names])
    if len(o) == 2:  # what stands in a line is turned by its axes
        own = np.vstack([own, own - looks[:, 2] * np.linalg.norm(own[1] - own[0])])
        true = np.vstack([true, true - known[:, 2] * np.linalg.norm(true[1] - true[0])])
    some = np.arange(len(own)) if fitted is None or len(fitted) < 3 else np.flatnonzero(np.isin(o, fitted))
    m, R, t = similarity(own[some], true[some])
    apart = np.linalg.norm(m * own @ R.T + t - true, axis=1)[: len(o)] / step
    trace = np.einsum("nij,nij->n", looks @ R.T, known)
    turned = np.degrees(np.arccos(np.clip((trace - 1) / 2, -1, 1)))
    return {n: (float(a), float(b)) for n, a, b in zip(names, apart, turned, strict=True)}


def outcome(truth: dict[str, Photograph], folder: Path, **settings) -> dict:
    """What `orient` makes of a folder of photographs, by the truth."""
    import raybundle as rb

    before = resource.getrusage(resource.RUSAGE_SELF)
    calibration = folder / "camera.toml"
    try:
        done = rb.orient(
            folder / "photos", folder / "project", calibration=calibration if calibration.exists() else None,
            **{"precise": False, "jobs": 1, "report": False, "library": False} | settings,
        )  # fmt: skip
    except rb.errors.NoOrientation as error:
        return {"outcome": "right", "oriented": 0, "parts": 0, "message": str(error).splitlines()[0]}
    after = resource.getrusage(resource.RUSAGE_SELF)
    parts = [done.adjustment, *(p.adjustment for p in done.other_components)]
    centres = np.array([p.centre for p in truth.values()])
    step = float(np.median(np.linalg.norm(np.diff(centres, axis=0), axis=1)))
    found = [off(a.adjusted, truth, step) for a in parts]
    wrong = sorted(n for f in found for n, (a, b) in f.items() if a > RIGHT or b > RIGHT_DEG)
    notices = [n for a in parts for n in a.notices]
    said = [n for n in notices if n.code == "repeated_structure"]
    faults = [n for n in said if n.severity.value == "fault"]
    named = bool(faults)
    return {
        "outcome": "named" if named and wrong else "right" if not wrong else "folded",
        "doubted": named, "oriented": sum(len(f) for f in found), "parts": [len(f) for f in found], "wrong": len(wrong),
        "largest": round(max((a for f in found for a, _ in f.values()), default=0.0), 3),
        "notices": sorted(f"{n.code}.{n.variant}:{n.severity.value}" for n in said),
        "other_faults": sorted({n.code for n in notices if n.severity.value == "fault"} - {"repeated_structure"}),
        "cpu_s": round(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, 1),
    }  # fmt: skip


def main() -> int:
    """Run all."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--only", default="")
    parser.add_argument("--work", type=Path)
    parser.add_argument("--out", default="doubles")
    parser.add_argument("--controls", action=argparse.BooleanOptionalAction)
    a = parser.parse_args()
    rows: dict[str, dict] = {}
    with tempfile.TemporaryDirectory() as scratch:
        work = a.work or Path(scratch)
        for equal in (True, False) if a.controls is None else (not a.controls,):
            for label, kind, rich, path in SETS:
                name = f"{label}, {'equal' if equal else 'different'}"
                if not re.search(a.only, name):
                    continue
                truth = {f"p{k:02d}.jpg": p for k, p in enumerate(photographs(kind, path, rich=rich, equal=equal))}
                folder = work / re.sub(r"\W+", "-", name)
                written({n: p.grey for n, p in truth.items()}, folder)
                rows[name] = {"photographs": len(truth), **outcome(truth, folder)}
                print(name, json.dumps(rows[name]), flush=True)
    doubles = [r for n, r in rows.items() if n.endswith(", equal")]
    controls = [r for n, r in rows.items() if n.endswith("different")]
    count = {k: sum(r["outcome"] == k for r in doubles) for k in ("right", "named", "folded")}
    summary = {
        "doubles": count, "controls": len(controls),
        "controls_doubted": sum(r.get("doubted", False) for r in controls),
        "controls_wrong": sum(r["outcome"] != "right" for r in controls),
    }  # fmt: skip
    print(json.dumps(summary))
    (RESULTS / f"{a.out}.json").write_text(json.dumps({"summary": summary, "sets": rows}, indent=1) + "\n", "utf-8")
    return int(count["folded"] > 0)


if __name__ == "__main__":
    raise SystemExit(main())
