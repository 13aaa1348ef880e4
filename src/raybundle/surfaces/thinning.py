"""A cloud with fewer points: of each cube of space the one that is known best."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.surfaces.run import Surface
from raybundle.surfaces.state import Cloud

MOST_CUBES = 2**62
"""That can be numbered."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Thinned:
    """Some of the points of a surface."""

    surface: Surface
    kept: tuple[Index, ...]
    """rows of each part"""

    def __len__(self) -> int:
        """How many."""
        return sum(len(k) for k in self.kept)

    def parts(self) -> Iterator[Cloud]:
        """Those of one reference after the other."""
        for cloud, kept in zip(self.surface.parts(), self.kept, strict=True):
            yield Cloud(**{name: values[kept] for name, values in cloud.as_arrays().items()})


def thinned(surface: Surface, side: float) -> Thinned:
    """Of each cube of so long sides the point with the least standard deviation; of equal ones the first.

    raises  InputError where there would be more cubes than can be numbered
    In memory is what is known of the cubes that have points.
    """
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for cloud in surface.parts():
        if len(cloud):
            low, high = np.minimum(low, cloud.xyz.min(axis=0)), np.maximum(high, cloud.xyz.max(axis=0))
    if not np.isfinite(low).all():
        return Thinned(surface=surface, kept=tuple(np.zeros(0, int) for _ in surface.clouds))
    first = np.floor(low / side)
    count = np.floor(high / side) - first + 1
    if float(np.prod(count)) > MOST_CUBES:
        least = float((np.prod(high - low) / MOST_CUBES) ** (1 / 3))
        raise InputError("surface.too_many_cubes", side=side, most=float(MOST_CUBES), least=least)
    best: tuple[Array, Array, Array, Array] = (np.zeros(0, np.int64), np.zeros(0), np.zeros(0, int), np.zeros(0, int))
    for part, cloud in enumerate(surface.parts()):
        x, y, z = (np.floor(cloud.xyz / side) - first).astype(np.int64).T
        cube = (x * int(count[1]) + y) * int(count[2]) + z
        sigma = np.linalg.norm(cloud.sigma.astype(float), axis=1)
        new = cube, sigma, np.full(len(cube), part), np.arange(len(cube))
        joined = [np.concatenate(both) for both in zip(best, new, strict=True)]
        order = np.lexsort((joined[3], joined[2], joined[1], joined[0]))
        taken = order[np.unique(joined[0][order], return_index=True)[1]]
        best = joined[0][taken], joined[1][taken], joined[2][taken], joined[3][taken]
    return Thinned(
        surface=surface, kept=tuple(np.sort(best[3][best[2] == part]) for part in range(len(surface.clouds)))
    )
