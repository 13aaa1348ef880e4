"""Orientation problems of rigs: the mean of several mountings, a station by all of its rays, two systems by stations.

A mounting is (R, b): R turns the axes of the rig to those of the camera, b is its projection centre in the rig's frame.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.rotation import cross_matrix, nearest_rotation, rotation_from_vector, vector_from_rotation

CANDIDATES = 200
"""Poses among which the middle one is looked for."""
WITHIN = 3.0
"""Times the median distance from the middle pose up to which poses take part in the mean."""
TRIPLES = 400
"""Triples of rays of a station that are solved: of 30 % right ones one is right with 1 - 2e-5."""
FEWEST = 4
"""Rays that a mounting needs, which the other rays of the camera judge as well; three leave up to four."""
LEAST = 6
"""Rays that a station needs: three leave up to eight poses, of 400 triples one may fit a fourth by chance."""
HALF = 0.5
"""Share of the rays that must fit"""
STEPS = 15
TURNING = 1e-2
"""Smallest ratio of the second to the largest singular value of the axes about which a rig turned: 0.6 degrees."""


def mean_pose(rotation: Array, vector: Array, size: float) -> tuple[Array, Array]:
    """The mean (3, 3), (3,) of poses (n, 3, 3), (n, 3) near the middle one of them.

    size  length that an angle of one radian is as far as

    The middle pose has the least median of distances to all (Rousseeuw 1984): up to half of the poses may be wrong.
    """
    some = np.linspace(0, len(rotation) - 1, min(len(rotation), CANDIDATES)).astype(int)
    distance = [_distances(rotation, vector, rotation[k], vector[k], size) for k in some]
    best = min(distance, key=lambda d: float(np.median(d)))
    near = best <= WITHIN * float(np.median(best))
    return nearest_rotation(rotation[near].mean(axis=0)), vector[near].mean(axis=0)


def _distances(rotation: Array, vector: Array, R: Array, v: Array, size: float) -> Array:
    turn = np.linalg.norm(vector_from_rotation(rotation @ R.T), axis=-1)
    return np.hypot(turn, np.linalg.norm(vector - v, axis=-1) / max(size, 1e-300))


@dataclass(frozen=True, slots=True, kw_only=True)
class StationRays:
    """Rays of the images of one station to known points, in the frame of the rig."""

    origin: Array
    """(m, 3) projection centres"""
    direction: Array
    """(m, 3) unit vectors"""
    xyz: Array
    """(m, 3) coordinates of the points in object space"""
    limit: Array
    """(m,) largest angle of a right ray [rad]"""

    def angles(self, rotation: Array, centre: Array) -> Array:
        """Angles (m,) [rad] between the rays and the directions to their points, the rig standing there."""
        away = (self.xyz - centre) @ rotation.T - self.origin
        sine = np.linalg.norm(np.cross(away, self.direction), axis=1)
        return np.arctan2(sine, np.einsum("ni,ni->n", away, self.direction))

    def cost(self, rotation: Array, centre: Array) -> float:
        """Sum of the angles in units of their limits, each one at most."""
        return float(np.minimum(self.angles(rotation, centre) / self.limit, 1.0).sum())


def resected_station(rays: StationRays) -> tuple[Array, Array] | None:
    """Rotation (3, 3) and centre (3,) of a rig by rays of all of its cameras; None where half of them do not fit.

    Three rays, whichever cameras they are of, have up to eight solutions (Nistér and Stewénius 2007); the one that most
    rays fit is refined.
    """
    import poselib

    count = len(rays.xyz)
    if count < LEAST:
        return None
    rng = np.random.default_rng(0)
    triples = list(combinations(range(count), 3)) if count <= 12 else []
    if not triples or len(triples) > TRIPLES:
        triples = [tuple(rng.choice(count, 3, replace=False)) for _ in range(TRIPLES)]
    best: tuple[float, Array, Array] | None = None
    for triple in triples:
        t = list(triple)
        for found in poselib.gp3p(rays.origin[t], rays.direction[t], rays.xyz[t]):
            R = np.asarray(found.R, float)
            centre = -R.T @ np.asarray(found.t, float)
            if not (np.isfinite(R).all() and np.isfinite(centre).all()):
                continue
            cost = rays.cost(R, centre)
            if best is None or cost < best[0]:
                best = (cost, R, centre)
    if best is None:
        return None
    R, centre = refined_station(rays, nearest_rotation(best[1]), best[2])
    fits = rays.angles(R, centre) < rays.limit
    return (R, centre) if fits.sum() >= max(LEAST, HALF * count) else None


def refined_station(rays: StationRays, rotation: Array, centre: Array) -> tuple[Array, Array]:
    """Gauss-Newton of a rig's pose on all of its rays, long residuals weighted down (Huber); the given one if worse."""
    R, C = rotation, centre
    aside = np.where(np.abs(rays.direction[:, :1]) < 0.9, [[1.0, 0.0, 0.0]], [[0.0, 1.0, 0.0]])
    first = np.cross(rays.direction, aside)
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    axes = np.stack([first, np.cross(rays.direction, first)], axis=1)
    for _ in range(STEPS):
        turned = (rays.xyz - C) @ R.T
        away = turned - rays.origin
        depth = np.einsum("ni,ni->n", away, rays.direction)
        ahead = depth > 1e-9 * np.linalg.norm(away, axis=1)
        if ahead.sum() < 3:
            return rotation, centre
        v = np.einsum("nki,ni->nk", axes, away)[ahead] / depth[ahead, None]
        by_away = (axes[ahead] - v[:, :, None] * rays.direction[ahead, None]) / depth[ahead, None, None]
        J = np.concatenate([-by_away @ R, -by_away @ cross_matrix(turned[ahead])], axis=2)
        scale = rays.limit[ahead] / 2
        w = np.minimum(1.0, scale / np.maximum(np.linalg.norm(v, axis=1), 1e-300)) / scale**2
        N = np.einsum("n,nki,nkj->ij", w, J, J)
        d = np.sqrt(np.maximum(np.diagonal(N), 1e-300))
        g = -np.einsum("n,nki,nk->i", w, J, v)
        step = np.linalg.solve(N / np.outer(d, d) + 1e-9 * np.eye(6), g / d) / d
        C = C + step[:3]
        R = rotation_from_vector(step[3:]) @ R
        if np.linalg.norm(step[3:]) < 1e-9:
            break
    better = np.isfinite(R).all() and np.isfinite(C).all() and rays.cost(R, C) <= rays.cost(rotation, centre)
    return (R, C) if better else (rotation, centre)


@dataclass(frozen=True, slots=True, kw_only=True)
class Common:
    """Stations at which one camera stands in one coordinate system, another camera in another one."""

    rotation: Array
    """(n, 3, 3) of the one camera"""
    centre: Array
    """(n, 3)"""
    other_rotation: Array
    """(n, 3, 3) of the other camera, in the other system"""
    other_centre: Array
    """(n, 3)"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Joined:
    """X = scale rotation x + translation brings one coordinate system to another."""

    scale: float
    rotation: Array
    translation: Array


def joined_by_stations(
    here: Common, there: Common, mounting: tuple[Array, Array] | None, *, scaled: bool
) -> Joined | None:
    """Bring a coordinate system to another one in which other cameras of the same stations stand.

    here      stations of which the first camera stands in the system that stays, the second in the one that is brought
    there     stations of which the first stands in the one that is brought, the second in the one that stays
    mounting  of the second camera in the frame of the first; None: not known, which takes three stations and turns
              about two axes
    scaled    whether the two systems have the same scale
    returns   None where the stations do not determine it

    Rotations: from station to station the second camera turns as the first does, in other axes, so that the mounting
    turns the axes of one onto those of the other.  Centres: linear in scale, translation and the offset b of the
    second camera, s S c + t - R' b = C here, s S c + S r' b + t = C there (Park and Martin 1994; Daniilidis 1999).
    """
    n = len(here.centre) + len(there.centre)
    if n < (2 if mounting is not None else 3):
        return None
    M = mounting[0] if mounting is not None else _turned_alike([here, there])
    if M is None:
        return None
    turn = [np.swapaxes(here.rotation, 1, 2) @ M.T @ here.other_rotation]
    turn.append(np.swapaxes(there.other_rotation, 1, 2) @ M @ there.rotation)
    S, _ = mean_pose(np.concatenate(turn), np.zeros((n, 3)), 1.0)
    right = np.concatenate([here.centre, there.other_centre])
    brought = np.concatenate([here.other_centre, there.centre]) @ S.T
    lever = np.concatenate([-np.swapaxes(here.rotation, 1, 2), S @ np.swapaxes(there.rotation, 1, 2)])
    if mounting is not None:
        right = right - lever @ mounting[1]
    if scaled:
        right = right - brought
    columns = [np.tile(np.eye(3), (n, 1, 1))]
    columns += [] if scaled else [brought[:, :, None]]
    columns += [lever] if mounting is None else []
    x = _robust_solution(np.concatenate(columns, axis=2), right)
    s = 1.0 if scaled else float(x[3])
    return Joined(scale=s, rotation=S, translation=x[:3]) if s > 0 else None


def _turned_alike(commons: Sequence[Common]) -> Array | None:
    """The rotation (3, 3) from the axes of one camera to those of the other; None without turns about two axes."""
    turns = list[tuple[Array, Array]]()
    for common in commons:
        R, Q = common.rotation, common.other_rotation
        pairs = np.array(list(combinations(range(len(R)), 2)), int).reshape(-1, 2)
        if len(pairs) > 3 * CANDIDATES:
            pairs = pairs[np.random.default_rng(0).choice(len(pairs), 3 * CANDIDATES, replace=False)]
        i, j = pairs.T
        turns.append(
            (
                vector_from_rotation(R[i] @ np.swapaxes(R[j], 1, 2)),
                vector_from_rotation(Q[i] @ np.swapaxes(Q[j], 1, 2)),
            )
        )
    a, b = (np.concatenate(part) for part in zip(*turns, strict=True))
    if not len(a):
        return None
    weight = np.ones(len(a))
    found = np.eye(3)
    for _ in range(20):
        u, s, v = np.linalg.svd(np.einsum("n,ni,nj->ij", weight, b, a))
        if s[1] < TURNING**2 * s[0]:  # of squares
            return None
        found = u @ np.diag([1.0, 1.0, np.linalg.det(u @ v)]) @ v
        off = np.linalg.norm(b - a @ found.T, axis=1)
        weight = 1 / np.maximum(off, 1e-3)
    return found


def _robust_solution(A: Array, right: Array) -> Array:
    """Least absolute deviations x (k,) of A (n, 3, k) x = right (n, 3) by reweighting, of least norm."""
    weight: Array = np.ones(len(A))
    x = np.zeros(A.shape[2])
    use: Mask = np.ones(len(A), bool)
    for _ in range(20):
        w = np.sqrt(weight[use])[:, None]
        x = np.linalg.lstsq((A[use] * w[:, :, None]).reshape(-1, A.shape[2]), (right[use] * w).ravel(), rcond=1e-9)[0]
        off = np.linalg.norm(right - A @ x, axis=1)
        weight = 1 / np.maximum(off, 1e-3 * max(float(np.median(off)), 1e-300))
    return x
