"""`raybundle targets sheet | detect | choose`."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import click

from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, NEW_FILE, NEW_FOLDER, common_options, counted
from raybundle.cli.numbers import Number
from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.targets.codes import RingFamily
    from raybundle.targets.layout import Sheet, SheetOptions
    from raybundle.targets.marks import Marks, Target

MOST_CODES = 1_000_000
LENGTH = re.compile(r"([0-9]+(?:\.[0-9]*)?|\.[0-9]+)\s*(mm|cm|m|in)?")
UNITS = {None: 1.0, "mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4}
FAMILY_HELP = (
    "Family of the targets: aicon14, agisoft12, dots, apriltag-36h11, chessboard-9x6 and others (how-to targets)."
)


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


def family_options(function: Any) -> Any:
    """--family, --table and --bits."""
    function = click.option("--bits", type=click.IntRange(3, 24), help="Sectors of the rings of --table.")(function)
    function = click.option(
        "--table", type=FOLDER, metavar="FILE", help="Targets of one's own: a table id,code; with --bits."
    )(function)
    return click.option("--family", "family_name", metavar="FAMILY", help=FAMILY_HELP)(function)


def rings_of(name: str | None, table: Path | None, bits: int | None) -> RingFamily:
    """The ring family that the options name; raises InputError."""
    from raybundle.targets.codes import read_table  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.targets.families import families, family_named  # noqa: PLC0415

    if table is not None:
        if name is not None or bits is None:
            raise InputError("--table goes with --bits and without --family")
        return read_table(table, bits)
    if name is None:
        raise InputError(
            "the family of the targets must be named, since families share rings under different numbers: "
            f"--family {' | '.join(sorted(families))}, or --table FILE --bits N"
        )
    return family_named(name)


def target_of(name: str | None, table: Path | None, bits: int | None, *, dots: bool) -> Target:
    """The target that the options name; raises InputError."""
    from raybundle.targets.kinds.rings import Rings  # noqa: PLC0415
    from raybundle.targets.marks import forms, target  # noqa: PLC0415

    if name is None and table is None:
        raise InputError(
            "the family of the targets must be named, since families share rings under different numbers: "
            f"--family {'; '.join(forms())}; or --table FILE --bits N"
        )
    made = target(name) if table is None and name is not None else Rings(rings=rings_of(name, table, bits))
    return Rings(rings=made.rings, dots=True) if dots and isinstance(made, Rings) else made


@click.group("targets", context_settings=COMMAND_SETTINGS)
def command() -> None:
    """Print coded targets, and find and measure them in photographs.

    \b
    Example:
      raybundle targets sheet --family aicon14 --codes 1-50 --paper A4 --out sheet.pdf
      raybundle targets detect images/ --family aicon14 --out targets.csv --overlay found
    """  # noqa: D301


@command.command("sheet", context_settings=COMMAND_SETTINGS)
@family_options
@click.option("--count", type=click.IntRange(1), help="So many targets, chosen to stay distinct when partly hidden.")
@click.option("--codes", "id_text", metavar="ID,FROM-TO,...", help="These targets, in place of --count.")
@click.option(
    "--spacing", type=Length(0, 1e5, above=True), help="Boards: side of a square, distance of dots; tags: their side."
)
@click.option(
    "--dot-radius", type=Length(0, 1e5, above=True), default="5mm", show_default=True, help="Radius of the dots."
)
@click.option("--paper", type=click.Choice(["A0", "A1", "A2", "A3", "A4"]), default="A4", show_default=True)
@click.option("--lying", is_flag=True, help="The longer side across.")
@click.option("--tile", type=click.Choice(["A1", "A2", "A3", "A4"]), help="Cut into parts for a printer of this paper.")
@click.option(
    "--polarity", type=click.Choice(["dark", "light"]), default="dark", show_default=True,
    help="dark: black on white; light: white on black.",
)  # fmt: skip
@click.option(
    "--out", type=NEW_FILE, required=True, metavar="FILE", help="FILE.pdf or FILE.svg; FILE.toml goes beside it."
)
@common_options
def sheet(
    family_name: str | None,
    table: Path | None,
    bits: int | None,
    count: int | None,
    id_text: str | None,
    spacing: float | None,
    dot_radius: float,
    paper: str,
    lying: bool,  # noqa: FBT001  (a flag of the command line)
    tile: str | None,
    polarity: str,
    out: Path,
    progress: str,
) -> None:
    """Write targets at true size, with a scale bar to verify the printer, and FILE.toml with ids, radii, positions.

    \b
    Example:
      raybundle targets sheet --family aicon12 --count 20 --out sheet.pdf
      raybundle targets sheet --family charuco-8x6-5x5_100 --spacing 25mm --lying --out board.pdf
      raybundle targets sheet --family agisoft12 --codes 1-12 --paper A2 --tile A4 --dot-radius 10mm --out large.pdf
    """  # noqa: D301
    from raybundle.targets.layout import SheetOptions  # noqa: PLC0415
    from raybundle.targets.sheets import write_sheet  # noqa: PLC0415

    del progress
    options = SheetOptions(
        dot_radius_mm=dot_radius, paper=paper, orientation="lying" if lying else "upright",
        polarity=cast("Any", polarity), tile=tile or "",
    )  # fmt: skip
    designed = designed_sheet(target_of(family_name, table, bits, dots=False), count, id_text, spacing, options)
    files = write_sheet(designed, out)
    placed = sum(len(p.targets) for p in designed.pages)
    what = counted(placed, "point" if designed.spacing_mm > 0 else "target")
    tail = f", printed as {counted(len(designed.printed), 'page')} {tile}" if tile else ""
    click.echo(f" {what} of {designed.title} on {counted(len(designed.pages), 'page')} {paper}{tail}")
    click.echo(f" {', '.join(str(f) for f in files)}")


def designed_sheet(
    target: Target, count: int | None, codes: str | None, spacing: float | None, options: SheetOptions
) -> Sheet:
    """The sheet of a family; raises InputError where options do not go with it."""
    from raybundle.targets.kinds.rings import Rings  # noqa: PLC0415
    from raybundle.targets.layout import design  # noqa: PLC0415
    from raybundle.targets.subsets import choose_codes  # noqa: PLC0415

    if isinstance(target, Rings) and target.rings is not None:
        if (count is None) == (codes is None):
            raise InputError("give either --codes or --count")
        ids = choose_codes(target.rings, count).ids if count is not None else read_ids(cast("str", codes))
        return design(target.rings, ids, options)
    from raybundle.targets.kinds.tags import Tags  # noqa: PLC0415  (loads OpenCV)
    from raybundle.targets.layout_boards import design_board, design_dots, design_tags  # noqa: PLC0415

    if spacing is None:
        raise InputError(f"{target.family}: give --spacing, the side of a square or the distance of dots, as 25mm")
    if isinstance(target, Tags):
        if codes is None and count is None:
            raise InputError("give either --codes or --count")
        numbers = read_ids(codes).tolist() if codes is not None else list(range(cast("int", count)))
        return design_tags(target, numbers, spacing, options)
    if isinstance(target, Rings):
        if codes is not None:
            raise InputError("dots have no numbers to choose from; give --count, or nothing: all there is room for")
        return design_dots(spacing, count, options)
    if codes is not None or count is not None:
        raise InputError(f"{target.family} is a board: its points have no numbers to choose from")
    return design_board(target, spacing, options)


def read_ids(text: str) -> Any:
    """Numbers and ranges, as 1,4,7-12; raises InputError."""
    import numpy as np  # noqa: PLC0415

    from raybundle.io.reading.words import quoted, whole_of  # noqa: PLC0415  (NumPy is loaded with it)

    ids: list[int] = []
    for word in text.split(","):
        match = re.fullmatch(r"\s*(\d+)(?:\s*-\s*(\d+))?\s*", word)
        if match is None:
            raise InputError(f"--codes {text}: {word!r} is neither a number nor a range as 7-12")
        first, last = whole_of(match[1]), whole_of(match[2] or match[1])
        if first is None or last is None or last - first > MOST_CODES:
            raise InputError(f"--codes: {quoted(word)} is more than the {MOST_CODES} targets that there can be")
        ids += range(first, last + 1)
    if len(set(ids)) < len(ids) or not ids:
        raise InputError(f"--codes {text}: a number stands there twice, or a range runs downwards")
    return np.array(ids)


@command.command("choose", context_settings=COMMAND_SETTINGS)
@family_options
@click.option("--count", type=click.IntRange(1), required=True)
@common_options
def choose(family_name: str | None, table: Path | None, bits: int | None, count: int, progress: str) -> None:
    """Choose targets that stay distinct when an arc of their ring is hidden.

    \b
    Example:
      raybundle targets choose --family aicon14 --count 40
    """  # noqa: D301
    from raybundle.targets.subsets import choose_codes  # noqa: PLC0415

    del progress
    family = rings_of(family_name, table, bits)
    choice = choose_codes(family, count)
    click.echo(f" {counted(count, 'target')} of {family.title}: {', '.join(map(str, choice.ids))}")
    click.echo(
        f" with any {choice.hidden} neighbouring sectors of {family.bits} hidden no ring passes for another; "
        f"two rings differ in {choice.distance} sectors at least"
    )


@command.command("detect", context_settings=COMMAND_SETTINGS)
@click.argument("inputs", type=FOLDER, nargs=-1, required=True, metavar="PHOTOS...")
@family_options
@click.option(
    "--polarity", type=click.Choice(["both", "dark", "light"]), default="both", show_default=True,
    help="Colour of the dots.",
)  # fmt: skip
@click.option("--out", type=NEW_FILE, metavar="FILE", help="Table of all that was found.")
@click.option(
    "--observations", type=NEW_FILE, metavar="FILE", help="Points with a name as observations.csv of a block."
)
@click.option("--dots", is_flag=True, help="With rings: dots without a ring, too.")
@click.option(
    "--overlay", type=NEW_FOLDER, metavar="DIR", help="Write the photographs with what was found drawn on them."
)
@click.option("--threads", type=click.IntRange(0), default=0, show_default=True, help="0: all processors.")
@common_options
def detect(
    inputs: tuple[Path, ...],
    family_name: str | None,
    table: Path | None,
    bits: int | None,
    polarity: str,
    out: Path | None,
    observations: Path | None,
    dots: bool,  # noqa: FBT001  (a flag of the command line)
    overlay: Path | None,
    threads: int,
    progress: str,
) -> int:
    """Find, read and measure targets.

    Standard deviations in the tables come from the grey values alone; what lens, film and panel add is for the
    adjustment to find.  Exit status 2 if nothing was found.

    \b
    Example:
      raybundle targets detect images/ --family aicon14
      raybundle targets detect images/ --family chessboard-9x6 --out targets.csv --overlay found
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415
    from raybundle.commands.targets import detect_all, write_observations, write_targets  # noqa: PLC0415
    from raybundle.targets.marks import MarkOptions  # noqa: PLC0415

    target = target_of(family_name, table, bits, dots=dots)
    options = MarkOptions(polarity=cast("Any", polarity))
    with reporting(progress) as tell:
        found, refused = detect_all(inputs, target, options, overlay, threads, tell)
    click.echo("\n".join(report(found, target)))
    for path, reason in refused:
        click.echo(f" left out: {path.name}: {reason}")
    if out is not None:
        write_targets(out, found)
        click.echo(f" targets: {out}")
    if observations is not None:
        write_observations(observations, found)
        click.echo(f" observations: {observations}")
    return 0 if any(len(m) for _, m in found) else 2


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
