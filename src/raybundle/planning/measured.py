"""What is measured in photographs, how precisely, and how often it is found: what a plan counts with beforehand."""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from raybundle.numerics.arrays import Array


@dataclass(frozen=True, slots=True, kw_only=True)
class Measured:
    """A class of points in photographs as a camera records them, at its full format."""

    name: str
    about: str
    sigma_px: float
    """Standard deviation of an image coordinate"""
    source: str
    """Where the figures come from"""
    most: float = 1.0
    """Share of the photographs that show a point squarely in which it is found"""
    half_deg: float = 90.0
    """Angle of incidence at which it is found half as often"""
    width_deg: float = 8.0
    """Degrees within which that changes"""

    def found(self, cosine: Array) -> Array:
        """Share of photographs (n,) in which points are found, by the cosines (n,) of their rays to the normal."""
        if self.half_deg >= 90:
            return np.full(np.shape(cosine), self.most)
        angle = np.degrees(np.arccos(np.clip(cosine, -1, 1)))
        return self.most / (1 + np.exp((angle - self.half_deg) / self.width_deg))


_KINDS = (
    Measured(
        name="retro", about="retro-reflective targets of 5 px and more, by flash", sigma_px=0.025,
        source="1/30 to 1/50 px (Fraser 1997; Luhmann and others 2013)",
    ),
    Measured(
        name="targets", about="printed coded targets of 10 px and more", sigma_px=0.05,
        source="1/10 to 1/30 px; calibrations of printed targets, benchmarks/plan_classes.py",
    ),
    Measured(
        name="dots", about="small or soft targets, corners of boards", sigma_px=0.1,
        source="calibrations of boards and sheets, benchmarks/plan_classes.py",
    ),
    Measured(
        name="natural", about="natural points, matched by least squares", sigma_px=0.25,
        source="median of six orientations, 0.13 to 0.30 px, benchmarks/plan_classes.py", most=0.84, half_deg=64,
        width_deg=13,
    ),
    Measured(
        name="phone", about="natural points in photographs of a phone, or much compressed ones", sigma_px=0.68,
        source="two orientations, 0.48 and 0.88 px, benchmarks/plan_classes.py", most=0.62, half_deg=56, width_deg=8,
    ),
    Measured(name="hand", about="points clicked by hand", sigma_px=0.5, source="as `raybundle mark` takes clicks"),
)  # fmt: skip
FREE_CAMERA = (2.5, 5.7)
"""Times that results stated of natural points what a plan promises where the camera is calibrated with the object
(medians of four sets, benchmarks/plan_achieved.py): smooth errors of image points that all photographs share go into
the camera, and a plan knows nothing of them.  With a camera that is held: 0.95 to 1.12 (three sets)."""
measured_kinds = MappingProxyType({m.name: m for m in _KINDS})
"""By their names"""
