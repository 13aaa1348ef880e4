"""Did the images of a camera have one interior orientation: c, principal point and K1 that each image asks for.

Images of two cameras that are taken for one fall into groups; images of one camera whose focus wanders, or whose lens
is stabilised, scatter.  The scatter itself is the measure: it contains smooth errors of any size that differ from image
to image, and no assumption of white noise enters.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.field_system import carrying, field_system, reason_against
from raybundle.adjustment.statistics.fields import COLUMNS, OWN, WithOwnInterior, root_of_fields
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
TURNS = 3
"""Directions that are tried one after the other from each parameter."""
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
    """(4 n, 4 n), by noise and by smooth errors that differ from image to image without groups"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Groups:
    """Images of a camera that fall into groups."""

    images: tuple[Index, ...]
    symbol: str
    """of `fields.OWN`, by which they differ most clearly"""
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
    if work is None or work.found is None or reason_against(work.system):
        return ()
    images = result.given.images
    count = np.bincount(images.camera[carrying(work.system)], minlength=len(result.given.cameras))
    chosen = np.flatnonzero((count >= 2 * FEWEST) & (count <= MOST_IMAGES)).tolist()
    if not chosen:
        return ()
    system = field_system(work.normals, work.state, WithOwnInterior)
    if not system.is_finite:
        return ()
    k, own = WithOwnInterior.columns, len(OWN)
    noise, variance = result.noise, result.sigma0**2
    root = root_of_fields(noise.tau_px**2, noise.focus_px**2)
    found = list[OwnInteriors]()
    for c in chosen:
        at = np.flatnonzero(images.camera[system.images] == c)
        n = len(at)
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
                covariance=V,
            )
        )  # fmt: skip
    return tuple(found)


def groups_of(own: OwnInteriors) -> Groups | None:
    """The most distinct groups of a camera's images; None where they may be chance.

    By each parameter: the sum of squares within the best division of the sorted values (Fisher 1958), as a share of
    all.  By all parameters together: Wilks' ratio of determinants (1932) of the best division into two.  Each is held
    against the same of normally distributed values without groups (Engelman and Hartigan 1969), which are drawn with
    the covariance that geometry, noise and smooth errors give them.
    """
    n, k = own.difference_px.shape
    counts = [g for g in range(2, MOST_GROUPS + 1) if g * FEWEST <= n]
    values, vectors = np.linalg.eigh(own.covariance)
    root = vectors * np.sqrt(np.maximum(values, 0.0))
    drawn = (np.random.default_rng(n).normal(size=(DRAWS, n * k)) @ root.T).reshape(DRAWS, n, k)
    tests = k * len(counts) + 1
    ratio, side = _in_two(own.difference_px[None])
    p = _probability(_in_two(drawn)[0], float(ratio[0])) * tests
    parts = [np.flatnonzero(side[0]), np.flatnonzero(~side[0])]
    clearest = int(np.argmin([_share_within(own.difference_px[:, j], parts) for j in range(k)]))
    found = [(p, clearest, parts)]
    for j in range(k):
        order = np.argsort(own.difference_px[:, j], kind="stable")
        shares, cuts = _divided(own.difference_px[order, j][None], max(counts))
        chance = _chance(drawn[:, :, j], max(counts))
        for g in counts:
            p = _probability(chance[g - 2], float(shares[g - 2, 0])) * tests
            found.append((p, j, np.split(order, cuts[g - 2][0])))
    p, j, parts = min(found, key=lambda f: (f[0], len(f[2])))  # of equal ones the first
    if p > LEVEL:
        return None
    parts.sort(key=lambda i: float(own.difference_px[i, j].mean()))
    within = _share_within(own.difference_px[:, j], parts) * float(np.var(own.difference_px[:, j]) * n)
    return Groups(
        images=tuple(np.sort(own.images[i]) for i in parts), symbol=OWN[j],
        means_px=np.array([own.difference_px[i, j].mean() for i in parts]),
        scatter_px=float(np.sqrt(within / max(n - len(parts), 1))), probability=p,
    )  # fmt: skip


def _probability(chance: Array, value: float) -> float:
    return float((1 + np.sum(chance <= value)) / (1 + len(chance)))


def _share_within(values: Array, parts: list[Index]) -> float:
    within = sum(float(((values[i] - values[i].mean()) ** 2).sum()) for i in parts)
    return within / max(float(((values - values.mean()) ** 2).sum()), 1e-300)


def _in_two(values: Array) -> tuple[Array, Array]:
    """Wilks' ratio (d,) of the best division of values (d, n, k) into two that is found, and the side (d, n) of each.

    With values whose scatter is the unit matrix, groups of a and b images with means m and m' have the ratio
    1 - a b / n |m - m'|^2.  From the order along each parameter, then along the difference of the means.
    """
    d, n, k = values.shape
    centred = values - values.mean(axis=1, keepdims=True)
    scale = np.sqrt(np.maximum(np.einsum("dnk,dnk->dk", centred, centred), 1e-300))
    unit = centred / scale[:, None]
    scatter = np.einsum("dnk,dnl->dkl", unit, unit) + 1e-9 * np.eye(k)
    white = np.linalg.solve(np.linalg.cholesky(scatter), unit.transpose(0, 2, 1)).transpose(0, 2, 1)
    sizes = np.arange(1, n)
    allowed = (sizes >= FEWEST) & (n - sizes >= FEWEST)
    best, side = np.ones(d), np.zeros((d, n), bool)
    for j in range(k):
        along = unit[:, :, j]
        for _ in range(TURNS):
            order = np.argsort(along, axis=1)
            sums = np.cumsum(np.take_along_axis(white, order[:, :, None], axis=1), axis=1)[:, :-1]
            gain = np.einsum("dnk,dnk->dn", sums, sums) * n / (sizes * (n - sizes))  # the whole sum is nil
            gain = np.where(allowed, gain, -1.0)
            cut = gain.argmax(axis=1)
            ratio = 1 - gain[np.arange(d), cut]
            rank = np.argsort(order, axis=1)
            now = rank <= cut[:, None]
            better = ratio < best
            best, side = np.where(better, ratio, best), np.where(better[:, None], now, side)
            along = np.einsum("dnk,dk->dn", white, -sums[np.arange(d), cut])
    return best, side


def _chance(drawn: Array, most: int) -> Array:
    """Shares (g - 1, d) of the square sum within the best 2 .. `most` groups of values (d, n) that have none."""
    d, n = drawn.shape
    pieces = np.array_split(np.sort(drawn, axis=1), max(1, d * n * n // TOGETHER))
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
