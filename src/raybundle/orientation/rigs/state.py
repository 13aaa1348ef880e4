"""Images of rigs one by one, and what is found of their mountings and stations on the way to approximate values."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.block import Block, Camera
from raybundle.block.rigs import (
    MOUNTING,
    is_mounted,
)
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.orientation.completion import complete
from raybundle.orientation.growth import SMALL_ANGLE, Growth
from raybundle.orientation.rays import intersect_linear, object_rays
from raybundle.orientation.rigs.pose import (
    StationRays,
)
from raybundle.platforms.rig import mounting_of

Mounting = tuple[Array, Array]


@dataclass(slots=True)
class Rigs:
    """Images one by one, and what is found of their rigs."""

    block: Block
    """With rigs, as given"""
    alone: Block
    """Its images one by one"""
    growth: Growth
    """Of `alone`: its rays and their limits"""
    fits: Mask
    """(m,) observations that fit the others of their point"""
    oriented: Mask
    """(n,) images that are oriented one by one"""
    system: Index
    """(n,) coordinate system of their orientations"""
    station: Index
    """(n,)"""
    sound: Mask
    """(p,) points that are given, or that two rays of oriented images determine"""
    local: bool = False
    """Whether the rigs stand in a system of their own, in which given coordinates are none"""
    mounting: dict[int, Mounting] = field(default_factory=dict[int, Mounting])
    """By camera"""
    pose: dict[int, Mounting] = field(default_factory=dict[int, Mounting])
    """By station: rotation and centre of the rig"""
    anchored: set[int] = field(default_factory=set[int])
    """Cameras whose mountings are in the frame of one of them, not in that of the cameras that are known"""

    @property
    def camera(self) -> Index:
        """Position of the camera of each image (n,)."""
        return self.block.images.camera

    @property
    def given(self) -> Mask:
        """Points with given coordinates (p,)."""
        finite: Mask = np.asarray(np.isfinite(self.block.points.xyz).all(axis=1))
        return np.zeros_like(finite) if self.local else finite


def is_free(camera: Camera) -> bool:
    """Whether nothing is known of a part of a camera's mounting at least."""
    return any(is_open(camera, s) for s in MOUNTING) if is_mounted(camera) else False


def is_open(camera: Camera, symbol: str) -> bool:
    """Whether a parameter is estimated and not observed."""
    observed = symbol in camera.sigma or (camera.calibrated is not None and symbol in camera.calibrated.symbols)
    return (camera.estimate == "auto" or symbol in camera.estimate) and not observed


def given_mounting(camera: Camera) -> Mounting:
    """The mounting that a camera has; none for one that is not mounted."""
    values = [camera.values.get(s, 0.0) if is_mounted(camera) else 0.0 for s in MOUNTING]
    return rotation_from_angles(np.array(values[3:])), np.array(values[:3])


def values_of(camera: Camera, mounting: Mounting) -> dict[str, float]:
    """The values of a mounted camera with those of a mounting that are estimated and not observed."""
    return {**camera.values, **{s: v for s, v in symbols_of(mounting).items() if is_open(camera, s)}}


def symbols_of(mounting: Mounting) -> dict[str, float]:
    """A mounting as parameters of a camera."""
    R, b = mounting
    return mounting_of(np.zeros(3), np.eye(3), b, R)


def with_poses(rigs: Rigs, alone: Block, chosen: Index, mounting: Mounting | None = None) -> Block:
    """Images one by one, those chosen (k,), of oriented stations, where their rigs have them.

    mounting  of all of them; None: as found
    """
    images = alone.images
    centre, rotation = images.centre.copy(), images.rotation.copy()
    for i in chosen.tolist():
        (M, b), (R, C) = mounting or rigs.mounting[int(rigs.camera[i])], rigs.pose[int(rigs.station[i])]
        centre[i], rotation[i] = C + R.T @ b, M @ R
    return replace(alone, cameras=rigs.alone.cameras, images=replace(images, centre=centre, rotation=rotation))


def at_stations(rigs: Rigs) -> Mask:
    """(n,) images with observations at stations that are oriented."""
    return rigs.growth.seen & np.isin(rigs.station, list(rigs.pose))


def placed_images(rigs: Rigs) -> Mask:
    """(n,) images whose station is oriented and whose mounting is known."""
    return np.isin(rigs.station, list(rigs.pose)) & np.isin(rigs.camera, list(rigs.mounting))


def renew_points(rigs: Rigs, images: Mask) -> None:
    """Intersect the points from these images (n,), all in one coordinate system, and judge them and their rays."""
    own, rays = rigs.alone.images, rigs.growth.rays
    centre = np.where(images[:, None], own.centre, np.nan)
    given = rigs.given
    xyz = np.where(given[:, None], rigs.block.points.xyz, np.nan)
    block = replace(rigs.alone, images=replace(own, centre=centre), points=replace(rigs.alone.points, xyz=xyz))
    found = complete(block, rays, ~given, 2 * rigs.growth.limits(images))
    rigs.alone = replace(rigs.alone, points=replace(block.points, xyz=found.xyz))
    rigs.fits = ~found.outliers
    rows = np.flatnonzero(images[rays.image] & rigs.fits)
    image, point = rays.image[rows], rays.point[rows]
    direction = object_rays(own.rotation[image], rays.direction[rows])
    _, count, ratio = intersect_linear(own.centre[image], direction, point, len(given))
    rigs.sound = given | ((count >= 2) & (ratio > SMALL_ANGLE))


def _rows_to_known(rigs: Rigs, images: Index) -> Index:
    """Rows of the observations in images (k,) whose points are known and that fit these."""
    rows = np.concatenate([np.zeros(0, np.int64), *(rigs.growth.by_image[i] for i in images.tolist())])
    return rows[rigs.fits[rows] & rigs.sound[rigs.growth.rays.point[rows]]]


def camera_rays(rigs: Rigs, images: Index) -> StationRays:
    """The rays of images (k,) of one camera to known points, as one image in the frame of their rigs."""
    rows = _rows_to_known(rigs, images)
    rays = rigs.growth.rays
    pose = {i: rigs.pose[int(rigs.station[i])] for i in images.tolist()}
    points, image = rigs.alone.points.xyz[rays.point[rows]], rays.image[rows].tolist()
    local = [pose[i][0] @ (xyz - pose[i][1]) for i, xyz in zip(image, points, strict=True)]
    return StationRays(
        origin=np.zeros((len(rows), 3)), direction=rays.direction[rows], xyz=np.array(local).reshape(-1, 3),
        limit=np.array([rigs.growth.limit(i) for i in image]),
    )  # fmt: skip


def station_rays(rigs: Rigs, images: Index) -> StationRays:
    """The rays of these images (k,) of a station, whose mountings are known, to points that are."""
    rays, xyz = rigs.growth.rays, rigs.alone.points.xyz
    rows = _rows_to_known(rigs, images)
    camera = rigs.camera[rays.image[rows]]
    M, b = np.zeros((len(rigs.block.cameras), 3, 3)), np.zeros((len(rigs.block.cameras), 3))
    for k, (R, offset) in rigs.mounting.items():
        M[k], b[k] = R, offset
    return StationRays(
        origin=b[camera], direction=object_rays(M[camera], rays.direction[rows]), xyz=xyz[rays.point[rows]],
        limit=np.array([rigs.growth.limit(i) for i in rays.image[rows].tolist()]),
    )  # fmt: skip


def move(rigs: Rigs, images: Mask, scale: float, rotation: Array, translation: Array) -> None:
    """Bring images (n,) and the points that they see to another coordinate system."""
    block, rays = rigs.alone, rigs.growth.rays
    centre, turned, xyz = block.images.centre.copy(), block.images.rotation.copy(), block.points.xyz.copy()
    centre[images] = scale * centre[images] @ rotation.T + translation
    turned[images] = turned[images] @ rotation.T
    seen = np.zeros(len(xyz), bool)
    seen[rays.point[images[rays.image]]] = True
    seen &= rigs.local | ~block.points.is_control.any(axis=1)
    xyz[seen] = scale * xyz[seen] @ rotation.T + translation
    rigs.alone = replace(
        block, images=replace(block.images, centre=centre, rotation=turned), points=replace(block.points, xyz=xyz)
    )
