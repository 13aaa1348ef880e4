"""A flight plan from above, as a picture that stands by itself."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

import numpy as np

from raybundle.errors import phrase
from raybundle.missions.mission import Exposures, Mission, exposures
from raybundle.missions.views import Coverage
from raybundle.numerics.arrays import Array
from raybundle.report.figures.svg import Plot, coordinates, round_below, span

SIZE = 900.0
WAYS = ("#c2410c", "#1d4ed8", "#15803d", "#7e22ce", "#0e7490", "#b91c1c")
"""Colours of the batteries, one after the other."""
SEEN = ((0, "#e58a8a"), (1, "#f6d5d5"), (2, "#fae8c8"), (3, "#e4f0dc"), (5, "#c9e3c4"), (9, "#a7d3a6"))
"""Photographs from which on a place has a colour."""
STYLE = (
    "text{font:12px sans-serif;fill:#222}.small{font-size:11px}.area{fill:none;stroke:#222;stroke-width:1.5}"
    ".zone{fill:#b91c1c;fill-opacity:.2;stroke:#b91c1c}"
    ".gap{fill:#b91c1c;fill-opacity:.08;stroke:#b91c1c;stroke-width:2;stroke-dasharray:6 3}"
)


def plan_view(mission: Mission, coverage: Coverage | None = None, *, gaps: Sequence[Array] = (),
              flown: Array | None = None) -> str:  # fmt: skip
    """SVG of the way, its photographs, the area, no-go zones, and how many photographs show each place.

    gaps   outlines (k, 2) of what is to be flown again
    flown  (n, 2) where photographs were taken, drawn in place of the planned ones
    """
    e, w = exposures(mission), mission.way_points
    home = np.array(mission.take_off[:2])
    plot = _plot(np.vstack([w.xyz[:, :2], mission.outline, home[None]]))
    parts: list[str] = []
    if coverage is not None:
        parts += _seen(plot, coverage)
    closed = np.vstack([mission.outline, mission.outline[:1]]) if mission.closed else mission.outline
    parts.append(f'<path class="area" d="{_way(plot, closed)}"/>')
    parts += [f'<path class="zone" d="{_way(plot, z)}Z"/>' for z in mission.no_go]
    for flight in range(mission.flights):
        colour = WAYS[flight % len(WAYS)]
        way = np.vstack([home, w.of_flight(flight).xyz[:, :2], home])
        parts.append(f'<path fill="none" stroke="{colour}" stroke-opacity=".7" d="{_way(plot, way)}"/>')
        if flown is None:
            parts += _photographs(plot, e.rows(np.flatnonzero(e.flight == flight)), colour)
    if flown is not None:
        parts += [_dot(plot, p, "#222", 2.2) for p in flown]
    parts += [f'<path class="gap" d="{_way(plot, g)}Z"/>' for g in gaps]
    parts += _home(plot, home)
    parts += _legend(plot, mission, coverage)
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {plot.width:.0f} {plot.height:.0f}" '
    return (
        f'{head}width="{plot.width:.0f}" height="{plot.height:.0f}"><title>{escape(mission.name)}</title>'
        f'<style>{STYLE}</style><rect width="100%" height="100%" fill="#fff"/>{"".join(parts)}</svg>\n'
    )


def _plot(xy: Array) -> Plot:
    """A plot of one scale along both axes."""
    (x0, x1), (y0, y1) = span(xy[:, 0]), span(xy[:, 1])
    scale = SIZE / max(x1 - x0, y1 - y0)
    width, height = max((x1 - x0) * scale, 320.0), max((y1 - y0) * scale, 120.0)
    middle = (x0 + x1) / 2, (y0 + y1) / 2
    return Plot(
        width=width + 40, height=height + 120, left=20, right=20, top=20, bottom=100,
        x_range=(middle[0] - width / scale / 2, middle[0] + width / scale / 2),
        y_range=(middle[1] - height / scale / 2, middle[1] + height / scale / 2),
    )  # fmt: skip


def _way(plot: Plot, xy: Array) -> str:
    return coordinates(plot.x(xy[:, 0]), plot.y(xy[:, 1]))


def _dot(plot: Plot, xy: Array, colour: str, radius: float) -> str:
    x, y = float(plot.x(xy[0])), float(plot.y(xy[1]))
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{colour}"/>'


def _photographs(plot: Plot, e: Exposures, colour: str) -> list[str]:
    """A dot for each photograph, with a stroke to where a tilted one looks."""
    found = [_dot(plot, p, colour, 2.0) for p in e.xyz]
    for k in np.flatnonzero(e.pitch > -np.pi / 2 + 0.03).tolist():
        x, y = float(plot.x(e.xyz[k, 0])), float(plot.y(e.xyz[k, 1]))
        dx, dy = 8 * float(np.sin(e.heading[k])), -8 * float(np.cos(e.heading[k]))
        found.append(f'<path stroke="{colour}" d="M{x:.1f} {y:.1f}l{dx:.1f} {dy:.1f}"/>')
    return found


def _seen(plot: Plot, coverage: Coverage) -> list[str]:
    """Squares in the colours of their counts, cut to the area; they overlap by a hair, so that no seam shows."""
    where = coverage.places
    side = abs(float(plot.x(where.step) - plot.x(0.0))) + 0.3
    level = np.searchsorted([n for n, _ in SEEN], coverage.count, side="right") - 1
    found: list[str] = []
    for k, (_, colour) in enumerate(SEEN):
        rows = where.middle[level == k]
        d = "".join(
            f"M{x - side / 2:.1f} {y - side / 2:.1f}h{side:.1f}v{side:.1f}h-{side:.1f}z"
            for x, y in zip(plot.x(rows[:, 0]).tolist(), plot.y(rows[:, 1]).tolist(), strict=True)
        )
        if d:
            found.append(f'<path fill="{colour}" d="{d}"/>')
    if where.outline is None:
        return found
    edge = f'<clipPath id="outline"><path d="{_way(plot, where.outline)}Z"/></clipPath>'
    return [edge, '<g clip-path="url(#outline)">', *found, "</g>"]


def _home(plot: Plot, home: Array) -> list[str]:
    x, y = float(plot.x(home[0])), float(plot.y(home[1]))
    take_off = escape(phrase("mission_picture.take_off"))
    return [
        f'<path fill="none" stroke="#111" stroke-width="2" d="M{x - 6:.1f} {y:.1f}h12M{x:.1f} {y - 6:.1f}v12"/>',
        f'<text x="{x + 8:.1f}" y="{y - 4:.1f}">{take_off}</text>',
    ]


def _legend(plot: Plot, mission: Mission, coverage: Coverage | None) -> list[str]:
    """Scale, north, batteries, colours of the area."""
    base = plot.height - 78
    metres = round_below((plot.x_range[1] - plot.x_range[0]) / 4)
    length = float(plot.x(metres) - plot.x(0.0))
    found = [
        f'<path fill="none" stroke="#111" stroke-width="2" d="M20 {base:.0f}v6h{length:.1f}v-6"/>',
        f'<text x="{26 + length:.1f}" y="{base + 8:.0f}">{metres:g} m</text>',
        f'<path fill="#111" d="M{plot.width - 30:.0f} {base + 12:.0f}l5 -18l5 18l-5 -4z"/>',
        f'<text x="{plot.width - 29:.0f}" y="{base + 26:.0f}">N</text>',
    ]
    x = 20.0
    for flight in range(mission.flights):
        found.append(
            f'<rect x="{x:.0f}" y="{base + 18:.0f}" width="12" height="12" fill="{WAYS[flight % len(WAYS)]}"/>'
        )
        battery = escape(phrase("mission_picture.battery", number=flight + 1))
        found.append(f'<text x="{x + 16:.0f}" y="{base + 28:.0f}">{battery}</text>')
        x += 84
    x = 20.0
    if coverage is not None:
        key = escape(phrase("mission_picture.photographs_of_place"))
        found.append(f'<text class="small" x="20" y="{base + 48:.0f}">{key}</text>')
        for k, (least, colour) in enumerate(SEEN):
            label = f"{least}" if k + 1 < len(SEEN) and SEEN[k + 1][0] == least + 1 else f"{least} +"
            if k + 1 < len(SEEN) and SEEN[k + 1][0] > least + 1:
                label = f"{least}-{SEEN[k + 1][0] - 1}"
            found.append(
                f'<rect x="{x:.0f}" y="{base + 54:.0f}" width="14" height="14" fill="{colour}" stroke="#999"/>'
                f'<text class="small" x="{x + 18:.0f}" y="{base + 66:.0f}">{label}</text>'
            )
            x += 56
    return found
