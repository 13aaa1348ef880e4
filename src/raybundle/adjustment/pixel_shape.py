"""What the pixels of a sensor can have of affinity and shear, and values beyond that.

Rows and columns stand at right angles and at equal distances by lithography.  Residuals that ask for more are the
symptom of something else that the model lacks, or of photographs that say too little; believed, it moves the principal
point and the camera constant.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from raybundle.adjustment.result import Adjustment, Notice
from raybundle.adjustment.severity import Severity
from raybundle.block import Camera

LIMIT = 1e-4
"""Affinity and shear that a sensor may have."""
ROUNDED = 0.5
"""Pixels by which each side of a picture that was made smaller is rounded: its pixels are that much less square."""
SIGNIFICANT = 2.6
"""Standard deviations beyond the limit from which a value is no chance (99 percent)."""
UNTOLD = 0.01
"""Error of projection, in half diagonals of the format, from which on nothing is told of a camera."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Beyond:
    """An affinity or a shear that no sensor has."""

    camera: str
    symbol: str
    excess: float
    """of its size by the limit"""
    notice: Notice


def shape_limit(camera: Camera, symbol: str) -> float:
    """Largest believable value of a parameter of the kind affinity.

    Of a picture whose sides were rounded to whole pixels when it was made smaller, the pixels are less square by half a
    pixel of each side; its rows and columns stay at right angles.
    """
    meaning = next(p.meaning for p in camera.sensor.parameters if p.symbol == symbol)
    return LIMIT + (0.0 if meaning == "shear" else ROUNDED * (1 / camera.width_px + 1 / camera.height_px))


def beyond_sensor(result: Adjustment, cameras: Sequence[str]) -> Beyond | None:
    """The affinity or shear of these cameras that is farthest beyond what a sensor has, significantly; else None.

    It is a fault where it would move image points by more than the share UNTOLD of the half diagonal, as it does where
    the affinity is as large: the rest of the interior orientation is nonsense then, too.
    """
    found: list[Beyond] = []
    for interior in result.interior:
        if interior.camera not in cameras:
            continue
        camera = next(c for c in result.given.cameras if c.id == interior.camera)
        for p in camera.sensor.parameters:
            value = interior.parameters.get(p.symbol)
            if p.kind != "affinity" or p.symbol not in interior.free or value is None or not value.std:
                continue
            limit = shape_limit(camera, p.symbol)
            size = abs(value.value)
            if size - limit <= SIGNIFICANT * value.std:
                continue
            reason = (
                f"the residuals ask for {'a shear' if p.meaning == 'shear' else 'an affinity'} {p.symbol} of "
                f"{value.value:.1e} ± {value.std:.0e}, which no sensor has (limit {limit:.0e}); it is held. Something "
                "else is not in the model, as motion during the read-out or uneven light on the targets, or the "
                "photographs say too little; standard deviations may be too small. Of a scan or an old camera it is "
                "believed where it is asked for by name"
            )
            notice = Notice(
                code="pixel_shape", message=f"camera {camera.id}: {reason}", ids=(camera.id, p.symbol), reason=reason,
                measured=Severity.FAULT if size > UNTOLD else Severity.CAUTION,
            )  # fmt: skip
            found.append(Beyond(camera=camera.id, symbol=p.symbol, excess=size / limit, notice=notice))
    return max(found, key=lambda b: b.excess, default=None)
