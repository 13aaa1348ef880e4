"""PLY point clouds: object points with colour and standard deviations, and the stations in a file beside."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.io.folders import new_files
from raybundle.io.formats.base import Draft, Export, Format, register
from raybundle.io.formats.surveyed import Surveyed, surveyed
from raybundle.numerics.arrays import Array

STATION_COLOUR = (220, 40, 40)
TYPES = {"f8": "double", "f4": "float", "u1": "uchar", "i4": "int"}


def write_vertices(
    path: Path, xyz: Array, colours: Array, extra: dict[str, Array] | None = None, comments: tuple[str, ...] = (),
    triangles: Array | None = None,
) -> None:  # fmt: skip
    """Write a binary PLY file of vertices (n, 3) with colours (n, 3) and more properties (n,) each, float.

    triangles  (m, 3) numbers of vertices; None: a cloud
    """
    write_in_parts(path, len(xyz), [(xyz, colours, extra or {})], comments, triangles)


def write_in_parts(
    path: Path, count: int, parts: Iterable[tuple[Array, Array, Mapping[str, Array]]], comments: tuple[str, ...] = (),
    triangles: Array | None = None,
) -> None:  # fmt: skip
    """Write a binary PLY file of `count` vertices that come part by part, all with the same properties.

    The file appears when it is whole.
    """
    with new_files(path) as (temporary,), temporary.open("wb") as file:
        begun = False
        for xyz, colours, extra in parts:
            rows = _rows(xyz, colours, extra)
            if not begun:
                file.write(_head(count, rows.dtype, comments, triangles))
                begun = True
            file.write(rows.tobytes())
        if not begun:
            nothing = np.zeros((0, 3))
            file.write(_head(0, _rows(nothing, nothing, {}).dtype, comments, triangles))
        if triangles is not None:
            faces = np.zeros(len(triangles), np.dtype([("count", "u1"), ("vertices", "<i4", (3,))]))
            faces["count"], faces["vertices"] = 3, triangles
            file.write(faces.tobytes())


def _rows(xyz: Array, colours: Array, extra: Mapping[str, Array]) -> Array:
    layout: list[Any] = [(axis, "<f8") for axis in "xyz"]
    layout += [(name, "u1") for name in ("red", "green", "blue")]
    layout += [(name, "<i4" if v.dtype.kind in "iu" else "<f4") for name, v in extra.items()]
    rows = np.zeros(len(xyz), np.dtype(layout))
    for k, axis in enumerate("xyz"):
        rows[axis] = xyz[:, k]
    for k, name in enumerate(("red", "green", "blue")):
        rows[name] = colours[:, k]
    for name, values in extra.items():
        rows[name] = values
    return rows


def _head(count: int, layout: np.dtype[Any], comments: tuple[str, ...], triangles: Array | None) -> bytes:
    names = layout.names or ()
    faces = [] if triangles is None else [f"element face {len(triangles)}", "property list uchar int vertex_indices"]
    lines = [
        "ply",
        "format binary_little_endian 1.0",
        *(f"comment {c}" for c in comments),
        f"element vertex {count}",
        *(f"property {TYPES[layout[n].str.lstrip('<|')]} {n}" for n in names),
        *faces,
        "end_header",
    ]
    return ("\n".join(lines) + "\n").encode("ascii", "replace")


def write(export: Export, path: Path) -> Draft:
    """Write the points, and the projection centres to NAME-stations.ply; sigma is NaN where it is not known.

    Coordinates are doubles, those of a georeferenced block in its system: CloudCompare and PDAL read them in full.
    Readers of single precision, as MeshLab is, round east and north of a map to some decimetres.
    """
    view = surveyed(export)
    s = view.scene
    comments = (*(('scale = "free"',) if export.block.free_scale else ()), *_system(view))
    if view.degrees:  # degrees and metres make no cloud
        view = surveyed(replace(export, frame=None))
    rays = np.bincount(s.point, minlength=len(s.xyz)).astype(np.int32)
    names = ("sigma_x", "sigma_y", "sigma_z")
    xyz = view.placed(s.xyz)
    sigma = view.sigma_of(s.points, xyz)
    write_vertices(path, xyz, s.colours, {**{n: sigma[:, k] for k, n in enumerate(names)}, "rays": rays}, comments)
    centre, sigma = view.stations, view.station_sigma
    red = np.tile(np.array(STATION_COLOUR, np.uint8), (len(centre), 1))
    stations = path.with_name(f"{path.stem}-stations{path.suffix}")
    write_vertices(stations, centre, red, {n: sigma[:, k] for k, n in enumerate(names)}, comments)
    reported = (f"PLY: {c}" for c in comments if c.startswith("crs"))
    return Draft(remarks=(*s.remarks, *reported))


def _system(view: Surveyed) -> tuple[str, ...]:
    """What the head states of the coordinate system, in ASCII."""
    frame = view.frame
    if frame is None:
        return ()
    name = view.system_name.encode("ascii", "replace").decode("ascii").replace("\n", " ")
    if not view.degrees:
        return (f"crs {name}",)
    origin = " ".join(f"{v:.10g}" for v in frame.origin)
    return (f"crs local east-north-up frame at {origin} of {name}, which is in degrees",)


register(
    Format(
        name="ply",
        title="PLY points with colour and sigma; stations beside",
        kind="file",
        observations=False,
        suffix=".ply",
        write=write,
        colours=True,
    )
)
