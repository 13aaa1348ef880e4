"""What a flight will determine, before it is flown: predicted precision, what is not determinable, what mends it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from raybundle.errors import Text, phrase
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.planning.flights.aerial import (
    NO_RTK,
    UNSOLVED,
    ControlTable,
    by_design,
    control_table,
    is_rtk,
    mended,
    precision,
)
from raybundle.planning.flights.uav_networks import Flight, flight_aerial

ENOUGH = 14
"""Tie points along a side that show what is determinable, and what control brings."""
SHOWN = 3.0
"""Tie points along the shorter side of a photograph"""
TILT = 30.0
"""Tilt of lines across that are proposed [deg]."""
HIGHER = 1.3
"""Times the height, lines across at another height that are proposed."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Forecast:
    """What one plan would give."""

    name: str
    plan: Flight
    photographs: int
    sigma_m: Array
    """(3,) a-priori standard deviations of the ground points X, Y, Z, root mean square; NaN where not determinable"""
    height_worst_m: float
    """Largest standard deviation of a height; NaN where not determinable"""
    std: Mapping[str, float]
    """Standard deviations of the free parameters that are determinable, in the units of their models"""
    std_level: Mapping[str, float]
    """The same where the flight is exactly level at one height"""
    lost: tuple[str, ...]
    """parameters that are not determinable"""
    lost_level: tuple[str, ...]
    """the same where the flight is exactly level at one height, so that no accident helps"""

    @property
    def sigma_c_px(self) -> float:
        """Of the camera constant; NaN where it is held or not determinable."""
        return self.std.get("c", float("nan")) / self.plan.camera.pixel_mm[0]

    @property
    def hanging(self) -> tuple[str, ...]:
        """Parameters that are not determinable, or by the unevenness of the flight alone."""
        return tuple(p for p in dict.fromkeys((*self.lost_level, *self.lost)) if p != UNSOLVED)

    @property
    def sure(self) -> bool:
        """Whether everything is determined by design and not by the unevenness of the flight alone."""
        return not self.lost and not self.lost_level


@dataclass(frozen=True, slots=True, kw_only=True)
class FlightPlan:
    """A plan, what it would be without RTK, and what would mend it."""

    planned: Forecast
    without_rtk: Forecast | None
    """Where positions are those of RTK: the plan with those that photographs have without; a lever arm is held"""
    remedies: tuple[Forecast, ...]
    """changes of the plan, those that cost nothing first"""

    @property
    def advised(self) -> Forecast | None:
        """The remedy that mends all that hangs, and keeps nearest to the best; None: there is none, or no need.

        Heights and each parameter that hangs count by how far a remedy's standard deviation stays behind the least
        that any such remedy gives; that remedy is taken whose farthest is nearest.
        """
        good = [] if self.planned.sure else [r for r in self.remedies if self.mends(r)]
        figures = np.array([[float(r.sigma_m[2]), *(r.std[p] for p in self.planned.hanging)] for r in good])
        return good[int((figures / figures.min(axis=0)).max(axis=1).argmin())] if good else None

    def mends(self, remedy: Forecast) -> bool:
        """Whether a remedy determines everything by design, and mends all that hangs (`aerial.mended`)."""
        before = {p: self.planned.std.get(p, float("inf")) for p in self.planned.hanging}
        return remedy.sure and all(mended(s, remedy.std_level[p], remedy.std[p]) for p, s in before.items())

    def gain(self, remedy: Forecast) -> float:
        """Times that heights of a remedy are as precise as planned; infinite where they were not determinable."""
        return _times(float(self.planned.sigma_m[2]), float(remedy.sigma_m[2]))

    def gains(self, remedy: Forecast) -> dict[str, float]:
        """The same of each parameter that hangs and that the remedy determines."""
        return {
            p: _times(self.planned.std.get(p, float("nan")), remedy.std[p])
            for p in self.planned.hanging
            if p in remedy.std
        }


def _times(before: float, after: float) -> float:
    return float(before / after) if np.isfinite(before) else float("inf")


def plan_flight(plan: Flight, progress: Progress = silent) -> FlightPlan:
    """The forecast of a plan, and of the changes that could mend what it leaves open.

    raises  NotSolvable as `forecast`
    """
    rtk = is_rtk(plan.station_sigma)
    plain = phrase("flight_change.without_rtk", lever_arm=plan.lever_arm)
    changes = [(phrase("flight_change.planned"), plan), (plain, without_rtk(plan))][: 1 + rtk] + _changes(plan)
    forecasts = list[Forecast]()
    for k, (name, changed) in enumerate(changes):
        progress(name, k / len(changes))
        forecasts.append(forecast(changed, name))
    return FlightPlan(
        planned=forecasts[0], without_rtk=forecasts[1] if rtk else None, remedies=tuple(forecasts[1 + rtk :])
    )


def without_rtk(plan: Flight) -> Flight:
    """The plan with positions of a plain receiver, beside whose errors a lever arm is of no account: it is held."""
    return replace(plan, station_sigma=NO_RTK, lever_arm=False)


def _changes(plan: Flight) -> list[tuple[Text, Flight]]:
    turned = not plan.alternating and plan.lines > 1
    across = replace(plan, cross_tilt_deg=TILT)
    known = replace(plan, control=1 if plan.control == 0 else plan.control)
    changes = [
        (phrase("flight_change.headings"), replace(plan, alternating=True), turned),
        (phrase("flight_change.control", n=1), known, plan.control == 0),
        (phrase("flight_change.control", n=5), replace(plan, control=5), plan.control < 5),
        (
            phrase("flight_change.across_higher", times=HIGHER), replace(plan, cross_height=HIGHER * plan.height),
            plan.cross_height is None and plan.cross_tilt_deg is None,
        ),
        (_across(), across, not _tilted(plan)),
        (_across(headings=True), replace(across, alternating=True), not _tilted(plan) and turned),
        (
            _across(control=1), replace(across, control=known.control),
            not _tilted(plan) and plan.control == 0 and plan.lever_arm,
        ),
        (
            _across(control=5), replace(across, control=5),
            not _tilted(plan) and plan.control < 5 and not is_rtk(plan.station_sigma),
        ),
    ]  # fmt: skip
    return [(name, changed) for name, changed, asked in changes if asked]


def _across(*, headings: bool = False, control: int = 0) -> Text:
    return phrase("flight_change.across_tilted", tilt_deg=TILT, headings=headings, control=control)


def _tilted(plan: Flight) -> bool:
    return plan.cross_tilt_deg is not None and abs(plan.cross_tilt_deg) >= TILT / 2


def forecast(plan: Flight, name: str = "") -> Forecast:
    """What a plan determines with the unevenness of a real flight, and exactly level at one height.

    raises  NotSolvable where the photographs see too little in common
    Limits: errors that all positions share, as of a wrong antenna height or geoid, are in no figure.
    """
    found = precision(flight_aerial(plan))
    even = replace(plan, height_jitter=0.0, angle_jitter_deg=0.0)
    lost_level, std_level = by_design(flight_aerial(even))
    return Forecast(
        name=name, plan=plan, photographs=found.photographs, sigma_m=found.sigma_m,
        height_worst_m=found.height_worst_m,
        std={p: s for p, s in found.std.items() if p not in found.lost}, lost=found.lost,
        std_level=std_level, lost_level=lost_level,
    )  # fmt: skip


def points_of(plan: Flight) -> int:
    """Tie points along the longer side of the ground of which each photograph shows some."""
    return math.ceil(SHOWN * max(plan.sides) / min(plan.footprint))


def _enough(plan: Flight) -> int:
    return min(plan.points, max(ENOUGH, points_of(plan)))


def flight_control(plan: Flight) -> ControlTable:
    """What control points bring to a flight, by number, standard deviation and place; with fewer tie points."""
    return control_table(flight_aerial(replace(plan, points=_enough(plan), control=0)))
