"""Tie points of a scene, by which a depth map knows where to look."""

from dataclasses import replace

import numpy as np

from raybundle.block import Observations, Points
from raybundle.surfaces.depths.pairs import Sources

CHOSEN = Sources(reference=0, sources=(1, 2, 3, 4), pairs=(), seen=1.0)


def robust(x):
    return np.median(np.abs(x)) / 0.6745


def with_tie_points(s):
    """The block of a scene, and points of the ground that its reference sees."""
    xy = np.stack(np.meshgrid(np.arange(10, 160, 20.0), np.arange(10, 120, 20.0)), axis=-1).reshape(-1, 2)
    t = s.t[xy[:, 1].astype(int), xy[:, 0].astype(int)]
    n = len(xy)
    points = Points(
        ids=tuple(str(k) for k in range(n)), role=np.zeros(n, np.int32), xyz=s.rays.points(xy, t),
        sigma=np.full((n, 3), np.nan),
    )  # fmt: skip
    observations = Observations(
        image=np.zeros(n, np.int32), point=np.arange(n, dtype=np.int32), xy_px=xy, cov_px2=np.tile([1.0, 1, 0], (n, 1))
    )
    return replace(s.block, points=points, observations=observations)
