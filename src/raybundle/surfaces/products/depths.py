"""Product: the depth map of each photograph with its standard deviations, in the photograph's own pixels."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.io.folders import new_folder
from raybundle.io.pictures.geotiff import TILE_PX, new_geotiff
from raybundle.io.pictures.rectified import toml_text
from raybundle.io.raster_library import raster_library
from raybundle.numerics.arrays import Array
from raybundle.numerics.counting import counted
from raybundle.surfaces.depths.depth_map import DepthMap
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.product import Context, Product, Written, register
from raybundle.surfaces.run import Surface

FOLDER, ABOUT = "depths", "depths.toml"
BANDS = ("depth", "standard deviation of the depth", "flags")
FLAGS = "1 grazed, 2 beside a step, 4 one source; 8 neighbours disagree, 16 beside a hole: no depth"
PLACE = (
    "outer corner of a pixel in the photograph as stored: x = left + column * step, y = top + row * step, from the "
    "outer corner of its first pixel; the TIFF has the same with y upwards, from -top on"
)


def _write(surface: Surface, out: Path, context: Context) -> Written:
    about: dict[str, Any] = {
        "bands": list(BANDS), "unit": context.unit, **({} if context.unit else {"scale": "free"}),
        "flags": FLAGS,
        "place": PLACE,
    }  # fmt: skip
    names = _names([surface.block.images.ids[k] for k in sorted(surface.maps)])
    measured = 0
    with new_folder(out / FOLDER, replacing=True) as folder:
        for (image, key), name in zip(sorted(surface.maps.items()), names, strict=True):
            given = surface.store.wanted(dict(surface.clouds)[image], ("place",))["place"]
            found = DepthMap.of_arrays(surface.store.wanted(key)).sure(given)
            sigma = surface.store.wanted(surface.sigmas[image], ("sigma",))["sigma"]
            rays = ReferenceRays.of(surface.block, image)
            measured += _write_one(folder / name, rays, found, np.asarray(sigma))
            about[json.dumps(name)] = _about(surface, image, rays, found)
        (folder / ABOUT).write_text(toml_text(about), encoding="utf-8")
    reported = f"{counted(len(names), 'depth map')}, {counted(measured, 'depth')}"
    return Written(files=(out / FOLDER,), reported=(reported,))


def _write_one(path: Path, rays: ReferenceRays, found: DepthMap, sigma: Array) -> int:
    """Write a map; how many depths it has."""
    g = found.grid
    t = np.asarray(found.t, float)
    bands = np.stack([rays.depths(t), rays.lengths(t, sigma), np.asarray(found.flags, float)], axis=2)
    bands = bands.astype(np.float32)
    left, top = g.x0 + 0.5 - g.stride / 2, g.y0 + 0.5 - g.stride / 2
    with new_geotiff(
        raster_library(), path, {"count": len(BANDS), "dtype": "float32", "nodata": float("nan")},
        width=g.columns, height=g.rows, left=left, top=-top, pixel=g.stride, wkt="", names=BANDS,
    ) as write:  # fmt: skip
        for row in range(0, g.rows, TILE_PX):
            write(0, row, bands[row : row + TILE_PX])
    return int(np.isfinite(t).sum())


def _about(surface: Surface, image: int, rays: ReferenceRays, found: DepthMap) -> dict[str, Any]:
    ids, g = surface.block.images.ids, found.grid
    return {
        "image": ids[image], "file": surface.block.images.file[image],
        "depth": rays.reported, "left": g.x0 + 0.5 - g.stride / 2,
        "top": g.y0 + 0.5 - g.stride / 2, "step": g.stride, "sources": [ids[s] for s in found.sources],
    }  # fmt: skip


def _names(ids: list[str]) -> list[str]:
    """Of the files, one for each image: what file systems do not take becomes a line."""
    stems, found = [re.sub(r"[^\w.-]+", "_", i).strip(".") or "image" for i in ids], list[str]()
    for stem in stems:
        name, k = f"{stem}.tif", 1
        while name.lower() in {n.lower() for n in found}:
            k += 1
            name = f"{stem}_{k}.tif"
        found.append(name)
    return found


def _check() -> None:
    raster_library()


PRODUCT = register(Product(name="depths", files=(FOLDER,), write=_write, check=_check))
