"""Cameras of a result as a calibration that later adjustments take."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from raybundle.adjustment.result import Adjustment
from raybundle.block import Camera
from raybundle.block.stored import observed_jointly
from raybundle.calibration.quality import CalibrationQuality
from raybundle.io.calibrations.ours import cameras_text


def stored_camera(adjustment: Adjustment, camera: Camera, qualities: Sequence[CalibrationQuality]) -> Camera:
    """An adjusted camera as a calibration: observed with its covariance; free where it could not be determined."""
    interior = next((i for i in adjustment.interior if i.camera == camera.id and i.image is None), None)
    precision = adjustment.precision
    plain = replace(camera, estimate=(), sigma={}, relations=(), calibrated=None)
    if any(q.camera == camera.id and q.grade == "not determinable" for q in qualities):
        return replace(plain, estimate="auto")
    if interior is None or precision is None or not interior.free:
        return plain
    return observed_jointly(plain, interior.free, precision.interior[camera.id])


def calibration_text(adjustment: Adjustment, qualities: Sequence[CalibrationQuality]) -> str:
    """calibration.toml of an adjustment, with the verdict on each camera as a comment."""
    cameras = [stored_camera(adjustment, c, qualities) for c in adjustment.adjusted.cameras]
    verdicts = "".join(f"# {q.camera}: {q.headline}\n" for q in qualities)
    return f"{verdicts}\n{cameras_text(cameras)}"
