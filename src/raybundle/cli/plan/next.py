"""`raybundle plan next`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, counted
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import notice_line
from raybundle.commands.planning.next import NextSettings, run_plan_next
from raybundle.errors import note
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.planning.next_plan import NextPlan

SHOWN = 12
"""Proposals that are reported one by one; the others stand in next.csv"""
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
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    settings = made(NextSettings, {"result": result, **values_of(NextSettings, given)})
    with reporting(progress) as notify:
        plan = run_plan_next(settings, notify)
    click.echo("\n".join(f" {line}" for line in lines(plan, settings)))


def lines(plan: NextPlan, settings: NextSettings) -> list[str]:
    """What is reported of the proposals."""
    import numpy as np  # noqa: PLC0415  (what computes is loaded after the help)

    from raybundle.planning.next_words import figure_words, goal_words, instruction  # noqa: PLC0415

    first, last = plan.proposals[0].before, plan.proposals[-1].after
    n = len(plan.proposals)
    falls = f"{figure_words(plan, first.value)} now, {figure_words(plan, last.value)} with {counted(n, 'photograph')}"
    judged = f"{counted(plan.judged, 'candidate')} of {plan.reached} within reach show enough"
    text = [f"{judged}; {goal_words(plan)} {falls}"]
    for k in range(min(n, SHOWN)):
        reported = instruction(plan, k)
        text += [f"{plan.names[k]}  {reported}", f"        {reported.brings}"]
        if reported.frees:
            text.append(f"        with it {', '.join(reported.frees)} can be determined")
    if n > SHOWN:
        text.append(f"... {n - SHOWN} more in next.csv")
    if n < plan.wanted:
        text.append(notice_line(note("plan.nothing_lowers", n=n, wanted=plan.wanted)))
    elif np.isfinite(first.value) and last.value > HARDLY * first.value:
        text.append(notice_line(note("plan.hardly_lowers", share=1 - last.value / first.value)))
    return [*text, f"{settings.out}: network.html, next.csv, next.json, block"]
