"""Viewing rays of a block, linear intersection, and residuals in pixels: what all orientation functions share."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.block import Block, Camera
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.sensors import sensor_models
from raybundle.sensors.model import SensorModel

FLIP = np.array([1.0, -1.0, -1.0])
"""Our image axes (y up, view along -Z) to those of the minimal solvers (y down, view along +Z)."""


@dataclass(slots=True)
class Rays:
    """All image observations of a block as unit viewing directions in their sensor's frame."""

    image: Index
    point: Index
    direction: Array
    """(m, 3)"""
    px: Array
    """(m,) size of one pixel as an angle [rad]"""


AT_ONCE = 20_000
"""Places whose rays are looked for together: some 2 kB each, of partial derivatives and what they are made of."""


def camera_rays(camera: Camera, xy_px: Array) -> Array:
    """Unit viewing directions (n, 3) in the sensor frame of image points (n, 2) [px].

    Where Newton's method from the central projection ends on the side that the sensor does not see, as for the
    back half of a panorama, it starts again from the nearest of a sphere of directions.
    """
    parts = [_rays(camera, xy_px[k : k + AT_ONCE]) for k in range(0, max(len(xy_px), 1), AT_ONCE)]
    return parts[0] if len(parts) == 1 else np.concatenate(parts)


def _rays(camera: Camera, xy_px: Array) -> Array:
    """The same of so many places that all partial derivatives of each fit into memory."""
    model = sensor_models[camera.model]
    values = camera.parameters
    image = camera.image_from_pixel(xy_px).T
    with np.errstate(all="ignore"):
        direction = model.ray(image, values)
        g = np.abs(np.stack(model.condition(*image, *direction, *values))).max(axis=0)
    lost = ~(g < 1e-6 * abs(values[0])) | ~model.in_front(direction, image, values)
    lost &= np.isfinite(image).all(axis=0)  # what has no place has no ray
    if lost.any():
        start = _nearest_direction(model, image[:, lost], values)
        with np.errstate(all="ignore"):
            direction[:, lost] = model.ray(image[:, lost], values, start)
    return direction.T


def _nearest_direction(model: SensorModel, image: Array, values: Array, count: int = 4000) -> Array:
    """Of directions spread evenly over the sphere those (3, n) whose image by `model.start` is nearest."""
    from scipy.spatial import KDTree

    k = np.arange(count) + 0.5
    z, turn = 1 - 2 * k / count, np.pi * (1 + np.sqrt(5)) * k
    sphere = np.stack([np.sqrt(1 - z * z) * np.cos(turn), np.sqrt(1 - z * z) * np.sin(turn), z])
    with np.errstate(all="ignore"):
        places = model.start(sphere, values)
    seen = np.isfinite(places).all(axis=0) & model.in_front(sphere, places, values)
    _, nearest = KDTree(places[:, seen].T).query(image.T)
    return sphere[:, seen][:, nearest]


def rays_of(block: Block) -> Rays:
    """Rays of all observations with the block's interior orientations as they are."""
    observations = block.observations
    direction = np.zeros((len(observations), 3))
    px = np.zeros(len(observations))
    camera = block.images.camera[observations.image]
    for c, cam in enumerate(block.cameras):
        mine = np.flatnonzero(camera == c)
        if not len(mine):
            continue
        direction[mine] = camera_rays(cam, observations.xy_px[mine])
        px[mine] = np.mean(cam.pixel_mm) / abs(cam.values[sensor_models[cam.model].symbols[0]])
    return Rays(observations.image, observations.point, direction, px)


def intersect_linear(origin: Array, direction: Array, point: Index, count: int) -> tuple[Array, Index, Array]:
    """Points (count, 3) nearest to their rays, number of rays (count,), and smallest eigenvalue over the largest.

    origin, direction  (m, 3) in object space, unit length; point (m,) which point each ray belongs to
    Minimises the distances of the point from its rays.  The eigenvalue ratio is sin^2 of about half the angle
    between the rays: 0 where they are parallel; such points get the foot of a slightly damped system.  Rays that are no
    numbers, as of a lens without inverse there, take no part.
    """
    known = np.isfinite(direction).all(axis=1) & np.isfinite(origin).all(axis=1)
    if not known.all():
        origin, direction, point = origin[known], direction[known], point[known]
    P = np.eye(3) - direction[:, :, None] * direction[:, None, :]
    rays = np.bincount(point, minlength=count)
    A = np.zeros((count, 9))
    b = np.zeros((count, 3))
    flat = P.reshape(-1, 9)
    right = np.einsum("nij,nj->ni", P, origin)
    for k in range(9):
        A[:, k] = np.bincount(point, flat[:, k], minlength=count)
    for k in range(3):
        b[:, k] = np.bincount(point, right[:, k], minlength=count)
    A = A.reshape(-1, 3, 3)
    ratio = np.zeros(count)
    enough = rays >= 2
    eigenvalues = np.linalg.eigvalsh(A[enough])
    largest = eigenvalues[:, 2]  # 0 where points lie at infinity: nothing is known of them
    ratio[enough] = np.where(largest > 1e-300, eigenvalues[:, 0] / np.where(largest > 1e-300, largest, 1.0), 0.0)
    mean = np.stack([np.bincount(point, origin[:, k], minlength=count) for k in range(3)], axis=1)
    mean = mean / np.maximum(rays, 1)[:, None]
    damped = A + 1e-12 * np.maximum(np.trace(A, axis1=1, axis2=2), 1.0)[:, None, None] * np.eye(3)
    xyz = mean + np.linalg.solve(damped, (b - np.einsum("pij,pj->pi", A, mean))[..., None])[..., 0]
    return xyz, rays, ratio


def angular_residuals(rotation: Array, centre: Array, xyz: Array, direction: Array) -> Array:
    """Angles (n,) [rad] between measured rays and the directions to their points, sensor frame."""
    d = np.einsum("nij,nj->ni", rotation, xyz - centre)
    d = d / np.maximum(np.linalg.norm(d, axis=1), 1e-300)[:, None]
    cosine = np.einsum("ni,ni->n", d, direction)
    sine = np.linalg.norm(np.cross(d, direction), axis=1)
    return np.arctan2(sine, cosine)


def object_rays(rotation: Array, direction: Array) -> Array:
    """Directions (n, 3) in object space of rays (n, 3) of images with rotations (n, 3, 3)."""
    return np.einsum("nji,nj->ni", rotation, direction)


def refine_pose(
    rotation: Array, centre: Array, xyz: Array, direction: Array, *, steps: int = 10, scale: float = 0.0
) -> tuple[Array, Array, Array]:
    """Gauss-Newton of one pose on rays (n, 3) to known points (n, 3); returns rotation, centre, angles (n,).

    Residual: the direction to the point in the tangent plane of the measured ray, equal weights; with `scale` > 0
    residuals beyond it [rad] are weighted down (Huber).
    """
    from raybundle.numerics.rotation import rotation_from_vector

    R, C = rotation.copy(), centre.copy()
    helper = np.where(np.abs(direction[:, :1]) < 0.9, [[1.0, 0, 0]], [[0, 1.0, 0]])
    e1 = np.cross(direction, helper)
    e1 /= np.linalg.norm(e1, axis=1)[:, None]
    e2 = np.cross(direction, e1)
    for _ in range(steps):
        P = (xyz - C) @ R.T
        depth = np.maximum(np.einsum("ni,ni->n", P, direction), 1e-12)
        J = np.zeros((len(P), 2, 6))
        v = np.zeros((len(P), 2))
        for k, e in enumerate((e1, e2)):
            value = np.einsum("ni,ni->n", P, e) / depth
            by_P = (e - value[:, None] * direction) / depth[:, None]
            v[:, k] = value
            J[:, k, :3] = -by_P @ R
            J[:, k, 3:] = np.cross(P, by_P)
        length = np.linalg.norm(v, axis=1)
        w = np.minimum(1.0, scale / np.maximum(length, 1e-300)) if scale > 0 else np.ones(len(P))
        weighted = (J * w[:, None, None]).reshape(-1, 6)
        N = weighted.T @ J.reshape(-1, 6)
        g = -weighted.T @ v.ravel()
        d = np.sqrt(np.maximum(np.diagonal(N), 1e-300))
        step = np.linalg.solve(N / np.outer(d, d) + 1e-9 * np.eye(6), g / d) / d
        C = C + step[:3]
        R = rotation_from_vector(step[3:]) @ R
        if np.linalg.norm(step[3:]) < 1e-8:
            break
    return R, C, angular_residuals(np.broadcast_to(R, (len(xyz), 3, 3)), np.broadcast_to(C, xyz.shape), xyz, direction)


def common_counts(image: Index, point: Index, chosen: Mask, points: int) -> Index:
    """(k, 3) pairs a < b of the chosen images (n,) and their common points, most first, by observations (m,)."""
    from scipy.sparse import coo_matrix

    rows = chosen[image]
    ones = np.ones(int(rows.sum()), np.int32)
    seen = coo_matrix((ones, (image[rows], point[rows])), shape=(len(chosen), points)).tocsr()
    common = (seen @ seen.T).tocoo()
    keep = common.row < common.col
    order = np.argsort(-common.data[keep], kind="stable")
    return np.stack([common.row[keep], common.col[keep], common.data[keep]], axis=1)[order]


def image_pairs(image: Index, point: Index, chosen: Mask, points: int, most: int = 200) -> list[tuple[int, int, int]]:
    """The pairs of `common_counts` with most common points."""
    return [(int(a), int(b), int(c)) for a, b, c in common_counts(image, point, chosen, points)[:most]]


def common_rows(first: Index, second: Index, point: Index) -> tuple[Index, Index]:
    """Rows of the common points among the rows of two images; point (m,) of every observation."""
    _, ia, ib = np.intersect1d(point[first], point[second], return_indices=True)
    return first[ia], second[ib]


def in_front(rotation: Array, centre: Array, xyz: Array, direction: Array) -> Mask:
    """(n,) whether points lie on the measured side of their rays."""
    return np.einsum("ni,ni->n", np.einsum("nij,nj->ni", rotation, xyz - centre), direction) > 0
