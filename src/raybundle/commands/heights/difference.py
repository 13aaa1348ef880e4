"""`raybundle heights difference`: what has moved between two surfaces."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.errors import InputError
from raybundle.settings import setting

if TYPE_CHECKING:
    from raybundle.surfaces.heights.displacement import Movements
    from raybundle.surfaces.heights.level_of_detection import SmallestMovement


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightsDifferenceSettings:
    """Two surfaces."""

    before: Path
    """folder of `surface` with heights"""
    after: Path
    out: Path | None = setting(None, "New folder.", metavar="FOLDER")


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasuredDifference:
    """What has moved."""

    movements: Movements
    unit: str
    compared: float
    """share of the heights before that have one after"""
    same: float
    """share of these that are one measurement in both, and so have not moved"""
    smallest: tuple[SmallestMovement, ...]
    """movements of squares that would have been found"""
    in_map: bool
    orientations: str
    """of one adjustment: "known", what both have in common; "unknown"; empty: they are independent"""
    cautions: tuple[str, ...]
    """what is to be reported of the surfaces themselves, a sentence each"""
    files: tuple[Path, ...]


def run_difference(settings: HeightsDifferenceSettings) -> MeasuredDifference:
    """The movements between two surfaces, written where that is asked for."""
    from raybundle.io.folders import check_new_folder
    from raybundle.surfaces.files.displacements import write_movements
    from raybundle.surfaces.files.input import on_same_grid, opened
    from raybundle.surfaces.heights.displacement import movements
    from raybundle.surfaces.heights.resampling import difference

    s = settings
    if s.out is not None:
        check_new_folder(s.out)
    before, after = opened(s.before), opened(s.after)
    model = difference(before.model, on_same_grid(before, after))
    if not model.known.any():
        raise InputError("height_grid.no_common_cell", other=str(s.before), file=s.after)
    if not (model.known & (model.local > 0)).any():
        raise InputError("height_grid.identical", other=str(s.before), file=s.after)
    a, b = before.model, after.model
    orientations = ""
    if a.adjustment and a.adjustment == b.adjustment:
        orientations = "known" if model.errors else "unknown"
    found = movements(model)
    smallest = found.smallest(model)
    files = write_movements(before, model, found, smallest, s.out) if s.out is not None else ()
    return MeasuredDifference(
        movements=found, unit=before.unit, compared=float(model.known.sum() / before.model.known.sum()),
        same=float((model.known & (model.local == 0)).sum() / model.known.sum()), smallest=smallest,
        in_map=bool(before.file.wkt), orientations=orientations,
        cautions=(*before.cautions, *after.cautions), files=files,
    )  # fmt: skip
