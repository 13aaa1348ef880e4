"""COLMAP models: cameras, images and points3D, binary or text, written and read.

The pixel frame is ours: the origin is the outer corner of the first pixel.  Poses turn object axes into camera
axes x right, y down, z forward.  Rigs of one camera each are what COLMAP makes of these files, so rigs and
frames are not written; where a model has rigs, its images hold their own poses, and these are read.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.block import Camera, Images
from raybundle.cameras.conversions import camera_from_forward, opencv_fit
from raybundle.cameras.forward_camera import ForwardCamera
from raybundle.errors import InputError
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
from raybundle.io.reading.binary import Binary
from raybundle.io.reading.files import read_text
from raybundle.io.reading.words import no_number, number_of, numbers_of, quoted, whole_of
from raybundle.numerics.arrays import Array, Index

MODELS: dict[int, tuple[str, tuple[str, ...]]] = {
    0: ("SIMPLE_PINHOLE", ("f", "cx", "cy")),
    1: ("PINHOLE", ("fx", "fy", "cx", "cy")),
    2: ("SIMPLE_RADIAL", ("f", "cx", "cy", "k1")),
    3: ("RADIAL", ("f", "cx", "cy", "k1", "k2")),
    4: ("OPENCV", ("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2")),
    5: ("OPENCV_FISHEYE", ("fx", "fy", "cx", "cy", "k1", "k2", "k3", "k4")),
    6: ("FULL_OPENCV", ("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "d1", "d2", "d3")),
    8: ("SIMPLE_RADIAL_FISHEYE", ("f", "cx", "cy", "k1")),
    9: ("RADIAL_FISHEYE", ("f", "cx", "cy", "k1", "k2")),
    14: ("SIMPLE_FISHEYE", ("f", "cx", "cy")),
    15: ("FISHEYE", ("fx", "fy", "cx", "cy")),
}
"""Number -> name and parameters; of COLMAP 4.2.  Those that are not here are refused by name or number."""
NUMBERS = {name: number for number, (name, _) in MODELS.items()}
NO_POINT = -1
POINT2D = np.dtype([("xy", "<f8", 2), ("point", "<i8")])
TRACK = np.dtype([("image", "<i4"), ("row", "<i4")])


def model_of(camera: ForwardCamera) -> tuple[str, tuple[float, ...]]:
    """Name of the COLMAP model and its parameters for a camera with the terms of one of those we write."""
    if camera.projection == "equidistant":
        name = "OPENCV_FISHEYE"
    elif camera.is_pinhole:
        name = "PINHOLE"
    else:
        name = "FULL_OPENCV" if any((camera.k3, camera.d1, camera.d2, camera.d3)) else "OPENCV"
    return name, tuple(float(getattr(camera, term)) for term in MODELS[NUMBERS[name]][1])


def forward_of(name: str, width: int, height: int, values: Sequence[float]) -> ForwardCamera:
    """The forward camera of a COLMAP model and its parameters."""
    terms = dict(zip(MODELS[NUMBERS[name]][1], values, strict=True))
    if "f" in terms:
        terms["fx"] = terms["fy"] = terms.pop("f")
    projection = "equidistant" if "FISHEYE" in name else "central"
    return ForwardCamera(width_px=width, height_px=height, projection=projection, **terms)


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


def quaternions(rotation: Array) -> Array:
    """Unit quaternions (n, 4), w first and not negative, of rotations (n, 3, 3)."""
    from scipy.spatial.transform import Rotation  # noqa: PLC0415  (SciPy only where it is used)

    q = np.roll(Rotation.from_matrix(rotation).as_quat(), 1, axis=1)
    return q * np.where(q[:, :1] < 0, -1.0, 1.0)


def rotations(quaternion: Array) -> Array:
    """Rotations (n, 3, 3) of quaternions (n, 4), w first, of any length but 0."""
    from scipy.spatial.transform import Rotation  # noqa: PLC0415

    return Rotation.from_quat(np.roll(quaternion, -1, axis=1)).as_matrix()


def _cameras(s: Scene) -> tuple[list[tuple[str, ForwardCamera, tuple[float, ...]]], Draft]:
    rows: list[tuple[str, ForwardCamera, tuple[float, ...]]] = []
    deviations: list[tuple[str, str, float]] = []
    for camera in s.cameras:
        fit = opencv_fit(camera)
        name, values = model_of(fit.camera)
        rows.append((name, fit.camera, values))
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
            file.write(struct.pack("<iiQQ", k, NUMBERS[name], camera.width_px, camera.height_px))
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
        raise InputError(
            f"image {blanks[0]!r} has a blank in its name, which COLMAP's text files cannot hold; use the binary "
            "format (colmap), or rename the photographs"
        )
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


@dataclass(slots=True)
class _Model:
    """What stands in the three files, still with COLMAP's numbers."""

    cameras: dict[int, ForwardCamera]
    names: list[str]
    camera: list[int]
    quaternion: list[Sequence[float]]
    translation: list[Sequence[float]]
    image: list[Index]
    """Position of the image, for every observation of the image"""
    xy: list[Array]
    point: list[Index]
    """Number of the point; -1 for none"""
    xyz: dict[int, Sequence[float]]
    rgb: dict[int, Sequence[int]]


PLACES = (".", "sparse/0", "0", "sparse")
"""Where in a folder a model stands."""


def _new_model() -> _Model:
    return _Model({}, [], [], [], [], [], [], [], {}, {})


def read(path: Path) -> Import:
    """The block of a COLMAP model; `path` is its folder, or one with sparse/0 or 0 in it.

    raises  InputError with file and place
    """
    folder = next((path / place for place in PLACES if _suffix(path / place)), None)
    if folder is None:
        raise InputError("holds no COLMAP model: cameras, images and points3D, all .bin or all .txt", file=path)
    model = _new_model()
    if _suffix(folder) == ".bin":
        _read_cameras_binary(folder / "cameras.bin", model)
        _read_images_binary(folder / "images.bin", model)
        _read_points_binary(folder / "points3D.bin", model)
    else:
        _read_cameras_text(folder / "cameras.txt", model)
        _read_images_text(folder / "images.txt", model)
        _read_points_text(folder / "points3D.txt", model)
    return _import(model, folder)


def _suffix(folder: Path) -> str:
    for suffix in (".bin", ".txt"):
        if all((folder / f"{n}{suffix}").is_file() for n in ("cameras", "images", "points3D")):
            return suffix
    return ""


def _import(model: _Model, folder: Path) -> Import:
    if not model.names:
        raise InputError("holds no image", file=folder)
    remarks: list[str] = []
    deviations: list[float] = []
    cameras: list[Camera] = []
    for number, forward in model.cameras.items():
        fit = camera_from_forward(forward, str(number), where=f"{folder}: ")
        cameras.append(fitted_camera(fit, f"camera {number}", remarks, deviations))
    R = np.swapaxes(rotations(np.array(model.quaternion, float)), -1, -2)
    centre = -np.einsum("nij,nj->ni", R, np.array(model.translation, float))
    order = {number: k for k, number in enumerate(model.cameras)}
    images = Images(
        ids=tuple(model.names),
        camera=np.array([order[c] for c in model.camera], np.int32),
        file=tuple(model.names),
        centre=centre,
        rotation=SENSOR_FROM_CV @ np.swapaxes(R, -1, -2),
    )
    image, point = (np.concatenate([np.zeros(0, np.int64), *part]) for part in (model.image, model.point))
    xy = np.concatenate([np.zeros((0, 2)), *model.xy])
    seen = point != NO_POINT
    if not seen.all():
        remarks.append(f"{int((~seen).sum())} of {len(seen)} image points belong to no object point and are left out")
    numbers = np.array(list(model.xyz), np.int64)
    at = np.argsort(numbers)
    place = np.searchsorted(numbers, point[seen], sorter=at)
    found = at[np.minimum(place, len(numbers) - 1)] if len(numbers) else np.zeros(0, int)
    unknown = point[seen][numbers[found] != point[seen]] if len(numbers) else point[seen]
    if len(unknown):
        raise InputError(f"an image refers to point {unknown[0]}, which points3D does not hold", file=folder)
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


def _checked_camera(
    path: Path, place: str, line: int | None, name: str, size: tuple[int, int], values: Sequence[float]
) -> ForwardCamera:
    """A forward camera of plausible size and principal distance."""
    if not all(0 < s <= 10_000_000 for s in size):
        raise InputError(f"{place}: a format of {size[0]} x {size[1]} px cannot be", file=path, line=line)
    forward = forward_of(name, *size, values)
    if not (forward.fx > 0 and forward.fy > 0):
        raise InputError(
            f"{place}: principal distance {forward.fx:g}, {forward.fy:g} px; it must be positive", file=path, line=line
        )
    return forward


def _unknown_model(path: Path, place: str, line: int | None, name: object) -> InputError:
    known = ", ".join(n for n, _ in MODELS.values())
    return InputError(f"{place}: camera model {name} is not read; known: {known}", file=path, line=line)


def _add_image(
    model: _Model, path: Path, line: int | None, camera: int, name: str, pose: Sequence[float],
) -> None:  # fmt: skip
    if camera not in model.cameras:
        raise InputError(f"image {quoted(name)} refers to camera {camera}, which is not there", file=path, line=line)
    if not 1e-6 < sum(v * v for v in pose[:4]) < 1e6:
        raise InputError(f"image {quoted(name)}: its quaternion has no direction", file=path, line=line)
    model.names.append(name)
    model.camera.append(camera)
    model.quaternion.append(pose[:4])
    model.translation.append(pose[4:])


def _check_names(model: _Model, path: Path) -> None:
    seen: set[str] = set()
    for name in model.names:
        if name in seen or name != name.strip():
            raise InputError(f"image name {quoted(name)} stands twice, or has blanks at its ends", file=path)
        seen.add(name)


def _read_cameras_binary(path: Path, model: _Model) -> None:
    file = Binary(path)
    for _ in range(file.count(24 + 24, "cameras")):
        number, kind, width, height = file.take("iiQQ")
        if kind not in MODELS:
            raise _unknown_model(path, f"camera {number}", None, f"number {kind}")
        name, terms = MODELS[kind]
        values = file.floats(len(terms), f"camera {number}")
        if number in model.cameras:
            file.fail(f"camera {number} stands twice")
        model.cameras[number] = _checked_camera(path, f"camera {number}", None, name, (width, height), values)
    file.end()


def _read_images_binary(path: Path, model: _Model) -> None:
    file = Binary(path)
    for k in range(file.count(4 + 56 + 4 + 2 + 8, "images")):
        (number,) = file.take("i")
        pose = file.floats(7, f"image {number}")
        (camera,) = file.take("i")
        _add_image(model, path, None, camera, file.name(), pose)
        points = file.records(POINT2D, file.count(POINT2D.itemsize, "image points"))
        matched = points["point"] != NO_POINT
        if not np.isfinite(points["xy"][matched]).all():
            file.fail(f"image {number} holds an image point that is not finite")
        model.image.append(np.full(len(points), k, np.int64))
        model.xy.append(points["xy"])
        model.point.append(points["point"].astype(np.int64))
    file.end()
    _check_names(model, path)


def _read_points_binary(path: Path, model: _Model) -> None:
    file = Binary(path)
    for _ in range(file.count(8 + 24 + 3 + 8 + 8, "points")):
        (number,) = file.take("Q")
        if number in model.xyz or number >= 1 << 63:
            file.fail(f"point {number} stands twice, or has no usable number")
        model.xyz[number] = file.floats(3, f"point {number}")
        model.rgb[number] = file.take("3B")
        file.take("d")
        file.records(TRACK, file.count(TRACK.itemsize, "track elements"))
    file.end()


def _lines(path: Path) -> Iterator[tuple[int, str]]:
    """Lines with their numbers, without comments."""
    for number, line in enumerate(read_text(path).split("\n"), 1):
        if not line.startswith("#"):
            yield number, line.strip()


def _floats(path: Path, line: int, words: Sequence[str], what: str) -> list[float]:
    values = numbers_of(words)
    if values is None:
        bad = next(w for w in words if number_of(w) is None)
        raise InputError(f"{what}: {no_number(bad)}", file=path, line=line)
    return values.tolist()


def _whole(path: Path, line: int, word: str, what: str) -> int:
    value = whole_of(word)
    if value is None:
        raise InputError(f"{what}: {quoted(word)} is not a whole number", file=path, line=line)
    if not -(1 << 62) < value < 1 << 62:
        raise InputError(f"{what}: {quoted(word)} is too large", file=path, line=line)
    return value


def _read_cameras_text(path: Path, model: _Model) -> None:
    for line, text in _lines(path):
        words = text.split()
        if not words:
            continue
        if len(words) < 5:
            raise InputError("number, model, width, height and parameters are needed", file=path, line=line)
        number, name = _whole(path, line, words[0], "camera"), words[1]
        place = f"camera {number}"
        if name not in NUMBERS:
            raise _unknown_model(path, place, line, quoted(name))
        width, height = (_whole(path, line, w, place) for w in words[2:4])
        values = _floats(path, line, words[4:], place)
        if len(values) != len(MODELS[NUMBERS[name]][1]):
            raise InputError(
                f"{place}: {len(values)} parameters, {name} has {len(MODELS[NUMBERS[name]][1])}", file=path, line=line
            )
        if number in model.cameras:
            raise InputError(f"{place} stands twice", file=path, line=line)
        model.cameras[number] = _checked_camera(path, place, line, name, (width, height), values)


def _read_images_text(path: Path, model: _Model) -> None:
    lines = [(n, t) for n, t in _lines(path)]
    while lines and not lines[0][1]:
        lines.pop(0)
    for line, head in lines[::2] if not lines or lines[-1][1] or len(lines) % 2 == 0 else lines[:-1:2]:
        words = head.split(maxsplit=9)
        if len(words) != 10:
            raise InputError("number, 4 + 3 numbers, camera and name are needed", file=path, line=line)
        pose = _floats(path, line, words[1:8], "image")
        _add_image(model, path, line, _whole(path, line, words[8], "camera"), words[9], pose)
    for k, (line, text) in enumerate(lines[1::2][: len(model.names)]):
        words = text.split()
        if len(words) % 3:
            raise InputError(f"{len(words)} words are not triples of x, y and a point", file=path, line=line)
        xy = _floats(path, line, [w for n, w in enumerate(words) if n % 3 < 2], "image points")
        points = [_whole(path, line, w, "point") for w in words[2::3]]
        model.image.append(np.full(len(points), k, np.int64))
        model.xy.append(np.array(xy).reshape(-1, 2))
        model.point.append(np.array(points, np.int64))
    _check_names(model, path)


def _read_points_text(path: Path, model: _Model) -> None:
    for line, text in _lines(path):
        words = text.split()
        if not words:
            continue
        if len(words) < 8:
            raise InputError("number, 3 coordinates, 3 colours and an error are needed", file=path, line=line)
        number = _whole(path, line, words[0], "point")
        if number in model.xyz or number < 0:
            raise InputError(f"point {number} stands twice, or is negative", file=path, line=line)
        model.xyz[number] = _floats(path, line, words[1:4], f"point {number}")
        rgb = [_whole(path, line, w, "colour") for w in words[4:7]]
        model.rgb[number] = [min(max(c, 0), 255) for c in rgb]


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
