"""Positions of a trajectory in place of those that photographs carry in their EXIF."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.geo.coordinate_systems import LocalFrame, parse_crs
from raybundle.io.photos.metadata import Gps
from raybundle.io.photos.photo import Photo
from raybundle.io.trajectories.base import Trajectory, frame_at, in_wgs84, matched
from raybundle.numerics.arrays import Array


def with_positions(
    photos: Sequence[Photo], trajectory: Trajectory, crs: str | None = None
) -> tuple[tuple[Photo, ...], tuple[str, ...]]:
    """The photographs with the positions of a trajectory, and remarks; those without one keep their own.

    crs     the system of a trajectory that shows none
    raises  InputError where the system is not known, or the positions belong to none of the photographs
    """
    trajectory = in_wgs84(trajectory, crs)
    rows = matched(trajectory, [p.name for p in photos]).tolist()
    gps = [None if row < 0 else _gps(trajectory, row) for row in rows]
    found = sum(g is not None for g in gps)
    if found == 0:
        raise InputError(
            "trajectory.no_photograph_found",
            n=len(photos),
            photograph=photos[0].name if photos else "-",
            name=trajectory.names[0] if trajectory.names else "-",
            file=trajectory.path,
        )
    changed = [
        p if g is None else replace(p, metadata=replace(p.metadata, gps=g)) for p, g in zip(photos, gps, strict=True)
    ]
    remark = phrase("position_list.used", n=found, of=len(photos), name=trajectory.path.name)
    correlated = trajectory.correlation is not None and bool((np.nan_to_num(trajectory.correlation) != 0).any())
    left = phrase("position_list.correlations", name=trajectory.path.name)
    return tuple(changed), (remark, *((left,) if correlated else ()), *trajectory.remarks)


def frame_of_positions(photos: Sequence[Photo], trajectory: Trajectory, crs: str | None = None) -> LocalFrame | None:
    """The local frame in the grid of a trajectory at the mean of these photographs; None where it is in degrees.

    crs     the system of a trajectory that names none
    """
    system = trajectory.crs or crs
    if system is None or parse_crs(system).is_geographic:
        return None
    rows = matched(trajectory, [p.name for p in photos])
    return frame_at(system, trajectory, rows[rows >= 0])


def _gps(trajectory: Trajectory, row: int) -> Gps | None:
    place: Array = trajectory.xyz[row]
    longitude, latitude, height = (float(v) for v in place)
    if math.isnan(longitude) or math.isnan(latitude):
        return None
    east, north, up = (float(v) for v in trajectory.sigma[row])
    correlated = any(v > 0 for v in (east, north, up))
    known = not math.isnan(height)
    return Gps(
        latitude_deg=latitude,
        longitude_deg=longitude,
        altitude_m=height if known else None,
        altitude_reference="ellipsoid" if known else "",
        sigma_m=(east, north, up) if correlated else None,
        fix=trajectory.fix[row] if trajectory.fix else "",
    )
