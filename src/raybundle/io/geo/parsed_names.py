"""Coordinate systems as files and messages name them."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

from raybundle.io.geo.parsed_systems import parse_crs

if TYPE_CHECKING:
    from pyproj import CRS


@lru_cache(maxsize=64)
def parsed_system(crs: str) -> CRS:
    """The system of a text; of the register of EPSG where it is one of it under another name, as PROJ strings are.

    Of a projected system in three dimensions the plan, which the register has and which programs know.
    raises  InputError as `parse_crs`
    """
    from pyproj import CRS

    system = parse_crs(crs)
    if system.is_projected and len(system.axis_info) == 3 and not system.is_compound:
        system = system.to_2d()
    code = None if system.is_compound or system.is_bound else system.to_epsg()
    found = system if code is None else CRS.from_epsg(code)
    return found if found.equals(system, ignore_axis_order=True) else system


def system_with_heights(crs: str) -> CRS | None:
    """A projected system with what its heights count from: compound, or in three dimensions above the ellipsoid.

    None where the text states nothing of heights, and where a geoid of its own is tied to it, which files do not hold.
    """
    system = parse_crs(crs)
    if system.is_bound or plan_system(crs) is None:
        return None
    if system.is_compound:
        return None if any(part.is_bound for part in system.sub_crs_list) else parsed_system(crs)
    return parsed_system(crs).to_3d() if len(system.axis_info) == 3 else None


def plan_system(crs: str) -> CRS | None:
    """The plan part of a system, for pictures in it; None where its coordinates are no lengths in a plane."""
    system = parsed_system(crs)
    if system.is_compound:
        system = system.sub_crs_list[0]
    return system if system.is_projected else None
