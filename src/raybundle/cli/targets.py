"""`raybundle targets sheet | detect | choose`."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, NEW_FOLDER, Group, common_options, facts
from raybundle.cli.numbers import Length
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, not_usable, report
from raybundle.commands.target_settings import (
    MILLIMETRES,
    ChooseSettings,
    DetectSettings,
    SheetSettings,
    run_choose,
    run_sheet,
)
from raybundle.errors import Message, note
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.targets.marks import Marks, Target

ON_SHEET = Length(MILLIMETRES.low, MILLIMETRES.high, above=True)


@click.group("targets", cls=Group)
def command() -> None:
    """Print coded targets, and measure them in photographs.

    \b
    Example:
      raybundle targets sheet --target aicon14 --codes 1-50 --paper A4 --out sheet.pdf
      raybundle targets detect images/ --target aicon14 --out targets.csv --overlay found
    """


@command.command("sheet")
@options_of(SheetSettings, spacing=ON_SHEET, dot_radius=ON_SHEET, out=NEW_FILE)
@common_options
def sheet(progress: str, **given: Any) -> None:
    """Write targets at true size, with a scale bar to verify the printer, and FILE.toml with ids, radii, positions.

    \b
    Example:
      raybundle targets sheet --target aicon12 --count 20 --out sheet.pdf
      raybundle targets sheet --target charuco-8x6-5x5_100 --spacing 25mm --lying --out board.pdf
      raybundle targets sheet --target agisoft12 --codes 1-12 --paper A2 --tile A4 --dot-radius 10mm --out large.pdf
    """
    del progress
    settings = made(SheetSettings, values_of(SheetSettings, given))
    designed, files = run_sheet(settings)
    facts(files=files, pages=len(designed.pages), printed_pages=len(designed.printed))
    placed = sum(len(p.targets) for p in designed.pages)
    report(Summary(
        done=[note("target_sheet.printed", n=placed, points=designed.spacing_mm > 0, target=designed.title,
                   pages=len(designed.pages), paper=settings.paper,
                   tiles=len(designed.printed) if settings.tile else 0, tile=settings.tile or "")],
        files=files,
    ))  # fmt: skip


@command.command("choose")
@options_of(ChooseSettings)
@common_options
def choose(progress: str, **given: Any) -> None:
    """Choose targets that stay distinct when an arc of their ring is hidden.

    \b
    Example:
      raybundle targets choose --target aicon14 --count 40
    """
    del progress
    settings = made(ChooseSettings, values_of(ChooseSettings, given))
    choice, family = run_choose(settings)
    facts(ids=choice.ids, hidden_sectors=choice.hidden, least_distance=choice.distance)
    report(Summary(
        done=[note("target_sheet.chosen", n=settings.count, target=family.title),
              note("target_sheet.distinct", hidden=choice.hidden, bits=family.bits, distance=choice.distance)],
        table=[", ".join(map(str, choice.ids))],
    ))  # fmt: skip


@command.command("detect")
@click.argument("photos", type=FOLDER, nargs=-1, required=True, metavar="PHOTOS...")
@options_of(DetectSettings, out=NEW_FILE, observations=NEW_FILE, overlay=NEW_FOLDER)
@common_options
def detect(photos: tuple[Path, ...], progress: str, **given: Any) -> int:
    """Find, read and measure targets.

    Standard deviations in the tables come from the grey values alone. The adjustment estimates the errors of lens, film
    and panel. Exit status 2 if nothing was found.

    \b
    Example:
      raybundle targets detect images/ --target aicon14
      raybundle targets detect images/ --target chessboard-9x6 --out targets.csv --overlay found
    """
    from raybundle.cli.progress import reporting
    from raybundle.commands.targets import run_detect

    settings = made(DetectSettings, {"photos": photos, **values_of(DetectSettings, given)})
    with reporting(progress) as notify:
        done = run_detect(settings, notify)
    facts(photographs=[
        {"photograph": name, "points": len(m), "names": [n for n in m.name if n]} for name, m in done.found
    ])  # fmt: skip
    report(_summary(done.found, done.target, not_usable([(p.name, why) for p, why in done.refused]),
                    [f for f in (settings.out, settings.observations, settings.overlay) if f is not None]))  # fmt: skip
    return 0 if any(len(m) for _, m in done.found) else 2


def _summary(
    found: Sequence[tuple[str, Marks]], target: Target, notices: Sequence[Message], files: Sequence[Path]
) -> Summary:
    """What the detection reports."""
    names = {n for _, m in found for n in m.name if n}
    named = sum(int(m.named.sum()) for _, m in found)
    rows: list[Message | str] = []
    for name, m in found:
        numbers = [] if target.objects else [n for n in m.name if n]
        rows.append(note("target_seen.photograph", name=name, n=len(m), points=", ".join(numbers)))
        rows += [f"  {r}" for r in m.remarks]
    return Summary(
        done=[
            note("target_seen.points", photographs=len(found), n=len(names), target=target.title),
            note("target_seen.observations", named=named, unnamed=sum(len(m) for _, m in found) - named),
        ],
        details=rows, notices=notices, files=files,
    )  # fmt: skip
