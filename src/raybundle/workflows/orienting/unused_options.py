"""What was asked for and can have no effect: refused where something is missing, stated where nothing is harmed."""

from __future__ import annotations

from collections.abc import Sequence

from raybundle.errors import InputError, phrase
from raybundle.io.geo.control_systems import check_degrees
from raybundle.io.geo.parsed_systems import parse_crs
from raybundle.io.photos.photo import Photo
from raybundle.io.trajectories import Trajectory
from raybundle.placing.marks import Given


def check_asked(
    photos: Sequence[Photo], given: Given, *, positions: Trajectory | None, crs: str | None, relative: str, scenes: bool
) -> tuple[str, ...]:
    """Remarks on options without effect.

    positions  of a file, which the photographs have by now
    scenes     whether satellite scenes take part
    raises     InputError for a coordinate system that does not exist, control in degrees without one, and where a
               lever arm or relative control is asked for of positions that nobody gave
    """
    if crs is not None:
        parse_crs(crs)
    if not scenes:
        check_degrees(given.control)
    known = given.gps and any(p.metadata.gps is not None for p in photos)
    if given.lever_arm is not None and not known:
        raise InputError("setting.needs_positions", name="lever_arm", gps=given.gps)
    if relative and not known:
        raise InputError("setting.needs_positions", name="relative", gps=given.gps)
    if crs is None or scenes or (positions is not None and positions.crs is None):
        return ()
    if any(c.crs == crs for c in given.control):
        return ()
    return (phrase("crs.without_effect", system=crs, name="none" if positions is None else positions.path.name),)
