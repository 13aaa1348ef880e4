"""Stage: what each photograph sees of the heights, how well, in which colours; and how bright each is beside others."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import cv2
import numpy as np

from raybundle.adjustment.system.predict import predicted_px
from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.io.block.arrays import block_of_arrays
from raybundle.io.photos.masks import MaskFile, Masks
from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.counting import counted
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import Product
from raybundle.pipeline.stage import Means, Stage
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task
from raybundle.surfaces.depths.depth_map import DepthMap
from raybundle.surfaces.depths.fusion import MapView
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.grid import HeightGrid
from raybundle.surfaces.heights.interpolation import slopes_of
from raybundle.surfaces.heights.seams import gains
from raybundle.surfaces.heights.sight_lines import SIGMAS, seen_from
from raybundle.surfaces.state import SURFACE, Looks, MeasuredHeights
from raybundle.surfaces.tasks import all_done, colours_of, free_of, stored_part
from raybundle.surfaces.tiles import TILE_CELLS, Window, around, heights_in, tile_of_number
from raybundle.workflows.rectify import STEEPEST

VERSION = 5
LOOK = "surface looks"
PROBES = 16
"""Cells along the side of a tile that are asked whether a photograph shows any of them."""
GRAZING = 0.05
"""Least share of the plane's size with which a slope is seen."""
MARGIN_PX = 2.0
"""Of a photograph, from which no colours are made."""
LEVEL_CELLS = 200_000
"""Cells of the whole that show how bright photographs are."""
CELL_S = 4e-6
"""CPU seconds of a cell and photograph, for the order and the time that is left."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What it depends on."""

    block: Block
    photos: Mapping[int, Photo]
    masks: Masks | None
    maps: Mapping[int, str]
    heights: MeasuredHeights
    pixel: float
    """of the orthophoto, in units of the plane"""


@dataclass(frozen=True, slots=True, kw_only=True)
class LookTask:
    """What a photograph sees."""

    block: str
    """key of a part of the block with its image alone"""
    photo: Photo
    map: str
    tiles: tuple[int, ...]
    heights: tuple[str, ...]
    """keys of the heights of these"""
    grid: HeightGrid
    pixel: float
    mask: MaskFile | None = None


def measure(i: Inputs, means: Means) -> Looks:
    """All photographs by tasks, and their gains."""
    there = _tiles_of_each(i, means.store)
    tasks = {k: _task(i, means, k, tiles) for k, tiles in there.items() if tiles}
    all_done(means, list(tasks.values()), "what photographs see")
    keys = {k: t.key for k, t in tasks.items()}
    if not keys:
        raise InputError("surface.orthophoto_not_shown")
    return Looks(keys=keys, tiles={k: tuple(there[k]) for k in keys}, gains=_gains(i.heights.grid, keys, means.store))


def _tiles_of_each(i: Inputs, store: Folder) -> dict[int, list[int]]:
    """Tiles that each photograph may see."""
    found = {k: list[int]() for k in sorted(i.maps)}
    for tile in sorted(i.heights.tiles):
        xyz = _some_points(i.heights, tile, store)
        for k, mine in found.items():
            camera = i.block.camera_of(k)
            xy = predicted_px(i.block, k, xyz)
            with np.errstate(invalid="ignore"):
                inside = ((xy >= 0) & (xy <= [camera.width_px, camera.height_px])).all(axis=1)
            if inside.any():
                mine.append(tile)
    return found


def _some_points(heights: MeasuredHeights, tile: int, store: Folder) -> Array:
    w = tile_of_number(heights.grid, tile)
    height = store.lent(heights.tiles[tile], ("height",))["height"]
    known = np.argwhere(np.isfinite(height))
    block = np.ravel_multi_index(tuple((known * PROBES // [w.height, w.width]).T), (PROBES, PROBES))
    row, column = known[np.unique(block, return_index=True)[1]].T
    return heights.grid.points_at(w.x + column + 0.5, w.y + row + 0.5, height[row, column])


def _task(i: Inputs, means: Means, k: int, tiles: list[int]) -> Task:
    own = stored_part(i.block, [k], means.store)
    heights = tuple(i.heights.tiles[t] for t in tiles)
    options = LookTask(
        block=own, photo=i.photos[k], map=i.maps[k], tiles=tuple(tiles), heights=heights,
        grid=i.heights.grid, pixel=i.pixel, mask=None if i.masks is None else i.masks.files.get(i.photos[k].name),
    )  # fmt: skip
    worn = [] if i.masks is None else [i.masks.key(i.photos[k])]
    inputs = (own, i.maps[k], *heights)
    return Task(
        key=key_of(LOOK, VERSION, inputs, i.photos[k].content, tiles, i.heights.grid, i.pixel, *worn),
        function=f"{__name__}:look_of", options=options, inputs=inputs, name=i.block.images.ids[k],
        cost=len(tiles) * TILE_CELLS**2 * CELL_S,
    )  # fmt: skip


def look_of(store: Folder, task: LookTask) -> Product:
    """The task: of each tile the cost (T, T) of taking this photograph, and its colours (T, T, 3) there.

    The cost is inf where it does not see a cell.  Also how many of its pixels a cell is wide in the median.
    """
    block = block_of_arrays(store.wanted(task.block))
    g, window = task.grid, around(task.tiles, task.grid)
    height, local, _ = heights_in(store, dict(zip(task.tiles, task.heights, strict=True)), g, window)
    cost = np.full(height.shape, np.inf, np.float32)
    colour = np.zeros((*height.shape, 3), np.uint8)
    cells, xy, scale = _seen(store, task, block, window, height, local)
    px = float(np.median(scale)) if len(scale) else 1.0
    if len(cells):
        row, column = np.divmod(cells, window.width)
        uv = g.places(window.x + column + 0.5, window.y + row + 0.5)
        viewer = ReferenceRays.of(block, 0).viewer(g.plane.coordinates)
        away = viewer - np.column_stack([uv, height[row, column]])
        facing = away[:, 2] / np.linalg.norm(away, axis=1)
        kept = facing > STEEPEST
        right, up = (x.ravel()[cells] for x in slopes_of(cv2.blur(height, (3, 3)), g.grid.pixel))
        # what slopes away from the photograph is seen with larger pixels than the plane
        along = np.maximum(1 - (right * away[:, 0] + up * away[:, 1]) / away[:, 2], GRAZING)
        size = np.hypot(g.grid.pixel / (scale * np.sqrt(along))[kept], task.pixel) / task.pixel
        cost.reshape(-1)[cells[kept]] = np.log(size) - np.log(facing[kept])
        colour.reshape(-1, 3)[cells] = _colours(task.photo, block, xy, px)
    tiles = [tile_of_number(g, t) for t in task.tiles]
    costs = np.full((len(tiles), TILE_CELLS, TILE_CELLS), np.inf, np.float16)
    colours = np.zeros((len(tiles), TILE_CELLS, TILE_CELLS, 3), np.uint8)
    for k, t in enumerate(tiles):
        part = slice(t.y - window.y, t.y - window.y + t.height), slice(t.x - window.x, t.x - window.x + t.width)
        costs[k, : t.height, : t.width], colours[k, : t.height, : t.width] = cost[part], colour[part]
    return {"tiles": np.array(task.tiles), "cost": costs, "colour": colours, "px": np.array(px)}


def _seen(
    store: Folder, task: LookTask, block: Block, window: Window, height: Array, sigma: Array
) -> tuple[Index, Array, Array]:
    """Cells of a window that the photograph sees, their places (n, 2) in it, and the width (n,) of a cell there [px].

    The heights must not hide a cell, and its depth map must show nothing before it.  What counts is how heights differ
    from their neighbours': orientation moves all of them together.
    """
    g, camera = task.grid, block.camera_of(0)
    cells = np.flatnonzero(np.isfinite(height))
    row, column = np.divmod(cells, window.width)
    at = height.ravel()[cells]
    moved = [(0.0, 0.0), (0.5, 0.0), (0.0, 0.5)]
    xy, right, down = (
        predicted_px(block, 0, g.points_at(window.x + column + 0.5 + a, window.y + row + 0.5 + b, at)) for a, b in moved
    )
    with np.errstate(invalid="ignore"):
        inside = ((xy > MARGIN_PX) & (xy < np.array([camera.width_px, camera.height_px]) - MARGIN_PX)).all(axis=1)
        scale = 2 * np.sqrt(np.abs(np.linalg.det(np.stack([right - xy, down - xy], axis=1))))
    inside &= scale > 0
    cells, xy, scale = cells[inside], xy[inside], scale[inside]
    viewer = ReferenceRays.of(block, 0).viewer(g.plane.coordinates)
    column_row = g.cells(viewer[None, :2])[0] - [window.x, window.y]
    seen = seen_from(height, sigma, np.append(column_row, viewer[2]), cells)
    cells, xy, scale = cells[seen], xy[seen], scale[seen]
    row, column = np.divmod(cells, window.width)
    xyz = g.points_at(window.x + column + 0.5, window.y + row + 0.5, height.ravel()[cells])
    free = _nothing_before(store, task, block, xyz, xy, sigma.ravel()[cells])
    used = free_of(task.photo, task.mask, block, 0)
    if used is not None:
        column, row = xy.astype(int).T
        free &= used[row, column]
    return cells[free], xy[free], scale[free]


def _nothing_before(store: Folder, task: LookTask, block: Block, xyz: Array, xy: Array, sigma: Array) -> Array:
    """Whether the photograph's depth map shows nothing before points (n, 3)."""
    found = DepthMap.of_arrays(store.wanted(task.map)).sure()
    rays = ReferenceRays.of(block, 0)
    view = MapView(rays=rays, grid=found.grid, t=found.t, slopes=found.slopes, sigma=np.sqrt(found.variance()))
    if not len(xyz):
        return np.zeros(0, bool)
    there, theirs, _ = view.looked_up(xy)
    t = rays.parameter(xy, xyz)
    # a cell is flat in its middle only: what lies within its side before it is the surface itself
    room = np.hypot(SIGMAS * sigma / task.grid.unit, task.grid.grid.pixel / task.grid.unit)
    with np.errstate(invalid="ignore"):
        return ~(there - t > SIGMAS * theirs + rays.parameters(t, room))


def _colours(photo: Photo, block: Block, xy: Array, px: float) -> Array:
    """Means (n, 3) over cells some pixels wide."""
    small, scale = colours_of(photo, block, 0, px)
    place = (xy * scale).astype(int)
    return small[np.clip(place[:, 1], 0, small.shape[0] - 1), np.clip(place[:, 0], 0, small.shape[1] - 1)]


def _gains(grid: HeightGrid, keys: Mapping[int, str], store: Folder) -> dict[int, tuple[float, ...]]:
    """Factors of red, green and blue of each photograph."""
    every = max(1, int(np.ceil(np.sqrt(grid.grid.width * grid.grid.height / LEVEL_CELLS))))
    samples = dict[int, tuple[Index, Array]]()
    for k, key in keys.items():
        a = store.lent(key)
        numbers, colours = list[Array](), list[Array]()
        for tile, cost, colour in zip(a["tiles"].tolist(), a["cost"], a["colour"], strict=True):
            row, column = np.nonzero(np.isfinite(cost[::every, ::every]))
            numbers.append((tile * TILE_CELLS + row * every) * TILE_CELLS + column * every)
            colours.append(colour[::every, ::every][row, column])
        samples[k] = np.concatenate(numbers), np.concatenate(colours)
    return {k: tuple(v.tolist()) for k, v in gains(samples).items()}


STAGE = SURFACE.register(
    Stage(
        name="photographs on heights", after=("heights",), function=measure, kinds=(LOOK,),
        put=lambda s, found: replace(s, looks=found), when=lambda s: s.options.orthophoto is not None,
        reported=lambda s: counted(len(s.looks.keys), "photograph") if s.looks else "",
        inputs=lambda s: Inputs(
            block=s.block, photos=s.photos, masks=s.masks, maps=s.maps, heights=s.wanted_heights,
            pixel=s.wanted_orthophoto.pixel,
        ),
    )
)  # fmt: skip
