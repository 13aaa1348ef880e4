"""`raybundle heights ground`: a terrain model."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from raybundle.commands.heights.common import HeightsSettings
from raybundle.errors import InputError
from raybundle.settings import POSITIVE, setting

SHARE = 0.1
"""Of the longer side, that the largest thing on the ground is taken for where nobody states it"""


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightsGroundSettings(HeightsSettings):
    """How the ground is distinguished from what stands on it."""

    largest: float | None = setting(
        None, "Width of the largest object on the ground, in the unit of the heights.  [default: a tenth of the "
        "longer side]", limits=POSITIVE, metavar="WIDTH",
    )  # fmt: skip
    slope: float = setting(15.0, "Steepest slope of the ground.", limits=POSITIVE, metavar="PERCENT")
    out: Path | None = setting(None, "New folder.  [default: SURFACE/ground]", metavar="FOLDER")


@dataclass(frozen=True, slots=True, kw_only=True)
class MadeGround:
    """A terrain model that was written."""

    folder: Path
    unit: str
    standing: float
    """share of the heights that stand on the ground"""
    filled: float
    """share of the ground that was spanned between the rest"""
    sigma: float
    """median standard deviation of measured ground"""
    filled_sigma: float
    """of the spanned one"""
    cautions: tuple[str, ...]
    """what is to be reported of the surface itself, a sentence each"""


def run_ground(settings: HeightsGroundSettings) -> MadeGround:
    """The terrain model that the settings ask for, written."""
    import numpy as np

    from raybundle.io.folders import check_new_folder
    from raybundle.surfaces.files.heights import write_model
    from raybundle.surfaces.files.input import opened
    from raybundle.surfaces.heights.hole_filling import filled
    from raybundle.surfaces.heights.terrain_filter import ground

    s = settings
    o = opened(s.source, 0.0)
    out = s.out or s.source / "ground"
    check_new_folder(out)
    f = o.file
    longer, shorter = max(f.width, f.height) * f.cell, min(f.width, f.height) * f.cell
    largest = s.largest or SHARE * longer
    if largest > shorter / 2:
        raise InputError(
            "terrain.object_too_wide",
            largest=float(largest),
            side=float(shorter),
            file=s.source,
        )
    height = o.model.heights.height[o.model.known]
    reach = float(height.max() - height.min())
    if largest < f.cell:
        raise InputError(
            "terrain.object_below_cell",
            largest=float(largest),
            cell=float(f.cell),
            file=s.source,
        )
    if s.slope / 100 * f.cell > reach:
        raise InputError(
            "terrain.slope_too_large",
            slope=float(s.slope),
            rise=s.slope / 100 * f.cell,
            range=reach,
            file=s.source,
        )
    found, stands = ground(o.model, largest / f.cell, s.slope / 100)
    if not found.known.any():
        raise InputError("terrain.no_ground", file=s.source)
    widest = largest if s.fill is None else s.fill
    found = filled(found, widest / f.cell / 2) if widest else found
    out.mkdir(parents=True, exist_ok=True)
    write_model(found, f, out)
    was = found.holes.filled if found.holes is not None else np.zeros(stands.shape, bool)
    measured = found.known & ~was
    sigma = [float(np.median(found.sigma[m])) if m.any() else float("nan") for m in (measured, was)]
    return MadeGround(
        folder=out, unit=o.unit, standing=float(stands.sum() / o.model.known.sum()),
        filled=float(was.sum() / found.known.sum()), sigma=sigma[0], filled_sigma=sigma[1], cautions=o.cautions,
    )  # fmt: skip
