"""Parallel lines over an area, the camera looking down."""

from __future__ import annotations

from raybundle.missions.patterns.base import Line, Pattern, Wish, register, straight_lines
from raybundle.missions.polygons import longest_direction
from raybundle.numerics.arrays import Array


def lines(outline: Array, wish: Wish) -> list[Line]:
    """One set of parallel lines; by default as few as there can be."""
    direction = longest_direction(outline) if wish.direction is None else wish.direction
    return straight_lines(outline, wish, direction=direction, tilt=wish.tilt or 0.0, group="line")


register(
    Pattern(
        name="nadir",
        shape="area",
        lines=lines,
        steps=lambda wish: wish.steps(wish.tilt or 0.0),
    )
)
