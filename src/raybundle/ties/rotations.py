"""Pairs between two parts of the photographs that agree in how the parts are turned against each other.

A repeated facade gives pairs far beyond chance that are wrong.  Two pairs that are right agree in the rotation; pairs
that contradict them must be fewer by half (cycle consistency: Zach, Klopschitz and Pollefeys 2010).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.block import Block
from raybundle.matching.verify import FEWEST, limit_px
from raybundle.numerics.arrays import Array, Mask
from raybundle.orientation.candidates import relative_all
from raybundle.orientation.rays import camera_rays

AGREEING_DEG = 4.0
"""Difference of rotations by two pairs that agree: relative orientations of some 30 matches are within 2 degrees."""
PAIRS = 2
"""That agree, where none is strong by itself."""
DECISIVE = 0.5
"""Share of the matches of the agreeing pairs that others may have which agree among themselves."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Common:
    """Matches of two photographs."""

    first: int
    second: int
    strong: bool
    """whether the pair is believed by itself"""
    xy: tuple[Array, Array]
    """(k, 2) each [px]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Turn:
    """A rotation between parts, by one of the relative orientations of a pair."""

    pair: int
    ends: tuple[int, int]
    rotation: Array
    inliers: Mask
    """(k,) of its matches"""


def limit(block: Block, image: int) -> float:
    """Angle [rad] up to which a ray fits."""
    camera = block.camera_of(image)
    size = camera.width_px, camera.height_px
    middle = np.array(size) / 2
    ray, beside = camera_rays(camera, np.array([middle, middle + np.array([limit_px(size), 0.0])]))
    return float(np.linalg.norm(ray - beside))


def fitting(block: Block, c: Common) -> Mask:
    """(k,) which matches of two oriented photographs fit their epipolar geometry."""
    images = block.images
    ends = zip((c.first, c.second), c.xy, strict=True)
    one, other = (camera_rays(block.camera_of(i), xy) @ images.rotation[i] for i, xy in ends)
    normal = np.cross(images.centre[c.second] - images.centre[c.first], other)
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    return np.abs((one * normal).sum(axis=1)) < 2 * limit(block, c.first)


def agreeing(block: Block, other: Block, pairs: Sequence[Common]) -> dict[int, Mask] | None:
    """The pairs that agree in the rotation, with the matches (k,) that fit; None where none is decisive.

    pairs   of a photograph of the block and one of the other, which may be a photograph without orientation
    """
    turns = [t for k, c in enumerate(pairs) for t in _turns(block, other, k, c)]
    best = _largest(turns)
    if not best:
        return None
    if len({t.ends for t in best.values()}) < PAIRS and not any(pairs[k].strong for k in best):
        return None
    ends = {t.ends for t in best.values()}
    rival = _largest([t for t in turns if t.ends not in ends])
    if _count(rival) > DECISIVE * _count(best):
        return None
    return {k: t.inliers for k, t in best.items()}


def _turns(block: Block, other: Block, number: int, c: Common) -> list[_Turn]:
    """The rotations of the other part against the block by one pair."""
    ends, xy = (c.first, c.second), c.xy
    if not block.images.oriented[c.first]:
        ends, xy = ends[::-1], xy[::-1]
    i, j = ends
    first, second = (camera_rays(block.camera_of(k), places) for k, places in zip(ends, xy, strict=True))
    own = other.images.rotation[j] if other.images.oriented[j] else np.eye(3)
    poses = relative_all(first, second, limit(block, i))
    return [
        _Turn(
            pair=number,
            ends=(c.first, c.second),
            rotation=own.T @ p.rotation @ block.images.rotation[i],
            inliers=p.inliers,
        )
        for p in poses
        if p.inliers.sum() >= FEWEST
    ]


def _largest(turns: Sequence[_Turn]) -> dict[int, _Turn]:
    """Of the rotations that agree with one of them, one for each pair, those with most matches."""
    best, most = dict[int, _Turn](), 0
    for t in turns:
        near = dict[int, _Turn]()
        for u in turns:
            angle = np.degrees(np.arccos(np.clip((np.trace(t.rotation @ u.rotation.T) - 1) / 2, -1, 1)))
            if angle < AGREEING_DEG and (u.pair not in near or u.inliers.sum() > near[u.pair].inliers.sum()):
                near[u.pair] = u
        if _count(near) > most:
            best, most = near, _count(near)
    return best


def _count(turns: Mapping[int, _Turn]) -> int:
    """Matches of all pairs; where methods gave several for two photographs, of the best one."""
    most = dict[tuple[int, int], int]()
    for t in turns.values():
        most[t.ends] = max(most.get(t.ends, 0), int(t.inliers.sum()))
    return sum(most.values())
