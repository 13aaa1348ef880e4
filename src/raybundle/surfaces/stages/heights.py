"""Stage: heights above a plane on a grid, tile by tile, and what orientation does to many of them together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.io.block.arrays import block_of_arrays
from raybundle.io.photos.photo import Photo
from raybundle.io.photos.quantisation import quantisation_tables
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.counting import counted
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import Product
from raybundle.pipeline.stage import Means, Stage
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task
from raybundle.surfaces.depths.depth_map import DepthMap
from raybundle.surfaces.depths.filters import Flag
from raybundle.surfaces.depths.jpeg_blocks import quantisation_noise, reach_of_blocks, share_of_blocks
from raybundle.surfaces.depths.levels import HALF
from raybundle.surfaces.depths.orientation import CommonRoot, ShiftCovariance
from raybundle.surfaces.depths.pairs import Sources
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.grid import HeightGrid
from raybundle.surfaces.heights.heights import STEEPEST, PointsOfCells, between_maps, on_grid
from raybundle.surfaces.heights.node_sums import Moments, moments
from raybundle.surfaces.heights.steps import halo, steps_of
from raybundle.surfaces.state import SURFACE, MeasuredHeights
from raybundle.surfaces.tasks import adjustment_key, all_done, stored_part, stored_together
from raybundle.surfaces.tiles import BLOCK_CELLS, TILE_CELLS, tile_of_number, tiles_across

VERSION, STEPS_VERSION = 6, 4
ABOVE, LAYER, TILE = "surface above", "surface layer", "surface heights"
"""First words of the keys of what is kept"""
SAMPLES = 48
"""Points of a part and map that stand for all of them."""
POINT_S, CELL_S = 3e-6, 1e-6
"""CPU seconds of a point and a cell, for the order and the time that is left."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What heights depend on."""

    adjustment: Adjustment
    chosen: tuple[Sources, ...]
    clouds: Mapping[int, str]
    maps: Mapping[int, str]
    shifts: Mapping[int, str]
    grid: HeightGrid
    photos: Mapping[int, Photo]


@dataclass(frozen=True, slots=True, kw_only=True)
class AboveTask:
    """The points of a reference above the grid."""

    block: str
    """key of a part of the block with the reference's image alone"""
    cloud: str
    map: str
    shifts: str
    together: str
    grid: HeightGrid
    quantised: float
    """standard deviation of grey values by quantisation; 0: none"""
    reach_px: float
    """of errors by blocks of compression"""
    drawn: float
    """share of the sources that they are of"""


@dataclass(frozen=True, slots=True, kw_only=True)
class TileTask:
    """The heights of a tile."""

    tile: int
    above: tuple[str, ...]
    """of the references that have points in it"""
    images: tuple[int, ...]
    grid: HeightGrid
    apart: float
    """correlation of noise and roughness of two references at one place"""


@dataclass(frozen=True, slots=True, kw_only=True)
class StepTask:
    """The heights of a tile, with their standard deviations by steps."""

    tile: int
    own: str
    """key of its layer"""
    others: tuple[tuple[int, str], ...]
    """tiles around it, and the keys of their layers"""
    grid: HeightGrid


def measure(i: Inputs, means: Means) -> MeasuredHeights:
    """All tiles by tasks."""
    refs = sorted(i.clouds)
    about = adjustment_key(i.adjustment)
    together = stored_together(i.adjustment, i.chosen, refs, means, about)
    tasks = [_above(i, means, k, together) for k in refs]
    all_done(means, tasks, "points above the grid")
    above = {k: t.key for k, t in zip(refs, tasks, strict=True)}
    there = dict[int, list[int]]()
    for k, key in above.items():
        for tile in means.store.wanted(key, ("tiles",))["tiles"].tolist():
            there.setdefault(tile, []).append(k)
    apart = between_maps(i.chosen)
    layers = [_tile(i.grid, tile, mine, [above[k] for k in mine], apart) for tile, mine in sorted(there.items())]
    all_done(means, layers, "heights")
    keys = {tile: t.key for tile, t in zip(sorted(there), layers, strict=True)}
    tiles = [_steps(i.grid, tile, keys) for tile in sorted(keys)]
    all_done(means, tiles, "steps between heights")
    found = {tile: t.key for tile, t in zip(sorted(keys), tiles, strict=True)}
    return MeasuredHeights(grid=i.grid, tiles=found, above=above, together=together, adjustment=about, apart=apart)


def _above(i: Inputs, means: Means, k: int, together: str) -> Task:
    """The task of a reference."""
    block = i.adjustment.adjusted
    own = stored_part(block, [k], means.store)
    points = len(means.store.lent(i.clouds[k], ("image",))["image"])
    inputs = (own, i.clouds[k], i.maps[k], i.shifts[k], together)
    noise = quantisation_noise(quantisation_tables(i.photos[k].path))
    sources = next(s.sources for s in i.chosen if s.reference == k)
    drawn, reach = reach_of_blocks(block, k, sources) if noise else (0.0, 0.0)
    options = AboveTask(
        block=own, cloud=i.clouds[k], map=i.maps[k], shifts=i.shifts[k], together=together, grid=i.grid,
        quantised=noise, reach_px=reach, drawn=drawn,
    )  # fmt: skip
    return Task(
        key=key_of(ABOVE, VERSION, *inputs, i.grid, noise, reach, drawn), function=f"{__name__}:above_of",
        options=options, inputs=inputs, name=block.images.ids[k], cost=points * POINT_S,
    )  # fmt: skip


def _tile(grid: HeightGrid, tile: int, images: Sequence[int], above: Sequence[str], apart: float) -> Task:
    """The task of a tile."""
    key = key_of(LAYER, VERSION, tile, images, above, grid, apart)
    return Task(
        key=key, function=f"{__name__}:tile_of", inputs=tuple(above),
        options=TileTask(tile=tile, above=tuple(above), images=tuple(images), grid=grid, apart=apart),
        name=f"tile {tile}", cost=TILE_CELLS**2 * CELL_S * (1 + len(above)),
    )  # fmt: skip


def _steps(grid: HeightGrid, tile: int, layers: Mapping[int, str]) -> Task:
    """The task of the steps in a tile."""
    across, (row, column) = tiles_across(grid), divmod(tile, tiles_across(grid))
    around = [
        (r * across + c, layers[r * across + c])
        for r in range(row - 1, row + 2)
        for c in range(max(column - 1, 0), min(column + 2, across))
        if (r, c) != (row, column) and r * across + c in layers
    ]
    inputs = (layers[tile], *(key for _, key in around))
    return Task(
        key=key_of(TILE, STEPS_VERSION, tile, inputs, grid), function=f"{__name__}:steps_in", inputs=inputs,
        options=StepTask(tile=tile, own=layers[tile], others=tuple(around), grid=grid),
        name=f"tile {tile}", cost=TILE_CELLS**2 * CELL_S,
    )  # fmt: skip


def above_of(store: Folder, task: AboveTask) -> Product:
    """The task: the points of a reference above the grid, tile by tile, and how orientation moves parts of tiles."""
    cloud = store.wanted(task.cloud, ("xyz", "normal", "across", "size", "place"))
    g, plane = task.grid.grid, task.grid.plane
    uvh = plane.coordinates(cloud["xyz"]) if len(cloud["xyz"]) else np.zeros((0, 3))
    J = plane.jacobian(cloud["xyz"].mean(axis=0)) if len(uvh) else np.eye(3)
    normal = cloud["normal"] @ np.linalg.inv(J)
    upright = normal[:, 2]
    cells = task.grid.cells(uvh[:, :2])
    size = np.linalg.norm(normal, axis=1)
    kept = (upright > STEEPEST * size) & (cells >= 0).all(axis=1) & (cells < [g.width, g.height]).all(axis=1)
    at = np.flatnonzero(kept)
    column, row = cells[at].T
    block = _number(column, row, BLOCK_CELLS, g.width)
    tile = _number(column, row, TILE_CELLS, g.width)
    order = np.lexsort((block, tile))
    at, tile, block = at[order], tile[order], block[order]
    tiles, begin = np.unique(tile, return_index=True)
    n = normal[at]
    slope = np.stack([-n[:, 0] / n[:, 2], n[:, 1] / n[:, 2]], axis=1) * g.pixel
    across = np.asarray(cloud["across"][at], float) / n[:, 2, None]
    contrast = store.wanted(task.map, ("contrast",))["contrast"].ravel()[np.asarray(cloud["place"][at])]
    by_blocks = np.sqrt(task.drawn * share_of_blocks(task.quantised, contrast)) * across[:, 0]
    across[:, 0] *= _alike(store, task, np.asarray(cloud["place"][at]))
    length, cells_of_px = _length(store, task, np.asarray(cloud["size"][at], float))
    blocks, moved = _moved(store, task, cloud, at, block, (column[order], row[order], uvh[at, 2]))
    return {
        "tiles": tiles, "begin": np.append(begin, len(at)), "column": column[order], "row": row[order],
        "height": uvh[at, 2], "slope": slope.astype(np.float32), "local": across[:, 0].astype(np.float32),
        "orientation": across[:, 1].astype(np.float32), "by_blocks": by_blocks.astype(np.float32),
        "reach": np.array(task.reach_px * cells_of_px), "blocks": blocks, "length": np.array(length),
        "products": moved.products, "sums": moved.sums, "base": moved.base,
    }  # fmt: skip


def _number(column: Array, row: Array, side: int, width: int) -> Index:
    """Of the squares of so many cells, row by row."""
    return (row // side).astype(np.int64) * -(-width // side) + (column // side).astype(np.int64)


def _length(store: Folder, task: AboveTask, size: Array) -> tuple[float, float]:
    """Distance in cells at which errors of two points correlate by 1 / e; cells of a pixel of the photograph."""
    px = float(store.wanted(task.map, ("correlation_px",))["correlation_px"][0])
    cells = float(np.median(size)) * task.grid.unit / task.grid.grid.pixel if len(size) else 1 / px
    return px * cells, cells


def _alike(store: Folder, task: AboveTask, place: Index) -> Array:
    """Factors (n,) of the standard deviations by noise and roughness of points, by their places in the map.

    Errors of depths that were measured at half the size reach twice as far: their mean over an area has twice the
    standard deviation.  Heights know one length: of such points the standard deviations are doubled in its place, which
    is too much for a single cell.
    """
    flags = store.wanted(task.map, ("flags",))["flags"].ravel()[place]
    return np.where(flags & np.uint8(Flag.COARSE), HALF, 1.0)


def _moved(
    store: Folder,
    task: AboveTask,
    cloud: Mapping[str, Array],
    at: Index,
    block: Index,
    place: tuple[Array, Array, Array],
) -> tuple[Index, Moments]:
    """Parts of tiles, and what shows how the points of this reference in them move with each independent error.

    place  columns, rows and heights of the points
    """
    together = CommonRoot.of_arrays(store.wanted(task.together))
    blocks, begin, count = np.unique(block, return_index=True, return_counts=True)
    if not len(at):
        return blocks, moments(*place, (np.zeros((0, together.root.shape[1])) for _ in range(3)), begin)
    some = [
        b + np.unique(np.linspace(0, n - 1, min(n, SAMPLES)).astype(int)) for b, n in zip(begin, count, strict=True)
    ]
    chosen = np.concatenate(some)
    shifts = ShiftCovariance.of_arrays(store.wanted(task.shifts)).among(together)
    found = DepthMap.of_arrays(store.wanted(task.map))
    pixel = cloud["place"][at[chosen]]
    xy, t = found.grid.xy_px.reshape(-1, 2)[pixel], np.asarray(found.t, float).ravel()[pixel]
    rays = ReferenceRays.of(block_of_arrays(store.wanted(task.block)), 0)
    sensitivity = found.shift.reshape(-1, found.shift.shape[2], 2)[pixel]
    moved = shifts.moved(xy, t, sensitivity, rays.by_t(xy, t))
    J = task.grid.plane.jacobian(cloud["xyz"].mean(axis=0))
    column, row, height = (x[chosen] for x in place)
    # blocks begin anew with each tile, whose side holds a whole number of them
    right, down = (x / BLOCK_CELLS % 1 - 0.5 for x in (column, row))
    first = np.cumsum([0, *(len(s) for s in some[:-1])])
    return blocks, moments(right, down, height, (np.einsum("j,njq->nq", J[k], moved) for k in (2, 0, 1)), first)


def tile_of(store: Folder, task: TileTask) -> Product:
    """The task: the heights of a tile, and by how much each reference weighs in its parts."""
    own = tile_of_number(task.grid, task.tile)
    parts, by_blocks = list[PointsOfCells](), list[Array]()
    lengths, reaches = list[float](), list[float]()
    for image, key in zip(task.images, task.above, strict=True):
        a = store.lent(key)
        k = int(np.searchsorted(a["tiles"], task.tile))
        mine = slice(*a["begin"][k : k + 2].tolist())
        lengths.append(float(a["length"]))
        reaches.append(float(a["reach"]))
        by_blocks.append(np.asarray(a["by_blocks"][mine], float))
        parts.append(
            PointsOfCells(
                column=a["column"][mine] - own.x, row=a["row"][mine] - own.y, height=a["height"][mine],
                slope=np.asarray(a["slope"][mine], float), local=np.asarray(a["local"][mine], float),
                orientation=np.asarray(a["orientation"][mine], float),
                image=np.full(mine.stop - mine.start, image, np.int32),
            )
        )  # fmt: skip
    points = PointsOfCells.joined(parts)
    length = float(np.average(lengths, weights=[max(len(p), 1) for p in parts]))
    found, weights = on_grid(points, (own.height, own.width), length, task.apart)
    across = -(-own.width // BLOCK_CELLS)
    block = _number(points.column, points.row, BLOCK_CELLS, own.width)
    share = np.zeros((len(task.images), across * -(-own.height // BLOCK_CELLS)))
    row_of = np.searchsorted(np.array(task.images), points.image)
    np.add.at(share, (row_of, block), weights)
    share /= np.maximum(share.sum(axis=0), 1e-300)
    # all of a cell are drawn alike
    inside = np.flatnonzero(weights)
    number = _number(points.column[inside], points.row[inside], 1, own.width)
    drawn = np.bincount(number, (weights * np.concatenate(by_blocks))[inside], minlength=own.width * own.height)
    reach = max(reaches, default=0.0)
    return {
        **found.as_arrays(), "blocks": drawn.reshape(own.height, own.width).astype(np.float32) * (reach > 0),
        "blocks_reach": np.array(reach), "images": np.array(task.images), "share": share.astype(np.float32),
        "length": np.array(length),
    }  # fmt: skip


def steps_in(store: Folder, task: StepTask) -> Product:
    """The task: the heights of a tile, with what steps within the resolution do to them."""
    layer, own = dict(store.wanted(task.own)), tile_of_number(task.grid, task.tile)
    length = float(layer["length"])
    rim = min(halo(length), TILE_CELLS)
    window = own.grown(rim)
    height, local = (np.full((window.height, window.width), np.nan) for _ in range(2))
    for tile, key in ((task.tile, task.own), *task.others):
        a = store.lent(key, ("height", "local"))
        for into, name in ((height, "height"), (local, "local")):
            window.take(into, tile_of_number(task.grid, tile), a[name])
    steps = steps_of(height, local, length, task.grid.grid.pixel)
    return {**layer, "step": steps[rim : rim + own.height, rim : rim + own.width]}


STAGE = SURFACE.register(
    Stage(
        name="heights", after=("fusion",), function=measure, kinds=(ABOVE, LAYER, TILE),
        put=lambda s, found: replace(s, heights=found), when=lambda s: s.options.grid is not None,
        reported=lambda s: counted(len(s.heights.tiles), "tile") if s.heights else "",
        inputs=lambda s: Inputs(
            adjustment=s.adjustment, chosen=s.chosen, clouds=s.clouds, maps=s.maps, shifts=s.shifts,
            grid=s.wanted_grid, photos=s.photos,
        ),
    )
)  # fmt: skip
