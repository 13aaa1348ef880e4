"""The files of a COLMAP model, binary or text: cameras, images, points, and rigs with their frames."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from raybundle.block import Camera
from raybundle.cameras.forward_camera import ForwardCamera
from raybundle.errors import InputError
from raybundle.io.formats.colmap_cameras import PARAMETERS, checked_camera, name_of, unknown_model
from raybundle.io.ids import repeated
from raybundle.io.reading.binary import Binary
from raybundle.io.reading.files import read_text
from raybundle.io.reading.words import no_number, number_of, numbers_of, quoted, whole_of
from raybundle.numerics.arrays import Array, Index

NO_POINT = -1
POINT2D = np.dtype([("xy", "<f8", 2), ("point", "<i8")])
TRACK = np.dtype([("image", "<i4"), ("row", "<i4")])
CAMERA, SENSORS = 0, {"CAMERA": 0, "IMU": 1}
"""Kinds of sensors in a rig."""
Pose = Sequence[float]
"""Quaternion, w first, and translation."""


@dataclass(slots=True)
class Model:
    """What stands in the files, still with COLMAP's numbers."""

    cameras: dict[int, ForwardCamera | Camera] = field(default_factory=dict[int, "ForwardCamera | Camera"])
    numbers: list[int] = field(default_factory=list[int])
    names: list[str] = field(default_factory=list[str])
    camera: list[int] = field(default_factory=list[int])
    pose: list[Pose] = field(default_factory=list[Pose])
    image: list[Index] = field(default_factory=list["Index"])
    """Position of the image, for every observation of the image"""
    xy: list[Array] = field(default_factory=list["Array"])
    point: list[Index] = field(default_factory=list["Index"])
    """Number of the point; -1 for none"""
    xyz: dict[int, Sequence[float]] = field(default_factory=dict[int, Sequence[float]])
    rgb: dict[int, Sequence[int]] = field(default_factory=dict[int, Sequence[int]])
    rigs: dict[int, dict[tuple[int, int], Pose | None]] = field(
        default_factory=dict[int, dict[tuple[int, int], "Pose | None"]]
    )
    """Rig -> kind and number of a sensor -> its pose in the rig; None where the rig states none"""
    frames: list[Frame] = field(default_factory=list["Frame"])


@dataclass(frozen=True, slots=True, kw_only=True)
class Frame:
    """An instant of a rig."""

    number: int
    rig: int
    pose: Pose
    data: tuple[tuple[int, int, int], ...]
    """Kind and number of the sensor, number of its image or measurement"""


def suffix_of(folder: Path) -> str:
    """Ending of the files of a model in a folder, .bin or .txt; empty where there is no model."""
    for suffix in (".bin", ".txt"):
        if all((folder / f"{n}{suffix}").is_file() for n in ("cameras", "images", "points3D")):
            return suffix
    return ""


def read_model(folder: Path) -> Model:
    """The model in a folder; raises InputError with file and place."""
    suffix, model = suffix_of(folder), Model()
    binary = suffix == ".bin"
    (_read_cameras_binary if binary else _read_cameras_text)(folder / f"cameras{suffix}", model)
    (_read_images_binary if binary else _read_images_text)(folder / f"images{suffix}", model)
    (_read_points_binary if binary else _read_points_text)(folder / f"points3D{suffix}", model)
    rigs, frames = folder / f"rigs{suffix}", folder / f"frames{suffix}"
    if rigs.is_file() and frames.is_file():
        (_read_rigs_binary if binary else _read_rigs_text)(rigs, model)
        (_read_frames_binary if binary else _read_frames_text)(frames, model)
    elif rigs.is_file() or frames.is_file():
        missing = frames if rigs.is_file() else rigs
        raise InputError("colmap.file_missing", other=(rigs if rigs.is_file() else frames).name, file=missing)
    return model


def _add_image(model: Model, path: Path, line: int | None, number: int, camera: int, name: str, pose: Pose) -> None:
    if camera not in model.cameras:
        raise InputError("image.unknown_camera", image=quoted(name), camera=str(camera), file=path, line=line)
    if not 1e-6 < sum(v * v for v in pose[:4]) < 1e6:
        raise InputError("rotation.quaternion", kind="image", name=quoted(name), file=path, line=line)
    model.numbers.append(number)
    model.names.append(name)
    model.camera.append(camera)
    model.pose.append(pose)


def _check_names(model: Model, path: Path) -> None:
    if len(set(model.numbers)) < len(model.numbers):
        raise InputError("name.twice", kind="image", name=repeated(map(str, model.numbers)), file=path)
    seen: set[str] = set()
    for name in model.names:
        if name != name.strip():
            raise InputError("name.blanks", name=quoted(name), file=path)
        if name in seen:
            raise InputError("name.twice", kind="image", name=quoted(name), file=path)
        seen.add(name)


def _read_cameras_binary(path: Path, model: Model) -> None:
    file = Binary(path)
    for _ in range(file.count(24 + 16, "cameras")):
        number, kind, width, height = file.take("iiQQ")
        name = name_of(kind)
        if name not in PARAMETERS:
            raise unknown_model(path, number, None, name)
        values = file.floats(len(PARAMETERS[name]), "camera", number)
        if number in model.cameras:
            file.fail("name.twice", kind="camera", name=str(number))
        model.cameras[number] = checked_camera(path, number, None, name, (width, height), values)
    file.end()


def _read_images_binary(path: Path, model: Model) -> None:
    file = Binary(path)
    for k in range(file.count(4 + 56 + 4 + 2 + 8, "images")):
        (number,) = file.take("i")
        pose = file.floats(7, "image", number)
        (camera,) = file.take("i")
        _add_image(model, path, None, number, camera, file.name(), pose)
        points = file.records(POINT2D, file.count(POINT2D.itemsize, "image_points"))
        matched = points["point"] != NO_POINT
        if not np.isfinite(points["xy"][matched]).all():
            file.fail("image.point_not_finite", image=str(number))
        model.image.append(np.full(len(points), k, np.int64))
        model.xy.append(points["xy"])
        model.point.append(points["point"].astype(np.int64))
    file.end()
    _check_names(model, path)


def _read_points_binary(path: Path, model: Model) -> None:
    file = Binary(path)
    for _ in range(file.count(8 + 24 + 3 + 8 + 8, "points")):
        (number,) = file.take("Q")
        _check_point(model, path, None, number)
        model.xyz[number] = file.floats(3, "point", number)
        model.rgb[number] = file.take("3B")
        file.take("d")
        file.records(TRACK, file.count(TRACK.itemsize, "track_elements"))
    file.end()


def _check_point(model: Model, path: Path, line: int | None, number: int) -> None:
    """Raise where the number of a point is no 63-bit number, or another point has it."""
    if not 0 <= number < 1 << 63:
        raise InputError("point.number_invalid", number=str(number), file=path, line=line)
    if number in model.xyz:
        raise InputError("name.twice", kind="point", name=str(number), file=path, line=line)


def _lines(path: Path) -> Iterator[tuple[int, str]]:
    """Lines with their numbers, without comments."""
    for number, line in enumerate(read_text(path).split("\n"), 1):
        if not line.startswith("#"):
            yield number, line.strip()


def _floats(path: Path, line: int, words: Sequence[str]) -> list[float]:
    values = numbers_of(words)
    if values is None:
        bad = next(w for w in words if number_of(w) is None)
        raise InputError(no_number(bad), file=path, line=line)
    return values.tolist()


def _whole(path: Path, line: int, word: str) -> int:
    value = whole_of(word)
    if value is None:
        raise InputError("value.no_whole_number", value=quoted(word), file=path, line=line)
    if not -(1 << 62) < value < 1 << 62:
        raise InputError("value.no_whole_number", value=quoted(word), file=path, line=line)
    return value


def _read_cameras_text(path: Path, model: Model) -> None:
    for line, text in _lines(path):
        words = text.split()
        if not words:
            continue
        if len(words) < 5:
            raise InputError("colmap.camera_line", file=path, line=line)
        number, name = _whole(path, line, words[0]), words[1]
        if name not in PARAMETERS:
            raise unknown_model(path, number, line, quoted(name))
        width, height = (_whole(path, line, w) for w in words[2:4])
        values = _floats(path, line, words[4:])
        if len(values) != (count := len(PARAMETERS[name])):
            raise InputError(
                "camera.parameter_count",
                camera=str(number),
                n=len(values),
                model=name,
                needed=count,
                file=path,
                line=line,
            )
        if number in model.cameras:
            raise InputError("name.twice", kind="camera", name=str(number), file=path, line=line)
        model.cameras[number] = checked_camera(path, number, line, name, (width, height), values)


def _read_images_text(path: Path, model: Model) -> None:
    """Two lines for each image; its image points stand in the line after its name, which may be empty.

    Blank lines before an image are passed over, as COLMAP does.
    """
    lines = _lines(path)
    for line, head in lines:
        if not head:
            continue
        words = head.split(maxsplit=9)
        if len(words) != 10:
            raise InputError("colmap.image_line", file=path, line=line)
        pose = _floats(path, line, words[1:8])
        number, camera = _whole(path, line, words[0]), _whole(path, line, words[8])
        _add_image(model, path, line, number, camera, words[9], pose)
        line, text = next(lines, (line, ""))  # noqa: PLW2901  (the second line of the image)
        words = text.split()
        if len(words) % 3:
            raise InputError("colmap.image_points_line", n=len(words), file=path, line=line)
        xy = _floats(path, line, [w for n, w in enumerate(words) if n % 3 < 2])
        points = [_whole(path, line, w) for w in words[2::3]]
        model.image.append(np.full(len(points), len(model.names) - 1, np.int64))
        model.xy.append(np.array(xy).reshape(-1, 2))
        model.point.append(np.array(points, np.int64))
    _check_names(model, path)


def _read_points_text(path: Path, model: Model) -> None:
    for line, text in _lines(path):
        words = text.split()
        if not words:
            continue
        if len(words) < 8:
            raise InputError("colmap.point_line", file=path, line=line)
        number = _whole(path, line, words[0])
        _check_point(model, path, line, number)
        model.xyz[number] = _floats(path, line, words[1:4])
        rgb = [_whole(path, line, w) for w in words[4:7]]
        model.rgb[number] = [min(max(c, 0), 255) for c in rgb]


def _read_rigs_binary(path: Path, model: Model) -> None:
    file = Binary(path)
    for _ in range(file.count(8, "rigs")):
        number, count = file.take("II")
        sensors: dict[tuple[int, int], Pose | None] = {}
        for k in range(count):
            sensor = file.take("iI")
            posed = k > 0 and file.take("B")[0] != 0
            sensors[sensor] = REFERENCE if k == 0 else file.floats(7, "rig", number) if posed else None
        _add_rig(model, path, None, number, sensors)
    file.end()


def _read_frames_binary(path: Path, model: Model) -> None:
    file = Binary(path)
    for _ in range(file.count(8 + 56 + 4, "frames")):
        number, rig = file.take("II")
        pose = file.floats(7, "frame", number)
        data = [file.take("iIQ") for _ in range(file.take("I")[0])]
        _add_frame(model, path, None, Frame(number=number, rig=rig, pose=pose, data=tuple(data)))  # type: ignore[arg-type]
    file.end()


REFERENCE: Pose = (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
"""Pose of the reference sensor in its rig."""


def _add_rig(
    model: Model, path: Path, line: int | None, number: int, sensors: dict[tuple[int, int], Pose | None]
) -> None:
    if number in model.rigs:
        raise InputError("name.twice", kind="rig", name=str(number), file=path, line=line)
    for pose in sensors.values():
        _check_pose(path, line, "rig", number, pose or REFERENCE)
    model.rigs[number] = sensors


def _add_frame(model: Model, path: Path, line: int | None, frame: Frame) -> None:
    if frame.rig not in model.rigs:
        raise InputError("frame.unknown_rig", frame=frame.number, rig=frame.rig, file=path, line=line)
    _check_pose(path, line, "frame", frame.number, frame.pose)
    for kind, sensor, _ in frame.data:
        if (kind, sensor) not in model.rigs[frame.rig]:
            raise InputError(
                "frame.unknown_sensor", frame=frame.number, sensor=sensor, rig=frame.rig, file=path, line=line
            )
    model.frames.append(frame)


def _check_pose(path: Path, line: int | None, kind: str, number: int, pose: Pose) -> None:
    if not 1e-6 < sum(v * v for v in pose[:4]) < 1e6:
        raise InputError("rotation.quaternion", kind=kind, name=str(number), file=path, line=line)


class _Words:
    """The words of a line, from front to back."""

    def __init__(self, path: Path, line: int, text: str) -> None:
        self.path, self.line, self.words = path, line, text.split()

    def take(self, count: int) -> list[str]:
        """The next words."""
        if len(self.words) < count:
            raise InputError("line.ends_early", file=self.path, line=self.line)
        found, self.words = self.words[:count], self.words[count:]
        return found

    def whole(self) -> int:
        """The next whole number."""
        return _whole(self.path, self.line, self.take(1)[0])

    def sensor(self) -> tuple[int, int]:
        """Kind and number of the next sensor."""
        word = self.take(1)[0]
        if word not in SENSORS:
            raise InputError(
                "value.not_supported", value=quoted(word), known=list(SENSORS), file=self.path, line=self.line
            )
        return SENSORS[word], self.whole()

    def pose(self) -> Pose:
        """The next pose."""
        return _floats(self.path, self.line, self.take(7))

    def end(self) -> None:
        """Raise where words are left."""
        if self.words:
            raise InputError("line.words_left", n=len(self.words), file=self.path, line=self.line)


def _read_rigs_text(path: Path, model: Model) -> None:
    for line, text in _lines(path):
        if not text:
            continue
        words = _Words(path, line, text)
        number, count = words.whole(), words.whole()
        sensors: dict[tuple[int, int], Pose | None] = {}
        for k in range(count):
            sensor = words.sensor()
            posed = k > 0 and words.whole() != 0
            sensors[sensor] = REFERENCE if k == 0 else words.pose() if posed else None
        words.end()
        _add_rig(model, path, line, number, sensors)


def _read_frames_text(path: Path, model: Model) -> None:
    for line, text in _lines(path):
        if not text:
            continue
        words = _Words(path, line, text)
        number, rig, pose = words.whole(), words.whole(), words.pose()
        data = tuple((*words.sensor(), words.whole()) for _ in range(words.whole()))
        words.end()
        _add_frame(model, path, line, Frame(number=number, rig=rig, pose=pose, data=data))
