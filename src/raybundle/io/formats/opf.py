"""OPF, the open photogrammetry format 1.0: project.opf, cameras and tracks, written and read.

Angles omega, phi, kappa and the image frame (x right, y up, the view along -z) are ours; the pixel frame too.
Perspective sensors have one focal length, three radial and two tangential terms (OpenCV's).  Tracks are glTF with
y up and single precision about their own origin.  Specification: Pix4D, opf-spec, version 1.0.
"""

from __future__ import annotations

import hashlib
import json
import uuid
from pathlib import Path, PurePosixPath
from typing import Any
from urllib.parse import quote, unquote

import numpy as np

from raybundle.block import Camera, Images
from raybundle.cameras.conversions import camera_from_forward, forward_fit
from raybundle.cameras.forward_camera import ForwardCamera
from raybundle.errors import InputError, Message, note
from raybundle.io.formats.base import (
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
from raybundle.io.ids import repeated
from raybundle.io.reading.files import read_bytes
from raybundle.io.reading.ledger import declare, enter
from raybundle.io.reading.trees import Json, read_json
from raybundle.io.reading.words import quoted
from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import angles_from_rotation, rotation_from_angles

TERMS = ("fx", "cx", "cy", "k1", "k2", "k3", "p1", "p2")
CRS = (
    'ENGINEERINGCRS["Local frame",ENGINEERINGDATUM["Local datum"],CS[Cartesian,3],AXIS["(X)",east,ORDER[1]],'
    'AXIS["(Y)",north,ORDER[2]],AXIS["(Z)",up,ORDER[3]],LENGTHUNIT["metre",1]]'
)
NO_GEOMETRY = (
    "format", "version", "generator", "id", "sources", "name", "description", "bands", "captures", "asset", "scene",
    "scenes", "mesh", "mode", "material", "materials", "extensionsUsed", "extensionsRequired", "byteLength", "target",
    "min", "max", "COLOR_0", "featureIds", "scales", "sensors.internals",
)  # fmt: skip
"""Members without bearing on the block, and those that the calibrated cameras repeat."""
GLTF_FROM_OBJECT = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
COMPONENTS = {5126: "<f4", 5125: "<u4", 5121: "u1"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
BANDS = [{"name": n, "weight": w} for n, w in (("Red", 0.2126), ("Green", 0.7152), ("Blue", 0.0722))]
FILES = {
    "camera_list": ("camera-list.json", "application/opf-camera-list+json"),
    "input_cameras": ("input-cameras.json", "application/opf-input-cameras+json"),
    "scene_reference_frame": ("scene-reference-frame.json", "application/opf-scene-reference-frame+json"),
    "calibration": ("calibrated-cameras.json", "application/opf-calibrated-cameras+json"),
}
SOURCES = {"input_cameras": ("camera_list",), "calibration": ("input_cameras", "scene_reference_frame")}


def uid(name: str) -> int:
    """A 52-bit number for a name, the same each time; small enough for every JSON reader."""
    return int.from_bytes(hashlib.blake2b(name.encode(), digest_size=8).digest()) >> 12


def write(export: Export, folder: Path) -> Draft:
    """Write project.opf with camera list, input and calibrated cameras, reference frame and tracks."""
    s = scene(export)
    fisheyes = [c.id for c in s.cameras if c.sensor.all_round]
    if fisheyes:
        raise InputError("camera.not_in_format", camera=fisheyes[0], kind="fisheye", format="OPF")
    deviations: list[tuple[str, str, float]] = []
    sensors: list[ForwardCamera] = []
    for camera in s.cameras:
        fit = forward_fit(camera, TERMS)
        sensors.append(fit.camera)
        deviations.append((camera.id, "perspective", fit.deviation_px))
    contents = {
        "camera_list": {"cameras": [{"id": uid(n), "uri": quote(n)} for n in s.names]},
        "input_cameras": _input_cameras(s, sensors),
        "scene_reference_frame": {
            "crs": {"definition": CRS},
            "base_to_canonical": {"shift": [0.0, 0.0, 0.0], "scale": [1.0, 1.0, 1.0], "swap_xy": False},
        },
        "calibration": _calibrated(s, sensors),
    }
    for item, content in contents.items():
        name, kind = FILES[item]
        _write_json(folder / name, {"format": kind, "version": "1.0", **content})
    tracks = _write_tracks(s, folder)
    _write_json(folder / "project.opf", _project(export.block.name, tracks))
    remarks, largest = deviation_remark(deviations)
    return Draft(remarks=(*s.remarks, *remarks), deviation_px=largest)


def _write_json(path: Path, value: object) -> None:
    path.write_text(json.dumps(value, indent=1, ensure_ascii=False, allow_nan=False) + "\n", encoding="utf-8")


def _project(name: str, tracks: list[str]) -> dict[str, Any]:
    ids = {item: str(uuid.uuid5(uuid.NAMESPACE_URL, f"{name}/{item}")) for item in FILES}
    items: list[dict[str, Any]] = []
    for item, (file, kind) in FILES.items():
        resources = [{"uri": file, "format": kind}]
        if item == "calibration":
            gltf = {"uri": tracks[0], "format": "model/gltf+json"}
            resources += [gltf, *({"uri": t, "format": "application/gltf-buffer+bin"} for t in tracks[1:])]
        sources = [{"id": ids[source], "type": source} for source in SOURCES.get(item, ())]
        items.append({"id": ids[item], "type": item, "resources": resources, "sources": sources})
    return {
        "format": "application/opf-project+json",
        "version": "1.0",
        "id": str(uuid.uuid5(uuid.NAMESPACE_URL, name)),
        "name": name,
        "description": "",
        "generator": {"name": "raybundle", "version": "1"},
        "items": items,
    }


def _internals(f: ForwardCamera) -> dict[str, Any]:
    return {
        "type": "perspective",
        "principal_point_px": [f.cx, f.cy],
        "focal_length_px": f.fx,
        "radial_distortion": [f.k1, f.k2, f.k3],
        "tangential_distortion": [f.p1, f.p2],
    }


def _input_cameras(s: Scene, sensors: list[ForwardCamera]) -> dict[str, Any]:
    listed = [
        {
            "id": k + 1,
            "name": camera.id,
            "bands": BANDS,
            "image_size_px": [f.width_px, f.height_px],
            "pixel_size_um": camera.pixel_mm[1] * 1000,
            "internals": _internals(f),
            "shutter_type": "global",
        }
        for k, (camera, f) in enumerate(zip(s.cameras, sensors, strict=True))
    ]
    captures: list[dict[str, Any]] = []
    for k, name in enumerate(s.names):
        camera = {
            "id": uid(name),
            "sensor_id": int(s.camera[k]) + 1,
            "model_source": "user",
            "pixel_type": "uint8",
            "pixel_range": {"min": 0, "max": 255},
        }
        captures.append(
            {
                "id": uid(name),
                "reference_camera_id": uid(name),
                "cameras": [camera],
                "rig_model_source": "not_applicable",
                "time": "1970-01-01T00:00:00Z",
            }
        )
    return {"sensors": listed, "captures": captures}


def _calibrated(s: Scene, sensors: list[ForwardCamera]) -> dict[str, Any]:
    angles = np.degrees(angles_from_rotation(s.rotation)).tolist()
    cameras = [
        {
            "id": uid(name),
            "sensor_id": int(s.camera[k]) + 1,
            "position": s.centre[k].tolist(),
            "orientation_deg": angles[k],
        }
        for k, name in enumerate(s.names)
    ]
    return {"sensors": [{"id": k + 1, "internals": _internals(f)} for k, f in enumerate(sensors)], "cameras": cameras}


def _write_tracks(s: Scene, folder: Path) -> list[str]:
    """Write tracks.gltf and its buffers; returns the names of the files."""
    origin = s.xyz.mean(axis=0) if len(s.xyz) else np.zeros(3)
    order = np.argsort(s.point, kind="stable")
    count = np.bincount(s.point, minlength=len(s.xyz)).astype(np.uint64)
    first = np.concatenate([[0], np.cumsum(count)[:-1]]).astype(np.uint64) if len(count) else count
    ranges = (first | (count << np.uint64(40))).astype("<u8").view("<u4").reshape(-1, 2)
    features = np.stack([np.arange(len(order)), np.zeros(len(order))], axis=1).astype("<u4")
    rgba = np.concatenate([s.colours, np.full((len(s.xyz), 1), 255, np.uint8)], axis=1)
    buffers: dict[str, tuple[Array, str]] = {
        "positions": ((s.xyz - origin).astype("<f4"), "VEC3"),
        "colors": (rgba.astype("u1"), "VEC4"),
        "matchCameraIds": (s.image[order].astype("<u4"), "SCALAR"),
        "matchPointIndexRanges": (ranges, "VEC2"),
        "matchPixelCoordinates": (s.xy_px[order].astype("<f4"), "VEC2"),
        "matchFeatureIds": (features, "VEC2"),
        "matchScales": (np.ones(len(order), "<f4"), "SCALAR"),
    }
    codes = {"<f4": 5126, "<u4": 5125, "|u1": 5121}
    accessors: list[dict[str, Any]] = []
    for k, (name, (values, kind)) in enumerate(buffers.items()):
        (folder / f"{name}.bin").write_bytes(values.tobytes())
        accessor = {"bufferView": k, "componentType": codes[values.dtype.str], "count": len(values), "type": kind}
        if k == 0 and len(values):
            accessor |= {"min": values.min(axis=0).tolist(), "max": values.max(axis=0).tolist()}
        accessors.append(accessor)
    sizes = [v.nbytes for v, _ in buffers.values()]
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = GLTF_FROM_OBJECT, GLTF_FROM_OBJECT @ origin
    points = {"pixelCoordinates": 4, "featureIds": 5, "scales": 6}
    matches = {"cameraUids": [uid(n) for n in s.names], "cameraIds": 2, "pointIndexRanges": 3, "imagePoints": points}
    primitive = {
        "attributes": {"POSITION": 0, "COLOR_0": 1},
        "mode": 0,
        "material": 0,
        "extensions": {"OPF_mesh_primitive_matches": matches},
    }
    gltf = {
        "asset": {"version": "2.0", "generator": "raybundle", "extensions": {"OPF_asset_version": {"version": "1.0"}}},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "matrix": matrix.T.ravel().tolist()}],
        "meshes": [{"primitives": [primitive]}],
        "materials": [{"extensions": {"KHR_materials_unlit": {}}}],
        "accessors": accessors,
        "bufferViews": [{"buffer": k, "byteLength": b, "target": 34962} for k, b in enumerate(sizes)],
        "buffers": [{"uri": f"{n}.bin", "byteLength": b} for n, b in zip(buffers, sizes, strict=True)],
        "extensionsUsed": ["KHR_materials_unlit", "OPF_asset_version", "OPF_mesh_primitive_matches"],
        "extensionsRequired": ["KHR_materials_unlit"],
    }
    _write_json(folder / "tracks.gltf", gltf)
    return ["tracks.gltf", *(f"{n}.bin" for n in buffers)]


def read(path: Path) -> Import:
    """The block of a calibrated project; perspective sensors alone.

    path  the .opf file or the folder that holds it.  Coordinates stand in the processing frame.
    """
    if path.is_dir():
        found = sorted(path.glob("*.opf"))
        if len(found) != 1:
            raise InputError("opf.file_count", n=len(found), file=path)
        path = found[0]
    project = read_json(path)
    declare(*NO_GEOMETRY)
    resources = _resources(project, path)
    remarks: list[Message] = []
    deviations: list[float] = []
    names = {_id(c): _name(c.get("uri")) for c in read_json(resources["camera-list"]).get("cameras").items()}
    calibrated = read_json(resources["calibrated-cameras"])
    cameras, index = _cameras_in(calibrated, read_json(resources["input-cameras"]), path, remarks, deviations)
    images, place = _images_in(calibrated, names, index)
    tracks = _no_tracks()
    if "gltf" in resources:
        tracks = _tracks_in(resources["gltf"], place)
    else:
        remarks.append(note("import.no_tracks", name="gltf"))
    if "scene-reference-frame" in resources:
        remarks += _frame_remark(read_json(resources["scene-reference-frame"]))
    block, more = block_of(
        name=project.get("name").text() if project.has("name") else path.stem,
        source="OPF",
        cameras=cameras,
        images=images,
        tracks=tracks,
    )
    return Import(block=block, remarks=(*remarks, *more), deviation_px=max(deviations, default=0.0))


def _frame_remark(frame: Json) -> list[Message]:
    """How the processing frame lies, if it is not the coordinate system itself."""
    base = frame.get("base_to_canonical")
    shift = base.get("shift").numbers(3)
    scale = base.get("scale").numbers(3) if base.has("scale") else np.ones(3)
    swapped = bool(base.get("swap_xy").value) if base.has("swap_xy") else False
    definition = frame.get("crs").get("definition").value
    system = quoted(definition)
    if not shift.any() and not swapped and (scale == 1).all():
        return [] if definition == CRS else [note("import.system_of_file", system=system)]
    return [
        note(
            "import.processing_frame", system=system, shift=[f"{v:.3f}" for v in shift.tolist()],
            scaled=not (scale == 1).all(), scale=[f"{v:g}" for v in scale.tolist()], swapped=swapped,
        )
    ]  # fmt: skip


def _resources(project: Json, path: Path) -> dict[str, Path]:
    """Files by the last part of their format; every path stays within the project's folder."""
    resources: dict[str, Path] = {}
    for item in project.get("items").items():
        kind = item.get("type").text()
        for resource in item.get("resources").items():
            what = resource.get("format").text()
            key = what.removeprefix("application/opf-").removesuffix("+json").replace("model/", "")
            if key == "gltf" and kind != "calibration":
                continue
            file = _inside(path.parent, resource.get("uri"))
            resources.setdefault(key, file)
    for key in ("camera-list", "input-cameras", "calibrated-cameras"):
        if key not in resources:
            raise InputError("opf.not_calibrated", part=key, file=path)
    return resources


def _inside(folder: Path, uri: Json) -> Path:
    name = unquote(uri.text())
    parts = PurePosixPath(name)
    if parts.is_absolute() or ".." in parts.parts or ":" in name or "\\" in name or "\0" in name:
        uri.fail("opf.path_outside", path=quoted(name))
    return folder / parts


def _id(value: Json) -> int:
    return value.get("id").whole(0, 1 << 64)


def _name(uri: Json) -> str:
    name = unquote(uri.text().partition("#")[0])
    if not name or not name.isprintable():
        uri.fail("name.unprintable", name=quoted(name))
    return PurePosixPath(name).name if ":" in name or name.startswith("/") else name.removeprefix("./")


def _cameras_in(
    calibrated: Json, given: Json, path: Path, remarks: list[Message], deviations: list[float]
) -> tuple[tuple[Camera, ...], dict[int, int]]:
    sizes: dict[int, tuple[int, int, float | None]] = {}
    for sensor in given.get("sensors").items():
        size = sensor.get("image_size_px")
        if len(size.items()) < 2:
            size.fail("value.count", n=len(size.items()), needed=2)
        width, height = (v.whole() for v in size.items()[:2])
        shutter = sensor.get("shutter_type").text() if sensor.has("shutter_type") else "global"
        enter(f"shutter_type {quoted(shutter)}", int(shutter != "global"))
        pixel = sensor.optional("pixel_size_um") / 1000
        sizes[_id(sensor)] = (width, height, pixel if pixel > 0 else None)
    cameras: list[Camera] = []
    index: dict[int, int] = {}
    for sensor in calibrated.get("sensors").items():
        id_ = _id(sensor)
        if id_ not in sizes:
            sensor.fail("reference.unknown", kind="sensor", name=str(id_), where="input-cameras")
        width, height, pixel = sizes[id_]
        internals = sensor.get("internals")
        if internals.get("type").text() != "perspective":
            internals.get("type").fail(
                "value.not_supported", value=quoted(internals.get("type").value), known=["perspective"]
            )
        f = internals.get("focal_length_px").number()
        if f <= 0:
            internals.fail("focal_length.not_positive", lengths=[f])
        cx, cy = internals.get("principal_point_px").numbers(2).tolist()
        k1, k2, k3 = internals.get("radial_distortion").numbers(3).tolist()
        p1, p2 = internals.get("tangential_distortion").numbers(2).tolist()
        forward = ForwardCamera(
            width_px=width, height_px=height, fx=f, fy=f, cx=cx, cy=cy, k1=k1, k2=k2, k3=k3, p1=p1, p2=p2
        )
        fit = camera_from_forward(forward, str(id_), pixel_mm=pixel, where=f"{path}: ")
        index[id_] = len(cameras)
        cameras.append(fitted_camera(fit, str(id_), remarks, deviations))
    return tuple(cameras), index


def _images_in(calibrated: Json, names: dict[int, str], sensors: dict[int, int]) -> tuple[Images, dict[int, int]]:
    cameras = calibrated.get("cameras").items()
    if not cameras:
        calibrated.get("cameras").fail("file.no_images")
    ids: list[str] = []
    index: list[int] = []
    place: dict[int, int] = {}
    centre, angles = np.zeros((len(cameras), 3)), np.zeros((len(cameras), 3))
    for k, camera in enumerate(cameras):
        id_, sensor = _id(camera), camera.get("sensor_id").whole(0, 1 << 64)
        if id_ not in names or sensor not in sensors:
            camera.fail("opf.unknown_camera", camera=str(id_), sensor=str(sensor))
        place[id_] = k
        ids.append(names[id_])
        index.append(sensors[sensor])
        centre[k], angles[k] = camera.get("position").numbers(3), camera.get("orientation_deg").numbers(3)
    if len(set(ids)) < len(ids):
        calibrated.get("cameras").fail("name.twice", kind="image", name=quoted(repeated(ids)))
    images = Images(
        ids=tuple(ids),
        camera=np.array(index, np.int32),
        file=tuple(ids),
        centre=centre,
        rotation=rotation_from_angles(np.radians(angles)),
    )
    return images, place


def _no_tracks() -> Tracks:
    none = np.zeros(0, np.int64)
    return Tracks(point_ids=(), xyz=np.zeros((0, 3)), image=none, point=none, xy_px=np.zeros((0, 2)))


def _tracks_in(path: Path, place: dict[int, int]) -> Tracks:
    gltf = read_json(path)
    node = _first(gltf, "nodes")
    primitive = _first(_first(gltf, "meshes"), "primitives")
    positions = _accessor(gltf, path, primitive.get("attributes").get("POSITION"), 3)
    extensions = primitive.get("extensions") if primitive.has("extensions") else None
    if extensions is None or not extensions.has("OPF_mesh_primitive_matches"):
        return _no_tracks()
    matches = extensions.get("OPF_mesh_primitive_matches")
    uids = [u.whole(0, 1 << 64) for u in matches.get("cameraUids").items()]
    camera_ids = _accessor(gltf, path, matches.get("cameraIds"), 1)[:, 0].astype(np.int64)
    ranges = np.ascontiguousarray(_accessor(gltf, path, matches.get("pointIndexRanges"), 2), "<u4").view("<u8")[:, 0]
    xy = _accessor(gltf, path, matches.get("imagePoints").get("pixelCoordinates"), 2).astype(float)
    first, count = (ranges & ((1 << 40) - 1)).astype(np.int64), (ranges >> np.uint64(40)).astype(np.int64)
    if len(ranges) != len(positions) or len(camera_ids) != len(xy) or (first + count > len(xy)).any():
        matches.fail("opf.counts_differ", points=len(positions), ranges=len(ranges), image_points=len(xy))
    if len(camera_ids) and camera_ids.max() >= len(uids):
        matches.fail("reference.unknown", kind="camera", name=str(camera_ids.max()), where="cameraUids")
    if int(count.sum()) > 4 * len(xy):
        matches.fail("opf.ranges_overlap")
    if not np.isfinite(xy).all() or not np.isfinite(positions).all():
        matches.fail("opf.not_finite")
    matrix = node.get("matrix").numbers(16).reshape(4, 4).T if node.has("matrix") else np.eye(4)
    xyz = (positions.astype(float) @ matrix[:3, :3].T + matrix[:3, 3]) @ GLTF_FROM_OBJECT
    point = np.repeat(np.arange(len(ranges)), count)
    rows = np.arange(len(point)) - np.repeat(np.cumsum(count) - count, count) + np.repeat(first, count)
    image_of = np.array([place.get(u, -1) for u in uids], np.int64)
    image = image_of[camera_ids[rows]] if len(rows) else np.zeros(0, np.int64)
    kept = image >= 0
    return Tracks(
        point_ids=tuple(str(k + 1) for k in range(len(xyz))),
        xyz=xyz,
        image=image[kept],
        point=point[kept],
        xy_px=xy[rows[kept]] if len(rows) else np.zeros((0, 2)),
    )


def _first(value: Json, key: str) -> Json:
    items = value.get(key).items()
    if not items:
        value.get(key).fail("value.list_empty")
    return items[0]


def _accessor(gltf: Json, path: Path, which: Json, width: int) -> Array:
    """The values (n, width) of an accessor; its count is held against the size of its file."""
    accessors, views, buffers = (gltf.get(k).items() for k in ("accessors", "bufferViews", "buffers"))
    accessor = accessors[which.whole(0, len(accessors) - 1)]
    view = views[accessor.get("bufferView").whole(0, len(views) - 1)]
    buffer = buffers[view.get("buffer").whole(0, len(buffers) - 1)]
    code, kind = accessor.get("componentType").whole(0, 10_000), accessor.get("type").text()
    if code not in COMPONENTS or WIDTHS.get(kind) != width:
        accessor.fail("opf.accessor_type", kind=kind, type=str(code))
    data = read_bytes(_inside(path.parent, buffer.get("uri")), 1 << 36)
    count, dtype = accessor.get("count").whole(0, 1 << 40), np.dtype(COMPONENTS[code])
    begin = int(view.optional("byteOffset"))
    if begin < 0 or begin + count * width * dtype.itemsize > len(data):
        accessor.fail("opf.accessor_size", n=count, size_bytes=len(data))
    return np.frombuffer(data, dtype, count * width, begin).reshape(count, width)


register(
    Format(
        name="opf",
        title="OPF project (perspective cameras and tracks)",
        kind="folder",
        colours=True,
        write=write,
        read=read,
        looks=lambda path: any(path.glob("*.opf")) if path.is_dir() else path.suffix.lower() == ".opf",
    )
)
