"""`raybundle heights volume`: volumes and areas, with standard deviations."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.commands.heights.common import (
    CELLS_FILLED,
    MOST_FILLED,
    HeightsSettings,
    check_filled,
    filled_within,
    stable_setting,
)
from raybundle.errors import InputError
from raybundle.settings import ANY, POSITIVE, setting

if TYPE_CHECKING:
    from raybundle.surfaces.heights.alignment import Alignment
    from raybundle.surfaces.heights.volumes import Volume

RIM = "rim"


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightsVolumeSettings(HeightsSettings):
    """Of what the volume is taken."""

    outline: tuple[str, ...] = setting(
        (), "Area: a file (GeoJSON, KML, CSV, OGR formats) or its corners X Y, X Y, ... in the coordinates of the "
        "grid.  [default: all heights]", metavar="FILE|CORNERS",
    )  # fmt: skip
    extent: tuple[float, float, float, float] | None = setting(
        None, "Rectangle instead of an outline.", metavar="LEFT BOTTOM RIGHT TOP", limits=(ANY, ANY, ANY, ANY)
    )
    above: str = setting(
        RIM, "Base of the volume: a height, the folder of another surface, an older model without photographs "
        "(GeoTIFF, LAS, LAZ) that is aligned, or rim. rim: the plane that fits the heights along the outline best.",
        metavar="HEIGHT|SURFACE|FILE|rim",
    )  # fmt: skip
    stable: tuple[str, ...] = stable_setting()
    most_filled: float = setting(
        MOST_FILLED, "Reject a volume with a larger filled share of the area.", metavar="PERCENT", limits=POSITIVE
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasuredVolume:
    """A volume."""

    volume: Volume
    unit: str
    """of lengths; empty: the scale is free"""
    base: str
    """a height, the folder of a surface, or "rim": the plane by the heights along the outline"""
    cautions: tuple[str, ...]
    """what is to be reported of the surface itself, a sentence each"""
    alignment: Alignment | None
    """of an older model as base"""


def run_volume(settings: HeightsVolumeSettings) -> MeasuredVolume:
    """The volume that the settings ask for."""
    from raybundle.io.reading.words import number_of
    from raybundle.surfaces.files.input import covered_by, is_older, on_same_grid, opened, outlined
    from raybundle.surfaces.files.older import align_older
    from raybundle.surfaces.heights.hole_filling import filled
    from raybundle.surfaces.heights.resampling import difference
    from raybundle.surfaces.heights.volumes import volume

    s = settings
    if s.stable and not is_older(Path(s.above)):
        raise InputError("old_heights.not_needed", file=s.above)
    if s.outline and s.extent is not None:
        raise InputError("option.exclusive", first="outline", second="extent")
    o = opened(s.source)
    level = number_of(s.above)
    older = level is None and is_older(Path(s.above))
    if level is None and s.above != RIM and not older and not Path(s.above).is_dir():
        raise InputError("volume.base_unknown", value=s.above, rim=RIM)
    everything = not s.outline and s.extent is None
    if level is None and s.above == RIM and everything:
        raise InputError("volume.rim_needs_outline")
    cautions = o.cautions
    model, base = o.model, level
    aligned = align_older(Path(s.above), o, s.stable) if older else None
    if aligned is not None:
        model, base = difference(aligned.old, aligned.surface), 0.0
        cautions = (*cautions, *aligned.remarks)
    elif level is None and s.above != RIM:
        below = opened(Path(s.above))
        model, base = difference(on_same_grid(o, below), o.model), 0.0
        cautions = (*cautions, *below.cautions)
    areas = outlined(o, s.outline, s.extent)
    covered = None if everything else covered_by(o, areas)
    widest = CELLS_FILLED * o.file.cell if s.fill is None else s.fill
    if covered is None:
        model = filled(model, widest / o.file.cell / 2) if widest else model
        covered = model.known.astype(float)
    else:
        model = filled_within(o, model, covered, widest, s.source)
    two = level is None and s.above != RIM
    found = volume(model, covered, [r for rings in areas for r in rings] if base is None else base)
    if two:
        # what was filled below a surface, as the ground is, is no part of the surface that is missing
        own = ~o.model.known if o.model.holes is None else ~o.model.known | o.model.holes.filled
        found = replace(found, filled=float(covered[own].sum() / covered.sum()))
    check_filled(found.filled, s.most_filled, s.source)
    return MeasuredVolume(
        volume=found, unit=o.unit, base=s.above if level is None else f"{level:g}", cautions=cautions,
        alignment=None if aligned is None else aligned.alignment,
    )  # fmt: skip
