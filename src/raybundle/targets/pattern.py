"""A whole target, drawn as the fit of its dot states it should look: a last test of what was read.

A ring is drawn as the dot is (see `centre`): the blurred image of a region is a sum along its edge.  The ellipse of the
dot leaves open how the plane lies behind it: the turn, and the projective maps that take a circle to itself.  In
homogeneous coordinates these are the boosts (x, w) -> (x + (g - 1) (b.x) b / b^2 + g b w, g (w + b.x)) with
g = 1 / sqrt(1 - b^2), b the image of the dot's centre in the frame in which its edge is the unit circle.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.targets.centre import CONTRAST, GROUND, GX, GY, X0, Y0, A, D, S
from raybundle.targets.codes import RingFamily, sectors

FINE = 1.3
"""Length of a piece of an edge, in standard deviations of the blur."""
FINEST = 40
"""Pixels along a side that are compared; of larger targets the means of blocks of 2 x 2, 3 x 3 ... are."""
BEYOND = 0.25
"""How far beyond the ring grey values are compared, in radii of the dot."""
OFF = 0.1
"""Departure from the dot as fitted, in units of its contrast, from which something lies there."""
PALEST = 0.35
"""Least ratio of the contrasts of ring and dot, either way round."""
ROUNDS = 4
"""Most steps towards the turn and the perspective of the ring."""
DELTA = np.array([0.01, 0.004, 0.004])
"""Steps for the differences of the edge: turn [rad], perspective."""
SETTLED = np.array([0.003, 0.001, 0.001])
"""Changes of them below which the ring has settled."""
TURN = 0.3
"""Sectors by which a ring may be turned against what was read: it is read in steps of an eighth."""
BOOST = 0.1
"""Largest perspective, as the distance of the image of the dot's centre from that of its ellipse in radii."""


@dataclass(frozen=True, slots=True)
class _Window:
    """Grey values around a target, in blocks of pixels where it is large."""

    x: Array
    """(w,) from the centre of the dot [px]"""
    y: Array
    """(h,)"""
    s: float
    """blur and block together, as the standard deviation of a Gaussian [px]"""
    within: Mask
    """(h, w) near enough"""
    p: Array
    """(n,) of those within: frame of the dot, in outer radii of the ring"""
    q: Array
    grey: Array
    dot: Array
    """(n,) share that the dot covers, blurred"""


@dataclass(frozen=True, slots=True)
class _Place:
    """How the ring lies beyond what the ellipse of its dot shows: turn [rad], perspective (2,)."""

    L: Array
    code: int
    family: RingFamily
    turn: float
    boost: Array

    def moved(self, step: Array) -> _Place:
        """Turned and tilted further by `step` (3,), the perspective within its bound."""
        return _Place(
            self.L, self.code, self.family, self.turn + step[0], np.clip(self.boost + step[1:], -BOOST, BOOST)
        )

    def edge(self, s: float) -> tuple[Array, Array]:
        """Of the set sectors."""
        return ring_edge(self.L, s, self.code, self.turn, self.family, self.boost)


def pattern_misfit(
    image: Array, values: Array, code: int, begin: float, family: RingFamily, *, covered: bool = False
) -> tuple[float, float]:
    """How far grey values are from those of the target drawn, in units of the contrast.

    image   (h, w)
    values  (10,) of the dot, as `fit_dots` gives them
    begin   where sector 0 begins in the frame of the dot, counter-clockwise as seen [rad]
    covered  something lies on the dot: within the ring, what does not look like it is left out

    returns  their standard deviation; the largest mean departure of a sector, which is small wherever nothing lies on
             the ring, however noisy or blurred it is
    Ground, contrasts of dot and ring and slopes of the light over ground and ring are fitted; infinite where the
    contrasts do not match.
    """
    w, place = _start(image, values, code, begin, family, covered=covered)
    return _misfit(w, place, blurred_region(place.edge(w.s), w.x, w.y, w.s)[w.within])


def settled_misfit(
    image: Array, values: Array, code: int, begin: float, family: RingFamily, *, covered: bool = False
) -> tuple[float, float]:
    """The same after the ring was moved to where grey values want it.

    The turn was read in steps of an eighth of a sector, and the perspective not at all: in large targets of many
    sectors both show.  Three unknowns more, and so more than `pattern_misfit` of a ring that something lies on.
    """
    w, place = _start(image, values, code, begin, family, covered=covered)
    ring = blurred_region(place.edge(w.s), w.x, w.y, w.s)[w.within]
    slack = TURN * 2 * np.pi / family.bits
    for _ in range(ROUNDS):
        levels = np.linalg.lstsq(_design(w, ring), w.grey, rcond=None)[0]
        light = levels[2] + levels[3] * w.p + levels[4] * w.q
        both = np.concatenate([_design(w, ring), light[:, None] * _felt(w, place)], axis=1)
        step = np.linalg.lstsq(both, w.grey, rcond=None)[0][-3:]
        step[0] = np.clip(place.turn + step[0], begin - slack, begin + slack) - place.turn
        place = place.moved(step)
        ring = blurred_region(place.edge(w.s), w.x, w.y, w.s)[w.within]
        if (abs(step) < SETTLED).all():
            break
    return _misfit(w, place, ring)


def _start(
    image: Array, values: Array, code: int, begin: float, family: RingFamily, *, covered: bool
) -> tuple[_Window, _Place]:
    L = np.array([[values[A], 0], [values[A + 1], values[D]]])
    return _window(image, values, L, family, covered=covered), _Place(L, code, family, begin, np.zeros(2))


def _window(image: Array, values: Array, L: Array, family: RingFamily, *, covered: bool) -> _Window:
    reach = (family.ring[1] + BEYOND) * np.hypot(L[:, 0], L[:, 1])
    low = np.maximum(np.floor(values[:2] - reach).astype(int), 0)
    high = np.minimum(np.ceil(values[:2] + reach).astype(int), [image.shape[1], image.shape[0]])
    step = max(1, int(np.ceil((high - low).max() / FINEST)))
    w, h = np.maximum((high - low) // step, 1)
    grey = image[low[1] : low[1] + h * step, low[0] : low[0] + w * step]
    grey = grey.reshape(h, step, w, step).mean(axis=(1, 3))
    from scipy.ndimage import binary_dilation

    x, y = (first + (np.arange(n) + 0.5) * step - v for first, n, v in zip(low, (w, h), values[[X0, Y0]], strict=True))
    s = math.sqrt(values[S] ** 2 + (step**2 - 1) / 12)
    dot = blurred_region(circle_edge(L, s), x, y, s)
    p, q = np.einsum("ij,j...->i...", np.linalg.inv(L), np.stack(np.meshgrid(x, y))) / family.ring[1]
    radius = np.hypot(p, q)
    within = radius < 1 + BEYOND / family.ring[1]
    if covered:
        dx, dy = np.meshgrid(x, y)
        seen = (values[GROUND] + values[CONTRAST] * dot) * (1 + values[GX] * dx + values[GY] * dy)
        off = (radius < family.ring[0] / family.ring[1]) & (abs(grey - seen) > OFF * abs(values[CONTRAST]))
        within &= ~np.asarray(binary_dilation(off, np.ones((3, 3))), bool)
    return _Window(x, y, s, within, p[within], q[within], grey[within], dot[within])


def _misfit(w: _Window, place: _Place, ring: Array) -> tuple[float, float]:
    J, family = _design(w, ring), place.family
    levels = np.linalg.lstsq(J, w.grey, rcond=None)[0]
    if not PALEST < levels[2] / levels[1] < 1 / PALEST:
        return np.inf, np.inf
    e = (w.grey - J @ levels) / levels[1]
    angle = np.arctan2(-w.q, w.p) - place.turn
    sector = (angle % (2 * np.pi) * family.bits / (2 * np.pi)).astype(int) % family.bits
    radius = np.hypot(w.p, w.q)
    on_ring = (radius > family.ring[0] / family.ring[1]) & (radius <= 1)
    sector = np.where(on_ring, sector, family.bits)  # the last is no sector
    count, total = (np.bincount(sector, v, minlength=family.bits + 1)[:-1] for v in (None, e))
    return float(np.sqrt(np.mean(e**2))), float(np.abs(total / np.maximum(count, 1)).max())


def _felt(w: _Window, place: _Place) -> Array:
    """Derivatives (n, 3) of the ring drawn by turn and perspective: what its edge sweeps, blurred."""
    at, piece = place.edge(w.s)
    tx, ty = (np.clip((at[:, k, None] - z) / w.s, -6, 6) for k, z in ((0, w.x), (1, w.y)))
    bell_x, bell_y = (np.exp(-(t**2) / 2) / (w.s * math.sqrt(2 * math.pi)) for t in (tx, ty))
    columns: list[Array] = []
    for d in np.diag(DELTA):
        v = (place.moved(d).edge(w.s)[0] - at) / d.sum()
        swept = v[:, 0] * piece[:, 1] - v[:, 1] * piece[:, 0]
        columns.append(((bell_y * swept[:, None]).T @ bell_x)[w.within])
    return np.stack(columns, axis=1)


def _design(w: _Window, ring: Array) -> Array:
    """Ground, dot, ring, slopes of the light over ring and ground (n, 7)."""
    return np.stack([np.ones_like(w.grey), w.dot, ring, ring * w.p, ring * w.q, w.p, w.q], axis=1)


def blurred_region(edge: tuple[Array, Array], x: Array, y: Array, s: float) -> Array:
    """Share (h, w) of a region in pixels with centres x (w,), y (h,): edge points (n, 2) and pieces (n, 2)."""
    from scipy.special import ndtr

    at, piece = edge
    # beyond six standard deviations nothing is felt
    tx, ty = (np.clip((at[:, k, None] - z) / s, -6, 6) for k, z in ((0, x), (1, y)))
    return (np.exp(-(ty**2) / 2) * (piece[:, 1, None] / (s * np.sqrt(2 * np.pi)))).T @ ndtr(tx)


def circle_edge(L: Array, s: float, radius: float = 1.0) -> tuple[Array, Array]:
    """Edge of a disc under the affine map L, for a blur s."""
    return _pieces(_arc(L, s, radius, 0, 2 * np.pi) @ L.T)


def ring_edge(L: Array, s: float, code: int, begin: float, family: RingFamily, boost: Array) -> tuple[Array, Array]:
    """Edges of the set sectors of a ring under the affine map L after a boost (2,), for a blur s."""
    step, parts = 2 * np.pi / family.bits, []
    inner, outer = family.ring
    for first, last in sectors(code, family.bits):
        a, b = begin + first * step, begin + last * step
        outline = np.concatenate([
            _arc(L, s, outer, a, b),
            _line(L, s, outer, inner, b),
            _arc(L, s, inner, b, a),
            _line(L, s, inner, outer, a),
        ])  # fmt: skip
        parts.append(_pieces(boosted(outline, boost) @ L.T))
    return np.concatenate([p[0] for p in parts]), np.concatenate([p[1] for p in parts])


def boosted(points: Array, b: Array) -> Array:
    """Points (n, 2) under the projective map that takes the unit circle to itself and its centre to b (2,)."""
    square = float(b @ b)
    g = 1 / math.sqrt(1 - square)
    along = points @ b
    more = (g - 1) / square if square > 1e-12 else 0.5
    return (points + (more * along + g)[:, None] * b) / (g * (1 + along))[:, None]


def _count(L: Array, s: float, length: float) -> int:
    return max(2, math.ceil(length * math.sqrt(float((L * L).sum())) / (FINE * s)))


def _arc(L: Array, s: float, radius: float, a: float, b: float) -> Array:
    t = np.linspace(a, b, 1 + _count(L, s, radius * abs(b - a)))
    return radius * np.stack([np.cos(t), -np.sin(t)], axis=1)


def _line(L: Array, s: float, start: float, end: float, angle: float) -> Array:
    r = np.linspace(start, end, 1 + _count(L, s, abs(end - start)))
    return r[:, None] * np.array([np.cos(angle), -np.sin(angle)])


def _pieces(outline: Array) -> tuple[Array, Array]:
    """Middles and pieces of a closed outline, turned so that what it encloses counts positive."""
    following = np.roll(outline, -1, axis=0)
    at, piece = (outline + following) / 2, following - outline
    area = at[:, 0] @ piece[:, 1]
    return at, piece * np.sign(area)
