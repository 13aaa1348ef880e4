"""Reading of rings: from a candidate ellipse to the edge of the dot, its quiet zone and the sectors around it.

Everything is sampled in the affine frame of the dot, in which its edge is the unit circle; for all candidates at once.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.targets.codes import RingFamily
from raybundle.targets.conics import algebraic, centred, conics, matrix, sampson

STEPS = 8
"""Positions within a sector at which the reading may begin."""
RAYS = 24
PART = 0.5
"""Least share of the rays that find an edge on one ellipse where something lies on a dot."""
NEAR_PX, NEAR = 0.3, 0.03
"""Largest distance of an edge from that ellipse: pixels and mean radii.  Rays are sampled at tenths of a radius."""
SIZES = (0.4, 2.5)
"""Least and largest semi-axis of that ellipse, in units of those of the spot that was found."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Edges:
    """Dots whose edge was found all around; ellipse and levels of each."""

    xy_px: Array
    """(n, 2)"""
    ellipse: Array
    """(n, 2, 2)"""
    ground: Array
    """(n,) grey value around the dot"""
    contrast: Array
    """(n,) grey value of the dot less that of the ground"""
    misfit: Array
    """(n,) rms distance of the edge from the ellipse [px]"""
    quiet: Array
    """(n,) largest departure from the ground half way to a ring, in units of the contrast"""
    source: Index
    """(n,) row of the candidate"""
    partly: Mask
    """(n,) whether only a part of the edge was found, more than half; `misfit` and `quiet` are those of that part"""

    def rows(self, chosen: Index | Mask) -> Edges:
        """Some of them."""
        return Edges(
            xy_px=self.xy_px[chosen], ellipse=self.ellipse[chosen], ground=self.ground[chosen],
            contrast=self.contrast[chosen], misfit=self.misfit[chosen], quiet=self.quiet[chosen],
            source=self.source[chosen], partly=self.partly[chosen],
        )  # fmt: skip


def joined(edges: list[Edges]) -> Edges:
    """All of them in a row."""
    return Edges(**{f.name: np.concatenate([getattr(e, f.name) for e in edges]) for f in fields(Edges)})


@dataclass(frozen=True, slots=True, kw_only=True)
class Readings:
    """Rings as read."""

    code: Index
    """(n,) set sectors as a number, beginning anywhere"""
    margin: Array
    """(n,) least distance of a sector's mean from half way between dark and light: 0.5 at best"""
    begin: Array
    """(n,) where sector 0 begins: angle in the frame of the dot [rad]"""
    beyond: Array
    """(n,) largest mean of a sector's continuation beyond the ring, where the ground should be: 0 ground, 1 dot"""


def frame(ellipse: Array) -> Array:
    """L (n, 2, 2), lower triangle, that takes the unit circle to the ellipse."""
    return np.linalg.cholesky(ellipse)


def sample(image: Array, xy_px: Array) -> Array:
    """Grey values (...) between pixel centres by bilinear interpolation, the border continued."""
    h, w = image.shape
    x, y = (np.clip(xy_px[..., k] - 0.5, 0, limit - 1.001) for k, limit in ((0, w), (1, h)))
    ix, iy = x.astype(np.int32), y.astype(np.int32)
    fx, fy = (x - ix).astype(np.float32), (y - iy).astype(np.float32)
    at = iy.astype(np.int64) * w + ix
    flat = image.reshape(-1)
    top = flat[at] * (1 - fx) + flat[at + 1] * fx
    return top * (1 - fy) + (flat[at + w] * (1 - fx) + flat[at + w + 1] * fx) * fy


def circle(angles: Array) -> Array:
    """Unit vectors (n, 2), counter-clockwise as seen: the rows of an image run downwards."""
    return np.stack([np.cos(angles), -np.sin(angles)], axis=1)


def _places(xy: Array, L: Array, vectors: Array) -> Array:
    return xy[:, None] + vectors @ L.transpose(0, 2, 1)


def rough_gate(image: Array, xy: Array, ellipse: Array, sign: Array, contrast: float) -> Mask:
    """Which candidates (n,) are of one colour within and mostly of the other around, and lie within the image."""
    L = frame(ellipse)
    reach = 1.8 * np.sqrt(ellipse[:, [0, 1], [0, 1]])
    h, w = image.shape
    inside = ((xy - reach > 0) & (xy + reach < [w, h])).all(axis=1)
    u = circle(np.arange(12) * np.pi / 6)
    within = sample(image, _places(xy, L, np.concatenate([u[::2] * 0.4, [[0, 0]]])))
    around = sample(image, _places(xy, L, u * 1.5)) * sign[:, None]
    core = np.sort(within, axis=1)[:, 3] * sign
    around.sort(axis=1)
    third, last = around[:, 5], around[:, 9]
    return inside & (core - third >= contrast) & (last < third + 0.6 * (core - third))


def find_edges(image: Array, xy: Array, ellipse: Array, sign: Array, rays: int = RAYS) -> Edges:
    """Ellipses through the edges of dots, where grey values are half way between ground and dot along rays."""
    u = circle((np.arange(rays) + 0.5) * 2 * np.pi / rays)
    L = frame(ellipse)
    r, found, core, ground, zone = _profiles(image, xy, L, sign, u)
    good = np.flatnonzero((found.sum(axis=1) >= 0.85 * rays) & (core > ground))
    edge = (u * r[..., None])[good]
    centre, C, misfit, fine = _through(xy[good], L[good], edge, found[good])
    good = good[fine]
    quiet = abs(zone[good] - ground[good, None]).max(axis=1)
    return _edges(centre[fine], C[fine], misfit[fine], quiet, good, core, ground, sign, partly=False)


def _edges(
    centre: Array, C: Array, misfit: Array, unquiet: Array, good: Index, core: Array, ground: Array, sign: Array, *,
    partly: bool,
) -> Edges:  # fmt: skip
    """Edges (k,) of the candidates `good` (k,); core, ground and sign of all candidates, unquiet [grey values]."""
    contrast = core[good] - ground[good]
    return Edges(
        xy_px=centre, ellipse=C, ground=ground[good] * sign[good], contrast=contrast * sign[good], misfit=misfit,
        quiet=unquiet / contrast, source=good, partly=np.full(len(good), partly),
    )  # fmt: skip


def _profiles(image: Array, xy: Array, L: Array, sign: Array, u: Array) -> tuple[Array, Mask, Array, Array, Array]:
    """Radii (n, rays) where grey values are half way between dot and ground, whether they are; levels (n,), (n,).

    The last are the levels (n, rays) half way to a ring.
    """
    rho, rays = np.linspace(0.3, 1.7, 15), len(u)
    grey = sample(image, _places(xy, L, (u[:, None] * rho[:, None]).reshape(-1, 2)))
    grey = grey.reshape(len(xy), rays, len(rho)) * sign[:, None, None].astype(np.float32)
    zone = grey[:, :, 12:14].mean(axis=2)  # 1.5 and 1.6 radii
    ground = np.median(zone, axis=1)
    core = np.median(grey[:, :, :3].reshape(len(xy), 3 * rays), axis=1)
    r, found = _falls(grey, ((ground + core) / 2)[:, None])
    return r, found, core, ground, zone


def _falls(grey: Array, level: Array) -> tuple[Array, Mask]:
    """Radii (n, rays) at which profiles (n, rays, 15) first fall below levels (n, rays), and whether they do."""
    rho = np.linspace(0.3, 1.7, grey.shape[2])
    below = grey < level[..., None]
    k = np.argmax(below, axis=2)
    found = below.any(axis=2) & (k > 0)
    k = np.maximum(k, 1)
    a, b = (np.take_along_axis(grey, j[..., None], axis=2)[..., 0] for j in (k - 1, k))
    return rho[0] + (k - 1 + np.clip((a - level) / np.maximum(a - b, 1e-9), 0, 1)) * (rho[1] - rho[0]), found


def outline_share(
    image: Array, xy: Array, ellipse: Array, window: Array, sign: Array, slope: Array, blur: Array, near: Array,
    even: float,
) -> Array:  # fmt: skip
    """Share (n,) of rays on which grey values are half way between dot and ground where a blurred ellipse has it so.

    window  (n,) radii up to which the ground was looked at: what lies farther out, a ring or texture, does not matter
    slope   (n, 2) of the light as fitted [1/px]
    blur  (n,) standard deviation s [px];  near  (n,) distance up to which it is so [px]
    Levels are those of the image, not of the fit, which may have bent them to what lies on the dot.  They follow the
    fitted slope of the light as far as that moves an edge by no more than `even` [px]: light that is wrong by a share q
    at the edge changes the level by q times itself, and moves a blurred edge by that over contrast / (s sqrt(2 pi)).
    Where an edge bends with a curvature k, the half way line of its image lies s^2 k / 2 within it.
    """
    rho = np.linspace(0.3, 1.7, 15)
    u = circle((np.arange(RAYS) + 0.5) * 2 * np.pi / RAYS)
    L = frame(ellipse)
    grey = sample(image, _places(xy, L, (u[:, None] * rho[:, None]).reshape(-1, 2)))
    grey = grey.reshape(len(xy), RAYS, len(rho)) * np.sign(sign)[:, None, None].astype(np.float32)
    core = np.median(grey[:, :, :3].reshape(len(xy), 3 * RAYS), axis=1)
    outermost = np.clip(np.searchsorted(rho, window + 1e-9) - 1, 8, 13)
    ground = np.median(np.take_along_axis(grey, outermost[:, None, None], axis=2)[..., 0], axis=1)
    light, level = np.einsum("rk,nik,ni->nr", u, L, slope), (ground + core) / 2
    moved = np.sqrt(2 * np.pi) * blur * abs(light).max(axis=1) * abs(level) / np.maximum(core - ground, 1e-9)
    light *= np.minimum(1, even / np.maximum(moved, 1e-9))[:, None]
    r, found = _falls(grey, level[:, None] * (1 + light))
    # distance along the normal L^-T u of that along the ray; curvature det L / |L u'|^3 with u' at right angles to u
    normal = np.linalg.solve(L.transpose(0, 2, 1), np.broadcast_to(u.T, (len(L), 2, len(u))))
    along = u[:, ::-1] * [-1, 1] @ L.transpose(0, 2, 1)
    bend = np.linalg.det(L)[:, None] / np.hypot(*along.transpose(2, 0, 1)) ** 3
    away = (r - 1) / np.hypot(*normal.transpose(1, 0, 2)) + blur[:, None] ** 2 * bend / 2
    return (found & (abs(away) < near[:, None])).mean(axis=1)


def find_parts(image: Array, xy: Array, ellipse: Array, sign: Array) -> Edges:
    """Ellipses through the larger part of the edges of dots on which something lies."""
    if not len(xy):
        return find_edges(image, xy, ellipse, sign)
    u = circle((np.arange(RAYS) + 0.5) * 2 * np.pi / RAYS)
    L = frame(ellipse)
    r, found, core, ground, zone = _profiles(image, xy, L, sign, u)
    good = np.flatnonzero((found.mean(axis=1) > PART) & (core > ground))
    near = np.maximum(NEAR_PX / np.sqrt(np.linalg.det(ellipse[good])) ** 0.5, NEAR)
    centre, C, misfit, agree = _through_part(xy[good], L[good], (u * r[..., None])[good], found[good], near)
    fine = agree.mean(axis=1) > PART
    good, agree = good[fine], agree[fine]
    quiet = np.where(agree, abs(zone[good] - ground[good, None]), 0).max(axis=1, initial=0)
    return _edges(centre[fine], C[fine], misfit[fine], quiet, good, core, ground, sign, partly=True)


def _through_part(xy: Array, L: Array, p: Array, found: Mask, near: Array) -> tuple[Array, Array, Array, Mask]:
    """Ellipses that most points p (n, k, 2) of frames L agree with: centres, C, rms distance [px], which do (n, k).

    Of ellipses through every half of the edge, the one that most points are `near` (n,) to, fitted again to these.
    """
    n, k = found.shape
    rays = np.arange(k)
    halves = ((rays - np.arange(0, k, 2)[:, None]) % k < k // 2)[None] & found[:, None]
    a = conics(np.broadcast_to(p[:, None], (n, k // 2, k, 2)), halves.astype(float))
    agree = (sampson(a, p[:, None]) < near[:, None, None]) & found[:, None]
    best = np.argmax(agree.sum(axis=2), axis=1)
    agree = agree[np.arange(n), best]
    distance = np.full(found.shape, np.inf)
    for _ in range(2):
        a = conics(p, agree.astype(float))
        distance = sampson(a, p)
        agree = (distance < near[:, None]) & found
    fine = _well_shaped(a)
    M, c, size = centred(a, fine)
    D = np.linalg.inv(M) * size[:, None, None]
    C = L @ D @ L.transpose(0, 2, 1)
    fine &= (np.hypot(*c.T) < 1) & (size > 0) & (np.linalg.eigvalsh(D) < SIZES[1] ** 2).all(axis=1)
    fine &= (np.linalg.eigvalsh(D) > SIZES[0] ** 2).all(axis=1)
    agree &= fine[:, None]
    C[~fine] = np.eye(2)
    mean = np.sqrt(np.sqrt(np.maximum(np.linalg.det(C), 0)))
    rms = np.sqrt(np.where(agree, distance**2, 0).sum(axis=1) / np.maximum(agree.sum(axis=1), 1)) * mean
    return xy + np.einsum("nij,nj->ni", L, c), C, rms, agree


def _well_shaped(a: Array) -> Mask:
    """Which conics (n, 5) are ellipses not too far from the unit circle."""
    return (np.linalg.det(matrix(a)) > 0.01) & (a[:, 0] > 0.05)


def _through(xy: Array, L: Array, p: Array, found: Mask) -> tuple[Array, Array, Array, Mask]:
    """Ellipses through points p (n, k, 2) of frames L: centres, C, rms distance [px], whether they are ellipses.

    A x^2 + B x y + C y^2 + D x + E y = 1 by least squares, points near the unit circle; the farthest left out once.
    """
    w = found.astype(float)
    a, e = np.zeros((len(p), 5)), np.zeros(found.shape)
    for _ in range(2):
        a = conics(p, w)
        e = algebraic(a, p) / 2
        limit = 3 * np.median(abs(e), axis=1) + 0.02
        w = found & (abs(e) < limit[:, None])
        w = np.where(w.sum(axis=1, keepdims=True) >= 0.65 * p.shape[1], w, found).astype(float)
    fine = _well_shaped(a)
    M, c, k = centred(a, fine)
    fine &= np.hypot(*c.T) < 0.5
    D = np.linalg.inv(M) * k[:, None, None]
    C = L @ D @ L.transpose(0, 2, 1)
    mean = np.sqrt(np.sqrt(np.maximum(np.linalg.det(C), 0)))
    rms = np.sqrt((w * e**2).sum(axis=1) / np.maximum(w.sum(axis=1), 1)) * mean
    C[~fine] = np.eye(2)
    return xy + np.einsum("nij,nj->ni", L, c), C, rms, fine


def read_rings(image: Array, edges: Edges, family: RingFamily) -> Readings:
    """Read the sectors around dots; the beginning of the sectors is sought in steps of an eighth."""
    bits, n = family.bits, len(edges.xy_px)
    count = bits * STEPS
    directions = circle((np.arange(count) + 0.5) * 2 * np.pi / count)
    L = frame(edges.ellipse)
    scale = np.where(edges.contrast == 0, 1, edges.contrast)[:, None]

    def around(radius: float) -> Array:
        grey = sample(image, _places(edges.xy_px, L, directions * radius))
        return (grey - edges.ground[:, None]) / scale

    v = np.mean([around(r) for r in np.linspace(*family.read, 3)], axis=0)
    # sectors may be paler than the dot (worn or seen askew): half way between dark and light is their own
    light = np.where(v > 0.4, v, 0).sum(axis=1) / np.maximum((v > 0.4).sum(axis=1), 1)
    v = np.clip(v / np.clip(light, 0.5, 1.1)[:, None], -0.25, 1.5)
    best, means, phase = np.full(n, -1.0), np.zeros((n, bits)), np.zeros(n, np.int64)
    for p in range(STEPS):
        sector = _sector_means(np.roll(v, -p, axis=1), bits)
        score = np.minimum(abs(sector - 0.5), 0.5).mean(axis=1)
        better = score > best
        best, phase = np.where(better, score, best), np.where(better, p, phase)
        means = np.where(better[:, None], sector, means)
    outer = family.ring[1] + min(0.35, (family.ground - family.ring[1]) / 2)
    beyond = np.take_along_axis(around(outer), (np.arange(count) + phase[:, None]) % count, axis=1)
    means = _evenly_lit(means, phase * 2 * np.pi / count)
    return Readings(
        code=((means > 0.5) << np.arange(bits)).sum(axis=1),
        margin=abs(means - 0.5).min(axis=1),
        begin=phase * 2 * np.pi / count,
        beyond=_sector_means(beyond, bits).max(axis=1) if n else np.zeros(0),
    )


def _sector_means(v: Array, bits: int) -> Array:
    """Means (n, bits) over the inner parts of sectors of v (n, bits STEPS); blur leaves less of narrow ones."""
    off = 1 if bits < 16 else 2
    return v.reshape(len(v), bits, STEPS)[:, :, off : STEPS - off].mean(axis=2)


def _evenly_lit(means: Array, begin: Array) -> Array:
    """Sectors (n, bits) divided by a plane through the set ones: light falls off, retro-reflecting foil is worn.

    The plane's slope is bound to 0 so that two or three sectors do not make one of their own.
    """
    bits = means.shape[1]
    angle = begin[:, None] + (np.arange(bits) + 0.5) * 2 * np.pi / bits
    J = np.stack([np.ones_like(angle), np.cos(angle), np.sin(angle)], axis=2)
    w = (means > 0.5).astype(float)
    N = np.einsum("nki,nk,nkj->nij", J, w, J) + np.diag([1e-6, 0.2, 0.2])
    plane = np.linalg.solve(N, np.einsum("nki,nk->ni", J, w * means)[..., None])[..., 0]
    level = np.einsum("nki,ni->nk", J, plane)
    return means / np.clip(level, 0.5, 1.4)
