"""How light reaches a sensor above the ground: refraction of the atmosphere, aberration by the sensor's velocity.

Each is 15 to 40 px from an orbit.

aberration  the direction that the moving sensor sees is the geometric one turned towards its velocity,
            u = s d + v / c_light with |u| = 1, v in the frame that turns with the body (light and detector share it)
refraction  the ray meets the ground nearer to the nadir than in empty space, by (n0 - 1) 8400 m tan z / cos^2 z,
            n0 - 1 = 2.9e-4 exp(-h / 8400 m), z the zenith angle at the ground; one exponential atmosphere.  For a
            sensor within it, by the integral of n - n_sensor along the ray: 0.1 m at 45 degrees from 3 km
"""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array

C_LIGHT = 299792458.0
SCALE_HEIGHT_M = 8400.0
REFRACTIVITY = 2.9e-4
"""Of air at sea level, visible light."""


def refraction_shift(xyz: Array, sensor: Array, height: Array, up: Array) -> tuple[Array, Array, Array]:
    """From where a ray meets the ground to where it would in empty space (n, 3) [m], with derivatives by both.

    xyz, sensor (n, 3) geocentric; height (n,) [m] and up (n, 3) unit vertical at xyz
    returns  shift (n, 3); (n, 3, 3) by xyz; (n, 3, 3) by sensor

    q = r / (r.up) - up is horizontal, of length tan z: smooth at the nadir.  D = r.up is the height of the sensor above
    the point; from an orbit exp(-D / 8400 m) vanishes.  Azimuth and weather are left out; the remaining error is some
    centimetres from an orbit, a tenth of the shift from an aircraft.
    """
    r = sensor - xyz
    vertical = np.einsum("ni,ni->n", r, up)[:, None]
    q = r / vertical - up
    thin = np.exp(-np.maximum(vertical, 0.0) / SCALE_HEIGHT_M)
    ground = REFRACTIVITY * np.exp(-height / SCALE_HEIGHT_M)[:, None]
    k = ground * (SCALE_HEIGHT_M * (1 - thin) - vertical * thin)
    k_by_vertical = ground * thin * vertical / SCALE_HEIGHT_M
    stretch = 1 + np.sum(q * q, axis=1)[:, None]
    bare = -stretch * q
    shift = k * bare
    by_q = -k[..., None] * (stretch[..., None] * np.eye(3) + 2 * q[:, :, None] * q[:, None, :])
    q_by_r = (np.eye(3) - r[:, :, None] * up[:, None, :] / vertical[..., None]) / vertical[..., None]
    q_by_up = -r[:, :, None] * r[:, None, :] / vertical[..., None] ** 2 - np.eye(3)
    horizontal = (np.eye(3) - up[:, :, None] * up[:, None, :]) / np.linalg.norm(xyz, axis=1)[:, None, None]
    by_vertical = (k_by_vertical * bare)[:, :, None]
    by_sensor = by_q @ q_by_r + by_vertical * up[:, None, :]
    by_up = by_q @ q_by_up + by_vertical * r[:, None, :]
    by_xyz = -by_sensor + by_up @ horizontal - shift[:, :, None] * up[:, None, :] / SCALE_HEIGHT_M
    return shift, by_xyz, by_sensor


def apparent_direction(d: Array, beta: Array) -> tuple[Array, Array, Array]:
    """The unit direction u = s d + beta (n, 3) in which a moving sensor sees a source in direction d.

    d (n, 3) unit; beta (n, 3) velocity / speed of light.  Also its derivatives (n, 3, 3) by d and by beta.
    """
    along = np.einsum("ni,ni->n", d, beta)
    root = np.sqrt(along**2 + 1 - np.sum(beta * beta, axis=1))
    s = root - along
    pull = (along / root - 1)[:, None]
    by_d = s[:, None, None] * np.eye(3) + d[:, :, None] * (pull * beta)[:, None, :]
    by_beta = np.eye(3) + d[:, :, None] * (pull * d - beta / root[:, None])[:, None, :]
    return s[:, None] * d + beta, by_d, by_beta
