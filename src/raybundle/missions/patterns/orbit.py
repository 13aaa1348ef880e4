"""Rings round an object: level ones from its foot to its top, or tilted ones that look at its middle."""

from __future__ import annotations

import math

import numpy as np

from raybundle.missions.patterns.base import LOWEST_M, Line, Pattern, Wish, register, whole
from raybundle.missions.patterns.facade import levels, steps
from raybundle.numerics.arrays import Array
from raybundle.numerics.planes import hull

WIDEST = math.radians(15)
"""Between neighbouring photographs of a ring: descriptors of features that are not flat are found again up to some 25
deg of change of view (Moreels and Perona 2007), and a third photograph is to see them too."""
LOWER = math.radians(20)
"""By which each further tilted ring looks more steeply down."""


def circle(outline: Array) -> tuple[Array, float]:
    """Centre (2,) of the box of an outline (n, 2), and the radius that holds all of it."""
    corners = hull(outline)
    centre = (corners.min(axis=0) + corners.max(axis=0)) / 2
    return centre, float(np.linalg.norm(corners - centre, axis=1).max(initial=0.0))


def lines(outline: Array, wish: Wish) -> list[Line]:
    """One ring for each level or tilt, a photograph at each point, looking at the axis of the object.

    Without a tilt the rings are level and as many as the heights of the object need; with one, `rings` look at the
    middle of the object, the first at that tilt from the nadir, each further one more steeply.
    """
    centre, radius = circle(outline)
    low, top = wish.heights or (0.0, 0.0)
    rings: list[tuple[float, float, float]] = []
    if wish.tilt is None:
        rings = [(radius + wish.distance, above, 0.0) for above in levels(wish, steps(wish)[1])]
    else:
        for k in range(wish.rings):
            tilt = max(wish.tilt - k * LOWER, math.radians(5))
            above = max((low + top) / 2 + wish.distance * math.cos(tilt), LOWEST_M)
            rings.append((radius + wish.distance * math.sin(tilt), above, tilt - math.pi / 2))
    found: list[Line] = []
    for k, (away, above, pitch) in enumerate(rings):
        step = min(WIDEST, steps(wish)[0] / away)
        n = whole(2 * math.pi / step, "photographs")
        azimuth = 2 * math.pi * np.arange(n + 1) / n
        azimuth = azimuth[:-1] if k % 2 == 0 else azimuth[:-1][::-1]
        xy = centre + away * np.stack([np.sin(azimuth), np.cos(azimuth)], axis=1)
        found.append(
            Line(
                name=f"ring {k + 1}",
                group="ring",
                xy=xy,
                above=np.full(n, above),
                heading=(azimuth + math.pi) % (2 * math.pi),
                pitch=np.full(n, pitch),
                foot=(float(centre[0]), float(centre[1])),
                distance=wish.distance,
            )
        )
    return found


register(
    Pattern(
        name="orbit",
        shape="place",
        lines=lines,
        steps=steps,
        ground=False,
    )
)
