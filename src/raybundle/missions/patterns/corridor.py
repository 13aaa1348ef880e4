"""Lines beside each other along a road, a river, a power line."""

from __future__ import annotations

import math

import numpy as np

from raybundle.errors import InputError
from raybundle.missions.patterns.base import NADIR, Line, Pattern, Wish, register, whole
from raybundle.numerics.arrays import Array

SHARPEST = math.radians(120)
"""Turn of a corridor beyond which lines beside it would run away from it."""


def lines(outline: Array, wish: Wish) -> list[Line]:
    """Parallel lines along a way of straight parts, as many as the width needs, each over the whole way.

    raises  InputError where the way turns back on itself, or bends more tightly than the lines beside it can follow
    """
    base, spacing = wish.steps(0.0)
    margin = spacing / 2 if wish.margin is None else wish.margin
    count = whole((wish.width + 2 * margin) / spacing, "lines")
    found: list[Line] = []
    for k in range(count):
        xy = beside(outline, (k - (count - 1) / 2) * spacing)
        xy = _whole_bases(xy, base, margin)
        xy = xy[::-1] if k % 2 else xy
        found.append(
            Line(
                name=f"line {k + 1}",
                group="line",
                xy=xy,
                above=np.full(len(xy), wish.distance),
                heading=_headings(xy),
                pitch=np.full(len(xy), NADIR),
                base=base,
            )
        )
    return found


def beside(way: Array, offset: float) -> Array:
    """A way (n, 2) moved to its right by an offset [m]; its corners stay on the bisectors."""
    parts = np.diff(way, axis=0)
    length = np.linalg.norm(parts, axis=1)
    ahead = parts / length[:, None]
    right = np.stack([ahead[:, 1], -ahead[:, 0]], axis=1)
    moved = [way[0] + offset * right[0]]
    for k in range(1, len(parts)):
        turn = float(np.arccos(np.clip(ahead[k - 1] @ ahead[k], -1, 1)))
        if turn > SHARPEST:
            raise InputError(
                "corridor.sharp_turn", turn_deg=math.degrees(turn), corner=k + 1, most_deg=math.degrees(SHARPEST)
            )
        moved.append(way[k] + offset * (right[k - 1] + right[k]) / (1 + right[k - 1] @ right[k]))
    moved.append(way[-1] + offset * right[-1])
    result = np.array(moved)
    back = np.flatnonzero(np.sum(np.diff(result, axis=0) * ahead, axis=1) <= 0)
    if len(back):
        k = int(back[0])
        raise InputError("corridor.tight_bend", corner=k + 1, offset_m=abs(offset), length_m=length[k])
    return result


def _whole_bases(xy: Array, base: float, margin: float) -> Array:
    """A line lengthened straight on at both ends by the margin, and to a whole number of bases."""
    length = float(np.linalg.norm(np.diff(xy, axis=0), axis=1).sum())
    wanted = math.ceil((length + 2 * margin) / base - 1e-9) * base
    first, last = xy[0] - xy[1], xy[-1] - xy[-2]
    more = (wanted - length) / 2
    result = xy.copy()
    result[0] = xy[0] + more * first / np.linalg.norm(first)
    result[-1] = xy[-1] + more * last / np.linalg.norm(last)
    return result


def _headings(xy: Array) -> Array:
    """Azimuths (n,) of the parts of a way that begin at each point; the last has that of the part before it."""
    d = np.diff(xy, axis=0)
    azimuth = np.arctan2(d[:, 0], d[:, 1])
    return np.append(azimuth, azimuth[-1]) % (2 * math.pi)


register(
    Pattern(
        name="corridor",
        shape="line",
        lines=lines,
        steps=lambda wish: wish.steps(0.0),
    )
)
