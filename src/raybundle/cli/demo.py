"""`raybundle demo`."""

from __future__ import annotations

import filecmp
import math
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import click

from raybundle.cli.common import NEW_FOLDER, Command, common_options, counted, facts, significant
from raybundle.commands.demonstrations import make_set, set_names

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
    from raybundle.numerics.arrays import Array
    from raybundle.planning.simulate import Simulation


@click.command("demo", cls=Command)
@click.option(
    "--out", type=NEW_FOLDER, default=Path("demo"), show_default=True, metavar="FOLDER", help="Where it writes."
)
@click.option(
    "--set",
    "photographs",
    metavar="NAME|FOLDER",
    help=f"Make photographs and what belongs to them instead, for a tutorial: {', '.join(set_names())}. Or orient "
    "those of a FOLDER with known truth: photos/, measured.csv, truth/.",
)
@click.option("--seed", type=click.IntRange(0), default=1, show_default=True, help="Of the random errors.")
@common_options
def command(out: Path, photographs: str | None, seed: int, progress: str) -> None:
    """Simulate a testfield, calibrate the camera, and print truth beside estimate and sigma.

    Given are image coordinates and one scale bar, and nothing else: no orientations, no object coordinates, a camera
    constant two per cent off, no distortion.

    \b
    Example:
      raybundle demo --out demo
      raybundle demo --set flight --out flight
      raybundle demo --set demo_data/portal --out portal
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415

    if photographs in set_names():
        with reporting(progress) as tell:
            told = make_set(photographs, out, tell)
        click.echo("\n".join([f" {line}" for line in told] + [f" all in {out}"]))
        return
    if photographs is not None:
        from raybundle.cli.demo_set import run  # noqa: PLC0415

        run(Path(photographs), out, progress)
        return
    from raybundle.planning.scenes import TargetField, field_scene  # noqa: PLC0415
    from raybundle.planning.simulate import Survey, simulate  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.report.text.summary import summary_lines  # noqa: PLC0415
    from raybundle.report.write import write_result  # noqa: PLC0415
    from raybundle.results.folder import check_target  # noqa: PLC0415
    from raybundle.workflows.adjust import adjust  # noqa: PLC0415

    survey = Survey(seed=seed, image_sigma_px=0.1, scale_bars=1, scale_bar_sigma=2e-5, orientation="absent")
    simulation = simulate(field_scene(TargetField()), survey)
    result = out / "result"
    check_target(result)
    _write_input(simulation, out)
    click.echo("\n".join(_given(simulation, survey.scale_bar_sigma)))
    with reporting(progress) as tell:
        adjustment = adjust(simulation.observed, progress=tell)
        write_result(adjustment, result, progress=tell)
    click.echo("\n".join(["", *_interior(simulation, adjustment), "", *_points(simulation, adjustment), ""]))
    click.echo("\n".join(summary_lines(adjustment)))
    facts(block=out / "block", truth=out / "truth", result=result)
    click.echo(f" block: {out / 'block'}, truth: {out / 'truth'}")
    click.echo(f" result: {result}, report: {result / 'report.html'}")


def _write_input(simulation: Simulation, out: Path) -> None:
    """Write block and truth; those of an earlier demo stay if they are the same."""
    from raybundle.errors import InputError  # noqa: PLC0415
    from raybundle.io.block.folder import write_block, write_block_files  # noqa: PLC0415

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
            raise InputError("holds another block, which is not overwritten; choose another --out", file=folder)


def _given(simulation: Simulation, sigma: float) -> list[str]:
    block = simulation.observed
    length = float(block.distances.length[0])
    std = math.sqrt(float(block.observations.cov_px2[0, 0]))
    return [
        (
            f" simulated: {counted(len(block.images), 'image')} of {counted(len(block.points), 'target')}, "
            f"{counted(len(block.observations), 'image observation')} with sigma {std:g} px"
        ),
        f" given besides: one scale bar, {length:.4f} m with sigma {sigma * 1000:g} mm; c {_start(simulation)}",
    ]


def _start(simulation: Simulation) -> str:
    start, truth = (block.cameras[0].values["c"] for block in (simulation.observed, simulation.truth))
    return f"= {start:g} mm ({100 * (start / truth - 1):+.1f} %), no distortion, no orientation, no coordinates"


def _interior(simulation: Simulation, adjustment: Adjustment) -> list[str]:
    truth = simulation.truth.cameras[0].values
    lines = [f" {'parameter':12}{'truth':>16}{'estimate':>16}{'sigma':>12}{'error / sigma':>16}"]
    for interior in adjustment.interior:
        for p in interior.parameters.values():
            if p.std is None or not p.std > 0:
                continue
            true, value, std = together((truth[p.symbol], p.value, p.std), p.std)
            ratio = (p.value - truth[p.symbol]) / p.std
            lines.append(f" {p.symbol:4}{p.unit:8}{true:>16}{value:>16}{std:>12}{ratio:>16.2f}")
    return lines


def together(values: tuple[float, ...], std: float) -> tuple[str, ...]:
    """Numbers written down to the second digit of a standard deviation, small ones with one common exponent."""
    decimals = 1 - math.floor(math.log10(std))
    if decimals <= 7:
        return tuple(f"{v:.{max(decimals, 0)}f}" for v in values)
    largest = max(abs(v) for v in values)
    exponent = math.floor(math.log10(largest))
    return tuple(f"{v / 10.0**exponent:.{max(decimals + exponent, 0)}f}e{exponent:+03d}" for v in values)


def _points(simulation: Simulation, adjustment: Adjustment) -> list[str]:
    import numpy as np  # noqa: PLC0415

    estimate, truth = adjustment.adjusted.points.xyz, simulation.truth.points.xyz
    error, turn = rigid_difference(estimate, truth)
    lines = [" object points, after a rigid motion onto the truth (a free network stands in a frame of its own)"]
    rms = 1000 * np.sqrt((error**2).mean(axis=0))
    lines.append(
        "   rms error    " + "  ".join(f"{a} {significant(v)}" for a, v in zip("XYZ", rms, strict=True)) + " mm"
    )
    if adjustment.precision is not None:
        covariance = turn @ adjustment.precision.object_points @ turn.T
        std = 1000 * np.sqrt(np.diagonal(covariance, axis1=1, axis2=2).mean(axis=0))
        text = "  ".join(f"{a} {significant(v)}" for a, v in zip("XYZ", std, strict=True))
        lines.append(f"   stated sigma {text} mm (rms)")
    return lines


def rigid_difference(estimate: Array, truth: Array) -> tuple[Array, Array]:
    """Estimate minus truth (n, 3) after the best rigid motion onto the truth, and its rotation (3, 3).

    Least squares without weights (Arun, Huang and Blostein 1987); the scale is left as it is.
    """
    from raybundle.numerics.rotation import nearest_rotation  # noqa: PLC0415

    a, b = estimate - estimate.mean(axis=0), truth - truth.mean(axis=0)
    turn = nearest_rotation(b.T @ a)
    return a @ turn.T - b, turn
