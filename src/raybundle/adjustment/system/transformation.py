"""From a well-spread minimal datum to inner constraints: the S-transformation, and the fit to what was given."""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.system.assemble import State, System
from raybundle.adjustment.system.datum import Datum, Transformation, node_generators, point_generators
from raybundle.adjustment.system.normals import Normals
from raybundle.numerics import large
from raybundle.numerics.arrays import Array


def transformation(normals: Normals, state: State, datum: Datum) -> Transformation | None:
    """The S-transformation from the minimal datum of the factor to inner constraints over the carriers.

    H of the points and K are still missing: `with_points`.
    """
    if datum.defect == 0 or datum.kind != "inner":
        return None
    system = normals.system
    used = system.points_used
    d = datum.defect
    G = point_generators(state.xyz, datum.centre, datum.extent)
    if d < 7:
        G = (G.reshape(-1, 7) @ datum.basis).reshape(-1, 3, d)
    if not used.all():
        G[~used] = 0
    if system.control_held.any():
        G[system.control_held] = 0
    BG = G if datum.carriers.all() else large.kept(G * datum.carriers[:, None, None])
    nodes = node_generators(system, state, datum)
    # what is given for retained points is added to their nodes
    nodes_h = normals.solve_nodes(state, np.zeros_like(nodes), BG)
    middle = np.linalg.inv(BG.reshape(-1, d).T @ G.reshape(-1, d))
    none = np.zeros((0, 3, d))
    return Transformation(nodes, G, BG, nodes_h, none, middle, np.zeros((d, d)))


def fit_to_given(system: System, state: State, given: State, datum: Datum) -> State:
    """Move the adjusted block, within the open datum, onto the given coordinates of the carriers.

    Small transformations of the open generators are repeated until nothing moves: the inner
    constraints G'B (x - x_given) = 0 then hold for the adjusted coordinates themselves.
    """
    if datum.defect == 0 or datum.kind != "inner":
        return state
    from scipy.linalg import expm

    new = state
    carriers = np.flatnonzero(datum.carriers & system.points_used)
    for _ in range(50):
        G = point_generators(new.xyz[carriers], datum.centre, datum.extent).reshape(-1, 7) @ datum.basis
        gap = (given.xyz[carriers] - new.xyz[carriers]).reshape(-1)
        step = datum.basis @ np.linalg.lstsq(G, gap, rcond=None)[0]
        step /= max(1.0, np.abs(step).max())  # in parts, where a block is to become many times larger
        t, w, s = step[:3] * datum.extent, step[3:6], step[6]
        generator = np.zeros((4, 4))
        generator[:3, :3] = np.array([[s, -w[2], w[1]], [w[2], s, -w[0]], [-w[1], w[0], s]])
        generator[:3, 3] = t
        new = placed(system, new, expm(generator), datum.centre)
        if np.abs(step).max() < 1e-13:
            break
    held = system.control_held
    new.xyz[held] = state.xyz[held]
    return new


def placed(system: System, state: State, T: Array, centre: Array) -> State:
    """The state after a similarity of points, images, and lengths among the free parameters.

    T       (4, 4) homogeneous, of coordinates from `centre` (3,)
    """
    new = state.copy()
    scale = np.cbrt(np.linalg.det(T[:3, :3]))
    for values in (new.xyz, new.centre):
        values[:] = (values - centre) @ T[:3, :3].T + T[:3, 3] + centre
    new.rotation = new.rotation @ (T[:3, :3].T / scale)
    shift = T[:3, 3] + centre - T[:3, :3] @ centre
    new.own = {
        p.kind.name: p.kind.own_placed(new.own[p.kind.name], float(scale), T[:3, :3] / scale, shift)
        for p in system.extra.parts
        if p.kind.own_width
    }
    for r, row in enumerate(system.interior):
        for position in row.free:
            if row.model.parameters[position].is_length:
                new.interior[r, position] *= scale
    system.share(new)
    return new
