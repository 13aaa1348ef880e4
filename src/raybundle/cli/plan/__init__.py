"""`raybundle plan ...`: one file a subcommand, loaded when it is called."""

from __future__ import annotations

import click

from raybundle.cli.lazy import LazyGroup

SUBCOMMANDS = {
    "network": "Stations round an object: the fewest photographs that reach a wanted standard deviation.",
    "next": "The next best photographs of a block in hand, in words that one can follow on site.",
    "list": "Photographs one by one, to take along: round a building, of a sheet, on a turntable, for targets.",
    "flight": "Predicted precision of a flight with or without RTK, and what would mend it.",
    "mission": "A flight over an area, along a line or round an object, written for a vehicle.",
    "check": "Photographs that were flown against their plan: what is missing, what is to be flown again.",
}


@click.group("plan", cls=LazyGroup)
def command() -> None:
    """Predict the precision of photographs before they are taken.

    \b
    Example:
      raybundle plan flight --lines 4 --photographs-per-line 8 --height 80 --alternate --cross 30
    """


command.home, command.summaries = __name__, SUBCOMMANDS
