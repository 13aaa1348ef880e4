"""OpenSfM: reconstruction.json with tracks.csv beside it, written and read.

Lengths in the image are divided by its longer side and count from its centre, x right, y down; the camera
looks along +z.  Shots hold the rotation (angle-axis) and translation from object to camera axes.
"""

from __future__ import annotations

import csv
import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.block import Camera, Images
from raybundle.cameras.conversions import FISHEYE, camera_from_forward, forward_fit, terms_for
from raybundle.cameras.forward_camera import ForwardCamera
from raybundle.errors import InputError, Message, note
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
    cv_pose,
    deviation_remark,
    fitted_camera,
    json_begins,
    register,
    scene,
)  # fmt: skip
from raybundle.io.reading.files import read_text
from raybundle.io.reading.ledger import declare
from raybundle.io.reading.trees import Json, read_json
from raybundle.io.reading.words import no_number, number_of, quoted
from raybundle.numerics.rotation import rotation_from_vector, vector_from_rotation

BROWN = ("fx", "fy", "cx", "cy", "k1", "k2", "k3", "p1", "p2")
TRACKS = "OPENSFM_TRACKS_VERSION_v2"
TERMS: Mapping[str, tuple[str, ...]] = {
    "perspective": ("k1", "k2"),
    "simple_radial": ("k1",),
    "radial": ("k1", "k2"),
    "brown": ("k1", "k2", "k3", "p1", "p2"),
    "fisheye": ("k1", "k2"),
    "fisheye_opencv": ("k1", "k2", "k3", "k4"),
}
"""Projection type -> distortion."""
NO_GEOMETRY = ("orientation", "scale", "capture_time", "gps_dop", "vertices", "faces", "merge_cc", "color")
"""Keys of shots and points without bearing on the block; `scale` is that of a mesh."""
SCALE = 0.004
"""Scale of a feature as OpenSfM's tracks want one; it weights nothing there by default."""


def write(export: Export, path: Path) -> Draft:
    """Write reconstruction.json and, beside it, NAME-tracks.csv or tracks.csv."""
    s = scene(export)
    deviations: list[tuple[str, str, float]] = []
    cameras: dict[str, dict[str, Any]] = {}
    for camera in s.cameras:
        fisheye = camera.sensor.all_round
        terms = terms_for(camera, FISHEYE if fisheye else BROWN)
        fit = forward_fit(camera, terms, projection="equidistant" if fisheye else "central")
        kind = "fisheye_opencv" if fisheye else "brown"
        deviations.append((camera.id, kind, fit.deviation_px))
        cameras[camera.id] = _camera_out(fit.camera, kind)
    R, t = cv_pose(s)
    vectors = vector_from_rotation(R).tolist()
    shots = {
        name: {
            "rotation": vectors[k],
            "translation": t[k].tolist(),
            "camera": s.cameras[int(s.camera[k])].id,
            "orientation": 1,
            "scale": 1.0,
        }
        for k, name in enumerate(s.names)
    }
    ids = [export.block.points.ids[k] for k in s.points.tolist()]
    points = {
        i: {"coordinates": xyz, "color": rgb}
        for i, xyz, rgb in zip(ids, s.xyz.tolist(), s.colours.tolist(), strict=True)
    }
    text = json.dumps([{"cameras": cameras, "shots": shots, "points": points}], ensure_ascii=False, allow_nan=False)
    path.write_text(text + "\n", encoding="utf-8")
    _write_tracks(s, ids, tracks_beside(path))
    remarks, largest = deviation_remark(deviations)
    return Draft(remarks=s.remarks + remarks, deviation_px=largest)


def tracks_beside(path: Path) -> Path:
    """The file with the observations of a reconstruction."""
    return path.with_name("tracks.csv" if path.stem == "reconstruction" else f"{path.stem}-tracks.csv")


def _camera_out(camera: ForwardCamera, kind: str) -> dict[str, Any]:
    side = max(camera.width_px, camera.height_px)
    return {
        "projection_type": kind,
        "width": camera.width_px,
        "height": camera.height_px,
        "focal_x": camera.fx / side,
        "focal_y": camera.fy / side,
        "c_x": (camera.cx - camera.width_px / 2) / side,
        "c_y": (camera.cy - camera.height_px / 2) / side,
        **{term: float(getattr(camera, term)) for term in TERMS[kind]},
    }


def _write_tracks(s: Scene, ids: list[str], path: Path) -> None:
    size = np.array([(c.width_px, c.height_px) for c in s.cameras], float)[s.camera[s.image]]
    normal = ((s.xy_px - size / 2) / size.max(axis=1, initial=0.0)[:, None]).tolist() if len(s.image) else []
    with path.open("w", encoding="utf-8", newline="") as file:
        file.write(TRACKS + "\n")
        writer = csv.writer(file, delimiter="\t", lineterminator="\n")
        rows = zip(s.image.tolist(), s.point.tolist(), normal, strict=True)
        for k, (image, point, (x, y)) in enumerate(rows):
            rgb = s.colours[point].tolist()
            writer.writerow([s.names[image], ids[point], k, exact(x), exact(y), SCALE, *rgb, -1, -1])


def read(path: Path) -> Import:
    """The block of a reconstruction.json; observations from tracks.csv beside it, where there is one."""
    if path.is_dir():
        path = path / "reconstruction.json"
    everything = read_json(path).items()
    declare(*NO_GEOMETRY)
    if not everything:
        raise InputError("file.no_images", file=path)
    remarks: list[Message] = []
    deviations: list[float] = []
    if len(everything) > 1:
        remarks.append(note("import.first_reconstruction", n=len(everything)))
    top = everything[0]
    cameras: list[Camera] = []
    forward: list[ForwardCamera] = []
    for id_, value in top.get("cameras").mapping().items():
        forward.append(_camera_in(value))
        fit = camera_from_forward(forward[-1], id_.strip() or "1", where=f"{path}: ")
        cameras.append(fitted_camera(fit, id_, remarks, deviations))
    images = _images_in(top, {c.id: k for k, c in enumerate(cameras)})
    points = top.get("points").mapping() if top.has("points") else {}
    xyz = np.array([p.get("coordinates").numbers(3) for p in points.values()]).reshape(-1, 3)
    colours = np.array([p.get("color").numbers(3) if p.has("color") else np.full(3, 128.0) for p in points.values()])
    tracks = _tracks_in(tracks_beside(path), images, forward, list(points), xyz, remarks)
    block, more = block_of(
        name=path.parent.name, source="OpenSfM", cameras=tuple(cameras), images=images, tracks=tracks
    )
    return Import(
        block=block,
        colours=np.clip(colours, 0, 255).reshape(-1, 3),
        remarks=(*remarks, *more),
        deviation_px=max(deviations, default=0.0),
    )


def _camera_in(value: Json) -> ForwardCamera:
    kind = value.get("projection_type").text()
    if kind not in TERMS:
        value.get("projection_type").fail("value.not_supported", value=quoted(kind), known=list(TERMS))
    width, height = value.get("width").whole(), value.get("height").whole()
    side = max(width, height)
    one = "focal" if value.has("focal") else None
    fx, fy = (value.get(one or f"focal_{a}").number() * side for a in "xy")
    if not (fx > 0 and fy > 0):
        value.fail("focal_length.not_positive", lengths=[fx / side, fy / side])
    return ForwardCamera(
        width_px=width,
        height_px=height,
        projection="equidistant" if kind.startswith("fisheye") else "central",
        fx=fx,
        fy=fy,
        cx=width / 2 + value.optional("c_x") * side,
        cy=height / 2 + value.optional("c_y") * side,
        **{term: value.optional(term) for term in TERMS[kind]},
    )


def _images_in(top: Json, cameras: Mapping[str, int]) -> Images:
    shots = top.get("shots").mapping()
    if not shots:
        top.get("shots").fail("file.no_images")
    index: list[int] = []
    vectors, t = np.zeros((len(shots), 3)), np.zeros((len(shots), 3))
    for k, (name, shot) in enumerate(shots.items()):
        camera = shot.get("camera").text()
        if camera not in cameras:
            shot.get("camera").fail("reference.unknown", kind="camera", name=quoted(camera), where="cameras")
        if not name.isprintable() or not name or name != name.strip():
            shot.fail("name.unprintable", name=quoted(name))
        index.append(cameras[camera])
        vectors[k], t[k] = shot.get("rotation").numbers(3), shot.get("translation").numbers(3)
    if np.abs(vectors).max() > 1e6:
        top.get("shots").fail("rotation.too_large", limit_rad=1e6)
    R = rotation_from_vector(vectors)
    return Images(
        ids=tuple(shots),
        camera=np.array(index, np.int32),
        file=tuple(shots),
        centre=-np.einsum("nji,nj->ni", R, t),
        rotation=SENSOR_FROM_CV @ R,
    )


@dataclass(slots=True)
class _Rows:
    image: list[int]
    point: list[int]
    xy: list[tuple[float, float]]


def _tracks_in(
    path: Path, images: Images, forward: list[ForwardCamera], ids: list[str], xyz: np.ndarray, remarks: list[Message]
) -> Tracks:
    rows = _Rows([], [], [])
    if path.is_file():
        _read_tracks(path, images, forward, ids, rows)
    else:
        remarks.append(note("import.no_tracks", name=path.name))
    return Tracks(
        point_ids=tuple(ids),
        xyz=xyz,
        image=np.array(rows.image, np.int64),
        point=np.array(rows.point, np.int64),
        xy_px=np.array(rows.xy, float).reshape(-1, 2),
    )


def _read_tracks(path: Path, images: Images, forward: list[ForwardCamera], ids: list[str], rows: _Rows) -> None:
    """Rows of images and points that the reconstruction holds; it leaves out many of its tracks on purpose."""
    image_of, point_of = ({name: k for k, name in enumerate(names)} for names in (images.ids, ids))
    for line, text in enumerate(read_text(path).split("\n"), 1):
        words = text.split("\t")
        if line == 1 and text.startswith("OPENSFM_TRACKS_VERSION"):
            if text.strip() not in {TRACKS, "OPENSFM_TRACKS_VERSION_v1"}:
                raise InputError(
                    "value.not_supported",
                    value=quoted(text),
                    known=["OPENSFM_TRACKS_VERSION_v1", TRACKS],
                    file=path,
                    line=1,
                )
            continue
        if not text.strip():
            continue
        if len(words) < 5:
            raise InputError(
                "line.too_few_words",
                n=len(words),
                needed=5,
                columns=["image", "track", "feature", "x", "y"],
                file=path,
                line=line,
            )
        image, point = image_of.get(words[0]), point_of.get(words[1])
        if image is None or point is None:
            continue
        x, y = number_of(words[3].strip()), number_of(words[4].strip())
        if x is None or y is None:
            bad = words[3] if x is None else words[4]
            raise InputError(no_number(bad), file=path, line=line, column="x" if x is None else "y")
        camera = forward[int(images.camera[image])]
        side = max(camera.width_px, camera.height_px)
        rows.image.append(image)
        rows.point.append(point)
        rows.xy.append((x * side + camera.width_px / 2, y * side + camera.height_px / 2))


register(
    Format(
        name="opensfm",
        title="OpenSfM reconstruction.json and tracks.csv",
        kind="file",
        colours=True,
        suffix=".json",
        write=write,
        read=read,
        looks=lambda path: (path / "reconstruction.json").is_file() or json_begins(path) == "[",
    )
)
