"""The covariance that a small network promises, from its design alone: quickly, for many networks that are alike.

The same normal equations as of `raybundle.adjustment`, whose covariances are the same (tests/planning); here each
station's part is kept, so that networks which differ by a station cost little.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from raybundle.calibration.maps import ProjectionShifts, projection_shifts
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.objects.surface import SurfacePoints
from raybundle.planning.network.bars import Bars, Scaled
from raybundle.planning.network.site import Site

SURE = 1e-9
"""Part of a ray that may be missing: rounding"""
FLAT = 1e-10
"""Least part of a point's largest eigenvalue that is more than rounding: rays that meet at an angle of 1e-5"""
WEAK = 1e-6
"""Least pivot of the scaled normal equations of the stations, squared 1e-12, from which on a network is determined"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Part:
    """What one station adds to the normal equations, and where it stands."""

    centre: Array
    rotation: Array
    points: Index
    """(k,) that it sees"""
    share: Array
    """(k,) how often each is found; their weights are multiplied by it"""
    A: Array
    B: Array
    D: Array
    """(k, 2, 3 or 6 or f) derivatives of the image points, in their standard deviations and by the root of `share`: by
    the point, by centre and turn of the station, by the interior orientation"""
    V: Array
    """(t, 3, 3) by points"""
    W: Array
    """(t, 3, 6) by points, and centre and turn of the station"""
    N: Array
    """(6, 6)"""
    side: Array
    """(6, f) by the station and the interior orientation"""
    WF: Array
    """(t, 3, f)"""
    F: Array
    """(f, f)"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Expected:
    """What a network promises."""

    points: Array
    """(t, 3, 3) covariances [m^2], inner constraints over all points, or under control"""
    interior: Array
    """(f, f) covariance of the free parameters of the interior orientation"""
    rays: Array
    """(t,) photographs in which a point is found, as far as that is to be expected"""
    inverse: Array
    """(u, u) covariance of stations and interior orientation in a datum of their own, for `Networks.elsewhere`"""
    eliminated: tuple[Array, Array]
    """(t, 3, 3) inverses of the points' normal equations, and (3t, u) these times those with the other unknowns"""
    scaled: Scaled | None = None
    """What scale bars bring"""

    @property
    def sigma(self) -> Array:
        """(t,) root mean square of the standard deviations of a point's coordinates [m]."""
        return np.sqrt(np.trace(self.points, axis1=1, axis2=2) / 3)


@dataclass(frozen=True, slots=True, kw_only=True)
class Short:
    """What a network lacks that cannot be adjusted."""

    unseen: Index
    """(t,) rays that each point lacks of those that it must have"""
    open: int = 0
    """Unknowns of stations and camera that nothing determines: a network that falls apart has some"""

    @property
    def lack(self) -> int:
        """Rays and unknowns that are missing; at least 1."""
        return max(1, int(self.unseen.sum()) + self.open)


class Networks:
    """Networks at one site."""

    def __init__(
        self, site: Site, control_sigma: Array | None = None, least_rays: int = 2, carriers: Mask | None = None,
        bars: Bars | None = None,
    ) -> None:  # fmt: skip
        """Prepare.

        control_sigma  (t, 3) standard deviations of coordinates that are known beforehand [m], infinite where none;
                       None: the datum is that of inner constraints over all points
        least_rays     of each point; two are no check of each other along their plane, three find a blunder
        carriers       (t,) points over which inner constraints are taken; None: all
        bars           known distances between points; the scale is theirs then
        """
        self.carriers, self.bars = carriers, bars
        self.least_rays = least_rays
        self.site = site
        xyz = site.points.xyz
        self.middle, self.size = xyz.mean(axis=0), site.extent
        self.prior = None if control_sigma is None else 1 / np.asarray(control_sigma, float) ** 2
        self.free = site.free
        symbols = site.camera.sensor.symbols
        self.columns = [5 + symbols.index(s) for s in self.free]

    def with_rays(self, least_rays: int) -> Networks:
        """The same with another least number of rays."""
        made = Networks(self.site, None, least_rays, self.carriers, self.bars)
        made.prior = self.prior
        return made

    @cached_property
    def shifts(self) -> ProjectionShifts:
        """How image points move by the free parameters of the interior orientation."""
        return projection_shifts(self.site.camera, tuple(self.free), columns=15, rows=10)

    @cached_property
    def _datum(self) -> tuple[Array, Array, Array]:
        """Shifts, turns and scale (t, 3, 7): orthonormal over the carriers and zero elsewhere; of all; (7, 7) unit."""
        G = self._directions(self.site.points.xyz)
        carrying = np.ones(len(G), bool) if self.carriers is None else self.carriers
        R = np.linalg.qr((G * carrying[:, None, None]).reshape(-1, 7))[1]
        unit = np.linalg.inv(R)
        G = G @ unit
        return G * carrying[:, None, None], G, unit

    def _directions(self, xyz: Array) -> Array:
        """(n, 3, 7) shifts, turns and scale of places."""
        p = (xyz - self.middle) / self.size
        return np.concatenate([np.tile(np.eye(3), (len(p), 1, 1)), -_crosses(p), p[:, :, None]], axis=2)

    def at_places(self, parts: Sequence[Part], points: SurfacePoints) -> list[Part]:
        """The parts of these stations for other points."""
        there = Networks(replace(self.site, points=points))
        return there.parts(np.array([p.centre for p in parts]), np.array([p.rotation for p in parts]))

    def elsewhere(
        self, parts: Sequence[Part], e: Expected, points: SurfacePoints, mine: Sequence[Part] | None = None
    ) -> Array:
        """(m, 3, 3) covariances that other points would have, measured in a network without adding to it.

        mine  their parts, as `at_places` gives them; None: they are made
        NaN where a point has less than two rays, or rays from one place alone.
        """
        mine = self.at_places(parts, points) if mine is None else mine
        rays = np.bincount(np.concatenate([p.points for p in mine]), minlength=len(points))
        m, t = len(points), len(self.site.points)
        V = np.sum([p.V for p in mine], axis=0)
        rays[~has_depth(V)] = 0
        own = np.concatenate([*(p.W for p in mine), np.sum([p.WF for p in mine], axis=0)], axis=2)
        Q = np.full((m, 3, 3), np.nan)
        good = np.flatnonzero(rays >= 2)
        iV = np.linalg.inv(V[good])
        M = iV @ own[good]
        MS = (M.reshape(-1, len(e.inverse)) @ e.inverse).reshape(M.shape)  # one product is faster than many small ones
        Q[good] = iV + MS @ np.swapaxes(M, 1, 2)
        if self.prior is not None:
            if e.scaled is not None:
                Q[good] += e.scaled.change(MS.reshape(-1, MS.shape[2]) @ e.scaled.by_unknowns, None)
            return Q
        H, _, unit = self._datum
        network_iV, network_M = e.eliminated
        flat = H.reshape(3 * t, 7)
        HM = flat.T @ network_M
        inner = flat.T @ (network_iV @ H).reshape(3 * t, 7) + HM @ e.inverse @ HM.T
        G = self._directions(points.xyz[good]) @ unit
        cross = G @ np.swapaxes((MS.reshape(-1, MS.shape[2]) @ HM.T).reshape(-1, 3, 7), 1, 2)
        Q[good] += G @ inner @ np.swapaxes(G, 1, 2) - cross - np.swapaxes(cross, 1, 2)
        if e.scaled is not None:
            flat_G = G.reshape(-1, 7)
            U = MS.reshape(-1, MS.shape[2]) @ e.scaled.by_unknowns - flat_G @ (flat.T @ e.scaled.raw)
            Q[good] += e.scaled.change(U, flat_G[:, 6])
        return Q

    def parts(self, centre: Array, rotation: Array) -> list[Part]:
        """The parts of stations (n, 3), (n, 3, 3)."""
        site = self.site
        station, point, image, P = site.seen(centre, rotation)
        values = site.camera.parameters
        _, J = site.camera.sensor.condition_and_jacobian(*image.T, *P.T, *values)
        J = np.moveaxis(np.broadcast_to(J, (2, J.shape[1], len(P))), 2, 0)
        # in px of the measured image
        pixel = np.array(site.camera.pixel_mm) * site.sigma_px
        J = -np.linalg.solve(J[:, :, :2], J[:, :, 2:]) / pixel[:, None]
        share = site.share(centre[station], point)
        J *= np.sqrt(share)[:, None, None]
        by_point = J[:, :, :3] @ rotation[station]
        by_station = np.concatenate([-by_point, J[:, :, :3] @ -_crosses(P)], axis=2)
        by_interior = J[:, :, [c - 2 for c in self.columns]]
        first, t = np.searchsorted(station, np.arange(len(centre) + 1)), len(site.points)
        return [
            self.part(centre[i], rotation[i], point[s], share[s], (by_point[s], by_station[s], by_interior[s]), t)
            for i in range(len(centre))
            for s in [slice(first[i], first[i + 1])]
        ]

    def part(
        self, centre: Array, rotation: Array, point: Index, share: Array, by: tuple[Array, Array, Array], count: int
    ) -> Part:
        """The part of one station.

        by     derivatives A, B, D of the image points of points (k,), as of `Part`
        count  how many points there are
        """
        A, B, D = by
        f = len(self.free)
        V, W, WF = np.zeros((count, 3, 3)), np.zeros((count, 3, 6)), np.zeros((count, 3, f))
        At = np.swapaxes(A, 1, 2)
        V[point], W[point], WF[point] = At @ A, At @ B, At @ D
        b, d = B.reshape(-1, 6), D.reshape(2 * len(point), f)
        return Part(
            centre=centre, rotation=rotation, points=point, share=share, A=A, B=B, D=D, V=V, W=W, N=b.T @ b,
            side=b.T @ d, WF=WF, F=d.T @ d,
        )  # fmt: skip

    def expected(self, parts: Sequence[Part]) -> Expected | Short:
        """The covariances of a network of these stations; what it lacks where points have less than two rays.

        A network that falls apart or leaves a parameter open lacks one ray.
        """
        t, f, n = len(self.site.points), len(self.free), len(parts)
        if not n:
            return Short(unseen=np.full(t, self.least_rays))
        found = np.bincount(
            np.concatenate([p.points for p in parts]), np.concatenate([p.share for p in parts]), minlength=t
        )
        known = np.zeros(t, bool) if self.prior is None else (self.prior > 0).all(axis=1)
        lacking = np.where(known, 0, np.ceil(np.maximum(self.least_rays - found - SURE, 0))).astype(np.int64)
        if lacking.any():
            return Short(unseen=lacking)
        V = np.sum([p.V for p in parts], axis=0)
        if self.prior is not None:
            V[:, range(3), range(3)] += self.prior
        u = 6 * n + f
        W = np.concatenate([*(p.W for p in parts), np.sum([p.WF for p in parts], axis=0)], axis=2).reshape(3 * t, u)
        N = np.zeros((u, u))
        for i, p in enumerate(parts):
            s = slice(6 * i, 6 * i + 6)
            N[s, s], N[s, 6 * n :], N[6 * n :, s] = p.N, p.side, p.side.T
        N[6 * n :, 6 * n :] = np.sum([p.F for p in parts], axis=0)
        try:
            iV = np.linalg.inv(V)
        except np.linalg.LinAlgError:
            return Short(unseen=_flat(V))
        M = (iV @ W.reshape(t, 3, u)).reshape(3 * t, u)
        iS = self._inverse(N - W.T @ M, np.diag(N), parts)
        if isinstance(iS, int):
            return Short(unseen=_flat(V), open=iS)
        points, interior, scaled = self._points(iV, M, iS), iS[6 * n :, 6 * n :], None
        if self.bars is not None:
            datum = None if self.prior is not None else self._datum[:2]
            scaled = Scaled.of(self.bars, self.site.points.xyz, iV, M, iS, datum)
            points = points + scaled.change(scaled.U, None if datum is None else datum[1].reshape(-1, 7)[:, 6])
            interior = interior + scaled.of_unknowns(iS[6 * n :] @ scaled.by_unknowns)
        return Expected(points=points, interior=interior, rays=found, inverse=iS, eliminated=(iV, M), scaled=scaled)

    def _inverse(self, S: Array, diagonal: Array, parts: Sequence[Part]) -> Array | int:
        """An inverse of the stations' normal equations, without the seven directions that change no image.

        Where there is none, how many unknowns nothing determines.
        """
        if not (diagonal > 0).all():
            return int((diagonal <= 0).sum())
        scale = 1 / np.sqrt(diagonal)
        S = scale[:, None] * S * scale
        C = np.zeros((len(S), 0))
        if self.prior is None:
            C = np.linalg.qr(self._open(parts, len(S)) / scale[:, None])[0]
        try:
            L = np.linalg.cholesky(S + C @ C.T)
        except np.linalg.LinAlgError:
            L = np.zeros((1, 1))
        if L.diagonal().min() < WEAK:
            return max(1, int((np.linalg.eigvalsh(S + C @ C.T) < WEAK).sum()))
        half = np.linalg.inv(L)
        return scale[:, None] * (half.T @ half - C @ C.T) * scale

    def _open(self, parts: Sequence[Part], unknowns: int) -> Array:
        C = np.zeros((unknowns, 7))
        for i, p in enumerate(parts):
            d = (p.centre - self.middle) / self.size
            s, turn = slice(6 * i, 6 * i + 3), slice(6 * i + 3, 6 * i + 6)
            C[s, :3], C[s, 3:6], C[s, 6] = np.eye(3), -_crosses(d[None])[0], d
            C[turn, 3:6] = -p.rotation / self.size
        return C

    def _points(self, iV: Array, M: Array, iS: Array) -> Array:
        t = len(iV)
        MS = M @ iS
        Q = iV + MS.reshape(t, 3, -1) @ np.swapaxes(M.reshape(t, 3, -1), 1, 2)
        if self.prior is not None:
            return Q
        H, G, _ = self._datum
        flat = H.reshape(3 * t, 7)
        QH = (iV @ H).reshape(3 * t, 7) + MS @ (M.T @ flat)
        HQH = flat.T @ QH
        cross = G @ np.swapaxes(QH.reshape(t, 3, 7), 1, 2)
        return Q - cross - np.swapaxes(cross, 1, 2) + G @ HQH @ np.swapaxes(G, 1, 2)


def _flat(V: Array) -> Index:
    """(t,) rays that points lack whose rays come from one place."""
    return (~has_depth(V)).astype(np.int64)


def has_depth(V: Array) -> Mask:
    """(n,) whether points with these normal equations (n, 3, 3) are not seen from one place alone."""
    size = np.linalg.eigvalsh(V)
    return size[:, 0] > FLAT * size[:, 2]


def _crosses(v: Array) -> Array:
    """(n, 3, 3) matrices of the vector product v x."""
    K = np.zeros((len(v), 3, 3))
    K[:, 0, 1], K[:, 0, 2], K[:, 1, 2] = -v[:, 2], v[:, 1], -v[:, 0]
    return K - np.swapaxes(K, 1, 2)
