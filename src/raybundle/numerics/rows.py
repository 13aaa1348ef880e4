"""Rows of a table by what they belong to."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from raybundle.numerics.arrays import Array, Index


def rows_of_each(owner: Index, count: int) -> list[Index]:
    """Rows (k,), in their order, of each of 0 .. count - 1; owner (m,), negative for those that belong to none.

    Once through the table, where a search for each owner would go through all of it `count` times.
    """
    order = np.argsort(owner, kind="stable")
    bounds = np.searchsorted(owner[order], np.arange(count + 1)).tolist()
    return [order[a:b] for a, b in pairwise(bounds)]


def rows_of_largest(values: Array, most: int) -> Index:
    """Positions (k,) of the largest, in falling order, equal ones as they stand; at most so many.  No NaN."""
    if most >= len(values):
        return np.argsort(-values, kind="stable")
    at = np.flatnonzero(values >= np.partition(values, len(values) - most)[len(values) - most])
    return at[np.argsort(-values[at], kind="stable")][:most]


def distinct(numbers: Index) -> Index:
    """Each number (k,) once, ascending; by sorting, which takes a fraction of the time that a hash table takes."""
    found = np.sort(numbers)
    return found[np.append(True, found[1:] != found[:-1])] if len(found) else found
