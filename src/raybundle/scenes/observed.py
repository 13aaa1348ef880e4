"""Image points of a scene with their derivatives: what every kind of scene hands to the adjustment."""

from __future__ import annotations

from dataclasses import dataclass

from raybundle.numerics.arrays import Array


@dataclass(frozen=True, slots=True, kw_only=True)
class Observed:
    """An image observation, predicted, with everything an adjustment asks of it."""

    xy_px: Array
    """(n, 2) pixel frame."""
    by_point: Array
    """(n, 2, 3) derivatives by the object point [px/m]."""
    by_parameters: Array
    """(n, 2, k) derivatives by the scene's own parameters."""
