"""What `raybundle strain` is given, and what it finds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from raybundle.errors import Message
from raybundle.settings import ANY, POSITIVE, Range, setting

if TYPE_CHECKING:
    from raybundle.matching.subsets import Followed, SubsetGrid
    from raybundle.metrology.strain import AreaStrain, RigidMotion, StrainField
    from raybundle.numerics.arrays import Array


@dataclass(frozen=True, slots=True, kw_only=True)
class StrainSettings:
    """Images of a specimen, and how they are evaluated."""

    reference: Path
    """before the load"""
    deformed: tuple[Path, ...]
    """under load, in the order of time"""
    out: Path = setting(MISSING, "New folder for tables, maps and result.json.", metavar="FOLDER")
    step: int = setting(10, "Distance between subsets.", metavar="PX", limits=Range(low=1, high=1000))
    window: int = setting(31, "Side of a subset, odd.", metavar="PX", limits=Range(low=9, high=301))
    gauge: int = setting(
        5, "Subsets along the side of the plane for a strain, odd.", metavar="COUNT", limits=Range(low=3, high=51)
    )  # fmt: skip
    shape: Literal["affine", "quadratic"] = setting("affine", "Deformation within a subset.")
    extent: tuple[float, float, float, float] | None = setting(
        None, "Part of the reference image in pixels.  [default: all]", metavar="LEFT TOP RIGHT BOTTOM",
        limits=(ANY, ANY, ANY, ANY),
    )  # fmt: skip
    area: tuple[str, ...] = setting(
        (), "Mean displacement and strain of a rectangle of the reference. May be repeated.",
        metavar="NAME:LEFT,TOP,RIGHT,BOTTOM",
    )  # fmt: skip
    mask: Path | None = setting(None, "Image that is black outside the specimen.", metavar="FILE")
    scale: float | None = setting(
        None, "Millimetres on the specimen per pixel.  [default: pixels only]", metavar="MM", limits=POSITIVE
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class StrainImage:
    """What one image shows of the specimen."""

    name: str
    followed: Followed
    displacement: Array
    """(n, 2) of the subsets [px], x to the right, y down; NaN where a subset was not followed"""
    rigid: RigidMotion
    relative: Array
    """(n, 2) displacement less the common rigid motion"""
    strain: StrainField
    areas: Mapping[str, AreaStrain | None]
    """None: too few subsets"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Strains:
    """Displacements and strains of all images."""

    settings: StrainSettings
    grid: SubsetGrid
    images: tuple[StrainImage, ...]
    reported: tuple[Message, ...]
    files: tuple[Path, ...]


def state_counts(f: Followed) -> dict[str, int]:
    """Subsets by what became of them, without states that none has."""
    import numpy as np

    from raybundle.matching.subsets import State

    counts = np.bincount(f.state, minlength=len(State)).tolist()
    return {state.name.lower(): n for state, n in zip(State, counts, strict=True) if n}
