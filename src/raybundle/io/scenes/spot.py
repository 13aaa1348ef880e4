"""DIMAP 1 XML of SPOT 5 level 1A (METADATA.DIM): orbit, attitude and viewing directions, the rigorous model.

The local orbital frame has Z from the earth's centre, X = V x Z, Y = Z x X.  A detector looks along
(-tan psi_Y, tan psi_X, -1), turned by yaw, roll and pitch into that frame (SPOT 123-4-5 Geometry Handbook, 2004).
Rows and columns count from 1.  Aberration and refraction are left out: the vendor's calibration contains their mean.
"""

from __future__ import annotations

from datetime import datetime
from pathlib import Path

import numpy as np

from raybundle.errors import Message, note
from raybundle.io.reading.words import quoted
from raybundle.io.reading.xml import Element, read_xml
from raybundle.io.scenes.base import Scene, SceneFormat, element_text, register
from raybundle.numerics.arrays import Array
from raybundle.scenes.linescan import LineScene
from raybundle.scenes.scan import EPOCH
from raybundle.scenes.trajectory import Trajectory, lagrange

ORBIT_M = (6.5e6, 5.0e7)
"""Geocentric distances that an orbit can have."""


def read(path: Path) -> Scene:
    """The scene of a SPOT 5 file; raises InputError where a table is cut off or its units are wrong."""
    root = read_xml(path, "Dimap_Document")
    size = root.get("Raster_Dimensions")
    columns, rows = (int(size.number(k)) for k in ("NCOLS", "NROWS"))
    strip = root.get("Data_Strip")
    stamp = strip.get("Sensor_Configuration", "Time_Stamp")
    centre = _time(stamp.get("SCENE_CENTER_TIME"))
    psi, remarks = _look(strip.get("Sensor_Configuration", "Instrument_Look_Angles_List"), columns)
    line = LineScene(
        epoch_s=(centre - EPOCH).total_seconds(),
        width_px=columns,
        height_px=rows,
        line_y=np.array([0.5, rows - 0.5]),
        line_times=(np.array([1.0, rows]) - stamp.number("SCENE_CENTER_LINE")) * stamp.number("LINE_PERIOD"),
        detector_x=np.arange(len(psi)) + 0.5,
        # seen from a frame turned by half a turn about its first axis, so that the third points to the ground
        detector_look=np.stack([-np.tan(psi[:, 1]), -np.tan(psi[:, 0])], axis=1),
        trajectory=_trajectory(strip, centre),
        aberration=False,
        refraction=False,
    )
    source = root.find("Dataset_Sources", "Source_Information", "Scene_Source")
    names = () if source is None else (element_text(source, k) for k in ("MISSION", "MISSION_INDEX", "INSTRUMENT"))
    return Scene(
        file=path,
        format="spot",
        rigorous=line,
        width_px=columns,
        height_px=rows,
        sensor=" ".join(n for n in names if n),
        time=element_text(stamp, "SCENE_CENTER_TIME"),
        remarks=remarks,
    )


def _time(element: Element) -> datetime:
    try:
        return datetime.fromisoformat(element.content.strip()).replace(tzinfo=None)
    except ValueError:
        element.fail("value.no_time", value=quoted(element.content.strip()))


def _vector(element: Element) -> Array:
    return np.array([element.number(k) for k in "XYZ"])


def _look(group: Element, columns: int) -> tuple[Array, tuple[Message, ...]]:
    """psi_X, psi_Y [rad] (m, 2) of the detectors 1, 2, ... of the first band."""
    bands = list(group.all("Instrument_Look_Angles"))
    if not bands:
        group.fail("scene.no_look_angles", element="Instrument_Look_Angles")
    entries = list(bands[0].get("Look_Angles_List").all("Look_Angles"))
    if len(entries) < columns:
        bands[0].fail("scene.look_angle_count", n=len(entries), columns=columns)
    wrong = next((e for k, e in enumerate(entries, 1) if e.number("DETECTOR_ID") != k), None)
    if wrong is not None:
        wrong.fail("scene.detector_order", number=wrong.number("DETECTOR_ID"))
    psi = np.array([[e.number("PSI_X"), e.number("PSI_Y")] for e in entries])
    return psi, () if len(bands) == 1 else (note("scene.one_band", n=len(bands), band="1"),)


def _trajectory(strip: Element, centre: datetime) -> Trajectory:
    points = list(strip.get("Ephemeris", "Points").all("Point"))
    if len(points) < 4:
        strip.get("Ephemeris", "Points").fail("scene.position_count", n=len(points), least=4)
    times = np.array([(_time(p.get("TIME")) - centre).total_seconds() for p in points])
    P, V = (np.array([_vector(p.get(k)) for p in points]) for k in ("Location", "Velocity"))
    radius = np.linalg.norm(P, axis=1)
    if radius.min() < ORBIT_M[0] or radius.max() > ORBIT_M[1]:
        strip.get("Ephemeris").fail(
            "scene.not_an_orbit",
            distance_m=radius.min() if radius.min() < ORBIT_M[0] else radius.max(),
            least_m=ORBIT_M[0],
            most_m=ORBIT_M[1],
        )
    angles = list(strip.get("Satellite_Attitudes", "Corrected_Attitudes", "Corrected_Attitude").all("Angles"))
    if len(angles) < 4:
        strip.get("Satellite_Attitudes").fail("scene.attitude_count", n=len(angles), least=4)
    at = np.array([(_time(a.get("TIME")) - centre).total_seconds() for a in angles])
    turn = np.array([[a.number(k) for k in ("PITCH", "ROLL", "YAW")] for a in angles])
    order = np.argsort(times)
    if (np.diff(times[order]) <= 0).any():
        strip.get("Ephemeris", "Points").fail("scene.same_time")
    orbit, speed = lagrange(times[order], P[order]), lagrange(times[order], V[order])
    return Trajectory(
        position_times=times[order],
        positions=P[order],
        attitude_times=at,
        quaternions=_quaternions(orbit(at), speed(at), turn),
    )


def _quaternions(P: Array, V: Array, turn: Array) -> Array:
    """Detector to body axes (n, 4) at positions and velocities (n, 3), with pitch, roll, yaw (n, 3) [rad]."""
    from scipy.spatial.transform import Rotation

    Z = P / np.linalg.norm(P, axis=1)[:, None]
    X = np.cross(V, Z)
    X /= np.linalg.norm(X, axis=1)[:, None]
    orbital = np.stack([X, np.cross(Z, X), Z], axis=2)
    pitch, roll, yaw = turn.T
    about = [Rotation.from_euler(axis, angle[:, None]) for axis, angle in (("x", -pitch), ("y", -roll), ("z", yaw))]
    half_turn = Rotation.from_matrix(np.diag([1.0, -1.0, -1.0]))
    return (Rotation.from_matrix(orbital) * about[0] * about[1] * about[2] * half_turn).as_quat()


def _recognises(path: Path, head: bytes) -> bool:
    del path
    return b"<Dimap_Document" in head and b"METADATA_FORMAT version='1." in head.replace(b'"', b"'")


register(SceneFormat(name="spot", title="DIMAP 1 XML of SPOT 5: orbit", recognises=_recognises, read=read))
