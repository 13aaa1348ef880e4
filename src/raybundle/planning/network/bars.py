"""Known distances between points of a planned network: what they do to its covariances, and where they should lie."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.planning.network.site import Site

ALIKE = 0.1
"""Part of its length by which the points of a bar may be nearer or farther than the bar is long"""
LIFT = 0.02
"""How far over the surface the end of a bar is, by the object's extent, when it is looked whether it fits"""
LOOKED_AT = 20_000
"""Pairs of points of which it is looked whether the object lies between"""
LONG = 0.8
"""Part of the longest distance from which on bars of any length are put"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Bars:
    """Scale bars between points."""

    pairs: Index
    """(b, 2) rows of points"""
    sigma: Array
    """(b,) standard deviations of their lengths [m]"""

    def rows(self, xyz: Array) -> Array:
        """(3t, b) derivatives of the lengths by the points' coordinates."""
        i, j = self.pairs.T
        along = xyz[i] - xyz[j]
        along = along / np.linalg.norm(along, axis=1, keepdims=True)
        A = np.zeros((len(xyz), 3, len(i)))
        k = np.arange(len(i))
        A[i, :, k] = along
        A[j, :, k] = -along
        return A.reshape(-1, len(i))

    def length(self, xyz: Array) -> Array:
        """(b,) [m]."""
        return np.linalg.norm(xyz[self.pairs[:, 0]] - xyz[self.pairs[:, 1]], axis=1)


@dataclass(frozen=True, slots=True, kw_only=True)
class Scaled:
    """A network with bars: the change of its covariances by their observations.

    Without control the scale is open before and is estimated from the bars: with the covariance Q of the network under
    inner constraints, bars l = A x + h m + e of dispersion D and C = A Q A' + D, the scale m has the variance
    v = 1 / (h' C^-1 h), and x + g m, with g its direction, the covariance
    Q - U K U' + g c' + c g' + v g g', U = Q A', K = C^-1 - v C^-1 h h' C^-1, c = -v U C^-1 h
    (sequential adjustment with an additional unknown: Koch 1999, section 3.2).
    """

    U: Array
    """(3t, b) covariances of points and lengths"""
    K: Array
    by_scale: Array
    """(b,) C^-1 h v; zeros where the scale is known before"""
    variance: float
    """Of the scale; 0 where it is known before"""
    by_unknowns: Array
    """(u, b) minus the lengths' derivatives by stations and interior orientation, points eliminated"""
    raw: Array
    """(3t, b) covariances of points and lengths in the stations' own datum"""

    @classmethod
    def of(cls, bars: Bars, xyz: Array, iV: Array, M: Array, iS: Array, datum: tuple[Array, Array] | None) -> Scaled:
        """Of a network: inverses of the points' normal equations (t, 3, 3), M (3t, u), covariance of the unknowns."""
        t, A = len(xyz), bars.rows(xyz)
        B = A
        if datum is not None:
            H, G = (d.reshape(3 * t, 7) for d in datum)
            B = A - H @ (G.T @ A)
        MB = M.T @ B
        raw = (iV @ B.reshape(t, 3, -1)).reshape(3 * t, -1) + M @ (iS @ MB)
        U = raw if datum is None else raw - datum[1].reshape(3 * t, 7) @ (datum[0].reshape(3 * t, 7).T @ raw)
        inverse = np.linalg.inv(A.T @ U + np.diag(bars.sigma**2))
        if datum is None:
            return cls(U=U, K=inverse, by_scale=np.zeros(len(inverse)), variance=0.0, by_unknowns=MB, raw=raw)
        h = A.T @ datum[1].reshape(3 * t, 7)[:, 6]
        Ch = inverse @ h
        v = 1 / float(h @ Ch)
        return cls(U=U, K=inverse - v * np.outer(Ch, Ch), by_scale=v * Ch, variance=v, by_unknowns=MB, raw=raw)

    def change(self, U: Array, g: Array | None) -> Array:
        """(n, 3, 3) change of the covariances of points with the covariances U (3n, b) and the scale's direction g."""
        U = U.reshape(-1, 3, U.shape[-1])
        new = -U @ self.K @ np.swapaxes(U, 1, 2)
        if g is not None:
            g = g.reshape(-1, 3, 1)
            c = -(U @ self.by_scale)[:, :, None]
            new = new + g @ np.swapaxes(c, 1, 2) + c @ np.swapaxes(g, 1, 2)
            new = new + self.variance * g @ np.swapaxes(g, 1, 2)
        return new

    def of_unknowns(self, F: Array) -> Array:
        """(f, f) change of the covariance of unknowns that do not depend on the scale, with F = cov by by_unknowns."""
        return -F @ self.K @ F.T


def placed_bars(
    xyz: Array, count: int, sigma: float, length: float | None = None,
    clear: Callable[[Index, Index], Mask] | None = None,
) -> Bars:  # fmt: skip
    """So many bars between points, in directions and at places that differ.

    length  of the bars [m]; None: as long as the object allows
    clear   of rows of two points each, whether a bar fits between them; None: everywhere
    raises  InputError where no two points are so far apart
    Each is, of those that fit, the one that is most across those before it and farthest from them.
    """
    i, j = np.triu_indices(len(xyz), 1)
    step = xyz[i] - xyz[j]
    far = np.linalg.norm(step, axis=1)
    order = np.argsort(-far if length is None else np.abs(far - length), kind="stable")
    if clear is not None:
        order = order[:LOOKED_AT]
        order = order[clear(i[order], j[order])]
    i, j, step, far = i[order], j[order], step[order], far[order]
    longest = float(far.max(initial=0.0))
    fits = far >= LONG * longest if length is None else np.abs(far / length - 1) <= ALIKE
    if not fits.any():
        raise InputError("plan.no_place_for_bars", length_m=length or longest, longest_m=longest)
    i, j, step, far = i[fits], j[fits], step[fits], far[fits]
    axis, middle = step / far[:, None], (xyz[i] + xyz[j]) / 2
    extent = float(np.ptp(xyz, axis=0).max())
    chosen = [int(far.argmax())] if length is None else [int(np.abs(far - (length or 0)).argmin())]
    while len(chosen) < min(count, len(i)):
        across = np.min(1 - np.abs(axis @ axis[chosen].T), axis=1)
        away = np.min(np.linalg.norm(middle[:, None] - middle[None, chosen], axis=2), axis=1) / extent
        worth = across + 0.5 * away
        worth[chosen] = -1
        chosen.append(int(worth.argmax()))
    return Bars(pairs=np.column_stack([i[chosen], j[chosen]]), sigma=np.full(len(chosen), sigma))


def bars_on(site: Site, count: int, sigma: float, length: float | None = None) -> Bars:
    """As `placed_bars`, between the points of a site, and not through its object: along a face, or over an edge."""
    p, lift = site.points, LIFT * site.extent

    def clear(i: Index, j: Index) -> Mask:
        a, b = p.xyz[i], p.xyz[j]
        seen = site.sight.visible(b + lift * p.normal[j], a, p.normal[i])
        back = site.sight.visible(a + lift * p.normal[i], b, p.normal[j])
        return np.asarray(seen & back)

    return placed_bars(p.xyz, count, sigma, length, clear)
