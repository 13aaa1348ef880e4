"""Reading of rings: from a candidate ellipse to the edge of the dot, its quiet zone and the sectors around it.

Everything is sampled in the affine frame of the dot, in which its edge is the unit circle; for all candidates at once.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.targets.codes import RingFamily

STEPS = 8
"""Positions within a sector at which the reading may begin."""
RAYS = 24


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

    def rows(self, chosen: Index | Mask) -> Edges:
        """Some of them."""
        return Edges(
            xy_px=self.xy_px[chosen], ellipse=self.ellipse[chosen], ground=self.ground[chosen],
            contrast=self.contrast[chosen], misfit=self.misfit[chosen], quiet=self.quiet[chosen],
            source=self.source[chosen],
        )  # fmt: skip


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
    rho = np.linspace(0.3, 1.7, 15)
    u = circle((np.arange(rays) + 0.5) * 2 * np.pi / rays)
    L = frame(ellipse)
    grey = sample(image, _places(xy, L, (u[:, None] * rho[:, None]).reshape(-1, 2)))
    grey = grey.reshape(len(xy), rays, len(rho)) * sign[:, None, None].astype(np.float32)
    zone = grey[:, :, 12:14].mean(axis=2)  # 1.5 and 1.6 radii
    ground = np.median(zone, axis=1)
    core = np.median(grey[:, :, :3].reshape(len(xy), 3 * rays), axis=1)
    level = ((ground + core) / 2)[:, None]
    below = grey < level[..., None]
    k = np.argmax(below, axis=2)
    found = below.any(axis=2) & (k > 0)
    k = np.maximum(k, 1)
    a, b = (np.take_along_axis(grey, j[..., None], axis=2)[..., 0] for j in (k - 1, k))
    r = rho[0] + (k - 1 + np.clip((a - level) / np.maximum(a - b, 1e-9), 0, 1)) * (rho[1] - rho[0])
    good = np.flatnonzero((found.sum(axis=1) >= 0.85 * rays) & (core > ground))
    edge = (u * r[..., None])[good]
    centre, C, misfit, fine = _through(xy[good], L[good], edge, found[good])
    good = good[fine]
    contrast = core[good] - ground[good]
    return Edges(
        xy_px=centre[fine],
        ellipse=C[fine],
        ground=ground[good] * sign[good],
        contrast=contrast * sign[good],
        misfit=misfit[fine],
        quiet=abs(zone[good] - ground[good, None]).max(axis=1) / contrast,
        source=good,
    )


def _through(xy: Array, L: Array, p: Array, found: Mask) -> tuple[Array, Array, Array, Mask]:
    """Ellipses through points p (n, k, 2) of frames L: centres, C, rms distance [px], whether they are ellipses.

    A x^2 + B x y + C y^2 + D x + E y = 1 by least squares, points near the unit circle; the farthest left out once.
    """
    x, y = p[..., 0], p[..., 1]
    J = np.stack([x * x, x * y, y * y, x, y], axis=2)
    w = found.astype(float)
    a, e = np.zeros((len(p), 5)), np.zeros(x.shape)
    for _ in range(2):
        N = np.einsum("nki,nk,nkj->nij", J, w, J) + 1e-9 * np.eye(5)
        a = np.linalg.solve(N, np.einsum("nki,nk->ni", J, w)[..., None])[..., 0]
        e = (np.einsum("nki,ni->nk", J, a) - 1) / 2
        limit = 3 * np.median(abs(e), axis=1) + 0.02
        w = found & (abs(e) < limit[:, None])
        w = np.where(w.sum(axis=1, keepdims=True) >= 0.65 * p.shape[1], w, found).astype(float)
    M = np.stack([a[:, 0], a[:, 1] / 2, a[:, 1] / 2, a[:, 2]], axis=1).reshape(-1, 2, 2)
    det = np.linalg.det(M)
    fine = (det > 0.01) & (a[:, 0] > 0.05)
    M[~fine] = np.eye(2)
    c = -0.5 * np.linalg.solve(M, a[:, 3:, None])[..., 0]
    k = 1 + np.einsum("ni,nij,nj->n", c, M, c)
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
