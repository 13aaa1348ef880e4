"""Digital image correlation: subsets of a reference image followed through images of the deformed specimen.

The windows of `least_squares` without weights, on coefficients of cubic B-splines, their shapes free.  Subsets stand on
a grid.  The best matched pass their shape on to their neighbours (Pan 2009), so that the start is good where
displacements are large.  At the reference, windows are read at pixels: noise then does not displace them (Shao, Dai and
He 2015).
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from enum import IntEnum

import numpy as np

from raybundle.matching.least_squares import Outcome, WindowMatches, WindowOptions, match_windows
from raybundle.matching.spline_pictures import Picture
from raybundle.matching.subset_noise import NOISE_F, WEAK_PX, displacement_covariance, part_displacements, weak_texture
from raybundle.numerics.arrays import Array, Index, Mask

CORRELATION = 0.75
"""Least correlation of two windows that are believed to show the same."""
SEED_CORRELATION = 0.85
"""The same where no neighbour supports a match."""
REACH_PX = 3.0
"""Distance from the place that a neighbour predicts, beyond which a match is another one."""
TRIED = 64
"""Subsets that are tried without displacement before features are looked for."""
PARENTS = 4
"""Neighbours from which a subset is tried."""
TORN_PX, TORN_F = 0.25, 4.0
"""Displacement of the ninths of a window against its shape, and its test quantity, above both of which it is torn.
Smooth fields reach 0.1 px."""
LOST_SHARE = 0.02
"""Of the subsets, that were followed before and no longer are, from which on features are looked for."""
CHANGED = 3.0
"""Standard deviation of residuals in units of the median of all, from which on grey values are others."""
EDGE_PX = 3.0
"""Distance from the edge of an image that interpolation and the iterations need."""


class State(IntEnum):
    """What became of a subset."""

    FOLLOWED = 0
    OUTSIDE = 1
    FLAT = 2
    UNSTEADY = 3
    UNLIKE = 4
    TORN = 5
    CHANGED = 6
    UNREACHED = 7


OF_OUTCOME = {
    Outcome.OUTSIDE: State.OUTSIDE, Outcome.FLAT: State.FLAT, Outcome.MOVED: State.UNSTEADY,
    Outcome.UNSTEADY: State.UNSTEADY,
}  # fmt: skip

JUMP_PX = 1.0
"""Distance of a subset from where its neighbour predicts it: bent specimens show hundredths of a pixel"""
LARGEST_PX, LEAST_PERIOD_PX = 1024, 4.0
"""Side of the part of the reference in which repetition is looked for, and the shortest period"""


@dataclass(frozen=True, slots=True, kw_only=True)
class SubsetGrid:
    """Where subsets stand in the reference image: in the middle of pixels."""

    xy_px: Array
    """(n, 2)"""
    cell: Index
    """(n, 2) row and column of the grid"""
    shape: tuple[int, int]
    """rows and columns of the grid"""
    step: int

    @classmethod
    def of(cls, free: Mask, step: int, half: int) -> SubsetGrid:
        """Subsets of (2 half + 1)^2 pixels, all of them free (h, w) and inside the image."""
        h, w = free.shape
        total = np.zeros((h + 1, w + 1), np.int64)
        total[1:, 1:] = free.cumsum(axis=0, dtype=np.int64).cumsum(axis=1)
        side, edge = 2 * half + 1, half + int(EDGE_PX)
        rows, columns = np.flatnonzero(free.any(axis=1)), np.flatnonzero(free.any(axis=0))
        if not len(rows):
            rows = columns = np.zeros(1, int)
        y = np.arange(max(int(rows[0]) + half, edge), min(int(rows[-1]) + 1 - half, h - edge), step)
        x = np.arange(max(int(columns[0]) + half, edge), min(int(columns[-1]) + 1 - half, w - edge), step)
        top, left = (a.ravel() - half for a in np.meshgrid(y, x, indexing="ij"))
        whole = total[top + side, left + side] - total[top, left + side] - total[top + side, left] + total[top, left]
        cell = np.stack(np.unravel_index(np.flatnonzero(whole == side**2), (len(y), len(x))), axis=1)
        xy = np.stack([x[cell[:, 1]], y[cell[:, 0]]], axis=1) + 0.5 if len(cell) else np.zeros((0, 2))
        return cls(xy_px=xy, cell=cell, shape=(len(y), len(x)), step=step)

    def neighbours(self) -> Index:
        """(n, 8) rows of the neighbours of each subset; -1 where there is none."""
        number = np.full((self.shape[0] + 2, self.shape[1] + 2), -1)
        number[self.cell[:, 0] + 1, self.cell[:, 1] + 1] = np.arange(len(self.cell))
        around = [(i, j) for i in (0, 1, 2) for j in (0, 1, 2) if (i, j) != (1, 1)]
        return np.stack([number[self.cell[:, 0] + i, self.cell[:, 1] + j] for i, j in around], axis=1)

    def raster(self, values: Array) -> Array:
        """Values (n, ...) as (rows, columns, ...); NaN elsewhere."""
        found = np.full((*self.shape, *values.shape[1:]), np.nan)
        found[self.cell[:, 0], self.cell[:, 1]] = values
        return found


@dataclass(frozen=True, slots=True, kw_only=True)
class Followed:
    """Subsets in one image of the deformed specimen."""

    state: Index
    """(n,) `State`; the rest is NaN where not FOLLOWED"""
    xy_px: Array
    """(n, 2) of the middle of the subset"""
    affine: Array
    """(n, 2, 2) deformed_from_reference of small vectors, by the subset alone"""
    cov_px2: Array
    """(n, 2, 2) of the displacement, from the noise of both images"""
    correlation: Array
    """(n,)"""
    noise: Array
    """(n, 2) standard deviation of a grey value of the reference, and of the target brought to its contrast"""
    parts_px: Array
    """(n,) displacement of the ninths of the window against its shape; 0 where noise explains it"""


def window_options(half: int, *, quadratic: bool) -> WindowOptions:
    """Of subsets of (2 half + 1)^2 pixels; lengths in the target, two to a pixel."""
    return WindowOptions(
        half=half, sigma=1e6, iterations=40, step=2e-4, reach=2 * REACH_PX, loose=1e3, spline=True, quadratic=quadratic
    )


def follow(
    reference: Picture, target: Picture, grid: SubsetGrid, window: WindowOptions, start: Followed | None = None
) -> Followed:
    """Find the subsets of a reference image in another one.

    reference, target  of zoom 1 and 2: what is read between pixels is interpolated from finer ones
    start              of an image taken shortly before, where displacements are similar

    What the covariance does not show: shapes that a window cannot take (`parts_px`), interpolation of aliased images,
    noise that neighbouring pixels share, lens distortion, motion towards the camera.
    """
    g = _Growth(reference=reference, target=target, grid=grid, window=window)
    if start is not None:
        rows = np.flatnonzero(start.state == State.FOLLOWED)
        g.try_at(rows, start.xy_px[rows], start.affine[rows], CORRELATION)
    else:
        rows = np.unique(np.linspace(0, len(grid.xy_px) - 1, TRIED).astype(int))
        g.try_at(rows, grid.xy_px[rows], np.tile(np.eye(2), (len(rows), 1, 1)), SEED_CORRELATION)
    g.grow()
    missing = g.state != State.FOLLOWED
    if start is not None:
        missing &= start.state == State.FOLLOWED
    if missing.mean() > (0 if start is None else LOST_SHARE):
        g.try_features()
        g.grow()
    return g.result()


def jumps(grid: SubsetGrid, f: Followed) -> tuple[int, int]:
    """Pairs of neighbours of which one lies elsewhere than the shape of the other predicts, and all pairs.

    Subsets across a crack are torn: what is followed on both sides are no neighbours.
    """
    around = grid.neighbours()
    i, k = np.nonzero(around >= 0)
    j = around[i, k]
    both = (i < j) & (f.state[i] == State.FOLLOWED) & (f.state[j] == State.FOLLOWED)
    i, j = i[both], j[both]
    apart = (grid.xy_px[j] - grid.xy_px[i])[:, :, None]
    predicted = ((f.affine[i] + f.affine[j]) / 2 @ apart)[:, :, 0]
    return int((np.linalg.norm(f.xy_px[j] - f.xy_px[i] - predicted, axis=1) > JUMP_PX).sum()), len(i)


def repetition(grey: Array) -> tuple[float, float]:
    """Correlation of the middle of an image with itself at another place, and the distance of that place [px].

    0 where no other place is more like it than what surrounds it.
    """
    from scipy.ndimage import maximum_filter

    h, w = (min(n, LARGEST_PX) for n in grey.shape)
    top, left = (grey.shape[0] - h) // 2, (grey.shape[1] - w) // 2
    part = np.asarray(grey[top : top + h, left : left + w], float)
    part = part - part.mean()
    power = np.abs(np.fft.rfft2(part, (2 * h, 2 * w))) ** 2
    C = np.fft.fftshift(np.fft.irfft2(power, (2 * h, 2 * w)))
    dy, dx = np.arange(-h, h)[:, None], np.arange(-w, w)
    overlap = np.maximum((h - np.abs(dy)) * (w - np.abs(dx)), 1) / (h * w)
    C = C / max(float(C[h, w]), 1e-300) / overlap
    distance = np.hypot(dy, dx)
    C[(distance > min(h, w) / 2) | (dy < 0)] = -1.0
    peak = (maximum_filter(C, 5) == C) & (distance > LEAST_PERIOD_PX)
    if not peak.any():
        return 0.0, 0.0
    alike = peak & (0.9 * C[peak].max() < C)  # of the multiples of a period the first
    best = np.unravel_index(np.where(alike, distance, np.inf).argmin(), C.shape)
    return max(float(C[best]), 0.0), float(distance[best])


@dataclass(slots=True, kw_only=True)
class _Growth:
    """The subsets that were found, from the best to their neighbours."""

    reference: Picture
    target: Picture
    grid: SubsetGrid
    window: WindowOptions
    state: Index = field(init=False)
    found: WindowMatches = field(init=False)

    def __post_init__(self) -> None:
        n = len(self.grid.xy_px)
        self.state = np.full(n, State.UNREACHED)
        self.found = WindowMatches(
            xy_px=np.zeros((n, 2)), affine=np.zeros((n, 2, 2)), bend=np.zeros((n, 2, 3)), cov_px2=np.zeros((n, 3)),
            correlation=np.zeros(n), residual=np.zeros((n, 14)), outcome=np.zeros(n, np.int32),
        )  # fmt: skip

    def try_at(self, rows: Index, xy: Array, affine: Array, least: float, window: WindowOptions | None = None) -> None:
        """Match subsets from places and shapes."""
        if not len(rows):
            return
        m = match_windows(
            self.reference.coefficients, self.target.coefficients, self.grid.xy_px[rows], 2 * xy - 0.5, 2 * affine,
            window or self.window,
        )  # fmt: skip
        m = replace(
            m, xy_px=(m.xy_px + 0.5) / 2, affine=m.affine / 2, bend=m.bend / 2, cov_px2=m.cov_px2 / 4,
            residual=m.residual * np.repeat([1, 4, 1], [2, 6, 6]),
        )  # fmt: skip
        of_outcome: Index = np.array([OF_OUTCOME.get(k, State.FOLLOWED) for k in Outcome])
        state = of_outcome[m.outcome]
        good = state == State.FOLLOWED
        parts, F = part_displacements(m, self.window)
        state[good & (parts > TORN_PX) & (F > TORN_F)] = State.TORN
        state[good & (m.correlation < least)] = State.UNLIKE
        better = (state == State.FOLLOWED) | (self.state[rows] == State.UNREACHED)
        at = rows[better]
        self.state[at] = state[better]
        for name in ("xy_px", "affine", "bend", "cov_px2", "correlation", "residual"):
            getattr(self.found, name)[at] = getattr(m, name)[better]

    def grow(self) -> None:
        """From neighbour to neighbour, those beside the best first, until none is left to be tried."""
        around = self.grid.neighbours()
        untried = around >= 0
        tries = np.zeros(len(around), int)
        while True:
            rows = np.flatnonzero((self.state != State.FOLLOWED) & (tries < PARENTS))
            there = untried[rows] & (self.state[around[rows]] == State.FOLLOWED)
            quality = np.where(there, self.found.correlation[around[rows]], -1.0)
            best = quality.argmax(axis=1)
            rows, best, quality = (a[quality.max(axis=1) > 0] for a in (rows, best, quality.max(axis=1)))
            if not len(rows):
                return
            first = quality >= np.median(quality)
            rows, best = rows[first], best[first]
            parent = around[rows, best]
            untried[rows, best] = False
            tries[rows] += 1
            B = self.found.affine[parent]
            d = self.grid.xy_px[rows] - self.grid.xy_px[parent]
            self.try_at(rows, self.found.xy_px[parent] + np.einsum("nij,nj->ni", B, d), B, CORRELATION)

    def try_features(self) -> None:
        """Subsets that are not found yet, from the nearest feature that both images have."""
        from scipy.spatial import KDTree

        from raybundle.matching.features import Described
        from raybundle.matching.rootsift import RootSift

        a, b = self.reference.features, self.target.features
        sides = [
            Described(xy_px=f.xy_px, descriptors=f.descriptors, size_px=(1, 1), scale_px=f.scale_px) for f in (a, b)
        ]
        pairs = RootSift().match(*sides)
        if not len(pairs):
            return
        p, q = a.rows(pairs[:, 0]), b.rows(pairs[:, 1])
        size, turn = q.scale_px / p.scale_px, q.angle - p.angle
        c, s = size * np.cos(turn), size * np.sin(turn)
        B = np.stack([np.stack([c, -s], axis=1), np.stack([s, c], axis=1)], axis=1)
        rows = np.flatnonzero(self.state != State.FOLLOWED)
        near, index = (np.asarray(v) for v in KDTree(p.xy_px).query(self.grid.xy_px[rows], k=1))
        rows, index = (v[near < 2 * self.window.half] for v in (rows, index))
        d = self.grid.xy_px[rows] - p.xy_px[index]
        xy = q.xy_px[index] + np.einsum("nij,nj->ni", B[index], d)
        self.try_at(rows, xy, B[index], SEED_CORRELATION, replace(self.window, reach=4 * REACH_PX))

    def _leave(self) -> None:
        """Mark those that lie outside the image where the nearest subset that was followed predicts them."""
        from scipy.spatial import KDTree

        good = np.flatnonzero(self.state == State.FOLLOWED)
        rows = np.flatnonzero(np.isin(self.state, (State.UNREACHED, State.UNSTEADY)))
        if len(good) and len(rows):
            near = good[KDTree(self.grid.xy_px[good]).query(self.grid.xy_px[rows])[1]]
            u, B = self.grid.xy_px[rows] - self.grid.xy_px[near], self.found.affine[near]
            reach = self.window.half * np.abs(B).sum(axis=2) + EDGE_PX
            xy = self.found.xy_px[near] + np.einsum("nij,nj->ni", B, u)
            size = np.array(self.target.grey.shape[::-1])
            self.state[rows[((xy < reach) | (xy > size - reach)).any(axis=1)]] = State.OUTSIDE

    def result(self) -> Followed:
        """With covariances from noise."""
        m, state = self.found, self.state
        rows = np.flatnonzero(state == State.FOLLOWED)
        nan = np.full(len(state), np.nan)
        if len(rows):
            sigma = np.sqrt(m.residual[rows, 0])
            state[rows[sigma > CHANGED * np.median(sigma)]] = State.CHANGED
            rows = np.flatnonzero(state == State.FOLLOWED)
        cov, noise, parts = np.full((len(state), 2, 2), np.nan), np.full((len(state), 2), np.nan), nan
        if len(rows):
            at = self.grid.xy_px[rows]
            cov[rows], noise[rows] = displacement_covariance(self.reference, self.target, at, m, rows, self.window)
        weak = np.trace(cov[rows], axis1=1, axis2=2) > WEAK_PX**2
        state[rows[weak]], cov[rows[weak]] = State.FLAT, np.nan
        rows = rows[~weak]
        if len(rows):
            weak = weak_texture(self.reference, self.grid.xy_px, self.window.half, np.median(noise[rows], axis=0))
            state[weak & (state != State.FOLLOWED) & (state != State.OUTSIDE)] = State.FLAT
            self._leave()
        noise[state != State.FOLLOWED] = np.nan
        size, F = (v[rows] for v in part_displacements(m, self.window))
        parts[rows] = np.where(F > NOISE_F, size, 0.0)
        known = state == State.FOLLOWED
        return Followed(
            state=state, xy_px=np.where(known[:, None], m.xy_px, np.nan),
            affine=np.where(known[:, None, None], m.affine, np.nan), cov_px2=cov,
            correlation=np.where(known, m.correlation, np.nan), noise=noise, parts_px=parts,
        )  # fmt: skip
