"""`raybundle compare`."""

from __future__ import annotations

from pathlib import Path

import click

from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, NEW_FILE, common_options


@click.command("compare", context_settings=COMMAND_SETTINGS)
@click.argument("first", type=FOLDER, metavar="RESULT")
@click.argument("second", type=FOLDER, metavar="RESULT")
@click.option(
    "--out",
    type=NEW_FILE,
    default=Path("compare.html"),
    show_default=True,
    metavar="FILE",
    help="The HTML file to write; an older comparison is replaced, no other file.",
)
@common_options
def command(first: Path, second: Path, out: Path, progress: str) -> None:
    """Put two result folders side by side: statistics, interior orientations, points after a similarity.

    Points are the same by their names; those with a running number (t100) only where their image points agree too.

    \b
    Example:
      raybundle compare camcal21-result free --out camcal21.html
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.errors import InputError  # noqa: PLC0415
    from raybundle.report.compare import write_comparison  # noqa: PLC0415
    from raybundle.results.folder import read_result  # noqa: PLC0415

    if out.is_dir() or out.suffix.lower() not in {".html", ".htm"}:
        raise InputError("is not a name for an HTML file; give --out NAME.html", file=out)
    if not out.absolute().parent.is_dir():
        raise InputError("its folder does not exist; create it first", file=out)
    with reporting(progress) as tell:
        tell("reading results", 0.0)
        a, b = read_result(first), read_result(second)
        tell("comparing", 0.0)
        cautions = write_comparison(a, b, out)
    for label, result in (("first", a), ("second", b)):
        sigma0 = result.result["sigma0"]
        text = "none" if sigma0 is None else f"{sigma0:.6g}"
        click.echo(f" {label}: {result.path}, sigma0 {text}, redundancy {result.result['redundancy']}")
    for caution in cautions:
        click.echo(f" caution: {caution}")
    click.echo(f" comparison: {out}")
