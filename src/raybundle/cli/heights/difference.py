"""`raybundle heights difference`."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, counted, facts
from raybundle.cli.heights.words import FREE, cautions, measured, plain, two_digits
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import notice_line
from raybundle.commands.heights.difference import HeightsDifferenceSettings, run_difference
from raybundle.errors import warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.heights.difference import MeasuredDifference
    from raybundle.surfaces.movements import Region

MOST_SHOWN = 12
UNSURE = 2.0
"""Standard deviations below which the amount of a region is called unsure"""


@click.command("difference", cls=Command)
@click.argument("before", type=FOLDER, metavar="BEFORE")
@click.argument("after", type=FOLDER, metavar="AFTER")
@options_of(HeightsDifferenceSettings, out=NEW_FOLDER)
def command(before: Path, after: Path, **given: Any) -> None:
    """Detect significant movements between two surfaces.

    Errors of the two orientations displace large parts alike. Therefore a movement of the whole is separated from
    movements relative to the rest. For the latter, the probability of any false alarm on the whole surface is 5 %.
    FOLDER gets difference.tif (difference, movement relative to the rest, both with sigma, significance, region),
    moved.csv and moved.geojson. If a region has moved, moved.gpkg lists area, mean movement, movement of the inner part
    (amount) and volume of each region. smallest.csv has the smallest detectable movements; difference.png shows the
    differences.

    \b
    Example:
      raybundle heights difference may/surface october/surface --out moved
    """  # noqa: D301
    asked = {"before": before, "after": after, **values_of(HeightsDifferenceSettings, given)}
    found = run_difference(made(HeightsDifferenceSettings, asked))
    m, w = found.movements, found.movements.whole
    facts(
        unit=found.unit, compared=found.compared, same=found.same, limit=m.limit, windows=m.windows,
        whole={
            "shift": w.shift.value, "shift_sigma": w.shift.sigma, "tilt": w.tilt, "tilt_sigma": w.tilt_sigma,
            "chi2": w.chi2, "significant": w.significant,
        },
        regions=[
            {
                k: getattr(r, k)
                for k in (
                    "area", "area_sigma", "mean", "mean_sigma", "amount", "amount_sigma", "volume", "volume_sigma",
                    "edge", "peak",
                )
            }
            for r in m.regions
        ],
        smallest=[{"side": s.side, "amount": _or_none(s.amount), "best": _or_none(s.best)} for s in found.smallest],
        files=[str(f) for f in found.files],
    )  # fmt: skip
    click.echo("\n".join(f" {line}" for line in _lines(found)))


def _or_none(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _lines(found: MeasuredDifference) -> list[str]:
    m, w, unit = found.movements, found.movements.whole, found.unit
    verdict = "more than chance" if w.significant else "within the uncertainty of both orientations"
    lines = [
        f"{found.compared:.0%} of the heights before have one after",
        (
            f"the whole: shift {measured(w.shift.value, w.shift.sigma, unit)}, tilts "
            f"{measured(w.tilt[0], w.tilt_sigma[0], '')} and {measured(w.tilt[1], w.tilt_sigma[1], '')}: chi2 "
            f"{w.chi2:.3g} of 3, limit {w.limit:.3g}: {verdict}"
        ),
    ]
    if found.same:
        lines.append(f"{found.same:.2%} of these are one measurement in both: they have not moved, and are not tested")
    if not m.regions:
        lines.append("nothing has moved against the rest by more than chance (5 % for the whole surface)")
    else:
        lines.append(
            f"{counted(len(m.regions), 'region')} moved against the rest by more than chance (5 % for all: means of "
            f"windows beyond {m.limit:.3g} sigma):"
        )
    for k, r in enumerate(m.regions[:MOST_SHOWN], 1):
        lines.append(
            f"  {k}: mean {measured(r.mean, r.mean_sigma, unit)} over {measured(r.area, r.area_sigma, unit, 2)}, "
            f"volume {measured(r.volume, r.volume_sigma, unit, 3)}; its inner part "
            f"{measured(r.amount, r.amount_sigma, unit)}; significance: its strongest window {r.peak:.3g} sigma, its "
            f"inner part {_times(r):.3g}"
        )
    if len(m.regions) > MOST_SHOWN:
        lines.append(f"  and {len(m.regions) - MOST_SHOWN} more")
    if unsure := sum(_times(r) < UNSURE for r in m.regions):
        lines.append(notice_line(warning("displacement.unsure", n=unsure, limit=UNSURE)))
    lines += _smallest(found)
    if found.orientations:
        lines.append(found.orientations)
    elif not found.in_map:
        lines.append("both have to be in one frame: with the same control, or points in common that have not moved")
    if not unit:
        lines.append(FREE)
    return [*lines, *cautions(found.cautions), *(str(f) for f in found.files)]


def _times(r: Region) -> float:
    """How many of its own standard deviations the inner part of a region has moved by."""
    return abs(r.amount) / r.amount_sigma if r.amount_sigma > 0 else math.inf


def _smallest(found: MeasuredDifference) -> list[str]:
    """How small a movement could have been and still be found."""
    lines = list[str]()
    for s in found.smallest:
        of = f"{plain(s.side, 3)} x {plain(s.side, 3)}"
        half, quarter = (two_digits(v) if math.isfinite(v) else "" for v in (s.amount, s.best))
        if half and half != quarter:
            lines.append(f"{half} over {of} ({quarter} where heights are best, in a quarter of it)")
        elif half:
            lines.append(f"{half} over {of}")
        elif quarter:
            lines.append(f"{quarter} over {of} in the best quarter, none however large in the median")
    if not lines:
        return ["no movement of squares of up to half of the surface would be found: too few heights, or all at steps"]
    unit = f" [{found.unit}]" if found.unit else ""
    return [f"smallest movement that would be found with a chance of 80 %, in the median over the surface{unit}:"] + [
        f"  {line}" for line in lines
    ]
