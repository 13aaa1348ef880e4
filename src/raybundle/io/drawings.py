"""Lines and areas as files: DXF by ezdxf, GeoPackage by pyogrio (both of the extra `[geo]`), GeoJSON."""

from __future__ import annotations

import json
import struct
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from importlib import import_module
from pathlib import Path
from typing import Any, Literal

import numpy as np

from raybundle.errors import InputError
from raybundle.io.formats.dxf import INSUNITS, VERSION
from raybundle.io.missions.areas import GEOGRAPHIC, in_crs
from raybundle.numerics.arrays import Array

WKB = {"line": 1002, "area": 1003}
"""Numbers of WKB for geometries with Z."""
GDAL = {"line": "LineString Z", "area": "Polygon Z"}
FORBIDDEN = frozenset('<>/\\":;?*|=`,')
"""Characters that names of layers in DXF cannot have"""
COLOURS = (7, 8, 5, 1, 3)
"""AutoCAD colour indices of layers in their order: black, grey, blue, red, green"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawn:
    """A line or an area with what is reported of it."""

    kind: Literal["line", "area"]
    rings: tuple[Array, ...]
    """(n, 2) or (n, 3) coordinates; of an area the outer ring and its holes, each closed"""
    layer: str = "lines"
    fields: Mapping[str, float | str] = field(default_factory=dict[str, float | str])


@dataclass(frozen=True, slots=True, kw_only=True)
class Label:
    """Words in a drawing."""

    text: str
    place: tuple[float, float, float]
    size: float
    angle_deg: float = 0.0
    layer: str = "labels"


def write_dxf(path: Path, drawn: Sequence[Drawn], labels: Sequence[Label], unit: str, about: Mapping[str, str]) -> None:
    """A drawing with polylines on layers, and words."""
    try:
        ezdxf: Any = import_module("ezdxf")
    except ImportError:
        raise InputError("package.ezdxf_missing") from None
    drawing = ezdxf.new(VERSION)
    drawing.header["$INSUNITS"] = INSUNITS.get(unit, 0)
    drawing.header["$MEASUREMENT"] = 0 if unit in {"ft", "us-ft"} else 1
    for name, value in about.items():
        drawing.header.custom_vars.append(name, value)
    layers = {name: _layer(name) for name in (*(d.layer for d in drawn), *(t.layer for t in labels))}
    for k, name in enumerate(layers.values()):
        if name not in drawing.layers:
            drawing.layers.add(name, color=COLOURS[k % len(COLOURS)])
    space = drawing.modelspace()
    for d in drawn:
        for ring in d.rings:
            to = {"layer": layers[d.layer]}
            if ring.shape[1] == 2:
                space.add_lwpolyline(ring.tolist(), dxfattribs=to)
            elif np.ptp(ring[:, 2]) == 0:
                flat = space.add_lwpolyline(ring[:, :2].tolist(), dxfattribs=to)
                flat.dxf.elevation = float(ring[0, 2])
            else:
                space.add_polyline3d(ring.tolist(), dxfattribs=to)
    for t in labels:
        words = space.add_text(t.text, height=t.size, rotation=t.angle_deg, dxfattribs={"layer": layers[t.layer]})
        words.set_placement(t.place, align=ezdxf.enums.TextEntityAlignment.MIDDLE_CENTER)
    with path.open("w", encoding=drawing.output_encoding, errors="dxfreplace") as file:
        drawing.write(file)


def _layer(name: str) -> str:
    """A name that DXF allows for a layer."""
    return "".join("_" if c in FORBIDDEN else c for c in name)[:255]


def write_geojson(path: Path, drawn: Sequence[Drawn], wkt: str) -> None:
    """RFC 7946: longitude and latitude of a map; coordinates of a plane of the object as they are, which it states."""
    features = [
        {
            "type": "Feature", "properties": dict(d.fields),
            "geometry": {
                "type": "LineString" if d.kind == "line" else "Polygon",
                "coordinates": _in_degrees(d.rings[0], wkt) if d.kind == "line" else [
                    _in_degrees(r, wkt) for r in d.rings
                ],
            },
        }
        for d in drawn
    ]  # fmt: skip
    collection: dict[str, Any] = {"type": "FeatureCollection", "features": features}
    if not wkt:
        collection["coordinates"] = "of a plane of the object: right, up, height above it; no longitude and latitude"
    path.write_text(json.dumps(collection) + "\n", encoding="utf-8")


def _in_degrees(ring: Array, wkt: str) -> list[list[float]]:
    if not wkt:
        return [[round(float(v), 9) for v in row] for row in ring]
    xy = in_crs(ring[:, :2], wkt, GEOGRAPHIC)
    return np.round(np.column_stack([xy, ring[:, 2:]]), 9).tolist()


def write_gpkg(path: Path, drawn: Sequence[Drawn], layer: str, wkt: str) -> None:
    """A GeoPackage with one layer; fields are those of the first, numbers or words."""
    try:
        pyogrio: Any = import_module("pyogrio")
        import_module("pyogrio.raw")
    except ImportError:
        raise InputError("package.pyogrio_missing") from None
    kind = drawn[0].kind if drawn else "line"
    shapes = np.array([_wkb(d) for d in drawn], object)
    names = list(drawn[0].fields) if drawn else []
    data = [np.array([d.fields[n] for d in drawn]) for n in names]
    data = [v.astype(object) if v.dtype.kind == "U" else v for v in data]
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of the library, about a system that is not known
            pyogrio.raw.write(
                str(path), shapes, data, names, geometry_type=GDAL[kind], crs=wkt or None, driver="GPKG", layer=layer
            )
    except (pyogrio.errors.DataSourceError, pyogrio.errors.DataLayerError, pyogrio.errors.CRSError) as error:
        raise InputError("geopackage.not_written", detail=str(error).splitlines()[0][:200]) from None


def _wkb(d: Drawn) -> bytes:
    parts = [struct.pack("<I", len(r)) + _with_z(r).tobytes() for r in d.rings]
    head = struct.pack("<BI", 1, WKB[d.kind])
    return head + (parts[0] if d.kind == "line" else struct.pack("<I", len(parts)) + b"".join(parts))


def _with_z(ring: Array) -> Array:
    z = ring[:, 2] if ring.shape[1] == 3 else np.zeros(len(ring))
    return np.ascontiguousarray(np.column_stack([ring[:, :2], z]), "<f8")
