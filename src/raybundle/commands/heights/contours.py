"""`raybundle heights contours`: contour lines."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.commands.heights.common import CELLS_FILLED, HeightsSettings
from raybundle.errors import InputError
from raybundle.settings import POSITIVE, setting

if TYPE_CHECKING:
    from raybundle.surfaces.files.input import Opened
    from raybundle.surfaces.heights.contours import Contour

FORMATS = (".gpkg", ".geojson", ".dxf", ".svg")


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightsContoursSettings(HeightsSettings):
    """Which contour lines, and where they go."""

    interval: float | None = setting(
        None, "Contour interval, in the unit of the heights.", limits=POSITIVE, metavar="HEIGHT"
    )
    rough: bool = setting(False, "Keep noise in the lines: no smoothing.")
    out: tuple[Path, ...] = setting(
        (), "New files. The endings choose the formats: .gpkg, .geojson, .dxf, .svg.", metavar="FILE"
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class DrawnContours:
    """Contour lines that were written."""

    contours: tuple[Contour, ...]
    interval: float
    unit: str
    sigma: float
    """median standard deviation of a height by noise, that neighbours do not share"""
    cautions: tuple[str, ...]
    """what is to be reported of the surface itself, a sentence each"""
    files: tuple[Path, ...]


def run_contours(settings: HeightsContoursSettings) -> DrawnContours:
    """The contour lines that the settings ask for, written."""
    import numpy as np

    from raybundle.io.folders import new_files
    from raybundle.surfaces.files.contours import write_contours
    from raybundle.surfaces.files.input import opened
    from raybundle.surfaces.heights.contours import contours, smoothed

    s = replace(settings, out=tuple(dict.fromkeys(settings.out)))
    if s.interval is None:
        raise InputError("option.missing", setting="interval", value="HEIGHT")
    if not s.out:
        raise InputError("option.missing", setting="out", value="FILE")
    for path in s.out:
        if path.suffix.lower() not in FORMATS:
            raise InputError("file.suffix", known=list(FORMATS), file=path)
    o = opened(s.source, 0.0)
    o: Opened = opened(s.source, CELLS_FILLED * o.file.cell if s.fill is None else s.fill)
    height = o.model.heights.height if s.rough else smoothed(o.model)
    found = contours(height, s.interval)
    if not found:
        known = o.model.heights.height[o.model.known]
        raise InputError(
            "contours.none",
            low=float(known.min()),
            high=float(known.max()),
            interval=s.interval,
            file=s.source,
        )
    for path in s.out:
        with new_files(path) as (new,):
            write_contours(o, found, s.interval, new)
    sigma = float(np.median(o.model.heights.local[o.model.known]))
    return DrawnContours(
        contours=found, interval=s.interval, unit=o.unit, sigma=sigma, cautions=o.cautions, files=s.out
    )
