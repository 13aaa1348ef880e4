"""The datum: what of position, orientation and scale the observations leave open, and how it is taken.

The normal equations are factored in a minimal datum (the fewest coordinates of well-spread object
points held, as many as are open); every other datum follows by an S-transformation (Baarda 1973):
Q' = S Q S', S = I - G (G'BG)^-1 G'B, with G the open part of the null space and B selecting the
points that carry the datum.  Residuals do not depend on it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.assemble import State, System
from raybundle.errors import DatumDefect, InputError, Message, NotSolvable, message
from raybundle.numerics import large
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.statistics import chi_square_tails
from raybundle.sensors import SensorModel

NAMES = ("position X", "position Y", "position Z", "rotation X", "rotation Y", "rotation Z", "scale")
SHORT = ("tX", "tY", "tZ", "rX", "rY", "rZ", "m")
"""The same as symbols: shifts, rotations, scale"""
ABOUT_LINE = "rotation about a straight line"
STRAIGHT = 1e-2
"""Share of a radian by which a rotation may also shift along its axis or scale, as control is off a line by errors."""
GOOD = 2.0
"""Times the median standard deviation up to which a point counts as well determined."""
SPREAD = 0.05
"""Of the best held coordinate's part in the datum the last one has at least, or points of other observations are tried.

Points nearly in a line make the undamped factor lose digits by the inverse of it."""
FEWEST_CARRIERS = 10
"""Well-determined points below which all points carry the datum."""


@dataclass(slots=True)
class Datum:
    """The open part of the datum and how it is taken."""

    kind: str
    """control | minimal | inner"""
    basis: Array
    """(7, d) combinations of the seven generators that are open"""
    centre: Array
    extent: float
    carriers: Mask
    """(p,) points over which inner constraints are taken"""

    @property
    def defect(self) -> int:
        """Number of open datum parameters."""
        return self.basis.shape[1]

    @property
    def open_names(self) -> tuple[str, ...]:
        """The open parts in words, pure generators by name."""
        return open_names(self.basis)


def open_names(basis: Array) -> tuple[str, ...]:
    """Names of the generators in the span of a basis (7, d); mixtures as "combination of ..."."""
    if basis.shape[1] == 0:
        return ()
    projector = basis @ basis.T
    pure = np.diagonal(projector) > 1 - 1e-6
    names = [n for i, n in enumerate(NAMES) if pure[i]]
    mixed = [n for i, n in enumerate(NAMES) if 1e-3 < projector[i, i] <= 1 - 1e-6]
    rest = basis.shape[1] - len(names)
    if rest == 1 and _turns_about_a_line(np.linalg.svd(projector * ~pure * ~pure[:, None])[0][:, 0]):
        names.append(ABOUT_LINE)
    elif rest > 0:
        names.append(f"{rest} combination{'s' if rest > 1 else ''} of {', '.join(mixed)}")
    return tuple(names)


def open_part(name: str) -> Message:
    """The message that names an open part of the datum, by its name among `open_names`."""
    if name == ABOUT_LINE or name in NAMES:
        return message("datum.part", part="about_line" if name == ABOUT_LINE else name.replace(" ", "_").lower())
    number, _, of = name.partition(" ")
    among = [short for short, whole in zip(SHORT, NAMES, strict=True) if whole in of]
    return message("datum.combination", n=int(number), among=among)


def open_values(names: Sequence[str]) -> tuple[str, tuple[Message, ...]]:
    """The value `part` of a message on open parts of the datum, as of `datum.part`; and details that name several."""
    each = tuple(open_part(name) for name in names)
    single = len(each) == 1 and each[0].code == "datum.part"
    return (str(each[0].values["part"]), ()) if single else ("several", each)


def _turns_about_a_line(generator: Array) -> bool:
    """Whether a generator (7,) is a pure rotation: no change of scale, and no shift along its own axis.

    In a general frame its components change with the frame; what it is does not.
    """
    shift, turn, scale = generator[:3], generator[3:6], generator[6]
    size = float(np.linalg.norm(turn))
    return bool(size > STRAIGHT and abs(scale) < STRAIGHT * size and abs(shift @ turn) < STRAIGHT * size**2)


def point_generators(xyz: Array, centre: Array, extent: float) -> Array:
    """The seven generators at points (n, 3): (n, 3, 7), lengths in units of the extent."""
    r = (xyz - centre) / extent
    G = large.zeros((len(xyz), 3, 7))
    G[:, [0, 1, 2], [0, 1, 2]] = 1
    x, y, z = r.T
    G[:, 1, 3], G[:, 2, 3] = -z, y
    G[:, 0, 4], G[:, 2, 4] = z, -x
    G[:, 0, 5], G[:, 1, 5] = -y, x
    G[:, :, 6] = r
    G *= extent
    return G


def node_generators(system: System, state: State, datum: Datum) -> Array:
    """The open generators at the unknowns of the nodes: (N, d)."""
    G = np.zeros((int(system.offsets[-1]), 7))
    images = np.flatnonzero(system.exterior_free & system.images_used)
    at = system.offsets[system.image_node[images]][:, None] + np.arange(6)
    G[at[:, :3]] = point_generators(state.centre[images], datum.centre, datum.extent)
    # R_new = R exp(-[w]x) = exp(-[R w]x) R
    G[at[:, 3:], 3:6] = -state.rotation[images]
    points = np.flatnonzero(system.point_node >= 0)
    at = system.offsets[system.point_node[points]][:, None] + np.arange(3)
    G[at] = point_generators(state.xyz[points], datum.centre, datum.extent) * ~system.control_held[points][:, :, None]
    for r, row in enumerate(system.interior):
        if row.node < 0:  # an instrument of which nothing is observed
            continue
        for k, position in enumerate(row.free):
            if row.model.parameters[position].is_length:
                G[system.offsets[row.node] + row.start + k, 6] = state.interior[r, position]
    for part in system.extra.parts:
        if part.kind.own_width:
            moved = part.kind.own_generators(state.own[part.kind.name], datum.centre)
            G[system.own_columns(part.kind)] = moved * np.r_[np.full(3, datum.extent), np.ones(4)]
    return G if datum.defect == 7 else G @ datum.basis


def analyse(system: System, state: State, options: AdjustmentOptions) -> Datum:
    """Which of the seven datum parameters control, distances, stations and held images leave open."""
    used = system.points_used
    if not used.any():
        raise NotSolvable("adjustment.no_point")
    centre, extent = middle_and_extent(state.xyz[used])
    basis, kind = what_is_open(system, state, options, centre, extent)
    carriers = used.copy()
    if options.datum_points:
        index = {name: i for i, name in enumerate(system.block.points.ids)}
        missing = [name for name in options.datum_points if name not in index or not used[index[name]]]
        if missing:
            raise InputError("datum.unknown_points", n=len(missing), points=missing)
        carriers = np.zeros_like(used)
        carriers[[index[name] for name in options.datum_points]] = True
    elif options.datum_over == "good":
        carriers = _well_determined(system, state)
    datum = Datum(kind=kind, basis=basis, centre=centre, extent=extent, carriers=carriers)
    if datum.defect and kind == "inner":
        G = point_generators(state.xyz[carriers], centre, extent).reshape(-1, 7) @ basis / extent
        if np.linalg.matrix_rank(_folded(G), tol=1e-6 * max(len(G), 1) ** 0.5) < datum.defect:
            raise DatumDefect(
                "datum.too_few_points",
                points=int(carriers.sum()),
                constraints=datum.defect,
                details=map(open_part, datum.open_names),
            )
    return datum


def middle_and_extent(cloud: Array) -> tuple[Array, float]:
    """Median (3,) of points (k, 3), and the median of their distances from it."""
    centre = np.median(cloud, axis=0)
    return centre, float(np.median(np.linalg.norm(cloud - centre, axis=1))) or 1.0


def what_is_open(
    system: System, state: State, options: AdjustmentOptions, centre: Array, extent: float
) -> tuple[Array, str]:
    """The open directions (7, d) of the datum, and how it is taken; DatumDefect where that cannot be.

    system  whose given points and observations outside the images fix what they fix
    """
    basis = open_directions(*_fixing_rows(system, state, centre, extent))
    kind = {"auto": "inner", "control": "control", "minimal": "minimal", "inner": "inner"}[options.datum]
    unscaled = [p.kind.key for p in system.extra.parts if p.kind.needs_scale]
    if unscaled and basis.shape[1] and np.abs(basis[6]).max() > 1e-6:
        raise DatumDefect(
            "datum.no_scale", unit=system.block.length_unit, n=len(unscaled),
            details=[message("observations.kind", kind=kind) for kind in unscaled],
        )  # fmt: skip
    if basis.shape[1] == 0:
        kind = "control"
    elif left_open := _left_open(system, basis):
        names = open_names(basis)
        part, each = open_values(names)
        raise DatumDefect(left_open, n=len(names), part=part, details=each, open_names=names)
    elif options.datum == "control":
        names = open_names(basis)
        part, each = open_values(names)
        raise DatumDefect("datum.not_by_control", free=basis.shape[1], n=len(names), part=part, details=each)
    return basis, kind


def open_directions(rows: Array, sigma: Array) -> Array:
    """The directions (7, d) of the generators that fixing observations leave open, orthonormal.

    rows   (k, 7) what the generators do to each, in extents and radians
    sigma  (k,) its standard deviation in the same unit, 0 = held

    Open is what moves no observation, and a rotation or change of scale of which a whole radian, or a factor of e,
    moves none of them by LEVER of its standard deviations once the best shift is taken out, nor all of them together
    by more than errors of measurement would (MISTAKEN): stations on a straight line do not show the rotation about it,
    however far errors of measurement put them off the line.  So the answer is the same at approximate and at adjusted
    values.  A shift has no lever, and is determined as well as it is observed.
    """
    if not len(rows):
        return np.eye(7)
    _, singular, vt = np.linalg.svd(_folded(rows), full_matrices=True)
    rank = int(np.sum(singular > 1e-7 * max(singular[0], 1e-2)))  # rows of what fixes anything are about 1 long
    weighted = rows / np.maximum(sigma, HELD)[:, None]
    taken = np.linalg.lstsq(weighted[:, :3], weighted[:, 3:], rcond=1e-7)[0]
    levers = weighted[:, 3:] - weighted[:, :3] @ taken
    turns = np.linalg.svd(_folded(levers), full_matrices=True)[2]
    moved = (levers @ turns.T) ** 2
    across = max(1, 2 * len(levers) // 3)
    chance = np.array([chi_square_tails(float(total), across)[1] for total in moved.sum(axis=0)])
    weak = (moved.max(axis=0) < LEVER**2) & (chance > MISTAKEN)
    found = np.vstack([-taken @ turns[weak].T, turns[weak].T])
    whole = np.linalg.svd(np.hstack([vt[rank:].T, found]), full_matrices=False)
    return _plain(whole[0][:, whole[1] > 1e-6 * max(whole[1].max(initial=0.0), 1e-300)])


LEVER = 5.0
"""Standard deviations by which a whole radian must move an observation that shows a rotation.

Errors alone put one of a million stations on a line so far off it.
"""
MISTAKEN = 6e-7
"""That probability.  Many observations show a rotation together, none of them by itself: the sum of squares of their
levers must be larger than that of errors of stations on a line, two coordinates of each across it."""
HELD = 1e-9
"""Standard deviation, in extents, that stands for that of a held value."""


def _folded(rows: Array) -> Array:
    """As many rows as columns with the same singular values and right singular vectors as many rows."""
    return np.linalg.qr(rows)[1] if len(rows) > rows.shape[1] else rows


def _left_open(system: System, basis: Array) -> str:
    """Why observations that carry a datum leave these directions (7, d) of it open: unknowns of their own; or ""."""
    unknown = set(_open_of_instruments(system).tolist())
    for part in reversed(system.extra.parts):
        named = part.kind.instruments(part.table, system.extra.scope)
        own = {
            int(c)
            for r, row in enumerate(system.interior)
            if row.instrument in named
            for c in system.interior_columns[r]
        }
        if part.kind.left_open and own & unknown and np.abs(basis[list(part.kind.hides)]).max() > 1e-6:
            return part.kind.left_open
    return ""


def _well_determined(system: System, state: State) -> Mask:
    """(p,) points whose rays alone, the images held, determine them to twice the median standard deviation; all if few.

    Every direction counts with the same angular precision.
    """
    o, used = system.block.observations, system.points_used
    image, point = o.image[system.rows], o.point[system.rows]
    ray = state.xyz[point] - state.centre[image]
    distance = np.linalg.norm(ray, axis=1)
    size = np.abs(state.centre[image]).max(axis=1, initial=1e-100)
    away = distance > 1e-12 * size  # a point in a projection centre has no direction
    point, distance = point[away], distance[away]
    d = ray[away] / distance[:, None]
    weight = 1 / distance**2
    xx, yy, zz, xy, xz, yz = (
        np.bincount(point, weight * ((i == j) - d[:, i] * d[:, j]), len(used))[used]
        for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
    )
    minors = yy * zz - yz**2, xx * zz - xz**2, xx * yy - xy**2
    determinant = xx * minors[0] - xy * (xy * zz - xz * yz) + xz * (xy * yz - yy * xz)
    with np.errstate(divide="ignore", invalid="ignore"):  # the trace of the inverse
        spread = np.where(determinant > 1e-12 * (xx + yy + zz) ** 3, sum(minors) / determinant, np.inf)
    good = np.zeros(len(used), bool)
    good[used] = np.sqrt(spread) < GOOD * np.sqrt(np.median(spread))
    return good if good.sum() >= FEWEST_CARRIERS else used.copy()


def _plain(basis: Array) -> Array:
    """An orthonormal basis of the same span in which pure generators stand alone, where there are any."""
    projector = basis @ basis.T
    pure = [i for i in range(7) if projector[i, i] > 1 - 1e-9]
    rest = projector.copy()
    rest[pure] = rest[:, pure] = 0
    count = basis.shape[1] - len(pure)
    columns = [np.eye(7)[:, pure]]
    if count:
        u, _, _ = np.linalg.svd(rest)
        columns.append(u[:, :count])
    return np.hstack(columns)


def _fixing_rows(system: System, state: State, centre: Array, extent: float) -> tuple[Array, Array]:
    """Directions (k, 7) of the generators that observations and held values fix, scaled alike, and their sigma (k,)."""
    rows: list[Array] = []
    sigma: list[Array] = []
    fixed = system.control_held | system.prior
    points = np.flatnonzero(fixed.any(axis=1))
    if len(points):
        G = point_generators(state.xyz[points], centre, extent) / extent
        rows.append(G[fixed[points]])
        sigma.append(np.where(system.prior, system.block.points.sigma, 0.0)[points][fixed[points]] / extent)
    images = np.flatnonzero(system.images_used & ~system.exterior_free)
    if len(images):
        rows.append(point_generators(state.centre[images], centre, extent).reshape(-1, 7) / extent)
        turn = np.zeros((len(images), 3, 7))
        turn[:, :, 3:6] = state.rotation[images]
        rows.append(turn.reshape(-1, 7))
        sigma.append(np.zeros(6 * len(images)))
    observed, std = _observed_rows(system, state, centre, extent)
    if len(observed):
        rows.append(observed)
        sigma.append(std)
    scaled = any(part.kind.fixes_scale for part in system.extra.parts)
    for r, row in enumerate(system.interior):
        if not isinstance(row.model, SensorModel):  # a lever arm alone measures nothing
            continue
        for position in row.carries:
            held = position not in row.free
            scaled |= row.model.parameters[position].is_length and held and state.interior[r, position] != 0
        scaled |= row.model.fixes_scale
    if scaled:
        rows.append(np.eye(7)[6:])
        sigma.append(np.zeros(1))
    return (np.vstack(rows), np.concatenate(sigma)) if rows else (np.zeros((0, 7)), np.zeros(0))


def _observed_rows(system: System, state: State, centre: Array, extent: float) -> tuple[Array, Array]:
    """What observations outside the images fix (k, 7), and their sigma (k,), lengths in units of the extent.

    Lever arms, shifts and misalignments that are not observed themselves are eliminated.
    """
    fixing, sigma, entries = list[Array](), list[Array](), list[tuple[int, int, float]]()
    own = [system.own_columns(p.kind).ravel() for p in system.extra.parts if p.kind.own_width]
    start, unknown = 0, np.sort(np.concatenate([_open_of_instruments(system), *own]))
    for part in system.extra.parts:
        if not part.kind.carries_datum or part.kind.name == "control":  # control stands in the fixed coordinates
            continue
        row, scale = np.zeros((len(part.rows), 7)), extent if part.kind.unit == "length" else 1.0
        places = part.kind.places(part.table, part.rows, system.extra.scope, state)
        for by in part.kind.observed(part.table, part.rows, system.extra.scope, state).partials:
            if by.of in {"interior", "own"}:
                columns = system.columns(part.kind, by)
                mine = np.flatnonzero(np.isin(columns, unknown))
                at = np.searchsorted(unknown, columns[mine])
                entries += zip((by.row[mine] + start).tolist(), at.tolist(), by.value[mine] / scale, strict=True)
            elif by.of == "rotation":
                # R_new = R exp(-[w]x) = exp(-[R w]x) R
                turned = -state.rotation[by.item, by.component] * (by.value / scale)[:, None]
                np.add.at(row[:, 3:6], by.row, turned)
            else:
                at = (state.xyz if by.of == "point" else state.centre)[by.item]
                at = places[by.row] if by.of == "point" and places is not None else at
                moved = point_generators(at, centre, extent)[np.arange(len(at)), by.component]
                np.add.at(row, by.row, moved * (by.value / scale)[:, None])
        fixing.append(row)
        sigma.append(part.rows.sigma / scale)
        start += len(row)
    if not fixing:
        return np.zeros((0, 7)), np.zeros(0)
    F, N = np.concatenate(fixing), np.zeros((start, len(unknown)))
    for k, at, value in entries:
        N[k, at] = value
    return F - N @ np.linalg.lstsq(N, F, rcond=1e-9)[0] if len(unknown) else F, np.concatenate(sigma)


def _open_of_instruments(system: System) -> Array:
    """Unknowns of instruments that are not observed themselves, in their order."""
    found = [
        system.interior_columns[r, k]
        for r, row in enumerate(system.interior)
        if row.instrument >= 0 and row.node >= 0
        for k in row.free
        if not row.owner(system.block).sigma.get(row.model.symbols[k], 0) > 0
    ]
    return np.sort(np.array(found, np.int64))


def hold_minimal(system: System, state: State, datum: Datum) -> Mask:
    """Choose as many coordinates of well-spread points as are open; (p, 3) True where held for the datum."""
    chosen = np.zeros_like(system.held)
    d = datum.defect
    if d == 0:
        return chosen
    rays = np.bincount(system.block.observations.point[system.rows], minlength=len(system.points_used))
    every = system.points_used & ~system.control_held.all(axis=1)
    found, firm = np.zeros((0, 2), np.int64), 0.0
    for free in (every & (system.point_node < 0) & ~(system.control_held | system.prior).any(axis=1), every):
        candidates = np.flatnonzero(free)
        given = (system.control_held | system.prior)[candidates]
        which, axis, share = well_spread(state.xyz[candidates], rays[candidates], given, datum)
        if share > firm:
            found, firm = np.stack([candidates[which], axis], axis=1), share
        if firm > SPREAD:  # points that nothing but image observations touch will do
            break
    if firm < 1e-9:
        raise DatumDefect("datum.points_in_line")
    chosen[found[:, 0], found[:, 1]] = True
    return chosen


def well_spread(xyz: Array, rays: Index, given: Mask, datum: Datum) -> tuple[Index, Index, float]:
    """Coordinates of points that can carry the open datum: points (d,), axes (d,), and how firmly they do.

    xyz    (k, 3) of points that may
    rays   (k,) image observations of each
    given  (k, 3) coordinates that may not: they are known
    """
    from scipy.linalg import qr

    d, candidates = datum.defect, np.arange(len(xyz))
    # far points are poorly determined: stay within three times the median distance
    near = np.linalg.norm(xyz - datum.centre, axis=1) < 3 * datum.extent
    candidates = candidates[near] if near.sum() >= 3 else candidates
    order = np.argsort(-rays[candidates], kind="stable")
    candidates = candidates[order[: max(60, len(order) // 4)]][:2000]
    G = point_generators(xyz[candidates], datum.centre, datum.extent) @ datum.basis / datum.extent
    G = G * ~given[candidates][:, :, None]
    if G[:, :, 0].size < d:
        none = np.zeros(0, np.int64)
        return none, none, 0.0
    decomposition: Any = qr(G.reshape(-1, d).T, mode="economic", pivoting=True)
    _, r, pivot = decomposition
    share = abs(r[-1, d - 1]) / max(abs(r[0, 0]), 1e-300)
    return candidates[pivot[:d] // 3], pivot[:d] % 3, float(share)


@dataclass(slots=True)
class Transformation:
    """Everything an S-transformation of selected blocks needs: Q' = Q - G M H' - H M' G' + G M K M' G'."""

    nodes: Array
    """G (N, d)"""
    points: Array
    """G (p, 3, d)"""
    given: Array
    """B G (p, 3, d)"""
    nodes_h: Array
    """H = Q B G (N, d)"""
    points_h: Array
    """(p, 3, d)"""
    middle: Array
    """M = (G'BG)^-1 (d, d)"""
    inner: Array
    """K = G'BH (d, d)"""

    def with_points(self, points_h: Array) -> Transformation:
        """The transformation with H of the points, which the statistics bring."""
        d = len(self.middle)
        inner = self.given.reshape(-1, d).T @ points_h.reshape(-1, d)
        return replace(self, points_h=points_h, inner=(inner + inner.T) / 2)

    def apply(self, block: Array, Ga: Array, Ha: Array, Gb: Array, Hb: Array) -> Array:
        """Transform cofactor blocks (..., a, b) with the rows of G and H that belong to their unknowns."""
        first = Ga @ np.swapaxes(self._half(Gb, Hb), -1, -2)
        second = self._half(Ga, Ha) @ np.swapaxes(Gb, -1, -2)
        return block - first - second

    def apply_own(self, block: Array) -> Array:
        """Transform the (p, 3, 3) cofactors of the object points; the same as `apply`, with half the work."""
        found = large.zeros(block.shape)
        for some in large.pieces(len(block)):
            G = self.points[some]
            first = G @ np.swapaxes(self._half(G, self.points_h[some]), -1, -2)
            found[some] = block[some] - first - np.swapaxes(first, -1, -2)
        return found

    def _half(self, G: Array, H: Array) -> Array:
        """H M' - 1/2 G M K M', the factor that stands beside G in either half of the symmetric form."""
        d = len(self.middle)
        flat = H.reshape(-1, d) @ self.middle.T - G.reshape(-1, d) @ (self.middle @ self.inner @ self.middle.T / 2)
        return flat.reshape(H.shape)
