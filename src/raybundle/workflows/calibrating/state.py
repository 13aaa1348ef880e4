"""What a run of `calibrate` knows, stage by stage; each stage of `workflows.calibrating.stages` gives some of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.calibration.eccentricity import RadiusScale
from raybundle.calibration.quality import CalibrationQuality
from raybundle.cameras.opencv import OpenCVCamera
from raybundle.io.photos.cameras import CameraGroup
from raybundle.io.photos.photo import Found, Photo
from raybundle.numerics.counting import counted
from raybundle.pipeline.stage import Workflow
from raybundle.targets.marks import Marks, Target
from raybundle.workflows.calibrating.options import CalibrateOptions
from raybundle.workflows.calibrating.recognise import Recognised
from raybundle.workflows.calibrating.target_block import TargetBlock
from raybundle.workflows.stage_arrays import Reasons


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Calibration:
    """What came of the photographs."""

    adjustment: Adjustment
    quality: tuple[CalibrationQuality, ...]
    photos: tuple[Photo, ...]
    groups: tuple[CameraGroup, ...]
    refused: tuple[tuple[str, str], ...]
    """files that are no usable photographs, and why"""
    not_used: tuple[tuple[str, str], ...]
    """photographs without a part in the result, and why"""
    marks: tuple[tuple[Marks, ...], ...]
    """of each photograph, one set for each family"""
    targets: tuple[Target, ...]
    completed: int
    """dots without a readable name that were used all the same"""
    dots: int
    """object points that are dots without a code"""
    largest_eccentricity_px: float
    radius: RadiusScale | None = None
    """What the eccentricities say of the targets' radii; None where nothing is round"""
    kept: tuple[str, ...] = ()
    """what became of each camera in the camera library, in words, where that was asked for"""
    seconds: Mapping[str, float] = field(default_factory=dict[str, float])
    """what each stage took, in their order"""

    def __repr__(self) -> str:
        """One line."""
        line = "; ".join(f"camera {q.camera}: {q.headline}" for q in self.quality) or repr(self.adjustment)
        return f"<Calibration by {self.used} of {counted(len(self.photos), 'photograph')}: {line}>"

    def _repr_html_(self) -> str:
        """For notebooks: that of its adjustment."""
        return self.adjustment._repr_html_()  # pyright: ignore[reportPrivateUsage]

    def opencv(self, camera: str | None = None, *, coefficients: int | None = None) -> OpenCVCamera:
        """A camera as OpenCV has it, with its covariance: see `Adjustment.opencv`."""
        return self.adjustment.opencv(camera, coefficients=coefficients)

    @property
    def used(self) -> int:
        """Number of photographs that take part."""
        return len(np.unique(self.adjustment.given.observations.image))


@dataclass(frozen=True, slots=True, kw_only=True)
class Start:
    """Targets as a block, with approximate values."""

    given: TargetBlock
    approximate: Block
    lost: Reasons
    notices: tuple[Notice, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Adjusted:
    """What the adjustment gives."""

    adjustment: Adjustment
    groups: tuple[CameraGroup, ...]
    lost: Reasons
    completed: int = 0
    dots: int = 0
    largest_eccentricity_px: float = 0.0
    radius: RadiusScale | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrateState:
    """What a run knows."""

    inputs: tuple[Path, ...]
    options: CalibrateOptions
    found: Found | None = None
    refused: Reasons = ()
    shown: Recognised | None = None
    """what was recognised where nobody stated what was photographed"""
    targets: tuple[Target, ...] = ()
    groups: tuple[CameraGroup, ...] = ()
    marks: tuple[tuple[Marks, ...], ...] = ()
    """of each photograph, one set for each family"""
    start: Start | None = None
    adjusted: Adjusted | None = None
    quality: tuple[CalibrationQuality, ...] = ()

    @property
    def photos(self) -> tuple[Photo, ...]:
        """The photographs, which are found."""
        assert self.found is not None
        return self.found.photos

    @property
    def begun(self) -> Start:
        """The start, which was made."""
        assert self.start is not None
        return self.start


CALIBRATE: Workflow[CalibrateState] = Workflow("calibrate")
"""The stages, each in a module of `workflows.calibrating.stages`"""
