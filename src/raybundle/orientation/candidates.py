"""Candidate poses of one image: closed form and robust, ambiguities kept."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.rotation import nearest_rotation
from raybundle.orientation.rays import FLIP, angular_residuals, refine_pose

FIELD = 0.15
"""Rays with less than this cosine to the axis are left out of the solvers that work on a plane."""
WIDE = 0.35
"""Where a tenth of the rays has less than this cosine, the solvers work on bearings instead."""


@dataclass(slots=True)
class Pose:
    """An exterior orientation and how well it fits."""

    rotation: Array
    centre: Array
    rms: float
    """Root mean square angle between rays and points [rad]."""
    inliers: Mask


def plane_points(direction: Array) -> Array:
    """Points (n, 2) on the plane at unit distance, y down, of rays (n, 3) in front of it."""
    d = direction * FLIP
    return d[:, :2] / d[:, 2:]


def pose_from_solver(pose: Any) -> tuple[Array, Array]:
    """Rotation (object axes to our image axes) and projection centre of a minimal solver's pose."""
    R = np.asarray(pose.R, float)
    return nearest_rotation(FLIP[:, None] * R), -R.T @ np.asarray(pose.t, float)


def is_wide(direction: Array) -> bool:
    """Whether rays (n, 3) fill a field too wide for image coordinates on a plane."""
    return bool(np.mean(-direction[:, 2] < WIDE) > 0.1)


def draws_needed(share: float, size: int) -> int:
    """Draws of `size` after which one without outliers has come with 99.99 %, if a `share` are inliers."""
    clean = min(max(share, 1e-3) ** size, 1 - 1e-9)
    return int(np.ceil(np.log(1e-4) / np.log(1 - clean)))


def resect_all(direction: Array, xyz: Array, *, keep: float = 4.0) -> list[Pose]:
    """All poses that fit rays (n, 3) to known points (n, 3): the best, and those nearly as good.

    P3P (Persson and Nordberg 2018) over triples, the most promising solutions refined over all points; four
    coplanar points leave two, which in unlucky views differ little.  Poses with up to `keep` times the smallest
    rms stay, or 0.02 rad above it: with an unknown distortion the right one need not be the best.
    """
    n = len(xyz)
    rng = np.random.default_rng(0)
    some = np.arange(n) if n <= 60 else rng.choice(n, 60, replace=False)
    found: list[Pose] = []
    for R, C in _p3p_solutions(direction[some], xyz[some], rng):
        pose = _refined(R, C, direction[some], xyz[some])
        if pose is not None and not any(_same(pose, other, xyz) for other in found):
            found.append(pose)
    if n > len(some):
        again = (_refined(p.rotation, p.centre, direction, xyz) for p in found)
        found = [p for p in again if p is not None]
    found.sort(key=lambda p: p.rms)
    return [p for p in found if p.rms <= max(keep * found[0].rms, found[0].rms + 0.02)][:6]


def _p3p_solutions(direction: Array, xyz: Array, rng: np.random.Generator) -> list[tuple[Array, Array]]:
    """Poses from triples of points, those that fit all points best first; alike ones only once."""
    import poselib  # noqa: PLC0415

    triples = list(combinations(range(len(xyz)), 3))
    if len(triples) > 30:
        triples = [tuple(t) for t in (rng.choice(len(xyz), 3, replace=False) for _ in range(30))]
    ranked: list[Pose] = []
    for triple in triples:
        t = list(triple)
        for solution in poselib.p3p(direction[t] * FLIP, xyz[t]):
            if np.isfinite(solution.R).all() and np.isfinite(solution.t).all():
                R, C = pose_from_solver(solution)
                angle = _angles(R, C, direction, xyz)
                ranked.append(Pose(R, C, float(np.sqrt(np.mean(angle**2))), np.ones(len(xyz), bool)))
    ranked.sort(key=lambda p: p.rms)
    distinct: list[Pose] = []
    for pose in ranked:
        if not any(_same(pose, other, xyz, 20.0) for other in distinct):
            distinct.append(pose)
    return [(p.rotation, p.centre) for p in distinct[:16]]


def _angles(R: Array, C: Array, direction: Array, xyz: Array) -> Array:
    return angular_residuals(np.broadcast_to(R, (len(xyz), 3, 3)), np.broadcast_to(C, xyz.shape), xyz, direction)


def _refined(R: Array, C: Array, direction: Array, xyz: Array) -> Pose | None:
    try:
        R, C, angle = refine_pose(R, C, xyz, direction)
    except np.linalg.LinAlgError:
        return None
    if not np.isfinite(angle).all() or (angle > 1.0).any():
        return None
    return Pose(R, C, float(np.sqrt(np.mean(angle**2))), np.ones(len(xyz), bool))


def _same(a: Pose, b: Pose, xyz: Array, factor: float = 1.0) -> bool:
    distance = float(np.mean(np.linalg.norm(xyz - a.centre, axis=1)))
    turn = np.arccos(np.clip((np.trace(a.rotation @ b.rotation.T) - 1) / 2, -1, 1))
    return turn < 1e-3 * factor and float(np.linalg.norm(a.centre - b.centre)) < 2e-3 * factor * distance


def resect_robust(direction: Array, xyz: Array, limit: float) -> Pose | None:
    """Pose of an image from rays (n, 3) and known points (n, 3) with outliers (LO-RANSAC); None if there is none.

    limit  largest angle of an inlier [rad]
    """
    if len(xyz) < 4:
        return None
    start = _wide_start(direction, xyz, limit) if is_wide(direction) else _plane_start(direction, xyz, limit)
    if start is None:
        return None
    R, C, inliers = start
    for _ in range(2):
        if inliers.sum() < 4:
            return None
        R, C, _ = refine_pose(R, C, xyz[inliers], direction[inliers], scale=limit / 2)
        angle = _angles(R, C, direction, xyz)
        inliers = angle < limit
    if inliers.sum() < 4:
        return None
    return Pose(R, C, float(np.sqrt(np.mean(angle[inliers] ** 2))), inliers)


def _plane_start(direction: Array, xyz: Array, limit: float) -> tuple[Array, Array, Mask] | None:
    """Rotation, centre and inliers from image points on the plane at unit distance."""
    import poselib  # noqa: PLC0415

    usable = -direction[:, 2] > FIELD
    if usable.sum() < 4:
        return None
    camera = {"model": "SIMPLE_PINHOLE", "width": 1, "height": 1, "params": [1.0, 0.0, 0.0]}
    options = {"max_reproj_error": limit, "min_iterations": 50, "max_iterations": 2000, "seed": 1}
    result, info = poselib.estimate_absolute_pose(
        np.ascontiguousarray(plane_points(direction[usable])), np.ascontiguousarray(xyz[usable]), camera, options, {}
    )
    inliers = np.zeros(len(xyz), bool)
    inliers[np.flatnonzero(usable)[np.asarray(info["inliers"], bool)]] = True
    return *pose_from_solver(result), inliers


def _wide_start(
    direction: Array, xyz: Array, limit: float, *, draws: int = 300
) -> tuple[Array, Array, Mask] | None:  # fmt: skip
    """Rotation, centre and inliers from rays in any direction: fisheyes and panoramas (RANSAC)."""
    import poselib  # noqa: PLC0415

    rng = np.random.default_rng(1)
    n = len(xyz)
    some = np.arange(n) if n <= 500 else rng.choice(n, 500, replace=False)
    d, X = direction[some], xyz[some]
    best: tuple[Array, Array] | None = None
    lowest, needed, draw = np.inf, draws, 0
    while draw < needed:
        draw += 1
        t = rng.choice(len(some), 3, replace=False)
        for solution in poselib.p3p(d[t] * FLIP, X[t]):
            if not (np.isfinite(solution.R).all() and np.isfinite(solution.t).all()):
                continue
            R, C = pose_from_solver(solution)
            angle = _angles(R, C, d, X)
            cost = float(np.mean(np.minimum(angle, limit) ** 2))
            if cost < lowest:
                lowest, best = cost, (R, C)
                needed = min(draws, max(30, draw, draws_needed(float(np.mean(angle < limit)), 3)))
    if best is None:
        return None
    return *best, _angles(*best, direction, xyz) < limit
