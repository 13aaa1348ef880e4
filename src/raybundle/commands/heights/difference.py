"""`raybundle heights difference`: what has moved between two surfaces."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.commands.heights.common import stable_setting
from raybundle.errors import InputError
from raybundle.settings import setting

if TYPE_CHECKING:
    from raybundle.surfaces.heights.alignment import Alignment
    from raybundle.surfaces.heights.displacement import Movements
    from raybundle.surfaces.heights.level_of_detection import SmallestMovement


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightsDifferenceSettings:
    """Two surfaces."""

    before: Path
    """folder of `surface` with heights; or an older model without photographs: GeoTIFF of heights, LAS, LAZ"""
    after: Path
    """as `before`; one of both has to be a surface"""
    stable: tuple[str, ...] = stable_setting()
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
    alignment: Alignment | None
    """of a model without photographs"""
    files: tuple[Path, ...]


def run_difference(settings: HeightsDifferenceSettings) -> MeasuredDifference:
    """The movements between two surfaces, written where that is asked for."""
    from raybundle.io.folders import check_new_folder
    from raybundle.surfaces.files.displacements import write_movements
    from raybundle.surfaces.files.input import is_older, on_same_grid, opened
    from raybundle.surfaces.files.older import align_older
    from raybundle.surfaces.heights.displacement import movements
    from raybundle.surfaces.heights.resampling import difference

    s = settings
    if s.out is not None:
        check_new_folder(s.out)
    later = is_older(s.after) and not is_older(s.before)
    file, folder = (s.after, s.before) if later else (s.before, s.after)
    after = opened(folder)
    older = align_older(file, after, s.stable) if is_older(file) else None
    if older is None and s.stable:
        raise InputError("old_heights.not_needed", file=s.before)
    # cells are those of the earlier surface, or of the only one
    first = opened(s.before) if older is None else after
    a, b = (first.model, on_same_grid(first, after)) if older is None else (older.old, older.surface)
    a, b = (b, a) if later else (a, b)
    model = difference(a, b)
    if not model.known.any():
        raise InputError("height_grid.no_common_cell", other=str(s.before), file=s.after)
    if not (model.known & (model.local > 0)).any():
        raise InputError("height_grid.identical", other=str(s.before), file=s.after)
    orientations = ""
    if a.adjustment and a.adjustment == b.adjustment:
        orientations = "known" if model.errors else "unknown"
    found = movements(model)
    smallest = found.smallest(model)
    files = write_movements(first, model, found, smallest, s.out) if s.out is not None else ()
    return MeasuredDifference(
        movements=found, unit=first.unit, compared=float(model.known.sum() / a.known.sum()),
        same=float((model.known & (model.local == 0)).sum() / model.known.sum()), smallest=smallest,
        in_map=bool(first.file.wkt), orientations=orientations,
        cautions=tuple(dict.fromkeys([*first.cautions, *after.cautions, *(older.remarks if older else ())])),
        files=files,
        alignment=None if older is None else older.alignment,
    )  # fmt: skip
