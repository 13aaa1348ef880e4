"""Volumes of several dates as files: tables, the covariance of all, outlines of the regions, a picture."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import date
from html import escape
from pathlib import Path
from typing import Any, Literal

import numpy as np

from raybundle.errors import phrase
from raybundle.io.drawings import Drawn, write_geojson, write_gpkg
from raybundle.io.folders import new_folder
from raybundle.metrology.trends import Trend
from raybundle.numerics.arrays import Array
from raybundle.surfaces.files.drawing_pixels import write_png
from raybundle.surfaces.files.drawings import (
    BAND,
    BOTTOM,
    LEFT,
    PANEL,
    RIGHT,
    TOP,
    WIDTH,
    Frame,
    level_lines,
    points,
    sheet,
)  # fmt: skip
from raybundle.surfaces.files.input import Opened
from raybundle.surfaces.heights.height_model import HeightModel, SumOfHeights
from raybundle.surfaces.heights.time_series import Change, RegionSeries, probability, rates

VOLUMES, CHANGES, ALL, LINES, LAYER, DRAWING, PICTURE = (
    "volumes.csv", "changes.csv", "volumes.json", "regions.geojson", "regions.gpkg", "volumes.svg", "volumes.png"
)  # fmt: skip
LABEL_PX = 76
"""Width of a date below a picture"""
Orientations = Literal["known", "unknown", "independent"]


@dataclass(frozen=True, slots=True, kw_only=True)
class DatedVolumes:
    """Volumes of regions at several dates."""

    regions: tuple[RegionSeries, ...]
    """the last of several is all of them together, unless they overlap"""
    dates: tuple[str, ...]
    """YYYY-MM-DD, or numbers of the surfaces where there are none"""
    rates: tuple[Trend | None, ...]
    """of each region, by three dates or more"""
    significance: float
    unit: str
    orientations: Orientations
    """of one adjustment, "known": what dates have in common counts once; else they are taken as independent"""

    @classmethod
    def of(
        cls, regions: tuple[RegionSeries, ...], dates: tuple[str, ...], models: Sequence[HeightModel], *, unit: str,
        significance: float,
    ) -> DatedVolumes:  # fmt: skip
        """Of the surfaces of all dates; dates are empty where they are not known."""
        adjustments, errors = {m.adjustment for m in models}, {m.errors for m in models}
        orientations: Orientations = "independent"
        if len(adjustments) == 1 and "" not in adjustments:
            orientations = "known" if len(errors) == 1 and "" not in errors else "unknown"
        days = np.array([date.fromisoformat(d).toordinal() for d in dates], float)
        return cls(
            regions=regions, dates=dates or tuple(str(k + 1) for k in range(len(models))), rates=rates(regions, days),
            significance=significance, unit=unit, orientations=orientations,
        )  # fmt: skip

    def as_mapping(self) -> dict[str, Any]:
        """All numbers, the covariances of volumes with them."""
        return {
            "unit": self.unit, "significance": self.significance, "orientations": self.orientations,
            "dates": list(self.dates),
            "regions": [
                {
                    "name": r.name, "plan_area": r.plan_area, "volume": r.volumes.tolist(),
                    "sigma": r.sigma.tolist(), "covariance": r.covariance.tolist(), "filled": r.filled.tolist(),
                    "changes": [self._change(c) for c in r.changes], **({} if t is None else {"rate": _rate(t)}),
                }
                for r, t in zip(self.regions, self.rates, strict=True)
            ],
        }  # fmt: skip

    def _change(self, c: Change) -> dict[str, Any]:
        def about(of: SumOfHeights) -> dict[str, Any]:
            return {
                "value": of.value, "sigma": of.sigma, "sigma_local": of.local, "sigma_orientation": of.orientation,
                "p": probability(of), "significant": c.significant(of),
            }  # fmt: skip

        return {
            "from": self.dates[c.begin], "to": self.dates[c.end], "net": about(c.net), "fill": about(c.fill),
            "cut": about(c.cut), "detectable": c.detectable, "limit": c.limit,
        }  # fmt: skip


def _rate(t: Trend) -> dict[str, float]:
    return {
        "per_day": float(t.velocity[0]), "sigma": float(np.sqrt(t.velocity_covariance[0, 0])), "p_none": t.p_none,
        "p_constant": t.p_constant,
    }  # fmt: skip


def write_time_series(
    o: Opened, found: DatedVolumes, areas: Mapping[str, Sequence[Array]], out: Path
) -> tuple[Path, ...]:
    """Write all files into a new folder; areas by the names of regions, rings in columns and rows."""
    names = (VOLUMES, CHANGES, ALL, LINES, LAYER, DRAWING, PICTURE)
    first = f"# lengths in {found.unit or 'no unit: the scale is free'}\n"
    with new_folder(out) as new:
        (new / VOLUMES).write_text(first + _csv(_volumes(found)), encoding="utf-8")
        (new / CHANGES).write_text(first + _csv(_changes(found)), encoding="utf-8")
        (new / ALL).write_text(json.dumps(found.as_mapping(), indent=1) + "\n", encoding="utf-8")
        drawn = [_drawn(o, found, r, areas[r.name]) for r in found.regions if r.name in areas]
        write_geojson(new / LINES, drawn, o.file.wkt)
        write_gpkg(new / LAYER, drawn, "regions", o.file.wkt)
        svg = volumes_svg(found)
        (new / DRAWING).write_text(svg, encoding="utf-8")
        write_png(svg, new / PICTURE)
    return tuple(out / n for n in names)


def _csv(rows: Sequence[Sequence[str]]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def _number(value: float) -> str:
    return f"{value:.8g}"


def _volumes(found: DatedVolumes) -> list[list[str]]:
    rows = [["region", "date", "volume", "sigma", "plan_area", "filled"]]
    for r in found.regions:
        each = zip(found.dates, r.volumes.tolist(), r.sigma.tolist(), r.filled.tolist(), strict=True)
        rows += [[r.name, d, *map(_number, (v, s, r.plan_area, f))] for d, v, s, f in each]
    return rows


def _changes(found: DatedVolumes) -> list[list[str]]:
    """A row for each region and interval."""
    names = [f"{q}{n}" for q in ("net", "fill", "cut") for n in ("", "_sigma", "_p", "_significant")]
    rows = [["region", "from", "to", *names, "detectable"]]
    for r in found.regions:
        for c in r.changes:
            numbers = [
                text for q in (c.net, c.fill, c.cut)
                for text in (_number(q.value), _number(q.sigma), _number(probability(q)), str(int(c.significant(q))))
            ]  # fmt: skip
            rows.append([r.name, found.dates[c.begin], found.dates[c.end], *numbers, _number(c.detectable)])
    return rows


def _drawn(o: Opened, found: DatedVolumes, r: RegionSeries, rings: Sequence[Array]) -> Drawn:
    """The outline of a region with its last volume and its whole change."""
    c = r.changes[-1]
    fields: dict[str, float | str] = {
        "region": r.name, "date": found.dates[-1], "area": r.plan_area, "volume": float(r.volumes[-1]),
        "volume_sigma": float(r.sigma[-1]), "since": found.dates[c.begin], "change": c.net.value,
        "change_sigma": c.net.sigma, "significant": float(c.significant(c.net)), "detectable": c.detectable,
    }  # fmt: skip
    closed = tuple(o.places(np.concatenate([ring, ring[:1]])) for ring in rings)
    return Drawn(kind="area", rings=closed, layer="REGIONS", fields=fields)


def volumes_svg(found: DatedVolumes) -> str:
    """The volumes of each region over time, with the band in which 95 % of true volumes lie."""
    panels = [_panel(found, r, k * PANEL) for k, r in enumerate(found.regions)]
    return sheet(WIDTH, PANEL * len(panels), "".join(panels))


def _panel(found: DatedVolumes, r: RegionSeries, top: float) -> str:
    dated = len(found.dates[0]) > 4 and "-" in found.dates[0]
    at = np.array([date.fromisoformat(d).toordinal() if dated else int(d) for d in found.dates], float)
    v, q = r.volumes, BAND * r.sigma
    low, high = float((v - q).min()), float((v + q).max())
    room = max(0.06 * (high - low), 1e-9 * max(abs(low), abs(high)), 1e-12)
    margin = 0.04 * float(np.ptp(at))
    f = Frame(low=low - room, high=high + room, length=float(np.ptp(at)) + 2 * margin, top=top)
    x, bottom, right = f.x(at - at[0] + margin), top + PANEL - BOTTOM, WIDTH - RIGHT
    out = [f'<text x="{LEFT}" y="{top + 22:.0f}">{escape(r.name)}</text>', *level_lines(f)]
    up, down = f.y(v + q), f.y(v - q)
    edge = points(np.concatenate([x, x[::-1]]), np.concatenate([up, down[::-1]]))
    out.append(f'<polygon class="band" points="{edge}"/><polyline class="line" points="{points(x, f.y(v))}"/>')
    last = -np.inf
    for k, name in enumerate(found.dates):
        a, b, c, d = float(x[k]), float(f.y(v[k])), float(up[k]), float(down[k])
        out.append(f'<line class="bar" x1="{a:.1f}" x2="{a:.1f}" y1="{c:.1f}" y2="{d:.1f}"/>')
        out.append(f'<circle class="dot" cx="{a:.1f}" cy="{b:.1f}" r="3.5"/>')
        # names that would run into each other are left out
        if a - last > LABEL_PX:
            out.append(
                f'<text class="small" x="{a:.1f}" y="{bottom + 17:.0f}" text-anchor="middle">{escape(name)}</text>'
            )
            last = a
    height = bottom - top - TOP
    out.append(f'<rect class="axis" x="{LEFT}" y="{top + TOP}" width="{right - LEFT}" height="{height}"/>')
    changed = [c for c in r.changes if c.significant(c.net)]
    entries = escape(phrase("height_drawing.volumes", n=len(changed), total=len(r.changes)))
    out.append(f'<text class="small" x="{right}" y="{top + 22:.0f}" text-anchor="end">{entries}</text>')
    along = escape(phrase("height_drawing.axis_volume", unit=found.unit or "none"))
    y = (top + TOP + bottom) / 2
    out.append(f'<text transform="translate(18 {y:.0f}) rotate(-90)" text-anchor="middle">{along}</text>')
    return "".join(out)
