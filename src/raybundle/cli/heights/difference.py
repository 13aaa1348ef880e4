"""`raybundle heights difference`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, counted, facts
from raybundle.cli.heights.words import FREE, cautions, measured
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.heights.difference import HeightsDifferenceSettings, run_difference
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.heights.difference import MeasuredDifference

MOST_SHOWN = 12


@click.command("difference", cls=Command)
@click.argument("before", type=FOLDER, metavar="BEFORE")
@click.argument("after", type=FOLDER, metavar="AFTER")
@options_of(HeightsDifferenceSettings, out=NEW_FOLDER)
def command(before: Path, after: Path, **given: Any) -> None:
    """What has moved between two surfaces by more than chance.

    Errors of the two orientations move large parts alike: whether the whole has moved by more than they allow is told
    apart from what has moved against the rest. For that the chance of any false alarm on the whole surface is 5 %.
    FOLDER gets difference.tif (difference, movement against the rest, both with sigma, significance, region),
    moved.csv, moved.geojson and, where something has moved, moved.gpkg with area, mean movement, movement of the inner
    part (amount) and volume of each region, and difference.png.

    \b
    Example:
      raybundle heights difference may/surface october/surface --out moved
    """  # noqa: D301
    asked = {"before": before, "after": after, **values_of(HeightsDifferenceSettings, given)}
    found = run_difference(made(HeightsDifferenceSettings, asked))
    m, w = found.movements, found.movements.whole
    facts(
        unit=found.unit, compared=found.compared, limit=m.limit, windows=m.windows,
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
        files=[str(f) for f in found.files],
    )  # fmt: skip
    click.echo("\n".join(f" {line}" for line in _lines(found)))


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
    if not m.regions:
        lines.append("nothing has moved against the rest by more than chance (5 % for the whole surface)")
    else:
        lines.append(f"{counted(len(m.regions), 'region')} moved against the rest by more than chance (5 % for all):")
    for k, r in enumerate(m.regions[:MOST_SHOWN], 1):
        lines.append(
            f"  {k}: mean {measured(r.mean, r.mean_sigma, unit)} over {measured(r.area, r.area_sigma, unit, 2)}, "
            f"volume {measured(r.volume, r.volume_sigma, unit, 3)}; its inner part "
            f"{measured(r.amount, r.amount_sigma, unit)}"
        )
    if len(m.regions) > MOST_SHOWN:
        lines.append(f"  and {len(m.regions) - MOST_SHOWN} more")
    if found.orientations:
        lines.append(found.orientations)
    elif not found.in_map:
        lines.append("both have to be in one frame: with the same control, or points in common that have not moved")
    if not unit:
        lines.append(FREE)
    return [*lines, *cautions(found.cautions), *(str(f) for f in found.files)]
