"""`raybundle demo`."""

from __future__ import annotations

import filecmp
import math
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import click

from raybundle.cli.common import NEW_FOLDER, Command, common_options, facts
from raybundle.cli.demo_errors import interior_errors, interior_lines, rigid_difference
from raybundle.cli.summary import of_adjustment, report
from raybundle.commands.demonstrations import make_set, set_names
from raybundle.errors import InputError, Message, note

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
    from raybundle.planning.simulate import Simulation


@click.command("demo", cls=Command)
@click.option(
    "--out", type=NEW_FOLDER, default=Path("demo"), show_default=True, metavar="FOLDER", help="Output folder."
)
@click.option(
    "--set",
    "photographs",
    metavar="NAME|FOLDER",
    help=f"Make a set of photographs for a tutorial: {', '.join(set_names())}. Or orient "
    "the photographs of a FOLDER with known truth: photos/, measured.csv, truth/.",
)
@click.option("--seed", type=click.IntRange(0), default=1, show_default=True, help="Seed of the random errors.")
@common_options
def command(out: Path, photographs: str | None, seed: int, progress: str) -> None:
    """Simulate a testfield, calibrate the camera, and print truth, estimate and sigma.

    Input: image coordinates, one scale bar, and a camera constant with an error of two per cent. Orientations, object
    coordinates and distortion are unknown.

    \b
    Example:
      raybundle demo --out demo
      raybundle demo --set flight --out flight
      raybundle demo --set demo_data/portal --out portal
    """
    from raybundle.cli.progress import reporting

    if photographs in set_names():
        with reporting(progress) as notify:
            files = make_set(photographs, out, notify)
        click.echo("\n".join([f" {line}" for line in files] + [f" all in {out}"]))
        return
    if photographs is not None:
        from raybundle.cli.demo_set import run

        run(Path(photographs), out, progress)
        return
    from raybundle.planning.simulate import Survey, simulate
    from raybundle.planning.synthetic_networks import TargetField, field_scene
    from raybundle.report.write import write_result
    from raybundle.results.folder import check_target
    from raybundle.workflows.adjust import adjust

    survey = Survey(seed=seed, image_sigma_px=0.1, scale_bars=1, scale_bar_sigma=2e-5, orientation="absent")
    simulation = simulate(field_scene(TargetField()), survey)
    result = out / "result"
    check_target(result)
    _write_input(simulation, out)
    with reporting(progress) as notify:
        adjustment = adjust(simulation.observed, progress=notify)
        write_result(adjustment, result, progress=notify)
    facts(block=out / "block", truth=out / "truth", result=result)
    given = simulation.observed
    sigma_px = math.sqrt(float(given.observations.cov_px2[0, 0]))
    simulated = note("demo.simulated", images=len(given.images), n=len(given.points), sigma_px=sigma_px)
    report(of_adjustment(
        adjustment, [result, result / "report.html", out / "block", out / "truth"],
        done=[simulated, *interior_errors(simulation.truth, adjustment), *_point_errors(simulation, adjustment)],
        details=[_given(simulation, survey.scale_bar_sigma), *interior_lines(simulation.truth, adjustment)],
    ))  # fmt: skip


def _write_input(simulation: Simulation, out: Path) -> None:
    """Write block and truth; those of an earlier demo stay if they are the same."""
    from raybundle.io.block.folder import write_block, write_block_files

    for name, block in (("block", simulation.observed), ("truth", simulation.truth)):
        folder = out / name
        if not folder.exists():
            write_block(block, folder)
            continue
        with TemporaryDirectory() as fresh:
            write_block_files(block, Path(fresh))
            names = sorted(f.name for f in Path(fresh).iterdir())
            same = filecmp.cmpfiles(fresh, folder, names, shallow=False)[0] == names
        if not same:
            raise InputError("folder.other_block", file=folder)


def _given(simulation: Simulation, sigma: float) -> Message:
    """What the adjustment begins from."""
    length = float(simulation.observed.distances.length[0])
    start, truth = (block.cameras[0].values["c"] for block in (simulation.observed, simulation.truth))
    return note("demo.given", length_m=length, sigma_mm=sigma * 1000, c_mm=start, error=start / truth - 1)


def _point_errors(simulation: Simulation, adjustment: Adjustment) -> list[Message]:
    """Errors of object points after a rigid motion onto the truth, beside what is stated."""
    import numpy as np

    if adjustment.precision is None:
        return []
    error, _ = rigid_difference(adjustment.adjusted.points.xyz, simulation.truth.points.xyz)
    std = np.sqrt(np.trace(adjustment.precision.object_points, axis1=1, axis2=2).mean() / 3)
    rms = 1000 * float(np.sqrt((error**2).mean()))
    return [note("demo.points", kind="targets", rms_mm=rms, stated_mm=1000 * float(std))]
