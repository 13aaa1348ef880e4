"""Image points without a name, as uncoded dots: which of them are one object point, once the images are oriented."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raybundle.adjustment.system.predict import predicted_px
from raybundle.block import Block
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.orientation.rays import camera_rays, intersect_linear

TOLERANCE_PX = 1.5
"""Distance from a predicted image point up to which a dot is taken for it."""
FEWEST = 3
"""Images that must show a dot."""
SHARE = 0.4
"""Share of the images in whose format it lies that must."""
PARTNERS = 3
MOST_CANDIDATES = 20_000


def link_unnamed(
    block: Block, dots: Sequence[Array], tolerance_px: float = TOLERANCE_PX
) -> list[list[tuple[int, int]]]:
    """Groups of (image, dot) that are one object point each.

    block  with orientations; images without are left alone
    dots   for each image (k, 2) image points [px]
    Each dot meets those near its epipolar line in a few images that stand well apart; the object point is predicted in
    all other images, and the one that most of them confirm wins.  A dot belongs to one group at most.
    Limits: rows of equal dots on a plane that all cameras look along can be confused; the adjustment's
    tests have the last word.
    """
    from scipy.spatial import KDTree

    n = len(dots)
    oriented = block.images.oriented
    ray: list[Array] = [np.zeros((0, 3))] * n
    tree: list[KDTree | None] = [None] * n
    for i in range(n):
        if oriented[i] and len(dots[i]):
            camera = block.cameras[int(block.images.camera[i])]
            ray[i] = camera_rays(camera, dots[i]) @ block.images.rotation[i]
            tree[i] = KDTree(dots[i])
    free = [np.ones(len(d), bool) for d in dots]
    known = block.points.xyz[np.isfinite(block.points.xyz).all(axis=1)]
    if len(known) < 3:
        return []
    partners = _partners(block, [i for i in range(n) if tree[i] is not None], known)
    groups: list[list[tuple[int, int]]] = []
    for i, others in partners.items():
        for j in others:
            a, b, xyz = _pairs(block, i, j, ray, free, known)
            if len(a):
                groups += _confirmed(block, tree, free, (i, a), (j, b), xyz, tolerance_px)
    return groups


def _partners(block: Block, images: Sequence[int], known: Array) -> dict[int, list[int]]:
    """For each image those that look at the same from 15 to 60 degrees aside, the nearest to 35 first."""
    middle = np.median(known, axis=0)
    away = block.images.centre[list(images)] - middle
    away = away / np.linalg.norm(away, axis=1, keepdims=True)
    angle = np.degrees(np.arccos(np.clip(away @ away.T, -1, 1)))
    result: dict[int, list[int]] = {}
    for r, i in enumerate(images):
        order = np.argsort(np.abs(angle[r] - 35))
        result[i] = [images[k] for k in order if k != r and 3 < angle[r, k] < 90][:PARTNERS]
    return result


def _pairs(
    block: Block, i: int, j: int, ray: Sequence[Array], free: Sequence[Mask], known: Array
) -> tuple[Index, Index, Array]:
    """Dots a of image i and b of image j whose rays meet, and where (k, 3)."""
    a, b = np.flatnonzero(free[i]), np.flatnonzero(free[j])
    if not len(a) or not len(b):
        return a[:0].astype(np.int32), b[:0].astype(np.int32), np.zeros((0, 3))
    base = block.images.centre[j] - block.images.centre[i]
    u, v = ray[i][a], ray[j][b]
    normal = np.cross(np.broadcast_to(base / np.linalg.norm(base), u.shape), u)
    normal = normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
    camera = block.cameras[int(block.images.camera[j])]
    pixel = float(np.mean(camera.pixel_mm)) / abs(camera.values["c"])
    near = np.abs(normal @ v.T) < 2 * TOLERANCE_PX * pixel
    p, q = np.nonzero(near)
    if len(p) > MOST_CANDIDATES:
        return a[:0].astype(np.int32), b[:0].astype(np.int32), np.zeros((0, 3))
    k = len(p)
    origin = np.stack([np.tile(block.images.centre[i], (k, 1)), np.tile(block.images.centre[j], (k, 1))], axis=1)
    direction = np.stack([u[p], v[q]], axis=1)
    point = np.repeat(np.arange(k), 2).astype(np.int32)
    xyz, _, _ = intersect_linear(origin.reshape(-1, 3), direction.reshape(-1, 3), point, k)
    size = float(np.linalg.norm(np.ptp(known, axis=0)))
    inside = (np.linalg.norm(xyz - np.median(known, axis=0), axis=1) < size) & np.isfinite(xyz).all(axis=1)
    return a[p[inside]].astype(np.int32), b[q[inside]].astype(np.int32), xyz[inside]


def _confirmed(
    block: Block, tree: Sequence[object], free: Sequence[Mask], first: tuple[int, Index], second: tuple[int, Index],
    xyz: Array, tolerance_px: float,
) -> list[list[tuple[int, int]]]:  # fmt: skip
    """The candidates that other images confirm, the best first; dots that are taken are no longer free."""
    (i, a), (j, b) = first, second
    hit = np.full((len(tree), len(xyz)), -1)
    within = np.zeros((len(tree), len(xyz)), bool)
    far = np.zeros((len(tree), len(xyz)))
    hit[i], hit[j] = a, b
    within[i] = within[j] = True
    for k, t in enumerate(tree):
        if t is None or k in {i, j}:
            continue
        at = predicted_px(block, k, xyz)
        camera = block.cameras[int(block.images.camera[k])]
        inside = np.isfinite(at).all(axis=1)
        inside &= (np.nan_to_num(at, nan=-1) > 0).all(axis=1)
        inside &= (np.nan_to_num(at, nan=1e9) < [camera.width_px, camera.height_px]).all(axis=1)
        within[k] = inside
        rows = np.flatnonzero(inside)
        if not len(rows):
            continue
        distance, nearest = t.query(at[rows])  # type: ignore[attr-defined]
        good = (distance < tolerance_px) & free[k][nearest]
        hit[k, rows[good]], far[k, rows[good]] = nearest[good], distance[good]
    support = (hit >= 0).sum(axis=0)
    miss = far.sum(axis=0) / np.maximum(support, 1)
    found: list[list[tuple[int, int]]] = []
    for c in np.lexsort((miss, -support)):
        if support[c] < max(FEWEST, SHARE * within[:, c].sum()):
            continue
        group = [(int(k), int(hit[k, c])) for k in np.flatnonzero(hit[:, c] >= 0)]
        if not all(free[k][d] for k, d in group):
            continue
        for k, d in group:
            free[k][d] = False
        found.append(group)
    return found
