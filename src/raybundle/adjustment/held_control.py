"""Held control: whether image points and distances want a point elsewhere, by the force that holds it there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.assemble import State, System
from raybundle.adjustment.queries import design_row
from raybundle.adjustment.result import Adjustment, Notice
from raybundle.adjustment.work import Work
from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import fisher_tail

MOST = 40
"""Held points that are tested, those on which the strongest forces act."""
CONTROLLED = 1e-6
"""Share of a direction's information that must show in the residuals for it to be tested.

What is formed as a difference of two cofactors carries some 1e-13 of rounding times the condition of the part.
"""


@dataclass(frozen=True, slots=True, kw_only=True)
class HeldTest:
    """The test of one held point against all other observations."""

    point: int
    square: float
    """T, by how much the weighted square sum falls when the point is let go"""
    directions: int
    """k, how many of its held directions are controlled"""
    probability: float
    """Of so large an F if the coordinates are right"""
    shift: Array
    """(3,) where the observations want the point, minus given; 0 where not held [object unit]"""


def held_tests(result: Adjustment) -> tuple[HeldTest, ...]:
    """The tests of the held control points, the least probable first; () without statistics or held control.

    A held coordinate has no residual.  Let its error be a further unknown d with the partials H of the whitened
    observations: v = A dx + H d - l.  At the solution with d = 0 the force that holds the point is g = H'v (the
    Lagrange multiplier of the constraint), and its cofactor Q = H'Qvv H = H'H - H'A N^-1 A'H.  Letting the point go
    moves it by -Q^-1 g and takes T = g' Q^-1 g from the weighted square sum W (Baarda 1968 for one unknown, w = g /
    sqrt(Q); Teunissen 2000, sec. 4.3, for several).  As sigma0 is estimated, and an error of control is in it,

        F = (T / k) / ((W - T) / (r - k))

    is distributed as F(k, r - k) where the coordinates are right; k counts the directions that the others control.
    For an error so large that v is no longer linear in d, T is a first approximation.
    """
    work = result.work
    if work is None or result.redundancy < 2:
        return ()
    system = work.system
    held = system.control_held & system.points_used[:, None]
    points = np.flatnonzero(held.any(axis=1))
    if not len(points):
        return ()
    v, _ = work.normals.residuals(work.state)
    seen = _seen(work, points, v)
    first = sorted(seen, key=lambda s: -s.least)[:MOST]
    tests = [t for t in (_test(work, s, held[s.point], result) for s in first) if t is not None]
    return tuple(sorted(tests, key=lambda t: (t.probability, -t.square)))


def held_notices(result: Adjustment) -> list[Notice]:
    """The held point that contradicts the observations most, if one does beyond chance."""
    tests = held_tests(result)
    limit = result.options.significance / max(len(tests), 1)
    if not tests or tests[0].probability > limit:
        return []
    worst = tests[0]
    name, unit = result.given.points.ids[worst.point], result.given.length_unit
    moved = ", ".join(f"{axis} {d:+.3g}" for axis, d in zip("XYZ", worst.shift, strict=True) if d)
    return [
        Notice(
            code="control_suspect",
            message=f"control {name} is held, and the observations contradict it: they would have it elsewhere by "
            f"{moved} {unit}; so much by chance has a probability of {worst.probability:.1g} (limit {limit:.1g}). "
            "Check its coordinates and its number in the images, or give it a standard deviation",
            ids=(name,),
        )
    ]


@dataclass(slots=True)
class _Seen:
    """A held point, its rows and the force on it."""

    point: int
    rows: Array
    """positions in `System.rows`"""
    H: Array
    """(2 k, 3) whitened partials of its image points by its coordinates"""
    force: Array
    """(3,) of its image points"""
    least: float
    """T is no less"""


def _seen(work: Work, points: Array, v: Array) -> list[_Seen]:
    from raybundle.adjustment.twin import image_residuals  # noqa: PLC0415  (reads this layer's normals)

    system, state = work.system, work.state
    o = system.block.observations
    rows = np.flatnonzero(np.isin(o.point[system.rows], points))
    image, point = o.image[system.rows[rows]], o.point[system.rows[rows]]
    partials = image_residuals(system, state, image, point, system.xy_mm[rows])[1][:, :, :3] @ state.rotation[image]
    W = np.zeros((len(rows), 2, 2))
    W[:, 0, 0], W[:, 1, 0], W[:, 1, 1] = system.whiten[rows].T
    partials = W @ partials
    found: list[_Seen] = []
    for p in points:
        mine = np.flatnonzero(point == p)
        if not len(mine):
            continue
        H = partials[mine].reshape(-1, 3)
        force = H.T @ v[rows[mine]].ravel()
        least = float(force @ np.linalg.lstsq(H.T @ H, force, rcond=1e-12)[0])
        found.append(_Seen(int(p), rows[mine], H, force, least))
    return found


def _test(work: Work, seen: _Seen, held: Array, result: Adjustment) -> HeldTest | None:
    system, state, normals = work.system, work.state, work.normals
    axes = np.flatnonzero(held)
    H, force = seen.H[:, axes], seen.force[axes].copy()
    nodes = np.zeros((int(system.offsets[-1]), len(axes)))
    points = np.zeros((*state.xyz.shape, len(axes)))
    for k, row in enumerate(seen.rows):
        for a in range(2):
            at, values, _, by_point = design_row(system, state, int(row), a)
            np.add.at(nodes, at, np.outer(values, H[2 * k + a]))
            points[seen.point] += np.outer(by_point, H[2 * k + a])
    own = H.T @ H
    for r, partial in _distances(system, state, seen.point):
        e = normals.extra(state)
        mine = e.row == r
        h = partial[axes]
        np.add.at(nodes, e.unknown[mine], np.outer(e.value[mine], h))
        own += np.outer(h, h)
        force += h * e.residual[r]
    retained = system.point_node[seen.point]
    if retained >= 0:  # its free coordinates are unknowns of a node
        nodes[system.offsets[retained] + np.arange(3)] += points[seen.point] * ~system.held[seen.point][:, None]
        points[seen.point] = 0
    x, y = normals.solve(state, nodes, points)
    Q = own - nodes.T @ x - np.einsum("pek,pel->kl", points, y)
    scale = np.sqrt(np.maximum(np.diagonal(own), 1e-300))
    values, vectors = np.linalg.eigh(Q / np.outer(scale, scale))
    told = values > CONTROLLED
    count = int(told.sum())
    if not count or result.redundancy <= count:
        return None
    along = vectors[:, told].T @ (force / scale)
    square = float((along**2 / values[told]).sum())
    left = max(result.weighted_square_sum - square, 1e-12 * result.weighted_square_sum)
    F = (square / count) / (left / (result.redundancy - count)) if left > 0 else 0.0
    shift = np.zeros(3)
    shift[axes] = -(vectors[:, told] @ (along / values[told])) / scale
    return HeldTest(
        point=seen.point, square=square, directions=count,
        probability=fisher_tail(F, count, result.redundancy - count), shift=shift,
    )  # fmt: skip


def _distances(system: System, state: State, point: int) -> list[tuple[int, Array]]:
    """Rows of the extra observations that are distances from a point, and their whitened partials (3,) by it."""
    found: list[tuple[int, Array]] = []
    d = system.block.distances
    for r in np.flatnonzero(system.extra.kind == 1):
        k = int(system.extra.item[r])
        start, end = int(d.start[k]), int(d.end[k])
        if point in {start, end}:
            unit = state.xyz[end] - state.xyz[start]
            unit = unit / np.linalg.norm(unit) * (1 if point == end else -1)
            found.append((int(r), unit / system.extra.sigma[r]))
    return found
