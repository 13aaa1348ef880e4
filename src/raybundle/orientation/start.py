"""Where the assembly of a part begins: control in single images, or the best pair."""

from __future__ import annotations

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array, Mask
from raybundle.orientation.candidates import Pose, relative_all, resect_all
from raybundle.orientation.growth import Growth
from raybundle.orientation.rays import angular_residuals, common_rows, image_pairs, intersect_linear, object_rays

PAIRS = 12
"""Pairs that are tried at the start."""
COMMON = 8
"""Common points that a starting pair needs."""
TELLING = 3
"""Common points that distinguish poses: one or two may lie where the candidates' epipolar lines cross."""
JUDGES = 5
"""Oriented images that judge the candidates of another, those with the most common points."""


def start_from_control(growth: Growth, left: Mask) -> bool:
    """Orient a first pair by control in each image, with the candidates that the common points favour.

    Four coplanar points leave two poses for each image, nearly alike in unlucky views: each combination is
    judged by how well the common tie points intersect.  A single image with control starts alone.
    """
    options: dict[int, list[Pose]] = {}
    for i in np.flatnonzero(left):
        direction, xyz, control = growth.known_rays(int(i))
        if control.sum() >= 3 and len(xyz) >= 4:
            poses = resect_all(direction, xyz)
            poses = [p for p in poses if p.rms < 4 * growth.limit(int(i))]
            if poses:
                options[int(i)] = poses
    if not options:
        return _three_points(growth, left)
    best: tuple[float, int, Pose, int, Pose] | None = None
    for a, b, common in _pairs(growth, left & np.isin(np.arange(len(left)), list(options))):
        if common < COMMON:
            continue
        for pa in options[a]:
            for pb in options[b]:
                score = _agreement(growth, a, pa, b, pb)
                if score is not None and (best is None or score < best[0]):
                    best = (score, a, pa, b, pb)
    growth.begin_round()
    if best is None:
        image = max(options, key=lambda i: (growth.known_points(i), -options[i][0].rms))
        growth.set_pose(image, options[image][0])
    else:
        _, a, pa, b, pb = best
        growth.set_pose(a, pa)
        growth.set_pose(b, pb)
    growth.intersect()
    growth.adjust()
    return True


def _three_points(growth: Growth, left: Mask) -> bool:
    """An image with exactly three control points and nothing else: the pose that lies above them."""
    for i in np.flatnonzero(left):
        direction, xyz, control = growth.known_rays(int(i))
        if control.sum() == 3 and len(xyz) == 3 and len(growth.by_image[int(i)]) == 3:
            poses = resect_all(direction, xyz, keep=1e9)
            if poses:
                growth.begin_round()
                growth.set_pose(int(i), max(poses, key=lambda p: float(p.centre[2])))
                return True
    return False


def _pairs(growth: Growth, left: Mask) -> list[tuple[int, int, int]]:
    return image_pairs(growth.rays.image, growth.rays.point, left, len(growth.known))


def _common(growth: Growth, a: int, b: int) -> tuple[Array, Array]:
    return common_rows(growth.by_image[a], growth.by_image[b], growth.rays.point)


def _agreement(growth: Growth, a: int, pa: Pose, b: int, pb: Pose, of_a: Array | None = None) -> float | None:
    """Median angle between rays and intersected common points, in units of the limit; None if most lie behind.

    of_a  rays of the first image that count; None: all
    """
    ra, rb = common_rows(growth.by_image[a] if of_a is None else of_a, growth.by_image[b], growth.rays.point)
    n = len(ra)
    rotation = np.concatenate([np.broadcast_to(pa.rotation, (n, 3, 3)), np.broadcast_to(pb.rotation, (n, 3, 3))])
    centre = np.concatenate([np.broadcast_to(pa.centre, (n, 3)), np.broadcast_to(pb.centre, (n, 3))])
    direction = growth.rays.direction[np.concatenate([ra, rb])]
    index = np.tile(np.arange(n, dtype=np.int32), 2)
    xyz, _, ratio = intersect_linear(centre, object_rays(rotation, direction), index, n)
    angle = angular_residuals(rotation, centre, xyz[index], direction)
    if np.median(ratio) < 1e-3 or np.mean(angle > 0.2) > 0.2:
        return None
    return float(np.median(angle) / growth.limit(a) + 0.3 * (pa.rms / growth.limit(a) + pb.rms / growth.limit(b)))


def favoured(growth: Growth, image: int, poses: list[Pose], *, last: bool) -> Pose | None:
    """Of several poses that fit the few known points of an image, the one that its common points favour.

    poses  that fit, the best first; three points leave up to four, all of them exact, so that their residuals are
           rounding and show nothing, and four in a plane leave two that are nearly alike
    last   whether to choose where nothing shows: the highest of three points, else the one that fits best
    Common points that are not known yet must intersect with oriented images; each candidate is judged by the image
    with the most of them, and by the median over the next ones.
    """
    if len(poses) < 2:
        return poses[0] if poses else None
    mine = growth.by_image[image]
    fresh = mine[~growth.known[growth.rays.point[mine]]]
    common = growth.common_points(np.unique(growth.rays.point[fresh])) * growth.active
    partners = [(int(common[other]), other) for other in np.flatnonzero(common >= TELLING).tolist()]
    scores = np.full((len(poses), min(len(partners), JUDGES)), np.inf)
    for k, (_, other) in enumerate(sorted(partners, reverse=True)[:JUDGES]):
        images = growth.block.images
        placed = Pose(images.rotation[other], images.centre[other], 0.0, np.ones(0, bool))
        for j, pose in enumerate(poses):
            found = _agreement(growth, image, pose, other, placed, fresh)
            scores[j, k] = np.inf if found is None else found
    if scores.size and np.isfinite(scores).any():
        return poses[int(np.argmin(np.median(scores, axis=1)))]
    if not last and len(fresh):
        return None
    exact = len(poses[0].inliers) == 3
    return max(poses, key=lambda p: float(p.centre[2])) if exact else poses[0]


def start_from_pair(growth: Growth, left: Mask) -> bool:
    """Orient the best pair relative to each other, in a system of its own; a third image decides between candidates."""
    growth.use_own_system()
    ranked: list[tuple[float, int, int, Pose]] = []
    tried: dict[int, int] = {}
    count = 0
    for a, b, common in _pairs(growth, left):
        if common < COMMON or count >= PAIRS:
            break
        if tried.get(a, 0) >= 4 or tried.get(b, 0) >= 4:
            continue
        tried[a], tried[b] = tried.get(a, 0) + 1, tried.get(b, 0) + 1
        count += 1
        ra, rb = _common(growth, a, b)
        for pose in relative_all(growth.rays.direction[ra], growth.rays.direction[rb], growth.limit(a)):
            angle = _median_angle(growth, ra, rb, pose)
            inliers = int(pose.inliers.sum())
            if angle <= np.radians(2.0):
                ids = growth.block.images.ids
                growth.remarks[a] = growth.remarks[b] = phrase(
                    "not_oriented.no_base", first=ids[a], second=ids[b], angle_deg=np.degrees(angle)
                )
            if inliers >= 0.5 * common and angle > np.radians(2.0):
                quality = inliers * min(angle, np.radians(20)) / np.radians(20) / (1 + pose.rms / growth.limit(a))
                ranked.append((quality, a, b, pose))
    if not ranked:
        return False
    ranked.sort(key=lambda r: -r[0])
    start = (growth.block, growth.known.copy(), growth.oriented.copy(), growth.active.copy())
    best: tuple[float, tuple[float, int, int, Pose]] | None = None
    for option in ranked[:6]:
        growth.block, growth.known = start[0], start[1].copy()
        growth.oriented, growth.active = start[2].copy(), start[3].copy()
        _set_pair(growth, option)
        score = _third_image(growth, option)
        if best is None or score > best[0]:
            best = (score, option)
        if score > 0.9 * option[3].inliers.sum() and len(ranked) > 1 and option is ranked[0]:
            break
    assert best is not None
    growth.block, growth.known = start[0], start[1].copy()
    growth.oriented, growth.active = start[2].copy(), start[3].copy()
    _set_pair(growth, best[1])
    growth.adjust()
    return True


def _set_pair(growth: Growth, option: tuple[float, int, int, Pose]) -> None:
    _, a, b, pose = option
    growth.begin_round()
    growth.set_pose(a, Pose(np.eye(3), np.zeros(3), 0.0, pose.inliers))
    growth.set_pose(b, pose)
    growth.last_adjusted = 0
    growth.intersect()


def _median_angle(growth: Growth, ra: Array, rb: Array, pose: Pose) -> float:
    """Median intersection angle [rad] of the inliers of a pair."""
    first = growth.rays.direction[ra[pose.inliers]]
    second = growth.rays.direction[rb[pose.inliers]] @ pose.rotation
    return float(np.median(np.arccos(np.clip(np.einsum("ni,ni->n", first, second), -1, 1))))


def _third_image(growth: Growth, option: tuple[float, int, int, Pose]) -> float:
    """Points that the best third image confirms under this start."""
    from raybundle.orientation.candidates import resect_robust

    waiting = np.flatnonzero(growth.waiting())
    if not len(waiting):
        return option[0]
    scores = growth.scores()[0][waiting]
    best = 0.0
    for k in np.argsort(-scores)[:3]:
        image = int(waiting[k])
        direction, xyz, _ = growth.known_rays(image)
        if len(xyz) < 6:
            continue
        pose = resect_robust(direction, xyz, growth.limit(image))
        if pose is not None:
            best += float(pose.inliers.sum()) / (1 + pose.rms / growth.limit(image))
    return best
