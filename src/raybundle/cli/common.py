"""Options and phrases that several commands share."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.command import NOT_KEPT, Command, Group, SeveralNames, facts
from raybundle.cli.outputs import NEW_FILE, NEW_FILE_OR_FOLDER, NEW_FOLDER, NEW_PAGE, Output
from raybundle.numerics.counting import counted, grouped, significant

if TYPE_CHECKING:
    from raybundle.report.outcome import Outcome

__all__ = [
    "FOLDER",
    "NEW_FILE",
    "NEW_FILE_OR_FOLDER",
    "NEW_FOLDER",
    "NEW_PAGE",
    "NOT_KEPT",
    "Command",
    "Group",
    "Output",
    "SeveralNames",
    "common_options",
    "counted",
    "facts",
    "grouped",
    "print_outcome",
    "significant",
    "store_lines",
]  # fmt: skip
FOLDER = click.Path(path_type=Path)


def common_options(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add --progress (an argument `progress`)."""
    return click.option(
        "--progress",
        type=click.Choice(["auto", "json", "none"]),
        default="auto",
        show_default=True,
        help="Progress display. auto: a bar on a terminal, a line every 30 s when piped. json: one JSON object per "
        "line on stderr.",
    )(function)


def store_lines(project: Path) -> list[str]:
    """A line that names the URL at which the products of a run lie; none if they lie in its folder."""
    from raybundle.pipeline.project import HERE, store_given

    store = store_given(project)
    return [f"products: {store}"] if store not in {"", HERE} else []


def print_outcome(outcome: Outcome | None) -> int:
    """Print what became of a wanted accuracy, and the exit status."""
    if outcome is None:
        return 0
    # what could not be judged is reported as what is wrong: nobody is to take it for kept
    click.echo(f" {'warning: ' * (outcome.kept is None)}{outcome.label}: {outcome.sentence}")
    return NOT_KEPT if outcome.kept is False else 0
