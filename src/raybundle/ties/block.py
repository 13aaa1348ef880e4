"""Blocks of tie points: from tracks, and what every step about them asks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, cast

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera, Images, Observations, Points
from raybundle.block.points import automatic_name
from raybundle.block.stored import is_observed_jointly
from raybundle.io.photos.photo import Photo
from raybundle.matching.tracks import Tracks
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rows import rows_of_each
from raybundle.orientation.rays import intersect_linear, object_rays, rays_of

if TYPE_CHECKING:
    from raybundle.scenes.sensor import SceneSensor

FEATURE_SIGMA_PX = 0.5
"""A-priori standard deviation of a feature; only the ratio to nothing else matters before the weights are known."""
FEWEST_POINTS = 12
"""Points below which an image is not oriented."""
FIRST_FREE = ("c", "K1", "K2")
"""Free at the start, where nothing is precise yet."""
FREE = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S")


FLAT = 1.0e-4
"""Eigenvalue ratio of an intersection below which it has no depth: rays parallel to about 1.2 degrees."""
RISE_M = 500.0
"""Difference of height between two points of a scene's ray."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TieBlock:
    """A block of tie points and what is known of its image points."""

    block: Block
    scale_px: Array
    """(m,) of the features"""
    angle: Array
    """(m,)"""
    not_oriented: tuple[tuple[str, str], ...]
    """images and reasons"""


def free_at_start(camera: Camera) -> tuple[str, ...]:
    """Parameters that the start may move: none of a camera that was given as calibrated."""
    if is_observed_jointly(camera):
        return ()
    if camera.estimate == "auto":
        return FIRST_FREE
    return tuple(s for s in camera.estimate if s in FIRST_FREE)


def free_when_precise(camera: Camera) -> tuple[str, ...]:
    """Parameters that are free once the image points are precise; the final adjustment tests each."""
    if camera.estimate == "auto":
        return tuple(s for s in FREE if s not in ("A", "S"))
    return camera.estimate


def block_of_tracks(
    photos: Sequence[Photo],
    cameras: Sequence[Camera],
    camera_of_photo: Index,
    xy_px: Array,
    t: Tracks,
) -> Block:
    """A block without orientation, coordinates and a name: what is made of it does not depend on the project's.

    xy_px  (m, 2) of the features of the tracks
    """
    n, p = len(photos), t.points
    nothing = np.full((p, 3), np.nan)
    return Block(
        name="",
        cameras=tuple(cameras),
        images=Images(
            ids=tuple(photo.name for photo in photos),
            camera=camera_of_photo.astype(np.int32),
            file=tuple(photo.name for photo in photos),
            centre=np.full((n, 3), np.nan),
            rotation=np.full((n, 3, 3), np.nan),
        ),
        observations=Observations(
            image=t.image,
            point=t.point,
            xy_px=xy_px,
            cov_px2=np.tile([FEATURE_SIGMA_PX**2, FEATURE_SIGMA_PX**2, 0.0], (len(t.image), 1)),
        ),
        points=Points(
            ids=tuple(automatic_name(k) for k in range(p)),
            role=np.zeros(p, np.int32),
            xyz=nothing,
            sigma=nothing.copy(),
        ),
    )


def flat_points(block: Block) -> Mask:
    """(p,) tie points whose rays are nearly parallel: they say nothing of the object and hinder convergence."""
    origin, direction = viewing_lines(block)
    p = len(block.points)
    _, count, ratio = intersect_linear(origin, direction, block.observations.point, p)
    return (count < 2) | (ratio < FLAT) | ~np.isfinite(block.points.xyz).all(axis=1)


def viewing_lines(block: Block) -> tuple[Array, Array]:
    """A point (m, 3) and the unit direction (m, 3) of the ray of every image observation, in object space.

    A scene's rays have no common centre: each is the line through its ground points at two heights.
    """
    o = block.observations
    of_scene = np.array([c.is_scene for c in block.cameras])[block.images.camera][o.image]
    origin, direction = np.empty((len(o), 3)), np.empty((len(o), 3))
    rows = np.flatnonzero(~of_scene)
    if len(rows):
        rays = rays_of(replace(block, observations=o.rows(rows)) if of_scene.any() else block)
        origin[rows] = block.images.centre[rays.image]
        direction[rows] = object_rays(block.images.rotation[rays.image], rays.direction)
    rows_of = rows_of_each(o.image, len(block.images))
    for i in np.unique(o.image[of_scene]):
        rows = rows_of[i]
        camera = block.cameras[int(block.images.camera[i])]
        sensor = cast("SceneSensor", camera.sensor)
        low, high = (sensor.localise(o.xy_px[rows], sensor.height_m + d, camera.parameters) for d in (0.0, RISE_M))
        origin[rows] = low
        direction[rows] = (low - high) / np.linalg.norm(low - high, axis=1, keepdims=True)
    return origin, direction


def object_pixel(block: Block, rows: Index) -> Array:
    """(k,) size of a pixel on the object, square to the ray, at the points of image observations."""
    o = block.observations.rows(rows)
    origin, direction = viewing_lines(replace(block, observations=o))
    beside = viewing_lines(replace(block, observations=replace(o, xy_px=o.xy_px + np.array([1.0, 0.0]))))[1]
    distance = np.linalg.norm(block.points.xyz[o.point] - origin, axis=1)
    return distance * np.linalg.norm(np.cross(direction, beside), axis=1)


def image_sigma_px(result: Adjustment) -> float:
    """Standard deviation of an image coordinate of mean weight: sigma0 x root mean square of the a-priori ones."""
    s = result.image_observations
    used = s.used
    cov = result.given.observations.cov_px2[used]
    return float(result.sigma0 * np.sqrt(cov[:, :2].mean()))
