"""ISD JSON of the Community Sensor Model, as ALE writes and USGSCSM reads it: line scan, push-frame, frame, radar.

Line and sample 0.5 are the centre of the first pixel, as with us.  Positions and attitudes stand in an inertial
frame; the body's rotation brings them to the frame that turns with it.  Quaternions have the scalar first and
rotate inertial to detector and to body axes.  Distances are in kilometres where no unit stands (ALE writes none for
positions); a unit that stands there counts.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError, Message, note
from raybundle.io.reading.trees import Json, read_json
from raybundle.io.reading.words import quoted
from raybundle.io.scenes import rpc_json, rpc_keys
from raybundle.io.scenes.base import Scene, SceneFormat, register
from raybundle.io.scenes.csm_distortion import undistorted
from raybundle.io.scenes.csm_frames import PUSH_FRAME, frame_keys
from raybundle.io.scenes.csm_radar import radar_scene
from raybundle.io.scenes.csm_tables import body_trajectory
from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import Ellipsoid
from raybundle.scenes.linescan import LineScene
from raybundle.scenes.push_frame import PushFrame

METRES = {"m": 1.0, "km": 1000.0}
LOOK_NODES = 257
"""Elements at which a viewing direction is computed where the optics distort."""
PAUSE_LINES = 1.0
"""Time between two rows of the table of line times, beyond what their lines take, that counts as a contradiction: to
a line the writers round."""
FRAMES = (PUSH_FRAME, "USGS_ASTRO_FRAME_SENSOR_MODEL")
RADAR = "_SAR_"
"""Of other models, by the middle of their names"""
KEYS_SHOWN = 6
"""Of a JSON file that is something else, in the message."""


def read(path: Path) -> Scene:
    """The scene of an ISD; sensors of other models are refused."""
    root = read_json(path)
    _check_model(root)
    if RADAR in root.get("name_model").text():
        return radar_scene(root, path, _ellipsoid(root.get("radii")), _unit(root.get("instrument_position")))
    rows, columns = root.get("image_lines").whole(), root.get("image_samples").whole()
    ellipsoid = _ellipsoid(root.get("radii"))
    framed = root.get("name_model").text() in FRAMES
    own: dict[str, Any] = frame_keys(root, rows, columns, focal_plane) if framed else _lines(root, rows, columns)
    look = own["look"][0] if framed else own["detector_look"]
    across = float(np.linalg.norm(look[-1] - look[0])) / columns
    group = root.get("instrument_position")
    trajectory, remarks = body_trajectory(root, ellipsoid, _unit(group), across, rigid=framed)
    kind: type[PushFrame | LineScene] = PushFrame if framed else LineScene
    line = kind(
        width_px=columns, trajectory=trajectory, ellipsoid=ellipsoid, aberration=False, refraction=False,
        epoch_s=root.optional("center_ephemeris_time", 0.0), **own,
    )  # fmt: skip
    remarks = [note("isd.no_aberration"), *remarks]
    if not group.has("unit"):
        far = float(np.linalg.norm(trajectory.positions, axis=1).min())
        remarks.append(note("isd.kilometres_assumed", distance_km=far / 1000, radius_km=ellipsoid.a / 1000))
    P, d = line.rays(np.array([[columns / 2, rows / 2]]))
    if P[0] @ d[0] > 0:
        line = _turned(line)
        remarks.append(note("isd.detector_turned"))
    remarks += _reversals(line) if isinstance(line, LineScene) else []
    return Scene(
        file=path,
        format="csm",
        rigorous=line,
        width_px=columns,
        height_px=line.height_px,
        sensor=root.get("name_sensor").text() if root.has("name_sensor") else "",
        remarks=tuple(remarks),
    )


def _check_model(root: Json) -> None:
    """Raise where the file is no ISD, or one of another sensor, or of an image that is a map."""
    if not root.has("name_model"):
        keys = list(root.mapping()) if isinstance(root.value, dict) else []
        root.fail("isd.no_model", n=len(keys), names=keys[:KEYS_SHOWN])
    model = root.get("name_model").text()
    if "LINE_SCANNER" not in model and RADAR not in model and model not in FRAMES:
        root.get("name_model").fail("isd.model_unknown", model=quoted(model))
    if root.has("projection"):
        root.get("projection").fail("isd.map_projected")


def _reversals(line: LineScene) -> list[Message]:
    """A remark where the scan comes back over ground that it has seen."""
    at = line.reversals()
    return [note("isd.scan_reverses", lines=[round(float(y)) for y in at])] if at.size else []


def _turned(line: LineScene | PushFrame) -> LineScene | PushFrame:
    """The same lines of sight, followed in the opposite direction: the detector turned by half a turn about x."""
    path = line.trajectory
    x, y, z, w = (path.quaternions / np.linalg.norm(path.quaternions, axis=1)[:, None]).T
    turned = replace(path, quaternions=np.stack([w, z, -y, -x], axis=1))
    if isinstance(line, PushFrame):
        return replace(line, trajectory=turned, look=line.look * [-1, 1])
    return replace(line, trajectory=turned, detector_look=line.detector_look * [-1, 1])


def _unit(group: Json) -> float:
    if not group.has("unit"):
        return METRES["km"]
    unit = group.get("unit").text().lower()
    if unit not in METRES:
        group.get("unit").fail("value.unit_unknown", unit=quoted(unit), known=list(METRES))
    return METRES[unit]


def _ellipsoid(radii: Json) -> Ellipsoid:
    unit = _unit(radii)
    a, b = (radii.get(k).number() * unit for k in ("semimajor", "semiminor"))
    try:
        return Ellipsoid(a, b)
    except InputError as error:
        raise error.at(radii.file, column=radii.at or None) from None


def _line_times(root: Json, rows: int) -> tuple[Array, Array]:
    """Lines y [px] and their times [s after the centre]; line 0.5 is the first in the file's table.

    Times may fall: an image of which the last line was taken first.
    """
    place = root.get("line_scan_rate")
    table = np.array([r.numbers(3) for r in place.items()]).reshape(-1, 3)
    steps = table[:, 2]
    if len(table) == 0 or not ((steps > 0).all() or (steps < 0).all()) or (np.diff(table[:, 0]) <= 0).any():
        place.fail("isd.line_times")
    y = table[:, 0] - 0.5
    pause = (np.diff(table[:, 1]) - steps[:-1] * np.diff(y)) / steps[:-1]
    if (np.abs(pause) > PAUSE_LINES).any():
        k = int(np.argmax(np.abs(pause)))
        place.fail(
            "isd.line_times_contradict",
            line_number=table[k + 1, 0],
            time_s=table[k + 1, 1],
            off_lines=pause[k],
            before_s=table[k, 1],
            step_s=steps[k],
        )
    end = max(float(rows), y[-1] + 1)
    return np.append(y, end), np.append(table[:, 1], table[-1, 1] + steps[-1] * (end - y[-1]))


def _lines(root: Json, rows: int, columns: int) -> dict[str, Any]:
    """What a line scanner has beside others: the times of its lines and the viewing directions of its elements."""
    y, times = _line_times(root, rows)
    x = np.linspace(0, columns, LOOK_NODES if root.has("optical_distortion") else 2)
    look = focal_plane(root, x, np.zeros(len(x)))
    return {"height_px": rows, "line_y": y, "line_times": times, "detector_x": x, "detector_look": look}


def focal_plane(root: Json, x: Array, lines: Array) -> Array:
    """Viewing directions (n, 2) at samples x and lines (n,) [px]: undistorted coordinates over the camera constant."""
    summing = [root.get(f"detector_{k}_summing").positive() for k in ("line", "sample")]
    start = [root.get(f"starting_detector_{k}").number() for k in ("line", "sample")]
    centre = [root.get("detector_center").get(k).number() for k in ("line", "sample")]
    to_pixel = np.stack([root.get(f"focal2pixel_{k}").numbers(3) for k in ("lines", "samples")])
    if abs(np.linalg.det(to_pixel[:, 1:])) < 1e-12:
        root.get("focal2pixel_lines").fail("isd.focal_plane")
    f = root.get("focal_length_model").get("focal_length").positive()
    pixels = np.stack([lines * summing[0] + start[0], x * summing[1] + start[1]]) - np.array(centre)[:, None]
    plane = np.linalg.solve(to_pixel[:, 1:], pixels - to_pixel[:, :1])
    if root.has("optical_distortion"):
        plane = undistorted(root.get("optical_distortion"), plane, f)
    return (plane / f).T


def _recognises(path: Path, head: bytes) -> bool:
    return (
        head.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{")
        and (b"name_model" in head or path.suffix.lower() in {".json", ".isd"})
        and not rpc_json.recognises(path, head)
        and not rpc_keys.is_json(path, head)
    )


register(SceneFormat(name="csm", title="Community Sensor Model ISD (JSON)", recognises=_recognises, read=read))
