"""A block as maps and drawings take it: points, photographs and figures in its coordinate system, with sigmas.

A georeferenced block is written in the system of its frame (east, north, height), any other in its own axes.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from raybundle.block import Block, Camera, Role
from raybundle.block.points import automatic
from raybundle.cameras.conversions import camera_rays
from raybundle.errors import InputError, phrase
from raybundle.io.formats.base import Export, Scene, scene
from raybundle.io.geo.coordinate_systems import LocalFrame
from raybundle.io.geo.parsed_names import parsed_system
from raybundle.io.geo.parsed_systems import system_name
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.natural import natural
from raybundle.numerics.planes import hull
from raybundle.numerics.rotation import angles_from_rotation
from raybundle.observations.alignment import Levels, Lines, OnFigure, PlumbLines

if TYPE_CHECKING:
    from pyproj import CRS

SIDE = 8
"""Places on each side of a photograph whose rays make its footprint: a distorted side is a curve."""
STEEPEST = 0.26
"""Cosine of the angle from the vertical (75 degrees) beyond which a ray is not followed to the ground, as in
`rectify`: its place there follows the assumed height four times over."""
KINDS = {"lines": "straight line", "plumb_lines": "plumb line", "levels": "level", "planes": "plane"}
"""Of figures, by their tables."""
FEET = {0.3048: "ft", 1200 / 3937: "us-ft"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure:
    """What was measured between points: lines, outlines of planes and levels, distances."""

    kind: str
    name: str
    xyz: Array
    """(k, 3) corners in the system"""
    closed: bool = False
    sigma: float = float("nan")
    """of the points' distances from it, or of the distance [unit of the block]"""


@dataclass(frozen=True, kw_only=True)
class Surveyed:
    """A block in the system in which it is written."""

    export: Export
    scene: Scene
    """oriented images and known points; `order` sorts its points"""

    @property
    def frame(self) -> LocalFrame | None:
        """Where it stands on the earth."""
        return self.export.frame

    @property
    def block(self) -> Block:
        """As it was given."""
        return self.export.block

    @cached_property
    def system(self) -> CRS | None:
        """None: a local system."""
        return None if self.frame is None else parsed_system(self.frame.crs)

    @property
    def system_name(self) -> str:
        """What it is called; empty for a local system."""
        return "" if self.frame is None else system_name(self.frame.crs)

    @property
    def local_name(self) -> str:
        """What a system is called that is none of the earth."""
        return "local" if self.export.within is None else "plane: X right, Y up, Z out of it"

    @property
    def degrees(self) -> bool:
        """Whether its plan coordinates are longitude and latitude."""
        return self.system is not None and self.system.is_geographic

    @cached_property
    def unit(self) -> str:
        """Of plan coordinates: m, mm, ft, us-ft, degree, or the name of another; empty where the scale is free."""
        if self.system is None:
            return "" if self.block.free_scale else self.block.length_unit
        axis = self.system.axis_info[0]
        if self.degrees:
            return "degree"
        if axis.unit_conversion_factor == 1.0:
            return "m"
        known = (w for f, w in FEET.items() if abs(axis.unit_conversion_factor / f - 1) < 1e-9)
        return next(known, axis.unit_name)

    @property
    def axes(self) -> tuple[str, str, str]:
        """What the coordinates are called."""
        return ("X", "Y", "Z") if self.system is None else ("E", "N", "h")

    @property
    def metres(self) -> float:
        """In a length unit of the block."""
        return 0.001 if self.block.length_unit == "mm" else 1.0

    def placed(self, xyz: Array) -> Array:
        """Coordinates (n, 3) in the system of coordinates (n, 3) of the block."""
        if self.export.within is not None:
            return self.export.within.coordinates(xyz)
        return xyz if self.frame is None else self.frame.crs_from_local(xyz * self.metres)

    # ---- points

    @cached_property
    def order(self) -> Index:
        """(p,) positions in the scene: control, check points, named points in their natural order, all others."""
        ids = [self.block.points.ids[k] for k in self.scene.points.tolist()]
        role = np.asarray(self.block.points.role)[self.scene.points]
        rank = np.select([role == Role.CONTROL, role == Role.CHECK, ~automatic(ids)], [0, 1, 2], 3)
        keys = [natural(name) for name in ids]
        return np.array(sorted(range(len(ids)), key=lambda k: (rank[k], keys[k])), np.int64)

    @property
    def rows(self) -> Index:
        """(p,) positions in the block, in this order."""
        return self.scene.points[self.order]

    @property
    def names(self) -> list[str]:
        """Of the points, in this order."""
        return [self.block.points.ids[k] for k in self.rows.tolist()]

    @property
    def named(self) -> Mask:
        """(p,) whether a point has a name of its own, or a role."""
        return ~automatic(self.names) | (np.asarray(self.block.points.role)[self.rows] != Role.TIE)

    @property
    def roles(self) -> list[str]:
        """(p,) control, check or tie."""
        return [Role(r).word for r in np.asarray(self.block.points.role)[self.rows].tolist()]

    @cached_property
    def xyz(self) -> Array:
        """(p, 3) of the points, in this order."""
        return self.placed(self.scene.xyz[self.order])

    @cached_property
    def sigma(self) -> Array:
        """(p, 3) along the axes of the system; NaN where not known. Of longitude and latitude in degrees."""
        return self.sigma_of(self.rows, self.xyz)

    def sigma_of(self, rows: Index, xyz: Array) -> Array:
        """The same of points at positions (k,) in the block and at xyz (k, 3) in the system."""
        return self._sigma(self.export.sigma, self.export.map_sigma, rows, xyz)

    @property
    def rays(self) -> Index:
        """(p,) observations in oriented images."""
        return np.bincount(self.scene.point, minlength=len(self.order))[self.order]

    @cached_property
    def differences(self) -> Array:
        """(p, 3) adjusted less given coordinates of control and check points; NaN where none were given."""
        given = self.export.given
        if given is None:
            return np.full((len(self.order), 3), np.nan)
        mine = given[self.rows]
        known = np.isfinite(mine)
        result = np.full(mine.shape, np.nan)
        some = known.any(axis=1)
        # what was not given is taken as adjusted, so that it has no part in the others
        filled = np.where(known, mine, self.scene.xyz[self.order])[some]
        result[some] = np.where(known[some], self.xyz[some] - self.placed(filled), np.nan)
        return result

    # ---- photographs

    @cached_property
    def photos(self) -> Index:
        """(n,) positions in the scene of the oriented photographs; the nominal viewpoints of scenes are none."""
        nominal = self.export.nominal
        every = np.arange(len(self.scene.source))
        return every if nominal is None else every[~nominal[self.scene.source]]

    @cached_property
    def stations(self) -> Array:
        """(n, 3) projection centres."""
        return self.placed(self.scene.centre[self.photos])

    @cached_property
    def station_sigma(self) -> Array:
        """(n, 3) their standard deviations along the axes of the system."""
        e = self.export
        return self._sigma(e.station_sigma, e.map_station_sigma, self.scene.source[self.photos], self.stations)

    @cached_property
    def rotation(self) -> Array:
        """(n, 3, 3) axes of the system to image axes; of longitude and latitude those of east, north, up."""
        return self.scene.rotation[self.photos] @ np.swapaxes(self.axes_at(self.stations), -1, -2)

    def axes_at(self, places: Array) -> Array:
        """(n, 3, 3) rotations from the axes of the block to those of the system, at places (n, 3) in it.

        Of longitude and latitude to east, north, up.
        """
        if self.export.within is not None:
            return np.broadcast_to(self.export.within.axes, (len(places), 3, 3))
        if self.frame is None or not len(places):
            return np.broadcast_to(np.eye(3), (len(places), 3, 3))
        return self.frame.crs_from_local_rotation(places)

    @property
    def angles(self) -> Array:
        """(n, 3) omega, phi, kappa [deg]."""
        return np.degrees(angles_from_rotation(self.rotation))

    @property
    def angle_sigma(self) -> Array:
        """(n, 3) of omega, phi, kappa in the frame of the adjustment, which convergence turns by little [deg]."""
        given, rows = self.export.station_angle_sigma, self.scene.source[self.photos]
        return np.full((len(rows), 3), np.nan) if given is None else np.degrees(given[rows])

    @cached_property
    def footprints(self) -> tuple[tuple[int, Array], ...]:
        """Photographs, as rows of `stations`, and the corners (k, 3) of what they show of level ground.

        The ground lies at the median height of the points that the photograph shows. A photograph whose border looks
        less steeply down than 75 degrees from the vertical, as that of a facade does, has none.
        """
        s = self.scene
        if not len(s.xyz) or self.export.within is not None:  # what is level is not in the plane
            return ()
        found: list[tuple[int, Array]] = []
        everywhere = float(np.median(s.xyz[:, 2]))
        heights = _median_heights(s, everywhere)
        borders = [_border(c) if c.model != "panorama" else None for c in s.cameras]
        for row, k in enumerate(self.photos.tolist()):
            rays = borders[int(s.camera[k])]
            if rays is None:
                continue
            towards = rays @ s.rotation[k]
            below = heights[k] - s.centre[k, 2]
            if below < 0 and bool(np.all(-towards[:, 2] > STEEPEST)):
                ground = s.centre[k] + towards * (below / towards[:, 2:])
                ground[:, 2] = heights[k]
                found.append((row, ground))
        if not found:
            return ()
        every = np.split(self.placed(np.concatenate([g for _, g in found])), len(found))
        return tuple((k, _anticlockwise(g)) for (k, _), g in zip(found, every, strict=True))

    # ---- figures

    @cached_property
    def figures(self) -> tuple[Figure, ...]:
        """Distances, lines and outlines that were observed, as adjusted points show them."""
        b = self.block
        known: Mask = np.all(np.isfinite(b.points.xyz), axis=1)
        found: list[Figure] = []
        d = b.distances
        for start, end, sigma in zip(d.start.tolist(), d.end.tolist(), d.sigma.tolist(), strict=True):
            if known[start] and known[end]:
                name = f"{b.points.ids[start]} - {b.points.ids[end]}"
                ends = self.placed(b.points.xyz[[start, end]])
                found.append(Figure(kind="distance", name=name, xyz=ends, sigma=float(sigma)))
        for table in b.tables.values():
            if not isinstance(table, OnFigure):
                continue
            kind = KINDS.get(table.name, table.name.rstrip("s").replace("_", " "))
            for name in sorted(set(table.figure), key=natural):
                rows = np.array([k for k, of in enumerate(table.figure) if of == name])
                at = np.unique(b.points.xyz[table.point[rows[known[table.point[rows]]]]], axis=0)
                if len(at) < 2:
                    continue
                corners = _corners(table, at)
                found.append(Figure(
                    kind=kind, name=name, xyz=self.placed(corners), closed=len(corners) > 2,
                    sigma=float(np.median(table.sigma[rows])),
                ))  # fmt: skip
        return tuple(found)

    @property
    def remarks(self) -> tuple[str, ...]:
        """What was left out, and in what system everything is."""
        reported = list(self.scene.remarks)
        if self.export.within is not None:
            reported.append(phrase("conversion.plane_axes", unit=self.unit or "none"))
        elif self.frame is None:
            reported.append(phrase("conversion.no_system", unit=self.unit or "none"))
        else:
            reported += [phrase("conversion.system", system=self.system_name), *self.frame.remarks]
        return tuple(reported)

    @property
    def footprint_remarks(self) -> tuple[str, ...]:
        """How many photographs of a georeferenced block have no footprint."""
        without = len(self.photos) - len(self.footprints)
        if not without or self.frame is None:  # what is level is not known of every local block
            return ()
        return (phrase("conversion.no_footprint", n=without),)

    def _sigma(self, local: Array | None, there: Array | None, rows: Index, at: Array) -> Array:
        if self.frame is None:
            known = np.full(at.shape, np.nan) if local is None else local[rows]
            return known if self.export.within is None else self.export.within.sigma(known)
        if there is not None:
            return there[rows]
        if local is None or not len(at):
            return np.full(at.shape, np.nan)
        C = np.zeros((len(at), 3, 3))
        C[:, [0, 1, 2], [0, 1, 2]] = (local[rows] * self.metres) ** 2
        return np.sqrt(np.diagonal(self.frame.crs_covariance(at, C), axis1=1, axis2=2))


def surveyed(export: Export) -> Surveyed:
    """The view of a block; raises InputError where no image is oriented, and where there is nothing to write."""
    found = Surveyed(export=export, scene=scene(export))
    if not len(found.scene.points) and not len(found.photos):
        raise InputError("block.nothing_to_write", block=export.block.name)
    return found


def check_lengths(s: Surveyed, name: str) -> None:
    """Raise InputError where a format whose coordinates are lengths would get longitude and latitude."""
    if s.degrees:
        raise InputError("format.degrees", format=name, system=s.system_name)


def _median_heights(s: Scene, everywhere: float) -> Array:
    """(n,) median height of the points seen in each image; of all where it sees fewer than three."""
    heights = np.full(len(s.source), everywhere)
    starts = np.searchsorted(s.image, np.arange(len(s.source) + 1))
    for k, (a, b) in enumerate(zip(starts[:-1].tolist(), starts[1:].tolist(), strict=True)):
        if b - a > 2:
            heights[k] = np.median(s.xyz[s.point[a:b], 2])
    return heights


def _border(camera: Camera) -> Array | None:
    """(k, 3) rays in the sensor frame along the border of the format; None where they cannot be determined."""
    w, h = float(camera.width_px), float(camera.height_px)
    t = np.arange(SIDE) / SIDE
    zero, one = np.zeros(SIDE), np.ones(SIDE)
    x = np.concatenate([t, one, 1 - t, zero]) * w
    y = np.concatenate([zero, t, one, 1 - t]) * h
    try:
        rays = camera_rays(camera, np.stack([x, y])).T
    except (ArithmeticError, ValueError, np.linalg.LinAlgError):
        return None
    return rays if np.isfinite(rays).all() else None


def _anticlockwise(ring: Array) -> Array:
    x, y = (ring[:, :2] - ring[:, :2].mean(axis=0)).T
    area = float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)))
    return ring if area >= 0 else ring[::-1]


def _corners(table: OnFigure, xyz: Array) -> Array:
    """Ends of a line (2, 3) or corners of an outline (k, 3), on the figure, of two points or more at places (n, 3)."""
    middle = xyz.mean(axis=0)
    if isinstance(table, PlumbLines):
        return np.array([[*middle[:2], xyz[:, 2].min()], [*middle[:2], xyz[:, 2].max()]])
    _, spread, axes = np.linalg.svd(xyz - middle)
    along = (xyz - middle) @ axes.T
    line = middle + np.array([[along[:, 0].min()], [along[:, 0].max()]]) * axes[:1]
    if isinstance(table, Lines):
        return line
    if isinstance(table, Levels):
        line[:, 2] = middle[2]
        axes, along = np.eye(3), xyz - middle
        spread = np.linalg.svd(along[:, :2], compute_uv=False)
    if len(xyz) < 3 or spread[1] < 1e-6 * spread[0]:
        return line
    return middle + hull(along[:, :2]) @ axes[:2]
