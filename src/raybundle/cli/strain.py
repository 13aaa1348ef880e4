"""`raybundle strain`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.strain import run_strain, summary_of
from raybundle.commands.strain_results import StrainSettings, state_counts
from raybundle.settings import made


@click.command("strain", cls=Command)
@click.argument("reference", type=FOLDER)
@click.argument("deformed", type=FOLDER, nargs=-1, required=True, metavar="DEFORMED...")
@options_of(StrainSettings, out=NEW_FOLDER)
@common_options
def command(reference: Path, deformed: tuple[Path, ...], progress: str, **given: Any) -> None:
    """Measure displacements and strains of a flat specimen (digital image correlation).

    REFERENCE is an image before the load, DEFORMED are images under load in the order of time, all from one camera that
    stands still. Subsets on a grid are followed by least-squares matching. Standard deviations come from the noise of
    both images. FOLDER gets displacements.csv, strain.csv, maps and result.json.

    \b
    Example:
      raybundle strain load-00.tif load-01.tif load-02.tif --out strains
      raybundle strain load-00.tif load-*.tif --scale 0.05 --mask specimen.png --out strains
      raybundle strain before.tif after.tif --window 41 --shape quadratic --out strains
    """
    from raybundle.cli.progress import reporting

    settings = made(StrainSettings, {"reference": reference, "deformed": deformed, **values_of(StrainSettings, given)})
    with reporting(progress) as notify:
        done = run_strain(settings, notify)
    facts(subsets=len(done.grid.xy_px), images=[{"name": i.name, **state_counts(i.followed)} for i in done.images])
    *others, last = done.images
    report(Summary(
        done=summary_of(last), details=[m for i in others for m in summary_of(i)], notices=done.reported,
        files=done.files,
    ))  # fmt: skip
