"""`raybundle heights ...`: one file a subcommand, loaded when it is called."""

from __future__ import annotations

import click

from raybundle.cli.lazy import LazyGroup

SUBCOMMANDS = {
    "volume": "Volume above and below a base, area in plan and true area.",
    "time-series": "Volumes of several dates, and significant changes between them.",
    "section": "Profiles along lines, as table, picture or drawing.",
    "contours": "Contour lines, without the wiggles that are noise.",
    "drawing": "Lines and areas drawn on a surface, for CAD and GIS.",
    "ground": "Separate the ground from what stands on it: a terrain model.",
    "difference": "Detect significant movements between two surfaces.",
}


@click.group("heights", cls=LazyGroup)
def command() -> None:
    """Compute volumes, sections, contours and differences from heights, with true standard deviations.

    SURFACE is a folder from `raybundle surface --dsm CELL` or `raybundle heights ground`. Errors of neighbours, errors
    along steps, and errors of the orientation are correlated. The standard deviations include these correlations.

    \b
    Example:
      raybundle heights volume facade-project/surface --extent 1 0 2 1 --above 0
      raybundle heights difference may/surface october/surface --out moved
    """


command.home, command.summaries = __name__, SUBCOMMANDS
