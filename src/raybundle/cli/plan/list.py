"""`raybundle plan list`."""

from __future__ import annotations

from typing import Any, get_args

import click

from raybundle.cli.common import NEW_FOLDER, Command, common_options
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.planning.network_files import free_camera
from raybundle.commands.planning.photograph_list import ListKind, ListSettings, facts_of, run_plan_list
from raybundle.errors import note
from raybundle.settings import made


@click.command("list", cls=Command)
@click.argument("kind", type=click.Choice(get_args(ListKind)))
@click.argument("object", metavar="OBJECT")
@options_of(ListSettings, out=NEW_FOLDER)
@common_options
def command(kind: str, object: str, progress: str, **given: Any) -> None:  # noqa: A002  (the argument's name)
    """List photographs one by one by established rules: a PDF with sketches and checkboxes.

    cipa: the 3x3 ring round a building (box:WIDTH,DEPTH,HEIGHT) and stereo pairs of its facades; calibration: a network
    for this camera and this sheet (sheet:WIDTH,HEIGHT); turntable: views of an object on a table; targets: places of
    coded targets and scale bars on an object with stations of `plan network`. OBJECT as for `plan network`. FOLDER gets
    list.pdf, list.csv and the files of `plan network`: the predicted precision, and a block. `raybundle plan check
    FOLDER PHOTOS` compares the photographs with the list.

    \b
    Example:
      raybundle plan list cipa box:12,8,6 --c 24 --around 15 --out house
      raybundle plan list cipa box:12,8,6 --c 24 --around 15 --clearance 8 --out house-from-8
      raybundle plan list calibration sheet:0.42,0.297 --c 24 --out calibration-list
      raybundle plan list targets box:4,3,2.5 --stations plan/stations.csv --count 50 --out targets-list
    """
    from raybundle.cli.progress import reporting

    settings = made(ListSettings, {"kind": kind, "object": object, **values_of(ListSettings, given)})
    with reporting(progress) as notify:
        plan = run_plan_list(settings, notify)
    camera, precision, *more = facts_of(settings, plan)
    report(Summary(
        done=[note("network.listed", n=len(plan.design.stations)), *of_texts([precision])],
        notices=free_camera(plan), details=[camera, *more],
        next_step=note("network.next_list", folder=str(settings.out)), files=[settings.out],
    ))  # fmt: skip
