"""A satellite scene of hills and roads: a picture with its RPC, control in a map, a raster of heights."""

from __future__ import annotations

import warnings
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.io.formats.gpkg import points_wkb
from raybundle.io.geo.coordinate_systems import local_frame, parse_crs
from raybundle.io.pictures.geotiff import new_geotiff
from raybundle.io.pictures.resampling import between
from raybundle.io.raster_library import raster_library
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress
from raybundle.planning.rendered.rendering import looked_up, noise_of_size
from raybundle.scenes.rpc import Rpc
from raybundle.scenes.rpc_fit import fit_rpc
from raybundle.scenes.simulate import OrbitPlan, orbit_scene

ABOUT = "a satellite scene with its RPC, control and check points in UTM, and a raster of heights"
SEED = 17
CRS = "EPSG:32633"
PLACE = (15.21, 48.37, 380.0)
"""Longitude, latitude, height above the ellipsoid of the middle; the place is made up"""
SIZE = (1280, 1120)
GSD_M = 0.6
WRONG = np.array([9.4, -6.7])
"""By which the RPC that the vendor states is off [px]"""
STATED_M = 5.0
"""ERR_BIAS as the vendor states it"""
HALF_M, CELL_M = 700.0, 5.0
"""Half the side of the raster of heights, and its cells"""
ROAD_M, WIDE_M = 127.5, 7.0
SURVEYED = (0.10, 0.10, 0.15)
MARKED_PX = 0.3
STEP = 16
ROUNDS = 10
CONTROL, CHECK = 8, 6
EDGE_PX = 40
"""Points nearer to the edge are not marked"""


def make(folder: Path, progress: Progress) -> tuple[str, ...]:
    """As `demonstrations` states."""
    library = raster_library()
    rng = np.random.default_rng(SEED)
    to_map = _to_map()
    middle = np.round(to_map(np.array([PLACE]))[0])
    progress("heights", 0.0)
    heights = _relief(rng)
    true = _true_rpc()
    progress("picture", 0.2)
    east, north, _ = _seen_ground(true, heights, middle, to_map)
    grey = _grey_values(rng, east - middle[0], north - middle[1])
    _write_picture(library, folder / "scene.tif", grey, replace(true.shifted(-WRONG), err_bias_m=STATED_M))
    progress("control", 0.8)
    own = local_frame(CRS, (*middle.tolist(), PLACE[2]))
    plan = _crossings()
    xyz = np.column_stack([plan + middle, _height_at(heights, plan[:, 0], plan[:, 1])])
    seen = true.project(own.wgs84_from_local(own.local_from_crs(xyz)))
    inside = np.flatnonzero(((seen > EDGE_PX) & (seen < np.array(SIZE) - EDGE_PX)).all(axis=1))
    chosen = rng.permutation(inside)[: CONTROL + CHECK]
    xyz, measured = xyz[chosen], seen[chosen] + rng.normal(0, MARKED_PX, (len(chosen), 2))
    _write_control(folder / "control.gpkg", xyz + rng.normal(0, SURVEYED, xyz.shape), measured)
    wkt = parse_crs(CRS).to_wkt()
    size = len(heights)
    with new_geotiff(
        library, folder / "heights.tif", {"count": 1, "dtype": "float32"}, width=size, height=size,
        left=float(middle[0]) - HALF_M, top=float(middle[1]) + HALF_M, pixel=CELL_M, wkt=wkt,
    ) as write:  # fmt: skip
        write(0, 0, heights[::-1, :, None])
    progress("control", 1.0)
    return (
        f"scene.tif: {SIZE[0]} x {SIZE[1]} px of {GSD_M:g} m, 11 bits, with the RPC of its vendor",
        f"control.gpkg: {CONTROL} control and {CHECK} check points in {CRS}, marked in the picture",
        f"heights.tif: the ground in {CRS}, cells of {CELL_M:g} m, heights above the ellipsoid",
    )


def _to_map() -> Any:
    from pyproj import Transformer

    transformer = Transformer.from_crs("EPSG:4326", CRS, always_xy=True)
    return lambda geographic: np.column_stack(transformer.transform(geographic[:, 0], geographic[:, 1]))


def _relief(rng: np.random.Generator) -> Array:
    """Heights (n, n) above the ellipsoid, the first row in the south."""
    n = int(2 * HALF_M / CELL_M)
    hills = 34 * noise_of_size(rng, (n, n), 60) + 9 * noise_of_size(rng, (n, n), 22)
    return (PLACE[2] + hills).astype(np.float32)


def _height_at(heights: Array, x: Array, y: Array) -> Array:
    """Of places from the middle [m], bilinear."""
    return looked_up(heights, (y + HALF_M) / CELL_M - 0.5, (x + HALF_M) / CELL_M - 0.5)


def _true_rpc() -> Rpc:
    """What the scene really looks like."""
    plan = OrbitPlan(
        target=PLACE, roll_deg=1.6, pitch_deg=0.7, heading_deg=193.0, gsd_m=GSD_M, width_px=SIZE[0], height_px=SIZE[1]
    )
    scene = orbit_scene(plan)
    return fit_rpc(scene.localise, SIZE, (PLACE[2] - 300, PLACE[2] + 300)).rpc


def _seen_ground(rpc: Rpc, heights: Array, middle: Array, to_map: Any) -> tuple[Array, Array, Array]:
    """Easting, northing and height (h, w) of what each pixel sees."""
    columns, rows = (np.arange(0, n + STEP, STEP) + 0.5 for n in SIZE)
    x, y = np.meshgrid(columns, rows)
    nodes = np.stack([x.ravel(), y.ravel()], axis=1)
    low, high = PLACE[2] - 150, PLACE[2] + 150
    places = [
        between(to_map(rpc.localise(nodes, h)).reshape(*x.shape, 2), STEP)[: SIZE[1], : SIZE[0]] for h in (low, high)
    ]
    t = np.full(SIZE[::-1], 0.5)
    found = places[0]
    for _ in range(ROUNDS):
        found = places[0] + t[..., None] * (places[1] - places[0])
        h = _height_at(heights, found[..., 0] - middle[0], found[..., 1] - middle[1])
        t = (h - low) / (high - low)
    return found[..., 0], found[..., 1], low + t * (high - low)


def _crossings() -> Array:
    """Places (n, 2) [m] from the middle where roads cross."""
    steps = np.arange(-3, 4) * ROAD_M
    return _bent(np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2))


def _bent(uv: Array) -> Array:
    """Places of the grid of roads, which is not quite straight."""
    u, v = uv[..., 0], uv[..., 1]
    return np.stack([u + 12 * np.sin(v / 130), v + 9 * np.cos(u / 110)], axis=-1)


def _straight(x: Array, y: Array) -> Array:
    """The inverse of `_bent` (..., 2)."""
    uv = np.stack([x, y], axis=-1)
    for _ in range(12):
        uv = uv + np.stack([x, y], axis=-1) - _bent(uv)
    return uv


def _grey_values(rng: np.random.Generator, x: Array, y: Array) -> Array:
    """Of fields and roads, uint16 of 11 bits, at places (h, w) [m] from the middle."""
    n = int(2 * HALF_M)
    fields = 170 * noise_of_size(rng, (n, n), 70) + 70 * noise_of_size(rng, (n, n), 11)
    fields += 35 * noise_of_size(rng, (n, n), 3)
    grey = 620 + looked_up(fields, y + HALF_M, x + HALF_M)
    uv = _straight(x, y)
    off = np.abs((uv / ROAD_M + 0.5) % 1 - 0.5) * ROAD_M
    road = np.clip((WIDE_M / 2 - off.min(axis=-1)) / GSD_M + 0.5, 0, 1)
    grey += road * (1250 - grey)
    return np.clip(np.rint(grey + rng.normal(0, 6, grey.shape)), 1, 2047).astype(np.uint16)


def _write_picture(library: Any, path: Path, grey: Array, rpc: Rpc) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", library.errors.NotGeoreferencedWarning)
        with library.open(
            path, "w", driver="GTiff", width=SIZE[0], height=SIZE[1], count=1, dtype="uint16", tiled=True,
            compress="deflate", predictor=2,
        ) as raster:  # fmt: skip
            raster.write(grey, 1)
            raster.rpcs = rpc.to_rasterio()


def _write_control(path: Path, xyz: Array, xy_px: Array) -> None:
    """Points in the map with their places in the picture, as a GIS keeps them."""
    pyogrio: Any = import_module("pyogrio")  # an extra
    import_module("pyogrio.raw")
    names = np.array([*(f"G{k + 1}" for k in range(CONTROL)), *(f"C{k + 1}" for k in range(CHECK))], object)
    roles = np.array([*["control"] * CONTROL, *["check"] * CHECK], object)
    shapes = np.empty(len(xyz), object)
    shapes[:] = points_wkb(np.round(xyz, 3))
    sigmas = [np.full(len(xyz), s) for s in SURVEYED]
    pyogrio.raw.write(
        str(path), shapes, [names, roles, np.round(xy_px[:, 0], 2), np.round(xy_px[:, 1], 2), *sigmas],
        ["point", "role", "x_px", "y_px", "sX", "sY", "sZ"], geometry_type="Point Z", crs=CRS, driver="GPKG",
        layer="control",
    )  # fmt: skip
