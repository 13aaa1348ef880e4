"""Settings that the commands on heights share."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.errors import InputError, Message, message
from raybundle.settings import NOT_NEGATIVE, setting

if TYPE_CHECKING:
    from raybundle.numerics.arrays import Array
    from raybundle.surfaces.files.input import Opened
    from raybundle.surfaces.heights.height_model import HeightModel

CELLS_FILLED = 10
"""Width in cells of the holes that are filled where nobody states how wide."""

MOST_FILLED = 20.0
"""Percent of an area whose heights may be interpolated where nobody states another limit"""


def stable_setting() -> Any:
    """By what an older model is aligned."""
    return setting(
        (), "Area that has not moved, by which an older model is aligned: a file or corners X Y, X Y, ...  "
        "[default: found by the heights; up to 45 % may have moved]", metavar="FILE|CORNERS",
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightsSettings:
    """What is taken from a surface."""

    source: Path
    """folder of `surface` with heights"""
    fill: float | None = setting(
        None, "Fill holes up to this width; 0: none. In the unit of the heights. Filled heights come from the "
        "surroundings; their standard deviation grows with the gap.  [default: 10 cells]",
        metavar="WIDTH", limits=NOT_NEGATIVE,
    )  # fmt: skip


def filled_within(o: Opened, model: HeightModel, covered: Array, widest: float, source: Path) -> HeightModel:
    """Heights with holes filled up to a width; raises InputError where a cell within an outline still has none.

    o       whose grid it is
    source  the folder that is named
    """
    from raybundle.surfaces.heights.hole_filling import filled

    found = filled(model, widest / o.file.cell / 2, covered > 0) if widest else model
    if ((covered > 0) & ~found.known).any():
        raise InputError(_no_height(o, model, found, covered), file=source)
    return found


def check_filled(share: float, most_percent: float, source: Path) -> None:
    """Raise InputError where a larger share was interpolated than is allowed."""
    if 100 * share > most_percent:
        raise InputError("volume.filled_share", share=share, limit_percent=float(most_percent), file=source)


def _no_height(o: Opened, before: HeightModel, model: HeightModel, covered: Array) -> Message:
    """That cells within an outline have no height, where the widest hole is, and what to do."""
    import numpy as np

    from raybundle.surfaces.heights.hole_filling import depths

    lost = (covered > 0) & ~model.known
    depth = np.where(lost, depths(before), 0.0)
    row, column = np.unravel_index(int(depth.argmax()), depth.shape)
    (x, y), far = o.places(np.array([[column + 0.5, row + 0.5]]))[0].tolist(), float(depth.max()) * o.file.cell
    return message(
        "volume.no_height", share=float(covered[lost].sum() / covered.sum()), n=int(lost.sum()), x=x, y=y,
        distance=far, unit=o.unit, fill=_upwards(2 * far),
    )  # fmt: skip


def _upwards(value: float) -> str:
    """A number with two digits that is no smaller."""
    power = 10.0 ** (math.floor(math.log10(value)) - 1)
    return f"{math.ceil(value / power * (1 - 1e-9)) * power:.6g}"
