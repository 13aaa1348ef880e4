"""An optical bar: a lens that sweeps across the track and writes on film, as in KH-4B and KH-9.

Column x is taken at time t(x) along the angle alpha = (x - x0) p / f from the middle of the sweep:

    w = (f sin alpha, (y - y0) p + m f v / (H rate) sin alpha, f cos alpha)

v the speed, H the height above the mean ground, rate that of the sweep [rad/s]: the film moves with the image of the
ground while the lens sweeps (factor m; 0 where it stands still).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.scenes.scan import ScanScene

STEEPEST_RAD = 1.4
"""Angle of the sweep up to which tangents stand for it."""


@dataclass(frozen=True, kw_only=True, eq=False)
class OpticalBar(ScanScene):
    """A sweep of an optical bar."""

    first_s: float
    """Time at the left edge of the image, of the trajectory's clock"""
    column_s: float
    """From column to column; negative where the sweep goes to the left"""
    centre_px: Array
    """(2,) x0, y0"""
    angle_px: float
    """p / f, the angle of a pixel [rad]"""
    motion: float
    """m v / rate [m]: the film's motion is this over H, times sin alpha"""
    ground_radius_m: float
    """Of the mean ground, from the middle of the body"""

    def __post_init__(self) -> None:
        """Refuse sweeps beyond the horizon."""
        widest = np.abs((np.array([0.0, self.width_px]) - self.centre_px[0]) * self.angle_px).max()
        if not widest < STEEPEST_RAD:
            raise InputError(
                "optical_bar.sweep", degrees=float(np.degrees(widest)), limit=float(np.degrees(STEEPEST_RAD))
            )
        ends = self.first_s + self.column_s * np.array([0.0, self.width_px])
        self.trajectory.check_cover(float(ends.min()), float(ends.max()))

    @cached_property
    def middle_and_half(self) -> tuple[float, float]:  # pyright: ignore[reportIncompatibleMethodOverride]
        """Of the sweep."""
        return self.first_s + self.column_s * self.width_px / 2, self.column_s * self.width_px / 2

    def time_at(self, xy: Array, part: Index | None = None) -> tuple[Array, Array]:
        """As `ScanScene`."""
        del part
        by = np.zeros((len(xy), 2))
        by[:, 0] = self.column_s
        return self.first_s + self.column_s * xy[:, 0], by

    def look_at(self, xy: Array, part: Index | None = None) -> tuple[Array, Array]:
        """As `ScanScene`."""
        t, _ = self.time_at(xy, part)
        P, V, _ = self.trajectory.position(t)
        far = np.linalg.norm(P, axis=1)
        height, rising = far - self.ground_radius_m, np.sum(P * V, axis=1) / far * self.column_s
        alpha, y = ((xy - self.centre_px) * self.angle_px).T
        s, c = np.sin(alpha), np.cos(alpha)
        film = y + self.motion / height * s
        film_x = self.motion / height * (c * self.angle_px - s * rising / height)
        by = np.zeros((len(xy), 2, 2))
        by[:, 0, 0] = self.angle_px / c**2
        by[:, 1, 0] = film_x / c + film * s / c**2 * self.angle_px
        by[:, 1, 1] = self.angle_px / c
        return np.stack([s / c, film / c], axis=1), by
