"""Which photographs measure the surface together: for each reference its sources, and the pairs that are of no use.

Tie points show it all before a pixel is read: what two photographs both see, at which angle, at which scales.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.block import Block
from raybundle.errors import phrase
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rows import rows_of_each

MOST_SOURCES = 4
"""Sources of a reference: with more the depth gets little better, and the time grows in proportion."""
FEWEST_POINTS = 12
"""Common points below which nothing can be stated of a pair: angle and scale are their medians."""
FLATTEST_DEG = 1.5
"""Median angle between the rays of common points below which a pair is refused: at 1.5 degrees a depth is 38 times as
uncertain as a place across the ray."""
BEST_RAD, WIDTH = 0.35, 0.5
"""Angle at which two photographs measure a surface best, and the logarithm's standard deviation about it: smaller
angles say little of the depth, at larger ones the windows look unlike."""
LARGEST_SCALE = 2.0
"""Ratio of the sizes of a pixel on the object above which one photograph has not the detail of the other."""
WORTH = 0.02
"""What a further source has to add to the information of a reference, as a share."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PairOfImages:
    """What two photographs have in common."""

    reference: int
    source: int
    points: int
    """Tie points that both see."""
    angle_deg: float
    """Median angle between their rays; NaN without common points."""
    scale: float
    """Median ratio of the sizes of a pixel on the object, source by reference."""

    @property
    def refusal(self) -> str:
        """Why depths are not measured with this pair; empty where they are."""
        if self.angle_deg < FLATTEST_DEG:
            return phrase("depths.small_angle", angle_deg=self.angle_deg, least_deg=FLATTEST_DEG)
        if not 1 / LARGEST_SCALE <= self.scale <= LARGEST_SCALE:
            return phrase("depths.scales_differ", ratio=max(self.scale, 1 / self.scale), limit=LARGEST_SCALE)
        return ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Sources:
    """A reference, the sources that measure its depths, and what was refused."""

    reference: int
    sources: tuple[int, ...]
    """The best first."""
    pairs: tuple[PairOfImages, ...]
    """All photographs with enough points in common, in the order of the block's images."""
    seen: float
    """Share of the reference's tie points that at least one source sees at a useful angle."""

    @property
    def refused(self) -> tuple[PairOfImages, ...]:
        """Pairs with enough points in common that are of no use."""
        return tuple(p for p in self.pairs if p.refusal)


def sources_of_each(block: Block, *, most: int = MOST_SOURCES, among: Sequence[int] | None = None) -> list[Sources]:
    """For each image of an oriented block the sources with which its depths are measured; images (n,), in their order.

    most   sources of a reference
    among  images that can be sources; None: all

    The first source is the one that shows most of the depths at the reference's tie points, each further one that which
    adds most to what is known: so sources on all sides of a reference go before several on one.  Limits:
    places without tie points, and what hides the object from a source.
    """
    o = block.observations
    placed: Mask = np.asarray(np.isfinite(block.points.xyz).all(axis=1))
    known = placed[o.point] & block.images.oriented[o.image]
    if among is not None:
        known &= np.isin(o.image, list(among))
    rows, point = rows_of_each(np.where(known, o.image, -1), len(block.images)), np.asarray(o.point)
    images_of = rows_of_each(np.where(known, o.point, -1), len(block.points))
    mine = [np.unique(point[r]) for r in rows]
    return [_sources(block, k, mine, images_of, most) for k in range(len(block.images))]


def _sources(block: Block, k: int, mine: list[Index], images_of: list[Index], most: int) -> Sources:
    """The sources of one reference."""
    at = mine[k]
    others = np.asarray(block.observations.image)[np.concatenate([images_of[p] for p in at.tolist()] or [at])]
    counts = np.bincount(others, minlength=len(block.images))
    counts[k] = 0
    pairs, gains = list[PairOfImages](), dict[int, Array]()
    for j in np.flatnonzero(counts >= FEWEST_POINTS).tolist():
        pair, gain = _pair(block, k, j, at, mine[j])
        pairs.append(pair)
        if not pair.refusal:
            gains[j] = gain
    chosen, total = list[int](), np.zeros(len(at))
    while gains and len(chosen) < most:
        added = {j: float(np.log1p(g / (1 + total)).sum()) for j, g in gains.items()}
        best = max(added, key=lambda j: (added[j], -j))
        if chosen and added[best] < WORTH * float(np.log1p(total).sum()):
            break
        chosen.append(best)
        total = total + gains.pop(best)
    return Sources(
        reference=k, sources=tuple(chosen), pairs=tuple(pairs), seen=float((total > 0.1).mean()) if len(at) else 0.0
    )


def _pair(block: Block, k: int, j: int, at: Index, theirs: Index) -> tuple[PairOfImages, Array]:
    """Two images, and what the second shows of the depths (n,) of the first's points, in units of the best pair.

    Of a scene by its nominal viewpoint, from which its middle is seen as the scene does: what angles and sizes differ
    by over its width is less than a choice of pairs has to know.
    """
    common, places, _ = np.intersect1d(at, theirs, assume_unique=True, return_indices=True)
    xyz, centre = block.points.xyz[common], block.images.centre
    a, b = xyz - centre[k], xyz - centre[j]
    far, near = np.linalg.norm(a, axis=1), np.linalg.norm(b, axis=1)
    angle = np.arccos(np.clip(np.einsum("ni,ni->n", a, b) / (far * near), -1.0, 1.0))
    finer = near / far * (_angle_of_pixel(block, j) / _angle_of_pixel(block, k))
    pair = PairOfImages(
        reference=k, source=j, points=len(common), angle_deg=float(np.degrees(np.median(angle))),
        scale=float(np.median(finer)),
    )  # fmt: skip
    gain = np.zeros(len(at))
    with np.errstate(divide="ignore"):
        likely = np.exp(-(np.log(angle / BEST_RAD) ** 2) / (2 * WIDTH**2))
    gain[places] = likely * np.minimum(finer, 1 / finer)
    return pair, gain


def _angle_of_pixel(block: Block, image: int) -> float:
    """The angle [rad] under which a pixel of an image is seen, in its middle."""
    camera = block.camera_of(image)
    return float(np.mean(camera.pixel_mm)) / abs(camera.sensor.camera_constant(camera.parameters))
