"""Adjusted coordinates in the coordinate system of the control, beside those in the frame of the adjustment."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Role
from raybundle.io.geo.coordinate_systems import LocalFrame
from raybundle.numerics.arrays import Array


def map_table(adjustment: Adjustment, frame: LocalFrame) -> dict[str, Sequence[str] | Array]:
    """Stations and object points in the system of a frame, with standard deviations along its axes.

    Heights are of the kind that control had.  Standard deviations hold the scale and the convergence of the grid;
    what they do not hold is the error of a datum shift or of a geoid.
    """
    points, images, precision = adjustment.adjusted.points, adjustment.adjusted.images, adjustment.precision
    rows = np.flatnonzero(np.isfinite(points.xyz).all(axis=1))
    taken = np.flatnonzero(images.oriented)
    xyz = np.vstack([images.centre[taken], points.xyz[rows]])
    there = frame.crs_from_local(xyz)
    std = np.full(there.shape, np.nan)
    if precision is not None:
        C = np.concatenate([precision.images[taken, :3, :3], precision.object_points[rows]])
        std = np.sqrt(np.diagonal(frame.crs_covariance(there, C), axis1=1, axis2=2))
    roles = [Role(r).word for r in np.asarray(points.role)[rows].tolist()]
    columns: dict[str, Sequence[str] | Array] = {
        "kind": ["image"] * len(taken) + roles,
        "id": [*(images.ids[i] for i in taken), *(points.ids[i] for i in rows)],
    }
    for k, name in enumerate("XYZ"):
        columns[name] = there[:, k]
    for k, name in enumerate(("sX", "sY", "sZ")):
        columns[name] = std[:, k]
    return columns
