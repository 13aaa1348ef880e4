"""`raybundle orient`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, print_outcome, store_lines
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, not_usable, of_adjustment, report
from raybundle.commands.orient import OrientSettings, accuracy_outcome, run_orient
from raybundle.commands.pages import page_files
from raybundle.errors import Message, message, named, note, phrase
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.workflows.orient import Orientation


class StageName(click.ParamType):
    """The name of a stage, as `raybundle status` lists them; its beginning is enough where no other begins so."""

    name = "stage"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """The whole name."""
        from raybundle.workflows.orient import stages

        known = stages()
        begun = [name for name in known if name.startswith(str(value).lower())]
        if len(begun) != 1:
            self.fail(message("value.not_supported", value=repr(value), known=list(known)).text(), param, ctx)
        return begun[0]


@click.command("orient", cls=Command)
@click.argument("photos", type=FOLDER, nargs=-1, required=True)
@click.option("--out", type=NEW_FOLDER, required=True, metavar="PROJECT", help="Project folder, new or existing.")
@options_of(OrientSettings, redo_from=StageName())
@common_options
def command(photos: tuple[Path, ...], out: Path, progress: str, **given: Any) -> int:
    """Orient photographs: a folder or files in, calibrated cameras, oriented images, object points and a report out.

    Images with an RPC (in a TIFF tag, or as NAME_RPC.TXT, NAME.RPB, NAME.XML beside them) are satellite scenes. Scenes
    and photographs are adjusted together, joined by control and by common points.

    No parameter is needed. A stopped run continues with the same command. Of photographs added later, only these are
    matched with the others.

    \b
    Exit status: 0 oriented (photographs that could not be are named); 2 bad input; 3 no two photographs fit; 4 the
    accuracy of --accuracy-class is not kept.

    \b
    Example:
      raybundle orient facade/ --out facade-project
      raybundle orient facade/ --out facade-project --from-stage precision
      raybundle orient flight/ --out flight-project --control gcp_list.txt
      raybundle orient flight/ --out flight-project --control gcp_list.txt --check checks.csv --accuracy-class 0.03,0.05
      raybundle orient facade/ --out scaled --control marks.csv --scale-bar A B 1.2319 0.0001
      raybundle orient pair/ --out pair-project --control gcp.csv --crs EPSG:32633
    """
    from raybundle.cli.progress import reporting

    settings = made(OrientSettings, {"photos": photos, "out": out, **values_of(OrientSettings, given)})
    try:
        with reporting(progress) as notify:
            done = run_orient(settings, notify)
    except KeyboardInterrupt:
        click.echo(phrase("interruption.kept", folder=str(out)), err=True)
        return 130
    report(_summary(done, settings))
    return print_outcome(accuracy_outcome(settings, done))


def _summary(done: Orientation, settings: OrientSettings) -> Summary:
    """What the command reports."""
    from raybundle.adjustment.evaluation.counts import counts
    from raybundle.workflows.orient import component_folder

    result, other = settings.out / "result", done.other_components
    lost = {n for n, _ in done.not_oriented}
    apart = sum(len(set(part.photographs) - lost) for part in other)
    points = counts(done.adjustment).points_used
    first = [note("summary.oriented", oriented=done.oriented - apart, of=len(done.photos), points=points,
                  parts=len(other), lost=len(lost), names=sorted(lost))]  # fmt: skip
    if not done.photos:
        first = []
    if done.scenes:
        first.append(note("summary.scenes", oriented=done.oriented_scenes, of=len(done.scenes)))
    parts = [
        note("summary.part", n=len(part.photographs), folder=str(settings.out / component_folder(k)))
        for k, part in enumerate(other)
    ]
    files = [result, *page_files(result, report=settings.report, pdf=settings.pdf)]
    return of_adjustment(
        done.adjustment, files, done=[*first, *parts], notices=not_usable(done.refused),
        next_step=note("summary.next_surface", project=str(settings.out)),
        details=[*_without_orientation(done, settings), note("summary.image_points", sigma_px=done.sigma_px),
                 *store_lines(settings.out)],
    )  # fmt: skip


def _without_orientation(done: Orientation, settings: OrientSettings) -> list[Message | str]:
    """Photographs that are not in the result, and why."""
    found: list[Message | str] = [named(*refused) for refused in (*done.refused, *done.not_oriented)]
    if done.oriented < len(done.photos) and settings.features == "rootsift":
        found.append(note("summary.try_xfeat"))
    return found
