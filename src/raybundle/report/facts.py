"""What is known of the photographs that an adjustment comes from, for the report."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class PhotoFact:
    """A photograph as it was given."""

    name: str
    """The id of its image in the block"""
    camera: str
    width_px: int
    height_px: int
    taken: str = ""
    """Date and time, in words"""
    device: str = ""
    """Make and model"""
    position: str = ""
    """What it states about where it was taken, in words, as "GPS" or "RTK"; empty: nothing"""


@dataclass(frozen=True, slots=True, kw_only=True)
class CameraFact:
    """What was known of a camera before the adjustment."""

    camera: str
    name: str
    photographs: int
    source: str
    """Where the starting camera constant comes from, in words"""
    c_px: float
    sigma_c_px: float
    """0: held, from a stored calibration"""
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class PairFact:
    """A pair of photographs that was compared."""

    first: str
    second: str
    candidates: int
    """Matches by appearance"""
    verified: int
    """Those that fit one geometry"""
    geometry: str
    """general | planar | rotation | watermark | none"""


@dataclass(frozen=True, slots=True, kw_only=True)
class StageFact:
    """What a stage of the work took."""

    name: str
    seconds: float
    cpu_seconds: float
    peak_memory_mb: float
    """Of the process up to the end of the stage"""
    from_cache: bool
    summary: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class PhotographFacts:
    """What a report states of a set of photographs beside their adjustment."""

    photographs: tuple[PhotoFact, ...]
    cameras: tuple[CameraFact, ...]
    refused: tuple[tuple[str, str], ...] = ()
    """Files that are no usable photographs, and why"""
    not_oriented: tuple[tuple[str, str], ...] = ()
    """Photographs without orientation, and why"""
    pairs: tuple[PairFact, ...] = ()
    stages: tuple[StageFact, ...] = ()
    settings: tuple[tuple[str, str], ...] = ()
    """what was asked for beside the defaults, by name"""
    sigma_px: float = math.nan
    """Standard deviation of an image coordinate, from the residuals; NaN: not known"""
