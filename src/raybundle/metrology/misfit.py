"""Why points of one name do not fit each other: mirrored, in another scale, some of them wrong, names exchanged.

A least squares fit bends to what is wrong.  Here the larger half that agrees best is looked for first (least trimmed
squares, Rousseeuw and Van Driessen 2006), and each point is tested against the others by their own scatter (the block
of three coordinates as one blunder, externally studentized: Cook and Weisberg 1982).  The scatter is that of the points
themselves: what they state of their errors is of no account, but as a floor.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from math import comb

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.statistics import fisher_tail
from raybundle.numerics.transform import Similarity, similarity

LEVEL = 0.001
"""Probability that points that fit are called wrong, mirrored or of another scale: that of data snooping (Baarda)"""
STARTS = 120
"""Triples that are drawn: of points of which 4 in 10 are wrong all are right with 22 %, one of 120 for certain"""
FEWEST = 5
"""Points by which a mirror image is reported: of four one with its depth on the wrong side looks like one"""
STEPS = 10
AT_ONCE = 100_000
"""Points that are moved onto the others at once, of all triples together"""
ROUNDS = 60
MIRROR = np.array([1.0, 1.0, -1.0])
AS_WELL = 0.05
"""Probability of the ratio of two misfits from which on one explanation is as good as the other"""
IN_LINE = 1e-6
"""Size across, as a share of that along, up to which points are in one line: no axes can be fitted by these"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Misfit:
    """How points fit onto others of the same names, and what stands in the way; arrays over the points."""

    mirrored: bool
    """A reflection fits far better"""
    scaled: bool
    """Another scale fits far better than the one that is kept"""
    factor: float
    """Target lengths over source lengths; 1 where the scale is kept and nothing contradicts that"""
    factor_sigma: float
    """Its standard deviation by the scatter of the points"""
    fits: Mask
    """(n,) points that agree with each other, by their own scatter"""
    distance: Array
    """(n,) from where those that agree have a point to where it is [unit of the target]"""
    exchanged: tuple[tuple[int, int], ...]
    """Pairs that fit with their names exchanged"""
    instead: tuple[int, ...]
    """Where one point is wrong: others that, left out instead, explain it as well"""
    rms: float
    """Of a coordinate of the points that agree [unit of the target]"""
    rms_kept: float
    """The same with the scale kept"""
    extent: float
    """Root mean square of a coordinate of the target about its middle [unit of the target]"""
    transform: Similarity
    """By the points that agree: of the mirrored source where it is mirrored, with `factor`"""

    @property
    def wrong(self) -> list[int]:
        """Points that do not agree with the others, the farthest first."""
        at = np.flatnonzero(~self.fits)
        return at[np.argsort(-self.distance[at], kind="stable")].tolist()

    @property
    def scattered(self) -> bool:
        """Whether no axes fit: half of the points or more do not agree, or what agrees explains no half of where."""
        return 2 * int(self.fits.sum()) <= len(self.fits) or self.rms > np.sqrt(0.5) * self.extent

    @property
    def sound(self) -> bool:
        """Whether nothing stands in the way."""
        return bool(self.fits.all()) and not self.mirrored and not self.scaled


def in_one_line(xyz: Array) -> bool:
    """Whether points (n, 3) lie in one line, or are one: no axes can be fitted by these."""
    size = np.linalg.svd(xyz - xyz.mean(axis=0), compute_uv=False)
    return len(xyz) < 3 or bool(size[1] <= IN_LINE * size[0])


def misfit(source: Array, target: Array, *, scale_sigma: float | None = 0.0, floor: float = 0.0) -> Misfit:
    """Look for what keeps points (n, 3) from fitting onto others of the same names (n, 3).

    scale_sigma  standard deviation with which the scales are known to be the same, as a share; None: scale is free
    floor        standard deviation of a coordinate below which no scatter is taken for small [unit of the target]
    raises       InputError for fewer than three points, or points in a line
    Limits: an error that most of the points share; that few points are wrong, where fewer than five are
    given (`instead` then has those that may be it).
    """
    n = len(source)
    mirrored = _is_mirrored(source, target)
    if mirrored:
        source = source * MIRROR
    free = scale_sigma is None
    loose = _agreeing(source, target, None, floor)
    kept, far = loose, False
    if not free:
        far, kept = _other_scale(source, target, loose, scale_sigma or 0.0, floor)
    scale = None if free or far else 1.0
    fits = loose if free or far else kept
    fit = similarity(source[fits], target[fits], scale=scale)
    distance = np.linalg.norm(fit.points(source) - target, axis=1)
    size = float(np.sqrt(np.sum((source[fits] - source[fits].mean(axis=0)) ** 2))) * fit.scale
    with_scale = similarity(source[fits], target[fits], scale=1.0)
    limit = float(np.sqrt(_spread(fit.residuals, scale, floor) * _critical(3 * int(fits.sum()) - 7, n)))
    return Misfit(
        mirrored=mirrored, scaled=far, factor=1.0 if scale is not None else fit.scale,
        factor_sigma=float(fit.sigma0 / max(size, 1e-300)) * fit.scale if int(fits.sum()) > 2 else 0.0, fits=fits,
        distance=distance, exchanged=_exchanged(fit.points(source), target, fits, limit),
        instead=_instead(source, target, fits, scale), rms=float(np.sqrt(np.mean(fit.residuals**2))),
        rms_kept=float(np.sqrt(np.mean(with_scale.residuals**2))),
        extent=float(np.sqrt(np.mean((target - target.mean(axis=0)) ** 2))), transform=fit,
    )  # fmt: skip


def _is_mirrored(source: Array, target: Array) -> bool:
    """Whether a reflection fits the larger half far better: F of the trimmed sums of squares, scales free."""
    n = len(source)
    if n < FEWEST:
        return False
    (_, straight), (_, turned) = (_trimmed(s, target, None) for s in (source, source * MIRROR))
    dof = 3 * _half(n) - 7
    size = float(np.sum((target - target.mean(axis=0)) ** 2))
    turned = max(turned, 1e-24 * size)
    return fisher_tail(straight / turned, dof, dof) < LEVEL


def _other_scale(source: Array, target: Array, fits: Mask, scale_sigma: float, floor: float) -> tuple[bool, Mask]:
    """Whether another scale than 1 fits far better, beyond what is known of it; and the points that fit with 1."""
    free, fixed = (similarity(source[fits], target[fits], scale=s) for s in (None, 1.0))
    dof = 3 * int(fits.sum()) - 7
    rest = float(np.sum(free.residuals**2))
    more = float(np.sum(fixed.residuals**2)) - rest
    spread = max(rest / max(dof, 1), floor**2, 1e-24 * float(np.sum((target - target.mean(axis=0)) ** 2)))
    beyond = abs(np.log(free.scale)) > _normal(LEVEL) * scale_sigma
    far = beyond and fisher_tail(more / spread, 1, dof) < LEVEL
    return far, fits if far else _agreeing(source, target, 1.0, floor)


def _normal(tail: float) -> float:
    from scipy.special import ndtri

    return float(ndtri(1 - tail / 2))


def _half(n: int) -> int:
    """Points of which the best fit is looked for: so many that nearly half may be wrong."""
    return (n + 4) // 2 if n > 4 else n


def _trimmed(source: Array, target: Array, scale: float | None) -> tuple[Mask, float]:
    """The larger half that fits best, and the sum of squares of its residuals."""
    n, h = len(source), _half(len(source))
    if h == n:
        starts = np.arange(n)[None]
    elif comb(n, 3) <= STARTS:
        starts = np.array(list(combinations(range(n), 3)))
    else:
        rng = np.random.default_rng(0)
        starts = np.array([rng.choice(n, 3, replace=False) for _ in range(STARTS)])
    best, least = np.arange(h), np.inf
    for part in np.array_split(starts, max(1, len(starts) * n // AT_ONCE)):
        halves, sums = _concentrated(source, target, part, h, scale)
        k = int(np.argmin(sums))
        if sums[k] < least:
            best, least = halves[k], float(sums[k])
    some = np.zeros(n, bool)
    some[best] = True
    return some, float(_squares(source, target, np.flatnonzero(some)[None], scale)[0, some].sum())


def _concentrated(source: Array, target: Array, starts: Index, h: int, scale: float | None) -> tuple[Index, Array]:
    """From each of some sets (m, k) of points the h points (m, h) to which concentration leads; their sums of squares.

    Of Rousseeuw and van Driessen 1999: the points that fit best make the next fit, which is never worse.
    """
    halves, sums = np.zeros((len(starts), h), int), np.full(len(starts), np.inf)
    going, at = np.arange(len(starts)), starts
    for _ in range(STEPS):
        square = _squares(source, target, at, scale)
        at = np.argsort(square, axis=1, kind="stable")[:, :h]
        total = np.take_along_axis(square, at, axis=1).sum(axis=1)
        halves[going] = at
        better = total < sums[going] * (1 - 1e-9)
        going, at, total = going[better], at[better], total[better]
        sums[going] = total
        if not len(going):
            break
    return halves, sums


def _squares(source: Array, target: Array, at: Index, scale: float | None) -> Array:
    """(m, n) squares of distances after the similarity of some points (m, k); as `similarity`, without statistics."""
    a, b = source[at], target[at]
    a0, b0 = a.mean(axis=1, keepdims=True), b.mean(axis=1, keepdims=True)
    a, b = a - a0, b - b0
    u, d, vt = np.linalg.svd(b.swapaxes(1, 2) @ a)
    sign = np.ones((len(at), 1, 3))
    sign[:, 0, 2] = np.sign(np.linalg.det(u @ vt))
    factor = scale
    if factor is None:
        factor = ((d * sign[:, 0]).sum(axis=1) / np.maximum((a * a).sum(axis=(1, 2)), 1e-300))[:, None, None]
    e = factor * (source - a0) @ ((u * sign) @ vt).swapaxes(1, 2) - (target - b0)
    return np.einsum("mni,mni->mn", e, e)


def _agreeing(source: Array, target: Array, scale: float | None, floor: float) -> Mask:
    """(n,) points that agree: from the half that fits best on, tested one by one against the others."""
    n = len(source)
    if n < 4:
        return np.ones(n, bool)
    some, rest = _trimmed(source, target, scale)
    fits = some.copy()
    if not some.all():
        fit = similarity(source[some], target[some], scale=scale)
        spread = max(rest / (3 * int(some.sum()) - 7) * _of_trimming(int(some.sum()) / n), floor**2)
        square = np.sum((fit.points(source) - target) ** 2, axis=1)
        fits = some | (square <= spread * _critical(np.inf, n))
    seen = set[bytes]()
    for _ in range(ROUNDS):
        if fits.tobytes() in seen:
            break
        seen.add(fits.tobytes())
        p = _tests(source, target, fits, scale, floor)
        back = np.where(fits, -1.0, p)
        if back.max() >= LEVEL / n:
            fits = fits | (back >= LEVEL / n)
            continue
        out = np.where(fits, p, np.inf)
        if out.min() < LEVEL / n and fits.sum() > 3:
            fits = fits.copy()
            fits[int(out.argmin())] = False
    return fits


def _tests(source: Array, target: Array, fits: Mask, scale: float | None, floor: float) -> Array:
    """(n,) probability of each point against the others that agree, without it."""
    p = np.zeros(len(source))
    m = int(fits.sum())
    fit = similarity(source[fits], target[fits], scale=scale)
    e = fit.points(source) - target
    A = _directions(fit.points(source), fits, scale)
    N = np.linalg.pinv(np.einsum("nij,nik->jk", A[fits], A[fits]))
    H = np.einsum("nij,jk,nlk->nil", A, N, A)
    rest, u = float(np.sum(e[fits] ** 2)), A.shape[2]
    small = 1e-24 * float(np.sum((target - target.mean(axis=0)) ** 2))
    for i in range(len(source)):
        inner = bool(fits[i])
        M = np.eye(3) - H[i] if inner else np.eye(3) + H[i]
        own = float(e[i] @ np.linalg.pinv(M, rcond=1e-9, hermitian=True) @ e[i])
        dof = 3 * (m - inner) - u
        if dof <= 0:
            p[i] = 1.0
            continue
        spread = max((rest - own * inner) / dof, floor**2, small)
        p[i] = fisher_tail(own / 3 / spread, 3, dof)
    return p


def _directions(xyz: Array, about: Mask, scale: float | None) -> Array:
    from raybundle.metrology.point_set import datum_directions

    return datum_directions(xyz, scale=scale is None, about=about)


def _of_trimming(share: float) -> float:
    """By how much the mean square of the smallest share of residuals of three coordinates is too small."""
    from scipy.special import chdtr, chdtri

    return share / float(chdtr(5, chdtri(3, 1 - share)))


def _critical(dof: float, n: int) -> float:
    """Square of a distance, in variances of a coordinate, that none of n right points exceeds."""
    from scipy.special import chdtri, fdtri

    tail = LEVEL / n
    return float(chdtri(3, tail) if np.isinf(dof) or dof <= 0 else 3 * fdtri(3, dof, 1 - tail))


def _spread(residuals: Array, scale: float | None, floor: float) -> float:
    dof = residuals.size - 6 - (scale is None)
    return max(float(np.sum(residuals**2)) / max(dof, 1), floor**2)


def _exchanged(here: Array, target: Array, fits: Mask, limit: float) -> tuple[tuple[int, int], ...]:
    at = np.flatnonzero(~fits).tolist()
    near = {(i, j) for i in at for j in at if i != j and float(np.linalg.norm(here[i] - target[j])) <= limit}
    return tuple((i, j) for i, j in sorted(near) if i < j and (j, i) in near)


def _instead(source: Array, target: Array, fits: Mask, scale: float | None) -> tuple[int, ...]:
    """Where one point is wrong: others without which the rest fits as well, by F of both misfits."""
    n = len(fits)
    if int((~fits).sum()) != 1:
        return ()
    dof = 3 * (n - 1) - 6 - (scale is None)
    sums = np.full(n, np.inf)
    for i in range(n):
        others = np.arange(n) != i
        if not in_one_line(source[others]):
            sums[i] = float(np.sum(similarity(source[others], target[others], scale=scale).residuals ** 2))
    best = int(np.flatnonzero(~fits)[0])
    floor = max(float(sums[best]), 1e-24 * float(np.sum((target - target.mean(axis=0)) ** 2)))
    return tuple(i for i in range(n) if i != best and fisher_tail(float(sums[i]) / floor, dof, dof) > AS_WELL)
