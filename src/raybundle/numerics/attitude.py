"""Attitudes as others state them, to and from the rotation R of object axes to image axes, (U, V, W) = R (X - X0).

opk      omega, phi, kappa   R = R3(kappa) R2(phi) R1(omega): our own; object axes turned about moving axes (Kraus 2007)
pok      phi, omega, kappa   R = R3(kappa) R1(omega) R2(phi): phi is the primary angle
rpy      roll, pitch, yaw    of a body with axes forward, right, down, against north, east, down: first yaw about down,
                             then pitch about the new right, then roll about the new forward axis (ARINC 705, ZYX)
gimbal   yaw, pitch, roll    of a camera by the same rule, its viewing axis forward: pitch 0 looks to the horizon, -90
                             to the nadir; yaw is the azimuth of the view, at the nadir that of the image's upper side

All angles in radians; in degrees or gon in files alone.  The object axes are east, north, up at the camera: where they
are those of a map grid or of a distant origin, `local_from_enu` of the frame turns between the two, and a yaw counts
from true north.
"""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import angles_from_rotation, rotation_from_angles

NED_FROM_ENU = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])
"""North, east, down of east, north, up; its own inverse."""
NADIR_FROM_BODY = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])
"""Image axes of a camera that looks down in a body, the upper side of its image forward."""
FRONT_FROM_BODY = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, -1.0], [-1.0, 0.0, 0.0]])
"""Image axes of a camera that looks forward in a body, the upper side of its image upward: right, up, back."""
GON = np.pi / 200
LOCKED = 1e-9
"""Cosine of the middle angle below which the outer two turn about the same axis."""


def rotation_from_opk(angles: Array) -> Array:
    """R (..., 3, 3) of omega, phi, kappa (..., 3) [rad]."""
    return rotation_from_angles(angles)


def opk_from_rotation(rotation: Array) -> Array:
    """omega, phi, kappa (..., 3) [rad] of R (..., 3, 3); omega is zero where phi is +-90 degrees."""
    return angles_from_rotation(rotation)


def rotation_from_pok(angles: Array) -> Array:
    """R (..., 3, 3) of phi, omega, kappa (..., 3) [rad], phi the primary angle."""
    a = np.asarray(angles, float)
    zero = np.zeros_like(a[..., 0])
    by_phi = rotation_from_angles(np.stack([zero, a[..., 0], zero], axis=-1))
    by_omega = rotation_from_angles(np.stack([a[..., 1], zero, zero], axis=-1))
    by_kappa = rotation_from_angles(np.stack([zero, zero, a[..., 2]], axis=-1))
    return by_kappa @ by_omega @ by_phi


def pok_from_rotation(rotation: Array) -> Array:
    """phi, omega, kappa (..., 3) [rad] of R (..., 3, 3); omega in [-pi/2, pi/2], at its ends phi is zero."""
    R = np.asarray(rotation, float)
    level = np.hypot(R[..., 2, 0], R[..., 2, 2])
    locked = level < LOCKED
    omega = np.arctan2(-R[..., 2, 1], level)
    phi = np.where(locked, 0.0, np.arctan2(R[..., 2, 0], R[..., 2, 2]))
    kappa = np.where(locked, np.arctan2(-R[..., 1, 0], R[..., 0, 0]), np.arctan2(R[..., 0, 1], R[..., 1, 1]))
    return np.stack([phi, omega, kappa], axis=-1)


def body_from_ned(angles: Array) -> Array:
    """Rotations (..., 3, 3) from north, east, down to forward, right, down of roll, pitch, yaw (..., 3) [rad]."""
    a = np.asarray(angles, float)
    sr, cr = np.sin(a[..., 0]), np.cos(a[..., 0])
    sp, cp = np.sin(a[..., 1]), np.cos(a[..., 1])
    sy, cy = np.sin(a[..., 2]), np.cos(a[..., 2])
    rows = [
        [cp * cy, cp * sy, -sp],
        [sr * sp * cy - cr * sy, sr * sp * sy + cr * cy, sr * cp],
        [cr * sp * cy + sr * sy, cr * sp * sy - sr * cy, cr * cp],
    ]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def rpy_from_body(rotation: Array) -> Array:
    """roll, pitch, yaw (..., 3) [rad] of rotations (..., 3, 3) from north, east, down to forward, right, down.

    Pitch lies in [-pi/2, pi/2]; at its ends only the sum or difference of yaw and roll is defined: roll is zero.
    """
    C = np.asarray(rotation, float)
    level = np.hypot(C[..., 0, 0], C[..., 0, 1])
    locked = level < LOCKED
    pitch = np.arctan2(-C[..., 0, 2], level)
    roll = np.where(locked, 0.0, np.arctan2(C[..., 1, 2], C[..., 2, 2]))
    yaw = np.where(locked, np.arctan2(-C[..., 1, 0], C[..., 1, 1]), np.arctan2(C[..., 0, 1], C[..., 0, 0]))
    return np.stack([roll, pitch, yaw], axis=-1)


def rotation_from_rpy(angles: Array, image_from_body: Array = NADIR_FROM_BODY) -> Array:
    """R (..., 3, 3) of roll, pitch, yaw (..., 3) [rad] of the body that carries the camera.

    image_from_body  (3, 3) how the camera is mounted; the default looks down with the upper side of the image forward
    """
    return image_from_body @ body_from_ned(angles) @ NED_FROM_ENU


def rpy_from_rotation(rotation: Array, image_from_body: Array = NADIR_FROM_BODY) -> Array:
    """roll, pitch, yaw (..., 3) [rad] of the body, from R (..., 3, 3) of the camera mounted in it."""
    return rpy_from_body(image_from_body.T @ np.asarray(rotation, float) @ NED_FROM_ENU)


def rotation_from_gimbal(angles: Array) -> Array:
    """R (..., 3, 3) of a camera's yaw, pitch, roll (..., 3) [rad], in the order in which drones record them."""
    a = np.asarray(angles, float)
    return rotation_from_rpy(a[..., ::-1], FRONT_FROM_BODY)


def gimbal_from_rotation(rotation: Array) -> Array:
    """A camera's yaw, pitch, roll (..., 3) [rad] of R (..., 3, 3); at the nadir roll is zero, yaw takes its part."""
    return rpy_from_rotation(rotation, FRONT_FROM_BODY)[..., ::-1]
