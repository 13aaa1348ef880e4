"""What `orient` can be asked for."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from raybundle.adjustment.records.options import NoiseModel
from raybundle.placing.attitudes import Convention
from raybundle.scenes.bias import BiasKind
from raybundle.ties.start import StartMethod

PIXELS_GB = 4.0
"""Memory that image pixels take unasked while points are measured."""


@dataclass(frozen=True, slots=True, kw_only=True)
class OrientOptions:
    """How photographs are oriented.  The defaults need no change."""

    features: str = "rootsift"
    """feature method"""
    feature_count: int = 10_000
    """features of a photograph, at most"""
    start: StartMethod = "auto"
    """growing: image by image; averaging: all pairs at once; parts: leaves by growing, joined; auto: growing, parts
    where there are very many photographs, averaging where that leaves images"""
    precise: bool = True
    """False leaves out least-squares matching: quick, and several times less precise"""
    jobs: int = 0
    """photographs or pairs worked on at the same time; 0 = processors"""
    cluster: str = ""
    """who does features and pairs, as `pipeline.choosing` takes it; empty: this process"""
    store: str = ""
    """where products lie, as `Project.open` takes it"""
    memory_gb: float = 0.0
    """memory that image pixels may take while points are measured, and an adjustment; 0: PIXELS_GB, and four fifths of
    what is free"""
    separate: tuple[str, ...] = ()
    """patterns of photographs' names, each a camera apart"""
    library: Path | None = None
    """camera library whose calibrations are held where none is given; None: none is used"""
    masks: Path | None = None
    """folder of masks, as COLMAP or Metashape name them: 0 where a photograph is not to be measured in"""
    targets: tuple[str, ...] = ()
    """families of coded targets that are measured: named points, or those of the control"""
    scene_bias: BiasKind = "shift"
    """what is estimated of a satellite scene's RPC: none, shift, drift, affine"""
    crs: str | None = None
    """coordinate system of positions in a grid and, where there are scenes, of control files that name none"""
    attitudes: Convention = "auto"
    """attitudes that are observed, by their convention; auto: what there is with standard deviations"""
    attitude_sigma_deg: tuple[float, float] | None = None
    """about level axes and about the vertical, of attitudes that state none; also asks for those of the gimbal"""
    relative: Literal["", "shift", "drift"] = ""
    """relative aerial control: positions and attitudes of a flight line count by their differences alone, or also after
    a drift; "": they count as they are"""
    noise: NoiseModel = "auto"
    """errors of image coordinates: white; fields: smooth ones that differ from image to image, and a floor; auto:
    fields where there are five photographs or more"""
    read_out_s: float | None = None
    """read-out time of rolling shutters [s]; 0: there are none; None: what the photographs show decisively"""
    redo_from: str = ""
    """stage, as `raybundle status` names it, from which on everything is done again"""
