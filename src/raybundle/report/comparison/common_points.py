"""Rows that two results have in common: images by name, object points by name and, if nobody named them, by place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.block import Block
from raybundle.block.points import NEAR_PX, is_automatic
from raybundle.numerics.arrays import Array, Index, Mask


@dataclass(frozen=True, slots=True, kw_only=True)
class Common:
    """Rows with the same id in two tables."""

    ids: tuple[str, ...]
    first: Index
    second: Index
    only_first: tuple[str, ...]
    only_second: tuple[str, ...]
    namesakes: tuple[str, ...] = ()
    """points with the same automatic name that were measured at other places: not of the common ones"""


def common_rows(first: Sequence[str], second: Sequence[str], others: frozenset[str] = frozenset()) -> Common:
    """The ids that both tables have, in the order of the first, and those that only one has.

    others  ids that mean something else in each of the two
    """
    at = {i: k for k, i in enumerate(second)}
    mine = [(i, k, at[i]) for k, i in enumerate(first) if i in at and i not in others]
    known = {i for i, _, _ in mine} | others
    return Common(
        ids=tuple(i for i, _, _ in mine),
        first=np.array([k for _, k, _ in mine], np.int32),
        second=np.array([k for _, _, k in mine], np.int32),
        only_first=tuple(i for i in first if i not in known),
        only_second=tuple(i for i in second if i not in known),
        namesakes=tuple(i for i in first if i in others),
    )


def common_points(first: Sequence[str], second: Sequence[str], blocks: tuple[Block, Block]) -> Common:
    """The points of two tables that are the same: by name where someone named them, else by their image points too.

    blocks  the two blocks with the image points

    A point with an automatic name (a running number) is common where it lies at the same place (`NEAR_PX`) in most of
    the photographs that show it in both, at least in one.
    """
    doubtful = frozenset(i for i in set(first) & set(second) if is_automatic(i))
    if not doubtful:
        return common_rows(first, second)
    return common_rows(first, second, doubtful - _same_places(*blocks))


def _same_places(first: Block, second: Block) -> frozenset[str]:
    """Names of points that lie at the same place in most of the photographs that show them in both blocks."""
    a, xy_a, names = _keyed(first, first, second)
    b, xy_b, _ = _keyed(second, first, second)
    _, i, j = np.intersect1d(a, b, return_indices=True)
    near: Mask = np.linalg.norm(xy_a[i] - xy_b[j], axis=1) <= NEAR_PX
    point = a[i] % max(len(names), 1)
    shown, same = (np.bincount(p, minlength=len(names)) for p in (point, point[near]))
    return frozenset(names[k] for k in np.flatnonzero((2 * same > shown) & (shown > 0)).tolist())


def _keyed(block: Block, first: Block, second: Block) -> tuple[Index, Array, tuple[str, ...]]:
    """A number (k,) of photograph and point for each image observation of names that both have, and its place."""
    images = {n: k for k, n in enumerate(sorted(set(first.images.ids) & set(second.images.ids)))}
    names = tuple(sorted(set(first.points.ids) & set(second.points.ids)))
    points = {n: k for k, n in enumerate(names)}
    o = block.observations
    image = np.array([images.get(n, -1) for n in block.images.ids], np.int64)[o.image]
    point = np.array([points.get(n, -1) for n in block.points.ids], np.int64)[o.point]
    both = (image >= 0) & (point >= 0)
    return (image * len(names) + point)[both], o.xy_px[both], names
