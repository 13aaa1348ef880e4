"""`raybundle heights time-series`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, facts, significant
from raybundle.cli.heights.words import free_scale, measured, two_digits
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.heights.time_series import HeightsTimeSeriesSettings, run_time_series
from raybundle.errors import Message, Severity, note
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.heights.time_series import MeasuredTimeSeries
    from raybundle.surfaces.heights.time_series import Change

SHOWN = 5
"""Regions that a terminal shows; the rest stands in the files"""


@click.command("time-series", cls=Command)
@click.argument("sources", type=FOLDER, metavar="SURFACE...", nargs=-1)
@options_of(HeightsTimeSeriesSettings, out=NEW_FOLDER)
def command(sources: tuple[Path, ...], **given: Any) -> None:
    """Compute volumes of regions at several dates, and test what changed between them.

    SURFACE are two surfaces or more in one frame, the earliest first. Each region has a volume at each date; each
    interval has net change, fill and cut, with standard deviations by the joint covariance of all dates. A change below
    its level of detection is not reported as a change. FOLDER gets volumes.csv, changes.csv, volumes.json (with
    covariances), volumes.svg and .png, regions.geojson and regions.gpkg.

    \b
    Example:
      raybundle heights time-series may/surface june/surface july/surface --outline piles.geojson --out growth
      raybundle heights time-series may/surface october/surface --outline heap.kml --date 2026-05-02 --date 2026-10-09
    """
    asked = {"sources": sources, **values_of(HeightsTimeSeriesSettings, given)}
    found = run_time_series(made(HeightsTimeSeriesSettings, asked))
    facts(**found.series.as_mapping(), files=[str(f) for f in found.files])
    report(_summary(found))


def _summary(found: MeasuredTimeSeries) -> Summary:
    """What the command reports."""
    s = found.series
    done, more = list[Message](), list[Message]()
    for r, t in zip(s.regions, s.rates, strict=True):
        last = measured(float(r.volumes[-1]), float(r.sigma[-1]), s.unit, 3)
        total = _change(r.changes[-1], s.dates, s.unit)
        done.append(note("heights.series_region", name=r.name, volume=last, **total))
        for c in r.changes:
            ends: dict[str, Any] = {"start": s.dates[c.begin], "end": s.dates[c.end]}
            fill, cut = (measured(q.value, q.sigma, s.unit, 3) for q in (c.fill, c.cut))
            more += [
                note("heights.series_change", name=r.name, end=ends["end"], **_change(c, s.dates, s.unit)),
                note("heights.series_parts", name=r.name, fill=fill, cut=cut, **ends),
            ]
        if t is not None:
            sigma = float(t.velocity_covariance[0, 0]) ** 0.5
            more.append(note("heights.series_rate", name=r.name, p=t.p_constant,
                             rate=measured(float(t.velocity[0]), sigma, s.unit, 3)))  # fmt: skip
    changes = [c for r in s.regions for c in r.changes]
    return Summary(
        done=[
            note("heights.series", n=sum(c.significant(c.net) for c in changes), total=len(changes),
                 significance=s.significance), *done[:SHOWN], *free_scale(s.unit),
        ],
        details=[*done[SHOWN:], *more], files=found.files,
        notices=[*of_texts(found.cautions, Severity.WARNING),
                 note("heights.series_orientations", common=s.orientations)],
    )  # fmt: skip


def _change(c: Change, dates: tuple[str, ...], unit: str) -> dict[str, Any]:
    """What a sentence takes of a change."""
    parts = [name for name, q in (("fill", c.fill), ("cut", c.cut)) if c.significant(q)]
    return {
        "start": dates[c.begin], "change": measured(c.net.value, c.net.sigma, unit, 3),
        "significant": c.significant(c.net), "detectable": two_digits(c.detectable), "unit": unit or "none",
        "parts": "both" if len(parts) == 2 else (*parts, "none")[0], "fill": significant(c.fill.value, 3),
        "cut": significant(c.cut.value, 3),
    }  # fmt: skip
