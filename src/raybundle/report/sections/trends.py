"""Section of `epochs`: velocities and accelerations of what moved, from three dates on."""

from __future__ import annotations

import numpy as np

from raybundle.errors import phrase
from raybundle.metrology.trends import YEAR, Trends
from raybundle.numerics.arrays import Array
from raybundle.report.chapters import Occasion, chapter
from raybundle.report.figures.time_series import displacement_over_time
from raybundle.report.parts import Figure, Figures, Part, Section, number, table, text, whole
from raybundle.report.sections.metrology import finding
from raybundle.report.text.numbers import cells, column_decimals, probability

MM = 1000.0
DRAWN = 6
"""Trends with a figure: areas first, then the fastest points"""


@chapter("velocities", after="displacements")
def velocities(o: Occasion) -> tuple[Section, ...]:
    """How fast what moved is, and whether it is steady."""
    found = finding(o, Trends)
    if found is None or not found.trends or o.view.adjustment.free_scale:
        return ()
    made = sorted(found.trends, key=lambda t: (not t.series.area, -float(np.linalg.norm(t.velocity))))
    figures = tuple(
        Figure(
            drawing=displacement_over_time(t, t.verdict(found.limit)),
            caption=phrase(
                "report_trends.figure", name=t.series.name, first=found.dates[t.series.first],
                last=found.dates[t.series.dates[-1]], verdict=t.verdict(found.limit),
            ),
        )
        for t in made[:DRAWN]
    )  # fmt: skip
    speed = np.array([_length(t.velocity, t.velocity_covariance) for t in made]) * MM * YEAR
    faster = np.array([_length(t.acceleration, t.acceleration_covariance) for t in made]) * MM * YEAR**2
    body = table(
        (
            whole(phrase("label.point")), number(phrase("report_trends.velocity"), "mm/a"),
            number(phrase("label.sigma"), "mm/a"), number(phrase("report_trends.acceleration"), "mm/a²"),
            number(phrase("label.sigma"), "mm/a²"), number("p"), text(phrase("report_trends.motion")),
        ),
        (
            [t.series.name for t in made], *_columns(speed), *_columns(faster),
            [probability(t.p_constant) for t in made],
            [phrase("report_trends.motion_of", verdict=t.verdict(found.limit)) for t in made],
        ),
        note=phrase("report_trends.note", limit=found.limit), rest="velocities.csv",
    )  # fmt: skip
    parts: list[Part] = [Figures(figures=figures), body]
    return (Section(anchor="velocities", title=phrase("report_trends.title"), parts=tuple(parts)),)


def _length(vector: Array, covariance: Array) -> tuple[float, float]:
    """The length of a vector and its standard deviation along it."""
    length = float(np.linalg.norm(vector))
    way = vector / max(length, 1e-300)
    return length, float(np.sqrt(max(float(way @ covariance @ way), 0.0)))


def _columns(values: Array) -> tuple[list[str], list[str]]:
    """Values and standard deviations (n, 2) as columns."""
    fine = column_decimals(values[:, 1])
    return cells(values[:, 0].tolist(), fine), cells(values[:, 1].tolist(), fine)
