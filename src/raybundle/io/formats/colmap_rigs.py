"""Poses of the images of a COLMAP model: rigs times frames, or those of the images where they stand alone."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.errors import InputError, Message, note
from raybundle.io.formats.colmap_files import CAMERA, Model
from raybundle.io.reading.ledger import enter
from raybundle.numerics.arrays import Array

SAME_ROTATION = 1e-6
"""Angle between poses that are the same [rad]: numbers of seven digits."""
SAME_PLACE = 1e-6
"""Distance between centres that are the same, of the extent of the model."""


def quaternions(rotation: Array) -> Array:
    """Unit quaternions (n, 4), w first and not negative, of rotations (n, 3, 3)."""
    from scipy.spatial.transform import Rotation

    q = np.roll(Rotation.from_matrix(rotation).as_quat(), 1, axis=1)
    return q * np.where(q[:, :1] < 0, -1.0, 1.0)


def rotations(quaternion: Array) -> Array:
    """Rotations (n, 3, 3) of quaternions (n, 4), w first, of any length but 0."""
    from scipy.spatial.transform import Rotation

    return Rotation.from_quat(np.roll(quaternion, -1, axis=1)).as_matrix()


def image_poses(model: Model, folder: Path, remarks: list[Message]) -> tuple[Array, Array]:
    """Rotations (n, 3, 3) from object axes to the camera's and translations (n, 3) of the images.

    The pose of a sensor in its rig times that of the rig in a frame; a remark where the files of the images differ.
    """
    pose = np.array(model.pose, float)
    R, t = rotations(pose[:, :4]), pose[:, 4:]
    position = {number: k for k, number in enumerate(model.numbers)}
    composed_R, composed_t = R.copy(), t.copy()
    found = np.zeros(len(R), bool)
    unposed = measurements = missing = 0
    for frame in model.frames:
        at = np.array(frame.pose, float)
        rig_R, rig_t = rotations(at[None, :4])[0], at[4:]
        for kind, sensor, number in frame.data:
            k = position.get(number) if kind == CAMERA else None
            mounted = model.rigs[frame.rig][kind, sensor]
            if k is None or mounted is None:
                measurements += kind != CAMERA
                missing += kind == CAMERA and k is None
                unposed += k is not None
                continue
            if found[k]:
                raise InputError("image.in_two_frames", image=model.names[k], file=folder)
            if model.camera[k] != sensor:
                raise InputError(
                    "image.camera_differs", image=model.names[k], camera=str(model.camera[k]), frame_camera=str(sensor),
                    file=folder,
                )  # fmt: skip
            own = np.array(mounted, float)
            own_R = rotations(own[None, :4])[0]
            composed_R[k], composed_t[k], found[k] = own_R @ rig_R, own_R @ rig_t + own[4:], True
    enter("measurement of another sensor in frames", measurements)
    enter("image of frames without a row in images", missing)
    if unposed:
        remarks.append(note("import.sensors_without_pose", n=unposed))
    _compare(model, (R, t), (composed_R, composed_t), remarks)
    return composed_R, composed_t


def _compare(model: Model, given: tuple[Array, Array], composed: tuple[Array, Array], remarks: list[Message]) -> None:
    """A remark where poses of images are not those of rigs times frames."""
    centres = [-np.einsum("nji,nj->ni", R, t) for R, t in (given, composed)]
    extent = float(np.linalg.norm(np.ptp(centres[1], axis=0))) or 1.0
    distance = np.linalg.norm(centres[0] - centres[1], axis=1)
    angle = 2 * np.arcsin(np.minimum(np.linalg.norm(given[0] - composed[0], axis=(1, 2)) / np.sqrt(8), 1))
    different = (distance > SAME_PLACE * extent) | (angle > SAME_ROTATION)
    if different.any():
        worst = int(np.argmax(np.where(different, distance, -1.0)))
        remarks.append(
            note(
                "import.rig_poses_differ", n=int(different.sum()), total=len(distance), apart=float(distance.max()),
                image=model.names[worst], angle_deg=float(np.degrees(angle.max())),
            )
        )  # fmt: skip
