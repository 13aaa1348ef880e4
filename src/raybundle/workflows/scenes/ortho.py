"""A scene brought to the map over a raster of heights: orthorectification, tile by tile.

Of each pixel of the map the height is taken from the raster, and where the scene sees that place from its RPC.  The
RPC and the geoid are computed at every sixteenth pixel, at three heights between the lowest and the highest of the
tile, and interpolated: linearly in plan, by the parabola in height.

What it does not do: find out what hides what.  Behind a steep slope that a place lies behind, or a building that the
raster has, the picture of what hides it appears a second time.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.geo.coordinate_systems import LocalFrame, local_frame
from raybundle.io.geo.ground import Ground
from raybundle.io.geo.parsed_names import parsed_system
from raybundle.io.geo.parsed_systems import system_name, utm_at
from raybundle.io.pictures.resampling import REACH, Kernel, between, sampled
from raybundle.io.scenes.pictures import Picture
from raybundle.numerics.arrays import Array, Mask
from raybundle.scenes.rpc import Rpc
from raybundle.workflows.rectify import STEP, Grid, grid_over, two_digits, whole_pixels

TILE_PX = 512
"""Side of what is worked on at once: a multiple of the step and of a tile of the file."""
MOST_PX = 1e10
"""Pixels of a map."""
BORDER = 65
"""Places along each side of the scene by which its outline on the ground is found."""
ROUNDS, CLOSE_M = 30, 0.5
"""The ground under a ray is found in so many rounds at most, to so many metres."""
OVERLAP = 2.0
"""How far from the middle of the RPC, in units of half its range, a place may be that the scene could show."""
SETTLING = 0.7
"""From round to round heights change by this factor less, or half of the change is taken."""
DEGREE_M = 111_320.0
"""Of a degree of latitude, for a size of pixels."""


@dataclass(frozen=True, kw_only=True)
class Ortho:
    """A map that is to be made of a scene."""

    rpc: Rpc
    size_px: tuple[int, int]
    ground: Ground
    frame: LocalFrame
    """plane system of the map"""
    grid: Grid
    kernel: Kernel = "cubic"
    reduced: int = 1
    """squares of so many pixels of the scene are averaged first, where those of the map are larger"""
    remarks: tuple[str, ...] = ()
    """what was assumed, and what is odd"""

    @property
    def crs(self) -> str:
        """The system of the map."""
        return self.frame.crs

    @cached_property
    def _same_plan(self) -> bool:
        """Whether map and raster of heights are in one plane system."""
        return parsed_system(self.ground.plan).equals(parsed_system(self.crs), ignore_axis_order=True)

    def tiles(self) -> Iterator[tuple[int, int, int, int]]:
        """Column, row, width, height of each part of the map."""
        for row in range(0, self.grid.height, TILE_PX):
            for column in range(0, self.grid.width, TILE_PX):
                yield column, row, min(TILE_PX, self.grid.width - column), min(TILE_PX, self.grid.height - row)

    def places(self, column: int, row: int, width: int, height: int) -> Array:
        """Where the scene sees the pixels (height, width, 2) of a part of the map [px]; NaN where nowhere."""
        nodes, shape = self.grid.part(column, row, width, height).coarse()
        geographic, cells, separation = self._at_nodes(nodes)

        def spread(values: Array) -> Array:
            return between(values.reshape(*shape, -1), STEP)[:height, :width]

        heights = self.ground.at(spread(cells)) + spread(separation)[..., 0]
        places = np.full((height, width, 2), np.nan)
        if not np.isfinite(heights).any():
            return places
        low, high = float(np.nanmin(heights)), float(np.nanmax(heights))
        half = max((high - low) / 2, 1.0)
        middle = (low + high) / 2
        layers = [self._seen(geographic, middle + t * half) for t in (-1, 0, 1)]
        if not any(np.isfinite(v).any() for v in layers):
            return places
        # the parabola through three heights, by powers of t from -1 to 1
        a, b, c = layers[1], (layers[2] - layers[0]) / 2, (layers[2] + layers[0]) / 2 - layers[1]
        t = ((heights - middle) / half)[..., None]
        fields = spread(np.concatenate([a, b, c], axis=1))
        return fields[..., :2] + t * (fields[..., 2:4] + t * fields[..., 4:])

    def _at_nodes(self, nodes: Array) -> tuple[Array, Array, Array]:
        """Longitude and latitude (n, 3), cells of the raster (n, 2), and what its heights lack (n,), of x, y (n, 2)."""
        xyz = np.column_stack([nodes, np.full(len(nodes), self.frame.origin[2])])
        geographic = self.frame.wgs84_from_local(self.frame.local_from_crs(xyz))
        cells = self.ground.cells(nodes) if self._same_plan else self.ground.places(geographic)
        return geographic, cells, self.ground.separation(cells)

    def _seen(self, geographic: Array, height: float) -> Array:
        """Image points (n, 2) of longitudes and latitudes (n, 3) at a height; NaN far from the scene."""
        at = geographic.copy()
        at[:, 2] = height
        near = self.rpc.ranges_away(at) < OVERLAP
        found = np.full((len(at), 2), np.nan)
        if near.any():
            found[near] = self.rpc.project(at[near])
        return found

    def tile(self, picture: Picture, part: tuple[int, int, int, int]) -> tuple[Array, Mask]:
        """Values (h, w, bands) of a part of the map, and where there are any (h, w)."""
        column, row, width, height = part
        places = self.places(column, row, width, height)
        nothing = np.zeros((height, width, picture.bands), picture.dtype), np.zeros((height, width), bool)
        size, r = np.array(self.size_px), self.reduced
        x, y = places[..., 0], places[..., 1]
        seen = (x >= 0) & (x <= size[0]) & (y >= 0) & (y <= size[1])
        if not seen.any():
            return nothing
        room = r * (REACH[self.kernel] + 1)
        last = np.maximum(size // r * r, 1) if r > 1 else size
        low = np.maximum(np.floor(places[seen].min(axis=0)).astype(int) - room, 0) // r * r
        high = np.minimum(-(-(np.ceil(places[seen].max(axis=0)).astype(int) + room) // r) * r, last)
        low = np.minimum(low, np.maximum(high - r, 0))
        (x0, y0), (x1, y1) = low.tolist(), high.tolist()
        values, known = picture.window(x0, y0, x1, y1, r)
        found, there = sampled(values, np.clip((places - low) / r, 0, (high - low) / r), self.kernel, known)
        return found, there & seen


def ortho_of(
    rpc: Rpc, size_px: tuple[int, int], ground: Ground, *, crs: str | None, pixel: float | None,
    area: tuple[float, float, float, float] | None, kernel: Kernel,
) -> Ortho:  # fmt: skip
    """The map that is asked for; what is not stated follows from the scene.

    crs    plane or geographic system; None: the zone of UTM of the scene's middle
    pixel  in its unit; None: that of the scene, in two digits
    area   left, bottom, right, top there; None: what the scene sees of the raster
    raises InputError where scene and raster have nothing in common, or the map has too many pixels
    """
    system = crs or utm_of(rpc)
    if parsed_system(system).is_compound or parsed_system(system).is_geocentric:
        raise InputError("crs.plane_needed", system=system)
    lon, lat, height = rpc.ground_offset.tolist()
    about = local_frame(system, _in_system(system, lon, lat, height))
    unit = about.units_m[0] if not parsed_system(system).is_geographic else DEGREE_M
    gsd = np.linalg.norm(rpc.pixel_on_ground(), axis=1)
    size = pixel or two_digits(float(gsd.max()) / unit)
    extent = np.array(area) if area is not None else whole_pixels(_outline(rpc, size_px, ground, about), size)
    grid = grid_over(extent, size, most=MOST_PX)
    reduced = max(1, int(size * unit / float(gsd.max()) + 0.01))
    return Ortho(
        rpc=rpc, size_px=size_px, ground=ground, frame=about, grid=grid, kernel=kernel, reduced=reduced,
        remarks=(*ground.remarks, *_odd_heights(rpc, ground, size_px)),
    )  # fmt: skip


def _odd_heights(rpc: Rpc, ground: Ground, size_px: tuple[int, int]) -> tuple[str, ...]:
    """What is to be stated where the ground under the scene lies at heights that its RPC was not made for."""
    places, known = ground_of_rays(rpc, ground, _inner_grid(size_px))
    out = known & rpc.heights_outside(places)
    if not out.any():
        return ()
    low, high = float(places[known, 2].min()), float(places[known, 2].max())
    lowest, highest = rpc.height_range_m
    return (phrase("scene.ground_outside_heights", low_m=low, high_m=high, lowest_m=lowest, highest_m=highest),)


def _inner_grid(size_px: tuple[int, int]) -> Array:
    """Places (81, 2) all over a picture [px]."""
    x, y = (np.linspace(0, n, 9) for n in size_px)
    return np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)


def utm_of(rpc: Rpc) -> str:
    """EPSG code of the zone of UTM in which the middle of a scene lies; raises InputError beyond its latitudes."""
    lon, lat = rpc.ground_offset[:2].tolist()
    code = utm_at(lon, lat)
    if code is None:
        raise InputError("area.no_utm", latitude_deg=lat)
    return code


def _in_system(crs: str, lon: float, lat: float, height: float) -> tuple[float, float, float]:
    from pyproj import Transformer

    x, y = Transformer.from_crs("EPSG:4326", parsed_system(crs), always_xy=True).transform(lon, lat)
    if not (np.isfinite(x) and np.isfinite(y)):
        raise InputError("scene.outside_system", longitude_deg=lon, latitude_deg=lat, system=system_name(crs))
    return float(x), float(y), height


def _outline(rpc: Rpc, size_px: tuple[int, int], ground: Ground, frame: LocalFrame) -> Array:
    """Left, bottom, right, top of what the scene sees of the raster, in the system of the map."""
    w, h = size_px
    along = np.linspace(0, 1, BORDER)
    none, one = np.zeros(BORDER), np.ones(BORDER)
    x = np.concatenate([along, along, none, one]) * w
    y = np.concatenate([none, one, along, along]) * h
    rays = np.concatenate([np.stack([x, y], axis=1), _inner_grid(size_px)])
    places, known = ground_of_rays(rpc, ground, rays)
    if not known.any():
        raise InputError(
            "scene.not_covered",
            longitude_deg=places[:, 0].mean(),
            latitude_deg=places[:, 1].mean(),
            file=ground.file,
        )
    xyz = frame.crs_from_local(frame.local_from_wgs84(places))
    low, high = xyz[:, :2].min(axis=0), xyz[:, :2].max(axis=0)
    rows, columns = ground.shape
    i = np.concatenate([along, along, none, one]) * rows - 0.5
    j = np.concatenate([none, one, along, along]) * columns - 0.5
    own = local_frame(ground.plan, (*ground.xy(np.array([[rows / 2, columns / 2]]))[0].tolist(), 0.0))
    corners = np.column_stack([ground.xy(np.stack([i, j], axis=1)), np.zeros(len(i))])
    raster = frame.crs_from_local(frame.local_from_wgs84(own.wgs84_from_local(own.local_from_crs(corners))))[:, :2]
    low, high = np.maximum(low, raster.min(axis=0)), np.minimum(high, raster.max(axis=0))
    return np.array([*low, *high])


def ground_of_rays(rpc: Rpc, ground: Ground, xy_px: Array) -> tuple[Array, Mask]:
    """Longitude, latitude, ellipsoidal height (n, 3) where rays of the scene meet the raster; where it has any (n,).

    Beyond the raster and in its holes the mean of the heights that were found stands for the ground.
    """
    height = np.full(len(xy_px), float(rpc.ground_offset[2]))
    known = np.zeros(len(xy_px), bool)
    places = rpc.localise(xy_px, height)
    before = np.inf
    for _ in range(ROUNDS):
        cells = ground.places(places)
        found = ground.at(cells) + ground.separation(cells)
        known = np.isfinite(found)
        new = np.where(known, found, np.nanmean(found) if known.any() else rpc.ground_offset[2])
        change = float(np.abs(new - height).max())
        settles = change <= max(CLOSE_M, SETTLING * before)
        height = new if settles else (height + new) / 2  # on slopes steeper than the ray it would go to and fro
        places, before = rpc.localise(xy_px, height), change
        if change <= CLOSE_M:
            break
    return places, known
