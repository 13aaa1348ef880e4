"""What has moved between two surfaces by more than chance: by all of it together, and by places of it.

All errors of orientation move large parts alike.  They are estimated first, with what is known of them before
(Gauss-Markov with a prior, robust by Huber's weights, so that a place that has moved has little say): what they cannot
explain is local.  Local movement is looked for in windows of several sizes, as means of differences over their standard
deviations.  The limit is Bonferroni's for all windows that are looked at, so that the chance of any false alarm on
the whole surface is at most 5 % (family-wise; Nichols and Hayasaka 2003).  Single differences count up to three
standard deviations each: blunders have heavier tails than noise, and no single cell is a movement.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from scipy.ndimage import binary_fill_holes
from scipy.special import chdtri, ndtri

from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.heights.grids import filtered
from raybundle.surfaces.heights.height_model import HeightModel, SumOfHeights
from raybundle.surfaces.heights.heights import between
from raybundle.surfaces.heights.hole_filling import parts_of
from raybundle.surfaces.heights.level_of_detection import (
    DetectionMap,
    OrientationFit,
    SmallestMovement,
    Windows,
    detection_maps,
    smallest_movements,
)  # fmt: skip
from raybundle.surfaces.heights.nodes import at_cells, information, splat, variances
from raybundle.surfaces.heights.steps import step_length

CHANCE = 0.05
"""Of any false alarm on the whole surface, and of the test of all of it."""
SIDES = (3, 5, 9, 17, 33, 65, 129)
"""Of windows [cells]"""
HUBER = 1.5
MOST, MOST_FILLED = 3.0, 10.0
"""Standard deviations that a single difference counts at most; one that was filled, which is no measurement of its own:
all of its hole has its error."""
KNOWN = 0.5
"""Share of a window's cells that need a difference."""
ROUNDS, PASSES = 30, 6
BESIDE = 1.5
"""Cells around a region that belong to neither side."""
LEFT = 0.3
"""Share of the cells that have not moved that shows the errors of orientation at least."""
SAME = 0.01
"""Share of the cells that are one measurement in both surfaces from where they say that the whole has not moved."""
SURE = 4.0
"""Standard deviations of a mean that the movement of a region is at least, where its outline is drawn."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WholeMovement:
    """How the whole has moved: shift and tilts of a plane, by cells that no region has."""

    shift: SumOfHeights
    """of the middle"""
    tilt: tuple[float, float]
    """by the columns and rows, rise over run"""
    tilt_sigma: tuple[float, float]
    chi2: float
    """of the three together, by their joint covariance"""

    @property
    def limit(self) -> float:
        """That chance leaves unexceeded in 95 %."""
        return float(chdtri(3, CHANCE))

    @property
    def significant(self) -> bool:
        """Whether it is more than chance."""
        return self.chi2 > self.limit


@dataclass(frozen=True, slots=True, kw_only=True)
class Region:
    """A connected part that has moved against the rest."""

    cells: Mask
    """those within that have no height count"""
    area: float
    area_sigma: float
    """by how well its outline is known"""
    mean: float
    """movement against the rest over all of its area: volume / area"""
    mean_sigma: float
    amount: float
    """movement of its inner part alone, so that a wrong outline, and what moved less at its rim, does not count"""
    amount_sigma: float
    volume: float
    volume_sigma: float
    edge: float
    """how well its outline is known: standard deviation of a place of it, in the unit of the heights"""
    peak: float
    """largest mean of a window over its standard deviation"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Movements:
    """What has moved."""

    whole: WholeMovement
    regions: tuple[Region, ...]
    """the largest volume first"""
    local: Array
    """(rows, columns) differences less what orientation explains"""
    sigma: Array
    """(rows, columns) their standard deviations"""
    peak: Array
    """(rows, columns) the largest mean of a window about a cell over its standard deviation, with its sign"""
    limit: float
    """of the absolute value of that, for a chance of 5 % on the whole surface"""
    windows: int
    """that were looked at"""
    sizes: tuple[Windows, ...]
    fit: OrientationFit
    """how the errors of orientation were estimated"""

    def smallest(self, model: HeightModel) -> tuple[SmallestMovement, ...]:
        """That would have been found, of squares of some sizes."""
        return smallest_movements(model, _most(model), self.sizes, self.limit, self.fit)

    def detectable(self, model: HeightModel) -> tuple[DetectionMap, ...]:
        """The same at each place."""
        return detection_maps(model, _most(model), self.sizes, self.limit, self.fit)


def movements(model: HeightModel) -> Movements:
    """What has moved, by differences of heights and all their errors.

    Limits: a movement that errors of orientation can explain, other than by its size.  Cells that both
    have from one measurement differ by nothing, without error: they have not moved, and are not tested.
    """
    free = model.known
    found = _local(model, free)
    for k in range(PASSES):
        # what has moved is to have no say in the errors of orientation: as long as it has, it makes others seem to have
        # moved the other way.  So the strongest come first
        strongest = sorted(found.regions, key=lambda r: -r.peak)[: 2**k if k < PASSES - 2 else None]
        before, free = free, _without(model.known, strongest)
        if (free == before).all():
            break
        found = _local(model, free)
    return Movements(
        whole=_whole(model, free), regions=found.regions, local=found.local,
        sigma=np.sqrt(model.local.astype(float) ** 2 + found.uncertain), peak=found.peak, limit=found.limit,
        windows=found.windows,
        sizes=found.sizes, fit=found.fit,
    )  # fmt: skip


def _tested(model: HeightModel) -> Mask:
    """Cells with a difference that is not of one measurement."""
    return model.known & (model.local > 0)


def _most(model: HeightModel) -> Array:
    """(rows, columns) standard deviations that differences count at most; 0: they are not tested."""
    most = MOST if model.holes is None else np.where(model.holes.filled, MOST_FILLED, MOST)
    return np.where(_tested(model), most, 0.0)


def _without(known: Mask, regions: Sequence[Region]) -> Mask:
    """Cells that no region has, nor its surroundings, over which a gentle movement ends; some are always left."""
    moved = np.zeros(known.shape, bool)
    for r in regions:
        moved |= r.cells
    free = known
    for share in (1.0, 0.5, 0.25, 0.0):
        free = known.copy()
        for r in regions:
            reach = BESIDE + share * float(np.sqrt(r.cells.sum() / np.pi))
            box = _box_about(r.cells, int(np.ceil(reach)))
            free[box] &= cv2.distanceTransform((~r.cells[box]).astype(np.uint8), cv2.DIST_L2, 5) > reach
        if free.sum() >= LEFT * (known & ~moved).sum():
            break
    return free if free.any() else known


def _box_about(cells: Mask, margin: int) -> tuple[slice, slice]:
    """Rows and columns that hold some cells and so many around them."""
    sides = [np.flatnonzero(cells.any(axis=axis)) for axis in (1, 0)]
    rows, columns = (slice(max(0, int(k[0]) - margin), int(k[-1]) + margin + 1) for k in sides)
    return rows, columns


@dataclass(frozen=True, slots=True, kw_only=True)
class _Local:
    """What has moved against the rest."""

    local: Array
    uncertain: Array
    """variance of it by what is not known of orientation"""
    peak: Array
    limit: float
    windows: int
    sizes: tuple[Windows, ...]
    fit: OrientationFit
    regions: tuple[Region, ...]


def _local(model: HeightModel, free: Mask) -> _Local:
    """What has moved against cells that are free of movements."""
    z, P = _orientation(model, free)
    local = model.heights.height.astype(float) - _by_errors(model, z)
    uncertain = variances(model.moved, model.block, model.shape, P, model.factors)
    sizes = _windows(model, local, uncertain)
    count = sum(int(np.isfinite(w.mean).sum()) for w in sizes)
    limit = float(-ndtri(CHANCE / 2 / max(count, 1)))
    peak, hits = _beyond(model, sizes, limit)
    regions = _regions(model, local, uncertain, hits, peak)
    fit = OrientationFit(covariance=P, alike=_alike(model), huber=HUBER)
    return _Local(
        local=local, uncertain=uncertain, peak=peak, limit=limit, windows=count, regions=regions, sizes=sizes, fit=fit
    )


def _alike(model: HeightModel) -> float:
    """Neighbours with common errors, which count once."""
    return 1 + np.pi * model.length**2


def _by_errors(model: HeightModel, errors: Array) -> Array:
    """(rows, columns) by how much errors of orientation (q,) move heights."""
    return at_cells(model.moved.astype(float) @ errors, model.block, model.shape, model.factors)


def _orientation(model: HeightModel, free: Mask) -> tuple[Array, Array]:
    """Errors of orientation (q,) that explain most of the differences, and their covariance."""
    *parts, q = model.moved.shape
    M = model.moved.reshape(int(np.prod(parts)), q).astype(float)
    known = free & (model.local > 0)
    s = np.where(known, model.local, 1.0).astype(float)
    d = np.where(known, model.heights.height, 0.0).astype(float)
    alike = _alike(model)
    z, P = np.zeros(q), np.eye(q)
    if not known.any() or not q:
        return z, P
    usual = float(np.median(s[known]))
    for k in range(ROUNDS):
        # by least squares first: against no errors at all, those of a tilt would make blunders of most differences
        e = np.abs(d - _by_errors(model, z)) / s if k else np.zeros(d.shape)
        w = np.where(known, np.minimum(1.0, HUBER / np.maximum(e, 1e-12)) / (s**2 * alike), 0.0)
        P = np.linalg.inv(information(model.moved, model.block, w, model.factors) + np.eye(q))
        new = P @ (M.T @ splat(w * d, model.moved, model.block, model.factors).ravel())
        far = float(np.abs(_by_errors(model, new - z)).max(initial=0.0))
        z = new
        if k and far < 1e-3 * usual:
            break
    return z, P


def _windows(model: HeightModel, local: Array, uncertain: Array) -> tuple[Windows, ...]:
    """Windows of all sizes."""
    known = _tested(model)
    s = np.where(known, model.local, 1.0).astype(float)
    most = _most(model)
    t = np.where(known, np.clip(local / s, -most, most), 0.0)
    variance = _correlated(model, known, s)
    holes, all_of_hole = _of_holes(model, known, s)
    found = list[Windows]()
    for side in (k for k in SIDES if k <= min(model.shape)):
        step = max(1, side // 2)
        rows, columns = (np.arange(0, n - side + 1, step) for n in model.shape)

        def over(values: Array, side: int = side, rows: Array = rows, columns: Array = columns) -> Array:
            total = cv2.integral(values.astype(np.float64))
            below, above = total[rows + side], total[rows]
            return below[:, columns + side] - below[:, columns] - above[:, columns + side] + above[:, columns]

        n = over(known.astype(float))
        # what is left of orientation moves a window as a whole, the error of a hole all of that
        common = over(np.where(known, np.sqrt(uncertain) / s, 0.0)) ** 2
        common += np.maximum(np.minimum(over(holes) ** 2, over(holes * all_of_hole)), 0.0)
        spread = np.sqrt(np.maximum(over(variance), 1e-300) + common)
        mean = np.where(n >= KNOWN * side**2, over(t) / spread, np.nan)
        found.append(Windows(side=side, rows=rows, columns=columns, mean=mean, spread=spread))
    return tuple(found)


def _beyond(model: HeightModel, sizes: Sequence[Windows], limit: float) -> tuple[Array, Mask]:
    """The peaks, and the cells of windows beyond the limit, by sign (2, rows, columns)."""
    known = _tested(model)
    peak, hits = np.zeros(model.shape), np.zeros((2, *model.shape), bool)
    for w in sizes:
        strong = np.argwhere(np.isfinite(w.mean) & (np.abs(w.mean) > limit))
        new = np.zeros_like(hits)
        for a, b in strong.tolist():
            box = slice(w.rows[a], w.rows[a] + w.side), slice(w.columns[b], w.columns[b] + w.side)
            # what smaller windows have found already, larger ones only blur
            if not hits[int(w.mean[a, b] < 0)][box].any():
                new[int(w.mean[a, b] < 0)][box] = True
        hits |= new
        peak = _larger(peak, _spread_out(np.nan_to_num(w.mean), w.rows, w.columns, w.side, model.shape))
    return np.where(known, peak, np.nan), hits & known


def _larger(one: Array, other: Array) -> Array:
    return np.where(np.abs(other) > np.abs(one), other, one)


def _spread_out(z: Array, rows: Array, columns: Array, side: int, shape: tuple[int, int]) -> Array:
    """(rows, columns) values of windows at the cells nearest to their middles."""
    if not len(rows) or not len(columns):
        return np.zeros(shape)
    step = max(1, side // 2)
    i, j = (
        np.clip((np.arange(n) - side // 2 + step // 2) // step, 0, len(k) - 1)
        for n, k in zip(shape, (rows, columns), strict=True)
    )
    return z[i][:, j]


def _correlated(model: HeightModel, known: Mask, s: Array) -> Array:
    """(rows, columns) parts of the variance of a sum of normalised differences, those with neighbours included.

    All neighbours count as of one map, and those beyond a window's edge, too: never too little.
    """
    h = model.heights
    own, point, step = (np.where(known, np.nan_to_num(v.astype(float)) / s, 0.0) for v in (h.local, h.point, h.step))
    n = int(np.ceil(3 * model.length)) + 1
    kernel = between(np.arange(-n, n + 1.0), np.zeros(1), model.length)
    kernel = kernel / np.sqrt(between(np.zeros(1), np.zeros(1), model.length))
    found = own**2 + point * (filtered(point, kernel) - kernel[n] ** 2 * point)
    length = step_length(model.length)
    n = int(np.ceil(3 * length))
    found = found + step * filtered(step, np.exp(-((np.arange(-n, n + 1.0) / length) ** 2)))
    if model.blocks is None:
        return found
    reach = model.blocks.reach
    n = int(np.ceil(3 * reach))
    blocks = np.where(known, model.blocks.sigma / s, 0.0)
    return found + blocks * filtered(blocks, np.exp(-((np.arange(-n, n + 1.0) / reach) ** 2)))


def _of_holes(model: HeightModel, known: Mask, s: Array) -> tuple[Array, Array]:
    """(rows, columns) normalised standard deviations by holes that were filled, and of all cells of a hole together."""
    if model.holes is None:
        return np.zeros(model.shape), np.zeros(model.shape)
    own = np.where(known, model.holes.sigma / s, 0.0)
    number = model.holes.number
    return own, np.bincount(number.ravel(), own.ravel())[number]


def _regions(model: HeightModel, local: Array, uncertain: Array, hits: Array, peak: Array) -> tuple[Region, ...]:
    """Connected parts that windows found, with outlines where half of the movement is reached."""
    found = list[tuple[Mask, int, float]]()
    taken = np.zeros(model.shape, bool)
    for sign, hit in zip((1.0, -1.0), hits, strict=True):
        number, count = parts_of(hit)
        order = sorted(range(1, count + 1), key=lambda k: -int((number == k).sum()))
        for k in order:
            whole = number == k
            seed = whole & ~taken
            # what is left of windows whose greater part a region has is what lies beside that
            if 2 * seed.sum() <= whole.sum():
                continue
            cells, side = _outlined(model, sign * local, seed)
            cells &= ~taken
            if not cells.any():
                continue
            taken |= cells
            found.append((cells, side, float(np.abs(peak[seed]).max())))
    regions = [_region(model, local, uncertain, *each, taken & ~each[0]) for each in found]
    return tuple(sorted(regions, key=lambda r: -abs(r.volume)))


def _outlined(model: HeightModel, local: Array, seed: Mask) -> tuple[Mask, int]:
    """Cells of a movement upwards that are connected with those that windows found, and the side of the means."""
    known = _tested(model)
    variance = np.where(known, np.nan_to_num(model.heights.local.astype(float)) ** 2, 0.0)
    values = np.where(known, local, 0.0)
    amount = _amount(local[seed], model.local[seed])
    usual = float(np.median(np.sqrt(variance[seed])))
    side = 1
    while side < 33 and usual * np.sqrt(1 + np.pi * model.length**2) / side > amount / SURE:
        side += 2
    cells = seed
    for _ in range(3):
        # weights leave out blunders and steps, which show little of where a movement ends
        w = np.where(known, 1 / np.maximum(np.square(model.local.astype(float)), 1e-300), 0.0)
        w = np.where(known, np.minimum(w, 1 / max(usual, 1e-300) ** 2), 0.0)
        box = (side, side)
        limited = np.clip(values, amount / 2 - MOST * usual - amount, amount / 2 + MOST * usual + amount)
        mean = cv2.blur(w * limited, box) / np.maximum(cv2.blur(w, box), 1e-300)
        number, _ = parts_of(known & (mean > amount / 2))
        mine = np.unique(number[seed & (number > 0)])
        cells = np.isin(number, mine[mine > 0])
        if not cells.any():
            return seed, side
        again = _amount(local[cells], model.local[cells])
        if abs(again - amount) < 0.01 * amount:
            break
        amount = again
    cells = cv2.morphologyEx(cells.astype(np.uint8), cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8)) > 0
    # what was not measured within a movement has moved, too
    return np.asarray(binary_fill_holes(cells), bool) & (known | ~model.known), side


def _amount(values: Array, sigma: Array) -> float:
    """Weighted median, robust against what a window holds beside the movement."""
    order = np.argsort(values)
    w = np.cumsum(1 / np.maximum(sigma[order].astype(float), 1e-300))
    return max(float(values[order][np.searchsorted(w, w[-1] / 2)]), 1e-300)


def _region(
    model: HeightModel, local: Array, uncertain: Array, cells: Mask, side: int, peak: float, others: Mask
) -> Region:  # fmt: skip
    """Numbers of a region; `others` are cells of other regions."""
    rim = max(1, side // 2 + 1)
    inner = cv2.erode(cells.astype(np.uint8), np.ones((2 * rim + 1,) * 2, np.uint8), borderValue=0) > 0
    inner = (inner if (inner & model.known).sum() >= FEWEST else cells) & model.known
    area, n = model.cell**2, int(cells.sum())
    w = np.where(inner, 1 / np.maximum(model.local.astype(float), 1e-300), 0.0)
    w /= w.sum()
    amount = float((w[inner] * local[inner]).sum())
    left = float((w[inner] * np.sqrt(uncertain[inner])).sum())
    amount_sigma = float(np.hypot(model.sum_of(w).local, left))
    edge_cells = n - int((cv2.erode(cells.astype(np.uint8), np.ones((3, 3), np.uint8), borderValue=0) > 0).sum())
    # an edge lies somewhere within the cells of the mean that found it
    edge = model.cell * np.sqrt((side**2 + 1) / 12)
    # beside it heights that are worse than half of the movement, or missing, may belong to it or not, all together
    around = cv2.dilate(cells.astype(np.uint8), np.ones((2 * rim + 3,) * 2, np.uint8)) > 0
    unclear = around & ~cells & ~(np.asarray(model.local) < abs(amount) / 2)
    area_sigma = np.hypot(edge * model.cell * np.sqrt(edge_cells * side), unclear.sum() * area / np.sqrt(12))
    # cells without a height have moved as the others have
    inside = (cells & model.known).astype(float)
    inside *= n / inside.sum()
    volume = float((inside * np.nan_to_num(local)).sum() * area)
    by_height = area * float(np.hypot(model.sum_of(inside).local, (inside * np.sqrt(uncertain)).sum()))
    mean = volume / (n * area)
    # what an outline that is off has more or less moved by half of the amount
    by_outline = abs(mean - amount / 2) * area_sigma
    beyond = _cut_off(model, local, uncertain, cells, rim, others)
    return Region(
        cells=cells, area=n * area, area_sigma=float(area_sigma), volume=volume, edge=float(edge), peak=peak,
        volume_sigma=float(np.linalg.norm([by_height, amount * area_sigma / 2, beyond])), amount=amount,
        amount_sigma=amount_sigma,
        mean=mean, mean_sigma=float(np.hypot(by_height, by_outline)) / (n * area),
    )  # fmt: skip


FEWEST = 9
"""Cells of an inner part"""
SKIRT, RINGS = 2.0, 20
"""Standard deviations by which a ring around a region has moved that belongs to it, and rings that are looked at: one
in forty that has not moved counts, too"""


def _cut_off(model: HeightModel, local: Array, uncertain: Array, cells: Mask, rim: int, others: Mask) -> float:
    """Volume that moved along with a region beyond its outline, which lies where half of the movement is reached.

    Rings as wide as the rim, as far as each has moved the same way by more than chance; cells beside steps, which are
    uncertain, have moved as the rest of their ring.
    """
    tested, total = _tested(model) & ~others, 0.0
    sign = float(np.sign(local[cells & _tested(model)].sum()))
    usual = float(np.median(model.local[tested])) if tested.any() else 0.0
    inner = cells
    for _ in range(RINGS):
        wider = cv2.dilate(inner.astype(np.uint8), np.ones((2 * rim + 1,) * 2, np.uint8)) > 0
        ring = wider & ~inner & tested
        if not ring.any():
            break
        w = np.where(ring, 1 / np.maximum(model.local.astype(float), usual) ** 2, 0.0)
        w /= w.sum()
        mean = sign * float((w * np.nan_to_num(local)).sum())
        if mean < SKIRT * np.hypot(model.sum_of(w).local, (w * np.sqrt(uncertain)).sum()):
            break
        total += mean * int(ring.sum()) * model.cell**2
        inner = wider
    return total


def _whole(model: HeightModel, free: Mask) -> WholeMovement:
    """Shift and tilts of the plane that fits the differences of cells best."""
    same = free & (model.local == 0)
    # what is one measurement in both has not moved
    used = same if same.sum() >= max(3, SAME * free.sum()) else free & (model.local > 0)
    r, c = np.nonzero(used)
    middle = np.array([c.mean(), r.mean()]) if len(r) else np.zeros(2)
    A = np.stack([np.ones(len(r)), (c - middle[0]) * model.cell, (r - middle[1]) * model.cell], axis=1)
    s = model.local[r, c].astype(float)
    w = np.ones(len(r))
    if (s > 0).any():
        # differences beyond three standard deviations of all are blunders or steps: they count less
        d = model.heights.height[r, c].astype(float)
        total = np.hypot(s, model.heights.orientation[r, c])
        w = np.minimum(1.0, MOST * total / np.maximum(np.abs(d - np.median(d)), 1e-300))
        w /= np.maximum(s, np.median(s)) ** 2
    solve = np.linalg.pinv(A * np.sqrt(w)[:, None]) * np.sqrt(w)
    sums = list[SumOfHeights]()
    for row in solve:
        weights = np.zeros(model.shape)
        weights[r, c] = row
        sums.append(model.sum_of(weights))
    moved = np.array([x.moved for x in sums])
    cov = moved @ moved.T + np.diag([x.local**2 for x in sums])
    value = np.array([x.value for x in sums])
    return WholeMovement(
        shift=sums[0], tilt=(sums[1].value, sums[2].value), tilt_sigma=(sums[1].sigma, sums[2].sigma),
        chi2=_chi2(value, cov),
    )  # fmt: skip


def _chi2(value: Array, covariance: Array) -> float:
    """Of values by their covariance; what is known without error is left out."""
    s = np.sqrt(np.diag(covariance))
    known = s > 0
    value, s = value[known] / s[known], s[known]
    return float(value @ np.linalg.pinv(covariance[np.ix_(known, known)] / np.outer(s, s), hermitian=True) @ value)
