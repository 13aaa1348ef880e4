"""Metashape cameras.xml: sensors, camera positions and markers, written and read.

Pixel frame as ours; cx, cy count from the image centre.  u = w/2 + cx + x' (f + b1) + y' b2, v = h/2 + cy + y' f,
with the tangential terms p1, p2 in the reverse order of OpenCV's (Metashape user manual, camera models).  A
camera's transform turns and shifts camera axes (x right, y down, z forward) to the chunk's, the chunk's transform
from there to object space.
"""

from __future__ import annotations

from html import escape
from pathlib import Path, PurePosixPath

import numpy as np

from raybundle.block import Block, Camera, Images, Role
from raybundle.cameras.conversions import camera_from_forward, forward_fit, terms_for
from raybundle.cameras.forward_camera import ForwardCamera
from raybundle.io.digits import exact
from raybundle.io.formats.base import (
    SENSOR_FROM_CV,
    Draft,
    Export,
    Format,
    Import,
    Scene,
    Tracks,
    block_of,
    deviation_remark,
    fitted_camera,
    register,
    scene,
)
from raybundle.io.reading.words import quoted
from raybundle.io.reading.xml import Element, read_xml
from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import nearest_rotation

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
    lines += _markers(s, export.block)
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
        kind = "fisheye" if camera.model == "fisheye" else "frame"
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


def _markers(s: Scene, block: Block) -> list[str]:
    named = [k for k, p in enumerate(s.points.tolist()) if block.points.role[p] != Role.TIE]
    if not named:
        return []
    lines = [f'<markers next_id="{len(named)}" next_group_id="0">']
    for number, k in enumerate(named):
        p = int(s.points[k])
        x, y, z = s.xyz[k].tolist()
        given = f'x="{exact(x)}" y="{exact(y)}" z="{exact(z)}"'
        enabled = "true" if block.points.role[p] == Role.CONTROL else "false"
        lines.append(f'<marker id="{number}" label="{escape(block.points.ids[p])}">')
        lines.append(f'<reference {given} enabled="{enabled}"/></marker>')
    lines += ["</markers>", '<frames next_id="1"><frame id="0"><markers>']
    for number, k in enumerate(named):
        lines.append(f'<marker marker_id="{number}">')
        for row in np.flatnonzero(s.point == k).tolist():
            x, y = s.xy_px[row].tolist()
            lines.append(f'<location camera_id="{int(s.image[row])}" pinned="true" x="{exact(x)}" y="{exact(y)}"/>')
        lines.append("</marker>")
    return [*lines, "</markers></frame></frames>"]


def read(path: Path) -> Import:
    """Cameras, images and markers of the first chunk; images that Metashape did not align stay without orientation."""
    root = read_xml(path, "document")
    chunk = root.get("chunk")
    remarks: list[str] = []
    deviations: list[float] = []
    chunks = len(list(root.all("chunk")))
    if chunks > 1:
        remarks.append(f"the first of {chunks} chunks is read")
    cameras: dict[str, Camera] = {}
    for sensor in chunk.get("sensors").all("sensor"):
        camera = _read_sensor(sensor, path, remarks, deviations)
        if camera is not None:
            cameras[sensor.attribute("id")] = camera
    if not cameras:
        chunk.get("sensors").fail("no sensor has a calibration")
    images, numbers = _read_images(chunk, cameras, remarks)
    tracks = _read_markers(chunk, numbers)
    block, more = block_of(
        name=path.stem, source="Metashape", cameras=tuple(cameras.values()), images=images, tracks=tracks
    )
    return Import(block=block, remarks=(*remarks, *more), deviation_px=max(deviations, default=0.0))


def _read_sensor(sensor: Element, path: Path, remarks: list[str], deviations: list[float]) -> Camera | None:
    calibration = next((c for c in sensor.all("calibration") if c.attributes.get("class") == "adjusted"), None)
    calibration = calibration or sensor.find("calibration")
    if calibration is None:
        remarks.append(
            f"sensor {sensor.attributes.get('label', '?')} has no calibration and is left out with its images"
        )
        return None
    kind = calibration.attributes.get("type", sensor.attributes.get("type", "frame"))
    if kind not in {"frame", "fisheye"}:
        calibration.fail(f"sensor type {quoted(kind)} is not read; known: frame, fisheye")
    for term in ("p3", "p4"):
        if calibration.number(term, 0.0):
            calibration.fail(f"{term} is not known here; calibrate without p3 and p4")
    resolution = calibration.find("resolution") or sensor.get("resolution")
    width, height = (_whole(resolution, n) for n in ("width", "height"))
    f = calibration.number("f")
    b1 = calibration.number("b1", 0.0)
    if f <= 0 or f + b1 <= 0:
        calibration.fail(f"f = {f:g} px cannot be; it must be positive")
    forward = ForwardCamera(
        width_px=width,
        height_px=height,
        projection="equidistant" if kind == "fisheye" else "central",
        fx=f + b1,
        fy=f,
        cx=width / 2 + calibration.number("cx", 0.0),
        cy=height / 2 + calibration.number("cy", 0.0),
        skew=calibration.number("b2", 0.0),
        **{t: calibration.number(t, 0.0) for t in ("k1", "k2", "k3", "k4")},
        p1=calibration.number("p2", 0.0),
        p2=calibration.number("p1", 0.0),
    )
    id_ = sensor.attribute("id")
    fit = camera_from_forward(forward, id_, pixel_mm=_pixel(sensor), where=f"{path}: ")
    return fitted_camera(fit, f"camera {id_}", remarks, deviations)


def _pixel(sensor: Element) -> float | None:
    for p in sensor.all("property"):
        if p.attributes.get("name") == "pixel_height":
            size = _float(p, "value")
            return size if 0 < size < 1 else None
    return None


def _float(element: Element, name: str) -> float:
    return element.value(name)


def _whole(element: Element, name: str) -> int:
    value = _float(element, name)
    if value != int(value) or not 0 < value <= 10_000_000:
        element.fail(f"attribute {name} = {value:g} is no size in pixels")
    return int(value)


def _similarity(chunk: Element, remarks: list[str]) -> tuple[float, Array, Array]:
    """Scale, rotation and translation from the chunk's to object space."""
    element = chunk.find("transform")
    if element is None:
        remarks.append("the chunk has no transform; coordinates stand in its own frame, without scale")
        return 1.0, np.eye(3), np.zeros(3)
    reference = chunk.find("reference")
    if reference is not None and not reference.content.strip().startswith("LOCAL_CS"):
        remarks.append("the chunk is georeferenced: its coordinates are geocentric (X, Y, Z of the earth)")
    R = element.get("rotation").numbers(9).reshape(3, 3) if element.find("rotation") else np.eye(3)
    t = element.get("translation").numbers(3) if element.find("translation") else np.zeros(3)
    scale = element.number("scale", 1.0)
    if scale <= 0 or np.abs(R @ R.T - np.eye(3)).max() > 1e-4 or np.linalg.det(R) < 0:
        element.fail("is no similarity: the scale must be positive, the rotation orthogonal")
    return scale, nearest_rotation(R), t


def _read_images(chunk: Element, cameras: dict[str, Camera], remarks: list[str]) -> tuple[Images, dict[str, int]]:
    scale, R, t = _similarity(chunk, remarks)
    order = {id_: k for k, id_ in enumerate(cameras)}
    ids: list[str] = []
    index: list[int] = []
    centre: list[Array] = []
    rotation: list[Array] = []
    numbers: dict[str, int] = {}
    group = chunk.get("cameras")
    elements = [*group.all("camera"), *(c for g in group.all("group") for c in g.all("camera"))]
    for element in elements:
        sensor = element.attribute("sensor_id")
        if sensor not in order:
            continue
        label = element.attribute("label")
        if not label.isprintable() or not label or label != label.strip() or label in ids:
            element.fail(f"label {quoted(label)} is empty, stands twice or cannot be printed")
        numbers[element.attribute("id")] = len(ids)
        ids.append(label)
        index.append(order[sensor])
        X0, own = np.full(3, np.nan), np.full((3, 3), np.nan)
        if (transform := element.find("transform")) is not None:
            M = transform.numbers(16).reshape(4, 4)
            if np.abs(M[:3, :3] @ M[:3, :3].T - np.eye(3)).max() > 1e-4 or np.linalg.det(M[:3, :3]) < 0:
                transform.fail("its 3 x 3 part is no rotation")
            X0, own = scale * R @ M[:3, 3] + t, SENSOR_FROM_CV @ nearest_rotation(M[:3, :3]).T @ R.T
        centre.append(X0)
        rotation.append(own)
    if not ids:
        group.fail("there is no camera with a calibrated sensor")
    images = Images(
        ids=tuple(ids),
        camera=np.array(index, np.int32),
        file=tuple(ids),
        centre=np.array(centre),
        rotation=np.array(rotation),
    )
    return images, numbers


def _read_markers(chunk: Element, numbers: dict[str, int]) -> Tracks:
    markers = chunk.find("markers")
    ids: dict[str, int] = {}
    labels: list[str] = []
    image: list[int] = []
    point: list[int] = []
    xy: list[tuple[float, float]] = []
    for marker in markers.all("marker") if markers else ():
        label = marker.attribute("label")
        if not label.isprintable() or not label or label != label.strip() or label in labels:
            marker.fail(f"label {quoted(label)} is empty, stands twice or cannot be printed")
        ids[marker.attribute("id")] = len(labels)
        labels.append(label)
    measured = chunk.find("frames", "frame", "markers")
    for marker in measured.all("marker") if measured else ():
        k = ids.get(marker.attribute("marker_id"))
        if k is None:
            marker.fail(f"marker {marker.attribute('marker_id')} stands nowhere in the chunk's markers")
        for location in marker.all("location"):
            at = numbers.get(location.attribute("camera_id"))
            if at is None or location.attributes.get("pinned") == "false":
                continue
            image.append(at)
            point.append(k)
            xy.append((_float(location, "x"), _float(location, "y")))
    return Tracks(
        point_ids=tuple(labels),
        xyz=np.full((len(labels), 3), np.nan),
        image=np.array(image, np.int64),
        point=np.array(point, np.int64),
        xy_px=np.array(xy, float).reshape(-1, 2),
    )


register(
    Format(
        name="metashape",
        title="Metashape cameras.xml (cameras and markers)",
        kind="file",
        suffix=".xml",
        write=write,
        read=read,
        looks=lambda path: path.suffix.lower() == ".xml" and not path.is_dir(),
    )
)
