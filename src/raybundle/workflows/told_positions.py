"""Positions that fit far better than stated: what that says, and what it does not."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.adjustment.result import Adjustment, Notice
from raybundle.io.photos.cameras import CameraGroup
from raybundle.numerics.statistics import chi_square_tails

ALPHA = 1e-3
"""Probability by chance of residuals so small, below which the positions are relatively more precise than stated."""
FEWEST = 6.0
"""Redundancy of the positions from which on that is asked."""
DIRECTIONS = (("in plan", ("X", "Y")), ("in height", ("Z",)))


def with_relative_precision(result: Adjustment) -> Adjustment:
    """The result with a word where the residuals of positions are significantly smaller than their sigma.

    A receiver's errors change slowly: neighbouring positions have them in common, and residuals after the adjustment
    show what differs alone.  What was stated stays the standard deviation of where the whole block is.
    """
    g = next((g for g in result.groups if g.kind == "station"), None)
    if g is None:
        return result
    told: list[str] = []
    for where, axes in DIRECTIONS:
        rows = np.isin(np.array(g.component), axes) & (g.sigma > 0) & np.isfinite(g.redundancy)
        r = float(g.redundancy[rows].sum())
        square = float(((g.residual[rows] / g.sigma[rows]) ** 2).sum())
        if r < FEWEST or chi_square_tails(square, r)[0] > ALPHA:
            continue
        stated = float(np.median(g.sigma[rows]))
        told.append(f"{stated * np.sqrt(square / r):.2g} m {where}, where {stated:.2g} m are stated or assumed")
    if not told:
        return result
    message = (
        f"the precision of the positions relative to each other is {' and '.join(told)}. The standard deviations "
        "stated hold for the shift that all positions have in common: residuals do not show it, and coordinates carry "
        "it. Control points would tell it"
    )
    return replace(result, notices=(*result.notices, Notice(code="relative_positions", message=message)))


def camera_notices(groups: Sequence[CameraGroup]) -> list[Notice]:
    """What metadata leave open of the cameras, and what was joined; one notice where several say the same."""
    told: dict[tuple[str, str], list[CameraGroup]] = {}
    for g in groups:
        for code, remarks in (("camera", g.remarks), ("camera_joined", g.joined)):
            for remark in remarks:
                told.setdefault((code, remark), []).append(g)
    found: list[Notice] = []
    for (code, remark), same in told.items():
        ids = tuple(g.id for g in same)
        n = sum(len(g.photos) for g in same)
        who = f"camera {ids[0]}" if len(ids) == 1 else f"{n} photographs (cameras {', '.join(ids)})"
        found.append(Notice(code=code, message=f"{who}: {remark}", ids=ids))
    return found
