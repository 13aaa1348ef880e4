"""A whole target, drawn as the fit of its dot says it should look: a last test of what was read.

A ring is drawn as the dot is (see `centre`): the blurred image of a region is a sum along its edge.
"""

from __future__ import annotations

import math

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.targets.centre import X0, Y0, A, D, S
from raybundle.targets.codes import RingFamily, sectors

FINE = 1.3
"""Length of a piece of an edge, in standard deviations of the blur."""
FINEST = 40
"""Pixels along a side that are compared; of larger targets every second, third ... is."""
BEYOND = 0.25
"""How far beyond the ring grey values are compared, in radii of the dot."""
PALEST = 0.35
"""Least ratio of the contrasts of ring and dot, either way round."""


def pattern_misfit(image: Array, values: Array, code: int, begin: float, family: RingFamily) -> tuple[float, float]:
    """How far grey values are from those of the target drawn, in units of the contrast.

    image   (h, w)
    values  (10,) of the dot, as `fit_dots` gives them
    begin   where sector 0 begins in the frame of the dot, counter-clockwise as seen [rad]

    returns  their standard deviation; the largest mean departure of a sector, which is small wherever nothing lies on
             the ring, however noisy or blurred it is
    Ground, contrasts of dot and ring and slopes of the light over ground and ring are fitted; infinite where the
    contrasts do not match.
    """
    L = np.array([[values[A], 0], [values[A + 1], values[D]]])
    reach = (family.ring[1] + BEYOND) * np.hypot(L[:, 0], L[:, 1])
    low = np.maximum(np.floor(values[:2] - reach).astype(int), 0)
    high = np.minimum(np.ceil(values[:2] + reach).astype(int), [image.shape[1], image.shape[0]])
    step = max(1, int(np.ceil((high - low).max() / FINEST)))
    rows, columns = slice(low[1], high[1], step), slice(low[0], high[0], step)
    x, y = (np.arange(s.start, s.stop, step) + 0.5 - v for s, v in ((columns, values[X0]), (rows, values[Y0])))
    dot = blurred_region(circle_edge(L, values[S]), x, y, values[S])
    ring = blurred_region(ring_edge(L, values[S], code, begin, family), x, y, values[S])
    p, q = np.einsum("ij,j...->i...", np.linalg.inv(L), np.stack(np.meshgrid(x, y))) / family.ring[1]
    within = np.hypot(p, q) < 1 + BEYOND / family.ring[1]
    p, q, dot, ring = p[within], q[within], dot[within], ring[within]
    grey = image[rows, columns][within].astype(float)
    J = np.stack([np.ones_like(grey), dot, ring, ring * p, ring * q, p, q], axis=1)
    levels, *_ = np.linalg.lstsq(J, grey)
    if not PALEST < levels[2] / levels[1] < 1 / PALEST:
        return np.inf, np.inf
    e = (grey - J @ levels) / levels[1]
    sector = ((np.arctan2(-q, p) - begin) % (2 * np.pi) * family.bits / (2 * np.pi)).astype(int) % family.bits
    sector = np.where(np.hypot(p, q) > family.ring[0] / family.ring[1], sector, family.bits)  # the last is no sector
    sector[np.hypot(p, q) > 1] = family.bits
    count, total = (np.bincount(sector, w, minlength=family.bits + 1)[:-1] for w in (None, e))
    return float(np.sqrt(np.mean(e**2))), float(np.abs(total / np.maximum(count, 1)).max())


def blurred_region(edge: tuple[Array, Array], x: Array, y: Array, s: float) -> Array:
    """Share (h, w) of a region in pixels with centres x (w,), y (h,): edge points (n, 2) and pieces (n, 2)."""
    from scipy.special import ndtr  # noqa: PLC0415  (loaded when a target is drawn)

    at, piece = edge
    # beyond six standard deviations nothing is felt
    tx, ty = (np.clip((at[:, k, None] - z) / s, -6, 6) for k, z in ((0, x), (1, y)))
    return (np.exp(-(ty**2) / 2) * (piece[:, 1, None] / (s * np.sqrt(2 * np.pi)))).T @ ndtr(tx)


def circle_edge(L: Array, s: float, radius: float = 1.0) -> tuple[Array, Array]:
    """Edge of a disc under the affine map L, for a blur s."""
    return _pieces(_arc(L, s, radius, 0, 2 * np.pi))


def ring_edge(L: Array, s: float, code: int, begin: float, family: RingFamily) -> tuple[Array, Array]:
    """Edges of the set sectors of a ring under the affine map L, for a blur s."""
    step, parts = 2 * np.pi / family.bits, []
    inner, outer = family.ring
    for first, last in sectors(code, family.bits):
        a, b = begin + first * step, begin + last * step
        outline = [
            _arc(L, s, outer, a, b),
            _line(L, s, outer, inner, b),
            _arc(L, s, inner, b, a),
            _line(L, s, inner, outer, a),
        ]
        parts.append(_pieces(np.concatenate(outline)))
    return np.concatenate([p[0] for p in parts]), np.concatenate([p[1] for p in parts])


def _count(L: Array, s: float, length: float) -> int:
    return max(2, math.ceil(length * math.sqrt(float((L * L).sum())) / (FINE * s)))


def _arc(L: Array, s: float, radius: float, a: float, b: float) -> Array:
    t = np.linspace(a, b, 1 + _count(L, s, radius * abs(b - a)))
    return radius * np.stack([np.cos(t), -np.sin(t)], axis=1) @ L.T


def _line(L: Array, s: float, start: float, end: float, angle: float) -> Array:
    r = np.linspace(start, end, 1 + _count(L, s, abs(end - start)))
    return r[:, None] * np.array([np.cos(angle), -np.sin(angle)]) @ L.T


def _pieces(outline: Array) -> tuple[Array, Array]:
    """Middles and pieces of a closed outline, turned so that what it encloses counts positive."""
    following = np.roll(outline, -1, axis=0)
    at, piece = (outline + following) / 2, following - outline
    area = at[:, 0] @ piece[:, 1]
    return at, piece * np.sign(area)
