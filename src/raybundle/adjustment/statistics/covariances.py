"""Any covariance of an adjusted system, by one solution of its normal equations."""

from __future__ import annotations

from functools import partial

import numpy as np

from raybundle.adjustment.statistics.precision import angle_form, image_unknowns, interior_unknowns
from raybundle.adjustment.statistics.system_state import Work
from raybundle.adjustment.system.assemble import State, System
from raybundle.adjustment.system.datum import Transformation
from raybundle.adjustment.system.other_observations import Part
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array

TOGETHER = 16
"""Right sides that the kernels solve at once."""


def covariance_of(work: Work, first: str, second: str) -> Array:
    """Covariance (k, l) of two named objects in the datum of the result, for a variance factor of 1.

    raises  InputError for names that took no part
    One solution of the normal equations, not a read-out: it exists for every pair, near or far.
    """
    a, Da = selection(work.system, work.state, first)
    b, Db = selection(work.system, work.state, second)
    nodes, points = cofactors_with(work, work.state, a)
    C = np.array([points[at, axis] if kind == "point" else nodes[at] for kind, at, axis in b]).T
    return Da @ C @ Db.T


def cofactors_with(work: Work, state: State, chosen: list[tuple[str, int, int]]) -> tuple[Array, Array]:
    """Columns of the inverse: cofactors (u, k) of all nodes and (p, 3, k) of all points with chosen unknowns."""
    system = work.system
    nodes = np.zeros((int(system.offsets[-1]), len(chosen)))
    points = np.zeros((*state.xyz.shape, len(chosen)))
    for k, (kind, at, axis) in enumerate(chosen):
        if kind == "point":
            points[at, axis, k] = 1
        else:
            nodes[at, k] = 1
    solve = work.spread.solve if work.spread is not None else partial(work.normals.solve, state)
    for start in range(0, len(chosen), TOGETHER):
        part = slice(start, start + TOGETHER)
        nodes[:, part], points[:, :, part] = solve(
            np.ascontiguousarray(nodes[:, part]), np.ascontiguousarray(points[:, :, part])
        )
    found = work.under_noise or work.found
    t = found.transformation if found else None
    if t is not None:
        Ga, Ha = _gauge(t, chosen)
        nodes, points = (
            Q - G @ t.middle @ Ha.T - H @ t.middle.T @ Ga.T + G @ (t.middle @ t.inner @ t.middle.T) @ Ga.T
            for Q, G, H in ((nodes, t.nodes, t.nodes_h), (points, t.points, t.points_h))
        )
    return nodes, points


def selection(system: System, state: State, name: str) -> tuple[list[tuple[str, int, int]], Array]:
    """Scalar unknowns of a named object and the derivative of its shown components by them."""
    kind, _, identity = name.partition(":")
    block = system.block
    if kind == "point" and identity in block.points.ids:
        p = block.points.ids.index(identity)
        if system.points_used[p]:
            if system.point_node[p] >= 0:
                start = int(system.offsets[system.point_node[p]])
                return [("node", start + e, e) for e in range(3)], np.eye(3)
            return [("point", p, e) for e in range(3)], np.eye(3)
    if kind == "image" and identity in block.images.ids:
        i = block.images.ids.index(identity)
        if system.images_used[i] and system.exterior_free[i]:
            unknowns = image_unknowns(system, i)
            return [("node", int(u), 0) for u in unknowns], angle_form(state.rotation[i])
    if kind == "camera":
        for row in system.interior:
            if row.key(block) == identity and row.node >= 0:
                unknowns = interior_unknowns(system, row)
                return [("node", int(u), 0) for u in unknowns], np.eye(len(unknowns))
    if (found := own_thing(system, name)) is not None:
        columns = system.own_columns(found[0].kind)[found[1]]
        return [("node", int(u), 0) for u in columns], np.eye(len(columns))
    raise InputError("query.unknown", name=name)


def own_thing(system: System, name: str) -> tuple[Part, int] | None:
    """The rows of a kind with unknowns of its own, and which of them has this name."""
    kind, _, identity = name.partition(":")
    part = system.extra.of(kind)
    if part is None or not part.kind.own_width:
        return None
    names = part.kind.own(part.table, system.extra.scope)
    return (part, names.index(identity)) if identity in names else None


def _gauge(t: Transformation, chosen: list[tuple[str, int, int]]) -> tuple[Array, Array]:
    G = np.array([t.points[at, axis] if kind == "point" else t.nodes[at] for kind, at, axis in chosen])
    H = np.array([t.points_h[at, axis] if kind == "point" else t.nodes_h[at] for kind, at, axis in chosen])
    return G, H
