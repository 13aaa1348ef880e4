"""Pixels of an orthophoto that no photograph gave colours on measured heights: from interpolated heights.

A hole takes the one photograph that sees most of it best, so that nothing in it is shown twice.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.ndimage import distance_transform_edt

from raybundle.adjustment.system.predict import predicted_px
from raybundle.block import Block
from raybundle.io.photos.masks import Masks
from raybundle.io.photos.photo import Photo
from raybundle.io.pictures.resampling import sampled
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.surfaces.grid import HeightGrid
from raybundle.surfaces.heights.height_model import HeightModel
from raybundle.surfaces.heights.hole_filling import filled, parts_of
from raybundle.surfaces.heights.interpolation import height_at
from raybundle.surfaces.heights.sight_lines import seen_from
from raybundle.surfaces.tasks import colours_of, free_of
from raybundle.workflows.rectify import STEEPEST, Grid

MARGIN_PX = 2.0
"""Of a photograph, from which no colours are made."""
UNSEEN = 4.0
"""What a cell of a hole that a photograph does not see costs, in costs of the best photograph."""
ROW = 1024
"""Places that are looked up side by side."""


def fill_holes(
    colours: Array, pixels: Grid, grid: HeightGrid, model: HeightModel, *, widest: float, block: Block,
    photos: Mapping[int, Photo], masks: Masks | None, gains: Mapping[int, tuple[float, ...]],
    progress: Progress = silent,
) -> Mask:  # fmt: skip
    """Give colours (h, w, 4) to pixels without any, in place; which they are (h, w).

    grid    of the heights; its upper left corner is that of `pixels`
    model   heights; holes, and gaps that reach the edge, are interpolated up to the depth `widest`, in its unit
    photos  by image of the block
    gains   factors of the colours of each, as of the rest of the orthophoto
    Limits: what stands in a hole is shown where the interpolated surface is, displaced by its distance from it.
    """
    found = np.zeros(colours.shape[:2], bool)
    reach = widest / grid.grid.pixel
    whole = filled(model, reach, _closed(model.known, reach))
    height, sigma = whole.heights.height, whole.heights.sigma
    ratio = pixels.pixel / grid.grid.pixel
    row, column = np.nonzero(colours[..., 3] == 0)
    x, y = (column + 0.5) * ratio, (row + 0.5) * ratio
    h, i, j = height_at(height, x, y, grid.grid.pixel)
    known = np.isfinite(h)
    row, column, x, y, h = row[known], column[known], x[known], y[known], h[known]
    cells = j[known] * height.shape[1] + i[known]
    if not len(cells):
        return found
    wanted, cell_of = np.unique(cells, return_inverse=True)
    images = sorted(photos)
    chosen = _chosen(_costs(block, images, grid, height, sigma, wanted), wanted, height.shape)[cell_of]
    for done, k in enumerate(images):
        progress("orthophoto holes", done / len(images))
        mine = np.flatnonzero(chosen == done)
        if not len(mine):
            continue
        picture, factor = colours_of(photos[k], block, k)
        mask = None if masks is None else masks.files.get(photos[k].name)
        xy = predicted_px(block, k, grid.points_at(x[mine], y[mine], h[mine]))
        values, inside = sampled(picture, _in_rows(xy * factor), known=free_of(photos[k], mask, block, k))
        values, inside = values.reshape(-1, 3)[: len(mine)], inside.ravel()[: len(mine)]
        mine = mine[inside]
        colour = np.clip(np.rint(values[inside] * np.array(gains.get(k, (1.0, 1.0, 1.0)))), 0, 255)
        colours[row[mine], column[mine], :3] = colour.astype(np.uint8)
        colours[row[mine], column[mine], 3] = 255
        found[row[mine], column[mine]] = True
    progress("orthophoto holes", 1.0)
    return found


def _closed(known: Mask, reach: float) -> Mask:
    """(rows, columns) cells with heights and those in gaps of less than twice a reach [cells] between them."""
    room = int(np.ceil(reach)) + 1
    near = np.asarray(distance_transform_edt(~np.pad(known, room))) <= reach
    inner = np.asarray(distance_transform_edt(near)) > reach
    return np.asarray(inner[room:-room, room:-room] | known)


def _costs(block: Block, images: list[int], grid: HeightGrid, height: Array, sigma: Array, cells: Index) -> Array:
    """(photographs, n) size of a pixel on the surface over the cosine, of cells; infinite: not seen."""
    j, i = np.divmod(cells, height.shape[1])
    xyz = grid.points_at(i + 0.5, j + 0.5, height[j, i])
    here = np.column_stack([grid.places(i + 0.5, j + 0.5), height[j, i]])
    costs = np.full((len(images), len(cells)), np.inf)
    for n, k in enumerate(images):
        camera = block.camera_of(k)
        viewer = grid.plane.coordinates(block.images.centre[k][None])[0]
        ray = viewer - here
        distance = np.linalg.norm(ray, axis=1)
        facing = ray[:, 2] / distance
        xy = predicted_px(block, k, xyz)
        with np.errstate(invalid="ignore"):
            inside = (xy > MARGIN_PX) & (xy < [camera.width_px - MARGIN_PX, camera.height_px - MARGIN_PX])
        rows = np.flatnonzero(inside.all(axis=1) & (facing > STEEPEST))
        eye = np.append(grid.cells(viewer[None, :2])[0], viewer[2])
        rows = rows[seen_from(height, sigma, eye, cells[rows])]
        scale = float(np.mean(camera.pixel_mm)) / camera.sensor.camera_constant(camera.parameters)
        costs[n, rows] = distance[rows] * scale / facing[rows] ** 2
    return costs


def _chosen(costs: Array, cells: Index, shape: tuple[int, int]) -> Index:
    """(n,) which photograph each cell takes, -1: none: that of its hole where it sees the cell, else the best one."""
    seen = np.isfinite(costs)
    best = costs.min(axis=0)
    hole = np.zeros(shape[0] * shape[1], bool)
    hole[cells] = True
    number = parts_of(hole.reshape(shape))[0].ravel()[cells]
    share = np.where(seen, costs / np.where(np.isfinite(best), best, 1.0), UNSEEN)
    of_hole = np.argmin([np.bincount(number, weights=s) for s in share], axis=0)[number]
    mine = seen[of_hole, np.arange(len(cells))]
    return np.where(mine, of_hole, np.where(np.isfinite(best), costs.argmin(axis=0), -1))


def _in_rows(places: Array) -> Array:
    """Places (n, 2) as (rows, ROW, 2), the last row filled up."""
    rows = max(1, -(-len(places) // ROW))
    found = np.full((rows * ROW, 2), np.nan)
    found[: len(places)] = places
    return found.reshape(rows, ROW, 2)
