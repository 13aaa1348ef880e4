"""Poses from unit bearings in any direction: LO-RANSAC for images whose rays leave the plane in front of the camera.

Fisheyes beyond 150 degrees and rotating panoramas have rays beside and behind the axis, which no plane of unit
distance holds.  Samples are solved by P3P and by the five-point method on bearings, hypotheses are counted by angles,
and the best are refined by least squares of angles.  The random numbers are seeded: same input, same pose.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import nearest_rotation, rotation_from_vector
from raybundle.orientation.rays import refine_pose

WIDE = np.cos(np.radians(75.0))
"""Rays with a smaller cosine to the axis make an image a wide one."""
BATCH = 24
"""Samples that are solved and counted together."""
COUNTED = 600
"""Points on which hypotheses are counted; the refinement uses all."""
SURE = 0.9999
"""Probability that a sample without outliers was drawn, at which the search ends."""


def is_wide(direction: Array) -> bool:
    """Whether some rays (n, 3) are so far off the axis that a plane in front of the camera does not hold them."""
    return bool((-direction[:, 2] < WIDE).any())


def resect_bearings(direction: Array, xyz: Array, limit: float) -> tuple[Array, Array] | None:
    """Rotation and projection centre from rays (n, 3) to known points (n, 3) with outliers; None if there is none.

    limit  largest angle of an inlier [rad]
    P3P (Persson and Nordberg 2018) within LO-RANSAC (Chum, Matas and Kittler 2003).
    """
    import poselib

    counted = _counted(len(xyz))
    d, X = direction[counted], xyz[counted]
    best_score, best, needed, drawn = 0.0, None, 3000.0, 0
    for samples in _samples(len(xyz), 3, 3000):
        poses = [p for s in samples for p in poselib.p3p(direction[s], xyz[s])]
        drawn += len(samples)
        if poses:
            R, t = np.stack([p.R for p in poses]), np.stack([p.t for p in poses])
            score = _truncated(_view_angles(R, t, d, X), limit)
            k = int(np.argmax(score))
            if score[k] > best_score:
                refined = _refined_pose(nearest_rotation(R[k]), -R[k].T @ t[k], direction, xyz, limit)
                again = _truncated(_view_angles(refined[0][None], (-refined[0] @ refined[1])[None], d, X), limit)[0]
                if again >= score[k]:
                    best_score, best = float(again), refined
                else:
                    best_score, best = float(score[k]), (nearest_rotation(R[k]), -R[k].T @ t[k])
                needed = _draws(best_score / len(counted), 3)
        if drawn >= max(needed, BATCH):
            break
    return best


def relative_bearings(first: Array, second: Array, limit: float, *, keep: int = 4) -> list[tuple[Array, Array]]:
    """Rotations and base directions of a second image relative to the first (at the origin, R = I), best first.

    first, second  (n, 3) rays of common points; limit  largest angle of an inlier [rad]
    Five points (Nistér 2004) within LO-RANSAC; up to `keep` different solutions stay, since a plane leaves two.
    """
    import poselib

    n = len(first)
    counted = _counted(n)
    a, b = first[counted], second[counted]
    found: list[tuple[float, Array, Array]] = []
    best, needed, drawn = 0.0, 2000.0, 0
    for samples in _samples(n, 5, 2000):
        poses = [p for s in samples for p in poselib.relpose_5pt(first[s], second[s])]
        drawn += len(samples)
        if poses:
            R = np.stack([p.R for p in poses])
            C = -np.einsum("hji,hj->hi", R, np.stack([p.t for p in poses]))
            C = C / np.maximum(np.linalg.norm(C, axis=1), 1e-300)[:, None]
            score = _truncated(_epipolar_angles(R, C, a, b), limit)
            for k in np.argsort(-score)[:3]:
                if score[k] < 0.7 * best or score[k] < 5 or _known(found, R[k], C[k]):
                    continue
                refined = refine_pair(nearest_rotation(R[k]), C[k], first, second, limit)
                again = float(_truncated(_epipolar_angles(refined[0][None], refined[1][None], a, b), limit)[0])
                if not _known(found, *refined):
                    found.append((again, *refined))
                best = max(best, again)
            found = sorted(found, key=lambda f: -f[0])[: 3 * keep]
            needed = _draws(best / len(counted), 5)
        if drawn >= max(needed, 2 * BATCH):
            break
    return [(R, C) for score, R, C in found if score >= 0.7 * best][:keep]


def refine_pair(R: Array, C: Array, first: Array, second: Array, limit: float) -> tuple[Array, Array]:
    """Least squares of the angles between rays and epipolar planes; rotation and unit base of the second image.

    Coplanarity, divided by its standard deviation for errors of equal size in both rays (Sampson 1982, on the
    sphere); residuals beyond half the limit are weighted down (Huber), those beyond the limit left out.
    """
    for _ in range(8):
        y = second @ R
        normal, turned = np.cross(C, first), np.cross(y, C)
        size = np.sqrt(np.maximum(np.sum(normal**2, axis=1) + np.sum(turned**2, axis=1), 1e-12))
        e = np.einsum("ni,ni->n", normal, y) / size
        by_turn = -np.cross(y, normal) @ R.T / size[:, None]
        helper = np.eye(3)[np.argmin(np.abs(C))]
        u = np.cross(C, helper)
        u /= np.linalg.norm(u)
        tangent = np.stack([u, np.cross(C, u)], axis=1)
        J = np.concatenate([by_turn, np.cross(first, y) @ tangent / size[:, None]], axis=1)
        w = np.where(np.abs(e) < limit, np.minimum(1.0, 0.5 * limit / np.maximum(np.abs(e), 1e-300)), 0.0)
        N = (J * w[:, None]).T @ J
        scale = np.sqrt(np.maximum(np.diagonal(N), 1e-300))
        step = -np.linalg.solve(N / np.outer(scale, scale) + 1e-9 * np.eye(5), (J * w[:, None]).T @ e / scale) / scale
        if not np.isfinite(step).all() or np.linalg.norm(step) > 1.0:
            break
        R = rotation_from_vector(step[:3]) @ R
        C = C + tangent @ step[3:]
        C = C / np.linalg.norm(C)
        if np.linalg.norm(step) < 1e-9:
            break
    return R, C


def _refined_pose(R: Array, C: Array, direction: Array, xyz: Array, limit: float) -> tuple[Array, Array]:
    """One pose over its inliers, twice: the second time with those that the first brought."""
    for _ in range(2):
        inliers = _view_angles(R[None], (-R @ C)[None], direction, xyz)[0] < limit
        if inliers.sum() < 4:
            break
        try:
            R, C, _ = refine_pose(R, C, xyz[inliers], direction[inliers], scale=limit / 2, steps=5)
        except np.linalg.LinAlgError:
            break
    return R, C


def _counted(n: int) -> Array:
    """Positions of the points on which hypotheses are counted."""
    return np.arange(n) if n <= COUNTED else np.sort(np.random.default_rng(2).choice(n, COUNTED, replace=False))


def _samples(n: int, size: int, most: int) -> Iterator[Array]:
    """Batches (BATCH, size) of random positions without repetition within a row."""
    rng = np.random.default_rng(1)
    for _ in range(0, most, BATCH):
        rows = rng.integers(0, n, (BATCH, size))
        single = np.all(np.diff(np.sort(rows, axis=1), axis=1) > 0, axis=1)
        yield rows[single]


def _draws(share: float, size: int) -> float:
    """Samples needed until one without outliers is found almost surely (Fischler and Bolles 1981)."""
    good = min(max(share, 1e-3) ** size, 1 - 1e-12)
    return float(np.log(1 - SURE) / np.log(1 - good))


def _truncated(angle: Array, limit: float) -> Array:
    """(h,) sum over the points (h, n) of 1 - (angle / limit)^2, none below 0 (Torr and Zisserman 2000)."""
    return np.maximum(0.0, 1 - (angle / limit) ** 2).sum(axis=1)


def _view_angles(R: Array, t: Array, direction: Array, xyz: Array) -> Array:
    """(h, n) angles [rad] of hypotheses R (h, 3, 3), t (h, 3) between rays (n, 3) and the directions to points."""
    P = np.einsum("hij,nj->hni", R, xyz) + t[:, None, :]
    away = np.linalg.norm(P - np.einsum("hni,ni->hn", P, direction)[..., None] * direction, axis=2)
    return np.arctan2(away, np.einsum("hni,ni->hn", P, direction))


def _epipolar_angles(R: Array, C: Array, first: Array, second: Array) -> Array:
    """(h, n) angles [rad] by which rays of two images miss each other; pi where they meet behind one of them."""
    y = np.einsum("ni,hij->hnj", second, R)
    normal, turned = np.cross(C[:, None, :], first), np.cross(y, C[:, None, :])
    e = np.einsum("hni,hni->hn", normal, y)
    size = np.sqrt(np.maximum(np.sum(normal**2, axis=2) + np.sum(turned**2, axis=2), 1e-24))
    # distances along the rays by the sine rule in the triangle of the base: positive on both
    plane = np.cross(first, y)
    front = (np.sum(normal * plane, axis=2) > 0) & (np.sum(turned * plane, axis=2) < 0)
    front |= np.sum(plane**2, axis=2) < 1e-6
    return np.where(front, np.abs(e) / size, np.pi)


def _known(found: list[tuple[float, Array, Array]], R: Array, C: Array) -> bool:
    """Whether a relative orientation is among those found, within half a degree."""
    return any(bool(np.trace(R @ r.T) > 1 + 2 * np.cos(0.01) and C @ c > np.cos(0.02)) for _, r, c in found)
