"""Stage: a true orthophoto; each cell of the heights takes a photograph, and each photograph gives its pixels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.block import Block
from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array
from raybundle.numerics.counting import counted
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import Product
from raybundle.pipeline.stage import Means, Stage
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task
from raybundle.surfaces.grid import HeightGrid
from raybundle.surfaces.heights.seams import ROUNDS, chosen, seam_costs
from raybundle.surfaces.orthophoto_pixels import PartTask, tiles_touched
from raybundle.surfaces.state import SURFACE, Looks, MadeOrthophoto, MeasuredHeights
from raybundle.surfaces.tasks import all_done, stored_part
from raybundle.surfaces.tiles import TILE_CELLS, Window, tile_of_number
from raybundle.workflows.rectify import Grid

VERSION = 5
CHOICE, PIXELS = "orthophoto choice", "orthophoto pixels"
"""First words of the keys of what is kept"""
MOST = 12
"""Photographs among which the cells of a tile choose: those that cost least in the mean of what they see."""
UNLIKE, PER_GREY, MOST_UNLIKE = 12.0, 0.02, 1.0
"""Grey values by which a photograph may differ from the median of three or more, and what more costs: what stands
before the surface, and what moved, looks other than the rest."""
CELL_S, PIXEL_S = 1e-5, 3e-6
"""CPU seconds of a cell and photograph, and of a pixel, for the order and the time that is left."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What it depends on."""

    block: Block
    photos: Mapping[int, Photo]
    maps: Mapping[int, str]
    shifts: Mapping[int, str]
    heights: MeasuredHeights
    looks: Looks
    grid: Grid


@dataclass(frozen=True, slots=True, kw_only=True)
class ChoiceTask:
    """Which photograph each cell of a tile takes."""

    tile: int
    images: tuple[int, ...]
    looks: tuple[str, ...]
    """of these, which see anything of it or around it"""
    gains: tuple[tuple[float, ...], ...]
    grid: HeightGrid


def make(i: Inputs, means: Means) -> MadeOrthophoto:
    """All of it by tasks."""
    tasks = {tile: t for tile in sorted(i.heights.tiles) if (t := _choice(i, tile)) is not None}
    all_done(means, list(tasks.values()), "seams")
    choice = {tile: t.key for tile, t in tasks.items()}
    mine = dict[int, list[int]]()
    for tile, key in choice.items():
        for k in means.store.wanted(key, ("images",))["images"].tolist():
            mine.setdefault(k, []).append(tile)
    parts = {k: _part(i, means, k, tiles, choice) for k, tiles in sorted(mine.items())}
    all_done(means, list(parts.values()), "pixels of the orthophoto")
    tiles = dict[int, list[int]]()
    for k, t in parts.items():
        for tile in means.store.wanted(t.key, ("tiles",))["tiles"].tolist():
            tiles.setdefault(tile, []).append(k)
    return MadeOrthophoto(
        grid=i.grid, choice=choice, parts={k: t.key for k, t in parts.items()},
        tiles={k: tuple(v) for k, v in sorted(tiles.items())}, gains=i.looks.gains,
    )  # fmt: skip


def _choice(i: Inputs, tile: int) -> Task | None:
    """The task of a tile of the heights; None where no photograph sees it."""
    grid = i.heights.grid
    near = set(tile_of_number(grid, tile).grown(ROUNDS).tiles(grid))
    images = tuple(k for k, tiles in sorted(i.looks.tiles.items()) if near & set(tiles))
    if not images:
        return None
    looks = tuple(i.looks.keys[k] for k in images)
    levels = tuple(i.looks.gains[k] for k in images)
    return Task(
        key=key_of(CHOICE, VERSION, tile, images, looks, levels, grid), function=f"{__name__}:choice_of",
        options=ChoiceTask(tile=tile, images=images, looks=looks, gains=levels, grid=grid), inputs=looks,
        name=f"tile {tile}", cost=TILE_CELLS**2 * CELL_S * min(len(images), MOST),
    )  # fmt: skip


def _part(i: Inputs, means: Means, k: int, tiles: Sequence[int], choice: Mapping[int, str]) -> Task:
    """The task of a photograph."""
    own = stored_part(i.block, [k], means.store)
    grid = i.heights.grid
    around = tiles_touched(grid, tiles)
    chosen_there = {t: choice[t] for t in around if t in choice}
    heights = {t: i.heights.tiles[t] for t in around if t in i.heights.tiles}
    above = {j: i.heights.above[j] for j in sorted(i.heights.above)}
    options = PartTask(
        image=k, block=own, photo=i.photos[k], map=i.maps[k], look=i.looks.keys[k], shifts=i.shifts[k],
        together=i.heights.together, gains=i.looks.gains[k], mine=tuple(tiles), choice=tuple(chosen_there.items()),
        heights=tuple(heights.items()), above=tuple(above.items()), grid=grid, pixels=i.grid,
    )  # fmt: skip
    inputs = (own, i.maps[k], options.look, options.shifts, options.together, *chosen_there.values(),
              *heights.values(), *above.values())  # fmt: skip
    per_cell = (grid.grid.pixel / i.grid.pixel) ** 2
    return Task(
        key=key_of(PIXELS, VERSION, inputs, i.photos[k].content, options.gains, tiles, grid, i.grid),
        function="raybundle.surfaces.orthophoto_pixels:part_of_orthophoto", options=options, inputs=inputs,
        name=i.block.images.ids[k], cost=len(tiles) * TILE_CELLS**2 * per_cell * PIXEL_S,
    )  # fmt: skip


def choice_of(store: Folder, task: ChoiceTask) -> Product:
    """The task: the image (h, w) that each cell of a tile takes, -1 where none sees it, and which images these are."""
    own = tile_of_number(task.grid, task.tile)
    window = own.grown(ROUNDS).within(task.grid)
    images, cost, colour = _looks_in(store, task, window)
    found = np.full((window.height, window.width), -1, np.int32)
    if len(images):
        seen = np.isfinite(cost)
        cost += _unlike(colour, seen)
        number = chosen(cost, *seam_costs(colour, seen))
        found = np.where(number >= 0, np.array(images, np.int32)[number], -1)
    mine = np.full((own.height, own.width), -1, np.int32)
    own.take(mine, window, found)
    return {"image": mine, "images": np.unique(mine[mine >= 0])}


def _looks_in(store: Folder, task: ChoiceTask, window: Window) -> tuple[list[int], Array, Array]:
    """Images that see most of a window best, their costs (n, h, w), and their levelled colours (n, h, w, 3)."""
    found = list[tuple[float, int, Array, Array]]()
    for k, key, gain in zip(task.images, task.looks, task.gains, strict=True):
        a = store.lent(key, ("tiles", "cost", "colour"))
        cost = np.full((window.height, window.width), np.inf, np.float32)
        colour = np.zeros((window.height, window.width, 3), np.float32)
        for tile, c, rgb in zip(a["tiles"].tolist(), a["cost"], a["colour"], strict=True):
            t = tile_of_number(task.grid, tile)
            window.take(cost, t, np.asarray(c[: t.height, : t.width], np.float32))
            window.take(colour, t, np.asarray(rgb[: t.height, : t.width], np.float32) * np.array(gain, np.float32))
        seen = np.isfinite(cost)
        if seen.any():
            found.append((float(np.exp(-cost[seen]).sum()), k, cost, colour))
    best = sorted(sorted(found, key=lambda f: (-f[0], f[1]))[:MOST], key=lambda f: f[1])
    if not best:
        return [], np.zeros(0), np.zeros(0)
    return [f[1] for f in best], np.stack([f[2] for f in best]), np.stack([f[3] for f in best])


def _unlike(colour: Array, seen: Array) -> Array:
    """(n, h, w) cost of differing from the median of three or more."""
    several = seen.sum(axis=0) > 2
    grey = np.where(seen, colour.mean(axis=3), np.nan)
    cost = np.zeros(seen.shape, np.float32)
    if several.any():
        there = grey[:, several]
        off = np.abs(there - np.nanmedian(there, axis=0))
        cost[:, several] = np.nan_to_num(np.clip(PER_GREY * (off - UNLIKE), 0, MOST_UNLIKE))
    return cost


STAGE = SURFACE.register(
    Stage(
        name="orthophoto", after=("photographs on heights",), function=make, kinds=(CHOICE, PIXELS),
        put=lambda s, found: replace(s, orthophoto=found), when=lambda s: s.options.orthophoto is not None,
        reported=lambda s: counted(len(s.orthophoto.parts), "photograph") if s.orthophoto else "",
        inputs=lambda s: Inputs(
            block=s.block, photos=s.photos, maps=s.maps, shifts=s.shifts, heights=s.wanted_heights,
            looks=s.wanted_looks, grid=s.wanted_orthophoto,
        ),
    )
)  # fmt: skip
