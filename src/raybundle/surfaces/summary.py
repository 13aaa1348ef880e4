"""What is reported of a surface: from what a run has kept, one map after the other."""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.numerics.thinning import one_of_each_cell
from raybundle.objects.cloud import CloudSample
from raybundle.pipeline.store import Folder
from raybundle.surfaces.depths.depth_map import DepthMap
from raybundle.surfaces.depths.filters import GRAZING
from raybundle.surfaces.depths.summary import (
    QUANTILES,
    HeightSummary,
    MapSummary,
    OrthophotoSummary,
    SurfaceSummary,
    reduced,
)
from raybundle.surfaces.files.heights import HeightFile
from raybundle.surfaces.orthophoto_files import tiles_of
from raybundle.surfaces.run import Surface
from raybundle.surfaces.tiles import TILE_CELLS, tile_of_number

SAMPLE = 7
"""One in so many points shows the quantiles."""
LAGS_PX = np.arange(0.0, 25.0)
SHOWN, LOOKED_AT = 250_000, 12
"""Points of a page (16 bytes each), and how many times as many are looked at for them"""
PICTURE_CELLS = 900
"""Longer side of the pictures of heights."""


def summary_of(surface: Surface, unit: str, file: HeightFile | None = None, written: int = 0) -> SurfaceSummary:
    """All that a page of a surface shows.

    file     what the heights lie on; None: there are none
    written  points in the files, where they were thinned
    """
    parts, axes, rays, grazed = list[Array](), list[Array](), np.zeros(256, int), 0
    for cloud in surface.parts():
        parts.append(np.asarray(cloud.parts[::SAMPLE], float))
        axes.append(np.asarray(cloud.sigma[::SAMPLE], float))
        rays += np.bincount(cloud.views, minlength=256)
        grazed += int((cloud.incidence < GRAZING).sum())
    squares, of_axes = (np.concatenate(x) ** 2 if x else np.zeros((0, 3)) for x in (parts, axes))
    maps, correlation = list[MapSummary](), list[Array]()
    for (image, _), given in zip(surface.clouds, surface.counts, strict=True):
        summary, found = _of_map(surface, image, given)
        maps.append(summary)
        correlation.append(found)
    return SurfaceSummary(
        points=len(surface), written=written, of_part=surface.options.region is not None, unit=unit,
        sigma=_quantiles(np.sqrt(squares.sum(axis=1))),
        position=_quantiles(np.sqrt(of_axes.sum(axis=1))),
        axes=np.array([_quantiles(np.sqrt(of_axes[:, k])) for k in range(3)]),
        parts=np.array([_quantiles(np.sqrt(squares[:, k])) for k in range(3)]), shares=_shares(squares),
        rays=rays[: _last(rays)],
        incidence=grazed / max(len(surface), 1), maps=tuple(maps), left_out=surface.left_out,
        correlation=np.stack([LAGS_PX, np.mean(correlation, axis=0)], axis=1) if maps else np.zeros((0, 2)),
        heights=None if file is None else _heights(surface, file),
        orthophoto=None if surface.orthophoto is None else _orthophoto(surface),
    )  # fmt: skip


def _shares(squares: Array) -> tuple[float, float, float]:
    if not len(squares):
        return 0.0, 0.0, 0.0
    noise, roughness, orientation = np.mean(squares / squares.sum(axis=1)[:, None], axis=0).tolist()
    return noise, roughness, orientation


def _last(counts: Array) -> int:
    there = np.flatnonzero(counts)
    return int(there[-1]) + 1 if len(there) else 0


def _quantiles(values: Array) -> tuple[float, ...]:
    if not len(values):
        return tuple(float("nan") for _ in QUANTILES)
    return tuple(np.quantile(values, QUANTILES).tolist())


def _of_map(surface: Surface, image: int, given: int) -> tuple[MapSummary, Array]:
    """What is reported of a map, and how its errors are correlated by distance."""
    store: Folder = surface.store
    place = store.wanted(dict(surface.clouds)[image], ("place",))["place"]
    found = DepthMap.of_arrays(store.wanted(surface.maps[image])).sure(place)
    sigma = store.wanted(surface.sigmas[image], ("sigma",))["sigma"]
    with np.errstate(divide="ignore", invalid="ignore"):
        length = sigma / np.square(found.t, dtype=float)
    known = np.isfinite(length)
    summary = MapSummary(
        name=surface.block.images.ids[image], sources=len(found.sources), pixels=known.size,
        measured=int(known.sum()), given=given,
        sigma=float(np.median(length[known])) if known.any() else float("nan"), picture=reduced(length)[0],
    )  # fmt: skip
    return summary, found.correlation_between(LAGS_PX)


def _heights(surface: Surface, file: HeightFile) -> HeightSummary | None:
    """Some of the heights, tile by tile."""
    measured = surface.heights
    if measured is None:
        return None
    grid = measured.grid
    k = max(1, int(np.ceil(max(file.width, file.height) / PICTURE_CELLS)))
    shape = tuple(-(-n // k) for n in (file.height, file.width))
    pictures = np.full((2, *shape), np.nan)
    profile = np.full((2, file.width), np.nan)
    middle, known = file.height // 2, 0
    for tile, key in measured.tiles.items():
        w = tile_of_number(grid, tile)
        x, y, width, height = w.x, w.y, w.width, w.height
        a = surface.store.wanted(key, ("height", "local", "step", "orientation"))
        both = np.stack([a["height"], np.hypot(np.hypot(a["local"], a["step"]), a["orientation"])]).astype(float)
        known += int(np.isfinite(both[0]).sum())
        rows, columns = (np.arange(-start % k, n, k) for start, n in ((y, height), (x, width)))
        if len(rows) and len(columns):
            at = np.ix_((y + rows) // k, (x + columns) // k)
            for picture, values in zip(pictures, both, strict=True):
                picture[at] = values[np.ix_(rows, columns)]
        if y <= middle < y + TILE_CELLS:
            profile[:, x : x + width] = both[:, middle - y]
    across = file.left + (np.arange(file.width) + 0.5) * file.cell
    return HeightSummary(
        height=pictures[0], sigma=pictures[1], cell=k * file.cell, left=file.left, top=file.top,
        share=known / (file.width * file.height), profile=np.stack([across, *profile], axis=1),
        in_map=bool(file.wkt),
    )  # fmt: skip


def sample_of(surface: Surface) -> CloudSample:
    """Points spread over a surface, as many as a page shows: one of each cell of the finest grid that gives so many.

    Of a cloud that is many times larger only every so many points are looked at.
    """
    step = max(1, len(surface) // (LOOKED_AT * SHOWN))
    parts = [
        (c.xyz[::step], c.colour[::step], np.linalg.norm(c.parts[::step].astype(float), axis=1), c.image[::step])
        for c in surface.parts()
    ]
    xyz, colour, sigma, image = (np.concatenate(x) for x in zip(*parts, strict=True))
    rows, cell = np.arange(len(xyz)), 0.0
    if len(xyz) > SHOWN:
        first, cell = one_of_each_cell(xyz, SHOWN)
        rows = np.sort(first)
    refs = [i for i, _ in surface.clouds]
    return CloudSample(
        xyz=xyz[rows], colour=colour[rows], sigma=sigma[rows], image=np.searchsorted(np.array(refs), image[rows]),
        names=tuple(surface.block.images.ids[i] for i in refs), cell=cell,
    )  # fmt: skip


def _orthophoto(surface: Surface) -> OrthophotoSummary:
    """Some of its pixels, tile by tile."""
    made = surface.orthophoto
    assert made is not None
    g = made.grid
    k = max(1, int(np.ceil(max(g.width, g.height) / PICTURE_CELLS)))
    picture = np.zeros((-(-g.height // k), -(-g.width // k), 4), np.uint8)
    seen, sigma = 0, list[Array]()
    for t in tiles_of(surface):
        w = t.window
        known = t.colours[..., 3] > 0
        seen += int(known.sum())
        sigma.append(np.hypot(t.sigma[..., 0], t.sigma[..., 1])[known][::13])
        rows, columns = (np.arange(-start % k, n, k) for start, n in ((w.y, w.height), (w.x, w.width)))
        if len(rows) and len(columns):
            picture[np.ix_((w.y + rows) // k, (w.x + columns) // k)] = t.colours[np.ix_(rows, columns)]
    return OrthophotoSummary(
        picture=picture, pixel=k * g.pixel, left=g.left, top=g.top, share=seen / (g.width * g.height),
        sigma=float(np.median(np.concatenate(sigma))) if seen else float("nan"),
    )  # fmt: skip
