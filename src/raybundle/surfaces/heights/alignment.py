"""An older height model without photographs, moved onto a surface by what is stable in both.

Five unknowns: shift upwards, two tilts, shift in plan (Nuth and Kääb 2011, with tilts).  What moved is left out: many
starts, each improved by the 55 % that it fits best (Rousseeuw 1984), compete by squares that count nine variances of
neighbours at most (Torr and Zisserman 2000); then cells and means of neighbours beyond chance are left out.  The noise
of the older model follows from variances of means over squares of several sizes in the stable area, less those that the
surface states: a part of each cell, and one that neighbours share.

Limits: where nearly half moved alike by little on gentle ground, tilts and a shift in plan may follow it unnoticed.
Two transformations that fit alike are refused.

The surface's own errors of orientation go into the transformation as far as a shift and tilts can follow them, and what
is left of them is what remains in a difference: both models get the same independent errors.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NoReturn

import cv2
import numpy as np
from scipy.optimize import nnls
from scipy.special import ndtri

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.heights.cell_factors import factors_of
from raybundle.surfaces.heights.height_model import Blocks, HeightModel
from raybundle.surfaces.heights.heights import Heights, between
from raybundle.surfaces.heights.nodes import variances
from raybundle.surfaces.heights.resampling import difference
from raybundle.surfaces.heights.steps import planes, steps_of

STABLE = 0.55
"""Share of the heights that have not moved at least"""
BEYOND, ANY_MEAN = 4.0, 0.05
"""Standard deviations from which a cell has moved, and probability that any mean of neighbours of a stable grid is left
out (by Bonferroni): what is left out by chance makes the noise that neighbours share too small, by (2 Phi(z) - 1 -
2 z phi(z))^2 of the normal distribution cut off at z: 0.2 % at 4, but 5 % at 3"""
COUNTED = 3.0
"""Standard deviations of neighbours that a cell counts with at most while starts compete"""
STARTS, FEW, SAMPLED = 200, 6, 4_000
"""Starts of the robust fit, cells of every other, and cells that judge it"""
NEAR, STEPS = 0.2, 6
"""Half the side, in parts of the grid, of the squares whose cells are the other starts, since what moved hangs
together; steps of each, half of them with the best 55 %"""
ALIKE, ELSEWHERE = 1.1, 0.8
"""How much more another transformation may lose that fits as well: that of 45 % which moved alike loses 1.17 times as
much; and the share of the heights that differ by less where it is none"""
SMOOTH, SLOPE = 9, 4
"""Cells along the side of means of neighbours, and from the middle to the side of the planes of slopes"""
ROUNDS, SETTLED, CLOSE = 20, 6, 0.01
"""Times that the older model is moved, times that what is stable is found anew, and cells of a move that end it"""
FEWEST = 100
"""Stable cells"""
SIDES = (1, 2, 4, 8, 16, 32)
"""Of squares whose means show the noise [cells]"""
FEWEST_SQUARES = 10
"""Squares of a size whose means show the noise"""
ALONE, REWEIGHTED, LOWEST = 3, 5, 0.1
"""Position of the squares whose means are taken as independent; fits of the noise, and the share of a variance that a
fit has at least"""
PLAN_CELLS = 1.0
"""Standard deviation of the shift in plan from which it is refused: slopes hold as far"""
SIGNAL, PLACES = 2.0, 9
"""Least square sum of slopes, in what noise makes of it, that is no more than noise; places where that is evaluated"""
SEED = 1
UP, TILT_RIGHT, TILT_UP, RIGHT, ABOVE = range(5)


@dataclass(frozen=True, slots=True, kw_only=True)
class Noise:
    """Of the older model, estimated in the stable area."""

    own: float
    """standard deviation by what cells do not share"""
    common: float
    """by what neighbours share"""
    reach: float
    """distance in cells at which that correlates by 1 / e"""

    @property
    def sigma(self) -> float:
        """Standard deviation of a height."""
        return float(np.hypot(self.own, self.common))


@dataclass(frozen=True, slots=True, kw_only=True)
class Alignment:
    """How an older model was moved, and what shows it."""

    values: Array
    """(5,) shift upwards, tilts to the right and upwards in plan, shift to the right and upwards in plan"""
    covariance: Array
    """(5, 5) by noise of both and by the orientation of the surface"""
    stable: Mask
    share: float
    """of the heights that both have"""
    given: bool
    """the stable area was given, and not found"""
    noise: Noise

    @property
    def sigma(self) -> Array:
        """(5,) standard deviations."""
        return np.sqrt(np.diag(self.covariance))


def aligned(
    old: Callable[[Array], Array], new: HeightModel, stable: Mask | None = None
) -> tuple[HeightModel, HeightModel, Alignment]:
    """The older model as heights of the surface's grid, and the surface with the errors that both share.

    old     heights (rows, columns) at the cells of the surface, moved in plan by (2,) to the right and upwards
    stable  (rows, columns) what has not moved; None: it is found
    raises  InputError where the stable area is too small, or does not determine the transformation
    """
    plan, used, k = np.zeros(2), np.zeros(new.shape, bool), 0
    # slopes of the surface: those of the older model have the noise that the differences have, too
    design = _design(new.heights.height.astype(float), _places(new), new.cell)
    while True:
        height = old(plan)
        known = new.known & np.isfinite(height) & (True if stable is None else stable)
        if known.sum() < FEWEST:
            raise InputError("old_heights.too_few", n=int(known.sum()), needed=FEWEST)
        d = new.heights.height.astype(float) - height
        known &= np.isfinite(design).all(axis=2)
        # cells at the limit must not come and go for ever
        if k <= SETTLED:
            d0 = np.where(known, d, 0.0)
            begin = used & known if k else _begin(design, d0, known)
            used = _stable(design, d0, known, begin, given=stable is not None)
        used = used & known
        x = _solved(design[used], d[used])
        plan = plan + x[RIGHT:]
        k, settled = k + 1, bool(np.abs(x[RIGHT:]).max() < CLOSE * new.cell)
        if settled or k == ROUNDS:
            break
    values = np.concatenate([x[:RIGHT], plan])
    rest = d - design @ x
    noise = _noise(rest, used, new)
    moved = height + np.nan_to_num(design) @ x
    model = _model(moved, noise, new)
    covariance, both = _with_errors(model, new, design, used)
    _check(covariance, new.cell)  # what is not determined does not settle either
    if not settled:
        raise InputError("old_heights.not_converged", shift=[float(v) for v in plan], cell=new.cell)
    share = float(used.sum() / (new.known & np.isfinite(height)).sum())
    return *both, Alignment(
        values=values, covariance=covariance, stable=used, share=share, given=stable is not None, noise=noise
    )


def _places(new: HeightModel) -> Array:
    """(rows, columns, 2) of cells to the right and upwards from the middle of the grid."""
    r, c = (np.arange(n) + 0.5 - n / 2 for n in new.shape)
    return np.stack(np.broadcast_arrays(c[None] * new.cell, -r[:, None] * new.cell), axis=2)


def _design(height: Array, places: Array, cell: float) -> Array:
    """(rows, columns, 5) by how much heights move with each unknown; NaN where no slope is known."""
    p = planes(height / cell, SLOPE)
    slopes = np.where((p.count >= FEW)[..., None], np.stack([p.right, -p.down], axis=2), np.nan)
    return np.concatenate([np.ones((*height.shape, 1)), places, -slopes], axis=2)


def _solved(A: Array, d: Array) -> Array:
    return np.asarray(np.linalg.lstsq(A, d, rcond=None)[0])


def _stable(design: Array, d: Array, known: Mask, begin: Mask, *, given: bool) -> Mask:
    """Which cells have not moved, beginning with some that have not."""
    used = begin
    for _ in range(10):
        before = used
        rest = np.where(known, d - np.nan_to_num(design) @ _solved(design[used], d[used]), 0.0)
        limit = BEYOND * _scale(rest[before])
        used = known & (np.abs(rest) < limit)
        if not given:
            # means of neighbours show what moved by less than noise; beside what moved lies what moved by less
            n, total = (
                cv2.blur(v, (SMOOTH, SMOOTH), borderType=cv2.BORDER_CONSTANT)
                for v in (known.astype(float), np.clip(rest, -2 * limit, 2 * limit))
            )
            mean = total / np.maximum(n, 1e-9)
            beyond = float(-ndtri(ANY_MEAN / 2 / max(int(known.sum()), 1)))
            moved = known & (np.abs(mean) > beyond * _scale(mean[before]))
            used &= cv2.dilate(moved.astype(np.uint8), np.ones((SMOOTH, SMOOTH), np.uint8)) == 0
        if used.sum() < FEWEST:
            raise InputError("old_heights.too_few", n=int(used.sum()), needed=FEWEST)
        if (used != before).mean() < 1e-3:
            break
    return used


def _scale(values: Array) -> float:
    """Standard deviation by the median of absolute values."""
    return float(np.median(np.abs(values)) / ndtri(0.75))


def _begin(design: Array, d: Array, known: Mask) -> Mask:
    """The cells that the best of many transformations fits within three standard deviations of neighbours."""
    rng = np.random.default_rng(SEED)
    at = np.flatnonzero(known)
    at = at if len(at) <= SAMPLED else rng.choice(at, SAMPLED, replace=False)
    A, y = design.reshape(-1, 5)[at], d.ravel()[at]
    p = planes(np.where(known, d, np.nan), 2 * SLOPE)
    limit = COUNTED * float(np.sqrt(np.median(p.scatter[known & np.isfinite(p.scatter)])))
    found = list[tuple[float, Array]]()
    place = np.stack(np.divmod(at, known.shape[1]), axis=1) / known.shape
    for k in range(STARTS):
        few = rng.choice(len(y), FEW, replace=False)
        if k % 2:
            few = np.flatnonzero(np.abs(place - place[few[0]]).max(axis=1) < NEAR)
        x = _solved(A[few], y[few])
        for step in range(STEPS):
            e = np.abs(y - A @ x)
            near = e <= (np.quantile(e, STABLE) if step < STEPS / 2 else limit)
            if near.sum() > FEW:
                x = _solved(A[near], y[near])
        found.append((float(np.mean(np.minimum(np.abs(y - A @ x), limit) ** 2)), x))
    least, best = min(found, key=lambda f: f[0])
    for lost, x in found:
        if lost < ALIKE * least and np.quantile(np.abs(A @ (x - best)), ELSEWHERE) > limit:
            raise InputError("old_heights.ambiguous")
    return known & (np.abs(d - np.nan_to_num(design) @ best) <= limit)


def _noise(rest: Array, used: Mask, new: HeightModel) -> Noise:
    """By variances of means over squares."""
    h = new.heights
    own, point, step = (float(np.mean(np.square(v[used].astype(float)))) for v in (new.local, h.point, h.step))
    own, sizes, found, counts = own - step, list[int](), list[float](), list[int]()
    total, n = (cv2.integral(v) for v in (np.where(used, rest, 0.0), used.astype(float)))
    for side in SIDES:
        s, k = (
            v[side::side, side::side] - v[:-side:side, side::side] - v[side::side, :-side:side]
            + v[:-side:side, :-side:side] for v in (total, n)
        )  # fmt: skip
        full = k >= 0.7 * side**2
        if full.sum() < FEWEST_SQUARES:
            break
        sizes.append(side)
        counts.append(int(full.sum()))
        # the transformation follows five of the means at most
        found.append(float(np.sum(np.square(s[full] / k[full]))) / (int(full.sum()) - 5))
    k0 = float(between(np.zeros(1), np.zeros(1), new.length)[0])
    stated = [
        own / side**2 + step / side**2 + point * (_pairs(side, new.length, exact=False) ** 2 - k0 / side**2)
        for side in sizes
    ]
    # means that neighbours share do not count more often because squares are small
    alone = np.sqrt(np.minimum(counts, counts[min(ALONE, len(counts) - 1)]))
    best, least = Noise(own=0.0, common=0.0, reach=1.0), np.inf
    for reach in np.geomspace(1, max(min(new.shape) / 4, 1.5), 24).tolist():
        A = np.array([[1 / side**2, _pairs(side, reach, exact=True) ** 2] for side in sizes])
        x, fitted = np.zeros(2), np.array(found)
        for _ in range(REWEIGHTED):
            w = alone / fitted
            x, _ = nnls(A * w[:, None], np.maximum(np.array(found) - stated, 0.0) * w)
            # weights by what is measured would favour what is too small by chance
            fitted = np.maximum(A @ x + stated, LOWEST * np.array(found))
        e = float((alone**2 * np.log(fitted / found) ** 2).sum())
        if e < least:
            best, least = Noise(own=float(np.sqrt(x[0])), common=float(np.sqrt(x[1])), reach=reach), e
    return best


def _pairs(side: int, length: float, *, exact: bool) -> float:
    """Mean correlation of two of so many cells in a row.

    exact  exp(-(d / length)^2) of distances of middles; else the square root of the mean over both cells
    """
    apart = np.abs(np.subtract.outer(np.arange(side), np.arange(side))).astype(float)
    k = np.exp(-((apart / length) ** 2)) if exact else between(apart, np.zeros(1), length)
    k0 = 1.0 if exact else float(np.sqrt(between(np.zeros(1), np.zeros(1), length)[0]))
    return float(np.mean(k / k0))


def _model(height: Array, noise: Noise, new: HeightModel) -> HeightModel:
    """Heights of the surface's grid with that noise, as yet without errors of the transformation."""
    known = np.isfinite(height)
    flat = np.where(known, np.float32(0), np.float32(np.nan))
    local = flat + np.float32(noise.own)
    step = np.nan_to_num(steps_of(height.astype(np.float32), local + np.float32(noise.common), new.length, new.cell))
    heights = Heights(
        height=height.astype(np.float32), local=local, step=step.astype(np.float32), orientation=flat, point=flat,
        points=known.astype(np.uint16), image=np.where(known, 0, -1).astype(np.int32),
    )  # fmt: skip
    nodes = new.moved.shape[:2]
    levels = np.zeros(nodes)
    sigma = np.where(known, noise.common, 0.0).astype(np.float32)
    return HeightModel(
        heights=heights, moved=np.zeros((*nodes, 4, 0), np.float32), block=new.block, cell=new.cell, length=new.length,
        factors=factors_of(height, local, levels, new.block, new.cell), levels=levels,
        blocks=Blocks(sigma=sigma, reach=noise.reach) if noise.common else None,
    )  # fmt: skip


def _with_errors(
    old: HeightModel, new: HeightModel, design: Array, used: Mask
) -> tuple[Array, tuple[HeightModel, HeightModel]]:
    """Covariance of the transformation, and both models with the same independent errors."""
    A = design[used]
    size = np.linalg.norm(A, axis=0)
    normal = (A / size).T @ (A / size)
    if np.linalg.matrix_rank(normal, hermitian=True) < 5:
        raise InputError("old_heights.not_determined")
    # noise of slopes makes the normal matrix larger than what slopes show
    by_noise = len(A) * _slope_variance(new, used)
    _check_slopes(normal * np.outer(size, size), by_noise, float(np.median(new.local[used])), new.cell)
    normal[RIGHT:, RIGHT:] -= np.diag(by_noise / size[RIGHT:] ** 2)
    solve = np.linalg.solve(normal, (A / size).T) / size[:, None]
    rows = [np.zeros(new.shape) for _ in range(5)]
    for w, one in zip(rows, solve, strict=True):
        w[used] = one
    d = difference(old, new)
    sums = [d.sum_of(w) for w in rows]
    local = np.diag([s.local**2 for s in sums])
    for i in range(5):
        for j in range(i):
            both = d.sum_of(rows[i] + rows[j]).local ** 2
            local[i, j] = local[j, i] = (both - local[i, i] - local[j, j]) / 2
    values, vectors = np.linalg.eigh(local / np.outer(size, size) ** -1)
    root = vectors * np.sqrt(np.maximum(values, 0.0)) / size[:, None]
    moves = np.array([s.moved for s in sums])
    each = np.hstack([moves, root])
    r, c = np.mgrid[: new.moved.shape[0], : new.moved.shape[1]].astype(float)
    place = (c * new.block - new.shape[1] / 2) * new.cell, -(r * new.block - new.shape[0] / 2) * new.cell
    nodes = np.zeros((*r.shape, 4, 5))
    nodes[..., 0, UP], nodes[..., 0, TILT_RIGHT], nodes[..., 0, TILT_UP] = 1.0, *place
    nodes[..., 2, RIGHT] = nodes[..., 3, ABOVE] = 1.0
    moved = (nodes @ each).astype(np.float32)
    sigma = np.sqrt(variances(moved, old.block, old.shape, factors=old.factors))
    heights = replace(old.heights, orientation=np.where(old.known, sigma, np.nan).astype(np.float32))
    name = f"aligned to {new.errors}"
    more = np.zeros((*new.moved.shape[:3], 5), np.float32)
    surface = replace(new, moved=np.concatenate([new.moved, more], axis=3), errors=name)
    return each @ each.T, (replace(old, heights=heights, moved=moved, errors=name), surface)


def _slope_variance(new: HeightModel, used: Mask) -> float:
    """Variance of the slopes of planes by the noise of the surface."""
    n = 2 * SLOPE + 1
    inside = cv2.erode(used.astype(np.uint8), np.ones((n, n), np.uint8), borderValue=0) > 0
    at = np.argwhere(inside)
    if not len(at):
        return 0.0
    x = np.arange(-SLOPE, SLOPE + 1.0)
    window = np.broadcast_to(x / (n * (x**2).sum() * new.cell), (n, n))
    found = list[float]()
    for r, c in at[np.linspace(0, len(at) - 1, PLACES).astype(int)].tolist():
        w = np.zeros(new.shape)
        w[r - SLOPE : r + SLOPE + 1, c - SLOPE : c + SLOPE + 1] = window
        found.append(new.sum_of(w).local ** 2)
    return float(np.mean(found))


def _check_slopes(normal: Array, by_noise: float, sigma: float, cell: float) -> None:
    """Raise InputError, with the direction, where slopes in a direction are no more than noise."""
    others = normal[:RIGHT, RIGHT:]
    values, vectors = np.linalg.eigh(
        normal[RIGHT:, RIGHT:] - others.T @ np.linalg.solve(normal[:RIGHT, :RIGHT], others)
    )
    least, by_slopes = float(values[0]), float(values[0]) - by_noise
    if least < SIGNAL * by_noise:
        worst = sigma * float(np.sqrt(max(least, 0.0))) / max(by_slopes, 0.01 * by_noise)
        _undetermined(vectors[:, 0], max(worst, PLAN_CELLS * cell), cell)


def _undetermined(direction: Array, sigma: float, cell: float) -> NoReturn:
    angle = float(np.degrees(np.arctan2(direction[0], direction[1])) % 180)
    raise InputError("old_heights.plan_undetermined", direction_deg=angle, sigma=sigma, limit=PLAN_CELLS * cell)


def _check(covariance: Array, cell: float) -> None:
    """Raise InputError, with the direction, where the shift in plan is not determined."""
    values, vectors = np.linalg.eigh(covariance[RIGHT:, RIGHT:])
    worst = float(np.sqrt(values[1]))
    if worst > PLAN_CELLS * cell:
        _undetermined(vectors[:, 1], worst, cell)
