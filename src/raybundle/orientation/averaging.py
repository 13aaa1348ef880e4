"""A start for all images at once: rotations by averaging over pairs, then positions and points from rays.

The growing start adds one image after the other and can bend a long chain, or begin badly; here every pair has its
say at once.  It needs overlapping pairs whose relative orientation is known, and no control.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import coo_matrix, csc_matrix, csr_array
from scipy.sparse.csgraph import breadth_first_order, connected_components, minimum_spanning_tree
from scipy.sparse.linalg import SuperLU, splu

from raybundle.block import Block
from raybundle.errors import NoOrientation
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.numerics.rotation import nearest_rotation, rotation_from_vector, vector_from_rotation
from raybundle.numerics.rows import rows_of_each
from raybundle.orientation.candidates import relative_all
from raybundle.orientation.rays import Rays, common_counts, common_rows, object_rays, rays_of
from raybundle.orientation.skeleton import skeleton

LEAST_COMMON = 20
"""Inliers from which on a pair counts."""
PAIRS_EACH = 20
"""Pairs of an image that are oriented, those with the most common points."""
LIMIT_PX = 6.0
"""Largest distance of an inlier from its epipolar line."""
ROTATION_STEPS, POSITION_STEPS = 30, 25
WRONG = np.radians(5.0)
"""Rotation of a pair that contradicts the average by more is wrong."""
FEWEST = 12
"""Rays that must agree with an image for it to count as oriented."""
AGREE = np.radians(1.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Pair:
    first: int
    second: int
    rotation: Array
    """second_from_first (3, 3)"""
    rows: tuple[Index, Index]
    """Observations of the inliers in the two images"""


def average_start(block: Block, progress: Progress = silent) -> Block:
    """The block with exterior orientations of its largest part from all pairs at once, in a system of its own.

    block    interior orientations are used as they stand; given orientations and coordinates are not used
    returns  images without an orientation (NaN) where too few rays agree; coordinates of the points that were used

    Rotations: L1 and then redescending averages over the pairs (Chatterjee and Govindu 2018, with Gauss-Newton steps
    in the tangent space).  Positions: the sum of squared distances between rays and points is least while the mean
    depth is held, reweighted to angles.  Limits: a pair of look-alikes that no third image contradicts
    enters like any other.
    raises  NoOrientation where no pair is left
    """
    rays = rays_of(block)
    chosen = skeleton(block)
    pairs = _pairs(block, rays, chosen, progress)
    n = len(block.images)
    R, part = _rotations(pairs, n)
    off = np.linalg.norm(_misfits(R, *_ends(pairs)), axis=1)
    good = [p for p, d in zip(pairs, off.tolist(), strict=True) if part[p.first] and part[p.second] and d < WRONG]
    if not good:
        raise NoOrientation("orientation.no_pair", least=LEAST_COMMON)
    rows = np.unique(np.concatenate([r for p in good for r in p.rows]))
    progress("orienting all images at once", 0.8)
    centre, xyz, angle = _positions(rays, rows, R, n, len(block.points))
    agree = angle < AGREE
    support = np.bincount(rays.image[rows[agree]], minlength=n)
    oriented = part & (support >= FEWEST)
    R[~oriented], centre[~oriented] = np.nan, np.nan
    progress("orienting all images at once", 1.0)
    return replace(
        block,
        images=replace(block.images, rotation=R, centre=centre),
        points=replace(block.points, xyz=_agreed(xyz, rays.point[rows], agree & oriented[rays.image[rows]])),
    )


def _agreed(xyz: Array, point: Index, agree: Mask) -> Array:
    """Coordinates with NaN for points with fewer than two rays that agree."""
    count = np.bincount(point, agree, minlength=len(xyz))
    return np.where(count[:, None] >= 2, xyz, np.nan)


def _pairs(block: Block, rays: Rays, chosen: Mask, progress: Progress) -> list[_Pair]:
    """Relative orientations of the pairs with the most common points of every image."""
    n = len(block.images)
    keep = chosen[rays.point]
    table = common_counts(rays.image[keep], rays.point[keep], np.ones(n, bool), len(block.points))
    taken = [0] * n
    wanted: list[tuple[int, int]] = []
    for a, b in table[table[:, 2] >= LEAST_COMMON, :2].tolist():
        if taken[a] < PAIRS_EACH or taken[b] < PAIRS_EACH:
            wanted.append((a, b))
            taken[a] += 1
            taken[b] += 1
    rows_of = rows_of_each(np.where(keep, rays.image, -1), n)
    found: list[_Pair] = []
    for k, (a, b) in enumerate(wanted):
        progress("orienting all images at once", 0.7 * k / len(wanted))
        ra, rb = common_rows(rows_of[a], rows_of[b], rays.point)
        limit = LIMIT_PX * float(np.median(rays.px[ra]))
        poses = relative_all(rays.direction[ra], rays.direction[rb], limit)
        if poses and poses[0].inliers.sum() >= LEAST_COMMON:
            best = poses[0]
            inliers = best.inliers
            found.append(_Pair(first=a, second=b, rotation=best.rotation, rows=(ra[inliers], rb[inliers])))
    return found


def _rotations(pairs: list[_Pair], n: int) -> tuple[Array, Mask]:
    """Rotations (n, 3, 3) of the largest connected part, and which images (n,) it holds."""
    R = np.tile(np.eye(3), (n, 1, 1))
    first, second = np.array([p.first for p in pairs], int), np.array([p.second for p in pairs], int)
    weight = np.array([len(p.rows[0]) for p in pairs], float)
    graph = csr_array(coo_matrix((1 / np.maximum(weight, 1), (first, second)), shape=(n, n)))
    _, label = connected_components(graph, directed=False)
    part = label == np.bincount(label).argmax()
    if not pairs or part.sum() < 2:
        return R, np.zeros(n, bool)
    mine = [k for k, p in enumerate(pairs) if part[p.first]]
    # the tree of the strongest pairs, from the image with the most of them
    root = int(np.bincount(np.concatenate([first[mine], second[mine]]), np.tile(weight[mine], 2), minlength=n).argmax())
    relative = {(pairs[k].first, pairs[k].second): pairs[k].rotation for k in mine}
    order, before = breadth_first_order(minimum_spanning_tree(graph), root, directed=False)
    for i in order[1:]:
        j = int(before[i])
        R[i] = (relative[j, int(i)] if (j, int(i)) in relative else relative[int(i), j].T) @ R[j]
    return _averaged(R, [pairs[k] for k in mine], np.sqrt(weight[mine]), part, root), part


def _averaged(R: Array, pairs: list[_Pair], weight: Array, part: Mask, root: int) -> Array:
    """Rotations that the pairs agree on, by reweighted Gauss-Newton steps."""
    unknown = part.copy()
    unknown[root] = False
    column = np.full(len(R), -1)
    column[unknown] = np.arange(unknown.sum())
    u = 3 * int(unknown.sum())
    turned = np.flatnonzero(unknown)
    first, second, rotation = _ends(pairs)
    at = np.stack([column[second], column[first]], axis=1)
    J = np.stack([np.broadcast_to(np.eye(3), rotation.shape), -rotation], axis=1)
    side, pair = np.divmod(np.flatnonzero((at.T >= 0).ravel()), len(pairs))
    for step in range(ROTATION_STEPS):
        misfit = _misfits(R, first, second, rotation)
        size = np.linalg.norm(misfit, axis=1)
        # absolute values first: nearly half of the pairs may be wrong; then those far off lose all weight
        w = weight / np.maximum(size, 1e-3) if step < ROTATION_STEPS // 2 else weight / (1 + (size / 0.02) ** 2) ** 2
        weighted = w[:, None, None, None] * J
        right = np.zeros((u // 3, 3))
        np.subtract.at(right, at[pair, side], np.einsum("kij,ki->kj", weighted[pair, side], misfit[pair]))
        N = _normals(at, np.einsum("kaij,kbil->kabjl", weighted, J), u // 3)
        N.setdiag(N.diagonal() * (1 + 1e-9) + 1e-12)
        delta = _factor(N).solve(right.ravel()).reshape(-1, 3)
        R[turned] = nearest_rotation(rotation_from_vector(delta) @ R[turned])
        if step >= ROTATION_STEPS // 2 and np.abs(delta).max(initial=0) < 1e-8:
            break
    return R


def _ends(pairs: list[_Pair]) -> tuple[Index, Index, Array]:
    """First and second images (k,) and rotations second_from_first (k, 3, 3) of pairs."""
    first, second = np.array([(p.first, p.second) for p in pairs], int).reshape(-1, 2).T
    return first, second, np.array([p.rotation for p in pairs]).reshape(-1, 3, 3)


def _misfits(R: Array, first: Index, second: Index, rotation: Array) -> Array:
    """Rotation vectors (k, 3) by which the average contradicts pairs."""
    return vector_from_rotation(R[second] @ R[first].swapaxes(1, 2) @ rotation.swapaxes(1, 2))


def _normals(at: Index, products: Array, count: int) -> csc_matrix:
    """Normal matrix of `count` rotations: blocks (k, 2, 2, 3, 3) at unknowns (k, 2), negative for a held one."""
    k, a, b = np.nonzero((at[:, :, None] >= 0) & (at[:, None, :] >= 0))
    return csc_matrix(_blocks(products[k, a, b], at[k, a], at[k, b], count, count))


def _factor(N: csc_matrix) -> SuperLU:
    """Factor of a symmetric positive definite matrix, by an order for symmetric ones: half of the fill of others."""
    options = {"SymmetricMode": True}
    return splu(N, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options)


def _positions(rays: Rays, rows: Index, R: Array, n: int, p: int) -> tuple[Array, Array, Array]:
    """Projection centres (n, 3), points (p, 3) and angles (m,) [rad] between the rays and their points."""
    image, point = rays.image[rows], rays.point[rows]
    d = object_rays(R[image], rays.direction[rows])
    w = np.ones(len(rows))
    centre, xyz = np.zeros((n, 3)), np.zeros((p, 3))
    angle = np.zeros(len(rows))
    for _ in range(POSITION_STEPS):
        centre, xyz = _linear(image, point, d, w, n, p)
        view = xyz[point] - centre[image]
        depth = np.einsum("ij,ij->i", view, d)
        across = np.linalg.norm(view - depth[:, None] * d, axis=1)
        angle = np.arctan2(across, depth)
        far = np.maximum(np.linalg.norm(view, axis=1), 1e-3)
        # angles, not distances, have one standard deviation; what lies behind or far off fades out
        w = 1 / (far**2 * np.maximum(angle, 1e-3) * (1 + (angle / 0.1) ** 2))
        w *= len(w) / w.sum()
    return centre, xyz, angle


def _linear(image: Index, point: Index, d: Array, w: Array, n: int, p: int) -> tuple[Array, Array]:
    """Centres and points that minimise sum w |(I - d d')(X - C)|^2 with a mean depth of 1; the first centre is 0."""
    P = w[:, None, None] * (np.eye(3) - d[:, :, None] * d[:, None, :])
    A = np.zeros((p, 3, 3))
    np.add.at(A, point, P)
    g_point, g_image = np.zeros((p, 3)), np.zeros((n, 3))
    np.add.at(g_point, point, w[:, None] * d)
    np.add.at(g_image, image, -w[:, None] * d)
    scale = np.maximum(np.trace(A, axis1=1, axis2=2), 1e-12)
    inverse = np.linalg.inv(A + 1e-9 * scale[:, None, None] * np.eye(3))
    W = _blocks(-P, image, point, n, p)
    inverse_all = _blocks(inverse, np.arange(p), np.arange(p), p, p)
    S = _blocks(P, image, image, n, n) - W @ inverse_all @ W.T
    g = g_image.ravel() - W @ (inverse_all @ g_point.ravel())
    seen = np.flatnonzero(np.bincount(image, minlength=n) > 0)
    free = (3 * seen[1:, None] + np.arange(3)).ravel()
    C = np.zeros(3 * n)
    reduced = S[free][:, free].tocsc()
    reduced.setdiag(reduced.diagonal() * (1 + 1e-12) + 1e-15)
    C[free] = _factor(reduced).solve(g[free])
    X = inverse_all @ (g_point.ravel() - W.T @ C)
    C, X = C.reshape(n, 3), X.reshape(p, 3)
    depth = float(np.average(np.einsum("ij,ij->i", X[point] - C[image], d), weights=w))
    return C / depth, X / depth


def _blocks(values: Array, row: Index, column: Index, rows: int, columns: int) -> csr_array:
    """A sparse matrix of 3 x 3 blocks (k, 3, 3) at block rows and columns (k,); those at one place are summed."""
    r = np.broadcast_to(3 * row[:, None, None] + np.arange(3)[None, :, None], values.shape)
    c = np.broadcast_to(3 * column[:, None, None] + np.arange(3)[None, None, :], values.shape)
    return csr_array(coo_matrix((values.ravel(), (r.ravel(), c.ravel())), shape=(3 * rows, 3 * columns)))
