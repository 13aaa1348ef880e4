"""`raybundle simulate`: a simulated block with its truth."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal, cast, get_args

from raybundle.errors import InputError
from raybundle.settings import METRES, NOT_NEGATIVE, PIXELS, Range, setting

if TYPE_CHECKING:
    from raybundle.block import Block
    from raybundle.planning.simulate import Simulation, Survey
    from raybundle.planning.synthetic_networks import Scene

SIGMA = Range(low=0, high=1e6)
SceneName = Literal["testfield", "flat", "aerial", "ring", "single"]
OF_SCENES = {
    "control_points": 0,
    "control_sigma": (0.0, 0.0),
    "check_points": 0,
    "scale_bars": 0,
    "scale_bar_sigma": 1e-4,
    "station_sigma": None,
}
"""Settings of a scene's survey; a plan has its own control and scale bars"""


@dataclass(frozen=True, slots=True, kw_only=True)
class SimulateSettings:
    """What is simulated, and how it is surveyed."""

    scene: str
    """a name, or a folder with a plan, a result or a block"""
    out: Path
    """new folder"""
    seed: int = setting(1, "Seed of all random numbers.", limits=NOT_NEGATIVE)
    image_sigma: float | None = setting(
        None, "Sigma of an image coordinate [px].  [default: 0.1, of a plan as planned]", limits=PIXELS
    )
    control_points: int = setting(0, "Number of control points.", limits=NOT_NEGATIVE)
    control_sigma: tuple[float, float] = setting(
        (0.0, 0.0), "Standard deviations of control points [m]; 0: fixed.", metavar="PLAN HEIGHT", limits=(SIGMA, SIGMA)
    )
    check_points: int = setting(0, "Number of check points.", limits=NOT_NEGATIVE)
    scale_bars: int = setting(0, "Number of scale bars.", limits=NOT_NEGATIVE)
    scale_bar_sigma: float = setting(1e-4, "Standard deviation of scale bars [m].", limits=METRES)
    station_sigma: float | None = setting(
        None, "Observe projection centres with this standard deviation [m].", limits=METRES
    )
    orientation: Literal["exact", "approximate", "absent"] = setting(
        "approximate", "Given exterior orientation at the start."
    )
    gross: float = setting(0.0, "Share of blunders.", limits=Range(low=0, high=0.5))
    gross_px: float = setting(20.0, "Size of the blunders [px].", limits=Range(low=0, high=1e5))

    def survey(self) -> Survey:
        """What is measured; a single photograph has ten control points where none are asked for."""
        from raybundle.planning.simulate import Survey

        return Survey(
            seed=self.seed,
            image_sigma_px=0.1 if self.image_sigma is None else self.image_sigma,
            control=10 if self.scene == "single" and self.control_points == 0 else self.control_points,
            control_sigma=(self.control_sigma[0], *self.control_sigma),
            check=self.check_points,
            scale_bars=self.scale_bars,
            scale_bar_sigma=self.scale_bar_sigma,
            station_sigma=self.station_sigma,
            orientation=self.orientation,
            gross_share=self.gross,
            gross_px=self.gross_px,
        )


def run_simulate(settings: SimulateSettings) -> Simulation:
    """Simulate what the settings ask for, and write it."""
    from raybundle.planning.simulate import simulate

    if settings.scene in get_args(SceneName):
        done = simulate(scene_of(cast("SceneName", settings.scene)), settings.survey())
    else:
        done = _of_plan(settings)
    write_simulation(done, settings.out)
    return done


def _of_plan(settings: SimulateSettings) -> Simulation:
    """What the photographs of a plan, or of a result once more, will measure."""
    from raybundle.commands.planning.network_files import VISIBLE
    from raybundle.commands.planning.objects import block_in
    from raybundle.planning.simulate_again import simulate_again

    folder = Path(settings.scene)
    if not folder.is_dir():
        raise InputError("simulation.unknown_scene", name=str(settings.scene), known=list(get_args(SceneName)))
    for name, usual in OF_SCENES.items():
        if getattr(settings, name) != usual:
            raise InputError("simulation.setting_of_scenes", setting=name, folder=str(folder))
    block = block_in(folder)
    if (folder / VISIBLE).is_file():
        block = _found_again(folder, block, settings.seed)
    return simulate_again(block, settings.survey(), settings.image_sigma)


def _found_again(plan: Path, block: Block, seed: int) -> Block:
    """The block of a plan with what is found drawn by this seed; raises InputError where its tables do not fit."""
    import numpy as np

    from raybundle.commands.planning.network_files import VISIBLE
    from raybundle.io.tables import Column, read_table
    from raybundle.planning.network.planned_block import redrawn

    numbers = [*"XYZ", *(f"s{a}_mm" for a in "XYZ"), "rays", "often"]
    columns = [Column(name="point", kind="id"), *(Column(name=n, kind="number", empty=n not in "XYZ") for n in numbers)]
    columns.append(Column(name="unlucky_mm", kind="number", optional=True, empty=True))
    points = read_table(
        plan / "points.csv", [*columns, Column(name="known", kind="text", optional=True, empty=True)], own=True
    )
    ids = points.text["point"]
    missing = [i for i in block.points.ids if i not in set(ids)]
    if missing:
        raise InputError("plan.point_missing", point=missing[0], file=plan / "points.csv")
    seen = read_table(
        plan / VISIBLE,
        [
            Column(
                name="image", kind="reference", known={i: k for k, i in enumerate(block.images.ids)}, where="images"
            ),
            Column(name="point", kind="reference", known={i: k for k, i in enumerate(ids)}, where="points.csv"),
            Column(name="found", kind="number", limit="> 0"),
        ],
        own=True,
    )
    sigma = float(np.sqrt(block.observations.cov_px2[:, 0].min()))
    visible = seen.index["image"], seen.index["point"], seen.number["found"]
    return redrawn(block, ids, points.numbers(*"XYZ"), visible, sigma, seed)


def scene_of(name: SceneName) -> Scene:
    """The scene of a name on the command line, with its standard plan."""
    from raybundle.planning import synthetic_networks as s

    scenes: dict[SceneName, Callable[[], Scene]] = {
        "testfield": lambda: s.field_scene(s.TargetField()),
        "flat": lambda: s.field_scene(s.TargetField(depth=0.0)),
        "aerial": lambda: s.aerial_scene(s.AerialStrips()),
        "ring": lambda: s.ring_scene(s.Ring()),
        "single": lambda: s.single_scene(s.SinglePhoto()),
    }
    return scenes[name]()


def write_simulation(simulation: Simulation, out: Path) -> None:
    """Write FOLDER/block, FOLDER/truth and FOLDER/gross.csv, whole or not at all."""
    from raybundle.io.block.folder import write_block_files
    from raybundle.io.block.tables import named
    from raybundle.io.folders import check_new_folder, new_folder
    from raybundle.io.tables import write_table

    check_new_folder(out)
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
            {},
        )
