"""Exact depth, incidence and sheet of every pixel of the rendered portal, by ray casting."""

from __future__ import annotations

import hashlib
import os
import sys
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from raybundle.io.block.folder import read_block
from raybundle.objects.kinds.base import grid_triangles
from raybundle.objects.sight import Sight
from raybundle.objects.surface import Surface
from raybundle.surfaces.depths.rays import ReferenceRays

ROOT = Path(__file__).resolve().parents[2]
PORTAL = ROOT / "demo_data/portal"
CELL, TEXEL = 0.004, 0.001
"""As tools/render_demo.py makes them."""
ROWS = 200


@dataclass(frozen=True, slots=True, kw_only=True)
class Depths:
    """What the pixels of a photograph show."""

    distance: np.ndarray
    """(h, w) along the ray from the projection centre [m]; NaN where it shows nothing"""
    incidence: np.ndarray
    """(h, w) cosine of the angle between ray and normal"""
    sheet: np.ndarray
    """(h, w) number of the sheet, -1: none"""
    t: np.ndarray
    """(h, w) depth parameter"""


class Portal:
    """The object of the demonstration set and its true block."""

    def __init__(self, cache: Path) -> None:
        self.cache = cache
        source = (ROOT / "tools/demo_scene.py").read_bytes()
        self.key = hashlib.sha256(source + f"{CELL} {TEXEL} 1".encode()).hexdigest()[:12]
        self.block = read_block(PORTAL / "truth")

    def _kept(self, name: str, make) -> dict[str, np.ndarray]:
        path = self.cache / f"{name}-{self.key}.npz"
        if not path.exists():
            new = path.with_suffix(f".{os.getpid()}.npz")
            np.savez(new, **make())
            new.replace(path)
        with np.load(path) as kept:
            return dict(kept)

    @cached_property
    def mesh(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Vertices (n, 3), triangles (m, 3) and the sheet of each triangle."""
        kept = self._kept("mesh", _mesh)
        return kept["vertices"].astype(float), kept["triangles"], kept["sheet"]

    @cached_property
    def sight(self) -> Sight:
        vertices, triangles, _ = self.mesh
        return Sight(Surface(name="portal", vertices=vertices, triangles=triangles), embree=True)

    def cast(self, origin: np.ndarray, direction: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Distances (n,) along unit directions, exact for the triangle that is met, and the triangles (-1: none)."""
        vertices, triangles, _ = self.mesh
        origin = np.broadcast_to(origin, direction.shape)
        met = np.asarray(self.sight.rays.intersects_first(origin - self.sight.middle, direction))
        hit = met >= 0
        a, b, c = (vertices[triangles[met[hit], k]] for k in range(3))
        n = np.cross(b - a, c - a)
        distance = np.full(len(direction), np.nan)
        distance[hit] = ((a - origin[hit]) * n).sum(axis=1) / (direction[hit] * n).sum(axis=1)
        return distance, met

    def depths(self, image: int) -> Depths:
        """Of all pixels of a photograph."""
        kept = self._kept(f"depths-{image:02d}", lambda: self._depths(image))
        rays = ReferenceRays.of(self.block, image)
        size = kept["distance"].shape
        y, x = np.mgrid[: size[0], : size[1]] + 0.5
        _, direction = rays.rays(np.stack([x.ravel(), y.ravel()], axis=1))
        t = np.linalg.norm(direction, axis=1).reshape(size) / kept["distance"]
        return Depths(**kept, t=t)

    def _depths(self, image: int) -> dict[str, np.ndarray]:
        camera = self.block.cameras[self.block.images.camera[image]]
        vertices, triangles, sheet = self.mesh
        rays = ReferenceRays.of(self.block, image)
        found = []
        for top in range(0, camera.height_px, ROWS):
            y, x = np.mgrid[top : min(top + ROWS, camera.height_px), : camera.width_px] + 0.5
            origin, d = rays.rays(np.stack([x.ravel(), y.ravel()], axis=1))
            d = d / np.linalg.norm(d, axis=1, keepdims=True)
            distance, met = self.cast(origin, d)
            a, b, c = (vertices[triangles[met, k]] for k in range(3))
            n = np.cross(b - a, c - a)
            cosine = np.abs((n * d).sum(axis=1)) / np.linalg.norm(n, axis=1)
            part = distance, np.where(met >= 0, cosine, np.nan), np.where(met >= 0, sheet[met], -1)
            found.append([q.reshape(x.shape) for q in part])
        distance, incidence, which = (np.concatenate(q) for q in zip(*found, strict=True))
        return {"distance": distance, "incidence": incidence.astype(np.float32), "sheet": which.astype(np.int16)}


def _mesh() -> dict[str, np.ndarray]:
    """The sheets as tools/render_demo.py draws them: the random numbers of the textures come first."""
    sys.path.insert(0, str(ROOT / "tools"))
    import demo_scene as scene

    rng = np.random.default_rng(scene.SEED)
    for w, h, tint in (
        (*scene.WALL_M, (1.0, 0.95, 0.86)),
        (4.1, 4.1, (0.98, 0.97, 0.92)),
        (5.2 / 1.5, 2.9 / 1.5, (0.86, 0.87, 0.88)),
    ):
        scene.stone((round(h / TEXEL), round(w / TEXEL)), rng, tint)
    vertices, triangles, which, n = [], [], [], 0
    for k, sheet in enumerate(scene.sheets(rng, CELL)):
        rows, columns = sheet.xyz.shape[:2]
        triangles.append(grid_triangles(rows, columns) + n)
        vertices.append(sheet.xyz.reshape(-1, 3))
        which.append(np.full(len(triangles[-1]), k))
        n += rows * columns
    # the renderer holds vertices in single precision
    return {
        "vertices": np.concatenate(vertices).astype(np.float32),
        "triangles": np.concatenate(triangles).astype(np.int32),
        "sheet": np.concatenate(which).astype(np.int16),
    }
