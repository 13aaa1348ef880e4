"""Heights of a surface of satellite scenes beside tie points that took no part, and beside another program's heights.

    python benchmarks/surface_scenes.py SCENES [--heights DSM] [--cell METRES] [--density 1|2|4] [--keep NAME]

SCENES is a folder of images with RPC, as the pair and the triplet of the tests of s2p.  They are oriented; every
second tie point is taken out of the block, which is adjusted without, and intersected with that orientation: so what
orientation has done to all is not in the difference, and the difference is compared with what noise, roughness and
steps say of the height, and the image points of the intersection.

Tie points and surface are measured in the same grey values, so their errors are no independent ones: the difference
scatters by less than the root of both squares.  If one of two estimates of the same data is efficient, the variance of
the difference is the difference of the variances (Hausman 1978): "independent" and "of the same data" are the two ends
between which the truth lies.  DSM is a GeoTIFF of heights above the ellipsoid of another program, brought onto ours by
one shift in space, for each program has an orientation of its own.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

import raybundle as rb  # noqa: E402
from raybundle.block import Block  # noqa: E402
from raybundle.block.select import select_block  # noqa: E402
from raybundle.io.block.folder import read_block, write_block  # noqa: E402
from raybundle.io.raster_library import raster_library  # noqa: E402
from raybundle.surfaces.files.heights import HeightFile, read_heights  # noqa: E402
from raybundle.surfaces.heights.height_model import HeightModel  # noqa: E402

REACH, FEWEST = 64, 500
"""Cells by which another's heights may be moved, and cells in common that tell whether they fit."""
NEIGHBOURS = np.array([[0, 0], [0, 1], [1, 0], [1, 1]])


def told(x: np.ndarray) -> dict[str, float]:
    """Of normalised differences."""
    return {
        "count": len(x), "robust_chi2": round(float((np.median(np.abs(x)) / 0.6745) ** 2), 3),
        "mean_chi2": round(float(np.mean(x**2)), 3),
        "chi2_within_5": round(float(np.mean(x[np.abs(x) < 5] ** 2)), 3),
        "beyond_5": round(float(np.mean(np.abs(x) > 5)), 4),
    }  # fmt: skip


def spread(x: np.ndarray) -> float:
    """Robust standard deviation."""
    return float(1.4826 * np.median(np.abs(x - np.median(x))))


def intersected(adjusted: Block, whole: Block, variance: float) -> tuple[np.ndarray, np.ndarray]:
    """Points of a block by the orientation of another: coordinates and covariances by their image points alone."""
    o = whole.observations
    xyz, found = np.array(whole.points.xyz), np.full((len(whole.points), 3, 3), np.nan)
    image = {name: k for k, name in enumerate(adjusted.images.ids)}
    for p in range(len(xyz)):
        rows = np.flatnonzero(o.point == p)
        if len(rows) < 2:
            continue
        xx, yy, xy = variance * np.asarray(o.cov_px2)[rows].T
        C = np.stack([xx, xy, xy, yy], axis=1).reshape(-1, 2, 2)
        for _ in range(5):
            seen = []
            for r in rows:
                camera = adjusted.camera_of(image[whole.images.ids[o.image[r]]])
                seen.append(camera.scene.observe(xyz[p : p + 1], camera.parameters))
            J = np.concatenate([s.by_point[0] for s in seen])
            W = np.zeros((2 * len(rows), 2 * len(rows)))
            for k, c in enumerate(C):
                W[2 * k : 2 * k + 2, 2 * k : 2 * k + 2] = np.linalg.inv(c)
            l = np.concatenate([o.xy_px[r] - s.xy_px[0] for r, s in zip(rows, seen, strict=True)])
            found[p] = np.linalg.inv(J.T @ W @ J)
            xyz[p] += found[p] @ J.T @ W @ l
    return xyz, found


def at(model: HeightModel, cells: np.ndarray) -> tuple[np.ndarray, ...]:
    """Heights at places between the middles of cells, their local standard deviations, and slopes by column and row."""
    x, y = (cells - 0.5).T
    i, j = np.floor(x).astype(int), np.floor(y).astype(int)
    rows, columns = model.shape
    good = (i >= 0) & (j >= 0) & (i < columns - 1) & (j < rows - 1)
    i, j, u, v = np.where(good, i, 0), np.where(good, j, 0), x - i, y - j
    h, s = model.heights.height.astype(float), model.local.astype(float)
    a, b, c, d = (h[j + dj, i + di] for dj, di in NEIGHBOURS)
    value = (1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * c + u * d)
    by_u, by_v = (1 - v) * (b - a) + v * (d - c), (1 - u) * (c - a) + u * (d - b)
    # errors of neighbours are alike over some cells: the mean of their standard deviations is that of the height
    weights = ((1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v)
    sigma = sum(w * s[j + dj, i + di] for w, (dj, di) in zip(weights, NEIGHBOURS, strict=True))
    return np.where(good, value, np.nan), sigma, by_u, by_v


def beside_ties(
    folder: Path, work: Path, cell: float, density: str
) -> tuple[dict[str, object], HeightModel, HeightFile]:
    """Orientation, surface, and differences at tie points that took no part."""
    if not (work / "project/result/result.json").is_file():
        rb.orient(folder, work / "project", report=False)
    whole = read_block(work / "project/result/block")
    out = np.arange(len(whole.points)) % 2 == 1
    kept = select_block(whole, "point", ~out)
    if not (work / "kept").exists():
        write_block(kept, work / "kept")
    done = rb.surface(work / "kept", work / "surface", photos=(folder,), dsm=cell, density=density)
    model, file = read_heights(work / "surface")
    adjustment = done.surface.adjustment
    xyz, C = intersected(adjustment.adjusted, select_block(whole, "point", out), adjustment.variance_factor)
    grid = done.surface.heights.grid
    uvh, G = grid.plane.coordinates(xyz), grid.plane.jacobian(xyz.mean(axis=0))
    height, sigma, by_u, by_v = at(model, grid.cells(uvh[:, :2]))
    slope = np.stack([-by_u / file.cell, by_v / file.cell, np.ones(len(xyz))], axis=1)
    own = np.einsum("ni,nij,nj->n", slope, G @ C @ G.T, slope)
    d = uvh[:, 2] - height
    good = np.isfinite(d / sigma) & np.isfinite(own)
    d, own, sigma = d[good], own[good], sigma[good]
    figures: dict[str, object] = {
        "points_out": int(out.sum()), "with_height": int(good.sum()),
        "cells_with_height": round(float(model.known.mean()), 3),
        "median_m": round(float(np.median(d)), 3), "robust_m": round(spread(d), 3),
        "sigma_point_m": round(float(np.median(np.sqrt(own))), 3), "sigma_height_m": round(float(np.median(sigma)), 3),
        "sigma_with_orientation_m": round(float(np.nanmedian(np.where(model.known, model.sigma, np.nan))), 3),
        "independent": told(d / np.hypot(sigma, np.sqrt(own))),
        "of_the_same_data": {
            "mean_chi2": round(float(np.mean(d**2) / abs(np.mean(sigma**2 - own))), 3),
            "robust_chi2": round(spread(d) ** 2 / abs(float(np.median(sigma**2 - own))), 3),
        },
    }  # fmt: skip
    return figures, model, file


def beside_another(model: HeightModel, file: HeightFile, other: Path) -> dict[str, object]:
    """Differences to another program's heights, before and after one shift in space."""
    from rasterio.warp import Resampling, reproject

    library = raster_library()
    with library.open(other) as raster:
        there = np.full(model.shape, np.nan, np.float32)
        to = library.transform.from_origin(file.left, file.top, file.cell, file.cell)
        reproject(
            raster.read(1), there, src_transform=raster.transform, src_crs=raster.crs, src_nodata=np.nan,
            dst_transform=to, dst_crs=library.crs.CRS.from_wkt(file.wkt), dst_nodata=np.nan,
            resampling=Resampling.bilinear,
        )  # fmt: skip
    h = model.heights.height.astype(float)
    there, first = _brought_near(h, there)
    by_v, by_u = np.gradient(h, file.cell)
    d = h - there
    good = np.isfinite(d) & np.isfinite(by_u) & np.isfinite(by_v)
    A = np.column_stack([by_u[good], -by_v[good], np.ones(int(good.sum()))])
    e, shift, w = d[good], np.zeros(3), np.ones(int(good.sum()))
    for _ in range(20):  # Huber
        shift = np.linalg.lstsq(A * w[:, None], e * w, rcond=None)[0]
        r = np.abs(e - A @ shift)
        w = np.sqrt(np.minimum(1, 1.5 * 1.4826 * np.median(r) / np.maximum(r, 1e-9)))
    left = e - A @ shift
    return {
        "cells": int(good.sum()), "median_m": round(float(np.median(e)), 3), "robust_m": round(spread(e), 3),
        "shift_m": np.round(shift * [-1, -1, 1] + np.append(first * file.cell, 0.0), 2).tolist(),
        "left_robust_m": round(spread(left), 3),
        "left_within_2_m": round(float(np.mean(np.abs(left) < 2)), 4),
    }  # fmt: skip


def _brought_near(ours: np.ndarray, theirs: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Another's heights moved by whole cells to where they fit best, and by how many east and north."""
    by, step = np.zeros(2, int), REACH // 4
    while step:
        tried = [by + step * np.array([i, j]) for i in range(-4, 5) for j in range(-4, 5)]
        by = min(tried, key=lambda b: _misfit(ours, _moved(theirs, b)))
        step //= 2
    return _moved(theirs, by), by * [1, -1]


def _moved(heights: np.ndarray, by: np.ndarray) -> np.ndarray:
    return np.roll(heights, (by[1], by[0]), axis=(0, 1))


def _misfit(ours: np.ndarray, theirs: np.ndarray) -> float:
    d = (ours - theirs)[::3, ::3]
    d = d[np.isfinite(d)]
    return spread(d) if len(d) > FEWEST else float("inf")


def main() -> None:
    """All of it."""
    parser = argparse.ArgumentParser()
    parser.add_argument("scenes", type=Path)
    parser.add_argument("--heights", type=Path, help="of another program")
    parser.add_argument("--cell", type=float, default=0.5)
    parser.add_argument("--density", default="1", choices=("1", "2", "4"))
    parser.add_argument("--work", type=Path, help="where orientation and surface are kept")
    parser.add_argument("--keep", metavar="NAME", help="into benchmarks/results/surface_scenes.json, under this name")
    given = parser.parse_args()
    if not given.scenes.is_dir():
        print(f"skipped: {given.scenes} is not there")
        return
    work = given.work or Path(tempfile.mkdtemp())
    work.mkdir(exist_ok=True, parents=True)
    figures, model, file = beside_ties(given.scenes, work, given.cell, given.density)
    if given.heights is not None:
        figures["another"] = beside_another(model, file, given.heights)
    print(json.dumps(figures, indent=1))
    if given.keep:
        file = ROOT / "benchmarks/results/surface_scenes.json"
        kept = json.loads(file.read_text()) if file.is_file() else {}
        file.write_text(json.dumps({**kept, given.keep: figures}, indent=1) + "\n")


if __name__ == "__main__":
    main()
