"""The refinement of depths with NumPy, as cpp/surface.cpp does it, in double precision: its oracle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.surfaces.depths.refine import PixelGrid, Refined, RefineOptions, Source, cubic
from raybundle.surfaces.depths.transfer import NODES, Transfer, lagrange

LAG = 3
BATCH = 2000
"""Pixels at once: 30 MB for windows of 49 pixels in four sources."""
LOOSE = 0.2
"""By how much less a source may correlate in the first iteration, far from its place yet."""
GRADIENT_NOISE, LEAST_SHARE, LONGEST, UNKNOWN = 1.2, 0.4, 2.0, 40.0
"""Of the steps of the iteration: see cpp/surface.cpp."""
REFINED, NO_START, NO_TEXTURE, LEFT_IMAGE, NO_CORRELATION, NO_CURVATURE, NO_CONVERGENCE, MOVED_FAR = range(8)


def refine_rows(
    reference: Array,
    sources: Sequence[Source],
    grid: PixelGrid,
    options: RefineOptions,
    autocovariance: Array | None,
    found: Refined,
    todo: Array,
    chain: int,
) -> None:
    """Refine in place the pixels of a grid that `todo` names, as the kernel does."""
    shared = _Shared.of(reference, sources, grid, options, autocovariance)
    if not chain:
        rows, columns = np.nonzero(todo)
        for k in range(0, len(rows), BATCH):
            _batch(shared, found, rows[k : k + BATCH], columns[k : k + BATCH])
        return
    order = range(grid.columns) if chain > 0 else range(grid.columns - 1, -1, -1)
    for k, column in enumerate(order):
        rows = np.flatnonzero(todo[:, column])
        if k and len(rows):
            before = column - chain
            takes = rows[np.isnan(found.numbers[0, rows, column]) & (found.reason[rows, before] == REFINED)]
            t, a, b = found.numbers[:3, takes, before].astype(float)
            kept = found.numbers[:3, takes, column].copy()
            found.numbers[:3, takes, column] = t + chain * grid.stride * a, a, b
            _batch(shared, found, rows, np.full(len(rows), column))
            lost = found.reason[takes, column] != REFINED
            found.numbers[:3, takes[lost], column] = kept[:, lost]
        else:
            _batch(shared, found, rows, np.full(len(rows), column))


@dataclass(frozen=True, slots=True, kw_only=True)
class _Shared:
    """What all pixels share."""

    reference: Array
    sources: Sequence[Source]
    grid: PixelGrid
    options: RefineOptions
    autocovariance: Array | None
    u: Array
    v: Array
    w: Array

    @classmethod
    def of(
        cls,
        reference: Array,
        sources: Sequence[Source],
        grid: PixelGrid,
        options: RefineOptions,
        autocovariance: Array | None,
    ) -> _Shared:
        side = np.arange(-options.half, options.half + 1.0)
        v, u = (x.ravel() for x in np.meshgrid(side, side, indexing="ij"))
        w = np.exp(-(u**2 + v**2) / (2 * options.sigma**2))
        return cls(
            reference=reference, sources=sources, grid=grid, options=options, autocovariance=autocovariance,
            u=u, v=v, w=w,
        )  # fmt: skip

    @property
    def total(self) -> float:
        """Sum of the weights."""
        return float(self.w.sum())

    @property
    def columns(self) -> Array:
        """(3, window) what the derivative by t is multiplied with: by t, a, b."""
        return np.stack([np.ones_like(self.u), self.u, self.v])


@dataclass(slots=True)
class _State:
    """Pixels on their way, and what the last evaluation made of them; arrays over sources have them first."""

    x: Index
    y: Index
    p: Array
    """(3, n) t, a, b"""
    slope: Array
    """(n,) standard deviation of the given slopes [px / px]"""
    T: Array
    contrast: Array
    used: Mask
    """(sources, n)"""
    g: Array
    """(sources, n, window) normalised"""
    gx: Array
    gy: Array
    J: Array
    """by t, of normalised grey values"""
    correlation: Array
    steep: Array
    """(sources, n, 2, 2) derivatives of place by u and v"""
    reach: Array
    squares: Array
    """(n,) sum of the squared reaches of all sources"""
    s2: Array
    Q: Array
    """(n, 3, 3)"""


def _batch(shared: _Shared, found: Refined, rows: Index, columns: Index) -> None:
    """Refine some pixels of the grid."""
    if not len(rows):
        return
    grid, half = shared.grid, shared.options.half
    p = found.numbers[:3, rows, columns].astype(float)
    found.views[rows, columns], found.iterations[rows, columns] = 0, 0
    reason = np.where(np.isnan(p[0]), NO_START, REFINED)
    known = np.asarray(np.isfinite(p[1:]).all(axis=0))
    p[1:] = np.nan_to_num(p[1:])
    x, y = grid.x0 + grid.stride * columns, grid.y0 + grid.stride * rows
    height, width = shared.reference.shape
    beyond = (x < half) | (y < half) | (x + half >= width) | (y + half >= height)
    reason = np.where((reason == REFINED) & beyond, LEFT_IMAGE, reason)
    go = np.flatnonzero(reason == REFINED)
    state, flat = _begun(shared, x[go], y[go], p[:, go], known[go])
    reason[go[flat]] = NO_TEXTURE
    go = go[~flat]
    if not len(go):  # as in columns that no refined neighbour has reached yet
        found.reason[rows, columns] = reason
        return
    with np.errstate(invalid="ignore", divide="ignore"):
        outcome, iterations, step = _iterate(shared, state)
        good = np.flatnonzero(outcome == REFINED)
        at = _subset(state, good)
        curvature, outcome[good] = _curvature(shared, at)
    reason[go] = outcome
    found.iterations[rows[go], columns[go]] = np.minimum(iterations, 255)
    found.reason[rows, columns] = reason
    keep = np.asarray(outcome[good] == REFINED)
    at, done = _subset(at, np.flatnonzero(keep)), go[good[keep]]
    place = rows[done], columns[done]
    noise, shift, response = _combined(shared, at)
    inflation = 1 / at.Q[:, 0, 0] / curvature[keep]
    correlation = np.where(at.used, at.correlation, 0).sum(axis=0) / np.maximum(at.used.sum(axis=0), 1)
    values = [
        *(at.p + inflation * step[:, good[keep]]),
        at.Q[:, 0, 0],
        noise,
        inflation,
        at.s2,
        correlation,
        at.contrast,
    ]
    found.numbers[:, *place] = np.stack(values)
    found.views[place] = (at.used.T * (1 << np.arange(len(at.used)))).sum(axis=1)
    found.shift[place] = shift
    if found.response is not None:
        found.response[place] = response


def _begun(shared: _Shared, x: Index, y: Index, p: Array, known: Mask) -> tuple[_State, Mask]:
    """Pixels whose window has texture, ready for the iteration, and which have none."""
    half, count = shared.options.half, len(shared.sources)
    side = np.arange(-half, half + 1)
    windows = shared.reference[y[:, None, None] + side[:, None], x[:, None, None] + side]
    T = windows.reshape(len(x), len(shared.w)).astype(float)
    T = T - (T @ shared.w / shared.total)[:, None]
    contrast = np.sqrt(T**2 @ shared.w / shared.total)
    flat = ~(contrast > shared.options.contrast)
    T, contrast, n = T[~flat] / contrast[~flat, None], contrast[~flat], int((~flat).sum())
    empty = np.zeros((4, count, n, len(shared.w)))
    state = _State(
        x=x[~flat], y=y[~flat], p=p[:, ~flat], slope=np.where(known[~flat], 1, UNKNOWN) * shared.options.slope, T=T,
        contrast=contrast, used=np.ones((count, n), bool), g=empty[0], gx=empty[1], gy=empty[2], J=empty[3],
        correlation=np.zeros((count, n)), steep=np.zeros((count, n, 2, 2)), reach=np.zeros(n), squares=np.zeros(n),
        s2=np.zeros(n), Q=np.zeros((n, 3, 3)),
    )  # fmt: skip
    return state, flat


def _subset(o: _State, rows: Index) -> _State:
    over = {name: getattr(o, name)[:, rows] for name in ("p", "used", "g", "gx", "gy", "J", "correlation", "steep")}
    each = {
        name: getattr(o, name)[rows] for name in ("x", "y", "slope", "T", "contrast", "reach", "squares", "s2", "Q")
    }
    return _State(**over, **each)


def _put(o: _State, rows: Index, part: _State) -> None:
    for name in ("p", "used", "g", "gx", "gy", "J", "correlation", "steep"):
        getattr(o, name)[:, rows] = getattr(part, name)
    for name in ("reach", "squares", "s2", "Q"):
        getattr(o, name)[rows] = getattr(part, name)


def _iterate(shared: _Shared, state: _State) -> tuple[Index, Index, Array]:
    """Outcome, iterations and the last step (3, n) of each pixel; the state is that before the last step."""
    o, n = shared.options, len(state.x)
    outcome, iterations, step = np.full(n, NO_CONVERGENCE), np.full(n, o.iterations + 1), np.zeros((3, n))
    start, rows = state.p.copy(), np.arange(n)
    before, made, used = np.zeros((3, n)), np.zeros((3, n)), np.zeros(state.used.shape, bool)
    for k in range(1, o.iterations + 1):
        part = _subset(state, rows)
        bad, N, B = _evaluate(shared, part, k)
        _with_slopes(part, N, B, start[:, rows])
        bad, d, longer = _solved(shared, part, bad, N, B)
        _put(state, rows, part)
        ends = (bad == REFINED) & (longer * _length(shared, part, d) < o.step)
        iterations[rows] = k
        outcome[rows] = np.where(ends | (bad != REFINED), bad, NO_CONVERGENCE)
        step[:, rows] = np.where(ends, d, step[:, rows])
        on = np.flatnonzero((bad == REFINED) & ~ends)
        rows, part, d = rows[on], _subset(part, on), (longer * d)[:, on]
        again = (used[:, rows] == part.used).all(axis=0)
        move = d - np.where(again, _accelerated(o.sigma, d, before[:, rows], made[:, rows]), 0)
        move /= np.maximum(_length(shared, part, move), 1)
        before[:, rows], made[:, rows], used[:, rows] = d, move, part.used
        state.p[:, rows] += move
        moved = ~(np.abs(state.p[0, rows] - start[0, rows]) * part.reach <= o.reach)
        outcome[rows[moved]] = MOVED_FAR
        rows = rows[~moved]
        if not len(rows):
            break
    iterations[rows] = o.iterations + 1
    return outcome, iterations, step


def _with_slopes(part: _State, N: Array, B: Array, start: Array) -> None:
    """Add to the normal equations that the slopes were given, too."""
    prior = np.maximum(part.s2, 1e-4) * part.reach**2 / part.slope**2
    for i in (1, 2):
        N[:, i, i] += prior
        B[:, i] += prior * (part.p[i] - start[i])


def _solved(shared: _Shared, part: _State, bad: Index, N: Array, B: Array) -> tuple[Index, Array, Array]:
    """Outcome (n,), correction (3, n), and by what it is lengthened since noise makes the normal matrix larger."""
    fine = bad == REFINED
    diagonal = N[:, 0, 0] * N[:, 1, 1] * N[:, 2, 2]
    singular = fine & ~(np.linalg.det(np.where(fine[:, None, None], N, np.eye(3))) > 1e-12 * diagonal)
    bad = np.where(singular, NO_TEXTURE, bad)
    part.Q = np.linalg.inv(np.where((bad == REFINED)[:, None, None], N, np.eye(3)))
    d = -np.einsum("nij,nj->in", part.Q, B)
    longer = 1 / np.maximum(1 - GRADIENT_NOISE * part.s2 * shared.total * part.squares / N[:, 0, 0], LEAST_SHARE)
    lost = (bad == REFINED) & ~(longer * _length(shared, part, d) < 1e9)
    return np.where(lost, NO_CONVERGENCE, bad), d, longer


def _length(shared: _Shared, part: _State, d: Array) -> Array:
    """Shift (n,) of steps (3, n) in the most sensitive source, about where the window's weight stands [px]."""
    return part.reach * np.sqrt(d[0] ** 2 + shared.options.sigma**2 * (d[1] ** 2 + d[2] ** 2))


def _accelerated(sigma: float, d: Array, before: Array, made: Array) -> Array:
    """What is taken off a correction (3, n) since the one before was followed by it (Anderson 1965)."""
    size, difference = np.array([[1.0], [sigma**2], [sigma**2]]), d - before
    change, along = (size * difference**2).sum(axis=0), (size * d * difference).sum(axis=0)
    gamma = np.where(change > 0, np.clip(along / np.where(change > 0, change, 1), -LONGEST, 0.5), 0)
    return gamma * (made + difference)


def _evaluate(shared: _Shared, o: _State, iteration: int) -> tuple[Index, Array, Array]:
    """Outcome (n,), normal matrix (n, 3, 3) and right side (n, 3); sources that leave or look otherwise are dropped."""
    n, w, least = len(o.x), shared.w, shared.options.correlation - (LOOSE if iteration == 1 else 0)
    bad = np.full(n, LEFT_IMAGE)
    o.reach, o.squares = np.zeros(n), np.zeros(n)
    columns = np.zeros((len(shared.sources), 3, n, len(w)))
    for s, source in enumerate(shared.sources):
        at = _Local.of(source.transfer, o, o.p)
        g, gx, gy, inside = _sampled(shared, source, at)
        inside &= o.used[s]
        g, contrast = _normalised(shared, g)
        textured = contrast > shared.options.contrast
        bad = np.where((bad == LEFT_IMAGE) & inside & ~textured, NO_TEXTURE, bad)
        correlation = (g * o.T) @ w / shared.total
        alike = ~(correlation < least)
        bad = np.where(inside & textured & ~alike, NO_CORRELATION, bad)
        o.used[s] = inside & textured & alike
        k = np.where(o.used[s], 1 / contrast, 0)[:, None]
        o.g[s], o.gx[s], o.gy[s] = (np.where(o.used[s][:, None], a, 0) for a in (g, gx * k, gy * k))
        o.J[s] = np.where(o.used[s][:, None], gx * k * at.by_t(0, shared) + gy * k * at.by_t(1, shared), 0)
        o.correlation[s], o.steep[s] = correlation, at.steep
        o.reach = np.where(o.used[s], np.maximum(o.reach, at.reach), o.reach)
        o.squares += np.where(o.used[s], at.reach**2, 0)
        full = o.J[s] * shared.columns[:, None]
        mean, along = full @ w / shared.total, (full * o.g[s]) @ w / shared.total
        columns[s] = full - mean[..., None] - along[..., None] * o.g[s]
    count = o.used.sum(axis=0)
    columns = np.where(o.used[:, None, :, None], columns, 0)
    patch, middle = o.T + o.g.sum(axis=0), columns.sum(axis=0)
    N = np.einsum("spnw,sqnw,w->npq", columns, columns, w)
    N -= np.einsum("pnw,qnw,w->npq", middle, middle, w) / (count + 1)[:, None, None]
    B = -np.einsum("pnw,nw,w->np", middle, patch, w) / (count + 1)[:, None]
    left = (count + 1) * shared.total - patch**2 @ w / (count + 1)
    worth = count * shared.total**2 / (w**2).sum()
    o.s2 = np.maximum(left, 0) / shared.total / count * worth / np.maximum(worth - 2 * count - 3, 1)
    return np.where(count > 0, REFINED, bad), N, B


def _normalised(shared: _Shared, g: Array) -> tuple[Array, Array]:
    g = g - (g @ shared.w / shared.total)[:, None]
    contrast = np.sqrt(g**2 @ shared.w / shared.total)
    return g / np.maximum(contrast, 1e-15)[:, None], contrast


@dataclass(slots=True)
class _Local:
    """Place in a window as a quadratic polynomial of u and v, and its derivative by t as a linear one; (n, 2) each."""

    c: Array
    """(6, n, 2) of 1, u, v, u^2, u v, v^2"""
    t: Array
    """(3, n, 2) of 1, u, v"""

    @classmethod
    def of(cls, table: Transfer, o: _State, p: Array) -> _Local:
        xy = np.stack([o.x + 0.5, o.y + 0.5], axis=1)
        where = table.nodes(xy, p[0])
        first = [
            np.clip(np.floor(np.nan_to_num(x)) - 1, 0, n - NODES)
            for x, n in zip(where, table.places.shape, strict=False)
        ]
        wv, wu, wt = (lagrange(x - f) for x, f in zip(where, first, strict=True))
        j, i, k = (f.astype(int)[:, None] + np.arange(NODES) for f in first)
        nodes = table.places[j[:, :, None, None], i[:, None, :, None], k[:, None, None, :]]
        outside = ~((where[2] >= 0) & (where[2] <= table.places.shape[2] - 1))

        def F(v: int, u: int, t: int) -> Array:
            value = np.einsum("nj,ni,nk,njikc->nc", wv[v], wu[u], wt[t], nodes)
            return np.where(outside[:, None], np.nan, value) / (table.step_px ** (u + v) * table.dt**t)

        a, b = p[1][:, None], p[2][:, None]
        t, tt, ut, vt = F(0, 0, 1), F(0, 0, 2), F(0, 1, 1), F(1, 0, 1)
        second = [
            (F(0, 2, 0) + 2 * a * ut + a**2 * tt) / 2,
            F(1, 1, 0) + b * ut + a * vt + a * b * tt,
            (F(2, 0, 0) + 2 * b * vt + b**2 * tt) / 2,
        ]
        return cls(
            np.stack([F(0, 0, 0), F(0, 1, 0) + a * t, F(1, 0, 0) + b * t, *second]),
            np.stack([t, ut + a * tt, vt + b * tt]),
        )

    def place(self, k: int, shared: _Shared) -> Array:
        """(n, window) x or y."""
        u, v = shared.u, shared.v
        return np.einsum("pn,pw->nw", self.c[..., k], np.stack([np.ones_like(u), u, v, u * u, u * v, v * v]))

    def by_t(self, k: int, shared: _Shared) -> Array:
        """(n, window) its derivative by t."""
        return np.einsum("pn,pw->nw", self.t[..., k], shared.columns)

    @property
    def steep(self) -> Array:
        """(n, 2, 2) derivatives of x, y by u, v."""
        return np.nan_to_num(np.stack([self.c[1], self.c[2]], axis=2))

    @property
    def reach(self) -> Array:
        """(n,) shift for a unit of t."""
        return np.hypot(self.t[0, :, 0], self.t[0, :, 1])


def _sampled(shared: _Shared, source: Source, at: _Local) -> tuple[Array, Array, Array, Mask]:
    """Grey values and gradients (n, window) by cubic convolution, and which windows are inside."""
    height, width = source.grey.shape
    x, y = at.place(0, shared) - 0.5, at.place(1, shared) - 0.5
    inside = ((x >= 1) & (x < width - 2) & (y >= 1) & (y < height - 2)).all(axis=1)
    x, y = (np.where(inside[:, None], q, 1) for q in (x, y))
    ix, iy = np.floor(x).astype(int), np.floor(y).astype(int)
    (wx, dx), (wy, dy) = cubic(x - ix), cubic(y - iy)
    four = np.arange(-1, 3)
    grey = source.grey[(iy[..., None] + four)[..., :, None], (ix[..., None] + four)[..., None, :]].astype(float)
    return (
        np.einsum("nwj,nwi,nwji->nw", wy, wx, grey),
        np.einsum("nwj,nwi,nwji->nw", wy, dx, grey),
        np.einsum("nwj,nwi,nwji->nw", dy, wx, grey),
        inside,
    )


def _curvature(shared: _Shared, o: _State) -> tuple[Array, Index]:
    """Observed curvature (n,) of the cost where the slopes follow t, and the outcome."""
    apart = shared.options.apart / o.reach
    along = np.stack([np.ones(len(o.x)), o.Q[:, 0, 1] / o.Q[:, 0, 0], o.Q[:, 0, 2] / o.Q[:, 0, 0]])
    count, cost, left = o.used.sum(axis=0), [], np.zeros(len(o.x), bool)
    for side in (-1, 0, 1):
        total = o.T.copy()
        for s, source in enumerate(shared.sources):
            g = o.g[s]
            if side:
                g, _, _, inside = _sampled(shared, source, _Local.of(source.transfer, o, o.p + side * apart * along))
                left |= o.used[s] & ~inside
                g = _normalised(shared, g)[0]
            total += np.where(o.used[s][:, None], g, 0)
        cost.append(-0.5 * (total**2 @ shared.w) / (count + 1))
    found = (cost[0] - 2 * cost[1] + cost[2]) / apart**2
    flat = ~(found > shared.options.share / o.Q[:, 0, 0])
    return found, np.where(left, LEFT_IMAGE, np.where(flat, NO_CURVATURE, REFINED))


def _combined(shared: _Shared, o: _State) -> tuple[Array, Array, Array]:
    """Cofactor of t (n,) by noise, its reaction to shifts of sources (n, sources, 2) and to the surface (n, window)."""
    w, n, count = shared.w, len(o.x), len(shared.sources)
    q = o.Q[:, 0]
    rows = np.zeros((count + 1, n, len(w)))
    for s in range(count):
        row = o.J[s] * (q @ shared.columns)
        row = row - (row @ w / shared.total)[:, None]
        rows[s + 1] = row - ((row * o.g[s]) @ w / shared.total)[:, None] * o.g[s]
    mean = rows.sum(axis=0) / (o.used.sum(axis=0) + 1)[:, None]
    noise, shift, response = np.zeros(n), np.zeros((n, count, 2)), np.zeros((n, len(w)))
    for s in range(-1, count):
        g, used = (o.T, np.ones(n, bool)) if s < 0 else (o.g[s], o.used[s])
        row = w * (rows[s + 1] - mean + ((mean * g) @ w / shared.total)[:, None] * g)
        row = np.where(used[:, None], row, 0)
        noise += (row**2).sum(axis=1) if shared.autocovariance is None else _correlated(shared, o, row, s)
        if s >= 0:
            shift[:, s] = -np.stack([(row * o.gx[s]).sum(axis=1), (row * o.gy[s]).sum(axis=1)], axis=1)
            response += row * o.J[s]
    return noise, shift, response


def _correlated(shared: _Shared, o: _State, row: Array, s: int) -> Array:
    """Variances (n,) of the sum of row times grey values whose autocovariance is given in the view's own pixels."""
    side = 2 * shared.options.half + 1
    k = np.pad(row.reshape(-1, side, side), ((0, 0), (LAG, LAG), (LAG, LAG)))
    assert shared.autocovariance is not None
    table = shared.autocovariance[s + 1].astype(float)
    sums = np.zeros(len(row))
    for dy in range(LAG + 1):
        for dx in range(-LAG if dy else 0, LAG + 1):
            lag = np.array([dx, dy], float)
            at = np.tile(lag, (len(row), 1)) if s < 0 else o.steep[s] @ lag
            reached = (np.abs(at) <= LAG).all(axis=1) if s < 0 else (np.abs(at) < LAG).all(axis=1)
            i = np.clip(np.floor(at), -LAG, LAG - 1).astype(int)
            f = at - i
            c = [table[i[:, 1] + LAG + m, i[:, 0] + LAG + l] for m in (0, 1) for l in (0, 1)]
            fx, fy = f.T
            cov = (1 - fy) * ((1 - fx) * c[0] + fx * c[1]) + fy * ((1 - fx) * c[2] + fx * c[3])
            moved = np.roll(k, (-dy, -dx), axis=(1, 2))
            sums += np.where(reached, cov, 0) * (k * moved).sum(axis=(1, 2)) * (2 if dx or dy else 1)
    return sums
