"""Heights as commands take them: read, holes filled, with outlines and lines in the coordinates of their grid."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError, Message, Text, named, plain
from raybundle.io.geo.parsed_systems import parse_crs, system_name
from raybundle.io.missions.areas import GEOGRAPHIC, Shape, in_crs, read_shapes
from raybundle.io.outlines import TEXT, read_outline
from raybundle.io.reading.words import number_of
from raybundle.missions.polygons import astray, checked_ring, signed_area
from raybundle.numerics.arrays import Array
from raybundle.results.fingerprint import FINGERPRINT, adjusted_since
from raybundle.surfaces.files.checks import other_heights
from raybundle.surfaces.files.heights import ABOUT, HeightFile, read_heights
from raybundle.surfaces.heights.height_model import HeightModel
from raybundle.surfaces.heights.hole_filling import filled
from raybundle.surfaces.heights.outlines import coverage
from raybundle.surfaces.heights.resampling import SAME, resampled

OUTSIDE = 1e-3
"""Share of an area or a line that may lie beyond the grid: rounding of coordinates."""
LEAST = 1e-6
"""Share of a cell below which it is within an outline by the rounding of coordinates alone."""
COARSER = 2.0
"""How much larger or smaller cells may be that are resampled."""
APART = 0.1
"""Of a cell, by which turning a plane may move a place and yet leave heights comparable."""

RASTERS, CLOUDS = {".tif", ".tiff"}, {".las", ".laz"}


def is_older(path: Path) -> bool:
    """Whether a path is a file of a height model without photographs, by its name, and no folder of a surface."""
    return path.suffix.lower() in RASTERS | CLOUDS and not path.is_dir()


@dataclass(frozen=True, slots=True, kw_only=True)
class Opened:
    """A surface with heights."""

    folder: Path
    model: HeightModel
    file: HeightFile

    @property
    def unit(self) -> str:
        """Of lengths; empty: the scale is free."""
        return self.file.unit

    @property
    def cautions(self) -> tuple[str, ...]:
        """What is to be reported of its files and of the result that it was measured of, a sentence each."""
        since = adjusted_since(self.folder, str(self.file.plane.get(FINGERPRINT, "")))
        return (*self.file.cautions, *([Text.of(named(str(self.folder), since))] if since else []))

    def cells(self, xy: Array) -> Array:
        """(n, 2) columns and rows of places (n, 2)."""
        return self.file.grid.cells(xy)

    def places(self, cells: Array) -> Array:
        """(n, 2) coordinates of columns and rows (n, 2)."""
        return self.file.grid.places(cells)


def opened(folder: Path, widest: float | None = None) -> Opened:
    """Heights of a surface.

    widest  of holes that are filled, in their unit
    raises  InputError for a file, where the folder holds none, or they are damaged
    """
    if folder.is_file():
        raise InputError(
            "height_grid.file", model=is_older(folder) and not (folder.parent / ABOUT).is_file(), file=folder
        )
    if not folder.is_dir():
        raise InputError("folder.missing_itself", file=folder)
    model, file = read_heights(folder)
    if not model.known.any():
        raise InputError("height_grid.empty", file=folder)
    if widest:
        model = filled(model, widest / file.cell / 2)
    return Opened(folder=folder, model=model, file=file)


def outlined(o: Opened, outlines: Sequence[str], extent: Sequence[float] | None) -> list[list[Array]]:
    """Areas by outlines, files or coordinates, or a rectangle: of each its rings, in columns and rows.

    raises  InputError for an outline that crosses itself
    """
    return [[o.cells(r) for r in rings] for rings in areas_in(o.file.wkt, outlines, extent)]


def named_areas(o: Opened, outlines: Sequence[str]) -> dict[str, list[Array]]:
    """Areas by outlines with their names: rings in columns and rows; without a name their number.

    Several areas of one name, as of a MultiPolygon, get a number behind it.
    """
    found = dict[str, list[Array]]()
    for given in outlines:
        for name, rings in _areas(o.file.wkt, given):
            own = name or str(len(found) + 1)
            number = next(k for k in range(1, len(found) + 2) if (own if k == 1 else f"{own} {k}") not in found)
            found[own if number == 1 else f"{own} {number}"] = [o.cells(r) for r in rings]
    return found


def covered_by(o: Opened, areas: Sequence[Sequence[Array]]) -> Array:
    """(rows, columns) share of each cell within areas, each by its rings in columns and rows.

    raises  InputError where areas overlap or lie beyond the grid
    """
    found = np.zeros(o.model.shape)
    wanted = 0.0
    for rings in areas:
        wanted += _size(rings)
        found += coverage(rings, o.model.shape)
    if found.max() > 1 + 1e-6:
        raise InputError("outline.overlap")
    lost = 1 - float(found.sum()) / wanted
    if lost > OUTSIDE:
        f = o.file
        raise InputError(
            "outline.beyond_heights",
            share=lost,
            limit=OUTSIDE,
            left=f.left,
            bottom=f.top - f.height * f.cell,
            right=f.left + f.width * f.cell,
            top=f.top,
        )
    found[(found < LEAST) & ~o.model.known] = 0.0
    return np.minimum(found, 1.0)


def _size(rings: Sequence[Array]) -> float:
    """Area of a ring without the others, which are holes in it."""

    def one(r: Array) -> float:
        x, y = (r - r[0]).T
        return abs(float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))) / 2

    return one(rings[0]) - sum(one(r) for r in rings[1:])


def areas_in(wkt: str, outlines: Sequence[str], extent: Sequence[float] | None) -> list[list[Array]]:
    """Areas in plan of a plane, by outlines in files or coordinates, or a rectangle: of each its rings.

    wkt     coordinate system of a map; empty: the plane is one of the object
    raises  InputError for an outline that crosses itself, a file without areas, and an extent that is empty
    """
    if extent is None:
        return [rings for given in outlines for _, rings in _areas(wkt, given)]
    left, bottom, right, top = extent
    if not (left < right and bottom < top):
        raise InputError("outline.extent_empty", left=left, bottom=bottom, right=right, top=top)
    return [[np.array([[left, bottom], [right, bottom], [right, top], [left, top]])]]


def _shapes(given: str, name: str) -> tuple[Shape, ...]:
    """What a file or coordinates hold.

    raises  InputError for numbers that are no corners, an empty text, and as `read_shapes` does
    """
    if not given.strip():
        raise InputError("outline.option_empty", name=name)
    if not Path(given).exists() and re.fullmatch(r"[\d\s.,;+\-eE]+", given) and re.search(r"\d", given):
        pairs = [p.split() for p in re.split(r"[;,]", given)]
        if any(len(p) != 2 or None in map(number_of, p) for p in pairs):
            raise InputError("outline.neither_file_nor_corners", name=name, given=given)
    return read_shapes(given)


def _areas(wkt: str, given: str) -> list[tuple[str, list[Array]]]:
    """The name of each area and its rings, the outer one first, in coordinates of the plane."""
    path = Path(given)
    if path.suffix.lower() in TEXT and path.is_file():
        return [(path.stem, [checked_ring(read_outline(path), name=path.name)])]
    shapes = [s for s in _shapes(given, "outline") if s.kind == "area"]
    if not shapes:
        if path.exists():
            raise InputError("outline.no_area_in_file", file=path)
        raise InputError("outline.too_few_corners", name="outline", given=given)
    found = list[tuple[str, list[Array]]]()
    for s in shapes:
        rings = [_in_plane(wkt, r, s.crs, typed=s.typed, path=path) for r in (s.xy, *s.holes)]
        checked = [checked_ring(r) for r in rings]
        _check_holes(checked)
        found.append((s.name, checked))
    return found


def _check_holes(rings: Sequence[Array]) -> None:
    """That holes of an area lie within it and apart from each other: what is enclosed is not known otherwise.

    raises  InputError where one does not, with the place
    """

    def refuse(code: str, place: Array, **holes: int) -> None:
        raise InputError(Message(code=code, values=plain({"x": place[0], "y": place[1], **holes})))

    outer, *holes = rings
    for k, hole in enumerate(holes, 1):
        if (place := astray(hole, outer, within=False)) is not None:
            refuse("outline.hole_outside", place, hole=k)
        for n, other in enumerate(holes[: k - 1], 1):
            apart = (hole.min(axis=0) > other.max(axis=0)).any() or (other.min(axis=0) > hole.max(axis=0)).any()
            if apart:
                continue
            place = astray(hole, other, within=True)
            place = astray(other, hole, within=True) if place is None else place
            if place is None and np.isclose(signed_area(hole), signed_area(other), rtol=1e-9, atol=0):
                place = hole[0] if astray(hole, other, within=False) is None else None
            if place is not None:
                refuse("outline.holes_overlap", place, hole=k, other=n)
    if holes and _size(rings) <= LEAST * signed_area(outer):
        refuse("outline.only_holes", outer[0])


def lines_of(o: Opened, given: str) -> list[Array]:
    """The lines (k, 2) in a file or in coordinates, in those of the grid."""
    path = Path(given)
    if path.suffix.lower() in TEXT and path.is_file():
        found = [read_outline(path)]
    else:
        shapes = [s for s in _shapes(given, "line") if s.kind != "place"]
        if not shapes:
            if path.exists():
                raise InputError("outline.no_line_in_file", file=path)
            raise InputError("outline.single_place", name="line", given=given)
        # of coordinates that were typed, three places or more are a line here, and no area
        found = [_in_plane(o.file.wkt, s.xy, s.crs, typed=s.typed, path=path) for s in shapes]
    for line in found:
        if len(line) < 2 or not np.linalg.norm(np.diff(line, axis=0), axis=1).min() > 0:
            raise InputError(
                "outline.line_without_length",
                given=given,
                file=path if path.exists() else None,
            )
    return found


def _in_plane(wkt: str, xy: Array, crs: str, *, typed: bool, path: Path) -> Array:
    """Coordinates of a file in those of a map, or of a plane of the object as they are."""
    if typed or not wkt:
        if not typed and crs and crs != GEOGRAPHIC:  # what states nothing is of the plane
            raise InputError(
                "outline.heights_in_no_map",
                system=system_name(crs),
                file=path,
            )
        if not typed and path.suffix.lower() in {".kml", ".kmz"}:
            raise InputError(
                "outline.heights_in_no_map",
                system=system_name(GEOGRAPHIC),
                file=path,
            )
        return np.asarray(xy, float)
    return in_crs(xy, crs or GEOGRAPHIC, wkt)


def on_same_grid(first: Opened, second: Opened) -> HeightModel:
    """The second surface at the cells of the first.

    raises  InputError where they are not in one frame, or their cells are too different
    """
    a, b = first.file, second.file
    if a.unit != b.unit:
        raise InputError(
            "surface_files.units_differ",
            unit=b.unit or "free",
            other=str(first.folder),
            other_unit=a.unit or "free",
            file=second.folder,
        )
    turn, move = _turned(first, second)
    scale = a.cell / b.cell
    if not 1 / COARSER <= scale <= COARSER:
        raise InputError(
            "surface_files.cells_differ",
            cell=b.cell,
            other=str(first.folder),
            other_cell=a.cell,
            file=second.folder,
        )
    model = second.model
    if turn is not None:
        model = _above_other_plane(second, turn, move)
    left, top = (a.left - b.left - move[0]) / b.cell, (b.top + move[1] - a.top) / b.cell
    same = abs(scale - 1) < SAME / max(a.width, a.height) and max(abs(left), abs(top)) < SAME
    if same and (a.width, a.height) == (b.width, b.height):
        return model
    return resampled(model, left, top, scale, first.model)


def _turned(first: Opened, second: Opened) -> tuple[Array | None, Array]:
    """Rotation (3, 3) and translation (3,) from coordinates above the second plane to those above the first.

    raises  InputError where they lie so differently that heights of one are not those of the other
    """
    a, b = first.file, second.file
    if bool(a.wkt) != bool(b.wkt):
        raise InputError("surface_files.one_in_map", map=bool(b.wkt), other=str(first.folder), file=second.folder)
    if a.wkt and parse_crs(a.wkt) != parse_crs(b.wkt):
        system, other = (system_name(f.system or f.wkt) for f in (b, a))
        raise InputError("surface_files.systems_differ", system=system, other=other, file=second.folder)
    if a.wkt:
        differing = other_heights(b.system, a.system)
        if differing:
            raise InputError(differing, file=second.folder)
        return None, np.zeros(3)
    p, q = (_axes(f.plane) for f in (a, b))
    if p is None or q is None:
        raise InputError("surface_files.plane_unknown", other=str(first.folder), file=second.folder)
    turn, move = p[1] @ q[1].T, p[1] @ (q[0] - p[0])
    tall = float(np.nanmax(np.abs(second.model.heights.height)))
    size = max(abs(b.left), abs(b.top), b.width * b.cell, b.height * b.cell)
    off = max(float(np.abs(turn[:2, :2] - np.eye(2)).sum()) * size, float(np.abs(turn[:2, 2]).sum()) * tall)
    if off <= APART * b.cell:
        return turn, move
    raise InputError(
        "surface_files.planes_differ", off_cells=off / b.cell, limit_cells=APART, other=str(first.folder),
        file=second.folder,
    )  # fmt: skip


def _above_other_plane(o: Opened, turn: Array, move: Array) -> HeightModel:
    """The heights above a plane that is tilted and moved by little."""
    f, h = o.file, o.model.heights
    v, u = np.mgrid[: f.height, : f.width] + 0.5
    more = turn[2, 0] * (f.left + u * f.cell) + turn[2, 1] * (f.top - v * f.cell) + move[2]
    return replace(o.model, heights=replace(h, height=(turn[2, 2] * h.height + more).astype(np.float32)))


def _axes(plane: Mapping[str, Any]) -> tuple[Array, Array] | None:
    """Origin and axes of a plane of the object."""
    try:
        return np.array(plane["origin"], float), np.array([plane[k] for k in ("right", "up", "normal")], float)
    except (KeyError, TypeError, ValueError):
        return None
