"""Approximate values of a whole block: orientations and coordinates from nothing but observations and control.

Images are added to what is oriented already, those with the most and best spread known points first;
after each round the bundle adjustment (robust, without statistics) smooths what has grown, interior
orientation included, so that an unknown distortion does not bend the block.  The start is control in
single images (both poses that four coplanar points leave are kept until the common points decide), or
the best pair.  Parts that do not grow together are joined by their common points or by control, else each
stays by itself.  A large block is oriented by a skeleton of its points; the others follow at the end.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.block import Block
from raybundle.block.select import points_left, with_rows
from raybundle.errors import Text, joined_texts, phrase
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.orientation.absolute import onto_control, onto_points, onto_scale
from raybundle.orientation.candidates import Pose, resect_all, resect_robust
from raybundle.orientation.completion import Completed, complete
from raybundle.orientation.growth import OFTEN, Growth
from raybundle.orientation.pixel_axes import axes_text
from raybundle.orientation.projective.camera_constant import with_camera_constants
from raybundle.orientation.rays import rays_of
from raybundle.orientation.skeleton import skeleton
from raybundle.orientation.start import favoured, start_from_control, start_from_pair

LEAST = 6
"""Known points from which on an image without control is resected."""
MOST, FEW = 0.5, 0.2
"""Shares of its known points that an image must bring together, at first and if there is no other way."""
FEWEST = 20
"""Points that a minority must have."""
SETTLE, STILL = 4, 0.005
"""Adjustments at most at the end of a part, and relative change of the camera constant at which they end."""
AGAIN = 1.2
"""Growth of its known points after which an image that was refused is tried again."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ApproximateValues:
    """A block with orientations and coordinates filled, and what there is to say about it."""

    block: Block
    notices: tuple[Notice, ...]
    outliers: Mask
    """(m,) image observations that do not fit the others of their point by far; still in the block"""
    not_oriented: Mapping[str, str]
    """Images without orientation, and why; their observations are still in the block"""
    system: Index
    """(n,) coordinate system in which the orientation of an image stands: 0 that of what was given, others free ones"""
    scaled: frozenset[int]
    """Coordinate systems whose scale something fixed"""


@dataclass(slots=True)
class _Failures:
    reasons: dict[int, Text] = field(default_factory=dict[int, Text])


def image_values(block: Block, progress: Progress = silent) -> ApproximateValues:
    """`possible_values` of images that stand for themselves."""
    observed = np.bincount(block.observations.image, minlength=len(block.images)) > 0
    missing = observed & ~block.images.oriented
    failures = _Failures()
    block, constants = with_camera_constants(block)
    growth = _oriented(block, missing, failures, progress) if missing.any() else Growth.of(block, rays_of(block))
    limits = 2 * growth.limits(growth.oriented)
    found = complete(growth.block, growth.rays, ~growth.given, limits)
    xyz = np.where(growth.given_control, growth.given_xyz, found.xyz)
    progress("orienting", 1.0)
    ids = block.images.ids
    left = np.flatnonzero(observed & ~growth.oriented)
    return ApproximateValues(
        block=replace(growth.block, points=replace(growth.block.points, xyz=xyz)),
        notices=(*constants, *_notices(block, found)),
        outliers=found.outliers,
        not_oriented={ids[i]: failures.reasons.get(int(i), phrase("not_oriented.not_connected")) for i in left},
        system=growth.system,
        scaled=frozenset(growth.scaled),
    )


def _oriented(block: Block, missing: Mask, failures: _Failures, progress: Progress) -> Growth:
    """The block with all orientations that its skeleton, or else all of its points give."""
    chosen = skeleton(block)
    keep = chosen[block.observations.point]
    if keep.all():
        growth = Growth.of(block, rays_of(block))
        _assemble(growth, failures, progress, int(missing.sum()))
        return growth
    numbers = np.flatnonzero(points_left(block, keep))
    part = with_rows(block, keep)
    thin = Growth.of(part, rays_of(part))
    _assemble(thin, failures, progress, int(missing.sum()))
    xyz = block.points.xyz.copy()
    xyz[numbers] = thin.block.points.xyz
    growth = Growth.of(
        replace(block, cameras=thin.block.cameras, images=thin.block.images, points=replace(block.points, xyz=xyz)),
        rays_of(replace(block, cameras=thin.block.cameras)),
    )
    # what the skeleton found counts as found, not as given
    growth.given = np.all(np.isfinite(block.points.xyz), axis=1)
    growth.given_xyz, growth.given_control = block.points.xyz.copy(), block.points.is_control
    growth.calibrated, growth.remarks = thin.calibrated, thin.remarks
    growth.system, growth.scaled = thin.system, thin.scaled
    growth.known = np.zeros(len(xyz), bool)
    growth.known[numbers] = thin.known
    if (missing & ~growth.oriented).any():
        _assemble(growth, failures, progress, int(missing.sum()))
    return growth


def _notices(block: Block, found: Completed) -> tuple[Notice, ...]:
    """Points that could only be given a makeshift coordinate."""
    notices: list[Notice] = []
    for mask, code in ((found.behind, "start_behind"), (found.weak, "start_parallel")):
        names = tuple(block.points.ids[i] for i in np.flatnonzero(mask))
        if names:
            notices.append(Notice(code=code, values={"n": len(names)}, ids=names[:100]))
    return tuple(notices)


def _assemble(growth: Growth, failures: _Failures, progress: Progress, total: int) -> None:
    """Orient all missing images, part by part."""
    placed = np.where(growth.given[:, None], growth.given_xyz, np.nan)
    if growth.oriented.any():
        growth.intersect()
        _grow(growth, failures, progress, total)
        _settle(growth)
        placed[growth.known] = growth.block.points.xyz[growth.known]
    while (left := growth.waiting()).any():
        part = growth.begin_part()
        if not _begin(growth, left, failures):
            break
        _grow(growth, failures, progress, total)
        _settle(growth)
        _place(growth, part, placed, failures)
        placed[growth.known] = growth.block.points.xyz[growth.known]


def _begin(growth: Growth, left: Mask, failures: _Failures) -> bool:
    """Start a new part: from control in the images, else from the best pair."""
    if start_from_control(growth, left):
        return True
    if start_from_pair(growth, left):
        return True
    for i in np.flatnonzero(left):
        known = growth.known_points(int(i))
        reason = growth.remarks.get(int(i)) or phrase("not_oriented.no_second_image", n=known)
        failures.reasons.setdefault(int(i), reason)
    return False


def _grow(growth: Growth, failures: _Failures, progress: Progress, total: int) -> None:
    """Add images until none is left that sees enough known points.

    An image is believed that brings half of its known points together; where none of those is left, one that
    brings a clear minority together, as among the wrong matches of repeated structures.
    """
    refused: dict[int, int] = {}
    share, loose = MOST, False
    while growth.waiting().any():
        worth = _worth(growth, refused)
        if not worth:
            if loose:
                growth.adjust(final=True)
                growth.intersect()
                loose = False
            elif share > FEW and refused:
                share = FEW
            else:
                for i in refused:
                    axes = axes_text(growth, i)
                    if axes is not None:
                        failures.reasons[i] = joined_texts(failures.reasons[i], axes)
                return
            refused.clear()
            continue
        added = 0
        growth.begin_round()
        for i in worth:
            pose = _resect(growth, i, share)
            if pose is None:
                known = growth.known_points(i)
                refused[i] = known
                failures.reasons[i] = (
                    phrase("not_oriented.few_common", n=known, least=LEAST)
                    if known < LEAST
                    else phrase("not_oriented.no_pose", n=known, share=share)
                )
                continue
            growth.set_pose(i, pose)
            added += 1
        progress("orienting", 1 - len(np.flatnonzero(growth.waiting())) / max(total, 1))
        if added:
            share = MOST
            growth.intersect()
            loose = not growth.adjust()


def _settle(growth: Growth) -> None:
    """Adjust a part again while its camera constants still move."""
    for _ in range(SETTLE):
        if growth.moved < STILL:
            break
        growth.adjust(final=True)
        growth.intersect()


def _worth(growth: Growth, refused: dict[int, int]) -> list[int]:
    """Waiting images with the most and best spread known points, the best first; of those refused, with new points.

    Not too many at once: what is added rests on what has been adjusted.
    """
    scores, known = growth.scores()
    waiting = np.flatnonzero(growth.waiting() & (growth.lost < OFTEN) & (scores > 0))
    fresh = [i for i in waiting.tolist() if known[i] > AGAIN * refused.get(i, 0)]
    good = [i for i in fresh if scores[i] >= 0.6 * scores[waiting].max()] or fresh
    return sorted(good, key=lambda i: -scores[i])[: max(3, int(0.75 * growth.active.sum()))]


def _resect(growth: Growth, image: int, share: float) -> Pose | None:
    """Pose of an image on the known points, if at least this share of them fits."""
    direction, xyz, control = growth.known_rays(image)
    if len(xyz) < (3 if control.sum() >= 3 else 4):
        return None
    limit = growth.limit(image)
    if len(xyz) < LEAST:
        poses = [p for p in resect_all(direction, xyz) if p.rms < limit]
        return favoured(growth, image, poses, last=share != MOST)
    for factor, least in ((1, 4), (4, LEAST)) if share == MOST else ((1, FEWEST),):
        pose = resect_robust(direction, xyz, factor * limit)
        if pose is not None and pose.inliers.sum() >= max(least, share * len(xyz)):
            return pose
    return None


def _place(growth: Growth, before: Mask, placed: Array, failures: _Failures) -> None:
    """Bring a part that was assembled in a system of its own onto control, stations, other parts or scale."""
    mine = growth.oriented & ~before
    control = onto_control(growth, before)
    if control == "open":
        growth.system[mine] = growth.system.max() + 1
    if control == "none":
        fit = onto_points(growth, before, placed)
        if fit == "apart":
            growth.system[mine] = growth.system.max() + 1
            growth.scaled |= {int(growth.system.max())} if onto_scale(growth, before) else set()
        if fit == "contradiction":
            part = growth.oriented & ~before
            growth.give_up(part)
            for i in np.flatnonzero(part):
                failures.reasons[int(i)] = phrase("not_oriented.contradicting_part", n=int(part.sum()) - 1)
        if fit == "joined":
            growth.system[mine] = _system_of(growth, mine, before)
            growth.end_part()
            growth.known |= np.isfinite(placed).all(axis=1)
            growth.adjust(final=True)
    growth.end_part()


def _system_of(growth: Growth, images: Mask, before: Mask) -> int:
    """The coordinate system of the images oriented before that have most points in common with these."""
    rays = growth.rays
    seen = np.zeros(len(growth.known), bool)
    seen[rays.point[images[rays.image]]] = True
    rows = before[rays.image] & seen[rays.point]
    return int(np.bincount(growth.system[rays.image[rows]], minlength=1).argmax())
