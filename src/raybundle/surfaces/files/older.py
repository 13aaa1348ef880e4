"""Older height models without photographs, a raster of heights or a point cloud, on the grid of a surface."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.io.formats.las import read_las
from raybundle.io.geo.parsed_systems import plan_of, system_name
from raybundle.io.geo.rasters import read_heights, whole_units
from raybundle.numerics.arrays import Array
from raybundle.objects.heights import HeightGrid
from raybundle.surfaces.files.input import CLOUDS, Opened, covered_by, outlined
from raybundle.surfaces.heights.alignment import Alignment, aligned
from raybundle.surfaces.heights.height_model import HeightModel

FOOT, ALIKE, SPREAD = 0.3048, 0.1, 0.3
"""[m]; shares by which the median ratio of heights may differ from it, and ratios from their median: what moved gives
ratios that differ among themselves"""
MARGIN = 32
"""Cells around the grid of a surface from which points of a cloud are taken"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Aligned:
    """An older model on the grid of a surface, and the surface with the errors that both share."""

    old: HeightModel
    surface: HeightModel
    alignment: Alignment
    remarks: tuple[str, ...]


def align_older(path: Path, o: Opened, stable: Sequence[str]) -> Aligned:
    """A model aligned to a surface.

    stable  outlines of what has not moved; none: it is found
    raises  InputError for a surface that is in no map in metres, a file that cannot be read, heights that are rounded
            to whole units, or no alignment
    """
    if not o.file.wkt or o.unit not in {"m", "metre"}:
        raise InputError("old_heights.no_map", file=o.folder)
    if path.suffix.lower() in CLOUDS:
        grid = _cloud(path, o)
    else:
        grid = read_heights(path, o.file.wkt, _box(o))
        if whole_units(path):
            raise InputError("old_heights.whole_units", file=path)
    rows, columns = np.mgrid[: o.file.height, : o.file.width]
    places = o.places(np.stack([columns.ravel() + 0.5, rows.ravel() + 0.5], axis=1))

    def at(plan: Array) -> Array:
        return np.asarray(grid.at(places - plan), float).reshape(o.model.shape)

    _check_unit(at(np.zeros(2)), o.model.heights.height, path)
    fixed = None
    if stable:
        fixed = covered_by(o, outlined(o, stable, None)) > 0.5
    old, surface, alignment = aligned(at, o.model, fixed)
    return Aligned(old=old, surface=surface, alignment=alignment, remarks=grid.remarks)


def _check_unit(old: Array, new: Array, path: Path) -> None:
    """Raise InputError where differences of heights across the surface are all those of feet against metres."""
    found = list[Array]()
    for axis, size in enumerate(new.shape):
        lag = max(1, size // 4)
        both = [np.take(z, np.arange(lag, size), axis) - np.take(z, np.arange(size - lag), axis) for z in (old, new)]
        found.append(np.stack([b.ravel() for b in both]))
    d_old, d_new = (d := np.hstack(found))[:, np.isfinite(d).all(axis=0)]
    large = np.abs(d_new) > np.quantile(np.abs(d_new), 0.75) if len(d_new) else np.zeros(0, bool)
    if not large.any():
        return
    ratios = d_old[large] / d_new[large]
    ratio = float(np.median(ratios))
    spread = float(np.median(np.abs(ratios - ratio)))
    for feet, metres in ((True, 1 / FOOT), (False, FOOT)):
        if abs(ratio / metres - 1) < ALIKE and spread / metres < SPREAD:
            raise InputError("old_heights.other_unit", ratio=ratio, feet="yes" if feet else "no", file=path)


def _box(o: Opened) -> Array:
    """(2, 2) least and greatest coordinates of the grid and its surroundings."""
    f = o.file
    m = MARGIN * f.cell
    return np.array([[f.left - m, f.top - f.height * f.cell - m], [f.left + f.width * f.cell + m, f.top + m]])


def _cloud(path: Path, o: Opened) -> HeightGrid:
    """Mean heights of the points of a cloud, in cells of the surface's grid."""
    f = o.file
    shape = f.height + 2 * MARGIN, f.width + 2 * MARGIN
    corner = np.array([f.left - MARGIN * f.cell, f.top + MARGIN * f.cell])
    count, total = np.zeros(shape[0] * shape[1]), np.zeros(shape[0] * shape[1])
    base, rounded = float(np.nanmedian(o.model.heights.height)), True
    for xyz, system in read_las(path):
        rounded &= bool((xyz[:, 2] == np.round(xyz[:, 2])).all())
        if system and plan_of(system) != plan_of(f.wkt):
            names = system_name(system), system_name(f.wkt)
            raise InputError("surface_files.systems_differ", system=names[0], other=names[1], file=path)
        c, r = np.floor((xyz[:, :2] - corner) / f.cell * [1, -1]).astype(int).T
        inside = (r >= 0) & (r < shape[0]) & (c >= 0) & (c < shape[1])
        at = r[inside] * shape[1] + c[inside]
        count += np.bincount(at, minlength=len(count))
        total += np.bincount(at, xyz[inside, 2] - base, minlength=len(total))
    if not count.any():
        raise InputError("height_grid.no_common_cell", other=str(o.folder), file=path)
    if rounded:
        raise InputError("old_heights.whole_units", file=path)
    mean = np.where(count > 0, total / np.maximum(count, 1) + base, np.nan).reshape(shape)
    middle = corner + np.array([0.5, -0.5]) * f.cell
    return HeightGrid(
        heights=mean, origin=(float(middle[0]), float(middle[1])), column=(f.cell, 0.0), row=(0.0, -f.cell), crs=f.wkt
    )
