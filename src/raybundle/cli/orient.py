"""`raybundle orient`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

import click

from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, common_options, counted

if TYPE_CHECKING:
    from raybundle.numerics.progress import Progress
    from raybundle.workflows.orient import Orientation

STAGES = ("photographs", "features", "matching", "start", "precision", "adjustment", "report")


@click.command("orient", context_settings=COMMAND_SETTINGS)
@click.argument("photos", type=FOLDER, nargs=-1, required=True)
@click.option("--out", type=FOLDER, required=True, metavar="PROJECT", help="Project folder; begun, or continued.")
@click.option(
    "--calibration", type=FOLDER, metavar="CAMERAS.toml", help="Known cameras; `estimate = []` in it holds them."
)
@click.option(
    "--control",
    type=FOLDER,
    multiple=True,
    metavar="FILE",
    help="Control points with their places in the photographs: gcp_list.txt, CSV or a block folder.",
)
@click.option("--check", type=FOLDER, multiple=True, metavar="FILE", help="Check points, in the same formats.")
@click.option(
    "--control-sigma",
    type=(float, float),
    metavar="PLAN HEIGHT",
    help="Standard deviation of control whose file states none.",
)
@click.option(
    "--mark-sigma",
    type=click.FloatRange(0.001),
    default=0.5,
    show_default=True,
    metavar="PX",
    help="Standard deviation of a point marked in a photograph.",
)
@click.option(
    "--scale-bar",
    type=(str, str, float, float),
    multiple=True,
    metavar="A B LENGTH SIGMA",
    help="A known distance between two points that --control measures.",
)
@click.option("--no-gps", is_flag=True, help="Leave positions out that the photographs state.")
@click.option("--features", default="rootsift", show_default=True, help="Feature method.")
@click.option(
    "--feature-count", type=click.IntRange(100), default=10_000, show_default=True, help="Features of a photograph."
)
@click.option("--quick", is_flag=True, help="Leave out least-squares matching: several times less precise.")
@click.option("--jobs", type=click.IntRange(0), default=0, show_default=True, help="0: all processors.")
@click.option(
    "--memory", type=click.FloatRange(0.1), default=4.0, show_default=True, metavar="GB",
    help="Memory that the pixels of photographs may take while points are measured.",
)  # fmt: skip
@click.option("--from", "redo_from", type=click.Choice(STAGES), help="Do this stage and all after it again.")
@click.option("--no-report", is_flag=True, help="Leave out report.html and network.html.")
@common_options
def command(
    photos: tuple[Path, ...],
    out: Path,
    calibration: Path | None,
    control: tuple[Path, ...],
    check: tuple[Path, ...],
    control_sigma: tuple[float, float] | None,
    mark_sigma: float,
    scale_bar: tuple[tuple[str, str, float, float], ...],
    no_gps: bool,  # noqa: FBT001  (a flag of the command line)
    features: str,
    feature_count: int,
    quick: bool,  # noqa: FBT001
    jobs: int,
    memory: float,
    redo_from: str | None,
    no_report: bool,  # noqa: FBT001
    progress: str,
) -> None:
    """Orient photographs: a folder or files in, calibrated cameras, oriented images, object points and a report out.

    No parameter is needed. A run that was stopped continues with the same command; photographs that are added
    later are matched with the others, and only they.

    \b
    Exit status: 0 oriented (photographs that could not be are named); 2 bad input; 3 no two photographs fit.

    \b
    Example:
      raybundle orient facade/ --out facade-project
      raybundle orient facade/ --out facade-project --from precision
      raybundle orient flight/ --out flight-project --control gcp_list.txt
      raybundle orient facade/ --out scaled --control marks.csv --scale-bar A B 1.2319 0.0001
    """  # noqa: D301
    from dataclasses import replace  # noqa: PLC0415

    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.cli.summary import summary_lines  # noqa: PLC0415
    from raybundle.io.block_toml import read_cameras  # noqa: PLC0415
    from raybundle.io.control_files import DEFAULTS, ControlDefaults, read_control  # noqa: PLC0415
    from raybundle.report.result_folder import check_target  # noqa: PLC0415
    from raybundle.workflows.georeference import Given, ScaleBar  # noqa: PLC0415
    from raybundle.workflows.orient import OrientOptions, orient  # noqa: PLC0415

    options = OrientOptions(
        features=features, feature_count=feature_count, precise=not quick, jobs=jobs, memory_gb=memory,
        redo_from=cast("Any", redo_from or ""),
    )  # fmt: skip
    cameras = read_cameras(calibration) if calibration is not None else ()
    plan, height = control_sigma or (DEFAULTS.plan, DEFAULTS.height)
    usual = ControlDefaults(plan=plan, height=height)
    given = Given(
        control=(
            *(read_control(f, defaults=usual) for f in control),
            *(read_control(f, defaults=replace(usual, role="check")) for f in check),
        ),
        scale_bars=tuple(ScaleBar(start=a, end=b, length=d, sigma=e) for a, b, d, e in scale_bar),
        gps=not no_gps, defaults=usual, sigma_given=control_sigma is not None, mark_px=mark_sigma,
    )  # fmt: skip
    result = out / "result"
    check_target(result)
    with reporting(progress) as tell:
        done = orient(photos, out, options, calibration=cameras, given=given, progress=tell)
        write_orientation(done, result, report="none" if no_report else "html", progress=tell)
    click.echo(f" {done.oriented} of {counted(len(done.photos), 'photograph')} oriented")
    for name, reason in (*done.refused, *done.not_oriented):
        click.echo(f"   {name}: {reason}")
    click.echo("\n".join(summary_lines(done.adjustment)))
    click.echo(f" image points: sigma {done.sigma_px:.3f} px")
    click.echo(
        f" result: {result}"
        + ("" if no_report else f", report: {result / 'report.html'}, in 3D: {result / 'network.html'}")
    )


def write_orientation(done: Orientation, result: Path, *, report: Literal["html", "none"], progress: Progress) -> None:
    """Write the result folder of oriented photographs."""
    from raybundle.cli.photograph_facts import photograph_facts  # noqa: PLC0415
    from raybundle.report.result_folder import write_result  # noqa: PLC0415

    write_result(
        done.adjustment,
        result,
        report=report,
        additions=done.additions(),
        photographs=photograph_facts(done),
        progress=progress,
    )
