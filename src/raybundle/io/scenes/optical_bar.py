"""Camera files of optical bars (KH-4B, KH-9) as the Ames Stereo Pipeline writes them: `.tsai`, OPTICAL_BAR.

The camera stands at iC when the sweep begins and moves along y of the untilted camera with `speed`; iR turns the axes
of the camera to those of the earth (x along the sweep, y along the flight, z down) and stays as it is.  Pixels count
from the centre of the first one, lengths are in metres.  Refraction is applied, aberration is not.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import NoReturn

import numpy as np

from raybundle.errors import InputError, note
from raybundle.io.reading.files import read_text
from raybundle.io.reading.words import numbers_of, quoted
from raybundle.io.scenes.base import Scene, SceneFormat, register
from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import WGS84, Ellipsoid
from raybundle.scenes.optical_bar import OpticalBar
from raybundle.scenes.trajectory import Trajectory

MARK = "OPTICAL_BAR"
COUNTS: Mapping[str, int] = {
    "image_size": 2, "image_center": 2, "pitch": 1, "f": 1, "scan_time": 1, "forward_tilt": 1, "iC": 3, "iR": 9,
    "speed": 1, "mean_earth_radius": 1, "mean_surface_elevation": 1, "motion_compensation_factor": 1,
}  # fmt: skip
POSITIVE = ("image_size", "pitch", "f", "scan_time", "speed", "mean_earth_radius")
MARGIN_S = 2.0
"""From the sweep to the first and the last entry of the table of its path."""
EARTH = 0.01
"""Share by which the radius of the earth in a file may differ from that of the ellipsoid."""
ROUNDED = 1e-6
"""Of a rotation matrix in a file."""


def read(path: Path) -> Scene:
    """The scene; raises InputError with file, line and key."""
    keys, scan_dir = _keys(path)
    width, height = (int(v) for v in keys["image_size"])
    pitch, f, time, speed = (float(keys[k][0]) for k in ("pitch", "f", "scan_time", "speed"))
    R = keys["iR"].reshape(3, 3)
    if np.abs(R @ R.T - np.eye(3)).max() > ROUNDED or np.linalg.det(R) < 0 or width < 2:
        raise InputError("optical_bar.rotation", deviation=float(np.abs(R @ R.T - np.eye(3)).max()), file=path)
    tilt = float(keys["forward_tilt"][0])
    velocity = speed * R @ np.array([0.0, np.cos(tilt), np.sin(tilt)])
    times = np.array([-MARGIN_S, 0.0, time, time + MARGIN_S])
    leftwards = scan_dir == "left"
    column_s = time / (width - 1) * (-1 if leftwards else 1)
    radius = float(keys["mean_earth_radius"][0])
    rate = (width - 1) * pitch / f / time
    from scipy.spatial.transform import Rotation

    scene = OpticalBar(
        width_px=width, height_px=height, aberration=False,
        ellipsoid=WGS84 if abs(radius / WGS84.a - 1) < EARTH else Ellipsoid(radius, radius),
        trajectory=Trajectory(
            position_times=times, positions=keys["iC"] + times[:, None] * velocity, attitude_times=times,
            quaternions=np.repeat(Rotation.from_matrix(R).as_quat()[None], len(times), axis=0),
        ),
        first_s=(width - 0.5) / (width - 1) * time if leftwards else -0.5 * column_s, column_s=column_s,
        centre_px=keys["image_center"] + 0.5, angle_px=pitch / f,
        motion=float(keys["motion_compensation_factor"][0]) * speed / rate * (-1 if leftwards else 1),
        ground_radius_m=radius + float(keys["mean_surface_elevation"][0]),
    )  # fmt: skip
    return Scene(
        file=path, format="optical_bar", rigorous=scene, width_px=width, height_px=height, sensor="optical bar",
        remarks=(note("optical_bar.corrections"),),
    )  # fmt: skip


def _keys(path: Path) -> tuple[dict[str, Array], str]:
    """Numbers by key, and the direction of the sweep."""
    found, direction = dict[str, Array](), "right"
    for number, line in enumerate(read_text(path).splitlines(), 1):
        key, equal, value = (part.strip() for part in line.partition("="))
        if not equal:
            continue
        if key == "scan_dir":
            direction = value
            if value not in {"left", "right"}:
                _fail(path, number, key, "value.not_supported", value=quoted(value), known=["left", "right"])
        elif key in COUNTS:
            read = numbers_of(value.split())
            if read is None:
                _fail(path, number, key, "value.not_a_number", value=quoted(value))
            found[key] = read
            if len(found[key]) != COUNTS[key] or not np.isfinite(found[key]).all():
                _fail(path, number, key, "value.count", n=len(found[key]), needed=COUNTS[key])
            if key in POSITIVE and (found[key] <= 0).any():
                _fail(path, number, key, "value.not_above", value=float(found[key].min()), limit=0.0)
    missing = [k for k in COUNTS if k not in found]
    if missing:
        raise InputError("value.key_missing", name=quoted(missing[0]), file=path)
    return found, direction


def _fail(path: Path, line: int, key: str, code: str, **values: object) -> NoReturn:
    raise InputError(code, file=path, line=line, column=key, **values)  # type: ignore[arg-type]


def _recognises(path: Path, head: bytes) -> bool:
    del path
    return MARK.encode() in head[:200]


register(SceneFormat(name="optical_bar", title="OPTICAL_BAR (.tsai, ASP)", recognises=_recognises, read=read))
