"""Candidate orientations of a second image relative to a first, refined; ambiguities kept."""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.rotation import nearest_rotation, rotation_from_vector
from raybundle.orientation.candidates import FIELD, Pose, draws_needed, is_wide, plane_points, pose_from_solver
from raybundle.orientation.rays import FLIP, angular_residuals, intersect_linear, object_rays

LEAST = 6
"""Common points that a relative orientation needs: five determine it, the sixth checks."""


def relative_all(first: Array, second: Array, limit: float) -> list[Pose]:
    """Orientations of a second image relative to a first (at the origin, R = I), base of length 1; best first.

    first, second  (n, 3) rays of common points
    limit          largest angle of an inlier [rad]

    Essential matrix (Nistér 2004, LO-RANSAC; over bearings where the field is wide) and the decomposition of a
    homography (Malis and Vargas 2007), so that a plane is no special case.  Each candidate is refined on its
    epipolar angles; those stay that explain nearly as many points in front of both images.
    """
    if len(first) < LEAST:
        return []
    wide = is_wide(first) or is_wide(second)
    starts = _wide_starts(first, second, limit) if wide else _plane_starts(first, second, limit)
    poses: list[Pose] = []
    for R, C in starts:
        pose = _refined(R, C, first, second, limit)
        if pose is not None and not any(_same(pose, p) for p in poses):
            poses.append(pose)
    poses.sort(key=lambda p: (-int(p.inliers.sum()), p.rms))
    return [p for p in poses if p.inliers.sum() >= 0.7 * poses[0].inliers.sum()]


def _same(a: Pose, b: Pose) -> bool:
    turn = np.arccos(np.clip((np.trace(a.rotation @ b.rotation.T) - 1) / 2, -1, 1))
    return bool(turn < 5e-3 and a.centre @ b.centre > 1 - 1e-3)


def _plane_starts(first: Array, second: Array, limit: float) -> list[tuple[Array, Array]]:
    """Rotations and bases from image points on the plane at unit distance."""
    import poselib  # noqa: PLC0415

    usable = (-first[:, 2] > FIELD) & (-second[:, 2] > FIELD)
    if usable.sum() < LEAST:
        return []
    a, b = (np.ascontiguousarray(plane_points(d[usable])) for d in (first, second))
    camera = {"model": "SIMPLE_PINHOLE", "width": 1, "height": 1, "params": [1.0, 0.0, 0.0]}
    options = {
        "max_epipolar_error": limit,
        "max_reproj_error": limit,
        "min_iterations": 100,
        "max_iterations": 3000,
        "seed": 1,
    }
    result, _ = poselib.estimate_relative_pose(a, b, camera, camera, options, {})
    R, C = pose_from_solver(result)
    starts = [(R * FLIP, FLIP * C)]  # the object system is the first image's own
    H, info = poselib.estimate_homography(a, b, options, {})
    if np.mean(np.asarray(info["inliers"], float)) > 0.5:
        for pose in poselib.motion_from_homography(np.asarray(H, float))[0]:
            R, t = np.asarray(pose.R, float), np.asarray(pose.t, float)
            turned = nearest_rotation(FLIP[:, None] * R * FLIP)
            starts += [(turned, sign * FLIP * (R.T @ t)) for sign in (-1.0, 1.0)]
    return starts


def _wide_starts(first: Array, second: Array, limit: float, *, draws: int = 400) -> list[tuple[Array, Array]]:
    """Rotations and bases from five rays in any direction: fisheyes and panoramas (RANSAC)."""
    import poselib  # noqa: PLC0415

    rng = np.random.default_rng(1)
    n = len(first)
    some = np.arange(n) if n <= 500 else rng.choice(n, 500, replace=False)
    a, b = first[some], second[some]
    found: list[tuple[float, Array, Array]] = []
    lowest, needed, draw = np.inf, draws, 0
    while draw < needed:
        draw += 1
        five = rng.choice(len(some), 5, replace=False)
        for solution in poselib.relpose_5pt(a[five] * FLIP, b[five] * FLIP):
            R, C = pose_from_solver(solution)
            length = float(np.linalg.norm(C))
            if not np.isfinite(R).all() or not length > 0:
                continue
            R, C = R * FLIP, FLIP * C / length
            v, _ = epipolar_angles(R, C, a, b)
            cost = float(np.mean(np.minimum(v * v, limit * limit)))
            found.append((cost, R, C))
            if cost < lowest:
                lowest = cost
                needed = min(draws, max(30, draw, draws_needed(float(np.mean(np.abs(v) < limit)), 5)))
    found.sort(key=lambda f: f[0])
    return [(R, C) for _, R, C in found[:6]]


def epipolar_angles(R: Array, C: Array, first: Array, second: Array) -> tuple[Array, Array]:
    """Signed misclosures (n,) [rad] of the coplanarity condition, and their derivatives (n, 5).

    The triple product of base and both rays over the length of its gradient (Sampson 1982): about the angle by
    which the two rays together miss a common plane with the base.  Parameters: turn of the second image (3), and the
    base in its two tangent directions.
    """
    turned = second @ R
    normal = np.cross(C, first)
    triple = np.einsum("ni,ni->n", normal, turned)
    by_first = np.cross(turned, C)
    by_second = normal @ R.T
    gradient2 = np.sum(np.cross(by_first, first) ** 2, axis=1) + np.sum(np.cross(by_second, second) ** 2, axis=1)
    length = np.sqrt(np.maximum(gradient2, 1e-24))
    J = np.empty((len(first), 5))
    J[:, :3] = np.cross(by_second, second) / length[:, None]
    J[:, 3:] = np.cross(first, turned) @ _tangent(C).T / length[:, None]
    return triple / length, J


def _tangent(C: Array) -> Array:
    """Two unit vectors (2, 3) at right angles to C and to each other."""
    e = np.cross(C, np.eye(3)[int(np.argmin(np.abs(C)))])
    e = e / np.linalg.norm(e)
    return np.stack([e, np.cross(C, e)])


def _refined(R: Array, C: Array, first: Array, second: Array, limit: float) -> Pose | None:
    """A start improved on its inliers (Gauss-Newton, large misclosures weighted down)."""
    length = float(np.linalg.norm(C))
    if not np.isfinite(length) or length < 1e-9:
        return None
    best = evaluate_pair(R, C / length, first, second, limit)
    for _ in range(2):
        if best is None or best.inliers.sum() < LEAST:
            return best
        turned, base = _refine(best.rotation, best.centre, first[best.inliers], second[best.inliers], limit)
        new = evaluate_pair(turned, base, first, second, limit)
        if new is None or (new.inliers.sum(), -new.rms) <= (best.inliers.sum(), -best.rms):
            break
        best = new
    return best


def _refine(R: Array, C: Array, first: Array, second: Array, limit: float) -> tuple[Array, Array]:
    for _ in range(10):
        v, J = epipolar_angles(R, C, first, second)
        w = np.minimum(1.0, limit / 2 / np.maximum(np.abs(v), 1e-300))
        N = (J * w[:, None]).T @ J
        d = np.sqrt(np.maximum(np.diagonal(N), 1e-300))
        step = -np.linalg.solve(N / np.outer(d, d) + 1e-9 * np.eye(5), J.T @ (w * v) / d) / d
        step *= min(1.0, 0.2 / max(float(np.linalg.norm(step)), 1e-300))
        R = rotation_from_vector(step[:3]) @ R
        C = C + step[3:] @ _tangent(C)
        C = C / np.linalg.norm(C)
        if np.linalg.norm(step) < 1e-12:
            break
    return R, C


def evaluate_pair(R: Array, C: Array, first: Array, second: Array, limit: float) -> Pose | None:
    """How well a relative orientation explains common rays: intersection angles, both sides in front."""
    worst = _worst_angle(R, C, first, second)
    inliers: Mask = worst < limit
    if inliers.sum() < 5:
        return None
    return Pose(R, C, float(np.sqrt(np.mean(worst[inliers] ** 2))), inliers)


def _worst_angle(R: Array, C: Array, first: Array, second: Array) -> Array:
    n = len(first)
    rotation = np.concatenate([np.broadcast_to(np.eye(3), (n, 3, 3)), np.broadcast_to(R, (n, 3, 3))])
    centre = np.concatenate([np.zeros((n, 3)), np.broadcast_to(C, (n, 3))])
    direction = np.concatenate([first, second])
    index = np.tile(np.arange(n, dtype=np.int32), 2)
    xyz, _, _ = intersect_linear(centre, object_rays(rotation, direction), index, n)
    angle = angular_residuals(rotation, centre, xyz[index], direction)
    return np.maximum(angle[:n], angle[n:])
