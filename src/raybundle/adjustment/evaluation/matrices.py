"""The matrices of an adjustment, sparse, with names of rows and columns: for checks, teaching, own statistics."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from raybundle.adjustment.statistics.precision import angle_form, image_unknowns, interior_unknowns
from raybundle.adjustment.system.assemble import State, System
from raybundle.adjustment.system.images_numpy import image_residuals
from raybundle.adjustment.system.normals import Normals, point_prior
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.platforms.station import station_partials

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment

ANGLES = ("omega", "phi", "kappa")


@dataclass(frozen=True, slots=True, kw_only=True)
class Matrices:
    """v = A dx + ..., weights P, at the adjusted values.

    Image observations are in pixels, y down; angles in radians; lengths in the block's unit; parameters of interior
    orientations in their own.
    """

    design: Any
    """A (m, u), scipy.sparse csr: derivatives of the observations by the unknowns"""
    weights: Any
    """P (m, m), scipy.sparse csr: inverse of the covariances that were stated, a-priori sigma0 of 1"""
    residuals: Array
    """v (m,) adjusted - observed"""
    observations: tuple[str, ...]
    """(m,) "IMAGE/POINT:x", "IMAGE/POINT:y", "control POINT:X", "distance A-B:length" ..."""
    unknowns: tuple[str, ...]
    """(u,) "image NAME:X0" ... ":kappa", "camera NAME:c", "point NAME:X" ..."""

    @property
    def normal(self) -> Any:
        """N = A' P A (u, u), scipy.sparse csc; singular by the datum's defect where nothing fixes the datum."""
        return (self.design.T @ self.weights @ self.design).tocsc()


def matrices(result: Adjustment) -> Matrices:
    """Design matrix, weights and residuals of a finished adjustment, with names.

    raises  InputError for a copy of a result, or one without statistics

    Limits: the datum's constraints, which are no observations, and the enlargement of covariances by
    noise that is not white (`Adjustment.noise`).
    """
    work = result.handle.work
    if work is None:
        raise InputError("adjustment.no_statistics")
    system, state = work.system, work.state
    columns, names = _unknowns(system)
    rows = [
        _image_rows(system, state, columns),
        _prior_rows(system, state, columns),
        _extra_rows(work.normals, state),
    ]
    return _joined(rows, names, _angles(system, state))


@dataclass(frozen=True, slots=True)
class _Columns:
    """Where each unknown stands."""

    nodes: int
    points: Index
    """(p, 3) column of each coordinate of eliminated points, -1 where it is none"""


@dataclass(frozen=True, slots=True)
class _Rows:
    row: Array
    column: Array
    value: Array
    weights: list[tuple[Array, Array, Array]]
    """rows, columns and values of weights"""
    residuals: Array
    names: list[str]


def _unknowns(system: System) -> tuple[_Columns, list[str]]:
    """Columns of all unknowns, and their names."""
    block, N = system.block, int(system.offsets[-1])
    names = [""] * N
    for i in np.flatnonzero(system.images_used):
        if system.exterior_free[i]:
            for at, what in zip(image_unknowns(system, int(i)), ("X0", "Y0", "Z0", *ANGLES), strict=True):
                names[int(at)] = f"image {block.images.ids[i]}:{what}"
    for row in system.interior:
        if row.node >= 0:
            for at, k in zip(interior_unknowns(system, row), row.free, strict=True):
                names[int(at)] = f"camera {row.key(block)}:{row.model.parameters[k].symbol}"
    for p in np.flatnonzero(system.point_node >= 0):
        start = int(system.offsets[system.point_node[p]])
        for e, axis in enumerate("XYZ"):
            names[start + e] = f"point {block.points.ids[p]}:{axis}"
    for part in system.extra.parts:
        if part.kind.own_width:
            of = part.kind.own(part.table, system.extra.scope)
            for name, at in zip(of, system.own_columns(part.kind), strict=True):
                for k, c in enumerate(at):
                    names[int(c)] = f"{part.kind.name} {name}:{k}"
    eliminated = system.points_used & (system.point_node < 0)
    free = ~system.control_held & eliminated[:, None]
    points = np.full(free.shape, -1, np.int64)
    points[free] = N + np.arange(int(free.sum()))
    names += [f"point {block.points.ids[p]}:{'XYZ'[e]}" for p, e in np.argwhere(free).tolist()]
    return _Columns(N, points), names


def _image_rows(system: System, state: State, columns: _Columns) -> _Rows:
    """Two rows an image observation, in pixels."""
    o = system.block.observations
    image, point = o.image[system.rows], o.point[system.rows]
    v, D, P, _ = image_residuals(system, state, image, point, system.xy_mm)
    by_station, by_point = station_partials(state.rotation[image], P[:, None], D[:, :, :3])
    per = 1 / system.pixel_mm
    row, column, value = list[Array](), list[Array](), list[Array]()
    m = len(image)
    at = 2 * np.arange(m)

    def put(mine: Array, where: Array, derivative: Array) -> None:
        """Derivatives (k, 2, n) of rows `mine` by the unknowns (k, n); -1: none."""
        free = where >= 0
        for axis in (0, 1):
            row.append(np.broadcast_to((at[mine] + axis)[:, None], where.shape)[free])
            column.append(where[free])
            value.append((derivative[:, axis] * per[mine, axis, None])[free])

    free = np.flatnonzero(system.exterior_free[image])
    start = system.offsets[system.image_node[image[free]]]
    put(free, start[:, None] + np.arange(6), by_station[free])
    for r, interior in enumerate(system.interior):
        parents = [k for k in (r, interior.parent) if k >= 0]
        mine = np.flatnonzero(system.interior_of_image[image] == r)
        for k in parents:
            own = system.interior_columns[k]
            where = np.broadcast_to(own, (len(mine), len(own)))
            put(mine, where, D[mine][:, :, 3 : 3 + len(own)])
    kept = system.point_node[point] >= 0
    to_node = np.flatnonzero(kept)
    where = system.offsets[system.point_node[point[to_node]]][:, None] + np.arange(3)
    put(to_node, np.where(system.control_held[point[to_node]], -1, where), by_point[to_node])
    rest = np.flatnonzero(~kept)
    put(rest, columns.points[point[rest]], by_point[rest])
    w = system.whiten
    root = np.zeros((m, 2, 2))
    root[:, 0, 0], root[:, 1, 0], root[:, 1, 1] = w.T
    root = root / per[:, None, :]
    pair = at[:, None] + np.arange(2)
    weights = [_square(pair, np.swapaxes(root, 1, 2) @ root)]
    ids, points = system.block.images.ids, system.block.points.ids
    names = [f"{ids[i]}/{points[p]}:{a}" for i, p in zip(image.tolist(), point.tolist(), strict=True) for a in "xy"]
    return _Rows(np.concatenate(row), np.concatenate(column), np.concatenate(value), weights, (v * per).ravel(), names)


def _square(rows: Array, W: Array) -> tuple[Array, Array, Array]:
    """Rows, columns and values of weights (n, k, k) of rows (n, k) that are weighted together."""
    return (
        np.broadcast_to(rows[:, :, None], W.shape).ravel(), np.broadcast_to(rows[:, None], W.shape).ravel(), W.ravel()
    )  # fmt: skip


def _prior_rows(system: System, state: State, columns: _Columns) -> _Rows:
    """Coordinates of eliminated points that are observed."""
    weight, value = point_prior(system)
    eliminated = system.points_used & (system.point_node < 0)
    at = np.argwhere(system.prior & eliminated[:, None] & (columns.points >= 0))
    column = columns.points[at[:, 0], at[:, 1]]
    rows = np.arange(len(at))
    ids = system.block.points.ids
    return _Rows(
        rows, column, np.ones(len(at)),
        [(rows, rows, weight[at[:, 0], at[:, 1]])],
        (state.xyz - value)[at[:, 0], at[:, 1]], [f"control {ids[p]}:{'XYZ'[e]}" for p, e in at.tolist()],
    )  # fmt: skip


def _extra_rows(normals: Normals, state: State) -> _Rows:
    """Observations outside the images, in their own units."""
    system, extra = normals.system, normals.system.extra
    e = normals.standardised(state, system.control_held)
    together: dict[int, list[int]] = {}
    for k, group in enumerate(extra.group_of_row().tolist()):
        together.setdefault(int(group), []).append(k)
    joint = {int(j.rows[0]): j for j in extra.correlated}
    weights = list[tuple[Array, Array, Array]]()
    for group, rows in together.items():
        at = np.array(rows)
        W = joint[group].weight if group in joint else np.eye(len(at))
        weights.append(_square(at[None], (W / np.outer(extra.sigma[at], extra.sigma[at]))[None]))
    names: list[str] = []
    for part in extra.parts:
        named = part.kind.named(part.table, part.rows, extra.scope)
        names += [f"{part.kind.name} {i}:{c}" for i, c in zip(named.ids, named.component, strict=True)]
    value, residual = e.value * extra.sigma[e.row], e.residual * extra.sigma
    return _Rows(np.asarray(e.row, np.int64), e.unknown, value, weights, residual, names)


def _angles(system: System, state: State) -> list[tuple[Array, Array]]:
    """Of each free image the columns of its rotation, and d (small rotation) / d (omega, phi, kappa)."""
    return [
        (image_unknowns(system, int(i))[3:], np.linalg.inv(angle_form(state.rotation[i])[3:, 3:]))
        for i in np.flatnonzero(system.images_used)
        if system.exterior_free[i]
    ]


def _joined(parts: list[_Rows], names: list[str], angles: list[tuple[Array, Array]]) -> Matrices:
    """All rows one after another; rotations by omega, phi, kappa."""
    from scipy.sparse import csr_matrix

    start = np.cumsum([0, *(len(p.residuals) for p in parts)])
    m, u = int(start[-1]), len(names)
    row = np.concatenate([p.row + s for p, s in zip(parts, start, strict=False)]).astype(np.int64)
    column = np.concatenate([p.column for p in parts]).astype(np.int64)
    A: Any = csr_matrix((np.concatenate([p.value for p in parts]), (row, column)), shape=(m, u))
    others = np.setdiff1d(np.arange(u), [c for at, _ in angles for c in at])
    turned = [_square(at[None], D[None]) for at, D in angles]
    r, c, D = (np.concatenate(v) for v in zip((others, others, np.ones(len(others))), *turned, strict=True))
    turn: Any = csr_matrix((D, (r, c)), shape=(u, u))
    places = [(r + s, c + s, W) for p, s in zip(parts, start, strict=False) for r, c, W in p.weights]
    r, c, W = (np.concatenate(values) for values in zip(*places, strict=True))
    P: Any = csr_matrix((W, (r, c)), shape=(m, m))
    return Matrices(
        design=(A @ turn).tocsr(), weights=P, residuals=np.concatenate([p.residuals for p in parts]),
        observations=tuple(n for p in parts for n in p.names), unknowns=tuple(names),
    )  # fmt: skip
