"""Did the images of a camera have one interior orientation: c, principal point and K1 that each image asks for.

Images of two cameras that are taken for one fall into groups; images of one camera whose focus wanders, or whose lens
is stabilised, scatter.  The scatter itself is the measure: it contains smooth errors of any size that differ from image
to image, and no assumption of white noise enters.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.field_system import field_system, reason_against
from raybundle.adjustment.fields import COLUMNS, OWN, WithOwnInterior, root_of_fields
from raybundle.adjustment.result import Adjustment
from raybundle.numerics.arrays import Array, Index

FEWEST = 3
"""Images of a group: fewer do not show how far its own images scatter."""
MOST_GROUPS = 4
"""Groups into which the values of one parameter are divided at a time."""
MOST_IMAGES = 60
"""Images of a camera up to which it is looked at: beyond, chance is not drawn in reasonable time."""
DRAWS = 2000
"""Simulated sets of images without groups: of twelve tests at LEVEL, the limit of each is about the second least."""
LEVEL = 1e-2
"""Probability of groups where there are none, for all parameters of a camera together."""
TOGETHER = 4_000_000
"""Numbers that are worked on at once."""
FARTHEST = 0.03
"""Standard deviation of what an image may have of its own, as a share of half the longer side of the format: what is
not determined stays within it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class OwnInteriors:
    """What each image of a camera asks for beside their common interior orientation."""

    images: Index
    """(n,)"""
    difference_px: Array
    """(n, 4) c, x0, y0, K1 as displacements, c and K1 at half the longer side of the format"""
    covariance: Array
    """(4, n, n) of each, by noise and by smooth errors that differ from image to image without groups"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Groups:
    """Images of a camera that fall into groups."""

    images: tuple[Index, ...]
    symbol: str
    """of `fields.OWN`, by which they differ"""
    means_px: Array
    """(g,) of its values"""
    scatter_px: float
    """Standard deviation of its values within the groups"""
    probability: float
    """of groups as distinct by chance, for all parameters together"""


def own_interiors(result: Adjustment) -> tuple[OwnInteriors, ...]:
    """Of each camera with FEWEST images or more in each of two groups; () where normal equations are not at hand.

    One step from the adjustment with a common interior orientation, all other unknowns eliminated.
    """
    work = result.handle.work
    if work is None or work.found is None or not work.normals.one_piece or reason_against(work.system):
        return ()
    system = field_system(work.normals, work.state, WithOwnInterior)
    if not system.is_finite:
        return ()
    k, own = WithOwnInterior.columns, len(OWN)
    noise, variance = result.noise, result.sigma0**2
    root = root_of_fields(noise.tau_px**2, noise.focus_px**2)
    images = result.given.images
    found = list[OwnInteriors]()
    for c in np.unique(images.camera[system.images]).tolist():
        at = np.flatnonzero(images.camera[system.images] == c)
        n = len(at)
        if not 2 * FEWEST <= n <= MOST_IMAGES:
            continue
        camera = result.given.cameras[c]
        prior = FARTHEST * max(camera.width_px, camera.height_px) / 2
        mine = (k * at[:, None] + np.arange(COLUMNS, k)).ravel()
        fields = (k * at[:, None] + np.arange(COLUMNS)).ravel()
        across = system.left(mine) / variance
        M = (across[mine] + across[mine].T) / 2
        Q = np.linalg.inv(M + np.eye(len(M)) / prior**2)
        moved = Q @ (across[fields].T.reshape(own * n, n, COLUMNS) @ root).reshape(own * n, -1)
        V = noise.phi * Q @ M @ Q + moved @ moved.T
        found.append(
            OwnInteriors(
                images=system.images[at], difference_px=(Q @ system.scores[mine] / variance).reshape(n, own),
                covariance=np.stack([V[j::own, j::own] for j in range(own)]),
            )
        )  # fmt: skip
    return tuple(found)


def groups_of(own: OwnInteriors) -> Groups | None:
    """The most distinct groups of a camera's images by one of the parameters; None where they may be chance.

    The sum of squares within the best division of the sorted values (Fisher 1958), as a share of all, is held against
    the same of normally distributed values without groups (Engelman and Hartigan 1969), which are drawn with the
    covariance that geometry, noise and smooth errors give them.
    """
    n = len(own.images)
    counts = [g for g in range(2, MOST_GROUPS + 1) if g * FEWEST <= n]
    best: Groups | None = None
    for k, symbol in enumerate(OWN):
        values = own.difference_px[:, k]
        order = np.argsort(values, kind="stable")
        shares, cuts = _divided(values[order][None], max(counts))
        chance = _chance(own.covariance[k], max(counts))
        for g in counts:
            p = float((1 + np.sum(chance[g - 2] <= shares[g - 2, 0])) / (1 + DRAWS)) * len(OWN) * len(counts)
            if p > LEVEL or (best is not None and p >= best.probability):
                continue
            parts = np.split(order, cuts[g - 2][0])
            means = np.array([values[i].mean() for i in parts])
            within = sum(float(((values[i] - m) ** 2).sum()) for i, m in zip(parts, means, strict=True))
            best = Groups(
                images=tuple(np.sort(own.images[i]) for i in parts), symbol=symbol, means_px=means,
                scatter_px=float(np.sqrt(within / max(n - g, 1))), probability=p,
            )  # fmt: skip
    return best


def _chance(covariance: Array, most: int) -> Array:
    """Shares (g - 1, DRAWS) of the square sum within the best 2 .. `most` groups of values that have none."""
    n = len(covariance)
    values, vectors = np.linalg.eigh(covariance)
    root = vectors * np.sqrt(np.maximum(values, 0.0))
    drawn = np.sort(np.random.default_rng(n).normal(size=(DRAWS, n)) @ root.T, axis=1)
    pieces = np.array_split(drawn, max(1, DRAWS * n * n // TOGETHER))
    return np.concatenate([_divided(v, most)[0] for v in pieces], axis=1)


def _divided(values: Array, most: int) -> tuple[Array, list[Array]]:
    """Share (g - 1, d) of the square sum within the best 2 .. `most` groups of sorted values (d, n), and their cuts.

    By dynamic programming (Fisher 1958), no group smaller than FEWEST.
    """
    d, n = values.shape
    values = values - values.mean(axis=1, keepdims=True)
    one = np.concatenate([np.zeros((d, 1)), np.cumsum(values, axis=1)], axis=1)
    two = np.concatenate([np.zeros((d, 1)), np.cumsum(values**2, axis=1)], axis=1)
    first, last = np.arange(n + 1)[:, None], np.arange(n + 1)[None, :]
    size = np.maximum(last - first, 1)
    cost = (two[:, None, :] - two[:, :, None]) - (one[:, None, :] - one[:, :, None]) ** 2 / size
    cost = np.where(last - first >= FEWEST, cost, np.inf)  # (d, first, last)
    best, shares, cuts = cost[:, 0], list[Array](), list[Array]()
    back = list[Array]()
    for g in range(2, most + 1):
        through = best[:, :, None] + cost
        back.append(through.argmin(axis=1))
        best = np.take_along_axis(through, back[-1][:, None], axis=1)[:, 0]
        shares.append(np.maximum(best[:, n], 0.0) / np.maximum(two[:, n], 1e-300))
        at, end = np.zeros((d, g - 1), np.int64), np.full(d, n)
        for k in range(g - 2, -1, -1):
            end = back[k][np.arange(d), end]
            at[:, k] = end
        cuts.append(at)
    return np.array(shares), cuts
