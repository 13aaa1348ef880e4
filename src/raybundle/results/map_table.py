"""Adjusted coordinates in the coordinate system of the control, beside those in the frame of the adjustment."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raybundle.adjustment.blunders.accuracy import Compared
from raybundle.adjustment.result import Adjustment
from raybundle.block import Role
from raybundle.io.digits import EVERY, STD, Digits, brought, by_sigma, in_network, jointly
from raybundle.io.geo.coordinate_systems import LocalFrame
from raybundle.io.geo.parsed_systems import system_name
from raybundle.numerics.arrays import Array

Columns = dict[str, Sequence[str] | Array]


def map_table(adjustment: Adjustment, frame: LocalFrame) -> tuple[Columns, dict[str, Digits]]:
    """Stations and object points in the system of a frame, with standard deviations along its axes; and their digits.

    Heights are of the kind that control had.  Standard deviations hold the scale and the convergence of the grid;
    what they do not hold is the error of a datum shift or of a geoid.
    """
    points, images, precision = adjustment.adjusted.points, adjustment.adjusted.images, adjustment.precision
    rows = np.flatnonzero(np.isfinite(points.xyz).all(axis=1))
    taken = np.flatnonzero(images.oriented)
    xyz = np.vstack([images.centre[taken], points.xyz[rows]])
    there = frame.crs_from_local(xyz)
    std = np.full(there.shape, np.nan)
    digits: dict[str, Digits] = {**dict.fromkeys("XYZ", EVERY), **dict.fromkeys(("sX", "sY", "sZ"), STD)}
    if precision is not None:
        C = np.concatenate([precision.images[taken, :3, :3], precision.object_points[rows]])
        C = frame.crs_covariance(there, C)
        std = np.sqrt(np.diagonal(C, axis1=1, axis2=2))
        digits |= dict(zip("XYZ", in_network(jointly(C), there), strict=True))
    roles = [Role(r).word for r in np.asarray(points.role)[rows].tolist()]
    columns: Columns = {
        "kind": ["image"] * len(taken) + roles,
        "id": [*(images.ids[i] for i in taken), *(points.ids[i] for i in rows)],
    }
    for k, name in enumerate("XYZ"):
        columns[name] = there[:, k]
    for k, name in enumerate(("sX", "sY", "sZ")):
        columns[name] = std[:, k]
    return columns, digits


def map_control_table(
    adjustment: Adjustment, frame: LocalFrame, compared: Sequence[tuple[str, Compared]]
) -> tuple[Columns, dict[str, Digits]]:  # fmt: skip
    """Given control and check points in the system of a frame, and adjusted minus given along its axes; their digits.

    compared  each role with its points: coordinates in the system, differences in metres
    """
    roles = [role for role, c in compared for _ in c.rows]
    rows = [int(k) for _, c in compared for k in c.rows]
    given = np.vstack([np.zeros((0, 3)), *(c.given for _, c in compared)])
    difference = np.vstack([np.zeros((0, 3)), *(c.difference for _, c in compared)])
    columns: Columns = {
        "point": [adjustment.given.points.ids[k] for k in rows], "role": roles,
    }  # fmt: skip
    for k, name in enumerate("XYZ"):
        columns[name] = given[:, k]
    for k, name in enumerate(("dE_m", "dN_m", "dh_m")):
        columns[name] = difference[:, k]
    columns["system"] = [system_name(frame.crs)] * len(rows)
    std = np.zeros(given.shape) if adjustment.precision is None else adjustment.precision.object_point_std[rows]
    sigma = np.vstack([np.zeros((0, 3)), *(c.sigma for _, c in compared)])
    both = np.hypot(np.nan_to_num(std), np.nan_to_num(sigma))
    named = zip(("dE_m", "dN_m", "dh_m"), both.T, strict=True)
    plan, height = frame.units_m
    least = (brought(len(rows), unit) for unit in (plan, plan, height))
    return columns, {**dict(zip("XYZ", least, strict=True)), **{n: by_sigma(s) for n, s in named}}
