"""`raybundle mark control | find | mask | unmask | draw | erase`: tables, panels, areas and lines."""

from __future__ import annotations

from pathlib import Path

import click

from raybundle.cli.common import FOLDER, common_options, facts
from raybundle.cli.marking import command, do, subcommand
from raybundle.cli.numbers import PIXELS
from raybundle.cli.summary import Summary, report
from raybundle.errors import InputError, note, warning


@subcommand("control")
@click.argument("file", metavar="TABLE.csv")
def control(folder: Path, file: str, author: str) -> None:
    """Set coordinates of all points of a table in one action: point,X,Y,Z; optional sX,sY,sZ,role.

    The action holds the rows: the table is not read again. In a project with a coordinate system, the coordinates are
    in that system, or in the local frame of the block: whichever lies nearer to the block.

    \b
    Example:
      raybundle mark control facade-project total-station.csv
    """
    do(folder, "control", author, file=file)


@command.command("find")
@click.argument("folder", type=FOLDER)
@click.argument("points", nargs=-1, metavar="[POINT]...")
@click.option(
    "--reach", type=PIXELS, metavar="LENGTH",
    help="Largest difference between given coordinates and the block.  [default: 6 m if only positions place the "
    "block; else four standard deviations of the control and 40 px]",
)  # fmt: skip
@click.option("--operator", "author", default="", metavar="TEXT", help="Name of the operator, for the journal.")
@common_options
def find(folder: Path, points: tuple[str, ...], reach: float | None, author: str, progress: str) -> None:
    """Find the ground panels of control points in the photographs, and mark them.

    Panels are crosses, chequered squares, iron crosses and discs. The block must be placed by positions of the
    photographs or by three marked control points. A point is marked in three photographs or more.

    \b
    Example:
      raybundle orient flight/ --out flight-project --control gcps.csv --crs EPSG:25832+7837
      raybundle mark find flight-project
      raybundle mark adjust flight-project
    """
    from raybundle.cli.progress import reporting
    from raybundle.commands.panels import find_panels
    from raybundle.measuring.panel_search import LEAST_RAYS

    with reporting(progress) as notify:
        done = find_panels(folder, points, reach=reach or 0.0, operator=author, progress=notify)
    s, unit = done.search, done.length_unit
    marked = [f.point for f in s.found if f.point in done.asked]
    first = [note("panels.found", n=len(marked), of=len(done.asked), marks=done.marked)]
    if s.found:
        x, y, z = (float(v) for v in s.shift)
        first.append(note("panels.shift", x=x, y=y, z=z, unit=unit, spread=s.spread))
    missed = {name: why for name, why in s.missed.items() if name in done.asked}
    reasons = dict.fromkeys(missed.values())
    notices = [
        warning("panels.missed", why=why, names=[n for n, w in missed.items() if w == why], least=LEAST_RAYS)
        for why in reasons
    ]
    if done.unread is not None:
        notices.append(warning("panels.files_not_read", details=(done.unread,)))
    if done.lost:
        notices.append(warning("panels.photographs_lost", n=len(done.lost), names=list(done.lost)))
    off = [note("panels.off", point=n, distance=d, unit=unit) for n, d in s.off.items() if n in missed]
    facts(found=marked, missed=missed, marks=done.marked)
    report(Summary(done=first, details=off, notices=notices))


@subcommand("mask")
@click.argument("mask", metavar="NAME")
@click.argument("image")
@click.option(
    "--polygon", required=True, metavar="'X,Y X,Y X,Y'",
    help="Corners of the area in pixels of the file. Write x and y with a comma and corners with a blank between them.",
)  # fmt: skip
@click.option("--all-images", "camera", is_flag=True, help="Apply the mask to every photograph of the same camera.")
def mask(folder: Path, mask: str, image: str, polygon: str, camera: bool, author: str) -> None:  # noqa: FBT001
    """Mask an area of a photograph: nothing is measured there. A mask of the same name is replaced.

    The next run of `orient` in the project uses it. `raybundle mark export --as-masks` writes masks as pictures.

    \b
    Example:
      raybundle mark mask facade-project tree IMG_3.jpg --polygon "0,0 800,0 760,1200 0,1300"
      raybundle mark mask car-project bonnet IMG_3.jpg --polygon "0,1700 4000,1700 4000,2000 0,2000" --all-images
    """
    do(folder, "mask", author, mask=mask, image=image, polygon=_corners(polygon), camera=camera)


@subcommand("unmask")
@click.argument("mask", metavar="NAME")
def unmask(folder: Path, mask: str, author: str) -> None:
    """Remove a drawn mask.

    \b
    Example:
      raybundle mark unmask facade-project tree
    """
    do(folder, "unmask", author, mask=mask)


@subcommand("draw")
@click.argument("drawing", metavar="NAME")
@click.option(
    "--line", metavar="'X,Y X,Y'",
    help="Corners of a line in the coordinates of the surface. Write X and Y with a comma and corners with a blank "
    "between them.",
)  # fmt: skip
@click.option("--area", metavar="'X,Y X,Y X,Y'", help="Corners of an area.")
@click.option("--layer", default="lines", show_default=True, metavar="TEXT", help="Layer in CAD and GIS.")
@click.option("--note", default="", metavar="TEXT", help="Attribute: remark.")
@click.option("--surface", default="surface", show_default=True, metavar="NAME", help="Surface folder in the project.")
def draw(folder: Path, drawing: str, line: str, area: str, layer: str, note: str, surface: str, author: str) -> None:
    """Draw a line or an area on a surface. A drawing of the same name is replaced.

    `raybundle heights drawing` writes drawings for CAD and GIS, with heights.

    \b
    Example:
      raybundle mark draw pit-project edge --line "2.5,1 4,1.5 6,1" --layer breaklines
      raybundle mark draw pit-project pile --area "1,1 4,1 3,3" --note gravel
    """
    if bool(line) == bool(area):
        raise InputError("surface_drawing.line_or_area")
    kind = "line" if line else "area"
    do(folder, "draw", author, drawing=drawing, kind=kind, corners=_corners(line or area), layer=layer, note=note,
       surface=surface)  # fmt: skip


@subcommand("erase")
@click.argument("drawing", metavar="NAME")
def erase(folder: Path, drawing: str, author: str) -> None:
    """Remove a drawn line or area.

    \b
    Example:
      raybundle mark erase pit-project edge
    """
    do(folder, "erase", author, drawing=drawing)


def _corners(text: str) -> list[list[float]]:
    from raybundle.io.reading.words import number_of, quoted

    found: list[list[float]] = []
    for k, word in enumerate(text.split()):
        values = [number_of(part) for part in word.split(",")]
        if len(values) != 2 or None in values:
            raise InputError("mask.corner_form", corner=k + 1, word=quoted(word))
        found.append([float(v) for v in values if v is not None])
    return found
