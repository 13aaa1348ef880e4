"""`raybundle merge`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.merge import MergeSettings, run_merge
from raybundle.errors import note
from raybundle.settings import made

JOINTS = 3
"""Joints of blocks that a terminal shows"""


@click.command("merge", cls=Command)
@click.argument("sources", type=FOLDER, nargs=-1, required=True, metavar="PROJECT PROJECT...")
@options_of(MergeSettings, out=NEW_FOLDER)
@common_options
def command(sources: tuple[Path, ...], progress: str, **given: Any) -> None:
    """Merge projects of one object into one block by their common points.

    Points are common by names from people, codes or tables: targets, control, marked points. The congruence test of
    `raybundle moved` detects moved points and different points of the same name; they stay separate. Projects are
    transformed to the frame of the one with control or positions. Tie points and images of one name stay separate.
    Adjust the block afterwards: common points then tie the projects together.

    \b
    Example:
      raybundle merge inside-project outside-project --out both
      raybundle adjust both --reject snooping --out both-result
    """
    from raybundle.block.joined import joint_messages
    from raybundle.cli.progress import reporting

    settings = made(MergeSettings, {"sources": sources, **values_of(MergeSettings, given)})
    with reporting(progress) as notify:
        done = run_merge(settings, notify)
    block = done.block
    facts(images=len(block.images), points=len(block.points), observations=len(block.observations), frame_of=done.first)
    joints = [joint_messages(joint, "units" if block.free_scale else block.length_unit) for joint in done.joints]
    first = [found[0] for found in joints]
    report(Summary(
        done=[
            note("block.merged", images=len(block.images), points=len(block.points),
                 observations=len(block.observations), name=done.first),
            *first[:JOINTS],
        ],
        notices=[*(m for found in joints for m in found[1:]), *done.cautions, *done.remarks], details=first[JOINTS:],
        next_step=note("block.adjust_merged", block=str(settings.out)), files=[settings.out],
    ))  # fmt: skip
