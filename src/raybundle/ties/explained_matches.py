"""Photographs with verified matches that the adjusted orientation does not explain: of another camera, or misplaced.

Pairs are verified by a fundamental matrix, which fits any camera.  Matches that fit it, but not the adjusted
orientation and camera, are left out one by one on the way to the adjustment, and what stays of the photograph looks
good.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.block import Block
from raybundle.block.frames import camera_from_file
from raybundle.cameras.conversions import camera_rays, interiors
from raybundle.errors import InputError
from raybundle.matching.verify import STRONG, VerifiedPair, limit_px
from raybundle.numerics.arrays import Array, Index

UNEXPLAINED = 0.6
"""Share of the matches of its best pair that fit the orientation, below which a photograph is reported."""
OTHERS = 0.9
"""The same share in the median of all photographs, below which nothing is reported: no camera fits then."""
KEPT = 256
"""Photographs of which features are kept while pairs are compared: they are read from the project"""
FEWEST = 4
"""Photographs with such pairs: the others show what is usual."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PairFits:
    """Pairs of oriented images of a block, and how many of their verified matches fit its orientation."""

    ends: Index
    """(k, 2) images of the block"""
    matches: Index
    fitting: Index


def pair_fits(block: Block, names: Sequence[str], xy_px: Sequence[Array], pairs: Sequence[VerifiedPair]) -> PairFits:
    """How many matches of each pair fit an adjusted block; no pairs where a camera has no single projection centre.

    names  files of the photographs
    xy_px  their features
    A match fits where its rays miss each other by no more than the verification allows, `verify.limit_px`.
    """
    position = {f: k for k, f in enumerate(block.images.file)}
    rows, oriented = [position.get(n, -1) for n in names], block.images.oriented
    places, (cameras, of_image) = lru_cache(KEPT)(xy_px.__getitem__), interiors(block)
    found: list[tuple[int, int, int, int]] = []
    for p in pairs:
        i, j = rows[p.first], rows[p.second]
        if i < 0 or j < 0 or not (oriented[i] and oriented[j]):
            continue
        if p.geometry not in {"general", "planar"} or not len(p.matches):
            continue
        base = block.images.centre[j] - block.images.centre[i]
        rays: list[Array] = []
        for k, photo, column in ((i, p.first, 0), (j, p.second, 1)):
            camera, pixels = cameras[of_image[k]], places(photo)[p.matches[:, column]]
            if k in block.images.frames:
                pixels = camera_from_file(pixels, camera, block.images.frames[k])
            try:
                rays.append(camera_rays(camera, pixels.T).T @ block.images.rotation[k])
            except InputError:
                return PairFits(ends=np.zeros((0, 2), int), matches=np.zeros(0, int), fitting=np.zeros(0, int))
        fits = np.ones(len(p.matches), bool)
        for one, other, k in ((*rays, j), (*rays[::-1], i)):
            normal = np.cross(one, base)
            length = np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
            camera = cameras[of_image[k]]
            c_px = camera.values[camera.sensor.scale_symbol] / camera.pixel_mm[0]
            off = np.abs(np.sum(normal * other, axis=1)) / length * c_px
            fits &= off < limit_px((camera.width_px, camera.height_px))
        found.append((i, j, len(p.matches), int(fits.sum())))
    table = np.array(found, int).reshape(-1, 4)
    return PairFits(ends=table[:, :2], matches=table[:, 2], fitting=table[:, 3])


def best_shares(fits: PairFits, images: int) -> Array:
    """(images,) of each image, the largest share of a strong pair's matches that fit; NaN: no such pair."""
    best, strong = np.full(images, np.nan), fits.matches >= STRONG
    share = fits.fitting[strong] / fits.matches[strong]
    for column in (0, 1):
        np.fmax.at(best, fits.ends[strong, column], share)
    return best


def unexplained_notice(block: Block, fits: PairFits) -> tuple[Notice, ...]:
    """The fault that names these photographs; none where there are none, or too few to compare with."""
    best = best_shares(fits, len(block.images))
    known = np.isfinite(best)
    if known.sum() < FEWEST or float(np.median(best[known])) < OTHERS:
        return ()
    low = [block.images.ids[k] for k in np.flatnonzero(known & (best < UNEXPLAINED))]
    if not low:
        return ()
    values = {
        "n": len(low), "names": low, "share": float(np.nanmin(best)), "median": float(np.median(best[known])),
        "limit": UNEXPLAINED,
    }  # fmt: skip
    return (Notice(code="image_contradicts.matches", ids=tuple(low[:100]), values=values, measured=Severity.FAULT),)
