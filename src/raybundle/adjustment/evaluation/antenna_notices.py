"""Shifts between control and the positions of photographs that the stated accuracy of the positions does not explain.

The shift is a parameter: whatever is common to all control, as a wrong base point, ends in it without a residual.
"""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment
from raybundle.block import Stations
from raybundle.numerics.arrays import Array
from raybundle.numerics.length_units import UNITS
from raybundle.numerics.statistics import chi_square_limit

LEVEL = 1e-3
"""Probability with which positions without a bias are reported."""
GEOID_M = 110.0
"""Largest distance of geoid and ellipsoid (EGM2008: -106 to 86 m): heights of two kinds differ by no more."""
SHIFTS = ("sx", "sy", "sz")


def shift_notices(result: Adjustment) -> list[Notice]:
    """A notice of each antenna with such a shift: a warning in plan, a note of heights that may count from the geoid.

    The standard deviation of a position is taken to be common to all of a flight: then the square of the shift, over
    the sum of its own covariance and the mean variance of the positions, is a chi-square.
    """
    block, found = result.adjusted, list[Notice]()
    stations = block.table(Stations)
    if stations.antenna is None:
        return found
    metre = UNITS.get(result.length_unit, 1.0)
    index = {c.id: k for k, c in enumerate(block.instruments)}
    for interior in result.interior:
        p = interior.parameters
        free = [s for s in SHIFTS if s in interior.free and p[s].std is not None]
        mine = stations.antenna == index.get(interior.camera, -1)
        if interior.camera not in index or not free or not mine.any():
            continue
        shift = np.array([p[s].value for s in SHIFTS])
        std = np.array([p[s].std or 0.0 for s in SHIFTS])
        total = std**2 + np.nanmean(stations.sigma[mine] ** 2, axis=0)
        plan = _beyond(shift[:2], total[:2]) and {"sx", "sy"} <= {*free}
        height = _beyond(shift[2:], total[2:]) and "sz" in free
        if not (plan or height):
            continue
        values = {
            "antenna": interior.camera, "plan": float(np.hypot(*shift[:2])), "height": float(shift[2]),
            "unit": result.length_unit, "sigma_plan": float(np.sqrt(total[:2].mean())),
            "sigma_height": float(np.sqrt(total[2])),
        }  # fmt: skip
        note = not plan and abs(shift[2]) * metre <= GEOID_M
        measured = Severity.NOTE if note else Severity.WARNING
        code = "positions_shifted" if plan else "positions_shifted.height"
        found.append(Notice(code=code, values=values, ids=(interior.camera,), measured=measured))
    return found


def _beyond(shift: Array, variance: Array) -> bool:
    return float((shift**2 / variance).sum()) > chi_square_limit(LEVEL, len(shift))
