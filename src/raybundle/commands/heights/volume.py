"""`raybundle heights volume`: volumes and areas, with standard deviations."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.commands.heights.common import CELLS_FILLED, HeightsSettings
from raybundle.errors import InputError
from raybundle.settings import ANY, POSITIVE, option, setting

if TYPE_CHECKING:
    from raybundle.surfaces.volumes import Volume

RIM = "rim"


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightsVolumeSettings(HeightsSettings):
    """Of what the volume is taken."""

    outline: tuple[str, ...] = setting(
        (), "Area: a file (GeoJSON, KML, CSV, what OGR reads) or its corners X Y, X Y, ... in the coordinates of the "
        "grid.  [default: all heights]", metavar="FILE|CORNERS",
    )  # fmt: skip
    extent: tuple[float, float, float, float] | None = setting(
        None, "A rectangle instead.", metavar="LEFT BOTTOM RIGHT TOP", limits=(ANY, ANY, ANY, ANY)
    )
    above: str = setting(
        RIM, "From where it counts: a height; the folder of another surface; or rim, the plane that fits the heights "
        "along the outline best.", metavar="HEIGHT|SURFACE|rim",
    )  # fmt: skip
    most_filled: float = setting(
        20.0, "Refuse a volume of which more than this share of the area was filled.", metavar="PERCENT",
        limits=POSITIVE,
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasuredVolume:
    """A volume."""

    volume: Volume
    unit: str
    """of lengths; empty: the scale is free"""
    base: str
    """from where it counts, in words"""


def run_volume(settings: HeightsVolumeSettings) -> MeasuredVolume:
    """The volume that the settings ask for."""
    import numpy as np  # noqa: PLC0415  (what computes is loaded after the help)

    from raybundle.io.reading.words import number_of  # noqa: PLC0415
    from raybundle.surfaces.resampled import difference  # noqa: PLC0415
    from raybundle.surfaces.volumes import volume  # noqa: PLC0415
    from raybundle.workflows.heights_read import covered_by, on_same_grid, opened  # noqa: PLC0415

    s = settings
    if s.outline and s.extent is not None:
        raise InputError(f"{option('outline')} and {option('extent')} both say where; give one of them")
    o = opened(s.source, 0.0)
    o = opened(s.source, CELLS_FILLED * o.file.cell if s.fill is None else s.fill)
    level = number_of(s.above)
    if level is None and s.above != RIM and not Path(s.above).is_dir():
        raise InputError(
            f"{option('above', s.above)} is no height, no folder of a surface, and not {RIM}; give one of them"
        )
    if level is None and s.above == RIM and not s.outline and s.extent is None:
        raise InputError(
            f"a base by the rim needs an outline; give {option('outline', 'FILE')}, or {option('above', 'HEIGHT')}"
        )
    model, words = (
        o.model,
        f"the height {level:g}" if level is not None else "the plane by the heights along the outline",
    )
    if level is None and s.above != RIM:
        model = difference(on_same_grid(o, opened(Path(s.above), s.fill or CELLS_FILLED * o.file.cell)), o.model)
        level, words = 0.0, f"the surface {s.above}"
    covered = covered_by(o, s.outline, s.extent)
    lost = (covered > 0) & ~model.known
    if lost.any():
        if not s.outline and s.extent is None:
            covered = np.where(lost, 0.0, covered)
        else:
            share = float(covered[lost].sum() / covered.sum())
            raise InputError(
                f"{share:.1%} of the area has no height: holes wider than {option('fill')} allows; fill them with a "
                "larger width, or take them out of the outline",
                file=s.source,
            )
    found = volume(model, covered, level)
    if 100 * found.filled > s.most_filled:
        raise InputError(
            f"{found.filled:.0%} of the area was filled, more than {s.most_filled:g} %; photograph what is missing, or "
            f"allow it with {option('most_filled', 100)}",
            file=s.source,
        )
    return MeasuredVolume(volume=found, unit=o.unit, base=words)
