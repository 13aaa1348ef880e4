"""Rays cast on a grid of heights."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

Array = NDArray[np.float64]
BLOCK = 24
"""Rays of a block, along rows and along columns, for which one range of heights is searched."""
FIRST_LEVEL = 2
TOLERANCE = 2e-4
"""Largest height of a ray's end above or below the surface, in cells."""


class HeightField:
    """A surface z(x, y), bilinear between the nodes of a square grid; constant beyond its rim.

    heights  (ny, nx)  [m]; row i stands at y = origin[1] + i cell, column j at x = origin[0] + j cell
    origin   (2,)      x and y of the first node [m]
    cell               distance between nodes [m]
    """

    def __init__(self, heights: NDArray[np.float32], origin: Array, cell: float) -> None:
        self.heights = heights
        self.origin = np.asarray(origin, dtype=float)
        self.cell = float(cell)
        self._levels()

    def _levels(self) -> None:
        """Largest and least height and largest slope over squares of 2^k cells."""
        h = self.heights
        size = 2**FIRST_LEVEL
        ny, nx = ((n - 1 + size - 1) // size * size + 1 for n in h.shape)
        h = np.pad(h, ((0, ny - h.shape[0]), (0, nx - h.shape[1])), mode="edge")
        high, low = _over_cells(h, np.maximum), _over_cells(h, np.minimum)
        slope_x = _over_squares(np.abs(np.diff(h, axis=1))[:, :], (0, 1), size)
        slope_y = _over_squares(np.abs(np.diff(h, axis=0))[:, :], (1, 0), size)
        steep = (np.hypot(slope_x, slope_y) / self.cell).astype(np.float32)
        levels = [(high, low, steep)]
        while max(levels[-1][0].shape) > 1:
            top, bottom, slope = levels[-1]
            levels.append((_halved(top, np.maximum), _halved(bottom, np.minimum), _halved(slope, np.maximum)))
        self._shape = np.array([level[0].shape for level in levels])
        self._start = np.concatenate([[0], np.cumsum([level[0].size for level in levels])])
        self._high, self._low, self._slope = (np.concatenate([level[k].ravel() for level in levels]) for k in range(3))

    def at(self, x: Array, y: Array) -> Array:
        """Heights [m] at points (x, y) [m] of one shape."""
        grid = np.stack([(y - self.origin[1]) / self.cell, (x - self.origin[0]) / self.cell])
        return ndimage.map_coordinates(self.heights, grid, np.float64, order=1, mode="nearest", prefilter=False)

    def over(self, x0: Array, x1: Array, y0: Array, y1: Array) -> tuple[Array, Array, Array]:
        """Bounds over rectangles: largest and least height [m], largest slope (tangent)."""
        i0, i1 = ((y - self.origin[1]) / self.cell for y in (y0, y1))
        j0, j1 = ((x - self.origin[0]) / self.cell for x in (x0, x1))
        extent = np.maximum(np.maximum(i1 - i0, j1 - j0), 1)
        level = np.clip(np.ceil(np.log2(extent)).astype(int) - FIRST_LEVEL, 0, len(self._shape) - 1)
        size = 2.0 ** (level + FIRST_LEVEL)
        rows, columns = self._shape[level, 0], self._shape[level, 1]
        found: list[tuple[NDArray, NDArray, NDArray]] = []
        for i in (i0, i1):
            for j in (j0, j1):
                row = np.clip((i // size).astype(int), 0, rows - 1)
                column = np.clip((j // size).astype(int), 0, columns - 1)
                k = self._start[level] + row * columns + column
                found.append((self._high[k], self._low[k], self._slope[k]))
        high, low, slope = (np.stack(part) for part in zip(*found, strict=True))
        return high.max(axis=0), low.min(axis=0), slope.max(axis=0)

    def cast(self, ax: Array, ay: Array, bx: Array, by: Array) -> Array:
        """Heights [m] where rays first meet the surface from above.

        ax, ay, bx, by  (m, n)  the rays' x = ax + bx z and y = ay + by z [m]; neighbours in the arrays are neighbours
                                in the photograph; m and n are multiples of BLOCK

        A range of heights is bounded for each block of rays. Where the surface is flatter there than the rays are
        steep, a ray meets it once and is solved by the secant rule to TOLERANCE. Other rays are followed from grid line
        to grid line: between two of them the surface is nearly straight along the ray, and nothing is missed but what a
        twisted cell hides within itself.
        """
        low, high, slope, lean = self._ranges(ax, ay, bx, by)
        once = slope * lean < 0.9
        z = np.empty_like(ax)
        views = [_blocks(part) for part in (ax, ay, bx, by, z)]
        for select, solve in ((once, self._solve), (~once, self._march)):
            if select.any():
                rays = [part[select] for part in views[:4]]
                bounds = [np.broadcast_to(part[select][:, None], rays[0].shape) for part in (low, high)]
                views[4][select] = solve(*(part.ravel() for part in (*rays, *bounds))).reshape(rays[0].shape)
        return _unblocked(views[4], ax.shape)

    def _ranges(self, ax: Array, ay: Array, bx: Array, by: Array) -> tuple[Array, Array, Array, Array]:
        """Least and largest height, largest slope and largest tangent of the rays with the plumb line, by block."""
        corner = [_corners(part) for part in (ax, ay, bx, by)]
        # Between its corners a block's rim bends by distortion and rotation: far less than a cell.
        shape = corner[0].shape[1:]
        low, high = np.full(shape, float(self._low.min())), np.full(shape, float(self._high.max()))
        slope = np.zeros(shape)
        for _ in range(6):
            x = np.stack([corner[0] + z * corner[2] for z in (low, high)])
            y = np.stack([corner[1] + z * corner[3] for z in (low, high)])
            x0, y0 = (part.min(axis=(0, 1)) - self.cell for part in (x, y))
            x1, y1 = (part.max(axis=(0, 1)) + self.cell for part in (x, y))
            high, low, slope = self.over(x0, x1, y0, y1)
        return low.ravel(), high.ravel(), slope.ravel(), np.hypot(corner[2], corner[3]).max(axis=0).ravel()

    def _solve(self, ax: Array, ay: Array, bx: Array, by: Array, low: Array, high: Array) -> Array:
        """Rays that meet the surface once: the secant rule; those it leaves are marched."""
        z0 = 0.5 * (low + high)
        f0 = self.at(ax + bx * z0, ay + by * z0) - z0
        z = z0 + f0
        f = self.at(ax + bx * z, ay + by * z) - z
        tolerance = TOLERANCE * self.cell
        left = np.flatnonzero(np.abs(f) > tolerance)
        for _ in range(8):
            if not left.size:
                return z
            slope = (f[left] - f0[left]) / (z[left] - z0[left])
            step = -f[left] / np.where(np.abs(slope) > 0.05, slope, -1)
            z0[left], f0[left] = z[left], f[left]
            z[left] = new = np.clip(z[left] + step, low[left], high[left])
            f[left] = self.at(ax[left] + bx[left] * new, ay[left] + by[left] * new) - new
            left = left[np.abs(f[left]) > tolerance]
        z[left] = self._march(*(part[left] for part in (ax, ay, bx, by, low, high)))
        return z

    def _march(self, ax: Array, ay: Array, bx: Array, by: Array, low: Array, high: Array) -> Array:
        """Rays that may meet the surface often: down from grid line to grid line, then Illinois between two of them."""
        (next_x, step_x), (next_y, step_y) = (
            _lines((a + b * high - start) / self.cell, b, high, self.cell)
            for a, b, start in ((ax, bx, self.origin[0]), (ay, by, self.origin[1]))
        )
        above, below = high.copy(), low.copy()
        f_above = self.at(ax + bx * high, ay + by * high) - high
        f_below = np.zeros_like(high)
        left = np.arange(high.size)
        while left.size:
            z = np.maximum(np.maximum(next_x, next_y), low[left])
            next_x, next_y = (
                np.where(next_x >= z, next_x - step_x, next_x),
                np.where(next_y >= z, next_y - step_y, next_y),
            )
            f = self.at(ax[left] + bx[left] * z, ay[left] + by[left] * z) - z
            met = (f >= 0) | (z <= low[left])
            below[left[met]], f_below[left[met]] = z[met], f[met]
            past = ~met
            left = left[past]
            above[left], f_above[left] = z[past], f[past]
            next_x, next_y, step_x, step_y = (part[past] for part in (next_x, next_y, step_x, step_y))
        return self._within(ax, ay, bx, by, above, below, f_above, f_below)

    def _within(
        self, ax: Array, ay: Array, bx: Array, by: Array, above: Array, below: Array, f_above: Array, f_below: Array
    ) -> Array:
        """Root between heights above (f <= 0) and below (f >= 0) the surface, by the Illinois rule."""
        z = np.where(f_above < 0, below, above)
        tolerance = TOLERANCE * self.cell
        left = np.flatnonzero((f_below > tolerance) & (f_above < 0))
        side = np.zeros(z.size, dtype=np.int8)
        for _ in range(40):
            if not left.size:
                break
            a, b, fa, fb = above[left], below[left], f_above[left], f_below[left]
            new = (a * fb - b * fa) / (fb - fa)
            f = self.at(ax[left] + bx[left] * new, ay[left] + by[left] * new) - new
            z[left] = new
            under = f > 0
            f_above[left] = np.where(under, np.where(side[left] == 1, fa / 2, fa), f)
            f_below[left] = np.where(under, f, np.where(side[left] == -1, fb / 2, fb))
            above[left], below[left] = np.where(under, a, new), np.where(under, new, b)
            side[left] = np.where(under, 1, -1)
            left = left[np.abs(f) > tolerance]
        return z


def _lines(at: Array, b: Array, high: Array, cell: float) -> tuple[Array, Array]:
    """Height of the first grid line of one direction below `high`, and the distance of such heights.

    at  coordinate at `high`, in cells; it changes by b / cell with height
    """
    step = cell / np.maximum(np.abs(b), 1e-12)
    to_next = np.where(b > 0, at - np.ceil(at) + 1, np.floor(at) + 1 - at)
    return high - to_next * step, step


def _over_cells(h: NDArray[np.float32], pick: np.ufunc) -> NDArray[np.float32]:
    """`pick` over the nodes of squares of 2^FIRST_LEVEL cells, rims included."""
    size = 2**FIRST_LEVEL
    rows = pick(pick.reduceat(h[:-1], np.arange(0, h.shape[0] - 1, size), axis=0), h[size::size])
    return pick(pick.reduceat(rows[:, :-1], np.arange(0, h.shape[1] - 1, size), axis=1), rows[:, size::size])


def _over_squares(part: NDArray[np.float32], node_axis: tuple[int, int], size: int) -> NDArray[np.float32]:
    """Largest of differences over squares of cells; `node_axis` names by 0 the axis that has nodes, not cells."""
    for axis in (0, 1):
        cells = part.shape[axis] - (node_axis[axis] == 0)
        starts = np.arange(0, cells, size)
        last = np.take(part, np.minimum(starts + size, part.shape[axis] - 1), axis=axis)
        part = np.maximum.reduceat(part, starts, axis=axis)
        if node_axis[axis] == 0:
            part = np.maximum(part, last)
    return part


def _halved(part: NDArray[np.float32], pick: np.ufunc) -> NDArray[np.float32]:
    """`pick` over squares of two by two."""
    part = np.pad(part, ((0, part.shape[0] % 2), (0, part.shape[1] % 2)), mode="edge")
    part = pick(part[::2], part[1::2])
    return pick(part[:, ::2], part[:, 1::2])


def _blocks(part: Array) -> Array:
    """Rays (m, n) by block, (blocks, BLOCK^2)."""
    m, n = part.shape
    return part.reshape(m // BLOCK, BLOCK, n // BLOCK, BLOCK).swapaxes(1, 2).reshape(-1, BLOCK * BLOCK)


def _unblocked(part: Array, shape: tuple[int, ...]) -> Array:
    m, n = shape
    return part.reshape(m // BLOCK, n // BLOCK, BLOCK, BLOCK).swapaxes(1, 2).reshape(m, n)


def _corners(part: Array) -> Array:
    """The corner rays of the blocks, (4, rows, columns)."""
    return np.stack([part[i::BLOCK, j::BLOCK] for i in (0, BLOCK - 1) for j in (0, BLOCK - 1)])
