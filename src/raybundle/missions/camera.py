"""The camera of a mission: what it covers, how finely, how quickly it can photograph again."""

from __future__ import annotations

from dataclasses import dataclass

from raybundle.block.block import Camera
from raybundle.errors import InputError
from raybundle.sensors import sensor_models


@dataclass(frozen=True, slots=True, kw_only=True)
class MissionCamera:
    """Format and camera constant, exposure, and the least time between two photographs."""

    name: str
    width_px: int
    """Of the format; this side lies across the flight"""
    height_px: int
    c_px: float
    """Camera constant"""
    pixel_mm: float = 0.0024
    exposure_s: float = 1 / 800
    interval_s: float = 1.0
    """Least time from one photograph to the next"""
    read_out_s: float | None = None
    """In which a rolling shutter reads a frame; None: a mechanical or global shutter"""
    source: str = ""
    """Where the figures come from"""

    def __post_init__(self) -> None:
        """Refuse what is no camera."""
        for what, value in (
            ("width_px", self.width_px), ("height_px", self.height_px), ("c_px", self.c_px),
            ("exposure_s", self.exposure_s), ("interval_s", self.interval_s), ("pixel_mm", self.pixel_mm),
        ):  # fmt: skip
            if not value > 0:
                raise InputError("mission_camera.not_positive", camera=self.name, entry=what, value=value)

    def distance(self, gsd: float) -> float:
        """Distance along the viewing axis [m] at which a pixel covers `gsd` [m] of a surface square to it."""
        return gsd * self.c_px

    def gsd(self, distance: float) -> float:
        """Side of a pixel [m] on a surface square to the axis at a distance [m]."""
        return distance / self.c_px

    def footprint(self, distance: float) -> tuple[float, float]:
        """Width and height [m] that the format covers of a surface square to the axis at a distance [m]."""
        return self.width_px * distance / self.c_px, self.height_px * distance / self.c_px

    def as_block_camera(self, id_: str = "1") -> Camera:
        """The same as a camera of a block: model brown, principal point in the middle, no distortion."""
        values = {**dict.fromkeys(sensor_models["brown"].symbols, 0.0), "c": self.c_px * self.pixel_mm}
        return Camera(
            id=id_, model="brown", width_px=self.width_px, height_px=self.height_px,
            pixel_mm=(self.pixel_mm, self.pixel_mm), values=values, estimate=(),
        )  # fmt: skip
