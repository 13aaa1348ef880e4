"""Covariances between any unknowns of an adjustment, in the result's datum, a-posteriori: full, never conditional."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.precision import image_unknowns, interior_unknowns
from raybundle.adjustment.statistics.some_points import Solve, needed, solver_of
from raybundle.adjustment.statistics.system_state import Work
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index

TOGETHER = 192
"""Right sides that are solved at once."""
KEPT = 64
"""Images of which columns are kept."""


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
            unknowns = self.of_image(image).unknowns
            nodes = np.zeros((int(self.work.system.offsets[-1]), len(unknowns)))
            nodes[unknowns, np.arange(len(unknowns))] = 1
            some = _Some.of(self.work, np.zeros(0, np.int64))
            found = self.variance * some.columns(nodes, np.zeros((len(some.points), 3, len(unknowns))))[0]
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
        one = self._known([point])
        some = _Some.of(self.work, one)
        nodes, points = some.columns(*some.sides((one, 1.0)))
        C = self._with_relief(self.variance * points[some.place(one)], one, one)[0]
        return self.variance * nodes, (C + C.T) / 2

    def of_points(self, points: Sequence[int]) -> Array:
        """Covariance (3 k, 3 k) of the coordinates of points."""
        C = self.points_with(points, points).reshape(3 * len(points), -1)
        return (C + C.T) / 2

    def of_differences(self, start: Index, end: Index) -> Array:
        """Covariances (k, 3, 3) of the coordinates of points less those of others, of each difference alone."""
        found, step = np.zeros((len(start), 3, 3)), TOGETHER // 3
        for k in range(0, len(start), step):
            a, b = start[k : k + step], end[k : k + step]
            some, each = _Some.of(self.work, np.concatenate([a, b])), np.arange(len(a))
            points = some.columns(*some.sides((b, 1.0), (a, -1.0)))[1]
            C = (points[some.place(b)] - points[some.place(a)]).reshape(len(a), 3, len(a), 3)
            found[k : k + step] = self.variance * C[each, :, each]
        if self.relief is not None:
            r = np.nan_to_num(self.relief[end]) - np.nan_to_num(self.relief[start])
            found += r[:, :, None] * r[:, None, :]
        return (found + found.swapaxes(1, 2)) / 2

    def points_with(self, points: Sequence[int], others: Sequence[int]) -> Array:
        """Covariance (n, 3, 3 k) of the coordinates of points with those of other points."""
        mine, right, step = np.asarray(points, np.int64), self._known(others), TOGETHER // 3
        some = _Some.of(self.work, np.concatenate([mine, right]))
        found = np.zeros((len(mine), 3, 3 * len(right)))
        for k in range(0, len(right), step):
            columns = some.columns(*some.sides((right[k : k + step], 1.0)))[1]
            found[:, :, 3 * k : 3 * (k + step)] = self.variance * columns[some.place(mine)]
        return self._with_relief(found, mine, right)

    def _with_relief(self, C: Array, points: Index, others: Index) -> Array:
        """Covariance (n, 3, 3 k) of points with others, with the relief that points of one place share."""
        if self.relief is not None:
            here, there = (points, others) if self.place is None else (self.place[points], self.place[others])
            r, s = (np.nan_to_num(self.relief[k]) for k in (points, others))
            for a, b in np.argwhere(here[:, None] == there).tolist():
                C[a, :, 3 * b : 3 * b + 3] += np.outer(r[a], s[b])
        return C

    def _known(self, points: Sequence[int]) -> Index:
        """The points; raises InputError for one that was not adjusted."""
        for p in points:
            if not self.takes_part(p):
                raise InputError("joint.point_not_used", point=self.work.system.block.points.ids[p])
        return np.asarray(points, np.int64)


@dataclass(frozen=True, slots=True)
class _Some:
    """Columns of the covariance matrix, of unit weight: of all nodes and some points."""

    work: Work
    points: Index
    """(k,) ascending"""
    solve: Solve

    @classmethod
    def of(cls, work: Work, points: Index) -> _Some:
        """Of these points and those that their covariances rest on."""
        every = np.union1d(points, needed(work)).astype(np.int64)
        return cls(work, every, solver_of(work, every))

    def place(self, points: Index) -> Index:
        """(n,) positions of points among all of them."""
        return np.searchsorted(self.points, points)

    def sides(self, *signed: tuple[Index, float]) -> tuple[Array, Array]:
        """Right sides for nodes (N, 3 c) and points (k, 3, 3 c) of sums of c points each, with these signs."""
        system, axis = self.work.system, np.arange(3)
        count = len(signed[0][0])
        nodes, given = np.zeros((int(system.offsets[-1]), 3 * count)), np.zeros((len(self.points), 3, 3 * count))
        for points, sign in signed:
            column, node = 3 * np.arange(count)[:, None] + axis, system.point_node[points]
            inside, kept = node < 0, node >= 0
            given[self.place(points)[inside, None], axis, column[inside]] += sign
            nodes[system.offsets[node[kept]][:, None] + axis, column[kept]] += sign
        return nodes, given

    def columns(self, nodes: Array, given: Array) -> tuple[Array, Array]:
        """The covariance applied to right sides, in the datum of the result: nodes (N, c) and points (k, 3, c)."""
        n, q = self.solve(nodes, given)
        q = self._retained(n, q)
        found = self.work.under_noise or self.work.found
        t = found.transformation if found else None
        if t is None:
            return n, q
        Gp, Hp = (self._retained(a, b[self.points]) for a, b in ((t.nodes, t.points), (t.nodes_h, t.points_h)))
        G, H = (
            nodes.T @ a + np.tensordot(given, b, ((0, 1), (0, 1))) for a, b in ((t.nodes, Gp), (t.nodes_h, Hp))
        )  # fmt: skip
        half = H @ t.middle.T - G @ (t.middle @ t.inner @ t.middle.T)
        n = n - t.nodes @ half.T - t.nodes_h @ t.middle.T @ G.T
        return n, q - Gp @ half.T - Hp @ t.middle.T @ G.T

    def _retained(self, nodes: Array, points: Array) -> Array:
        """Points (k, 3, c), those that are not eliminated from the nodes (N, c)."""
        node = self.work.system.point_node[self.points]
        kept, found = np.flatnonzero(node >= 0), points.copy()
        found[kept] = nodes[self.work.system.offsets[node[kept]][:, None] + np.arange(3)]
        return found


def _of_places(relief: Array, place: Index) -> Array:
    """Relief (p, 3) of points, the mean of those of a place that have some."""
    vector, n = np.nan_to_num(relief), int(place.max(initial=-1)) + 1
    found = np.zeros((n, 3))
    np.add.at(found, place, vector)
    count = np.bincount(place[vector.any(axis=1)], minlength=n)
    return (found / np.maximum(count, 1)[:, None])[place]
