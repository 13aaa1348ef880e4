"""What carries the camera: how fast, how long, how high; and those that are known by name with their cameras."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from raybundle.errors import InputError
from raybundle.missions.camera import MissionCamera

HEIGHT_LIMIT_M = 120.0
"""Above the ground, in the open category: Commission Implementing Regulation (EU) 2019/947, Annex, part A,
UAS.OPEN.010 (2): 120 m from the closest point of the surface of the earth."""
SIGHT_M = 500.0
"""How far away a vehicle is still seen.  The regulation asks for sight (article 2 (7)) without a distance; EASA's
guidance to the same regulation makes it depend on the size of the vehicle: some 300 to 500 m for small ones."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Vehicle:
    """What a vehicle can do."""

    name: str = "multirotor"
    speed: float = 12.0
    """Greatest speed on a mission [m/s]"""
    climb: float = 4.0
    """Greatest rate of climb [m/s]"""
    descent: float = 3.0
    """Greatest rate of descent [m/s]"""
    acceleration: float = 2.0
    """From rest to speed and back [m/s2], for the time that turns take"""
    minutes: float = 25.0
    """Of flight with one battery, in calm air"""
    reserve: float = 0.25
    """Share of a battery that is kept"""
    codes: tuple[int, int, int] | None = None
    """Of vehicle, variant and camera in DJI's WPML"""
    source: str = "usual figures of a small multirotor"

    def __post_init__(self) -> None:
        """Refuse what does not fly."""
        for what in ("speed", "climb", "descent", "acceleration", "minutes"):
            if not getattr(self, what) > 0:
                raise InputError(
                    "mission.vehicle_not_positive", vehicle=self.name, entry=what, value=getattr(self, what)
                )

    @property
    def usable_s(self) -> float:
        """Seconds of flight before the reserve is touched."""
        return 60 * self.minutes * (1 - self.reserve)


def _camera(
    name: str, size: tuple[int, int], focal: float, width_mm: float, interval: float, shutter: float | None = None,
) -> MissionCamera:  # fmt: skip
    pixel = width_mm / size[0]
    return MissionCamera(
        name=name, width_px=size[0], height_px=size[1], c_px=focal / pixel, pixel_mm=pixel, interval_s=interval,
        read_out_s=shutter, source="manufacturer's data sheet: nominal focal length, good to 1 or 2 per cent",
    )  # fmt: skip


KNOWN: Mapping[str, tuple[Vehicle, MissionCamera]] = {
    v.name: (v, c)
    for v, c in (
        (
            Vehicle(
                name="phantom-4-rtk", speed=13.0, climb=6.0, descent=3.0, minutes=30,
                source="DJI, Phantom 4 RTK, specifications",
            ),
            _camera("FC6310R", (5472, 3648), 8.8, 13.2, 2.5),
        ),
        (
            Vehicle(
                name="mavic-3e", speed=15.0, climb=6.0, descent=6.0, minutes=42, codes=(77, 0, 66),
                source="DJI, Mavic 3 Enterprise, specifications",
            ),
            _camera("Mavic 3E", (5280, 3956), 12.29, 17.3, 0.7),
        ),
        (
            Vehicle(
                name="matrice-350-p1-35", speed=15.0, climb=6.0, descent=5.0, minutes=40, codes=(89, 0, 50),
                source="DJI, Matrice 350 RTK and Zenmuse P1, specifications",
            ),
            _camera("Zenmuse P1 35 mm", (8192, 5460), 35.0, 35.9, 0.7),
        ),
        (
            Vehicle(
                name="mavic-2-pro", speed=13.0, climb=4.0, descent=3.0, minutes=29,
                source="DJI, Mavic 2 Pro, specifications",
            ),
            _camera("L1D-20c", (5472, 3648), 10.26, 13.2, 2.0, 0.056),
        ),
        (
            Vehicle(
                name="air-2s", speed=13.0, climb=6.0, descent=6.0, minutes=30,
                source="DJI, Air 2S, specifications",
            ),
            _camera("FC3411", (5472, 3648), 8.4, 13.2, 2.0, 0.032),
        ),
        (
            Vehicle(
                name="mini-3-pro", speed=10.0, climb=5.0, descent=3.5, minutes=32,
                source="DJI, Mini 3 Pro, specifications",
            ),
            _camera("FC3582", (4032, 3024), 6.72, 9.7, 2.0, 0.026),
        ),
    )
}  # fmt: skip
"""Vehicles with their own cameras.  Minutes are those of the data sheets; the read-out times are those of
`io.photos.read_out_times`.  A photograph of one's own camera, or its calibration, states more than the nominal focal
length that stands here."""
