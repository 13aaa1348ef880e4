"""Distances of places from a surface."""

from __future__ import annotations

import numpy as np
from scipy.spatial import KDTree

from raybundle.numerics.arrays import Array
from raybundle.objects.surface import Surface


class Distances:
    """Exact distances from the triangles of a surface."""

    def __init__(self, surface: Surface) -> None:
        """Build the tree of the triangles' middles."""
        corners = surface.vertices[surface.triangles]
        self.corners = corners[surface.areas > 0]
        middle = self.corners.mean(axis=1)
        self.reach = float(np.linalg.norm(self.corners - middle[:, None], axis=2).max())
        self.tree = KDTree(middle)

    def of(self, places: Array) -> Array:
        """(n,) distances of places (n, 3) [as the surface]."""
        least = self.tree.query(places)[0] + self.reach  # the nearest triangle is not farther than that
        near = self.tree.query_ball_point(places, least + self.reach)
        count = np.array([len(k) for k in near])
        rows = np.concatenate([np.asarray(k, np.int64) for k in near])
        place = np.repeat(np.arange(len(places)), count)
        each = _to_triangles(places[place], self.corners[rows])
        first = np.concatenate([[0], np.cumsum(count)[:-1]])
        return np.minimum.reduceat(each, first)


def _to_triangles(p: Array, corners: Array) -> Array:
    """(k,) distances of points (k, 3) from triangles (k, 3, 3): to the plane, or to the nearest side."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    n = np.cross(b - a, c - a)
    square = np.einsum("ki,ki->k", n, n)
    height = np.einsum("ki,ki->k", p - a, n)
    within = np.ones(len(p), bool)
    best = np.full(len(p), np.inf)
    for s, e in ((a, b), (b, c), (c, a)):
        side = e - s
        within &= np.einsum("ki,ki->k", np.cross(n, side), p - s) >= 0
        t = np.clip(np.einsum("ki,ki->k", p - s, side) / np.einsum("ki,ki->k", side, side), 0, 1)
        best = np.minimum(best, np.linalg.norm(p - s - t[:, None] * side, axis=1))
    return np.where(within, np.abs(height) / np.sqrt(square), best)
