"""The vertical by plumb edges: planes of straight edges and projection centres that meet in one direction.

A straight edge and a projection centre span a plane; the planes of all plumb edges hold the vertical.  Whether there
are plumb edges at all is asked first, a contrario (Desolneux, Moisan, Morel 2000): of the edges whose planes pass the
prior vertical within a cone, by chance a share p = e / cone passes a given direction in it within e.  A bundle counts
when so many edges meet by chance less than once in a thousand sets of photographs, all directions tried considered
(number of false alarms).  The same edge of a building stands in many photographs: what counts are edges of an average
photograph, not of all.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array, Mask

CONE = 3.72
"""Standard deviations of the prior, in each of its two components, within which the vertical lies with a probability of
0.999 (root of chi-square with two degrees of freedom)."""
NEAREST = np.radians([0.25, 0.5, 1.0])
"""Distances e that are tried: edges are plumb to some tenths of a degree (DIN 18202: 8 mm in 3 m)."""
FALSE_ALARMS = 1e-3
"""Expected number of bundles by chance up to which one is believed."""
LEAN = np.radians(0.15)
"""Standard deviation of an edge that is meant to be plumb: a third of what DIN 18202 allows, 8 mm in 1 m."""
TUKEY = 4.685
"""Standardised distance beyond which an edge has no weight (Tukey's biweight, 95 % efficient on the normal law)."""
ROUNDS = 20
MOST_PAIRS = 4000


@dataclass(frozen=True, slots=True, kw_only=True)
class PlumbEdges:
    """The vertical that edges meet in."""

    up: Array
    """(3,) unit vector"""
    sigma: float
    """Standard deviation of its less determined component [rad]"""
    edges: int
    """Edges that meet in it"""
    photographs: int
    """Photographs that have one of them"""
    false_alarms: float
    """Bundles as large expected by chance"""


def plumb_vertical(normals: Array, sigma: Array, image: Array, prior: Array, prior_sigma: float) -> PlumbEdges | None:
    """The vertical by the normals of planes through edges; None where no more meet than by chance.

    normals      (n, 3) unit normals in object space; sigma  (n,) of their angle from measurement [rad]
    image        (n,) photographs in which the edges were seen
    prior        (3,) vertical, known to `prior_sigma` [rad] in each component
    The standard deviation is that of the prior and the edges together; edges scatter as they do, and those of different
    photographs count as seen once by an average photograph.  Limits: a building that leans as a whole.
    """
    cone = CONE * prior_sigma
    near = np.abs(normals @ prior) < np.sin(cone)
    normals, sigma, image = normals[near], sigma[near], image[near]
    views = len(np.unique(image))
    if len(normals) < 3 * max(views, 1):
        return None
    u, v = _tangents(prior)
    # the plane with normal n passes prior + a u + b v where n.u a + n.v b = - n.prior
    across = np.stack([normals @ u, normals @ v], axis=1)
    length = np.linalg.norm(across, axis=1)
    across, offset = across / length[:, None], -(normals @ prior) / length
    best, alarms = _largest_bundle(across, offset, cone, views)
    if best is None or alarms > FALSE_ALARMS:
        return None
    s = np.hypot(sigma, LEAN)
    at, scale, N = best, 1.0, np.eye(2) / prior_sigma**2
    for _ in range(ROUNDS):
        r = (across @ at - offset) / s
        held = np.abs(r) < TUKEY * max(scale, 1.0)
        scale = float(np.median(np.abs(r[held])) / 0.6745) if held.any() else 1.0
        w = _biweight(r / max(scale, 1.0)) / (s * max(scale, 1.0)) ** 2 / views
        N = (across * w[:, None]).T @ across + np.eye(2) / prior_sigma**2
        new = np.linalg.solve(N, across.T @ (w * offset))
        done = np.abs(new - at).max() < 1e-7
        at = new
        if done:
            break
    r = (across @ at - offset) / s
    meet = np.abs(r) < 2.58 * max(scale, 1.0)
    up = prior + at[0] * u + at[1] * v
    spread = float(np.sqrt(np.linalg.eigvalsh(np.linalg.inv(N))[1]))
    return PlumbEdges(
        up=up / np.linalg.norm(up), sigma=spread, edges=int(meet.sum()), photographs=len(np.unique(image[meet])),
        false_alarms=alarms,
    )  # fmt: skip


def _largest_bundle(across: Array, offset: Array, cone: float, views: int) -> tuple[Array | None, float]:
    """Where most lines (n, 2), (n,) of a plane meet, and the number of false alarms of that bundle."""
    from scipy.special import bdtrc

    n = len(offset)
    rng = np.random.default_rng(1)
    i, j = (rng.integers(n, size=MOST_PAIRS) for _ in range(2))
    det = across[i, 0] * across[j, 1] - across[i, 1] * across[j, 0]
    good = np.abs(det) > np.sin(np.radians(2))
    i, j, det = i[good], j[good], det[good]
    places = np.stack(
        [offset[i] * across[j, 1] - offset[j] * across[i, 1], across[i, 0] * offset[j] - across[j, 0] * offset[i]],
        axis=1,
    ) / det[:, None]  # fmt: skip
    # edges that are all parallel in the pictures meet nowhere in particular: nearest to the prior
    foot = across * offset[:, None]
    places = np.concatenate([places, foot[rng.integers(n, size=min(n, MOST_PAIRS // 10))]])
    places = places[np.hypot(*places.T) < cone]
    if not len(places):
        return None, np.inf
    distance = np.abs(places @ across.T - offset)
    best, least = None, np.inf
    each = n / views
    tests = len(NEAREST) * max(each * (each - 1) / 2, 1.0)
    for e in NEAREST[cone / 2 > NEAREST]:
        count = (distance < e).sum(axis=1)
        k = int(count.argmax())
        met = max(int(count[k] / views) - 2, 0)
        alarms = float(tests * bdtrc(met - 1, max(int(each) - 2, met), e / cone)) if met > 0 else np.inf
        if alarms < least:
            best, least = places[k], alarms
    return best, least


def _biweight(r: Array) -> Array:
    inside: Mask = np.abs(r) < TUKEY
    return np.where(inside, (1 - (r / TUKEY) ** 2) ** 2, 0.0)


def _tangents(z: Array) -> tuple[Array, Array]:
    u = np.cross(z, np.eye(3)[np.abs(z).argmin()])
    u = u / np.linalg.norm(u)
    return u, np.cross(z, u)
