"""Covariances between any unknowns of an adjustment, in the result's datum, a-posteriori: full, never conditional."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.precision import image_unknowns, interior_unknowns
from raybundle.adjustment.statistics.system_state import Work
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index

TOGETHER = 16
"""Right sides that are solved at once."""
KEPT = 64
"""Images of which columns are kept."""
Unknown = tuple[str, Any, int]
"""Kind; an unknown of the nodes, a point, or two points: start and end of a difference; axis"""


@dataclass(slots=True)
class OfImage:
    """The free unknowns of an image: exterior orientation, interior orientation, what it shares with others."""

    unknowns: Index
    """(k,) positions among those of the nodes"""
    exterior: bool
    """whether the first six are the exterior orientation: X0, Y0, Z0, and a small rotation on the left"""
    interior: tuple[int, ...]
    """parameters of the sensor model that the others are"""


@dataclass(slots=True)
class Joint:
    """Columns of the covariance matrix, asked for one by one and kept."""

    work: Work
    variance: float
    relief: Array | None = None
    """(p, 3) what relief within windows adds to a point, along a direction (`Precision.roughness`)"""
    place: Index | None = None
    """(p,) number of the place of each point.  All windows of a place are matched to one reference, along the ray of
    which relief moves the points of all dates alike; None: each point has its own"""
    images: dict[int, Array] = field(default_factory=dict[int, Array])

    @classmethod
    def of(cls, adjustment: Adjustment, place: Index | None = None) -> Joint:
        """Of an adjustment with its factor; raises InputError for one without statistics."""
        if adjustment.handle.work is None:
            raise InputError("joint.no_covariances")
        known = adjustment.precision
        relief = None if known is None else known.roughness
        if relief is not None and place is not None:
            relief = _of_places(relief, place)
        return cls(adjustment.handle.work, adjustment.variance_factor, relief, place)

    def of_image(self, image: int) -> OfImage:
        """What is unknown of an image; raises InputError for one that took no part."""
        system = self.work.system
        if not system.images_used[image]:
            raise InputError("joint.image_not_used", image=system.block.images.ids[image])
        at: list[Array] = []
        exterior = bool(system.exterior_free[image])
        if exterior:
            at.append(image_unknowns(system, image))
        free: list[int] = []
        for r, positions in system.sources(int(system.interior_of_image[image])):
            if system.interior[r].node >= 0:
                at.append(interior_unknowns(system, system.interior[r]))
                free += positions
        unknowns = np.concatenate(at).astype(np.int64) if at else np.zeros(0, np.int64)
        return OfImage(unknowns, exterior, tuple(free))

    def takes_part(self, point: int) -> bool:
        """Whether an object point was adjusted."""
        return bool(self.work.system.points_used[point])

    def image_columns(self, image: int) -> Array:
        """Covariance (N, k) of all unknowns of nodes with those of an image."""
        found = self.images.pop(image, None)
        if found is None:
            found, _ = self._columns([("node", int(u), 0) for u in self.of_image(image).unknowns], [])
        self.images[image] = found
        while len(self.images) > KEPT:
            del self.images[next(iter(self.images))]
        return found

    def between_images(self, first: int, second: int) -> Array:
        """Covariance (k, l) of the unknowns of two images."""
        if not len(self.of_image(second).unknowns):
            return np.zeros((len(self.of_image(first).unknowns), 0))
        return self.image_columns(second)[self.of_image(first).unknowns]

    def point_columns(self, point: int) -> tuple[Array, Array]:
        """Covariance (N, 3) of all unknowns of nodes with a point's coordinates, and the point's own (3, 3)."""
        nodes, points = self._columns(self._of_point(point), [point])
        C = self._with_relief(points, [point], [point])[0]
        return nodes, (C + C.T) / 2

    def of_points(self, points: Sequence[int]) -> Array:
        """Covariance (3 k, 3 k) of the coordinates of points."""
        right = [u for p in points for u in self._of_point(p)]
        _, found = self._columns(right, list(points))
        C = self._with_relief(found, points, points).reshape(3 * len(points), -1)
        return (C + C.T) / 2

    def of_differences(self, start: Index, end: Index) -> Array:
        """Covariances (k, 3, 3) of the coordinates of points less those of others, of each difference alone."""
        found, step = np.zeros((len(start), 3, 3)), TOGETHER // 3
        for k in range(0, len(start), step):
            a, b = start[k : k + step].tolist(), end[k : k + step].tolist()
            right = [("difference", (p, q), axis) for p, q in zip(a, b, strict=True) for axis in range(3)]
            C = self._some(right, [*b, *a])[1]
            for j in range(len(a)):
                found[k + j] = (C[j] - C[len(a) + j])[:, 3 * j : 3 * j + 3]
        if self.relief is not None:
            r = np.nan_to_num(self.relief[end]) - np.nan_to_num(self.relief[start])
            found += r[:, :, None] * r[:, None, :]
        return (found + found.swapaxes(1, 2)) / 2

    def points_with(self, points: Sequence[int], others: Sequence[int]) -> Array:
        """Covariance (n, 3, 3 k) of the coordinates of points with those of other points."""
        right = [u for p in others for u in self._of_point(p)]
        return self._with_relief(self._columns(right, list(points))[1], points, others)

    def _with_relief(self, C: Array, points: Sequence[int], others: Sequence[int]) -> Array:
        """Covariance (n, 3, 3 k) of points with others, with the relief that points of one place share."""
        if self.relief is not None:
            at = np.asarray(points), np.asarray(others)
            here, there = at if self.place is None else (self.place[k] for k in at)
            r, s = (np.nan_to_num(self.relief[k]) for k in at)
            for a, b in np.argwhere(here[:, None] == there).tolist():
                C[a, :, 3 * b : 3 * b + 3] += np.outer(r[a], s[b])
        return C

    def _of_point(self, point: int) -> list[Unknown]:
        if not self.takes_part(point):
            raise InputError("joint.point_not_used", point=self.work.system.block.points.ids[point])
        return [("point", point, axis) for axis in range(3)]

    def _columns(self, right: list[Unknown], points: list[int]) -> tuple[Array, Array]:
        """Covariance of some unknowns (c) with all nodes (N, c) and with the coordinates of points (k, 3, c)."""
        parts = [self._some(right[k : k + TOGETHER], points) for k in range(0, len(right), TOGETHER)]
        if not parts:
            return np.zeros((int(self.work.system.offsets[-1]), 0)), np.zeros((len(points), 3, 0))
        return np.concatenate([n for n, _ in parts], axis=1), np.concatenate([p for _, p in parts], axis=2)

    def _some(self, right: list[Unknown], points: list[int]) -> tuple[Array, Array]:
        work, system = self.work, self.work.system
        nodes = np.zeros((int(system.offsets[-1]), len(right)))
        given = np.zeros((*work.state.xyz.shape, len(right)))
        for k, (kind, at, axis) in enumerate(right):
            if kind == "node":
                nodes[at, k] = 1
                continue
            for p, sign in _signed(at):
                if system.point_node[p] >= 0:
                    nodes[system.offsets[system.point_node[p]] + axis, k] = sign
                else:
                    given[p, axis, k] = sign
        solve = work.spread.solve if work.spread is not None else partial(work.normals.solve, work.state)
        n, p = solve(nodes, given)
        q = self._points(n, p, points)
        found = work.under_noise or work.found
        t = found.transformation if found else None
        if t is not None:
            G, H = self._rows(t.nodes, t.points, right), self._rows(t.nodes_h, t.points_h, right)
            half = H @ t.middle.T - G @ (t.middle @ t.inner @ t.middle.T)
            Gp, Hp = self._points(t.nodes, t.points, points), self._points(t.nodes_h, t.points_h, points)
            n = n - t.nodes @ half.T - t.nodes_h @ t.middle.T @ G.T
            q = q - Gp @ half.T - Hp @ t.middle.T @ G.T
        return self.variance * n, self.variance * q

    def _points(self, nodes: Array, points: Array, which: list[int]) -> Array:
        """Rows (k, 3, c) of points, retained ones from the nodes (N, c), others from (p, 3, c)."""
        system = self.work.system
        found = [
            nodes[system.offsets[system.point_node[p]] + np.arange(3)] if system.point_node[p] >= 0 else points[p]
            for p in which
        ]
        return np.array(found).reshape(len(which), 3, nodes.shape[1])

    def _rows(self, nodes: Array, points: Array, right: list[Unknown]) -> Array:
        rows = [
            nodes[at] if kind == "node"
            else sum(sign * self._points(nodes, points, [p])[0, axis] for p, sign in _signed(at))
            for kind, at, axis in right
        ]  # fmt: skip
        return np.array(rows).reshape(len(right), nodes.shape[1])


def _signed(at: int | tuple[int, int]) -> list[tuple[int, float]]:
    """A point, or the end less the start of a difference."""
    return [(at, 1.0)] if isinstance(at, int) else [(at[1], 1.0), (at[0], -1.0)]


def _of_places(relief: Array, place: Index) -> Array:
    """Relief (p, 3) of points, the mean of those of a place that have some."""
    vector, n = np.nan_to_num(relief), int(place.max(initial=-1)) + 1
    found = np.zeros((n, 3))
    np.add.at(found, place, vector)
    count = np.bincount(place[vector.any(axis=1)], minlength=n)
    return (found / np.maximum(count, 1)[:, None])[place]
