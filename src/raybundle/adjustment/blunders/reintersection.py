"""Points that left while gross errors bent the block, intersected anew from the images as they are without these.

Rays then end behind the camera or diverge, and residuals of right ones are as large as that of the wrong one.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import numpy as np

from raybundle.adjustment.blunders.separability import FEWEST
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import Block
from raybundle.block.rejection import Rejection, RejectionKind, Rejections
from raybundle.block.rigs import without_rigs
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.statistics import axis_tests

WHOLE = {
    RejectionKind.BEHIND_CAMERA, RejectionKind.RAYS_DIVERGE, RejectionKind.SINGLE_RAY,
    RejectionKind.BLUNDER_NOT_LOCATED,
}  # fmt: skip
"""Kinds of rejections that say of a point, not which of its rays is wrong"""
MOST_PAIRS = 200
"""Pairs of rays of a point that are intersected: all of 20 rays"""
LARGEST = 1e6
"""Test value of what has no place in the image, as behind the camera"""


def reintersected(result: Adjustment, block: Block, skip: set[int]) -> tuple[Block, Rejections, set[int]] | None:
    """The block and its rejections with such points where most of their rays meet; None where none do.

    result  adjusted, without gross errors among the rays that took part
    skip    points that are not tried again

    Points of which no more rays take part than were rejected are tried as well: gross errors that agree, as names
    exchanged in several images, win where they come first.  Such a point is left out where no majority meets and as
    many of the rejected rays meet in another place.

    Of each two rays the intersection with most others within the critical value counts (Fischler and Bolles 1981); the
    other rays are blunders.  Three rays have to meet, and more than half of them; or both of two.  No other ray may
    meet them in the place of one of these: which one is wrong could not be located.
    """
    o, reasons = block.observations, list(result.image_observations.rejected)
    lost = np.array([r is not None and r.kind in WHOLE for r in reasons], bool)
    held: Mask = np.any(block.points.is_control, axis=1) | np.isin(np.arange(len(block.points)), list(skip))
    scene: Mask = np.array([c.is_scene for c in block.cameras], bool)[block.images.camera[o.image]]
    doubted = _outnumbered(result) & ~held & ~block.points_named
    points = np.setdiff1d(np.union1d(o.point[lost & ~scene], np.flatnonzero(doubted)), np.flatnonzero(held))
    if not len(points):
        return None
    given = np.array([r is not None and r.kind is RejectionKind.GIVEN for r in reasons], bool)
    usable = np.flatnonzero(block.images.oriented[o.image] & ~scene & ~given & np.isin(o.point, points))
    usable = usable[np.argsort(o.point[usable], kind="stable")]
    ends = np.searchsorted(o.point[usable], points, side="right")
    found: set[int] = set()
    alone = without_rigs(block)
    xyz = block.points.xyz.copy()
    for p, rows in zip(points.tolist(), np.split(usable, ends[:-1]), strict=True):
        place, meet = _meeting(result, alone, rows)
        if int(meet.sum()) < min(FEWEST, len(rows)) or 2 * int(meet.sum()) <= len(rows):
            out = rows[[reasons[i] is not None for i in rows]]
            if doubted[p] and int(_meeting(result, alone, out)[1].sum()) >= len(rows) - len(out):
                found.add(p)
                for i in rows.tolist():
                    reasons[i] = reasons[i] or Rejection(kind=RejectionKind.BLUNDER_NOT_LOCATED)
            continue
        if doubted[p] and all(
            (reasons[i] is None) == fits for i, fits in zip(rows.tolist(), meet.tolist(), strict=True)
        ):
            continue
        found.add(p)
        xyz[p] = place
        for i, fits, sizes in zip(rows.tolist(), meet.tolist(), _sizes(result, alone, rows, place), strict=True):
            reasons[i] = None if fits else Rejection(
                kind=RejectionKind.BLUNDER, tau=float(sizes.max()), limit=result.critical_tau,
                axis="xy"[int(sizes.argmax())],
            )  # fmt: skip
    if not found:
        return None
    return replace(block, points=replace(block.points, xyz=xyz)), tuple(reasons), found


def _outnumbered(result: Adjustment) -> Mask:
    """Points (p,) of which no more image points take part than were rejected as blunders."""
    o, reasons, n = result.given.observations, result.image_observations.rejected, len(result.given.points)
    out = np.array([r is not None and r.kind is RejectionKind.BLUNDER for r in reasons], bool)
    kept = np.bincount(o.point[result.image_observations.used], minlength=n)
    return (kept > 1) & (np.bincount(o.point[out], minlength=n) >= kept)


def _meeting(result: Adjustment, block: Block, rows: Index) -> tuple[Array, Array]:
    """The place (3,) where most of these rays of one point meet, and which of them (k,); of a block without rigs."""
    o, none = block.observations, (np.full(3, np.nan), np.zeros(len(rows), bool))
    if len(rows) < 2:
        return none
    centre, direction = block.images.centre[o.image[rows]], directions(block, rows)
    P = np.eye(3) - direction[:, :, None] * direction[:, None, :]
    right = np.einsum("nij,nj->ni", P, centre)

    def fitting(inside: Index) -> tuple[Array, Array]:
        try:
            place = np.linalg.solve(P[inside].sum(axis=0), right[inside].sum(axis=0))
        except np.linalg.LinAlgError:
            return none
        ahead = np.einsum("ni,ni->n", place - centre, direction) > 0
        return place, ahead & (_sizes(result, block, rows, place) < result.critical_tau).all(axis=1)

    best = none
    for pair in list(combinations(range(len(rows)), 2))[:MOST_PAIRS]:
        found = fitting(np.array(pair))
        if found[1].sum() > best[1].sum():
            best = found
    if best[1].sum() < 2:
        return best
    more = fitting(np.flatnonzero(best[1]))
    best = more if more[1].sum() >= best[1].sum() else best
    inside, outside = np.flatnonzero(best[1]), np.flatnonzero(~best[1])
    for i in inside.tolist():
        for j in outside.tolist():
            instead = np.array([*inside[inside != i], j])
            if fitting(instead)[1][instead].all():
                return none
    return best


def _sizes(result: Adjustment, block: Block, rows: Index, place: Array) -> Array:
    """Test values (k, 2) of rays by their distances from a place (3,) of their point, none above `LARGEST`."""
    with np.errstate(all="ignore"):
        v = residuals_px(block, rows, np.tile(place, (len(rows), 1)))
        size = np.abs(axis_tests(v, block.observations.cov_px2[rows])) / max(result.sigma0, 1.0)
    return np.minimum(np.nan_to_num(size, nan=np.inf), LARGEST)


def directions(block: Block, rows: Index) -> Array:
    """Unit rays (k, 3) of image observations in object space."""
    o, found = block.observations, np.zeros((len(rows), 3))
    for i in np.unique(o.image[rows]).tolist():
        mine = np.flatnonzero(o.image[rows] == i)
        camera = block.camera_of(i)
        rays = camera.sensor.ray(camera.image_from_pixel(o.xy_px[rows[mine]]).T, camera.parameters)
        found[mine] = rays.T @ block.images.rotation[i]
    return found
