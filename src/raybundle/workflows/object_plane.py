"""A plane of the object with axes in it: by named points, plumb, level, or the one that most points lie in.

What a picture to scale, a drawing sheet and a drawing in the plane's axes have in common.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from raybundle.block import Block
from raybundle.errors import InputError, Message, Text, note, phrase, warning
from raybundle.io.geo.coordinate_systems import LocalFrame
from raybundle.io.geo.parsed_names import plan_system
from raybundle.io.geo.parsed_systems import system_name
from raybundle.measuring.axes import IN_LINE
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.planes import in_plane, planes_of_most
from raybundle.workflows.vertical import Plumb, asked_plumb, points_at

if TYPE_CHECKING:
    from pyproj import CRS

FLAT = 0.9
"""Vertical part of the normal from which a plane counts as horizontal."""
BLUNDER = 3.0
"""Robust standard deviations from which a point does not lie at the median height."""
LEAST = 3
BATTER = float(np.arctan(1 / 5))
"""[rad], 11 degrees: what the face of a rampart leans back (Vauban's revetments, a fifth of their height).  No house
leans so: the tower of Pisa leans by 4 degrees, that of Suurhusen by 5."""
Covariance = Callable[[Sequence[str]], Array | None]
"""Joint covariance (3 k, 3 k) of the coordinates of named points; None where it is not known"""


@dataclass(frozen=True, slots=True, kw_only=True)
class PlaneAsked:
    """Which plane is meant, and which axes it has."""

    points: tuple[str, ...] = ()
    """(): that of most points"""
    vertical: bool = False
    horizontal: bool = False
    up: str = "z"
    """z, lines, or the names of two points with a comma between"""
    axis: tuple[str, str] | None = None
    """None: level"""
    origin: str = ""
    """point whose foot is the origin; "": the middle of the points"""
    wall: int = 1
    """of planes by most points, the how many-th"""

    def __post_init__(self) -> None:
        """Raises InputError for what does not go together."""
        if self.vertical and self.horizontal:
            raise InputError("plane.vertical_and_horizontal")
        least = 2 if self.vertical else LEAST
        if self.points and not self.horizontal and len(self.points) < least:
            raise InputError("plane.too_few_points", n=len(self.points), least=least, vertical=self.vertical)
        twice = [n for n in self.points if self.points.count(n) > 1]
        if twice:
            raise InputError("plane.point_twice", point=twice[0])

    @property
    def axes_words(self) -> Text:
        """Where the plane's coordinates begin, and where they go."""
        first, second = self.axis or ("", "")
        right = "points" if self.axis else "block" if self.horizontal else "level"
        return phrase(
            "drawing_sheet.axes", at_point=bool(self.origin), origin=self.origin, right=right, first=first,
            second=second,
        )  # fmt: skip

    @property
    def has_axes(self) -> bool:
        """Whether axes of the object are asked for, so that those of a map are not."""
        return self.axis is not None or bool(self.origin)


@dataclass(frozen=True, slots=True, kw_only=True)
class Lean:
    """How far a plane leans back from the vertical (its normal above the horizon), or is out of level."""

    angle: float
    """[rad], positive: it leans away from the viewer"""
    sigma: float
    """standard deviation [rad]; NaN: not known"""

    @property
    def reported(self) -> bool:
        """Whether it is more than its standard deviation."""
        return abs(self.angle) > self.sigma

    @property
    def of_no_wall(self) -> bool:
        """Whether it is more than any wall leans, beyond the 95 % of its standard deviation."""
        spread = self.sigma if np.isfinite(self.sigma) else 0.0
        return abs(self.angle) - 1.96 * spread > BATTER

    @property
    def values(self) -> dict[str, float | bool]:
        """Of its message."""
        known = bool(np.isfinite(self.sigma))
        return {
            "back": self.angle >= 0, "lean_deg": abs(float(np.degrees(self.angle))), "sigma_known": known,
            "sigma_deg": float(np.degrees(self.sigma)) if known else 0.0,
        }  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Plane:
    """A plane in object space with axes to the right, upwards, and towards the viewer."""

    origin: Array
    """(3,)"""
    axes: Array
    """(3, 3), rows right, up, normal"""
    rms: float
    """Root mean square distance of the points that it was fitted to."""
    points: int
    of: int
    """points that might lie in it: all that were seen twice, or those named"""
    extent: Array
    """(4,) left, bottom, right, top of these points in the plane"""
    lean: Lean | None = None
    """of a wall that was not made plumb: of the plane itself; of one that was: of the same points without that"""
    plumb: Plumb | None = None
    """what was taken for the vertical"""
    kind: str = "best"
    """named, best, vertical or horizontal"""
    axes_by: Text | None = None
    """where the coordinates begin, and where they go, in words"""

    def coordinates(self, xyz: Array) -> Array:
        """(n, 3) right, up, and distance in front of the plane of points (n, 3)."""
        return (xyz - self.origin) @ self.axes.T

    def places(self, at: Array) -> Array:
        """Points (n, 3) of the object at places (n, 2) of the picture."""
        return self.origin + at @ self.axes[:2]

    @property
    def cautions(self) -> tuple[Text, ...]:
        """What speaks against it."""
        if self.kind != "vertical" or self.lean is None or not self.lean.of_no_wall:
            return ()
        limit = float(np.degrees(BATTER))
        found = warning("plane.leans", details=[self._vertical], **self.lean.values, limit_deg=limit)
        return (Text.of(found),)

    @property
    def remarks(self) -> tuple[Text, ...]:
        """What is to be reported of it."""
        if self.kind != "vertical" or self.lean is None or not self.lean.reported or self.cautions:
            return ()
        return (Text.of(note("plane.not_plumb", details=[self._vertical], **self.lean.values)),)

    @property
    def _vertical(self) -> Message:
        """By what the vertical is known."""
        return phrase("plumb.block").message if self.plumb is None else self.plumb.words.message

    def as_mapping(self) -> dict[str, Any]:
        """What NAME.toml states of it."""
        reported: dict[str, Any] = {
            "origin": self.origin.tolist(), "right": self.axes[0].tolist(), "up": self.axes[1].tolist(),
            "normal": self.axes[2].tolist(), "axes_by": self.axes_by or "", "plane": self.kind,
            "points": self.points, "points_of": self.of, "points_rms": self.rms,
        }  # fmt: skip
        if self.axes_by is not None:
            reported["axes_by_message"] = json.dumps(self.axes_by.message.json())
        if self.plumb is not None:
            reported["vertical_by"] = self.plumb.words
            reported["vertical_by_message"] = json.dumps(self.plumb.words.message.json())
        if self.lean is not None:
            reported["lean_deg"] = float(np.degrees(self.lean.angle))
            if np.isfinite(self.lean.sigma):
                reported["lean_sigma_deg"] = float(np.degrees(self.lean.sigma))
        return reported


@dataclass(frozen=True, slots=True, kw_only=True)
class MapLevel(Plane):
    """Level ground in a map: one height above the reference surface, and places that are east and north there.

    The picture is made in the map's own grid: each of its places goes through the projection, so that scale and
    convergence of the grid are in it without an approximation.
    """

    frame: LocalFrame
    system: CRS
    """in plan"""
    height: float
    """in the system"""
    metres: float
    """in a unit of the block"""

    @property
    def unit(self) -> str:
        """Of east and north."""
        axis = self.system.axis_info[0]
        return "m" if axis.unit_conversion_factor == 1.0 else axis.unit_name

    @property
    def per_unit(self) -> float:
        """Units of the system in one of the block."""
        return self.metres / self.system.axis_info[0].unit_conversion_factor

    def coordinates(self, xyz: Array) -> Array:
        """(n, 3) east, north, and height above this level, in units of the system."""
        return self.frame.crs_from_local(xyz * self.metres) - [0.0, 0.0, self.height]

    def places(self, at: Array) -> Array:
        """Points (n, 3) of the object at east, north (n, 2)."""
        there = np.column_stack([at, np.full(len(at), self.height)])
        return self.frame.local_from_crs(there) / self.metres

    def as_mapping(self) -> dict[str, Any]:
        """What NAME.toml states of it."""
        return {
            "system": self.frame.crs, "height": self.height, "plane": "horizontal", "points": self.points,
            "points_of": self.of, "points_rms": self.rms,
        }  # fmt: skip


def in_map(plane: Plane, frame: LocalFrame, metres: float) -> MapLevel:
    """A horizontal plane as level ground of the map in which a block stands.

    metres  in a unit of the block
    The extent is that of the plane's in east and north, and its rms is in the unit of the system, too.
    raises  InputError where the system is not projected
    """
    system = plan_system(frame.crs)
    if system is None:
        raise InputError("plane.no_projected_system", system=system_name(frame.crs))
    unit = system.axis_info[0].unit_conversion_factor
    left, bottom, right, top = plane.extent
    corners = plane.places(np.array([[left, bottom], [right, bottom], [right, top], [left, top]]))
    there = frame.crs_from_local(corners * metres)
    middle = frame.crs_from_local(plane.origin[None] * metres)[0]
    return MapLevel(
        origin=plane.origin, axes=plane.axes, rms=plane.rms * metres / unit, points=plane.points, of=plane.of,
        extent=np.concatenate([there[:, :2].min(axis=0), there[:, :2].max(axis=0)]), kind="horizontal",
        plumb=plane.plumb, frame=frame, system=system, height=float(middle[2]), metres=metres,
    )  # fmt: skip


def plane_of(
    block: Block, asked: PlaneAsked | None = None, *, sigma: Array | None = None,
    about: Mapping[str, Any] | None = None, covariance: Covariance = lambda _: None,
) -> Plane:  # fmt: skip
    """The plane that is asked for, with its axes.

    sigma       (p, 3) standard deviations of the object points; a point lies in a plane within what they allow, or
                within the size of a photograph's pixel there, which a picture does not show; None: within the latter
    about       what the result.json states, of which `upright` shows where Z comes from
    covariance  of named points; without it the lean of a plane by names has no standard deviation of its measurement
    raises      InputError for unknown points, for too few and where they lie on a line
    The lean's standard deviation holds the errors of named points, or of unnamed ones the scatter about the plane as
    if it were independent from point to point; and that of the vertical.  Limits: errors that many
    unnamed points have in common.
    """
    asked = asked or PlaneAsked()
    plumb = asked_plumb(block, asked.up, about or {})
    xyz = block.points.xyz
    seen = (np.bincount(block.observations.point, minlength=len(xyz)) > 1) & np.isfinite(xyz).all(axis=1)
    chosen = points_at(block, asked.points) if asked.points else np.flatnonzero(seen)
    if len(chosen) < (2 if asked.vertical and asked.points else LEAST):
        raise InputError(
            "plane.too_few_points",
            n=len(chosen),
            least=2 if asked.vertical and asked.points else LEAST,
            vertical=asked.vertical,
        )
    points = xyz[chosen]
    known = np.full((len(points), 3), np.nan) if sigma is None else sigma[chosen]
    least = pixel_at(block, np.median(points, axis=0))
    origin, normal, inliers = _placed(points, known, least, asked, plumb.up)
    viewer = block.images.centre[block.images.oriented].mean(axis=0)
    normal = normal if normal @ (viewer - origin) >= 0 else -normal
    axes = _turned(axes_of(normal, plumb.up), block, asked)
    at = (points[inliers] - origin) @ axes.T
    shown = at
    if asked.vertical and len(asked.points) == LEAST - 1:  # two points have no extent: all that lie in their plane
        every = xyz[seen]
        spread = np.zeros((len(every), 3)) if sigma is None else sigma[seen]
        near = in_plane(every, np.nan_to_num(spread) ** 2, least, origin, normal)
        shown = (every[near] - origin) @ axes.T if near.sum() >= LEAST else at
    moved = _origin(block, asked, origin, axes)
    shift = ((moved - origin) @ axes.T)[:2]
    kind = "horizontal" if asked.horizontal else "vertical" if asked.vertical else "named" if asked.points else "best"
    found = Plane(
        origin=moved, axes=axes, rms=float(np.sqrt((at[:, 2] ** 2).mean())), points=int(inliers.sum()),
        of=len(points), extent=_extent(shown) - np.tile(shift, 2), plumb=plumb, kind=kind, axes_by=asked.axes_words,
    )  # fmt: skip
    if asked.horizontal or abs(float(axes[2] @ plumb.up)) > FLAT:
        return found
    return replace(found, lean=_lean(block, asked, plumb, points[inliers], axes[2], covariance))


def _placed(points: Array, sigma: Array, least: float, asked: PlaneAsked, up: Array) -> tuple[Array, Array, Mask]:
    """Origin (3,), normal (3,) and the points (n,) that lie in the plane."""
    if asked.horizontal:
        heights = points @ up
        near = heights - np.median(heights)
        inliers = np.abs(near) < BLUNDER * 1.4826 * max(float(np.median(np.abs(near))), 1e-12)
        middle = np.median(points, axis=0)
        return middle + (np.median(heights) - middle @ up) * up, up, inliers
    if not asked.points:
        walls = planes_of_most(points, sigma, least, count=asked.wall, steep=up if asked.vertical else None)
        if len(walls) < asked.wall:
            raise InputError("plane.no_such_wall", wall=asked.wall, n=len(walls))
        found = walls[-1]
        _check_spread(points[found.inliers])
        if asked.vertical:  # of the wall as it stands: those within a plumb plane would be a band of one that leans
            return found.origin, _made_plumb(points[found.inliers], up), found.inliers
        return found.origin, found.normal, found.inliers
    origin, every = points.mean(axis=0), np.ones(len(points), bool)
    if not asked.vertical:
        _check_spread(points)
        return origin, np.linalg.svd(points - origin, full_matrices=False)[2][2], every
    return origin, _made_plumb(points, up), every


def _made_plumb(points: Array, up: Array) -> Array:
    """The level normal (3,) of the plumb plane that fits points best: of the line that they make as seen from above."""
    away = points - points.mean(axis=0)
    _, s, axes = np.linalg.svd(away - np.outer(away @ up, up), full_matrices=False)
    if not s[0] > IN_LINE * float(np.linalg.norm(away, axis=1).max()):
        raise InputError("plane.points_above_each_other")
    normal: Array = np.cross(axes[0], up)
    return normal / np.linalg.norm(normal)


def _check_spread(points: Array) -> None:
    spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False) if len(points) >= LEAST else np.zeros(3)
    if len(points) < LEAST or spread[1] < 1e-6 * spread[0] or spread[0] == 0:
        raise InputError("plane.points_on_line")


def axes_of(normal: Array, up: Array) -> Array:
    """Rows right, up, normal: up is the vertical in the plane; in a horizontal plane the object's Y."""
    reference = np.array([0.0, 1.0, 0.0]) if abs(float(normal @ up)) > FLAT else up
    upward = reference - (reference @ normal) * normal
    upward = upward / np.linalg.norm(upward)
    return np.stack([np.cross(upward, normal), upward, normal])


def _turned(axes: Array, block: Block, asked: PlaneAsked) -> Array:
    """The axes with the one to the right along two points, as seen in the plane."""
    if asked.axis is None:
        return axes
    a, b = block.points.xyz[points_at(block, asked.axis)]
    along = b - a
    right = along - (along @ axes[2]) * axes[2]
    if not np.linalg.norm(right) > IN_LINE * np.linalg.norm(along):
        raise InputError("plane.axis_no_direction", first=asked.axis[0], second=asked.axis[1])
    right = right / np.linalg.norm(right)
    return np.stack([right, np.cross(axes[2], right), axes[2]])


def _origin(block: Block, asked: PlaneAsked, origin: Array, axes: Array) -> Array:
    """Where the coordinates of the plane begin."""
    if not asked.origin:
        return origin
    point = block.points.xyz[points_at(block, (asked.origin,))[0]]
    return point - ((point - origin) @ axes[2]) * axes[2]


def _extent(at: Array) -> Array:
    """(4,) left, bottom, right, top of places; of many, without the half percent at each edge."""
    low, high = np.percentile(at[:, :2], [0.5, 99.5], axis=0) if len(at) > 200 else (at.min(axis=0), at.max(axis=0))
    return np.array([low[0], low[1], high[0], high[1]])[[0, 1, 2, 3]]


def _lean(
    block: Block, asked: PlaneAsked, plumb: Plumb, mine: Array, normal: Array, covariance: Covariance
) -> Lean | None:
    """How the points of a wall lean: of the plane that fits them best, whether the one made of them is plumb or not."""
    if asked.points and len(asked.points) < LEAST:
        return None
    size = np.linalg.svd(mine - mine.mean(axis=0), compute_uv=False)
    if size[1] < IN_LINE * size[0]:
        return None  # in a line: they show no lean
    angle = lean_of(mine, plumb.up, normal)
    variance = _by_scatter(mine, plumb.up) if len(mine) > LEAST else 0.0 if asked.points else np.nan
    if asked.points:
        measured = _by_errors(block, asked, plumb, normal, covariance)
        variance = measured + variance if np.isfinite(measured) or len(mine) <= LEAST else variance
    own = 0.0 if np.isnan(plumb.sigma) else plumb.sigma**2
    return Lean(angle=angle, sigma=float(np.sqrt(variance + own)))


def lean_of(points: Array, up: Array, normal: Array) -> float:
    """Angle [rad] of the normal of the best plane through points (n, 3), on the side of `normal`, above the horizon."""
    n = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2][2]
    n = n if n @ normal >= 0 else -n
    return float(np.arcsin(np.clip(n @ up, -1, 1)))


def _by_scatter(points: Array, up: Array) -> float:
    """Variance [rad^2] of the lean by the distances of points from their best plane, taken as independent."""
    _, s, axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)
    turn = (axes[:2] @ up) ** 2  # the lean is the turn about the level axis: shares of the turns along both axes
    noise = s[2] ** 2 / (len(points) - LEAST)
    return float(noise * (turn / np.maximum(s[:2] ** 2, 1e-300)).sum() / max(float(turn.sum()), 1e-300))


def _by_errors(block: Block, asked: PlaneAsked, plumb: Plumb, normal: Array, covariance: Covariance) -> float:
    """Variance [rad^2] of the lean by the errors of named points, those that show the vertical among them."""
    names = tuple(dict.fromkeys((*asked.points, *plumb.points)))
    C = covariance(names)
    if C is None:
        return np.nan
    xyz = block.points.xyz[points_at(block, names)]
    own = [names.index(n) for n in asked.points]

    def lean(moved: Array) -> float:
        return lean_of(moved[own], plumb.up_of(dict(zip(names, moved, strict=True))), normal)

    step = 1e-6 * float(np.linalg.norm(xyz - xyz.mean(axis=0), axis=1).max())
    J = np.zeros(3 * len(names))
    for k in range(len(J)):
        change = np.zeros(len(J))
        change[k] = step
        change = change.reshape(-1, 3)
        J[k] = (lean(xyz + change) - lean(xyz - change)) / (2 * step)
    return max(float(J @ C @ J), 0.0)


def pixel_at(block: Block, middle: Array) -> float:
    """The median size of a photograph's pixel at the distance of a place (3,)."""
    sizes: list[float] = []
    for i in np.flatnonzero(block.images.oriented).tolist():
        camera = block.cameras[int(block.images.camera[i])]
        ray = block.images.centre[i] - middle
        distance = float(np.linalg.norm(ray))
        sizes.append(distance * float(np.mean(camera.pixel_mm)) / camera.sensor.camera_constant(camera.parameters))
    return float(np.median(sizes))
