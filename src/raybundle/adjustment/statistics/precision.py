"""Cofactors of the unknowns, from the factor of the last step; nothing is held fixed to get them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.records.figures import Precision
from raybundle.adjustment.system.assemble import InteriorRow, State, System
from raybundle.adjustment.system.datum import Datum, Transformation
from raybundle.adjustment.system.normals import Normals
from raybundle.adjustment.system.transformation import transformation
from raybundle.numerics import large
from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import angle_derivatives


@dataclass(slots=True)
class Cofactors:
    """Selected blocks of the cofactor matrix, a-priori sigma0 = 1."""

    inverse: Array
    """Selected inverse in the layout of the normal matrix, datum of the factor."""
    transformation: Transformation | None
    points_minimal: Array
    """(p, 3, 3) datum of the factor"""
    points: Array
    """(p, 3, 3) datum of the result"""
    hat: Array
    """(m, 3) diagonal and off-diagonal of A Q A' of each whitened image point"""
    effect: Array
    """(m, 3, 2) effect of a whitened unit blunder on its object point, datum of the result"""


def cofactors(normals: Normals, state: State, datum: Datum) -> Cofactors:
    """All selected cofactors; `normals` holds the undamped factor in its minimal datum."""
    system = normals.system
    inverse = normals.selected_inverse()
    change = transformation(normals, state, datum)
    points_minimal, hat, effect, points_h = normals.statistics(state, inverse, change)
    seen = np.zeros(len(system.points_used), bool)
    seen[system.block.observations.point[system.rows]] = True
    for p in np.flatnonzero(system.points_used & ~seen & (system.point_node >= 0)):  # no ray, and a node of its own
        node = int(system.point_node[p])
        points_minimal[p] = normals.node_block(inverse, node, node)
        if change is not None:
            points_h[p] = change.nodes_h[system.offsets[node] + np.arange(3)]
    held = system.held
    if held.any():
        points_minimal = points_minimal * ~held[:, :, None] * ~held[:, None, :]
    points = points_minimal
    if change is not None:
        change = change.with_points(points_h)
        points = change.apply_own(points_minimal)
    return Cofactors(inverse, change, points_minimal, points, hat, effect)


def node_cofactor(normals: Normals, found: Cofactors, unknowns: Array) -> Array:
    """Cofactor (k, k) of unknowns of nodes, datum of the result; their nodes must meet in the normal matrix."""
    return cross_cofactor(normals, found, unknowns, unknowns)


def cross_cofactor(normals: Normals, found: Cofactors, first: Array, second: Array) -> Array:
    """Cofactor (k, l) between unknowns of two nodes, datum of the result."""
    offsets = normals.system.offsets
    a = int(np.searchsorted(offsets, first[0], side="right") - 1)
    b = int(np.searchsorted(offsets, second[0], side="right") - 1)
    block = normals.node_block(found.inverse, a, b)[np.ix_(first - offsets[a], second - offsets[b])]
    t = found.transformation
    if t is None:
        return block
    return t.apply(block, t.nodes[first], t.nodes_h[first], t.nodes[second], t.nodes_h[second])


def image_unknowns(system: System, image: int) -> Array:
    """The six unknowns of an image's exterior orientation."""
    return system.offsets[system.image_node[image]] + np.arange(6)


def interior_unknowns(system: System, row: InteriorRow) -> Array:
    """The unknowns of an interior orientation."""
    return system.offsets[row.node] + row.start + np.arange(len(row.free))


def angle_form(rotation: Array) -> Array:
    """D (X, Y, Z, omega, phi, kappa) / d (X, Y, Z, delta), (6, 6)."""
    D = np.eye(6)
    D[3:, 3:] = angle_derivatives(rotation)
    return D


def precision(normals: Normals, state: State, found: Cofactors, variance: float) -> Precision:
    """Covariances of points, images and interior orientations; `variance` is sigma0 squared."""
    system, block = normals.system, normals.system.block
    points = large.full(found.points.shape, np.nan)
    for some in large.pieces(len(points)):
        points[some] = np.where(system.points_used[some, None, None], found.points[some] * variance, np.nan)
    images = np.full((len(block.images), 6, 6), np.nan)
    used = np.flatnonzero(system.images_used)
    for i in used:
        if system.exterior_free[i]:
            D = angle_form(state.rotation[i])
            images[i] = variance * D @ node_cofactor(normals, found, image_unknowns(system, int(i))) @ D.T
        else:
            images[i] = 0.0
    interior: dict[str, Array] = {}
    parameters: dict[str, tuple[str, ...]] = {}
    cross: dict[str, Array] = {}
    for r, row in enumerate(system.interior):
        key = row.key(block)
        parameters[key] = tuple(row.model.symbols[k] for k in row.free) if row.node >= 0 else ()
        if row.node < 0 or not row.free:
            interior[key] = np.zeros((0, 0))
            cross[key] = np.zeros((0, 0, 6))
            continue
        mine = interior_unknowns(system, row)
        Q = node_cofactor(normals, found, mine)
        interior[key] = variance * Q
        rows: list[Array] = []
        for i in system.images_of(r)[system.exterior_free[system.images_of(r)]]:
            C = cross_cofactor(normals, found, mine, image_unknowns(system, int(i))) @ angle_form(state.rotation[i]).T
            with np.errstate(invalid="ignore", divide="ignore"):
                s = np.sqrt(np.outer(np.diagonal(Q), np.diagonal(images[i]) / variance if variance > 0 else np.ones(6)))
                rows.append(C / s)
        cross[key] = np.array(rows).reshape(-1, len(mine), 6)
    return Precision(
        object_points=points, images=images, interior=interior, parameters=parameters, interior_exterior=cross
    )


def interior_precision(normals: Normals, state: State, found: Cofactors, variance: float) -> Precision:
    """Covariances of the interior orientations alone; those of points and images are NaN."""
    del state
    system, block = normals.system, normals.system.block
    interior: dict[str, Array] = {}
    parameters: dict[str, tuple[str, ...]] = {}
    for row in system.interior:
        key, free = row.key(block), row.node >= 0 and bool(row.free)
        parameters[key] = tuple(row.model.symbols[k] for k in row.free) if free else ()
        Q = node_cofactor(normals, found, interior_unknowns(system, row)) if free else np.zeros((0, 0))
        interior[key] = variance * Q
    return Precision(
        object_points=np.full((len(block.points), 3, 3), np.nan), images=np.full((len(block.images), 6, 6), np.nan),
        interior=interior, parameters=parameters, interior_exterior={},
    )  # fmt: skip
