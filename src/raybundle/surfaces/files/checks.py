"""Whether the files of heights belong together: where rasters lie, what orientation does, what heights count from."""

from __future__ import annotations

import hashlib
import warnings
from collections.abc import Generator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, get_args

import numpy as np

from raybundle.block.block import LengthUnit
from raybundle.errors import InputError, Message, message, phrase
from raybundle.io.geo.parsed_names import plan_system
from raybundle.io.geo.parsed_systems import geoid_file, parse_crs, plan_of, system_name
from raybundle.io.raster_library import raster_errors
from raybundle.io.reading.trees import Json
from raybundle.numerics.arrays import Array
from raybundle.pipeline.archives import DAMAGED

if TYPE_CHECKING:
    from pyproj import CRS

ROUNDING_CELLS, ROUNDING = 1e-3, 1e-9
"""By which a place in a raster may differ from heights.toml: of a cell, and of the coordinate itself"""
OF_ORIENTATION = "orientation_sha256"
"""Key of heights.toml: check sum of the file that states how orientation moves the heights"""
OF_HEIGHTS, OF_SIGMAS = "heights_sha256", "heights_sigma_sha256"
"""The same of the values of the two rasters, which a lossless copy of them in another form keeps"""
WHOLE_SIGMA, STEP_SIGMA = "sigma", "sigma of steps"
"""Bands of standard deviations: that of all parts, which no height is without, and one that earlier files lack"""
STRIP = 256
"""Rows of a raster that are read at once for its check sum"""
SAME_PLACE = 0.1
"""Of a cell, by which two texts of one system may put a place apart"""


def check_place(tree: Json) -> None:
    """Raise InputError where heights.toml shows no place that a grid can have."""
    for name in ("pixel", "length_cells"):
        if not tree.get(name).number() > 0:
            tree.get(name).fail("number.too_small", entry=name, value=tree.get(name).number(), limit=0.0)
    for name in ("width_px", "height_px"):
        tree.get(name).whole()
    if not 0 <= tree.optional("between_maps", 0.0) <= 1:
        tree.get("between_maps").fail("surface_files.correlation", correlation=tree.get("between_maps").number())
    unit = tree.get("unit").text() if tree.has("unit") else ""
    known = ("", *get_args(LengthUnit), *_units_of(tree))
    if unit not in known:
        tree.get("unit").fail("surface_files.unit_unknown", unit=unit, known=[u for u in known if u])


def _units_of(tree: Json) -> tuple[str, ...]:
    """What the unit of the system is called, where there is one; raises InputError for a text that names none."""
    if not tree.has("system"):
        return ()
    try:
        system = plan_system(tree.get("system").text())
    except InputError as error:
        tree.get("system").fail(error.args[0])
    return () if system is None else (system.axis_info[0].unit_name,)


@contextmanager
def raster(library: Any, path: Path) -> Generator[Any]:
    """A raster that is open; raises InputError, naming it, where it cannot be read or is cut off."""
    with raster_errors(path), warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of the library, about rasters without a place: that is reported here
        with library.open(path) as file:
            yield file


def check_raster(file: Any, path: Path, tree: Json) -> None:
    """Raise InputError, with the numbers, where a raster does not lie where heights.toml states.

    file  that rasterio has opened
    tree  heights.toml
    """
    about = tree.file.name
    stated = tuple(tree.get(name).whole() for name in ("width_px", "height_px"))
    if (file.width, file.height) != stated:
        raise InputError(
            "surface_files.size_differs",
            columns=file.width,
            rows=file.height,
            about=about,
            needed_columns=stated[0],
            needed_rows=stated[1],
            file=path,
        )
    left, top, pixel = (tree.get(name).number() for name in ("left", "top", "pixel"))
    t = file.transform
    wanted = {
        "left": (left, t.c),
        "top": (top, t.f),
        "width": (pixel, t.a),
        "height": (pixel, -t.e),
    }
    for what, (named, found) in wanted.items():
        allowed = max(ROUNDING_CELLS * pixel / (1 if what in {"left", "top"} else max(stated)), ROUNDING * abs(named))
        if not abs(found - named) <= allowed:
            raise InputError(
                "surface_files.place_differs",
                quantity=what,
                value=found,
                about=about,
                needed=named,
                file=path,
            )
    if abs(t.b) > 0 or abs(t.d) > 0:
        raise InputError("surface_files.rotated", about=about, file=path)
    if file.crs and tree.has("system"):
        corners = np.array([[left, top], [left + stated[0] * pixel, top - stated[1] * pixel]])
        _check_system(file.crs.to_wkt(), path, tree.get("system").text(), about, corners, pixel)


def _check_system(wkt: str, path: Path, system: str, about: str, corners: Array, pixel: float) -> None:
    """Raise InputError where a raster is in another system than heights.toml states."""
    mine, stated = plan_of(wkt), plan_system(system)
    same = stated is not None and _one_plan(mine, stated, corners, pixel)
    if same and parse_crs(wkt).is_compound and parse_crs(system).is_compound:
        codes = [parse_crs(s).sub_crs_list[1].to_epsg() for s in (wkt, system)]
        same = None in codes or codes[0] == codes[1]
    if not same:
        raise InputError(
            "surface_files.system_differs", system=system_name(wkt), about=about, needed=system_name(system), file=path
        )


def _one_plan(mine: CRS, stated: CRS, corners: Array, pixel: float) -> bool:
    """Whether two texts mean one plan system: a GeoTIFF keeps no name and no datum that nobody registered."""
    if mine.equals(stated, ignore_axis_order=True):
        return True
    codes = [s.to_epsg(min_confidence=100) for s in (mine, stated)]
    if None not in codes:
        return codes[0] == codes[1]
    if not mine.is_projected:
        return False
    from pyproj import Proj

    there = Proj(mine)(*Proj(stated)(*corners.T, inverse=True))
    apart = np.abs(np.stack(there, axis=1) - corners).max()
    return bool(apart <= SAME_PLACE * pixel)


def check_sum(path: Path) -> str:
    """SHA-256 of a file."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def check_belongs(path: Path, tree: Json) -> None:
    """Raise InputError where what orientation does was not written with these heights.

    tree  heights.toml; of earlier versions it has no check sum, and nothing is reported
    """
    if tree.has(OF_ORIENTATION) and check_sum(path) != tree.get(OF_ORIENTATION).text():
        raise InputError("surface_files.other_surface", about=tree.file.name, file=path)


def values_in(file: Any, first: int = 0, rows: int | None = None) -> Array:
    """(bands, rows, columns) float32 of some rows of a raster that rasterio has opened; NaN where it holds nothing."""
    last = file.height if rows is None else min(first + rows, file.height)
    values = file.read(window=((first, last), (0, file.width))).astype(np.float32)
    for band, nothing in zip(values, file.nodatavals, strict=True):
        if nothing is not None:
            band[band == np.float32(nothing)] = np.nan
    return values


def sum_of_raster(library: Any, path: Path) -> str:
    """SHA-256 of the values of a raster, row by row, as of `sum_of_values`."""
    found = hashlib.sha256()
    with raster(library, path) as file:
        for first in range(0, file.height, STRIP):
            _add(found, values_in(file, first, STRIP))
    return found.hexdigest()


def sum_of_values(values: Array) -> str:
    """SHA-256 of values (bands, rows, columns), as float32 of each row band by band; every NaN is the same."""
    found = hashlib.sha256()
    for first in range(0, values.shape[1], STRIP):
        _add(found, values[:, first : first + STRIP])
    return found.hexdigest()


def _add(found: Any, values: Array) -> None:
    rows = np.moveaxis(values, 0, 1).astype("<f4")
    rows[np.isnan(rows)] = np.nan
    found.update(rows.tobytes())


def check_values(heights: Path, height: Array, sigmas: Path, bands: Mapping[str, Array], tree: Json) -> tuple[str, ...]:
    """Raise InputError where standard deviations are not of these heights, or are none; what is to be reported else.

    height  (rows, columns) of the file `heights`
    bands   (rows, columns) each, all of the file `sigmas`, in its order: standard deviations by what they are of, and
            others under names that do not begin with sigma
    tree    heights.toml; of earlier versions it has no check sums, and values alone are looked at
    """
    infinite = int(np.isinf(height).sum())
    if infinite:
        raise InputError(
            "surface_files.infinite_heights",
            n=infinite,
            file=heights,
        )
    if tree.has(OF_SIGMAS) and sum_of_values(np.stack(list(bands.values()))) != tree.get(OF_SIGMAS).text():
        raise InputError("surface_files.other_surface", about=tree.file.name,
                         file=sigmas)  # fmt: skip
    known = np.isfinite(height)
    for name, values in bands.items():
        if name.startswith("sigma"):
            _check_sigma(sigmas, name, values[known])
    if tree.has(OF_HEIGHTS) and sum_of_values(height[None]) != tree.get(OF_HEIGHTS).text():
        return (phrase("heights.changed_values", name=str(heights)),)
    return ()


def _check_sigma(path: Path, name: str, sigma: Array) -> None:
    """Raise InputError, with their number, where standard deviations of cells with a height can be none."""
    wrong = {
        "negative": sigma < 0, "infinite": np.isinf(sigma), "zero": (sigma == 0) & (name == WHOLE_SIGMA),
        "missing": np.isnan(sigma) & (name != STEP_SIGMA),
    }  # fmt: skip
    counts = {why: int(np.asarray(which).sum()) for why, which in wrong.items()}
    if any(counts.values()):
        raise InputError(
            "surface_files.impossible_sigmas",
            n=sum(counts.values()),
            cells=len(sigma),
            band=name,
            negative=counts["negative"],
            infinite=counts["infinite"],
            zero=counts["zero"],
            missing=counts["missing"],
            file=path,
        )


@contextmanager
def orientation(path: Path) -> Generator[Mapping[str, Array]]:
    """What heights_orientation.npz holds; raises InputError, naming it, where it is damaged or something is missing."""
    try:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as kept:
            yield kept
    except DAMAGED as error:
        if isinstance(error, KeyError) and error.args:
            raise InputError(
                "surface_files.entry_missing", name=str(error.args[0]).partition(" ")[0], file=path
            ) from None
        raise InputError("surface_files.damaged", file=path) from None


def check_orientation(
    path: Path, nodes: Array, block: int, shape: tuple[int, int], holes: Sequence[Array] = ()
) -> None:
    """Raise InputError where what orientation does is not of heights of so many rows and columns.

    nodes  (node rows, node columns, ...) at the corners of blocks of so many cells
    holes  (rows, columns) of each cell
    """
    if block < 1:
        raise InputError("surface_files.block_size", cells=block, file=path)
    wanted = tuple(-(-n // block) + 1 for n in shape)
    if nodes.ndim < 3 or nodes.shape[:2] != wanted:
        raise InputError(
            "surface_files.node_count",
            nodes=nodes.shape[:2],
            rows=shape[0],
            columns=shape[1],
            needed=wanted,
            file=path,
        )
    if nodes.dtype.kind != "f" or not np.isfinite(nodes).all():
        raise InputError("surface_files.not_finite", file=path)
    if any(h.shape != shape for h in holes):
        raise InputError("surface_files.other_holes", file=path)


def other_heights(one: str, other: str) -> Message | None:
    """Why heights in two systems of one plan are not of one kind; None: nothing speaks against it.

    one, other  texts of systems; empty: it is not known.  Of two that say nothing nothing is known, and they are taken
                as of one kind.
    """
    datums = [_vertical_datum(s) for s in (one, other)]
    if datums[0] == datums[1]:
        return None
    names = [system_name(s) if s else "none" for s in (one, other)]
    return message(
        "surface_files.vertical_datums_differ", system=names[0], datum=datums[0] or "unknown",
        other_system=names[1], other_datum=datums[1] or "unknown",
    )  # fmt: skip


def _vertical_datum(system: str) -> str | None:
    """The name of what heights in a system count from, "ellipsoid" for ellipsoidal heights; None: unknown."""
    if not system:
        return None
    found = parse_crs(system)
    if found.is_compound:
        high = found.sub_crs_list[1]
        code = high.to_authority(min_confidence=100)
        if code:
            return f"{high.name} ({':'.join(code)})"
        grid = geoid_file(system)
        return grid or high.name
    return "ellipsoid" if len(found.axis_info) == 3 else None
