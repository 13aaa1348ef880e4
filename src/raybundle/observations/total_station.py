"""What a total station and its kin measure: directions, zenith angles, slope distances, coordinate differences.

The vertical of the instrument is the Z axis of the object's frame: over the few hundred metres of a facade or a dig the
verticals of all set-ups are taken as parallel, and refraction and curvature as none (0.5 mgon at 100 m, growing with
the distance); longer sights are to be reduced before.  Angles count clockwise, as instruments do.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from raybundle.errors import InputError, message
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.records import Stuck
from raybundle.numerics.transform import SimilarityTransform
from raybundle.observations.kind import Scope
from raybundle.observations.residual import ResidualKind, Unknowns, length, wrapped
from raybundle.observations.table import Table, Wrong, cells


@dataclass(frozen=True, slots=True, kw_only=True)
class Sights(Table):
    """From one object point to another."""

    station: Index
    target: Index

    def wrong(self) -> Sequence[Wrong]:
        return [Wrong(self.station == self.target, "target", lambda _: message("observation.same_point"))]


@dataclass(frozen=True, slots=True, kw_only=True)
class Directions(Sights):
    """Horizontal directions; those of a set have one orientation, which is unknown."""

    name: ClassVar[str] = "directions"
    observed: ClassVar[str] = "angle"
    upright: ClassVar[bool] = True
    set: tuple[str, ...] = cells("text", "set")
    station: Index = cells("point", "station")
    target: Index = cells("point", "target")
    angle: Array = cells("number", "direction_deg", follows="stays", unit="deg")
    """(k,) clockwise from the zero of the circle [rad]"""
    sigma: Array = cells("number", "sigma_deg", follows="stays", unit="deg", limit="> 0")

    def wrong(self) -> Sequence[Wrong]:
        first = dict[str, int]()
        here = [first.setdefault(s, int(p)) == int(p) for s, p in zip(self.set, self.station, strict=True)]
        return [
            *Sights.wrong(self),
            Wrong(
                ~np.array(here, bool), "station",
                lambda k: message("observation.set_station", set=self.set[k]),
            ),
        ]  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class ZenithAngles(Sights):
    """Zenith angles: 0 is up."""

    name: ClassVar[str] = "zenith_angles"
    observed: ClassVar[str] = "angle"
    upright: ClassVar[bool] = True
    station: Index = cells("point", "station")
    target: Index = cells("point", "target")
    angle: Array = cells("number", "zenith_deg", follows="stays", unit="deg")
    """(k,) [rad]"""
    sigma: Array = cells("number", "sigma_deg", follows="stays", unit="deg", limit="> 0")
    instrument: Array | None = cells(
        "number", "instrument_height", follows="length", optional=True, empty=True, fill=0.0
    )
    """(k,) of its axis above the station point [length unit]"""
    reflector: Array | None = cells("number", "target_height", follows="length", optional=True, empty=True, fill=0.0)
    """(k,) of what was sighted above the target point [length unit]"""

    def wrong(self) -> Sequence[Wrong]:
        no = ~((self.angle > 0) & (self.angle < np.pi))
        return [
            *Sights.wrong(self),
            Wrong(
                no, "zenith_deg",
                lambda k: message("observation.zenith_angle", angle_deg=float(np.degrees(self.angle[k]))),
            ),
        ]  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class SlopeDistances(Sights):
    """Distances between instrument and reflector."""

    name: ClassVar[str] = "slope_distances"
    observed: ClassVar[str] = "length"
    station: Index = cells("point", "station")
    target: Index = cells("point", "target")
    length: Array = cells("number", "distance", follows="length", limit="> 0")
    sigma: Array = cells("number", "sigma", follows="length", limit="> 0")
    instrument: Array | None = cells(
        "number", "instrument_height", follows="length", optional=True, empty=True, fill=0.0
    )
    reflector: Array | None = cells("number", "target_height", follows="length", optional=True, empty=True, fill=0.0)

    def tilted(self, by: SimilarityTransform) -> Sequence[Stuck]:
        heights = np.zeros(len(self))
        for h in (self.instrument, self.reflector):
            heights = heights + (0.0 if h is None else np.abs(h))
        rows: Mask = np.asarray((heights > 0) & by.tilts, bool)
        return [Stuck(rows, message("transform.heights_tilted"))]


@dataclass(frozen=True, slots=True, kw_only=True)
class Differences(Sights):
    """Coordinate differences, target minus station: levelling (dZ alone), GNSS baselines."""

    name: ClassVar[str] = "differences"
    observed: ClassVar[str] = "xyz"
    station: Index = cells("point", "from")
    target: Index = cells("point", "to")
    xyz: Array = cells("number", "dX", "dY", "dZ", follows="vector", empty=True)
    """(k, 3) [length unit]; NaN: not observed"""
    sigma: Array = cells("number", "sX", "sY", "sZ", follows="deviations", empty=True, limit="> 0")
    correlation: Array | None = cells(
        "number", "rXY", "rXZ", "rYZ", follows="correlations", deviations="sigma", empty=True, optional=True, fill=0.0
    )
    """(k, 3) coefficients of correlation of the observed differences; None: independent."""

    def wrong(self) -> Sequence[Wrong]:
        lone = (np.isfinite(self.xyz) != np.isfinite(self.sigma)).any(axis=1)
        return [
            *Sights.wrong(self),
            Wrong(np.asarray(lone, bool), "sX", lambda _: message("observation.value_without_sigma")),
            Wrong(np.asarray(np.isnan(self.xyz).all(axis=1), bool), "dX", lambda _: message("observation.no_value")),
        ]


class _Sight(ResidualKind, registered=False):
    """v = f(X_target - X_station) - observed."""

    object = "from–to"
    carries_datum = True
    carries_points = True

    def _across(self, row: Any, at: Unknowns) -> Array:
        """(k, 3) from the axis of the instrument to what was sighted."""
        d = at.point(row.target) - at.point(row.station)
        up = np.zeros((len(row), 3))
        for heights, sign in ((getattr(row, "reflector", None), 1.0), (getattr(row, "instrument", None), -1.0)):
            if heights is not None:
                up[:, 2] += sign * heights
        return d + up


class Direction(_Sight):
    """v = atan2(dX, dY) - o - direction, with the unknown orientation o of the set, wrapped to half a circle."""

    name = "direction"
    group = "directions"
    order = 13
    title = "Horizontal directions"
    noun = "direction"
    quantities = "directions"
    unit = "angle"
    table = Directions
    thing = "set"
    own_width = 1
    left_open = "datum.directions_unknown"
    hides = (5,)

    def check(self, table: Directions, scope: Scope) -> None:
        for k in np.flatnonzero(self.used(table, scope)):
            d = (scope.xyz[table.target[k]] - scope.xyz[table.station[k]])[:2]
            if not np.hypot(*d) > 0:
                ids = scope.point_ids
                raise InputError(
                    "total_station.vertical_sight",
                    set=table.set[k],
                    station=ids[table.station[k]],
                    target=ids[table.target[k]],
                )

    def own_start(self, table: Directions, scope: Scope) -> Array:
        used, sets = self.used(table, scope), np.array(table.set)
        d = scope.xyz[table.target] - scope.xyz[table.station]
        off = np.arctan2(d[:, 0], d[:, 1]) - table.angle
        found = [np.angle(np.exp(1j * off[used & (sets == name)]).sum()) for name in self.own(table, scope)]
        return np.array(found).reshape(-1, 1)

    def own_placed(self, values: Array, scale: float, R: Array, t: Array) -> Array:
        return values - np.arctan2(R[1, 0], R[0, 0])

    def own_generators(self, values: Array, centre: Array) -> Array:
        by = np.zeros((len(values), 1, 7))
        by[:, 0, 5] = -1.0
        return by

    def residual(self, row: Directions, at: Unknowns) -> Array:
        d = self._across(row, at)
        return wrapped(np.arctan2(d[:, 0], d[:, 1]) - at.own[:, 0] - row.angle)


class ZenithAngle(_Sight):
    """v = atan2(horizontal distance, height difference) - zenith angle."""

    name = "zenith_angle"
    group = "zenith angles"
    order = 14
    title = "Zenith angles"
    noun = "zenith angle"
    quantities = "zenith angles"
    unit = "angle"
    table = ZenithAngles

    def residual(self, row: ZenithAngles, at: Unknowns) -> Array:
        d = self._across(row, at)
        return np.arctan2(length(d[:, :2]), d[:, 2]) - row.angle


class SlopeDistance(_Sight):
    """v = distance between instrument and reflector - observed."""

    name = "slope_distance"
    group = "slope distances"
    order = 15
    title = "Slope distances"
    noun = "slope distance"
    quantities = "slope distances"
    unit = "length"
    table = SlopeDistances
    called = ("length",)
    fixes_scale = True

    def residual(self, row: SlopeDistances, at: Unknowns) -> Array:
        return length(self._across(row, at)) - row.length


class Difference(_Sight):
    """v = X_target - X_station - observed, for each coordinate that was."""

    name = "difference"
    group = "coordinate differences"
    order = 16
    title = "Coordinate differences"
    noun = "coordinate difference"
    quantities = "coordinate differences"
    components = ("X", "Y", "Z")
    unit = "length"
    table = Differences
    called = ("dX", "dY", "dZ")

    def residual(self, row: Differences, at: Unknowns) -> Array:
        return self._across(row, at) - row.xyz
