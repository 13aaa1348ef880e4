"""A mesh above a plane: vertices on a grid of heights, triangles where nothing steps, the orthophoto on it."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.surfaces.heights.interpolation import bends_of, beside_steps, height_at
from raybundle.surfaces.orthophoto_files import tiles_of
from raybundle.surfaces.orthophoto_pixels import TILE_PX
from raybundle.surfaces.product_grids import MOST_VERTICES, TEXTURE_PX
from raybundle.surfaces.run import Surface
from raybundle.surfaces.tiles import heights_in, tile_of_number
from raybundle.workflows.rectify import Grid, grid_over

STEEPEST = 3.0
"""Rise of an edge, in sides of a cell, from which its triangle is left out: 72 degrees, beyond which heights above a
plane show nothing of what is there."""
ROOM = 2
"""Cells around a tile from which its vertices are made."""
UNSEEN = 128
"""Grey of a picture's pixels that no photograph shows."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Mesh:
    """Triangles over a plane; arrays (n, ...) of vertices."""

    xyz: Array
    """(n, 3) in the block's frame"""
    sigma: Array
    """(n,) standard deviation of the height in units of the plane, what the surface does between cells included"""
    place: Array
    """(n, 2) in the picture, 0 to 1 from its lower left corner"""
    colours: Array
    """(n, 3) uint8"""
    triangles: Index
    """(m, 3) counterclockwise as seen from the viewer"""
    picture: Array
    """(h, w, 3) uint8"""


def mesh_of(surface: Surface, cell: float) -> Mesh:
    """The mesh of a surface with heights and an orthophoto.

    cell    distance of its vertices, in units of the plane
    raises  InputError where no triangle is left

    It is a relief: what stands behind or below something else is not in it, and it is not closed.
    """
    assert surface.heights is not None
    g = surface.heights.grid.grid
    low = g.top - g.height * g.pixel
    grid = grid_over(
        np.array([g.left, low, g.left + g.width * g.pixel, g.top]), cell, most=MOST_VERTICES, setting="mesh"
    )
    height, sigma = _heights(surface, grid)
    triangles = _triangles(height, cell)
    if not len(triangles):
        raise InputError("surface.mesh_empty", side=cell)
    used, triangles = np.unique(triangles, return_inverse=True)
    row, column = np.divmod(used, grid.width)
    u, v = grid.left + (column + 0.5) * cell, grid.top - (row + 0.5) * cell
    z = height.ravel()[used]
    picture, size = _picture(surface)
    place = np.column_stack([(u - g.left) / size[0], (v - (g.top - size[1])) / size[1]])
    h, w = picture.shape[:2]
    j, i = ((1 - place[:, 1]) * h).astype(int).clip(0, h - 1), (place[:, 0] * w).astype(int).clip(0, w - 1)
    return Mesh(
        xyz=surface.heights.grid.plane.points(np.column_stack([u, v, z])), sigma=sigma.ravel()[used], place=place,
        colours=picture[j, i], triangles=triangles.reshape(-1, 3), picture=picture,
    )  # fmt: skip


def _heights(surface: Surface, grid: Grid) -> tuple[Array, Array]:
    """(rows, columns) heights of vertices and their standard deviations, tile by tile."""
    measured = surface.heights
    assert measured is not None
    ratio = grid.pixel / measured.grid.grid.pixel
    height = np.full((grid.height, grid.width), np.nan)
    sigma = np.full((grid.height, grid.width), np.nan, np.float32)
    for tile in measured.tiles:
        own = tile_of_number(measured.grid, tile)
        columns, rows = (
            np.arange(max(0, int(np.ceil(a / ratio - 0.5))), min(n, int(np.ceil((a + size) / ratio - 0.5))))
            for a, size, n in ((own.x, own.width, grid.width), (own.y, own.height, grid.height))
        )
        if not (len(rows) and len(columns)):
            continue
        window = own.grown(ROOM)
        z, local, orientation = heights_in(surface.store, measured.tiles, measured.grid, window)
        x, y = np.meshgrid((columns + 0.5) * ratio - window.x, (rows + 0.5) * ratio - window.y)
        part, i, j = height_at(z, x, y, measured.grid.grid.pixel)
        between = np.hypot(beside_steps(z, measured.grid.grid.pixel), bends_of(z))
        of_cell = np.hypot(np.hypot(local, orientation), between)
        height[np.ix_(rows, columns)], sigma[np.ix_(rows, columns)] = part, of_cell[j, i]
    return height, sigma


def _triangles(height: Array, cell: float) -> Index:
    """(m, 3) numbers of nodes, row by row: of each square two, along its flatter diagonal."""
    rows, columns = height.shape
    number = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = number[:-1, :-1], number[:-1, 1:], number[1:, :-1], number[1:, 1:]
    flat = height.ravel()
    with np.errstate(invalid="ignore"):
        first = ~(np.abs(flat[b] - flat[c]) < np.abs(flat[a] - flat[d]))
    one = np.where(first[..., None], np.stack([a, c, d], axis=-1), np.stack([a, c, b], axis=-1))
    two = np.where(first[..., None], np.stack([a, d, b], axis=-1), np.stack([b, c, d], axis=-1))
    every = np.concatenate([one.reshape(-1, 3), two.reshape(-1, 3)])
    z = flat[every]
    with np.errstate(invalid="ignore"):
        return every[z.max(axis=1) - z.min(axis=1) <= STEEPEST * cell]


def _picture(surface: Surface) -> tuple[Array, Array]:
    """The orthophoto (h, w, 3), reduced to what graphics cards take, and its size (2,) in units of the plane."""
    made = surface.orthophoto
    assert made is not None
    g, factor = made.grid, 1
    while max(g.width, g.height) > TEXTURE_PX * factor and factor < TILE_PX:
        factor *= 2
    height, width = -(-g.height // factor), -(-g.width // factor)
    found = np.full((height, width, 3), UNSEEN, np.uint8)
    for t in tiles_of(surface):
        w = t.window
        down, right = -w.height % factor, -w.width % factor
        padded = np.pad(t.colours.astype(np.float32), ((0, down), (0, right), (0, 0)))
        seen = padded[..., 3] / 255
        sums = cv2.resize(np.dstack([padded[..., :3] * seen[..., None], seen]), None, fx=1 / factor, fy=1 / factor,
                          interpolation=cv2.INTER_AREA)  # fmt: skip
        some = sums[..., 3] > 0
        y, x = w.y // factor, w.x // factor
        found[y : y + sums.shape[0], x : x + sums.shape[1]][some] = np.rint(sums[some, :3] / sums[some, 3:])
    return found, np.array([width, height]) * factor * g.pixel
