"""How far a place of an orthophoto may be off in plan: by the height at which its ray was met, and by orientation.

A pixel shows what lies on its ray where the ray meets the surface.  Heights that are too large by e move what it shows
by e times the tangent of the ray's angle, more on ground that slopes away from the viewer, as the ray meets that later.
Orientation moves the ray and the heights together; what both share does not displace one against the other.
"""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array

GRAZING = 0.15
"""Least sine-like factor 1 - slope . tangent: what a ray all but slides along is not seen well anyway."""


def gram(ray: Array, height: Array) -> Array:
    """(4, 4) products of how a ray moves at its depth (3, q) and the height there (q,) with each independent error.

    ray  to the right, upwards and along the normal of the plane
    """
    all_ = np.vstack([ray, height[None]])
    return all_ @ all_.T


def displacement(tangent: Array, slope: Array, local: Array, G: Array) -> Array:
    """Standard deviations (n, 2) of places to the right and upwards, in the unit of the heights.

    tangent  (n, 2) right and up per unit of height along the ray, towards the viewer
    slope    (n, 2) rise of the surface to the right and upwards
    local    (n,) standard deviation of the height by noise and roughness
    G        (n, 4, 4) of `gram`

    With a ray that moves by a = (a_u, a_v, a_h) and heights that move by m + e, the ray meets the surface s further,
    s (1 - g t) = a_h - g a_uv - m - e, and what a pixel shows lies off by a_uv - t s.
    """
    along = np.maximum(1 - (slope * tangent).sum(axis=1), GRAZING)
    found = np.zeros((len(tangent), 2))
    for k in range(2):
        t = tangent[:, k] / along
        c = np.stack([t * slope[:, 0], t * slope[:, 1], -t, t], axis=1)
        c[:, k] += 1.0
        found[:, k] = np.sqrt(np.maximum(np.einsum("ni,nij,nj->n", c, G, c), 0) + (t * local) ** 2)
    return found
