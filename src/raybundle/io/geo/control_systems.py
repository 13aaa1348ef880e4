"""The coordinate system of control that stands in several files."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.errors import InputError, Text, note
from raybundle.io.geo.areas import check_area
from raybundle.io.geo.control_files import ControlFile
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.io.geo.parsed_systems import is_plan, parse_crs, plan_of, system_name
from raybundle.numerics.arrays import Array

MAP_M = 1e5
"""From zero, in plan: no site's own axes begin so far away, and grids add such numbers lest coordinates be negative."""


DEGREES = np.array([180.0, 90.0])
OFFSET = 1000.0
"""Extents of a site by which both of its coordinates lie from zero where they are degrees: up to 5 km at 45 degrees.
Axes of one's own begin at the site."""


def like_degrees(xy: Array) -> bool:
    """Whether places (n, 2) can only be longitude and latitude [deg], in either order: small and hardly different."""
    known = xy[np.isfinite(xy).all(axis=1)]
    if len(known) < 2:
        return False
    middle, wide = np.abs(known.mean(axis=0)), float((known.max(axis=0) - known.min(axis=0)).max())
    within = (middle < DEGREES).all() or (middle < DEGREES[::-1]).all()
    return bool(within and 0 < wide < 1 and (middle > OFFSET * wide).all())


def check_degrees(files: Sequence[ControlFile]) -> None:
    """Raise InputError for longitude and latitude in a file without a coordinate system: they would be metres."""
    for f in files:
        if f.crs is None and like_degrees(f.xyz[:, :2]):
            x, y = np.nanmedian(f.xyz[:, :2], axis=0).tolist()
            raise InputError("control_file.degrees", x=x, y=y, file=f.path)


def in_one_system(files: Sequence[ControlFile], crs: str | None = None) -> tuple[ControlFile, ...]:
    """The files, of which those that name no coordinate system stand in that of the others, or else in `crs`.

    crs     the system that the user names, also of heights of which a file with the same plan has none; None: none
    raises  InputError for coordinates that no use of `crs` has
    A remark states in what they are taken, beside files with a system where their coordinates do not lie among the
    others', by which one sees that it is the same.
    """
    if crs is not None:
        files = tuple(_with_heights(f, crs) for f in files)
    systems = {f.crs for f in files if f.crs}
    if not systems:
        return tuple(_in_named(f, crs) for f in files)
    if len(systems) > 1:
        return tuple(files)
    (known,) = systems
    around = np.vstack([f.xyz[:, :2] for f in files if f.crs])
    others = [f.path.name for f in files if f.crs]
    found: list[ControlFile] = []
    for f in files:
        if f.crs is None and np.isfinite(f.xyz).any():
            assumed = note("control_file.system_of_others", name=f.path.name, others=others, system=system_name(known))
            beyond = check_area(known, f.xyz[:, :2], f.path)
            more = () if _among(f.xyz[:, :2], around) else (Text.of(assumed), *beyond)
            f = replace(f, crs=known, remarks=(*f.remarks, *more))  # noqa: PLW2901
        found.append(f)
    return tuple(found)


def sigma_in_metres(control: ControlFile) -> Array:
    """(n, 3) standard deviations [m] of a file: what it states in a unit of its system, what was assumed as it is.

    Of longitude and latitude they are metres already.
    """
    if control.crs is None or control.reported is None or parse_crs(control.crs).is_geographic:
        return control.sigma
    at = np.nanmean(np.where(np.isfinite(control.xyz), control.xyz, np.nan)[:, :2], axis=0)
    plan, height = local_frame(control.crs, (*at.tolist(), 0.0)).units_m
    return np.where(control.reported, control.sigma * [plan, plan, height], control.sigma)


def _with_heights(file: ControlFile, crs: str) -> ControlFile:
    """A file that names a system in plan alone, in `crs` where that is the same and states what heights count from."""
    if file.crs is None or file.crs == crs or is_plan(crs) or not is_plan(file.crs):
        return file
    return replace(file, crs=crs) if plan_of(crs).equals(plan_of(file.crs)) else file


def _in_named(file: ControlFile, crs: str | None) -> ControlFile:
    """A file without a system in the one that the user names; a remark on coordinates of a map that nobody named."""
    xy = file.xyz[np.isfinite(file.xyz[:, :2]).all(axis=1), :2]
    if not len(xy):
        return file
    x, y = np.median(xy, axis=0).tolist()
    if crs is None:
        if max(abs(x), abs(y)) < MAP_M:
            return file
        assumed = note("control_file.cartesian_assumed", name=file.path.name, x=x, y=y)
        return replace(file, remarks=(*file.remarks, Text.of(assumed)))
    check_area(crs, xy, file.path, named=True)
    taken = note("control_file.system_given", name=file.path.name, system=system_name(crs))
    return replace(file, crs=crs, remarks=(*file.remarks, Text.of(taken)))


def _among(xy: Array, around: Array) -> bool:
    """Whether places (n, 2) lie within the extent of others (m, 2), or beside it by no more than it is wide."""
    known = around[np.isfinite(around).all(axis=1)]
    if not len(known):
        return False
    low, high = known.min(axis=0), known.max(axis=0)
    wide = float((high - low).max())
    own = xy[np.isfinite(xy).all(axis=1)]
    return bool(((own >= low - wide) & (own <= high + wide)).all())
