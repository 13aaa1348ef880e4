"""What a client gets beside the adjustment: who it is for, in which system, whether it is as good as was asked for."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from raybundle.adjustment.blunders.accuracy import Accuracy, Axes, ObjectAxes
from raybundle.adjustment.blunders.accuracy_class import AccuracyClass, Judged, all_kept, judged
from raybundle.planning.flights.record import Flight, flight_of
from raybundle.report.outcome import Outcome
from raybundle.report.text.accuracy_words import accuracy_outcome, asprs_statements
from raybundle.results.record import Record

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
    from raybundle.io.geo.coordinate_systems import LocalFrame


@dataclass(frozen=True, slots=True, kw_only=True)
class Delivery:
    """A result as it is handed over."""

    accuracy: Accuracy
    record: Record = field(default_factory=Record)
    frame: LocalFrame | None = None
    """coordinate system in which the result stands; None: one of its own"""
    flight: Flight | None = None
    """what was flown; None: no flight"""
    wanted: AccuracyClass | None = None
    judged: tuple[Judged, ...] = ()
    outcomes: tuple[Outcome, ...] = ()
    """of all that was asked for"""
    findings: tuple[object, ...] = ()
    """what else was found with the points of the result, each given by a chapter: a best fit, a length test"""
    files: tuple[str, ...] = ()
    """names of what stands beside the report"""
    pictures: Mapping[str, Path] = field(default_factory=dict[str, Path])
    """file of an image in the block -> where the photograph is"""
    surface: str = ""
    """where the page of dense points stands that were measured of an earlier result in its place; empty: nowhere"""

    @property
    def heights(self) -> bool:
        """Whether any height was given, by control, positions or a check point: else those of a map are relative."""
        if self.frame is None:
            return True
        given = (self.accuracy.control.given, self.accuracy.check.given)
        stations = self.accuracy.result.given.stations
        return any(np.isfinite(g[:, 2]).any() for g in given) or bool(np.isfinite(stations.xyz[:, 2]).any())

    @property
    def statements(self) -> tuple[str, ...]:
        """Those of ASPRS, where a class of it is wanted."""
        return asprs_statements(self.judged) if self.wanted is not None and self.wanted.asprs else ()

    def as_mapping(self) -> dict[str, object]:
        """What result.json states beside the adjustment."""
        found: dict[str, object] = dict(self.accuracy.as_mapping())
        if self.record.as_mapping():
            found["record"] = self.record.as_mapping()
        if self.flight is not None:
            found["flight"] = asdict(self.flight)
        if self.wanted is not None:
            found["accuracy_class"] = {
                "asprs": self.wanted.asprs,
                "kept": all_kept(self.judged),
                "parts": [_plain(asdict(j)) for j in self.judged],
                "statements": list(self.statements),
            }
        return found


def _plain(values: dict[str, object]) -> dict[str, object]:
    return {k: None if isinstance(v, float) and not math.isfinite(v) else v for k, v in values.items()}


def wanted_outcome(
    adjustment: Adjustment, wanted: AccuracyClass | None, frame: LocalFrame | None = None
) -> Outcome | None:
    """What became of a wanted accuracy, as the report states; None where none is wanted."""
    return None if wanted is None else delivery_of(adjustment, frame=frame, wanted=wanted).outcomes[0]


def delivery_of(
    adjustment: Adjustment, *, frame: LocalFrame | None = None, wanted: AccuracyClass | None = None,
    record: Record | None = None, outcomes: tuple[Outcome, ...] = (), findings: tuple[object, ...] = (),
) -> Delivery:  # fmt: skip
    """What is handed over of an adjustment.

    frame     the coordinate system in which its local frame stands
    wanted    accuracy that is asked for
    outcomes  of what else was asked for
    findings  what else was found, as in `Delivery`
    """
    axes: Axes = ObjectAxes()
    if frame is not None:
        from raybundle.report.map_axes import MapAxes

        axes = MapAxes(frame=frame)
    flight = None
    if not adjustment.datum_defect or frame is not None:
        used = adjustment.image_observations.used
        flight = flight_of(adjustment.adjusted, used, on_the_earth=frame is not None)
    accuracy = Accuracy(adjustment, axes, math.nan if flight is None else flight.area_one_m2 / 1e6)
    made = Delivery(
        accuracy=accuracy, record=record or Record(), frame=frame, flight=flight, wanted=wanted, outcomes=outcomes,
        findings=findings,
    )  # fmt: skip
    if wanted is None:
        return made
    parts = judged(accuracy, wanted, heights=made.heights)
    return replace(made, judged=parts, outcomes=(accuracy_outcome(parts, wanted), *outcomes))
