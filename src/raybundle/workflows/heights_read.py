"""Heights as commands take them: read, holes filled, with outlines and lines in the coordinates of their grid."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.io.geo.parsed_systems import parse_crs, system_name
from raybundle.io.missions.areas import GEOGRAPHIC, Shape, in_crs, read_shapes
from raybundle.io.outlines import TEXT, read_outline
from raybundle.io.reading.words import number_of
from raybundle.missions.polygons import astray, checked_ring, signed_area
from raybundle.numerics.arrays import Array
from raybundle.results.fingerprint import FINGERPRINT, adjusted_since
from raybundle.settings import option
from raybundle.surfaces.height_model import HeightModel
from raybundle.surfaces.holes import filled
from raybundle.surfaces.outlines import coverage
from raybundle.surfaces.resampled import SAME, resampled
from raybundle.workflows.height_checks import other_heights
from raybundle.workflows.height_files import HeightFile, read_heights

OUTSIDE = 1e-3
"""Share of an area or a line that may lie beyond the grid: rounding of coordinates."""
LEAST = 1e-6
"""Share of a cell below which it is within an outline by the rounding of coordinates alone."""
COARSER = 2.0
"""How much larger or smaller cells may be that are resampled."""
APART = 0.1
"""Of a cell, by which turning a plane may move a place and yet leave heights comparable."""


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
        """What is to be told of its files and of the result that it was measured of, a sentence each."""
        since = adjusted_since(self.folder, str(self.file.plane.get(FINGERPRINT, "")))
        return (*self.file.cautions, *([f"{self.folder}: {since}"] if since else []))

    def cells(self, xy: Array) -> Array:
        """(n, 2) columns and rows of places (n, 2)."""
        return self.file.grid.cells(xy)

    def places(self, cells: Array) -> Array:
        """(n, 2) coordinates of columns and rows (n, 2)."""
        return self.file.grid.places(cells)


def opened(folder: Path, widest: float | None = None) -> Opened:
    """Heights of a surface.

    widest  of holes that are filled, in their unit
    raises  InputError where the folder holds none, or they are damaged
    """
    if not folder.is_dir():
        raise InputError("there is no such folder; give one that `surface` wrote with heights", file=folder)
    model, file = read_heights(folder)
    if not model.known.any():
        raise InputError("holds no height", file=folder)
    if widest:
        model = filled(model, widest / file.cell / 2)
    return Opened(folder=folder, model=model, file=file)


def outlined(o: Opened, outlines: Sequence[str], extent: Sequence[float] | None) -> list[list[Array]]:
    """Areas by outlines, files or coordinates, or a rectangle: of each its rings, in columns and rows.

    raises  InputError for an outline that crosses itself
    """
    return [[o.cells(r) for r in rings] for rings in areas_in(o.file.wkt, outlines, extent)]


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
        raise InputError("two of the outlines overlap; give areas that lie apart, or one round all of them")
    lost = 1 - float(found.sum()) / wanted
    if lost > OUTSIDE:
        f = o.file
        reach = f"{f.left:g} {f.top - f.height * f.cell:g} {f.left + f.width * f.cell:g} {f.top:g}"
        raise InputError(f"{lost:.1%} of the outline lies beyond the heights, which reach over {reach}")
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
        return [rings for given in outlines for rings in _areas(wkt, given)]
    left, bottom, right, top = extent
    if not (left < right and bottom < top):
        raise InputError(f"the extent {left:g} {bottom:g} {right:g} {top:g} is empty; give left, bottom, right, top")
    return [[np.array([[left, bottom], [right, bottom], [right, top], [left, top]])]]


def _shapes(given: str, name: str) -> tuple[Shape, ...]:
    """What a file or coordinates hold.

    raises  InputError for numbers that are no corners, an empty text, and as `read_shapes` does
    """
    if not given.strip():
        raise InputError(f"{option(name, given)} is empty; give a file, or corners as X Y, X Y, ...")
    if not Path(given).exists() and re.fullmatch(r"[\d\s.,;+\-eE]+", given) and re.search(r"\d", given):
        pairs = [p.split() for p in re.split(r"[;,]", given)]
        if any(len(p) != 2 or None in map(number_of, p) for p in pairs):
            raise InputError(
                f"{option(name, given)} is no file and no corners: these are written X Y, X Y, ... with a blank "
                "between the two numbers of a corner and a comma between corners"
            )
    return read_shapes(given)


def _areas(wkt: str, given: str) -> list[list[Array]]:
    """The rings of each area, the outer one first, in coordinates of the plane."""
    path = Path(given)
    if path.suffix.lower() in TEXT and path.is_file():
        return [[checked_ring(read_outline(path), name=path.name)]]
    shapes = [s for s in _shapes(given, "outline") if s.kind == "area"]
    if not shapes:
        if path.exists():
            raise InputError("holds no area; lines and points enclose nothing", file=path)
        raise InputError(f"{option('outline', given)} holds no area: it has fewer than three corners")
    found = list[list[Array]]()
    for s in shapes:
        rings = [_in_plane(wkt, r, s.crs, typed=s.typed, path=path) for r in (s.xy, *s.holes)]
        checked = [checked_ring(r) for r in rings]
        _check_holes(checked)
        found.append(checked)
    return found


def _check_holes(rings: Sequence[Array]) -> None:
    """That holes of an area lie within it and apart from each other: what is enclosed is not known otherwise.

    raises  InputError where one does not, with the place
    """

    def refuse(what: str, place: Array) -> None:
        raise InputError(
            f"the outline has {what} near {place[0]:.8g}, {place[1]:.8g}: what it encloses there is not known; give "
            "areas whose holes lie within them and apart from each other"
        )

    outer, *holes = rings
    for k, hole in enumerate(holes, 1):
        if (place := astray(hole, outer, within=False)) is not None:
            refuse(f"hole {k} outside of its edge", place)
        for n, other in enumerate(holes[: k - 1], 1):
            apart = (hole.min(axis=0) > other.max(axis=0)).any() or (other.min(axis=0) > hole.max(axis=0)).any()
            if apart:
                continue
            place = astray(hole, other, within=True)
            place = astray(other, hole, within=True) if place is None else place
            if place is None and np.isclose(signed_area(hole), signed_area(other), rtol=1e-9, atol=0):
                place = hole[0] if astray(hole, other, within=False) is None else None
            if place is not None:
                refuse(f"hole {k} over hole {n}", place)
    if holes and _size(rings) <= LEAST * signed_area(outer):
        refuse("holes that leave nothing of it", outer[0])


def lines_of(o: Opened, given: str) -> list[Array]:
    """The lines (k, 2) in a file or in coordinates, in those of the grid."""
    path = Path(given)
    if path.suffix.lower() in TEXT and path.is_file():
        found = [read_outline(path)]
    else:
        shapes = [s for s in _shapes(given, "line") if s.kind != "place"]
        if not shapes:
            if path.exists():
                raise InputError("holds no line", file=path)
            raise InputError(f"{option('line', given)} is a single place; a line needs two corners or more")
        # of coordinates that were typed, three places or more are a line here, and no area
        found = [_in_plane(o.file.wkt, s.xy, s.crs, typed=s.typed, path=path) for s in shapes]
    for line in found:
        if len(line) < 2 or not np.linalg.norm(np.diff(line, axis=0), axis=1).min() > 0:
            raise InputError(
                "a line needs two different places, one after the other" + ("" if path.exists() else f": {given}"),
                file=path if path.exists() else None,
            )
    return found


def _in_plane(wkt: str, xy: Array, crs: str, *, typed: bool, path: Path) -> Array:
    """Coordinates of a file in those of a map, or of a plane of the object as they are."""
    if typed or not wkt:
        if not typed and crs and crs != GEOGRAPHIC:  # what says nothing is of the plane
            raise InputError(
                f"is in {system_name(crs)}, and these heights lie on a plane of the object, in no map; give "
                "coordinates of the plane, in a file that names no coordinate system",
                file=path,
            )
        if not typed and path.suffix.lower() in {".kml", ".kmz"}:
            raise InputError(
                "is in longitude and latitude, and these heights lie on a plane of the object, in no map; give "
                "coordinates of the plane, as CSV or GeoJSON",
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
        units = [f.unit or "no unit (free scale)" for f in (a, b)]
        raise InputError(f"is in {units[1]}, and {first.folder} in {units[0]}; both need one unit", file=second.folder)
    turn, move = _turned(first, second)
    scale = a.cell / b.cell
    if not 1 / COARSER <= scale <= COARSER:
        raise InputError(
            f"has cells of {b.cell:g}, and {first.folder} of {a.cell:g}; make both with cells of one size",
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
    why = ""
    if bool(a.wkt) != bool(b.wkt):
        why = "one lies in a map, the other on a plane of the object"
    elif a.wkt and parse_crs(a.wkt) != parse_crs(b.wkt):
        names = [system_name(f.system or f.wkt) for f in (b, a)]
        why = f"they are in different coordinate systems, {names[0]} and {names[1]}"
    if not why and a.wkt:
        if other := other_heights(b.system, a.system):
            raise InputError(
                f"{other}: a difference would be that of the two; make both surfaces of results in one system of plan "
                f"and heights ({option('crs', 'EPSG:PLAN+HEIGHT')} of `orient`)",
                file=second.folder,
            )
        return None, np.zeros(3)
    p, q = (_axes(f.plane) for f in (a, b))
    if not why and (p is None or q is None):
        why = "their planes are not known"
    if not why and p is not None and q is not None:
        turn, move = p[1] @ q[1].T, p[1] @ (q[0] - p[0])
        tall = float(np.nanmax(np.abs(second.model.heights.height)))
        size = max(abs(b.left), abs(b.top), b.width * b.cell, b.height * b.cell)
        off = max(float(np.abs(turn[:2, :2] - np.eye(2)).sum()) * size, float(np.abs(turn[:2, 2]).sum()) * tall)
        if off <= APART * b.cell:
            return turn, move
        far = f"{off / b.cell:.3g} cells, more than {APART:g}"
        why = f"their planes are turned against each other, which moves places by {far}"
    raise InputError(
        f"{why}: their heights are not above the same; make both surfaces with the same plane (by points that both "
        "have, or in one map), in one frame: with the same control",
        file=second.folder,
    )


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
