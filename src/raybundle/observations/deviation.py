"""Parameters of single images that scatter about those of their camera: focus that breathes, stabilisers that shift.

Each image has its own value; that they differ little from each other is observed.  About which value they scatter is
unknown and adjusted with them.  Between a camera that all images share and one for each image, and nearer to the truth
of zoom and autofocus lenses than both.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from raybundle.errors import InputError, message
from raybundle.numerics.arrays import Array, Index
from raybundle.observations.kind import Interior, Named, ObservationKind, Observed, Rows, Scope, Values, partials
from raybundle.observations.table import Table, Wrong, cells


@dataclass(frozen=True, slots=True, kw_only=True)
class Deviations(Table):
    """How far parameters of single images are from what their camera's images have on average."""

    name: ClassVar[str] = "deviations"
    named_by: ClassVar[tuple[str, ...]] = ("image", "parameter")
    image: Index = cells("image", "image")
    parameter: tuple[str, ...] = cells("text", "parameter")
    sigma: Array = cells("number", "sigma", follows="stays", limit="> 0")
    """(k,) of one image's value [unit of the parameter]"""

    def wrong(self) -> Sequence[Wrong]:
        seen, twice = set[tuple[int, str]](), np.zeros(len(self), bool)
        for k, key in enumerate(zip(self.image.tolist(), self.parameter, strict=True)):
            twice[k] = key in seen
            seen.add(key)
        return [
            Wrong(twice, "parameter", lambda k: message("observation.parameter_twice", parameter=self.parameter[k]))
        ]


class Deviation(ObservationKind):
    """v = parameter of the image - m, with the unknown mean m of each camera's parameter: observed as 0."""

    name = "deviation"
    group = "deviations of single images"
    order = 12
    title = "Interior orientation of single images, deviations from their camera"
    object = "camera/image"
    noun = "deviation of a single image"
    quantities = "deviations of single images"
    unit = "own"
    table = Deviations
    own_width = 1

    def check(self, table: Deviations, scope: Scope) -> None:
        own = {i.image: i for i in scope.interior if i.image >= 0}
        for k in np.flatnonzero(scope.images[table.image] if len(table) else []):
            image, parameter = int(table.image[k]), table.parameter[k]
            interior = own.get(image)
            if interior is None or parameter not in {interior.symbols[p] for p in interior.free}:
                raise InputError("deviation.parameter_not_free", image=scope.image_ids[image], parameter=parameter)

    def own(self, table: Deviations, scope: Scope) -> tuple[str, ...]:
        return tuple(dict.fromkeys(self._means(table, scope)[1]))

    def own_start(self, table: Deviations, scope: Scope) -> Array:
        rows, means = self._means(table, scope)
        at = {i.image: i for i in scope.interior if i.image >= 0}
        given = [float(at[int(table.image[k])].given[table.parameter[k]]) for k in rows]
        return np.array([[np.mean([g for g, m in zip(given, means, strict=True) if m == mean])]
                         for mean in dict.fromkeys(means)]).reshape(-1, 1)  # fmt: skip

    def rows(self, table: Deviations, scope: Scope) -> Rows:
        rows, _ = self._means(table, scope)
        return Rows.of(rows, np.zeros(len(rows)), np.zeros(len(rows)), table.sigma[rows])

    def observed(self, table: Deviations, rows: Rows, scope: Scope, values: Values) -> Observed:
        _, means = self._means(table, scope)
        order = {m: n for n, m in enumerate(dict.fromkeys(means))}
        mean = np.array([order[m] for m in means], np.int32)
        r = {i.image: k for k, i in enumerate(scope.interior) if i.image >= 0}
        at = np.array([r[int(table.image[k])] for k in rows.item.tolist()], np.int32)
        column = [scope.interior[a].symbols.index(table.parameter[k]) for a, k in zip(at, rows.item, strict=True)]
        residual = values.interior[at, column] - values.own[self.name][mean, 0] - rows.value
        every, one = np.arange(len(rows)), np.ones(1)
        return Observed(
            residual,
            (partials("interior", every, at, np.array(column), one), partials("own", every, mean, 0, -one)),
        )

    def named(self, table: Deviations, rows: Rows, scope: Scope) -> Named:
        key = {i.image: i.key for i in scope.interior if i.image >= 0}
        images = table.image[rows.item].tolist()
        return Named(tuple(key[i] for i in images), tuple(table.parameter[k] for k in rows.item.tolist()))

    def _means(self, table: Deviations, scope: Scope) -> tuple[Array, list[str]]:
        """Rows that take part, and the mean that each scatters about: "camera parameter"."""
        at: dict[int, Interior] = {i.image: i for i in scope.interior if i.image >= 0}
        rows, means = list[int](), list[str]()
        for k, (image, parameter) in enumerate(zip(table.image.tolist(), table.parameter, strict=True)):
            interior = at.get(image)
            if interior is not None and parameter in {interior.symbols[p] for p in interior.free}:
                rows.append(k)
                means.append(f"{interior.key.rpartition('/')[0]} {parameter}")
        return np.array(rows, np.int64), means
