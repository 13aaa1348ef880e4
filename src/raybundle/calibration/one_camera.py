"""Did all photographs have one interior orientation?  Two cameras, a zoom that was moved, a lens focused again."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import cross_matrix
from raybundle.platforms.station import sensor_from_object
from raybundle.sensors import sensor_models

By = Literal["names", "order", "values"]
FEWEST = 3
"""Photographs of a camera that is distinguished."""
LEAST_POINTS = 10
GAIN = 1.4
"""By how much the scatter within groups must be smaller than the scatter of all, as a ratio of variances."""
LARGE = 4.0
"""Mean square of the single photographs' deviations, in their variances, from which groups are looked for."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Split:
    """Photographs of one camera that fall into two groups."""

    groups: tuple[Index, Index]
    """Images of each"""
    by: By
    """By what the photographs were divided"""
    name: str
    """Of names: what those of the first group begin with; of order: its last photograph"""
    sought: bool
    """True where the division was made up to fit, False where names or order suggest it"""
    difference: Array
    """(3,) c, x0, y0 of the second minus the first [px]"""


def own_interiors(result: Adjustment, camera: str) -> tuple[Index, Array, Array]:
    """Images, corrections (n, 3) of c, x0, y0 [px] and their covariances (n, 3, 3) that each image asks for.

    Each image is taken alone with the adjusted object points held: six unknowns of its orientation and three of its
    interior orientation, one step from the adjusted values.  Covariances carry the a-posteriori sigma0.
    Limits: with points adjusted from the same images, deviations are somewhat too small.
    """
    block, o = result.adjusted, result.given.observations
    k = next(i for i, c in enumerate(block.cameras) if c.id == camera)
    cam = block.cameras[k]
    model = sensor_models[cam.model]
    kinds = [p.kind for p in model.parameters]
    wanted = [kinds.index("scale"), *[i for i, kind in enumerate(kinds) if kind == "principal point"][:2]]
    used = result.image_observations.used & (block.images.camera[o.image] == k)
    if len(wanted) < 3:  # a model without a principal point states nothing of where it is
        used = np.zeros_like(used)
    images: list[int] = []
    shift, spread = list[Array](), list[Array]()
    for i in np.unique(o.image[used]):
        rows = np.flatnonzero(used & (o.image == i))
        if len(rows) < LEAST_POINTS:
            continue
        v, A = _one_image(block, result, int(i), rows, wanted)
        N = A.T @ A
        if np.linalg.cond(N / np.sqrt(np.outer(np.diag(N), np.diag(N)))) > 1e10:
            continue
        Q = np.linalg.inv(N)
        images.append(int(i))
        shift.append((-Q @ A.T @ v)[6:])
        spread.append(Q[6:, 6:] * max(result.sigma0, 1e-12) ** 2)
    pixel = float(np.mean(cam.pixel_mm))
    n = len(images)
    return (
        np.array(images, np.int32),
        np.array(shift).reshape(n, 3) / pixel,
        np.array(spread).reshape(n, 3, 3) / pixel**2,
    )


def _one_image(block: Block, result: Adjustment, i: int, rows: Array, wanted: Sequence[int]) -> tuple[Array, Array]:
    """Whitened misclosures (2m,) and design (2m, 9) of an image with its points held."""
    o = result.given.observations
    cam = block.cameras[block.images.camera[i]]
    model = sensor_models[cam.model]
    values = cam.parameters
    n = len(rows)
    R = np.broadcast_to(block.images.rotation[i], (n, 3, 3))
    P = sensor_from_object(R, np.broadcast_to(block.images.centre[i], (n, 3)), block.points.xyz[o.point[rows]])
    xy = cam.image_from_pixel(o.xy_px[rows]).T
    g, J = model.condition_and_jacobian(*xy, *P, *np.repeat(values[:, None], n, axis=1))
    J = np.moveaxis(J, 2, 0)
    by_point = J[:, :, 2:5]
    exterior = np.concatenate([-by_point @ R, -by_point @ cross_matrix(P.T)], axis=2)
    full = np.concatenate([exterior, J[:, :, 5:][:, :, list(wanted)]], axis=2)
    B = np.linalg.inv(J[:, :, :2])
    sign = np.array(cam.pixel_mm) * [1, -1]
    A = np.einsum("nij,njk->nik", B, full) / sign[:, None]
    v = np.einsum("nij,nj->ni", B, g.T) / sign
    C = np.empty((n, 2, 2))
    C[:, 0, 0], C[:, 1, 1] = o.cov_px2[rows, :2].T
    C[:, 0, 1] = C[:, 1, 0] = o.cov_px2[rows, 2]
    W = np.linalg.inv(np.linalg.cholesky(C))
    return (W @ v[..., None]).reshape(-1), (W @ A).reshape(2 * n, 9)


def find_splits(result: Adjustment, camera: str) -> tuple[Split, ...]:
    """Divisions of a camera's photographs into two, where they deviate far more than their precision allows.

    The best by the beginnings of the names, by the order of the photographs, and by c, x0 or y0 alone.  Empty where no
    division explains the deviations; an adjustment with two cameras has the last word.
    """
    images, shift, spread = own_interiors(result, camera)
    if len(images) < 2 * FEWEST:
        return ()
    P = np.linalg.inv(spread)
    whole = _scatter(shift, P) / (3 * (len(images) - 1))
    if whole < LARGE:
        return ()
    best: dict[By, tuple[float, Mask, str]] = {}
    for kind, side, name in _candidates([result.given.images.ids[i] for i in images], shift):
        if min(int(side.sum()), int((~side).sum())) < FEWEST:
            continue
        within = _scatter(shift[side], P[side]) + _scatter(shift[~side], P[~side])
        if kind not in best or within < best[kind][0]:
            best[kind] = within, side, name
    found: list[Split] = []
    for kind, (within, side, name) in best.items():
        if whole < GAIN * within / (3 * (len(images) - 2)):
            continue
        means = [_mean(shift[s], P[s]) for s in (side, ~side)]
        found.append(
            Split(
                groups=(images[side], images[~side]), by=kind, name=name, sought=kind == "values",
                difference=means[1] - means[0],
            )
        )  # fmt: skip
    return tuple(found)


def _mean(shift: Array, P: Array) -> Array:
    return np.linalg.solve(P.sum(axis=0), np.einsum("nij,nj->i", P, shift))


def _scatter(shift: Array, P: Array) -> float:
    d = shift - _mean(shift, P)
    return float(np.einsum("ni,nij,nj->", d, P, d))


def _candidates(names: Sequence[str], shift: Array) -> list[tuple[By, Mask, str]]:
    """Kind of division, side (n,) and the name by which it was made."""
    found: list[tuple[By, Mask, str]] = []
    starts = [re.split(r"[_\-. ]", name, maxsplit=1)[0] for name in names]
    if len(set(starts)) < len(names) / 2:
        of_names: list[tuple[By, Mask, str]] = [
            ("names", np.array([s == start for s in starts]), start) for start in dict.fromkeys(starts)
        ]
        found += of_names
    order = np.arange(len(names))
    of_order: list[tuple[By, Mask, str]] = [("order", order < k, names[k - 1]) for k in range(1, len(names))]
    found += of_order
    for axis in range(3):
        along = np.argsort(shift[:, axis])
        for k in range(1, len(names)):
            side = np.zeros(len(names), bool)
            side[along[:k]] = True
            found.append(("values", side, ""))
    return found
