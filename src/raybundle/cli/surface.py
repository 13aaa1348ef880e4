"""`raybundle surface`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, counted, facts, significant
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.surface import SurfaceSettings, run_surface
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.surface import MeasuredSurface

MOST_LEFT_OUT = 8
"""Photographs and pairs without a part that are named."""


@click.command("surface", cls=Command)
@click.argument("source", type=FOLDER, metavar="RESULT")
@options_of(SurfaceSettings, out=NEW_FOLDER)
@common_options
def command(source: Path, progress: str, **given: Any) -> None:
    """Measure dense points of what the photographs show, each with its standard deviations.

    RESULT is a result folder or the project of `orient`. SOURCE/surface/points.ply holds the points with colours,
    standard deviations of x, y, z, and their parts along the ray: noise of grey values, roughness of the surface
    within the window, orientation and calibration. Other depth maps confirm each point, and the best estimate of a
    place is kept. A run that was stopped goes on where it was.

    \b
    Example:
      raybundle surface facade-project
      raybundle surface facade-project --density 2 --out facade-surface
    """  # noqa: D301  (\b is click's mark for a paragraph that keeps its lines)
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    settings = made(SurfaceSettings, {"source": source, **values_of(SurfaceSettings, given)})
    with reporting(progress) as tell:
        done = run_surface(settings, tell)
    facts(points=len(done.surface), unit=done.unit, median_sigma=done.median_sigma, file=str(done.points))
    click.echo("\n".join(f" {line}" for line in _lines(done)))


def _lines(done: MeasuredSurface) -> list[str]:
    """What the command prints."""
    s = done.surface
    lost = s.left_out
    some = [i for i, n in zip((i for i, _ in s.clouds), s.counts, strict=True) if n]
    told = [f"{done.points}: {counted(len(s), 'point')} from {counted(len(some), 'depth map')}"]
    if len(s):
        noise, rough, orientation = (100 * v for v in done.shares)
        unit = f" {done.unit}" if done.unit else " (the scale is free)"
        told.append(
            f"standard deviation along the ray {significant(done.median_sigma)}{unit} in the median; of its square "
            f"{noise:.0f} % noise of grey values, {rough:.0f} % roughness, {orientation:.0f} % orientation"
        )
    told += [f"{w.files[0]}: {line}" for _, w in done.written for line in w.told]
    told += done.remarks
    told += [f"no point of {name}: {why}" for name, why in s.pointless]
    told += [f"left out: {what}: {why}" for what, why in lost[:MOST_LEFT_OUT]]
    if len(lost) > MOST_LEFT_OUT:
        told.append(f"left out: {len(lost) - MOST_LEFT_OUT} more")
    return told
