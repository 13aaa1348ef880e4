"""Areas, ways and places from files: GeoJSON, KML, KMZ, or what OGR reads (extra `geo`); or from coordinates."""

from __future__ import annotations

import re
import struct
import zipfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from raybundle.errors import InputError
from raybundle.io.geo.parsed_systems import parse_crs, utm_at
from raybundle.io.reading.files import UNPACKING, check_regular, guarded, read_bytes
from raybundle.io.reading.trees import Json, read_json
from raybundle.io.reading.words import number_of, quoted
from raybundle.io.reading.xml import Element, xml_of
from raybundle.numerics.arrays import Array
from raybundle.readable import readable

if TYPE_CHECKING:
    from pyproj import CRS

Kind = Literal["area", "line", "place"]
GEOGRAPHIC = "EPSG:4326"
NAMED = "OGC:CRS84"
"""The same, longitude first, where a file names it"""
CORNERS = 100_000
NAMES = ("name", "Name", "NAME", "id", "ID")
"""Properties that name a feature, the first of them that it has"""
_SHAPES = {"Polygon": "area", "LineString": "line", "Point": "place"}
_WKB = {1: "place", 2: "line", 3: "area"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Shape:
    """An outline as it was given."""

    kind: Kind
    xy: Array
    """(n, 2) x or longitude before y or latitude, in `crs`; a polygon's last corner is not its first"""
    holes: tuple[Array, ...] = ()
    crs: str = GEOGRAPHIC
    typed: bool = False
    """whether it was given as coordinates, so that what they are follows from what they are for"""
    name: str = ""


def read_shapes(given: str, crs: str = "") -> tuple[Shape, ...]:
    """The outlines in a file, or those of coordinates: "LON LAT, LON LAT, ...".

    crs     of coordinates, or of a file that does not say; "" for longitude and latitude in WGS 84
    raises  InputError for a file that holds none, with the place
    """
    path = Path(given)
    if not path.exists():
        typed = _typed(given)
        if typed is not None:
            kind: Kind = "area" if len(typed) > 2 else "line" if len(typed) == 2 else "place"
            return (replace(_shape(kind, typed, (), crs), typed=True),)
    suffix = path.suffix.lower()
    if suffix in {".geojson", ".json"}:
        shapes = tuple(_geojson(read_json(path), crs))
    elif suffix in {".kml", ".kmz"}:
        data = read_bytes(path) if suffix == ".kml" else _unpacked(path)
        shapes = tuple(_kml(xml_of(data, path, "kml")))
    else:
        shapes = tuple(_ogr(path, crs))
    if not shapes:
        raise InputError("area.none", file=path)
    return shapes


def _shape(kind: Kind, xy: Array, holes: Sequence[Array], crs: str, name: str = "") -> Shape:
    def open_ring(ring: Array) -> Array:
        return ring[:-1] if kind == "area" and len(ring) > 1 and (ring[0] == ring[-1]).all() else ring

    return Shape(
        kind=kind, xy=open_ring(xy), holes=tuple(open_ring(h) for h in holes), crs=crs or GEOGRAPHIC, name=name
    )


def _typed(text: str) -> Array | None:
    """Pairs of numbers with commas or semicolons between the pairs."""
    rows: list[list[float]] = []
    for part in re.split(r"[;,]", text):
        values = [number_of(w) for w in part.split()]
        if len(values) != 2 or values[0] is None or values[1] is None:
            return None
        rows.append([values[0], values[1]])
    return np.array(rows)


def _geojson(top: Json, crs: str) -> Iterator[Shape]:
    """RFC 7946: longitude, latitude in WGS 84; the older member `crs` is taken where it stands."""
    named = top.value.get("crs") if isinstance(top.value, dict) else None
    own = crs
    if isinstance(named, dict) and top.get("crs").has("properties") and top.get("crs").get("properties").has("name"):
        own = top.get("crs").get("properties").get("name").text()
        own = NAMED if "CRS84" in own else re.sub(r"^urn:ogc:def:crs:EPSG:[^:]*:", "EPSG:", own)
    for geometry, name in _geometries(top):
        kind = geometry.get("type").text()
        parts = geometry.get("coordinates")
        single = kind.removeprefix("Multi")
        if single not in _SHAPES:
            continue
        for one in parts.items() if kind != single else [parts]:
            if single == "Polygon":
                rings = [_pairs(r) for r in one.items()]
                if rings:
                    yield _shape("area", rings[0], rings[1:], own, name)
            elif single == "LineString":
                yield _shape("line", _pairs(one), (), own, name)
            else:
                yield _shape("place", _pair(one)[None], (), own, name)


def _geometries(value: Json, name: str = "") -> Iterator[tuple[Json, str]]:
    """Geometries, each with the name of its feature."""
    kind = value.get("type").text()
    if kind == "FeatureCollection":
        for feature in value.get("features").items():
            yield from _geometries(feature)
    elif kind == "Feature":
        if value.has("geometry"):
            yield from _geometries(value.get("geometry"), _name_in(value.value.get("properties")))
    elif kind == "GeometryCollection":
        for geometry in value.get("geometries").items():
            yield from _geometries(geometry, name)
    else:
        yield value, name


def _name_in(properties: Any) -> str:
    """The name among the properties of a feature; empty: there is none."""
    known = properties if isinstance(properties, dict) else {}
    texts = (str(v).strip() for k in NAMES if isinstance(v := known.get(k), str | int | float))
    return next((readable(t) for t in texts if t), "")


def _pairs(value: Json) -> Array:
    items = value.items()
    if len(items) > CORNERS:
        value.fail("area.too_many_points", n=len(items), most=CORNERS)
    return np.array([_pair(i) for i in items]).reshape(-1, 2)


def _pair(value: Json) -> Array:
    numbers = value.items()
    if len(numbers) < 2:
        value.fail("value.count", n=len(numbers), needed=2)
    return np.array([numbers[0].number(), numbers[1].number()])


def _unpacked(path: Path) -> bytes:
    """The first KML in a KMZ."""
    check_regular(path)
    try:
        with guarded(path), zipfile.ZipFile(path) as archive:
            inner = [i for i in archive.infolist() if i.filename.lower().endswith(".kml")]
            if not inner:
                raise InputError("archive.file_missing", name=".kml", file=path)
            if inner[0].file_size > 1 << 26:
                raise InputError(
                    "archive.file_too_large",
                    name=inner[0].filename,
                    size_bytes=inner[0].file_size,
                    limit_bytes=1 << 26,
                    file=path,
                )
            return archive.read(inner[0])
    except UNPACKING as error:
        raise InputError("archive.not_unpacked", detail=str(error), file=path) from None


def _kml(element: Element, name: str = "") -> Iterator[Shape]:
    """Polygons, lines and points anywhere in a document; KML is in longitude and latitude, always."""
    for child in element.children:
        if child.name == "Polygon":
            holes = [_coordinates(i.get("LinearRing", "coordinates")) for i in child.all("innerBoundaryIs")]
            outer = _coordinates(child.get("outerBoundaryIs", "LinearRing", "coordinates"))
            yield _shape("area", outer, holes, "", name)
        elif child.name in {"LineString", "Point"}:
            kind: Kind = "line" if child.name == "LineString" else "place"
            yield _shape(kind, _coordinates(child.get("coordinates")), (), "", name)
        elif child.name == "Placemark":
            yield from _kml(child, next((readable(c.content.strip()) for c in child.children if c.name == "name"), ""))
        else:
            yield from _kml(child, name)


def _coordinates(element: Element) -> Array:
    rows: list[list[float]] = []
    for word in element.content.split():
        values = [number_of(v) for v in word.split(",")]
        if len(values) < 2 or values[0] is None or values[1] is None:
            element.fail("area.no_position", text=quoted(word))
        rows.append([values[0], values[1]])
    return np.array(rows).reshape(-1, 2)


def _ogr(path: Path, crs: str) -> Iterator[Shape]:
    """What OGR reads: GeoPackage, shapefile, FlatGeobuf and others."""
    check_regular(path)
    try:
        reader: Any = import_module("pyogrio.raw")  # an extra
    except ImportError:
        raise InputError(
            "package.pyogrio_missing",
            file=path,
        ) from None
    try:
        about, _, geometry, columns = reader.read(path, columns=list(NAMES), force_2d=True)
    except Exception as error:  # noqa: BLE001  (GDAL's drivers raise what they like on damaged files)
        found = str(error).splitlines()[0] if path.suffix.lower() not in {".wkt", ".txt", ".csv"} else ""
        raise InputError(
            "area.not_readable",
            detail=found or path.suffix,
            file=path,
        ) from None
    own = str(about.get("crs") or crs)
    for k, data in enumerate(geometry):
        if data is not None:
            name = _name_in({field: values[k] for field, values in zip(about["fields"], columns, strict=True)})
            for shape in _wkb(_Bytes(bytes(data)), path, own):
                yield replace(shape, name=name)


class _Bytes:
    """Bytes and how far they were read."""

    def __init__(self, data: bytes) -> None:
        self.data, self.at = data, 0

    def take(self, layout: str) -> tuple[Any, ...]:
        """The next values of a layout of `struct`."""
        values = struct.unpack_from(layout, self.data, self.at)
        self.at += struct.calcsize(layout)
        return values


def _wkb(source: _Bytes, path: Path, crs: str) -> Iterator[Shape]:
    """Well-known binary (OGC 06-103r4, section 8)."""
    try:
        order = "<" if source.take("B")[0] == 1 else ">"
        code = source.take(order + "I")[0] % 1000
        if code in {4, 5, 6, 7}:
            for _ in range(source.take(order + "I")[0]):
                yield from _wkb(source, path, crs)
        elif code == 1:
            yield _shape("place", np.array([source.take(order + "2d")]), (), crs)
        elif code == 2:
            yield _shape("line", _ring(source, order), (), crs)
        elif code == 3:
            rings = [_ring(source, order) for _ in range(source.take(order + "I")[0])]
            if rings:
                yield _shape("area", rings[0], rings[1:], crs)
    except (struct.error, ValueError):
        raise InputError("area.damaged", file=path) from None


def _ring(source: _Bytes, order: str) -> Array:
    count = source.take(order + "I")[0]
    if count > CORNERS:
        raise ValueError
    return np.array(source.take(f"{order}{2 * count}d")).reshape(-1, 2)


def plane_crs(shape: Shape) -> str:
    """A plane coordinate system in metres for an outline: its own where that is one, else its zone of UTM."""
    system = parse_crs(shape.crs)
    if is_metric(system):
        return shape.crs
    lon, lat = in_crs(shape.xy, shape.crs, GEOGRAPHIC).mean(axis=0)
    code = utm_at(lon, lat)
    if code is None:
        raise InputError("area.no_utm", latitude_deg=lat)
    return code


def is_metric(system: CRS) -> bool:
    """Whether a coordinate system is a plane one in metres."""
    return system.is_projected and all(abs(a.unit_conversion_factor - 1) < 1e-12 for a in system.axis_info[:2])


def in_crs(xy: Array, source: str, target: str) -> Array:
    """Coordinates (n, 2) of one system in another; raises InputError where one lies outside of it."""
    from pyproj import Transformer

    if parse_crs(source).is_geographic:
        bad = np.flatnonzero((np.abs(xy[:, 0]) > 360) | (np.abs(xy[:, 1]) > 90))
        if len(bad):
            x, y = xy[bad[0]]
            raise InputError("area.not_degrees", x=x, y=y)
    if source == target:
        return np.asarray(xy, float)
    transformer = Transformer.from_crs(parse_crs(source), parse_crs(target), always_xy=True)
    padded = np.vstack([xy, xy])  # pyproj takes arrays of one value for numbers
    x, y = transformer.transform(padded[:, 0], padded[:, 1])
    result = np.stack([x, y], axis=1)[: len(xy)]
    bad = np.flatnonzero(~np.isfinite(result).all(axis=1))
    if len(bad):
        a, b = xy[bad[0]]
        raise InputError("area.outside_system", x=a, y=b, system=target[:60])
    return result
