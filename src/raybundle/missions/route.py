"""The way of one battery as vehicles take it: latitude, longitude, height above the take-off, degrees."""

from __future__ import annotations

from dataclasses import dataclass

from raybundle.missions.mission import TriggerBy
from raybundle.numerics.arrays import Array


@dataclass(frozen=True, slots=True, kw_only=True)
class Route:
    """What formats of flight plans hold."""

    name: str
    home: tuple[float, float, float]
    """latitude, longitude [deg], height of the ground at the take-off [m]"""
    latitude_deg: Array
    """(n,) WGS 84"""
    longitude_deg: Array
    """(n,)"""
    height: Array
    """(n,) above the ground at the take-off [m]"""
    heading_deg: Array
    """(n,) of the camera, from true north, 0 to 360; NaN where a format does not hold it"""
    pitch_deg: Array
    """(n,) of the gimbal: 0 to the horizon, -90 to the nadir; NaN where a format does not hold it"""
    speed: Array
    """(n,) [m/s]; NaN where a format does not hold it"""
    trigger: Array
    """(n,) `Trigger`"""
    base: Array
    """(n,) metres between photographs from a START on; NaN elsewhere"""
    trigger_by: TriggerBy = "distance"
    codes: tuple[int, int, int] | None = None
    """of vehicle, variant and camera in DJI's WPML"""
    above_ground: Array | None = None
    """(n,) above the ground below [m], where it is known"""
    vehicle: str = ""

    def __len__(self) -> int:
        """Number of way points."""
        return len(self.height)
