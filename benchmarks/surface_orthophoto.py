"""Places of the true orthophoto of the rendered portal beside its exact geometry, and how much its seams show.

    python benchmarks/surface_orthophoto.py PROJECT SURFACE [--keep]

PROJECT is what `raybundle orient` made of the demonstration set portal with its control, SURFACE a folder of
`raybundle surface --dsm CELL --ortho PIXEL --mesh CELL` of it.  Each pixel of the orthophoto is followed to its place
in the photograph that it was taken from, and from there along the true ray to the true object: what it shows lies so
far from where it is shown.  Vertices of the mesh stand above the plane as high as the true object there, or are off by
so much.  Marks are circles whose centres are measured in the picture, beside their known coordinates.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

import cv2
import numpy as np
import rasterio
import trimesh

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.surface.truth import Portal  # noqa: E402

from raybundle.adjustment.system.predict import predicted_px  # noqa: E402
from raybundle.surfaces.depths.rays import ReferenceRays  # noqa: E402
from raybundle.surfaces.files.heights import read_heights  # noqa: E402
from raybundle.surfaces.heights.interpolation import closed, height_at  # noqa: E402
from raybundle.workflows.sources import read_source, result_within  # noqa: E402

EVERY = 3
"""Of rows and columns of pixels that are followed"""
MARK_M = 0.012
"""Radius around a mark's centre within which its inner circle lies"""


def told(x: np.ndarray) -> dict[str, float]:
    """Of normalised errors."""
    x = x[np.isfinite(x)]
    return {
        "count": len(x), "robust_chi2": round(float((np.median(np.abs(x)) / 0.6745) ** 2), 3),
        "within_1": round(float(np.mean(np.abs(x) < 1)), 3), "within_1.96": round(float(np.mean(np.abs(x) < 1.96)), 3),
        "beyond_5": round(float(np.mean(np.abs(x) > 5)), 5),
    }  # fmt: skip


def followed(block, truth: Portal, plane, at: np.ndarray, h: np.ndarray, image: np.ndarray) -> np.ndarray:
    """(n, 2) of the plane, of what pixels at (n, 2) and heights (n,) show."""
    origin, axes = plane
    found = np.full((len(at), 2), np.nan)
    by_name = {n: k for k, n in enumerate(truth.block.images.file)}
    for k in np.unique(image).tolist():
        mine = image == k
        xyz = origin + np.column_stack([at[mine], h[mine]]) @ axes
        xy = predicted_px(block, k, xyz)
        rays = ReferenceRays.of(truth.block, by_name[block.images.file[k]])
        start, d = rays.rays(xy)
        d /= np.linalg.norm(d, axis=1, keepdims=True)
        distance, _ = truth.cast(start, d)
        found[mine] = ((start + distance[:, None] * d - origin) @ axes.T)[:, :2]
    return found


def marks(truth: Portal, grey: np.ndarray, sigma: np.ndarray, place) -> list[dict[str, float]]:
    """Centres of the white circles of the targets, less their coordinates [mm]."""
    left, top, pixel, origin, axes = place
    found = []
    for name, xyz in zip(truth.block.points.ids, truth.block.points.xyz, strict=True):
        if not name.startswith("T"):
            continue
        u, v, _ = (xyz - origin) @ axes.T
        x, y = (u - left) / pixel, (top - v) / pixel
        r = round(MARK_M / pixel)
        j, i = int(y), int(x)
        part = grey[j - r : j + r + 1, i - r : i + r + 1].astype(float)
        if part.shape != (2 * r + 1,) * 2:
            continue
        level = (np.percentile(part, 5) + np.percentile(part, 95)) / 2
        count, labels = cv2.connectedComponents((part > level).astype(np.uint8))
        middle = labels[r, r]
        if middle == 0 or count < 2:
            continue
        near = cv2.dilate((labels == middle).astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
        w = np.where(near, np.clip(part - np.percentile(part, 5), 0, None), 0)
        yy, xx = np.mgrid[j - r : j + r + 1, i - r : i + r + 1] + 0.5
        ex, ey = (w * xx).sum() / w.sum() - x, (w * yy).sum() / w.sum() - y
        found.append({
            "mark": name, "right_mm": round(1000 * ex * pixel, 3), "up_mm": round(-1000 * ey * pixel, 3),
            "sigma_mm": np.round(1000 * np.nanmedian(sigma[:, j - 2 : j + 3, i - 2 : i + 3], axis=(1, 2)), 3).tolist(),
        })  # fmt: skip
    return found


def seams(colours: np.ndarray, image: np.ndarray) -> dict[str, float]:
    """Differences of grey values across seams, beside those of neighbours within photographs."""
    grey = colours.astype(float).mean(axis=2)
    across, beside = [], []
    for a, b in ((np.s_[:, 3:], np.s_[:, :-3]), (np.s_[3:], np.s_[:-3])):
        both = (image[a] >= 0) & (image[b] >= 0)
        d = np.abs(grey[a] - grey[b])
        across.append(d[both & (image[a] != image[b])])
        beside.append(d[both & (image[a] == image[b])])
    a, b = np.concatenate(across), np.concatenate(beside)
    return {"pixels": len(a), "across": round(float(a.mean()), 2), "within": round(float(b.mean()), 2)}


def vertices(folder: Path, truth: Portal, plane) -> dict[str, float]:
    """Heights of the mesh less those of the object."""
    origin, axes = plane
    mesh = trimesh.load(folder / "mesh.ply", process=False)
    data = mesh.metadata["_ply_raw"]["vertex"]["data"]
    xyz = np.column_stack([data[a] for a in "xyz"]).astype(float)
    far = 1.0
    z = (xyz - origin) @ axes[2]
    distance, _ = truth.cast(xyz + (far - z)[:, None] * axes[2], np.broadcast_to(-axes[2], xyz.shape))
    e = z - (far - distance)
    return {
        "vertices": len(xyz), "triangles": len(mesh.faces),
        "sigma_mm": round(1000 * float(np.median(data["sigma"])), 3),
        "robust_mm": round(1000 * float(np.nanmedian(np.abs(e))) / 0.6745, 3), **told(e / np.ravel(data["sigma"])),
    }  # fmt: skip


def main() -> None:
    """All of it."""
    parser = argparse.ArgumentParser()
    parser.add_argument("project", type=Path)
    parser.add_argument("surface", type=Path)
    parser.add_argument("--keep", action="store_true", help="into benchmarks/results/surface_orthophoto.json")
    given = parser.parse_args()
    (ROOT / ".pytest_cache/d/surface").mkdir(parents=True, exist_ok=True)
    truth = Portal(ROOT / ".pytest_cache/d/surface")
    export, _ = read_source(result_within(given.project))
    model, file = read_heights(given.surface)
    origin = np.array(file.plane["origin"])
    axes = np.array([file.plane[k] for k in ("right", "up", "normal")])
    with rasterio.open(given.surface / "orthophoto.tif") as f:
        colours, pixel = np.moveaxis(f.read(), 0, 2), f.transform.a
        left, top = f.transform.c, f.transform.f
    with rasterio.open(given.surface / "orthophoto_sigma.tif") as f:
        right, up, number = f.read()
    h = model.heights
    height, _, _ = closed(h.height, h.local, h.orientation)
    y, x = np.nonzero(np.isfinite(right[::EVERY, ::EVERY]))
    y, x = y * EVERY, x * EVERY
    u, v = left + (x + 0.5) * pixel, top - (y + 0.5) * pixel
    at = np.column_stack([u, v])
    z, _, _ = height_at(height, (u - file.left) / file.cell, (file.top - v) / file.cell, file.cell)
    shown = followed(export.block, truth, (origin, axes), at, z, number[y, x].astype(int))
    e, s = at - shown, np.column_stack([right[y, x], up[y, x]])
    size = np.hypot(*e.T)
    found = {
        "pixel_m": pixel, "cell_m": file.cell, "seen": round(float(np.mean(colours[..., 3] > 0)), 4),
        "followed": len(e), "off_robust_mm": round(1000 * float(np.nanmedian(np.abs(e))) / 0.6745, 3),
        "sigma_mm": round(1000 * float(np.median(s)), 3), "right": told(e[:, 0] / s[:, 0]),
        "up": told(e[:, 1] / s[:, 1]),
        "beyond_a_pixel": round(float(np.nanmean(size > pixel)), 4),
        "beyond_50_mm": round(float(np.nanmean(size > 0.05)), 5),
        "seams": seams(colours[..., :3], np.nan_to_num(number, nan=-1).astype(int)),
        "marks": marks(truth, colours[..., :3].mean(axis=2), np.stack([right, up]), (left, top, pixel, origin, axes)),
    }  # fmt: skip
    if (given.surface / "mesh.ply").is_file():
        found["mesh"] = vertices(given.surface, truth, (origin, axes))
    print(json.dumps(found, indent=1))
    if given.keep:
        path = ROOT / "benchmarks/results/surface_orthophoto.json"
        path.write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
