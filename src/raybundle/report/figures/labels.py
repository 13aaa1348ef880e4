"""Labels beside the dots of a sketch, so that none lies on a dot or on another label."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array, Mask

NEAREST, FARTHEST, RINGS, WAYS = 4.0, 90.0, 28, 24
"""Distances from a dot to the edge of its label that are tried, and directions"""
ASIDE = 5.0
"""What a radian off the wanted direction is worth in distance"""
AIR = 0.7
"""Kept free round a label"""
APART = 2.0
"""Between the places by which a line is reported"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Placed:
    """Where labels stand."""

    box: Array
    """(n, 4) left, bottom, right, top; NaN where there was no room"""
    start: Array
    """(n, 2) the dots"""
    end: Array
    """(n, 2) the nearest place of each label"""

    @property
    def fits(self) -> Mask:
        """(n,) which have found room."""
        return np.isfinite(self.box[:, 0])

    @property
    def led(self) -> Mask:
        """(n,) which are so far from their dots that a line must lead there."""
        return self.fits & (np.linalg.norm(self.end - self.start, axis=1) > 2 * NEAREST)


def placed_labels(
    dots: Array, radius: float, sizes: Array, ways: Array, lines: Array, area: Array, first: Mask | None = None
) -> Placed:
    """Places of labels, one after the other: as near to its dot and as much in its direction as there is room.

    dots    (n, 2), of a radius
    sizes   (n, 2) width and height of the labels
    ways    (n, 2) directions in which they had best stand
    lines   (k, 2, 2) that no label may lie on
    area    (2, 2) lowest and highest corner of the sketch
    first   (n,) which have the best places, and may be led to; the others stand beside their dots or nowhere
    """
    leading = np.ones(len(dots), bool) if first is None else first
    taken = [_boxes(dots, radius), _boxes(_along(lines), AIR)]
    box = np.full((len(dots), 4), np.nan)
    end = dots.copy()
    for k in np.argsort(~leading, kind="stable"):
        dot = dots[k]
        tried = _tried(dot, sizes[k], ways[k])
        inside = (tried[:, :2] >= area[0]).all(axis=1) & (tried[:, 2:] <= area[1]).all(axis=1)
        near = np.concatenate(taken)
        reach = FARTHEST + sizes[k].max()
        near = near[(near[:, :2] <= dot + reach).all(axis=1) & (near[:, 2:] >= dot - reach).all(axis=1)]
        free = inside & ~_meet(tried, near)
        ends = np.clip(dot, tried[:, :2], tried[:, 2:])
        if not leading[k]:
            free &= np.linalg.norm(ends - dot, axis=1) <= 2 * NEAREST
        boxes = box[np.isfinite(box[:, 0])]
        others = _boxes(dots[np.linalg.norm(dots - dot, axis=1) > 2 * radius], radius)
        for c in np.flatnonzero(free):
            led = _boxes(_along(np.array([[dot, ends[c]]])), 0.0)
            if not _meet(led, np.concatenate([boxes, others])).any():
                box[k], end[k] = tried[c], ends[c]
                grown = tried[c] + [-AIR, -AIR, AIR, AIR]
                taken += [grown[None], led]
                break
    return Placed(box=box, start=dots, end=end)


def _tried(dot: Array, size: Array, way: Array) -> Array:
    """(c, 4) boxes round a dot, the best first: in all directions, the nearer the better."""
    angle = 2 * np.pi * np.arange(WAYS) / WAYS
    off = np.abs(np.arctan2(np.sin(angle - np.arctan2(way[1], way[0])), np.cos(angle - np.arctan2(way[1], way[0]))))
    far = np.linspace(NEAREST, FARTHEST, RINGS)
    cost = far[:, None] + ASIDE * off[None]
    towards = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    # of a box about the origin: how far its middle is moved so that its edge is as far away as is wanted
    half = size / 2
    with np.errstate(divide="ignore"):
        depth = np.min(half / np.abs(towards), axis=1)
    middle = dot + (far[:, None, None] + depth[None, :, None]) * towards[None]
    middle = middle.reshape(-1, 2)[np.argsort(cost.ravel(), kind="stable")]
    return np.concatenate([middle - half, middle + half], axis=1)


def _boxes(places: Array, half: float) -> Array:
    return np.concatenate([places - half, places + half], axis=1)


def _along(lines: Array) -> Array:
    """(m, 2) places along lines (k, 2, 2)."""
    found = [np.zeros((0, 2))]
    for a, b in lines:
        n = max(2, int(np.linalg.norm(b - a) / APART) + 1)
        found.append(a + np.linspace(0, 1, n)[:, None] * (b - a))
    return np.concatenate(found)


def _meet(some: Array, others: Array) -> Mask:
    """(n,) which of boxes (n, 4) lie over any of others (m, 4)."""
    a, b = some.T[:, :, None], others.T
    meeting: Mask = (a[2] > b[0]) & (a[3] > b[1]) & (a[0] < b[2]) & (a[1] < b[3])
    return np.asarray(meeting.any(axis=1))
