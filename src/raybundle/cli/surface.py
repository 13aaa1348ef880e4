"""`raybundle surface`."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, counted, facts, significant, store_told
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.surface import WORK, SurfaceSettings, run_surface
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.surface import MeasuredSurface

MOST_LEFT_OUT = 8
"""Photographs and pairs without a part that are named."""
MOST_CAUTIONS = 3
"""Of the adjustment, that are printed; all faults are."""


@click.command("surface", cls=Command)
@click.argument("source", type=FOLDER, metavar="RESULT")
@options_of(SurfaceSettings, out=NEW_FOLDER)
@common_options
def command(source: Path, progress: str, **given: Any) -> int:
    """Measure dense points of what the photographs show, each with its standard deviations.

    RESULT is a result folder or the project of `orient`. SOURCE/surface/points.ply holds the points with colours,
    standard deviations of x, y, z, and their parts along the ray: noise of grey values, roughness of the surface
    within the window, orientation and calibration. Other depth maps confirm each point, and the best estimate of a
    place is kept. surface.html shows how good it is, and what speaks against the adjustment that it rests on. A run
    that was stopped goes on where it was.

    \b
    Example:
      raybundle surface facade-project
      raybundle surface facade-project --density 2 --out facade-surface
    """  # noqa: D301  (\b is click's mark for a paragraph that keeps its lines)
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    settings = made(SurfaceSettings, {"source": source, **values_of(SurfaceSettings, given)})
    try:
        with reporting(progress) as tell:
            done = run_surface(settings, tell)
    except KeyboardInterrupt:
        kept = (settings.out or source / "surface") / WORK
        click.echo(f"interrupted; what is finished is kept in {kept}, the same command continues there", err=True)
        return 130
    facts(
        points=len(done.surface), unit=done.unit, median_sigma=done.median_sigma,
        median_along_ray=done.median_along_ray, verdict=done.pages.verdict, file=str(done.points),
    )  # fmt: skip
    work = (settings.out or source / "surface") / WORK
    click.echo("\n".join([*(f" {line}" for line in _lines(done)), *store_told(work)]))
    return 0


def _lines(done: MeasuredSurface) -> list[str]:
    """What the command prints."""
    told = [_points(done)]
    if len(done.surface):
        told.append(_precision(done))
    told += [f"{w.files[0]}: {line}" for name, w in done.written if name for line in w.told]
    told += [*done.remarks, *_lost(done), *_without_part(done), *_adjustment(done)]
    words = ("report", "PDF", "in 3D") if len(done.pages.files) > 2 else ("report", "in 3D")
    told.append(", ".join(f"{word}: {path}" for word, path in zip(words, done.pages.files, strict=True)))
    return told


def _points(done: MeasuredSurface) -> str:
    """How many, and of how many maps."""
    s, written = done.surface, done.pages.summary.written
    maps = f"from {counted(sum(1 for n in s.counts if n), 'depth map')}"
    thinned = f", thinned from {counted(len(s), 'point')}" if written else ""
    return f"{done.points}: {counted(written or len(s), 'point')} {maps}{thinned}"


def _precision(done: MeasuredSurface) -> str:
    """How good points are in the datum, and by what their errors along the ray come about."""
    from raybundle.numerics.length_units import precision_unit  # noqa: PLC0415  (loaded after the help)

    factor, of = precision_unit(done.median_sigma, done.unit)
    unit = f" {of}" if of else " (the scale is free)"
    noise, rough, orientation = whole_shares(done.shares)
    each = ", ".join(
        f"{a} {significant(factor * float(v[0]), 2)}" for a, v in zip("XYZ", done.pages.summary.axes, strict=True)
    )  # fmt: skip
    whole, along = (significant(factor * v, 2) for v in (done.median_sigma, done.median_along_ray))
    along = f"{along} {of}".rstrip()
    return (
        f"standard deviation of a point {whole}{unit} in the median ({each}); along its ray {along}, "
        f"of whose square {noise} % are noise of grey values, {rough} % roughness, {orientation} % orientation and "
        "calibration"
    )


def whole_shares(shares: Sequence[float]) -> list[int]:
    """Shares in whole per cent that are 100 together: rounded down, and what is left to the largest remainders."""
    percent = [100 * s for s in shares]
    found = [int(p) for p in percent]
    left = sorted(range(len(found)), key=lambda k: found[k] - percent[k])
    for k in left[: 100 - sum(found)]:
        found[k] += 1
    return found


def _lost(done: MeasuredSurface) -> list[str]:
    """That photographs which were adjusted are not there, do not fit, or are others under their names."""
    from raybundle.workflows.surface_photographs import lost_words  # noqa: PLC0415  (loaded after the help)

    s = done.surface
    told = [lost_words(s.lost, int(s.block.images.oriented.sum()))] if s.lost else []
    return [f"caution: {words}" for words in (*told, s.others) if words]


def _without_part(done: MeasuredSurface) -> list[str]:
    """Photographs and pairs that give nothing, those of one reason together."""
    s = done.surface
    told = [f"no point of {name}: {why}" for name, why in s.pointless]
    whys = dict[str, list[str]]()
    for what, why in s.left_out[len(s.lost) :]:  # a reason that names its photograph is that of others, too
        whys.setdefault(why.removeprefix(what).strip(), []).append(what)
    for why, names in list(whys.items())[:MOST_LEFT_OUT]:
        if len(names) > 1:
            told.append(f"left out: {len(names)} for one reason ({', '.join(names[:MOST_LEFT_OUT])}"
                        f"{', ...' if len(names) > MOST_LEFT_OUT else ''}): {why}")  # fmt: skip
        else:
            told.append(f"left out: {names[0]}: {why}")
    if len(whys) > MOST_LEFT_OUT:
        told.append(f"left out: {sum(len(n) for n in list(whys.values())[MOST_LEFT_OUT:])} more")
    return told


def _adjustment(done: MeasuredSurface) -> list[str]:
    """What is to be said of what the points rest on: its verdict, every fault, and the gravest cautions."""
    from raybundle.adjustment.severity import Severity  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.report.text.summary import line_of  # noqa: PLC0415

    told = done.pages.warnings
    faults = [n for n in told if n.severity is Severity.FAULT]
    cautions = [n for n in told if n.severity is Severity.CAUTION]
    lines = [f"the adjustment behind it: {done.pages.verdict}"]
    lines += map(line_of, (*faults, *cautions[:MOST_CAUTIONS]))
    if len(cautions) > MOST_CAUTIONS:
        lines.append(f"and {counted(len(cautions) - MOST_CAUTIONS, 'more caution')}, see {done.pages.files[0].name}")
    return lines
