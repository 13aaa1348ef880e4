"""What a flight will determine, before it is flown: predicted precision, what is not determinable, what mends it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.errors import NotSolvable
from raybundle.numerics.arrays import Array
from raybundle.planning.uav_networks import Flight, flight_block

ENOUGH = 14
"""Tie points along a side that tell what is determinable."""
UNSOLVED = "everything"
"""What an exactly level flight leaves open where it has no solution at all and nothing is named."""
TILT = 30.0
"""Tilt of lines across that are proposed [deg]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Forecast:
    """What one plan would give."""

    name: str
    plan: Flight
    photographs: int
    sigma_m: Array
    """(3,) a-priori standard deviations of the ground points X, Y, Z, root mean square; NaN where not determinable"""
    sigma_c_px: float
    """of the camera constant; NaN where it is held or not determinable"""
    lost: tuple[str, ...]
    """parameters that are not determinable"""
    lost_level: tuple[str, ...]
    """the same where the flight is exactly level at one height, so that no accident helps"""

    @property
    def sure(self) -> bool:
        """Whether everything is determined by design and not by the unevenness of the flight alone."""
        return not self.lost and not self.lost_level


@dataclass(frozen=True, slots=True, kw_only=True)
class FlightPlan:
    """A plan and what would mend it."""

    planned: Forecast
    remedies: tuple[Forecast, ...]
    """changes of the plan, the fewest photographs first"""

    @property
    def advised(self) -> Forecast | None:
        """The remedy that determines everything by design with the best heights; None: there is none, or no need."""
        good = [] if self.planned.sure else [r for r in self.remedies if r.sure]
        return min(good, key=lambda r: float(r.sigma_m[2])) if good else None


def plan_flight(plan: Flight) -> FlightPlan:
    """The forecast of a plan, and of the changes that could mend what it leaves open.

    raises  NotSolvable as `forecast`
    """
    changes = [
        ("headings alternate", replace(plan, alternating=True), not plan.alternating and plan.lines > 1),
        ("one control point in the middle", replace(plan, control=1), plan.control == 0),
        (f"lines across, tilted {TILT:g} deg", replace(plan, cross_tilt_deg=TILT), not _tilted(plan)),
        (
            f"headings alternate, lines across tilted {TILT:g} deg",
            replace(plan, alternating=True, cross_tilt_deg=TILT),
            not _tilted(plan) and not plan.alternating and plan.lines > 1,
        ),
    ]
    return FlightPlan(
        planned=forecast(plan), remedies=tuple(forecast(changed, name) for name, changed, asked in changes if asked)
    )


def _tilted(plan: Flight) -> bool:
    return plan.cross_tilt_deg is not None and abs(plan.cross_tilt_deg) >= TILT / 2


def forecast(plan: Flight, name: str = "as planned") -> Forecast:
    """Adjust a simulation of the plan twice: with the unevenness of a real flight, and exactly level at one height.

    raises  NotSolvable where the photographs see too little in common
    What it does not tell: errors that all positions share, as of a wrong antenna height or geoid, are in no figure.
    """
    options = AdjustmentOptions(threads=1)
    result = adjust_block(flight_block(plan), options)
    lost = _lost(result)
    even = replace(plan, height_jitter=0.0, angle_jitter_deg=0.0, points=min(plan.points, ENOUGH))
    try:
        level = _lost(adjust_block(flight_block(even), options))
    except NotSolvable as error:
        level = tuple(dict.fromkeys(u.symbol for u in error.undetermined if u.kind == "parameter")) or (UNSOLVED,)
    precision = result.precision
    assert precision is not None
    c = result.interior[0].parameters.get("c")
    std = None if c is None or "c" in lost else c.std
    rms = np.sqrt(np.nanmean((precision.object_point_std / result.sigma0) ** 2, axis=0))
    return Forecast(
        name=name,
        plan=plan,
        photographs=len(result.given.images),
        sigma_m=np.full(3, np.nan) if lost else rms,
        sigma_c_px=std / result.sigma0 / plan.camera.pixel_mm[0] if std else float("nan"),
        lost=lost,
        lost_level=level,
    )


def _lost(result: Adjustment) -> tuple[str, ...]:
    return tuple(name.split()[0] for name in result.not_determinable)
