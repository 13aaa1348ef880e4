"""Coordinate systems of the earth, and the local east-north-up frame in which a block is adjusted.

A map projection bends straight lines and changes lengths; a bundle needs a Cartesian frame.  `LocalFrame` is
the plane through one point of the ellipsoid, axes east, north, up there.  Its heights are those above that
plane, not above the ellipsoid: 1 km from the origin the two differ by 8 cm.

Coordinates of a coordinate system stand in the order x = east or longitude, y = north or latitude, z = height;
longitude and latitude in degrees, the rest in the unit of the system.  Conversion to geocentric coordinates:
Hofmann-Wellenhof, Lichtenegger and Wasle 2008, section 8.2.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from raybundle.errors import InputError, Text, note
from raybundle.io.geo.parsed_systems import (
    ELLIPSOID,
    code_of,
    geoid_file,
    height_name,
    of_older_datum,
    parse_crs,
    system_name,
)
from raybundle.io.reading.words import finite
from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import nearest_rotation

if TYPE_CHECKING:
    from pyproj import CRS, Transformer

WGS84 = "EPSG:4979"
STEP_M = 1.0
"""Half the base of numeric derivatives."""


@dataclass(frozen=True, slots=True, kw_only=True)
class LocalFrame:
    """A local east-north-up frame at a point; lengths in metres.

    Heights: `crs_from_local` gives back heights of the kind that went in.  Heights above a geoid need its grid, or an
    undulation; a constant one neglects the slope of the geoid, which tilts the frame (to 1 : 10 000 in mountains).
    A system that states nothing about heights is taken to count them from the ellipsoid.
    """

    crs: str
    """As it was given: EPSG:25832, EPSG:25832+7837, a PROJ string or WKT."""
    origin: tuple[float, float, float]
    """In that system; the height counts as 0 where it was not known."""
    undulation_m: float | None = None
    """Height of the geoid above the ellipsoid at the origin, added to all heights; None: by the grid of the geoid."""
    remarks: tuple[str, ...] = ()
    """What is assumed about heights and datum."""

    def local_from_crs(self, xyz: Array) -> Array:
        """Local coordinates (n, 3) of coordinates (n, 3); an unknown height (NaN) stays unknown.

        Plan coordinates of a point without height are taken at the height of the origin; 100 m of height
        move them by 1.6 cm at 1 km from the origin.
        raises  InputError where a point lies outside the area of the system
        """
        xyz = _rows(xyz)
        unknown = np.isnan(xyz[:, 2])
        filled = np.where(unknown[:, None] & [False, False, True], self.origin[2], xyz)
        local = (_geocentric_from_crs(self, filled) - self.geocentric[0]) @ self.geocentric[1].T
        local[unknown, 2] = np.nan
        return local

    def crs_from_local(self, xyz: Array) -> Array:
        """Coordinates (n, 3) of local coordinates (n, 3); an unknown height (NaN) stays unknown."""
        xyz = _rows(xyz)
        unknown = np.isnan(xyz[:, 2])
        filled = xyz.copy()
        # without a height: on the surface through the origin that runs parallel to the ellipsoid
        radius = np.linalg.norm(self.geocentric[0])
        square = np.sum(xyz[:, :2] ** 2, axis=1)
        filled[unknown, 2] = (np.sqrt(np.maximum(radius**2 - square, 0)) - radius)[unknown]
        for _ in range(3 if unknown.any() else 0):
            height = _crs_from_geocentric(self, filled @ self.geocentric[1] + self.geocentric[0])[:, 2]
            filled[unknown, 2] -= (height[unknown] - self.origin[2]) * _unit(self.crs)[1]
        result = _crs_from_geocentric(self, filled @ self.geocentric[1] + self.geocentric[0])
        result[unknown, 2] = np.nan
        return result

    def wgs84_from_local(self, xyz: Array) -> Array:
        """Longitude, latitude [deg] and height [m] (n, 3) in WGS 84; a datum shift is pyproj's best without grids."""
        centre, R = self.geocentric
        geographic = _geographic_from_geocentric(_rows(xyz) @ R + centre, _horizontal(self.crs))
        return _transformed(_to_wgs84(self.crs), geographic)

    def local_from_wgs84(self, geographic: Array) -> Array:
        """Local coordinates (n, 3) of longitude, latitude [deg], ellipsoidal height [m] in WGS 84; NaN heights stay."""
        rows = _rows(geographic)
        unknown = np.isnan(rows[:, 2])
        height = self.wgs84_from_local(np.zeros((1, 3)))[0, 2]
        filled = np.where(unknown[:, None] & [False, False, True], height, rows)
        own = _checked(_converted(_to_wgs84(self.crs), *filled.T, inverse=True), rows, "WGS 84")
        local = (_geocentric_from_geographic(own, _horizontal(self.crs)) - self.geocentric[0]) @ self.geocentric[1].T
        local[unknown, 2] = np.nan
        return local

    def jacobian(self, xyz: Array) -> Array:
        """(n, 3, 3) derivatives of local coordinates by those of the system, at (n, 3) in the system."""
        xyz = _rows(xyz)
        filled = np.where(np.isnan(xyz) & [False, False, True], self.origin[2], xyz)
        plan, height = _unit(self.crs)
        step = STEP_M / np.array([plan, plan, height])
        beside = np.array([np.diag(step), -np.diag(step)])[:, :, None] + filled  # side, axis, point, coordinate
        ahead, behind = self.local_from_crs(beside.reshape(-1, 3)).reshape(beside.shape)
        return np.moveaxis((ahead - behind) / (2 * step[:, None, None]), 0, 2)

    def local_covariance(self, xyz: Array, covariance: Array) -> Array:
        """Covariances (n, 3, 3) in the local frame of covariances (n, 3, 3) in the system, at (n, 3) there.

        The scale of the projection and the convergence of its grid are in it.  Unknown heights: the plan part
        is right, what has to do with the height is NaN in and out.
        """
        J = self.jacobian(xyz)
        return _propagated(J, covariance)

    def crs_covariance(self, xyz: Array, covariance: Array) -> Array:
        """Covariances (n, 3, 3) in the system of covariances (n, 3, 3) in the local frame, at (n, 3) in the system."""
        return _propagated(np.linalg.inv(self.jacobian(xyz)), covariance)

    def local_from_enu(self, xyz: Array) -> Array:
        """Rotations (n, 3, 3) from east, north, up at points (n, 3) of the system to the axes of this frame."""
        geographic = _geographic(self, _rows(xyz))
        return self.geocentric[1] @ np.swapaxes(_enu_from_geocentric(geographic), -1, -2)

    def crs_from_local_rotation(self, xyz: Array) -> Array:
        """Rotations (n, 3, 3) from the axes of this frame to those of the system's grid, at points (n, 3) of it.

        For attitudes: R(object axes to image axes) in the grid = R(local) @ result.T.  Geographic systems: to
        east, north, up.
        """
        xyz = _rows(xyz)
        if _horizontal(self.crs).is_geographic:
            return np.swapaxes(self.local_from_enu(xyz), -1, -2)
        return np.swapaxes(nearest_rotation(self.jacobian(xyz)), -1, -2)

    def scale_and_convergence(self, xyz: Array) -> Array:
        """(n, 2) of a projected system at (n, 3): length in the grid / length in space, and convergence [rad].

        The scale holds at the point's height.  The convergence is the direction of grid north, counted
        clockwise from north.
        """
        J = np.swapaxes(self.local_from_enu(xyz), -1, -2) @ self.jacobian(xyz)
        plan = J[:, :2, :2] * (1 / _unit(self.crs)[0])
        return np.stack([1 / np.sqrt(np.linalg.det(plan)), np.arctan2(plan[:, 0, 1], plan[:, 1, 1])], axis=1)

    def as_mapping(self) -> dict[str, Any]:
        """What a file needs to make the same frame again with `local_frame`."""
        given = {} if self.undulation_m is None else {"undulation_m": self.undulation_m}
        return {"crs": self.crs, "origin": list(self.origin), **given}

    @property
    def units_m(self) -> tuple[float, float]:
        """Metres in a unit of plan and of height; of degrees, a metre at the equator."""
        return _unit(self.crs)

    @property
    def geoid_grid(self) -> str:
        """File of the grid that heights above a geoid are converted with; empty where none is."""
        transformer = _geoid(self)
        found = None if transformer is None else re.search(r"grids=([^\s,]+)", transformer.definition)
        return "" if found is None else found[1]

    @property
    def geocentric(self) -> tuple[Array, Array]:
        """Geocentric coordinates (3,) of the origin, and the rotation (3, 3) to the axes, in its own datum."""
        return _place(self.crs, self.origin, self.undulation_m)


def local_frame(
    crs: str, origin: tuple[float, float, float] | Array, *, undulation_m: float | None = None
) -> LocalFrame:
    """The local frame at a point of a coordinate system.

    crs           "EPSG:25832", "EPSG:25832+7837" (plan + heights), a PROJ string, WKT or "WGS84 UTM 32N"
    origin        x, y, z there (longitude before latitude); a height of NaN counts as 0, and is stated in a remark
    undulation_m  height of the geoid above the ellipsoid, that of WGS 84 where the system's is an older one; None: by
                  pyproj's grid
    raises        InputError for an unknown system, an origin outside its area, or a geoid whose grid is missing
    """
    x, y, z = (float(v) for v in origin)
    if undulation_m is not None and crs.strip().lower().endswith(ELLIPSOID):
        raise InputError("crs.undulation_of_ellipsoid", system=crs)
    remarks = height_remarks(crs, undulation_m)
    if np.isnan(z):
        z = 0.0
        remarks += (Text.of(note("crs.origin_height_unknown")),)
    frame = LocalFrame(crs=crs, origin=(x, y, z), undulation_m=undulation_m, remarks=remarks)
    frame.local_from_crs(np.array([[x, y, z]]))
    return frame


def in_other_projection(frame: LocalFrame, crs: str) -> LocalFrame:
    """The same local frame, its coordinates stated in another projection of the same datum.

    raises  InputError where the system has another datum or other heights: that takes a transformation, whose
            accuracy is the user's to choose
    """
    old, new = _horizontal(frame.crs), _horizontal(crs)
    same_datum = (
        not (old.is_geocentric or new.is_geocentric)
        and old.geodetic_crs is not None and new.geodetic_crs is not None
        and old.geodetic_crs.to_2d().equals(new.geodetic_crs.to_2d())
    )  # fmt: skip
    heights = [c.sub_crs_list[1] if c.is_compound else None for c in map(parse_crs, (frame.crs, crs))]
    a, b = heights
    if not same_datum or not ((a is None and b is None) or (a is not None and b is not None and a.equals(b))):
        raise InputError("crs.other_datum", own=system_name(frame.crs), system=system_name(crs))
    x, y, z = frame.origin
    lon, lat = _converted(_plan(frame.crs), np.array([x]), np.array([y]))[0]
    plan = _converted(_plan(crs), np.array([lon]), np.array([lat]), inverse=True)
    x, y = _checked(plan, np.array([[x, y]]), crs)[0].tolist()
    origin = (x, y, z * _unit(frame.crs)[1] / _unit(crs)[1])
    return local_frame(crs, origin, undulation_m=frame.undulation_m)


def frame_from_mapping(values: Mapping[str, Any]) -> LocalFrame:
    """The frame that `LocalFrame.as_mapping` described; raises InputError where a value is missing or wrong."""
    try:
        origin = [finite(v) for v in values["origin"]]
        x, y, z = (v for v in origin if v is not None)
        crs, given = str(values["crs"]), values.get("undulation_m")
        (undulation,) = (None,) if given is None else (v for v in [finite(given)] if v is not None)
    except (KeyError, TypeError, ValueError):
        raise InputError("crs.incomplete") from None
    return local_frame(crs, (x, y, z), undulation_m=undulation)


def height_remarks(crs: str, undulation_m: float | None = None) -> tuple[str, ...]:
    """What is assumed about the heights of a system, in words."""
    system = parse_crs(crs)
    older = undulation_m is not None and not system.is_geocentric and of_older_datum(crs)
    if system.is_geocentric or (len(system.axis_info) == 3 and not system.is_compound):
        return ()
    if not system.is_compound:
        unit = system.axis_info[0].unit_name if system.is_projected else "metre"
        name = system_name(crs)
        if undulation_m is not None:
            above = note("crs.heights_above_geoid", system=name, unit=unit, undulation_m=undulation_m, older=older)
            return (Text.of(above),)
        code = code_of(crs)  # one of another place would move the block there
        assumed = note(
            "crs.heights_assumed", system=name, unit=unit, coded=bool(code), code_name=str(code or ""),
            ellipsoidal=f"{code or ''}{ELLIPSOID}", sea=f"{code or ''}+5773",
        )  # fmt: skip
        return (Text.of(assumed),)
    if undulation_m is not None:
        added = note("crs.undulation_added", heights=height_name(crs), undulation_m=undulation_m, older=older)
        return (Text.of(added),)
    return ()


def _missing_geoid(crs: str, grid: str) -> InputError:
    from pyproj.datadir import get_data_dir

    plan = parse_crs(crs).sub_crs_list[0]
    code = plan.to_authority()
    alone = (":".join(code) if code else plan.name) + ELLIPSOID
    kind = "unknown" if not grid else "own" if Path(grid).is_absolute() else "known"
    return InputError(
        "crs.geoid_missing", heights=height_name(crs), kind=kind, grid=grid or "-", folder=str(get_data_dir()),
        ellipsoidal=alone,
    )  # fmt: skip


@lru_cache(maxsize=64)
def _horizontal(crs: str) -> CRS:
    system = parse_crs(crs)
    if system.is_compound:
        system = system.sub_crs_list[0]
    while system.is_bound and system.source_crs is not None:
        system = system.source_crs
    return system


@lru_cache(maxsize=64)
def _plan(crs: str) -> Transformer:
    """From plan coordinates to longitude and latitude on the same datum: a conversion, exact."""
    from pyproj import Transformer

    system = _horizontal(crs)
    flat = system.to_2d() if len(system.axis_info) == 3 else system
    base = flat.geodetic_crs
    assert base is not None
    return Transformer.from_crs(flat, base.to_2d(), always_xy=True)


@lru_cache(maxsize=64)
def _vertical(crs: str) -> tuple[Transformer | None, str]:
    """From heights above the geoid to ellipsoidal ones by a grid, or None and the name of the grid that lacks."""
    from pyproj.transformer import TransformerGroup

    system = parse_crs(crs)
    if not system.is_compound:
        return None, ""
    base = _horizontal(crs).geodetic_crs
    assert base is not None
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        group = TransformerGroup(system, base.to_3d(), always_xy=True)
    best = group.transformers[0] if group.transformers else None
    # a PROJ string names an ellipsoid and no datum: "ballpark" is its plan then, not the grid of its heights
    if best is not None and ("ballpark" not in best.description.lower() or "vgridshift" in best.definition):
        return best, ""
    grids = [g.full_name or g.short_name for o in group.unavailable_operations for g in o.grids]
    return None, next(iter(grids), "") or geoid_file(crs)


@lru_cache(maxsize=64)
def _to_wgs84(crs: str) -> Transformer:
    from pyproj import Transformer

    base = _horizontal(crs).geodetic_crs
    assert base is not None
    return Transformer.from_crs(base.to_3d(), WGS84, always_xy=True)


@lru_cache(maxsize=64)
def _unit(crs: str) -> tuple[float, float]:
    """Metres in a unit of plan and height; for degrees a metre at the equator, good enough for steps."""
    system = parse_crs(crs)
    plan = _horizontal(crs).axis_info[0].unit_conversion_factor
    if system.is_compound:
        height = system.sub_crs_list[1].axis_info[0].unit_conversion_factor
    elif len(system.axis_info) == 3 and not (system.is_projected and crs.strip().lower().endswith(ELLIPSOID)):
        height = system.axis_info[2].unit_conversion_factor
    else:
        height = plan if system.is_projected else 1.0
    return (plan * 6378137.0 if _horizontal(crs).is_geographic else plan), height


@lru_cache(maxsize=64)
def _place(crs: str, origin: tuple[float, float, float], undulation_m: float | None) -> tuple[Array, Array]:
    at = LocalFrame(crs=crs, origin=origin, undulation_m=undulation_m)
    geographic = _geographic(at, np.array([origin]))
    return _geocentric_from_geographic(geographic, _horizontal(crs))[0], _enu_from_geocentric(geographic)[0]


def _rows(xyz: Array) -> Array:
    rows = np.asarray(xyz, float)
    if rows.ndim != 2 or rows.shape[1] != 3:
        raise InputError("crs.coordinate_shape", shape=rows.shape)
    return rows


def _geoid(frame: LocalFrame) -> Transformer | None:
    """What converts the heights of a frame; None where an undulation is given or nothing has to be converted."""
    if frame.undulation_m is not None or not parse_crs(frame.crs).is_compound:
        return None
    transformer, grid = _vertical(frame.crs)
    if transformer is None:
        raise _missing_geoid(frame.crs, grid)
    return transformer


def _geographic(frame: LocalFrame, xyz: Array) -> Array:
    """Longitude, latitude [deg] and ellipsoidal height [m] (n, 3), on the datum of the system."""
    if _horizontal(frame.crs).is_geocentric:
        return _geographic_from_geocentric(xyz, _horizontal(frame.crs))
    transformer = _geoid(frame)
    if transformer is not None:
        return _transformed(transformer, xyz)
    lon, lat = _converted(_plan(frame.crs), xyz[:, 0], xyz[:, 1]).T
    height = xyz[:, 2] * _unit(frame.crs)[1] + (frame.undulation_m or 0.0)
    result = np.stack([lon, lat, height], axis=1)
    if frame.undulation_m is not None and of_older_datum(frame.crs):
        there = _converted(_to_wgs84(frame.crs), lon, lat, height)
        result = _converted(_to_wgs84(frame.crs), there[:, 0], there[:, 1], height, inverse=True)
    return _checked(result, xyz, frame.crs)


def _geocentric_from_crs(frame: LocalFrame, xyz: Array) -> Array:
    system = _horizontal(frame.crs)
    return xyz if system.is_geocentric else _geocentric_from_geographic(_geographic(frame, xyz), system)


def _crs_from_geocentric(frame: LocalFrame, xyz: Array) -> Array:

    system = _horizontal(frame.crs)
    if system.is_geocentric:
        return xyz
    geographic = _geographic_from_geocentric(xyz, system)
    transformer = _geoid(frame)
    if transformer is not None:
        return _converted(transformer, *geographic.T, inverse=True)
    x, y = _converted(_plan(frame.crs), geographic[:, 0], geographic[:, 1], inverse=True).T
    height = geographic[:, 2]
    if frame.undulation_m is not None and of_older_datum(frame.crs):
        height = _converted(_to_wgs84(frame.crs), *geographic.T)[:, 2]
    result = np.stack([x, y, (height - (frame.undulation_m or 0.0)) / _unit(frame.crs)[1]], axis=1)
    return _checked(result, xyz, frame.crs)


def _converted(transformer: Transformer, *columns: Array, inverse: bool = False) -> Array:
    """Columns (n,) each, two or three, through pyproj: (n, as many).

    Arrays of one value are doubled: pyproj takes them for numbers where NumPy still allows that (before 2.4, with a
    warning), and then gives numbers back.
    """
    from pyproj.enums import TransformDirection

    words = {"direction": TransformDirection.INVERSE} if inverse else {}
    count = len(columns[0])
    given = (np.repeat(c, 2) if count == 1 else c for c in columns)
    transform: Any = transformer.transform  # its overloads do not show how many columns are unpacked
    return np.stack(transform(*given, **words), axis=1)[:count]


def _transformed(transformer: Transformer, xyz: Array) -> Array:
    height = np.nan_to_num(xyz[:, 2])
    result = _converted(transformer, xyz[:, 0], xyz[:, 1], height)
    result[np.isnan(xyz[:, 2]), 2] = np.nan
    return result


def _checked(result: Array, given: Array, crs: str) -> Array:
    bad = np.flatnonzero(np.isinf(result).any(axis=1))
    if len(bad):
        x, y = given[bad[0], :2]
        raise InputError("crs.not_transformed", number=bad[0], x=x, y=y, system=system_name(crs))
    return result


def _ellipsoid(system: CRS) -> tuple[float, float]:
    """Semi-major axis [m] and squared eccentricity."""
    ellipsoid = system.ellipsoid
    assert ellipsoid is not None
    f = 1 / ellipsoid.inverse_flattening if ellipsoid.inverse_flattening else 0.0
    return ellipsoid.semi_major_metre, f * (2 - f)


def _geocentric_from_geographic(geographic: Array, system: CRS) -> Array:
    a, e2 = _ellipsoid(system)
    lon, lat, h = np.radians(geographic[:, 0]), np.radians(geographic[:, 1]), geographic[:, 2]
    N = a / np.sqrt(1 - e2 * np.sin(lat) ** 2)
    plane = (N + h) * np.cos(lat)
    return np.stack([plane * np.cos(lon), plane * np.sin(lon), (N * (1 - e2) + h) * np.sin(lat)], axis=1)


def _geographic_from_geocentric(xyz: Array, system: CRS) -> Array:
    """Fixed-point iteration on the latitude; converges to 1e-13 rad within a few steps for any height on earth."""
    a, e2 = _ellipsoid(system)
    plane = np.hypot(xyz[:, 0], xyz[:, 1])
    lat = np.arctan2(xyz[:, 2], plane * (1 - e2))
    for _ in range(10):
        N = a / np.sqrt(1 - e2 * np.sin(lat) ** 2)
        lat = np.arctan2(xyz[:, 2] + e2 * N * np.sin(lat), plane)
    N = a / np.sqrt(1 - e2 * np.sin(lat) ** 2)
    h = plane * np.cos(lat) + xyz[:, 2] * np.sin(lat) - a * a / N
    return np.stack([np.degrees(np.arctan2(xyz[:, 1], xyz[:, 0])), np.degrees(lat), h], axis=1)


def _enu_from_geocentric(geographic: Array) -> Array:
    """Rotations (n, 3, 3) from geocentric axes to east, north, up."""
    lon, lat = np.radians(geographic[:, 0]), np.radians(geographic[:, 1])
    so, co, sa, ca = np.sin(lon), np.cos(lon), np.sin(lat), np.cos(lat)
    rows = [[-so, co, np.zeros_like(so)], [-sa * co, -sa * so, ca], [ca * co, ca * so, sa]]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def _propagated(J: Array, covariance: Array) -> Array:
    """J C J' where a row and column of NaN (an unknown height) stays NaN and the rest is right."""
    C = np.asarray(covariance, float)
    unknown = np.isnan(np.diagonal(C, axis1=-2, axis2=-1))
    filled = np.where(unknown[..., :, None] | unknown[..., None, :], 0.0, C)
    result = J @ filled @ np.swapaxes(J, -1, -2)
    return np.where(unknown[..., :, None] | unknown[..., None, :], np.nan, result)
