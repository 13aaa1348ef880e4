"""Accuracy against check points, and of control that had taken no part."""

from __future__ import annotations

from typing import Any

import numpy as np

from raybundle.adjustment.check_points import check_differences
from raybundle.adjustment.result import Adjustment
from raybundle.numerics.arrays import Array

ENOUGH = 30
"""Check points that ASPRS (2023) asks for."""


def levelled(a: Adjustment) -> frozenset[str]:
    """Names of the control points whose heights only level the block: nobody gave them."""
    return frozenset(name for n in a.notices if n.code == "levelled" for name in n.ids)


def accuracy(result: Adjustment) -> dict[str, Any]:
    """Accuracy against check points in the sense of ASPRS (2023), and leave-one-out differences of the control.

    RMSE_H and RMSE_V combine the differences at the check points with the accuracy of the check points themselves;
    at least 30 check points are asked for there.  Leave-one-out: adjusted minus given of a control coordinate had it
    taken no part, v / r (to first order, one coordinate at a time).
    """
    found: dict[str, Any] = {}
    check, d = check_differences(result)
    s = result.given.points.sigma[check]
    plan = np.isfinite(d[:, :2]).all(axis=1)
    high = np.isfinite(d[:, 2])
    if plan.any():
        own = float(np.sqrt(np.nanmean(np.nan_to_num(s[plan, :2]) ** 2) * 2))
        rmse = float(np.sqrt((d[plan, :2] ** 2).sum(axis=1).mean()))
        found["asprs"] = {
            "check_points_horizontal": int(plan.sum()), "rmse_h": float(np.hypot(rmse, own)),
            "check_points_vertical": int(high.sum()),
            "rmse_v": _vertical(d[high, 2], s[high, 2]) if high.any() else None, "enough": bool(plan.sum() >= ENOUGH),
        }  # fmt: skip
    invented = levelled(result)
    for group in result.groups:
        if group.kind != "control":
            continue
        r = np.asarray(group.redundancy, float)
        with np.errstate(all="ignore"):
            left_out = np.where(r > 1e-6, np.asarray(group.residual) / r, np.nan)
        found["leave_one_out"] = [
            {"point": name, "coordinate": axis, "difference": float(value)}
            for name, axis, value in zip(group.ids, group.component, left_out, strict=True)
            if not (name in invented and axis == "Z")
        ]
    return found


def _vertical(d: Array, s: Array) -> float:
    return float(np.hypot(np.sqrt((d**2).mean()), np.sqrt((np.nan_to_num(s) ** 2).mean())))
