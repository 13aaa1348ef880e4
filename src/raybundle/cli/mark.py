"""`raybundle mark put | move | remove | point | ...`: measuring by hand."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.cli.common import FOLDER, NEW_FILE_OR_FOLDER, NEW_FOLDER, common_options, facts, print_outcome
from raybundle.cli.marking import command, do, subcommand, words
from raybundle.cli.marking_areas import control, draw, erase, find, mask, unmask
from raybundle.cli.marks_shown import shown
from raybundle.cli.numbers import NUMBER, PIXELS, POSITIVE, Number
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_adjustment, of_texts, report
from raybundle.commands.begin_settings import BeginSettings
from raybundle.commands.marks_settings import RejectSettings
from raybundle.commands.pages import PROJECT_LANGUAGE_HELP, page_files
from raybundle.errors import InputError, Severity, named, note
from raybundle.report.languages import checked_language
from raybundle.report.paper.needed import check_typesetter

__all__ = ["command", "control", "draw", "erase", "find", "mask", "unmask"]
NO_NUMBER = "-"
"""What stands for a coordinate that is not known."""


class PerhapsNumber(Number):
    """A number, or - where it is not known."""

    name = "NUMBER|-"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """The number; a dash stays one."""
        return value if value == NO_NUMBER else super().convert(value, param, ctx)


PERHAPS, PERHAPS_SIGMA = PerhapsNumber(), PerhapsNumber(0)


Covariance = tuple[float, float, float]


def _place(
    folder: Path, verb: str, author: str, sigma: float | None, covariance: Covariance | None, /, **given: Any
) -> None:
    own = None if sigma is None else (sigma**2, sigma**2, 0.0)
    do(folder, verb, author, **({"covariance": known} if (known := covariance or own) else {}), **given)


def _precision(usual: float | None) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Add --mark-sigma, with its default, and --covariance."""
    whole = click.option(
        "--covariance", type=(POSITIVE, POSITIVE, NUMBER), metavar="XX YY XY",
        help="Variances of x and y and their covariance [px^2], instead of --mark-sigma.",
    )  # fmt: skip
    sigma = click.option(
        "--mark-sigma",
        "sigma",
        type=PIXELS,
        default=usual,
        show_default=usual is not None,
        metavar="PX",
        help="Standard deviation of the mark." if usual else "Standard deviation of the mark.  [default: as it is]",
    )
    return lambda function: sigma(whole(function))


@command.command("begin")
@click.argument("photos", type=FOLDER, nargs=-1, required=True)
@click.option(
    "--out", type=NEW_FOLDER, metavar="PROJECT", help="Project folder, new or existing.  [default: PHOTOS-project]"
)
@options_of(BeginSettings)
@common_options
def begin_(photos: tuple[Path, ...], out: Path | None, progress: str, **given: Any) -> None:
    """Begin a project of photographs for manual measurement, if matching cannot join them.

    \b
    Example:
      raybundle mark begin archive/ --out archive-project
      raybundle mark begin archive/ --own-camera "1938_*" --calibration cameras.toml
    """
    from raybundle.cli.progress import reporting
    from raybundle.commands.new_project import begin

    lines: list[str] = []
    with reporting(progress) as notify:
        project = begin(photos, out, notify=lines.append, progress=notify, **values_of(BeginSettings, given))
    facts(project=project)
    report(Summary(done=[note("project_status.begun")], notices=of_texts(lines), files=[project]))


@subcommand("put")
@click.argument("image")
@click.argument("point")
@click.argument("x_px", type=NUMBER, metavar="X")
@click.argument("y_px", type=NUMBER, metavar="Y")
@_precision(0.5)
def put(
    folder: Path, image: str, point: str, x_px: float, y_px: float, sigma: float, covariance: Covariance | None,
    author: str,
) -> None:  # fmt: skip
    """Mark a point in an image. A new name makes a tie point.

    \b
    Example:
      raybundle mark put facade-project IMG_3.jpg gate 1204.3 880.1
    """
    _place(folder, "put", author, sigma, covariance, image=image, point=point, x_px=x_px, y_px=y_px)


@subcommand("move")
@click.argument("image")
@click.argument("point")
@click.argument("x_px", type=NUMBER, metavar="X")
@click.argument("y_px", type=NUMBER, metavar="Y")
@_precision(None)
def move(
    folder: Path, image: str, point: str, x_px: float, y_px: float, sigma: float | None, covariance: Covariance | None,
    author: str,
) -> None:  # fmt: skip
    """Move a mark.

    \b
    Example:
      raybundle mark move facade-project IMG_3.jpg gate 1204.6 880.0 --mark-sigma 0.2
    """
    _place(folder, "move", author, sigma, covariance, image=image, point=point, x_px=x_px, y_px=y_px)


@subcommand("remove")
@click.argument("image")
@click.argument("point")
def remove(folder: Path, image: str, point: str, author: str) -> None:
    """Remove a mark; the point stays.

    \b
    Example:
      raybundle mark remove facade-project IMG_3.jpg gate
    """
    do(folder, "remove", author, image=image, point=point)


@subcommand("point")
@click.argument("point")
@click.option("--role", type=click.Choice(["tie", "control", "check"]), default="tie", show_default=True)
@click.option("--coordinates", type=(PERHAPS,) * 3, metavar="X Y Z", help="Given coordinates; - for an unknown one.")
@click.option(
    "--sigma",
    type=(PERHAPS_SIGMA,) * 3,
    metavar="sX sY sZ",
    help="Standard deviations of the coordinates; 0: fixed, -: none.",
)
def point_(
    folder: Path, point: str, role: str, coordinates: tuple[Any, ...] | None, sigma: tuple[Any, ...] | None, author: str
) -> None:
    """Set the role of a point and its known coordinates.

    \b
    Example:
      raybundle mark point facade-project gate --role control --coordinates 12.5 3.25 - --sigma 0.01 0.01 -
    """
    xyz, s = ([None if v == NO_NUMBER else v for v in values or (NO_NUMBER,) * 3] for values in (coordinates, sigma))
    do(folder, "point", author, point=point, role=role, xyz=xyz, sigma=s)


@subcommand("rename")
@click.argument("point")
@click.argument("to")
def rename(folder: Path, point: str, to: str, author: str) -> None:
    """Rename a point.

    \b
    Example:
      raybundle mark rename facade-project t17 gate
    """
    do(folder, "rename", author, point=point, to=to)


@subcommand("forget")
@click.argument("point")
def forget(folder: Path, point: str, author: str) -> None:
    """Remove all measurements of a point, with its bars and lines.

    \b
    Example:
      raybundle mark forget facade-project gate
    """
    do(folder, "forget", author, point=point)


@subcommand("bar")
@click.argument("start", metavar="A")
@click.argument("end", metavar="B")
@click.argument("length", type=POSITIVE)
@click.argument("sigma", type=POSITIVE)
def bar(folder: Path, start: str, end: str, length: float, sigma: float, author: str) -> None:
    """Add a measured distance between two points, with its standard deviation.

    \b
    Example:
      raybundle mark bar facade-project A B 1.0003 0.0001
    """
    do(folder, "bar", author, start=start, end=end, length=length, sigma=sigma)


@subcommand("unbar")
@click.argument("start", metavar="A")
@click.argument("end", metavar="B")
def unbar(folder: Path, start: str, end: str, author: str) -> None:
    """Remove a scale bar.

    \b
    Example:
      raybundle mark unbar facade-project A B
    """
    do(folder, "unbar", author, start=start, end=end)


@subcommand("line")
@click.argument("line")
@click.argument("points", nargs=-1, metavar="POINT...")
@click.option(
    "--figure", "kind", type=click.Choice(["straight", "plumb", "level", "plane"]), default="straight",
    show_default=True, help="Kind of figure: a straight line, a plumb line, points at one height, or points on one "
    "plane.",
)  # fmt: skip
@click.option(
    "--sigma",
    type=POSITIVE,
    default=0.01,
    show_default=True,
    help="Standard deviation of a point's distance from the figure.",
)
def line_(folder: Path, line: str, points: tuple[str, ...], kind: str, sigma: float, author: str) -> None:
    """Define points on one line, level or plane. Without points: remove it.

    Plumb lines and levels give the vertical.

    \b
    Example:
      raybundle mark line facade-project edge gate sill-1 sill-2 --figure plumb
      raybundle mark line pond-project water W1 W2 W3 --figure level --sigma 0.002
    """
    do(folder, "line", author, line=line, points=points, kind=kind, sigma=sigma)


@subcommand("datum")
@click.argument("names", nargs=-1, metavar="[ORIGIN AXIS [PLANE]]")
def datum(folder: Path, names: tuple[str, ...], author: str) -> None:
    """Define the coordinate system by three points, or two and the vertical. Without points: as in the block.

    With two points, measured levels and plumb lines give the vertical, and the axis point lies on X in plan.

    \b
    Example:
      raybundle mark datum facade-project A B C
      raybundle mark datum pond-project A B
    """
    if len(names) not in {0, 2, 3}:
        raise InputError("axes.point_count", n=len(names))
    do(folder, "datum", author, **dict(zip(("origin", "axis", "plane"), names, strict=False)))


@subcommand("reject")
@click.argument("image", required=False)
@click.argument("point", required=False)
@options_of(RejectSettings)
def reject(folder: Path, image: str | None, point: str | None, author: str, **limits: float | None) -> None:
    """Reject image observations: one, or all beyond a limit in the last adjustment, as one action.

    \b
    Example:
      raybundle mark reject facade-project IMG_3.jpg t17
      raybundle mark reject facade-project --w 4
      raybundle mark reject facade-project --sigma 0.02
    """
    given = {name: limit for name, limit in limits.items() if limit is not None}
    if len(given) == 1 and image is None:
        ((quantity, limit),) = given.items()
        do(folder, "reject_beyond", author, quantity=quantity, limit=limit)
    elif given or image is None or point is None:
        raise InputError("mark.nothing_to_reject", limits=[f"--{name}" for name in limits])
    else:
        do(folder, "reject", author, image=image, point=point)


@subcommand("accept")
@click.argument("image")
@click.argument("point")
def accept(folder: Path, image: str, point: str, author: str) -> None:
    """Accept an image observation again that was rejected by hand.

    \b
    Example:
      raybundle mark accept facade-project IMG_3.jpg t17
    """
    do(folder, "accept", author, image=image, point=point)


@subcommand("parameter")
@click.argument("camera")
@click.argument("symbol")
@click.argument("choice", type=click.Choice(["free", "held", "auto"]))
def parameter(folder: Path, camera: str, symbol: str, choice: str, author: str) -> None:
    """Estimate or fix a camera parameter in the next adjustments. auto: according to block and options.

    \b
    Example:
      raybundle mark parameter facade-project canon K3 held
    """
    do(folder, "parameter", author, camera=camera, symbol=symbol, choice=choice)


@subcommand("fiducial")
@click.argument("image")
@click.argument("name")
@click.argument("x_px", type=NUMBER, metavar="[X]", required=False)
@click.argument("y_px", type=NUMBER, metavar="[Y]", required=False)
@_precision(0.2)
def fiducial(
    folder: Path, image: str, name: str, x_px: float | None, y_px: float | None, sigma: float,
    covariance: Covariance | None, author: str,
) -> None:  # fmt: skip
    """Set a fiducial mark in a scan of film. Without X and Y: remove it.

    \b
    Example:
      raybundle mark fiducial archive-project 17_0412.tif F1 812.4 9310.7
    """
    _place(folder, "fiducial", author, sigma, covariance, image=image, name=name, x_px=x_px, y_px=y_px)


@subcommand("undo")
def undo(folder: Path, author: str) -> None:
    """Undo the last action.

    \b
    Example:
      raybundle mark undo facade-project
    """
    do(folder, "undo", author)


@subcommand("redo")
def redo(folder: Path, author: str) -> None:
    """Redo the last undone action.

    \b
    Example:
      raybundle mark redo facade-project
    """
    do(folder, "redo", author)


@command.command("list")
@click.argument("folder", type=FOLDER)
@click.option("--history", "with_history", is_flag=True, help="Show all actions, including undone ones.")
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
def list_(folder: Path, with_history: bool, as_json: bool) -> None:  # noqa: FBT001
    """List the measurements.

    \b
    Example:
      raybundle mark list facade-project --history
    """
    from raybundle.commands.marks import as_plain, history, marks
    from raybundle.commands.new_project import standing_folder
    from raybundle.measuring.session import block_folder
    from raybundle.measuring.state import in_force

    block_folder(standing_folder(folder) or folder)
    if not with_history:
        state = marks(folder)
        if as_json:
            click.echo(json.dumps(as_plain(state), ensure_ascii=False))
        else:
            report(Summary(done=[], table=shown(state)))
        return
    entries, rows = history(folder), list[str]()
    counts, _ = in_force([e.action for e in entries])
    for e, counted_in in zip(entries, counts, strict=True):
        if as_json:
            row = {"seq": e.seq, "time": e.time, "author": e.author, "verb": e.verb, "arguments": e.arguments}
            click.echo(json.dumps(row | {"counts": counted_in}, ensure_ascii=False))
            continue
        gone = "" if counted_in or e.verb in {"undo", "redo"} else "  (taken back)"
        rows.append(
            f" {e.seq:5d}  {e.time}  {e.author or '-'}  {e.verb} {', '.join(words(e.arguments))}".rstrip() + gone
        )
    if not as_json:
        report(Summary(done=[], table=rows))


@command.command("export")
@click.argument("folder", type=FOLDER)
@click.argument("out", type=NEW_FILE_OR_FOLDER)
@click.option(
    "--as-masks",
    is_flag=True,
    help="Write a folder of masks, one picture per photograph. `orient --masks` reads it.",
)
@click.option("--crs", default="", help="Coordinate system of the points for gcp_list.txt, e.g. EPSG:32633.")
def export(folder: Path, out: Path, as_masks: bool, crs: str) -> None:  # noqa: FBT001
    """Export the measurements: NAME.csv for --control, gcp_list.txt, a block folder, or masks.

    \b
    Example:
      raybundle mark export facade-project marks.csv
      raybundle mark export facade-project gcp_list.txt --crs EPSG:32633
      raybundle mark export facade-project facade-measured
      raybundle mark export facade-project masks --as-masks
    """
    from raybundle.commands.marks import export_marks, export_masks

    done = export_masks(folder, out) if as_masks else export_marks(folder, out, crs=crs)
    facts(files=done.files)
    report(Summary(
        done=[note("project_status.exported")], files=done.files, notices=of_texts(done.remarks, Severity.NOTE)
    ))  # fmt: skip


@command.command("adjust")
@click.argument("folder", type=FOLDER)
@click.option(
    "--out", type=NEW_FOLDER, metavar="RESULT",
    help="Result folder. An older result is replaced.  [default: the current result of a project, PROJECT/result; "
    "the earlier one is kept in PROJECT/results; else FOLDER-measured]",
)  # fmt: skip
@options_of(AdjustmentOptions)
@click.option("--no-report", is_flag=True, help="Leave out report.html and network.html.")
@click.option("--pdf", is_flag=True, help="Also write the report as report.pdf.")
@click.option("--language", default="", metavar="CODE", help=PROJECT_LANGUAGE_HELP)
@common_options
def adjust_(
    folder: Path, out: Path | None, no_report: bool, pdf: bool, language: str, progress: str, **given: Any  # noqa: FBT001
) -> int:  # fmt: skip
    """Adjust the block with the manual measurements, and write a result folder.

    Photographs without orientation are oriented from their marks if possible; missing marks are reported.

    \b
    Exit status: 0 a result is written; 2 bad input; 3 not solvable as given: what is lacking is named; 4 the accuracy
    that the project asks for is not kept.

    \b
    Example:
      raybundle mark adjust facade-project
      raybundle mark adjust facade-project --out facade-with-control --reject snooping
    """
    from raybundle.cli.progress import reporting
    from raybundle.commands.marked_results import passed_on, write_marked
    from raybundle.commands.marks import adjust_marks
    from raybundle.commands.new_project import standing_folder
    from raybundle.measuring.journal import measured_result
    from raybundle.report.delivery import wanted_outcome
    from raybundle.report.text.summary import adjusted
    from raybundle.results.folder import check_target

    folder = standing_folder(folder) or folder
    check_target(out or measured_result(folder))
    if language:
        checked_language(language)
    if pdf:
        check_typesetter()
    with reporting(progress) as notify:
        adjustment, left_out = adjust_marks(folder, notify, **values_of(AdjustmentOptions, given))
        target = write_marked(
            folder, adjustment, out, report="none" if no_report else "html", pdf=pdf, language=language, progress=notify
        )
    facts(out=target)
    names = [note("summary.marks_left_out", n=len(left_out), names=list(left_out))] if left_out else []
    files = [target, *page_files(target, report=not no_report, pdf=pdf)]
    report(of_adjustment(
        adjustment, files, done=[adjusted(adjustment), *names],
        details=[named(*reason) for reason in left_out.items()],
    ))  # fmt: skip
    known = passed_on(folder)
    return print_outcome(wanted_outcome(adjustment, known.wanted, known.frame))
