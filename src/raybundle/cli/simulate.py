"""`raybundle simulate`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import NEW_FOLDER, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.simulate import SimulateSettings, run_simulate
from raybundle.errors import note
from raybundle.settings import made


@click.command("simulate", cls=Command)
@click.argument("scene", metavar="SCENE|FOLDER")
@click.option(
    "--out", type=NEW_FOLDER, required=True, metavar="FOLDER", help="New folder for block/, truth/ and gross.csv."
)
@options_of(SimulateSettings)
@common_options
def command(scene: str, out: Path, progress: str, **given: Any) -> None:
    """Write a simulated block, the truth beside it and the list of its blunders.

    testfield: targets in relief, convergent rolled images; flat: the same in one plane; aerial: three strips; ring:
    stations round a cylinder; single: one photo of control points. For a folder with a plan, a result or a block, its
    stations measure again, with new errors of the given size.

    \b
    Example:
      raybundle simulate testfield --out field --scale-bars 1 --gross 0.01
      raybundle adjust field/block --out field-result --reject snooping
      raybundle plan network facade:6,4 --photographs 8 --out plan
      raybundle simulate plan --seed 7 --out measured
    """
    del progress
    done = run_simulate(made(SimulateSettings, {"scene": scene, "out": out, **values_of(SimulateSettings, given)}))
    block = done.observed
    facts(images=len(block.images), points=len(block.points), observations=len(block.observations))
    facts(gross_errors=int(done.gross.sum()), block=out / "block", truth=out / "truth")
    report(Summary(
        done=[note("block.simulated", images=len(block.images), points=len(block.points),
                   observations=len(block.observations), blunders=int(done.gross.sum()))],
        files=[out / "block", out / "truth"],
    ))  # fmt: skip
