"""`raybundle mark control | mask | unmask`: tables and areas as one action each."""

from __future__ import annotations

from pathlib import Path

import click

from raybundle.cli.marking import do, subcommand
from raybundle.errors import InputError


@subcommand("control")
@click.argument("file", metavar="TABLE.csv")
def control(folder: Path, file: str, author: str) -> None:
    """Set coordinates of all points of a table in one action: point,X,Y,Z; optional sX,sY,sZ,role.

    The action holds the rows: the table is not read again.

    \b
    Example:
      raybundle mark control facade-project total-station.csv
    """
    do(folder, "control", author, file=file)


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


def _corners(text: str) -> list[list[float]]:
    from raybundle.io.reading.words import number_of, quoted

    found: list[list[float]] = []
    for k, word in enumerate(text.split()):
        values = [number_of(part) for part in word.split(",")]
        if len(values) != 2 or None in values:
            raise InputError("mask.corner_form", corner=k + 1, word=quoted(word))
        found.append([float(v) for v in values if v is not None])
    return found
