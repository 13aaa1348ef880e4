"""What a pattern is given, and what it answers with: lines in plan with heights, views and distances of photographs."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from raybundle.errors import InputError
from raybundle.missions.camera import MissionCamera
from raybundle.missions.defaults import OVERLAP
from raybundle.missions.polygons import along
from raybundle.numerics.arrays import Array

NADIR = -math.pi / 2
MOST = 20_000
"""Lines, or photographs of a ring, that one mission may have: more is a slip of a unit, not a flight."""
LOWEST_M = 2.0
"""Above ground, below which no way point is put before a facade or round an object."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Wish:
    """What is asked of a pattern; each takes what concerns it."""

    camera: MissionCamera
    distance: float
    """along the viewing axis to what is photographed [m]"""
    overlap: tuple[float, float] = OVERLAP
    """along and across lines"""
    direction: float | None = None
    """azimuth of the lines [rad]; None: that of the fewest lines"""
    margin: float | None = None
    """by which the area is widened [m]; None: half the spacing of lines, so that its edge is seen from two lines"""
    tilt: float | None = None
    """of the view from the nadir [rad]; None: as usual for the pattern"""
    directions: int = 4
    """of oblique views"""
    heights: tuple[float, float] | None = None
    """lower and upper end of a facade or object above ground [m]"""
    rings: int = 1
    """of orbits that look down at one tilt or more"""
    width: float = 0.0
    """of a corridor [m]"""
    side: Literal["left", "right"] = "right"
    """of a facade's line on which the vehicle flies, seen along the line"""

    @property
    def gsd(self) -> float:
        """Side of a pixel in the middle of a photograph [m]."""
        return self.camera.gsd(self.distance)

    def above(self, tilt: float) -> float:
        """Height above ground at which the axis tilted so far meets it at the distance [m]."""
        return self.distance * math.cos(tilt)

    def steps(self, tilt: float = 0.0) -> tuple[float, float]:
        """Base and spacing [m] of the overlaps asked for, over level ground, the view tilted along the line.

        Along, a tilted photograph covers h (tan(t + a) - tan(t - a)), a half its angle of view; across, the width of
        its middle row counts, the near part being narrower.
        raises  InputError where the view reaches the horizon
        """
        half = math.atan(self.camera.height_px / 2 / self.camera.c_px)
        if tilt + half >= math.radians(85):
            raise InputError(
                "mission.view_to_horizon",
                tilt_deg=math.degrees(tilt),
                angle_deg=math.degrees(2 * half),
                most_deg=85 - math.degrees(half),
            )
        reach = self.above(tilt) * (math.tan(tilt + half) - math.tan(tilt - half))
        return (1 - self.overlap[0]) * reach, (1 - self.overlap[1]) * self.camera.footprint(self.distance)[0]

    def along(self, direction: float) -> Wish:
        """The same with lines of a direction."""
        return replace(self, direction=direction)


@dataclass(frozen=True, slots=True, kw_only=True)
class Line:
    """A flight line before heights of the ground are known."""

    name: str
    group: str
    """lines of one group are neighbours between which photographs overlap"""
    xy: Array
    """(k, 2) [m]"""
    above: Array
    """(k,) height above the ground below, or above that at `foot` [m]"""
    heading: Array
    """(k,) of the view [rad]"""
    pitch: Array
    """(k,) [rad]"""
    base: float | None = None
    """metres between photographs; None: one at each point, standing"""
    foot: tuple[float, float] | None = None
    """x, y of the ground from which heights count; None: from the ground below"""
    distance: float | None = None
    """to what is photographed; None: the ground"""

    @property
    def length(self) -> float:
        """In plan [m]."""
        return float(np.linalg.norm(np.diff(self.xy, axis=0), axis=1).sum())

    def turned(self) -> Line:
        """The same flown the other way, with the views that it had."""
        return replace(
            self, xy=self.xy[::-1], above=self.above[::-1], heading=self.heading[::-1], pitch=self.pitch[::-1]
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Pattern:
    """One way to fly."""

    name: str
    shape: Literal["area", "line", "place"]
    """what it is flown over: an area, along a line, round a place or area"""
    lines: Callable[[Array, Wish], list[Line]]
    """of the outline (n, 2) and what is asked for"""
    steps: Callable[[Wish], tuple[float, float]]
    """base and spacing [m], as they are reported"""
    ground: bool = True
    """whether it photographs the ground, so that heights follow it"""


patterns: dict[str, Pattern] = {}


def register(pattern: Pattern) -> Pattern:
    """Make a pattern known by its name."""
    patterns[pattern.name] = pattern
    return pattern


def whole(number: float, what: str) -> int:
    """A count rounded up, at least 1; raises InputError for one that nobody flies."""
    if not number <= MOST:
        raise InputError("mission.too_many_parts", kind=what, n=number, most=MOST)
    return max(1, math.ceil(number - 1e-9))


def axes(direction: float) -> tuple[Array, Array]:
    """Unit vectors along an azimuth [rad] and to the right of it."""
    return np.array([math.sin(direction), math.cos(direction)]), np.array([math.cos(direction), -math.sin(direction)])


def straight_lines(
    outline: Array, wish: Wish, *, direction: float, tilt: float, group: str, fixed: bool = False
) -> list[Line]:
    """Parallel lines over an area, flown to and fro, the view tilted forward.

    fixed  whether the view keeps the azimuth `direction` on the way back as well, as for one of several oblique views

    The area is divided into strips of the spacing; each line runs as far as the area reaches within its strip, and is
    lengthened to whole bases, so that the overlap is that asked for.  A tilted view sees ahead of the vehicle: its
    lines begin and end so much earlier.
    """
    base, spacing = wish.steps(tilt)
    margin = spacing / 2 if wish.margin is None else wish.margin
    u, v = axes(direction)
    ring = np.stack([outline @ u, outline @ v], axis=1)
    low, high = float(ring[:, 1].min()) - margin, float(ring[:, 1].max()) + margin
    count = whole((high - low) / spacing, "lines")
    first = (low + high) / 2 - (count - 1) / 2 * spacing
    ahead = wish.above(tilt) * math.tan(tilt)
    lines: list[Line] = []
    for k in range(count):
        y = first + k * spacing
        parts = along(ring, y - spacing / 2 - margin, y + spacing / 2 + margin)
        back = len(lines) % 2 == 1
        for x0, x1 in reversed(parts) if back else parts:
            steps = max(1, math.ceil((x1 - x0 + 2 * margin) / base - 1e-9))
            middle, half = (x0 + x1) / 2, steps * base / 2
            shift = -ahead if fixed or not back else ahead
            ends = np.array([middle - half, middle + half])[:: -1 if back else 1] + shift
            view = direction if fixed or not back else direction + math.pi
            lines.append(
                Line(
                    name=f"{group} {k + 1}",
                    group=group,
                    xy=ends[:, None] * u + y * v,
                    above=np.full(2, wish.above(tilt)),
                    heading=np.full(2, view % (2 * math.pi)),
                    pitch=np.full(2, NADIR + tilt),
                    base=base,
                )
            )
    return lines
