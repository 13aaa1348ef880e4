"""`raybundle simulate`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import click

from raybundle.cli.common import COMMAND_SETTINGS, NEW_FOLDER, common_options, counted
from raybundle.cli.numbers import METRES, PIXELS, Number

if TYPE_CHECKING:
    from raybundle.planning.scenes import Scene
    from raybundle.planning.simulate import Simulation


@click.command("simulate", context_settings=COMMAND_SETTINGS)
@click.argument("scene", type=click.Choice(["testfield", "flat", "aerial", "ring", "single"]))
@click.option(
    "--out", type=NEW_FOLDER, required=True, metavar="FOLDER", help="New folder for block/, truth/ and gross.csv."
)
@click.option("--seed", type=click.IntRange(0), default=1, show_default=True, help="Of all random numbers.")
@click.option(
    "--noise",
    type=PIXELS,
    default=0.1,
    show_default=True,
    help="Sigma of an image coordinate [px].",
)
@click.option("--control", type=click.IntRange(0), default=0, show_default=True, help="Number of control points.")
@click.option("--control-sigma", type=Number(0, 1e6), default=0.0, show_default=True, help="Their sigma [m]; 0: held.")
@click.option("--check", type=click.IntRange(0), default=0, show_default=True, help="Number of check points.")
@click.option("--scale-bars", type=click.IntRange(0), default=0, show_default=True, help="Number of scale bars.")
@click.option(
    "--scale-bar-sigma",
    type=METRES,
    default=1e-4,
    show_default=True,
    help="Their sigma [m].",
)
@click.option("--station-sigma", type=METRES, help="Observe projection centres so well [m].")
@click.option(
    "--orientation",
    type=click.Choice(["exact", "approximate", "absent"]),
    default="approximate",
    show_default=True,
    help="Exterior orientation given at the start.",
)
@click.option("--gross", type=Number(0, 0.5), default=0.0, show_default=True, help="Share of gross errors.")
@click.option("--gross-px", type=Number(0, 1e5), default=20.0, show_default=True, help="Their size [px].")
@common_options
def command(scene: str, out: Path, progress: str, seed: int, noise: float, **survey: float | None) -> None:
    """Write a simulated block, the truth beside it and the list of its gross errors.

    testfield: targets in relief, convergent rolled images; flat: the same in one plane; aerial: three strips;
    ring: stations round a cylinder; single: one photo of control points.

    \b
    Example:
      raybundle simulate testfield --out field --scale-bars 1 --gross 0.01
      raybundle adjust field/block --out field-result --reject snooping
    """  # noqa: D301
    del progress
    from raybundle.planning.simulate import Survey, simulate  # noqa: PLC0415  (what computes is loaded after the help)

    control = cast("int", survey["control"])
    sigma = cast("float", survey["control_sigma"])
    plan = Survey(
        seed=seed,
        image_sigma_px=noise,
        control=10 if scene == "single" and control == 0 else control,
        control_sigma=(sigma, sigma, sigma),
        check=cast("int", survey["check"]),
        scale_bars=cast("int", survey["scale_bars"]),
        scale_bar_sigma=cast("float", survey["scale_bar_sigma"]),
        station_sigma=survey["station_sigma"],
        orientation=cast("Any", survey["orientation"]),
        gross_share=cast("float", survey["gross"]),
        gross_px=cast("float", survey["gross_px"]),
    )
    simulation = simulate(scene_of(scene), plan)
    write_simulation(simulation, out)
    block = simulation.observed
    click.echo(
        f" {counted(len(block.images), 'image')}, {counted(len(block.points), 'object point')}, "
        f"{counted(len(block.observations), 'image observation')}, "
        f"{counted(int(simulation.gross.sum()), 'gross error')}"
    )
    click.echo(f" block: {out / 'block'}, truth: {out / 'truth'}")


def scene_of(name: str) -> Scene:
    """The scene of a name on the command line, with its standard plan."""
    from raybundle.planning import scenes as s  # noqa: PLC0415

    scenes = {
        "testfield": lambda: s.field_scene(s.TargetField()),
        "flat": lambda: s.field_scene(s.TargetField(depth=0.0)),
        "aerial": lambda: s.aerial_scene(s.AerialStrips()),
        "ring": lambda: s.ring_scene(s.Ring()),
        "single": lambda: s.single_scene(s.SinglePhoto()),
    }
    return scenes[name]()


def write_simulation(simulation: Simulation, out: Path) -> None:
    """Write FOLDER/block, FOLDER/truth and FOLDER/gross.csv, whole or not at all."""
    from raybundle.errors import InputError  # noqa: PLC0415
    from raybundle.io.block.folder import named, write_block_files  # noqa: PLC0415
    from raybundle.io.folders import new_folder  # noqa: PLC0415
    from raybundle.io.tables import write_table  # noqa: PLC0415

    if out.exists() and (not out.is_dir() or any(out.iterdir())):
        raise InputError("stands there already and is not overwritten; choose another folder or delete it", file=out)
    with new_folder(out) as folder:
        for name, block in (("block", simulation.observed), ("truth", simulation.truth)):
            (folder / name).mkdir()
            write_block_files(block, folder / name)
        o = simulation.truth.observations
        write_table(
            folder / "gross.csv",
            {
                "image": named(simulation.truth.images.ids, o.image[simulation.gross]),
                "point": named(simulation.truth.points.ids, o.point[simulation.gross]),
            },
        )
