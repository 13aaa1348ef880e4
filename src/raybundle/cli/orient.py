"""`raybundle orient`."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

import click

from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, NEW_FOLDER, common_options, counted, noise_option
from raybundle.cli.numbers import NOT_NEGATIVE, NUMBER, POSITIVE, Number

if TYPE_CHECKING:
    from raybundle.numerics.progress import Progress
    from raybundle.pipeline.project import StageRecord
    from raybundle.report.section_photographs import PhotographFacts
    from raybundle.workflows.orient import Orientation


class StageName(click.ParamType):
    """The name of a stage, as `raybundle status` lists them; its beginning is enough where no other begins so."""

    name = "stage"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """The whole name."""
        from raybundle.workflows.orient import stages  # noqa: PLC0415  (what computes is loaded after the help)

        known = stages()
        begun = [name for name in known if name.startswith(str(value).lower())]
        if len(begun) != 1:
            self.fail(f"{value!r} is not one of {', '.join(repr(n) for n in known)}.", param, ctx)
        return begun[0]


@click.command("orient", context_settings=COMMAND_SETTINGS)
@click.argument("photos", type=FOLDER, nargs=-1, required=True)
@click.option("--out", type=NEW_FOLDER, required=True, metavar="PROJECT", help="Project folder; begun, or continued.")
@click.option(
    "--calibration",
    type=FOLDER,
    metavar="CAMERAS.toml",
    help="Known cameras; `estimate = []` in it holds them; those of `raybundle calibrate` are observed with their "
    "covariance.",
)
@click.option(
    "--camera",
    "separate",
    multiple=True,
    metavar="PATTERN",
    help="Photographs whose names match, as 'left_*' or 'a.jpg|b.jpg', are a camera apart; for those without metadata.",
)
@click.option(
    "--masks", type=FOLDER, metavar="DIR",
    help="Masks of the photographs, named photo.jpg.png as by COLMAP, or photo_mask.png or photo.png as by Metashape: "
    "nothing is measured where they are 0.",
)  # fmt: skip
@click.option("--no-library", is_flag=True, help="Leave calibrations of the camera library out.")
@click.option(
    "--control",
    type=FOLDER,
    multiple=True,
    metavar="FILE",
    help="Control points with their places in the photographs: gcp_list.txt, CSV or a block folder.",
)
@click.option("--check", type=FOLDER, multiple=True, metavar="FILE", help="Check points, in the same formats.")
@click.option(
    "--control-sigma",
    type=(NOT_NEGATIVE, NOT_NEGATIVE),
    metavar="PLAN HEIGHT",
    help="Standard deviation of control whose file states none.",
)
@click.option(
    "--mark-sigma",
    type=Number(0.001, 1e5),
    default=0.5,
    show_default=True,
    metavar="PX",
    help="Standard deviation of a point marked in a photograph.",
)
@click.option(
    "--scale-bar",
    type=(str, str, POSITIVE, NOT_NEGATIVE),
    multiple=True,
    metavar="A B LENGTH SIGMA",
    help="A known distance between two points that --control measures, and its standard deviation, both in metres; may "
    "be repeated.",
)
@click.option(
    "--positions", type=FOLDER, metavar="FILE",
    help="Positions of the photographs, as an MRK file or CSV, in place of those that they state.",
)  # fmt: skip
@click.option(
    "--attitudes", type=click.Choice(("auto", "none", "opk", "rpy-ned", "gimbal")), default="auto", show_default=True,
    help="Observe attitudes of --positions, or the gimbal's in the photographs, by their convention; auto: what the "
    "file holds with standard deviations.",
)  # fmt: skip
@click.option(
    "--attitude-sigma", type=(POSITIVE, POSITIVE), metavar="TILT HEADING",
    help="Standard deviations [deg] of attitudes that state none; observes those of the gimbal as well.",
)  # fmt: skip
@click.option(
    "--no-misalignment", is_flag=True, help="Attitudes are those of the camera itself: no misalignment is estimated."
)
@click.option(
    "--relative", type=click.Choice(("shift", "drift")),
    help="Relative aerial control: positions and attitudes of a flight line count by their differences alone; drift: "
    "after a drift of the positions as well.",
)  # fmt: skip
@click.option(
    "--lever-arm", type=(NUMBER, NUMBER, NUMBER, NOT_NEGATIVE), metavar="RIGHT UP BACK SIGMA",
    help="Positions belong to an antenna that stands there in the axes of the image, seen from the projection centre; "
    "SIGMA 0 holds it.",
)  # fmt: skip
@click.option(
    "--no-shift", is_flag=True,
    help="Control and positions are in one datum: no shift of the positions of each flight is estimated.",
)  # fmt: skip
@click.option(
    "--scene-bias", type=click.Choice(("none", "shift", "drift", "affine")), default="shift", show_default=True,
    help="What is estimated of a satellite scene's RPC.",
)  # fmt: skip
@click.option(
    "--crs",
    metavar="SYSTEM",
    help="As EPSG:32633, of --positions in a grid and, with satellite scenes, of control files that name none.",
)
@click.option("--no-gps", is_flag=True, help="Leave positions out that the photographs state.")
@click.option("--up", default="auto", show_default=True, metavar="WAY",
    help="Which way is up where neither control nor positions tell it: auto, by how the photographs were held; "
    "terrestrial, aerial, oblique; or two points A,B that --control measures, B plumb above A.",
)  # fmt: skip
@click.option("--features", default="rootsift", show_default=True, metavar="METHOD",
    help="rootsift; for wide baselines, with the extra [learned]: xfeat or disk.",
)  # fmt: skip
@click.option(
    "--feature-count", type=click.IntRange(100), default=10_000, show_default=True, help="Features of a photograph."
)
@click.option(
    "--start",
    type=click.Choice(("auto", "growing", "averaging")),
    default="auto",
    show_default=True,
    help="Image by image, or all pairs at once; auto: the second where the first leaves photographs or the view is "
    "narrow.",
)
@click.option("--quick", is_flag=True, help="Leave out least-squares matching: several times less precise.")
@click.option("--jobs", type=click.IntRange(0), default=0, show_default=True, help="0: all processors.")
@click.option(
    "--memory", type=Number(0.1, 1e6), default=4.0, show_default=True, metavar="GB",
    help="Memory that the pixels of photographs may take while points are measured.",
)  # fmt: skip
@click.option(
    "--from",
    "redo_from",
    type=StageName(),
    metavar="STAGE",
    help="Do this stage, as `raybundle status` lists them, and all after it again.",
)
@noise_option
@click.option("--no-report", is_flag=True, help="Leave out report.html and network.html.")
@common_options
def command(
    photos: tuple[Path, ...],
    out: Path,
    calibration: Path | None,
    separate: tuple[str, ...],
    masks: Path | None,
    no_library: bool,  # noqa: FBT001  (a flag of the command line)
    control: tuple[Path, ...],
    check: tuple[Path, ...],
    control_sigma: tuple[float, float] | None,
    mark_sigma: float,
    scale_bar: tuple[tuple[str, str, float, float], ...],
    positions: Path | None,
    attitudes: str,
    attitude_sigma: tuple[float, float] | None,
    no_misalignment: bool,  # noqa: FBT001
    relative: str | None,
    lever_arm: tuple[float, float, float, float] | None,
    no_shift: bool,  # noqa: FBT001
    scene_bias: str,
    crs: str | None,
    no_gps: bool,  # noqa: FBT001
    up: str,
    features: str,
    feature_count: int,
    start: str,
    quick: bool,  # noqa: FBT001
    jobs: int,
    memory: float,
    redo_from: str | None,
    noise: str,
    no_report: bool,  # noqa: FBT001
    progress: str,
) -> int:
    """Orient photographs: a folder or files in, calibrated cameras, oriented images, object points and a report out.

    Images that bring an RPC (in a TIFF tag, or as NAME_RPC.TXT, NAME.RPB, NAME.XML beside them) are satellite scenes;
    scenes and photographs are adjusted together, joined by control and by common points.

    No parameter is needed. A run that was stopped continues with the same command; photographs that are added
    later are matched with the others, and only they.

    \b
    Exit status: 0 oriented (photographs that could not be are named); 2 bad input; 3 no two photographs fit.

    \b
    Example:
      raybundle orient facade/ --out facade-project
      raybundle orient facade/ --out facade-project --from precision
      raybundle orient flight/ --out flight-project --control gcp_list.txt
      raybundle orient facade/ --out scaled --control marks.csv --scale-bar A B 1.2319 0.0001
      raybundle orient pair/ --out pair-project --control gcp.csv --crs EPSG:32633
    """  # noqa: D301
    from dataclasses import replace  # noqa: PLC0415

    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.cli.summary import summary_lines  # noqa: PLC0415
    from raybundle.errors import InputError  # noqa: PLC0415
    from raybundle.io.block_toml import read_cameras  # noqa: PLC0415
    from raybundle.io.camera_library import library_folder  # noqa: PLC0415
    from raybundle.io.control_files import DEFAULTS, ControlDefaults, named_apart, read_control  # noqa: PLC0415
    from raybundle.io.photos.photo import shown  # noqa: PLC0415
    from raybundle.io.trajectories import read_trajectory  # noqa: PLC0415
    from raybundle.pipeline.project import discard_empty  # noqa: PLC0415
    from raybundle.report.result_folder import check_target  # noqa: PLC0415
    from raybundle.workflows.earlier_result import less_fixed  # noqa: PLC0415
    from raybundle.workflows.marks import Given, ScaleBar  # noqa: PLC0415
    from raybundle.workflows.orient import OrientOptions, orient, part_folder  # noqa: PLC0415

    options = OrientOptions(
        features=features, feature_count=feature_count, start=cast("Any", start), precise=not quick, jobs=jobs,
        memory_gb=memory, separate=separate, masks=masks, library=None if no_library else library_folder(),
        redo_from=cast("Any", redo_from or ""), scene_bias=cast("Any", scene_bias), crs=crs,
        attitudes=cast("Any", attitudes), attitude_sigma_deg=attitude_sigma,
        relative=cast("Any", relative or ""), noise=cast("Any", noise),
    )  # fmt: skip
    cameras = read_cameras(calibration) if calibration is not None else ()
    plan, height = control_sigma or (DEFAULTS.plan, DEFAULTS.height)
    usual = ControlDefaults(plan=plan, height=height)
    given = Given(
        control=named_apart((
            *(read_control(f, defaults=usual) for f in control),
            *(read_control(f, defaults=replace(usual, role="check")) for f in check),
        )),
        scale_bars=tuple(ScaleBar(start=a, end=b, length=d, sigma=e) for a, b, d, e in scale_bar),
        gps=not no_gps, shift=not no_shift, misalignment=not no_misalignment,
        lever_arm=None if lever_arm is None else (lever_arm[:3], lever_arm[3]),
        defaults=usual, sigma_given=control_sigma is not None, mark_px=mark_sigma, up=up,
    )  # fmt: skip
    result = out / "result"
    if shown(out) != out:
        raise InputError("this name is no UTF-8, which the result is written in; choose another --out", file=shown(out))
    check_target(result)
    begins = not out.exists()
    try:
        with reporting(progress) as tell:
            _keep_settings(out)
            done = orient(
                photos, out, options, calibration=cameras, given=given, progress=tell,
                positions=None if positions is None else read_trajectory(positions),
            )  # fmt: skip
            lost = less_fixed(result, done.adjustment)
            if lost is not None:
                done = replace(
                    done, adjustment=replace(done.adjustment, notices=(lost, *done.adjustment.notices))
                )  # fmt: skip
            with report_stage(out, done.stages):
                write_orientation(done, result, report="none" if no_report else "html", progress=tell)
    except KeyboardInterrupt:
        click.echo(f"interrupted; what is finished is kept in {out}, the same command continues there", err=True)
        return 130
    except InputError:
        if begins and out.is_dir():
            discard_empty(out)
        raise
    if done.photos or not done.scenes:
        click.echo(f" {_oriented(done)}")
    if done.scenes:
        click.echo(f" {done.oriented_scenes} of {counted(len(done.scenes), 'scene')} in the block")
    for name, reason in (*done.refused, *done.not_oriented):
        click.echo(f"   {name}: {reason}")
    if done.oriented < len(done.photos) and features == "rootsift":
        click.echo("   --features xfeat matches photographs from farther apart (pip install 'raybundle[learned]')")
    for k, part in enumerate(done.parts):
        click.echo(f"   {counted(len(part.photographs), 'photograph')} in a part of its own: {out / part_folder(k)}")
    click.echo("\n".join(summary_lines(done.adjustment)))
    click.echo(f" image points: sigma {done.sigma_px:.3f} px")
    click.echo(
        f" result: {result}"
        + ("" if no_report else f", report: {result / 'report.html'}, in 3D: {result / 'network.html'}")
    )
    return 0


def _oriented(done: Orientation) -> str:
    """How many photographs are oriented, and where, in words."""
    whole = counted(len(done.photos), "photograph")
    apart = sum(len(set(part.photographs) - {n for n, _ in done.not_oriented}) for part in done.parts)
    if not apart:
        return f"{done.oriented} of {whole} oriented"
    others = f"{len(done.parts)} others" if len(done.parts) > 1 else "another"
    return f"{done.oriented - apart} of {whole} oriented in this result, {apart} in {others}"


def _keep_settings(out: Path) -> None:
    """Write the command's arguments, as given or by default, into project.toml."""
    import json  # noqa: PLC0415

    from raybundle.pipeline.project import Project  # noqa: PLC0415

    values = {k: v for k, v in click.get_current_context().params.items() if v is not None}
    lines = ["# what the last run was asked for; `raybundle status` shows what it did", "[orient]"]
    # a JSON text or list is one of TOML
    lines += [f"{name} = {json.dumps(value, default=str, ensure_ascii=False)}" for name, value in values.items()]
    text = ("\n".join(lines) + "\n").encode("utf-8", "replace").decode()
    project = Project.open(out)
    try:
        project.write_settings(text)
    finally:
        project.close()


@contextmanager
def report_stage(out: Path, before: Sequence[StageRecord]) -> Generator[None]:
    """Record the writing of the result as the last stage of a run."""
    from raybundle.pipeline.project import Project  # noqa: PLC0415

    project = Project.open(out)
    try:
        project.records += before
        with project.stage("report") as stage:
            stage.from_cache = False
            yield
    finally:
        project.close()


def write_orientation(done: Orientation, result: Path, *, report: Literal["html", "none"], progress: Progress) -> None:
    """Write the result folder of oriented photographs."""
    from raybundle.report.result_folder import write_result  # noqa: PLC0415
    from raybundle.workflows.orient import part_folder  # noqa: PLC0415

    write_result(
        done.adjustment,
        result,
        report=report,
        additions=done.additions(),
        photographs=facts_of(done),
        frame=done.frame,
        progress=progress,
    )
    for k, part in enumerate(done.parts):
        write_result(part.adjustment, result.parent / part_folder(k), report=report, progress=progress)
    _remove_older(result.parent, len(done.parts))


def facts_of(done: Orientation) -> PhotographFacts:
    """What the report says of photographs and scenes; a scene is a photograph with a camera of its own."""
    from dataclasses import replace  # noqa: PLC0415

    from raybundle.cli.photograph_facts import photograph_facts  # noqa: PLC0415
    from raybundle.report.section_photographs import PairFact, PhotoFact  # noqa: PLC0415

    facts = photograph_facts(done)
    names = [s.name for s in done.scenes]
    scenes = tuple(
        PhotoFact(
            name=s.name, camera=s.name, width_px=s.width_px, height_px=s.height_px, taken=s.scene.time,
            device=s.scene.sensor,
        )
        for s in done.scenes
    )  # fmt: skip
    pairs = tuple(
        PairFact(
            first=names[p.pair.first], second=names[p.pair.second], candidates=p.pair.candidates,
            verified=len(p.pair.matches), geometry=p.pair.geometry,
        )
        for p in done.scene_pairs
    )  # fmt: skip
    return replace(facts, photographs=(*scenes, *facts.photographs), pairs=(*pairs, *facts.pairs))


def _remove_older(project: Path, parts: int) -> None:
    """Remove results of parts that an earlier run had and this one has not."""
    import shutil  # noqa: PLC0415

    from raybundle.errors import InputError  # noqa: PLC0415
    from raybundle.report.result_folder import check_target  # noqa: PLC0415
    from raybundle.workflows.orient import part_folder  # noqa: PLC0415

    older = project / part_folder(parts)
    while older.is_dir():
        try:
            check_target(older)
        except InputError:  # somebody's own files are in it
            return
        shutil.rmtree(older)
        parts += 1
        older = project / part_folder(parts)
