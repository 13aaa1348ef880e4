"""`raybundle heights volume`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, Command, facts
from raybundle.cli.heights.alignment import alignment_facts, alignment_lines, alignment_warnings
from raybundle.cli.heights.words import LEAST_SHARE, free_scale, measured, plain, two_digits
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.heights.volume import HeightsVolumeSettings, run_volume
from raybundle.errors import Severity, note
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
    """
    found = run_volume(made(HeightsVolumeSettings, {"source": source, **values_of(HeightsVolumeSettings, given)}))
    v = found.volume
    facts(
        unit=found.unit, plan_area=v.plan_area, true_area=v.true_area, true_area_sigma=v.true_area_sigma,
        true_area_noise=v.true_area_noise, filled=v.filled, filled_sigma=v.filled_sigma,
        **{
            name: {"value": q.value, "sigma": q.sigma, "sigma_local": q.local, "sigma_orientation": q.orientation}
            for name, q in (("above", v.above), ("below", v.below), ("net", v.net))
        },
        **alignment_facts(found.alignment),
    )  # fmt: skip
    report(_summary(found))


def _summary(found: MeasuredVolume) -> Summary:
    """What the command reports."""
    v, unit = found.volume, found.unit
    above, below, net = (measured(q.value, q.sigma, unit, 3) for q in (v.above, v.below, v.net))
    area = f"{plain(v.plan_area)} {unit}2" if unit else plain(v.plan_area)
    more = [
        note("heights.volume_sigma", local=two_digits(v.net.local), orientation=two_digits(v.net.orientation)),
        note("heights.mean_height", mean=measured(v.net.value / v.plan_area, v.mean_sigma, unit)),
    ]
    if v.filled >= LEAST_SHARE:
        more.append(note("heights.volume_filled", share=v.filled, sigma=two_digits(v.filled_sigma)))
    return Summary(
        done=[
            note("heights.volume", base=found.base, above=above, below=below), note("heights.net_volume", net=net),
            note("heights.area", area=area, true_area=measured(v.true_area, v.true_area_sigma, unit, 2)),
            *([] if found.alignment is None else alignment_lines(found.alignment, unit)), *free_scale(unit),
        ],
        details=more,
        notices=[*alignment_warnings(found.alignment), *of_texts(found.cautions, Severity.WARNING)],
    )  # fmt: skip
