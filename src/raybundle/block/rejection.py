"""Why an image observation takes no part: a kind and its figures."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING

import numpy as np

from raybundle.errors import Text, phrase

if TYPE_CHECKING:
    from raybundle.block.block import Block
    from raybundle.numerics.arrays import Mask


class RejectionKind(StrEnum):
    """Kinds of rejections; the values are what programs read (`rejections` of result.json)."""

    BLUNDER = "blunder"
    BLUNDER_NOT_LOCATED = "blunder_not_located"
    """One ray of the point is wrong, and which one cannot be determined: all leave."""
    BEHIND_CAMERA = "behind_camera"
    RAYS_DIVERGE = "rays_diverge"
    """The best place for its point is beyond infinity."""
    SINGLE_RAY = "single_ray"
    """The others of its point were rejected."""
    RESIDUAL = "residual"
    """By a robust estimate on the way to the adjustment."""
    GIVEN = "given"
    """By whoever made the observations, or by the caller."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Rejection:
    """The reason for one image observation."""

    kind: RejectionKind
    tau: float = math.nan
    """Test value that was found, without unit; NaN where none was tested."""
    limit: float = math.nan
    """Its critical value."""
    axis: str = ""
    """Image coordinate of the test value: x or y."""

    @property
    def text(self) -> Text:
        """The reason, as the report shows it."""
        if math.isnan(self.tau):
            return phrase("rejection.reason", kind=self.kind.value, axis="none", tau=0.0, limit=0.0)
        return phrase("rejection.reason", kind=self.kind.value, axis=self.axis, tau=self.tau, limit=self.limit)

    def __str__(self) -> str:
        """The kind and its figures, as files have them in every language."""
        kind = self.kind.value.replace("_", " ")
        return kind if math.isnan(self.tau) else f"{kind}: tau {self.tau:.2f} > {self.limit:.2f} in {self.axis}"


Rejections = tuple[Rejection | None, ...]
"""(m,) parallel to the image observations; None: it takes part."""


FOUND_WRONG = {
    RejectionKind.BLUNDER, RejectionKind.BLUNDER_NOT_LOCATED, RejectionKind.RESIDUAL, RejectionKind.GIVEN,
}  # fmt: skip
"""Kinds that a block keeps; the others follow from its geometry each time."""


def known_wrong(block: Block) -> Mask:
    """(m,) image observations that the block gives as rejected."""
    o = block.observations
    found = np.zeros(len(o), bool)
    if not block.rejected:
        return found
    image = {name: k for k, name in enumerate(block.images.ids)}
    point = {name: k for k, name in enumerate(block.points.ids)}
    n = len(point)
    pairs = [image[i] * n + point[p] for i, p in block.rejected if i in image and p in point]
    return np.isin(o.image.astype(np.int64) * n + o.point, np.array(pairs, np.int64))


def given_rejections(block: Block) -> Rejections:
    """Why image observations take no part from the outset."""
    if not block.rejected:
        return (None,) * len(block.observations)
    given = Rejection(kind=RejectionKind.GIVEN)
    return tuple(given if wrong else None for wrong in known_wrong(block).tolist())


def found_wrong(block: Block, rejections: Rejections) -> tuple[tuple[str, str], ...]:
    """Image and point of the observations that a block is to keep as rejected."""
    o, images, points = block.observations, block.images.ids, block.points.ids
    return tuple(
        (images[int(o.image[k])], points[int(o.point[k])])
        for k, r in enumerate(rejections)
        if r is not None and r.kind in FOUND_WRONG
    )


def counts(rejections: Iterable[Rejection | None]) -> dict[RejectionKind, int]:
    """Number of rejections of each kind, the most frequent first."""
    found: dict[RejectionKind, int] = {}
    for r in rejections:
        if r is not None:
            found[r.kind] = found.get(r.kind, 0) + 1
    return dict(sorted(found.items(), key=lambda pair: -pair[1]))


def words(rejections: Rejections) -> tuple[str, ...]:
    """Empty, or the reason: the column `rejected` of observations.csv."""
    if rejections.count(None) == len(rejections):
        return ("",) * len(rejections)
    return tuple("" if r is None else str(r) for r in rejections)
