"""Dots that are partly covered: by a hand, a cable, another thing, a highlight, the border of the photograph.

What lies on a dot is judged by the residuals of its grey values against their noise, and leaves the fit together with
as much around it as its own edge is blurred over; ellipse, blur and contrast are fitted to what is free, and judged
again until nothing changes.  The covariance of the centre comes from the free pixels alone, and so grows as the arc
shrinks.

An ellipse that was fitted to a covered dot as a whole is wrong all around, and its residuals do not show where.  So the
judgement starts from an ellipse through the largest part of the edge that lies on one (see `arcs`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.targets.arcs import NEAR, Arc, free_arcs
from raybundle.targets.centre import (
    CONTRAST,
    GROUND,
    GX,
    SECTORS,
    UNKNOWNS,
    WIDTHS,
    X0,
    Y0,
    A,
    Box,
    D,
    DotOptions,
    DotOutcome,
    Dots,
    MaskedDots,
    S,
    difference_noise,
    fit_dots,
    fit_masked,
    radius_of,
    sector_of,
    triangle_from_ellipse,
)
from raybundle.targets.judgement import FALSE, NORMAL_DEVIATE, covered_of
from raybundle.targets.rings import outline_share

ROUGH = 1.35
"""rms residual over the noise from which a dot is looked at again: that of 100 white grey values is known to 0.1."""
ROUNDS = 12
"""Most judgements."""
STILL = 0.05
"""Change of the centre, in its standard deviations, below which what is covered is settled."""
CURVED = 1.44
"""Largest ratio of the growth of the sum of squares at two standard deviations to what the linear model states.

The stated standard deviation is that of the linear model, and true to a fifth as long as the sum of squares grows by
4 (1.2)^(+-2) variances two standard deviations off along the worst direction.  As the arc shrinks, that fails first:
the ellipses through a short arc lie on a bent line (Bates, Watts 1980: curvature of the parameters).
"""
NEARBY_PX = 3.5
"""Ground beyond the edge that the first fit rests on: farther out it may be covered where the edge is not [px]."""
LEAST_EDGE = 0.5
"""Least share of the edge that is free: of what is judged by the majority, the majority must be right (Rousseeuw 1984).
"""
EVEN_PX = 0.12
"""Distance up to which the outline of a dot is taken to lie on an ellipse: four times what noise of a hundredth of the
contrast makes of an edge blurred by a pixel."""
NO_OUTLINE = 0.65
"""Share of the outline that lies on its ellipse below which a spot that is suspect is refused.

Learned (`benchmarks/target_centres.py constants`; 225 covered dots taken for spots, eight photographs without targets,
two of a panel): at 0.4 the squared errors are twice as many variances as at 0.65 (4.5 against 2.3) and 35 more spots
of the photographs stay; 0.8 and 0.95 lose a third and two thirds of the dots, and are no truer.
"""
ELLIPTIC = 0.9
"""Share of the rays from which on an outline is an ellipse: what the eye takes for a dot is not refused.

Of 24 rays two may be off.  Noise takes one off with a probability of 6e-5 (four standard deviations, see EVEN_PX); a
thing that hides a twentieth of the outline takes one ray and, by its blurred ends, one to each side."""
SAME = -2 * math.log(FALSE)
"""Largest squared distance of the centre by what is free from that of the whole, by the covariance of the former.

Where nothing lies on a dot, one estimate rests on a part of the pixels of the other, and the covariance of their
difference is that of the part less that of the whole (Hausman 1978), so that the square exceeds this limit, the
quantile of chi-square with two degrees of freedom, in less than FALSE of all dots.  Covariances are by the noise that
differences of neighbouring residuals show: the residuals of a wrong fit would excuse themselves."""
LOST = 3.0
"""rms residual over the noise from which a dot is refused of which no arc lies on an ellipse.

Learned (as NO_OUTLINE): anything from 1.5 to 4.5 gives the same; from 6 on, wrong centres are kept.
"""


@dataclass(frozen=True, slots=True)
class _Judged:
    """A dot under judgement."""

    box: Box
    values: Array
    covered: Mask
    window: float
    fits: int = 0
    strict: bool = False
    """what stands out is judged by the noise alone"""

    @property
    def within(self) -> Mask:
        """(h, w) pixels near enough to the dot."""
        return radius_of(self.values, *self.box) <= self.window

    @property
    def free(self) -> Mask:
        """(h, w) pixels that take part."""
        return self.within & ~self.covered


def measure_dots(
    image: Array, xy_px: Array, ellipse: Array, window: Array, options: DotOptions | None = None,
    surely: Mask | None = None,
) -> Dots:  # fmt: skip
    """Fit dots that may be partly covered; arguments as those of `centre.fit_dots`.

    surely  (n,) whether these are dots, and not spots of which some may be: None, all are

    A dot on which something lies is measured by what is free of it, or refused as COVERED.  What the covariance does
    not show: a thing of the colour that the dot or its ground has there is not seen, and does no harm; a bent edge
    along the dot's own that hides less than its grey values would show at one false alarm in a hundred dots remains.
    """
    o = options or DotOptions()
    image = np.ascontiguousarray(image, np.uint16)
    window = np.broadcast_to(np.asarray(window, float), len(xy_px))
    dots = fit_dots(image, xy_px, ellipse, window, o)
    known, suspect = doubts_on(dots)
    # what only seems rough may be so: most prints and lenses are no ideal ones
    share, asked = np.zeros(len(window)), np.flatnonzero(dots.measured & (known | suspect))
    share[asked] = _elliptic_share(image, dots, window, asked)
    elliptic = share > ELLIPTIC
    if surely is not None:
        dots.outcome[~surely & dots.measured & (known | suspect) & (share < NO_OUTLINE)] = DotOutcome.COVERED
        spot = ~surely & ~dots.measured
        known, suspect = known & ~spot, suspect & ~spot
    rows = np.flatnonzero(known | (suspect & ~elliptic))
    if not len(rows):
        return dots
    free = _measure_free(
        image, np.reshape(xy_px, (-1, 2))[rows], np.reshape(ellipse, (-1, 2, 2))[rows], window[rows], o
    )
    # a dot on which nothing was found stays as it was fitted
    free.outcome[(free.outcome < 0) & dots.measured[rows] & (dots.doubts[rows, 2] > LOST)] = DotOutcome.COVERED
    refused = free.outcome == DotOutcome.COVERED
    kept = elliptic[rows] | (~known[rows] & _is_the_same(dots, rows, free))  # of an edge that has moved nothing is kept
    if surely is not None:  # rough all around, no part of the edge elsewhere than the rest: print, lens, compression
        kept |= ~surely[rows] & dots.measured[rows] & ~known[rows]
    free.outcome[refused & kept] = -1
    taken = free.outcome >= 0
    for whole, part in (
        (dots.values, free.values), (dots.cov_px2, free.cov_px2), (dots.residual, free.residual),
        (dots.outcome, free.outcome),
    ):  # fmt: skip
        whole[rows[taken]] = part[taken]
    dots.covered[rows[taken]] = True
    return dots


def doubts_on(dots: Dots) -> tuple[Mask, Mask]:
    """Dots (n,) that are to be judged in any case; and those (n,) if their outline is no ellipse.

    A part of the edge that has moved, and what stands out far, is something on the dot; squares and roughness may be
    the print's, the lens's or the noise's own.
    """
    limit = NORMAL_DEVIATE.inv_cdf(1 - FALSE / ((2 * len(WIDTHS) + 1) * SECTORS))  # two sides of shifts, one of squares
    shift, square, rough = dots.doubts.T
    known = (shift > limit) | (square > 2 * limit)
    lost = ~dots.measured & (dots.outcome != DotOutcome.FLAT)
    return (dots.measured & known) | lost, dots.measured & ((square > limit) | (rough > ROUGH))


def _is_the_same(dots: Dots, rows: Index, free: Dots) -> Mask:
    """(k,) whether what was left out changed nothing: roughness of print and ground, then, not a thing on the dot."""
    apart = dots.xy_px[rows] - free.xy_px
    known = np.linalg.det(free.cov_px2) > 0
    inverse = np.linalg.inv(np.where(known[:, None, None], free.cov_px2, np.eye(2)))
    like = dots.measured[rows] & (dots.doubts[rows, 2] < LOST)
    return like & known & (np.einsum("ni,nij,nj->n", apart, inverse, apart) < SAME)


def _elliptic_share(image: Array, dots: Dots, window: Array, rows: Index) -> Array:
    """(k,) how much of the outlines of these dots lies on their ellipses."""
    C = dots.ellipse[rows]
    near = np.maximum(EVEN_PX, NEAR * np.sqrt(np.sqrt(np.linalg.det(C))))
    v = dots.values[rows]
    return outline_share(image, dots.xy_px[rows], C, window[rows], v[:, CONTRAST], v[:, GX:], v[:, S], near, EVEN_PX)


def _measure_free(image: Array, xy: Array, ellipse: Array, window: Array, o: DotOptions) -> Dots:
    """Dots by what is free of them; outcome -1 where nothing was found to lie on one."""
    n = len(xy)
    dots = Dots(
        values=np.zeros((n, UNKNOWNS)), cov_px2=np.zeros((n, 2, 2)), residual=np.zeros(n), doubts=np.zeros((n, 3)),
        outcome=np.full(n, -1, np.int32), covered=np.zeros(n, bool),
    )  # fmt: skip
    arcs = free_arcs(image, xy, ellipse)
    judged = {
        i: j for i, arc in enumerate(arcs) if arc is not None and (j := _start(image, arc, window[i])) is not None
    }  # fmt: skip
    for _ in range(2 * ROUNDS):
        if not judged:
            break
        fitted = _fit(image, judged, o)
        following: dict[int, _Judged] = {}
        covered = _covered(judged, fitted)
        for k, (i, j) in enumerate(judged.items()):
            new = _judge(j, fitted, k, covered[k])
            if new is None:
                dots.values[i], dots.cov_px2[i] = fitted.values[k], _by_noise(fitted, j.free, k)
                dots.outcome[i] = -1 if j.strict else DotOutcome.COVERED
            elif not _settled(j, new, fitted, k):
                following[i] = new
            elif (again := _end(image, dots, i, j, fitted, k, o)) is not None:
                following[i] = again
        judged = following
    return dots


def _fit(image: Array, judged: dict[int, _Judged], o: DotOptions) -> MaskedDots:
    of = judged.values()
    return fit_masked(image, np.array([j.values for j in of]), [j.box for j in of], [j.free for j in of], o)


def _start(image: Array, arc: Arc, window: float) -> _Judged | None:
    """A dot with the arc of its edge that lies on an ellipse; None where the image has nothing of it."""
    v = np.zeros(UNKNOWNS)
    v[:2], v[A : D + 1], v[S] = arc.xy_px, triangle_from_ellipse(arc.ellipse[None])[0], 0.8
    reach = 1.1 * window * np.sqrt(np.diag(arc.ellipse)) + 3
    low = np.maximum(np.floor(arc.xy_px - reach), 0).astype(int)
    high = np.minimum(np.ceil(arc.xy_px + reach).astype(int), [image.shape[1], image.shape[0]])
    if not (high - low > 4).all():
        return None
    box = slice(int(low[1]), int(high[1])), slice(int(low[0]), int(high[0]))
    y, x = np.mgrid[box] + 0.5
    # to begin with: less one more sector at the ends, and what is near
    sure = arc.free & np.roll(arc.free, 1) & np.roll(arc.free, -1)
    covered = ~sure[sector_of(v, x, y)]
    radius, grey = radius_of(v, *box), image[box]
    covered |= radius > 1 + NEARBY_PX / min(v[A], v[D])
    inner, outer = grey[(radius < 0.6) & ~covered], grey[(radius > 1.15) & ~covered]
    if not (len(inner) and len(outer)):
        return None
    v[GROUND] = np.median(outer)
    v[CONTRAST] = np.median(inner) - v[GROUND]
    return _Judged(box, v, covered, window) if abs(v[CONTRAST]) > 1 else None


def _covered(judged: dict[int, _Judged], fitted: MaskedDots) -> list[Mask]:
    """What seems to be covered of each dot that could be fitted; all of the others."""
    of, rows = list(judged.values()), np.flatnonzero(fitted.outcome == DotOutcome.MEASURED).tolist()
    found = covered_of(
        fitted.values[rows], fitted.cov[rows], [of[k].box for k in rows], [of[k].free for k in rows],
        [fitted.residuals[k] for k in rows], [fitted.derivatives[k] for k in rows],
        np.array([of[k].strict for k in rows], bool),
    )  # fmt: skip
    by_row = dict(zip(rows, found, strict=True))
    return [by_row.get(k, j.covered) for k, j in enumerate(of)]


def _judge(j: _Judged, fitted: MaskedDots, k: int, covered: Mask) -> _Judged | None:
    """The dot as fitted, and what then seems to be covered; None where it cannot be fitted, or does not settle."""
    if fitted.outcome[k] != DotOutcome.MEASURED or j.fits > ROUNDS:
        return None
    v = fitted.values[k]
    if j.fits >= ROUNDS // 2:  # what comes and goes is left out
        covered = covered | j.covered
    return replace(j, values=v, covered=covered, fits=j.fits + 1)


def _settled(old: _Judged, new: _Judged, fitted: MaskedDots, k: int) -> bool:
    """Whether another fit would change nothing that matters."""
    within = new.within
    if np.array_equal(old.covered & within, new.covered & within):
        return True
    shift = new.values[:2] - old.values[:2]
    return old.fits > 1 and float(shift @ np.linalg.solve(fitted.cov[k][:2, :2], shift)) < STILL**2


def _end(image: Array, dots: Dots, i: int, j: _Judged, fitted: MaskedDots, k: int, o: DotOptions) -> _Judged | None:
    """The outcome of a dot whose free pixels are settled; or the dot again, to be judged more strictly.

    The residuals of small dots that are wrong all around rise above their noise, but nowhere above each other.
    """
    j = replace(j, values=fitted.values[k])
    edge = free_edge(j)
    rough = fitted.residual[k] / difference_noise(fitted.residuals[k], j.free)
    if edge.all() and not (j.covered & j.within).any():
        dots.values[i] = j.values
        return replace(j, strict=True, fits=1) if rough > ROUGH and not j.strict else None
    good = edge.mean() > LEAST_EDGE and rough < ROUGH and _is_straight(image, j, fitted, k, o)
    if good or not j.strict:
        dots.values[i], dots.residual[i] = j.values, fitted.residual[k]
        dots.cov_px2[i] = fitted.cov[k][:2, :2] if good else _by_noise(fitted, j.free, k)
        dots.outcome[i] = DotOutcome.MEASURED if good else DotOutcome.COVERED
    return None


def _by_noise(fitted: MaskedDots, free: Mask, k: int) -> Array:
    """Covariance (2, 2) of the centre of a dot by the noise of its grey values, not by its residuals; 0: no fit."""
    if fitted.outcome[k] != DotOutcome.MEASURED:
        return np.zeros((2, 2))
    rough = fitted.residual[k] / difference_noise(fitted.residuals[k], free)
    return fitted.cov[k][:2, :2] / max(rough, 1.0) ** 2


def _edge_pixels(j: _Judged) -> tuple[Array, Array, Mask]:
    """Rows and columns (128,) in the box of points evenly round the edge, in the frame of the dot; which are in it."""
    v, (rows, columns) = j.values, j.box
    t = (np.arange(128) + 0.5) * 2 * np.pi / 128
    x, y = v[X0] + v[A] * np.cos(t), v[Y0] + v[A + 1] * np.cos(t) + v[D] * np.sin(t)
    x, y = np.floor(x).astype(int) - columns.start, np.floor(y).astype(int) - rows.start
    h, w = j.covered.shape
    return np.clip(y, 0, h - 1), np.clip(x, 0, w - 1), (x >= 0) & (y >= 0) & (x < w) & (y < h)


def free_edge(j: _Judged) -> Mask:
    """Points (128,) evenly round the edge whose pixel takes part."""
    y, x, inside = _edge_pixels(j)
    return inside & ~j.covered[y, x]


def _is_straight(image: Array, j: _Judged, fitted: MaskedDots, k: int, o: DotOptions) -> bool:
    """Whether the sum of squares grows as the linear model states, along the worst direction of the centre."""
    cov, variance = fitted.cov[k][:2], fitted.residual[k] ** 2
    size, axes = np.linalg.eigh(cov[:, :2])
    step = 2 * axes[:, 1] @ cov / np.sqrt(size[1])
    at = j.values + np.array([[0.0], [1.0], [-1.0]]) * step
    if not (np.minimum(at[:, A], at[:, D]) > 0.5).all():
        return False
    seen = fit_masked(image, at, [j.box] * 3, [j.free] * 3, replace(o, iterations=0))
    total = np.array([(e[j.free] ** 2).sum() for e in seen.residuals]) / variance
    total += (at[:, GX:] ** 2).sum(axis=1) / o.slope**2
    growth = (total[1:] - total[0]) / 4
    return bool((growth > 1 / CURVED).all() and (growth < CURVED).all())
