"""`raybundle plan next`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.planning.next import NextSettings, run_plan_next
from raybundle.errors import Message, note
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.planning.next.plan import NextPlan

SHOWN = 3
"""Proposals that a terminal shows; --verbose and next.csv have all"""
HARDLY = 0.99
"""Share of what is to be lowered, of which a remark is made where it stays"""


@click.command("next", cls=Command)
@click.argument("result", type=FOLDER, metavar="RESULT")
@options_of(NextSettings, out=NEW_FOLDER)
@common_options
def command(result: Path, progress: str, **given: Any) -> None:
    """Propose the next photographs of an existing block: stations, and the gain of each.

    RESULT is a result, block or project folder. Stations within reach are compared by the exact standard deviations of
    an adjustment with each of them. The best one is added, then the next one is searched. Each is described relative to
    the nearest photograph. FOLDER gets network.html (the block, proposals in red), next.csv, next.json, and a block
    with the proposals for `adjust`. Only for frame cameras.

    \b
    Example:
      raybundle plan next result --photographs 3 --out next
      raybundle plan next calibration --photographs 4 --aim calibration --out next
    """
    from raybundle.cli.progress import reporting

    settings = made(NextSettings, {"result": result, **values_of(NextSettings, given)})
    with reporting(progress) as notify:
        plan = run_plan_next(settings, notify)
    report(summary(plan, settings))


def summary(plan: NextPlan, settings: NextSettings) -> Summary:
    """What the command reports."""
    import numpy as np

    from raybundle.planning.next.words import figure_words, goal_words, instruction

    first, last = plan.proposals[0].before, plan.proposals[-1].after
    n = len(plan.proposals)
    shown, more = list[Message](), list[Message]()
    for k in range(n):
        found = instruction(plan, k)
        (shown if k < SHOWN else more).append(note("network.proposal", name=plan.names[k], text=str(found)))
        more.append(note("network.proposal", name=plan.names[k], text=found.brings))
        if found.frees:
            more.append(note("network.freed", parameters=list(found.frees)))
    if n > SHOWN:
        shown.append(note("network.more_proposals", n=n - SHOWN, file_name="next.csv"))
    notices: list[Message] = []
    if n < plan.wanted:
        notices.append(note("plan.nothing_lowers", n=n, wanted=plan.wanted))
    elif np.isfinite(first.value) and last.value > HARDLY * first.value:
        notices.append(note("plan.hardly_lowers", share=1 - last.value / first.value))
    before, after = figure_words(plan, first.value), figure_words(plan, last.value)
    lowered = note("network.lowered", goal=goal_words(plan), before=before, after=after, n=n)
    judged = note("network.judged", judged=plan.judged, reached=plan.reached)
    return Summary(done=[lowered, *shown], notices=notices, details=[judged, *more], files=[settings.out])
