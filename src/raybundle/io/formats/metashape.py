"""Metashape cameras.xml: sensors, camera positions and markers, written and read.

Pixel frame as ours; cx, cy count from the image centre.  u = w/2 + cx + x' (f + b1) + y' b2, v = h/2 + cy + y' f,
with the tangential terms p1, p2 in the reverse order of OpenCV's (Metashape user manual, camera models).  A
camera's transform turns and shifts camera axes (x right, y down, z forward) to the chunk's, the chunk's transform
from there to object space.
"""

from __future__ import annotations

from dataclasses import replace
from html import escape
from pathlib import Path, PurePosixPath

import numpy as np

from raybundle.block import Role
from raybundle.cameras.conversions import forward_fit, terms_for
from raybundle.io.digits import exact
from raybundle.io.formats.base import (
    SENSOR_FROM_CV,
    Draft,
    Export,
    Format,
    Import,
    Scene,
    block_of,
    deviation_remark,
    register,
    scene,
)
from raybundle.io.formats.metashape_chunk import NO_GEOMETRY, Reading, chunk_of, read_images, read_markers, read_sensors
from raybundle.io.reading.ledger import declare
from raybundle.io.reading.xml import read_xml
from raybundle.numerics.arrays import Array

TERMS = ("fx", "fy", "cx", "cy", "skew", "k1", "k2", "k3", "k4", "p1", "p2")
LOCAL = (
    'LOCAL_CS["Local Coordinates (m)",LOCAL_DATUM["Local Datum",0],UNIT["metre",1,AUTHORITY["EPSG","9001"]],'
    'AXIS["X",EAST],AXIS["Y",NORTH],AXIS["Z",UP]]'
)


def write(export: Export, path: Path) -> Draft:
    """Write sensors, cameras, and the control and check points with their image observations as markers."""
    s = scene(export)
    sensors, deviations = _sensors(s)
    stems = [n.removesuffix(PurePosixPath(n).suffix) for n in s.names]
    labels = stems if len(set(stems)) == len(stems) else list(s.names)
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', '<document version="2.0.0">', '<chunk label="raybundle">']
    lines += [f'<sensors next_id="{len(s.cameras)}">', *sensors, "</sensors>"]
    lines.append(f'<cameras next_id="{len(labels)}" next_group_id="0">')
    for k, label in enumerate(labels):
        M = np.eye(4)
        M[:3, :3], M[:3, 3] = s.rotation[k].T @ SENSOR_FROM_CV, s.centre[k]
        lines.append(f'<camera id="{k}" sensor_id="{int(s.camera[k])}" label="{escape(label)}">')
        lines.append(f"<orientation>1</orientation><transform>{_row(M.ravel())}</transform></camera>")
    lines.append("</cameras>")
    lines += _markers(s, export)
    lines += [f"<reference>{escape(LOCAL)}</reference>", "<transform>"]
    lines += [f'<rotation locked="true">{_row(np.eye(3).ravel())}</rotation>']
    lines += ['<translation locked="true">0 0 0</translation><scale locked="true">1</scale>', "</transform>"]
    lines += ["</chunk>", "</document>"]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    remarks, largest = deviation_remark(deviations)
    return Draft(remarks=(*s.remarks, *remarks), deviation_px=largest)


def _row(values: Array) -> str:
    return " ".join(exact(v) for v in np.asarray(values, float).tolist())


def _sensors(s: Scene) -> tuple[list[str], list[tuple[str, str, float]]]:
    lines: list[str] = []
    deviations: list[tuple[str, str, float]] = []
    for k, camera in enumerate(s.cameras):
        kind = "fisheye" if camera.sensor.all_round else "frame"
        fit = forward_fit(
            camera, terms_for(camera, TERMS), projection="equidistant" if kind == "fisheye" else "central"
        )
        f = fit.camera
        deviations.append((camera.id, f"a Metashape {kind} camera", fit.deviation_px))
        size = f'<resolution width="{f.width_px}" height="{f.height_px}"/>'
        values = {
            "f": f.fy, "cx": f.cx - f.width_px / 2, "cy": f.cy - f.height_px / 2,
            "b1": f.fx - f.fy, "b2": f.skew, "k1": f.k1, "k2": f.k2, "k3": f.k3, "k4": f.k4, "p1": f.p2, "p2": f.p1,
        }  # fmt: skip
        lines += [
            f'<sensor id="{k}" label="{escape(camera.id)}" type="{kind}">{size}',
            f'<property name="pixel_width" value="{exact(camera.pixel_mm[0])}"/>',
            f'<property name="pixel_height" value="{exact(camera.pixel_mm[1])}"/>',
            f'<calibration type="{kind}" class="adjusted">{size}',
            "".join(f"<{n}>{exact(v)}</{n}>" for n, v in values.items() if v or n == "f"),
            "</calibration></sensor>",
        ]
    return lines, deviations


def _markers(s: Scene, export: Export) -> list[str]:
    block = export.block
    named = [k for k, p in enumerate(s.points.tolist()) if block.points.role[p] != Role.TIE]
    if not named:
        return []
    lines = [f'<markers next_id="{len(named)}" next_group_id="0">']
    for number, k in enumerate(named):
        p = int(s.points[k])
        enabled = "true" if block.points.role[p] == Role.CONTROL else "false"
        lines.append(f'<marker id="{number}" label="{escape(block.points.ids[p])}">')
        lines.append(f'<reference {_reference(export, p)} enabled="{enabled}"/></marker>')
    lines += ["</markers>", '<frames next_id="1"><frame id="0"><markers>']
    for number, k in enumerate(named):
        lines.append(f'<marker marker_id="{number}">')
        for row in np.flatnonzero(s.point == k).tolist():
            x, y = s.xy_px[row].tolist()
            lines.append(f'<location camera_id="{int(s.image[row])}" pinned="true" x="{exact(x)}" y="{exact(y)}"/>')
        lines.append("</marker>")
    return [*lines, "</markers></frame></frames>"]


def _reference(export: Export, p: int) -> str:
    """Given coordinates and standard deviations of a point as attributes; those that are not given are missing."""
    points = export.block.points
    given = points.xyz[p] if export.given is None else np.where(np.isfinite(export.given[p]), export.given[p], np.nan)
    if not np.isfinite(given).any():
        given = points.xyz[p]
    known = np.isfinite(points.sigma[p])
    reported = known if known.any() else np.isfinite(given)
    words = [f'{n}="{exact(v)}"' for n, v, t in zip("xyz", given.tolist(), reported.tolist(), strict=True) if t]
    words += [f's{n}="{exact(v)}"' for n, v in zip("xyz", points.sigma[p].tolist(), strict=True) if np.isfinite(v)]
    return " ".join(words)


def read(path: Path) -> Import:
    """Cameras, images and markers of the first enabled chunk; images that were not aligned stay without orientation."""
    root = read_xml(path, "document")
    declare(*NO_GEOMETRY)
    chunks = list(root.all("chunk"))
    found = Reading(path)
    chunk = chunk_of(chunks, found) if chunks else root.get("chunk")
    cameras = read_sensors(chunk, found)
    images, numbers, free_scale = read_images(chunk, cameras, found)
    tracks, control = read_markers(chunk, numbers, found)
    block, more = block_of(
        name=path.stem, source="Metashape", cameras=tuple(cameras.values()), images=images, tracks=tracks
    )
    points = replace(block.points, role=control.role, xyz=control.xyz, sigma=control.sigma)
    block = replace(block, points=points, free_scale=free_scale)
    largest = max(found.deviations, default=0.0)
    return Import(block=block, remarks=(*found.all_remarks(), *more), deviation_px=largest)


register(
    Format(
        name="metashape",
        title="Metashape cameras.xml (cameras and markers)",
        kind="file",
        points="named",
        suffix=".xml",
        write=write,
        read=read,
        looks=lambda path: path.suffix.lower() == ".xml" and not path.is_dir(),
    )
)
