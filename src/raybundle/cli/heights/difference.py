"""`raybundle heights difference`."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, facts
from raybundle.cli.heights.alignment import alignment_facts, alignment_lines, alignment_warnings
from raybundle.cli.heights.words import free_scale, measured, two_digits
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.heights.difference import HeightsDifferenceSettings, run_difference
from raybundle.errors import Message, Severity, note, warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.heights.difference import MeasuredDifference
    from raybundle.surfaces.heights.displacement import Region

UNSURE = 2.0
"""Standard deviations below which the amount of a region is called unsure"""


@click.command("difference", cls=Command)
@click.argument("before", type=FOLDER, metavar="BEFORE")
@click.argument("after", type=FOLDER, metavar="AFTER")
@options_of(HeightsDifferenceSettings, out=NEW_FOLDER)
def command(before: Path, after: Path, **given: Any) -> None:
    """Detect significant movements between two surfaces.

    One of both may be a model without photographs: a GeoTIFF of heights, LAS or LAZ. It is aligned to the surface by
    what is stable. The precision of the alignment is included; the noise of that model is estimated.

    Errors of the two orientations displace large parts alike. Therefore a movement of the whole is separated from
    movements relative to the rest. For the latter, the probability of any false alarm on the whole surface is 5 %.
    FOLDER gets difference.tif (difference, movement relative to the rest, both with sigma, significance, region),
    moved.csv and moved.geojson. If a region has moved, moved.gpkg lists area, mean movement, movement of the inner part
    (amount) and volume of each region. detectable.tif and detectable.png show the smallest detectable movement at each
    place, smallest.csv its median; difference.png shows the differences.

    \b
    Example:
      raybundle heights difference may/surface october/surface --out moved
      raybundle heights difference dsm-2019.tif pit/surface --stable road.geojson --out moved
    """
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
        files=[str(f) for f in found.files], **alignment_facts(found.alignment),
    )  # fmt: skip
    report(_summary(found))


def _or_none(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _summary(found: MeasuredDifference) -> Summary:
    """What the command reports."""
    m, w, unit = found.movements, found.movements.whole, found.unit
    smallest = [s for s in found.smallest if math.isfinite(s.best)]
    least = [note("heights.no_movement_detectable")]
    if smallest:
        s = smallest[-1]
        level = two_digits(s.amount if math.isfinite(s.amount) else s.best)
        least = [note("heights.level_of_detection", amount=level, side=s.side, unit=unit,
                      all_places=math.isfinite(s.amount))]  # fmt: skip
    shift, tilts = measured(w.shift.value, w.shift.sigma, unit), [
        measured(tilt, sigma, "") for tilt, sigma in zip(w.tilt, w.tilt_sigma, strict=True)
    ]  # fmt: skip
    more: list[Message] = [note("heights.compared", share=found.compared), note("heights.tilts", tilts=tilts)]
    if found.same:
        more.append(note("heights.same_measurement", share=found.same))
    for k, r in enumerate(m.regions, 1):
        more += [
            note("heights.region", k=k, mean=measured(r.mean, r.mean_sigma, unit),
                 area=measured(r.area, r.area_sigma, unit, 2), volume=measured(r.volume, r.volume_sigma, unit, 3)),
            note("heights.region_inner", k=k, amount=measured(r.amount, r.amount_sigma, unit), peak=float(r.peak),
                 times=_times(r)),
        ]  # fmt: skip
    more += [
        note("heights.smallest", side=s.side, amount=_or_none(s.amount), best=float(s.best), unit=unit,
             median=math.isfinite(s.amount)) for s in smallest
    ]  # fmt: skip
    unsure = sum(_times(r) < UNSURE for r in m.regions)
    return Summary(
        done=[
            note("heights.moved", n=len(m.regions), limit=float(m.limit)), *least,
            *(
                [note("heights.whole", shift=shift, chi2=w.chi2, limit=w.limit, significant=bool(w.significant))]
                if found.alignment is None else alignment_lines(found.alignment, unit)
            ),
            *free_scale(unit),
        ],
        details=more, files=found.files,
        notices=[
            *([warning("displacement.unsure", n=unsure, limit=UNSURE)] if unsure else []),
            *alignment_warnings(found.alignment), *of_texts(found.cautions, Severity.WARNING), *_frame(found),
        ],
    )  # fmt: skip


def _frame(found: MeasuredDifference) -> list[Message]:
    """What is known of both orientations together."""
    if found.orientations:
        return [note("heights.one_adjustment", common=found.orientations)]
    return [] if found.in_map else [note("heights.same_frame")]


def _times(r: Region) -> float:
    """How many of its own standard deviations the inner part of a region has moved by."""
    return abs(r.amount) / r.amount_sigma if r.amount_sigma > 0 else math.inf
