"""Candidate matches: pairs of features that are each other's nearest, clearly nearer than the next."""

from __future__ import annotations

import numpy as np

from raybundle.numerics import native
from raybundle.numerics.arrays import Array, Index

CHUNK = 2048
RATIO = 0.85
"""Of the distances to the nearest and the second, below which a match is a candidate (Lowe 2004)"""


def best_matches(a: Array, b: Array) -> tuple[Index, Array, Array, Index]:
    """Nearest neighbours by inner product.

    a, b     (n, k), (m, k) unit vectors, float32; or bytes of which the directions count, k a multiple of 4
    returns  for rows of a: position of the largest product in b, that product, the second largest product;
             for rows of b: position of the largest product in a
    """
    module = native.module()
    if module is None:
        return best_matches_twin(a, b)
    if a.dtype == b.dtype == np.uint8:
        # whole numbers are exact, and a quarter of the size
        return tuple(module.best_matches_of_bytes(np.ascontiguousarray(a), np.ascontiguousarray(b)))  # pyright: ignore[reportReturnType]
    found = module.best_matches(np.ascontiguousarray(a, np.float32), np.ascontiguousarray(b, np.float32))
    return tuple(found)  # pyright: ignore[reportReturnType]


def best_matches_twin(a: Array, b: Array) -> tuple[Index, Array, Array, Index]:
    """The same with NumPy."""
    a, b = (directions(v) if v.dtype == np.uint8 else v for v in (a, b))
    n, m = len(a), len(b)
    first = np.full(n, -1, np.int32)
    value, second = np.full(n, -np.inf, np.float32), np.full(n, -np.inf, np.float32)
    reverse, column = np.full(m, -1, np.int32), np.full(m, -np.inf, np.float32)
    if not n or not m:
        return first, value, second, reverse
    for begin in range(0, n, CHUNK):
        rows = slice(begin, min(begin + CHUNK, n))
        products = a[rows] @ b.T
        at = np.argmax(products, axis=0)
        top = products[at, np.arange(m)]
        better = top > column
        column[better], reverse[better] = top[better], at[better] + begin
        first[rows] = np.argmax(products, axis=1)
        here = np.arange(products.shape[0])
        value[rows] = products[here, first[rows]]
        products[here, first[rows]] = -np.inf
        second[rows] = products.max(axis=1)
    return first, value, second, reverse


def directions(a: Array) -> Array:
    """Unit vectors (n, k) float32 of rows of bytes; 0 for a row of zeros."""
    v = a.astype(np.float32)
    return v / np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1)


def mutual_matches(a: Array, b: Array, ratio: float = RATIO, farthest: float = 0.8) -> tuple[Index, Array]:
    """Matches (k, 2) of vectors, as `best_matches` takes them, and the distances (k,) of their directions.

    ratio     the distance to the nearest must be smaller than this share of that to the second
    farthest  largest distance of unit vectors
    """
    matches, distance, following = nearest_matches(a, b, farthest)
    good = distance < ratio * following
    return matches[good], distance[good]


def nearest_matches(a: Array, b: Array, farthest: float = 0.8) -> tuple[Index, Array, Array]:
    """Pairs (k, 2) that are each other's nearest, their distances (k,), and those to the second nearest (k,)."""
    if len(a) < 2 or len(b) < 2:
        return np.zeros((0, 2), np.int32), np.zeros(0), np.zeros(0)
    first, value, second, reverse = best_matches(a, b)
    distance = np.sqrt(np.maximum(2 - 2 * value.astype(float), 0))
    next_distance = np.sqrt(np.maximum(2 - 2 * second.astype(float), 0))
    rows = np.arange(len(a))
    good = (reverse[first] == rows) & (distance < farthest)
    return np.column_stack([rows[good], first[good]]).astype(np.int32), distance[good], next_distance[good]
