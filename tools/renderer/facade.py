"""A facade of triangles, made from a seed: openings, ledges and a ball in front of it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .classes import CURVED, NAMES, SMOOTH, STEP
from .mesh import Mesh, box, rectangle, sphere
from .terrain import AMBIENT, PLANE, SUN
from .texture import Texture, texture
from .truth_mesh import MeshSurface

Array = NDArray[np.float64]
UPRIGHT = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
"""Object axes of the axes a facade is drawn in: right, up along the facade, out of it."""
FACET = 0.05
"""How far a facet of the ball is below the ball, in pixels."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Facade:
    """A mesh with texture; its front is the plane Y = 0, seen from negative Y.

    codes  (n,)  class of place of each triangle; reveals and the sides of ledges are steps
    core   (2,)  half sides [m] along X and Z of what is judged
    """

    mesh: Mesh
    codes: NDArray[np.int8]
    texture: Texture
    core: Array
    gsd: float
    shade: NDArray[np.float32]

    @property
    def axes(self) -> Array:
        """Object axes (3, 3) of right, up and out, as columns."""
        return UPRIGHT

    def seen(self, origins: Array, directions: Array) -> NDArray[np.float32]:
        """Light along rays (m, n, 3); see `exposure.Seen`. Beyond the facade it is dark."""
        t, index = self.mesh.cast(origins, directions)
        met = index >= 0
        place = origins + np.where(met, t, 1)[..., None] * directions
        light = self.texture.at(*np.moveaxis(place, -1, 0))
        light *= np.where(met, self.shade[index], 0.05)
        return light

    def hidden(self, points: Array, centre: Array) -> NDArray[np.bool_]:
        """Whether something stands between points (n, 3) on the mesh and a projection centre."""
        found = np.zeros(len(points), dtype=bool)
        for triangle in self.mesh.near_lines(points, centre - points):
            t = self.mesh.meet(int(triangle), points, centre - points)
            found |= (t > 1e-6) & (t < 1)
        return found

    def control(self, places: Array, rng: np.random.Generator) -> Array:
        """Points (n, 3) of the front near places (n, 2), in shares of the core; away from edges."""
        spread = np.linspace(0, 0.3, 40)[:, None] * rng.uniform(-1, 1, (len(places), 40, 2))
        plan = self.core * np.clip(places[:, None] + spread, -1, 1)
        points = np.insert(plan.reshape(-1, 2), 1, 0.0, axis=1)
        true = MeshSurface(mesh=self.mesh, codes=self.codes, core=self.core, gsd=self.gsd)
        normals = np.broadcast_to([0.0, -1.0, 0.0], points.shape)
        good = np.abs(np.nan_to_num(true.distances(points, normals, self.gsd), nan=1)) < 1e-9
        good &= true.classes_at(points, 20 * self.gsd) == SMOOTH
        good = good.reshape(len(places), -1)
        return points.reshape(len(places), -1, 3)[good.any(axis=1), good.argmax(axis=1)[good.any(axis=1)]]

    def write(self, path: Path) -> None:
        """Write triangles and classes (`truth.read_surface` reads them)."""
        np.savez(
            path,
            triangles=self.mesh.triangles,
            codes=self.codes,
            class_names=np.array(NAMES),
            core=self.core,
            gsd=self.gsd,
        )


def facade(seed: int, width: float, gsd: float) -> Facade:
    """A wall with four by three openings, ledges below some of them, and a ball.

    width  width of a photograph on the object [m]; what is judged is 1.0 by 0.8 of it
    """
    rng = np.random.default_rng(seed)
    core = np.array([0.5, 0.4]) * width
    columns, rows = ((np.arange(n) + 0.5) / n * 2 - 1 for n in (4, 3))
    half = np.array([0.14, 0.18]) * core
    columns, rows = (part + 0.06 * rng.uniform(-1, 1, len(part)) for part in (columns, rows))
    openings = [np.array([u, v]) * core for u in columns for v in rows]
    depth = rng.choice(np.array([0.02, 0.04, 0.06]) * width, len(openings))
    ball = int(rng.integers(len(openings)))
    parts = [_front(openings, half, core + 0.3 * width)]
    for k, (middle, deep) in enumerate(zip(openings, depth, strict=True)):
        if k == ball:
            parts.append(
                rectangle(np.array([*(middle - half), 0]), np.array([2 * half[0], 0, 0]), np.array([0, 2 * half[1], 0]))
            )
            continue
        parts.append(_recess(middle, half, deep))
        if rng.uniform() < 0.5:
            low = np.array([middle[0] - 1.1 * half[0], middle[1] - 1.3 * half[1], 0])
            parts.append(box(low, low + np.array([2.2 * half[0], 0.2 * half[1], 0.02 * width])))
    flat = np.concatenate(parts)
    radius = 0.8 * half.min()
    rings = int(np.ceil(np.pi * np.sqrt(radius / (8 * FACET * gsd))))
    round_part = sphere(np.array([*openings[ball], 0.5 * radius]), radius, rings)
    round_part = round_part[round_part[..., 2].max(axis=1) > 0]
    drawn = np.concatenate([flat, round_part])
    mesh = Mesh(drawn @ UPRIGHT.T)
    codes = np.repeat(np.array([SMOOTH, CURVED], dtype=np.int8), [len(flat), len(round_part)])
    codes[: len(flat)][np.abs(mesh.normals[: len(flat), 1]) < 0.5] = STEP
    sun = UPRIGHT @ SUN / np.linalg.norm(SUN)
    direct = np.maximum(mesh.normals @ sun, 0) * np.linalg.norm(SUN) / SUN[2]
    own = texture((core[0] + 0.35 * width, core[1] + 0.35 * width), gsd, (), PLANE @ UPRIGHT.T, rng)
    shade = (AMBIENT + (1 - AMBIENT) * direct).astype(np.float32)
    return Facade(mesh=mesh, codes=codes, texture=own, core=core, gsd=gsd, shade=shade)


def _front(openings: list[Array], half: Array, extent: Array) -> Array:
    """The wall's front without its openings, as rectangles between the lines of all their sides."""
    lines = [
        np.unique(np.concatenate([[-extent[k], extent[k]], *([o[k] - half[k], o[k] + half[k]] for o in openings)]))
        for k in (0, 1)
    ]
    found: list[Array] = []
    for x0, x1 in zip(lines[0][:-1], lines[0][1:], strict=True):
        for y0, y1 in zip(lines[1][:-1], lines[1][1:], strict=True):
            middle = np.array([x0 + x1, y0 + y1]) / 2
            if not any((np.abs(middle - o) < half).all() for o in openings):
                found.append(rectangle(np.array([x0, y0, 0]), np.array([x1 - x0, 0, 0]), np.array([0, y1 - y0, 0])))
    return np.concatenate(found)


def _recess(middle: Array, half: Array, deep: float) -> Array:
    """The back and the four reveals of an opening."""
    (x0, y0), (x1, y1) = middle - half, middle + half
    along, up, out = np.array([x1 - x0, 0, 0]), np.array([0, y1 - y0, 0]), np.array([0, 0, deep])
    low = np.array([x0, y0, -deep])
    return np.concatenate(
        [
            rectangle(low, along, up),
            rectangle(low, up, out),
            rectangle(low + along, out, up),
            rectangle(low, out, along),
            rectangle(low + up, along, out),
        ]
    )
