"""Far object points: their steps, and those whose rays diverge.

Nearer, the same linear step is taken along the ray by inverse distance (Montiel, Civera and Davison 2006): a point
never passes through its camera.  Farther, it is taken as it is: a point never passes infinity, behind which the
collinearity equations go on with a mirror image that no camera sees.  Where rays diverge, by errors of measurement or
a wrong match, the best inverse distance is negative; such a point runs away by orders of magnitude, and soon nothing
hangs on it.  At first points may pass infinity: far ones come to their place sooner; see `solve`.
"""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array, Index

FARTHEST = 1e6
"""Distance, in medians of the block, beyond which rays are stated to diverge.

The parallax over a base of one median is then 1e-6 radians, a hundredth of a pixel at c = 10 000 pixels: less than the
best targets are measured to, so no point is determined there.
"""
FAR = 10.0
"""Distance, in medians of the block, at which such a point begins."""
SMALL = 0.02
"""Relative change of the distance up to which both kinds of step are one."""


def retracted(ray: Array, step: Array, *, passing: bool = False) -> tuple[Index, Array]:
    """Points at `ray` (n, 3) from a projection centre that a linear step (n, 3) moves otherwise than straight on.

    passing  points farther off, too, move by inverse distance, and may pass infinity
    returns  which (k,), and their new rays (k, 3) from the old projection centre
    """
    d2 = np.einsum("ij,ij->i", ray, ray)
    along = np.einsum("ij,ij->i", ray, step) / np.maximum(d2, 1e-300)
    which = np.flatnonzero(np.abs(along) > SMALL if passing else along < -SMALL)
    r, part = ray[which], along[which, None]
    shrink = 1 - part
    shrink = np.where(np.abs(shrink) < 1e-3, np.copysign(1e-3, shrink), shrink)
    return which, (r + step[which] - part * r) / shrink


def turned_about(ray: Array, typical: float) -> Array:
    """Rays (n, 3) to points behind all their cameras, turned to before them: the same image points, `FAR` away.

    A negative inverse distance becomes a small positive one; the iteration finds which.  Nearer, at a `typical`
    distance, a point would lie behind others of its cameras.
    """
    return -ray * (FAR * typical / np.maximum(np.linalg.norm(ray, axis=1), 1e-300))[:, None]


def diverging(ray: Array, typical: float | None = None) -> Index:
    """Which rays (n, 3), from a projection centre to a point, end where they can only diverge from the others.

    typical  length of rays; None: the median of these
    """
    distance = np.linalg.norm(ray, axis=1)
    if not len(ray):
        return np.zeros(0, np.int64)
    return np.flatnonzero(distance > FARTHEST * (np.median(distance) if typical is None else typical))
