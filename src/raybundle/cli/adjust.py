"""`raybundle adjust`."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal, cast

import click

from raybundle.adjustment.options import AdjustmentOptions
from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, NEW_FOLDER, common_options, noise_option

DEFAULT = AdjustmentOptions()


@click.command("adjust", context_settings=COMMAND_SETTINGS)
@click.argument("block", type=FOLDER)
@click.option(
    "--out", type=NEW_FOLDER, required=True, metavar="RESULT", help="Result folder; an older result is replaced."
)
@click.option(
    "--datum",
    type=click.Choice(["auto", "control", "minimal", "inner"]),
    default=DEFAULT.datum,
    show_default=True,
    help="auto: inner constraints take what control, distances and stations leave open; control: an error if anything "
    "stays open; minimal: the fewest coordinates held; inner: inner constraints for everything but a measured scale.",
)
@click.option("--datum-points", metavar="ID,ID,...", default="", help="Points that carry the datum; all if not given.")
@click.option(
    "--estimate",
    type=click.Choice(["given", "auto"]),
    default=DEFAULT.estimate,
    show_default=True,
    help="given: the parameters named in block.toml; auto: chosen by significance and determinability.",
)
@click.option(
    "--reject",
    type=click.Choice(["none", "snooping"]),
    default=DEFAULT.reject,
    show_default=True,
    help="snooping: image observations with significant blunders are left out, one at a time.",
)
@click.option(
    "--residuals",
    type=click.Choice(["measured", "corrected"]),
    help="Where residuals are taken: at the measured or at the corrected image point.  [default: as block.toml says]",
)
@click.option("--robust-start", is_flag=True, help="Begin with a robust weight function; the end is least squares.")
@click.option(
    "--threads", type=click.IntRange(0), default=DEFAULT.threads, show_default=True, help="0: all processors."
)
@noise_option
@click.option("--no-report", is_flag=True, help="Leave out report.html and network.html.")
@common_options
def command(
    block: Path,
    out: Path,
    datum: str,
    datum_points: str,
    estimate: str,
    reject: str,
    residuals: str | None,
    robust_start: bool,  # noqa: FBT001  (a flag of the command line)
    threads: int,
    noise: str,
    no_report: bool,  # noqa: FBT001
    progress: str,
) -> None:
    """Adjust a block folder and write a result folder with its report.

    By default nothing is rejected, and the parameters named in block.toml are estimated, no more and no less.

    \b
    Exit status: 0 a result is written, and its faults are printed (one of them says where the iteration did not
    come to an end); 2 bad input, named by file, line and column; 3 not solvable as given, the message names what is
    not determined.

    \b
    Example:
      raybundle adjust camcal21 --out camcal21-result
      raybundle adjust camcal21 --out free --datum inner --estimate auto --reject snooping
    """  # noqa: D301
    options = AdjustmentOptions(
        datum=cast("Any", datum),
        datum_points=tuple(p.strip() for p in datum_points.split(",") if p.strip()),
        estimate=cast("Any", estimate),
        reject=cast("Any", reject),
        residuals=cast("Any", residuals or DEFAULT.residuals),
        robust_start=robust_start,
        threads=threads,
        noise=cast("Any", noise),
    )
    run(block, out, options, "none" if no_report else "html", progress)


def run(block: Path, out: Path, options: AdjustmentOptions, report: Literal["html", "none"], progress: str) -> None:
    """Read, adjust, write, and print the summary."""
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.io.block.folder import read_block  # noqa: PLC0415
    from raybundle.report.text.summary import summary_lines  # noqa: PLC0415
    from raybundle.report.write import write_result  # noqa: PLC0415
    from raybundle.results.folder import check_target  # noqa: PLC0415
    from raybundle.workflows.adjust import adjust  # noqa: PLC0415

    check_target(out)
    with reporting(progress) as tell:
        adjustment = adjust(read_block(block, progress=tell), options, tell)
        write_result(adjustment, out, report=report, progress=tell)
    click.echo("\n".join(summary_lines(adjustment)))
    click.echo(
        f" result: {out}"
        + (f", report: {out / 'report.html'}, in 3D: {out / 'network.html'}" if report == "html" else "")
    )
