"""nerfstudio: transforms.json, written and read.

The camera frame is ours (x right, y up, the view along -z), and so is the pixel frame; `transform_matrix` turns
and shifts camera axes to object axes.  There are no tracks in this format.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Literal

import numpy as np

from raybundle.block import Block, Camera, Images
from raybundle.cameras.conversions import FISHEYE, camera_from_forward, forward_fit, pinhole_of, terms_for
from raybundle.cameras.equirectangular import equirectangular_camera
from raybundle.cameras.forward_camera import ForwardCamera
from raybundle.errors import InputError, Message, note, phrase
from raybundle.io.formats.base import (
    Draft,
    Export,
    Format,
    Import,
    Tracks,
    block_of,
    deviation_remark,
    fitted_camera,
    json_begins,
    register,
    scene,
)  # fmt: skip
from raybundle.io.formats.ply import write_vertices
from raybundle.io.ids import repeated
from raybundle.io.reading.ledger import declare
from raybundle.io.reading.trees import Json, read_json
from raybundle.io.reading.words import quoted
from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import nearest_rotation

TERMS = ("fx", "fy", "cx", "cy", "k1", "k2", "k3", "k4", "p1", "p2")
DISTORTION = TERMS[4:]
KEYS = {"fx": "fl_x", "fy": "fl_y"}
FOLDER = "images/"
NO_GEOMETRY = (
    "ply_file_path",
    "aabb_scale",
    "sharpness",
    "colmap_im_id",
    "scale",
    "offset",
)
"""Keys without bearing on cameras: clouds beside the file, the cube of a radiance field."""
LENSES: Mapping[str, Literal["central", "equidistant", "sphere"]] = {
    "OPENCV": "central", "PINHOLE": "central", "SIMPLE_PINHOLE": "central", "SIMPLE_RADIAL": "central",
    "RADIAL": "central", "OPENCV_FISHEYE": "equidistant",
    "EQUIRECTANGULAR": "sphere",
}  # fmt: skip
"""Camera models that are read."""
FLAGS = {"is_fisheye": "OPENCV_FISHEYE", "equirectangular": "EQUIRECTANGULAR"}
"""Keys of instant-ngp that name a lens -> the same as a camera model."""
OTHER_LENSES = ("latlong", "orthographic", "ftheta_p0")
"""Keys of instant-ngp for lenses that are not read."""
ANGLE_SHARE = 0.01
"""Largest difference of a focal length from that of the field of view beside it, as a share."""


def _camera_out(camera: Camera) -> tuple[dict[str, Any], str, float]:
    if camera.sensor.all_round:
        fit = forward_fit(camera, terms_for(camera, FISHEYE), projection="equidistant")
        forward, name, deviation = fit.camera, "OPENCV_FISHEYE", fit.deviation_px
    else:
        exact = pinhole_of(camera)
        fit = None if exact else forward_fit(camera, terms_for(camera, TERMS))
        forward = exact or (fit.camera if fit else exact)
        name, deviation = ("OPENCV", fit.deviation_px) if fit else ("PINHOLE", 0.0)
    assert forward is not None
    values = {KEYS.get(t, t): float(getattr(forward, t)) for t in TERMS}
    return {"camera_model": name, "w": camera.width_px, "h": camera.height_px, **values}, name, deviation


def write(export: Export, path: Path) -> Draft:
    """Write transforms.json, and the object points beside it as sparse_pc.ply."""
    s = scene(export)
    cameras: list[dict[str, Any]] = []
    deviations: list[tuple[str, str, float]] = []
    for camera in s.cameras:
        values, name, deviation = _camera_out(camera)
        cameras.append(values)
        deviations.append((camera.id, name, deviation))
    if len({c["camera_model"] for c in cameras}) > 1:
        if "OPENCV_FISHEYE" in {c["camera_model"] for c in cameras}:
            raise InputError("nerfstudio.mixed_models")
        for values in cameras:
            values["camera_model"] = "OPENCV"
    frames: list[dict[str, Any]] = []
    for k, name in enumerate(s.names):
        M = np.eye(4)
        M[:3, :3], M[:3, 3] = s.rotation[k].T, s.centre[k]
        own = {key: v for key, v in cameras[int(s.camera[k])].items() if key != "camera_model"}
        frames.append({"file_path": FOLDER + name, "transform_matrix": M.tolist(), **(own if len(cameras) > 1 else {})})
    head = cameras[0] if len(cameras) == 1 else {"camera_model": cameras[0]["camera_model"]}
    cloud = path.with_name("sparse_pc.ply" if path.stem == "transforms" else f"{path.stem}-sparse_pc.ply")
    write_vertices(cloud, s.xyz, s.colours)
    free = {"scale": "free"} if export.block.free_scale else {}
    text = json.dumps({**head, **free, "frames": frames, "ply_file_path": cloud.name}, indent=1, ensure_ascii=False)
    path.write_text(text + "\n", encoding="utf-8")
    remarks, largest = deviation_remark(deviations)
    return Draft(remarks=(*s.remarks, *remarks, phrase("conversion.nerfstudio_images")), deviation_px=largest)


def read(path: Path) -> Import:
    """Cameras and images of a transforms.json; it holds neither points nor observations."""
    if path.is_dir():
        path = path / "transforms.json"
    top = read_json(path)
    declare(*NO_GEOMETRY)
    frames = top.get("frames").items()
    if not frames:
        top.get("frames").fail("file.no_images")
    forward: list[ForwardCamera | tuple[int, int]] = []
    index: list[int] = []
    names: list[str] = []
    remarks: list[Message] = []
    matrices = np.zeros((len(frames), 4, 4))
    for k, frame in enumerate(frames):
        camera = _camera_in(top, frame, remarks)
        if camera not in forward:
            forward.append(camera)
        index.append(forward.index(camera))
        names.append(frame.get("file_path").text().removeprefix("./").removeprefix(FOLDER))
        rows = frame.get("transform_matrix").items()
        if len(rows) not in {3, 4}:
            frame.get("transform_matrix").fail("value.count", n=len(rows), needed=4)
        matrices[k, : len(rows)] = np.array([row.numbers(4) for row in rows])
        _check_rotation(frame.get("transform_matrix"), matrices[k, :3, :3])
    if len(set(names)) < len(names):
        top.get("frames").fail("name.twice", kind="image", name=quoted(repeated(names)))
    deviations: list[float] = []
    cameras: list[Camera] = []
    for k, camera in enumerate(forward, 1):
        if not isinstance(camera, ForwardCamera):
            cameras.append(equirectangular_camera(str(k), *camera, whole_sphere=True))
            continue
        fit = camera_from_forward(camera, str(k), where=f"{path}: ")
        cameras.append(fitted_camera(fit, str(k), remarks, deviations))
    images = Images(
        ids=tuple(names),
        camera=np.array(index, np.int32),
        file=tuple(names),
        centre=matrices[:, :3, 3].copy(),
        rotation=np.swapaxes(nearest_rotation(matrices[:, :3, :3]), -1, -2),
    )
    return Import(
        block=_bare(path, tuple(cameras), images),
        remarks=(*remarks, note("import.no_observations")),
        deviation_px=max(deviations, default=0.0),
    )


def _bare(path: Path, cameras: tuple[Camera, ...], images: Images) -> Block:
    none = np.zeros(0, np.int64)
    tracks = Tracks(point_ids=(), xyz=np.zeros((0, 3)), image=none, point=none, xy_px=np.zeros((0, 2)))
    return block_of(name=path.parent.name, source="nerfstudio", cameras=cameras, images=images, tracks=tracks)[0]


def _check_rotation(place: Json, R: Array) -> None:
    if np.abs(R @ R.T - np.eye(3)).max() > 1e-3 or np.linalg.det(R) < 0:
        place.fail("rotation.not_orthogonal")


def _place(top: Json, frame: Json, key: str) -> Json:
    """Where a key stands: in the frame, else in the file, whose value a frame replaces."""
    top.asked.below(key)
    return frame if frame.has(key) else top


def _lens(top: Json, frame: Json) -> str:
    """The camera model of a frame: its own or that of the file, by name or by a flag of instant-ngp."""
    named = _place(top, frame, "camera_model")
    model = named.get("camera_model").text() if named.has("camera_model") else ""
    if model and model not in LENSES:
        named.get("camera_model").fail("value.not_supported", value=quoted(model), known=list(LENSES))
    for key in OTHER_LENSES:
        place = _place(top, frame, key)
        if place.has(key) and place.get(key).value is not False:
            place.get(key).fail("value.not_supported", value=key, known=list(LENSES))
    for key, lens in FLAGS.items():
        place = _place(top, frame, key)
        if not place.has(key):
            continue
        flag = place.get(key).value
        if not isinstance(flag, bool) and flag not in (0, 1):
            place.get(key).fail("value.no_truth_value", value=quoted(flag))
        if flag and model and model != lens:
            place.get(key).fail("nerfstudio.model_contradiction", model=quoted(model))
        model = lens if flag else model
    return model or "OPENCV"


def _focal(place: Callable[[str], Json], axis: str, size: int, remarks: list[Message]) -> float | None:
    """Focal length [px] along an axis: stated, or of the field of view [rad] or [deg] as instant-ngp takes it.

    A field of view that contradicts a focal length in the same place has a remark.
    """
    key, angle_key, degrees_key = f"fl_{axis}", f"camera_angle_{axis}", f"{axis}_fov"
    where = next((k for k in (angle_key, degrees_key) if place(k).has(k)), "")
    angle = place(where).get(where).number() if where else math.nan
    angle = math.radians(angle) if where == degrees_key else angle
    if where and not 0 < angle < math.pi:
        place(where).get(where).fail("nerfstudio.field_of_view", angle_deg=math.degrees(angle))
    derived = size / (2 * math.tan(angle / 2)) if where else None
    if not place(key).has(key):
        return derived
    stated = place(key).get(key).number()
    if derived is not None and place(key) is place(where) and abs(derived - stated) > ANGLE_SHARE * abs(stated):
        found = note("import.focal_length_contradicts", name=key, used_px=stated, other=where, other_px=derived)
        if found not in remarks:
            remarks.append(found)
    return stated


def _camera_in(top: Json, frame: Json, remarks: list[Message]) -> ForwardCamera | tuple[int, int]:
    """The camera of a frame; of an equirectangular image its width and height."""

    def place(key: str) -> Json:
        return _place(top, frame, key)

    model = _lens(top, frame)
    width, height = (place(k).get(k).whole() for k in ("w", "h"))
    every = {t: place(t).optional(t) for t in DISTORTION}
    if LENSES[model] == "sphere":
        return width, height
    fx = _focal(place, "x", width, remarks)
    fy = _focal(place, "y", height, remarks) or fx
    if fx is None or fy is None:
        frame.fail("nerfstudio.focal_length_missing")
    if not (fx > 0 and fy > 0):
        frame.fail("focal_length.not_positive", lengths=[fx, fy])
    terms = () if "PINHOLE" in model else DISTORTION if LENSES[model] == "central" else FISHEYE[4:]
    for term, value in every.items():
        if term not in terms and value:
            place(term).get(term).fail("nerfstudio.parameter_unused", value=value, model=model)
    return ForwardCamera(
        width_px=width,
        height_px=height,
        projection="equidistant" if LENSES[model] == "equidistant" else "central",
        fx=fx,
        fy=fy,
        cx=place("cx").optional("cx", width / 2),
        cy=place("cy").optional("cy", height / 2),
        **{t: every[t] for t in terms},
    )


register(
    Format(
        name="nerfstudio",
        title="nerfstudio transforms.json",
        kind="file",
        colours=True,
        observations=False,
        suffix=".json",
        write=write,
        read=read,
        looks=lambda path: (path / "transforms.json").is_file() or json_begins(path) not in {"", "["},
    )
)
