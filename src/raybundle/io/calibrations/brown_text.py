"""Calibration reports of Australis and PhotoModeler: Brown's terms in mm at the measured point, our own direction.

Australis: x right, y up from the centre of the format, K1-K3, P1, P2, and the affine terms B1, B2 on x (our A, S).
PhotoModeler: Xp, Yp from the upper left corner of a format Fw x Fh, y down; no affinity, which Fw / Fh takes up.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from raybundle.block import Camera
from raybundle.errors import InputError, phrase
from raybundle.io.calibrations.base import Calibration, CalibrationFormat, Conversion, register
from raybundle.io.digits import exact
from raybundle.io.reading.files import read_text
from raybundle.io.reading.ledger import enter
from raybundle.io.reading.words import fortran_of, no_number, quoted, whole_of
from raybundle.sensors import sensor_models

AUSTRALIS = {
    "C": "c", "XP": "x0", "YP": "y0", "K1": "K1", "K2": "K2", "K3": "K3", "P1": "P1", "P2": "P2", "B1": "A", "B2": "S",
}  # fmt: skip
PHOTOMODELER = {
    "Focal Length": "c", "Xp": "x0", "Yp": "y0", "Fw": "width", "Fh": "height", "K1": "K1", "K2": "K2", "K3": "K3",
    "P1": "P1", "P2": "P2",
}  # fmt: skip
LARGEST_PX = 10_000_000
NUMBER = r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eEdD][-+]?[0-9]+)?"
FINAL, FINAL_STD, COLUMNS = 2, 4, 5
_ROW = re.compile(rf"^\s*({'|'.join(AUSTRALIS)})\s+({NUMBER}(?:\s+{NUMBER})*)\s*(?:\(mm\))?\s*$")
_OTHER_ROW = re.compile(rf"^\s*([A-Z]{{1,2}}[0-9]{{0,2}})\s+{NUMBER}(?:\s+{NUMBER})*\s*(?:\(\w+\))?\s*$")
_SENSOR = re.compile(rf"^\s*([HV])\s+(\d+)\s+({NUMBER})\s*$")
_NAMED = re.compile(rf"^\s*({'|'.join(PHOTOMODELER)})\b(?![\s\w]*Deviation)")
_VALUE = re.compile(rf"^\s*(Value|Deviation)\s*:\s*(?:[\w ]+:\s*)?({NUMBER})")
_IMAGE = re.compile(r"^\s*Image Size\s*:\s*(\d+)\s*x\s*(\d+)", re.IGNORECASE)


def _number(text: str, path: Path, line: int) -> float:
    value = fortran_of(text)
    if value is None:
        raise InputError(no_number(text), file=path, line=line)
    return value


def _pixels(text: str, path: Path, line: int) -> int:
    value = whole_of(text)
    if value is None or not 0 < value <= LARGEST_PX:
        raise InputError("value.not_whole", value=quoted(text), least=1, most=LARGEST_PX, file=path, line=line)
    return value


def read_australis(path: Path, size_px: tuple[int, int] | None) -> tuple[Calibration, ...]:
    """The first camera of a report "Camera Parameters": final values and their standard deviations."""
    del size_px
    sensor: dict[str, tuple[int, float]] = {}
    final: dict[str, float] = {}
    std: dict[str, float] = {}
    for line, text in enumerate(read_text(path).split("\n"), 1):
        if (size := _SENSOR.match(text)) and size[1] not in sensor:
            sensor[size[1]] = (_pixels(size[2], path, line), _number(size[3], path, line))
        elif row := _ROW.match(text):
            symbol = AUSTRALIS[row[1]]
            if symbol in final:
                raise InputError("calibration.second_camera", file=path, line=line)
            columns = [_number(w, path, line) for w in row[2].split()]
            if len(columns) not in {1, COLUMNS}:
                raise InputError(
                    "calibration.australis_row",
                    parameter=row[1],
                    n=len(columns),
                    needed=COLUMNS,
                    file=path,
                    line=line,
                )
            final[symbol] = columns[FINAL] if len(columns) == COLUMNS else columns[0]
            if len(columns) == COLUMNS and columns[FINAL_STD] > 0:
                std[symbol] = columns[FINAL_STD]
        elif other := _OTHER_ROW.match(text):
            enter(other[1])
    missing = [k for k, s in AUSTRALIS.items() if s not in final and s not in {"A", "S"}]
    if missing or len(sensor) != len("HV"):
        raise InputError("calibration.incomplete", missing=missing or ["H", "V"], file=path)
    (width, pixel_x), (height, pixel_y) = sensor["H"], sensor["V"]
    camera = _camera(path, path.stem, (width, height), (pixel_x, pixel_y), final)
    free = tuple(s for s in sensor_models["brown"].symbols if s in std)
    remarks = (phrase("calibration_remark.file_without_correlations"),) if free else ()
    covariance = np.diag([std[s] ** 2 for s in free]) if free else None
    return (
        Calibration(
            id=path.stem,
            camera=camera,
            pixel_mm=camera.pixel_mm,
            free=free,
            covariance=covariance,
            remarks=remarks,
        ),
    )


def _camera(
    path: Path, id_: str, size: tuple[int, int], pixel: tuple[float, float], values: dict[str, float]
) -> Camera:
    if not all(0 < s <= LARGEST_PX for s in size) or not all(0 < p < 1 for p in pixel) or not values["c"] > 0:
        raise InputError(
            "calibration.impossible_values",
            width_px=size[0],
            height_px=size[1],
            pixel_mm=list(pixel),
            c_mm=values["c"],
            file=path,
        )
    symbols = sensor_models["brown"].symbols
    return Camera(
        id=id_,
        model="brown",
        width_px=size[0],
        height_px=size[1],
        pixel_mm=pixel,
        values={s: float(values.get(s, 0.0)) for s in symbols},
    )


def write_australis(conversions: Sequence[Conversion], suffix: str) -> str:
    """A report that `read_australis` reads; standard deviations where they are known, else 0."""
    del suffix
    (conversion,) = conversions
    calibration = conversion.calibration
    camera = calibration.camera
    assert isinstance(camera, Camera)
    std: dict[str, float] = {}
    if calibration.covariance is not None:
        std = dict(zip(calibration.free, np.sqrt(np.diag(calibration.covariance)).tolist(), strict=True))
    lines = ["Australis Bundle Adjustment Results: Camera Parameters", "", f"Results for Camera 1    {calibration.id}"]
    lines += ["", "Sensor Size        Pixel Size (mm)"]
    lines += [f"  H   {camera.width_px}   {exact(camera.pixel_mm[0])}"]
    lines += [f"  V   {camera.height_px}   {exact(camera.pixel_mm[1])}", ""]
    lines += ["  Camera    Initial      Total          Final        Initial         Final"]
    lines += [" Variable    Value     Adjustment       Value       Std. Error     Std. Error", ""]
    for name, symbol in AUSTRALIS.items():
        value = exact(camera.values.get(symbol, 0.0))
        unit = " (mm)" if name in {"C", "XP", "YP"} else ""
        lines.append(f"   {name:<3} {value}   0.0   {value}   1.0e+003   {exact(std.get(symbol, 0.0))}{unit}")
    return "\n".join(lines) + "\n"


def read_photomodeler(path: Path, size_px: tuple[int, int] | None) -> tuple[Calibration, ...]:
    """The camera of a calibration report; its format in pixels is given where the report does not hold it."""
    values: dict[str, float] = {}
    std: dict[str, float] = {}
    name = heading = ""
    for line, text in enumerate(read_text(path).split("\n"), 1):
        if image := _IMAGE.match(text):
            size_px = (_pixels(image[1], path, line), _pixels(image[2], path, line))
        elif entry := _VALUE.match(text):
            where = values if entry[1] == "Value" else std
            if name and name not in where:
                where[name] = _number(entry[2], path, line)
            elif not name and heading and entry[1] == "Value":
                enter(heading)
        elif named := _NAMED.match(text):
            name = PHOTOMODELER[named[1]]
        elif text.strip():
            name, heading = "", text.strip()
    missing = [k for k, s in PHOTOMODELER.items() if s not in values and s not in {"K2", "K3", "P1", "P2"}]
    if missing:
        raise InputError("calibration.incomplete", missing=missing, file=path)
    if size_px is None:
        raise InputError("calibration.no_size", file=path)
    fw, fh = values["width"], values["height"]
    values["x0"] -= fw / 2
    values["y0"] = fh / 2 - values["y0"]
    camera = _camera(path, path.stem, size_px, (fw / size_px[0], fh / size_px[1]), values)
    ratio = camera.pixel_mm[0] / camera.pixel_mm[1]
    if abs(ratio - 1) > 0.1:
        raise InputError(
            "calibration.pixels_not_square",
            width_mm=fw,
            height_mm=fh,
            width_px=size_px[0],
            height_px=size_px[1],
            ratio=ratio,
            file=path,
        )
    free = tuple(s for s in sensor_models["brown"].symbols if std.get(s, 0) > 0)
    return (
        Calibration(
            id=path.stem,
            camera=camera,
            pixel_mm=camera.pixel_mm,
            free=free,
            covariance=np.diag([std[s] ** 2 for s in free]) if free else None,
            remarks=(phrase("calibration_remark.file_without_correlations"),) if free else (),
        ),
    )


def write_photomodeler(conversions: Sequence[Conversion], suffix: str) -> str:
    """A calibration report that `read_photomodeler` reads, with the format in pixels added."""
    del suffix
    (conversion,) = conversions
    calibration = conversion.calibration
    camera = calibration.camera
    assert isinstance(camera, Camera)
    fw, fh = camera.size_mm.tolist()
    values = dict(camera.values) | {"width": fw, "height": fh}
    values["x0"], values["y0"] = values["x0"] + fw / 2, fh / 2 - values["y0"]
    std: dict[str, float] = {}
    if calibration.covariance is not None:
        std = dict(zip(calibration.free, np.sqrt(np.diag(calibration.covariance)).tolist(), strict=True))
    lines = [f"Camera: {calibration.id}", f"Image Size: {camera.width_px} x {camera.height_px}"]
    for name, symbol in PHOTOMODELER.items():
        unit = " mm" if symbol in {"c", "x0", "y0", "width", "height"} else ""
        lines += [f"    {name}", f"        Value: {exact(values.get(symbol, 0.0))}{unit}"]
        if symbol in std:
            lines.append(f"        Deviation: {exact(std[symbol])}{unit}")
    return "\n".join(lines) + "\n"


register(
    CalibrationFormat(
        name="australis",
        title="Australis camera parameters (text), mm, at the measured point",
        suffixes=(".txt",),
        read=read_australis,
        write=write_australis,
        model="measured",
        keeps="standard deviations",
        recognises=lambda text, suffix: suffix == ".txt" and bool(re.search(r"^\s*XP\s+[-+\d.]", text, re.MULTILINE)),
    )
)
register(
    CalibrationFormat(
        name="photomodeler",
        title="PhotoModeler calibration report (text), mm, at the measured point",
        suffixes=(".txt",),
        read=read_photomodeler,
        write=write_photomodeler,
        model="photomodeler",
        keeps="standard deviations",
        recognises=lambda text, suffix: (
            suffix == ".txt" and bool(re.search(r"^\s*Fw\b", text, re.MULTILINE)) and "Value:" in text
        ),
    )
)
