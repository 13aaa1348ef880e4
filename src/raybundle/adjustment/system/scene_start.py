"""Approximate coordinates of object points from satellite scenes, whose orientation is known from the start."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, cast

import numpy as np

from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array

if TYPE_CHECKING:
    from raybundle.scenes.sensor import SceneSensor

ROUNDS = 10


def with_scene_points(block: Block) -> Block:
    """The block with coordinates for points that have none and are seen by two scenes or more.

    Intersection of the scenes' rays by least squares, their parameters as they are given.
    raises  InputError where scenes and the unit of length do not go together
    """
    scenes = [i for i in range(len(block.images)) if block.cameras[int(block.images.camera[i])].is_scene]
    if not scenes:
        return block
    if block.length_unit != "m":
        raise InputError("scene.length_unit", unit=block.length_unit)
    o = block.observations
    is_scene = np.zeros(len(block.images), bool)
    is_scene[scenes] = True
    p = len(block.points)
    rays = np.bincount(o.point[is_scene[o.image]], minlength=p)
    wanted = (rays >= 2) & ~np.isfinite(block.points.xyz).all(axis=1)
    if not wanted.any():
        return block
    xyz = np.where(wanted[:, None], np.nan, block.points.xyz)
    for i in scenes:  # where each is first seen, at the scene's height
        rows = np.flatnonzero((o.image == i) & wanted[o.point] & np.isnan(xyz[o.point, 0]))
        sensor, values = _sensor(block, i)
        if len(rows):
            xyz[o.point[rows]] = sensor.localise(o.xy_px[rows], sensor.height_m, values)
    for _ in range(ROUNDS):
        N, b = np.zeros((p, 3, 3)), np.zeros((p, 3))
        for i in scenes:
            rows = np.flatnonzero((o.image == i) & wanted[o.point])
            if not len(rows):
                continue
            sensor, values = _sensor(block, i)
            seen = sensor.observe(xyz[o.point[rows]], values, o.xy_px[rows])
            np.add.at(N, o.point[rows], np.einsum("nki,nkj->nij", seen.by_point, seen.by_point))
            np.add.at(b, o.point[rows], np.einsum("nki,nk->ni", seen.by_point, o.xy_px[rows] - seen.xy_px))
        mine = np.flatnonzero(wanted)
        # a point whose rays are parallel stays at the scene's height
        scale = np.trace(N[mine], axis1=1, axis2=2)[:, None, None]
        step = np.linalg.solve(N[mine] + 1e-9 * scale * np.eye(3), b[mine][..., None])[..., 0]
        xyz[mine] += step
        if np.abs(step).max() < 1e-3:
            break
    return replace(block, points=replace(block.points, xyz=xyz))


def refuse_unoriented(block: Block) -> None:
    """Raise InputError where a block with scenes needs approximate values that the scenes do not give."""
    if not any(c.is_scene for c in block.cameras):
        return
    o = block.observations
    seen = np.bincount(o.image, minlength=len(block.images)) > 0
    images = [block.images.ids[i] for i in np.flatnonzero(seen & ~block.images.oriented)]
    lost = np.flatnonzero(
        (np.bincount(o.point, minlength=len(block.points)) > 0) & ~np.isfinite(block.points.xyz).all(axis=1)
    )
    points = [block.points.ids[k] for k in lost]
    if images:
        raise InputError("approximate_values.images_beside_scenes", n=len(images), images=images)
    raise InputError("approximate_values.points_beside_scenes", n=len(points), points=points)


def _sensor(block: Block, image: int) -> tuple[SceneSensor, Array]:
    camera = block.cameras[int(block.images.camera[image])]
    sensor = cast("SceneSensor", camera.scene)
    return sensor, np.array([camera.values[s] for s in sensor.symbols])
