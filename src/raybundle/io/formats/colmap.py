"""COLMAP models: cameras, images and points3D, binary or text, written and read.

The pixel frame is ours: the origin is the outer corner of the first pixel.  Poses turn object axes into camera
axes x right, y down, z forward.  Rigs of one camera each are what COLMAP makes of these files, so rigs and
frames are not written; where a model has them, they give the poses of its images.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.block import Camera, Images
from raybundle.cameras.conversions import camera_from_forward, opencv_fit
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
    register,
    scene,
)  # fmt: skip
from raybundle.io.formats.colmap_cameras import EVERY_NUMBER, model_of, written_directly
from raybundle.io.formats.colmap_files import NO_POINT, POINT2D, TRACK, Model, read_model, suffix_of
from raybundle.io.formats.colmap_rigs import image_poses, quaternions
from raybundle.numerics.arrays import Array, Index


@dataclass(frozen=True, slots=True, kw_only=True)
class _Point:
    """A row of points3D."""

    number: int
    xyz: Array
    rgb: tuple[int, int, int]
    error: float
    images: Index
    """(k,) 1-based numbers of images"""
    rows: Index
    """(k,) rows in the list of the image"""


def _numbers(s: Scene, export: Export) -> list[int]:
    """1-based numbers of the points; their own ids where these all are numbers."""
    ids = [export.block.points.ids[k] for k in s.points.tolist()]
    if all(i.isascii() and i.isdigit() and len(i) < 18 and i == str(int(i)) for i in ids) and "0" not in ids:
        return [int(i) for i in ids]
    return list(range(1, len(ids) + 1))


def _points(s: Scene, export: Export) -> Iterator[_Point]:
    numbers = _numbers(s, export)
    first = np.searchsorted(s.image, np.arange(len(s.names)))
    row = np.arange(len(s.image)) - first[s.image] if len(s.image) else np.zeros(0, int)
    order = np.argsort(s.point, kind="stable")
    begin = np.searchsorted(s.point[order], np.arange(len(numbers) + 1))
    for k, number in enumerate(numbers):
        rows = order[begin[k] : begin[k + 1]]
        errors = s.error_px[rows]
        known = errors[np.isfinite(errors)]
        r, g, b = s.colours[k].tolist()
        yield _Point(
            number=number,
            xyz=s.xyz[k],
            rgb=(r, g, b),
            error=float(known.mean()) if len(known) else -1.0,
            images=s.image[rows] + 1,
            rows=row[rows],
        )


def _cameras(s: Scene) -> tuple[list[tuple[str, Camera, tuple[float, ...]]], Draft]:
    rows: list[tuple[str, Camera, tuple[float, ...]]] = []
    deviations: list[tuple[str, str, float]] = []
    for camera in s.cameras:
        if (direct := written_directly(camera)) is not None:
            rows.append((direct[0], camera, direct[1]))
            continue
        fit = opencv_fit(camera)
        name, values = model_of(fit.camera)
        rows.append((name, camera, values))
        deviations.append((camera.id, name, fit.deviation_px))
    remarks, largest = deviation_remark(deviations)
    return rows, Draft(remarks=s.remarks + remarks, deviation_px=largest)


def write_binary(export: Export, folder: Path) -> Draft:
    """Write cameras.bin, images.bin and points3D.bin."""
    s = scene(export)
    cameras, draft = _cameras(s)
    with (folder / "cameras.bin").open("wb") as file:
        file.write(struct.pack("<Q", len(cameras)))
        for k, (name, camera, values) in enumerate(cameras, 1):
            file.write(struct.pack("<iiQQ", k, EVERY_NUMBER[name], camera.width_px, camera.height_px))
            file.write(struct.pack(f"<{len(values)}d", *values))
    numbers = np.array(_numbers(s, export), np.int64)
    with (folder / "images.bin").open("wb") as file:
        file.write(struct.pack("<Q", len(s.names)))
        for k, (q, t) in enumerate(_poses(s), 1):
            of_image = slice(*np.searchsorted(s.image, [k - 1, k]))
            file.write(struct.pack("<i7di", k, *q, *t, int(s.camera[k - 1]) + 1))
            file.write(s.names[k - 1].encode() + b"\0")
            points = np.zeros(of_image.stop - of_image.start, POINT2D)
            points["xy"], points["point"] = s.xy_px[of_image], numbers[s.point[of_image]]
            file.write(struct.pack("<Q", len(points)) + points.tobytes())
    with (folder / "points3D.bin").open("wb") as file:
        file.write(struct.pack("<Q", len(numbers)))
        for p in _points(s, export):
            file.write(struct.pack("<Q3d3BdQ", p.number, *p.xyz, *p.rgb, p.error, len(p.images)))
            track = np.zeros(len(p.images), TRACK)
            track["image"], track["row"] = p.images, p.rows
            file.write(track.tobytes())
    return draft


def _poses(s: Scene) -> list[tuple[list[float], list[float]]]:
    R, t = cv_pose(s)
    return list(zip(quaternions(R).tolist(), t.tolist(), strict=True))


def write_text(export: Export, folder: Path) -> Draft:
    """Write cameras.txt, images.txt and points3D.txt."""
    s = scene(export)
    blanks = [n for n in s.names if " " in n]
    if blanks:
        raise InputError("colmap.blank_in_name", image=blanks[0])
    cameras, draft = _cameras(s)
    with (folder / "cameras.txt").open("w", encoding="utf-8", newline="\n") as file:
        file.write("# CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n")
        for k, (name, camera, values) in enumerate(cameras, 1):
            file.write(f"{k} {name} {camera.width_px} {camera.height_px} {_row(values)}\n")
    numbers = _numbers(s, export)
    with (folder / "images.txt").open("w", encoding="utf-8", newline="\n") as file:
        file.write("# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n# POINTS2D[] as (X, Y, POINT3D_ID)\n")
        for k, (q, t) in enumerate(_poses(s), 1):
            a, b = np.searchsorted(s.image, [k - 1, k]).tolist()
            file.write(f"{k} {_row(q)} {_row(t)} {int(s.camera[k - 1]) + 1} {s.names[k - 1]}\n")
            triples = zip(s.xy_px[a:b].tolist(), s.point[a:b].tolist(), strict=True)
            file.write(" ".join(f"{exact(x)} {exact(y)} {numbers[p]}" for (x, y), p in triples) + "\n")
    with (folder / "points3D.txt").open("w", encoding="utf-8", newline="\n") as file:
        file.write("# POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[] as (IMAGE_ID, POINT2D_IDX)\n")
        for p in _points(s, export):
            track = " ".join(f"{i} {r}" for i, r in zip(p.images.tolist(), p.rows.tolist(), strict=True))
            rgb = " ".join(map(str, p.rgb))
            file.write(f"{p.number} {_row(p.xyz.tolist())} {rgb} {exact(p.error)} {track}".rstrip() + "\n")
    return draft


def _row(values: Sequence[float]) -> str:
    return " ".join(exact(v) for v in values)


PLACES = (".", "sparse/0", "0", "sparse")
"""Where in a folder a model stands."""


def read(path: Path) -> Import:
    """The block of a COLMAP model; `path` is its folder, or one with sparse/0 or 0 in it.

    raises  InputError with file and place
    """
    folder = next((path / place for place in PLACES if suffix_of(path / place)), None)
    if folder is None:
        raise InputError("colmap.no_model", file=path)
    model = read_model(folder)
    return _import(model, folder)


def _import(model: Model, folder: Path) -> Import:
    if not model.names:
        raise InputError("file.no_images", file=folder)
    remarks: list[Message] = []
    deviations: list[float] = []
    cameras: list[Camera] = []
    for number, forward in model.cameras.items():
        if isinstance(forward, Camera):
            cameras.append(forward)
            continue
        fit = camera_from_forward(forward, str(number), where=f"{folder}: ")
        cameras.append(fitted_camera(fit, str(number), remarks, deviations))
    R, t = image_poses(model, folder, remarks)
    order = {number: k for k, number in enumerate(model.cameras)}
    images = Images(
        ids=tuple(model.names),
        camera=np.array([order[c] for c in model.camera], np.int32),
        file=tuple(model.names),
        centre=-np.einsum("nji,nj->ni", R, t),
        rotation=SENSOR_FROM_CV @ R,
    )
    image, point = (np.concatenate([np.zeros(0, np.int64), *part]) for part in (model.image, model.point))
    xy = np.concatenate([np.zeros((0, 2)), *model.xy])
    seen = point != NO_POINT
    if not seen.all():
        remarks.append(note("import.points_without_object", n=int((~seen).sum()), total=len(seen)))
    numbers = np.array(list(model.xyz), np.int64)
    at = np.argsort(numbers)
    place = np.searchsorted(numbers, point[seen], sorter=at)
    found = at[np.minimum(place, len(numbers) - 1)] if len(numbers) else np.zeros(0, int)
    unknown = point[seen][numbers[found] != point[seen]] if len(numbers) else point[seen]
    if len(unknown):
        raise InputError("reference.unknown", kind="point", name=str(unknown[0]), where="points3D", file=folder)
    tracks = Tracks(
        point_ids=tuple(str(n) for n in numbers.tolist()),
        xyz=np.array(list(model.xyz.values()), float).reshape(-1, 3),
        image=image[seen],
        point=found,
        xy_px=xy[seen],
    )
    block, more = block_of(name=folder.name, source="COLMAP", cameras=tuple(cameras), images=images, tracks=tracks)
    colours = np.array(list(model.rgb.values()), np.uint8).reshape(-1, 3)
    largest = max(deviations, default=0.0)
    return Import(block=block, colours=colours, remarks=(*remarks, *more), deviation_px=largest)


register(
    Format(
        name="colmap",
        title="COLMAP model, binary",
        kind="folder",
        colours=True,
        write=write_binary,
        read=read,
        looks=lambda path: any((path / p / f"cameras{s}").is_file() for p in PLACES for s in (".bin", ".txt")),
    )
)
register(
    Format(name="colmap-text", title="COLMAP model, text", kind="folder", colours=True, write=write_text, read=read)
)
