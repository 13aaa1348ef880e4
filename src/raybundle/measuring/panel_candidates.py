"""Places of a picture that may be ground panels: cross, chequered, iron cross (triangles) or disc.

All of them look the same after half a turn about their centre, from whatever side they are seen.  With the grey values
g(c + u) of the disc of radius r about c, their mean m and variance v, the correlation of a place with itself, turned by
half a turn, is

    s(c) = sum_u (g(c + u) - m) (g(c - u) - m) / (n v)

(point symmetry; Reisfeld, Wolfson and Yeshurun 1995 use gradients).  A bar is symmetric all along its axis: the smaller
eigenvalue of the structure tensor of the disc separates it from a point (Förstner and Gülch 1987).  What remains is
measured as a click of the hand is (`snap`); places that no model of a panel describes are left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.measuring.snap import Found, Snapped, snap
from raybundle.numerics.arrays import Array

RADIUS = 10
"""Of the disc [px of a level]: panels of some 12 to 25 px across are seen in the picture itself, larger in a level"""
LEVELS = 3
"""The picture, half and a quarter of it"""
LEAST_SYMMETRY = 0.6
"""Correlation of a place with itself after half a turn; of texture it is below 0.3 with RADIUS (300 pixels)"""
LEAST_CONTRAST = 8.0
"""Standard deviation of the grey values in the disc [of 256]"""
LEAST_ROUND = 0.08
"""Smaller over larger eigenvalue of the structure tensor"""
MOST = 24
"""Places of a window, the most distinct first"""
KINDS: tuple[Found, ...] = ("cross", "corner", "ellipse")
"""Cross; chequered and iron cross; disc"""
REACH_PX = 4.0
"""Farthest that the measured centre lies from the place"""
APART_PX = 4.0
"""Distance below which two places are one"""
SYMMETRY_PX = 0.3
"""Standard deviation of a centre by symmetry alone: numbers and creases of a panel are not symmetric"""
UNIFORM = 0.4
"""Contrast of a smaller disc over that of the larger one, below which it shows nothing: within a white disc"""
STEP = 2
"""Pixels of a finer level by which a centre is moved to either side of its place in the coarser one"""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Place:
    """A place that looks like a panel, to about a pixel."""

    x_px: float
    y_px: float
    symmetry: float
    contrast: float
    """standard deviation of the grey values about it [of 256]; of the disc in which both together are largest"""
    level: int
    """of that disc"""

    worth: float
    """how distinct it is: symmetry times contrast times the root of the radius of that disc in RADIUS"""


def panel_places(grey: Array) -> list[Place]:
    """Places of a picture (h, w), uint8 or uint16, that look like panels, the most distinct first."""
    scale = 256.0 if grey.dtype == np.uint16 else 1.0
    found: list[Place] = []
    for place in sorted(_places(grey.astype(np.float32) / np.float32(scale)), key=lambda p: -p.worth):
        if not any(_within(place, f) for f in found):
            found.append(place)
    return found[:MOST]


def _within(place: Place, other: Place) -> bool:
    """Whether a place is a part of another one: an end of a cross, a triangle."""
    apart = np.hypot(place.x_px - other.x_px, place.y_px - other.y_px)
    return bool(apart < APART_PX or (apart < RADIUS * 2**other.level and place.worth < other.worth))


def measured_panel(grey: Array, place: Place, kinds: Sequence[Found] = KINDS) -> Snapped | None:
    """The panel at a place of a picture by the model that describes it best, else by its symmetry (a patch)."""
    tried = [snap(grey, place.x_px, place.y_px, kind, reach_px=REACH_PX, windows=False) for kind in kinds]
    best = max((t for t in tried if isinstance(t, Snapped)), key=lambda t: t.quality, default=None)
    return best or _half_turn(grey, place)


def _half_turn(grey: Array, place: Place) -> Snapped | None:
    """The centre about which the grey values are symmetric, by least squares; None where it is not near the place.

    Of offsets u of one half of the disc the differences g(c + u) - g(c - u) are to vanish; their partials by c are
    differences of gradients.
    """
    from scipy.ndimage import map_coordinates

    k = np.arange(-RADIUS, RADIUS + 1)
    u, v = (a.ravel().astype(float) for a in np.meshgrid(k, k))
    half = (u * u + v * v <= RADIUS**2) & ((v > 0) | ((v == 0) & (u > 0)))
    u, v = u[half], v[half]
    start = np.array([place.x_px, place.y_px]) - 0.5
    low = np.maximum(np.floor(start).astype(int) - 2 * RADIUS, 0)
    part = grey[low[1] : low[1] + 4 * RADIUS + 1, low[0] : low[0] + 4 * RADIUS + 1].astype(float)
    if min(part.shape) < 3 * RADIUS:
        return None
    gy, gx = np.gradient(part)
    c = start - low
    Q, e = np.eye(2), np.zeros(0)
    for _ in range(10):
        there, back = np.stack([c[1] + v, c[0] + u]), np.stack([c[1] - v, c[0] - u])
        one, two = ([map_coordinates(p, at, order=1, mode="nearest") for p in (part, gx, gy)] for at in (there, back))
        e = two[0] - one[0]
        J = np.stack([one[1] - two[1], one[2] - two[2]], axis=1)
        N = J.T @ J
        if np.linalg.cond(N) > 1e3:
            return None
        Q = np.linalg.inv(N)
        step = Q @ (J.T @ e)
        c = c + np.clip(step, -1, 1)
        if np.abs(step).max() < 1e-3:
            break
    moved = float(np.hypot(*(c + low - start)))
    C = Q * float(e @ e) / (len(e) - 2) + SYMMETRY_PX**2 * np.eye(2)
    if moved > REACH_PX or not np.isfinite(C).all():
        return None
    x, y = c + low + 0.5
    return Snapped(
        x_px=float(x), y_px=float(y), covariance=(float(C[0, 0]), float(C[1, 1]), float(C[0, 1])), kind="patch",
        quality=place.symmetry, moved_px=moved,
    )  # fmt: skip


def _places(grey: Array) -> list[Place]:
    """The places of all levels."""
    import cv2

    maps: list[tuple[Array, Array, Array]] = []
    part = grey
    for _ in range(LEVELS):
        if min(part.shape) < 4 * RADIUS:
            break
        maps.append(_maps(part))
        part = cv2.resize(part, (part.shape[1] // 2, part.shape[0] // 2), interpolation=cv2.INTER_AREA)
    found: list[Place] = []
    for level in reversed(range(len(maps))):
        s, contrast, roundness = maps[level]
        worth = np.where((s >= LEAST_SYMMETRY) & (contrast >= LEAST_CONTRAST) & (roundness >= LEAST_ROUND), s, 0.0)
        peak = (worth > 0) & (worth == cv2.dilate(worth, np.ones((5, 5), np.uint8)))
        here = [_refined(maps, level, x, y) for y, x in np.argwhere(peak).tolist()]
        found += [p for p in here if p is not None]
    return found


def _refined(maps: Sequence[tuple[Array, Array, Array]], level: int, x: int, y: int) -> Place | None:
    """A place of a level, its centre where the smaller discs about it are most symmetric; None where they are not.

    A smaller disc of little contrast, as within a white disc, shows nothing.
    """
    s, contrast, _ = maps[level]
    at, best = (y, x), (float(s[y, x]), float(contrast[y, x]), level)
    for finer in reversed(range(level)):
        fine, flat = maps[finer][0], maps[finer][1]
        x0, y0 = max(2 * x - STEP, 0), max(2 * y - STEP, 0)
        window = np.s_[y0 : 2 * y + STEP + 2, x0 : 2 * x + STEP + 2]
        near = fine[window]
        if not near.size or flat[2 * y, 2 * x] < max(LEAST_CONTRAST, UNIFORM * contrast[at]):
            x, y = 2 * x, 2 * y
            continue
        if near.max() < LEAST_SYMMETRY:
            return None
        dy, dx = np.unravel_index(int(np.argmax(near)), near.shape)
        x, y = x0 + int(dx), y0 + int(dy)
        best = max(best, (float(near[dy, dx]), float(flat[y, x]), finer), key=_worth)
    return Place(
        x_px=x + 0.5, y_px=y + 0.5, symmetry=best[0], contrast=best[1], level=best[2], worth=_worth(best)
    )  # fmt: skip


def _worth(of: tuple[float, float, int]) -> float:
    symmetry, contrast, level = of
    return float(symmetry * contrast * 2 ** (level / 2))


def _maps(grey: Array) -> tuple[Array, Array, Array]:
    """Symmetry, contrast and roundness of each pixel of a level; 0 within RADIUS of the rim."""
    import cv2

    h, w = grey.shape
    r = RADIUS
    k = np.arange(-r, r + 1)
    disc = (k[:, None] ** 2 + k[None] ** 2 <= r * r).astype(np.float32)
    n = float(disc.sum())
    g = cv2.GaussianBlur(grey, (0, 0), 0.8)
    g = g - np.float32(g.mean())
    mean = cv2.filter2D(g, -1, disc / n)
    square = cv2.filter2D(g * g, -1, disc / n)
    inner = np.s_[r : h - r, r : w - r]
    products = g[inner] * g[inner]
    for dy in range(r + 1):
        for dx in range(-r, r + 1):
            if (dy == 0 and dx <= 0) or dy * dy + dx * dx > r * r:
                continue
            products += 2 * g[r + dy : h - r + dy, r + dx : w - r + dx] * g[r - dy : h - r - dy, r - dx : w - r - dx]
    s, contrast, roundness = (np.zeros_like(g) for _ in range(3))
    variance = np.maximum(square - mean * mean, 1e-6)
    s[inner] = (products / n - mean[inner] ** 2) / variance[inner]
    contrast[inner] = np.sqrt(variance[inner])
    gx, gy = cv2.Sobel(g, -1, 1, 0), cv2.Sobel(g, -1, 0, 1)
    xx, yy, xy = (cv2.filter2D(p, -1, disc / n)[inner] for p in (gx * gx, gy * gy, gx * gy))
    half, root = (xx + yy) / 2, np.sqrt(((xx - yy) / 2) ** 2 + xy * xy)
    roundness[inner] = (half - root) / np.maximum(half + root, 1e-6)
    return s, contrast, roundness
