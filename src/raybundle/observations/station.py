"""Observed projection centres: GNSS antennas with their lever arms, shifts, drifts and time offsets."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from raybundle.errors import InputError, message
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.rotation import cross_matrix
from raybundle.observations.correlation import correlated
from raybundle.observations.kind import Named, ObservationKind, Observed, Rows, Scope, Values, partials
from raybundle.observations.table import Table, Wrong, again, cells


@dataclass(frozen=True, slots=True, kw_only=True)
class Stations(Table):
    """Observed projection centres (GNSS)."""

    name: ClassVar[str] = "stations"
    named_by: ClassVar[tuple[str, ...]] = ("image",)
    observed: ClassVar[str] = "xyz"

    image: Index = cells("image", "image")
    xyz: Array = cells("number", "X", "Y", "Z", follows="position", empty=True)
    """(k, 3); NaN where a coordinate was not observed."""
    sigma: Array = cells("number", "sX", "sY", "sZ", follows="deviations", empty=True, limit="> 0")
    """(k, 3)"""
    correlation: Array | None = cells(
        "number", "rXY", "rXZ", "rYZ", follows="correlations", deviations="sigma", empty=True, optional=True, fill=0.0
    )
    """(k, 3) coefficients of correlation of the observed coordinates; None: independent."""
    antenna: Index | None = cells("instrument", "antenna", model="antenna", empty=True, optional=True)
    """(k,) position in `Block.instruments` of the antenna that was observed, -1 or None: the projection centre."""
    time: Array | None = cells("number", "time_s", follows="stays", empty=True, optional=True, fill=0.0)
    """(k,) [s] for an antenna's drift; None: zero."""
    velocity: Array | None = cells("number", "vX", "vY", "vZ", follows="vector", empty=True, optional=True)
    """(k, 3) of the image [length unit / s], for an antenna's time offset; None or NaN: by the positions around it."""

    def wrong(self) -> Sequence[Wrong]:
        given, weighted = np.isfinite(self.xyz), np.isfinite(self.sigma)
        return [
            Wrong(again(self.image), "image", lambda _: message("observation.image_twice")),
            Wrong(
                np.asarray(np.any(given ^ weighted, axis=1), bool), "sX",
                lambda _: message("observation.value_without_sigma"),
            ),
            Wrong(np.asarray(~given.any(axis=1), bool), "X", lambda _: message("observation.no_value")),
        ]  # fmt: skip

    @property
    def velocities(self) -> Array:
        """(k, 3) as given, else by the positions of the same antenna before and after; NaN where there is neither.

        A neighbour further in time than twice the usual interval belongs to another flight line and is left out.
        """
        found = np.full((len(self), 3), np.nan) if self.velocity is None else np.array(self.velocity, float)
        if self.time is None or self.antenna is None:
            return found
        for a in np.unique(self.antenna[self.antenna >= 0]):
            mine = np.flatnonzero(self.antenna == a)
            mine = mine[np.argsort(self.time[mine], kind="stable")]
            step = np.diff(self.time[mine])
            if not (step > 0).any():
                continue
            near = (step > 0) & (step <= 2 * np.median(step[step > 0]))
            for k, row in enumerate(mine):
                if np.isfinite(found[row]).all():
                    continue
                low, high = k - int(k > 0 and near[k - 1]), k + int(k < len(near) and near[k])
                if high > low:
                    seconds = self.time[mine[high]] - self.time[mine[low]]
                    found[row] = (self.xyz[mine[high]] - self.xyz[mine[low]]) / seconds
        return found


class Station(ObservationKind):
    """v = X0 + R' a + s + d t + v dt - observed, see `raybundle.platforms.antenna`; X0 alone without an antenna."""

    name = "station"
    group = "stations"
    order = 2
    title = "Observed projection centres"
    object = "image"
    noun = "observed projection centre"
    quantities = "coordinates of projection centres"
    unit = "length"
    table = Stations
    carries_datum = True
    left_open = "datum.antennas_unknown"

    def check(self, table: Stations, scope: Scope) -> None:
        if table.antenna is None:
            return
        late = {
            i.instrument
            for i in scope.interior
            if i.given.get("dt", 0.0) != 0 or ("dt" in i.symbols and i.symbols.index("dt") in i.free)
        }
        unknown = np.isnan(table.velocities).any(axis=1)
        unknown &= np.array([a in late for a in table.antenna.tolist()], bool)
        if unknown.any():
            names = [scope.image_ids[table.image[k]] for k in np.flatnonzero(unknown)]
            raise InputError("station.velocity_unknown", images=names)

    def instruments(self, table: Stations, scope: Scope) -> set[int]:
        return (
            set() if table.antenna is None else {a for a in table.antenna[scope.images[table.image]].tolist() if a >= 0}
        )

    def rows(self, table: Stations, scope: Scope) -> Rows:
        item, axis = np.nonzero(scope.images[table.image, None] & np.isfinite(table.xyz) & (table.sigma > 0))
        shift: Array = scope.shift[axis]
        rows = Rows.of(item, axis, table.xyz[item, axis] - shift, table.sigma[item, axis], shift)
        return correlated(table, rows)

    def observed(self, table: Stations, rows: Rows, scope: Scope, values: Values) -> Observed:
        item, axis, k = rows.item, rows.component, np.arange(len(rows))
        image = table.image[item]
        residual = values.centre[image, axis] - rows.value
        found = [partials("centre", k, image, axis, np.ones(1))]
        antenna = np.full(len(table), -1, np.int32) if table.antenna is None else table.antenna
        at = scope.parameters_of(antenna[item])
        mine = np.flatnonzero(antenna[item] >= 0)
        if not len(mine):
            return Observed(residual, tuple(found))
        item, axis, image, at = item[mine], axis[mine], image[mine], at[mine]
        time = np.zeros(len(mine)) if table.time is None else table.time[item]
        velocity = np.nan_to_num(table.velocities[item, axis])  # without a time offset it may not be known
        a, s, d = (values.interior[at, 3 * j : 3 * j + 3] for j in range(3))
        back = values.rotation[image, :, axis]  # row `axis` of R'
        n = np.arange(len(mine))
        residual[mine] += (back * a).sum(axis=1) + s[n, axis] + d[n, axis] * time + velocity * values.interior[at, 9]
        # R_new' a = R' exp(-[delta]x) a
        turned = np.einsum("ki,kij->kj", back, cross_matrix(a))
        for j in range(3):
            found.append(partials("rotation", mine, image, j, turned[:, j]))
            found.append(partials("interior", mine, at, j, back[:, j]))
        found.append(partials("interior", mine, at, 3 + axis, np.ones(1)))
        found.append(partials("interior", mine, at, 6 + axis, time))
        found.append(partials("interior", mine, at, 9, velocity))
        return Observed(residual, tuple(found))

    def named(self, table: Stations, rows: Rows, scope: Scope) -> Named:
        return Named(
            tuple(scope.image_ids[i] for i in table.image[rows.item].tolist()),
            tuple("XYZ"[a] for a in rows.component.tolist()),
        )
