"""Rows of photographs in front of a facade, which stands over a line on the ground."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from raybundle.errors import InputError
from raybundle.missions.patterns.base import LOWEST_M, Line, Pattern, Wish, register, whole
from raybundle.numerics.arrays import Array


def steps(wish: Wish) -> tuple[float, float]:
    """Base along a row and height between rows [m]."""
    width, height = wish.camera.footprint(wish.distance)
    return (1 - wish.overlap[0]) * width, (1 - wish.overlap[1]) * height


def levels(wish: Wish, step: float) -> list[float]:
    """Heights above ground [m] of rows that cover an object from its lower to its upper end."""
    if wish.heights is None:
        raise InputError("mission.heights_missing")
    low, top = wish.heights
    if not top > low:
        raise InputError("mission.heights_order", top_m=top, low_m=low)
    count = whole((top - low) / step, "rows")
    middle = (low + top) / 2
    return sorted({max(middle + (k - (count - 1) / 2) * step, LOWEST_M) for k in range(count)})


def lines(outline: Array, wish: Wish) -> list[Line]:
    """Rows from below to above in front of each straight part of the facade, the view square to it and level."""
    base, step = steps(wish)
    rows = levels(wish, step)
    found: list[Line] = []
    for part, (a, b) in enumerate(pairwise(outline)):
        length = float(np.linalg.norm(b - a))
        ahead = (b - a) / length
        out = np.array([ahead[1], -ahead[0]]) * (1 if wish.side == "right" else -1)
        margin = base if wish.margin is None else wish.margin
        half = math.ceil((length + 2 * margin) / base - 1e-9) * base / 2
        ends = (a + b) / 2 + wish.distance * out + np.array([-half, half])[:, None] * ahead
        heading = math.atan2(-out[0], -out[1]) % (2 * math.pi)
        foot = (a + b) / 2
        for k, above in enumerate(rows):
            found.append(
                Line(
                    name=f"facade {part + 1} row {k + 1}",
                    group=f"facade {part + 1}",
                    xy=ends[:: -1 if k % 2 else 1],
                    above=np.full(2, above),
                    heading=np.full(2, heading),
                    pitch=np.zeros(2),
                    base=base,
                    foot=(float(foot[0]), float(foot[1])),
                    distance=wish.distance,
                )
            )
    return found


register(
    Pattern(
        name="facade",
        shape="line",
        lines=lines,
        steps=steps,
        ground=False,
    )
)
