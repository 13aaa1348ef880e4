"""Judge a surface by the truth of a rendered set: tools/judge_surface.py FOLDER SURFACE [--later FOLDER SURFACE].

FOLDER is what tools/render.py wrote, SURFACE what
raybundle surface PROJECT --out SURFACE --horizontal --dsm CELL
wrote for a project that was oriented with control of the folder. Nothing is fitted to the truth.

points   of points.ply, errors along their rays, and along normals of planes through the true surface in their windows
cells    errors of single heights, against the mean of the true surface over the cell
means    of squares of 100 pixels (20 cm at 2 mm), every half of a side; a square is of the class of 90 % of its cells
volumes  200 outlines that are drawn, above a level base, and above the plane of their rims; their true areas
moved    with --later, of a later date of the same ground: volumes between both surfaces in 200 drawn outlines, and
         the regions of `raybundle heights difference`, which is run beside the surface

Truth comes from the renderer alone. Standard deviations of sums are those that the product states
(`HeightModel.sum_of`, `volume`).
"""

from __future__ import annotations

import argparse
import csv
import json
import subprocess
import sys
from pathlib import Path
from typing import Any, cast

import numpy as np
import rasterio
from matplotlib.path import Path as Polygon
from numpy.typing import NDArray
from renderer.classes import NAMES
from renderer.judging import robust_chi_square, statistics
from renderer.truth import Surface, read_surface
from scipy.ndimage import label

from raybundle.surfaces.files.heights import HeightFile, read_heights
from raybundle.surfaces.files.input import on_same_grid, opened
from raybundle.surfaces.heights.height_model import HeightModel, SumOfHeights
from raybundle.surfaces.heights.resampling import difference
from raybundle.surfaces.heights.volumes import volume

Array = NDArray[np.float64]
WINDOW_PX = 4.0
"""Half side of the matching window [px]"""
POINTS = 30_000
"""Points that are judged at most, drawn among all"""
SQUARE_PX = 100.0
SHARE = 0.9
"""Of a square's cells that give it its class"""
OUTLINES = 200
FINE = 4
"""Places along the side of a cell"""
SEED = 46
NEAR_PX = 25.0
"""Distance from the mean of a window up to which the surface itself is looked for [px]"""


def read_ply(path: Path) -> tuple[dict[str, Array], list[str]]:
    """Vertices of a binary little-endian PLY by property, and the names of the photographs."""
    sizes = {"float": "<f4", "double": "<f8", "uchar": "u1", "ushort": "<u2", "int": "<i4", "uint": "<u4"}
    names = list[str]()
    with path.open("rb") as file:
        count, kinds = 0, list[tuple[str, str]]()
        while (line := file.readline().decode("ascii", "replace").strip()) != "end_header":
            words = line.split()
            if words[:2] == ["element", "vertex"]:
                count = int(words[2])
            elif words[:2] == ["comment", "image"]:
                names.append(words[3])
            elif words and words[0] == "property":
                kinds.append((words[2], sizes[words[1]]))
        values = np.fromfile(file, np.dtype(kinds), count)
    return {name: np.asarray(values[name], float) for name, _ in kinds}, names


class Ground:
    """The true surface above the plane of a grid of heights."""

    def __init__(self, surface: Surface, file: HeightFile) -> None:
        """Of a terrain; the plane has to be level."""
        plane = file.plane
        self.surface, self.file = surface, file
        self.origin, self.right, self.up = (np.array(plane[name], float) for name in ("origin", "right", "up"))
        if abs(np.cross(self.right, self.up)[2] - 1) > 1e-9:
            message = "heights above a plane that is not level"
            raise SystemExit(message)

    def places(self, columns: Array, rows: Array) -> Array:
        """Object points (..., 3) of the plane at columns and rows [cells] of the grid."""
        f = self.file
        u, v = f.left + columns * f.cell, f.top - rows * f.cell
        return self.origin + u[..., None] * self.right + v[..., None] * self.up

    def at(self, columns: Array, rows: Array) -> Array:
        """True heights (...) above the plane."""
        p = self.places(columns, rows)
        return self.surface.field.at(p[..., 0], p[..., 1]) - self.origin[2]

    def cells(self) -> Array:
        """(rows, columns) means of the true heights over the cells."""
        f = self.file
        fine = (np.arange(FINE) + 0.5) / FINE
        found = np.zeros((f.height, f.width))
        for v in fine:
            for u in fine:
                c, r = np.meshgrid(np.arange(f.width) + float(u), np.arange(f.height) + float(v))
                found += self.at(np.asarray(c, float), np.asarray(r, float))
        return found / FINE**2

    def true_area(self, covered: Array) -> float:
        """Area of the true surface over shares of cells (rows, columns), by its own nodes."""
        f = self.file
        rows, columns = np.nonzero(covered)
        n = max(int(np.ceil(f.cell / self.surface.field.cell)) * 2, 4)
        side = (np.arange(n + 1)) / n
        total = 0.0
        for k in range(0, len(rows), 2000):
            r, c = rows[k : k + 2000, None, None], columns[k : k + 2000, None, None]
            shape = (len(r), n + 1, n + 1)
            z = self.at(
                np.broadcast_to(c + side[None, None, :], shape), np.broadcast_to(r + side[None, :, None], shape)
            )
            step = f.cell / n
            dx = 0.5 * (np.diff(z[:, 1:], axis=2) + np.diff(z[:, :-1], axis=2)) / step
            dy = 0.5 * (np.diff(z[:, :, 1:], axis=1) + np.diff(z[:, :, :-1], axis=1)) / step
            total += float((np.sqrt(1 + dx**2 + dy**2).mean(axis=(1, 2)) * covered[rows, columns][k : k + 2000]).sum())
        return total * f.cell**2


def rows_of(classes: NDArray[np.int8], error: Array, sigma: Array) -> list[dict[str, Any]]:
    """Statistics by class, and of all."""
    found = []
    good = np.isfinite(error) & (sigma > 0)
    for code, name in [*enumerate(NAMES), (-1, "all")]:
        mine = good & ((classes == code) | (code == -1))
        if mine.any():
            bias = float(1e3 * np.median(error[mine]))
            beyond = float(np.mean(np.abs(error[mine]) > 3 * sigma[mine]))
            found.append(
                {"class": name, **statistics(error[mine], sigma[mine]), "bias_mm": bias, "beyond_3_sigma": beyond}
            )
    return found


def of_points(surface: Surface, folder: Path, path: Path, *, along: str = "ray") -> list[dict[str, Any]]:
    """Points of the cloud by class of place.

    along  "ray": errors along the ray of a point, as its noise and roughness are stated; "normal": along the normal of
           the plane of best fit in its window. Where the surface is even both are the same. Across a step or a crease
           that plane is no surface: its normal leans away from the ray, and with the angle between both errors grow by
           1 / cos while standard deviations shrink by cos, also those of points that lie well.
    """
    v, names = read_ply(path)
    xyz = np.stack([v[n] for n in ("x", "y", "z")], axis=1)
    inside = np.flatnonzero(surface.in_core(xyz))
    some = np.sort(np.random.default_rng(SEED).choice(inside, min(POINTS, len(inside)), replace=False))
    xyz = xyz[some]
    half = WINDOW_PX * surface.gsd
    cameras = {row["name"]: row["centre_m"] for row in json.loads((folder / "truth" / "cameras.json").read_text())}
    centre = np.array([cameras[name] for name in names])[v["image"][some].astype(int)]
    ray = (centre - xyz) / np.linalg.norm(centre - xyz, axis=1, keepdims=True)
    lines = ray if along == "ray" else surface.normals(xyz, half)
    error = surface.window_distances(xyz, lines, half)
    near = np.abs(error) < NEAR_PX * surface.gsd
    exact = surface.distances(xyz[near], lines[near])
    error[near] = np.where(np.isfinite(exact), exact, error[near])
    noise, rough = (v[f"sigma_{n}"][some] ** 2 for n in ("noise", "roughness"))
    # parts along the ray have no axes: what is left of the axes' variances is that of orientation
    whole = np.stack([v[f"sigma_{n}"][some] for n in "xyz"], axis=1) ** 2
    other = np.maximum(whole - (noise + rough)[:, None] * ray**2, 0)
    if along == "ray":
        # orientation moves the ray as well: a surface that is nearly level feels what it does to heights
        sigma = np.sqrt(noise + rough + other[:, 2] / ray[:, 2] ** 2)
    else:
        sigma = np.sqrt((noise + rough) * (ray * lines).sum(axis=1) ** 2 + (other * lines**2).sum(axis=1))
    codes = surface.classes_at(xyz, half)
    rows = rows_of(codes, error, sigma)
    for row in rows:
        mine = codes == NAMES.index(row["class"]) if row["class"] in NAMES else codes >= 0
        row["noise_mm"], row["roughness_mm"] = (float(1e3 * np.sqrt(np.median(x[mine]))) for x in (noise, rough))
    return rows


def classes_of(ground: Ground) -> NDArray[np.int8]:
    """(rows, columns) class of each cell, by itself and what a window shows beside it; -1 beyond the core."""
    f, surface = ground.file, ground.surface
    c, r = np.meshgrid(np.arange(f.width) + 0.5, np.arange(f.height) + 0.5)
    p = ground.places(np.asarray(c, float), np.asarray(r, float)).reshape(-1, 3)
    half = WINDOW_PX * surface.gsd + f.cell / 2
    code = np.full(len(p), -1, np.int8)
    inside = surface.in_core(p)
    code[inside] = surface.classes_at(p[inside], half)
    return code.reshape(c.shape)


def of_squares(model: HeightModel, truth: Array, codes: NDArray[np.int8], side: int) -> list[dict[str, Any]]:
    """Means of squares by class of place, each by its own standard deviation, and all of a class by their covariance.

    Orientation moves all squares of a set by a shift and two tilts: what they have in common is three draws, however
    many squares there are.  By the covariance of squares that do not overlap these count as three, and the rest is
    judged beside them.
    """
    kinds, errors, sums = list[int](), list[float](), list[SumOfHeights]()
    boxes = list[tuple[int, int]]()
    known = model.known & (codes >= 0)
    for top in range(0, codes.shape[0] - side + 1, max(side // 2, 1)):
        for left in range(0, codes.shape[1] - side + 1, max(side // 2, 1)):
            box = slice(top, top + side), slice(left, left + side)
            part, there = codes[box], known[box]
            if there.mean() < SHARE:
                continue
            count = np.bincount(part[there], minlength=len(NAMES))
            if count.max() < SHARE * side**2:
                continue
            w = np.zeros(model.shape)
            w[box] = there / there.sum()
            found = model.sum_of(w)
            kinds.append(int(count.argmax()))
            errors.append(found.value - float((w * truth).sum()))
            sums.append(found)
            boxes.append((top, left))
    rows = rows_of(np.array(kinds, np.int8), np.array(errors), np.array([x.sigma for x in sums]))
    for row in rows:
        mine = list[int]()
        for k, kind in enumerate(kinds):
            apart = all(max(abs(a - b) for a, b in zip(boxes[k], boxes[m], strict=True)) >= side for m in mine)
            if apart and row["class"] in {NAMES[kind], "all"}:
                mine.append(k)
        moved = np.array([sums[k].moved for k in mine], float)
        C = moved @ moved.T + np.diag([sums[k].local ** 2 for k in mine])
        free = np.asarray(np.linalg.solve(np.linalg.cholesky(C), np.array(errors)[mine]), float)
        row |= {"apart": len(mine), "joint": robust_chi_square(free), "joint_mean": float(np.mean(free**2))}
    return rows


def outlines(
    shape: tuple[int, ...], allowed: NDArray[np.bool_], rng: np.random.Generator, smallest: float
) -> list[tuple[Array, Array]]:
    """Star-shaped rings (n, 2) of columns and rows that are drawn, with the shares of cells that they cover."""
    fine = (np.arange(FINE) + 0.5) / FINE
    found = list[tuple[Array, Array]]()
    for _ in range(50 * OUTLINES):
        if len(found) == OUTLINES:
            break
        size = smallest * np.exp(rng.uniform(0, np.log(6)))
        middle = rng.uniform(0, 1, 2) * np.array(shape[::-1])
        n = int(rng.integers(4, 12))
        angle = np.sort(rng.uniform(0, 2 * np.pi, n))
        if np.diff(np.append(angle, angle[0] + 2 * np.pi)).max() > 2.5:
            continue
        ring = middle + size * rng.uniform(0.5, 1, n)[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
        low, high = np.floor(ring.min(axis=0)).astype(int), np.ceil(ring.max(axis=0)).astype(int)
        if (low < 1).any() or (high > np.array(shape[::-1]) - 1).any():
            continue
        c, r = (np.arange(a, b)[:, None] + fine for a, b in zip(low, high, strict=True))
        grid = np.stack(np.meshgrid(c.ravel(), r.ravel()), axis=-1).reshape(-1, 2)
        inner = Polygon(ring).contains_points(grid).reshape(len(r), FINE, len(c), FINE).mean(axis=(1, 3))
        covered = np.zeros(shape)
        covered[low[1] : high[1], low[0] : high[0]] = inner
        used = covered > 0
        if used.any() and (allowed | ~used).all():
            found.append((ring, covered))
    return found


def summary(errors: Array, sigmas: Array, values: Array) -> dict[str, Any]:
    """Of volumes and areas, with their relative errors."""
    ratio = errors / sigmas
    return {
        "n": len(errors),
        "chi_square": robust_chi_square(ratio),
        "beyond_3": int((np.abs(ratio) > 3).sum()),
        "bias_sigma": float(np.median(ratio)),
        "worst": float(np.abs(ratio).max()) if len(ratio) else 0.0,
        "error": float(np.median(np.abs(errors))),
        "sigma": float(np.median(sigmas)),
        "of_value": float(np.median(errors / np.where(values == 0, 1, values))),
    }


def of_volumes(ground: Ground, model: HeightModel, truth: Array, codes: NDArray[np.int8], seed: int) -> dict[str, Any]:
    """Volumes and true areas in outlines that are drawn, all cells of which have a height."""
    rng = np.random.default_rng([SEED, seed])
    drawn = outlines(model.shape, model.known & (codes >= 0), rng, 25 * ground.surface.gsd / model.cell)
    area = model.cell**2
    kinds = {"level": list[tuple[float, ...]](), "area": list[tuple[float, ...]]()}
    rough = list[tuple[float, ...]]()
    for _, covered in drawn:
        base = float(truth[covered > 0].min()) - 0.05
        found = volume(model, covered, base)
        exact = float((covered * (truth - base)).sum() * area)
        kinds["level"].append((found.net.value - exact, found.net.sigma, exact))
        true = ground.true_area(covered)
        row = (found.true_area - true, found.true_area_sigma, true)
        kinds["area"].append(row)
        mine = np.bincount(codes[covered > 0], minlength=len(NAMES)) / (covered > 0).sum()
        if mine[NAMES.index("clutter")] > SHARE:
            rough.append(row)
    found = {k: summary(*np.array(rows).T) for k, rows in kinds.items() if rows}
    if rough:
        found["area of clutter"] = summary(*np.array(rough).T)
    return found


def of_moved(before: Path, after: Path, first: Surface, second: Surface, seed: int) -> dict[str, Any]:
    """Volumes between two surfaces in drawn outlines; regions that are called moved."""
    one, other = opened(before), opened(after)
    model = difference(one.model, on_same_grid(one, other))
    _, file = read_heights(before)
    a, b = Ground(first, file), Ground(second, file)
    truth = b.cells() - a.cells()
    codes = classes_of(a)
    rng = np.random.default_rng([SEED, seed, 1])
    rows = []
    for _, covered in outlines(model.shape, model.known & (codes >= 0), rng, 25 * first.gsd / model.cell):
        w = covered * model.cell**2
        found = model.sum_of(w)
        exact = float((w * truth).sum())
        rows.append((found.value - exact, found.sigma, exact))
    out = after.parent / f"{after.name}-moved"
    if not out.exists():
        command = [sys.executable, "-m", "raybundle", "heights", "difference", str(before), str(after), "--out"]
        subprocess.run([*command, str(out)], check=True, capture_output=True)
    with rasterio.open(out / "difference.tif") as tif:
        region = np.nan_to_num(tif.read(list(tif.descriptions).index("region") + 1)).astype(int)
    regions = []
    with (out / "moved.csv").open(newline="", encoding="utf-8") as text:
        for row in csv.DictReader(line for line in text if not line.startswith("#")):
            number = int(row["region"])
            mine = region == number
            whole = np.abs(truth) > 0.05 * np.abs(truth[mine]).max(initial=0)
            part = np.zeros(mine.shape, bool)
            names, _ = cast("tuple[NDArray[np.int32], int]", label(whole))
            for k in set(np.unique(names[mine]).tolist()) - {0}:
                part |= names == k
            exact = float(truth[part].sum() * model.cell**2)
            regions.append({**row, "true_volume": exact, "within": float(truth[mine].sum() * model.cell**2)})
    return {"outlines": summary(*np.array(rows).T), "regions": regions}


def printed(title: str, rows: list[dict[str, Any]]) -> None:
    """A table."""
    print(title)
    print("class               n  chi-square  > 3 sigma  > 5 sigma  sigma mm  error mm   bias mm  Spearman")
    for r in rows:
        print(
            f"{r['class']:<14}{r['n']:>7}{r['chi_square']:>12.2f}{100 * r['beyond_3_sigma']:>9.1f} %"
            f"{100 * r['beyond_5_sigma']:>9.2f} %{r['sigma_mm']:>10.3f}{r['error_mm']:>10.3f}{r['bias_mm']:>10.3f}"
            f"{r['spearman']:>10.2f}"
            + (f"{r['noise_mm']:>10.3f} noise{r['roughness_mm']:>10.3f} roughness" if "noise_mm" in r else "")
            + (f"   jointly {r['joint']:.2f}, mean {r['joint_mean']:.2f}, of {r['apart']}" if "joint" in r else "")
        )


def judged(folder: Path, made: Path, seed: int, *, volumes: bool) -> dict[str, Any]:
    """All of a surface."""
    surface = read_surface(folder)
    if not isinstance(surface, Surface):
        message = "a terrain is needed"
        raise SystemExit(message)
    model, file = read_heights(made)
    ground = Ground(surface, file)
    truth, codes = ground.cells(), classes_of(ground)
    h = model.heights
    complete = {
        name: float((model.known & (codes == k)).sum() / (codes == k).sum())
        for k, name in enumerate(NAMES)
        if (codes == k).any()
    }
    found: dict[str, Any] = {
        "points": of_points(surface, folder, made / "points.ply"),
        "points along normals": of_points(surface, folder, made / "points.ply", along="normal"),
        "cells": rows_of(codes[codes >= 0], (h.height - truth)[codes >= 0], np.asarray(model.sigma, float)[codes >= 0]),
        "means": of_squares(model, truth, codes, round(SQUARE_PX * surface.gsd / file.cell)),
        "complete": complete,
    }
    if volumes:
        found["volumes"] = of_volumes(ground, model, truth, codes, seed)
    return found


def main() -> None:
    """Read the command line and print tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("surface", type=Path)
    parser.add_argument("--later", nargs=2, type=Path, metavar=("FOLDER", "SURFACE"))
    parser.add_argument("--seed", type=int, default=1, help="of the outlines")
    parser.add_argument("--no-volumes", action="store_true")
    parser.add_argument("--json", type=Path)
    o = parser.parse_args()
    found = judged(o.folder, o.surface, o.seed, volumes=not o.no_volumes)
    for kind in ("points", "points along normals", "cells", "means"):
        printed(kind, found[kind])
    print("complete  " + "  ".join(f"{k} {100 * v:.1f} %" for k, v in found["complete"].items()))
    if o.later:
        first, second = (read_surface(f) for f in (o.folder, o.later[0]))
        assert isinstance(first, Surface)
        assert isinstance(second, Surface)
        found["moved"] = of_moved(o.surface, o.later[1], first, second, o.seed)
    for name, row in {**found.get("volumes", {}), **({"moved": found["moved"]["outlines"]} if o.later else {})}.items():
        print(f"{name:<16}" + "  ".join(f"{k} {v:.4g}" for k, v in row.items()))
    for row in found.get("moved", {}).get("regions", []):
        print({k: v for k, v in row.items() if "volume" in k or k in {"region", "within", "area"}})
    if o.json:
        o.json.write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
