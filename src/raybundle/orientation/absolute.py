"""Absolute orientation: a part in a system of its own onto control, projection centres or a scale bar."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from typing import Literal

import numpy as np

from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.least_squares import Minimum, minimum
from raybundle.numerics.rotation import rotation_from_angles, rotation_from_vector
from raybundle.numerics.transform import robust_similarity
from raybundle.orientation.growth import Growth

LEAST_COMMON = 4
"""Points by which one part is brought onto another."""


OPEN = 0.02
"""Share of the largest singular value of a similarity's equations below which a part of it stays open: given points in
a line that are 50 times as far apart as they are off it"""


def onto_control(growth: Growth, before: Mask) -> Literal["determined", "open", "none"]:
    """Bring the images oriented since `before` and their points onto control or observed centres.

    Full control points first (robust similarity); else whatever coordinates are given, XY-only and Z-only,
    by a search over rotations.

    open  what is given leaves a part of the similarity open, as two points the turn about them
    none  nothing is given
    """
    if not growth.local:
        return "determined"
    block = growth.block
    images = growth.oriented & ~before
    mine = _points_of(growth, images)
    target_points, given = block_control(growth)
    part = mine[given[mine].any(axis=1)]
    source = [growth.block.points.xyz[part]]
    target = [target_points[part]]
    which = [given[part]]
    stations = [k for k, i in enumerate(block.stations.image) if images[i]]
    if stations:
        source.append(block.images.centre[block.stations.image[stations]])
        target.append(block.stations.xyz[stations])
        which.append(np.isfinite(block.stations.xyz[stations]))
    a, b, w = np.concatenate(source), np.concatenate(target), np.concatenate(which)
    if not w.any():
        return "none"
    full = w.all(axis=1)
    transform = None
    if full.sum() >= 3:
        extent = float(np.max(np.ptp(b[full], axis=0)))
        try:
            s, _ = robust_similarity(a[full], b[full], 0.05 * extent)
            transform = (s.scale, s.rotation, s.translation)
        except InputError:
            transform = None
    if transform is None:
        transform = partial_similarity(a, np.where(w, b, 0.0), w)
    _apply(growth, images, mine, *transform)
    return "open" if _leave_open(b, w) else "determined"


def _leave_open(target: Array, given: Mask) -> bool:
    """Whether single given coordinates (n, 3) of points leave a part of a similarity open."""
    about = target - np.array([target[given[:, k], k].mean() if given[:, k].any() else 0.0 for k in range(3)])
    about = np.where(given, about, 0.0)
    size = float(np.sqrt(np.mean(about**2))) or 1.0
    A = _by_similarity(1.0, about / size)[given]
    values = np.linalg.svd(A, compute_uv=False)
    return len(values) < 7 or float(values[-1]) < OPEN * float(values[0])


def _by_similarity(s: float, turned: Array) -> Array:
    """Partial derivatives (n, 3, 7) of s turned + t by t, a small rotation and s."""
    A = np.zeros((len(turned), 3, 7))
    A[:, :, :3] = np.eye(3)
    A[:, 1, 3], A[:, 2, 3] = -s * turned[:, 2], s * turned[:, 1]
    A[:, 0, 4], A[:, 2, 4] = s * turned[:, 2], -s * turned[:, 0]
    A[:, 0, 5], A[:, 1, 5] = -s * turned[:, 1], s * turned[:, 0]
    A[:, :, 6] = turned
    return A


def onto_points(growth: Growth, before: Mask, placed: Array) -> Literal["joined", "apart", "contradiction"]:
    """Bring the part oriented since `before` onto its points' coordinates `placed` (p, 3) by earlier parts or as given.

    apart          fewer than four points in common: nothing is done
    contradiction  no similarity brings half of the common points together: nothing is done
    """
    images = growth.oriented & ~before
    mine = _points_of(growth, images)
    common = mine[np.isfinite(placed[mine]).all(axis=1)]
    if len(common) < LEAST_COMMON:
        return "apart"
    target = placed[common]
    extent = float(np.linalg.norm(np.percentile(target, 90, axis=0) - np.percentile(target, 10, axis=0)))
    try:
        s, agree = robust_similarity(growth.block.points.xyz[common], target, 0.05 * extent)
    except InputError:
        return "apart"
    if agree.sum() < max(LEAST_COMMON, 0.5 * len(common)):
        return "contradiction"
    _apply(growth, images, mine, s.scale, s.rotation, s.translation)
    return "joined"


def _points_of(growth: Growth, images: Mask) -> Array:
    """Positions of the known points that these images see."""
    seen = np.zeros(len(growth.known), bool)
    seen[growth.rays.point[images[growth.rays.image]]] = True
    return np.flatnonzero(seen & growth.known)


def block_control(growth: Growth) -> tuple[Array, Mask]:
    """Given control coordinates (p, 3) and which of them are given; the part's own coordinates stand in the block."""
    return growth.given_xyz, growth.given_control


def onto_scale(growth: Growth, before: Mask) -> bool:
    """Without control: scale from a distance between two points of the part, else the first base is 1 (False)."""
    if not growth.local:
        return False
    block = growth.block
    images = growth.oriented & ~before
    mine = _points_of(growth, images)
    inside = np.zeros(len(growth.known), bool)
    inside[mine] = True
    factors = [
        block.distances.length[d]
        / float(np.linalg.norm(block.points.xyz[block.distances.end[d]] - block.points.xyz[block.distances.start[d]]))
        for d in range(len(block.distances))
        if inside[block.distances.start[d]] and inside[block.distances.end[d]]
    ]
    if factors:
        _apply(growth, images, mine, float(np.median(factors)), np.eye(3), np.zeros(3))
    return bool(factors)


def _apply(growth: Growth, images: Mask, points: Array, scale: float, R: Array, t: Array) -> None:
    block: Block = growth.block
    centre, rotation, xyz = block.images.centre.copy(), block.images.rotation.copy(), block.points.xyz.copy()
    centre[images] = scale * centre[images] @ R.T + t
    rotation[images] = rotation[images] @ R.T
    xyz[points] = scale * xyz[points] @ R.T + t
    xyz[growth.given_control] = growth.given_xyz[growth.given_control]
    growth.block = replace(
        block, images=replace(block.images, centre=centre, rotation=rotation), points=replace(block.points, xyz=xyz)
    )


def _offset(target: Array, turned: Array, given: Mask, axis: int) -> float:
    mine = given[:, axis]
    return float((target[mine, axis] - turned[mine, axis]).mean()) if mine.any() else 0.0


def partial_similarity(source: Array, target: Array, given: Mask) -> tuple[float, Array, Array]:
    """Similarity (scale, rotation, translation) of points (n, 3) onto single given coordinates (n, 3).

    Damped Gauss-Newton from 24 rotations; what the coordinates leave open stays as it is.
    """
    quarter = [0.0, np.pi / 2, np.pi, -np.pi / 2]
    starts = [
        rotation_from_angles(np.array([o, p, k])) for o, p, k in product(quarter, [0.0, np.pi / 2, -np.pi / 2], quarter)
    ]
    middle = source.mean(axis=0)
    spread = [float(np.std(target[given[:, k], k])) if given[:, k].any() else 0.0 for k in range(3)]
    guess = max(spread) / max(float(np.std(source - middle, axis=0).max()), 1e-300) or 1.0

    def function(at: tuple[float, Array, Array]) -> tuple[Array, Array]:
        s, R, t = at
        turned = (source - middle) @ R.T
        return (s * turned + t - target)[given], _by_similarity(s, turned)[given]

    def moved(at: tuple[float, Array, Array], step: Array) -> tuple[float, Array, Array]:
        s, R, t = at
        turn = rotation_from_vector(np.clip(step[3:6], -0.5, 0.5))
        return s * float(np.clip(1 + step[6] / s, 0.3, 3.0)), turn @ R, t + step[:3]

    found: list[Minimum[tuple[float, Array, Array]]] = []
    for R in starts:
        t = np.array([_offset(target, guess * (source - middle) @ R.T, given, k) for k in range(3)])
        found.append(minimum(function, (guess, R, t), moved, steps=30, rcond=1e-9))
    s, R, t = min(found, key=lambda m: m.square_sum).values
    return s, R, t - s * R @ middle
