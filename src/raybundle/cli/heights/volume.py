"""`raybundle heights volume`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, Command, facts
from raybundle.cli.heights.words import FREE, LEAST_SHARE, cautions, measured, plain, two_digits
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.heights.volume import HeightsVolumeSettings, run_volume
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.heights.volume import MeasuredVolume


@click.command("volume", cls=Command)
@click.argument("source", type=FOLDER, metavar="SURFACE")
@options_of(HeightsVolumeSettings)
def command(source: Path, **given: Any) -> None:
    """Compute volumes above and below a base, area in plan and true area, with standard deviations.

    The base is a height, another surface, or the plane that fits the heights along the outline best. Errors of the base
    are included. Small holes are filled, and their share is reported.

    \b
    Example:
      raybundle heights volume pit/surface --outline heap.geojson
      raybundle heights volume facade-project/surface --outline "0 0, 1 0, 1 1, 0 1" --above 0.02
      raybundle heights volume october/surface --outline heap.geojson --above may/surface
    """  # noqa: D301
    found = run_volume(made(HeightsVolumeSettings, {"source": source, **values_of(HeightsVolumeSettings, given)}))
    v = found.volume
    facts(
        unit=found.unit, plan_area=v.plan_area, true_area=v.true_area, true_area_sigma=v.true_area_sigma,
        true_area_noise=v.true_area_noise, filled=v.filled, filled_sigma=v.filled_sigma,
        **{
            name: {"value": q.value, "sigma": q.sigma, "sigma_local": q.local, "sigma_orientation": q.orientation}
            for name, q in (("above", v.above), ("below", v.below), ("net", v.net))
        },
    )  # fmt: skip
    click.echo("\n".join(f" {line}" for line in _lines(found)))


def _lines(found: MeasuredVolume) -> list[str]:
    v, unit = found.volume, found.unit
    square = f" {unit}2" if unit else ""
    lines = [
        f"above {found.base}: {measured(v.above.value, v.above.sigma, unit, 3)}",
        f"below: {measured(v.below.value, v.below.sigma, unit, 3)}",
        (
            f"net: {measured(v.net.value, v.net.sigma, unit, 3)}; of its sigma "
            f"{two_digits(v.net.local)} is local, {two_digits(v.net.orientation)} orientation"
        ),
        f"mean height above the base: {measured(v.net.value / v.plan_area, v.mean_sigma, unit)}",
        f"area in plan {plain(v.plan_area)}{square}, true area {measured(v.true_area, v.true_area_sigma, unit, 2)}",
    ]
    if v.filled >= LEAST_SHARE:
        lines.append(
            f"{v.filled:.2%} of the area was filled; sigma of the net volume by that {two_digits(v.filled_sigma)}"
        )
    if not unit:
        lines.append(FREE)
    return [*lines, *cautions(found.cautions)]
