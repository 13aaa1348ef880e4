"""`raybundle orient`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, counted, store_told, told_outcome
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.orient import OrientSettings, accuracy_outcome, run_orient
from raybundle.commands.pages import pages_told
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.workflows.orient import Orientation


class StageName(click.ParamType):
    """The name of a stage, as `raybundle status` lists them; its beginning is enough where no other begins so."""

    name = "stage"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """The whole name."""
        from raybundle.workflows.orient import stages  # noqa: PLC0415  (what computes is loaded after the help)

        known = stages()
        begun = [name for name in known if name.startswith(str(value).lower())]
        if len(begun) != 1:
            self.fail(f"{value!r} is not one of {', '.join(repr(n) for n in known)}.", param, ctx)
        return begun[0]


@click.command("orient", cls=Command)
@click.argument("photos", type=FOLDER, nargs=-1, required=True)
@click.option("--out", type=NEW_FOLDER, required=True, metavar="PROJECT", help="Project folder; begun, or continued.")
@options_of(OrientSettings, redo_from=StageName())
@common_options
def command(photos: tuple[Path, ...], out: Path, progress: str, **given: Any) -> int:
    """Orient photographs: a folder or files in, calibrated cameras, oriented images, object points and a report out.

    Images that bring an RPC (in a TIFF tag, or as NAME_RPC.TXT, NAME.RPB, NAME.XML beside them) are satellite scenes;
    scenes and photographs are adjusted together, joined by control and by common points.

    No parameter is needed. A run that was stopped continues with the same command; photographs that are added
    later are matched with the others, and only they.

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
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    settings = made(OrientSettings, {"photos": photos, "out": out, **values_of(OrientSettings, given)})
    try:
        with reporting(progress) as tell:
            done = run_orient(settings, tell)
    except KeyboardInterrupt:
        click.echo(f"interrupted; what is finished is kept in {out}, the same command continues there", err=True)
        return 130
    click.echo("\n".join(_lines(done, settings)))
    outcome = accuracy_outcome(settings, done)
    return told_outcome(outcome)


def _lines(done: Orientation, settings: OrientSettings) -> list[str]:
    """What the command prints."""
    from raybundle.report.text.summary import summary_lines  # noqa: PLC0415
    from raybundle.workflows.orient import component_folder  # noqa: PLC0415

    result = settings.out / "result"
    told = [f" {_oriented(done)}"] if done.photos or not done.scenes else []
    if done.scenes:
        told.append(f" {done.oriented_scenes} of {counted(len(done.scenes), 'scene')} in the block")
    told += [f"   {name}: {reason}" for name, reason in (*done.refused, *done.not_oriented)]
    if done.oriented < len(done.photos) and settings.features == "rootsift":
        told.append("   --features xfeat matches photographs from farther apart (pip install 'raybundle[learned]')")
    for k, part in enumerate(done.other_components):
        n = counted(len(part.photographs), "photograph")
        told.append(f"   {n} in a part of its own: {settings.out / component_folder(k)}")
    told += summary_lines(done.adjustment)
    told.append(f" image points: sigma {done.sigma_px:.3f} px (rms of a coordinate, from the residuals)")
    return [*told, *store_told(settings.out), f" result: {result}{pages_told(result, settings)}"]


def _oriented(done: Orientation) -> str:
    """How many photographs are oriented, and where, in words."""
    whole = counted(len(done.photos), "photograph")
    apart = sum(len(set(part.photographs) - {n for n, _ in done.not_oriented}) for part in done.other_components)
    if not apart:
        return f"{done.oriented} of {whole} oriented"
    others = f"{len(done.other_components)} others" if len(done.other_components) > 1 else "another"
    return f"{done.oriented - apart} of {whole} oriented in this result, {apart} in {others}"
