"""A rig: a station that carries several cameras, each mounted with an offset of its own.

(U, V, W) of a mounted camera = R3(ka) R2(ph) R1(om) ((X, Y, Z) - b), where (X, Y, Z) is the point in the rig's frame.
The rig has one exterior orientation at each station; `sensors.mounted` puts the offsets into the condition.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import angles_from_rotation, rotation_from_angles

OFFSET = ("bx", "by", "bz")
ANGLES = ("om", "ph", "ka")


def orientation_of(centre: Array, rotation: Array, mounting: Mapping[str, float]) -> tuple[Array, Array]:
    """Projection centre (3,) and rotation (3, 3) of a camera from those of its rig and its mounting."""
    own = rotation_from_angles(np.array([mounting[s] for s in ANGLES]))
    return centre + rotation.T @ np.array([mounting[s] for s in OFFSET]), own @ rotation


def mounting_of(centre: Array, rotation: Array, camera_centre: Array, camera_rotation: Array) -> dict[str, float]:
    """The mounting of a camera from the exterior orientations of its rig and of itself; a start for the adjustment."""
    offset = rotation @ (camera_centre - centre)
    angles = angles_from_rotation(camera_rotation @ rotation.T)
    return dict(zip((*OFFSET, *ANGLES), (float(v) for v in (*offset, *angles)), strict=True))
