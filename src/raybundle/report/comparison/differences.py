"""What differs between two results: object points, the second laid onto the first, and what was taken otherwise."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, cast

import numpy as np

from raybundle.errors import InputError, Text, note
from raybundle.io.tables import Table as Csv
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.transform import Similarity, similarity
from raybundle.report.comparison.common_points import Common
from raybundle.report.comparison.shared import Shared
from raybundle.report.parts import pick
from raybundle.results.folder import ResultFolder

SMALL_BASIS = 22
"""Redundancy of a similarity below which its figures are uncertain by more than 15 %.

The relative standard deviation of an rms from r redundant differences is 1 / sqrt(2 r); 1 / (2 x 0.15^2) = 22.2.  Ten
points have 23, nine 20."""
APART = Shared(common=0, used=(0, 0), part="")
"""Of two results that share nothing."""
PARAMETERS = 7
"""Of a similarity."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PointDifferences:
    """Second minus first, after the second was laid onto the first."""

    ids: tuple[str, ...]
    difference: Array
    """(n, 3) length unit of the first"""
    std: Array
    """(n, 3) standard deviation of the difference as `Shared.std` has it; NaN where one has none"""
    fit: Similarity | None
    """The similarity; None where the two were compared as they stand"""

    @property
    def redundancy(self) -> int:
        """Differences less the parameters that were fitted to them."""
        return self.difference.size - (0 if self.fit is None else PARAMETERS)


def point_differences(
    xyz: tuple[Array, Array], std: tuple[Array, Array], ids: Sequence[str], *, fitted: bool, shared: Shared = APART
) -> PointDifferences:
    """Second minus first of points (n, 3) in one unit with standard deviations (n, 3).

    fitted  lay the second onto the first by a least squares similarity before
    shared  what the two have in common; independent where nothing is stated
    raises  InputError where a similarity needs more points, or points that are not in a line

    The standard deviation of turned points neglects the correlations between their coordinates.
    """
    fit = similarity(xyz[1], xyz[0]) if fitted else None
    moved = xyz[1] if fit is None else fit.points(xyz[1])
    turned = std[1] ** 2 if fit is None else fit.scale**2 * std[1] ** 2 @ (fit.rotation**2).T
    own = shared.std(std[0], np.sqrt(turned))
    return PointDifferences(ids=tuple(ids), difference=moved - xyz[0], std=own, fit=fit)


def columns_of(csv: Csv, names: Sequence[str], rows: Index) -> Array:
    """Columns of some rows of a table (n, k)."""
    return np.stack([csv.number[n][rows] for n in names], axis=1)


def to_first(first: ResultFolder, second: ResultFolder) -> float:
    """Factor from the second's length unit to the first's."""
    mm = {"m": 1000.0, "mm": 1.0}
    return mm[second.block.length_unit] / mm[first.block.length_unit]


def compared(
    first: ResultFolder, second: ResultFolder, common: Common, *, fitted: bool, shared: Shared
) -> PointDifferences | None:
    """The common points of two results, second minus first; None where there are too few, or all in a line."""
    factor = to_first(first, second)
    xyz = columns_of(first.points, "XYZ", common.first), factor * columns_of(second.points, "XYZ", common.second)
    names = ("sX", "sY", "sZ")
    std = columns_of(first.points, names, common.first), factor * columns_of(second.points, names, common.second)
    good = np.flatnonzero(np.isfinite(xyz[0]).all(axis=1) & np.isfinite(xyz[1]).all(axis=1))
    if not len(good):
        return None
    ids = pick(good, common.ids)
    try:
        return point_differences(
            (xyz[0][good], xyz[1][good]), (std[0][good], std[1][good]), ids, fitted=fitted, shared=shared
        )
    except InputError:
        return None


def basis_words(count: int, *, centres: bool) -> Text:
    """What a similarity rests on, with a caution where that is little.

    count    points, or projection centres, with three coordinates each
    centres  whether they are projection centres
    """
    r = 3 * count - PARAMETERS
    found = [note("report_compare.basis", n=count, centres=centres, coordinates=3 * count, redundancy=r)]
    if r < SMALL_BASIS:
        unsure, absorbed = 100 / math.sqrt(2 * r) if r > 0 else math.inf, 100 * PARAMETERS / (3 * count)
        found.append(note("report_compare.small_basis", uncertainty_percent=unsure, absorbed_percent=absorbed))
    return Text.of(*found)


def taken_otherwise(first: ResultFolder, second: ResultFolder) -> Text:
    """What of the same observations the two took otherwise, by which estimates and sigmas move.

    Image observations are the same where image and place are, to a hundredth of a pixel.
    """
    a, b = _taken(first), _taken(second)
    common = a.keys() & b.keys()
    only = sum(not a[k] and b[k] for k in common), sum(a[k] and not b[k] for k in common)
    if not common:
        found = [note("report_compare.no_common_observation")]
    elif any(only):
        found = [note("report_compare.rejected_otherwise", n=len(common), first=only[0], second=only[1])]
    else:
        found = [note("report_compare.rejected_alike", n=len(common))]
    kinds = [str(cast("Mapping[str, Any]", r.result.get("noise") or {}).get("kind", "white")) for r in (first, second)]
    found.append(note("report_compare.noise_models", same=kinds[0] == kinds[1], first=kinds[0], second=kinds[1]))
    free = [_free(r) for r in (first, second)]
    for which, names in (("first", free[0] - free[1]), ("second", free[1] - free[0])):
        if names:
            found.append(note("report_compare.free_in", which=which, names=sorted(names)))
    if free[0] == free[1]:
        found.append(note("report_compare.free_alike"))
    return Text.of(*found)


def _taken(folder: ResultFolder) -> dict[tuple[str, int, int], bool]:
    """Whether each image observation, by image and place, takes part."""
    o = folder.observations
    x, y = (np.rint(100 * o.number[n]).astype(np.int64).tolist() for n in ("x_px", "y_px"))
    return {(i, a, b): not r for i, a, b, r in zip(o.text["image"], x, y, o.text["rejected"], strict=True)}


def _free(folder: ResultFolder) -> set[str]:
    """Parameters of cameras that were estimated, as "x0 (camera)"."""
    cameras = cast("Mapping[str, Mapping[str, Mapping[str, Any]]]", folder.result.get("cameras") or {})
    return {
        f"{s} ({c})"
        for c, values in cameras.items()
        for s, p in values.items()
        if p.get("status") in {"estimated", "observed"} or as_float(p.get("std")) > 0
    }


def as_float(value: Any) -> float:
    """A number of result.json; NaN where there is none."""
    return float(value) if isinstance(value, int | float) else math.nan
