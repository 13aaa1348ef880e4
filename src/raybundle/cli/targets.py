"""`raybundle targets sheet | detect | choose`."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, NEW_FILE, NEW_FOLDER, common_options, counted
from raybundle.cli.numbers import Number
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.target_settings import (
    MILLIMETRES,
    ChooseSettings,
    DetectSettings,
    SheetSettings,
    run_choose,
    run_sheet,
)
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.targets.marks import Marks, Target

LENGTH = re.compile(r"([0-9]+(?:\.[0-9]*)?|\.[0-9]+)\s*(mm|cm|m|in)?")
UNITS = {None: 1.0, "mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4}


class Length(Number):
    """A length in millimetres, written with or without its unit."""

    name = "LENGTH"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """5mm, 0.5cm, 5."""
        from raybundle.io.reading.words import number_of  # noqa: PLC0415  (NumPy is loaded with it)

        if isinstance(value, float):
            return value
        match = LENGTH.fullmatch(str(value).strip())
        if match is None:
            self.fail(f"{value!r} is not a length such as 5mm, 0.5cm or 0.2in", param, ctx)
        return super().convert((number_of(match[1]) or 0.0) * UNITS[match[2]], param, ctx)


ON_SHEET = Length(MILLIMETRES.low, MILLIMETRES.high, above=True)


@click.group("targets", context_settings=COMMAND_SETTINGS)
def command() -> None:
    """Print coded targets, and find and measure them in photographs.

    \b
    Example:
      raybundle targets sheet --family aicon14 --codes 1-50 --paper A4 --out sheet.pdf
      raybundle targets detect images/ --family aicon14 --out targets.csv --overlay found
    """  # noqa: D301


@command.command("sheet", context_settings=COMMAND_SETTINGS)
@options_of(SheetSettings, spacing=ON_SHEET, dot_radius=ON_SHEET, out=NEW_FILE)
@common_options
def sheet(progress: str, **given: Any) -> None:
    """Write targets at true size, with a scale bar to verify the printer, and FILE.toml with ids, radii, positions.

    \b
    Example:
      raybundle targets sheet --family aicon12 --count 20 --out sheet.pdf
      raybundle targets sheet --family charuco-8x6-5x5_100 --spacing 25mm --lying --out board.pdf
      raybundle targets sheet --family agisoft12 --codes 1-12 --paper A2 --tile A4 --dot-radius 10mm --out large.pdf
    """  # noqa: D301
    del progress
    settings = made(SheetSettings, values_of(SheetSettings, given))
    designed, files = run_sheet(settings)
    placed = sum(len(p.targets) for p in designed.pages)
    what = counted(placed, "point" if designed.spacing_mm > 0 else "target")
    tail = f", printed as {counted(len(designed.printed), 'page')} {settings.tile}" if settings.tile else ""
    click.echo(f" {what} of {designed.title} on {counted(len(designed.pages), 'page')} {settings.paper}{tail}")
    click.echo(f" {', '.join(str(f) for f in files)}")


@command.command("choose", context_settings=COMMAND_SETTINGS)
@options_of(ChooseSettings)
@common_options
def choose(progress: str, **given: Any) -> None:
    """Choose targets that stay distinct when an arc of their ring is hidden.

    \b
    Example:
      raybundle targets choose --family aicon14 --count 40
    """  # noqa: D301
    del progress
    settings = made(ChooseSettings, values_of(ChooseSettings, given))
    choice, family = run_choose(settings)
    click.echo(f" {counted(settings.count, 'target')} of {family.title}: {', '.join(map(str, choice.ids))}")
    click.echo(
        f" with any {choice.hidden} neighbouring sectors of {family.bits} hidden no ring passes for another; "
        f"two rings differ in {choice.distance} sectors at least"
    )


@command.command("detect", context_settings=COMMAND_SETTINGS)
@click.argument("photos", type=FOLDER, nargs=-1, required=True, metavar="PHOTOS...")
@options_of(DetectSettings, out=NEW_FILE, observations=NEW_FILE, overlay=NEW_FOLDER)
@common_options
def detect(photos: tuple[Path, ...], progress: str, **given: Any) -> int:
    """Find, read and measure targets.

    Standard deviations in the tables come from the grey values alone; what lens, film and panel add is for the
    adjustment to find.  Exit status 2 if nothing was found.

    \b
    Example:
      raybundle targets detect images/ --family aicon14
      raybundle targets detect images/ --family chessboard-9x6 --out targets.csv --overlay found
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415
    from raybundle.commands.targets import run_detect  # noqa: PLC0415

    settings = made(DetectSettings, {"photos": photos, **values_of(DetectSettings, given)})
    with reporting(progress) as tell:
        done = run_detect(settings, tell)
    click.echo("\n".join(report(done.found, done.target)))
    for path, reason in done.refused:
        click.echo(f" left out: {path.name}: {reason}")
    if settings.out is not None:
        click.echo(f" targets: {settings.out}")
    if settings.observations is not None:
        click.echo(f" observations: {settings.observations}")
    return 0 if any(len(m) for _, m in done.found) else 2


def report(found: Sequence[tuple[str, Marks]], target: Target) -> list[str]:
    """What was found, for a terminal."""
    names = {n for _, m in found for n in m.name if n}
    reads = sum(int(m.named.sum()) for _, m in found)
    bare = sum(int((~m.named).sum()) for _, m in found)
    lines = [
        f" {counted(len(found), 'photograph')}, {counted(len(names), 'point')} of {target.title}",
        f" {counted(reads, 'image observation')} with a name, {counted(bare, 'dot')} without",
    ]
    for name, m in found:
        numbers = ", ".join(n for n in m.name if n) if not target.objects else ""
        lines.append(f"   {name}: {counted(len(m), 'point')}{': ' if numbers else ''}{numbers}")
        lines += [f"     {r}" for r in m.remarks]
    return lines
