"""Covariances under the noise of real photographs: the one place where floor and fields meet the cofactors.

C = s0^2 (Q + (phi - 1) Q_c S Q_c') + J cov(fields) J', with Q the cofactors of least squares, Q_c their columns of the
cameras, S the normal matrix of the image points when object points are eliminated, and J = Q U the influence of the
fields on every unknown.  The floor is that of image points as cameras see them: what the points' own rays bring is not
inflated (the noise of one point's rays is not that of another's), nor is what observations outside the images bring; a
length that a scale bar alone fixes keeps the standard deviation of the bar.

With K = Q E' of the whitened rows E outside the images, Own the inverse normal matrices of the points by their rays
alone, and G = Own E', the middle is Q_c S Q_c' = Q - K K' - (I - K E) Own (I - K E)'.  Own is taken where the cameras
carry the datum; an S-transformation (Baarda 1973) then brings all to the datum of the result, so that what can be
estimated at all does not depend on it.  Everything here is in units of s0^2, as the cofactors of white noise are.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from raybundle.adjustment.statistics.field_system import (
    FieldSystem,
    entries,
    field_system,
    own_of_rays,
    reason_against,
)
from raybundle.adjustment.statistics.field_test import OwnField, own_fields
from raybundle.adjustment.statistics.fields import (
    COLUMNS,
    FEWEST_DIRECTIONS,
    WHITE,
    Components,
    Noise,
    Scores,
    independent_scores,
    variance_components,
)
from raybundle.adjustment.statistics.precision import Cofactors
from raybundle.adjustment.system.assemble import State, System
from raybundle.adjustment.system.datum import Datum, Transformation, node_generators, point_generators
from raybundle.adjustment.system.normals import Normals
from raybundle.adjustment.system.transformation import transformation
from raybundle.errors import phrase
from raybundle.numerics.arrays import Array, Index

WHOLE = 150
"""Images up to which all residuals are asked at once: the eigenvalues of 1500 columns take a second."""
SAMPLE, SAMPLES = 40, 5
"""Images of a sample of larger blocks, and number of samples."""
EXACT = 300
"""Images up to which the influence of every coefficient is formed."""
PROBES = 256
"""Random combinations that stand for the coefficients beyond."""
SINGULAR = 1e-12
"""Eigenvalue, of a normal matrix with a unit diagonal, below which its direction is not determined."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Outside:
    """Whitened rows of the observations outside the images: control, distances, positions, parameters."""

    nodes: Any
    """(N, k) sparse, transposed"""
    point: Index
    """(q,) of those of eliminated points, which stand last among the k"""
    axis: Index
    weight: Array

    def reported(self, nodes: Array, points: Array) -> Array:
        """(k, c) of columns for nodes (N, c) and points (p, 3, c)."""
        found = self.nodes.T @ nodes
        found[len(found) - len(self.point) :] += self.weight[:, None] * points[self.point, self.axis]
        return found

    def right(self, reported: Array, shape: tuple[int, ...]) -> tuple[Array, Array]:
        """Right sides for nodes (N, c) and points (p, 3, c), `shape`, of coefficients (k, c)."""
        points = np.zeros(shape)
        values = self.weight[:, None] * reported[len(reported) - len(self.point) :]
        np.add.at(points, (self.point, self.axis), values)
        return self.nodes @ reported, points


@dataclass(slots=True)
class Spread:
    """How noise that is not white spreads over the unknowns of a factored block, in the datum of the factor."""

    fields: FieldSystem
    phi: float
    basis: Any
    """(10 f, r), sparse where exact: a square root of the covariance of the fields' coefficients, in units of s0^2"""
    own: Array
    """(p, 3, 3) V_p^-1 of eliminated points by their rays, the cameras known; nothing held for the datum"""
    own_nodes: Any
    """(N, N) sparse: the same of retained points, in the places of their unknowns"""
    outside: Outside | None
    """Observations outside the images; None where there are none, or the floor is that of white noise"""
    inverse: Array
    """The covariance of the nodes in the layout of the normal matrix, in units of s0^2, no datum taken"""
    points: Array
    """(p, 3, 3) of the points"""
    own_fields: tuple[OwnField, ...] = ()
    """What the residuals of single images show of a field of their own, of the images that were asked"""

    def solve(self, nodes: Array, points: Array) -> tuple[Array, Array]:
        """The covariance applied to right sides for nodes (N, k) and points (p, 3, k), k <= 16; as `Normals.solve`.

        The points' own part is that of a datum which the cameras carry, all else in the datum of the factor: a
        transformation to the datum of the result makes one of them.
        """
        n, p = self.fields.base.solve(self.fields.state, nodes, points)
        return self.applied(nodes, points, n, p)

    def applied(self, nodes: Array, points: Array, n: Array, p: Array) -> tuple[Array, Array]:
        """As `solve`, where what white noise makes of the right sides is known: nodes (N, k), points (p, 3, k)."""
        moved_n, moved_p = self.moved(n, points)
        if self.phi == 1:
            return n + moved_n, p + moved_p
        floor_n, floor_p = self.floor(nodes, points, n, p)
        return n + (self.phi - 1) * floor_n + moved_n, p + (self.phi - 1) * floor_p + moved_p

    def among_nodes(self, nodes: Array) -> Array:
        """The nodes' part (N, k) of `solve` for right sides of nodes (N, k) alone, any k."""
        base, wide, outside = self.fields.base, self.fields.wide, self.outside
        if self.phi != 1 and outside is not None and len(outside.point):
            none = np.zeros((*self.fields.state.xyz.shape, nodes.shape[1]))
            return self.solve(nodes, none)[0]
        n = base.solved_nodes(nodes)
        found = n
        if self.basis.shape[1]:
            found = n + base.solved(wide.times(self.basis @ (self.basis.T @ wide.transposed(n))))
        if self.phi == 1:
            return found
        if outside is None:
            return found + (self.phi - 1) * (n - self.own_nodes @ nodes)
        seen = outside.nodes.T @ n
        own = self.own_nodes @ (nodes - outside.nodes @ seen)
        taken = base.solved_nodes(outside.nodes @ (seen - outside.nodes.T @ own))
        return found + (self.phi - 1) * (n - own - taken)

    def floor(self, nodes: Array, points: Array, n: Array, p: Array) -> tuple[Array, Array]:
        """Q_c S Q_c' applied to right sides, of which Q makes n and p."""
        if self.outside is None:
            own_n, own_p = self.own_solve(nodes, points)
            return n - own_n, p - own_p
        reported = self.outside.reported(n, p)
        taken_n, taken_p = self.outside.right(reported, p.shape)
        own_n, own_p = self.own_solve(nodes - taken_n, points - taken_p)
        reported = reported - self.outside.reported(own_n, own_p)
        k_n, k_p = self.fields.base.solve(self.fields.state, *self.outside.right(reported, p.shape))
        return n - own_n - k_n, p - own_p - k_p

    def moved(self, nodes: Array, given: Array) -> tuple[Array, Array]:
        """The fields' part applied to right sides, of which `Normals.solve` made these nodes."""
        if not self.basis.shape[1]:
            return np.zeros_like(nodes), np.zeros((*self.fields.state.xyz.shape, nodes.shape[1]))
        return self.fields.influence(self.basis @ (self.basis.T @ self.fields.projected(nodes, given)))

    def own_solve(self, nodes: Array, points: Array) -> tuple[Array, Array]:
        """The points' own part applied to right sides."""
        n = self.own_nodes @ self._with_retained(nodes, points)
        return n, self.own @ points + self._of_retained(n)

    def _with_retained(self, nodes: Array, points: Array) -> Array:
        """Right sides of nodes with those that are given for retained points."""
        system = self.fields.base.system
        kept = np.flatnonzero(system.point_node >= 0)
        whole = nodes.copy()
        at = system.offsets[system.point_node[kept]][:, None] + np.arange(3)
        whole[at] += points[kept]
        return whole

    def _of_retained(self, nodes: Array) -> Array:
        """Points (p, 3, k) of what stands in the nodes of retained ones."""
        system = self.fields.base.system
        kept = np.flatnonzero(system.point_node >= 0)
        points = np.zeros((len(system.point_node), 3, nodes.shape[1]))
        points[kept] = nodes[system.offsets[system.point_node[kept]][:, None] + np.arange(3)]
        return points


def noise_of(
    normals: Normals, state: State, found: Cofactors, datum: Datum, variance: float
) -> tuple[Noise, Cofactors, Spread | None]:
    """Floor and fields of a block, its cofactors under them, and what answers further questions.

    normals   with the undamped factor in its minimal datum, at `state`
    variance  sigma0^2
    returns   white noise with its reason and the cofactors as they are where fields cannot be determined
    """
    reason = reason_against(normals.system)
    if reason:
        return replace(WHITE, reason=reason), found, None
    fields = field_system(normals, state)
    if not fields.is_finite:
        return replace(WHITE, reason=phrase("noise.singular_points")), found, None
    reported, of_images = components(fields, variance)
    noise = Noise(
        kind="fields", phi=reported.phi, tau_px=float(np.sqrt(reported.tau_square)),
        focus_px=float(np.sqrt(reported.focus_square)), directions=reported.directions, chi_square=reported.chi_square,
        images=len(fields.images), sampled=len(of_images),
    )  # fmt: skip
    if reported.directions < FEWEST_DIRECTIONS:
        few = phrase("noise.few_directions", n=reported.directions, least=FEWEST_DIRECTIONS)
        return replace(WHITE, reason=few), found, None
    spread = spread_of(fields, found, reported.phi, reported.root(variance))
    spread.own_fields = of_images
    return noise, spread_in_datum(spread, found, datum), spread


def components(fields: FieldSystem, variance: float) -> tuple[Components, tuple[OwnField, ...]]:
    """Floor and fields from the residuals, and what those of each image that they are taken from show by themselves.

    Of more than WHOLE images samples of neighbouring ones are taken: their scores, with all that the fields of the
    others do to them.
    """
    n = len(fields.images)
    if n <= WHOLE:
        M = fields.left(np.arange(fields.size))
        of_images = own_fields(fields.images, M, fields.scores, variance)
        return variance_components([independent_scores(M, fields.scores, variance)]), tuple(of_images)
    samples, of_images = list[Scores](), list[OwnField]()
    for images in _samples(fields):
        chosen = (COLUMNS * images[:, None] + np.arange(COLUMNS)).ravel()
        across = fields.left(chosen).T
        samples.append(independent_scores(across[:, chosen], fields.scores[chosen], variance, across))
        of_images += own_fields(fields.images[images], across[:, chosen], fields.scores[chosen], variance)
        del across  # before the next one: 32 kB an image
    return variance_components(samples), tuple(of_images)


def _samples(fields: FieldSystem) -> list[Array]:
    """Neighbouring images (k,), by their positions among those with fields: each sample grows from one of its own.

    The next image is that which shares most with those that are in it; the first ones are spread over the block.
    """
    n = len(fields.images)
    free, found = np.ones(n, bool), list[Array]()
    for first in np.linspace(0, n - 1, SAMPLES).round().astype(int):
        start = first if free[first] else int(np.flatnonzero(free)[0])
        mine, pull = [start], fields.wide.shared(start)
        free[start] = False
        while len(mine) < SAMPLE and (free & (pull > 0)).any():
            following = int(np.argmax(np.where(free, pull, -1.0)))
            mine.append(following)
            free[following] = False
            pull = pull + fields.wide.shared(following)
        found.append(np.array(sorted(mine)))
        if not free.any():
            break
    return found


def spread_alone(fields: FieldSystem, phi: float, root: Array) -> Spread:
    """What answers questions under floor and fields as in `spread_of`, without the cofactors of all unknowns."""
    own, own_nodes = _own(fields)
    none = np.zeros(0)
    return Spread(
        fields=fields, phi=phi, basis=_basis(fields, root), own=own, own_nodes=own_nodes,
        outside=_outside(fields) if phi > 1 else None, inverse=none, points=none,
    )  # fmt: skip


def spread_of(fields: FieldSystem, found: Cofactors, phi: float, root: Array) -> Spread:
    """The noise spread over the unknowns; `root` (10, 10) of the covariance of an image's coefficients, units of s0^2.

    Of more than EXACT images random combinations of all coefficients stand for them: PROBES of them show a variance to
    a tenth, a standard deviation to a twentieth, and what is stated remains a covariance.
    """
    spread = spread_alone(fields, phi, root)
    own, own_nodes = spread.own, spread.own_nodes
    row, column = entries(fields.base)
    inverse, points = phi * found.inverse, phi * found.points_minimal - (phi - 1) * own
    if own_nodes.nnz:
        inverse -= (phi - 1) * np.asarray(own_nodes[row, column]).ravel()
    if spread.basis.shape[1]:
        J = fields.base.solved(fields.wide.times(spread.basis))
        nodes_jj, points_jj = fields.wide.influences(J, spread.basis)
        inverse += nodes_jj
        points += points_jj
    if spread.outside is not None:
        nodes_kk, points_kk = _from_outside(spread, spread.outside, row, column)
        inverse -= (phi - 1) * nodes_kk
        points -= (phi - 1) * points_kk
    retained = np.flatnonzero(fields.base.system.point_node >= 0)
    points[retained] = _retained_blocks(fields.base, inverse, retained)
    spread.inverse, spread.points = inverse, points
    return spread


def _outside(fields: FieldSystem) -> Outside | None:
    """The rows of all observations outside the images; None where there are none, or far too many.

    Of more than EXACT images their part would take longer than all else: the floor then counts for them as well, and
    standard deviations come out rather too large.
    """
    from scipy.sparse import coo_matrix

    system = fields.base.system
    extra = fields.base.extra(fields.state)
    point, axis = np.nonzero(system.prior & (system.point_node < 0)[:, None])
    k = len(extra.residual)
    if k + len(point) == 0 or len(fields.images) > EXACT:
        return None
    shape = (int(system.offsets[-1]), k + len(point))
    nodes = coo_matrix((extra.value, (extra.unknown, extra.row)), shape=shape).tocsr()
    weight = 1 / system.block.points.sigma[point, axis]
    return Outside(nodes=nodes, point=point.astype(np.int32), axis=axis.astype(np.int32), weight=weight)


def _from_outside(spread: Spread, outside: Outside, row: Array, column: Array) -> tuple[Array, Array]:
    """Q - Own - Q_c S Q_c' of the nodes at the entries of the normal matrix, and of the points (p, 3, 3).

    (K - G) (K - G)' - G G' + K E G K', the last with a root of E G, which is that of rows on points alone.
    """
    count, p = outside.nodes.shape[1], len(spread.own)
    nodes, points = np.zeros(len(row)), np.zeros((p, 3, 3))
    both = np.zeros((count, count))

    def add(n: Array, moved: Array, sign: float = 1.0) -> None:
        nonlocal nodes, points
        nodes += sign * np.einsum("ek,ek->e", n[row], n[column])
        points += sign * (moved @ np.swapaxes(moved, 1, 2))

    def solved(reported: Array) -> tuple[Array, Array]:
        return spread.fields.base.solve(spread.fields.state, *outside.right(reported, (p, 3, reported.shape[1])))

    for first in range(0, count, 16):
        reported = np.eye(count)[:, first : first + 16]
        own_n, own_p = spread.own_solve(*outside.right(reported, (p, 3, reported.shape[1])))
        n, moved = solved(reported)
        add(n - own_n, moved - own_p)
        add(own_n, own_p, -1.0)
        both[:, first : first + 16] = outside.reported(own_n, own_p)
    touching = np.flatnonzero(np.abs(both).sum(axis=0) > 0)
    if len(touching):
        values, vectors = np.linalg.eigh(both[np.ix_(touching, touching)])
        root = np.zeros((count, len(touching)))
        root[touching] = vectors * np.sqrt(np.maximum(values, 0.0))
        for first in range(0, len(touching), 16):
            add(*solved(np.ascontiguousarray(root[:, first : first + 16])))
    return nodes, points


def _basis(fields: FieldSystem, root: Array) -> Any:
    """A square root (10 f, r) of the covariance of all coefficients, sparse where exact; no column without fields."""
    from scipy.sparse import csr_matrix, identity, kron

    n = len(fields.images)
    if not root.any():
        return csr_matrix((COLUMNS * n, 0))
    if n <= EXACT:
        return kron(identity(n), root, format="csr")
    signs = np.random.default_rng(n).integers(0, 2, (COLUMNS * n, PROBES)).astype(np.int8)
    found = np.empty(signs.shape)
    for k in range(0, len(found), COLUMNS):
        found[k : k + COLUMNS] = root @ (signs[k : k + COLUMNS] * 2.0 - 1.0) / np.sqrt(PROBES)
    return found


def spread_in_datum(spread: Spread, found: Cofactors, datum: Datum) -> Cofactors:
    """The cofactors under this noise, in units of s0^2, in any datum of the same defect.

    found  those of white noise, of which what tests rest on is kept
    """
    fields = spread.fields
    normals, system = fields.base, fields.base.system
    change = transformation(normals, fields.state, datum) or _minimal_transformation(fields, datum)
    if change is None:
        return replace(found, inverse=spread.inverse, points_minimal=spread.points, points=spread.points)
    # H = C B G and K = G'B C B G of this covariance, in place of those of the cofactors
    white_h = normals.solve_points(fields.state, change.nodes_h, change.given)
    white_h[system.held] = 0
    nodes_h, points_h = spread.applied(np.zeros_like(change.nodes_h), change.given, change.nodes_h, white_h)
    if datum.kind == "inner":
        points_h[system.control_held] = 0
    change = replace(change, nodes_h=nodes_h).with_points(points_h)
    points = change.apply_own(spread.points)
    fixed = system.control_held if datum.kind == "inner" else system.held
    points[fixed[:, :, None] | fixed[:, None, :]] = 0.0
    return replace(
        found, inverse=spread.inverse, transformation=change, points_minimal=spread.points, points=points
    )  # fmt: skip


def _minimal_transformation(fields: FieldSystem, datum: Datum) -> Transformation | None:
    """The transformation to the minimal datum of the factor; None where nothing is open."""
    if datum.defect == 0:
        return None
    state, system = fields.state, fields.base.system
    G = (point_generators(state.xyz, datum.centre, datum.extent).reshape(-1, 7) @ datum.basis).reshape(
        -1, 3, datum.defect
    )
    G[~system.points_used] = 0
    G[system.control_held] = 0
    given = G * (system.held & ~system.control_held)[:, :, None]
    nodes = node_generators(system, state, datum)
    d = datum.defect
    middle = np.linalg.inv(given.reshape(-1, d).T @ G.reshape(-1, d))
    return Transformation(nodes, G, given, np.zeros_like(nodes), np.zeros((0, 3, d)), middle, np.zeros((d, d)))


def _own(fields: FieldSystem) -> tuple[Array, Any]:
    """What the points' own rays bring, the cameras known: (p, 3, 3) eliminated, (N, N) sparse retained.

    Nothing is held but control, so that it is the same in every datum that cameras carry; what control, distances and
    other observations outside the images bring to the points is not theirs.
    """
    from scipy.sparse import csr_matrix

    normals, state, system = fields.base, fields.state, fields.base.system
    N = int(system.offsets[-1])
    held = system.held
    kept = np.flatnonzero((system.point_node >= 0) & system.points_used)
    try:
        normals.hold(system.control_held)
        own = own_of_rays(normals, state)
        blocks = fields.wide.ray_blocks(kept) if len(kept) else np.zeros((0, 3, 3))
    finally:
        normals.hold(held)
    free = ~system.control_held[kept]
    blocks = np.array([_inverse(b) for b in blocks]).reshape(-1, 3, 3) * free[:, :, None] * free[:, None, :]
    at = system.offsets[system.point_node[kept]][:, None] + np.arange(3)
    places = np.repeat(at, 3, axis=1).ravel(), np.tile(at, (1, 3)).ravel()
    nodes = csr_matrix((blocks.ravel(), places), shape=(N, N))  # rays tie no two points
    own[system.point_node >= 0] = 0
    _without_priors(own, system)
    return own, nodes


def _without_priors(own: Array, system: System) -> None:
    """Take from the cofactors of eliminated points (p, 3, 3) what their given coordinates bring, in place."""
    prior = system.prior & (system.point_node < 0)[:, None]
    for p in np.flatnonzero(prior.any(axis=1)):
        free = np.flatnonzero(~system.control_held[p])
        at = np.ix_(free, free)
        weight = np.where(prior[p, free], 1 / system.block.points.sigma[p, free] ** 2, 0.0)
        own[p][at] = _inverse(_inverse(own[p][at]) - np.diag(weight))


def _inverse(N: Array) -> Array:
    """The inverse of normal equations; of what they do not determine, nothing."""
    size = np.diagonal(N)
    scale = np.where(size > 0, 1 / np.sqrt(np.where(size > 0, size, 1.0)), 0.0)
    values, vectors = np.linalg.eigh(N * np.outer(scale, scale))
    known = values > SINGULAR
    whole = vectors[:, known] / np.sqrt(values[known])
    return whole @ whole.T * np.outer(scale, scale)


def _retained_blocks(normals: Normals, inverse: Array, points: Array) -> Array:
    """Blocks (k, 3, 3) of retained points in the layout of the normal matrix."""
    system = normals.system
    nodes = [int(system.point_node[p]) for p in points]
    blocks = np.array([normals.node_block(inverse, a, a) for a in nodes]).reshape(-1, 3, 3)
    free = ~system.held[points]
    return blocks * free[:, :, None] * free[:, None, :]
