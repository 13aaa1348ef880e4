"""Attitudes of photographs, from a file or from what the photographs record, with their covariances."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.io.photos.photo import Photo
from raybundle.io.trajectories.base import Trajectory, decided, in_wgs84, matched
from raybundle.numerics.arrays import Array
from raybundle.numerics.attitude import rotation_from_gimbal, rotation_from_opk, rotation_from_pok, rotation_from_rpy
from raybundle.numerics.rotation import vector_from_rotation

ROTATIONS = {
    "opk": rotation_from_opk,
    "pok": rotation_from_pok,
    "rpy-ned": rotation_from_rpy,
    "gimbal": rotation_from_gimbal,
}
"""Conventions and the rotations that their three angles make."""
TWICE_STEP = 2e-6
"""Base of numeric derivatives [rad]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PhotoAttitudes:
    """What an INS or a gimbal measured of the attitudes of photographs."""

    names: tuple[str, ...]
    """(n,) of the photographs"""
    rotation: Array
    """(n, 3, 3) from east, north, up at the camera to the image axes"""
    covariance: Array
    """(n, 3, 3) of a small rotation about the image axes [rad^2]; NaN where no standard deviation is known"""
    convention: str
    """opk, pok, rpy-ned or gimbal"""
    angles: Array
    """(n, 3) as recorded, in the order of the convention [rad]"""
    against_enu: Array
    """(n, 3, 3) what turns the rotation of the angles: rotation = rotation(angles) @ against_enu"""
    source: str
    """name of a file, or gimbal: the metadata of the photographs"""
    reading: str = ""
    """name of the reading, where the file has several"""
    others: tuple[PhotoAttitudes, ...] = ()
    """the other readings, from which the photographs choose"""
    customary: bool = False
    """whether this reading is the one that its format usually has"""

    def __len__(self) -> int:
        return len(self.names)

    @property
    def stated(self) -> int:
        """Number of attitudes with standard deviations."""
        return int(np.isfinite(self.covariance).all(axis=(1, 2)).sum())


def attitudes_of_file(
    trajectory: Trajectory, photos: Sequence[Photo], *, crs: str | None, sigma: tuple[float, float] | None,
    use: str = "auto",
) -> PhotoAttitudes | None:  # fmt: skip
    """The attitudes of a file for these photographs; None where it has none for them.

    crs     the system of a file that shows none
    sigma   about level axes and about the vertical [rad], where the file states no standard deviations
    use     the convention that is expected, with or without the unit: of several readings those of that name
    raises  InputError where attitudes stand against a grid that is not known
    """
    if trajectory.readings:
        names = [r.name for r in trajectory.readings]
        named = [n for n in names if n == use or n.startswith(f"{use}-")] or names
        read = [attitudes_of_file(decided(trajectory, n), photos, crs=crs, sigma=sigma) for n in named]
        found = [replace(r, reading=n) for r, n in zip(read, named, strict=True) if r is not None]
        customary = trajectory.rotation is not None
        return replace(found[0], others=tuple(found[1:]), customary=customary) if found else None
    if trajectory.rotation is None or trajectory.angles is None:
        return None
    turned = in_wgs84(trajectory, crs)
    assert turned.rotation is not None
    row = matched(turned, [p.name for p in photos])
    mine = np.flatnonzero((row >= 0) & np.isfinite(turned.rotation[row]).all(axis=(1, 2)))
    if not len(mine):
        return None
    rows = row[mine]
    rotation, angles = turned.rotation[rows], trajectory.angles[rows]
    stated = np.full((len(rows), 3), np.nan) if turned.rotation_sigma is None else turned.rotation_sigma[rows]
    by_angles = ROTATIONS[trajectory.convention](angles)
    found = PhotoAttitudes(
        names=tuple(photos[k].name for k in mine.tolist()),
        rotation=rotation,
        covariance=_covariance(trajectory.convention, angles, rotation, np.where(stated > 0, stated, np.nan)),
        convention=trajectory.convention,
        angles=angles,
        against_enu=np.swapaxes(by_angles, 1, 2) @ rotation,
        source=trajectory.path.name,
    )
    return with_sigma(found, sigma)


def attitudes_of_gimbals(photos: Sequence[Photo], *, sigma: tuple[float, float] | None) -> PhotoAttitudes | None:
    """The attitudes that the photographs record of their gimbal, yaw from true north; None where they record none."""
    seen = {p.name: p.metadata.gimbal for p in photos if p.metadata.gimbal is not None}
    if not seen:
        return None
    angles = np.radians(np.array(list(seen.values())))
    rotation = rotation_from_gimbal(angles)
    found = PhotoAttitudes(
        names=tuple(seen), rotation=rotation, covariance=np.full_like(rotation, np.nan),
        convention="gimbal", angles=angles, against_enu=np.tile(np.eye(3), (len(seen), 1, 1)),
        source="gimbal",
    )  # fmt: skip
    return with_sigma(found, sigma)


def with_sigma(attitudes: PhotoAttitudes, sigma: tuple[float, float] | None) -> PhotoAttitudes:
    """The attitudes, those without standard deviations with these about level axes and the vertical [rad]."""
    if sigma is None:
        return attitudes
    usual = about_enu(attitudes.rotation, np.tile(sigma, (len(attitudes), 1)))
    known = np.isfinite(attitudes.covariance).all(axis=(1, 2), keepdims=True)
    return replace(attitudes, covariance=np.where(known, attitudes.covariance, usual))


def about_enu(rotation: Array, sigma: Array) -> Array:
    """Covariances (n, 3, 3) about the image axes of standard deviations (n, 2) about level axes and the vertical."""
    level, upright = sigma.T
    variances = np.stack([level, level, upright], axis=1) ** 2
    return rotation @ (variances[:, :, None] * np.swapaxes(rotation, 1, 2))


def _covariance(convention: str, angles: Array, rotation: Array, sigma: Array) -> Array:
    """Of a small rotation about the image axes, from the standard deviations (n, 3) of the angles.

    At the nadir the yaw and the roll of a gimbal turn about one axis and none of its angles about the third: there
    the larger one of pitch and roll counts about both level axes.
    """
    if convention == "gimbal":
        yaw, pitch, roll = sigma.T
        return about_enu(rotation, np.stack([np.maximum(pitch, roll), yaw], axis=1))
    make = ROTATIONS[convention]
    J = np.empty((len(angles), 3, 3))
    for k in range(3):
        step = np.zeros(3)
        step[k] = TWICE_STEP / 2
        J[:, :, k] = vector_from_rotation(make(angles + step) @ np.swapaxes(make(angles - step), 1, 2)) / TWICE_STEP
    return J @ (sigma[:, :, None] ** 2 * np.swapaxes(J, 1, 2))
