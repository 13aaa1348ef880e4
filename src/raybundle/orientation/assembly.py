"""Approximate values of a whole block: orientations and coordinates from nothing but observations and control.

Images are added to what is oriented already, those with the most and best spread known points first;
after each round the bundle adjustment (robust, without statistics) smooths what has grown, interior
orientation included, so that an unknown distortion does not bend the block.  The start is control in
single images (both poses that four coplanar points leave are kept until the common points decide), or
the best pair.  Unconnected parts are assembled each by itself.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from raybundle.adjustment.result import Notice
from raybundle.block import Block
from raybundle.errors import NoOrientation
from raybundle.numerics.arrays import Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.orientation.absolute import onto_control, onto_scale
from raybundle.orientation.candidates import Pose, resect_all, resect_robust
from raybundle.orientation.growth import Growth
from raybundle.orientation.rays import rays_of
from raybundle.orientation.start import start_from_control, start_from_pair

LEAST = 6
"""Known points from which on an image without control is resected."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ApproximateValues:
    """A block with every orientation and coordinate filled, and what there is to say about it."""

    block: Block
    notices: tuple[Notice, ...]


@dataclass(slots=True)
class _Failures:
    reasons: dict[int, str] = field(default_factory=dict[int, str])


def approximate_values(block: Block, progress: Progress = silent) -> ApproximateValues:
    """Fill the missing exterior orientations and object coordinates of a block.

    What is given is used and kept (it is refined by the adjustment, not here).
    Raises NoOrientation, which names each image that could not be oriented, and why.
    """
    growth = Growth.of(block, rays_of(block))
    observed = np.bincount(block.observations.image, minlength=len(block.images)) > 0
    missing = observed & ~block.images.oriented
    notices: list[Notice] = []
    if missing.any():
        failures = _assemble(growth, missing, progress)
        left = [int(i) for i in np.flatnonzero(observed & ~growth.oriented)]
        if left:
            lines = [f"  image {block.images.ids[i]}: {failures.reasons.get(i, 'not connected')}" for i in left[:20]]
            more = "" if len(left) <= 20 else f"\n  and {len(left) - 20} more"
            raise NoOrientation(
                f"no approximate orientation for {len(left)} of {int(observed.sum())} images:\n"
                + "\n".join(lines) + more
                + "\n  Measure more common points, or give approximate values in images.csv.",
                images={block.images.ids[i]: failures.reasons.get(i, "not connected") for i in left},
            )  # fmt: skip
    growth.intersect(everything=True)
    growth.restore_control()
    notices += growth.notices()
    progress("orienting", 1.0)
    return ApproximateValues(block=growth.block, notices=tuple(notices))


def _assemble(growth: Growth, missing: Mask, progress: Progress) -> _Failures:
    """Orient all missing images, part by part."""
    failures = _Failures()
    total = int(missing.sum())
    grown_any = bool(growth.oriented.any())
    if grown_any:
        growth.intersect()
        _grow(growth, failures, progress, total)
    while (left := growth.waiting()).any():
        part = growth.begin_part()
        if not _begin(growth, left, failures):
            break
        _grow(growth, failures, progress, total)
        _place(growth, part)
    return failures


def _begin(growth: Growth, left: Mask, failures: _Failures) -> bool:
    """Start a new part: from control in the images, else from the best pair."""
    if start_from_control(growth, left):
        return True
    if start_from_pair(growth, left):
        return True
    for i in np.flatnonzero(left):
        known = growth.known_points(int(i))
        reason = growth.remarks.get(int(i), f"{known} known points, no second image with enough common points")
        failures.reasons.setdefault(int(i), reason)
    return False


def _grow(growth: Growth, failures: _Failures, progress: Progress, total: int) -> None:
    """Add images until none is left that sees enough known points."""
    refused: dict[int, int] = {}
    while True:
        waiting = np.flatnonzero(growth.waiting())
        scores = np.array([growth.score(int(i)) for i in waiting])
        worth = [
            int(i)
            for i, s in zip(waiting, scores, strict=True)
            if s > 0 and s >= 0.6 * scores.max() and refused.get(int(i)) != growth.known_points(int(i))
        ]
        if not worth:
            worth = [
                int(i)
                for i, s in zip(waiting, scores, strict=True)
                if s > 0 and refused.get(int(i)) != growth.known_points(int(i))
            ]
        if not worth:
            return
        # not too many at once: what is added rests on what has been adjusted
        worth.sort(key=lambda i: -growth.score(i))
        worth = worth[: max(3, int(0.75 * growth.active.sum()))]
        added = 0
        for i in worth:
            pose = _resect(growth, i)
            if pose is None:
                known = growth.known_points(i)
                refused[i] = known
                failures.reasons[i] = (
                    f"{known} points in common with the rest, {LEAST} needed"
                    if known < LEAST
                    else f"{known} points in common with the rest, but no pose that fits half of them"
                )
                continue
            growth.set_pose(i, pose)
            added += 1
        progress("orienting", 1 - len(np.flatnonzero(growth.waiting())) / max(total, 1))
        if added:
            growth.intersect()
            growth.adjust()


def _resect(growth: Growth, image: int) -> Pose | None:
    direction, xyz, control = growth.known_rays(image)
    if len(xyz) < (3 if control.sum() >= 3 else 4):
        return None
    limit = growth.limit(image)
    if len(xyz) < LEAST:
        poses = resect_all(direction, xyz)
        return poses[0] if poses and poses[0].rms < limit else None
    pose = resect_robust(direction, xyz, limit)
    if pose is None or pose.inliers.sum() < max(4, 0.5 * len(xyz)):
        wider = resect_robust(direction, xyz, 4 * limit)
        pose = wider if wider is not None and wider.inliers.sum() >= max(6, 0.5 * len(xyz)) else None
    return pose


def _place(growth: Growth, part: Mask) -> None:
    """Bring a part that was assembled in a system of its own onto control, stations or scale."""
    if not onto_control(growth, part):
        onto_scale(growth, part)
    growth.end_part()
