"""Heights on a grid as files: two GeoTIFFs, what states where they lie, and how orientation moves them together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.folders import new_files
from raybundle.io.geo.parsed_names import system_with_heights
from raybundle.io.pictures.geotiff import Write, new_geotiff
from raybundle.io.pictures.rectified import toml_text
from raybundle.io.raster_library import raster_library
from raybundle.io.reading.trees import Json, read_toml
from raybundle.numerics.arrays import Array
from raybundle.numerics.length_units import precision_unit
from raybundle.surfaces.files.checks import (
    OF_HEIGHTS,
    OF_ORIENTATION,
    OF_SIGMAS,
    STEP_SIGMA,
    WHOLE_SIGMA,
    check_belongs,
    check_orientation,
    check_place,
    check_raster,
    check_sum,
    check_values,
    orientation,
    raster,
    sum_of_raster,
    values_in,
)  # fmt: skip
from raybundle.surfaces.grid import HeightGrid
from raybundle.surfaces.heights.cell_factors import factors_of
from raybundle.surfaces.heights.height_model import Blocks, HeightModel, Holes
from raybundle.surfaces.heights.heights import BETWEEN_MAPS, Heights
from raybundle.surfaces.heights.node_sums import NodeSums
from raybundle.surfaces.heights.nodes import of_blocks
from raybundle.surfaces.run import Surface
from raybundle.surfaces.tiles import BLOCK_CELLS, TILE_CELLS, Window, moved_of, tile_of_number, tiles_across
from raybundle.workflows.object_plane import MapLevel, Plane
from raybundle.workflows.rectify import Grid

if TYPE_CHECKING:
    from pyproj import CRS

HEIGHTS, SIGMAS, ABOUT, MOVED = "heights.tif", "heights_sigma.tif", "heights.toml", "heights_orientation.npz"
FILES = (HEIGHTS, SIGMAS, ABOUT, MOVED)
BANDS = (
    WHOLE_SIGMA, "sigma of noise and roughness", STEP_SIGMA, "sigma of orientation", "sigma of a point", "points",
    "image",
)  # fmt: skip
"""Of the second file"""
ONLY_HEIGHT = ("height",)
"""Of the first"""
KEPT = ("", "local", "step", "orientation", "point", "points", "image")
"""Fields of `Heights` that these are; the first follows from three others"""


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightFile:
    """What heights.toml states."""

    left: float
    top: float
    cell: float
    width: int
    height: int
    unit: str
    block: str
    wkt: str
    """plane system of a map; empty: a plane of the object"""
    plane: Mapping[str, Any]
    """where it lies"""
    cautions: tuple[str, ...] = ()
    """what is to be reported of the files beside it, with their names"""

    @classmethod
    def of(cls, grid: HeightGrid, plane: Plane, unit: str, block: str) -> HeightFile:
        """Of a grid."""
        g, wkt = grid.grid, plane.system.to_wkt() if isinstance(plane, MapLevel) else ""
        return cls(
            left=g.left, top=g.top, cell=g.pixel, width=g.width, height=g.height, block=block, wkt=wkt,
            unit=plane.unit if isinstance(plane, MapLevel) else unit, plane=plane.as_mapping(),
        )  # fmt: skip

    @property
    def grid(self) -> Grid:
        """Its cells in the plane."""
        return Grid(left=self.left, top=self.top, pixel=self.cell, width=self.width, height=self.height)

    def new(self, path: Path, names: Sequence[str]) -> AbstractContextManager[Write]:
        """A GeoTIFF of these cells with bands of floats, NaN where nothing was measured.

        That of the heights has the system with what they count from, where anything states it.
        """
        system = self.with_heights if names == ONLY_HEIGHT else None
        if system is not None and not system.is_compound:  # GDAL keeps no third dimension in the file itself
            names, system = ("height above the ellipsoid",), None
        return new_geotiff(
            raster_library(), path, {"count": len(names), "dtype": "float32", "nodata": float("nan")},
            width=self.width, height=self.height, left=self.left, top=self.top, pixel=self.cell,
            wkt=self.wkt if system is None else system.to_wkt(), names=names,
        )  # fmt: skip

    @property
    def system(self) -> str:
        """Text of the system of a map, with what heights count from where it states it; empty: nothing shows it."""
        return str(self.plane.get("system", "")) if self.wkt else ""

    @property
    def with_heights(self) -> CRS | None:
        """The system of a map with what heights count from; None where nothing states it."""
        return system_with_heights(self.system) if self.system else None

    def as_mapping(self) -> dict[str, Any]:
        """What the file holds, beside the numbers of the heights."""
        return {
            "left": self.left, "top": self.top, "pixel": self.cell, "width_px": self.width, "height_px": self.height,
            "block": self.block, "unit": self.unit, **({} if self.unit else {"scale": "free"}), **self.plane,
        }  # fmt: skip


@dataclass(slots=True)
class _Whole:
    """What is known of all tiles when each was written."""

    moved: NodeSums | None = None
    lengths: list[float] = field(default_factory=list[float])
    cells: list[int] = field(default_factory=list[int])
    sigma: list[Array] = field(default_factory=list[Array])
    blocks: Array | None = None
    """(rows, columns) standard deviations by blocks of compression; None: there are none yet"""
    reaches: list[float] = field(default_factory=list[float])

    def add(self, h: Heights, length: float) -> None:
        """A tile."""
        good = np.isfinite(h.height)
        self.lengths.append(length)
        self.cells.append(int(good.sum()))
        self.sigma.append(h.sigma[good][::7])

    @property
    def length(self) -> float:
        """Of correlation, in cells."""
        return float(np.average(self.lengths, weights=np.maximum(self.cells, 1)))

    def add_blocks(self, window: Window, shape: tuple[int, int], sigma: Array, reach: float) -> None:
        """Of a tile."""
        if not sigma.any():
            return
        if self.blocks is None:
            self.blocks = np.zeros(shape, np.float32)
        self.blocks[window.y : window.y + window.height, window.x : window.x + window.width] = sigma
        self.reaches.append(reach)

    @property
    def reach(self) -> float:
        """Of errors by blocks, in cells; the furthest of tiles. 0: there are none."""
        return max(self.reaches, default=0.0)


def write_heights(surface: Surface, file: HeightFile, out: Path) -> tuple[str, ...]:
    """Write the files of the heights of a surface tile by tile; what is to be reported of them."""
    measured, whole = surface.heights, _Whole()
    assert measured is not None
    with new_files(*(out / f for f in FILES)) as (heights, sigmas, about, moved):
        with file.new(heights, ONLY_HEIGHT) as write_height, file.new(sigmas, BANDS) as write_sigmas:
            for tile in range(tiles_across(measured.grid) * -(-file.height // TILE_CELLS)):
                window = tile_of_number(measured.grid, tile)
                one, many = _tile(surface, file, whole, tile, window)
                write_height(window.x, window.y, one)
                write_sigmas(window.x, window.y, many)
        if whole.moved is None:
            raise InputError("surface.no_point_above_area")
        nodes, levels = whole.moved.solved(BLOCK_CELLS * file.cell)
        kept = {
            "nodes": nodes, "levels": levels, "block": np.array(BLOCK_CELLS), "errors": np.array(measured.together),
            "adjustment": np.array(measured.adjustment),
        }  # fmt: skip
        if whole.blocks is not None:
            kept |= {"blocks": whole.blocks, "blocks_reach": np.array(whole.reach)}
        np.savez_compressed(moved, allow_pickle=False, **kept)
        about.write_text(_about(file, (heights, sigmas, moved), whole.length, measured.apart), encoding="utf-8")
    share = sum(whole.cells) / (file.width * file.height)
    sigma = float(np.median(np.concatenate(whole.sigma)))
    factor, of = precision_unit(sigma, file.unit)
    return (
        phrase(
            "product.heights", width=file.width, height=file.height, cell=file.cell, unit=file.unit, share=share,
            sigma=factor * sigma, sigma_unit=of,
        ),
    )  # fmt: skip


def _about(file: HeightFile, beside: tuple[Path, Path, Path], length: float, apart: float) -> str:
    """The text of heights.toml, with check sums of what belongs to it: both rasters, the file of the orientation."""
    heights, sigmas, moved = beside
    library = raster_library()
    own = {
        "length_cells": length, "between_maps": apart, OF_HEIGHTS: sum_of_raster(library, heights),
        OF_SIGMAS: sum_of_raster(library, sigmas), OF_ORIENTATION: check_sum(moved),
    }  # fmt: skip
    return toml_text({**file.as_mapping(), **own})


def _tile(surface: Surface, file: HeightFile, whole: _Whole, tile: int, window: Window) -> tuple[Array, Array]:
    """Heights and the bands of the second file (h, w, bands) of a tile."""
    measured = surface.heights
    assert measured is not None
    if tile not in measured.tiles:
        empty = np.full((window.height, window.width, 1), np.nan, np.float32)
        return empty, np.repeat(empty, len(BANDS), axis=2)
    a = surface.store.wanted(measured.tiles[tile])
    h = Heights.of_arrays(a)
    part = moved_of(surface.store, measured.above, measured.grid, tile, measured.tiles[tile])
    if whole.moved is None:
        whole.moved = NodeSums.of((file.height, file.width), BLOCK_CELLS, part.sums.shape[3])
    first = window.y // BLOCK_CELLS, window.x // BLOCK_CELLS
    whole.moved.add(first, part, np.isfinite(h.height), BLOCK_CELLS)
    whole.add(h, float(a["length"]))
    whole.add_blocks(window, (file.height, file.width), np.asarray(a["blocks"]), float(a["blocks_reach"]))
    bands = [h.sigma, *(getattr(h, name).astype(np.float32) for name in KEPT[1:])]
    return h.height[..., None], np.stack(bands, axis=2)


def write_model(model: HeightModel, file: HeightFile, out: Path) -> None:
    """Write heights that were made of others into a folder, as `write_heights` does; filled holes are kept as such."""
    h = model.heights
    sigma = np.where(model.known, model.sigma, np.nan)
    bands = [sigma, *(np.where(model.known, getattr(h, name), np.nan) for name in KEPT[1:])]
    with new_files(*(out / f for f in FILES)) as (heights, sigmas, about, moved):
        with file.new(heights, ONLY_HEIGHT) as write:
            write(0, 0, h.height[..., None])
        with file.new(sigmas, BANDS) as write:
            write(0, 0, np.stack(bands, axis=2).astype(np.float32))
        kept = {
            "nodes": model.moved, "block": np.array(model.block), "errors": np.array(model.errors),
            "adjustment": np.array(model.adjustment),
        }  # fmt: skip
        if model.levels is not None:
            kept |= {"levels": model.levels}
        if model.blocks is not None:
            kept |= {"blocks": model.blocks.sigma.astype(np.float32), "blocks_reach": np.array(model.blocks.reach)}
        if model.holes is not None:
            kept |= {"holes": model.holes.number.astype(np.int32), "holes_sigma": model.holes.sigma.astype(np.float32)}
        np.savez_compressed(moved, allow_pickle=False, **kept)
        about.write_text(_about(file, (heights, sigmas, moved), model.length, model.apart), encoding="utf-8")


def read_heights(folder: str | Path) -> tuple[HeightModel, HeightFile]:
    """Heights as `write_heights` wrote them.  Raises InputError where a file is missing or does not fit the others."""
    library, folder = raster_library(), Path(folder)
    for name in FILES:
        if not (folder / name).is_file():
            raise InputError("surface_files.no_heights", name=name, file=folder)
    tree = read_toml(folder / ABOUT).tree()
    check_place(tree)
    numbers = {name: tree.get(name).number() for name in ("left", "top", "pixel", "length_cells")}
    height, bands, wkt = _rasters(library, folder, tree)
    found = dict(zip(KEPT[1:], bands[1:], strict=True))
    with orientation(folder / MOVED) as kept:
        # older files have one value for each block, or for each node
        moved = kept["nodes"] if "nodes" in kept else of_blocks(kept["moved"])
        if moved.ndim < 3:
            raise InputError("surface_files.node_dimensions", dimensions=moved.ndim, file=folder / MOVED)
        moved = moved if moved.ndim == 4 else moved[:, :, None]
        levels = kept.get("levels")
        block = int(kept["block"])
        holes = Holes(number=kept["holes"], sigma=kept["holes_sigma"]) if "holes" in kept else None
        blocks = None
        if "blocks" in kept:
            blocks = Blocks(sigma=kept["blocks"], reach=float(kept["blocks_reach"]))
        errors, adjustment = (str(kept[name]) if name in kept else "" for name in ("errors", "adjustment"))
    check_orientation(
        folder / MOVED,
        moved,
        block,
        height.shape,
        (([] if holes is None else [holes.number, holes.sigma]) + ([] if blocks is None else [blocks.sigma])),
    )
    check_belongs(folder / MOVED, tree)
    named: dict[str, Array] = dict(zip(BANDS, bands, strict=True))
    cautions = check_values(folder / HEIGHTS, height, folder / SIGMAS, named, tree)
    heights = Heights(
        height=height, local=found["local"], step=np.nan_to_num(found["step"]), orientation=found["orientation"],
        point=found["point"],
        points=np.nan_to_num(found["points"]).astype(np.uint16),
        image=np.nan_to_num(found["image"], nan=-1).astype(np.int32),
    )  # fmt: skip
    cell, length = numbers["pixel"], numbers["length_cells"]
    factors = None if levels is None else factors_of(height, found["local"], levels, block, cell)
    model = HeightModel(
        heights=heights, moved=moved, factors=factors, levels=levels, block=block, cell=cell, length=length,
        apart=tree.optional("between_maps", BETWEEN_MAPS), holes=holes, errors=errors, adjustment=adjustment,
        blocks=blocks,
    )  # fmt: skip
    stated = {k: v.value for k, v in tree.mapping().items()}
    plane = {k: v for k, v in stated.items() if k not in {"left", "top", "pixel", "width_px", "height_px", "block"}}
    return model, HeightFile(
        left=numbers["left"], top=numbers["top"], cell=numbers["pixel"], width=height.shape[1],
        height=height.shape[0], unit=str(stated.get("unit", "")), block=str(stated.get("block", "")), wkt=wkt,
        plane=plane, cautions=cautions,
    )  # fmt: skip


def _rasters(library: Any, folder: Path, tree: Json) -> tuple[Array, Array, str]:
    """Heights (rows, columns), the bands of the second file (bands, rows, columns), and its system, that in plan."""
    with raster(library, folder / HEIGHTS) as one, raster(library, folder / SIGMAS) as many:
        check_raster(one, folder / HEIGHTS, tree)
        check_raster(many, folder / SIGMAS, tree)
        if many.count != len(BANDS):
            raise InputError(
                "surface_files.bands_differ",
                sigmas=SIGMAS,
                heights=HEIGHTS,
                n=many.count,
                needed=len(BANDS),
                file=folder,
            )
        return values_in(one)[0], values_in(many), many.crs.to_wkt() if many.crs else ""
