"""Choice of codes that stay distinct when a part of the ring is hidden.

Hide an arc of h sectors of a ring of N: what is left is a run of N - h sectors.  Two rings that have no run of that
length in common cannot be taken for each other, whatever the hidden arc looks like.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.targets.codes import RingFamily, population, rotations


@dataclass(frozen=True, slots=True, kw_only=True)
class Choice:
    """Targets to be used together."""

    ids: Index
    """(n,) upwards"""
    hidden: int
    """sectors of one arc that may be hidden without one ring passing for another; 0: not even one"""
    distance: int
    """least number of sectors in which two of the rings differ, turned as alike as possible"""


def choose_codes(family: RingFamily, count: int) -> Choice:
    """The `count` targets that bear the longest hidden arc.

    Found by taking rings that share the fewest runs with others first, so that now and then one sector more would
    have been possible.  What the choice does not protect against: hidden parts in several places; `distance` shows.
    Raises InputError where the family has not so many.
    """
    if not 1 <= count <= len(family):
        raise InputError("target.too_few_codes", family=family.name, n=len(family), wanted=count)
    readings = rotations(family.codes, family.bits)
    best, hidden = np.arange(count), 0
    for h in range(1, family.bits - 1):
        chosen = _independent(readings & ((1 << (family.bits - h)) - 1), count)
        if len(chosen) < count:
            break
        best, hidden = chosen, h
    best = np.sort(best)
    return Choice(ids=family.ids[best], hidden=hidden, distance=least_distance(family.codes[best], family.bits))


def _independent(runs: Index, count: int) -> Index:
    """Positions of up to `count` rows of (n, k) that share no value, greedily, rare values first."""
    _, inverse, frequency = np.unique(runs, return_inverse=True, return_counts=True)
    inverse = inverse.reshape(runs.shape)
    order = np.argsort(frequency[inverse].sum(axis=1), kind="stable")
    used = np.zeros(len(frequency), bool)
    chosen: list[int] = []
    for i in order:
        if not used[inverse[i]].any():
            used[inverse[i]] = True
            chosen.append(int(i))
            if len(chosen) == count:
                break
    return np.array(chosen, np.int64)


def least_distance(codes: Index, bits: int) -> int:
    """Least number of differing sectors between any two rings over all turns; `bits` for a single ring."""
    turned = rotations(codes, bits)
    least = bits
    for i in range(len(codes) - 1):
        least = min(least, int(_set_bits(turned[i + 1 :] ^ codes[i]).min()))
        if least == 2:
            break
    return least


_OF_TWELVE: Array = population(np.arange(1 << 12), 12).astype(np.int8)


def _set_bits(values: Index) -> Index:
    return _OF_TWELVE[values & 0xFFF] + _OF_TWELVE[values >> 12]
