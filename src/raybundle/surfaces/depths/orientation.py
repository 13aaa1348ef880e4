"""What the uncertainty of orientation and calibration does to depths and object points.

A depth follows the tables that say where a source shows what the reference sees: where one shifts, the depth gives way
by the sensitivity that refinement found.  How tables shift follows from the joint covariance of all exterior and
interior orientations concerned, by differences of the projections themselves: so it holds for any sensor on any
platform.  Shifts change slowly over an image: they are kept at nodes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from raybundle.adjustment.evaluation.queries import JointOrientation, Step
from raybundle.adjustment.system.predict import image_points
from raybundle.block import Block, Camera
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.numerics.rows import rows_of_each
from raybundle.surfaces.depths.rays import ReferenceRays

NODES, LEVELS = 12, 4
"""Nodes along the longer side of a reference, and levels of depth; between them shifts are linear."""
MOST_ERRORS = 256
"""Independent errors that are kept of all orientations of a surface together."""
SHARE = 0.1
"""Of a standard deviation by which an unknown is changed for a difference of projections."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ShiftCovariance:
    """How sources and rays of a reference shift together, at nodes of pixels and levels of depth.

    Partials by the unknowns are kept, not covariances: the error of a ray and that of the depth along it may all but
    cancel, as those of a flight's height and its depths do, and only partials can be interpolated then.
    """

    partials: Array
    """(rows, columns, levels, 2s + 3, k): x and y of the place in each source [px], then the object point at a depth
    parameter that is held, by the unknowns of orientation and calibration"""
    root: Array
    """(k, q) of these unknowns: root root' is their covariance"""
    unknowns: Index
    """(k,) their numbers in the adjustment"""
    steps_px: tuple[float, float]
    """From row to row and from column to column; node (0, 0) stands at the corner of the first pixel"""
    t0: float
    dt: float

    def as_arrays(self) -> dict[str, Array]:
        """What a store keeps."""
        return {
            "partials": self.partials, "root": self.root, "unknowns": self.unknowns,
            "grid": np.array([*self.steps_px, self.t0, self.dt]),
        }  # fmt: skip

    @classmethod
    def of_arrays(cls, a: Mapping[str, Array]) -> ShiftCovariance:
        """That of `as_arrays`."""
        down, across, t0, dt = a["grid"].tolist()
        return cls(
            partials=np.asarray(a["partials"]), root=np.asarray(a["root"]), unknowns=np.asarray(a["unknowns"]),
            steps_px=(down, across), t0=t0, dt=dt,
        )  # fmt: skip

    def among(self, together: CommonRoot) -> ShiftCovariance:
        """The same by the independent errors that all references of a surface have in common."""
        at = np.searchsorted(together.unknowns, self.unknowns)
        return replace(self, root=together.root[at])

    def of_depths(self, xy_px: Array, t: Array, sensitivity: Array) -> Array:
        """Variances (n,) of depth parameters from orientation and calibration.

        xy_px        (n, 2) pixels of the reference
        t            (n,)
        sensitivity  (n, s, 2) of t to a shift of each source's table [1 / px], 0 where it was not used
        """
        found = np.zeros(len(t))
        k = sensitivity.reshape(len(t), 2 * sensitivity.shape[1])
        for mine, weights, nodes in self._cells(xy_px, t):
            found[mine] = (_along(weights, nodes, k[mine]) ** 2).sum(axis=1)
        return found

    def of_points(self, xy_px: Array, t: Array, sensitivity: Array, by_t: Array) -> Array:
        """Covariances (n, 3, 3) of object points from orientation and calibration, in the datum of the adjustment.

        by_t  (n, 3) derivative of the object point by t; a point moves with its ray, and along it with its depth
        """
        found = np.zeros((len(t), 3, 3))
        for mine, point in self.moved_points(xy_px, t, sensitivity, by_t):
            for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)):
                found[mine, i, j] = found[mine, j, i] = np.einsum("nq,nq->n", point[:, i], point[:, j])
        return found

    def moved_points(self, xy_px: Array, t: Array, sensitivity: Array, by_t: Array) -> Iterator[tuple[Index, Array]]:
        """Some of the object points, and how they move (m, 3, q) with each of q independent errors of variance 1."""
        k = sensitivity.reshape(len(t), 2 * sensitivity.shape[1])
        for mine, weights, nodes in self._cells(xy_px, t):
            along = _along(weights, nodes, k[mine])
            of_ray = (weights @ nodes[:, -3:].reshape(len(nodes), -1)).reshape(len(mine), 3, -1)
            yield mine, of_ray + by_t[mine, :, None] * along[:, None]

    def moved(self, xy_px: Array, t: Array, sensitivity: Array, by_t: Array) -> Array:
        """How all of the object points move (n, 3, q)."""
        found = np.zeros((len(t), 3, self.root.shape[1]))
        for mine, point in self.moved_points(xy_px, t, sensitivity, by_t):
            found[mine] = point
        return found

    def _cells(self, xy_px: Array, t: Array) -> Iterator[tuple[Index, Array, Array]]:
        """Pixels of one cell after the other, their weights (m, 8) of its nodes, and the nodes' factors."""
        factors = self.partials @ self.root
        rows, columns, levels = factors.shape[:3]
        v, u = xy_px[:, 1] / self.steps_px[0], xy_px[:, 0] / self.steps_px[1]
        j, i = (np.clip(np.floor(x), 0, n - 2).astype(int) for x, n in ((v, rows), (u, columns)))
        level = np.clip((t - self.t0) / self.dt, 0, levels - 1)
        at = np.clip(np.floor(level), 0, levels - 2).astype(int)
        cells = rows - 1, columns - 1, levels - 1
        for cell, mine in enumerate(rows_of_each(np.ravel_multi_index((j, i, at), cells), int(np.prod(cells)))):
            if not len(mine):
                continue
            row, column, first = (int(n) for n in np.unravel_index(cell, cells))
            nodes = factors[row : row + 2, column : column + 2, first : first + 2].reshape(8, *factors.shape[3:])
            down, right, deep = v[mine] - row, u[mine] - column, level[mine] - first
            weights = [
                (down if y else 1 - down) * (right if x else 1 - right) * (deep if z else 1 - deep)
                for y, x, z in product((0, 1), repeat=3)
            ]
            yield mine, np.stack(weights, axis=1), nodes


def _along(weights: Array, nodes: Array, k: Array) -> Array:
    """(m, q) how depths move with each independent error, by sensitivities (m, 2s) and weights (m, 8) of nodes."""
    both = (weights[:, :, None] * k[:, None, :]).reshape(len(k), -1)
    return both @ nodes[:, :-3].reshape(both.shape[1], -1)


def shift_covariance(
    block: Block, joint: JointOrientation, reference: int, sources: Sequence[int], t_range: tuple[float, float]
) -> ShiftCovariance:
    """How the places of a reference's points in its sources are uncertain together.

    block    the adjusted one, whose orientations `joint` is of
    joint    of the reference and all its sources at least
    t_range  smallest and largest depth parameter

    Raises InputError for a reference that has no orientation.
    """
    rays = ReferenceRays.of(block, reference)
    width, height = rays.camera.width_px, rays.camera.height_px
    step = max(width, height) / (NODES - 1)
    columns, rows = (max(2, int(np.ceil(n / step)) + 1) for n in (width, height))
    steps = height / (rows - 1), width / (columns - 1)
    v, u, t = np.meshgrid(
        np.arange(rows) * steps[0], np.arange(columns) * steps[1], np.linspace(*t_range, LEVELS), indexing="ij"
    )
    xy, levels = np.stack([u.ravel(), v.ravel()], axis=1), t.ravel()
    std = np.sqrt(np.maximum(np.diagonal(joint.covariance), 0.0))
    views = {
        i: _View(camera=block.camera_of(i), rotation=block.images.rotation[i], centre=block.images.centre[i])
        for i in (reference, *sources)
    }
    xyz, places = _seen(rays, views, reference, sources, xy, levels)
    J = np.zeros((len(xy), 2 * len(sources), len(std)))
    A = np.zeros((len(xy), 3, len(std)))
    for k, one in enumerate(joint.steps):
        moved = [i for i in one.images if i in views]
        if not moved or std[k] == 0:
            continue
        changed = {**views, **{i: views[i].stepped(one, SHARE * std[k]) for i in moved}}
        at, there = _seen(rays, changed, reference, sources, xy, levels)
        A[:, :, k] = (at - xyz) / (SHARE * std[k])
        J[:, :, k] = (there - places) / (SHARE * std[k])
    # a place that a source does not see has no shift that matters
    J = np.where(np.isfinite(J), J, 0.0)
    partials = np.concatenate([J, A], axis=1)
    return ShiftCovariance(
        partials=partials.reshape(rows, columns, LEVELS, *partials.shape[1:]), root=root_of(joint.covariance),
        unknowns=joint.unknowns, steps_px=steps, t0=t_range[0], dt=(t_range[1] - t_range[0]) / (LEVELS - 1),
    )  # fmt: skip


def root_of(covariance: Array) -> Array:
    """(k, k) R with R R' = the covariance, which may be singular."""
    values, vectors = np.linalg.eigh(covariance) if len(covariance) else (np.zeros(0), np.zeros((0, 0)))
    return vectors * np.sqrt(np.maximum(values, 0.0))


@dataclass(frozen=True, slots=True, kw_only=True)
class CommonRoot:
    """Independent errors behind all orientations of a surface, so that what its references share is known."""

    unknowns: Index
    """(k,) numbers in the adjustment, ascending"""
    root: Array
    """(k, q) root root' is their covariance, or an estimate of it by q draws"""

    def as_arrays(self) -> dict[str, Array]:
        """What a store keeps."""
        return {"unknowns": self.unknowns, "root": self.root}

    @classmethod
    def of_arrays(cls, a: Mapping[str, Array]) -> CommonRoot:
        """That of `as_arrays`."""
        return cls(unknowns=np.asarray(a["unknowns"]), root=np.asarray(a["root"]))

    @classmethod
    def of(cls, joint: JointOrientation) -> CommonRoot:
        """Exact where there are no more unknowns than `MOST_ERRORS`, else projected on so many at random.

        A variance by projections on q independent directions has a relative standard deviation of sqrt(2 / q)
        (Hutchinson 1990): 9 % of 256, or 4 % of the standard deviation that follows.
        """
        order = np.argsort(joint.unknowns)
        root = root_of(joint.covariance)[order]
        if root.shape[1] > MOST_ERRORS:
            directions = np.random.default_rng(len(order)).normal(size=(root.shape[1], MOST_ERRORS))
            root = root @ directions / np.sqrt(MOST_ERRORS)
        return cls(unknowns=joint.unknowns[order], root=root)


@dataclass(frozen=True, slots=True, kw_only=True)
class _View:
    camera: Camera
    rotation: Array
    centre: Array

    def stepped(self, step: Step, by: float) -> _View:
        """One unknown changed."""
        if step.axis < 0:
            values = {**self.camera.values, step.symbol: self.camera.values[step.symbol] + by}
            return replace(self, camera=replace(self.camera, values=values))
        vector = np.zeros(3)
        vector[step.axis % 3] = by
        if step.axis < 3:
            return replace(self, centre=self.centre + vector)
        return replace(self, rotation=rotation_from_vector(vector[None])[0] @ self.rotation)


def _seen(
    rays: ReferenceRays, views: dict[int, _View], reference: int, sources: Sequence[int], xy: Array, t: Array
) -> tuple[Array, Array]:
    """Object points (n, 3) of a reference's pixels, and their places (n, 2s) in the sources."""
    own = views[reference]
    xyz = rays.moved(own.camera, own.rotation, own.centre).points(xy, t)
    places = [image_points(views[i].camera, views[i].rotation, views[i].centre, xyz) for i in sources]
    return xyz, np.concatenate(places, axis=1)
