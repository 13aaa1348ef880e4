"""What `calibrate` can be asked for."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from raybundle.adjustment.records.options import NoiseModel
from raybundle.targets.marks import Target
from raybundle.targets.sidecar import PrintedSheet


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrateOptions:
    """How cameras are calibrated.  The defaults need no change."""

    targets: tuple[str | Target, ...] = ()
    """families of what was photographed, as "aicon14" or "chessboard-9x6", or targets of one's own; (): found out"""
    sheet: PrintedSheet | None = None
    """the sheet that was photographed, by the file beside it: its family, and where its targets are, as a start"""
    separate: tuple[str, ...] = ()
    """patterns of photographs' names, each a camera apart"""
    masks: Path | None = None
    """folder of masks for natural points, which are taken where there are no targets"""
    model: str = "auto"
    """distortion model; auto: brown, or what fits a wide lens better"""
    estimate: tuple[str, ...] = ()
    """parameters that are estimated, no more and no less; (): chosen by significance and determinability"""
    spacing: float | None = None
    """distance of neighbouring points of a board [mm]; None: not known, so that lengths are in no unit"""
    jobs: int = 0
    """photographs worked on at the same time; 0 = processors"""
    dots: bool = False
    """use dots without a code, too, among coded targets"""
    eccentricity: bool = True
    """correct the centres of ellipses"""
    shear: bool = False
    """believe any affinity and shear, as of scanned pictures (`AdjustmentOptions.pixel_shape`)"""
    noise: NoiseModel = "auto"
    """errors of image coordinates: white; fields: smooth ones that differ from image to image, and a floor; auto:
    fields where there are five photographs or more"""
    split: bool = True
    """distinguish the photographs of two cameras where they cannot be of one"""
