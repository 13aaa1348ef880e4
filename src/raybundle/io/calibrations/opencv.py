"""OpenCV's calibrations: camera matrix and distortion coefficients in YAML or JSON; also ROS camera_info.

OpenCV counts pixels from the centre of the first one: its cx, cy are half a pixel less than ours.  Coefficients
stand in the order k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 taux tauy, of which the first 4, 5, 8, 12 or 14 are given;
its k4 k5 k6 are our denominator d1 d2 d3.  A fisheye has four, for powers of the angle off the axis.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, cast

import numpy as np

from raybundle.cameras.forward_camera import ForwardCamera
from raybundle.cameras.opencv import COUNTS, HALF, ORDER
from raybundle.errors import phrase
from raybundle.io.calibrations.base import Calibration, CalibrationFormat, Conversion, Variant, register
from raybundle.io.calibrations.yaml_text import read_yaml
from raybundle.io.digits import exact
from raybundle.io.reading.ledger import declare
from raybundle.io.reading.trees import Json, read_json
from raybundle.numerics.arrays import Array

FISHEYE = ("k1", "k2", "k3", "k4")
MATRIX = (
    "camera_matrix", "cameraMatrix", "Camera_Matrix", "intrinsic_matrix", "intrinsics", "mtx", "matrix", "K", "M",
)  # fmt: skip
DISTORTION = (
    "distortion_coefficients", "Distortion_Coefficients", "distCoeffs", "dist_coeffs", "distortion", "dist", "D",
)  # fmt: skip
WIDTH, HEIGHT = ("image_width", "image_Width", "width"), ("image_height", "image_Height", "height")
SIZES = ("image_size", "imageSize", "img_size", "size", "resolution")
MODEL_WORDS = ("distortion_model", "camera_model", "model", "fisheye_model")
NAMES = ("camera_name", "name")
_SIDE = r"(left|right|l|r|cam(?:era)?_?[0-9]+|[0-9]+)"
_FISHEYE_MODEL = r"equi|equidistant|\w*fish_?eye\w*"
_FLAG, _KIND = r"\w*fish_?eye\w*", r"\w*(?:model|type|projection|lens)"
"""Keys that state a fisheye: a flag, and the name of a model."""
FAR, NEAR = 0.15, 0.05
"""Distances of a principal point from the centre, as shares of width and height.  Lenses stand within NEAR; a cut
picture may have FAR, and then no other format has its centre at the same place."""


def read_file(path: Path) -> Json:
    """The JSON or YAML in a file."""
    return read_json(path) if path.suffix.lower() == ".json" else read_yaml(path)


def _member(top: Json, names: Sequence[str]) -> Json | None:
    return next((top.get(n) for n in names if top.has(n)), None)


def _numbers(value: Json) -> Array:
    """All numbers of a matrix: {rows, cols, data}, or a list, nested or not."""
    if value.has("data"):
        numbers = np.array([i.number() for i in value.get("data").items()])
        rows, cols = (value.get(k).whole(0, 10_000) if value.has(k) else None for k in ("rows", "cols"))
        if rows is not None and cols is not None and rows * cols != len(numbers):
            value.fail("opencv.matrix_size", rows=rows, columns=cols, n=len(numbers))
        return numbers
    flat: list[float] = []
    for item in value.items():
        flat += [i.number() for i in item.items()] if isinstance(item.value, list) else [item.number()]
    return np.array(flat)


def _size(top: Json, size_px: tuple[int, int] | None) -> tuple[int, int]:
    width, height = _member(top, WIDTH), _member(top, HEIGHT)
    if width is not None and height is not None:
        return width.whole(), height.whole()
    both = _member(top, SIZES)
    if both is not None:
        named = both if isinstance(both.value, dict) else None
        sides = (
            None if named is None else (_member(named, ("width", "w", "cols")), _member(named, ("height", "h", "rows")))
        )
        if sides is not None and sides[0] is not None and sides[1] is not None:
            return sides[0].whole(), sides[1].whole()
        items = list(both.mapping().values()) if named else both.items()
        if len(items) == 2:
            return items[0].whole(), items[1].whole()
        both.fail("opencv.size_expected")
    if size_px is None:
        top.fail("calibration.no_size")
    return size_px


def _is_fisheye(table: Json) -> bool:
    """Whether a flag of a fisheye is set, or a model of this name is stated."""
    flags = [table.get(k).value for k in table.names() if re.fullmatch(_FLAG, k, re.IGNORECASE)]
    kinds = [table.get(k).value for k in table.names() if re.fullmatch(_KIND, k, re.IGNORECASE)]
    return any(str(v).strip().lower() in {"1", "1.0", "true", "yes"} for v in flags) or any(
        re.fullmatch(_FISHEYE_MODEL, str(v).strip().lower()) for v in kinds
    )


def _key_pattern(names: Sequence[str]) -> re.Pattern[str]:
    """A key that is one of some names, alone or with the side or number of a camera before or after it."""
    words = "|".join(sorted({n.lower().replace("_", "_?") for n in names}, key=len, reverse=True))
    return re.compile(rf"(?:{_SIDE}_?)?({words})(?:_?{_SIDE})?", re.IGNORECASE)


_MATRIX_KEY, _DISTORTION_KEY = _key_pattern(MATRIX), _key_pattern(DISTORTION)


def _by_side(members: Mapping[str, Any], pattern: re.Pattern[str], *, only: int | None = None) -> dict[str, str]:
    """Keys by the side or number in them, "" for a key without one.

    only  how many numbers a value has; others are no such entries
    """
    found: dict[str, str] = {}
    for key, value in members.items():
        match = pattern.fullmatch(key)
        if match is None or not isinstance(value, list | dict):
            continue
        if only is not None and _length(value) != only:
            continue
        found.setdefault((match[1] or match[3] or "").lower(), key)
    return found


def _length(value: Any) -> int | None:
    """How many elements a matrix has."""
    if isinstance(value, dict):
        value = cast("dict[str, Any]", value).get("data")
    if not isinstance(value, list):
        return None
    rows = cast("list[Any]", value)
    return sum(len(cast("list[Any]", r)) if isinstance(r, list) else 1 for r in rows)


def _read(path: Path, size_px: tuple[int, int] | None, *, fisheye: bool) -> tuple[Calibration, ...]:
    top = read_file(path)
    declare(*WIDTH, *HEIGHT, *SIZES, *NAMES, *MODEL_WORDS, "dt", "type_id")
    groups = _groups(top)
    if not groups:
        top.fail("opencv.no_matrix", names=list(MATRIX))
    found: list[Calibration] = []
    for id_, group in groups:
        found += _cameras(path, id_, group, top, size_px, fisheye=fisheye)
    return tuple(found)


def _groups(top: Json) -> list[tuple[str, Json]]:
    """The tables that hold camera matrices: the file itself, or members of it, each with its name."""
    names = top.names()
    if _by_side(top.value, _MATRIX_KEY):
        return [("", top)]
    tables = [k for k in names if isinstance(top.value[k], dict)]
    return [(k, top.get(k)) for k in tables if _by_side(top.value[k], _MATRIX_KEY)]


def _cameras(
    path: Path, id_: str, table: Json, top: Json, size_px: tuple[int, int] | None, *, fisheye: bool
) -> list[Calibration]:
    """The cameras of one table: one for each side or number that its camera matrices have."""
    matrices = _by_side(table.value, _MATRIX_KEY, only=9) or _by_side(table.value, _MATRIX_KEY)
    distortions = _by_side(table.value, _DISTORTION_KEY)
    if len(matrices) == 1 and len(distortions) == 1:
        distortions = dict(zip(matrices, distortions.values(), strict=True))
    _check_kind(table, top, fisheye=fisheye)
    name = _member(table, NAMES)
    stem = id_ or (name.text().strip() if name is not None and isinstance(name.value, str) else "") or path.stem
    sized = table if _has_size(table) else top
    return [
        _camera(
            stem if len(matrices) == 1 else f"{stem}-{side or 'first'}", table.get(matrix),
            table.get(distortions[side]) if side in distortions else None, _size(sized, size_px), fisheye=fisheye,
        )
        for side, matrix in matrices.items()
    ]  # fmt: skip


def _has_size(table: Json) -> bool:
    return _member(table, SIZES) is not None or _member(table, WIDTH) is not None


def _check_kind(table: Json, top: Json, *, fisheye: bool) -> None:
    if (_is_fisheye(table) or _is_fisheye(top)) and not fisheye:
        top.fail("opencv.fisheye")


def _camera(id_: str, matrix: Json, distortion: Json | None, size: tuple[int, int], *, fisheye: bool) -> Calibration:
    K = _numbers(matrix)
    if len(K) != 9:
        matrix.fail("value.count", n=len(K), needed=9)
    fx, skew, cx, zero, fy, cy, *last = K.tolist()
    if zero or last != [0, 0, 1] or fx <= 0 or fy <= 0:
        matrix.fail("opencv.matrix_form")
    misplaced = _check_size(matrix, (cx + HALF, cy + HALF), size)
    coefficients = np.zeros(4) if distortion is None else _numbers(distortion)
    place = distortion or matrix
    if fisheye and len(coefficients) != 4:
        place.fail("opencv.coefficient_count", n=len(coefficients), known=[4])
    if not fisheye and len(coefficients) not in COUNTS:
        place.fail("opencv.coefficient_count", n=len(coefficients), known=list(COUNTS))
    remarks = [*misplaced]
    if distortion is None:
        remarks.append(phrase("calibration_remark.no_distortion"))
    if skew and not fisheye:
        remarks.append(phrase("calibration_remark.skew", skew=skew))
        skew = 0.0
    camera = ForwardCamera(
        width_px=size[0],
        height_px=size[1],
        projection="equidistant" if fisheye else "central",
        fx=fx,
        fy=fy,
        cx=cx + HALF,
        cy=cy + HALF,
        skew=skew,
        **dict(zip(FISHEYE if fisheye else ORDER, coefficients.tolist(), strict=False)),
    )
    return Calibration(id=id_, camera=camera, remarks=tuple(remarks))


def _check_size(matrix: Json, point: tuple[float, float], size: tuple[int, int]) -> list[str]:
    """Remark on a principal point far from the centre of the format.

    raises  InputError where it lies outside, or near the centre of the format with width and height exchanged
    """
    (x, y), (width, height) = point, size
    off = max(abs(x / width - 0.5), abs(y / height - 0.5))
    if off <= FAR:
        return []
    if max(abs(x / height - 0.5), abs(y / width - 0.5)) <= NEAR:
        matrix.fail("opencv.size_interchanged", x_px=x, y_px=y, width_px=width, height_px=height)
    same = abs(x / width - y / height) <= NEAR * (x / width + y / height)
    if off >= 0.5:
        matrix.fail("opencv.principal_point_outside", x_px=x, y_px=y, width_px=width, height_px=height)
    return [
        phrase(
            "calibration_remark.principal_point", x_px=x, y_px=y, width_px=width, height_px=height, another_size=same,
            other_width_px=round(2 * x), other_height_px=round(2 * y),
        )
    ]  # fmt: skip


def read(path: Path, size_px: tuple[int, int] | None) -> tuple[Calibration, ...]:
    """A calibration of `calibrateCamera`."""
    return _read(path, size_px, fisheye=False)


def read_fisheye(path: Path, size_px: tuple[int, int] | None) -> tuple[Calibration, ...]:
    """A calibration of `fisheye::calibrate`; a file that does not say so is believed."""
    return _read(path, size_px, fisheye=True)


def matrix_of(camera: ForwardCamera) -> list[float]:
    """The camera matrix (9) with OpenCV's pixel origin."""
    return [camera.fx, camera.skew, camera.cx - HALF, 0.0, camera.fy, camera.cy - HALF, 0.0, 0.0, 1.0]


def coefficients_of(camera: ForwardCamera, variant: str) -> list[float]:
    """The distortion coefficients of a variant: "fisheye", or the number of them."""
    names = FISHEYE if variant == "fisheye" else ORDER[: int(variant)]
    return [float(getattr(camera, n)) for n in names]


def write(conversions: Sequence[Conversion], suffix: str) -> str:
    """A file that OpenCV's FileStorage reads."""
    (conversion,) = conversions
    camera = conversion.calibration.camera
    assert isinstance(camera, ForwardCamera)
    coefficients = coefficients_of(camera, conversion.variant)
    matrices = (
        ("camera_matrix", 3, 3, matrix_of(camera)),
        ("distortion_coefficients", 1, len(coefficients), coefficients),
    )
    fisheye = conversion.variant == "fisheye"
    if suffix == ".json":
        values = {
            "image_width": camera.width_px,
            "image_height": camera.height_px,
            **({"fisheye_model": 1} if fisheye else {}),
            **{
                name: {"type_id": "opencv-matrix", "rows": rows, "cols": cols, "dt": "d", "data": data}
                for name, rows, cols, data in matrices
            },
        }
        return json.dumps(values, indent=1) + "\n"
    lines = ["%YAML:1.0", "---", f"image_width: {camera.width_px}", f"image_height: {camera.height_px}"]
    lines += ["fisheye_model: 1"] if fisheye else []
    for name, rows, cols, data in matrices:
        lines += [f"{name}: !!opencv-matrix", f"   rows: {rows}", f"   cols: {cols}", "   dt: d"]
        lines.append(f"   data: [ {', '.join(_yaml_number(v) for v in data)} ]")
    return "\n".join(lines) + "\n"


def _yaml_number(value: float) -> str:
    """A real number that YAML 1.0 does not take for a whole one or a text."""
    text = exact(value)
    return text if "." in text else text.replace("e", ".0e")


def _known(text: str, suffix: str, *, fisheye: bool) -> bool:
    if suffix not in {".yaml", ".yml", ".json"} or re.search(r"^\s*cam0\s*:", text, re.MULTILINE):
        return False
    if not any(_MATRIX_KEY.fullmatch(k) for k in re.findall(r"""(?:^|[\s{,"'])([A-Za-z]\w*)["']?\s*:""", text)):
        return False
    stated = rf"""{_FLAG}["']?\s*:\s*["']?(1|true|yes)\b|{_KIND}["']?\s*:\s*["']?({_FISHEYE_MODEL})\b"""
    return (re.search(stated, text, re.IGNORECASE) is not None) == fisheye


def _variant(count: int) -> Variant:
    return Variant(name=str(count), terms=("fx", "fy", "cx", "cy", *ORDER[:count]))


register(
    CalibrationFormat(
        name="opencv",
        title="OpenCV (YAML, JSON): 4, 5, 8, 12 or 14 coefficients; also ROS camera_info",
        suffixes=(".yaml", ".yml", ".json"),
        read=read,
        write=write,
        variants=tuple(_variant(n) for n in COUNTS),
        recognises=lambda text, suffix: _known(text, suffix, fisheye=False),
    )
)
register(
    CalibrationFormat(
        name="opencv-fisheye",
        title="OpenCV's fisheye (YAML, JSON): 4 coefficients",
        suffixes=(".yaml", ".yml", ".json"),
        read=read_fisheye,
        write=write,
        variants=(Variant(name="fisheye", terms=("fx", "fy", "cx", "cy", *FISHEYE), projection="equidistant"),),
        recognises=lambda text, suffix: _known(text, suffix, fisheye=True),
    )
)
