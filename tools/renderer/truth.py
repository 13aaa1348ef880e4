"""Distances of points from the true surface, and the class of place that they stand in."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .classes import BORDER, RIDGE, STEP
from .height_field import HeightField
from .mesh import Mesh
from .truth_mesh import MeshSurface

Array = NDArray[np.float64]
FARTHEST = 0.5
"""Longest distance along a normal that is searched [m]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Surface:
    """The true surface of a rendered terrain.

    field        heights
    classes      (p, q) codes of `classes` at every `class_step`-th node
    core         (2,) half sides [m] of the rectangle around the origin that is judged
    gsd          mean size of a pixel on the object [m]
    """

    field: HeightField
    classes: NDArray[np.int8]
    class_step: int
    core: Array
    gsd: float

    def in_core(self, points: Array) -> NDArray[np.bool_]:
        """Whether points (n, 3) stand in the rectangle that is judged."""
        return np.all(np.abs(points[:, :2]) <= self.core, axis=1)

    def classes_at(self, points: Array, half: float) -> NDArray[np.int8]:
        """Class of place of points (n, 3), by all of a square window of half side `half` [m] around each.

        A window with a wall is `step`, otherwise one with a crease is `ridge`; one with several other classes is
        `border`. The window is that of matching: what stands in it is what the point was measured by.
        """
        size = self.field.cell * self.class_step
        reach = int(np.ceil(half / size))
        steps = np.arange(-reach, reach + 1)
        middle = np.rint((points[:, [1, 0]] - self.field.origin[[1, 0]]) / size).astype(int)
        rows = np.clip(middle[:, 0, None] + steps, 0, self.classes.shape[0] - 1)
        columns = np.clip(middle[:, 1, None] + steps, 0, self.classes.shape[1] - 1)
        found = np.empty(len(points), dtype=np.int8)
        for part in _parts(len(points), len(steps) ** 2):
            window = self.classes[rows[part, :, None], columns[part, None, :]].reshape(-1, len(steps) ** 2)
            low, high = window.min(axis=1), window.max(axis=1)
            code = np.where(low == high, low, BORDER).astype(np.int8)
            for crease in (RIDGE, STEP):
                code[(window == crease).any(axis=1)] = crease
            found[part] = code
        return found

    def window_planes(self, points: Array, half: float) -> tuple[Array, Array]:
        """Mean height (n,) [m] and unit normal (n, 3), upwards, of the plane of best fit in a window of each point.

        half  half side [m] of the square window in plan
        """
        reach = max(round(half / self.field.cell), 1)
        steps = self.field.cell * np.arange(-reach, reach + 1)
        moment = np.mean(steps**2)
        mean, normal = np.empty(len(points)), np.empty((len(points), 3))
        for part in _parts(len(points), len(steps) ** 2):
            x = points[part, 0, None, None] + steps[None, None, :]
            y = points[part, 1, None, None] + steps[None, :, None]
            z = self.field.at(*np.broadcast_arrays(x, y))
            mean[part] = z.mean(axis=(1, 2))
            dx = (z.mean(axis=1) * steps).mean(axis=1) / moment
            dy = (z.mean(axis=2) * steps).mean(axis=1) / moment
            normal[part] = np.stack([-dx, -dy, np.ones_like(dx)], axis=1)
        return mean, normal / np.linalg.norm(normal, axis=1, keepdims=True)

    def normals(self, points: Array, half: float) -> Array:
        """Unit normals (n, 3) of the planes of best fit in the windows of points (n, 3)."""
        return self.window_planes(points, half)[1]

    def distances(self, points: Array, normals: Array) -> Array:
        """Distances (n,) [m] of points (n, 3) from the surface, along unit normals (n, 3), positive above it.

        Of several places where the line meets the surface the nearest counts. NaN where it meets none within FARTHEST.
        """
        step = self.field.cell / 2
        above = self._above(points, normals, np.zeros(len(points)))
        near, far = np.zeros(len(points)), np.full(len(points), np.nan)
        far[above == 0] = 0
        left = np.flatnonzero(above != 0)
        for k in range(1, int(FARTHEST / step) + 1):
            if not left.size:
                break
            for sign in (1.0, -1.0):
                shift = np.full(left.size, sign * k * step)
                met = self._above(points[left], normals[left], shift) * above[left] <= 0
                far[left[met]], near[left[met]] = shift[met], shift[met] - sign * step
                left = left[~met]
        for _ in range(40):
            middle = 0.5 * (near + far)
            beyond = self._above(points, normals, np.nan_to_num(middle)) * above <= 0
            near, far = np.where(beyond, near, middle), np.where(beyond, middle, far)
        return 0.5 * (near + far)

    def window_distances(self, points: Array, normals: Array, half: float) -> Array:
        """Distances (n,) [m] along normals from the surface averaged over a window of each point, positive above it.

        The mean of n . (P - Q) over the surface points Q that stand in a square window of half side `half` around P:
        what matching by a window can know of the surface at best.
        """
        mean, _ = self.window_planes(points, half)
        return normals[:, 2] * (points[:, 2] - mean)

    def _above(self, points: Array, normals: Array, shift: Array) -> Array:
        """Height above the surface of points moved by `shift` against their normals."""
        x, y, z = (points - shift[:, None] * normals).T
        return z - self.field.at(x, y)


def read_surface(folder: Path) -> Surface | MeshSurface:
    """The surface of a rendered folder (FOLDER/truth/surface.npz)."""
    with np.load(folder / "truth" / "surface.npz") as data:
        if "triangles" in data:
            mesh = Mesh(data["triangles"])
            return MeshSurface(mesh=mesh, codes=data["codes"], core=data["core"], gsd=float(data["gsd"]))
        return Surface(
            field=HeightField(data["heights"], data["origin"], float(data["cell"])),
            classes=data["classes"],
            class_step=int(data["class_step"]),
            core=data["core"],
            gsd=float(data["gsd"]),
        )


def _parts(count: int, width: int) -> list[slice]:
    """Slices of `count` rows of which each has at most a few million cells."""
    many = max(int(4e6 / width), 1)
    return [slice(i, i + many) for i in range(0, count, many)]
