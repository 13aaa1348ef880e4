"""GeoPackage (OGC 12-128r19) by pyogrio, the extra `[geo]`: points, stations, footprints, control, what moved.

Geometries are written as WKB (OGC 06-103r4) that is made here, so that neither shapely nor geopandas is needed.
"""

from __future__ import annotations

import struct
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any, Literal

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.formats.base import Draft, Export, Format, register
from raybundle.io.formats.surveyed import Surveyed, surveyed
from raybundle.io.geo.parsed_systems import parse_crs, system_name
from raybundle.numerics.arrays import Array

POINT, LINE, POLYGON = 1001, 1002, 1003
"""Numbers of WKB for geometries with Z."""
Shape = Literal["Point Z", "LineString Z", "Polygon Z"]
METRES = {"m": ("metre", 1.0), "mm": ("millimetre", 0.001)}


@dataclass(frozen=True, slots=True, kw_only=True)
class Layer:
    """A table of the file."""

    name: str
    about: str
    shape: Shape
    geometry: Sequence[bytes]
    fields: Mapping[str, Sequence[str] | Array]


def write(export: Export, path: Path) -> Draft:
    """Write the layers; those of footprints, control and figures where there is something in them."""
    pyogrio = _pyogrio()
    s = surveyed(export)
    crs = system_of(s)
    layers = [_points(s), _stations(s), *(made(s) for made in (_footprints, _control, _figures, _displacements))]
    about = {"BLOCK": s.block.name, "SYSTEM": s.system_name or s.local_name, "WRITTEN_BY": "raybundle"}
    about |= {name.upper(): _text(" ".join(words.split())) for name, words in export.record.items()}
    for k, layer in enumerate(layer for layer in layers if len(layer.geometry) or layer.name in {"points", "stations"}):
        data = [_array([_text(w) for w in v]) if isinstance(v, list) else v for v in layer.fields.values()]
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # of the library, about values that are not known
                pyogrio.raw.write(
                    str(path), _array(layer.geometry), data, list(layer.fields), geometry_type=layer.shape, crs=crs,
                    driver="GPKG", layer=layer.name, append=k > 0, layer_metadata={"ABOUT": layer.about},
                    dataset_metadata=None if k else about,
                )  # fmt: skip
        except (pyogrio.errors.DataSourceError, pyogrio.errors.DataLayerError, pyogrio.errors.CRSError) as error:
            raise InputError("geopackage.not_written", detail=str(error).splitlines()[0][:200]) from None
    _check_system(s, str(pyogrio.read_info(str(path), layer="points")["crs"] or ""))
    return Draft(remarks=(*s.remarks, *s.footprint_remarks))


def system_of(s: Surveyed) -> str:
    """WKT of the system, with its heights where it shows them; of a local one an engineering system with its unit."""
    if s.system is not None:
        return s.system.to_wkt()
    word, metres = METRES.get(s.unit, ("unknown", 1.0))
    axes = "".join(f',AXIS["{n}",{way},ORDER[{k}],LENGTHUNIT["{word}",{metres}]]'
                   for k, (n, way) in enumerate((("x", "east"), ("y", "north")), 1))  # fmt: skip
    return f'ENGCRS["local system of the block",EDATUM["local"],CS[Cartesian,2]{axes}]'


def _check_system(s: Surveyed, written: str) -> None:
    """Raise InputError where GDAL wrote a system of another unit: it takes UTM in kilometres for that in metres."""
    if s.system is None or not written:
        return
    mine, other = (c.axis_info[0].unit_conversion_factor for c in (s.system, parse_crs(written)))
    if abs(mine / other - 1) > 1e-9:
        raise InputError("geopackage.other_unit", system=s.system_name, written=system_name(written))


def _pyogrio() -> Any:
    try:
        library: Any = import_module("pyogrio")  # an extra
        import_module("pyogrio.raw")
    except ImportError:
        raise InputError("package.pyogrio_missing") from None
    return library


def _points(s: Surveyed) -> Layer:
    fields = {
        "id": s.names, "role": s.roles, **_axes("", s, s.xyz), **_axes("s", s, s.sigma),
        "rays": s.rays.astype(np.int32),
    }  # fmt: skip
    about = (
        "object points; s..: standard deviations in the unit of the axis; rays: photographs in which it was measured"
    )
    return Layer(name="points", about=about, shape="Point Z", geometry=points_wkb(s.xyz), fields=fields)


def _stations(s: Surveyed) -> Layer:
    view = -s.rotation[:, 2, :]
    images, scene = s.block.images, s.scene
    fields: dict[str, Sequence[str] | Array] = {
        "id": [images.ids[k] for k in scene.source[s.photos].tolist()],
        "file": [scene.names[k] for k in s.photos.tolist()],
        "camera": [scene.cameras[k].id for k in scene.camera[s.photos].tolist()],
        **_axes("", s, s.stations), **_axes("s", s, s.station_sigma),
    }  # fmt: skip
    for k, name in enumerate(("omega", "phi", "kappa")):
        fields[f"{name}_deg"] = s.angles[:, k]
    for k, name in enumerate(("omega", "phi", "kappa")):
        fields[f"s{name}_deg"] = s.angle_sigma[:, k]
    fields["azimuth_deg"] = np.degrees(np.arctan2(view[:, 0], view[:, 1])) % 360
    fields["nadir_deg"] = np.degrees(np.arccos(np.clip(-view[:, 2], -1, 1)))
    about = (
        "projection centres; omega, phi, kappa turn the axes of the system to those of the image (x right, y up), "
        "with the standard deviations that they have in the frame of the adjustment"
    )
    return Layer(name="stations", about=about, shape="Point Z", geometry=points_wkb(s.stations), fields=fields)


def _footprints(s: Surveyed) -> Layer:
    images, scene = s.block.images, s.scene
    at = [scene.source[s.photos[row]] for row, _ in s.footprints]
    fields: dict[str, Sequence[str] | Array] = {
        "id": [images.ids[k] for k in at],
        "file": [scene.names[s.photos[row]] for row, _ in s.footprints],
    }
    about = "what photographs show of level ground at the median height of the points that each of them shows"
    rings = [ring_wkb(ring) for _, ring in s.footprints]
    return Layer(name="footprints", about=about, shape="Polygon Z", geometry=rings, fields=fields)


def _control(s: Surveyed) -> Layer:
    rows = np.array([k for k, role in enumerate(s.roles) if role != "tie"], np.int64)
    fields: dict[str, Sequence[str] | Array] = {
        "id": [s.names[k] for k in rows], "role": [s.roles[k] for k in rows], **_axes("", s, s.xyz[rows]),
        **_axes("d", s, s.differences[rows]), **_axes("s", s, s.sigma[rows]),
    }  # fmt: skip
    about = "control and check points as adjusted; d..: adjusted less given, where coordinates were given"
    return Layer(name="control", about=about, shape="Point Z", geometry=points_wkb(s.xyz[rows]), fields=fields)


def _figures(s: Surveyed) -> Layer:
    f = s.figures
    fields: dict[str, Sequence[str] | Array] = {
        "kind": [a.kind for a in f], "name": [a.name for a in f], "sigma": np.array([a.sigma for a in f], float),
    }  # fmt: skip
    about = f"distances, lines and outlines that were observed; sigma as given [{s.block.length_unit}]"
    lines = [line_wkb(np.vstack([a.xyz, a.xyz[:1]]) if a.closed else a.xyz) for a in f]
    return Layer(name="figures", about=about, shape="LineString Z", geometry=lines, fields=fields)


def _displacements(s: Surveyed) -> Layer:
    about = phrase("geopackage_layer.displacements")
    m, shape = s.export.displaced, "Point Z"
    if m is None:
        return Layer(name="displacements", about=about, shape=shape, geometry=[], fields={})
    rows = np.flatnonzero(np.isfinite(m.xyz).all(axis=1))
    at = s.placed(m.xyz[rows] / s.metres)
    A = s.axes_at(at)
    C = A @ m.covariance[rows] @ np.swapaxes(A, -1, -2)
    fields: dict[str, Sequence[str] | Array] = {
        "id": [m.point[k] for k in rows], "from": [m.start[k] for k in rows], "to": [m.end[k] for k in rows],
        **_axes("d", s, (A @ m.vector[rows, :, None])[:, :, 0]),
        **_axes("sd", s, np.sqrt(np.diagonal(C, axis1=1, axis2=2))),
        "length": np.linalg.norm(m.vector[rows], axis=1), "p": m.p[rows], "verdict": [m.verdict[k] for k in rows],
    }  # fmt: skip
    return Layer(name="displacements", about=about, shape=shape, geometry=points_wkb(at), fields=fields)


def _axes(before: str, s: Surveyed, values: Array) -> dict[str, Array]:
    return {f"{before}{a}": np.ascontiguousarray(values[:, k]) for k, a in enumerate(s.axes)}


def points_wkb(xyz: Array) -> list[bytes]:
    """Of points (n, 3)."""
    rows = np.zeros(len(xyz), np.dtype([("order", "u1"), ("kind", "<u4"), ("xyz", "<f8", 3)]))
    rows["order"], rows["kind"], rows["xyz"] = 1, POINT, xyz
    data, size = rows.tobytes(), rows.itemsize
    return [data[k : k + size] for k in range(0, len(data), size)]


def line_wkb(xyz: Array) -> bytes:
    """Of a line through corners (k, 3)."""
    return struct.pack("<BII", 1, LINE, len(xyz)) + np.asarray(xyz, "<f8").tobytes()


def ring_wkb(xyz: Array) -> bytes:
    """Of a polygon with corners (k, 3), the first of which is repeated at the end."""
    closed = np.vstack([xyz, xyz[:1]])
    return struct.pack("<BIII", 1, POLYGON, 1, len(closed)) + np.asarray(closed, "<f8").tobytes()


def _array(values: Sequence[object]) -> Array:
    result = np.empty(len(values), object)
    result[:] = values
    return result


def _text(words: str) -> str:
    """Words that any program can show: what is no letter (of file names that are no UTF-8, say) becomes "?"."""
    return words if words.isprintable() else "".join(c if c.isprintable() else "?" for c in words)


register(
    Format(
        name="gpkg",
        title="GeoPackage: points, stations, footprints, control (extra [geo])",
        kind="file",
        observations=False,
        suffix=".gpkg",
        write=write,
        metric=True,
        in_plane=True,
    )
)
