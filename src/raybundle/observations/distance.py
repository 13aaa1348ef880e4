"""Distances between two object points: scale bars, tape measures, distance meters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from raybundle.errors import message
from raybundle.numerics.arrays import Array, Index
from raybundle.observations.residual import ResidualKind, Unknowns, length
from raybundle.observations.table import Table, Wrong, cells


@dataclass(frozen=True, slots=True, kw_only=True)
class Distances(Table):
    """Scale bars: observed distances between two object points."""

    name: ClassVar[str] = "distances"
    observed: ClassVar[str] = "length"

    start: Index = cells("point", "from")
    end: Index = cells("point", "to")
    length: Array = cells("number", "length", follows="length", limit="> 0")
    sigma: Array = cells("number", "sigma", follows="length", limit="> 0")

    def wrong(self) -> Sequence[Wrong]:
        return [Wrong(self.start == self.end, "to", lambda _: message("observation.same_point"))]


class Distance(ResidualKind):
    """v = |X_end - X_start| - length, the shortest way between two points in the frame of the object."""

    name = "distance"
    group = "distances"
    order = 1
    title = "Scale bars"
    object = "from–to"
    noun = "scale bar"
    quantities = "scale bars"
    unit = "length"
    fixes_scale = True
    table = Distances
    called = ("length",)
    between = "-"

    def residual(self, row: Distances, at: Unknowns) -> Array:
        return length(at.point(row.end) - at.point(row.start)) - row.length
