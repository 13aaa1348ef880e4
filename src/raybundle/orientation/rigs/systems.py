"""Parts of rigs that stand in coordinate systems of their own: their scale, and how they are joined."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations

import numpy as np

from raybundle.block.rigs import (
    is_mounted,
)
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.rows import rows_of_each
from raybundle.orientation.growth import SMALL_ANGLE, WRONG
from raybundle.orientation.rays import intersect_linear, object_rays
from raybundle.orientation.rigs.pose import (
    FEWEST,
    Common,
    joined_by_stations,
)
from raybundle.orientation.rigs.state import Mounting, Rigs, is_free, is_open, move, renew_points
from raybundle.orientation.similarity_onto_rays import KnownRays, OntoRays, onto_rays
from raybundle.platforms.rig import OFFSET


def scaled_by_mountings(rigs: Rigs, images: Mask, known: Mapping[int, Mounting]) -> bool:
    """Scale a free system by the distances of cameras whose mountings are known; False where there are none."""
    ready = np.flatnonzero(images & np.isin(rigs.camera, list(known)))
    ratio, own = list[float](), rigs.alone.images
    for mine in rows_of_each(rigs.station[ready], int(rigs.station.max(initial=-1)) + 1):
        for a, b in zip(ready[mine[:-1]].tolist(), ready[mine[1:]].tolist(), strict=True):
            base = np.linalg.norm(known[int(rigs.camera[a])][1] - known[int(rigs.camera[b])][1])
            there = np.linalg.norm(own.centre[a] - own.centre[b])
            if base > 0 and there > 0:
                ratio.append(float(base / there))
    if not ratio:
        return False
    move(rigs, images, float(np.median(ratio)), np.eye(3), np.zeros(3))
    return True


def scale_by_offsets(rigs: Rigs) -> None:
    """Scale the rigs by offsets of which a part is known, where nothing else scales them."""
    given, there = list[float](), list[float]()
    for k, (_, b) in rigs.mounting.items():
        camera = rigs.block.cameras[k]
        if not is_mounted(camera) or not is_free(camera):
            continue
        for axis, s in enumerate(OFFSET):
            if not is_open(camera, s):
                given.append(camera.values.get(s, 0.0))
                there.append(float(b[axis]))
    square = float(np.dot(given, there))
    if not square > 0:
        return
    _transform(rigs, float(np.dot(given, given)) / square, np.eye(3), np.zeros(3))


def onto_control(rigs: Rigs) -> bool:
    """Bring the rigs onto control by the rays to it; False where these leave anything open."""
    control: Mask = np.asarray(rigs.block.points.is_control.all(axis=1))
    found = _onto_points(rigs, rigs.oriented, control, rigs.block.points.xyz)
    if found is None:
        return False
    _transform(rigs, found.scale, found.rotation, found.translation)
    rigs.local = False
    renew_points(rigs, rigs.oriented)
    return True


def _onto_points(rigs: Rigs, images: Mask, known: Mask, xyz: Array) -> OntoRays | None:
    """The similarity that brings images (n,) onto known points (p,), four at least; None where rays do not meet them.

    Points that one ray sees count as well: together, the parts of a rig may have what none of them has.
    """
    rays, own = rigs.growth.rays, rigs.alone.images
    rows = np.flatnonzero(images[rays.image] & known[rays.point])
    image, point = rays.image[rows], rays.point[rows]
    if len(np.unique(point)) < FEWEST:
        return None
    direction = object_rays(own.rotation[image], rays.direction[rows])
    free, count, ratio = intersect_linear(own.centre[image], direction, point, len(known))
    free[(count < 2) | (ratio <= SMALL_ANGLE)] = np.nan
    found = onto_rays(
        KnownRays(image=image, point=point, target=xyz[point], centre=own.centre[image], direction=direction),
        free[point],
    )
    limit = np.array([rigs.growth.limit(i) for i in image.tolist()])
    return found if found is not None and np.median(found.angle / limit) < WRONG else None


def _transform(rigs: Rigs, scale: float, rotation: Array, translation: Array) -> None:
    """Bring the oriented images, their rigs and free mountings to another coordinate system."""
    move(rigs, rigs.oriented, scale, rotation, translation)
    free = {k for k in rigs.mounting if is_free(rigs.block.cameras[k])}
    rigs.mounting = {k: (R, scale * b if k in free else b) for k, (R, b) in rigs.mounting.items()}
    rigs.pose = {s: (R @ rotation.T, scale * rotation @ C + translation) for s, (R, C) in rigs.pose.items()}


def join(rigs: Rigs, main: int, images: Mask, *, same_scale: bool) -> bool:
    """Bring images (n,) of another coordinate system to the main one, over stations or points that both know."""
    there = rigs.oriented & (rigs.system == main)
    common = {
        (a, b): (_common(rigs, there, images, a, b), _common(rigs, images, there, a, b))
        for a, b in combinations(np.unique(rigs.camera[there | images]).tolist(), 2)
    }
    for (a, b), (here, back) in sorted(common.items(), key=lambda c: -len(c[1][0].centre) - len(c[1][1].centre)):
        found = joined_by_stations(here, back, _mounting_between(rigs, a, b), scaled=same_scale)
        if found is not None:
            move(rigs, images, found.scale, found.rotation, found.translation)
            return True
    by_points = _by_common_points(rigs, there, images)
    if by_points is not None:
        move(rigs, images, *by_points)
    return by_points is not None


def _by_common_points(rigs: Rigs, there: Mask, images: Mask) -> tuple[float, Array, Array] | None:
    """Scale, rotation and translation that bring images (n,) to those there by the points that both see.

    Those that two rays determine on either side, and what single rays of the other say of them.
    """
    rays, own = rigs.growth.rays, rigs.alone.images
    seen = [np.isin(np.arange(len(rigs.sound)), rays.point[mine[rays.image]]) for mine in (there, images)]
    found = _onto_points(rigs, images, rigs.sound & seen[0], rigs.alone.points.xyz)
    if found is not None:
        return found.scale, found.rotation, found.translation
    rows = np.flatnonzero(images[rays.image])
    image, point = rays.image[rows], rays.point[rows]
    direction = object_rays(own.rotation[image], rays.direction[rows])
    xyz, count, ratio = intersect_linear(own.centre[image], direction, point, len(rigs.sound))
    back = _onto_points(rigs, there, (count >= 2) & (ratio > SMALL_ANGLE) & seen[0], xyz)
    if back is None:
        return None
    return 1 / back.scale, back.rotation.T, -back.rotation.T @ back.translation / back.scale


def _common(rigs: Rigs, first: Mask, second: Mask, a: int, b: int) -> Common:
    """The stations of camera a among the first images (n,) and of camera b among the second ones."""
    one, other = (np.flatnonzero(mine & (rigs.camera == k)) for mine, k in ((first, a), (second, b)))
    _, i, j = np.intersect1d(rigs.station[one], rigs.station[other], return_indices=True)
    own = rigs.alone.images
    return Common(
        rotation=own.rotation[one[i]], centre=own.centre[one[i]], other_rotation=own.rotation[other[j]],
        other_centre=own.centre[other[j]],
    )  # fmt: skip


def _mounting_between(rigs: Rigs, a: int, b: int) -> Mounting | None:
    """The mounting of camera b in the frame of camera a; None where they are not known in one frame."""
    if a not in rigs.mounting or b not in rigs.mounting or (a in rigs.anchored) != (b in rigs.anchored):
        return None
    (M, o), (N, p) = rigs.mounting[a], rigs.mounting[b]
    return N @ M.T, M @ (p - o)
