"""`raybundle surface`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, facts, store_lines
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.surface import WORK, SurfaceSettings, run_surface
from raybundle.errors import Message, Severity, message_of_text, named, note, phrase
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.surface import MeasuredSurface

MOST_LEFT_OUT = 8
"""Photographs and pairs without a part that are named."""


@click.command("surface", cls=Command)
@click.argument("source", type=FOLDER, metavar="RESULT")
@options_of(SurfaceSettings, out=NEW_FOLDER)
@common_options
def command(source: Path, progress: str, **given: Any) -> int:
    """Measure dense surface points, each with its standard deviations.

    RESULT is a result folder or the project of `orient`. SOURCE/surface/points.ply holds the points with colours and
    standard deviations of x, y, z. It also has their parts along the ray: noise of grey values, roughness of the
    surface within the window, orientation and calibration. Other depth maps confirm each point; the best estimate of a
    place is used. surface.html shows the quality, and objections to the underlying adjustment. A stopped run continues
    at its last step.

    \b
    Example:
      raybundle surface facade-project
      raybundle surface facade-project --density 2 --out facade-surface
    """
    from raybundle.cli.progress import reporting

    settings = made(SurfaceSettings, {"source": source, **values_of(SurfaceSettings, given)})
    try:
        with reporting(progress) as notify:
            done = run_surface(settings, notify)
    except KeyboardInterrupt:
        kept = (settings.out or source / "surface") / WORK
        click.echo(phrase("interruption.kept", folder=str(kept)), err=True)
        return 130
    facts(
        points=len(done.surface), unit=done.unit, median_sigma=done.median_sigma,
        median_along_ray=done.median_along_ray, verdict=done.pages.verdict, file=str(done.points),
    )  # fmt: skip
    work = (settings.out or source / "surface") / WORK
    report(_summary(done, work))
    return 0


def _summary(done: MeasuredSurface, work: Path) -> Summary:
    """What the command reports."""
    from raybundle.surfaces.photographs import lost_message

    s, written = done.surface, done.pages.summary.written
    points = note("surface.points", n=written or len(s), maps=sum(1 for n in s.counts if n))
    wrong = [lost_message(s.lost, int(s.block.images.oriented.sum()))] if s.lost else []
    wrong += [message_of_text(s.others)] if s.others else []
    products = [named(str(w.files[0]), line) for name, w in done.written if name for line in w.reported]
    return Summary(
        done=[points, *_precision(done)[:1]],
        notices=[*(replace(m, severity=Severity.WARNING) for m in wrong), *done.pages.warnings],
        files=[done.points, *(w.files[0] for name, w in done.written if name), *done.pages.files],
        details=[*_precision(done)[1:], *products, *of_texts(done.remarks), *_without_part(done),
                 f"adjustment: {done.pages.verdict}", *store_lines(work)],
    )  # fmt: skip


def _precision(done: MeasuredSurface) -> list[Message]:
    """How good points are in the datum, and by what their errors along the ray come about."""
    from raybundle.numerics.length_units import precision_unit

    if not len(done.surface):
        return []
    factor, unit = precision_unit(done.median_sigma, done.unit)
    x, y, z = (factor * float(v[0]) for _, v in zip("XYZ", done.pages.summary.axes, strict=True))
    noise, rough, orientation = whole_shares(done.shares)
    free = not unit
    return [
        note("surface.precision", median=factor * done.median_sigma, unit=unit, free_scale=free),
        note("surface.precision_of_axes", x=x, y=y, z=z, along_ray=factor * done.median_along_ray, unit=unit),
        note("surface.shares", noise=noise, roughness=rough, orientation=orientation),
    ]  # fmt: skip


def whole_shares(shares: Sequence[float]) -> list[int]:
    """Shares in whole per cent that are 100 together: rounded down, and what is left to the largest remainders."""
    percent = [100 * s for s in shares]
    found = [int(p) for p in percent]
    left = sorted(range(len(found)), key=lambda k: found[k] - percent[k])
    for k in left[: 100 - sum(found)]:
        found[k] += 1
    return found


def _without_part(done: MeasuredSurface) -> list[str]:
    """Photographs and pairs that give nothing, those of one reason together."""
    s = done.surface
    lines = [f"no point of {name}: {why}" for name, why in s.pointless]
    whys = dict[str, list[str]]()
    for what, why in s.left_out[len(s.lost) :]:  # a reason that names its photograph is that of others, too
        whys.setdefault(why.removeprefix(what).strip(), []).append(what)
    for why, names in list(whys.items())[:MOST_LEFT_OUT]:
        if len(names) > 1:
            lines.append(f"left out: {len(names)} for one reason ({', '.join(names[:MOST_LEFT_OUT])}"
                        f"{', ...' if len(names) > MOST_LEFT_OUT else ''}): {why}")  # fmt: skip
        else:
            lines.append(f"left out: {names[0]}: {why}")
    if len(whys) > MOST_LEFT_OUT:
        lines.append(f"left out: {sum(len(n) for n in list(whys.values())[MOST_LEFT_OUT:])} more")
    return lines
