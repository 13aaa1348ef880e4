"""What a lens shows sharply: depth of field, hyperfocal distance, and where diffraction takes over."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError

WAVELENGTH_MM = 0.00055
"""Green light"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Optics:
    """How a lens is set."""

    f_number: float = 8.0
    focus: float = float("inf")
    """Object distance to which it is focused [m]"""
    blur_px: float = 1.5
    """Largest circle of confusion: what is blurred by more is not measured"""

    def __post_init__(self) -> None:
        """Raise InputError for what no lens has."""
        for word, value in (("f_number", self.f_number), ("focus", self.focus), ("blur_px", self.blur_px)):
            if not value > 0:
                raise InputError("lens.not_positive", entry=word, value=value)

    def hyperfocal(self, c_mm: float, pixel_mm: float) -> float:
        """Distance [m] from which on all is sharp where the lens is focused there: c^2 / (N u) + c.

        c_mm  focal length, for which the camera constant of a lens focused far away stands
        """
        return (c_mm**2 / (self.f_number * self.blur_px * pixel_mm) + c_mm) / 1000

    def depth_of_field(self, c_mm: float, pixel_mm: float) -> tuple[float, float]:
        """Nearest and farthest distance [m] that is sharp; farthest infinite from the hyperfocal distance on.

        raises  InputError where the lens cannot focus so near
        """
        f, h = c_mm / 1000, self.hyperfocal(c_mm, pixel_mm)
        if self.focus <= f:
            raise InputError("lens.focus_too_near", c_mm=c_mm, focus_m=self.focus)
        if np.isinf(self.focus):
            return h, float("inf")
        near = h * self.focus / (h + (self.focus - f))
        far = h * self.focus / (h - (self.focus - f)) if h > self.focus - f else float("inf")
        return near, far


def best_focus(near: float, far: float) -> float:
    """Focus distance [m] whose depth of field has these ends for some f-number: their harmonic mean."""
    return 2 / (1 / near + 1 / far)
