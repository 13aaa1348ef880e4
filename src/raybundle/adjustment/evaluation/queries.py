"""Questions to a finished adjustment: any covariance, another datum, separability; nothing is adjusted again."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from raybundle.adjustment.evaluation.joint_cofactors import design_rows
from raybundle.adjustment.evaluation.tie_roughness import widened
from raybundle.adjustment.statistics.covariances import cofactors_with, own_thing
from raybundle.adjustment.statistics.noise import spread_in_datum
from raybundle.adjustment.statistics.precision import image_unknowns, interior_unknowns, precision
from raybundle.adjustment.statistics.system_state import Work
from raybundle.adjustment.system.assemble import State
from raybundle.adjustment.system.datum import Datum
from raybundle.adjustment.system.transformation import transformation
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.rows import rows_of_largest

if TYPE_CHECKING:
    from raybundle.adjustment.records.figures import ObservationStatistics, Precision
    from raybundle.adjustment.result import Adjustment

SUSPECTS = 20
"""Largest number of suspects whose separability is listed."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Step:
    """One unknown of an orientation, as the adjustment steps along it."""

    images: tuple[int, ...]
    """whose projection it changes, of those that were asked for"""
    axis: int = -1
    """0 to 2: the projection centre; 3 to 5: a small rotation on the left, exp([step]x) R [rad]; -1: interior"""
    symbol: str = ""
    """of an interior orientation's parameter"""


@dataclass(frozen=True, slots=True, kw_only=True)
class JointOrientation:
    """How exterior and interior orientations of some images are uncertain together."""

    steps: tuple[Step, ...]
    """(k,) what is free; what is held is not among them"""
    covariance: Array
    """(k, k) a-posteriori, in the result's datum"""
    unknowns: Index
    """(k,) their numbers in the adjustment: the same for whichever images are asked for"""


def joint_orientation(result: Adjustment, images: Sequence[int]) -> JointOrientation:
    """The joint covariance of all that projects into some images: exterior and interior orientations.

    images  rows of the block's images that took part
    raises  InputError for an image that did not

    In the steps of the adjustment, not in angles: nothing is singular where an axis lies along X.
    """
    work, state = _work(result)
    system, block = work.system, work.system.block
    unknowns, steps = list[int](), list[Step]()
    of_row = dict[int, list[int]]()
    for i in images:
        if not system.images_used[i]:
            raise InputError("query.image_without_part", image=block.images.ids[i])
        if system.exterior_free[i]:
            unknowns.extend(image_unknowns(system, i).tolist())
            steps.extend(Step(images=(i,), axis=axis) for axis in range(6))
        for row, _ in system.sources(int(system.interior_of_image[i])):
            of_row.setdefault(row, []).append(i)
    for r, mine in sorted(of_row.items()):
        row = system.interior[r]
        if row.node >= 0:
            unknowns.extend(interior_unknowns(system, row).tolist())
            names = row.model.symbols
            steps.extend(Step(images=tuple(mine), symbol=names[k]) for k in row.free)
    nodes, _ = cofactors_with(work, state, [("node", u, 0) for u in unknowns])
    Q = nodes[unknowns]
    return JointOrientation(
        steps=tuple(steps), covariance=_variance(result) * (Q + Q.T) / 2, unknowns=np.array(unknowns, np.int64)
    )


def own_values(result: Adjustment, name: str) -> Array:
    """Adjusted values (w,) of an unknown that a kind of observation has for itself, in the frame of the object.

    name    KIND:NAME, as "plane:floor"; the values are those that the kind states (`ObservationKind.own_start`)
    raises  InputError for a name that took no part
    Their covariance is that of the small steps that the kind takes: `result.covariance(name, name)`.
    """
    work, state = _work(result)
    found = own_thing(work.system, name)
    if found is None:
        raise InputError("query.unknown_own", name=name)
    part, k = found
    return part.kind.own_placed(state.own[part.kind.name], 1.0, np.eye(3), work.system.shift)[k]


def precision_in_datum(result: Adjustment, datum_points: tuple[str, ...]) -> Precision:
    """Covariances of points, images and cameras under inner constraints over these points (S-transformation).

    Only what the observations leave open is taken from the points; residuals and sigma0 do not change.
    """
    work, state = _work(result)
    index = {name: i for i, name in enumerate(work.system.block.points.ids)}
    missing = [p for p in datum_points if p not in index or not work.system.points_used[index[p]]]
    if missing:
        raise InputError("datum.unknown_points", n=len(missing), points=missing)
    if work.datum.defect == 0:
        raise InputError("datum.fixed")
    carriers = np.zeros(len(index), bool)
    carriers[[index[p] for p in datum_points]] = True
    datum = Datum(
        kind="inner", basis=work.datum.basis, centre=work.datum.centre, extent=work.datum.extent, carriers=carriers
    )
    assert work.found is not None
    rough = None if result.precision is None else result.precision.roughness
    if work.spread is not None:
        found = spread_in_datum(work.spread, work.found, datum)
    else:
        change = transformation(work.normals, state, datum)
        assert change is not None
        points_h = work.normals.solve_points(state, change.nodes_h, change.given)
        points_h[work.normals.system.held] = 0
        change = change.with_points(points_h)
        points = change.apply_own(work.found.points_minimal)
        found = replace(work.found, transformation=change, points=points)
    changed = precision(work.normals, state, found, _variance(result))
    return changed if rough is None else widened(changed, rough)


def _work(result: Adjustment) -> tuple[Work, State]:
    if result.handle.work is None:
        raise InputError("adjustment.no_statistics")
    return result.handle.work, result.handle.work.state


def _variance(result: Adjustment) -> float:
    return result.variance_factor


def suspects(
    work: Work, state: State, statistics: ObservationStatistics, critical: float
) -> tuple[tuple[str, str, float, float], ...]:
    """Suspects and their separability: image, point, |w|, and the largest correlation of w with another suspect's.

    Correlation of the test values (Förstner 1983): near 1 the test cannot show which of the two is wrong.
    """
    system = work.system
    size = np.nan_to_num(np.abs(statistics.t[system.rows]))
    chosen = rows_of_largest(size.max(axis=1), SUSPECTS)
    chosen = chosen[size[chosen].max(axis=1) > critical]
    if not len(chosen):
        return ()
    axis = size[chosen].argmax(axis=1)
    Q = _residual_cofactor(work, state, chosen, axis)
    s = np.sqrt(np.maximum(np.diagonal(Q), 1e-300))
    rho = np.abs(Q / np.outer(s, s))
    np.fill_diagonal(rho, 0)
    block = system.block
    w = np.abs(statistics.w[system.rows])
    rows = system.rows[chosen]
    return tuple(
        (
            block.images.ids[block.observations.image[r]],
            block.points.ids[block.observations.point[r]],
            float(w[k, a]),
            float(rho[i].max()) if len(chosen) > 1 else 0.0,
        )
        for i, (r, k, a) in enumerate(zip(rows, chosen, axis, strict=True))
    )


def _residual_cofactor(work: Work, state: State, chosen: Array, axis: Array) -> Array:
    """Cofactors (k, k) of whitened residuals: I - A Q A'."""
    system, k = work.system, np.arange(len(chosen))
    by_point, columns, by_node = design_rows(system, state, chosen)
    point = system.block.observations.point[system.rows[chosen]]
    nodes = np.zeros((int(system.offsets[-1]), len(k)))
    points = np.zeros((*state.xyz.shape, len(k)))
    row, at = np.nonzero(columns >= 0)
    np.add.at(nodes, (columns[row, at], row), by_node[row, axis[row], at])
    points[point, :, k] = np.where(system.held[point], 0.0, by_point[k, axis])
    x, y = work.normals.solve(state, nodes, points)
    return np.eye(len(k)) - nodes.T @ x - np.einsum("pek,pel->kl", points, y)


@dataclass(frozen=True, slots=True, kw_only=True)
class NamedCovariance:
    """A covariance matrix and what its rows are."""

    names: tuple[str, ...]
    """(k,) "point:7:X", "image:DSC01:kappa", "camera:1:c" """
    matrix: Array
    """(k, k) a-posteriori, in the result's datum; rad, units of the block and of the parameters"""

    @property
    def std(self) -> dict[str, float]:
        """Standard deviations by name."""
        return dict(zip(self.names, np.sqrt(np.maximum(np.diag(self.matrix), 0)).tolist(), strict=True))


def covariance(result: Adjustment, names: Sequence[str]) -> NamedCovariance:
    """The joint covariance of several objects of an adjustment, with the names of its rows.

    names   "point:7", "image:DSC01", "camera:1", as `Adjustment.covariance` takes them
    raises  InputError for names that took no part
    """
    blocks = [[result.covariance(a, b) for b in names[k:]] for k, a in enumerate(names)]
    full = [[blocks[i][j - i] if j >= i else blocks[j][i - j].T for j in range(len(names))] for i in range(len(names))]
    matrix = np.block(full) if names else np.zeros((0, 0))
    rows = [f"{name}:{c}" for k, name in enumerate(names) for c in _components(result, name, len(blocks[k][0]))]
    return NamedCovariance(names=tuple(rows), matrix=matrix)


def _components(result: Adjustment, name: str, count: int) -> Sequence[str]:
    """What the components of a named object are called."""
    kind, _, identity = name.partition(":")
    if kind == "point":
        return "XYZ"
    if kind == "image":
        return ("X0", "Y0", "Z0", "omega", "phi", "kappa")
    if kind == "camera":
        work, _ = _work(result)
        row = next(r for r in work.system.interior if r.key(work.system.block) == identity)
        return [row.model.parameters[k].symbol for k in row.free]
    return [str(k) for k in range(count)]
