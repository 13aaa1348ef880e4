"""Candidate poses of one image and of image pairs: closed form and robust, ambiguities kept."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.rotation import nearest_rotation
from raybundle.orientation.bearings import is_wide, relative_bearings, resect_bearings
from raybundle.orientation.rays import FLIP, angular_residuals, intersect_linear, object_rays, refine_pose

PLANE = {"model": "SIMPLE_PINHOLE", "width": 1, "height": 1, "params": [1.0, 0.0, 0.0]}
"""The camera of the plane at unit distance."""


REFINED = 16
"""Solutions of triples that are refined, the best ones."""


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


def resect_all(direction: Array, xyz: Array, *, keep: float = 4.0) -> list[Pose]:
    """All poses that fit rays (n, 3) to known points (n, 3): the best, and those nearly as good.

    P3P (Persson and Nordberg 2018) over triples, each solution refined over all points; four coplanar points
    leave two, which in unlucky views differ little.  Poses with up to `keep` times the smallest rms stay.
    """
    import poselib

    n = len(xyz)
    rng = np.random.default_rng(0)
    triples = list(combinations(range(n), 3))
    if len(triples) > 30:
        triples = [tuple(t) for t in (rng.choice(n, 3, replace=False) for _ in range(30))]
    starts: list[tuple[float, Array, Array]] = []
    for triple in triples:
        t = list(triple)
        for solution in poselib.p3p(direction[t] * FLIP, xyz[t]):
            if np.isfinite(solution.R).all() and np.isfinite(solution.t).all():
                R, C = pose_from_solver(solution)
                starts.append((float(np.median(_pose_angles(R, C, xyz, direction))), R, C))
    found: list[Pose] = []
    tried = 0
    for _, R0, C0 in sorted(starts, key=lambda s: s[0]):
        if tried == REFINED:
            break
        if any(_same(Pose(R0, C0, 0.0, other.inliers), other, xyz, 3.0) for other in found):
            continue
        tried += 1
        try:
            R, C, angle = refine_pose(R0, C0, xyz, direction)
        except np.linalg.LinAlgError:
            continue
        if not np.isfinite(angle).all() or (angle > 1.0).any():
            continue
        pose = Pose(R, C, float(np.sqrt(np.mean(angle**2))), np.ones(n, bool))
        if not any(_same(pose, other, xyz) for other in found):
            found.append(pose)
    found.sort(key=lambda p: p.rms)
    return [p for p in found if p.rms <= max(keep * found[0].rms, found[0].rms + 0.02)][:6]


def _same(a: Pose, b: Pose, xyz: Array, factor: float = 1.0) -> bool:
    distance = float(np.mean(np.linalg.norm(xyz - a.centre, axis=1)))
    turn = np.arccos(np.clip((np.trace(a.rotation @ b.rotation.T) - 1) / 2, -1, 1))
    return turn < factor * 1e-3 and float(np.linalg.norm(a.centre - b.centre)) < factor * 2e-3 * distance


def resect_robust(direction: Array, xyz: Array, limit: float) -> Pose | None:
    """Pose of an image from rays (n, 3) and known points (n, 3) with outliers (LO-RANSAC); None if there is none.

    limit  largest angle of an inlier [rad]
    Wide images are solved on bearings, others on the plane.
    """
    if len(xyz) < 4:
        return None
    start = resect_bearings(direction, xyz, limit) if is_wide(direction) else _resect_plane(direction, xyz, limit)
    if start is None:
        return None
    R, C = start
    inliers = _pose_angles(R, C, xyz, direction) < 1.5 * limit
    if inliers.sum() < 4:
        return None
    R, C, _ = refine_pose(R, C, xyz[inliers], direction[inliers], scale=limit / 2)
    angle = _pose_angles(R, C, xyz, direction)
    inliers = angle < limit
    if inliers.sum() < 4:
        return None
    return Pose(R, C, float(np.sqrt(np.mean(angle[inliers] ** 2))), inliers)


def _pose_angles(R: Array, C: Array, xyz: Array, direction: Array) -> Array:
    return angular_residuals(np.broadcast_to(R, (len(xyz), 3, 3)), np.broadcast_to(C, xyz.shape), xyz, direction)


def _resect_plane(direction: Array, xyz: Array, limit: float) -> tuple[Array, Array] | None:
    import poselib

    options = {"max_reproj_error": limit, "min_iterations": 50, "max_iterations": 2000, "seed": 1}
    result, info = poselib.estimate_absolute_pose(
        np.ascontiguousarray(plane_points(direction)), np.ascontiguousarray(xyz), PLANE, options, {}
    )
    return pose_from_solver(result) if np.sum(info["inliers"]) >= 4 else None


def relative_all(first: Array, second: Array, limit: float) -> list[Pose]:
    """Orientations of a second image relative to a first (at the origin, R = I), base of length 1; best first.

    first, second  (n, 3) rays of common points
    limit          largest angle of an inlier [rad]
    Essential matrix (Nistér 2004, LO-RANSAC) and the decomposition of a homography (Malis and Vargas 2007), so
    that a plane is no special case; on bearings where one of the images is a wide one.  Candidates stay that
    explain nearly as many points in front of both images.
    """
    if len(first) < 6:
        return []
    wide = is_wide(first) or is_wide(second)
    starts = relative_bearings(first, second, limit) if wide else _relative_plane(first, second, limit)
    poses: list[Pose] = []
    for R, C in starts:
        length = float(np.linalg.norm(C))
        if not np.isfinite(length) or length < 1e-9:
            continue
        pose = evaluate_pair(R, C / length, first, second, limit)
        if pose is not None and not any(
            np.arccos(np.clip((np.trace(p.rotation @ pose.rotation.T) - 1) / 2, -1, 1)) < 5e-3
            and float(p.centre @ pose.centre) > 1 - 1e-3
            for p in poses
        ):
            poses.append(pose)
    poses.sort(key=lambda p: (-int(p.inliers.sum()), p.rms))
    return [p for p in poses if p.inliers.sum() >= 0.7 * poses[0].inliers.sum()]


def _relative_plane(first: Array, second: Array, limit: float) -> list[tuple[Array, Array]]:
    import poselib

    a, b = (np.ascontiguousarray(plane_points(d)) for d in (first, second))
    options = {
        "max_epipolar_error": limit,
        "max_reproj_error": limit,
        "min_iterations": 100,
        "max_iterations": 3000,
        "seed": 1,
    }
    result, _ = poselib.estimate_relative_pose(a, b, PLANE, PLANE, options, {})
    R, C = pose_from_solver(result)
    starts = [(R * FLIP, FLIP * C)]  # the object system is the first image's own
    H, info = poselib.estimate_homography(a, b, options, {})
    if np.mean(np.asarray(info["inliers"], float)) > 0.5:
        starts += _from_homography(np.asarray(H, float))
    return starts


def evaluate_pair(R: Array, C: Array, first: Array, second: Array, limit: float) -> Pose | None:
    """How well a relative orientation explains common rays: intersection angles, both sides in front."""
    n = len(first)
    rotation = np.concatenate([np.broadcast_to(np.eye(3), (n, 3, 3)), np.broadcast_to(R, (n, 3, 3))])
    centre = np.concatenate([np.zeros((n, 3)), np.broadcast_to(C, (n, 3))])
    direction = np.concatenate([first, second])
    index = np.tile(np.arange(n, dtype=np.int32), 2)
    xyz, _, _ = intersect_linear(centre, object_rays(rotation, direction), index, n)
    angle = angular_residuals(rotation, centre, xyz[index], direction)
    worst = np.maximum(angle[:n], angle[n:])
    inliers = worst < limit
    if inliers.sum() < 5:
        return None
    return Pose(R, C, float(np.sqrt(np.mean(worst[inliers] ** 2))), inliers)


def _from_homography(H: Array) -> list[tuple[Array, Array]]:
    """Rotations and centres of the second image from x2 ~ H x1 on normalised planes."""
    import poselib

    found: list[tuple[Array, Array]] = []
    solutions = poselib.motion_from_homography(H)
    for pose in solutions[0]:
        R = np.asarray(pose.R, float)
        for sign in (1.0, -1.0):
            t = sign * np.asarray(pose.t, float)
            found.append((nearest_rotation(FLIP[:, None] * R * FLIP), FLIP * (-R.T @ t)))
    return found
