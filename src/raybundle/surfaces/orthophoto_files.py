"""A true orthophoto as files: colours, of which photograph each pixel is and how far it may be off, what is what."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import phrase
from raybundle.io.folders import new_files
from raybundle.io.pictures.geotiff import new_geotiff
from raybundle.io.pictures.rectified import toml_text
from raybundle.io.raster_library import raster_library
from raybundle.numerics.arrays import Array
from raybundle.numerics.length_units import precision_unit
from raybundle.results.record import STATE
from raybundle.surfaces.files.heights import HeightFile
from raybundle.surfaces.orthophoto_pixels import TILE_PX, pixel_tiles, tile_of_pixels
from raybundle.surfaces.run import Surface
from raybundle.surfaces.tiles import Window
from raybundle.workflows.object_plane import MapLevel, Plane

PICTURE, SIGMAS, ABOUT = "orthophoto.tif", "orthophoto_sigma.tif", "orthophoto.toml"
FILES = (PICTURE, SIGMAS, ABOUT)
BANDS = ("standard deviation to the right", "standard deviation upwards", "photograph")
MAP_BANDS = ("standard deviation of east", "standard deviation of north", "photograph")
"""Of the second file"""
MOST_SEEN = 0.95
"""Share of the pixels from which on nobody asks why not more are seen"""
BAND = {"count": 4, "dtype": "uint8", "photometric": "RGB", "alpha": "YES", "interleave": "pixel"}


@dataclass(frozen=True, slots=True, kw_only=True)
class TileOfOrthophoto:
    """Some of its pixels."""

    window: Window
    colours: Array
    """(h, w, 4) uint8 red, green, blue, and 255 where there are any"""
    sigma: Array
    """(h, w, 2) float32 standard deviations of the place to the right and upwards; NaN: nothing is seen"""
    image: Array
    """(h, w) int32 the photograph, a row of the block's images; -1: none"""


def tiles_of(surface: Surface) -> Iterator[TileOfOrthophoto]:
    """The orthophoto of a surface tile by tile, those without any pixel included."""
    made = surface.orthophoto
    assert made is not None
    down = -(-made.grid.height // TILE_PX)
    for tile in range(pixel_tiles(made.grid) * down):
        yield _tile(surface, tile)


def _tile(surface: Surface, tile: int) -> TileOfOrthophoto:
    made = surface.orthophoto
    assert made is not None
    window = tile_of_pixels(made.grid, tile)
    count = window.width * window.height
    total, weight = np.zeros((count, 3)), np.zeros(count)
    sigma, image = np.full((count, 2), np.nan, np.float32), np.full(count, -1, np.int32)
    for k in made.tiles.get(tile, ()):
        a = surface.store.lent(made.parts[k])
        row = int(np.searchsorted(a["tiles"], tile))
        mine = slice(*a["begin"][row : row + 2].tolist())
        at, w = np.asarray(a["at"][mine], int), np.asarray(a["weight"][mine], float)
        total[at] += w[:, None] * a["colour"][mine]
        weight[at] += w
        own = np.isfinite(a["sigma"][mine, 0])
        sigma[at[own]], image[at[own]] = a["sigma"][mine][own], k
    # what only lies within the rim of a seam belongs to nobody: the photograph of its cell does not see it
    seen = (weight > 0) & (image >= 0)
    colours = np.zeros((count, 4), np.uint8)
    colours[seen, :3] = np.rint(total[seen] / weight[seen, None])
    colours[seen, 3] = 255
    shape = window.height, window.width
    return TileOfOrthophoto(
        window=window, colours=colours.reshape(*shape, 4), sigma=sigma.reshape(*shape, 2), image=image.reshape(shape)
    )


def write_orthophoto(surface: Surface, plane: Plane, unit: str, out: Path, state: str = "") -> tuple[str, ...]:
    """Write the files tile by tile; what is to be reported of them.

    state  why the result is not to be used yet, which orthophoto.toml shows
    """
    made = surface.orthophoto
    assert made is not None
    g, library = made.grid, raster_library()
    in_map = isinstance(plane, MapLevel)
    wkt = plane.system.to_wkt() if isinstance(plane, MapLevel) else ""
    place: dict[str, Any] = {
        "width": g.width,
        "height": g.height,
        "left": g.left,
        "top": g.top,
        "pixel": g.pixel,
        "wkt": wkt,
    }
    floats = {"count": len(BANDS), "dtype": "float32", "nodata": float("nan")}
    pixels, some = dict[int, int](), list[Array]()
    with new_files(*(out / f for f in FILES)) as (picture, sigmas, about):
        with (
            new_geotiff(library, picture, BAND, **place) as write,
            new_geotiff(library, sigmas, floats, names=MAP_BANDS if in_map else BANDS, **place) as write_sigma,
        ):
            for t in tiles_of(surface):
                write(t.window.x, t.window.y, t.colours)
                number = np.where(t.image >= 0, t.image, np.nan).astype(np.float32)
                write_sigma(t.window.x, t.window.y, np.dstack([t.sigma, number]))
                for k, n in zip(*np.unique(t.image[t.image >= 0], return_counts=True), strict=True):
                    pixels[int(k)] = pixels.get(int(k), 0) + int(n)
                some.append(t.sigma[np.isfinite(t.sigma[..., 0])][::13])
        about.write_text(
            toml_text({**_about(surface, plane, unit, pixels), **({STATE: state} if state else {})}), encoding="utf-8"
        )
    return _lines(surface, pixels, some, f" {plane.unit if isinstance(plane, MapLevel) else unit}".rstrip())


def _lines(surface: Surface, pixels: dict[int, int], sigma: list[Array], of: str) -> tuple[str, ...]:
    """What is to be stated: how much of it is seen and why not more, how far pixels are off, and how many by far."""
    made, heights = surface.orthophoto, surface.heights
    assert made is not None
    assert heights is not None
    g, h = made.grid, heights.grid.grid
    tiles = (surface.store.wanted(key, ("height",))["height"] for key in heights.tiles.values())
    known = sum(int(np.isfinite(t).sum()) for t in tiles) / (h.width * h.height)
    share = sum(pixels.values()) / (g.width * g.height)
    size = {"width": g.width, "height": g.height, "pixel": g.pixel, "unit": of.strip()}
    if not pixels:
        return (phrase("product.orthophoto_unseen", **size),)
    off = np.hypot(*np.concatenate(sigma).T)
    factor, unit = precision_unit(float(np.median(off)), of.strip())
    half, most = (factor * float(np.quantile(off, q)) for q in (0.5, 0.95))
    beyond = float((off > g.pixel).mean())
    lines = [
        phrase("product.orthophoto", **size, share=share, photographs=len(pixels)),
        phrase("product.orthophoto_sigma", median=half, most=most, unit=unit, beyond=beyond),
    ]
    if share < MOST_SEEN:
        lines.append(phrase("product.orthophoto_gaps", share=known, coarse=surface.options.density > 1))
    if any(c.is_scene for c in surface.block.cameras):
        lines.append(phrase("product.orthophoto_scenes"))
    return tuple(lines)


def _about(surface: Surface, plane: Plane, unit: str, pixels: dict[int, int]) -> dict[str, object]:
    """What orthophoto.toml states."""
    made = surface.orthophoto
    assert made is not None
    assert surface.heights is not None
    file = HeightFile.of(surface.heights.grid, plane, unit, surface.block.name).as_mapping()
    g, ids, whole = made.grid, surface.block.images.ids, sum(pixels.values())
    place = {"left": g.left, "top": g.top, "pixel": g.pixel, "width_px": g.width, "height_px": g.height}
    images = sorted(pixels)
    return {
        **file, **place, "heights_pixel": surface.heights.grid.grid.pixel,
        "photographs": {str(k): ids[k] for k in images},
        "shares": {ids[k]: pixels[k] / whole for k in images},
        "gains": {ids[k]: list(made.gains[k]) for k in images},
    }  # fmt: skip
