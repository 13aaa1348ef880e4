"""Line-scan ISD JSON of the Community Sensor Model, as ALE writes and USGSCSM reads it.

Line and sample 0.5 are the centre of the first pixel, as with us.  Positions and attitudes stand in an inertial
frame; the body's rotation brings them to the frame that turns with it.  Quaternions have the scalar first and
rotate inertial to detector and to body axes.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.io.reading.trees import Json, read_json
from raybundle.io.scenes.base import Scene, SceneFormat, register
from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import Ellipsoid
from raybundle.scenes.linescan import LineScene
from raybundle.scenes.trajectory import Trajectory, rotation_from_quaternion

METRES = {"m": 1.0, "km": 1000.0}
NODES = 25
"""Positions to which USGSCSM interpolates shorter tables."""
LOOK_NODES = 257
"""Elements at which a viewing direction is computed where the optics distort."""


def read(path: Path) -> Scene:
    """The scene of a line-scan ISD; other sensors are refused."""
    root = read_json(path)
    model = root.get("name_model").text()
    if "LINE_SCANNER" not in model:
        root.get("name_model").fail(f"{model}: only line scanners (..._LINE_SCANNER_SENSOR_MODEL) are read")
    rows, columns = root.get("image_lines").whole(), root.get("image_samples").whole()
    ellipsoid = _ellipsoid(root.get("radii"))
    line_y, line_times = _line_times(root, rows)
    x, look = _detector(root, columns)
    line = LineScene(
        width_px=columns,
        height_px=rows,
        line_y=line_y,
        line_times=line_times,
        detector_x=x,
        detector_look=look,
        trajectory=_trajectory(root, ellipsoid),
        ellipsoid=ellipsoid,
        aberration=False,
        refraction=False,
    )
    remarks = ["CSM: neither aberration nor refraction is applied, as in USGSCSM"]
    P, d = line.rays(np.array([[columns / 2, rows / 2]]))
    if P[0] @ d[0] > 0:
        line = _turned(line)
        remarks.append(
            "the detector's third axis points away from the body; it looks along the other way, as in USGSCSM"
        )
    return Scene(
        file=path,
        format="csm",
        line=line,
        width_px=columns,
        height_px=rows,
        sensor=root.get("name_sensor").text() if root.has("name_sensor") else "",
        remarks=tuple(remarks),
    )


def _turned(line: LineScene) -> LineScene:
    """The same lines of sight, followed in the opposite direction: the detector turned by half a turn about x."""
    path = line.trajectory
    x, y, z, w = (path.quaternions / np.linalg.norm(path.quaternions, axis=1)[:, None]).T
    turned = replace(path, quaternions=np.stack([w, z, -y, -x], axis=1))
    return replace(line, trajectory=turned, detector_look=line.detector_look * [-1, 1])


def _unit(group: Json) -> float:
    unit = group.get("unit").text().lower()
    if unit not in METRES:
        group.get("unit").fail(f"unit {unit!r} is not m or km")
    return METRES[unit]


def _ellipsoid(radii: Json) -> Ellipsoid:
    unit = _unit(radii)
    a, b = (radii.get(k).number() * unit for k in ("semimajor", "semiminor"))
    try:
        return Ellipsoid(a, b)
    except InputError as error:
        radii.fail(str(error))


def _line_times(root: Json, rows: int) -> tuple[Array, Array]:
    """Lines y [px] and their times [s after the centre]; line 0.5 is the first in the file's table."""
    table = np.array([r.numbers(3) for r in root.get("line_scan_rate").items()]).reshape(-1, 3)
    if len(table) == 0 or (table[:, 2] <= 0).any() or (np.diff(table[:, 0]) <= 0).any():
        root.get("line_scan_rate").fail("lines must increase and each needs a positive time per line")
    y = table[:, 0] - 0.5
    end = max(float(rows), y[-1] + 1)
    return np.append(y, end), np.append(table[:, 1], table[-1, 1] + table[-1, 2] * (end - y[-1]))


def _detector(root: Json, columns: int) -> tuple[Array, Array]:
    """Elements [px] and their viewing directions: focal plane coordinates [mm] over the camera constant [mm]."""
    summing = [root.optional(f"detector_{k}_summing", 1.0) for k in ("line", "sample")]
    if any(s <= 0 for s in summing):
        root.fail(f"detector summing {summing} must be positive")
    start = [root.optional(f"starting_detector_{k}") for k in ("line", "sample")]
    centre = [root.get("detector_center").get(k).number() for k in ("line", "sample")]
    to_pixel = np.stack([root.get(f"focal2pixel_{k}").numbers(3) for k in ("lines", "samples")])
    if abs(np.linalg.det(to_pixel[:, 1:])) < 1e-12:
        root.get("focal2pixel_lines").fail("the map from focal plane to pixels cannot be inverted")
    coefficients = _radial(root)
    x = np.linspace(0, columns, LOOK_NODES if coefficients.any() else 2)
    pixels = np.stack([np.full(len(x), start[0]), x * summing[1] + start[1]]) - np.array(centre)[:, None]
    plane = np.linalg.solve(to_pixel[:, 1:], pixels - to_pixel[:, :1])
    r2 = np.sum(plane**2, axis=0)
    plane = plane * (1 - (coefficients[0] + r2 * (coefficients[1] + r2 * coefficients[2])))
    f = root.get("focal_length_model").get("focal_length").number()
    if f == 0:
        root.get("focal_length_model").fail("the focal length is zero")
    return x, (plane / f).T


def _radial(root: Json) -> Array:
    """The three radial coefficients; other kinds of distortion are refused unless all their terms are zero."""
    if not root.has("optical_distortion"):
        return np.zeros(3)
    kinds = root.get("optical_distortion").mapping()
    for name, kind in kinds.items():
        parts = [kind.get(part).items() for part in ("coefficients", "x", "y") if kind.has(part)]
        values = np.array([v.number() for part in parts for v in part])
        if name == "radial":
            return np.append(values, np.zeros(3))[:3]
        if values.any():
            kind.fail(f"optical distortion of the kind {name!r} is not known; known: radial")
    return np.zeros(3)


def _times(root: Json, group: Json, name: str, count: int) -> Array:
    """Seconds after the centre of the image of a table's entries."""
    if group.has("ephemeris_times"):
        times = group.get("ephemeris_times").items()
        if len(times) != count:
            group.get("ephemeris_times").fail(f"{len(times)} times for {count} entries of the table")
        return np.array([t.number() for t in times]) - root.get("center_ephemeris_time").number()
    return root.get(f"t0_{name}").number() + root.get(f"dt_{name}").number() * np.arange(count)


def _rotations(root: Json, key: str) -> tuple[Array, Array]:
    """Times (n,) and rotations (n, 3, 3) from inertial axes to those of the detector or the body."""
    group = root.get(key)
    q = np.array([r.numbers(4) for r in group.get("quaternions").items()]).reshape(-1, 4)
    if len(q) == 0 or (np.linalg.norm(q, axis=1) < 1e-6).any():
        group.get("quaternions").fail("a quaternion of length zero, or none")
    R = rotation_from_quaternion(q[:, [1, 2, 3, 0]])
    if group.has("constant_rotation"):
        R = group.get("constant_rotation").numbers(9).reshape(3, 3) @ R
    return _times(root, group, "quaternion", len(q)), R


def _trajectory(root: Json, ellipsoid: Ellipsoid) -> Trajectory:
    group = root.get("instrument_position")
    positions = np.array([r.numbers(3) for r in group.get("positions").items()]).reshape(-1, 3) * _unit(group)
    radius = np.linalg.norm(positions, axis=1)
    if len(radius) == 0 or radius.min() <= ellipsoid.b:
        group.fail(
            f"a position is {radius.min(initial=0):.6g} m from the centre of a body of radius {ellipsoid.a:.6g} m; the "
            "units of positions and radii do not agree"
        )
    position_times, positions = _equal_steps(group, _times(root, group, "ephemeris", len(positions)), positions)
    body_times, body = _rotations(root, "body_rotation")
    pointing_times, pointing = _rotations(root, "instrument_pointing")
    at_positions, at_pointing = (_interpolated(body_times, body, t) for t in (position_times, pointing_times))
    return Trajectory(
        position_times=position_times,
        positions=np.einsum("nij,nj->ni", at_positions, positions),
        attitude_times=pointing_times,
        quaternions=_quaternion(at_pointing @ np.swapaxes(pointing, 1, 2)),
    )


def _equal_steps(group: Json, times: Array, positions: Array) -> tuple[Array, Array]:
    """The positions at 25 or more equal steps, by Hermite cubics where the table has velocities.

    USGSCSM does so; where velocities contradict the positions, as in some synthetic files, this is felt.
    """
    if not group.has("velocities") or len(times) < 2 or (np.diff(times) <= 0).any():
        return times, positions
    from scipy.interpolate import CubicHermiteSpline  # noqa: PLC0415  (SciPy only where such a file is read)

    velocities = np.array([r.numbers(3) for r in group.get("velocities").items()]).reshape(-1, 3) * _unit(group)
    if len(velocities) != len(times):
        group.get("velocities").fail(f"{len(velocities)} velocities for {len(times)} positions")
    at = np.linspace(times[0], times[-1], max(NODES, len(times)))
    return at, CubicHermiteSpline(times, positions, velocities)(at)


def _quaternion(R: Array) -> Array:
    from scipy.spatial.transform import Rotation  # noqa: PLC0415  (SciPy only where such a file is read)

    return Rotation.from_matrix(R).as_quat()


def _interpolated(times: Array, R: Array, at: Array) -> Array:
    """Rotations (n, 3, 3) at other times; those of one entry hold for all."""
    if len(times) == len(at) and np.array_equal(times, at):
        return R
    if len(times) == 1:
        return np.broadcast_to(R[0], (len(at), 3, 3))
    nowhere = np.zeros((len(times), 3))
    path = Trajectory(position_times=times, positions=nowhere, attitude_times=times, quaternions=_quaternion(R))
    return path.rotation(at)[0]


def _recognises(path: Path, head: bytes) -> bool:
    return head.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{") and (
        b"name_model" in head or path.suffix.lower() in {".json", ".isd"}
    )


register(
    SceneFormat(name="csm", title="Community Sensor Model line-scan ISD (JSON)", recognises=_recognises, read=read)
)
