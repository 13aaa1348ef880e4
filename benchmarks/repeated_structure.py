"""Repeated structure: rendered objects whose parts look alike, oriented from nothing and compared with the truth.

    python benchmarks/repeated_structure.py [WORK]

A round tower with six identical windows (24 photographs) and a facade of ten identical bays (16), each with walls of
strong, weak and hardly any texture.  Prints and stores for each: photographs oriented, the largest error of a
projection centre after a similarity, in shares of the distance of neighbours, and what is said of repeated structure.
Right is an error below 0.1; wrong in silence is an error above that with neither a fault nor status 3.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import cv2
import numpy as np
from runs import of_block
from scipy.ndimage import gaussian_filter

RESULTS = Path(__file__).resolve().parent / "results/repeated_structure.json"
W, H, C = 1200, 900, 1100.0
NOISE, QUALITY = 2.0, 92
CONTRASTS = {"strong": 20, "weak": 6, "none": 2}


def wall(height: int, width: int, rng: np.random.Generator, contrast: float) -> np.ndarray:
    """Texture that is nowhere the same."""
    total = np.zeros((height, width), np.float32)
    for size, share in ((2, 0.6), (6, 0.8), (20, 0.6)):
        layer = gaussian_filter(rng.normal(size=(height, width)).astype(np.float32), size, mode="wrap")
        total += share * layer / layer.std()
    return 140 + contrast * total


def window(height: int, width: int, seed: int) -> np.ndarray:
    """Texture that is repeated."""
    rng = np.random.default_rng(seed)
    picture = np.full((height, width), 60.0, np.float32)
    for _ in range(160):
        place, axes = rng.uniform(0, [width, height]), rng.uniform(4, 26, 2)
        grey = float(rng.uniform(10, 240))
        cv2.ellipse(picture, (tuple(place), tuple(axes), float(rng.uniform(0, 180))), grey, -1)
    return cv2.GaussianBlur(picture, (0, 0), 1)


def towards(centre: np.ndarray, target: np.ndarray) -> np.ndarray:
    """Rotation sensor_from_object of a level camera."""
    z = (centre - target) / np.linalg.norm(centre - target)
    x = np.cross([0, 0, 1], z)
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(z, x), z])


def rays(R: np.ndarray) -> np.ndarray:
    """Directions (H, W, 3) in object space."""
    y, x = np.mgrid[0:H, 0:W] + 0.5
    return np.stack([x - W / 2, H / 2 - y, np.full_like(x, -C)], axis=-1) @ R


def shown(texture: np.ndarray, u: np.ndarray, v: np.ndarray, hit: np.ndarray) -> np.ndarray:
    """The texture at columns u and rows v, bright where the object is not."""
    hit = hit & (u >= 0) & (u < texture.shape[1] - 1) & (v >= 0) & (v < texture.shape[0] - 1)
    found = cv2.remap(
        texture, np.clip(u, 0, texture.shape[1] - 1).astype(np.float32), v.astype(np.float32), cv2.INTER_CUBIC
    )
    return np.where(hit, found, 220.0)


def tower(contrast: float) -> list[tuple[np.ndarray, np.ndarray]]:
    """Photographs with their projection centres."""
    rng, radius, height, scale = np.random.default_rng(1), 3.0, 6.0, 150
    texture = wall(int(height * scale), round(2 * np.pi * radius * scale), rng, contrast).astype(np.float32)
    for k in range(6):
        u = int(texture.shape[1] / 6 * (k + 0.5))
        texture[240:600, u - 130 : u + 130] = window(360, 260, 7)
    result = []
    for k in range(24):
        a = 2 * np.pi * k / 24
        c = np.array([11 * np.cos(a), 11 * np.sin(a), 2.5 + 0.4 * (k % 2)])
        d = rays(towards(c, np.array([0, 0, 3.0])))
        A, B = (d[..., :2] ** 2).sum(axis=-1), d[..., :2] @ c[:2]
        root = B**2 - A * (c[:2] @ c[:2] - radius**2)
        t = (-B - np.sqrt(np.maximum(root, 0))) / A
        P = c + t[..., None] * d
        u = np.arctan2(P[..., 1], P[..., 0]) % (2 * np.pi) * radius * scale
        result.append((shown(texture, u, texture.shape[0] - P[..., 2] * scale, (root > 0) & (t > 0)), c))
    return result


def facade(contrast: float) -> list[tuple[np.ndarray, np.ndarray]]:
    """As `tower`."""
    rng, width, height, scale = np.random.default_rng(2), 40.0, 8.0, 110
    texture = wall(int(height * scale), int(width * scale), rng, contrast).astype(np.float32)
    for k in range(10):
        u = int(texture.shape[1] / 10 * (k + 0.5))
        texture[200:620, u - 130 : u + 130] = window(420, 260, 8)
    result = []
    for k in range(16):
        x = 3 + 34 * k / 15
        c = np.array([x, -8.0 - 1.5 * (k % 2), 3.5 + 0.6 * (k % 3)])
        d = rays(towards(c, np.array([x + 1.2 * (-1) ** k, 0, 4.0])))
        t = -c[1] / d[..., 1]
        P = c + t[..., None] * d
        result.append((shown(texture, P[..., 0] * scale, texture.shape[0] - P[..., 2] * scale, t > 0), c))
    return result


def oriented(photographs: list[tuple[np.ndarray, np.ndarray]], folder: Path) -> dict:
    """What `orient` makes of them; the camera is given, since a plane and level views hardly determine it."""
    rng = np.random.default_rng(3)
    (folder / "photos").mkdir(parents=True)
    for k, (grey, _) in enumerate(photographs):
        noisy = np.clip(grey + rng.normal(0, NOISE, grey.shape), 0, 255).astype(np.uint8)
        cv2.imwrite(str(folder / f"photos/p{k:02d}.jpg"), noisy, [cv2.IMWRITE_JPEG_QUALITY, QUALITY])
    (folder / "camera.toml").write_text(
        f'[cameras.1]\nmodel = "brown"\nwidth_px = {W}\nheight_px = {H}\npixel_mm = [0.001, 0.001]\n'
        f"c_mm = {C * 0.001}\nestimate = []\n",
        encoding="utf-8",
    )
    command = [sys.executable, "-m", "raybundle", "orient", str(folder / "photos"), "--out", str(folder / "project")]
    done = subprocess.run(
        [*command, "--calibration", str(folder / "camera.toml"), "--quick"], capture_output=True, text=True, check=False
    )
    if done.returncode:
        return {"status": done.returncode, "said": done.stderr.strip().splitlines()[:1]}
    result = json.loads((folder / "project/result/result.json").read_text(encoding="utf-8"))
    faults = [w["code"] for w in result["warnings"] if w.get("severity") == "fault"]
    said = [w.get("severity") for w in result["warnings"] if w["code"] == "repeated_structure"]
    cameras = of_block(folder / "project/result/block")
    numbers = sorted(int(name[1:3]) for name in cameras)
    p = np.array([cameras[f"p{k:02d}.jpg"]["centre"] for k in numbers])
    q = np.array([photographs[k][1] for k in numbers])
    step = float(np.median(np.linalg.norm(np.diff([c for _, c in photographs], axis=0), axis=1)))
    p, q = p - p.mean(axis=0), q - q.mean(axis=0)
    U, S, V = np.linalg.svd(q.T @ p)
    D = np.diag([1, 1, np.linalg.det(U @ V)])
    off = np.linalg.norm(q - (S * np.diag(D)).sum() / (p**2).sum() * p @ (U @ D @ V).T, axis=1)
    return {
        "status": 0, "oriented": len(numbers), "photographs": len(photographs),
        "largest_error": round(float(off.max()) / step, 4), "repeated_structure": said, "faults": sorted(set(faults)),
    }  # fmt: skip


def main() -> int:
    """Run all."""
    rows = {}
    with tempfile.TemporaryDirectory() as scratch:
        work = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(scratch)
        for name, make in (("tower", tower), ("facade", facade)):
            for texture, contrast in CONTRASTS.items():
                row = oriented(make(contrast), work / f"{name}-{texture}")
                rows[f"{name}, {texture} texture on the walls"] = row
                print(name, texture, json.dumps(row), flush=True)
    RESULTS.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    silent = [n for n, r in rows.items() if r["status"] == 0 and r["largest_error"] > 0.1 and not r["faults"]]
    print("wrong in silence:", ", ".join(silent) or "none")
    return int(bool(silent))


if __name__ == "__main__":
    raise SystemExit(main())
