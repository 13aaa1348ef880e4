"""Frames in plane systems for blocks that are reported in degrees: what is made of squares needs one."""

from __future__ import annotations

import numpy as np

from raybundle.errors import InputError
from raybundle.io.geo.coordinate_systems import WGS84, LocalFrame, local_frame
from raybundle.io.geo.parsed_names import plan_system
from raybundle.io.geo.parsed_systems import utm_at
from raybundle.numerics.places import Local, Place

SAME_DEG, SAME_M = 1e-8, 1e-3
"""What two frames may differ by, a millimetre"""


def frame_at(place: Place | None) -> LocalFrame | None:
    """The frame of a block that stands at a place of the earth; None where it stands at none.

    raises  InputError for a frame that is not level
    """
    if place is None:
        return None
    if not isinstance(place, Local):
        raise InputError("object_frame.not_local")
    if not place.crs:
        return local_frame(WGS84, place.origin)
    return local_frame(place.crs, place.crs_origin, undulation_m=place.undulation_m)


def in_plane_system(frame: LocalFrame) -> LocalFrame:
    """The same local frame in the zone of UTM in which its origin lies; one in a plane system as it is.

    Heights count from the ellipsoid of WGS 84 then.  Beyond the latitudes of UTM, and of a datum that UTM's zones do
    not stand on, the frame stays as it is.
    """
    if plan_system(frame.crs) is not None:
        return frame
    lon, lat, h = frame.wgs84_from_local(np.zeros((1, 3)))[0].tolist()
    zone = utm_at(lon, lat)
    if zone is None:
        return frame
    zone = f"{zone}+ellipsoid"
    near = local_frame(zone, (500_000.0, 0.0 if lat >= 0 else 10_000_000.0, h))
    made = local_frame(zone, tuple(near.crs_from_local(near.local_from_wgs84(np.array([[lon, lat, h]])))[0].tolist()))
    probe = 1000.0 * np.vstack([np.zeros(3), np.eye(3)])
    off = np.abs(made.wgs84_from_local(probe) - frame.wgs84_from_local(probe))
    return made if (off < [SAME_DEG, SAME_DEG, SAME_M]).all() else frame
