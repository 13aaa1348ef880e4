"""Simulated pushbroom scenes of a ground point, from a circular orbit: for tests, planning and examples."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import WGS84, enu_from_geocentric, geocentric_from_geographic
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.scenes.linescan import LineScene
from raybundle.scenes.trajectory import Trajectory

GM = 3.986004418e14
TABLE_S = 0.02
"""Interval of the simulated ephemeris and attitude."""


@dataclass(frozen=True, slots=True, kw_only=True)
class OrbitPlan:
    """Where a simulated scene looks, and from where."""

    target: tuple[float, float, float]
    """Longitude, latitude [deg], height [m] in the middle of the scene."""
    pitch_deg: float = 0.0
    """Angle at the centre of the earth by which the satellite stands before the target, along the track."""
    roll_deg: float = 0.5
    """The same across the track."""
    heading_deg: float = 190.0
    """Of the flight."""
    altitude_m: float = 681e3
    gsd_m: float = 1.0
    """Of a pixel at the target, seen vertically from the altitude."""
    width_px: int = 4000
    height_px: int = 4000
    drift: tuple[float, float, float] = (2e-4, -1e-4, 1e-4)
    """Turn of the sensor about its axes [rad/s]."""


def orbit_scene(plan: OrbitPlan) -> LineScene:
    """A rigorous scene whose middle shows the target.

    The earth does not turn here; what the tables give is taken in the frame that turns with it.
    """
    target = np.array([plan.target])
    T = geocentric_from_geographic(target, WGS84)[0]
    E, N, U = enu_from_geocentric(target)[0]
    heading = np.radians(plan.heading_deg)
    along = np.sin(heading) * E + np.cos(heading) * N
    normal = np.cross(U, along)
    p0 = rotation_from_vector(np.radians(plan.pitch_deg) * normal + np.radians(plan.roll_deg) * along) @ U
    v0 = along - p0 * (along @ p0)
    v0 /= np.linalg.norm(v0)
    r = float(np.linalg.norm(T)) + plan.altitude_m
    rate = np.sqrt(GM / r**3)
    line_s = plan.gsd_m / (rate * float(np.linalg.norm(T)))
    half = line_s * plan.height_px / 2
    t = np.arange(-half - 0.5, half + 0.5 + TABLE_S, TABLE_S)
    phase = (rate * t)[:, None]
    P = r * (np.cos(phase) * p0 + np.sin(phase) * v0)
    V = r * rate * (np.cos(phase) * v0 - np.sin(phase) * p0)
    level = _axes(-P, V)
    sight = (T - r * p0)[None]
    fixed = level[np.argmin(np.abs(t))].T @ _axes(sight, (v0 * rate * r)[None])[0]
    turn = rotation_from_vector(t[:, None] * np.array(plan.drift))
    x = np.array([0.0, float(plan.width_px)])
    look = np.stack([np.zeros(2), (x - plan.width_px / 2) * plan.gsd_m / plan.altitude_m], axis=1)
    return LineScene(
        width_px=plan.width_px,
        height_px=plan.height_px,
        line_y=np.array([0.5, plan.height_px + 0.5]),
        line_times=np.array([-half, half]),
        detector_x=x,
        detector_look=look,
        trajectory=Trajectory(
            position_times=t, positions=P, attitude_times=t, quaternions=_quaternions(level @ fixed @ turn)
        ),
    )


def _axes(sight: Array, velocity: Array) -> Array:
    """(n, 3, 3) columns: x along the track, y across it, z along the line of sight."""
    z = sight / np.linalg.norm(sight, axis=1)[:, None]
    x = velocity - z * np.sum(velocity * z, axis=1)[:, None]
    x /= np.linalg.norm(x, axis=1)[:, None]
    return np.stack([x, np.cross(z, x), z], axis=2)


def _quaternions(rotation: Array) -> Array:
    """(n, 4), the scalar last."""
    from scipy.spatial.transform import Rotation

    return Rotation.from_matrix(rotation).as_quat()
